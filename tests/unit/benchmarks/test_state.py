# SPDX-License-Identifier: GPL-3.0-or-later
"""Page on the state of the project: made from stored results, worst numbers are the worst."""

import re

import pytest

from benchmarks import small_contacts, state, tables
from benchmarks.state import Worst, at_least, at_most


def test_the_page_is_made_from_the_stored_results():
    assert state.PAGE.read_text(encoding="utf-8") == state.page()


def test_the_worst_number_is_named_with_its_goal():
    found = {"a": 1.0, "b": 3.0, "c": 2.0}
    assert at_most("p", "q", found, 2.5) == Worst("p", "q", 3.0, "b", "≤ 2.5", False)
    assert at_least("p", "q", found, 0.5) == Worst("p", "q", 1.0, "a", "≥ 0.5", True)
    assert at_most("p", "q", found).met is None
    lines = state.shown([at_most("a_b", "q", found, 2.5), at_least("p", "q", found, 1.0)])
    assert "| [a b](a_b.md) | q | 3 | b | ≤ 2.5 | **no** |" in lines
    assert lines.endswith("| a | ≥ 1 | yes |")


def test_every_page_that_is_named_exists_and_missed_goals_are_listed():
    text = state.page()
    for name in re.findall(r"\]\((\w+\.md)\)", text):
        assert (state.PAGE.parent / name).exists()
    met, goals = map(int, re.search(r"(\d+) of (\d+) goals", text).groups())
    assert text.count("**no**") == goals - met
    assert text.count("| yes |") == met


def test_worst_numbers_agree_with_the_pages():
    """Numbers of this page that other pages state in their sentences or tables."""
    rows = {row.quantity: row for make in state.SECTIONS.values() for row in make()}
    page = state.MEASURED.read_text(encoding="utf-8")
    share = re.search(r"at most (\d+) % of the time is outside the core", page)[1]
    assert float(share) == round(rows["time outside the core [%]"].value)
    accuracy = (state.PAGE.parent / "accuracy.md").read_text(encoding="utf-8")
    table = next(block for block in accuracy.split("\n\n") if "maximum true / stated" in block)
    most = max(row["maximum true / stated"] for row in tables.rows_of(table))
    assert rows["true error / stated error"].value >= most - 0.005


def test_samples_outside_the_core_are_counted():
    report = " 40.0%  _core.so\n 20.0%  libfftw3.so\n 30.0%  libpython.so\n 10.0%  _multiarray.so\n"
    assert small_contacts.share_of_python(report) == pytest.approx(0.4)

# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/validation.md contains exactly the numbers measured by tests."""

import dataclasses
import re
import subprocess
import sys
from pathlib import Path

import pytest

import validation_page
from validation_page import Measured, Row

ROOT = Path(__file__).parents[2]
STORED = validation_page.load()
PRESSURE = Row("table", "p", "a/16", "", 1.01, 1.0, "GPa", 0.02, True, "file.py::test_p[16]")


def test_the_page_is_generated_from_the_stored_numbers():
    assert validation_page.PAGE.read_text(encoding="utf-8") == validation_page.page(STORED.values())


def test_the_stored_numbers_are_within_their_limits():
    assert len(STORED) > 200
    assert [row for row in STORED.values() if not row.holds] == []


def test_each_number_has_its_test():
    command = [sys.executable, "-m", "pytest", "--collect-only", "-q", "-m", "", "tests/validation"]
    found = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert {row.test for row in STORED.values()} <= set(found.stdout.splitlines())


def test_the_page_of_features_states_stored_numbers():
    """Each line of its table with two numbers of equal unit agrees with a stored row."""
    text = (ROOT / "docs" / "features.md").read_text(encoding="utf-8")
    lines = text.partition("## Accuracy")[2].partition("\n## ")[0].splitlines()
    number = r"\| [^|]*?([\d.]+) (GPa|MPa|nm|%) \| [^|]*?([\d.]+) \2 \|$"
    pairs = [match.groups() for line in lines if (match := re.search(number, line))]
    assert len(pairs) >= 6

    def says(text, value):
        return abs(value - float(text)) <= 0.5001 * 10.0 ** -len(text.partition(".")[2])

    for ours, unit, reference in pairs:
        same_unit = [row for row in STORED.values() if row.unit == unit]
        assert any(says(ours, r.ours) and says(reference, r.reference) for r in same_unit), ours

    within = re.findall(r"Hertz, (\d+) cells per contact radius: (.*?) \| within ([\d.]+) %", text)
    assert len(within) == 2
    for cells, name, bound in within:
        rows = [row for row in STORED.values() if row.table == "Hertz contact"]
        there = [r for r in rows if r.mesh == f"a/{cells}" and r.quantity.startswith(name)]
        worst = 100 * max(abs(row.ours / row.reference - 1) for row in there)
        assert 0.9 * float(bound) < worst <= float(bound), name


def test_cells():
    assert PRESSURE.cells() == ["p", "a/16", "1.01 GPa", "1 GPa", "+1 %", "2 %", "`test_p`"]
    row = dataclasses.replace(PRESSURE, relative=False, source="thesis")
    assert row.cells()[3:6] == ["1 GPa (thesis)", "+0.01 GPa", "0.02 GPa"]
    assert dataclasses.replace(row, ours=0.01, reference=0.0).cells()[2:5] == ["", "", "+0.01 GPa"]


def measure(ours, stored, **changes):
    measured = Measured(PRESSURE.test, stored)
    arguments = {"mesh": "a/16", "rel": 0.02, "unit": "GPa", **changes}
    measured.close("table", "p", ours, 1.0, **arguments)
    measured.complete()
    return measured.rows


def test_a_number_is_near_its_reference_and_as_stored():
    stored = {PRESSURE.key: PRESSURE}
    assert measure(1.01, stored) == [PRESSURE]
    assert measure(1.0109, stored)
    for ours, changes, text in (
        (1.021, {}, "farther from its reference"),
        (1.012, {}, "says 1.01"),
        (1.01, {"rel": 0.03}, "says 1.01"),
        (1.01, {"mesh": "a/8"}, "not on docs/validation.md"),
    ):
        with pytest.raises(AssertionError, match=text):
            measure(ours, stored, **changes)
    more = {("table", "q", "", ""): dataclasses.replace(PRESSURE, quantity="q", mesh="")}
    with pytest.raises(AssertionError, match="no longer measured"):
        measure(1.01, stored | more)


def test_each_table_has_its_place():
    with pytest.raises(ValueError, match="no place for: table"):
        validation_page.page([*STORED.values(), PRESSURE])
    with pytest.raises(ValueError, match="measured twice"):
        validation_page.write([PRESSURE, PRESSURE])
    with pytest.raises(ValueError, match="no numbers for 'Hertz contact'"):
        validation_page.write([PRESSURE])

# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscoelastic increments over elastic ones, on small grids, and the statements of the page."""

import pytest

from benchmarks import tables, viscous
from benchmarks.harness import ROOT, Meter


def test_the_page_states_at_most_1_3_elastic_increments():
    page = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    rows = tables.rows_of(tables.section_of(page, viscous))
    assert {row["across"] for row in rows} == {128, 256}
    assert max(row["increment over elastic"] for row in rows) <= 1.3


def test_memory_is_one_field_more_than_terms_for_each_traction():
    pressed = viscous.press(Meter(), "periodic rough surface", 48, 2)
    assert pressed["remembered fields"] == 3  # all cells have been loaded
    ball = viscous.press(Meter(), "ball", 32, 2)
    assert ball["remembered fields"] < 3
    slipping = viscous.press(Meter(), "balls with partial slip", 32, 2)
    assert slipping["remembered fields"] == pytest.approx(3 * ball["remembered fields"], rel=0.1)
    for row in (pressed, ball, slipping):
        assert row["contact_fraction"] == pytest.approx(row["contact_fraction, elastic"], abs=0.03)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Pull-off from craters, and iterations of plastic flow with adhesion."""

import math
import re

import pytest

from benchmarks import adhesive_craters as craters
from benchmarks import tables, theory

PULL_OFF = {
    (0.5, 5.0): (1.00, 1.574), (0.5, 20.0): (1.00, 1.558), (5.0, 5.0): (1.77, 1.59),
    (5.0, 20.0): (1.77, 1.44), (20.0, 5.0): (3.27, 1.64), (20.0, 20.0): (3.27, 1.51),
    (60.0, 5.0): (5.65, 1.64), (60.0, 20.0): (5.65, 1.57),
}  # fmt: skip
"""Effective radius R_eff/R and pull-off/(pi w R_eff), by load over yield load and work of adhesion,
from NumPy code for adhesive contact on the same cells."""


def check(crater, ratio, w, **more):
    """Assert the effective radius and the pull-off force of a crater; return the force [N]."""
    relative, unit = PULL_OFF[ratio, w]
    assert crater.radius / craters.RADIUS == pytest.approx(relative, rel=0.01)
    force = craters.pull_off(crater, w, **more)
    assert force / (math.pi * w * crater.radius) == pytest.approx(unit, rel=0.02)
    return force


def test_the_table_of_the_theory_states_these_values():
    page = "\n".join(file.read_text(encoding="utf-8") for file in theory.PAGES)
    made = re.search(r"<!-- table: craters -->\n(.*?)<!-- end", page, re.DOTALL)[1]
    rows = {(float(r["load/W_y"]), float(str(r["w"]).split()[0])): r for r in tables.rows_of(made)}
    assert rows.keys() == PULL_OFF.keys()
    for key, (relative, unit) in PULL_OFF.items():
        assert float(rows[key]["R_eff/R"]) == pytest.approx(relative, rel=0.01)
        assert float(rows[key]["F/(π w R_eff)"]) == pytest.approx(unit, rel=0.02)


def test_a_crater_increases_the_pull_off_force_of_a_ball():
    crater = craters.pressed(5.0)
    force = check(crater, 5.0, 20.0, steps=30)
    assert force == pytest.approx(craters.jkr_of(crater, 20.0), rel=0.05)


@pytest.mark.slow
@pytest.mark.filterwarnings(
    "ignore::samcontact.IncrementWarning", "ignore::samcontact.GridTooSmallWarning"
)
@pytest.mark.parametrize("ratio", craters.LOADS)
def test_pull_off_from_craters_approaches_that_of_their_profiles(ratio):
    """The range is that of the cells: the excess over JKR falls with their size."""
    crater = craters.pressed(ratio)
    for w in craters.WORKS:
        exact = craters.jkr_of(crater, w)
        excess = check(crater, ratio, w) / exact - 1
        finer = craters.pull_off(crater.refined(2), w, 2 * craters.STEPS) / exact - 1
        assert 0 < finer < 0.8 * excess < 0.08
        assert abs(2 * finer - excess) < 0.03


@pytest.mark.parametrize("control", ["approach", "load"])
def test_adhesion_hardly_adds_iterations_to_plastic_flow(control):
    without = craters.cost_of(None, control, increments=4)
    for w in (5.0, 30.0):
        found = craters.cost_of(w, control, increments=4)
        assert found.plastic <= 1.05 * without.plastic + 1
        assert found.contact <= 1.6 * without.contact

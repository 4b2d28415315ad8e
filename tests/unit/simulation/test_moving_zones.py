# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic subdomains move with their bodies through a rough contact, and remain in the wake."""

import pytest

import samcontact as sc
from openmp import outputs_with
from rough_setups import (
    KINEMATIC,
    RIGID,
    SIZE,
    SOFT,
    STEEL,
    WIDE_GRID,
    WIDE_PERCENT,
    assert_few_errors,
    rms,
    rolling,
    rough_gap,
    same,
    simulation,
    zone_counts,
)

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning", "ignore::samcontact.PlasticStrainWarning"
)


def moved(sim, cells):
    return sim.step(load=WIDE_PERCENT, advance=(cells[0] * SIZE, cells[1] * SIZE))


@pytest.mark.parametrize(
    ("bodies", "cells", "steps", "options"),
    [
        ((STEEL, RIGID), (24, 24), 2, {"reach": 20 * SIZE, "friction": 0.2}),
        ((SOFT, KINEMATIC), (16, 12.5), 2, {"friction": 0.1}),
        ((STEEL, RIGID), (16, 15.9), 2, {"friction": sc.Coulomb(0.2)}),
    ],
    ids=["rolling", "between the cells", "with creepage"],
)
def test_subdomains_left_behind_act_as_in_one_box(bodies, cells, steps, options):
    sims = [rolling(*bodies, zones=zones, **options) for zones in ("auto", "one")]
    inelastic = [n for n in (1, 2) if bodies[n - 1].is_plastic]
    counts = []
    for step in range(steps):
        zones, one = (moved(sim, cells if step else (0, 0)) for sim in sims)
        assert_few_errors(zones, one, inelastic, 5e-4)
        assert not one.shear.any() or rms(zones.shear, one.shear) < 5e-4
        counts.append(max(zone_counts(sims[0])))
        assert max(zone_counts(sims[1])) == 1
    assert sum(count > 1 for count in counts) >= 2


def test_ploughing_takes_as_many_iterations_in_subdomains_as_in_one_box():
    """A rough body at rest ploughs: as many iterations as in one box."""
    sims = [
        simulation(RIGID, STEEL, grid=WIDE_GRID, gap=rough_gap(grid=WIDE_GRID), zones=zones)
        for zones in ("auto", "one")
    ]
    for step in range(3):
        zones, one = (moved(sim, (0, 10 if step else 0)) for sim in sims)
        assert zones.iterations <= one.iterations + 1
    assert zones.iterations < 11
    assert zone_counts(sims[0])[1] > 1


def test_continuation_from_a_file_changes_no_digit(tmp_path):
    sim = rolling(STEEL, RIGID, friction=0.2)
    for cells in ((0, 0), (24, 24)):
        moved(sim, cells)
    assert zone_counts(sim)[0] > 1
    sim.save(tmp_path / "state.h5")
    other = sc.Simulation.load(tmp_path / "state.h5")
    assert same(moved(other, (24, 24)), moved(sim, (24, 24)), [1])
    assert zone_counts(other) == zone_counts(sim)
    assert other.counters == sim.counters


THREADS = """
import hashlib, warnings
warnings.simplefilter("ignore")
from rough_setups import *
sim = rolling(SOFT, KINEMATIC, friction=0.1)
for cells in (0, 16):
    state = sim.step(load=WIDE_PERCENT, advance=(cells * SIZE, (cells - 1.5) * SIZE))
    assert min(zone_counts(sim)) > 1, zone_counts(sim)
    parts = fields(state, (1, 2)).values()
    print(state.iterations, hashlib.sha256(b"".join(x.tobytes() for x in parts)).hexdigest())
"""


@pytest.mark.slow
def test_the_number_of_threads_changes_no_digit():
    message = outputs_with(THREADS, 1, 3)
    assert message[0] == message[1]
    assert len(message[0].splitlines()) == 2

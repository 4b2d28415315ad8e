# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand cycles of many plastic subdomains do not drift: changes vanish or decrease."""

import itertools

import numpy as np
import pytest

import samcontact as sc
from rough_setups import ELASTIC, NU, PERCENT, E, simulation

PERFECT = sc.Material.perfect_plastic(E, NU, 1e9)
LAWS = {
    "perfect": PERFECT,
    "linear": sc.Material.linear_hardening(E, NU, 1e9, 0.1 * E),
    "kinematic": PERFECT.with_kinematic_hardening(0.11 * E),
}
FRICTIONS = 0.0, 0.2
SIZE, RADIUS, LOAD = 1e-6, 30e-6, 0.04
GRID = sc.Grid(64, 64, SIZE, SIZE, 6, SIZE)
SETTLED = 20
REPEATED = 1e-12
"""Maximum change of fields by a settled cycle, relative to the largest value."""

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning", "ignore::samcontact.PlasticStrainWarning"
)


def long(*scenes):
    return [pytest.param(*scene, 1000, marks=pytest.mark.slow) for scene in scenes]


def asperities():
    """Return four asperities of different heights."""
    x, y, away = GRID.x[:, None], GRID.y, 22 * SIZE
    corners = itertools.product((-away, away), repeat=2)
    spheres = [
        np.hypot(x - a, y - b) ** 2 / (2 * RADIUS) + n * 1e-8 for n, (a, b) in enumerate(corners)
    ]
    return np.minimum.reduce(spheres)


def largest(field):
    return np.abs(field).max()


def assert_balanced(state, load):
    strain = state.plastic_strain()
    assert largest(strain[:3].sum(axis=0)) <= 1e-12 * largest(strain)
    assert state.pressure.sum() * state.grid.cell_area == pytest.approx(load, rel=1e-9)


@pytest.mark.parametrize(
    ("law", "friction", "cycles"),
    [("perfect", 0.2, 30), ("kinematic", 0.0, 30), *long(*itertools.product(LAWS, FRICTIONS))],
)
def test_asperities_shake_down(law, friction, cycles):
    """Cycles after the first few are equal: subdomains neither creep nor activate each other."""
    bodies = sc.Simulation(GRID, ELASTIC, LAWS[law], asperities(), friction, on_border="warn")
    first = bodies.step(load=LOAD)
    for cycle in range(cycles):
        unloaded = bodies.step(load=0.0)
        state = bodies.step(load=LOAD)
        if cycle == SETTLED:
            settled, bare = state, unloaded
    assert len(state.zones(2)) == 4
    assert_balanced(state, LOAD)
    for name in ("plastic_strain", "equivalent_plastic_strain", "backstress"):
        late, early = (getattr(moment, name)() for moment in (state, settled))
        assert largest(late - early) <= REPEATED * largest(early) if early.size else not late.size
    assert largest(state.pressure - settled.pressure) <= 100 * REPEATED * largest(state.pressure)
    print_, early = (moment.residual_displacement() for moment in (unloaded, bare))
    assert largest(print_ - early) <= REPEATED * largest(early)
    # the total change by all cycles is of the order of tol = 1e-6
    strain = first.plastic_strain()
    assert largest(state.plastic_strain() - strain) < 1e-5 * largest(strain)


@pytest.mark.parametrize(
    ("friction", "cycles"), [(0.0, 20), *long(*((friction,) for friction in FRICTIONS))]
)
def test_subdomains_with_alternating_flow_become_periodic(friction, cycles):
    """Sharp spots yield again on unloading; the change per cycle decreases as 1/cycles."""
    bodies = simulation(ELASTIC, LAWS["kinematic"], friction=friction)
    before = bodies.step(load=PERCENT).plastic_strain()
    grown, changes = [], []
    for cycle in range(1, cycles + 1):
        bodies.step(load=0.0)
        state = bodies.step(load=PERCENT)
        strain = state.plastic_strain()
        if cycle in (cycles // 4, cycles // 2, cycles):
            changes.append(largest(strain - before) / largest(strain))
        before = strain
        grown.append(state.max_equivalent_plastic_strain())
    assert len(state.zones(2)) > 2
    assert_balanced(state, PERCENT)
    assert all(late < max(0.6 * early, 1e-8) for early, late in itertools.pairwise(changes))
    assert np.diff(grown).min() > 1e-3  # cells that yield in each cycle continue to do so
    widths = np.diff(grown)[cycles // 2 :]
    assert widths == pytest.approx(widths[-1], rel=0.05)
    assert largest(strain) < 0.1

# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand cycles do not drift: after a few cycles the state repeats to the last bits."""

import itertools

import numpy as np
import pytest

import samcontact as sc

E, NU, RADIUS = 210e9, 0.3, 7.5e-3
STEEL = sc.Material.elastic(E, NU)
PERFECT = sc.Material.perfect_plastic(E, NU, 1e9)
EXACT = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(STEEL, STEEL), p0=2.4e9)
SIZE = 3.2 * EXACT.a / 11
GRID = sc.Grid(11, 11, SIZE, SIZE, 6, 1.9 * EXACT.a / 6)
GAP = sc.surfaces.paraboloid(GRID, RADIUS)
LAWS = {
    "linear": sc.Material.linear_hardening(E, NU, 1e9, 0.1 * E),
    "Swift": sc.Material.swift(E, NU, 600e6, 20.0, 0.121),
    "perfect": PERFECT,
    "kinematic": PERFECT.with_kinematic_hardening(0.11 * E),
    "kinematic, saturating": PERFECT.with_kinematic_hardening([1e11, 2e10], [100.0, 0.0]),
}
SETTLED = 60
"""Cycles within which what tol leaves open is taken up; each takes up a part of the rest."""
REPEATED = {"exact": 1e-14, "fast": 1e-9}
"""Maximum change per settled cycle, relative to the largest value. Fast transforms have rounding
errors: once in many cycles a cell at its yield stress flows by tol times an increment."""
SCENES = [
    ("linear", 0.0, 1000, "fast"),
    *((law, friction, 100, "exact") for law in LAWS for friction in (0.0, 0.2)),
    *((law, 0.2, 100, "fast") for law in ("linear", "kinematic")),
    *(
        pytest.param(law, friction, 1000, method, marks=pytest.mark.slow)
        for law in LAWS
        for friction in (0.0, 0.2)
        for method in REPEATED
    ),
]


def largest(field):
    return np.abs(field).max()


@pytest.mark.parametrize(("law", "friction", "cycles", "method"), SCENES)
@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_shakedown_to_the_last_bits(law, friction, cycles, method):
    """Elastic shakedown: the first reloading differs by tol, later reloadings not at all."""
    simulation = sc.Simulation(
        GRID, STEEL, LAWS[law], GAP, friction, on_border="warn", residual_stress=method
    )
    same = REPEATED[method]
    first = simulation.step(load=EXACT.load)
    assert first.max_equivalent_plastic_strain() > 5e-4
    for cycle in range(cycles):
        unloaded = simulation.step(load=0.0)
        state = simulation.step(load=EXACT.load)
        if cycle == SETTLED:
            settled, bare = state, unloaded
    for name in ("plastic_strain", "equivalent_plastic_strain", "stress", "backstress"):
        late, early = (getattr(moment, name)() for moment in (state, settled))
        assert largest(late - early) <= same * largest(early) if early.size else not late.size
    assert largest(state.pressure - settled.pressure) <= 100 * same * settled.pressure.max()
    residual = bare.residual_stress()
    assert largest(unloaded.residual_stress() - residual) <= same * largest(residual)
    # the total change by all cycles is of the order of tol = 1e-6
    strain = first.plastic_strain()
    assert largest(state.plastic_strain() - strain) < 1e-5 * largest(strain)


def test_alternating_plastic_flow_becomes_periodic():
    """Alternating shear causes flow in every cycle: loops close, are equal and do not drift.

    Pressure and shear are prescribed, kinematic hardening is linear. Neighbouring cells adapt to
    each other more and more slowly: the change per cycle falls faster than 1/cycles.
    """
    law = PERFECT.with_kinematic_hardening(0.2 * E)
    simulation = sc.Simulation(GRID, STEEL, law, GAP, tol=1e-8, on_border="warn")
    pressure = 0.6 * EXACT.pressure(GRID.x[:, None], GRID.y)
    strains, grown = [], []
    for _ in range(81):
        for direction in (0.8, -0.8):
            state = simulation.step(pressure=pressure, shear=direction * pressure)
        strains.append(state.plastic_strain())
        grown.append(state.max_equivalent_plastic_strain())
    assert largest(strains[-1]) > 1e-4
    changes = [largest(strains[n] - strains[n - 1]) for n in (10, 20, 40, 80)]
    assert all(late < 0.4 * early for early, late in itertools.pairwise(changes))
    assert changes[-1] < 1e-4 * largest(strains[-1])
    widths = np.diff(grown)
    assert widths.min() > 1e-3
    assert widths[40:] == pytest.approx(widths[-1], rel=1e-4)

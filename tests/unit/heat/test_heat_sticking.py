# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat in proportion to the pressure of a contact that sticks or slips partially."""

import math

import numpy as np
import pytest
from heat_setups import ALPHA, COLD, KAPPA, WARM, E, K, ball

import samcontact as sc

SIZE = 70e-6
GRID = sc.Grid(16, 16, SIZE, SIZE, 6, SIZE)
SOFT = sc.Material.elastic(0.4 * E, 0.2).with_thermal(K, ALPHA, KAPPA)
SOURCES = {
    "steady": {"velocity": (-0.2, 0.0)},
    "elapsed": {"time": 2e-3},
    "history": {"history": (1e-3, 1.0)},
}


def simulation(friction, source, body2=WARM, factor=0.08, **settings):
    heat = sc.Heat(factor, **SOURCES[source])
    return sc.Simulation(GRID, COLD, body2, ball(GRID), friction, heat=heat, **settings)


def path(source, loads):
    lasting = {"duration": 1e-3} if source == "history" else {}
    return [{"load": load} | lasting for load in loads]


@pytest.mark.parametrize("source", SOURCES)
def test_friction_without_tangential_load_leaves_the_heated_contact(source):
    sticks = simulation(sc.Coulomb(0.3), source, tol=1e-8)
    slides = simulation(0.0, source, tol=1e-8)
    steps = path(source, (800.0, 1200.0))
    states, free = sticks.run(steps, progress=False), slides.run(steps, progress=False)
    cold = sc.Simulation(GRID, COLD, WARM, ball(GRID)).step(load=1200.0)
    assert states[-1].pressure.max() > 1.05 * cold.pressure.max()
    assert not states[-1].shear.any()
    for of in (
        lambda s: s.pressure,
        lambda s: s.temperature(2),
        lambda s: s.stress(2),
        lambda s: s.surface_displacement(2),
    ):
        expected = of(free[-1])
        np.testing.assert_allclose(
            of(states[-1]), expected, rtol=0, atol=1e-6 * np.abs(expected).max()
        )


@pytest.mark.parametrize("friction", [sc.Coulomb(0.3), sc.Coulomb(math.inf)])
def test_dissimilar_heated_bodies_touch_where_they_are_pressed(friction):
    """Initial gap, and displacements due to pressure, shear and heat, add up to the gap."""
    run = simulation(friction, "history", SOFT, factor=0.03, tol=1e-8)
    step = {"load": 500.0, "duration": 1e-3}
    run.step(**step)
    state = run.step(**step, tangential_load=(60.0, 0.0))
    assert state.shear[0].sum() * GRID.cell_area == pytest.approx(60.0, rel=1e-6)
    touches = state.pressure > 0
    gap = ball(GRID) - state.approach + sum(state.surface_displacement(body) for body in (1, 2))
    assert np.abs(gap[touches]).max() < 1e-6 * abs(state.approach)
    assert gap[~touches].min() > 0
    cold = sc.Simulation(GRID, COLD, SOFT, ball(GRID), friction)
    cold.step(load=500.0)
    expected = cold.step(load=500.0, tangential_load=(60.0, 0.0))
    assert state.pressure.max() > 1.02 * expected.pressure.max()


def test_transient_heat_of_full_slip_equals_that_of_full_sliding():
    # Long increments, so that the slip is large compared with elastic displacements.
    mu, speed, step = 0.3, 0.5, 1.0
    source = {"history": (step, 10.0)}
    slides = sc.Simulation(
        GRID, WARM, WARM, ball(GRID), mu,
        heat=sc.Heat(sc.heat.factors(mu, speed, 0.5), **source),
    )  # fmt: skip
    slips = sc.Simulation(
        GRID, WARM, WARM, ball(GRID), sc.Coulomb(mu), heat=sc.Heat(partition=0.5, **source)
    )
    slides.step(load=600.0, heat_factor=0.0, duration=step)
    slips.step(load=600.0, duration=step)
    factors = sc.heat.factors(mu, speed, 0.5)
    for load in (600.0, 550.0):
        expected = slides.step(load=load, heat_factor=factors, duration=step)
        state = slips.step(load=load, shift=(speed * step, 0.0), duration=step)
    assert not state.sticking.any()
    assert expected.surface_temperature(1).max() > 50.0
    for of in (lambda s: s.pressure, lambda s: s.temperature(1), lambda s: s.stress(2)):
        np.testing.assert_allclose(
            of(state), of(expected), rtol=0, atol=1e-4 * np.abs(of(expected)).max()
        )


def test_a_single_contact_with_partial_slip_has_no_heat():
    with pytest.raises(ValueError, match="must be 0 in a ContactSolver with partial slip"):
        sc.ContactSolver(GRID, COLD, WARM, sc.Coulomb(0.3), heat=sc.Heat(0.1))

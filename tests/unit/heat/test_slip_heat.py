# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictional heat with partial slip: frictional power of an increment."""

import copy

import numpy as np
import pytest

import samcontact as sc

GRID = sc.Grid(28, 28, 36e-6, 36e-6, dz=36e-6)
HOT = (50.2, 11.7e-6, 1.367e-5)
BALL = sc.Material.elastic(210e9, 0.3).with_thermal(*HOT)
STEEL = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 10e9).with_thermal(*HOT)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
MU, HEAT_FRACTION = 0.3, 0.6


def simulation(body2=STEEL, friction=None, heat=None, **settings):
    heat = sc.Heat(partition=HEAT_FRACTION) if heat is None else heat
    friction = sc.Coulomb(MU) if friction is None else friction
    return sc.Simulation(GRID, BALL, body2, GAP, friction, heat=heat, **settings)


def power_of(state):
    """Return the frictional power per area [W/m^2]."""
    return np.reshape(state._core.slip_power, GRID.surface_shape)


@pytest.mark.parametrize(
    ("body2", "source"),
    [
        (STEEL, {}),
        (STEEL.with_softening(lambda rise: 1 - 2e-4 * rise), {}),
        (BALL, {"time": 1e-3}),
        (BALL, {"velocity": ((0.0, 0.0), (0.5, 0.1)), "time": 1e-3}),
        (BALL, {"velocity": ((0.2, 0.0), (0.5, 0.0))}),
    ],
    ids=["steady", "softening", "elapsed", "moving", "both moving"],
)
def test_heat_at_full_slip_equals_heat_of_full_sliding(body2, source):
    speed, duration = 0.2, 2.0
    heat = sc.Heat(sc.heat.factors(MU, speed, HEAT_FRACTION), **source)
    slides = simulation(body2, MU, heat)
    sticks = simulation(body2, heat=sc.Heat(partition=HEAT_FRACTION, **source))
    # Cold contact first, because newly contacting cells slip in only a part of the increment.
    slides.step(load=300.0, heat_factor=0.0)
    sticks.step(load=300.0, shift=(speed * duration, 0.0), duration=1e9)
    expected = slides.step(load=300.0, heat_factor=heat.factor)
    state = sticks.step(load=300.0, shift=(speed * duration, 0.0), duration=duration)
    assert not state.sticking.any()
    assert expected.surface_temperature(2).max() > 50
    for of in (
        lambda s: s.pressure,
        lambda s: s.approach,
        lambda s: s.surface_temperature(1),
        lambda s: s.surface_temperature(2),
        lambda s: s.temperature(2)[..., :8],
        lambda s: s.stress(1)[..., :8],
        lambda s: s.stress(2)[..., :8],
        lambda s: s.max_equivalent_plastic_strain(2),
    ):
        # Surface strain slightly changes the slip direction; softening uses the first contact.
        tol = 5e-4 if body2.softening else 1e-5
        np.testing.assert_allclose(of(state), of(expected), atol=tol * np.abs(of(expected)).max())


@pytest.mark.parametrize("source", [{}, {"time": 1e-3, "velocity": ((0, 0), (0.3, 0.2))}])
def test_the_friction_power_enters_the_bodies(source):
    run = simulation(BALL, heat=sc.Heat(partition=HEAT_FRACTION, **source), tol=1e-9)
    before = run.step(load=100.0, duration=1.0)
    assert not power_of(before).any()
    assert not before.surface_temperature(1).any()
    duration = 1e-7
    state = run.step(load=100.0, shift=(6e-7, 3e-7), twist=2e-3, duration=duration)
    power = power_of(state)
    assert 20 < state.sticking.sum() < np.count_nonzero(state.pressure) - 20
    assert not power[state.sticking].any()
    np.testing.assert_allclose(
        power, (state.shear * state.slip).sum(axis=0) / duration, atol=1e-7 * power.max()
    )
    work = state.friction_work - before.friction_work
    assert power.sum() * GRID.cell_area * duration == pytest.approx(work, rel=1e-7)
    for body, share in ((1, 1 - HEAT_FRACTION), (2, HEAT_FRACTION)):
        factor = [0.0, 0.0]
        factor[body - 1] = share
        hot = sc.ContactSolver(GRID, BALL, BALL, heat=sc.Heat(factor, **source))
        cold = sc.ContactSolver(GRID, BALL, BALL)
        z = state.depths
        rise = hot.temperature(power, z, body)
        np.testing.assert_allclose(state.temperature(body), rise, atol=1e-6 * rise.max())
        heated = hot.stress(power, z, body) - cold.stress(power, z, body)
        stress = cold.stress(state.pressure, z, body, shear=state.shear) + heated
        np.testing.assert_allclose(state.stress(body), stress, atol=1e-6 * abs(stress).max())
        assert abs(heated).max() > 1e-3 * abs(stress).max()


def test_heat_of_slip_raises_the_surfaces():
    """The gap under load is the initial gap plus elastic and thermal displacements."""
    run = simulation(BALL, tol=1e-9)
    run.step(load=100.0, duration=1.0)
    state = run.step(load=100.0, shift=(2e-6, 0.0), duration=1e-7)
    touches = state.pressure > 0
    left = GAP - state.approach + sum(state.surface_displacement(body) for body in (1, 2))
    assert abs(left[touches]).max() < 1e-8 * abs(state.approach)
    cold = sc.Simulation(GRID, BALL, BALL, GAP, sc.Coulomb(MU))
    cold.step(load=100.0)
    expected = cold.step(load=100.0, shift=(2e-6, 0.0))
    assert state.pressure.max() > 1.01 * expected.pressure.max()
    slow = simulation(BALL)
    slow.step(load=100.0, duration=1.0)
    state = slow.step(load=100.0, shift=(2e-6, 0.0), duration=1e6)
    np.testing.assert_allclose(state.pressure, expected.pressure, atol=1e-5 * state.pressure.max())


def test_copies_and_parts_of_increments_keep_the_heat(tmp_path):
    run = simulation(increment_tol=5e-2)
    run.step(load=250.0, duration=1.0)
    state = run.step(load=400.0, shift=(3e-6, 0.0), duration=1e-4)
    assert state.substeps > 1
    assert power_of(state).any()
    run.save(tmp_path / "run.h5")
    others = [copy.deepcopy(run), sc.Simulation.load(tmp_path / "run.h5")]
    warm = state.surface_temperature(2)
    expected = run.step(load=400.0, shift=(-2e-6, 0.0), duration=1e-4)
    for other in others:
        assert other.heat == run.heat
        assert np.array_equal(other.state.surface_temperature(2), warm)
        now = other.step(load=400.0, shift=(-2e-6, 0.0), duration=1e-4)
        assert np.array_equal(now.pressure, expected.pressure)
        assert np.array_equal(now.temperature(2), expected.temperature(2))


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: sc.Heat(0.1, partition=0.5), "factor must be 0 with partition"),
        (lambda: sc.Heat(partition=1.5), r"partition must be in \[0, 1\]"),
        (lambda: simulation(friction=0.3), "heat.partition must be None with friction = 0.3"),
        (
            lambda: simulation(sc.Material.elastic(210e9, 0.3)),
            "without thermal constants, got 0.6",
        ),
        (lambda: simulation().step(load=1.0), "duration is required"),
        (lambda: simulation().step(load=1.0, duration=0.0), "duration"),
        (
            lambda: simulation().step(load=1.0, duration=1.0, heat_factor=0.1),
            "heat_factor cannot",
        ),
        (lambda: simulation().step(approach=1e-6, duration=1.0), "heat.reference is required"),
        (
            lambda: sc.ContactSolver(GRID, BALL, BALL, sc.Coulomb(0.3), heat=sc.Heat(partition=0)),
            "heat.partition must be None for a single contact",
        ),
    ],
)
def test_bodies_that_cannot_be_heated_are_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()

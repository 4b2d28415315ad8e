# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction that falls with the slip rate: CONTACT's example, fixed point, memory, refusals."""

import math

import numpy as np
import pytest

import samcontact as sc

# Example "veldep_fric" of CONTACT (Vollebregt and Schuttelaars 2012): rolling cylinder
G, NU, V, FN = 82e9, 0.28, 45.0, 622216.0
STEEL = sc.Material.elastic(2 * G * (1 + NU), NU)
STRIP = sc.Grid(93, 1, 1e-4, 0.2)
CYLINDER = STRIP.x[:, None] ** 2 / (2 * 0.46)
FALLING = sc.FallingCoulomb(0.18, 0.12, 0.1)
SPOT = sc.Grid(28, 28, 36e-6, 36e-6)
WARN = {"on_border": "warn"}  # the strip ends at the edges of the grid
at_edges = pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
BALL = sc.surfaces.paraboloid(SPOT, 7.5e-3)


def counts(found):
    touching = np.count_nonzero(found.pressure)
    return found.sticking.sum(), touching - found.sticking.sum()


@pytest.fixture(scope="module")
def steady():
    drive = {"load": FN, "creepage": (0.9999e-3, 0.0), "speed": V}
    with pytest.warns(sc.GridTooSmallWarning):
        return sc.rolling.steady(STRIP, STEEL, STEEL, CYLINDER, friction=FALLING, **drive, **WARN)


def test_steady_rolling_of_contact(steady):
    assert steady.tangential_load[0] / (0.3 * FN) == pytest.approx(0.5941, abs=1e-4)
    assert counts(steady) == (45, 36)


@pytest.mark.parametrize(
    ("slip_rate", "force", "cells"), [(0.0, 0.5977, (77, 4)), (V, 0.5703, (34, 47))]
)
@at_edges
def test_both_solutions_of_a_short_step_of_contact(steady, slip_rate, force, cells):
    solver = sc.ContactSolver(STRIP, STEEL, STEEL, FALLING, **WARN)
    step = {"load": FN, "previous": steady, "advance": (-STRIP.dx,) * 2,
            "shift": (1e-3 * STRIP.dx, 0.0), "duration": STRIP.dx / V}  # fmt: skip
    found = solver.solve(CYLINDER, slip_rate=slip_rate, **step)
    assert found.tangential_load[0] / (0.3 * FN) == pytest.approx(force, abs=1e-4)
    assert counts(found) == cells
    with pytest.raises(ValueError, match=r"falling number must be at most 1, got 1\.003"):
        solver.solve(CYLINDER, **step)


def require_consistent(found, law, duration):
    """The shear of slipping cells is the coefficient at their own slip rate times the pressure."""
    slips = (found.pressure > 0) & ~found.sticking
    rate = np.hypot(*found.slip)[slips] / duration
    mu = law.kinetic + law.drop * 2 ** (-rate / law.half_speed)
    np.testing.assert_allclose(np.hypot(*found.shear)[slips], mu * found.pressure[slips], rtol=1e-6)
    assert slips.any()


@pytest.mark.parametrize("body1", [STEEL, sc.Material.elastic(100e9, 0.2)], ids=["same", "other"])
def test_the_friction_of_slipping_cells_is_that_of_their_slip_rate(body1):
    law = sc.FallingCoulomb(0.1, 0.2, 2e-3)
    solver = sc.ContactSolver(SPOT, body1, STEEL, law)
    found = solver.solve(BALL, load=300.0, shift=(1.5e-6, 0.0), duration=1e-3)
    require_consistent(found, law, 1e-3)
    assert 0 < found.falling_number < 1
    run = sc.Simulation(SPOT, body1, STEEL, BALL, law, tol=1e-8)
    run.step(load=300.0, duration=1e-3)
    state = run.step(load=300.0, shift=(1.5e-6, 0.0), duration=1e-3)
    require_consistent(state, law, 1e-3)
    np.testing.assert_allclose(state.slip_rate[state.sticking], 0.0)


def test_slow_and_fast_slip_have_the_static_and_the_kinetic_coefficient():
    law = sc.FallingCoulomb(0.1, 0.2, 1e-3)
    for duration, mu in ((1e3, 0.3), (1e-1, 0.1)):
        solver = sc.ContactSolver(SPOT, STEEL, STEEL, law)
        found = solver.solve(BALL, load=300.0, shift=(1e-2, 0.0), duration=duration)
        assert found.tangential_load[0] == pytest.approx(300 * mu, rel=1e-2)


def test_without_a_drop_the_law_is_coulombs():
    one, other = (
        sc.ContactSolver(SPOT, STEEL, STEEL, law).solve(BALL, load=300.0, shift=(1e-6, 0.0))
        for law in (sc.Coulomb(0.3), sc.FallingCoulomb(0.3, 0.0, 1.0))
    )
    assert np.array_equal(one.shear, other.shear)


def test_a_memory_makes_short_steps_possible_and_delays_the_fall():
    law = sc.FallingCoulomb(0.1, 0.2, 1e-3, memory=2e-5)
    run = sc.Simulation(SPOT, STEEL, STEEL, BALL, law)
    duration, step, mu = 1e-3, 2e-6, []
    run.step(load=300.0, duration=duration)
    run.step(load=300.0, shift=(1e-5, 0.0), duration=1e2)  # slow sliding: coefficient 0.3
    rate = np.zeros(SPOT.surface_shape)
    for _ in range(20):
        state = run.step(load=300.0, shift=(step, 0.0), duration=duration)
        mu.append(state.tangential_load[0] / 300.0)
        way = np.hypot(*state.slip)
        kept = np.exp(-way / 2e-5)
        rate = kept * rate + (1 - kept) * way / duration
    assert mu == sorted(mu, reverse=True)
    assert mu[0] > 0.2
    assert mu[-1] < 0.16
    slips = (state.pressure > 0) & ~state.sticking
    np.testing.assert_allclose(state.slip_rate[slips], rate[slips], rtol=1e-3)
    short = sc.FallingCoulomb(0.1, 0.2, 1e-3)
    with pytest.raises(ValueError, match="falling number must be at most 1"):
        sc.ContactSolver(SPOT, STEEL, STEEL, short).solve(
            BALL, load=300.0, shift=(step, 0.0), duration=1e-5
        )


def test_the_slip_rate_survives_a_checkpoint(tmp_path):
    law = sc.FallingCoulomb(0.1, 0.2, 1e-3, memory=1e-6)
    run = sc.Simulation(SPOT, STEEL, STEEL, BALL, law)
    for _ in range(2):
        run.step(load=300.0, shift=(1e-6, 0.0), duration=1e-3)
    run.save(tmp_path / "run.h5")
    again = sc.Simulation.load(tmp_path / "run.h5", gap=BALL)
    step = {"load": 300.0, "shift": (1e-6, 0.0), "duration": 1e-3}
    assert np.array_equal(run.step(**step).slip_rate, again.step(**step).slip_rate)


def test_missing_and_useless_durations():
    solver = sc.ContactSolver(SPOT, STEEL, STEEL, FALLING)
    with pytest.raises(ValueError, match="duration is required because the friction depends"):
        solver.solve(BALL, load=300.0)
    with pytest.raises(ValueError, match="speed is required because the friction depends"):
        sc.rolling.steady(SPOT, STEEL, STEEL, BALL, load=300.0, friction=FALLING)
    with pytest.raises(ValueError, match="duration must be a finite number > 0"):
        solver.solve(BALL, load=300.0, duration=0.0)
    with pytest.raises(ValueError, match="slip_rate must be a finite number >= 0"):
        solver.solve(BALL, load=300.0, duration=1.0, slip_rate=-1.0)
    plain = sc.ContactSolver(SPOT, STEEL, STEEL, sc.Coulomb(0.3))
    for name in ("duration", "slip_rate"):
        with pytest.raises(ValueError, match=f"{name} has no effect with friction"):
            plain.solve(BALL, load=300.0, **{name: 1.0})
    with pytest.raises(ValueError, match="duration is required because the friction depends"):
        sc.Simulation(SPOT, STEEL, STEEL, BALL, FALLING).step(load=300.0)
    assert math.isclose(FALLING.ratio(1e9), 0.3)

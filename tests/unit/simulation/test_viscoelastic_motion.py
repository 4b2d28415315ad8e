# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscoelastic bodies that move through the contact, against steady motion and elastic limits."""

import numpy as np
import pytest

import samcontact as sc
from moving_bodies import crept

G, NU, RADIUS, LOAD = 1143e6, 0.4, 0.05, 6e5
GLASS = sc.Material.elastic(2 * G * (1 + NU), NU)
POLYMER = GLASS.with_relaxation(times=[0.0045], shares=[0.5])
"""Material of CONTACT's visc_cylindr, whose creep time is 9 ms."""
GRID = sc.Grid(50, 1, 0.32e-3, 1.0)
GAP = GRID.x[:, None] ** 2 / (2 * RADIUS)
RIGID = sc.Material.rigid()


def marched(sim, cells, load, speed, *, both=True, **more):
    """Move by single cells towards -x."""
    dx = sim.grid.dx
    step = {"load": load, "advance": (-dx if both else 0.0, -dx), "duration": dx / speed}
    return [sim.step(**step, **more) for _ in range(cells)]


def without_track(load, speed):
    """Return the steady pressure if all material forgets its past where it leaves the grid."""
    zero, unit = sc.ContactSolver(GRID, RIGID, GLASS), np.eye(GRID.nx)
    k = 2 * np.column_stack(
        [zero.displacement(np.ascontiguousarray(row[:, None]))[2] for row in unit]
    )
    operator = k @ crept(unit, 0, POLYMER, speed / GRID.dx)
    inside = np.ones(GRID.nx, bool)
    for _ in range(50):
        n = np.count_nonzero(inside)
        system = np.ones((n + 1, n + 1))
        system[:n, :n], system[:n, n] = operator[np.ix_(inside, inside)], -1.0
        system[n, n] = 0.0
        right = np.append(-GAP[inside, 0], load / (GRID.dx * GRID.dy))
        *found, approach = np.linalg.solve(system, right)
        pressure = np.zeros(GRID.nx)
        pressure[inside] = found
        gap = GAP[:, 0] + operator @ pressure - approach
        now = pressure - gap / k[0, 0] > 0
        if (now == inside).all():
            return pressure
        inside = now
    raise AssertionError("the cells in contact are not found")


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_march_of_rollers_with_and_without_track():
    """Rollers of CONTACT: without the track outside the grid the resistance is 23 % low."""
    sim = sc.Simulation(GRID, POLYMER, POLYMER, GAP, friction=0.0, tol=1e-9, on_border="warn")
    states = marched(sim, 250, LOAD, 1.0)
    steady = sc.rolling.steady(
        GRID, POLYMER, POLYMER, GAP, load=LOAD, friction=0.0, speed=1.0, on_border="warn"
    )
    pressure, highest = states[-1].pressure, steady.pressure.max()
    assert np.abs(pressure - steady.pressure).max() < 1e-3 * highest
    assert states[-1].approach == pytest.approx(steady.approach, rel=1e-3)
    resistance = steady.rolling_resistance
    assert -states[-1].moment[1] == pytest.approx(resistance, rel=1e-3)
    # both rollers lose the work of the moment
    lost = sum(states[-1].viscous_work(body=b) - states[-2].viscous_work(body=b) for b in (1, 2))
    assert lost / GRID.dx == pytest.approx(resistance / RADIUS, rel=0.02)
    forgetful = without_track(LOAD, 1.0)
    moment = np.sum(forgetful * GRID.x) * GRID.dx * GRID.dy
    assert moment / resistance - 1 == pytest.approx(-0.23, abs=0.02)


def test_march_on_a_wave_converges_to_steady_sliding():
    """Friction and pressure on a periodic surface, with three sizes of cells and steps."""
    rubber = sc.Material.elastic(1e7, 0.4).with_relaxation(times=[0.02, 0.2], shares=[0.45, 0.45])
    errors = []
    for n in (16, 32, 64):
        grid = sc.Grid(n, 1, 1 / n, 1.0, periodic="xy")
        wave = 1e-3 * (1 - np.cos(2 * np.pi * grid.x)) + 3e-4 * np.sin(4 * np.pi * grid.x)
        given = grid, RIGID, rubber, wave[:, None]
        steady = sc.sliding.steady(*given, load=9e3, velocity=1.0)
        sim = sc.Simulation(*given, friction=0.0, tol=1e-9)
        before, last = marched(sim, 6 * n, 9e3, 1.0, both=False)[-2:]
        friction = (last.viscous_work(body=2) - before.viscous_work(body=2)) / (grid.dx * 9e3)
        errors.append([friction / steady.friction - 1, last.approach / steady.approach - 1])
    coarse, _, fine = np.abs(errors)
    assert (fine < [6e-3, 5e-4]).all()
    assert (coarse / fine > 4**1.5).all()


def test_march_on_a_wave_in_full_contact_is_of_second_order():
    """Steps of one cell against the closed form; the steady solution has the error of the cells."""
    body = sc.Material.elastic(1.0, 0.0).with_relaxation(times=[0.05], shares=[0.9])
    q, height, mean = 2 * np.pi, 1e-3, 0.2
    exact = height**2 * q**2 * body.loss(q) / 4
    errors, steps = [], []
    for n in (16, 32, 64):
        grid = sc.Grid(n, 1, 1 / n, 1 / n, periodic="xy")
        gap = height * (1 - np.cos(q * grid.x))[:, None]
        given = grid, RIGID, body, gap
        load = mean * grid.cell_area * n
        steady = sc.sliding.steady(*given, load=load, velocity=1.0)
        state = marched(sc.Simulation(*given, tol=1e-10), 6 * n, load, 1.0, both=False)[-1]
        slope = height * q * np.sin(q * grid.x)[:, None]
        force = (state.pressure * slope).mean()
        errors.append(force / exact - 1)
        steps.append(1 - force / (steady.pressure * slope).mean())
    assert (np.abs(errors) < [1.4e-2, 3.3e-3, 8.1e-4]).all()
    np.testing.assert_allclose(steps, [1.4e-2, 3.3e-3, 8.1e-4], rtol=0.02)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize(("speed", "modulus"), [(1e12, 1e7), (1e-12, 4e6)])
def test_fast_and_slow_creepage_is_elastic(speed, modulus):
    """Partial slip of different bodies with the instantaneous and with the long-time moduli."""
    grid = sc.Grid(20, 8, 1.2e-4, 1.5e-4)
    gap = sc.surfaces.paraboloid(grid, 10e-3)

    def last(*bodies, **timed):
        sim = sc.Simulation(grid, *bodies, gap, friction=sc.Coulomb(0.3), tol=1e-10)
        step = {"load": 0.01, "advance": (-grid.dx, -grid.dx), "shift": (2e-3 * grid.dx, 0.0)}
        return [sim.step(**step, **timed) for _ in range(24)][-1]

    elastic = [sc.Material.elastic(modulus, nu) for nu in (0.3, 0.45)]
    relaxing = [
        sc.Material.elastic(1e7, nu).with_relaxation(times=[0.5], shares=[0.6])
        for nu in (0.3, 0.45)
    ]
    found, expected = last(*relaxing, duration=grid.dx / speed), last(*elastic)
    force = expected.tangential_load
    assert 0.2 < force[0] / (0.3 * 0.01) < 0.999
    np.testing.assert_allclose(found.tangential_load, force, atol=1e-6 * force[0])
    for one, other in ((found.pressure, expected.pressure), (found.shear, expected.shear)):
        np.testing.assert_allclose(one, other, atol=1e-6 * np.abs(other).max())


def test_return_restart_and_refusals(tmp_path):
    """The track is read from a checkpoint; material that returns has kept it."""
    body = sc.Material.elastic(1e7, 0.4).with_relaxation(times=[0.1, 10.0], shares=[0.4, 0.4])
    grid = sc.Grid(24, 6, 1e-4, 2e-4)
    gap = sc.surfaces.paraboloid(grid, 10e-3)
    sim = sc.Simulation(grid, RIGID, body, gap, friction=0.0)
    marched(sim, 40, 0.005, 1e-3)
    sim.save(tmp_path / "half.npz")
    again = sc.Simulation.load(tmp_path / "half.npz")
    one, two = (marched(s, 3, 0.005, 1e-3)[-1] for s in (sim, again))
    np.testing.assert_array_equal(one.pressure, two.pressure)
    assert one.viscous_work(body=2) == two.viscous_work(body=2)
    # unloaded material far from the contact returns at once: it recovers as it would have at rest
    away, recovered = 60 * grid.dx, one.residual_displacement(body=2)
    sim.step(load=0.0, advance=(0.0, -away), duration=0.0)
    there = sim.state.residual_displacement(body=2)
    assert np.abs(there).max() < 0.3 * np.abs(recovered).max()
    back = sim.step(load=0.0, advance=(0.0, away), duration=0.0)
    rest = again.step(load=0.0, duration=0.0)
    np.testing.assert_allclose(
        back.residual_displacement(body=2),
        rest.residual_displacement(body=2),
        atol=1e-9 * np.abs(recovered).max(),
    )
    with pytest.raises(ValueError, match=r"advance of body 2 must be a multiple of the cell size"):
        sim.step(load=0.0, advance=(0.0, 0.5 * grid.dx), duration=0.1)
    with pytest.raises(ValueError, match=r"along y is not supported of viscoelastic bodies"):
        sim.step(load=0.0, advance=((0.0, 0.0), (0.0, grid.dy)), duration=0.1)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_creepage_is_the_slip_of_the_crept_shear():
    """Steady partial slip at a speed between both limits, on a grid that holds the whole track."""
    body = sc.Material.elastic(1e7, 0.4).with_relaxation(times=[2e-2, 2e-1], shares=[0.3, 0.3])
    grid, speed, cells = sc.Grid(30, 1, 6e-5, 1e-3), 3e-3, 400
    gap = grid.x[:, None] ** 2 / (2 * 10e-3)
    given = {"friction": sc.Coulomb(0.3), "tol": 1e-10, "on_border": "warn"}
    sim = sc.Simulation(grid, body, body, gap, **given)
    shift = 8e-3 * grid.dx
    state = marched(sim, 250, 0.05, speed, shift=(shift, 0.0))[-1]
    acting = crept(state.shear[0], cells, body, speed / grid.dx)
    track = sc.Grid(len(acting), 1, grid.dx, grid.dy)
    zero = sc.ContactSolver(track, RIGID, sc.Material.elastic(body.E, body.nu))
    shear = np.stack([acting, np.zeros_like(acting)])
    u = 2 * zero.displacement(np.zeros_like(acting), shear)[0][cells:, 0]
    loaded = state.pressure[:-1, 0] > 0
    slip = (shift - (u[:-1] - u[1:]))[loaded]
    np.testing.assert_allclose(slip, state.slip[0][:-1, 0][loaded], atol=4e-3 * shift)
    sticking = np.count_nonzero(state.slip[0][:-1, 0][loaded] == 0)
    assert 3 < sticking < len(slip) - 3
    steady = sc.rolling.steady(
        grid, body, body, gap, load=0.05, creepage=(8e-3, 0.0), speed=speed, **given
    )
    for one, other in ((state.pressure, steady.pressure), (state.shear, steady.shear)):
        np.testing.assert_allclose(one, other, atol=5e-3 * np.abs(other).max())


def test_march_of_a_coated_body():
    """Layers that share one relaxation, rolling on 16 cells, approach the steady state."""
    soft, hard = (
        sc.Material.elastic(modulus, 0.4).with_relaxation(times=[2e-2], shares=[0.6])
        for modulus in (1e7, 5e7)
    )
    coated = sc.Layered([(soft, 1.5e-3)], hard)
    grid = sc.Grid(16, 8, 0.75e-3, 2e-3)
    gap = sc.surfaces.paraboloid(grid, 0.1)
    steady = sc.rolling.steady(grid, RIGID, coated, gap, load=0.8, friction=0.0, speed=0.05)
    thick = sc.rolling.steady(grid, RIGID, soft, gap, load=0.8, friction=0.0, speed=0.05)
    sim = sc.Simulation(grid, RIGID, coated, gap, friction=0.0, tol=1e-8)
    state = marched(sim, 64, 0.8, 0.05)[-1]
    assert np.abs(state.pressure - steady.pressure).max() < 0.012 * steady.pressure.max()
    assert state.approach == pytest.approx(steady.approach, rel=1e-3)
    assert -state.moment[1] == pytest.approx(steady.rolling_resistance, rel=0.03)
    assert steady.rolling_resistance < 0.8 * thick.rolling_resistance

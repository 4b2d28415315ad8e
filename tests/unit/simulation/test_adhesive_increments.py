# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments with adhesion: branches, pull-off, work of a cycle, plastic flow and restart."""

import math

import numpy as np
import pytest

import samcontact as sc

pytestmark = pytest.mark.filterwarnings("ignore:the attraction at the edge")
R, W, E = 1e-6, 0.05, 1e9
TIP, SOFT = sc.Material.rigid(), sc.Material.elastic(E, 0.3)
LAW = sc.Adhesion.exponential(W, 1e-9)
FORCE = math.pi * W * R


def ball(law=LAW, n=32, dx=6e-9, body=SOFT, radius=R, **more):
    grid = sc.Grid(n, n, dx, dx, **more)
    return sc.Simulation(grid, TIP, body, sc.surfaces.paraboloid(grid, radius), adhesion=law)


def work_of(states):
    """Return the work on the bodies along the states [J]."""
    loads = np.array([s.load for s in states])
    approaches = np.array([s.approach for s in states])
    return float(np.sum(0.5 * (loads[1:] + loads[:-1]) * np.diff(approaches)))


def test_a_simulation_starts_apart_and_equals_the_contact():
    simulation = ball()
    assert simulation.state.load == 0.0
    assert simulation.state.approach < -20e-9
    assert not simulation.state.in_contact.any()
    state = simulation.step(approach=1e-9)
    solver = sc.ContactSolver(simulation.grid, TIP, SOFT, adhesion=LAW, tol=1e-9)
    found = solver.solve(simulation.initial_gap, approach=1e-9)
    np.testing.assert_allclose(state.pressure, found.pressure, atol=1e-5 * found.pressure.max())
    assert np.array_equal(state.in_contact, found.in_contact)
    assert state.adhesion_stress.max() == pytest.approx(LAW.peak, rel=0.1)
    apart = simulation.step(approach=-40e-9)
    assert apart.load == pytest.approx(0.0, abs=1e-6 * FORCE)


def test_a_cycle_loses_work_in_its_jumps():
    radius = 4e-6
    simulation = ball(sc.Adhesion.jkr(W), n=64, dx=9e-9, radius=radius)
    path = np.concatenate([np.linspace(-7e-9, 0.0, 36), np.linspace(0.0, -7e-9, 36)[1:]])
    states = [simulation.step(approach=a) for a in path]
    ends = states[0], states[-1]
    assert ends[1].load == pytest.approx(ends[0].load, abs=1e-4 * FORCE)
    scale = math.pi * W * radius * 3.8e-9
    assert 0.05 * scale < work_of(states) < 1.3 * scale
    closed = [s.in_contact.any() for s in states]
    pulled_in = path[closed.index(True)]
    pulled_off = path[len(closed) - 1 - closed[::-1].index(True)]
    assert pulled_off < pulled_in  # hysteresis


def test_a_machine_of_finite_stiffness_is_a_spring_in_series():
    for periodic in ("", "xy"):
        grid = sc.Grid(32, 32, 6e-9, 6e-9, periodic=periodic)
        gap = sc.surfaces.paraboloid(grid, R)
        machine = sc.Simulation(grid, TIP, SOFT, gap, adhesion=LAW, stiffness=200.0)
        rigid = sc.Simulation(grid, TIP, SOFT, gap, adhesion=LAW)
        for approach in (2e-9, 0.0, -1e-9):
            state = machine.step(approach=approach)
            assert state.approach == pytest.approx(approach - state.load / 200.0, abs=1e-20)
            other = rigid.step(approach=state.approach)
            np.testing.assert_allclose(
                state.pressure, other.pressure, atol=1e-6 * other.pressure.max()
            )
    soft = sc.Simulation(grid, TIP, SOFT, gap, adhesion=LAW, stiffness=1.0)
    soft.step(approach=0.0)
    found = sc.paths.pull_off(soft, step=5e-9)
    lost = found.states[-2]
    assert found.is_apart
    assert -lost.load > 0.9 * found.pull_off  # it jumps apart near the largest tension


def test_pull_off_is_the_largest_tension():
    simulation = ball()
    simulation.step(approach=0.0)
    with pytest.raises(sc.PullOffError) as caught:
        simulation.step(load=-3 * FORCE)
    assert simulation.state.approach == 0.0  # the state before the error remains
    found = sc.paths.pull_off(simulation, step=1e-10)
    assert found.is_apart
    assert found.pull_off == pytest.approx(caught.value.pull_off, rel=3e-3)
    assert 1.5 * FORCE < found.pull_off < 2.0 * FORCE
    assert found.pull_off == max(-s.load for s in found.states)
    assert found.work == pytest.approx(work_of(found.states), rel=1e-12)
    early = ball()
    early.step(approach=0.0)
    stopped = sc.paths.pull_off(early, step=1e-10, until="maximum")
    assert stopped.pull_off == found.pull_off
    assert not stopped.is_apart
    other = ball()
    other.step(approach=0.0)
    with pytest.raises(ValueError, match="do not separate"):
        sc.paths.pull_off(other, step=1e-12, max_steps=3)


def test_a_refined_attraction_above_the_yield_stress_is_told():
    soft = sc.Material.perfect_plastic(E, 0.3, 40e6)
    with pytest.warns(sc.ResolutionWarning, match="exceeds the yield stress 40 MPa, and its range"):
        ball(sc.Adhesion.jkr(W), n=16, dx=12e-9, body=soft, dz=12e-9).step(approach=-1e-9)


def test_a_restart_continues_on_the_branch(tmp_path):
    simulation = ball(sc.Adhesion.jkr(W))
    for approach in (0.0, 1e-9, -1e-9):
        simulation.step(approach=approach)
    simulation.save(tmp_path / "state.h5")
    loaded = sc.Simulation.load(tmp_path / "state.h5")
    assert loaded.adhesion == sc.Adhesion.jkr(W)
    for approach in (-1.5e-9, -2e-9):
        first, second = simulation.step(approach=approach), loaded.step(approach=approach)
        assert np.array_equal(first.pressure, second.pressure)
        assert first.load == second.load


def pulled_off(body, load, tension_free):
    """Return pull-off force and effective radius after pressing to a load."""
    law = sc.Adhesion.exponential(W_GOLD, RANGE_GOLD)
    radius = 1e-6
    grid = sc.Grid(40, 40, 6e-9, 6e-9, dz=8e-9)
    simulation = sc.Simulation(
        grid, TIP, body, sc.surfaces.paraboloid(grid, radius), adhesion=law, on_border="warn"
    )
    pressed = simulation.step(load=load)
    found = sc.paths.pull_off(simulation, step=2e-10, until="maximum")
    plastic = pressed.max_strains[1][0] if body.is_plastic else 0.0
    return found.pull_off, plastic, tension_free


W_GOLD, RANGE_GOLD = 1.0, 1.2e-9


def test_plastic_flow_increases_the_pull_off_force():
    """The crater conforms to the ball, so that its effective radius is larger."""
    elastic = sc.Material.elastic(80e9, 0.4)
    gold = sc.Material.linear_hardening(80e9, 0.4, 1.2e9, 2e9)
    load = 2e-5
    stiff, none, _ = pulled_off(elastic, load, True)
    soft, strain, _ = pulled_off(gold, load, True)
    assert none == 0.0
    assert strain > 0.005
    assert stiff == pytest.approx(1.6 * math.pi * W_GOLD * 1e-6, rel=0.25)
    assert soft > 1.1 * stiff

# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure and shear together, where the sweeps between them stall."""

import math

import numpy as np
import pytest

import samcontact as sc
from benchmarks.stability import scenes

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning",
    "ignore::samcontact.ResolutionWarning",
    "ignore::samcontact.ElasticStrainWarning",
)

# Scenes whose sweeps stall: pulled, shifted, turned, unloaded, driven by the approach.
STALLED = [4, 6, 15, 18, 21, 28, 32, 33, 44, 48, 49]


@pytest.mark.parametrize("seed", STALLED)
def test_contacts_without_slip_are_solved(seed):
    """The conditions hold by a dense matrix made from closed forms."""
    given = scenes.scene("none", seed)
    found = scenes.outcome(given)
    assert found.error == ""
    assert found.counters["joint_steps"] > 0
    assert max(scenes.residuals(given, found.states)) < 1e-6
    assert len(found.states) == len(given.steps)


def test_cells_carry_shear_at_the_pressure_zero():
    """The state that the sweeps lack: a cell of an edge touches, is not pressed, and slides."""
    found = [
        state for seed in STALLED for state in scenes.outcome(scenes.scene("none", seed)).states
    ]
    sheared = [(state.pressure == 0) & (np.hypot(*state.shear) > 0) for state in found]
    slid = [np.hypot(*state.slip) for state in found]
    assert sum(np.count_nonzero(cells) for cells in sheared) >= 1
    for state, cells, slip in zip(found, sheared, slid, strict=True):
        assert not np.any(state.sticking & cells)
        assert np.all(slip[cells] > 0)
        assert np.abs(state.gap[cells]).max(initial=0.0) < 1e-6 * state.approach


def hard_contact(**settings):
    """A rigid ball, pressed and shifted by a fifth of its approach without slip."""
    body1, body2 = sc.Material.rigid(), sc.Material.elastic(210e9, 0.0)
    ball = sc.hertz.point(7.5e-3, sc.hertz.effective_modulus(body1, body2), load=300.0)
    grid = sc.Grid(13, 13, 3 * ball.a / 13, 3 * ball.a / 13)
    solver = sc.ContactSolver(
        grid, body1, body2, sc.Coulomb(math.inf), on_border="warn", **settings
    )
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    pressed = solver.solve(gap, load=300.0)
    shift = (0.2 * ball.approach, 0.0)
    return solver.solve(gap, approach=pressed.approach, shift=shift, previous=pressed)


def test_a_single_contact_is_solved_too():
    found = hard_contact()
    assert found.joint_steps > 0
    assert found.converged
    assert max(found.error, found.tangential_error) <= 1e-8
    assert hard_contact(on_stall="warn").shear.tobytes() == found.shear.tobytes()


@pytest.fixture
def beyond_reach():
    """A solver whose tolerance is below the rounding errors of the hard contact."""
    return {"tol": 1e-13}


def test_without_a_solution_the_best_state_is_returned_under_a_warning(beyond_reach):
    try:
        hard_contact(**beyond_reach)
    except sc.ConvergenceError as error:
        told = str(error)
    else:
        pytest.skip("solved to rounding here")
    assert "Newton steps on pressure and shear together" in told
    assert 'on_stall="warn"' in told
    with pytest.warns(sc.ConvergenceWarning, match="state with the smallest error"):
        found = hard_contact(**beyond_reach, on_stall="warn")
    assert not found.converged
    assert max(found.error, found.tangential_error) < 1e-9
    assert np.all(found.pressure >= 0)


def test_on_stall_is_checked():
    with pytest.raises(ValueError, match="on_stall must be"):
        hard_contact(on_stall="ignore")


def test_a_body_yields_while_its_contact_does_not_slip():
    """A polymer ball on steel that yields: the same history in a body that cannot yield differs,
    and one whose yield stress is out of reach is elastic to the tolerance."""
    given = scenes.scene("none", 44)
    grid = sc.Grid(given.grid.nx, given.grid.ny, scenes.CELL, scenes.CELL, 6, scenes.CELL)
    elastic = scenes.outcome(given)
    soft, hard = (
        sc.Material.linear_hardening(70e9, 0.33, strength, 7e9) for strength in (0.3e9, 1e13)
    )
    press, pull = given.steps[:2]

    def state(body):
        simulation = sc.Simulation(
            grid, given.bodies[0], body, given.gap, given.friction, on_border="warn"
        )
        simulation.step(**press)
        return simulation.step(**pull)

    same, yielded = state(hard), state(soft)
    assert same.joint_steps > 0
    largest = same.pressure.max()
    assert np.abs(same.pressure - elastic.states[1].pressure).max() < 1e-5 * largest
    assert yielded.converged
    assert yielded.tangential_load == pytest.approx(pull["tangential_load"], rel=1e-5)
    assert yielded.equivalent_plastic_strain().max() > 0


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["none", "coulomb", "tresca"])
def test_thousand_random_scenes(kind):
    """At most five of a thousand contacts have no solution."""
    failed = [seed for seed in range(1000) if scenes.outcome(scenes.scene(kind, seed)).error]
    assert len(failed) <= 5

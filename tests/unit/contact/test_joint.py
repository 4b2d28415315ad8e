# SPDX-License-Identifier: GPL-3.0-or-later
"""Newton's method on pressure and shear together, where the sweeps between them stall."""

import functools
import math

import numpy as np
import pytest

import samcontact as sc
from benchmarks.stability import random_contacts

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning",
    "ignore::samcontact.ResolutionWarning",
    "ignore::samcontact.ElasticStrainWarning",
)

# Random contacts whose sweeps stall: unloaded, pulled, pulled in two directions, shifted.
STALLED = [("none", 4), ("none", 6), ("none", 32), ("none", 33)]


@functools.cache
def solved(law, number):
    contact = random_contacts.random_contact(law, number)
    return contact, random_contacts.solve(contact)


@pytest.mark.parametrize(("law", "number"), STALLED)
def test_conditions_of_contact_and_friction_hold(law, number):
    """The dense matrix is made from closed forms. Prescribed forces and motions are reached."""
    contact, found = solved(law, number)
    assert found.error == ""
    assert found.counters["joint_steps"] > 0
    assert len(found.states) == len(contact.steps)
    assert max(random_contacts.residuals(contact, found.states)) < 1e-6
    shift = np.zeros(2)
    for step, state in zip(contact.steps, found.states, strict=True):
        area = contact.grid.cell_area
        force = area * state.shear.sum(axis=(1, 2))
        if "load" in step:
            assert area * state.pressure.sum() == pytest.approx(step["load"], rel=1e-6)
        if "tangential_load" in step:
            assert force == pytest.approx(step["tangential_load"], rel=1e-5)
        elif "shift" in step:
            shift = shift + step["shift"]
            assert state.shift == pytest.approx(shift, rel=1e-12)


def test_cells_at_zero_pressure_slide_in_contact():
    found = [state for stalled in STALLED for state in solved(*stalled)[1].states]
    sheared = [(state.pressure == 0) & (np.hypot(*state.shear) > 0) for state in found]
    assert any(cells.any() for cells in sheared)
    for state, cells in zip(found, sheared, strict=True):
        slip = state.slip[:, cells]
        assert not np.any(state.sticking & cells)
        assert np.all(np.hypot(*slip) > 0)
        assert np.abs(state.gap[cells]).max(initial=0.0) < 1e-6 * state.approach
        along = (slip * state.shear[:, cells]).sum(axis=0)
        assert along == pytest.approx(np.hypot(*slip) * np.hypot(*state.shear[:, cells]), rel=1e-5)


GRID_OF_BALL = 13


def ball_on_half_space(**settings):
    """Return the contact of a rigid ball after a shift by a fifth of its approach without slip."""
    body1, body2 = sc.Material.rigid(), sc.Material.elastic(210e9, 0.0)
    ball = sc.hertz.point(7.5e-3, sc.hertz.effective_modulus(body1, body2), load=300.0)
    size = 3 * ball.a / GRID_OF_BALL
    grid = sc.Grid(GRID_OF_BALL, GRID_OF_BALL, size, size)
    solver = sc.ContactSolver(
        grid, body1, body2, sc.Coulomb(math.inf), on_border="warn", **settings
    )
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    pressed = solver.solve(gap, load=300.0)
    shift = (0.2 * ball.approach, 0.0)
    return solver.solve(gap, approach=pressed.approach, shift=shift, previous=pressed)


def test_the_solution_has_the_symmetry_of_the_contact():
    found = ball_on_half_space()
    assert found.joint_steps > 0
    assert found.converged
    assert max(found.error, found.tangential_error) <= 1e-8
    (x, y), pressure = found.shear, found.pressure
    scale = 1e-6 * pressure.max()
    np.testing.assert_allclose(pressure, pressure[:, ::-1], rtol=0, atol=scale)
    np.testing.assert_allclose(x, x[:, ::-1], rtol=0, atol=scale)
    np.testing.assert_allclose(y, -y[:, ::-1], rtol=0, atol=scale)
    assert ball_on_half_space(on_stall="warn").shear.tobytes() == found.shear.tobytes()


def test_state_with_the_smallest_error_is_returned_under_a_warning():
    """60 iterations suffice for each pressure, but not for pressure and shear together."""
    few = {"max_iterations": 60}
    with pytest.raises(sc.ConvergenceError) as failure:
        ball_on_half_space(**few)
    message = str(failure.value)
    assert "60 Newton steps on pressure and shear together" in message
    assert 'on_stall="warn"' in message
    with pytest.warns(sc.ConvergenceWarning, match="state with the smallest error"):
        found = ball_on_half_space(**few, on_stall="warn")
    assert not found.converged
    assert found.joint_steps == 60
    error = max(found.error, found.tangential_error)
    assert 1e-8 < error == pytest.approx(failure.value.residual)
    assert error < 1e-2
    assert np.all(found.pressure >= 0)


def test_on_stall_is_checked():
    with pytest.raises(ValueError, match="on_stall must be"):
        ball_on_half_space(on_stall="ignore")


@pytest.mark.slow
@pytest.mark.parametrize("law", ["none", "coulomb", "tresca"])
def test_thousand_random_contacts(law):
    """At most five of a thousand contacts do not converge."""
    failed = [number for number in range(1000) if solved.__wrapped__(law, number)[1].error]
    assert len(failed) <= 5

# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip and creep of bodies that adhere, against independent solutions."""

import numpy as np
import pytest
from scipy.optimize import brentq

import samcontact as sc

pytestmark = [
    pytest.mark.filterwarnings("ignore:the attraction at the edge"),
    pytest.mark.filterwarnings("ignore:under-resolved contact"),
]
W, MU, R = 0.05, 0.4, 2e-7
LAW = sc.Adhesion.exponential(W, 4e-9)
GRID = sc.Grid(40, 40, 4e-9, 4e-9)
GAP = sc.surfaces.paraboloid(GRID, R)
RIGID = sc.Material.rigid()


def slipping(*bodies, law=LAW, **more):
    return sc.Simulation(GRID, *bodies, GAP, friction=sc.Coulomb(MU), adhesion=law, **more)


def test_shear_is_a_difference_of_two_hard_contacts():
    """nu = 0: at the attraction of the solution, the theorem of Ciavarella and Jaeger holds."""
    body = sc.Material.elastic(2e9, 0.0)
    force = 1.4e-8
    simulation = slipping(body, body, tol=1e-9)
    simulation.step(load=1e-8)
    state = simulation.step(load=1e-8, tangential_load=(force, 0.0))
    pull = state.repulsion - state.pressure
    moved = sc.ContactSolver(GRID, body, body)
    attracted = GAP - sum(moved.displacement(pull, body=b)[2] for b in (1, 2))
    hard = sc.ContactSolver(GRID, body, body, tol=1e-11)
    full = hard.solve(attracted, approach=state.approach)
    np.testing.assert_allclose(full.pressure, state.repulsion, atol=1e-9 * full.pressure.max())

    def missing(approach):
        return MU * (full.load - hard.solve(attracted, approach=approach).load) - force

    smaller = brentq(missing, attracted.min(), state.approach, xtol=1e-18, rtol=1e-12)
    expected = MU * (full.pressure - hard.solve(attracted, approach=smaller).pressure)
    np.testing.assert_allclose(state.shear[0], expected, atol=1e-7 * expected.max())
    assert 0 < np.sum(state.sticking) < np.sum(state.in_contact)


@pytest.mark.parametrize(
    "bodies",
    [
        (RIGID, sc.Material.elastic(2e9, 0.2)),
        (sc.Material.elastic(4e9, 0.4), sc.Material.elastic(2e9, 0.1)),
    ],
)
def test_slip_of_dissimilar_bodies_is_that_of_their_displacements(bodies):
    """The slip equals the shift less the displacements due to tension, pressure and shear."""
    simulation = slipping(*bodies, tol=1e-9)
    solver = sc.ContactSolver(GRID, *bodies)
    before = simulation.step(load=1e-8)
    for step in (
        {"load": 1.1e-8, "tangential_load": (1e-8, 0.0)},
        {"approach": 0.5 * before.approach, "tangential_load": (-2e-9, 3e-9)},
        {"approach": 0.9 * before.approach, "tangential_load": (-6e-9, 3e-9)},
    ):
        state = simulation.step(**step)
        moved = np.zeros((2, *GRID.surface_shape))
        for number, sign in ((1, -1.0), (2, 1.0)):
            if bodies[number - 1].is_rigid:
                continue
            for at, way in ((state, sign), (before, -sign)):
                moved += way * solver.displacement(at.pressure, at.shear, body=number)[:2]
        shift = np.asarray(state.shift) - np.asarray(before.shift)
        slip = shift[:, None, None] - moved
        lasting = state.in_contact & before.in_contact
        assert np.sum(state.sticking) > 10
        np.testing.assert_allclose(
            slip[:, lasting], state.slip[:, lasting], atol=1e-8 * np.abs(shift).max()
        )
        before = state


def test_only_cells_in_contact_stick_without_slip():
    """The attraction across open cells transmits no shear, and the force equals the traction."""
    body, force = sc.Material.elastic(2e9, 0.3), 5e-9
    simulation = sc.Simulation(GRID, RIGID, body, GAP, friction=sc.Coulomb(np.inf), adhesion=LAW)
    simulation.step(load=1e-8)
    state = simulation.step(load=1e-8, tangential_load=(force, 0.0))
    shear = np.hypot(*state.shear)
    assert not shear[~state.in_contact].any()
    assert shear[state.in_contact].all()
    assert state.shear[0].sum() * GRID.cell_area == pytest.approx(force, rel=1e-8)


def test_vanishing_adhesion_is_hard_contact_with_partial_slip():
    body = sc.Material.elastic(2e9, 0.3)
    weak = slipping(RIGID, body, law=sc.Adhesion.exponential(1e-9 * W, 4e-9))
    hard = slipping(RIGID, body, law=sc.HardContact())
    for simulation in (weak, hard):
        simulation.step(load=2e-8)
    weak, hard = (s.step(load=2e-8, tangential_load=(5e-9, 2e-9)) for s in (weak, hard))
    assert np.abs(weak.shear - hard.shear).max() < 1e-5 * np.abs(hard.shear).max()
    assert weak.approach == pytest.approx(hard.approach, rel=1e-6)


def test_a_creeping_ball_holds_more_when_pulled_fast():
    """The limits of fast and slow pulling are elastic, and each closed cycle loses work."""
    grid = sc.Grid(40, 40, 8e-9, 8e-9)
    gap = sc.surfaces.paraboloid(grid, 1e-6)
    law = sc.Adhesion.exponential(W, 2e-9)
    elastic = sc.Material.elastic(2e9, 0.3)
    creeping = elastic.with_relaxation([1e-2, 1.0], [0.3, 0.3])
    slow_body = sc.Material.elastic(0.4 * 2e9, 0.3)

    def ball(body):
        return sc.Simulation(grid, RIGID, body, gap, adhesion=law)

    fast = ball(creeping).step(approach=2e-9, duration=0.0)
    expected = ball(elastic).step(approach=2e-9)
    np.testing.assert_array_equal(fast.pressure, expected.pressure)
    pulls = []
    for duration in (0.0, 0.1, 1e5):
        simulation = ball(creeping)
        simulation.step(approach=2e-9, duration=0.0)
        relaxed = simulation.step(approach=2e-9, duration=np.inf)
        tension = [
            -simulation.step(approach=2e-9 - n * 3e-10, duration=duration).load
            for n in range(1, 16)
        ]
        pulls.append(max(tension) / (np.pi * W * 1e-6))
    expected = ball(slow_body).step(approach=2e-9)
    assert relaxed.load == pytest.approx(expected.load, rel=1e-6)
    assert pulls[0] > 1.2 * pulls[1] > 1.2**2 * pulls[2]
    other = ball(slow_body)
    slowest = [-other.step(approach=2e-9 - n * 3e-10).load for n in range(16)]
    assert pulls[2] == pytest.approx(max(slowest) / (np.pi * W * 1e-6), rel=1e-3)


def test_adhesion_with_a_viscoelastic_fluid_is_refused():
    fluid = sc.Material.elastic(2e9, 0.3).with_relaxation([1.0], [1.0])
    with pytest.raises(ValueError, match="which has no long-time modulus"):
        sc.Simulation(GRID, RIGID, fluid, GAP, adhesion=LAW)

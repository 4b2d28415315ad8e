# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhering bodies that move through the grid in full sliding."""

import numpy as np
import pytest

import samcontact as sc

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning", "ignore::samcontact.ResolutionWarning"
)
TIP, SOFT = sc.Material.rigid(), sc.Material.elastic(1e9, 0.3)
LAW = sc.Adhesion.exponential(0.05, 2.5e-9)


def test_a_rough_surface_moves_past_an_adhering_bump():
    """Each position is the contact with the shifted heights, on the branch of the last one."""
    n, dx, approach = 24, 1e-8, 1.2e-9
    grid = sc.Grid(n, n, dx, dx, periodic="xy")
    heights = sc.surfaces.rough_self_affine(grid, 1.2e-9, 0.8, wavelength_min=6e-8, seed=3)
    far = grid.x[:, None] ** 2 + grid.y[None] ** 2
    gap = 2e-9 * (1 - np.exp(-far / (6e-8) ** 2))
    simulation = sc.Simulation(
        grid, TIP, SOFT, gap, adhesion=LAW, relief1=sc.Relief(heights, 0, True), tol=1e-8
    )
    solver = sc.ContactSolver(grid, TIP, SOFT, adhesion=LAW, tol=1e-9)
    states, found = [simulation.step(approach=approach)], None
    states += [simulation.step(approach=approach, advance=(2 * dx, 0.0)) for _ in range(12)]
    for k, state in enumerate(states):
        start = None if found is None else found.pressure
        shifted = gap - np.roll(heights, 2 * k, axis=0)
        found = solver.solve(shifted, approach=approach, initial_pressure=start)
        largest = np.abs(found.pressure).max()
        np.testing.assert_allclose(state.pressure, found.pressure, rtol=0, atol=1e-6 * largest)
    loads = [state.load for state in states]
    assert loads[12] == pytest.approx(loads[0], rel=0.1)  # one period
    assert np.ptp(loads) > 0.05 * abs(loads[0])


def test_an_imprint_moves_with_its_body_under_an_adhering_ball():
    """Once nothing yields, the contact is elastic, over the imprint that has moved."""
    n, dx = 24, 8e-9
    grid = sc.Grid(n, n, dx, dx, dz=dx, nz=10)
    metal = sc.Material.perfect_plastic(1e9, 0.3, 30e6)
    law = sc.Adhesion.exponential(0.02, 1.6e-9)
    gap = sc.surfaces.paraboloid(grid, 4e-7)
    simulation = sc.Simulation(grid, TIP, metal, gap, adhesion=law, tol=1e-7, on_border="warn")
    pressed = simulation.step(approach=4e-9)
    strain = pressed.max_equivalent_plastic_strain(2)
    assert strain > 0.01
    solver = sc.ContactSolver(grid, TIP, SOFT, adhesion=law, tol=1e-9, on_border="warn")
    loads = [simulation.step(approach=1.0e-9).load]
    for shift in range(1, 4):
        state = simulation.step(approach=1.0e-9, advance=(dx, dx))
        loads.append(state.load)
        assert state.max_equivalent_plastic_strain(2) == pytest.approx(strain, rel=1e-12)
        moved = state.residual_displacement(2)
        found = solver.solve(gap + moved, approach=1.0e-9, initial_pressure=state.pressure)
        largest = np.abs(found.pressure).max()
        np.testing.assert_allclose(state.pressure, found.pressure, rtol=0, atol=1e-4 * largest)
        deepest = np.unravel_index(moved.argmax(), moved.shape)[0]
        assert deepest in (11 + shift, 12 + shift)
    assert abs(loads[3] / loads[0] - 1) > 0.02


def test_motion_of_adhering_bodies_under_partial_slip_is_refused():
    grid = sc.Grid(16, 16, 1e-8, 1e-8)
    gap = sc.surfaces.paraboloid(grid, 4e-7)
    law = sc.Adhesion.exponential(0.05, 2.5e-9)
    simulation = sc.Simulation(grid, TIP, SOFT, gap, sc.Coulomb(0.3), adhesion=law)
    simulation.step(approach=0.0)
    with pytest.raises(ValueError, match=r"and partial slip, got \(1e-08, 1e-08\): with"):
        simulation.step(approach=0.0, advance=(1e-8, 1e-8))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Moments on adhering bodies: an eccentric load moves the contact of a paraboloid."""

import numpy as np
import pytest

import samcontact as sc

pytestmark = pytest.mark.filterwarnings("ignore:the attraction at the edge")
W, R = 0.05, 1e-6
SOFT = sc.Material.elastic(2e9, 0.3)
FORCE = np.pi * W * R
GRID = sc.Grid(80, 80, 8e-9, 8e-9)
GAP = sc.surfaces.paraboloid(GRID, R)
LAW = sc.Adhesion.exponential(W, 1.6e-9)
CELLS = (4, -3)
PLACE = CELLS[0] * GRID.dx, CELLS[1] * GRID.dy


def moment_of(load):
    return load * PLACE[1], -load * PLACE[0]


def assert_moved(found, centred, tol):
    """Assert the same pressure at another place, on a paraboloid tilted about its apex."""
    expected = np.roll(centred.pressure, CELLS, axis=(0, 1))
    scale = np.abs(expected).max()
    np.testing.assert_allclose(found.pressure, expected, atol=tol * scale)
    np.testing.assert_allclose(found.tilt, (PLACE[1] / R, -PLACE[0] / R), rtol=10 * tol)
    approach = centred.approach - 0.5 * np.hypot(*PLACE) ** 2 / R
    assert found.approach == pytest.approx(approach, rel=10 * tol)


def test_an_eccentric_load_moves_the_contact():
    solver = sc.ContactSolver(GRID, SOFT, SOFT, adhesion=LAW, tol=1e-9)
    load = 2 * FORCE
    found = solver.solve(GAP, load=load, moment=moment_of(load))
    assert_moved(found, solver.solve(GAP, load=load), 1e-6)
    np.testing.assert_allclose(found.moment, moment_of(load), rtol=1e-7)
    held = solver.solve(GAP, load=load, tilt=tuple(found.tilt))
    np.testing.assert_allclose(held.pressure, found.pressure, atol=1e-6 * held.pressure.max())


def test_an_eccentric_tension_with_friction():
    """Moment and tangential force of bodies that are pulled, along a path."""
    states = []
    for moments in (None, moment_of):
        sim = sc.Simulation(GRID, SOFT, SOFT, GAP, friction=sc.Coulomb(0.3), adhesion=LAW, tol=1e-9)
        for load, pull in ((FORCE, 0.0), (-0.8 * FORCE, 0.0), (-0.8 * FORCE, 0.1 * FORCE)):
            more = {} if moments is None else {"moment": moments(load)}
            state = sim.step(load=load, tangential_load=(pull, 0.0), **more)
        states.append(state)
    centred, moved = states
    assert_moved(moved, centred, 1e-6)
    shear = np.roll(centred.shear, CELLS, axis=(1, 2))
    np.testing.assert_allclose(moved.shear, shear, atol=1e-5 * np.abs(shear).max())


def test_a_dissimilar_body_slides_under_a_moment():
    """Full sliding, in which the shear changes the gap and thus the tilt."""
    grid, load = sc.Grid(48, 48, 8e-9, 8e-9), FORCE
    gap = sc.surfaces.paraboloid(grid, R)
    solver = sc.ContactSolver(grid, sc.Material.rigid(), SOFT, friction=0.2, adhesion=LAW)
    found = solver.solve(gap, load=load, moment=moment_of(load))
    held = solver.solve(gap, load=load, tilt=tuple(found.tilt), initial_pressure=found.pressure)
    np.testing.assert_allclose(held.moment, moment_of(load), rtol=1e-5)
    np.testing.assert_allclose(held.pressure, found.pressure, atol=1e-5 * held.pressure.max())


def test_a_moment_that_no_tilt_causes_is_refused():
    """A paraboloid rolls without resistance if no load acts."""
    solver = sc.ContactSolver(GRID, SOFT, SOFT, adhesion=LAW)
    start = solver.solve(GAP, load=FORCE).pressure
    with pytest.raises(sc.ConvergenceError, match="contact did not converge at load 0 N, moment"):
        solver.solve(GAP, load=0.0, moment=(1e-16, None), initial_pressure=start)

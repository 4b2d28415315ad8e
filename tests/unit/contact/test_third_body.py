# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic layer between the bodies: CONTACT's single cell, limits, rolling, energy."""

import numpy as np
import pytest

import samcontact as sc

# Example "plastic_3bl" of CONTACT: one cell of 1 mm x 1 mm
G, NU = 82e9, 0.28
STEEL = sc.Material.elastic(2 * G * (1 + NU), NU)
BRASS = sc.Material.elastic(100e9, 0.2)
CELL = sc.Grid(1, 1, 1e-3, 1e-3)
MAGNETITE = sc.ThirdBody(0.7, 560e6, 176.63e6, 20e-6)
SPOT = sc.Grid(28, 28, 36e-6, 36e-6)
BALL = sc.surfaces.paraboloid(SPOT, 7.5e-3)
quiet = pytest.mark.filterwarnings("ignore::UserWarning")


@quiet
def test_a_single_cell_of_contact():
    def forces(law, *shifts):
        solver, last, found = sc.ContactSolver(CELL, STEEL, STEEL, law, on_border="warn"), None, []
        for shift in shifts:
            last = solver.solve(np.zeros((1, 1)), load=900.0, shift=(shift, 0.0), previous=last)
            found.append(last.tangential_load[0])
        return found

    assert forces(sc.Coulomb(0.7), 1e-6) == [pytest.approx(84.97, abs=0.005)]
    found = forces(MAGNETITE, 35e-6, 35e-6, 30e-6, 50e-6)
    np.testing.assert_allclose(found, [280.0, 560.0, 560.0, 560.0], atol=0.05)
    assert found[-1] / (0.7 * 900) == pytest.approx(0.8889, abs=5e-5)


@pytest.mark.parametrize("body1", [STEEL, BRASS], ids=["identical", "dissimilar"])
def test_the_layer_is_sheared_by_the_part_of_the_shift_that_the_bodies_do_not_take(body1):
    law = sc.ThirdBody(0.4, 3e8, 1e8, 1e-6)
    solver = sc.ContactSolver(SPOT, body1, STEEL, law, tol=1e-10)
    found = solver.solve(BALL, load=300.0, shift=(3e-6, 0.0))
    relative = (
        solver.displacement(found.pressure, found.shear, 2)
        - solver.displacement(found.pressure, found.shear, 1)
    )[:2]
    layer = np.array([3e-6, 0.0])[:, None, None] - relative
    sticks = found.sticking
    np.testing.assert_allclose(found.shear[:, sticks] * 1e-14, layer[:, sticks], atol=1e-12)
    size, pressed = np.hypot(*found.shear), found.pressure > 0
    assert 0.05 < sticks.sum() / pressed.sum() < 0.95
    np.testing.assert_allclose(
        size[pressed & ~sticks], law.bound(found.pressure)[pressed & ~sticks], rtol=1e-9
    )


def test_a_stiff_layer_is_capped_coulomb_friction():
    one, other = (
        sc.ContactSolver(SPOT, STEEL, STEEL, law).solve(BALL, load=300.0, shift=(1e-6, 0.0))
        for law in (sc.CappedCoulomb(0.3, 3e8), sc.ThirdBody(0.3, 3e8, 1e30, 1e-6))
    )
    np.testing.assert_allclose(one.shear, other.shear, atol=1e-9 * np.abs(one.shear).max())


def test_rolling_and_plastic_simulations_with_a_layer():
    law = sc.ThirdBody(0.4, 3e8, 5e8, 1e-6)
    drive = {"load": 300.0, "creepage": (1e-3, 0.0)}
    soft, hard = (
        sc.rolling.steady(SPOT, BRASS, STEEL, BALL, friction=friction, **drive)
        for friction in (law, sc.CappedCoulomb(0.4, 3e8))
    )
    assert 0 < soft.tangential_load[0] < 0.98 * hard.tangential_load[0]
    step = {"advance": (-SPOT.dx, -SPOT.dx), "shift": (1e-3 * SPOT.dx, 0.0)}
    rolled = sc.ContactSolver(SPOT, BRASS, STEEL, law).solve(
        BALL, load=300.0, previous=soft, **step
    )
    np.testing.assert_allclose(rolled.shear, soft.shear, atol=1e-4 * np.abs(soft.shear).max())
    grid = sc.Grid(28, 28, 36e-6, 36e-6, dz=36e-6)
    yields = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 10e9)
    run = sc.Simulation(grid, STEEL, yields, BALL, law)
    work = [run.step(load=300.0, shift=(shift, 0.0)).friction_work for shift in (2e-6, 4e-6, -2e-6)]
    assert (np.diff([0.0, *work]) >= 0).all()
    with pytest.raises(ValueError, match="an energy balance is not available with a layer"):
        sc.energy.balance(run, [run.state])

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


CLAY = sc.ThirdBody(0.7, 200e6, 106.25e6, 20e-6, hardening=435e9)
SAND = sc.ThirdBody(0.7, 400e6, 176.63e6, 20e-6, hardening=-195e9)
MOLYBDENUM_SULPHIDE = sc.ThirdBody(0.7, 20e6, 20.238e6, 20e-6, hardening=20.4e9)
PRINTED = {
    "clay": (
        CLAY,
        [40, 40, 40, 40, 36, 0, -36, 0, 46, 44, *[50] * 7],
        [200.0, 216.0, 232.0, 248.0, 262.4, 262.4, 82.43, 82.43, 266.4, 284.0, 304.0, 324.1, 344.1,
         364.1, 384.1, 404.1, 424.1],
    ),
    "sand": (
        SAND, [25, 25, *[50] * 11],
        [200.0, 400.0, 390.0, 380.0, 370.0, 360.0, 350.0, 340.0, 330.0, 320.1, 310.1, 300.1, 290.1],
    ),
    "MoS2": (
        MOLYBDENUM_SULPHIDE, [20, 40, 40, *[50] * 10],
        [20.00, 20.80, 21.60, 22.60, 23.60, 24.60, 25.60, 26.60, 27.60, 28.60, 29.60, 30.60, 31.60],
    ),
}  # fmt: skip
"""Shifts [um] and tangential forces [N] that CONTACT prints for the example "plastic_3bl"."""


@quiet
@pytest.mark.parametrize("name", PRINTED)
def test_hardening_of_a_single_cell_of_contact(name):
    law, shifts, printed = PRINTED[name]
    solver, last, found = sc.ContactSolver(CELL, STEEL, STEEL, law, on_border="warn"), None, []
    simulation = sc.Simulation(CELL, STEEL, STEEL, np.zeros((1, 1)), law, on_border="warn")
    for shift in shifts:
        drive = {"load": 900.0, "shift": (1e-6 * shift, 0.0)}
        last = solver.solve(np.zeros((1, 1)), previous=last, **drive)
        found.append(last.tangential_load[0])
        state = simulation.step(**drive)
        assert state.tangential_load[0] == pytest.approx(found[-1], rel=1e-6)
        assert state.plastic_slip == pytest.approx(last.plastic_slip, abs=1e-13)
    # printed with four digits
    np.testing.assert_allclose(found, printed, atol=0.055 if name != "MoS2" else 0.0055)


def flowing(law, body1=BRASS, **settings):
    """Return the solution of a ball that is shifted in three steps, and the solver."""
    solver = sc.ContactSolver(SPOT, body1, STEEL, law, tol=1e-10, **settings)
    last = solver.solve(BALL, load=300.0)
    for _ in range(3):
        last = solver.solve(BALL, load=300.0, shift=(2e-6, 1e-6), previous=last)
    return last, solver


@pytest.mark.parametrize("hardening", [1e13, 1e14, -2e12])
@pytest.mark.parametrize("body1", [STEEL, BRASS], ids=["identical", "dissimilar"])
def test_flowing_cells_have_the_strength_at_their_plastic_slip(body1, hardening):
    law = sc.ThirdBody(0.4, 2e8, 1e8, 1e-6, hardening)
    found, _ = flowing(law, body1)
    size, pressed = np.hypot(*found.shear), found.pressure > 0
    strength = np.maximum(law.strength + hardening * found.plastic_slip, 0.0)
    bound = np.minimum(0.4 * found.pressure, strength)
    assert (size[pressed] <= bound[pressed] * (1 + 1e-7)).all()
    slips = pressed & (np.hypot(*found.slip) > 0)
    np.testing.assert_allclose(size[slips], bound[slips], rtol=1e-7)
    assert (found.plastic_slip > 0).sum() > 30
    assert ((bound == 0.4 * found.pressure) & slips).any()  # cells that slip on the layer


def test_no_hardening_is_the_limit_of_little():
    one, _ = flowing(sc.ThirdBody(0.4, 2e8, 1e8, 1e-6))
    other, _ = flowing(sc.ThirdBody(0.4, 2e8, 1e8, 1e-6, 1e6))
    np.testing.assert_allclose(other.shear, one.shear, atol=1e-6 * np.abs(one.shear).max())
    assert one.plastic_slip is None


def test_small_steps_and_one_step_have_the_same_plastic_slip():
    """The shift is monotonic along x, and nu = 0 of identical bodies: no cell unloads."""
    body = sc.Material.elastic(2e11, 0.0)
    law = sc.ThirdBody(0.4, 2e8, 1e8, 1e-6, 5e13)
    solver = sc.ContactSolver(SPOT, body, body, law, tol=1e-10)
    start = solver.solve(BALL, load=300.0)
    whole = solver.solve(BALL, load=300.0, shift=(6e-6, 0.0), previous=start)
    last = start
    for _ in range(6):
        last = solver.solve(BALL, load=300.0, shift=(1e-6, 0.0), previous=last)
    scale = whole.plastic_slip.max()
    np.testing.assert_allclose(last.plastic_slip, whole.plastic_slip, atol=2e-2 * scale)


def test_plastic_slip_moves_with_the_layer_and_is_kept(tmp_path):
    law = sc.ThirdBody(0.4, 1e8, 1e9, 1e-6, 2e13)
    run = sc.Simulation(SPOT, BRASS, STEEL, BALL, law)
    run.step(load=300.0)
    slid = run.step(load=300.0, shift=(2e-6, 0.0))
    assert slid.plastic_slip.max() > 1e-7
    run.save(tmp_path / "kept.h5")
    again = sc.Simulation.load(tmp_path / "kept.h5")
    moves = {"load": 300.0, "advance": (-2 * SPOT.dx, -2 * SPOT.dx)}
    rolled, other = run.step(**moves), again.step(**moves)
    np.testing.assert_array_equal(rolled.plastic_slip, other.plastic_slip)
    carried = np.zeros_like(slid.plastic_slip)
    carried[:-2] = slid.plastic_slip[2:]
    assert (rolled.plastic_slip >= carried - 1e-15).all()
    assert (rolled.plastic_slip == carried).sum() > 0.5 * carried.size


def test_steady_rolling_hardens_along_the_path():
    """A march by cells reaches the steady state."""
    law = sc.ThirdBody(0.4, 1e8, 1e9, 1e-6, 5e12)
    drive = {"load": 300.0, "creepage": (3e-3, 0.0)}
    steady = sc.rolling.steady(SPOT, BRASS, STEEL, BALL, friction=law, **drive)
    inside = steady.in_contact.any(axis=1).nonzero()[0]
    assert (np.diff(steady.plastic_slip[: inside.max()], axis=0) <= 1e-18).all()
    solver, last = sc.ContactSolver(SPOT, BRASS, STEEL, law), steady
    step = {"advance": (-SPOT.dx, -SPOT.dx), "shift": (3e-3 * SPOT.dx, 0.0)}
    for _ in range(2):
        last = solver.solve(BALL, load=300.0, previous=last, **step)
    np.testing.assert_allclose(last.shear, steady.shear, atol=1e-4 * np.abs(steady.shear).max())
    soft = sc.rolling.steady(SPOT, BRASS, STEEL, BALL, friction=sc.ThirdBody(0.4, 1e8, 1e9, 1e-6),
                             **drive)  # fmt: skip
    assert steady.tangential_load[0] > 1.02 * soft.tangential_load[0]


@quiet
def test_a_force_above_the_first_strength_is_carried_by_hardening():
    """CONTACT's clay yields at 200 N: the forces that it prints for shifts cause these shifts."""
    _, shifts, printed = PRINTED["clay"]
    solver = sc.ContactSolver(CELL, STEEL, STEEL, CLAY, on_border="warn")
    last = None
    for shift in shifts[:5]:
        last = solver.solve(np.zeros((1, 1)), load=900.0, shift=(1e-6 * shift, 0.0), previous=last)
    held = solver.solve(np.zeros((1, 1)), load=900.0, tangential_load=(printed[4], 0.0))
    assert held.tangential_load[0] == pytest.approx(printed[4], rel=1e-6)
    whole = 1e-6 * sum(shifts[:5])
    assert held.shift[0] == pytest.approx(whole, rel=5e-4)  # four digits of the force
    assert held.plastic_slip[0, 0] == pytest.approx(last.plastic_slip[0, 0], rel=5e-4)
    with pytest.raises(ValueError, match="must be"):
        solver.solve(np.zeros((1, 1)), load=900.0, tangential_load=(0.7 * 900.0, 0.0))


@pytest.mark.parametrize("body1", [STEEL, BRASS], ids=["identical", "dissimilar"])
def test_forces_and_motions_above_the_first_strength_are_inverse(body1):
    law = sc.ThirdBody(0.4, 1e8, 1e9, 1e-6, 2e13)
    given = {"load": 300.0}
    solver = sc.ContactSolver(SPOT, body1, STEEL, law, tol=1e-9)
    start = solver.solve(BALL, **given)
    moved = solver.solve(BALL, shift=(6e-6, 2e-6), previous=start, **given)
    force = moved.tangential_load
    strength = law.strength * moved.contact_area
    assert np.hypot(*force) > 1.1 * strength
    pulled = solver.solve(BALL, tangential_load=tuple(force), previous=start, **given)
    np.testing.assert_allclose(pulled.tangential_load, force, rtol=1e-6)
    np.testing.assert_allclose(pulled.shift, (6e-6, 2e-6), rtol=1e-5)
    scale = moved.plastic_slip.max()
    np.testing.assert_allclose(pulled.plastic_slip, moved.plastic_slip, atol=1e-4 * scale)
    run = sc.Simulation(SPOT, body1, STEEL, BALL, law, tol=1e-9)
    run.step(**given)
    state = run.step(tangential_load=(float(force[0]), float(force[1])), **given)
    np.testing.assert_allclose(state.shift, (6e-6, 2e-6), rtol=1e-5)


def test_a_force_above_the_first_strength_rolls_with_the_creepage_that_causes_it():
    law = sc.ThirdBody(0.4, 1e8, 1e9, 1e-6, 5e12)
    given = {"load": 300.0, "friction": law}
    crept = sc.rolling.steady(SPOT, BRASS, STEEL, BALL, creepage=(6e-3, 0.0), **given)
    force = float(crept.tangential_load[0])
    assert force > 1.05 * law.strength * crept.contact_area
    pulled = sc.rolling.steady(SPOT, BRASS, STEEL, BALL, tangential_load=(force, None), **given)
    assert pulled.tangential_load[0] == pytest.approx(force, rel=1e-5)
    assert pulled.creepage[0] == pytest.approx(6e-3, rel=1e-4)


def test_a_layer_that_softens_too_fast_is_refused():
    with pytest.raises(ValueError, match=r"hardening of the layer must be more than -.* Pa/m"):
        flowing(sc.ThirdBody(0.4, 2e8, 1e8, 1e-6, -1.2e14))
    with pytest.raises(ValueError, match="hardening must be 0 with infinite strength"):
        sc.ThirdBody(0.4, np.inf, 1e8, 1e-6, 1e12)


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

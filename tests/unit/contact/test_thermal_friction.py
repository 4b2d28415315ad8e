# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction that depends on the temperature of the surfaces of a wheel that slides on a rail."""

import numpy as np
import pytest
from scipy.integrate import quad

import samcontact as sc

# Ertz and Knothe (2002): wheel on rail at 30 m/s with a slip of 1 m/s
G, NU, V, SLIP, LOAD = 82e9, 0.28, 30.0, 1.0, 100e3
STEEL = sc.Material.elastic(2 * G * (1 + NU), NU).with_thermal(50.0, 0.0, 50.0 / (7850 * 450))
FALLING = sc.ThermalCoulomb([0.0, 200.0], [0.3, 0.15])


def wheel_on_rail(law, cells=(72, 50)):
    grid = sc.Grid(*cells, 14.4e-3 / cells[0], 25e-3 / cells[1])
    gap = 1.015 * grid.x[:, None] ** 2 + 0.4215 * grid.y**2
    heat = sc.Heat(partition=0.5, velocity=((-V, 0.0), (-V - SLIP, 0.0)))
    run = sc.Simulation(grid, STEEL, STEEL, gap, law, heat=heat)
    duration = grid.dx / V
    run.step(load=LOAD, shift=(1e-3, 0.0), duration=1e3)
    for _ in range(3):
        state = run.step(load=LOAD, advance=(-V * duration, -(V + SLIP) * duration),
                         duration=duration)  # fmt: skip
    return state


def test_flash_temperature_of_a_sliding_wheel():
    """Heat conducted straight into both bodies, under the middle of the semi-elliptic pressure."""
    state = wheel_on_rail(sc.Coulomb(0.3))
    assert not state.sticking.any()
    a, flux = 5.88e-3, 0.5 * 0.3 * state.pressure.max() * SLIP
    points = [
        quad(lambda u, x=x: 2 * np.sqrt(max(1 - (x - u * u) ** 2, 0.0)), 0, np.sqrt(1 + x))[0]
        for x in np.linspace(0.5, 0.8, 31)
    ]
    expected = flux / np.sqrt(50.0 * 7850 * 450) * np.sqrt(a / np.pi / V) * max(points)
    rises = [state.surface_temperature(body).max() for body in (1, 2)]
    assert np.mean(rises) == pytest.approx(expected, rel=0.02)
    # the strain of the surfaces changes their speed by mu p/G
    assert abs(rises[1] - rises[0]) < 0.03 * expected


def upwind_flash(own_cell):
    """Return the rise [K] and the friction power [W] by Ertz and Knothe's sum over cells.

    Cells and backward difference of the slip are those of the example "ertz_temperature" of
    CONTACT (revision 2356).
    """
    grid = sc.Grid(65, 45, 0.2e-3, 0.5e-3)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    gap = 1.015 * grid.x[:, None] ** 2 + 0.4215 * grid.y**2
    pressure = solver.solve(gap, load=LOAD).pressure
    assert (pressure > 0).sum() == 1969
    assert pressure.max() == pytest.approx(770.6e6, abs=0.05e6)
    shear = np.stack([0.3 * pressure, np.zeros(gap.shape)])
    moved = [solver.displacement(pressure, shear, body)[0] for body in (1, 2)]
    relative = moved[1] - moved[0]
    ahead = 2 * relative[:1] - relative[1:2]
    slip = V * (0.03333 - np.diff(relative, axis=0, prepend=ahead) / grid.dx)
    flux = shear[0] * slip
    behind = grid.x[:, None] - grid.x
    root = np.sqrt(np.maximum(behind + grid.dx / 2, 0)) - np.sqrt(
        np.maximum(behind - grid.dx / 2, 0)
    )
    root[np.diag_indices(65)] *= own_cell
    rise = root @ flux / np.sqrt(np.pi * V * 50.0 * 7850 * 450)  # half of the heat
    return rise.max(), flux.sum() * grid.cell_area


def test_contact_prints_a_flash_temperature_with_the_own_cell_counted_twice():
    """CONTACT prints 166.8 K, of which 14.5 K vanish with the cell size: the exact integral over
    the half of a cell up to its centre is sqrt(dx/2), the program adds 2 sqrt(dx/2).
    """
    printed, power = upwind_flash(own_cell=2.0)
    assert printed == pytest.approx(166.8, abs=0.05)
    assert power == pytest.approx(2.994e4, abs=5.0)
    exact, _ = upwind_flash(own_cell=1.0)
    state = wheel_on_rail(sc.Coulomb(0.3))
    rise = max(state.surface_temperature(body).max() for body in (1, 2))
    assert rise == pytest.approx(exact, rel=0.01)


def test_slipping_cells_have_the_coefficient_at_their_temperature():
    state = wheel_on_rail(FALLING, (36, 26))
    rise = np.maximum(state.surface_temperature(1), state.surface_temperature(2))
    mu = np.interp(rise, FALLING.temperature, FALLING.coefficient)
    slips = state.in_contact & ~state.sticking
    assert slips.sum() > 0.9 * state.in_contact.sum()
    size = np.hypot(*state.shear)
    np.testing.assert_allclose(size[slips], (mu * state.pressure)[slips], rtol=1e-4)
    assert mu[slips].min() < 0.24
    constant = wheel_on_rail(sc.Coulomb(0.3), (36, 26))
    assert abs(state.tangential_load[0]) < 0.9 * abs(constant.tangential_load[0])


def test_a_constant_table_is_coulomb_friction():
    one, other = (
        wheel_on_rail(law, (24, 18)) for law in (sc.Coulomb(0.3), sc.ThermalCoulomb([0.0], [0.3]))
    )
    np.testing.assert_allclose(one.shear, other.shear, atol=1e-6 * np.abs(one.shear).max())


def test_a_bulk_temperature_is_added_to_the_rise():
    """Cases 2 and 3 of CONTACT: a wheel of 150 K on a cold rail, at rest and sliding."""
    warm = sc.ThermalCoulomb(FALLING.temperature, FALLING.coefficient, bulk=75.0)
    shifted = sc.ThermalCoulomb([-75.0, 125.0], FALLING.coefficient)
    one, other = (wheel_on_rail(law, (24, 18)) for law in (warm, shifted))
    np.testing.assert_allclose(one.shear, other.shear, atol=1e-9 * np.abs(one.shear).max())
    slips = one.in_contact & ~one.sticking
    rise = np.maximum(one.surface_temperature(1), one.surface_temperature(2))
    mu = np.interp(75.0 + rise, FALLING.temperature, FALLING.coefficient)
    size = np.hypot(*one.shear)
    np.testing.assert_allclose(size[slips], (mu * one.pressure)[slips], rtol=1e-4)
    assert upwind_flash(own_cell=2.0)[0] + 75.0 == pytest.approx(241.8, abs=0.05)


def test_friction_of_the_temperature_needs_heat_due_to_slip():
    grid = sc.Grid(8, 8, 1e-3, 1e-3)
    for make in (sc.ContactSolver, lambda *a: sc.Simulation(*a[:3], np.zeros((8, 8)), a[3])):
        with pytest.raises(
            ValueError, match=r"^heat.partition is required with friction = Thermal"
        ):
            make(grid, STEEL, STEEL, FALLING)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([], []), "coefficient must have one value for each temperature"),
        (([0.0, 1.0], [0.3]), "coefficient must have one value for each temperature, 2, got 1"),
        (([0.0, 0.0], [0.3, 0.2]), r"temperature\[1\] must be larger than temperature\[0\]"),
        (([0.0], [-0.3]), r"coefficient\[0\] must be a finite number >= 0"),
    ],
)
def test_refused_tables(arguments, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        sc.ThermalCoulomb(*arguments)

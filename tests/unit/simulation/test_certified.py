# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities interpolated between cells are close to those of smooth fields."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact._util.tensors import von_mises
from samcontact.simulation import error_controlled_quantities
from samcontact.simulation.error_controlled_quantities import in_own_box
from samcontact.solutions.contact_area import contact_area

STEEL = sc.Material.elastic(210e9, 0.3)


def test_peak_of_a_parabola_lies_between_its_cells():
    x, y, z = np.meshgrid(np.arange(7) - 3.3, np.arange(9) - 4.4, np.arange(5) + 0.5, indexing="ij")
    field = 5.0 - 0.3 * x**2 - 0.2 * y**2 - 0.1 * (z - 2.2) ** 2
    assert error_controlled_quantities.peak_value(field) == pytest.approx(5.0, rel=1e-14)
    below, surface = error_controlled_quantities.below_and_at_surface(field)
    assert below == pytest.approx(5.0, rel=1e-14)
    assert surface == 0.0
    # of what grows up to the surface it is the value there, half a layer above the first centres
    falling = 5.0 - 0.3 * x**2 - 0.2 * y**2 - 0.1 * (z + 1.0) ** 2
    assert error_controlled_quantities.below_and_at_surface(falling) == pytest.approx(
        (0.0, 4.9), rel=1e-14
    )


@pytest.mark.parametrize("even", [0, 1])
def test_hertz_area_and_pressure_are_close_on_few_cells(even):
    hertz = sc.hertz.point(7.5e-3, sc.hertz.effective_modulus(STEEL, STEEL), load=1500.0)
    cells = 44 - even
    grid = sc.Grid(cells, cells, hertz.a / 16, hertz.a / 16)
    pressure = sc.ContactSolver(grid, STEEL, STEEL).solve(
        sc.surfaces.paraboloid(grid, 7.5e-3), load=1500.0
    ).pressure  # fmt: skip
    area = contact_area(pressure, grid.cell_area)
    assert area == pytest.approx(math.pi * hertz.a**2, rel=6e-3)
    assert error_controlled_quantities.peak_value(pressure) == pytest.approx(hertz.p0, rel=4e-4)


def test_area_of_periodic_contacts_has_no_grid_edge():
    assert contact_area(np.ones((6, 4)), 2.0, "xy") == 48.0
    x = np.cos(2 * np.pi * (np.arange(64) + 0.3) / 64)
    strip = np.sqrt(np.maximum(np.tile(x, (8, 1)), 0.0))  # of squares, cos; half of the cells
    rolled = [contact_area(np.roll(strip, n, 1), 1.0, "xy") for n in (0, 16, 32)]
    assert rolled == pytest.approx([8 * 32.0] * 3, rel=2e-3)


def test_names_exist_only_for_bodies_with_the_quantity():
    steel = sc.Material.perfect_plastic(210e9, 0.3, 1e9)
    assert error_controlled_quantities.names((STEEL, STEEL))[4:] == ["max_von_mises_body2"]
    assert error_controlled_quantities.names((STEEL, STEEL), volume=False) == list(
        error_controlled_quantities.CONTACT_QUANTITIES
    )
    assert len(error_controlled_quantities.names((steel, STEEL))) == 8
    assert error_controlled_quantities.names((steel, STEEL))[4] == "max_von_mises_body1"


@pytest.mark.parametrize("shift", [0.0, 0.3])
def test_fields_of_the_plastic_zone_contain_the_maximum_of_the_grid(shift):
    grid = sc.Grid(23, 21, 5e-5, 5e-5, dz=5e-5)
    steel = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9)
    gap = ((grid.x[:, None] - shift * grid.dx) ** 2 + grid.y**2) / (2 * 7.5e-3)
    run = sc.Simulation(grid, STEEL, steel, gap)
    for state in run.run([{"load": 1000.0}, {"load": 0.0}], progress=False):
        i, j, nx, ny, _ = state._core.own_box(1)
        beside = np.s_[max(i, 0) : i + nx, max(j, 0) : j + ny]
        inside = np.s_[max(-i, 0) : grid.nx - i, max(-j, 0) : grid.ny - j]
        for name in ("stress", "residual_stress", "residual_displacement"):
            whole, own = getattr(state, name)(2), in_own_box(state, name, 2)
            if whole.ndim == 2:
                assert own[inside] == pytest.approx(whole[beside], rel=1e-9)
            else:
                deep = min(whole.shape[3], own.shape[3])
                mine, other = (von_mises(f[..., :deep]) for f in (own, whole))
                assert mine[inside] == pytest.approx(other[beside], rel=1e-8, abs=1.0)
            kind = {"stress": "max_von_mises", "residual_stress": "max_residual_von_mises"}
            value = error_controlled_quantities.value(
                state, f"{kind.get(name, 'imprint_depth')}_body2"
            )
            field = whole if whole.ndim == 2 else von_mises(whole)
            assert value > 0.999 * field.max()


def test_extrapolation_to_the_surface_does_not_exceed_the_yield_stress():
    """The first layer yields and the second hardly does: a parabola would overshoot."""
    cell = 24e-6
    grid = sc.Grid(27, 27, cell, cell, dz=cell)
    steel = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 20e9)
    simulation = sc.Simulation(
        grid, sc.Material.elastic(210e9, 0.3), steel, sc.surfaces.paraboloid(grid, 7.5e-3),
        sc.Coulomb(0.5),
    )  # fmt: skip
    path = [{"load": 300.0}, {"load": 300.0, "tangential_load": (90.0, 0.0)}]
    state = simulation.run(path, progress=False)[-1]
    strain = error_controlled_quantities.value(state, "max_equivalent_plastic_strain_body2")
    found = error_controlled_quantities.value(state, "max_von_mises_body2")
    assert state.von_mises(2).max() <= found <= steel.yield_stress(strain) * (1 + 1e-6)

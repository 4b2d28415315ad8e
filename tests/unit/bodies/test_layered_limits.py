# SPDX-License-Identifier: GPL-3.0-or-later
"""Extreme layers: growth stress, thin, soft, and nearly incompressible."""

import numpy as np
import pytest

import samcontact as sc
from samcontact._util.tensors import von_mises

RIGID = sc.Material.rigid()
STEEL = sc.Material.elastic(210e9, 0.3)
NITRIDE = sc.Material.elastic(400e9, 0.25)
RADIUS = 1e-3


def yielding(E, nu, yield_stress):
    return sc.Material.linear_hardening(E, nu, yield_stress, 0.02 * E)


def elastic_twin(material):
    return sc.Material.elastic(material.E, material.nu)


def elastic_solver(body, grid):
    twin = sc.Layered([(elastic_twin(m), h) for m, h in body.layers], elastic_twin(body.substrate))
    return sc.ContactSolver(grid, RIGID, twin, on_border="warn")


def of_yield(body, solver, gap, load):
    """Return the maximum of elastic stress over local yield stress, and its depth."""
    z = solver.grid.z
    stress = solver.stress(solver.solve(gap, load=load).pressure, z)
    stress[[0, 1, 5]] += body.residual_stress_at(z)[:, None, None, :]
    ratio = von_mises(stress) / body.yield_stress_at(z)
    worst = int(np.argmax(ratio.max(axis=(0, 1))))
    return float(ratio.max()), z[worst]


CASE = (yielding(400e9, 0.25, 2.2e9), 6e-6), yielding(210e9, 0.3, 0.9e9)
SOFT = [(NITRIDE, 4e-6), (yielding(100e9, 0.35, 0.5e9), 4e-6)]
GROWN = yielding(400e9, 0.25, 3e9)


@pytest.mark.parametrize(
    ("layers", "substrate", "starts_in"),
    [
        # The case is too shallow: the core yields first, although stress is largest in the case.
        pytest.param([CASE[0]], CASE[1], 1, marks=pytest.mark.slow),
        ([(CASE[0][0], 24e-6)], CASE[1], 0),
        (SOFT, yielding(210e9, 0.3, 2e9), 1),
        # Without its growth stress the substrate would yield first.
        ([(GROWN.with_residual_stress([0.0], [2.5e9]), 8e-6)], yielding(210e9, 0.3, 1.5e9), 0),
        pytest.param(
            *([(GROWN.with_residual_stress([0.0], [-2.5e9]), 8e-6)], yielding(210e9, 0.3, 1.5e9)),
            1,
            marks=pytest.mark.slow,
        ),
    ],
)
@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_flow_begins_where_a_layer_first_reaches_its_yield_stress(layers, substrate, starts_in):
    body = sc.Layered(layers, substrate)
    grid = sc.Grid(33, 33, 2e-6, 2e-6, nz=24, dz=2e-6)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    solver, low, high = elastic_solver(body, grid), 0.01, 4.0
    for _ in range(10):  # to 0.6 %
        load = np.sqrt(low * high)
        low, high = (low, load) if of_yield(body, solver, gap, load)[0] > 1 else (load, high)
    assert 0.012 < low < 3.9
    depth = of_yield(body, solver, gap, high)[1]
    assert np.searchsorted(body.interfaces, depth) == starts_in
    run = sc.Simulation(grid, RIGID, body, gap)
    assert run.step(load=0.98 * low).max_equivalent_plastic_strain() == 0
    strain = run.step(load=1.03 * high).equivalent_plastic_strain()
    assert grid.z[strain.max(axis=(0, 1)).argmax()] == pytest.approx(depth, abs=1.01 * grid.dz)
    deep = np.searchsorted(body.interfaces, grid.z) != starts_in
    assert strain[..., deep].max() == 0


def test_growth_stress_causes_no_displacement_and_exists_only_in_the_coating():
    grid = sc.Grid(17, 17, 4e-6, 4e-6, nz=6, dz=2e-6)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    plain, grown = (
        sc.Simulation(grid, RIGID, sc.Layered([(coating, 4e-6)], STEEL), gap).step(load=1.0)
        for coating in (NITRIDE, NITRIDE.with_residual_stress([0.0], [-3e9], [-1e9], [2e8]))
    )
    assert np.array_equal(plain.pressure, grown.pressure)
    more = grown.stress() - plain.stress()
    for component, value in ((0, -3e9), (1, -1e9), (5, 2e8)):
        assert more[component][..., :2] == pytest.approx(value, rel=1e-9)
    assert np.abs(more[..., 2:]).max() == 0
    assert np.abs(more[2:5]).max() == 0


def test_nearly_incompressible_layers():
    """Layers with 1 - 2 nu = 0.002 on a rigid base, under a uniform load."""
    rubber = sc.Material.elastic(5e6, 0.499)
    grid = sc.Grid(4, 4, 1e-6, 1e-6, periodic="xy")
    solver = sc.ContactSolver(grid, RIGID, sc.Layered([(rubber, 3e-6), (rubber, 1e-6)], RIGID))
    u = solver.displacement(np.full((4, 4), 1e3))
    oedometer = 4e-6 * 1.499 * 0.002 / (5e6 * 0.501)
    assert u[2] == pytest.approx(1e3 * oedometer, rel=1e-9)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_flow_in_nearly_incompressible_layers_is_that_of_the_homogeneous_body():
    grid = sc.Grid(16, 16, 4e-6, 4e-6, nz=9, dz=4e-6)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    usual, other = (yielding(E, 0.499, 3e7) for E in (5e9, 5e9 * (1 + 1e-12)))
    layered = sc.Layered([(other, 8e-6), (usual, 4e-6), (other, 8e-6)], usual)
    one, two = (
        sc.Simulation(grid, RIGID, body, gap, zones="one", image_tol=1e-6).step(load=0.1)
        for body in (usual, layered)
    )
    assert one.max_equivalent_plastic_strain() > 1e-3
    for name in ("stress", "residual_stress", "residual_displacement"):
        fields = [getattr(state, name)() for state in (two, one)]
        assert fields[0] == pytest.approx(fields[1], abs=2e-5 * np.abs(fields[1]).max())


def test_a_nanometre_on_a_millimetre_is_a_membrane():
    """The layer is stretched with the surface of the substrate; the contact is not affected."""
    grid = sc.Grid(41, 41, 1e-6, 1e-6)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    body = sc.Layered([(NITRIDE, 1e-9)], STEEL)
    bare, coated = (sc.ContactSolver(grid, RIGID, b) for b in (STEEL, body))
    expected, found = (solver.solve(gap, load=0.5) for solver in (bare, coated))
    assert found.pressure == pytest.approx(expected.pressure, abs=1e-3 * expected.pressure.max())
    assert found.approach == pytest.approx(expected.approach, rel=1e-3)
    inside, below = np.moveaxis(coated.stress(found.pressure, [0.5e-9, 2e-9]), -1, 0)
    inside_of_it = np.s_[:, 12:29, 12:29]  # the edge of the contact is sharper than this
    s = below[inside_of_it]
    E, nu = STEEL.E, STEEL.nu
    stretch = [(s[0] - nu * (s[1] + s[2])) / E, (s[1] - nu * (s[0] + s[2])) / E]
    E, nu = NITRIDE.E, NITRIDE.nu
    for along, across, c in ((0, 1, 0), (1, 0, 1)):
        membrane = E / (1 - nu**2) * (stretch[along] + nu * stretch[across])
        membrane += nu / (1 - nu) * s[2]
        assert inside[inside_of_it][c] == pytest.approx(membrane, abs=1e-3 * np.abs(s).max())
    volume = sc.Grid(41, 41, 1e-6, 1e-6, dz=1e-6)
    with pytest.raises(ValueError, match=r"the bottom of layers\[0\] of body2, at 1e-09 m"):
        sc.Simulation(volume, RIGID, sc.Layered([(NITRIDE, 1e-9)], CASE[1]), gap)


def test_a_rigid_substrate_has_no_stress():
    body = sc.Layered([(STEEL, 2e-6), (NITRIDE, 2e-6)], RIGID)
    for periodic in ("", "xy"):
        grid = sc.Grid(8, 8, 1e-6, 1e-6, nz=8, dz=1e-6, periodic=periodic)
        solver = sc.ContactSolver(grid, RIGID, body)
        pressure = np.zeros((8, 8))
        pressure[3:5, 3:5] = 1e6
        stress = solver.stress(pressure, grid.z)
        assert np.abs(stress[..., 3]).max() > 1e4
        assert np.abs(stress[..., 4:]).max() == 0
        run = sc.Simulation(grid, RIGID, body, np.zeros((8, 8)))
        found = run.step(pressure=pressure).stress()
        assert found == pytest.approx(stress, abs=1e-3)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.parametrize("stiff", [1 / 20, 20.0])
@pytest.mark.parametrize("periodic", ["x", "y"])
def test_the_reference_distance_of_displacement_is_the_grid_length(stiff, periodic):
    """The reference distance is the grid length, even if layers bend over longer distances."""
    along, across = (20, 1.0), (1, 3.0)
    (nx, dx), (ny, dy) = (along, across) if periodic == "y" else (across, along)
    grid = sc.Grid(nx, ny, dx, dy, periodic=periodic)
    coated = sc.Layered([(sc.Material.elastic(stiff, 0.1), 3.0)], sc.Material.elastic(1.0, 0.2))
    load = np.zeros(grid.surface_shape)
    load.flat[0] = 1.0
    pressed = sc.ContactSolver(grid, coated, RIGID, on_border="warn")
    u = pressed.displacement(load, body=1).ravel()
    assert abs(3 * u[-1] - 3 * u[-2] + u[-3]) < 0.03 * u[-3]
    flat = np.zeros(grid.surface_shape)
    solver = sc.ContactSolver(grid, coated, coated, sc.Coulomb(0.3), on_border="warn")
    shifted = solver.solve(flat, load=1.0, shift=(1e-3, 2e-3))
    assert (shifted.tangential_load > 0).all()

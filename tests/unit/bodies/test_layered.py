# SPDX-License-Identifier: GPL-3.0-or-later
"""Layered bodies: refused arguments, transfer functions and coefficients, contacts between them."""

import copy
import pickle

import numpy as np
import pytest

import samcontact as sc
from oracles import layers as oracle

STEEL = sc.Material.elastic(210e9, 0.3)
NITRIDE = sc.Material.elastic(420e9, 0.22)
POLYMER = sc.Material.elastic(3e9, 0.4)
RIGID = sc.Material.rigid()


@pytest.mark.parametrize(
    ("layers", "substrate", "error", "text"),
    [
        ([], STEEL, ValueError, "at least one layer"),
        (STEEL, STEEL, TypeError, "list of pairs .material, thickness."),
        ([STEEL], STEEL, TypeError, r"layers\[0\] must be a pair .material, thickness."),
        ([(STEEL, 1e-6), (STEEL, 0.0)], STEEL, ValueError, r"thickness of layers\[1\].*> 0.*got 0"),
        ([(STEEL, np.inf)], STEEL, ValueError, r"thickness of layers\[0\].*finite"),
        ([(STEEL, "1 um")], STEEL, TypeError, r"thickness of layers\[0\] must be a number"),
        ([(RIGID, 1e-6)], STEEL, ValueError, r"layers\[0\] must not be rigid: only the substrate"),
        (
            [(1e-6, STEEL)],
            STEEL,
            TypeError,
            r"material of layers\[0\] must be a",
        ),
        ([(STEEL, 1e-6)], 210e9, TypeError, "substrate must be a samcontact.Material"),
    ],
)
def test_invalid_layered_bodies_are_refused(layers, substrate, error, text):
    with pytest.raises(error, match=text):
        sc.Layered(layers, substrate)


def test_options_unsupported_for_layers_are_refused_by_name():
    coated = sc.Layered([(NITRIDE, 2e-6)], STEEL)
    with pytest.raises(ValueError, match=r"body2 must be 0 without thermal constants of layers.0."):
        sc.ContactSolver(sc.Grid(8, 8, 1e-6, 1e-6), RIGID, coated, 0.1, heat=sc.Heat((0.0, 0.1)))
    with pytest.raises(TypeError, match="body1 must be homogeneous, with E and nu"):
        sc.hertz.effective_modulus(coated, STEEL)


def test_a_layered_body_is_a_value():
    coated = sc.Layered([(NITRIDE, 2e-6), (POLYMER, 1e-6)], STEEL)
    assert coated == sc.Layered(((NITRIDE, 2e-6), [POLYMER, 1e-6]), STEEL) != STEEL
    for again in (copy.deepcopy(coated), pickle.loads(pickle.dumps(coated))):
        assert again == coated
        assert hash(again) == hash(coated)
    assert coated.interfaces == pytest.approx([2e-6, 3e-6])
    depths = [0.0, np.nextafter(2e-6, 0.0), 2e-6, 1.0]
    assert [coated.material_at(z) for z in depths] == [NITRIDE, NITRIDE, POLYMER, STEEL]


STACKS = {
    "stiff coating": ([(50.0, 0.25, 1.0)], (1.0, 0.3)),
    "soft coating": ([(0.02, 0.499, 1.0)], (1.0, 0.3)),
    "soft between stiff": ([(800.0, 0.2, 0.3), (5.0, 0.45, 0.6), (70.0, 0.33, 0.4)], (210.0, 0.3)),
    "on a rigid base": ([(1.0, 0.0, 1.0), (3.0, 0.4, 0.2)], None),
}


def layered(layers, substrate):
    below = RIGID if substrate is None else sc.Material.elastic(*substrate)
    return sc.Layered([(sc.Material.elastic(E, nu), h) for E, nu, h in layers], below)


@pytest.mark.parametrize("name", STACKS)
def test_waves_obey_elasticity_through_the_depth(name):
    layers, substrate = STACKS[name]
    q = np.geomspace(0.1, 7.0, 9)
    exact = [oracle.wave_compliance(value, layers, substrate) for value in q]
    assert layered(layers, substrate).wave_compliance(q) == pytest.approx(exact, rel=1e-8)


def test_long_and_short_waves_have_the_compliance_of_one_material():
    coated = sc.Layered([(NITRIDE, 1e-9), (POLYMER, 1e-3)], STEEL)
    for q, material in ((1e-6, STEEL), (1e6, POLYMER), (1e13, NITRIDE)):
        alone = 2 * (1 - material.nu**2) / (material.E * q)
        assert coated.wave_compliance(q) == pytest.approx(alone, rel=3e-3)


def coefficients(body, offsets, grid):
    """Return u_x, u_y, u_z at cells due to pressure, shear_x and shear_y on the first cell."""
    solver = sc.ContactSolver(grid, RIGID, body)
    unit = np.zeros(grid.surface_shape)
    unit[0, 0] = 1.0
    loads = [(unit, 0 * unit), (0 * unit, unit), (0 * unit, np.stack([0 * unit, unit]))]
    tables = [solver.displacement(pressure, shear) for pressure, shear in loads]
    return np.array([[table[:, i, j] for i, j in offsets] for table in tables])


@pytest.mark.parametrize("thickness", [0.1, 4.0, 300.0])
@pytest.mark.parametrize("ratio", [1 / 50, 4.0, 50.0])
def test_coefficients_are_hankel_integrals_of_waves(thickness, ratio):
    grid = sc.Grid(40, 33, 1.0, 1.0)
    top = sc.Material.elastic(ratio, 0.25)
    body = sc.Layered([(top, thickness)], sc.Material.elastic(1.0, 0.3))
    offsets = [(0, 0), (1, 0), (2, 3), (12, 5), (39, 32)]
    near, all_of_it = (coefficients(b, offsets, grid)[0, :, 2] for b in (top, body))

    def rest(q):
        return body.wave_compliance(q) - 2 * (1 - top.nu**2) / (top.E * q)

    longest = thickness * max(1.0, ratio) ** (1 / 3) + 40.0
    span = 1e-4 / longest, 20 / thickness
    exact = near + [oracle.cell_displacement(i, j, rest, *span) for i, j in offsets]
    assert np.abs(all_of_it - exact).max() < 1e-6 * all_of_it.max()


def test_coefficients_rotate_with_the_axes():
    """Bodies are isotropic along the surface: coefficients at (30, 40) are rotated ones."""
    body = sc.Layered([(NITRIDE, 9.0), (POLYMER, 5.0)], STEEL)
    ahead, aslant = (30, 40), (50, 0)
    grid = sc.Grid(51, 51, 1.0, 1.0)
    found = coefficients(body, [ahead, aslant], grid)
    c, s = 0.6, 0.8
    rotation = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    tensor = found[[1, 2, 0], 0]  # of loads along x, y and z
    rotated, along = rotation @ tensor @ rotation.T, found[[1, 2, 0], 1]
    assert rotated == pytest.approx(along, abs=3e-4 * np.abs(along).max())


def test_the_operator_is_symmetric_and_positive():
    body = sc.Layered([(NITRIDE, 0.7), (POLYMER, 0.4)], STEEL)
    grid = sc.Grid(5, 4, 1.0, 1.3)
    solver = sc.ContactSolver(grid, RIGID, body)
    columns = []
    for place in np.ndindex(3, *grid.surface_shape):
        load = np.zeros((3, *grid.surface_shape))
        load[place] = 1.0
        columns.append(solver.displacement(load[2], load[:2]).ravel())
    operator = np.array(columns).T
    assert np.abs(operator - operator.T).max() < 1e-12 * operator.max()
    values = np.linalg.eigvalsh(operator)
    assert values[0] > 0


def test_equal_layers_are_the_homogeneous_body():
    grid = sc.Grid(24, 20, 1e-6, 1.1e-6)
    gap = sc.surfaces.paraboloid(grid, 1e-3)
    same = sc.Layered([(STEEL, 1e-6), (STEEL, 3e-7)], STEEL)
    one, two = (sc.ContactSolver(grid, NITRIDE, body, 0.2) for body in (STEEL, same))
    a, b = (solver.solve(gap, load=0.05) for solver in (one, two))
    assert np.array_equal(a.pressure, b.pressure)
    z = [0.0, 5e-7, 1e-6, 1e-5]
    assert np.array_equal(one.stress(a.pressure, z), two.stress(a.pressure, z))


def test_two_layered_bodies_with_coupled_friction():
    grid = sc.Grid(32, 32, 1e-6, 1e-6)
    gap = sc.surfaces.paraboloid(grid, 2e-3)
    coated = sc.Layered([(NITRIDE, 4e-6)], STEEL)
    other = sc.Layered([(POLYMER, 2e-6)], RIGID)
    both = sc.ContactSolver(grid, coated, other, 0.3).solve(gap, load=0.02)
    swapped = sc.ContactSolver(grid, other, coated, 0.3).solve(gap, load=0.02)
    # Swapped bodies are the same problem in the mirrored frame: shear towards -x.
    assert swapped.pressure == pytest.approx(both.pressure[::-1], rel=1e-6, abs=1.0)
    stuck = sc.ContactSolver(grid, coated, coated, sc.Coulomb(0.3))
    identical = stuck.solve(gap, load=0.05, tangential_load=(0.01, 0.0))
    assert 0 < identical.sticking.sum() < np.count_nonzero(identical.pressure)
    assert identical.tangential_load == pytest.approx((0.01, 0.0), abs=1e-8)


def test_a_surface_and_its_repetitions_agree():
    """Lattice sums of coefficients and stresses use different methods for other periods."""
    body = sc.Layered([(NITRIDE, 1.5e-6), (POLYMER, 0.7e-6)], STEEL)
    rng = np.random.default_rng(4)
    pressure, shear = 1e8 * rng.random((8, 6)), 1e7 * rng.random((2, 8, 6))
    shear -= shear.mean(axis=(1, 2), keepdims=True)
    depths = [0.0, 1e-6, 1.5e-6, 4e-6]
    for periodic, times in (("xy", (2, 3)), ("xy", (14, 1)), ("x", (2, 1)), ("y", (1, 3))):
        found = []
        for nx, ny in ((1, 1), times):
            grid = sc.Grid(8 * nx, 6 * ny, 1e-6, 1e-6, periodic=periodic)
            solver = sc.ContactSolver(grid, RIGID, body)
            tractions = np.tile(pressure, (nx, ny)), np.tile(shear, (1, nx, ny))
            found.append(
                (
                    solver.displacement(*tractions)[:, :8, :6],
                    solver.stress(tractions[0], depths, shear=tractions[1])[:, :8, :6],
                )
            )
        (u, stress), (again, stress_again) = found
        # With one free direction the reference distance of displacement scales with the grid.
        u, again = (v - v.mean(axis=(1, 2), keepdims=True) for v in (u, again))
        assert again == pytest.approx(u, abs=1e-6 * np.abs(u).max())
        assert stress_again == pytest.approx(stress, abs=1e-6 * np.abs(stress).max())


def test_a_uniform_load_compresses_layers_on_a_rigid_base():
    grid = sc.Grid(4, 4, 1e-6, 1e-6, periodic="xy")
    body = sc.Layered([(STEEL, 2e-6), (POLYMER, 1e-6)], RIGID)
    solver = sc.ContactSolver(grid, RIGID, body)
    u = solver.displacement(np.full((4, 4), 1e6), np.full((4, 4), 2e6))
    oedometer, shear = 0.0, 0.0
    for material, thickness in body.layers:
        E, nu = material.E, material.nu
        oedometer += thickness * (1 + nu) * (1 - 2 * nu) / (E * (1 - nu))
        shear += thickness * 2 * (1 + nu) / E
    assert u[2] == pytest.approx(1e6 * oedometer, rel=1e-9)
    assert u[0] == pytest.approx(2e6 * shear, rel=1e-9)


def coated_run():
    grid = sc.Grid(24, 24, 2e-6, 2e-6, nz=6, dz=2e-6)
    coated = sc.Layered([(NITRIDE, 4e-6)], STEEL)
    gap = sc.surfaces.paraboloid(grid, 2e-3)
    return sc.Simulation(grid, RIGID, coated, gap, friction=0.1), gap


def test_a_simulation_with_layers_is_the_contact_of_its_solver(tmp_path):
    simulation, gap = coated_run()
    state = simulation.step(load=0.3)
    solver = sc.ContactSolver(simulation.grid, RIGID, simulation.body2, 0.1)
    found = solver.solve(gap, load=0.3)
    assert state.pressure == pytest.approx(found.pressure, rel=1e-4, abs=1.0)
    direct = solver.stress(state.pressure, state.depths)
    assert state.stress(2) == pytest.approx(direct, abs=1e-9 * np.abs(direct).max())
    sides = solver.stress(state.pressure, [np.nextafter(4e-6, 0.0), 4e-6])
    assert np.array_equal(state.interface_stress(), np.moveaxis(sides, -1, 0)[..., None])
    with pytest.raises(ValueError, match="body1 must be layered for the stress at interfaces"):
        state.interface_stress(1)
    simulation.save(tmp_path / "coated.h5")
    again = sc.Simulation.load(tmp_path / "coated.h5")
    assert again.body2 == simulation.body2
    assert np.array_equal(again.step(load=0.5).pressure, simulation.step(load=0.5).pressure)


def test_results_contain_the_layers():
    from samcontact import results

    simulation, _ = coated_run()
    dataset = results.to_dataset(simulation, [simulation.step(load=0.3)])
    assert dataset.attrs["body2_law"] == "layered"
    assert dataset.attrs["body2_thickness"] == (4e-6,)
    assert [dataset.attrs[f"body2_{name}_E"] for name in ("layer1", "substrate")] == [
        NITRIDE.E,
        STEEL.E,
    ]
    assert "stress_body2" in dataset
    between = dataset.interface_stress_body2.sel(side="above", component="zz")
    assert between.sizes["interface_body2"] == 1
    assert float(between.interface_body2[0]) == pytest.approx(4e-6)
    assert float(between.min()) < -1e8


def test_interfaces_of_the_upper_body_include_growth_stress_and_shear():
    grown = NITRIDE.with_residual_stress([0.0], [-1e9], [-2e9], [1e8])
    grid = sc.Grid(24, 24, 2e-6, 2e-6)
    gap = sc.surfaces.paraboloid(grid, 2e-3)
    run = sc.Simulation(grid, sc.Layered([(grown, 4e-6)], STEEL), RIGID, gap, friction=0.1)
    state = run.step(load=0.3)
    solver = sc.ContactSolver(grid, run.body1, RIGID, 0.1)
    elastic = solver.stress(state.pressure, [np.nextafter(4e-6, 0.0), 4e-6], body=1)
    above, below = state.interface_stress(1)[..., 0] - np.moveaxis(elastic, -1, 0)
    start = np.array([-1e9, -2e9, 0.0, 0.0, 0.0, 1e8])
    assert above == pytest.approx(np.broadcast_to(start[:, None, None], above.shape), rel=1e-9)
    assert np.abs(below).max() == 0


SOFT = sc.Material.perfect_plastic(210e9, 0.3, 1e9)


@pytest.mark.parametrize(
    ("body", "more", "text"),
    [
        (sc.Layered([(SOFT, 1e-6)], RIGID), {}, "the layers of body2 must be elastic and free"),
        (
            sc.Layered([(STEEL, 1e-6)], SOFT),
            {"residual_stress": "exact"},
            'residual_stress must be "fast" because body2 has layers',
        ),
        (sc.Layered([(NITRIDE, 1.5e-6)], SOFT), {}, r"the bottom of layers\[0\] of body2"),
    ],
)
def test_plastic_options_unsupported_for_layers_are_refused(body, more, text):
    grid = sc.Grid(8, 8, 1e-6, 1e-6, nz=2, dz=1e-6)
    with pytest.raises(ValueError, match=text):
        sc.Simulation(grid, RIGID, body, np.zeros((8, 8)), **more)


def plastic_run(layers):
    grid = sc.Grid(26, 26, 4e-6, 4e-6, nz=14, dz=3e-6)
    steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
    body = sc.Layered(layers, steel) if layers else steel
    gap = sc.surfaces.paraboloid(grid, 1e-3)
    run = sc.Simulation(grid, RIGID, body, gap, zones="one")
    return grid, [run.step(load=load) for load in (2.0, 4.0, 6.0, 0.0)]


def test_flow_below_a_layer_of_the_same_stiffness_stays_below_it():
    grid, below = plastic_run([(STEEL, 6e-6)])
    _, free = plastic_run([])
    for state, without in zip(below, free, strict=True):
        gamma = state.equivalent_plastic_strain()
        assert gamma[:, :, :2].max() == 0
        assert gamma[:, :, 2:].max() > 0 or state is below[0]
        assert state.approach >= 0 or state.load == 0
        assert without.equivalent_plastic_strain().shape == gamma.shape
    # An elastic steel layer does not increase the flow, and residual stress is in equilibrium.
    assert (
        0
        < below[-1].max_equivalent_plastic_strain()
        < 1.2 * free[-1].max_equivalent_plastic_strain()
    )
    sums = below[-1].residual_stress()[2].sum(axis=(0, 1)) * grid.cell_area
    assert np.abs(sums).max() < 2e-2 * 6.0


def test_flow_below_a_very_soft_layer_is_that_of_the_bare_substrate():
    """Residual imprint of a substrate below a very soft layer, under prescribed tractions."""
    nothing = sc.Material.elastic(1e-3, 0.0)
    steel = sc.Material.perfect_plastic(210e9, 0.3, 1e9)
    grid = sc.Grid(20, 20, 4e-6, 4e-6, nz=12, dz=4e-6)
    strain = np.zeros((6, *grid.volume_shape))
    strain[:, 7:13, 8:12, 4:7] = np.random.default_rng(3).standard_normal((6, 6, 4, 3)) * 1e-3
    strain[2] = -(strain[0] + strain[1])
    gap = sc.surfaces.paraboloid(grid, 1e-3)
    coated = sc.Simulation(grid, RIGID, sc.Layered([(nothing, 8e-6)], steel), gap)
    coated.set_plastic_strain(2, strain)
    bare = sc.Simulation(grid, RIGID, steel, gap, zones="one")
    bare.set_plastic_strain(2, np.pad(strain[..., 2:], [(0, 0)] * 3 + [(0, 2)]))
    found = coated.state.residual_stress()[..., 2:8]
    exact = bare.state.residual_stress()[..., :6]
    assert np.abs(found - exact).max() < 1e-3 * np.abs(exact).max()  # image_tol


@pytest.mark.parametrize("periodic", ["xy", "x", "y"])
def test_plastic_strain_and_its_repetitions_agree(periodic):
    """Stress, and the displacement of the surface by lattice sums, on one period and on two."""
    body = sc.Layered([(POLYMER, 1e-6), (NITRIDE, 1e-6)], SOFT)
    strain = np.zeros((6, 8, 6, 4))
    strain[..., 2:] = np.random.default_rng(5).standard_normal((6, 8, 6, 2)) * 1e-3
    found = []
    for times in (1, 2):
        nx, ny = (times if axis in periodic else 1 for axis in "xy")
        grid = sc.Grid(8 * nx, 6 * ny, 1e-6, 1e-6, nz=4, dz=1e-6, periodic=periodic)
        run = sc.Simulation(grid, RIGID, body, np.full(grid.surface_shape, 1e-3))
        run.set_plastic_strain(2, np.tile(strain, (1, nx, ny, 1)))
        u = run.state.residual_displacement()[:8, :6]
        found.append((u, run.state.residual_stress()[:, :8, :6]))
    (u, stress), (again, stress_again) = found
    assert again == pytest.approx(u, abs=1e-6 * np.abs(u).max())
    # Images along a free direction are removed to image_tol.
    tol = 1e-12 if periodic == "xy" else 1e-3
    assert stress_again == pytest.approx(stress, abs=tol * np.abs(stress).max())


@pytest.mark.parametrize("periodic", ["xy", "y"])
def test_a_layer_equal_to_its_substrate_gives_equal_displacement(periodic):
    strain = np.zeros((6, 8, 6, 4))
    strain[..., 2:] = np.random.default_rng(6).standard_normal((6, 8, 6, 2)) * 1e-3
    grid = sc.Grid(8, 6, 1e-6, 1.5e-6, nz=4, dz=1e-6, periodic=periodic)
    like = sc.Material.elastic(SOFT.E * (1 + 1e-9), SOFT.nu)
    found = []
    for body in (SOFT, sc.Layered([(like, 2e-6)], SOFT)):
        run = sc.Simulation(grid, RIGID, body, np.full(grid.surface_shape, 1e-3))
        run.set_plastic_strain(2, strain)
        found.append((run.state.residual_displacement(), run.state.residual_stress()))
    for plain, layered in zip(*found, strict=True):
        assert layered == pytest.approx(plain, abs=1e-8 * np.abs(plain).max())

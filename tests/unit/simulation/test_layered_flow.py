# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic flow in layers and substrate together: closed forms, limits, equilibrium."""

import numpy as np
import pytest

import samcontact as sc

RIGID = sc.Material.rigid()
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
NITRIDE = sc.Material.linear_hardening(400e9, 0.25, 2.5e9, 20e9)
COPPER = sc.Material.perfect_plastic(70e9, 0.33, 0.3e9)


def flow_held_along_surface(body, z, pressure):
    """Return the equivalent plastic strain g of one depth under uniform pressure p.

    |p (1 - 2 nu)/(1 - nu) + s0| = sigma_y(g) f + H g + E g/(2 (1 - nu)), H of the backstresses.
    """
    material = body.material_at(z)
    E, nu = material.E, material.nu
    driven = pressure * (1 - 2 * nu) / (1 - nu) + material.residual_stress_at(z)[0]
    stiffness = E / (2 * (1 - nu)) + sum(modulus for modulus, _ in material.kinematic)
    low, high = 0.0, 1.0
    for _ in range(60):
        g = 0.5 * (low + high)
        yields = driven > material.yield_stress(g) * material.yield_factor(z) + stiffness * g
        low, high = (g, high) if yields else (low, g)
    return low


def test_each_depth_flows_by_the_law_of_its_layer():
    layers = [
        (sc.Material.elastic(400e9, 0.2), 4e-6),
        (NITRIDE.with_residual_stress([0.0], [2.4e9]), 8e-6),
        (COPPER.with_kinematic_hardening([10e9, 30e9]), 12e-6),
        # Depths are those below the surface: 1.9 at the top of the layer, 24 um deep.
        (COPPER.with_yield_profile([20e-6, 60e-6], [2.0, 1.0]), 16e-6),
    ]
    substrate = STEEL.with_kinematic_hardening(5e9).with_residual_stress(
        [44e-6, 80e-6], [400e6, -100e6]
    )
    body = sc.Layered(layers, substrate)
    grid = sc.Grid(8, 8, 10e-6, 10e-6, nz=25, dz=4e-6, periodic="xy")
    pressure = 2.2e9
    run = sc.Simulation(grid, RIGID, body, np.zeros((8, 8)))
    state = run.step(pressure=np.full((8, 8), pressure))
    expected = [flow_held_along_surface(body, z, pressure) for z in grid.z]
    flowing = np.array(expected) > 0
    assert not flowing[0]
    assert flowing[[2, *range(5, 11), 12]].all()
    assert not flowing[-1]
    strain = state.plastic_strain()
    for cell in [(0, 0), (3, 7)]:
        assert -strain[2][cell] == pytest.approx(expected, abs=1e-8)
        assert state.equivalent_plastic_strain()[cell] == pytest.approx(expected, abs=1e-8)
    assert state.max_equivalent_plastic_strain() == pytest.approx(max(expected), abs=1e-8)
    # X = 2/3 C e, as many terms as the material has.
    backstress = state.backstress()[:, 2, 0, 0]
    modulus = np.zeros((2, 25))
    modulus[:, 3:6], modulus[0, 10:] = [[10e9], [30e9]], 5e9
    assert backstress == pytest.approx(2 / 3 * modulus * strain[2, 0, 0], abs=1.0)
    assert state.initial_stress()[0, 0, 0] == pytest.approx(body.residual_stress_at(grid.z)[0])


def indented(body, upper=RIGID, n=26, loads=(2.0, 4.0, 6.0, 0.0), image_tol=1e-3):
    grid = sc.Grid(n, n, 4e-6, 4e-6, nz=20, dz=3e-6)
    gap = sc.surfaces.paraboloid(grid, 1e-3)
    run = sc.Simulation(grid, upper, body, gap, zones="one", image_tol=image_tol)
    return run, [run.step(load=load) for load in loads]


def flowing_steel(E):
    material = sc.Material.voce(E, 0.3, 1.2e9, 1.8e9, 30.0).with_yield_profile(
        [0.0, 20e-6], [1.3, 0.8]
    )
    material = material.with_residual_stress([0.0, 15e-6], [-3e8, 1e8], [-1e8, 0.0])
    return material.with_kinematic_hardening([40e9, 5e9], [300.0, 0.0])


@pytest.fixture(scope="module")
def homogeneous():
    """Return the states and the simulation of the body without layers."""
    return indented(flowing_steel(210e9), loads=(6.0, 0.0), image_tol=1e-6)


@pytest.mark.parametrize(("difference", "tol"), [(0.0, 1e-9), (1e-12, 2e-5)])
@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_nearly_equal_layers_agree_with_the_homogeneous_body(difference, tol, homogeneous):
    """Images of layered bodies are found by another method, both to image_tol."""
    usual, other = flowing_steel(210e9), flowing_steel(210e9 * (1 + difference))
    layered = sc.Layered([(other, 6e-6), (usual, 9e-6), (other, 3e-6)], usual)
    _, expected = homogeneous
    _, found = indented(layered, loads=(6.0, 0.0), image_tol=1e-6)
    assert expected[-1].max_equivalent_plastic_strain() > 1e-3
    for one, same in zip(found, expected, strict=True):
        assert one.approach == pytest.approx(same.approach, rel=tol, abs=tol * 1e-7)
        for name in (
            "pressure", "stress", "residual_stress", "backstress", "equivalent_plastic_strain",
            "residual_displacement",
        ):  # fmt: skip
            fields = [getattr(state, name) for state in (one, same)]
            fields = [field() if callable(field) else field for field in fields]
            scale = max(np.abs(fields[1]).max(), 1e-12)
            assert fields[0] == pytest.approx(fields[1], abs=tol * scale), name


def forces_on_blocks(grid, stress):
    """Return the force on the part of the grid above each depth, through bottom and sides."""
    bottom = stress[2:5].sum(axis=(1, 2)) * grid.cell_area
    ends = [np.moveaxis(s, axis, 0) for s, axis in ((stress[4], 0), (stress[3], 1))]
    sides = np.zeros(stress.shape[-1])
    for s, width in zip(ends, (grid.dy, grid.dx), strict=True):
        edges = [1.5 * s[n] - 0.5 * s[inner] for n, inner in ((-1, -2), (0, 1))]
        sides += (edges[0] - edges[1]).sum(axis=0) * width * grid.dz
    return bottom[0] + np.cumsum(sides) - 0.5 * sides, bottom[1:]


SANDWICH = [(NITRIDE, 6e-6), (COPPER, 6e-6)]


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.filterwarnings("ignore::samcontact.PlasticStrainWarning")
def test_a_soft_layer_flows_between_stiff_ones():
    run, states = indented(sc.Layered(SANDWICH, STEEL), n=40)
    loaded, unloaded = states[-2:]
    strain = unloaded.equivalent_plastic_strain()
    assert strain[:, :, 2:4].max() > 10 * strain[:, :, :2].max() > 0
    # Nowhere more than what each law bears.
    z = run.grid.z
    for n, (material, _) in enumerate(run.body2.layers):
        own = (z > 6e-6 * n) & (z < 6e-6 * (n + 1))
        bears = material.yield_stress(loaded.equivalent_plastic_strain()[..., own])
        assert loaded.von_mises()[..., own].max() <= bears.max() * 1.001
        flowed = strain[..., own] > 0
        assert loaded.von_mises()[..., own][flowed].max() == pytest.approx(bears.max(), rel=1e-3)
    through, along = forces_on_blocks(run.grid, unloaded.residual_stress())
    assert np.abs(through).max() < 5e-4 * loaded.load
    assert np.abs(along).max() < 1e-9 * loaded.load
    assert sc.energy.residual_energy(unloaded.track(2)) > 0


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_two_equal_layered_bodies_are_solved_as_one():
    bodies = [
        sc.Layered([(NITRIDE, 6e-6), (sc.Material.swift(E, 0.3, 945e6, 20.0, 0.121), 3e-6)], COPPER)
        for E in (210e9, 210e9 * (1 + 1e-12))
    ]
    _, (twins,) = indented(bodies[0], bodies[0], loads=(0.5,))
    _, (layered,) = indented(bodies[0], bodies[1], loads=(0.5,))
    assert twins.max_equivalent_plastic_strain() > 1e-3
    for body in (1, 2):
        assert layered.equivalent_plastic_strain(body) == pytest.approx(
            twins.equivalent_plastic_strain(2), abs=1e-8
        )
    assert np.array_equal(twins.stress(1), twins.stress(2))


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_a_run_with_yielding_layers_resumes_from_its_file(tmp_path):
    soft = COPPER.with_kinematic_hardening([10e9, 30e9], [0.0, 100.0])
    hard = NITRIDE.with_residual_stress([0.0], [-1e9])
    run, _ = indented(sc.Layered([(hard, 6e-6), (soft, 6e-6)], STEEL), loads=(2.0,))
    run.save(tmp_path / "run.h5")
    again = sc.Simulation.load(tmp_path / "run.h5")
    assert again.body2 == run.body2
    one, other = run.step(load=4.0), again.step(load=4.0)
    for name in ("stress", "plastic_strain", "backstress"):
        assert np.array_equal(getattr(one, name)(), getattr(other, name)())


def test_an_invalid_history_of_a_layer_is_refused():
    body = sc.Layered([(NITRIDE, 6e-6), (COPPER.with_kinematic_hardening(1e9), 6e-6)], STEEL)
    run, _ = indented(body, loads=())
    strain, backstress = (np.zeros((*n, *run.grid.volume_shape)) for n in ((6,), (1, 6)))
    backstress[0, 0, 3, 4, 2], backstress[0, 1, 3, 4, 2] = 1e8, -1e8
    run.set_plastic_strain(2, strain, backstress=backstress)
    assert np.array_equal(run.state.backstress(), backstress)
    with pytest.raises(ValueError, match=r"backstress.* at most modulus/recovery = 0"):
        run.set_plastic_strain(2, strain, backstress=np.roll(backstress, 2, axis=-1))


def test_the_load_of_first_yield_is_refused_for_several_laws():
    run, _ = indented(sc.Layered(SANDWICH, STEEL), loads=())
    with pytest.raises(ValueError, match="does not support layers, got layers in body2"):
        sc.find_load(lambda load: (run, [{"load": load}]), "yield", largest_load=10.0)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_energy_balance_of_yielding_layers():
    """Work is stored elastically, stored as residual energy, or dissipated by flow and slip."""
    soft = COPPER.with_kinematic_hardening(5e9)
    body = sc.Layered([(NITRIDE.with_residual_stress([0.0], [-1e9]), 6e-6), (soft, 6e-6)], STEEL)
    grid = sc.Grid(26, 26, 4e-6, 4e-6, nz=20, dz=3e-6)
    gap = sc.surfaces.paraboloid(grid, 1e-3)
    run = sc.Simulation(grid, sc.Material.elastic(600e9, 0.2), body, gap, friction=sc.Coulomb(0.3))
    states = [run.step(load=load) for load in np.linspace(0.5, 4.0, 8)]
    states += [run.step(load=4.0, shift=(5e-8, 0.0)) for _ in range(4)]
    found = sc.energy.balance(run, states)
    assert found.plastic_work > 0.1 * found.work_input
    assert found.friction_work > 0
    assert abs(found.imbalance) < 2e-3


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_results_contain_the_strength_of_each_layer(tmp_path):
    from samcontact import plotting, results
    from samcontact.report import tables
    from samcontact.results.reading import graded_of

    hard = sc.Material.elastic(400e9, 0.25).with_residual_stress([0.0], [-1e9])
    body = sc.Layered([(hard, 6e-6), (COPPER.with_yield_profile([0.0], [1.5]), 6e-6)], STEEL)
    run, states = indented(body, loads=(2.0,))
    results.save(results.to_dataset(run, states), tmp_path / "results.nc")
    dataset = results.open_results(tmp_path / "results.nc")
    assert graded_of(dataset, 2) == body
    rows = {row.name: row.value for row in tables.parameters(dataset) if row.section == "body2"}
    assert rows["layer2 yield stress"] == "300 MPa"
    assert rows["substrate B"] == "945 MPa"
    ax = plotting.axis_profile(states[0].stress(), run.grid, body=body, interfaces=body.interfaces)
    drawn = {line.get_label(): line.get_xydata().T for line in ax.lines}
    limit, depth = drawn["initial yield stress"]
    assert np.isnan(limit[depth < 6.0 * (1 - 1e-9)]).all()
    inside = (depth > 6.1) & (depth < 11.9)
    assert limit[inside] == pytest.approx(450.0)
    assert np.interp(11.9, depth, limit) == pytest.approx(450.0)
    start, depth = drawn[r"initial $\sigma_{xx} = \sigma_{yy}$"]
    assert start[depth < 5.9] == pytest.approx(-1000.0)
    assert np.abs(start[depth > 6.0]).max() == 0


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_contacts_move_over_layers_as_over_the_homogeneous_body():
    usual, other = (
        sc.Material.swift(E, 0.3, 945e6, 20.0, 0.121).with_kinematic_hardening(20e9, 100.0)
        for E in (210e9, 210e9 * (1 + 1e-12))
    )
    grid = sc.Grid(20, 20, 4e-6, 4e-6, nz=14, dz=3e-6)
    gap = sc.surfaces.paraboloid(grid, 1e-3)
    found = []
    for body in (usual, sc.Layered([(other, 6e-6), (usual, 6e-6)], usual)):
        run = sc.Simulation(grid, RIGID, body, gap, zones="one", friction=0.2, image_tol=1e-6)
        run.step(load=4.0)
        run.step(load=4.0, advance=(4e-6, 4e-6))
        rolled = run.step(load=4.0, advance=(4e-6, 4e-6))
        found.append((rolled.pressure, run.step(load=0.0).track(2)))
    (pressure, track), (same_pressure, same) = found
    assert pressure == pytest.approx(same_pressure, abs=1e-5 * pressure.max())
    strain = track.equivalent_plastic_strain()
    assert strain.max() > 5e-4
    assert same.equivalent_plastic_strain() == pytest.approx(strain, abs=2e-5 * strain.max())
    stress = track.residual_stress()
    assert same.residual_stress() == pytest.approx(stress, abs=2e-5 * np.abs(stress).max())
    print_left = track.residual_displacement()
    assert same.residual_displacement() == pytest.approx(
        print_left, abs=2e-5 * np.abs(print_left).max()
    )


def strain_along(stress, material, component):
    """Return the elastic strain xx, yy or xy of a stress."""
    E, nu = material.E, material.nu
    if component == 5:
        return stress[5] * (1 + nu) / E
    return ((1 + nu) * stress[component] - nu * stress[:3].sum(axis=0)) / E


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_traction_and_lateral_strain_are_continuous_at_interfaces():
    """Traction and lateral strain are equal on both sides of an interface."""
    brass = sc.Material.linear_hardening(120e9, 0.33, 0.6e9, 20e9)
    body = sc.Layered([(NITRIDE, 8e-6), (brass, 8e-6)], STEEL)
    grid = sc.Grid(34, 34, 3e-6, 3e-6, dz=2e-6)
    run = sc.Simulation(grid, RIGID, body, sc.surfaces.paraboloid(grid, 1e-3), friction=0.2)
    state = [run.step(load=load) for load in (2.0, 3.0)][-1]
    sides, plastic = state.interface_stress(), state.plastic_strain()
    tractions = sides[:, 2:5]
    assert np.abs(tractions[0] - tractions[1]).max() < 0.02 * np.abs(tractions).max()
    materials = [NITRIDE, brass, STEEL]
    for n, at in enumerate((4, 8)):
        strains, flowed = [], []
        for material, stress, first, along in zip(
            materials[n:], sides[..., n], (at - 1, at), (-1, 1), strict=False
        ):
            near = [plastic[..., first + k * along] for k in range(3)]  # each constant in a cell
            flowed.append((11 * near[0] - 7 * near[1] + 2 * near[2]) / 6)
            strains.append([strain_along(stress, material, c) + flowed[-1][c] for c in (0, 1, 5)])
        jump = np.abs(flowed[0] - flowed[1])[:2].max()
        assert jump > 2e-3
        assert np.abs(np.subtract(*strains)).max() < 0.06 * jump

# SPDX-License-Identifier: GPL-3.0-or-later
"""A tensile limit in simulations: paths, plastic flow, energy, files."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import surfaces
from samcontact.results import to_dataset

LIMIT = 5e7
LAW = sc.TensileLimit(LIMIT)
STEEL = sc.Material.elastic(210e9, 0.3)
SOFT = sc.Material.elastic(20e9, 0.2)
YIELDS = sc.Material.linear_hardening(20e9, 0.2, 8e7, 1e9)


def rough(grid):
    return -surfaces.rough_self_affine(grid, 2e-8, 0.8, wavelength_min=6e-6, seed=1)


def grid_of(**more):
    return sc.Grid(24, 24, 1e-6, 1e-6, periodic="xy", **more)


def area(grid):
    return grid.nx * grid.ny * grid.cell_area


def test_a_path_of_loads_is_that_of_single_contacts():
    grid = grid_of()
    gap, pull = rough(grid), LIMIT * area(grid)
    simulation = sc.Simulation(grid, STEEL, SOFT, gap, adhesion=LAW, tol=1e-9)
    assert simulation.state.load == pytest.approx(-pull, rel=1e-12)
    assert not simulation.state.in_contact.any()
    solver = sc.ContactSolver(grid, STEEL, SOFT, adhesion=LAW, tol=1e-10)
    for share in (0.5, -0.5, 0.0, -0.9):
        state = simulation.step(load=share * pull)
        one = solver.solve(gap, load=share * pull)
        scale = one.repulsion.max()
        np.testing.assert_allclose(state.pressure, one.pressure, rtol=0, atol=1e-6 * scale)
        np.testing.assert_array_equal(state.in_contact, one.in_contact)
        assert state.contact_area == pytest.approx(one.contact_area, rel=1e-5)
    assert not simulation.step(load=-pull).in_contact.any()
    with pytest.raises(ValueError, match="the maximum tensile force of the contact law"):
        simulation.step(load=-1.001 * pull)


def test_work_is_stored_as_energy():
    """The work of the load equals the elastic energy plus the work of the attraction."""
    grid = grid_of()
    gap = rough(grid)
    simulation = sc.Simulation(grid, STEEL, SOFT, gap, adhesion=LAW, tol=1e-10)
    solver = sc.ContactSolver(grid, STEEL, SOFT, adhesion=LAW)

    def stored(state):
        u = sum(solver.displacement(state.pressure, body=body)[2] for body in (1, 2))
        elastic = 0.5 * grid.cell_area * np.sum(state.pressure * u)
        return elastic + state.attraction_energy, elastic

    lowest, mean = gap.min(), gap.mean()
    approaches = lowest + np.linspace(0.3, 0.6, 81) * (mean - lowest)
    states = [simulation.step(approach=approach) for approach in approaches]
    loads = np.array([state.load for state in states])
    assert loads.min() < 0
    work = np.sum(0.5 * (loads[1:] + loads[:-1]) * np.diff(approaches))
    (first, elastic), (last, more) = stored(states[0]), stored(states[-1])
    assert last - first == pytest.approx(work, rel=1e-3)
    assert abs(more - elastic - work) > 0.1 * abs(work)  # attraction has a part in it


def test_flow_is_that_of_the_computed_pressure():
    """Plastic strain and gap equal those due to the prescribed tractions of the increment."""
    grid = grid_of(dz=1e-6)
    gap, load = rough(grid), -0.2 * LIMIT * area(grid)
    simulation = sc.Simulation(grid, sc.Material.rigid(), YIELDS, gap, adhesion=LAW, tol=1e-8)
    state = simulation.step(load=load)
    assert state.max_equivalent_plastic_strain() > 1e-5
    assert state.pressure.min() == pytest.approx(-LIMIT, rel=1e-12)
    given = sc.Simulation(grid, sc.Material.rigid(), YIELDS, gap, tol=1e-8)
    alone = given.step(pressure=state.pressure)
    strain = state.equivalent_plastic_strain()
    np.testing.assert_allclose(
        alone.at_layers(state.layers).equivalent_plastic_strain(), strain, atol=1e-4 * strain.max()
    )
    scale = np.ptp(state.gap)
    opened = alone.gap - alone.gap[state.in_contact].mean()
    np.testing.assert_allclose(opened, state.gap, rtol=0, atol=1e-4 * scale)
    touched = state.gap[state.in_contact]
    assert np.abs(touched).max() < 1e-4 * scale
    assert state.gap.min() > -1e-4 * scale


def test_no_limit_is_hard_contact_to_every_digit():
    grid = grid_of(dz=1e-6)
    states = [
        sc.Simulation(grid, sc.Material.rigid(), YIELDS, rough(grid), adhesion=law).step(load=1e-2)
        for law in (sc.TensileLimit(0.0), sc.HardContact())
    ]
    for name in ("pressure", "gap", "approach"):
        np.testing.assert_array_equal(*(getattr(state, name) for state in states))
    np.testing.assert_array_equal(*(state.stress() for state in states))


def test_checkpoints_and_results_contain_the_law(tmp_path):
    grid = grid_of()
    simulation = sc.Simulation(grid, STEEL, SOFT, rough(grid), adhesion=LAW)
    state = simulation.step(load=0.0)
    simulation.save(tmp_path / "kept.h5")
    again = sc.Simulation.load(tmp_path / "kept.h5")
    assert again.adhesion == LAW
    np.testing.assert_array_equal(again.state.repulsion, state.repulsion)
    np.testing.assert_array_equal(
        again.step(load=1e-3).pressure, simulation.step(load=1e-3).pressure
    )
    dataset = to_dataset(simulation, [state])
    assert dataset.attrs["adhesion"] == "tensile_limit"
    assert dataset.attrs["adhesion_limit"] == LIMIT
    np.testing.assert_array_equal(dataset["repulsion"].values[0], state.repulsion)
    assert float(dataset["attraction_energy"][0]) == state.attraction_energy > 0
    hard = sc.Simulation(grid, STEEL, SOFT, rough(grid))
    found = to_dataset(hard, [hard.step(load=1e-3)])
    assert "repulsion" not in found
    assert "adhesion" not in found.attrs


def test_options_unsupported_with_attraction_are_refused():
    grid = sc.Grid(17, 17, 1e-6, 1e-6)
    gap = surfaces.paraboloid(grid, 1e-3)
    simulation = sc.Simulation(grid, STEEL, SOFT, gap, adhesion=LAW)
    with pytest.raises(ValueError, match="pressure cannot be combined with adhesion"):
        simulation.step(pressure=np.zeros(grid.surface_shape))
    with pytest.raises(ValueError, match="advance must be"):
        simulation.step(load=1e-3, advance=(1e-6, 1e-6))
    sliding = sc.Simulation(grid, STEEL, SOFT, gap, sc.Coulomb(0.2), adhesion=LAW)
    states = [sliding.step(load=1e-3)]
    with pytest.raises(ValueError, match="adhesion must not attract"):
        sc.energy.balance(sliding, states)


def test_the_grid_of_attracting_bodies_is_not_enlarged():
    grid = sc.Grid(9, 9, 1e-6, 1e-6)
    simulation = sc.Simulation(
        grid, STEEL, SOFT, lambda over: surfaces.paraboloid(over, 1e-3), adhesion=LAW
    )
    with pytest.raises(sc.GridTooSmallError, match="with an attractive contact law"):
        simulation.step(load=0.05)

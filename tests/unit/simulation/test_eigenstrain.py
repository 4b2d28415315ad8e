# SPDX-License-Identifier: GPL-3.0-or-later
"""Prescribed eigenstrain: Eshelby's values, equilibrium, contact, yield, checkpoints, refusals."""

import copy
import itertools
import math
import pickle

import numpy as np
import pytest

import samcontact as sc
from samcontact.simulation.repeated import coarsened, rebuilt

E, NU = 210e9, 0.3
STEEL = sc.Material.elastic(E, NU)
SOFT = sc.Material.linear_hardening(E, NU, yield_stress=400e6, tangent_modulus=2e9)
D = 1e-5
GRID = sc.Grid(24, 20, D, D, 12, D)
R = 2e-3
MISFIT = np.array([1e-3, 2e-3, -5e-4, 3e-4, -4e-4, 2e-4])


def flat(grid=GRID):
    return np.zeros(grid.surface_shape)


def problem(body=STEEL, grid=GRID, gap=None, **settings):
    gap = sc.surfaces.paraboloid(grid, R) if gap is None else gap
    return sc.Simulation(grid, STEEL, body, gap, **settings)


def given(simulation, strain=MISFIT, first=(8, 6, 3), cells=(6, 7, 4)):
    simulation.add_eigenstrain(2, strain, first, cells)
    return simulation


def cuboid(function, *points, component=None, **more):
    """Return the closed-form field of the box of `given` at cell centres."""
    x0, y0 = GRID.x[8] + 2.5 * D, GRID.y[6] + 3 * D
    X, Y = (axis - start for axis, start in zip(points[:2], (x0, y0), strict=True))
    values = function(X, Y, *points[2:], 5 * D, 3 * D, 3.5 * D, 2 * D, **more)
    return np.tensordot(values, MISFIT, (values.ndim - X.ndim - 1, 0))


def test_stress_is_that_of_a_cuboid():
    state = given(problem(residual_stress="exact")).state
    X, Y, Z = np.meshgrid(GRID.x, GRID.y, GRID.z, indexing="ij")
    expected = cuboid(sc.kernels.eigenstrain_stress, X, Y, Z, E=E, nu=NU)
    largest = np.abs(expected).max()
    np.testing.assert_allclose(state.eigenstress(), expected, atol=1e-9 * largest)
    for of in (state.stress, state.residual_stress):
        np.testing.assert_array_equal(of(), state.eigenstress())
    assert not state.eigenstress(1).any()
    off = given(problem()).state.eigenstress() - expected  # fast, as for plastic strain
    assert np.abs(off).max() < 0.05 * largest
    assert np.sqrt(np.mean(off**2)) < 0.005 * largest


def test_displacement_is_that_of_a_cuboid():
    state = given(problem()).state
    X, Y = np.meshgrid(GRID.x, GRID.y, indexing="ij")
    expected = cuboid(sc.kernels.eigenstrain_displacement, X, Y, nu=NU)
    found = state.surface_displacement()
    np.testing.assert_allclose(found, expected, atol=1e-9 * np.abs(expected).max())
    np.testing.assert_allclose(state.gap, expected + problem().state.gap, rtol=1e-9)
    np.testing.assert_array_equal(state.residual_displacement(), found)


@pytest.mark.parametrize(
    ("strain", "share"),
    [
        # Eshelby (1957): stress over E strain in a sphere
        ((1.0, 1.0, 1.0, 0.0, 0.0, 0.0), -2 / (3 * (1 - NU))),
        ((0.0, 0.0, 0.0, 1.0, 0.0, 0.0), -(1 - 2 * (4 - 5 * NU) / (15 * (1 - NU))) / (1 + NU)),
    ],
)
def test_stress_in_a_deep_sphere_is_that_of_eshelby(strain, share):
    n, radius, depth = 19, 5.2, 22
    grid = sc.Grid(n, n, D, D, 32, D)
    at = np.arange(n) - n // 2
    inside = sum(np.square(axis) for axis in np.meshgrid(at, at, at, indexing="ij")) <= radius**2
    field = 1e-3 * np.array(strain)[:, None, None, None] * inside
    simulation = problem(grid=grid, gap=flat(grid))
    simulation.add_eigenstrain(2, field, (0, 0, depth - n // 2))
    state = simulation.state
    middle = slice(n // 2 - 1, n // 2 + 2)
    found = state.eigenstress()[:, middle, middle, depth - 1 : depth + 2]
    expected = 1e-3 * E * share * np.array(strain)
    largest = np.abs(expected).max()
    off = found - expected[:, None, None, None]
    assert np.abs(off).max() < 0.03 * largest
    assert np.abs(off.mean(axis=(1, 2, 3))).max() < 0.02 * largest
    if strain[0]:
        energy = E * 1e-6 / (1 - NU) * inside.sum() * D**3
        track = state.track(margin=n)
        assert sc.energy.eigenstrain_energy(track) == pytest.approx(energy, rel=0.03)
        assert sc.energy.residual_energy(track) == 0


def test_planes_bear_no_net_force():
    grid = sc.Grid(16, 16, D, D, 10, D, periodic="xy")
    state = given(problem(grid=grid, gap=flat(grid)), first=(3, 5, 2)).state
    stress = state.eigenstress()
    largest = np.abs(stress).max()
    for component in (2, 3, 4):  # zz, yz, xz on planes of equal depth
        assert np.abs(stress[component].mean(axis=(0, 1))).max() < 1e-9 * largest
    free = np.abs(stress[2, :, :, 0]).max()
    assert free < 0.2 * largest


def test_contact_includes_the_displacement_of_eigenstrain():
    simulation = given(problem())
    unloaded = simulation.state
    state = simulation.step(load=3.0)
    gap = sc.surfaces.paraboloid(GRID, R) + unloaded.surface_displacement()
    alone = sc.ContactSolver(GRID, STEEL, STEEL).solve(gap, load=3.0)
    largest = alone.pressure.max()
    np.testing.assert_allclose(state.pressure, alone.pressure, atol=1e-6 * largest)
    without = problem().step(load=3.0)
    assert np.abs(without.pressure - state.pressure).max() > 0.01 * largest
    plain = problem()
    same = plain.step(pressure=state.pressure, shear=np.zeros(GRID.surface_shape))
    np.testing.assert_allclose(
        state.stress(), same.stress() + unloaded.eigenstress(), atol=1e-9 * largest
    )


def test_elastic_unloading_keeps_eigenstrain():
    simulation = given(problem(SOFT), strain=MISFIT / 20)
    simulation.step(load=0.05)
    state = simulation.step(load=0.0)
    assert state.iterations == 0
    assert state.max_plastic_strain_magnitude() == 0
    assert state.plastic_cells() == 0
    np.testing.assert_array_equal(state.residual_stress(), state.eigenstress())
    assert state.eigenstress().any()


def test_eigenstrain_can_cause_yield():
    simulation = given(problem(SOFT), 2 * MISFIT)
    assert simulation.state.plastic_cells() == 0
    state = simulation.step(load=0.0)
    assert state.plastic_cells() > 0
    yielded = state.equivalent_plastic_strain() > 0
    bears = 400e6 + E * 2e9 / (E - 2e9) * state.equivalent_plastic_strain()
    assert (state.von_mises() < 1.003 * bears).all()
    assert (state.von_mises()[yielded] > 0.99 * bears[yielded]).mean() > 0.9
    # one eigenstrain or two that add to it
    halves = given(given(problem(SOFT))).step(load=0.0)
    np.testing.assert_allclose(halves.plastic_strain(), state.plastic_strain(), atol=1e-9)


def test_flow_equals_that_with_an_equal_plastic_strain():
    field = np.zeros((6, *GRID.volume_shape))
    field[:, 8:14, 6:13, 3:7] = 2 * MISFIT[:, None, None, None]
    other = problem(SOFT)
    other.set_plastic_strain(2, field)
    own = given(problem(SOFT), 2 * MISFIT)
    for load in (0.0, 4.0):
        a, b = own.step(load=load), other.step(load=load)
        flow = b.plastic_strain() - field
        largest = np.abs(flow).max()
        assert largest > 1e-4
        np.testing.assert_allclose(a.plastic_strain(), flow, atol=5e-3 * largest)
        np.testing.assert_allclose(a.pressure, b.pressure, atol=2e-3 * max(b.pressure.max(), 1))
    assert own.state.max_plastic_strain_magnitude() < 1.01 * largest * math.sqrt(6)
    np.testing.assert_array_equal(own.state.eigenstrain(), field)


def same_next_step(one, other):
    a, b = one.step(load=2.0), other.step(load=2.0)
    np.testing.assert_array_equal(a.pressure, b.pressure)
    np.testing.assert_array_equal(a.plastic_strain(), b.plastic_strain())
    np.testing.assert_array_equal(a.eigenstrain(), b.eigenstrain())
    assert a.has_eigenstrain()
    assert not a.has_eigenstrain(1)


def test_copies_and_checkpoints_keep_eigenstrain(tmp_path):
    simulation = given(problem(SOFT))
    simulation.step(load=1.0)
    simulation.save(tmp_path / "kept.h5")
    others = [
        copy.copy(simulation),
        pickle.loads(pickle.dumps(simulation)),
        sc.Simulation.load(tmp_path / "kept.h5"),
    ]
    assert pickle.loads(pickle.dumps(simulation.state)).has_eigenstrain()
    first, *rest = others
    same_next_step(simulation, first)
    for other in rest:
        same_next_step(other, copy.copy(other))
        np.testing.assert_array_equal(other.state.pressure, simulation.state.pressure)


def test_runs_continue_only_with_equal_eigenstrain(tmp_path):
    path = [{"load": 1.0}, {"load": 2.0}]
    states = given(problem(SOFT)).run(path, progress=False, checkpoint=tmp_path / "run")
    again = given(problem(SOFT)).run(path, progress=False, checkpoint=tmp_path / "run")
    np.testing.assert_array_equal(again[-1].pressure, states[-1].pressure)
    with pytest.raises(ValueError, match="eigenstrain2"):
        given(problem(SOFT), 2 * MISFIT).run(path, progress=False, checkpoint=tmp_path / "run")


def test_eigenstrain_keeps_its_position_if_the_grid_is_enlarged():
    simulation = sc.Simulation(GRID, STEEL, STEEL, lambda grid: sc.surfaces.paraboloid(grid, R))
    given(simulation)
    before = simulation.grid.surface_shape
    state = simulation.step(load=200.0)
    after = simulation.grid.surface_shape
    assert after != before
    i, j = ((n - m) // 2 for n, m in zip(after, before, strict=True))
    strained = np.zeros((6, *state.grid.surface_shape, state.layers))
    strained[:, 8 + i : 14 + i, 6 + j : 13 + j, 3:7] = MISFIT[:, None, None, None]
    np.testing.assert_array_equal(state.eigenstrain(), strained)


def test_eigenstrain_moves_with_its_body():
    for body in (SOFT, STEEL):
        simulation = given(problem(body))
        before = simulation.state
        simulation.step(load=1.0)
        state = simulation.step(load=1.0, advance=(3 * D, 3 * D))
        moved = np.roll(before.eigenstrain(), 3, axis=1)
        np.testing.assert_array_equal(state.eigenstrain(), moved)
    with pytest.raises(ValueError, match="whole cells"):
        simulation.step(load=1.0, advance=(0.5 * D, 0.5 * D))
    assert simulation.state.travel == state.travel


def test_the_energy_balance_separates_eigenstrain():
    settings = {"friction": sc.Coulomb(0.3), "tol": 1e-8}
    path = [{"load": load} for load in np.linspace(0.3, 3.0, 8)]
    path += [{"load": 3.0, "shift": (s, 0.0)} for s in (1e-8, 2e-8)]
    simulation, plain = given(problem(**settings), MISFIT / 10), problem(**settings)
    states = simulation.run(path, progress=False)
    found = sc.energy.balance(simulation, states)
    other = sc.energy.balance(plain, plain.run(path, progress=False))
    own = sc.energy.eigenstrain_energy(states[-1].track(margin=0))
    assert found.eigenstrain_energy == pytest.approx(own)
    assert own > 0
    assert other.eigenstrain_energy == 0
    assert found.residual_energy == 0
    assert abs(found.imbalance) < abs(other.imbalance) + 0.02
    more = given(simulation).step(load=3.0)
    with pytest.raises(ValueError, match="equal eigenstrain"):
        sc.energy.balance(simulation, [*states, more])


def test_repeated_cycles_keep_eigenstrain():
    simulation = given(problem(SOFT))
    simulation.step(load=1.0, advance=(2 * D, 2 * D))
    again = rebuilt(simulation).state
    np.testing.assert_array_equal(again.eigenstrain(), given(problem()).state.eigenstrain())
    coarse = coarsened(simulation, simulation.heat)
    found, grid = coarse.state.eigenstrain(), coarse.grid
    assert (grid.dx, grid.dz) == (2 * D, 2 * D)
    total = found.sum(axis=(1, 2, 3)) * 8
    np.testing.assert_allclose(total, MISFIT * 6 * 7 * 4, rtol=1e-12)
    middle = np.tensordot(np.abs(found).sum(axis=0).sum(axis=(1, 2)), grid.x, 1)
    assert middle / np.abs(found).sum() == pytest.approx(GRID.x[8] + 2.5 * D)


def test_an_opposite_eigenstrain_cancels():
    simulation = given(given(problem()), -MISFIT)
    assert not simulation.state.has_eigenstrain()
    pressure = problem().step(load=2.0).pressure
    np.testing.assert_array_equal(simulation.step(load=2.0).pressure, pressure)


REFUSED = {
    "in the grid, which has 24": ((MISFIT, (20, 0, 0), (5, 2, 2)), {}),
    "in the grid, which has 20": ((MISFIT, (0, 19, 0), (5, 2, 2)), {}),
    "in the grid, which has 12": ((MISFIT, (0, 0, 11), (5, 2, 2)), {}),
    "first must be": ((MISFIT, (-1, 0, 0), (1, 1, 1)), {}),
    "three integers": ((MISFIT, (1, 0), (1, 1, 1)), {}),
    "cells must be": ((MISFIT, (1, 0, 0), (1, 0, 1)), {}),
    "with cells =": ((MISFIT,), {}),
    "finite": ((np.full(6, math.nan), (0, 0, 0), (1, 1, 1)), {}),
    "shape": ((np.zeros((5, 2, 2, 2)),), {}),
    "grid must have dz": ((MISFIT, (0, 0, 0), (1, 1, 1)), {"grid": sc.Grid(24, 20, D, D)}),
    "rigid": ((MISFIT, (0, 0, 0), (1, 1, 1)), {"body": sc.Material.rigid()}),
}


@pytest.mark.parametrize("words", REFUSED)
def test_unsupported_arguments_are_refused(words):
    arguments, changes = REFUSED[words]
    simulation = problem(**changes)
    with pytest.raises(ValueError, match=words):
        simulation.add_eigenstrain(2, *arguments)
    assert not simulation.state.has_eigenstrain()


def test_automatic_layers_show_eigenstrain():
    grid = sc.Grid(16, 16, D, D, dz=D)
    simulation = given(problem(grid=grid), first=(2, 3, 15))
    state = simulation.state
    assert state.layers == 19
    assert state.eigenstrain()[..., 15:].any()
    assert not state.eigenstrain()[..., :15].any()
    with pytest.raises(ValueError, match="inside the grid"):
        given(simulation, first=(0, 0, 10**6))


def test_stress_depends_on_the_coating_layers_with_eigenstrain():
    layers = sc.Layered([(sc.Material.elastic(400e9, 0.2), 4 * D)], STEEL)
    swollen = np.array([1e-3, 1e-3, 0.0, 0.0, 0.0, 0.0])
    found = [
        given(problem(layers), swollen, (6, 6, first), (8, 8, 4)).state.eigenstress()
        for first in (0, 4)
    ]
    for stress, part in zip(found, (slice(0, 4), slice(4, 8)), strict=True):
        assert (stress[:2, 8:12, 8:12, part] < 0).all()
    ratio = found[0][0, 10, 10, 2] / found[1][0, 10, 10, 6]
    assert 1.2 < ratio < 2.5


def test_values_of_all_cells_are_used():
    """A field with different values in all cells keeps positions and order."""
    field = np.arange(6 * 2 * 3 * 2, dtype=float).reshape(6, 2, 3, 2) * 1e-6
    simulation = problem()
    simulation.add_eigenstrain(2, field, (4, 5, 6))
    found = simulation.state.eigenstrain()
    np.testing.assert_array_equal(found[:, 4:6, 5:8, 6:8], field)
    for component, at in itertools.product(range(6), ((0, 0, 0), (4, 5, 5))):
        assert found[(component, *at)] == 0


def test_eigenstrain_displaces_the_surface_as_an_equal_plastic_strain():
    strain = np.zeros((6, 24, 20, 12))
    strain[0, 8:14, 6:13, 3:7], strain[2, 8:14, 6:13, 3:7] = 1e-4, -1e-4
    prescribed, plastic = (problem(SOFT, gap=flat() + 1e-3) for _ in range(2))
    prescribed.add_eigenstrain(2, strain)
    plastic.set_plastic_strain(2, strain)
    for axis in "xyz":
        one, other = (s.state.residual_displacement(axis=axis) for s in (prescribed, plastic))
        assert np.abs(other).max() > 1e-11
        np.testing.assert_allclose(one, other, rtol=0.0, atol=1e-10 * np.abs(other).max())

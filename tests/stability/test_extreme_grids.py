# SPDX-License-Identifier: GPL-3.0-or-later
"""Extreme Poisson's ratios, long and flat cells, prime and unequal numbers of cells."""

import math

import numpy as np
import pytest

import samcontact as sc

E, RADIUS, LOAD = 210e9, 7.5e-3, 300.0
RATIOS = (0.0, 0.3, 0.499)
STEEL = sc.Material.elastic(E, 0.3)


def hertz(body1, body2, load=LOAD):
    return sc.hertz.point(RADIUS, sc.hertz.effective_modulus(body1, body2), load=load)


def ball(nx, ny, body1=STEEL, body2=STEEL, friction=0.0, width=2.6):
    """Solve elastic contact on a square around the Hertz contact; return solution and Hertz."""
    exact = hertz(body1, body2)
    grid = sc.Grid(nx, ny, width * exact.a / nx, width * exact.a / ny)
    solver = sc.ContactSolver(grid, body1, body2, friction)
    return grid, solver.solve(sc.surfaces.paraboloid(grid, RADIUS), load=LOAD), exact


@pytest.mark.parametrize("nu1", RATIOS)
@pytest.mark.parametrize("nu2", RATIOS)
def test_hertz_at_any_poisson_ratio(nu1, nu2):
    """25 cells across: approach and pressure are within 0.1 %."""
    bodies = (sc.Material.elastic(E, nu) for nu in (nu1, nu2))
    _, found, exact = ball(25, 25, *bodies)
    assert found.approach == pytest.approx(exact.approach, rel=1e-3)
    assert found.pressure.max() == pytest.approx(exact.p0, rel=1e-3)


@pytest.mark.parametrize("nu1", RATIOS)
@pytest.mark.parametrize("nu2", RATIOS)
def test_coupled_friction_of_one_at_any_poisson_ratio(nu1, nu2):
    """The pressure is mirrored in x if the bodies are swapped, symmetric if they are identical."""
    bodies = [sc.Material.elastic(E, nu) for nu in (nu1, nu2)]
    found = [ball(25, 24, *pair, friction=1.0)[1] for pair in (bodies, bodies[::-1])]
    assert all(solution.error <= 1e-8 for solution in found)
    difference = np.abs(found[0].pressure - found[1].pressure[::-1]).max()
    assert difference <= 1e-6 * found[0].pressure.max()
    skew = np.abs(found[0].pressure - found[0].pressure[::-1]).max() / found[0].pressure.max()
    assert (skew > 0.01) == (nu1 != nu2)


@pytest.mark.parametrize(("nx", "ny"), [(24, 384), (384, 24), (24, 1536), (24, 96), (96, 24)])
def test_long_cells(nx, ny):
    """Cells up to dx:dy = 64:1, 24 across: errors of square cells of the longer side, 0.6 %."""
    grid, found, exact = ball(nx, ny)
    expected = exact.pressure(grid.x[:, None], grid.y)
    assert found.approach == pytest.approx(exact.approach, rel=5e-4)
    assert np.abs(found.pressure - expected).sum() < 0.007 * expected.sum()


PRIMES = [(23, 29), (31, 37), (61, 47), (127, 23), (19, 97), (7, 61)]


@pytest.mark.parametrize(("nx", "ny"), PRIMES)
def test_prime_numbers_of_cells(nx, ny):
    """The error is that of the coarser direction, below (0.4 cell/contact radius)^1.5."""
    _, found, exact = ball(nx, ny)
    cell = 2.6 / min(nx, ny)
    assert found.approach == pytest.approx(exact.approach, rel=(0.4 * cell) ** 1.5)
    assert found.pressure.sum() * exact.a**2 * 2.6**2 / (nx * ny) == pytest.approx(LOAD, rel=1e-12)


@pytest.mark.parametrize("shape", [(1, 1), (1, 13), (13, 1), (2, 2), (2, 5), (3, 2)])
def test_grids_of_few_cells(shape):
    """The gap of loaded cells is zero for any number of cells."""
    grid = sc.Grid(*shape, 5e-5, 7e-5)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    with pytest.warns(sc.GridTooSmallWarning):
        found = sc.ContactSolver(grid, STEEL, STEEL, on_border="warn").solve(gap, load=10.0)
    u = 2 * sc.operators.surface_displacement(grid, found.pressure, E, 0.3)
    closed = (gap + u - found.approach)[found.pressure > 0]
    assert np.abs(closed).max() <= 1e-8 * u.max()
    assert found.pressure.sum() * grid.cell_area == pytest.approx(10.0, rel=1e-12)


EXACT = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(STEEL, STEEL), p0=2.4e9)
WIDTH, DEPTH = 3.2 * EXACT.a, 2.0 * EXACT.a


def dent(nx, ny, nz, nu=0.3, **settings):
    """Return maximum pressure, imprint depth and volume integral of plastic strain for a ball."""
    soft = sc.Material.linear_hardening(E, nu, 1e9, 0.1 * E)
    grid = sc.Grid(nx, ny, WIDTH / nx, WIDTH / ny, nz, DEPTH / nz)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, STEEL, soft, gap, **settings)
    loaded = simulation.step(load=EXACT.load)
    state = simulation.step(load=0.0)
    volume = grid.cell_area * grid.dz / EXACT.a**3
    flow = state.equivalent_plastic_strain().sum() * volume
    return np.array([loaded.pressure.max(), state.residual_displacement().max(), flow])


@pytest.fixture(scope="module")
def regular():
    return dent(33, 33, 20)


SHAPES = {
    # cells, and the largest relative difference: one of the coarser direction
    "dz:dx = 1:8": ((15, 15, 80), 0.03),
    "dz:dx = 8:1": ((77, 77, 6), 0.15),
    "dx:dy = 1:16": ((145, 9, 12), 0.07),
    "dx:dy = 16:1": ((9, 145, 12), 0.07),
    "primes": ((17, 23, 13), 0.03),
    "primes, long": ((41, 13, 11), 0.03),
}


@pytest.mark.parametrize("method", ["exact", "fast"])
@pytest.mark.parametrize("name", SHAPES)
def test_plastic_flow_in_long_and_flat_cells(name, method, regular):
    shape, tolerance = SHAPES[name]
    found = dent(*shape, residual_stress=method)
    assert found == pytest.approx(regular, rel=tolerance)


@pytest.mark.parametrize("nu", [0.0, 0.499])
def test_plastic_flow_at_the_ends_of_poisson_ratio(nu):
    """Agreement with half the cell size is as close as at nu = 0.3."""
    coarse, fine = dent(17, 17, 10, nu), dent(33, 33, 20, nu)
    assert coarse == pytest.approx(fine, rel=0.03)


@pytest.mark.parametrize("flatness", [1 / 16, 1 / 8, 8.0, 16.0])
@pytest.mark.parametrize("nu", [0.0, 0.499])
def test_influence_of_flat_cuboids(flatness, nu):
    """The far field of a cuboid equals the sum over its parts, without cancellation."""
    half, depth, parts = 1.0, 20.0 * max(1.0, flatness), 4
    c = half * flatness
    X = np.array([0.0, 3.0, 30.0, 300.0]) * max(1.0, flatness)
    whole = sc.kernels.eigenstrain_stress(X, 0.3 * X, depth, depth, half, half, c, E, nu)
    summed = 0.0
    for n in range(parts):
        centre = depth - c + (2 * n + 1) * c / parts
        summed = summed + sc.kernels.eigenstrain_stress(
            X, 0.3 * X, depth, centre, half, half, c / parts, E, nu
        )
    if flatness < 1:  # inside a part its strain is subtracted once; on a face it is not unique
        whole, summed = whole[..., 1:], summed[..., 1:]
    else:
        whole, summed = whole[..., 2:], summed[..., 2:]
    # relative to the largest component at the same point
    scale = np.abs(whole).max(axis=(0, 1))
    assert (np.abs(whole - summed).max(axis=(0, 1)) <= 1e-8 * scale).all()
    assert math.isfinite(scale.max())

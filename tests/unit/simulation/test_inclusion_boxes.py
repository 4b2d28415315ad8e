# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes of inclusions that begin at their depth, and several boxes for inclusions far apart."""

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
YIELDING = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 9.5e9)
STIFF = sc.Material.elastic(390e9, 0.25)
H = 10e-6


def pressed(body, grid, radius, load, **settings):
    gap = sc.surfaces.paraboloid(grid, radius)
    simulation = sc.Simulation(
        grid, sc.Material.rigid(), body, gap, on_border="warn", **({"tol": 1e-4} | settings)
    )
    return simulation, simulation.step(load=load)


def test_misfit_sphere_at_depth():
    """Mindlin and Cheng (1950), doi:10.1063/1.1699785, eight radii below the surface."""
    r, strain, depth = 4 * H, 1e-3, 32 * H
    grid = sc.Grid(25, 25, H, H, dz=H)
    body = sc.Heterogeneous(STEEL, [sc.Inclusion.sphere((0.0, 0.0, depth), r, STEEL, strain)])
    gap = sc.surfaces.paraboloid(grid, 1e-2)
    state = sc.Simulation(grid, sc.Material.rigid(), body, gap, image_tol=1e-4).state
    r2 = grid.x[:, None] ** 2 + grid.y**2
    expected = -4 / 3 * 1.3 * strain * r**3 * depth / (r2 + depth**2) ** 1.5
    error = state.residual_displacement(2)[8:17, 8:17] - expected[8:17, 8:17]
    assert np.abs(error).max() < 5e-4 * np.abs(expected).max()
    inside = state.residual_stress(2)[:, 12, 12, 31:33].mean(axis=1)
    uniform = -2 / 3 * 210e9 * strain / 0.7  # of the sphere in an infinite body
    np.testing.assert_allclose(inside[:3], uniform, rtol=0.01)


@pytest.mark.parametrize("matrix", [STEEL, YIELDING])
def test_box_at_depth_equals_the_box_from_the_surface(matrix):
    """A second inclusion, almost of the matrix, at the surface requires layers from there."""
    grid = sc.Grid(31, 31, H, H, dz=H)
    deep = sc.Inclusion.sphere((2 * H, 0.0, 26 * H), 3.6 * H, STIFF, misfit=2e-3)
    young = 210e9 * (1 + 1e-9)
    almost = (
        sc.Material.linear_hardening(young, 0.3, 1.2e9, 9.5e9)
        if matrix.is_plastic
        else sc.Material.elastic(young, 0.3)
    )
    shallow = sc.Inclusion.sphere((0.0, 0.0, 2.2 * H), 2.1 * H, almost)
    found, expected = (
        pressed(sc.Heterogeneous(matrix, inclusions), grid, 2e-3, 5.0)[1]
        for inclusions in ([deep], [deep, shallow])
    )
    np.testing.assert_allclose(found.pressure, expected.pressure, rtol=0, atol=1e-5 * 2e9)
    for name in ("stress", "eigenstrain"):
        a, b = (getattr(state, name)(2)[..., :32] for state in (found, expected))
        np.testing.assert_allclose(a, b, rtol=0, atol=2e-4 * np.abs(b).max())


def scattered(matrix):
    """A body whose inclusions are far apart, with the contact on several of them."""
    rng = np.random.default_rng(4)
    places = np.stack(np.meshgrid(*[np.arange(-36, 37, 24.0)] * 2), -1).reshape(-1, 2)
    centers = np.column_stack([places + rng.uniform(-3, 3, places.shape), rng.uniform(6, 9, 16)])
    spheres = [
        sc.Inclusion.sphere(H * at, 3.1 * H, STIFF, misfit=(-1) ** n * 5e-4)
        for n, at in enumerate(centers)
    ]
    return sc.Heterogeneous(matrix, spheres)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.parametrize("matrix", [STEEL, pytest.param(YIELDING, marks=pytest.mark.slow)])
def test_inclusions_far_apart(matrix, tmp_path):
    """Boxes of their own give the stress of one box, and a restart its digits."""
    grid, body = sc.Grid(96, 96, H, H, dz=H), scattered(matrix)
    found = {}
    for zones in ("one", "auto"):
        simulation, loaded = pressed(body, grid, 15e-3, 30.0, zones=zones)
        simulation.save(tmp_path / zones)
        found[zones] = (loaded, simulation.step(load=0.0))
    again = sc.Simulation.load(tmp_path / "auto").step(load=0.0)
    np.testing.assert_array_equal(again.stress(2), found["auto"][1].stress(2))
    p0 = found["one"][0].pressure.max()
    for a, b in zip(*found.values(), strict=True):
        np.testing.assert_allclose(b.pressure, a.pressure, rtol=0, atol=1e-3 * p0)
        layers = min(a.stress(2).shape[-1], b.stress(2).shape[-1])
        error = b.stress(2)[..., :layers] - a.stress(2)[..., :layers]
        assert 0 < np.abs(error).max() < 1.5e-3 * p0
        assert np.sqrt((error**2).mean()) < 1e-4 * p0

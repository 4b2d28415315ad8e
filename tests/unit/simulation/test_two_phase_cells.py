# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells that the surface of an inclusion divides, where both phases flow."""

import numpy as np

import samcontact as sc
from samcontact.problem.two_phase_cells import normals

STEEL = sc.Material.linear_hardening(210e9, 0.3, 1.5e9, 9.5e9)
R, H = 1e-4, 25e-6
GRID = sc.Grid(25, 25, H, H, nz=15, dz=H)
CENTER = (0.1e-4, -0.05e-4, 2.1e-4)


def body(material):
    return sc.Heterogeneous(STEEL, [sc.Inclusion.sphere(CENTER, R, material)])


def test_normals_of_a_sphere():
    cells = body(sc.Material.elastic(400e9, 0.25)).cells_on(GRID)
    places = [
        (np.arange(n) + first + 0.5) * H - (12.5 * H if axis < 2 else 0.0) - c
        for axis, (n, first, c) in enumerate(
            zip(cells.share.shape, cells.first, CENTER, strict=True)
        )
    ]
    at = np.array(np.meshgrid(*places, indexing="ij"))
    exact = at / np.linalg.norm(at, axis=0)
    found = normals(cells, GRID)
    cosine = (found * exact).sum(axis=0)[cells.is_cut]
    assert cosine.min() > np.cos(np.radians(10.0))
    np.testing.assert_allclose(np.linalg.norm(found, axis=0)[cells.is_cut], 1.0)
    of_sphere = normals(cells, GRID, body(sc.Material.elastic(400e9, 0.25)).inclusions)
    np.testing.assert_allclose(of_sphere[:, cells.is_cut], exact[:, cells.is_cut], atol=1e-12)


def test_normals_of_an_ellipsoid_across_the_side_of_a_period():
    """They are those in the middle of the period, which follow nearly from the shares."""
    axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]]
    grid = sc.Grid(24, 25, H, H, nz=15, dz=H, periodic="x")
    found = []
    for x in (0.0, 12 * H):
        inclusion = sc.Inclusion.ellipsoid(
            (x, 0.0, 2e-4), (1.4e-4, 1e-4, 1.2e-4), sc.Material.elastic(4e11, 0.3), axes=axes
        )
        cells = sc.Heterogeneous(STEEL, [inclusion]).cells_on(grid)
        of_surface = normals(cells, grid, [inclusion])
        if x == 0.0:
            cosine = (of_surface * normals(cells, grid)).sum(axis=0)[cells.is_cut]
            assert cosine.min() > np.cos(np.radians(12.0))
        of_surface = np.where(cells.is_cut, of_surface, 0.0)
        found.append([cells.over_grid(part, (24, 25, 15)) for part in of_surface])
    assert np.abs(found[0]).max() > 0.9
    np.testing.assert_allclose(np.roll(found[1], 12, axis=1), found[0], atol=1e-9)


def test_nearly_equal_phases():
    """A laminate of nearly equal phases is nearly the homogeneous body."""
    almost = sc.Material.linear_hardening(210.001e9, 0.3, 1.50001e9, 9.50001e9)
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    states = []
    for one in (STEEL, body(almost)):
        sim = sc.Simulation(GRID, sc.Material.rigid(), one, gap, on_border="warn", tol=1e-6)
        sim.step(load=60.0)
        states.append((sim.step(load=90.0), sim.step(load=0.0)))
    for homogeneous, mixed in zip(*states, strict=True):
        scale = np.abs(homogeneous.stress(2)).max()
        difference = np.abs(mixed.stress(2) - homogeneous.stress(2)).max()
        assert difference < 1e-3 * scale
        strain = homogeneous.plastic_strain(2)
        assert np.abs(mixed.plastic_strain(2) - strain).max() < 2e-3 * np.abs(strain).max()

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
    found = normals(cells, GRID)
    places = [
        (np.arange(n) + first + 0.5) * H - (12.5 * H if axis < 2 else 0.0) - c
        for axis, (n, first, c) in enumerate(
            zip(cells.share.shape, cells.first, CENTER, strict=True)
        )
    ]
    at = np.array(np.meshgrid(*places, indexing="ij"))
    exact = at / np.linalg.norm(at, axis=0)
    cosine = (found * exact).sum(axis=0)[cells.is_cut]
    assert cosine.min() > np.cos(np.radians(10.0))
    np.testing.assert_allclose(np.linalg.norm(found, axis=0)[cells.is_cut], 1.0)


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

# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions in layered bodies, against layers that are themselves voxels of a homogeneous body."""

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
YIELDING = sc.Material.linear_hardening(210e9, 0.3, 1.5e9, 9.5e9)
STIFF = sc.Material.elastic(400e9, 0.25)
RIGID = sc.Material.rigid()
H = 25e-6
GRID = sc.Grid(21, 21, H, H, dz=H)
SPHERE = sc.Inclusion.sphere((2e-5, 0.0, 9 * H), 4 * H, STIFF, misfit=1e-4)


def simulation(body, **more):
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    return sc.Simulation(GRID, RIGID, body, gap, on_border="warn", tol=1e-4, **more)


@pytest.mark.parametrize("material", [STEEL, YIELDING])
@pytest.mark.parametrize(("layers", "rounding"), [(3, 0.0), (3, 1e-8), (14, 1e-8)])
def test_layers_of_almost_equal_constants(material, layers, rounding):
    """The sphere below an interface, or in a layer, is that of the homogeneous body."""
    # Layers of equal constants are one layer; others are computed as layers.
    coat = sc.Material(material.law, dict(material.parameters) | {"E": material.E * (1 + rounding)})
    layered = sc.Layered([(coat, layers * H)], material)
    a = simulation(sc.Heterogeneous(material, [SPHERE]), zones="one").step(load=60.0)
    b = simulation(sc.Heterogeneous(layered, [SPHERE])).step(load=60.0)
    error = 1e-12 if rounding == 0.0 else 1e-5
    np.testing.assert_allclose(b.pressure, a.pressure, rtol=0, atol=error * a.pressure.max())
    scale = np.abs(a.stress(2)).max()
    np.testing.assert_allclose(b.stress(2), a.stress(2), rtol=0, atol=error * scale)


SUBSTRATE = sc.Material.elastic(200e9, 0.3)
COAT = sc.Material.elastic(120e9, 0.25)
BLOCK = sc.Material.elastic(300e9, 0.2)


def pressed(body, n, size):
    """Rigid waves on a body that is periodic in both directions, with layers of n x n cells."""
    grid = sc.Grid(n, n, size, size, dz=size, periodic="xy")
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    wave = 2 * np.pi / (n * size)
    gap = 2e-7 * (2 - np.cos(wave * x) - np.cos(wave * y))
    return sc.Simulation(grid, RIGID, body, gap, tol=1e-4).step(load=3.0).at_layers(2 * n // 3)


@pytest.mark.parametrize(("thickness", "top", "bottom"), [(6, 1, 5), (2, 4, 7)])
def test_layer_of_voxels(thickness, top, bottom):
    """Block in the coating or in the substrate; the coating is a layer, or inclusions itself.

    The second body uses the operators of the homogeneous half-space only. The difference of the
    stress falls from 6 to 2 and 1 % of the effect of the block with 12, 24 and 36 cells a period.
    """
    n, length = 24, 1e-4
    size, middle = length / n, slice(n // 3, 2 * n // 3)
    voxels = np.zeros((n, n, 2 * max(thickness, bottom)), dtype=int)
    voxels[:, :, : 2 * thickness] = 1
    voxels[middle, middle, 2 * top : 2 * bottom] = 2
    corner = (-length / 2, -length / 2, 0.0)
    all_voxels = sc.Heterogeneous.voxels(SUBSTRATE, [COAT, BLOCK], voxels, size, corner)
    layered = sc.Layered([(COAT, 2 * thickness * size)], SUBSTRATE)
    first = 0 if top < thickness else 2 * thickness
    block = (voxels == 2).astype(int)[:, :, first:]
    in_layers = sc.Heterogeneous.voxels(layered, BLOCK, block, size, (*corner[:2], first * size))
    coat = sc.Heterogeneous.voxels(
        SUBSTRATE, COAT, (voxels > 0)[:, :, : 2 * thickness].astype(int), size, corner
    )
    a, b, c, d = (pressed(body, n, size) for body in (all_voxels, coat, in_layers, layered))
    other, effect = (one.stress(2) - clean.stress(2) for one, clean in ((a, b), (c, d)))
    error = other - effect
    assert np.linalg.norm(error) < 0.03 * np.linalg.norm(effect)
    inside = middle, middle, slice(2 * top, 2 * bottom)
    means = [field[(slice(None), *inside)].mean(axis=(1, 2, 3)) for field in (error, effect)]
    assert np.abs(means[0]).max() < 0.005 * np.abs(means[1]).max()
    assert np.linalg.norm(a.pressure - c.pressure) < 0.03 * np.linalg.norm(c.pressure)


def below_coating(coat, substrate, depth):
    sphere = sc.Inclusion.sphere((0.0, 0.0, depth), 4 * H, STIFF)
    return simulation(
        sc.Heterogeneous(sc.Layered([(coat, 4 * H)], substrate), [sphere]), friction=0.2
    )


def test_tractions_on_an_interface():
    """Tractions are continuous above a sphere; the stress along the interface jumps."""
    state = below_coating(sc.Material.elastic(300e9, 0.22), STEEL, 11 * H).step(load=60.0)
    above, below = state.interface_stress(2)[..., 0]
    jump = above - below
    assert np.linalg.norm(jump[2:5]) < 5e-3 * np.linalg.norm(above[2:5])
    assert np.linalg.norm(jump[:2]) > 0.2 * np.linalg.norm(above[:2])


def test_restart_with_plastic_layers(tmp_path):
    """The history is restored to every digit."""
    hard = sc.Material.linear_hardening(300e9, 0.22, 3e9, 9e9)
    soft = sc.Material.linear_hardening(210e9, 0.3, 0.6e9, 9.5e9)
    sim = below_coating(hard, soft, 9 * H)
    state = sim.step(load=60.0)
    assert state.max_equivalent_plastic_strain(2) > 0
    sim.save(tmp_path / "kept")
    again = sc.Simulation.load(tmp_path / "kept")
    assert again.body2 == sim.body2
    a, b = (one.step(load=0.0).stress(2) for one in (sim, again))
    np.testing.assert_array_equal(a, b)


def test_refusals():
    layered = sc.Layered([(COAT, 4 * H)], STEEL)
    with pytest.raises(ValueError, match=r"inclusions\[1\] must lie within one layer, got depths"):
        sc.Heterogeneous(layered, [SPHERE, sc.Inclusion.sphere((0, 0, 4 * H), 2 * H, STIFF)])
    with pytest.raises(ValueError, match="block of voxels must lie within one layer"):
        sc.Heterogeneous.voxels(layered, STIFF, np.ones((4, 4, 6), int), H, (0, 0, 0))
    with pytest.raises(ValueError, match="give the inclusions of a layered body as"):
        sc.Layered([(COAT, H)], sc.Heterogeneous(STEEL, [SPHERE]))
    touching = sc.Inclusion.sphere((0, 0, 4 * H), 4 * H, STIFF)
    body = sc.Heterogeneous(sc.Layered([(COAT, 8 * H)], RIGID), [touching])
    with pytest.raises(ValueError, match="must be elastic and free of inclusions"):
        simulation(body)
    off = sc.Heterogeneous(sc.Layered([(COAT, 8.5 * H)], STEEL), [touching])
    with pytest.raises(ValueError, match="must coincide with a boundary between layers of cells"):
        simulation(off)
    with pytest.raises(AttributeError, match="a layered matrix has no single E"):
        _ = off.E

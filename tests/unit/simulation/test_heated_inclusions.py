# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions that expand differently from a heated matrix."""

import numpy as np
import pytest

import samcontact as sc

H = 25e-6
STEEL = sc.Material.elastic(210e9, 0.3)
HOT = STEEL.with_thermal(50.0, 12e-6, 1.3e-5)
RIGID = sc.Material.rigid()


def like_hot(material, expansion):
    return material.with_thermal(50.0, expansion, 1.3e-5)


def test_uniform_temperature_is_a_misfit():
    """Long uniform heating of a periodic body acts as the misfit (alpha1 - alpha0) T."""
    grid = sc.Grid(20, 20, H, H, dz=H, periodic="xy")
    gap = np.zeros(grid.surface_shape)
    pressure = np.full(grid.surface_shape, 1e6)
    time = (4e4 * H) ** 2 / 1.3e-5
    heat = sc.Heat((0.0, 1.0), velocity=((0.0, 0.0), (0.0, 0.0)), time=time)

    def pressed(material, misfit=0.0, matrix=HOT):
        sphere = sc.Inclusion.sphere((0.0, 0.0, 5 * H), 4 * H, material, misfit=misfit)
        sim = sc.Simulation(
            grid, RIGID, sc.Heterogeneous(matrix, [sphere]), gap, friction=0.3, heat=heat, tol=1e-4
        )
        return sim.step(pressure=pressure).at_layers(12)

    stiff = sc.Material.elastic(380e9, 0.24)
    warm = pressed(like_hot(stiff, 8e-6))
    rise = warm.temperature(2)
    assert np.ptp(rise[..., :10]) < 1e-3 * rise.max()
    given = pressed(stiff, misfit=-4e-6 * rise[10, 10, 5])
    effect = given.disturbance(2)
    np.testing.assert_allclose(
        warm.disturbance(2), effect, rtol=0, atol=1e-3 * np.abs(effect).max()
    )
    assert np.abs(effect).max() > 1e-3 * 210e9 * 4e-6 * rise.max()


def heated(body, **more):
    grid = sc.Grid(21, 21, H, H, dz=H)
    heat = sc.Heat((0.0, 0.05), velocity=((0.0, 0.0), (1.0, 0.0)), **more)
    gap = sc.surfaces.paraboloid(grid, 5e-3)
    return sc.Simulation(
        grid, RIGID, body, gap, friction=0.3, heat=heat, on_border="warn", tol=1e-6
    )


def test_expansion_below_a_sliding_contact():
    """Eigenstrain (alpha1 - alpha0) T with equal moduli, and the effect of a given one."""
    inside = np.zeros((21, 21, 12), int)
    inside[6:14, 8:13, 2:7] = 1
    corner = (-10.5 * H, -10.5 * H, 0.0)
    block = sc.Heterogeneous.voxels(HOT, like_hot(STEEL, 30e-6), inside, H, corner)
    state = heated(block).step(load=60.0)
    expected = np.zeros((6, 21, 21, state.layers))
    depth = min(12, state.layers)
    rise = state.temperature(2)
    expected[:3, ..., :depth] = 18e-6 * rise[..., :depth] * inside[..., :depth]
    assert np.abs(expected).max() > 1e-4
    np.testing.assert_allclose(state.eigenstrain(2), expected, rtol=0, atol=1e-5 * expected.max())
    plain = heated(HOT)
    plain.add_eigenstrain(2, state.at_layers(12).eigenstrain(2))
    other = plain.step(load=60.0)
    scale = other.pressure.max()
    np.testing.assert_allclose(state.pressure, other.pressure, rtol=0, atol=1e-5 * scale)
    clean = heated(HOT).step(load=60.0)
    assert np.abs(clean.pressure - state.pressure).max() > 1e-3 * scale
    stress, expected = (one.at_layers(12).stress(2) for one in (state, other))
    np.testing.assert_allclose(stress, expected, rtol=0, atol=1e-5 * np.abs(expected).max())


def test_equal_expansion_and_cooling():
    """Inclusions without thermal constants expand like the matrix; without heat nothing remains."""
    oxide = sc.Material.elastic(380e9, 0.24)
    sphere = [
        sc.Heterogeneous(HOT, [sc.Inclusion.sphere((0.0, 0.0, 5 * H), 4 * H, material)])
        for material in (oxide, like_hot(oxide, 12e-6), like_hot(oxide, 8e-6))
    ]
    a, b = (heated(body).step(load=60.0).stress(2) for body in sphere[:2])
    np.testing.assert_array_equal(a, b)
    sim = heated(sphere[2])
    loaded = sim.step(load=60.0)
    assert np.abs(loaded.stress(2) - a).max() > 1e-3 * np.abs(a).max()
    assert np.abs(sim.step(load=0.0).stress(2)).max() < 1e-5 * np.abs(a).max()


def test_two_phase_cells_and_history():
    """Sliding over an oxide in yielding steel, with the heat of earlier steps."""
    yielding = like_hot(sc.Material.linear_hardening(210e9, 0.3, 0.8e9, 9.5e9), 12e-6)
    oxide = like_hot(sc.Material.elastic(380e9, 0.24), 8e-6)
    plastic = []
    for material in (oxide, like_hot(oxide, 12e-6)):
        sphere = sc.Inclusion.sphere((0.0, 0.0, 5 * H), 4 * H, material)
        sim = heated(sc.Heterogeneous(yielding, [sphere]), history=(1e-4, 1.0))
        for _ in range(3):
            state = sim.step(load=60.0, duration=1e-2)
        plastic.append(state.max_equivalent_plastic_strain(2))
        assert state.converged
    assert plastic[0] != pytest.approx(plastic[1], rel=1e-3)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Dents and furrows: shape, position on the body, and refused arguments."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import dents

GRID = sc.Grid(16, 11, 2e-5, 3e-5)
STEEL = sc.Material.elastic(210e9, 0.3)


def heights_on(relief, grid, cells):
    """Heights on the body's cells counted from the grid's first row at the start."""
    out = np.zeros((len(cells), grid.ny))
    for row, cell in enumerate(cells):
        n = cell - relief.first
        if relief.periodic:
            out[row] = relief.heights[n % len(relief.heights)]
        elif 0 <= n < len(relief.heights):
            out[row] = relief.heights[n]
    return out


@pytest.mark.parametrize(("depth", "x", "y"), [(3e-6, 0.0, 0.0), (-2e-6, 4.7e-4, 2e-5)])
def test_spherical_cap(depth, x, y):
    radius = 9e-5
    cells = np.arange(-20, 60)
    position = (cells - 7.5) * GRID.dx
    r = np.hypot(position[:, None] - x, GRID.y[None, :] - y)
    sphere = (radius**2 + depth**2) / (2 * abs(depth))
    inside = r < radius
    expected = np.zeros(r.shape)
    expected[inside] = np.sqrt(sphere**2 - r[inside] ** 2) - (sphere - abs(depth))
    expected *= -np.sign(depth)
    made = heights_on(dents.spherical(GRID, depth, radius, x, y), GRID, cells)
    assert np.count_nonzero(made) > 20
    np.testing.assert_allclose(made, expected, atol=1e-9 * abs(depth) + 1e-17)


def test_half_sphere():
    made = dents.spherical(GRID, 9e-5, 9e-5, x=GRID.dx / 2)
    assert made.heights.min() == pytest.approx(-9e-5)


def test_furrow_across():
    relief = dents.furrow(GRID, 1e-6, 5e-5, position=1e-5)
    made = heights_on(relief, GRID, np.arange(16))
    same = heights_on(dents.spherical(GRID, 1e-6, 5e-5, x=1e-5), GRID, np.arange(16))
    np.testing.assert_array_equal(made, np.repeat(same[:, 5:6], 11, axis=1))  # y = 0 in row 5


def test_furrow_along():
    made = heights_on(dents.furrow(GRID, 1e-6, 7e-5, "x", 3e-5), GRID, np.arange(-100, 100))
    assert np.ptp(made, axis=0).max() == 0.0
    assert np.argmin(made[0]) == 6
    assert made[0].min() == pytest.approx(-1e-6)


def test_a_dent_acts_at_its_position():
    """A contact that rolls to a dent equals a contact loaded there."""
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    dent = dents.spherical(GRID, 5e-8, 6e-5, x=12 * GRID.dx)
    rolling = sc.Simulation(GRID, STEEL, STEEL, gap, relief2=dent)
    rolling.step(load=0.5)
    there = rolling.step(load=0.5, advance=(-12 * GRID.dx, -12 * GRID.dx))
    loaded = sc.Simulation(GRID, STEEL, STEEL, gap, relief2=dents.spherical(GRID, 5e-8, 6e-5))
    expected = loaded.step(load=0.5)
    scale = expected.pressure.max()
    np.testing.assert_allclose(there.pressure, expected.pressure, atol=1e-5 * scale)
    without = sc.Simulation(GRID, STEEL, STEEL, gap).step(load=0.5)
    assert np.abs(without.pressure - expected.pressure).max() > 0.02 * scale


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: dents.spherical(GRID, 0.0, 1e-4), r"depth must be nonzero, .* got 0\.0"),
        (
            lambda: dents.spherical(GRID, 2e-4, 1e-4),
            "must be nonzero, of magnitude <= radius = 0.0001, got",
        ),
        (lambda: dents.spherical(GRID, 1e-6, 0.0), "radius must be a finite number > 0, got 0"),
        (lambda: dents.spherical(GRID, 1e-6, 1e-4, x=np.inf), "x must be a finite number, got inf"),
        (
            lambda: dents.furrow(GRID, 1e-3, 1e-4),
            "must be nonzero, of magnitude <= half_width = 0.0001",
        ),
        (lambda: dents.furrow(GRID, 1e-6, 1e-4, "z"), "along must be one of 'y', 'x', got 'z'"),
        (lambda: dents.furrow(GRID, 1e-6, -1.0), "half_width must be a finite number > 0, got -1"),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()

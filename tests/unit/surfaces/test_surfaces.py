# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps at known points, statistics of generated roughness, and errors."""

import math

import numpy as np
import pytest

from core_fakes import make_grid
from samcontact import surfaces


@pytest.fixture
def grid():
    return make_grid(nx=21, ny=11, dx=1e-3, dy=2e-3)


def test_paraboloid(grid):
    gap = surfaces.paraboloid(grid, 2.0, 5.0)
    assert gap.shape == (21, 11)
    assert gap[10, 5] == 0.0
    assert gap[0, 5] == pytest.approx(1e-2**2 / 4.0, rel=1e-14)
    assert gap[10, 0] == pytest.approx(1e-2**2 / 10.0, rel=1e-14)
    np.testing.assert_array_equal(surfaces.paraboloid(grid, 2.0), surfaces.paraboloid(grid, 2.0, 2))
    assert np.all(surfaces.paraboloid(grid, 2.0, math.inf)[0] == 1e-2**2 / 4.0)


def test_sphere_lies_on_a_sphere_and_tends_to_the_paraboloid(grid):
    R = 0.02
    gap = surfaces.sphere(grid, R)
    r2 = grid.x[:, None] ** 2 + grid.y[None, :] ** 2
    np.testing.assert_allclose((R - gap) ** 2 + r2, R**2, rtol=1e-14)
    flat = surfaces.sphere(grid, 1e6)
    np.testing.assert_allclose(flat, surfaces.paraboloid(grid, 1e6), rtol=1e-14)


def test_cylinder_axes(grid):
    along_y = surfaces.cylinder(grid, 0.02)
    assert along_y.shape == (21, 11)
    assert np.all(along_y == along_y[:, :1])
    np.testing.assert_allclose((0.02 - along_y[:, 0]) ** 2 + grid.x**2, 0.02**2, rtol=1e-14)
    along_x = surfaces.cylinder(grid, 0.02, axis="x")
    assert np.all(along_x == along_x[:1, :])
    assert along_x[0, 0] == pytest.approx(along_y[0, 0], rel=1e-14)  # both reach 10 mm


def test_sinusoidal_peaks_and_zeros(grid):
    rough = surfaces.sinusoidal(grid, 3e-6, 8e-3, 16e-3)
    assert rough[12, 7] == pytest.approx(3e-6, rel=1e-12)  # x = lx/4, y = ly/4
    assert rough[8, 7] == pytest.approx(-3e-6, rel=1e-12)
    assert abs(rough[14, 7]) < 1e-20
    assert np.all(np.abs(rough[10]) < 1e-20)


def test_from_heights_touches_in_one_point(grid):
    rng = np.random.default_rng(1)
    lower, upper = rng.standard_normal((2, 21, 11))
    gap = surfaces.from_heights(grid, lower, upper)
    assert gap.min() == 0.0
    np.testing.assert_allclose(np.diff(gap, axis=0), np.diff(upper - lower, axis=0), atol=1e-14)
    # a summit of the lower surface is where it touches a flat
    flat = surfaces.from_heights(grid, lower)
    assert np.unravel_index(flat.argmin(), flat.shape) == np.unravel_index(
        lower.argmax(), lower.shape
    )


def _radial_spectrum(heights, dx):
    n = heights.shape[0]
    power = np.abs(np.fft.fft2(heights)) ** 2
    q = np.hypot(*np.meshgrid(*[np.fft.fftfreq(n, dx)] * 2, indexing="ij"))
    return q, power


def test_rough_self_affine_spectrum():
    grid = make_grid(nx=256, ny=256, dx=1.0, dy=1.0)
    hurst, high, middle, low = 0.7, 128.0, 32.0, 4.0
    heights = surfaces.rough_self_affine(
        grid, 2e-6, hurst, wavelength_min=low, wavelength_max=high, roll_off=middle, seed=5
    )
    assert heights.mean() == pytest.approx(0.0, abs=1e-18)
    assert np.sqrt(np.mean(heights**2)) == pytest.approx(2e-6, rel=1e-12)
    q, power = _radial_spectrum(heights, 1.0)
    total = power.sum()
    assert power[(q > 1.001 / low) | (q < 0.999 / high)].sum() < 1e-24 * total
    # slope of the log-averaged power between roll-off and cut-off: -2 (1 + H). 40 thousand modes
    # of an exponential distribution leave a standard error below 0.03
    inside = (q > 1.01 / middle) & (q < 0.99 / low)
    slope = np.polyfit(np.log(q[inside]), np.log(power[inside]), 1)[0]
    assert slope == pytest.approx(-2 * (1 + hurst), abs=0.15)
    plateau = (q >= 1 / high) & (q <= 1 / middle)
    slope = np.polyfit(np.log(q[plateau]), np.log(power[plateau]), 1)[0]
    assert abs(slope) < 0.6  # 200 modes only


def test_rough_self_affine_is_reproducible_and_periodic(grid):
    first = surfaces.rough_self_affine(grid, 1e-6, 0.8, seed=3)
    assert np.array_equal(first, surfaces.rough_self_affine(grid, 1e-6, 0.8, seed=3))
    assert not np.array_equal(first, surfaces.rough_self_affine(grid, 1e-6, 0.8, seed=4))
    assert np.all(surfaces.rough_self_affine(grid, 0.0, 0.8, seed=3) == 0.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: surfaces.paraboloid(g, 0.0), r"Rx must be a number > 0 \(inf allowed\), got 0"),
        (lambda g: surfaces.paraboloid(g, 1.0, -2.0), "Ry must be .*got -2.0"),
        (lambda g: surfaces.sphere(g, 0.012), r"R must be >= 0\.0141421 to cover the grid.*0\.012"),
        (lambda g: surfaces.sphere(g, math.inf), "R must be a finite number > 0, got inf"),
        (lambda g: surfaces.cylinder(g, 1.0, axis="z"), "axis must be one of 'y', 'x', got 'z'"),
        (lambda g: surfaces.cylinder(g, 0.009), "R must be >= 0.01"),
        (lambda g: surfaces.sinusoidal(g, -1.0, 1.0, 1.0), "amplitude must be .* >= 0, got -1.0"),
        (lambda g: surfaces.sinusoidal(g, 1.0, 1e-3, 1.0), "wavelength_x must be >= 0.002"),
        (lambda g: surfaces.from_heights(g, np.zeros((3, 3))), r"shape \(21, 11\), got \(3, 3\)"),
        (
            lambda g: surfaces.from_heights(g, np.full((21, 11), np.nan)),
            r"heights_lower must be .* or -inf where there is no body, got nan at index \(0, 0\)",
        ),
        (lambda g: surfaces.rough_self_affine(g, 1.0, 1.2, seed=0), r"hurst must be in \[0, 1\]"),
        (
            lambda g: surfaces.rough_self_affine(g, 1.0, 0.8, wavelength_min=1e-3, seed=0),
            "wavelength_min must be >= 0.004",
        ),
        (
            lambda g: surfaces.rough_self_affine(g, 1.0, 0.8, roll_off=1.0, seed=0),
            "roll_off must be between",
        ),
        (
            lambda g: surfaces.rough_self_affine(
                g, 1.0, 0.8, wavelength_min=8.001e-3, wavelength_max=8.002e-3, seed=0
            ),
            "must have at least one",
        ),
    ],
)
def test_bad_input_is_named(grid, call, message):
    with pytest.raises(ValueError, match=message):
        call(grid)


def test_radii_that_make_the_gap_infinite_are_refused():
    grid = make_grid(nx=4, ny=4, dx=1e-6, dy=1e-6)
    with pytest.raises(ValueError, match=r"Rx and Ry must give a finite gap .* got 5e-324 and inf"):
        surfaces.paraboloid(grid, 5e-324, math.inf)

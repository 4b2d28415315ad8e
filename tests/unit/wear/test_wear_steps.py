# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear: depth of removal, smoothing of its edge, and remaining plastic strain."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact import wear
from samcontact.wear.checks import make_filter
from samcontact.wear.steps import deviator_below_worn_surface

RNG = np.random.default_rng(7)


def columns(profile, nz, dz):
    z = (np.arange(nz) + 0.5) * dz
    return profile(z)[None, None, :]


def test_depth_of_a_linear_profile_is_exact():
    field = columns(lambda z: 0.01 - 700.0 * z, 12, 1e-6)
    assert wear.depth(field, 1e-6, 0.004)[0, 0] == pytest.approx(6e-3 / 700, rel=1e-14)


def test_depth_of_an_exponential_converges():
    exact = 1e-5 * np.log(5.0)
    errors = []
    for n in (10, 20, 40, 80):
        dz = 4e-5 / n
        field = columns(lambda z: 0.01 * np.exp(-z / 1e-5), n, dz)
        errors.append(abs(wear.depth(field, dz, 0.002)[0, 0] - exact))
    assert errors[0] < 0.01 * exact
    assert errors[3] < errors[0] / 64  # of second order at least


def test_depth_lies_between_the_two_layers():
    """A plateau followed by a step causes no overshoot."""
    field = np.array([5.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0])[None, None, :]
    found = [wear.depth(field, 1.0, limit)[0, 0] for limit in (4.999, 2.5, 0.001)]
    assert 3.5 < found[0] < found[1] < found[2] < 4.5
    assert found[1] == pytest.approx(4.0, abs=1e-12)


def test_depth_only_from_the_surface_down():
    field = np.zeros((3, 1, 6))
    field[0, 0] = [1, 3, 3, 1, 0, 0]  # below the surface only
    field[1, 0] = [3, 1, 3, 3, 0, 0]  # the second zone is not connected
    field[2, 0] = [2, 0, 0, 0, 0, 0]  # at the threshold, not beyond
    found = wear.depth(field, 1.0, 2.0)[:, 0]
    assert found[0] == 0
    assert found[2] == 0
    assert 0.5 < found[1] < 1.5


@pytest.mark.parametrize(("window", "order"), [(5, 2), ((7, 3), 1), (9, 4), ((1, 5), 2)])
def test_smoothing_keeps_the_volume(window, order):
    given = np.zeros((20, 18))
    given[6:15, 5:11] = RNG.uniform(0, 3e-6, (9, 6))
    given[0, 0] = 2e-6  # at the border of the array
    made = wear.smooth(given, window, order)
    assert made.min() >= 0
    assert np.abs(made - given).max() > 1e-7
    assert made.sum() == pytest.approx(given.sum(), rel=1e-14)


def test_smoothing_fits_a_polynomial_in_each_window():
    """Comparison with a least-squares fit of x^m y^n, m and n up to the order, about one cell."""
    given = 10 + RNG.uniform(0, 1, (15, 13))
    made = wear.smooth(given, (5, 7), 2)
    x, y = (a.ravel() for a in np.meshgrid(np.arange(-2, 3), np.arange(-3, 4), indexing="ij"))
    terms = np.stack([x**m * y**n for m in range(3) for n in range(3)], axis=1)
    fitted = np.linalg.lstsq(terms.astype(float), given[5:10, 3:10].ravel(), rcond=None)[0][0]
    other = np.linalg.lstsq(terms.astype(float), given[6:11, 4:11].ravel(), rcond=None)[0][0]
    # up to the factor that restores the volume, which is lost beyond the array here
    assert made[7, 6] / made[8, 7] == pytest.approx(fitted / other, rel=1e-12)


def test_smoothing_reproduces_polynomials_inside():
    x, y = np.meshgrid(np.arange(30.0), np.arange(26.0), indexing="ij")
    surface = 50 + x + 0.1 * (x - 12) ** 2 + 0.05 * (y - 9) ** 2
    given = np.zeros((40, 36))
    given[5:35, 5:31] = surface
    made = wear.smooth(given, 5, 2)[7:33, 7:29]
    ratio = made / surface[2:28, 2:24]
    np.testing.assert_allclose(ratio, ratio[0, 0], rtol=1e-12)


@pytest.mark.parametrize("window", [None, 1, (1, 1)])
def test_no_smoothing(window):
    given = RNG.uniform(0, 1, (6, 5))
    np.testing.assert_array_equal(wear.smooth(given, window, 0), given)


def test_shift_by_whole_layers():
    field = RNG.normal(size=(6, 4, 3, 9))
    layers = RNG.integers(0, 11, (4, 3))
    made = wear.below_worn_surface(field, layers * 2.0, 2.0)
    for i, j in np.ndindex(4, 3):
        n = min(int(layers[i, j]), 9)
        expected = np.concatenate([field[:, i, j, n:], np.zeros((6, n))], axis=1)
        np.testing.assert_allclose(made[:, i, j], expected, atol=1e-14)


def test_shift_between_layers():
    z = (np.arange(60) + 0.5) * 0.1
    field = np.broadcast_to(np.exp(-z), (2, 1, 60))
    made = wear.below_worn_surface(field, np.array([[0.234], [0.0]]), 0.1)
    np.testing.assert_allclose(made[0, 0, :50], np.exp(-z - 0.234)[:50], rtol=2e-3)
    np.testing.assert_array_equal(made[1], field[1])


def test_shift_does_not_overshoot():
    field = RNG.uniform(0, 1, (5, 4, 12)) ** 8
    made = wear.below_worn_surface(field, RNG.uniform(0, 6, (5, 4)), 1.0)
    assert made.min() >= -1e-15
    assert (made.max(axis=2) <= field.max(axis=2) + 1e-15).all()


def test_shifted_deviators_stay_deviators():
    field = RNG.normal(size=(6, 3, 2, 8))
    field[2] = -field[0] - field[1]
    field[0, 2, 1] += 1.0  # one column is no deviator
    removed = np.array([[0.3, 0.0], [1.7, 2.2], [0.4, 0.6]])
    made = deviator_below_worn_surface(field, removed, 1.0)
    trace = made[:3].sum(axis=0)
    assert np.abs(trace[:2]).max() < 1e-14
    np.testing.assert_allclose(made[:, 2, 1], wear.below_worn_surface(field, removed, 1.0)[:, 2, 1])
    assert np.abs(wear.below_worn_surface(field, removed, 1.0)[:3, :2].sum(axis=0)).max() > 1e-3


def test_strain_to_the_bottom():
    with pytest.raises(
        ValueError, match=r"grid must be deeper than the worn layer.* threshold = 0\.5"
    ):
        wear.depth(np.ones((2, 2, 3)), 1e-6, 0.5)


def test_bad_fields():
    with pytest.raises(ValueError, match="depth must be >= 0 everywhere, got -1"):
        wear.smooth(-np.ones((7, 7)))
    with pytest.raises(ValueError, match="depth must be >= 0 everywhere, got -1"):
        wear.below_worn_surface(np.ones((7, 7, 2)), -np.ones((7, 7)), 1.0)
    with pytest.raises(ValueError, match=r"equivalent must have shape \(nx, ny, nz\)"):
        wear.depth(np.ones((7, 7)), 1.0, 0.1)


def test_the_width_of_a_gaussian_is_independent_of_the_cells():
    """Volume and standard deviation in metres of the smoothed loss of one cell."""
    length = 7e-6
    for dx, dy in ((2e-6, 3e-6), (1e-6, 0.7e-6)):
        made = np.zeros((91, 131))
        made[40, 60] = 3e-7
        filter_ = make_filter(sc.Grid(91, 131, dx, dy), length, None, None)
        spread = filter_(made)
        assert spread.min() >= 0
        assert math.fsum(spread.flat) == math.fsum(made.flat)
        for axis, cell in enumerate((dx, dy)):
            along = spread.sum(axis=1 - axis) / spread.sum()
            x = cell * (np.arange(len(along)) - (40, 60)[axis])
            assert np.sqrt(np.sum(along * x**2)) == pytest.approx(length, rel=2e-3)
            reach = np.flatnonzero(along)
            assert 6 * length < (reach[-1] - reach[0] + 1) * cell
            assert reach[-1] - reach[0] + 1 <= filter_.sides[axis]


def test_a_gaussian_of_zero_is_zero():
    filter_ = make_filter(sc.Grid(9, 9, 1e-6, 1e-6), 2e-6, None, None)
    np.testing.assert_array_equal(filter_(np.zeros((9, 9))), np.zeros((9, 9)))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Weibull distributions of lives, and the largest inclusion of a volume."""

import math

import numpy as np
import pytest
from scipy import stats

import samcontact as sc

RANDOM = np.random.default_rng(5)
LIVES = 1e7 * RANDOM.weibull(1.3, size=12)
MAXIMA = 2e-5 + 5e-6 * RANDOM.gumbel(size=24)
A0 = 150e-6


def test_the_fit_maximises_the_likelihood():
    fit = sc.inclusions.weibull_fit(LIVES)
    shape, _, scale = stats.weibull_min.fit(LIVES, floc=0)
    best = stats.weibull_min.logpdf(LIVES, fit.shape, scale=fit.scale).sum()
    assert best >= stats.weibull_min.logpdf(LIVES, shape, scale=scale).sum() - 1e-9
    assert (fit.shape, fit.scale) == pytest.approx((shape, scale), rel=1e-3)
    expected = stats.weibull_min.ppf(0.1, fit.shape, scale=fit.scale)
    assert fit.life() == pytest.approx(expected, rel=1e-12)
    assert fit.median_ranks[[0, -1]] == pytest.approx([0.7 / 12.4, 11.7 / 12.4])


def test_the_pivots_have_the_published_mean():
    """Thoman, Bain and Antle (1969): the estimated shape of n lives is 1/B(n) times too large."""
    for count, factor in ((10, 0.859), (20, 0.931), (40, 0.966)):
        lives = np.exp(np.linspace(0, 1, count))
        fit = sc.inclusions.weibull_fit(lives)
        low, high = fit.shape_interval(0.9)
        pivots = fit._pivots[0]
        assert 1 / pivots.mean() == pytest.approx(factor, abs=0.012)
        assert low < fit.shape < high


def test_confidence_intervals_cover_the_truth():
    """90 % of 300 samples of 8 lives, within the binomial error."""
    hits = np.zeros(2)
    first = None
    for n in range(300):
        lives = np.random.default_rng(n).weibull(1.5, size=8)
        fit = sc.inclusions.weibull_fit(lives)
        if first is None:
            first = fit._pivots
        fit.__dict__["_pivots"] = first  # they depend on the number of lives only
        low, high = fit.shape_interval()
        hits[0] += low <= 1.5 <= high
        low, high = fit.life_interval()
        hits[1] += low <= (-math.log(0.9)) ** (1 / 1.5) <= high
    assert hits / 300 == pytest.approx(np.array([0.9, 0.9]), abs=0.05)


def test_the_fit_scales_with_the_unit_of_lives():
    fit, scaled = sc.inclusions.weibull_fit(LIVES), sc.inclusions.weibull_fit(LIVES / 3600)
    assert scaled.shape == pytest.approx(fit.shape, rel=1e-10)
    assert scaled.life(0.5) == pytest.approx(fit.life(0.5) / 3600, rel=1e-10)
    assert "L10" in fit._repr_html_()


def test_the_largest_inclusion_is_a_gumbel_distribution():
    largest = sc.inclusions.LargestInclusion.fit(MAXIMA, A0)
    location, scale = stats.gumbel_r.fit(MAXIMA)
    assert (largest.location, largest.scale) == pytest.approx((location, scale), rel=1e-4)
    volume = 1e4 * A0 * largest.mean
    assert largest.return_period(volume) == pytest.approx(1e4)
    expected = stats.gumbel_r.ppf(1 - 1e-4, largest.location, largest.scale)
    assert largest.expected_in(volume) == pytest.approx(expected, rel=1e-12)
    low, high = largest.interval(volume)
    assert low < expected < high
    drawn = largest.draw(volume, 20_000, seed=1) * math.sqrt(math.pi)
    size = stats.gumbel_r(largest.location + largest.scale * math.log(1e4), largest.scale)
    assert drawn.mean() == pytest.approx(size.mean(), rel=5e-3)
    assert drawn.std() == pytest.approx(size.std(), rel=3e-2)
    np.testing.assert_array_equal(largest.draw(volume, 3, 1), largest.draw(volume, 3, 1))


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (
            lambda: sc.inclusions.weibull_fit([1.0, 2.0]),
            "lives must be a list of at least 3 numbers",
        ),
        (lambda: sc.inclusions.weibull_fit([0.0, 2.0, 3.0]), "lives must be > 0"),
        (lambda: sc.inclusions.weibull_fit([2.0, 2.0, 2.0]), "lives must not all be equal"),
        (lambda: sc.inclusions.weibull_fit(LIVES).life(10.0), r"failed must be in \(0, 1\)"),
        (
            lambda: sc.inclusions.weibull_fit(LIVES).shape_interval(95.0),
            r"confidence must be in \(0, 1\)",
        ),
        (
            lambda: sc.inclusions.LargestInclusion.fit([1e-5] * 3, A0),
            "maxima must be a list of at least 6",
        ),
        (lambda: sc.inclusions.LargestInclusion.fit([1e-5] * 8, A0), "maxima must be > 0 and not"),
        (
            lambda: sc.inclusions.LargestInclusion.fit(MAXIMA, A0).expected_in(1e-12),
            "volume must exceed .* the volume that one inspected area represents",
        ),
        (
            lambda: sc.inclusions.LargestInclusion(2e-5, 5e-6, A0).interval(1.0),
            "fields, the number of maxima, must be > 0",
        ),
    ],
)
def test_invalid_arguments_are_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()

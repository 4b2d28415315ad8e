# SPDX-License-Identifier: GPL-3.0-or-later
"""Weibull distributions of lives in tests or random microstructures, with confidence limits.

The confidence limits are exact. They follow from the quantities b*/b and b* ln(x*/x), where b is
the shape, x a quantile, and * marks estimates. The distributions of both quantities depend only on
the number of lives (Thoman, Bain and Antle, 1969, doi:10.1080/00401706.1969.10490706). They are
found by simulation.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, finite_array, number
from .._util.display import HtmlTable, Rows, ShortRepr

MIN_LIVES = 3
_SAMPLES = 10_000  # simulated distributions
_SEED = 20090117
_STEPS = 100  # of Newton's iteration


@dataclass(frozen=True, repr=False, eq=False)
class WeibullFit(ShortRepr, HtmlTable):
    """Two-parameter Weibull distribution of lives, as fitted by `weibull_fit`.

    Attributes
    ----------
    shape : float
        Weibull slope [-].
    scale : float
        Life at which a fraction of 63.2 % has failed, in the unit of the lives.
    lives : ndarray, shape (n,)
        Lives in increasing order.
    """

    shape: float
    scale: float
    lives: FloatArray

    def life(self, failed: float = 0.1) -> float:
        """Life at which the fraction `failed`, in (0, 1), has failed; 0.1 gives the life L10."""
        return float(self.scale * (-math.log1p(-_share("failed", failed))) ** (1 / self.shape))

    @cached_property
    def median_ranks(self) -> FloatArray:
        """Failed fraction at life i of n, by Benard's formula (i - 0.3)/(n + 0.4)."""
        n = len(self.lives)
        return np.asarray((np.arange(1, n + 1) - 0.3) / (n + 0.4))

    @cached_property
    def _pivots(self) -> tuple[FloatArray, FloatArray]:
        random = np.random.default_rng(_SEED)
        logs = np.log(random.standard_exponential((_SAMPLES, len(self.lives))))
        return _fitted(logs)

    def shape_interval(self, confidence: float = 0.9) -> tuple[float, float]:
        """Confidence interval of the shape; confidence in (0, 1). Default: 0.9."""
        low, high = np.quantile(self._pivots[0], _tails(confidence))
        return float(self.shape / high), float(self.shape / low)

    def life_interval(self, failed: float = 0.1, confidence: float = 0.9) -> tuple[float, float]:
        """Confidence interval of the life at which the fraction `failed` has failed, see `life`."""
        risk = math.log(-math.log1p(-_share("failed", failed)))
        shape, log_scale = self._pivots
        pivot = shape * log_scale + risk  # shape times log(estimated/true quantile), true shape 1
        low, high = np.quantile(pivot - shape * risk, _tails(confidence))
        here = self.life(failed)
        return float(here * math.exp(-high / self.shape)), float(here * math.exp(-low / self.shape))

    def _rows(self) -> Rows:
        low, high = self.shape_interval()
        first, last = self.life_interval()
        return [
            ("lives", str(len(self.lives))),
            ("slope", f"{self.shape:.3g} (90 %: {low:.3g} to {high:.3g})"),
            ("L10", f"{self.life():.4g} (90 %: {first:.4g} to {last:.4g})"),
            ("L50", f"{self.life(0.5):.4g}"),
        ]


def _share(name: str, value: float) -> float:
    share = number(name, value)
    if not 0.0 < share < 1.0:
        raise ValueError(f"{name} must be in (0, 1), got {share!r}: use a fraction, not per cent")
    return share


def _tails(confidence: float) -> tuple[float, float]:
    rest = 1.0 - _share("confidence", confidence)
    return rest / 2, 1 - rest / 2


def weibull_fit(lives: ArrayLike) -> WeibullFit:
    """Fit a Weibull distribution to lives by maximum likelihood.

    Parameters
    ----------
    lives : array_like, shape (n,)
        At least three lives in any unit, > 0 and not all equal. Each life must end with a failure;
        tests stopped before failure are not supported. Example: the lives of random microstructures
        with different seeds, all under the same load.

    Returns
    -------
    WeibullFit

    Raises
    ------
    ValueError
        There are too few lives, they are not positive, or all are equal.
    TypeError
        A life is not a number.
    """
    given = finite_array("lives", lives)
    if given.ndim != 1 or given.size < MIN_LIVES:
        raise ValueError(
            f"lives must be a list of at least {MIN_LIVES} numbers, got shape {given.shape}"
        )
    given = np.sort(given)
    if given[0] <= 0.0:
        raise ValueError(f"lives must be > 0, got {given[0]!r}")
    if given[-1] <= given[0] * (1 + 1e-9):
        raise ValueError(f"lives must not all be equal, got {given.size} times {given[0]!r}")
    shape, log_scale = _fitted(np.log(given)[None])
    given.flags.writeable = False
    return WeibullFit(float(shape[0]), float(np.exp(log_scale[0])), given)


def _fitted(logs: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Fit Weibull shapes and logarithms of scales to samples of lives, by Newton's method.

    logs: logarithms of lives, shape (samples, n); each sample is fitted separately.
    """
    middle = logs.mean(axis=1, keepdims=True)
    x = logs - middle
    shape = np.pi / np.sqrt(6) / x.std(axis=1, ddof=1)
    for _ in range(_STEPS):
        power = np.exp(shape[:, None] * (x - x.max(axis=1, keepdims=True)))
        total = power.sum(axis=1)
        first = (power * x).sum(axis=1) / total
        second = (power * x * x).sum(axis=1) / total
        step = (first - 1 / shape) / (second - first**2 + 1 / shape**2)
        shape = np.maximum(shape - step, shape / 2)
        if np.abs(step / shape).max() < 1e-12:
            break
    peak = x.max(axis=1)
    power = np.exp(shape[:, None] * (x - peak[:, None])).mean(axis=1)
    return shape, middle[:, 0] + peak + np.log(power) / shape

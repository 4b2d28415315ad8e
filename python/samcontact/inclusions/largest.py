# SPDX-License-Identifier: GPL-3.0-or-later
"""Largest inclusion in a volume of steel, by statistics of extreme values.

The sizes of the largest inclusions in equal inspected areas follow a Gumbel distribution (Murakami,
2019, *Metal Fatigue*, 2nd edition, chapter 6; ASTM E2283).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, integer, positive
from .._util.display import HtmlTable, Rows, quantity

MIN_AREAS = 6
_EULER = 0.5772156649015329


@dataclass(frozen=True)
class LargestInclusion(HtmlTable):
    """Gumbel distribution of the size of the largest inclusion.

    The size of an inclusion is the square root of its area in a section. Create the distribution
    with `LargestInclusion.fit` from measured maxima.

    Parameters
    ----------
    location, scale : float
        Constants > 0 of the Gumbel distribution of the size of the largest inclusion in one
        inspected area [m].
    area : float
        Area that was inspected for each maximum [m^2], > 0.
    fields : int, optional
        Number of measured maxima, which `interval` needs; 0 if unknown.

    Raises
    ------
    ValueError
        A value is outside its range.
    TypeError
        A value is not a number.
    """

    location: float
    scale: float
    area: float
    fields: int = 0

    def __post_init__(self) -> None:
        for name in ("location", "scale", "area"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        integer("fields", self.fields, 0)

    @classmethod
    def fit(cls, maxima: ArrayLike, area: float) -> LargestInclusion:
        """Fit the distribution to measured maxima by maximum likelihood.

        Parameters
        ----------
        maxima : array_like, shape (n,)
            Square root of the area of the largest inclusion in each of n >= 6 inspected areas [m].
        area : float
            Size of each inspected area [m^2], e.g. 150e-6 according to ASTM E2283.

        Returns
        -------
        LargestInclusion

        Raises
        ------
        ValueError
            There are too few maxima, they are not positive, or all are equal.
        TypeError
            A value is not a number.
        """
        x = finite_array("maxima", maxima)
        if x.ndim != 1 or x.size < MIN_AREAS:
            raise ValueError(
                f"maxima must be a list of at least {MIN_AREAS} numbers, got shape {x.shape}"
            )
        if x.min() <= 0.0 or np.ptp(x) <= 1e-9 * x.max():
            raise ValueError(
                f"maxima must be > 0 and not all equal, got {x.min():g} to {x.max():g} m"
            )
        low = float(x.min())
        spread = x - low
        scale = float(x.std(ddof=1) * math.sqrt(6) / math.pi)
        for _ in range(100):  # Newton: mean - weighted mean = scale
            weight = np.exp(-spread / scale)
            total = weight.sum()
            first = float((weight * spread).sum() / total)
            second = float((weight * spread**2).sum() / total)
            value = spread.mean() - first - scale
            slope = -(second - first**2) / scale**2 - 1
            step = value / slope
            scale = max(scale - step, scale / 2)
            if abs(step) < 1e-13 * scale:
                break
        location = low - scale * math.log(float(np.exp(-spread / scale).mean()))
        return cls(location, scale, area, x.size)

    @property
    def mean(self) -> float:
        """Mean of sqrt(area) of the largest inclusion in one inspected area [m]."""
        return self.location + _EULER * self.scale

    def return_period(self, volume: float) -> float:
        """Number of inspected areas that are equivalent to a volume [m^3] of steel.

        One inspected area represents a volume equal to this area times `mean` (Murakami). Raises
        ValueError unless `volume` is larger.
        """
        periods = positive("volume", volume) / (self.area * self.mean)
        if periods <= 1.0:
            raise ValueError(
                f"volume must exceed {self.area * self.mean:.3g} m^3, the volume that one "
                f"inspected area represents, got {volume!r} m^3"
            )
        return periods

    def expected_in(self, volume: float) -> float:
        """Expected size of the largest inclusion in a volume [m^3] of steel: sqrt(area) [m]."""
        return self.location + self.scale * self._reduced(volume)

    def _reduced(self, volume: float) -> float:
        return -math.log(-math.log1p(-1.0 / self.return_period(volume)))

    def interval(self, volume: float) -> tuple[float, float]:
        """Confidence interval (about 95 %, ASTM E2283) of `expected_in` [m] for a volume [m^3]."""
        if self.fields == 0:
            raise ValueError(
                "fields, the number of maxima, must be > 0 for an interval, got 0: use "
                "LargestInclusion.fit"
            )
        y = self._reduced(volume)
        error = self.scale * math.sqrt((1.109 + 0.514 * y + 0.608 * y * y) / self.fields)
        middle = self.expected_in(volume)
        return middle - 2 * error, middle + 2 * error

    def draw(self, volume: float, count: int, seed: int) -> FloatArray:
        """Draw random radii of spheres that represent the largest inclusion in a volume.

        Parameters
        ----------
        volume : float
            Volume of steel under stress [m^3].
        count : int
            Number of draws, >= 1.
        seed : int
            Seed of the random numbers, >= 0.

        Returns
        -------
        ndarray, shape (count,)
            Radii [m] of the spheres whose central sections have the drawn areas: sqrt(area/pi).

        Raises
        ------
        ValueError
            A value is outside its range, or the volume is less than the volume that one inspected
            area represents.
        TypeError
            A value is not a number.
        """
        random = np.random.default_rng(integer("seed", seed, 0))
        periods = self.return_period(volume)
        share = random.uniform(size=integer("count", count, 1))
        size = self.location - self.scale * np.log(-np.log(share) / periods)
        return np.asarray(np.maximum(size, 0.0) / math.sqrt(math.pi))

    def _rows(self) -> Rows:
        return [
            ("location", quantity(self.location, "m")),
            ("scale", quantity(self.scale, "m")),
            ("inspected area", quantity(self.area, "m²")),
            ("maxima", str(self.fields) if self.fields else "unknown"),
        ]

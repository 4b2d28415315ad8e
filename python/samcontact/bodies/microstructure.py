# SPDX-License-Identifier: GPL-3.0-or-later
"""Random microstructures of spherical inclusions.

The number of inclusions has a Poisson distribution, whose mean follows from the volume fraction.
The radii are lognormal. Inclusions are placed in order of decreasing radius, each at a random
position that is free (random sequential addition). Clusters form a Neyman-Scott process: the
cluster centres (parents) are at random positions, and the coordinates of the inclusions are
normally distributed about the centre of their cluster.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import (
    FloatArray,
    finite_array,
    integer,
    non_negative,
    number,
    positive,
    real_array,
)
from .._util.short_text import in_short
from .inclusion import Inclusion, checked_phase
from .material import Material

MAX_FRACTION = 0.3
"""Largest volume fraction for which random sequential addition finds room."""
MAX_INCLUSIONS = 100_000
"""Largest expected number of inclusions in one body."""
MAX_SPREAD = 2.0
"""Largest standard deviation of ln(radius)."""
_TRIES = 2000  # for the place of one inclusion


class RandomSpheres(NamedTuple):
    """Checked arguments of a random microstructure, see `Heterogeneous.random`."""

    fraction: float
    median: float
    spread: float
    limits: tuple[float, float]
    box: FloatArray
    gap: float
    cover: float
    cluster: tuple[float, float] | None

    @property
    def mean_volume(self) -> float:
        """Expected volume of one inclusion [m^3]."""
        return 4 / 3 * math.pi * _mean_cube(self.median, self.spread, self.limits)

    @property
    def expected_number(self) -> float:
        """Expected number of inclusions with their centres in the box."""
        return self.fraction * float(np.ptp(self.box, axis=1).prod()) / self.mean_volume

    def drawn(self, seed: int) -> FloatArray:
        """Draw centres and radii [m], shape (n, 4): x, y, z, r, the largest radius first.

        Raises ValueError if no inclusion is drawn, or if no free position is found for one.
        """
        random = np.random.default_rng(seed)
        count = int(random.poisson(self.expected_number))
        if count == 0:
            raise ValueError(
                f"fraction must give at least one inclusion in the box, got none with seed {seed} "
                f"and an expected number of {self.expected_number:.3g}: use a larger box, or draw "
                "the largest inclusion with samcontact.inclusions.LargestInclusion"
            )
        radii = self.median * np.exp(self.spread * random.normal(size=count))
        radii = np.sort(np.clip(radii, *self.limits))[::-1]
        places = self._places(random, count)
        found = np.empty((0, 4))
        for radius in radii:
            center = self._free_place(random, places, found, radius)
            if center is None:
                raise ValueError(
                    f"fraction must leave room for all inclusions, got {self.fraction!r}: only "
                    f"{len(found)} of {count} were placed before one of radius {radius:.3g} m "
                    "found no room; use a smaller fraction, gap or cover, or a larger box"
                )
            found = np.vstack([found, [*center, radius]])
        return found

    def _places(self, random: np.random.Generator, count: int) -> FloatArray | None:
        """Centres of the clusters [m], shape (n, 3); None without clusters."""
        if self.cluster is None:
            return None
        parents = max(int(random.poisson(count / self.cluster[0])), 1)
        return random.uniform(self.box[:, 0], self.box[:, 1], size=(parents, 3))

    def _free_place(
        self, random: np.random.Generator, parents: FloatArray | None, found: FloatArray, r: float
    ) -> FloatArray | None:
        low, high = self.box.T
        for _ in range(_TRIES):
            if parents is None or self.cluster is None:
                center = random.uniform(low, high)
            else:
                parent = parents[random.integers(len(parents))]
                center = parent + self.cluster[1] * random.normal(size=3)
                if ((center < low) | (center > high)).any():
                    continue
            if center[2] - r < self.cover:
                continue
            distance = np.sqrt(((found[:, :3] - center) ** 2).sum(axis=1))
            if (distance >= (found[:, 3] + r) * (1 + self.gap / 2)).all():
                return np.asarray(center)
        return None


def _mean_cube(median: float, spread: float, limits: tuple[float, float]) -> float:
    """Mean of the third power of a lognormal radius that is clipped to limits [m^3]."""
    if spread == 0.0:
        return float(np.clip(median, *limits)) ** 3
    low, high = (
        math.log(limit / median) / spread if 0.0 < limit < math.inf else limit_at_infinity
        for limit, limit_at_infinity in zip(limits, (-math.inf, math.inf), strict=True)
    )
    inner = median**3 * math.exp(4.5 * spread**2)
    mean = inner * (_normal(high - 3 * spread) - _normal(low - 3 * spread))
    if limits[0] > 0.0:
        mean += limits[0] ** 3 * _normal(low)
    if limits[1] < math.inf:
        mean += limits[1] ** 3 * _normal(-high)
    return mean


def _normal(x: float) -> float:
    """Cumulative normal distribution."""
    return 0.5 * math.erfc(-x / math.sqrt(2))


def checked_box(name: str, box: ArrayLike) -> FloatArray:
    """Return the checked limits ((x0, x1), (y0, y1), (z0, z1)) of a box [m] as an array."""
    ends = finite_array(name, box, (3, 2))
    if not (ends[:, 0] < ends[:, 1]).all():
        raise ValueError(
            f"{name} must have lower limits below the upper limits along x, y and z, got "
            f"{ends.tolist()}"
        )
    if ends[2, 0] < 0.0:
        raise ValueError(f"{name} must begin at a depth z >= 0, got {ends[2, 0]!r} m")
    return ends


def _pair(name: str, parts: str, value: Any) -> tuple[float, float]:
    given = finite_array(name, value)
    if given.shape != (2,):
        raise ValueError(f"{name} must be a pair ({parts}), got {in_short(value)}")
    return float(given[0]), float(given[1])


def checked_microstructure(
    fraction: float,
    radius: float | Sequence[float],
    box: ArrayLike,
    gap: float,
    cover: float,
    radius_limits: Sequence[float] | None,
    cluster: Sequence[float] | None,
) -> RandomSpheres:
    """Check the arguments of `Heterogeneous.random`."""
    share = positive("fraction", fraction)
    if share > MAX_FRACTION:
        raise ValueError(
            f"fraction must be at most {MAX_FRACTION:g}, got {share!r}: it is a volume "
            "fraction, not a percentage"
        )
    given_radius = real_array("radius", radius)
    if given_radius.ndim == 0:
        median, spread = number("radius", radius), 0.0
    else:
        median, spread = _pair("radius", "median [m], standard deviation of ln(radius)", radius)
    median, spread = positive("radius", median), non_negative("spread of radius", spread)
    if spread > MAX_SPREAD:
        raise ValueError(
            f"spread of radius must be at most {MAX_SPREAD:g}, got {spread!r}: it is the standard "
            "deviation of ln(radius), without unit"
        )
    limits = (0.0, math.inf)
    if radius_limits is not None:
        limits = _pair("radius_limits", "minimum, maximum [m]", radius_limits)
        non_negative("radius_limits", limits[0])
        if not limits[0] <= median <= limits[1]:
            raise ValueError(
                f"radius_limits must enclose the median radius {median!r} m, got {limits!r}"
            )
    clusters = None
    if cluster is not None:
        members, distance = _pair("cluster", "mean number of inclusions, distance [m]", cluster)
        clusters = positive("members of cluster", members), positive("distance", distance)
    given = RandomSpheres(
        share, median, spread, limits, checked_box("box", box), non_negative("gap", gap),
        non_negative("cover", cover), clusters,
    )  # fmt: skip
    if given.expected_number > MAX_INCLUSIONS:
        raise ValueError(
            f"fraction must give at most {MAX_INCLUSIONS} inclusions, got about "
            f"{given.expected_number:.3g}: use a smaller fraction or box, or a larger radius"
        )
    return given


def random_inclusions(
    material: Material | None,
    fraction: float,
    radius: float | Sequence[float],
    box: ArrayLike,
    seed: int,
    gap: float,
    cover: float,
    *,
    misfit: ArrayLike,
    radius_limits: Sequence[float] | None,
    cluster: Sequence[float] | None,
) -> list[Inclusion]:
    """Draw random spherical inclusions, see `Heterogeneous.random`."""
    checked_phase("material", material)
    description = checked_microstructure(fraction, radius, box, gap, cover, radius_limits, cluster)
    spheres = description.drawn(integer("seed", seed, 0))
    return [Inclusion(place[:3], (place[3],) * 3, None, material, misfit) for place in spheres]

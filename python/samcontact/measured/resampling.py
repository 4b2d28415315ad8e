# SPDX-License-Identifier: GPL-3.0-or-later
"""Evaluation of measured heights between samples: splines, cell averages, extrapolation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .._util.checks import FloatArray, boolean, choice, number
from .._util.lazy_scipy import scipy

_SPLINE_DECAY_SAMPLES = (
    24  # samples over which the effect of the ends of a cubic spline decays to rounding
)


@dataclass(frozen=True, eq=False)
class Sampling:
    """Options for the evaluation of heights.

    method, average, fill: as in `MeasuredSurface.on`. periodic: axes along which the measured area
    is periodic. edgeless: whether `fill` may be -inf, which means that the body ends at the edge of
    the measured area.
    """

    method: str = "cubic"
    average: bool = False
    fill: float | None = None
    periodic: str = ""
    edgeless: bool = False

    def __post_init__(self) -> None:
        boolean("average", self.average)
        choice("method", self.method, ("cubic", "linear"))
        choice("periodic", self.periodic, ("", "x", "y", "xy"))
        if self.fill is None:
            return
        fill = number("fill", self.fill)
        if not (np.isfinite(fill) or (self.edgeless and fill == -np.inf)):
            allowed = "a finite number, or -inf (no body)" if self.edgeless else "a finite number"
            raise ValueError(f"fill must be {allowed}, got {fill!r}")


def resampled(
    heights: FloatArray,
    steps: tuple[float, float],
    points: tuple[FloatArray, FloatArray],
    cell: tuple[float, float],
    sampling: Sampling,
) -> FloatArray:
    """Return the heights [m] at all combinations of the given x and y, shape (len(x), len(y)).

    heights: shape (nx, ny), all defined; a profile (ny = 1) applies at every y. points: x and y [m]
    from the centre of the measured area. cell: cell lengths along x and y [m]. Raises ValueError if
    points lie outside the measured area and `fill` is None.
    """
    is_profile = heights.shape[1] == 1
    axes, orders, parts, inside = [], [], [], []
    for axis, (p, length, step) in enumerate(zip(points, cell, steps, strict=True)):
        repeats = "xy"[axis] in sampling.periodic or (axis == 1 and is_profile)
        n = heights.shape[axis]
        edge = 0.5 * length if sampling.average else 0.0
        inside.append(
            np.ones(p.size, dtype=bool) if repeats else _inside(p, axis, n * step, edge, sampling)
        )
        wide = _SPLINE_DECAY_SAMPLES if repeats else 0
        heights = np.pad(heights, [(wide, wide) if a == axis else (0, 0) for a in (0, 1)], "wrap")
        at = (np.arange(n + 2 * wide) - 0.5 * (n + 2 * wide - 1)) * step
        within = _parts(p, length, step) if sampling.average else p[:, None]
        if repeats:
            within = within - n * step * np.round(within / (n * step))
        axes.append(at)
        orders.append(min({"cubic": 3, "linear": 1}[sampling.method], len(at) - 1))
        # up to half a step beyond the outermost samples, their height is used
        parts.append(np.clip(within, at[0], at[-1]))
    spline = scipy.interpolate.RectBivariateSpline(*axes, heights, kx=orders[0], ky=orders[1], s=0)
    found = np.zeros((points[0].size, points[1].size))
    for part_x in parts[0].T:
        rows, back_x = np.unique(part_x, return_inverse=True)
        for part_y in parts[1].T:
            columns, back_y = np.unique(part_y, return_inverse=True)
            found += spline(rows, columns)[np.ix_(back_x, back_y)]
    found /= parts[0].shape[1] * parts[1].shape[1]
    if sampling.fill is not None:
        found[~(inside[0][:, None] & inside[1][None, :])] = sampling.fill
    return found


def _inside(positions: FloatArray, axis: int, size: float, edge: float, sampling: Sampling) -> Any:
    """Return whether both ends of each cell, position +- edge [m], lie in the measured area.

    Raises ValueError for a position outside this area if `fill` is None.
    """
    half = 0.5 * size
    inside = np.abs(positions) + edge <= half * (1.0 + 1e-9)
    if sampling.fill is None and not inside.all():
        raise ValueError(
            f"grid must lie inside the measured area, {-half:.6g} to {half:.6g} m along "
            f"{'xy'[axis]} from the centre of this area, but the cells of the grid extend from "
            f"{positions.min() - edge:.6g} to {positions.max() + edge:.6g} m: reduce the grid, or "
            "set fill, the height outside the area"
        )
    return inside


def _parts(positions: FloatArray, cell: float, step: float) -> FloatArray:
    """Return the centres of equal parts of each cell, each at most one sample spacing long."""
    count = max(1, int(np.ceil(cell / step - 1e-9)))
    return np.asarray(positions[:, None] + ((np.arange(count) + 0.5) / count - 0.5) * cell)

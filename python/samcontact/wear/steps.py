# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps of wear: removed depth, smoothing of this depth, and the remaining plastic strain."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, integer, positive, real_array
from .._util.lazy_scipy import scipy
from .._util.short_text import in_short

Window = int | Sequence[int] | None

_BISECTIONS = 60
"""Number of bisections of one layer, enough to find a depth to within rounding errors."""
_CUTOFF_DEVIATIONS = 4.0
"""Distance at which a Gaussian is cut off, in standard deviations."""
_MAX_RELATIVE_TRACE = 1e-9
"""Trace up to which a tensor counts as a deviator, divided by its largest component."""


def depth(equivalent: ArrayLike, dz: float, threshold: float) -> FloatArray:
    """Return the thickness of the surface layer in which the plastic strain exceeds a threshold.

    Parameters
    ----------
    equivalent : array_like, shape (nx, ny, nz)
        Equivalent plastic strain at the mid-depths (k + 1/2) dz [-], >= 0.
    dz : float
        Thickness of a layer [m], > 0.
    threshold : float
        Threshold of the equivalent plastic strain [-], > 0.

    Returns
    -------
    ndarray, shape (nx, ny)
        Depth [m]; 0 if the strain in the first layer of cells does not exceed the threshold,
        regardless of deeper layers. Otherwise, the first depth at which the strain, interpolated
        along the column by monotone cubics (PCHIP), drops to the threshold. Boucly (2008), section
        5.1.3.1, uses Lagrange polynomials, which overshoot.

    Raises
    ------
    ValueError
        The strain exceeds the threshold down to the last layer.
    """
    step, limit = positive("dz", dz), positive("threshold", threshold)
    shape = real_array("equivalent", equivalent).shape
    if len(shape) != 3 or shape[2] == 0:
        raise ValueError(f"equivalent must have shape (nx, ny, nz), got {shape}")
    field = finite_array("equivalent", equivalent, shape)
    found = np.zeros(shape[:2])
    worn = field[:, :, 0] > limit
    if not worn.any():
        return found
    columns = field[worn]
    if (columns > limit).all(axis=1).any():
        raise ValueError(
            "grid must be deeper than the worn layer, but the plastic strain exceeds "
            f"threshold = {limit!r} down to the last layer of the grid, at "
            f"{shape[2] * step!r} m: use more layers"
        )
    layer = np.argmax(columns <= limit, axis=1) - 1  # the last one above the threshold
    rows, slopes = np.arange(len(columns)), _slopes(columns)
    ends = (columns[rows, layer], columns[rows, layer + 1])
    slopes_at_ends = (slopes[rows, layer], slopes[rows, layer + 1])
    low, high = np.zeros(len(columns)), np.ones(len(columns))
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        above = _hermite(middle, ends, slopes_at_ends) > limit
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    found[worn] = (layer + 0.5 + 0.5 * (low + high)) * step
    return found


def _slopes(columns: FloatArray) -> FloatArray:
    """Return the slopes of monotone cubics through columns of values [per layer], same shape."""
    count = columns.shape[-1]
    interpolant = scipy.interpolate.PchipInterpolator(np.arange(count), columns, axis=-1)
    return np.asarray(interpolant(np.arange(count), 1), dtype=np.float64)


def _hermite(
    t: FloatArray, values: tuple[FloatArray, FloatArray], slopes: tuple[FloatArray, FloatArray]
) -> FloatArray:
    """Interpolate by a cubic between two layers, at the fraction t of their distance."""
    s = 1 - t
    (y0, y1), (d0, d1) = values, slopes
    result: FloatArray = s * s * ((1 + 2 * t) * y0 + t * d0) + t * t * ((1 + 2 * s) * y1 - s * d1)
    return result


def window_and_order(window: Window, order: int) -> tuple[int, int, int]:
    """Return the checked window along x and along y [cells], and the checked polynomial order."""
    sides: list[int] = [1 if window is None else window] * 2 if _single(window) else list(window)  # type: ignore[arg-type,list-item]
    if len(sides) != 2:
        raise ValueError(
            f"window must be a number of cells or a pair of them, got {in_short(window)}"
        )
    for cells in sides:
        if integer("window", cells, 1) % 2 == 0:
            raise ValueError(f"window must be an odd number of cells, got {in_short(window)}")
    integer("order", order, 0)
    for cells in sides:
        if 1 < cells <= order:
            raise ValueError(f"order must be < window = {in_short(window)}, got {order}")
    return int(sides[0]), int(sides[1]), int(order)


def _single(window: Window) -> bool:
    return window is None or not isinstance(window, Sequence)


def smooth(depth: ArrayLike, window: Window = 5, order: int = 2) -> FloatArray:
    """Smooth the edge of a wear depth, conserving the volume. Boucly (2008), eqs. (5.1)-(5.3).

    Parameters
    ----------
    depth : array_like, shape (nx, ny)
        Wear depth [m], >= 0. It is taken as 0 outside the array.
    window : int or pair of int, optional
        Odd number of cells (along x and y) of a two-dimensional Savitzky-Golay filter; None or 1
        for no smoothing.
    order : int, optional
        Order of the polynomials of this filter in x and in y, < `window`.

    Returns
    -------
    ndarray, shape (nx, ny)
        Wear depth [m], >= 0; the sum over all cells is unchanged, except for rounding.

    Raises
    ------
    ValueError
        A depth is < 0, or a window or order is not allowed.
    """
    shape = real_array("depth", depth).shape
    if len(shape) != 2:
        raise ValueError(f"depth must have shape (nx, ny), got {shape}")
    given = finite_array("depth", depth, shape)
    if (given < 0).any():
        raise ValueError(f"depth must be >= 0 everywhere, got {float(given.min())!r}")
    *sides, degree = window_and_order(window, order)
    if max(sides) == 1 or not given.any():
        return np.array(given)
    result = given
    for axis, cells in enumerate(sides):
        if cells > 1:
            # Values that the filter spreads beyond the array are cut off only at the end.
            padding = [(cells, cells) if axis == n else (0, 0) for n in (0, 1)]
            padded = np.pad(result, padding)
            padded = scipy.signal.savgol_filter(
                padded, cells, degree, axis=axis, mode="constant", cval=0.0
            )
            result = padded[cells:-cells] if axis == 0 else padded[:, cells:-cells]
    return scaled_to_volume(given, np.maximum(result, 0.0))  # the filter undershoots near a step


def scaled_to_volume(given: FloatArray, result: FloatArray) -> FloatArray:
    """Return a smoothed depth, multiplied so that its sum equals the sum of the given depth."""
    if not given.any():
        return np.zeros_like(given)
    total = math.fsum(given.flat)
    scaled = np.asarray(result * (total / math.fsum(result.flat)), dtype=np.float64)
    # The rounding error of the scaling is added to the deepest cell, where it matters least.
    deepest = np.unravel_index(int(np.argmax(scaled)), scaled.shape)
    scaled[deepest] += total - math.fsum(scaled.flat)
    return scaled


@dataclass(frozen=True)
class Polynomials:
    """Smoothing by the function `smooth` over a window of cells, as in Boucly (2008)."""

    sides: tuple[int, int]
    """Numbers of cells of the window along x and y."""
    order: int

    def __call__(self, depth: FloatArray) -> FloatArray:
        return smooth(depth, self.sides, self.order)


@dataclass(frozen=True)
class Gaussian:
    """Smoothing by a Gaussian with a physical standard deviation, conserving the volume."""

    deviation: tuple[float, float]
    """Standard deviation in cells along x and y."""

    @property
    def sides(self) -> tuple[int, int]:
        """Numbers of cells along x and y over which the wear in a cell is spread."""
        x, y = (2 * math.ceil(_CUTOFF_DEVIATIONS * cells) + 1 for cells in self.deviation)
        return x, y

    def __call__(self, depth: FloatArray) -> FloatArray:
        if not depth.any():
            return np.array(depth)
        options = {"mode": "constant", "truncate": _CUTOFF_DEVIATIONS}
        return scaled_to_volume(
            depth, scipy.ndimage.gaussian_filter(depth, self.deviation, **options)
        )


def below_worn_surface(field: ArrayLike, depth: ArrayLike, dz: float) -> FloatArray:
    """Interpolate a volume field at layer depths z_k below the worn surface.

    These points lie z_k + depth below the old surface.

    Parameters
    ----------
    field : array_like, shape (..., nx, ny, nz)
        Values at the mid-layer depths.
    depth : array_like, shape (nx, ny)
        Removed depth [m], >= 0.
    dz : float
        Thickness of a layer [m], > 0.

    Returns
    -------
    ndarray
        Field of unchanged shape, interpolated along each column by monotone cubics (PCHIP), which
        do not overshoot. Below the deepest layer, the interpolated field falls to 0 within one
        layer thickness.

    Raises
    ------
    ValueError
        Wrong shape, or a depth < 0.
    """
    step, shape = positive("dz", dz), real_array("field", field).shape
    if len(shape) < 3 or shape[-1] == 0:
        raise ValueError(f"field must have shape (..., nx, ny, nz), got {shape}")
    values = finite_array("field", field, shape)
    removed = finite_array("depth", depth, shape[-3:-1])
    if (removed < 0).any():
        raise ValueError(f"depth must be >= 0 everywhere, got {float(removed.min())!r}")
    result = values.copy()
    worn = removed > 0
    columns = values[..., worn, :]
    if not columns.any():
        return np.asarray(result, dtype=np.float64)
    count = shape[-1]
    # Two layers of zeros: at the end of the column, and beyond.
    extended = np.concatenate([columns, np.zeros((*columns.shape[:-1], 2))], axis=-1)
    slopes = _slopes(extended)
    place = np.arange(count) + (removed[worn] / step)[:, None]
    layer = np.minimum(np.floor(place).astype(np.int64), count)
    part = np.where(place < count + 1, place - layer, 1.0)
    at = np.broadcast_to(layer, columns.shape)

    def ends(nodes: FloatArray) -> tuple[FloatArray, FloatArray]:
        upper, lower = (np.take_along_axis(nodes, at + n, axis=-1) for n in (0, 1))
        return upper, lower

    result[..., worn, :] = _hermite(part, ends(extended), ends(slopes))
    return np.asarray(result, dtype=np.float64)


def deviator_below_worn_surface(tensor: FloatArray, depth: FloatArray, dz: float) -> FloatArray:
    """Apply `below_worn_surface` to each component of tensors, shape (..., 6, nx, ny, nz).

    Interpolation can give a deviator a small mean normal part. This part is subtracted in all
    columns of cells (along z) in which the given tensors are deviators.
    """
    moved = below_worn_surface(tensor, depth, dz)
    trace = np.abs(tensor[..., :3, :, :, :].sum(axis=-4)).max(axis=-1, keepdims=True)
    largest = np.abs(tensor).max(axis=(-4, -1))[..., None]
    worn = (depth > 0)[:, :, None] & (trace <= _MAX_RELATIVE_TRACE * largest)
    normal = moved[..., :3, :, :, :]
    normal -= np.where(worn, normal.sum(axis=-4) / 3, 0.0)[..., None, :, :, :]
    return np.asarray(moved, dtype=np.float64)

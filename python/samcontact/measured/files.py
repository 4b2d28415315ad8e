# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers for instrument files and plain arrays."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from .._util.checks import choice, file_path, positive
from .._util.short_text import in_short
from .instruments import ReaderArguments, metres, require_format, with_library
from .plain import Table, columns, grid_of_points, is_array, is_plain, plain_heights, profile, table
from .plausible import warn_of_size
from .surface import TRENDS, MeasuredSurface

_DEFAULT_CHANNELS = (None, 0, "Default")  # channel of a file with one map


def read(
    path: str | os.PathLike[str],
    *,
    format: str | None = None,
    channel: int | str | None = None,
    detrend: str | None = "center",
    undefined: str = "fill",
    dx: float | None = None,
    dy: float | None = None,
    unit: str | None = None,
) -> MeasuredSurface:
    """Read a measured surface or profile.

    Parameters
    ----------
    path : str or path
        File in any format of SurfaceTopography (.al3d, .sur, .x3p, .opd, .vk4, .nc, text, ...), or
        a plain array (.npy), or plain text (with decimal points; a header must not state sizes).
        Columns are separated by blanks in .txt, .dat and .asc files, and by commas or semicolons in
        .csv files. A plain file contains one of the following: rows of heights, which require `dx`;
        two columns x and z of a profile; or three columns x, y, z of points that fill a grid, in
        any order.
    format : str, optional
        Name of a reader in SurfaceTopography ("sur", "x3p", "nms", ...), "array" for rows of
        heights, or "xyz" for columns of positions and heights. Default: determined from content and
        suffix.
    channel : int or str, optional
        Number (from 0) or name of the map in the file. Default: the first map of heights.
    detrend : {"center", "height", "slope", "curvature"} or None
        Trend to remove, see `MeasuredSurface.detrended`. None leaves the heights unchanged.
    undefined : {"fill", "error", "keep"}
        Treatment of undefined points: interpolate them (`MeasuredSurface.filled`), raise
        ValueError, or keep them as NaN.
    dx, dy : float, optional
        Sample spacing [m], if the file does not contain it. `dy` defaults to `dx`.
    unit : str, optional
        Length unit of the heights ("nm", "um", ...), if the file does not contain it. Default for
        rows of heights: metres. For columns it is also the unit of the positions.

    Returns
    -------
    MeasuredSurface
        Surface. Its `attrs` contain source, format, channel, unit of the file, trend and number of
        filled points, and, if available, instrument and acquisition_time. A profile has heights of
        shape (n, 1). A profile with unequal steps is interpolated to equal steps; `attrs` then
        contains the original steps.

    Raises
    ------
    ValueError
        The file cannot be read, or is not a map or profile of heights. A spacing or unit is missing
        in both the arguments and the file, or present in both. An argument is outside its range.
    ImportError
        SurfaceTopography is required and not installed.

    Warns
    -----
    UnitWarning
        The surface is implausible: it is longer than 1 m, has an rms slope above 2, or has a height
        range larger than its length.

    Notes
    -----
    In every format the first index of the heights runs along x. A line of a plain text contains the
    ny heights at one x, as written by NumPy. A text with a header, from an instrument or from
    SurfaceTopography, is an image: a line contains the nx heights at one y.
    """
    choice("undefined", undefined, ("fill", "error", "keep"))
    choice("detrend", detrend, (*TRENDS, None))
    source = file_path("path", path)
    step_x = None if dx is None else positive("dx", dx)
    step_y = step_x if dy is None else positive("dy", dy)
    if step_y is not None and step_x is None:
        raise ValueError(f"dx is required if dy is given, got dy = {in_short(dy)}: give both [m]")
    steps = None if step_x is None or step_y is None else (step_x, step_y)
    surface = _read(source, require_format(format), ReaderArguments(channel, steps, unit))
    warn_of_size(surface.heights, surface.steps, str(source), stacklevel=2)
    if undefined == "error" and surface.undefined:
        raise ValueError(
            f"{source} must have no undefined points, got {surface.undefined}: "
            'set undefined = "fill" to interpolate them'
        )
    # fit the trend to measured points, before others are interpolated
    surface = surface if detrend is None else surface.detrended(detrend)
    return surface.filled() if undefined == "fill" else surface


def has_columns(path: Path) -> bool:
    """Whether a plain file contains columns of positions and heights, not rows of heights."""
    found = table(path)
    return found is not None and columns(found.values, path) is not None


def _read(source: Path, format: str | None, given: ReaderArguments) -> MeasuredSurface:
    found = table(source) if format in (None, "xyz") else None
    if found is not None and (which := columns(found.values, source)) is not None:
        return _surface_from_columns(source, found, which, given)
    if format in (None, "array") and is_plain(source):
        return _surface_from_rows(source, given)
    if format == "array":
        raise ValueError(
            f'format must not be "array", because {source} is not a plain file of numbers (.npy, '
            "or .txt, .dat, .asc or .csv without a header): omit format"
        )
    return with_library(source, format, given)


def _surface_from_rows(source: Path, given: ReaderArguments) -> MeasuredSurface:
    """Read a surface from a plain file with rows of heights."""
    heights = plain_heights(source)
    if given.steps is None:
        raise ValueError(f"dx is required, because {source} does not contain it")
    if given.channel not in _DEFAULT_CHANNELS:
        raise ValueError(
            f"channel must be 0, because {source} contains only one map, got "
            f"{in_short(given.channel)}"
        )
    kind = "npy" if is_array(source) else source.suffix.lower()[1:]
    attrs = {"source": str(source), "format": kind}
    if given.unit is not None:
        heights = heights * metres(given.unit)
        attrs["unit"] = given.unit
    return MeasuredSurface(heights, *given.steps, attrs)


def _surface_from_columns(
    source: Path, found: Table, which: tuple[int, ...], given: ReaderArguments
) -> MeasuredSurface:
    """Read a profile from two columns x and z, or a map from three columns x, y, z."""
    names = ("x", "z") if len(which) == 2 else ("x", "y", "z")
    what = "a profile, columns x and z" if len(names) == 2 else "points, columns x, y and z"
    rows = f'{source} contains {what} (if it contains rows of heights, set format="array")'
    if len(names) == 3:
        grid_of_points(found.values, source)
    if given.steps is not None:
        raise ValueError(f"dx must be None, got {in_short(given.steps[0])}: {rows}")
    if given.channel not in _DEFAULT_CHANNELS:
        raise ValueError(
            f"channel must be 0, because {source} contains only one map, got "
            f"{in_short(given.channel)}"
        )
    units = [found.units[column] for column in which]
    if given.unit is None and None in units:
        known = [f"{name} in {unit}" for name, unit in zip(names, units, strict=True) if unit]
        stated = f"specifies only {' and '.join(known)}" if known else "specifies no unit"
        raise ValueError(f'unit is required, e.g. unit="um": {rows}, and {stated}')
    if given.unit is not None and None not in units:
        raise ValueError(
            f"unit must be None, got {in_short(given.unit)}: {source} has the unit {units[0]}"
        )
    known_units = [given.unit if unit is None else unit for unit in units]
    points = found.values[:, list(which)] * [metres(str(unit)) for unit in known_units]
    attrs = {"source": str(source), "format": "xyz", "unit": known_units[-1]}
    if len(names) == 3:
        heights, step_x, step_y = grid_of_points(points, source)
        return MeasuredSurface(heights, step_x, step_y, attrs)
    z, step, uneven = profile(points[:, 0], points[:, 1])
    if uneven:
        attrs["interpolated_from"] = uneven
    return MeasuredSurface(np.asarray(z), step, attrs=attrs)

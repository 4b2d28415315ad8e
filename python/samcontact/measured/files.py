# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading the files of instruments, and plain arrays."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from .._checks import FloatArray, choice, positive
from .surface import TRENDS, MeasuredSurface, library

PLAIN_FORMATS = (".npy", ".txt", ".dat", ".csv")


def read(
    path: str | os.PathLike[str],
    *,
    channel: int | str | None = None,
    detrend: str | None = "center",
    undefined: str = "fill",
    dx: float | None = None,
    dy: float | None = None,
    unit: str | None = None,
) -> MeasuredSurface:
    """Read a measured surface.

    Parameters
    ----------
    path : str or path
        Any format of SurfaceTopography (.al3d, .sur, .x3p, .opd, .vk4, .nc, text, ...), found from
        the content. With `dx` and no `unit`, .npy, .txt, .dat (blanks) and .csv are plain arrays
        of heights [m], nx rows of ny values, and are read without it.
    channel : int or str, optional
        Number (from 0) or name of the map in the file; by default the one that the format puts
        first.
    detrend : {"center", "height", "slope", "curvature"} or None
        As `MeasuredSurface.detrended`; None leaves the heights as they are in the file.
    undefined : {"fill", "error", "keep"}
        What becomes of undefined points: `MeasuredSurface.filled`, an error, or NaN.
    dx, dy : float, optional
        Distance of the samples [m], for files that do not tell it. dy defaults to dx.
    unit : str, optional
        Length unit ("nm", "um", ...) of a file that does not tell it.

    Returns
    -------
    MeasuredSurface
        With `attrs` source, format, channel, the file's unit, trend and number of filled points,
        and where the file tells them instrument and acquisition_time. Axes are those of
        SurfaceTopography: the first index runs along x.

    Raises
    ------
    ValueError
        The file cannot be read, is no map of heights, tells no size or unit where none is given,
        or tells one that is given; or an argument is outside its range.
    ImportError
        SurfaceTopography is needed and not installed.
    """
    choice("undefined", undefined, ("fill", "error", "keep"))
    choice("detrend", detrend, (*TRENDS, None))
    source = Path(path)
    step_x = None if dx is None else positive("dx", dx)
    step_y = step_x if dy is None else positive("dy", dy)
    if step_y is not None and step_x is None:
        raise ValueError(f"dx must be given with dy = {dy!r}, got None")
    plain = source.suffix.lower() in PLAIN_FORMATS and (channel, unit) == (None, None)
    if step_x is not None and plain:
        attrs = {"source": str(source), "format": source.suffix.lower()[1:]}
        surface = MeasuredSurface(plain_heights(source), step_x, step_y, attrs)
    else:
        given = None if step_x is None or step_y is None else (step_x, step_y)
        surface = _with_library(source, channel, given, unit)
    if undefined == "error" and surface.undefined:
        raise ValueError(f"{source}: {surface.undefined} points are undefined")
    # the trend is that of the measured points, before others are interpolated
    surface = surface if detrend is None else surface.detrended(detrend)
    return surface.filled() if undefined == "fill" else surface


def plain_heights(path: Path) -> FloatArray:
    """Rows of heights from a plain file; a ValueError that names it where it cannot be read."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of an empty file, which is refused below
            if path.suffix.lower() == ".npy":
                heights: Any = np.load(path, allow_pickle=False)
            else:
                delimiter = "," if path.suffix.lower() == ".csv" else None
                heights = np.loadtxt(path, delimiter=delimiter, ndmin=2)
    except (OSError, ValueError, EOFError, TypeError, ArithmeticError, MemoryError) as error:
        raise ValueError(f"path: cannot read heights from {path}: {error}") from error
    numbers = isinstance(heights, np.ndarray) and heights.dtype.kind in "iuf"
    if not numbers or heights.ndim != 2 or heights.size == 0:
        found = f"{heights.dtype} of shape {heights.shape}" if numbers else type(heights).__name__
        raise ValueError(f"path: {path} must hold rows of numbers, has {found}")
    return np.asarray(heights)


def _with_library(
    path: Path,
    channel: int | str | None,
    steps: tuple[float, float] | None,
    unit: str | None,
) -> MeasuredSurface:
    io = library("SurfaceTopography.IO")
    try:
        # an open file: given a path, readers that fail to recognise the file may leave it open
        with path.open("rb") as file, io.open_topography(file) as reader:
            info = _channel(reader, channel, path)
            topography = info.topography(**_missing(info, steps, unit, path)).to_unit("m")
            heights = np.ma.filled(np.ma.array(topography.heights(), dtype=np.float64), np.nan)
            attrs = _provenance(path, reader, info, topography)
            step_x, step_y = (float(step) for step in topography.pixel_size)
    except io.CannotDetectFileFormat as error:
        raise ValueError(
            f"path: cannot read heights from {path}: no format that SurfaceTopography knows"
        ) from error
    except ImportError:
        raise
    except Exception as error:  # its readers let any kind through for a damaged file
        if isinstance(error, ValueError) and str(path) in str(error):
            raise
        raise ValueError(f"path: cannot read heights from {path}: {error}") from error
    return MeasuredSurface(heights, step_x, step_y, attrs)


def _provenance(path: Path, reader: Any, info: Any, topography: Any) -> dict[str, Any]:
    """Where heights come from."""
    attrs = {"source": str(path), "format": reader.format(), "channel": info.name}
    if info.unit is not None:
        attrs["unit"] = info.unit
    for name in ("instrument", "acquisition_time"):
        if topography.info.get(name) is not None:
            attrs[name] = topography.info[name]
    return attrs


def _channel(reader: Any, channel: int | str | None, path: Path) -> Any:
    """The wanted channel of a file, which must be a map of heights."""
    listed = ", ".join(f"{info.index}: {info.name!r}" for info in reader.channels)
    if channel is None:
        found = [reader.default_channel]
    else:
        found = [info for info in reader.channels if channel in (info.index, info.name)]
    if not found:
        raise ValueError(f"channel must be one of {listed} in {path}, got {channel!r}")
    if found[0].dim != 2 or not found[0].is_height_channel:
        raise ValueError(
            f"channel {found[0].name!r} of {path} is no map of heights; the file has {listed}"
        )
    return found[0]


def _missing(
    info: Any, steps: tuple[float, float] | None, unit: str | None, path: Path
) -> dict[str, Any]:
    """What the file does not tell about a channel, from the arguments."""
    for name, known, given in (("dx", info.physical_sizes, steps), ("unit", info.unit, unit)):
        if known is not None and given is not None:
            raise ValueError(f"{name} must not be given: {path} has its own")
        if known is None and given is None:
            raise ValueError(f"{name} must be given: {path} does not tell it")
    metadata: dict[str, Any] = {}
    if unit is not None:
        metadata["unit"] = unit
    if steps is not None:
        # sizes are in the unit of the heights
        factor = library("SurfaceTopography.Support.UnitConversion").get_unit_conversion_factor(
            "m", info.unit if unit is None else unit
        )
        metadata["physical_sizes"] = tuple(
            n * step * factor for n, step in zip(info.nb_grid_pts, steps, strict=True)
        )
    return metadata

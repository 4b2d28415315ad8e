# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading the files of instruments, and plain arrays."""

from __future__ import annotations

import codecs
import os
import re
import stat
import warnings
from itertools import takewhile
from pathlib import Path
from tokenize import TokenError
from typing import Any
from zipfile import BadZipFile

import numpy as np
from numpy.lib.format import MAGIC_PREFIX

from .._checks import FloatArray, choice, file_path, positive
from .._short import in_short
from .surface import TRENDS, MeasuredSurface, library

PLAIN_FORMATS = (".npy", ".txt", ".dat", ".asc", ".csv")
_FIRST = (None, 0, "Default")  # channel of a file with one map
# what np.load and the readers of instruments raise; the last of headers and archives of numpy.save
_DAMAGED = (
    OSError, ValueError, EOFError, TypeError, ArithmeticError, MemoryError,
    SyntaxError, TokenError, BadZipFile, KeyError, NotImplementedError,
)  # fmt: skip


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
        the content. With `dx`, plain arrays of heights: .npy, and .txt, .dat, .asc (blanks) and
        .csv (commas or semicolons, decimal points) without a header that tells sizes or units.
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
        Length unit of the heights ("nm", "um", ...), of a file that does not tell it; of a plain
        array by default metres.

    Returns
    -------
    MeasuredSurface
        With `attrs` source, format, channel, the file's unit, trend and number of filled points,
        and where the file tells them instrument and acquisition_time.

    Raises
    ------
    ValueError
        The file cannot be read, is no map of heights, tells no size or unit where none is given,
        or tells one that is given; or an argument is outside its range.
    ImportError
        SurfaceTopography is needed and not installed.

    Notes
    -----
    The first index of the heights runs along x, whatever the format. A line of a plain text holds
    the ny heights of one x, as NumPy writes such an array; a text with a header, of an instrument
    or of SurfaceTopography, is an image, of which a line holds the nx heights of one y.
    """
    choice("undefined", undefined, ("fill", "error", "keep"))
    choice("detrend", detrend, (*TRENDS, None))
    source = file_path("path", path)
    step_x = None if dx is None else positive("dx", dx)
    step_y = step_x if dy is None else positive("dy", dy)
    if step_y is not None and step_x is None:
        raise ValueError(f"dx must be given with dy = {in_short(dy)}, got None")
    if _is_array(source):
        if step_x is None:
            raise ValueError(f"dx must be given: {path} does not tell it")
        if channel not in _FIRST:
            raise ValueError(f"channel must be 0: {path} has one map, got {in_short(channel)}")
    if step_x is not None and channel in _FIRST and is_plain(source):
        kind = "npy" if _is_array(source) else source.suffix.lower()[1:]
        attrs = {"source": str(source), "format": kind}
        heights = plain_heights(source)
        if unit is not None:
            heights = heights * _metres(unit)
            attrs["unit"] = unit
        surface = MeasuredSurface(heights, step_x, step_y, attrs)
    else:
        given = None if step_x is None or step_y is None else (step_x, step_y)
        surface = _with_library(source, channel, given, unit)
    if undefined == "error" and surface.undefined:
        raise ValueError(f"{source}: {surface.undefined} points are undefined")
    # the trend is that of the measured points, before others are interpolated
    surface = surface if detrend is None else surface.detrended(detrend)
    return surface.filled() if undefined == "fill" else surface


def is_plain(path: Path) -> bool:
    """Whether a file is an array of heights only, without sizes or units of its own."""
    is_array = _is_array(path)
    if is_array or path.suffix.lower() not in PLAIN_FORMATS:
        return is_array
    try:
        lines = [] if path.suffix.lower() == ".npy" else _lines(path)
    except OSError:  # told by reading its heights
        return True
    before = takewhile(lambda line: not _is_data(line), lines)
    # values of a header stand after a colon (in Japanese a wide one) or an equals sign
    comment = re.compile("\\s*(#[^:=\N{FULLWIDTH COLON}]*)?")
    return all(comment.fullmatch(line) for line in before)


def _is_array(path: Path) -> bool:
    """Whether a file begins as one of numpy.save; a ValueError for what can be read only once."""
    try:
        mode = path.stat().st_mode
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
            raise ValueError(f"path: {path} must be a file, is a pipe or device")
        with path.open("rb") as file:
            return file.read(len(MAGIC_PREFIX)) == MAGIC_PREFIX
    except OSError:  # told by reading its heights
        return False


def _is_data(line: str) -> bool:
    """Whether a line of a text begins with a number."""
    first = re.split(r"[\s,;]", line.strip(), maxsplit=1)[0]
    try:
        float(first)
    except ValueError:
        return False
    return True


def _lines(path: Path) -> list[str]:
    """The lines of a text as spreadsheets and instruments write it, with or without a mark."""
    content = path.read_bytes()
    is_wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    # what is no text is no number either, and refused as such
    return content.decode("utf-16" if is_wide else "utf-8-sig", errors="replace").splitlines()


def plain_heights(path: Path) -> FloatArray:
    """Rows of heights from a plain file; a ValueError that names it where it cannot be read."""
    try:
        if path.suffix.lower() == ".npy" or _is_array(path):
            heights: Any = _array(path)
        else:
            heights = _rows(_lines(path), path.suffix.lower() == ".csv")
    except _DAMAGED as error:
        raise ValueError(f"path: cannot read heights from {path}: {error}") from error
    numbers = isinstance(heights, np.ndarray) and heights.dtype.kind in "iuf"
    if not numbers or heights.ndim != 2 or heights.size == 0:
        found = f"{heights.dtype} of shape {heights.shape}" if numbers else type(heights).__name__
        raise ValueError(f"path: {path} must hold rows of numbers, has {found}")
    return np.asarray(heights)


def _array(path: Path) -> Any:
    with path.open("rb") as file:
        start = file.read(6)
    # others would be taken for pickles, and the user be told to load them without safety
    if not start.startswith((b"\x93NUMPY", b"PK")):
        raise ValueError(f"it begins with {start!r}, is no file of numpy.save")
    return np.load(path, allow_pickle=False)


def _rows(lines: list[str], is_csv: bool) -> FloatArray:
    """Numbers of a text; a comma is never guessed to be a decimal one."""
    first = next((line for line in lines if _is_data(line)), "")
    delimiter = ";" if ";" in first else "," if is_csv and "," in first else None
    if "," in first and delimiter != ",":
        raise ValueError(
            f"numbers must have decimal points, and commas separate them in .csv only, got "
            f"{first.strip()[:40]!r}"
        )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of an empty file, which is refused by shape
        try:
            return np.loadtxt(lines, delimiter=delimiter, ndmin=2)
        except ValueError as error:  # without what NumPy advises, which is for its own arguments
            raise ValueError(str(error).split("; use `usecols`")[0]) from error


def _metres(unit: str) -> float:
    """What a length unit is in metres."""
    conversion = library("SurfaceTopography.Support.UnitConversion")
    try:
        if not isinstance(unit, str):
            raise TypeError
        return float(conversion.get_unit_conversion_factor(unit, "m"))
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(
            f'unit must be a length unit, e.g. "nm" or "um", got {in_short(unit)}'
        ) from error


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
            # a text whose header tells nothing is a plain array all the same
            plain = (reader.format(), info.physical_sizes, info.unit) == ("asc", None, None)
            if plain:
                steps, unit = steps and steps[::-1], unit or "m"
            topography = info.topography(**_missing(info, steps, unit, path)).to_unit("m")
            heights, sizes = topography.heights(), topography.pixel_size
            if plain:
                heights, sizes = heights.T, sizes[::-1]
            attrs = _provenance(path, reader, info, topography)
            step_x, step_y = (float(step) for step in sizes)
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
        raise ValueError(f"channel must be one of {listed} in {path}, got {in_short(channel)}")
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
        metre = _metres(info.unit if unit is None else unit)
        metadata["physical_sizes"] = tuple(
            n * step / metre for n, step in zip(info.nb_grid_pts, steps, strict=True)
        )
    return metadata

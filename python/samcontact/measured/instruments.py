# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading of instrument files by SurfaceTopography."""

from __future__ import annotations

import difflib
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

import numpy as np

from .._util.checks import FloatArray
from .._util.short_text import in_short
from .plain import error_text, profile, written_positions
from .surface import MeasuredSurface, library

OWN_FORMATS = ("array", "xyz")
"""Formats that can be read without SurfaceTopography; "xyz" can be read with it too."""
_COMPRESSION_MAGIC = {b"\x1f\x8b": "gzip", b"BZh": "bzip2", b"\xfd7zXZ": "xz"}
_NMS_STEPS = 1376  # byte offset of the steps along x and y in NanoFocus files
_NMS_FIELDS = 2e-5, 5e-2  # smallest and largest field of view of the microscopes [m]


class ReaderArguments(NamedTuple):
    """Arguments that supplement the contents of a file."""

    channel: int | str | None
    steps: tuple[float, float] | None
    unit: str | None


class _ReaderError(Exception):
    """Reason why a reader cannot use a file."""


def require_format(name: str | None) -> str | None:
    """Return the name of a reader in lower case; raise ValueError if there is no such reader."""
    if name is None:
        return None
    if not isinstance(name, str):
        raise TypeError(f'format must be a string, e.g. "sur", got {in_short(name)}')
    key = name.lower().lstrip(".")
    if key in OWN_FORMATS:
        return key
    io = library("SurfaceTopography.IO")
    known = sorted({*OWN_FORMATS, *io.lookup_reader_by_format})
    if key in known:
        return key
    near = difflib.get_close_matches(key, known, 1)
    hint = f"did you mean {near[0]!r}?" if near else f"use one of {', '.join(known)}"
    raise ValueError(f"format must be the name of a reader, got {in_short(name)}: {hint}")


def metres(unit: str) -> float:
    """Return the length of a unit in metres, e.g. 1e-6 for "um"."""
    conversion = library("SurfaceTopography.Support.UnitConversion")
    try:
        if not isinstance(unit, str):
            raise TypeError
        return float(conversion.get_unit_conversion_factor(unit, "m"))
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(
            f'unit must be a length unit, e.g. "nm" or "um", got {in_short(unit)}'
        ) from error


def with_library(path: Path, format: str | None, given: ReaderArguments) -> MeasuredSurface:
    """Read a surface with the first suitable reader.

    Raises ValueError if no reader is suitable. The message then contains the errors of all readers
    that recognise the format.
    """
    io = library("SurfaceTopography.IO")
    reasons: list[tuple[int, str]] = []
    try:
        # an open file: given a path, readers that do not recognise the file may leave it open
        with path.open("rb") as file:
            start = file.read(io.MAGIC_BUFFER_SIZE)
            for mark, name in _COMPRESSION_MAGIC.items():
                if start.startswith(mark):
                    raise ValueError(
                        f"path: {path} must not be compressed with {name}: unpack it first"
                    )
            for reader, rank in _candidates(io, path, start, format):
                file.seek(0)
                try:
                    return _read(io, path, file, reader.format(), given)
                except _ReaderError as refusal:
                    reasons.append((rank, f"{reader.name()} ({reader.format()}): {refusal}"))
    except OSError as error:
        raise ValueError(f"path: cannot read heights from {path}: {error_text(error)}") from error
    texts = [text for rank, text in sorted(reasons, key=lambda r: r[0]) if rank < _UNKNOWN_FORMAT]
    reason = texts[0] if texts else f"no format supported by SurfaceTopography{_expected(io, path)}"
    raise ValueError(f"path: cannot read heights from {path}: {reason}")


_UNKNOWN_FORMAT = 2


def _candidates(io: Any, path: Path, start: bytes, format: str | None) -> Iterator[tuple[Any, int]]:
    """Iterate over possible readers of a file and their ranks, the most likely reader first.

    Rank 0: the reader recognises the content. Rank 1: it recognises only the suffix of the file
    name. Rank 2: it recognises neither. Readers of text files keep the order in which
    SurfaceTopography lists them, because some of them must be tried before others.
    """
    if format is not None:
        yield io.lookup_reader_by_format[format], 0
        return
    ending = path.suffix.lower()[1:]
    found = []
    for number, reader in enumerate(io.readers):
        match = reader.can_read(start)
        if match == io.MagicMatch.NO:
            continue
        named = ending in reader.file_extensions()
        is_text = reader.mime_types() == ["text/plain"]
        rank = 0 if match == io.MagicMatch.YES else 1 if named else _UNKNOWN_FORMAT
        order = (0 if named else 1) if rank == 0 else 2 if named and not is_text else 3
        found.append((order, number, reader, rank))
    for _, _, reader, rank in sorted(found, key=lambda f: f[:2]):
        yield reader, rank


def _expected(io: Any, path: Path) -> str:
    """Return a hint that a file does not match its suffix, or "" if the suffix is unknown."""
    ending = path.suffix.lower()[1:]
    names = [reader.name() for reader in io.readers if ending in reader.file_extensions()]
    return f"; it does not begin like a {names[0]} file" if names else ""


def _read(
    io: Any, path: Path, file: BinaryIO, format: str, given: ReaderArguments
) -> MeasuredSurface:
    """Read a surface; raise _ReaderError if a reader fails, ValueError for an invalid argument."""
    reader = _call_reader(io, lambda: io.open_topography(file, format=format))
    with reader:
        if not len(_call_reader(io, lambda: list(reader.channels))):
            raise _ReaderError("the file has no channels")
        info = _channel(reader, given.channel, path)
        steps, unit = given.steps, given.unit
        # a text whose header has no sizes is a plain array as well
        plain = (format, info.physical_sizes, info.unit, info.dim) == ("asc", None, None, 2)
        if plain:
            steps, unit = steps and steps[::-1], unit or "m"
        missing = _missing(info, steps, unit, path)
        topography = _call_reader(io, lambda: info.topography(**missing).to_unit("m"))
        attrs = _provenance(path, format, info, topography)
        if info.dim == 1:
            x = written_positions(path) if format == "xyz" else None
            x = None if x is None else x * metres(str(info.unit or unit))
            surface: MeasuredSurface = _call_reader(io, lambda: _profile(topography, attrs, x))
            return surface
        heights, sizes = _call_reader(io, lambda: (topography.heights(), topography.pixel_size))
    if plain:
        heights, sizes = heights.T, sizes[::-1]
    if format == "nms":
        sizes = _nms_steps(file, heights.shape, sizes)
    return MeasuredSurface(heights, float(sizes[0]), float(sizes[1]), attrs)


def _call_reader(io: Any, call: Any) -> Any:
    """Call a reader; raise _ReaderError for any error: damaged files cause errors of all kinds."""
    try:
        return call()
    except (ImportError, _ReaderError):
        raise
    except (io.ReadFileError, io.UnknownFileFormat) as error:
        raise _ReaderError(error_text(error)) from error
    except Exception as error:
        raise _ReaderError(
            f"the reader failed ({type(error).__name__}: {error_text(error)}): the file is "
            "damaged, or is a variant of the format that SurfaceTopography does not support"
        ) from error


def _profile(topography: Any, attrs: dict[str, Any], written: FloatArray | None) -> MeasuredSurface:
    """Convert a line scan to a surface with one row of samples.

    written: positions [m] as written in the file, if known. They replace the positions from
    SurfaceTopography, which treats steps as equal if they differ by less than 1e-6 in the unit of
    the file, even if this unit is the metre.
    """
    x, z = np.asarray(topography.positions(), dtype=float), np.ma.asarray(topography.heights())
    if written is not None and len(written) == len(x):
        x = written
    if len(x) < 2 or not ((np.diff(x) > 0).all() or (np.diff(x) < 0).all()):
        raise _ReaderError("the positions x of the profile must increase or decrease throughout")
    heights, step, uneven = profile(x, np.ma.filled(z.astype(float), np.nan))
    return MeasuredSurface(
        heights, step, attrs=attrs | ({"interpolated_from": uneven} if uneven else {})
    )


def _nms_steps(file: BinaryIO, shape: tuple[int, ...], steps: Any) -> Any:
    """Return the sample spacing of a NanoFocus file [m].

    The spacing is stored in nm; SurfaceTopography may interpret it as mm.
    """
    file.seek(_NMS_STEPS)
    own = [1e-9 * step for step in struct.unpack("<2d", file.read(16))]
    low, high = _NMS_FIELDS
    is_field = all(low <= n * step <= high for n, step in zip(shape, own, strict=True))
    return own if is_field else steps


def _provenance(path: Path, format: str, info: Any, topography: Any) -> dict[str, Any]:
    """Return attributes that state the origin of the heights: file, format, instrument, time."""
    attrs = {"source": str(path), "format": format, "channel": info.name}
    if info.unit is not None:
        attrs["unit"] = info.unit
    for name in ("instrument", "acquisition_time"):
        if topography.info.get(name) is not None:
            attrs[name] = topography.info[name]
    return attrs


def _channel(reader: Any, channel: int | str | None, path: Path) -> Any:
    """Return the selected channel of a file; by default, the first channel with heights."""
    channels = list(reader.channels)
    listed = ", ".join(f"{info.index}: {info.name!r}" for info in channels)
    if channel is None:
        default = reader.default_channel
        found = [info for info in (default, *channels) if info.is_height_channel][:1] or [default]
    else:
        found = [info for info in channels if channel in (info.index, info.name)]
    if not found:
        raise ValueError(f"channel must be one of {listed} in {path}, got {in_short(channel)}")
    if not found[0].is_height_channel:
        raise ValueError(
            f"channel {found[0].name!r} of {path} must contain heights, got "
            f"{found[0].data_kind.value}; the file has {listed}"
        )
    return found[0]


def _missing(
    info: Any, steps: tuple[float, float] | None, unit: str | None, path: Path
) -> dict[str, Any]:
    """Return, from the arguments, the sizes and the unit that are missing in the file."""
    for name, known, given in (("dx", info.physical_sizes, steps), ("unit", info.unit, unit)):
        if known is not None and given is not None:
            raise ValueError(f"{name} must be None, got {in_short(given)}: {path} contains it")
        if known is None and given is None:
            raise ValueError(f"{name} is required, because {path} does not contain it")
    metadata: dict[str, Any] = {}
    if unit is not None:
        metadata["unit"] = unit
    if steps is not None:
        # sizes are in the unit of the heights
        metre = metres(info.unit if unit is None else unit)
        counts = info.nb_grid_pts
        sizes = tuple(n * step / metre for n, step in zip(counts, steps, strict=False))
        metadata["physical_sizes"] = sizes if len(counts) > 1 else sizes[0]
    return metadata

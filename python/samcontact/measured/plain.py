# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading of plain arrays and texts: rows of heights, or columns of positions and heights."""

from __future__ import annotations

import codecs
import re
import stat
import warnings
from itertools import takewhile
from pathlib import Path
from tokenize import TokenError
from typing import Any, NamedTuple
from zipfile import BadZipFile

import numpy as np
from numpy.lib.format import MAGIC_PREFIX

from .._util.checks import FloatArray

PLAIN_FORMATS = (".npy", ".txt", ".dat", ".asc", ".csv")
_TABLE_FORMATS = (*PLAIN_FORMATS, ".xyz")
# errors of np.load; the last four are raised for damaged .npy headers or archives
_READ_ERRORS = (
    OSError, ValueError, EOFError, TypeError, ArithmeticError, MemoryError,
    SyntaxError, TokenError, BadZipFile, KeyError, NotImplementedError,
)  # fmt: skip
_MIN_POSITION_ROWS = 4  # minimum number of rows for columns of positions
# a comment without a value: values follow a colon (full-width in Japanese) or an equals sign
_COMMENT = re.compile("\\s*(#[^:=\N{FULLWIDTH COLON}]*)?")
_UNITS = {
    "nm": r"nm|nanomet\w+",
    "um": r"[u\u00b5\u03bc]m|micron\w*|micromet\w+",
    "mm": r"mm|millimet\w+",
    "m": r"m|met(?:er|re)s?",
}


class Table(NamedTuple):
    """Numbers read from a file, and the unit of each column (None if its label has no unit)."""

    values: FloatArray
    units: tuple[str | None, ...]


def error_text(error: BaseException) -> str:
    """Return the text of an error on one line, without operating-system error numbers."""
    if isinstance(error, OSError) and error.strerror:
        return error.strerror.lower()
    text = " ".join(str(error).split())
    return text if len(text) <= 200 else f"{text[:200]}..."


def is_array(path: Path) -> bool:
    """Whether a file begins like a file of numpy.save; raise ValueError for a pipe or device."""
    try:
        mode = path.stat().st_mode
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
            raise ValueError(f"path: {path} must be a regular file, got a pipe or device")
        with path.open("rb") as file:
            return file.read(len(MAGIC_PREFIX)) == MAGIC_PREFIX
    except OSError:  # reported when its heights are read
        return False


def is_plain(path: Path) -> bool:
    """Whether a file contains only an array of numbers, without sample spacings or units."""
    array = is_array(path)
    if array or path.suffix.lower() not in PLAIN_FORMATS:
        return array
    try:
        lines = [] if path.suffix.lower() == ".npy" else _lines(path)
    except OSError:  # reported when its heights are read
        return True
    return all(_COMMENT.fullmatch(line) for line in _header(lines))


def plain_heights(path: Path) -> FloatArray:
    """Read rows of numbers from a plain file; raise ValueError if the file cannot be read."""
    try:
        if path.suffix.lower() == ".npy" or is_array(path):
            heights: Any = _array(path)
        else:
            heights = _rows(_lines(path), path.suffix.lower() == ".csv")
    except _READ_ERRORS as error:
        raise ValueError(f"path: cannot read heights from {path}: {error_text(error)}") from error
    numbers = isinstance(heights, np.ndarray) and heights.dtype.kind in "iuf"
    if not numbers or heights.ndim != 2 or heights.size == 0:
        found = f"{heights.dtype} of shape {heights.shape}" if numbers else type(heights).__name__
        raise ValueError(f"path: {path} must contain rows of numbers, got {found}")
    return np.asarray(heights)


def table(path: Path) -> Table | None:
    """Read a file of two or three columns of numbers; return None for other files."""
    if is_array(path):
        values, header = plain_heights(path), []
    elif path.suffix.lower() in _TABLE_FORMATS:
        try:
            lines = _lines(path)
            header = [line for line in _header(lines) if not _COMMENT.fullmatch(line)]
            if len(header) > 1 or any("#" in line or "valid" in line for line in header):
                return None
            values = _rows(lines, path.suffix.lower() == ".csv", skip=_header(lines))
        except (OSError, ValueError):  # reported when its heights are read
            return None
    else:
        return None
    if values.ndim != 2 or values.shape[1] not in (2, 3) or values.dtype.kind not in "iuf":
        return None
    labels = re.split(r"[,;\t]|\s{2,}", header[0].strip()) if header else []
    fits = len(labels) == values.shape[1]
    units = tuple(_unit_of(label) for label in labels) if fits else (None,) * values.shape[1]
    return Table(np.asarray(values, dtype=np.float64), units)


def written_positions(path: Path) -> FloatArray | None:
    """Return the positions x of a profile in a text with any header; None for other files."""
    try:
        lines = _lines(path)
        values = _rows(lines, path.suffix.lower() == ".csv", skip=_header(lines))
        which = columns(values, path) if values.shape[1] in (2, 3) else None
    except (OSError, ValueError):
        return None
    return None if which is None or len(which) != 2 else np.asarray(values[:, which[0]])


def _unit_of(label: str) -> str | None:
    """Return the length unit in the label of a column; None if the label has no unit."""
    for unit, words in _UNITS.items():
        if re.search(rf"(?<![^\W_])(?:{words})(?![^\W_])", label):
            return unit
    return None


def columns(values: FloatArray, path: Path) -> tuple[int, ...] | None:
    """Return the indices of the columns x, z or x, y, z, or None if the rows are heights.

    Raises ValueError if the positions x of a profile change direction. This function does not
    check that points fill a grid.
    """
    if len(values) < _MIN_POSITION_ROWS or not np.isfinite(values[:, :-1]).all():
        return None
    if values.shape[1] == 3 and not (_counts(values[:, 0]) and _rises(values[:, 1]) == 1.0):
        varies = [axis for axis in (0, 1) if np.ptp(values[:, axis]) > 0]
        if len(varies) == 2:
            return 0, 1, 2  # points that fill a grid, or an error
        # a line of points along one of the axes
        along = [axis for axis in varies if _rises(values[:, axis]) == 1.0]
        return (along[0], 2) if along else None
    first = values.shape[1] - 2
    share = _rises(values[:, first])
    if share == 1.0:
        return first, first + 1
    if share >= 0.9:
        steps = np.diff(values[:, first])
        turns = np.flatnonzero(np.sign(steps) != np.sign(values[-1, first] - values[0, first]))
        raise ValueError(
            f"path: the positions x of the profile in {path} must increase or decrease throughout, "
            f"but their direction reverses at row {turns[0] + 2}; if the lines are rows of "
            'heights, set format="array"'
        )
    return None


def _counts(column: FloatArray) -> bool:
    """Whether a column contains consecutive row numbers."""
    return bool(np.array_equal(column - column[0], np.arange(len(column))))


def _rises(column: FloatArray) -> float:
    """Return the fraction of rising or of falling steps in a column, whichever is larger."""
    steps = np.diff(column)
    return float(max((steps > 0).mean(), (steps < 0).mean()))


def profile(x: FloatArray, z: FloatArray) -> tuple[FloatArray, float, str]:
    """Return heights at equal steps along x, the step, and a note on unequal original steps.

    The note is empty if the steps of the profile are equal.
    """
    if x[0] > x[-1]:
        x, z = x[::-1], z[::-1]
    count = np.arange(len(x))
    step = float(x[-1] - x[0]) / (len(x) - 1)
    even = x[0] + step * count
    if np.abs(x - even).max() <= 1e-6 * step:
        return z, step, ""
    # positions rounded in the file
    digit = _last_digit(x, step)
    start, rounded = np.polynomial.Polynomial.fit(count, x, 1).convert().coef
    if np.abs(x - start - rounded * count).max() <= 0.55 * digit:
        return z, float(rounded), ""
    steps = np.diff(x)
    return np.interp(even, x, z), step, f"steps of {steps.min():.4g} to {steps.max():.4g} m"


def _last_digit(x: FloatArray, step: float) -> float:
    """Return the step to which positions are rounded [m], e.g. 1e-8; 0 if it is not evident."""
    for digits in range(4):
        unit = 10.0 ** (np.floor(np.log10(step) + 1e-9) - digits)
        if np.abs(x / unit - np.round(x / unit)).max() < 1e-4:
            return float(unit)
    return 0.0


def grid_of_points(points: FloatArray, path: Path) -> tuple[FloatArray, float, float]:
    """Return the heights of points x, y, z as an array [i][j], and the steps along x and y.

    The points may be in any order. Raises ValueError unless each node of a regular grid has
    exactly one point.
    """
    axes = [_places(points[:, axis]) for axis in (0, 1)]
    (i, x), (j, y) = axes
    missing = len(x) * len(y) - len(np.unique(i * len(y) + j))
    if missing or len(points) != len(x) * len(y) or min(len(x), len(y)) < 2:
        raise ValueError(
            f"path: the three columns of {path} are interpreted as points x, y, z, which must fill "
            f"a grid, got {len(points)} points at {len(x)} values of x and {len(y)} values of y: "
            "interpolate the points to a grid or, if the lines are rows of heights, set "
            'format="array"'
        )
    steps = []
    for name, places in (("x", x), ("y", y)):
        between = np.diff(places)
        if np.ptp(between) > 0.02 * between.mean():
            raise ValueError(
                f"path: the points of {path} must have equal steps along {name}, got steps of "
                f"{between.min():.4g} to {between.max():.4g}"
            )
        steps.append(float(between.mean()))
    heights = np.empty((len(x), len(y)))
    heights[i, j] = points[:, 2]
    return heights, steps[0], steps[1]


def _places(column: FloatArray) -> tuple[Any, FloatArray]:
    """Return the index of each point along an axis, and the distinct positions on this axis."""
    order = np.argsort(column, kind="stable")
    steps = np.diff(column[order])
    number = np.zeros(len(column), dtype=int)
    number[order[1:]] = np.cumsum(steps > 0.5 * steps.max(initial=0.0))
    totals = np.bincount(number, weights=column)
    return number, totals / np.bincount(number)


def _is_data(line: str) -> bool:
    """Whether a line of a text begins with a number."""
    first = re.split(r"[\s,;]", line.strip(), maxsplit=1)[0]
    try:
        float(first)
    except ValueError:
        return False
    return True


def _header(lines: list[str]) -> list[str]:
    """Return the lines before the first line of numbers."""
    return list(takewhile(lambda line: not _is_data(line), lines))


def _lines(path: Path) -> list[str]:
    """Read the lines of a text in UTF-8 or UTF-16, with or without a byte-order mark."""
    content = path.read_bytes()
    is_wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    # a file that is not text contains no numbers, and is refused for that reason
    return content.decode("utf-16" if is_wide else "utf-8-sig", errors="replace").splitlines()


def _array(path: Path) -> Any:
    with path.open("rb") as file:
        start = file.read(6)
    # NumPy would take other files for pickles, and advise unsafe loading
    if not start.startswith((b"\x93NUMPY", b"PK")):
        raise ValueError(f"the file begins with {start!r} and was not written by numpy.save")
    return np.load(path, allow_pickle=False)


def _rows(lines: list[str], is_csv: bool, skip: list[str] | None = None) -> FloatArray:
    """Return the rows of numbers in a text; raise ValueError for decimal commas.

    skip: header lines.
    """
    first = next((line for line in lines if _is_data(line)), "")
    delimiter = ";" if ";" in first else "," if is_csv and "," in first else None
    if "," in first and delimiter != ",":
        raise ValueError(
            "numbers must have decimal points; commas may separate columns only in .csv files, got "
            f"{first.strip()[:40]!r}"
        )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # for an empty file, which is refused by shape
        try:
            return np.loadtxt(lines[len(skip or ()) :], delimiter=delimiter, ndmin=2)
        except ValueError as error:  # without NumPy's advice about its own arguments
            raise ValueError(str(error).split("; use `usecols`")[0]) from error

# SPDX-License-Identifier: GPL-3.0-or-later
"""Argument checks; each error message gives the name, the value and the allowed range."""

from __future__ import annotations

import difflib
import math
import os
import sys
from collections.abc import Iterable, Mapping
from itertools import islice
from numbers import Integral, Real
from pathlib import Path
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _core
from .array_contents import NON_REAL_TYPES, masked_values, not_numbers
from .short_text import in_short

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
MAX_COUNT = (1 << 31) - 1
"""Maximum count: the core uses 32-bit integers."""
MAX_CELLS_ALONG_AXIS = 1 << 24
"""Maximum number of cells along one axis; Fourier transforms need twice this number."""
MAX_STRESS = 1e75
"""Maximum stress or modulus [Pa], and maximum load [N]: their products do not overflow."""
MAX_INCREMENTS_OF_PATH = 100_000
"""Maximum number of increments of a path: longer paths would take months."""
MAX_FILE_NAME_BYTES = 200
"""Maximum length of a file name [bytes]. File systems allow 255; the names of temporary files are
longer than those of the final files."""
MAX_NUMBER = 1e300
"""Maximum magnitude in SI units: products of larger numbers leave the floating-point range."""


def _has_unit(value: Any) -> bool:
    """Whether a value has a unit (e.g. a pint quantity). NumPy would drop the unit."""
    return hasattr(value, "to_base_units")


def number(name: str, value: Any) -> float:
    """Return `value` as a float; raise TypeError unless it is a real number (not a bool)."""
    if type(value) is float and abs(value) <= MAX_NUMBER:  # the usual case, first to save time
        return value + 0.0  # never -0.0
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, NON_REAL_TYPES) or not isinstance(value, Real):
        raise TypeError(f"{name} must be a number, got {in_short(value)}{_remedy(value)}")
    try:
        found = float(value) + 0.0
    except OverflowError:  # an integer of more than 308 digits
        found = sys.float_info.max
    if MAX_NUMBER < abs(found) < math.inf or (math.isinf(found) and value != found):
        raise ValueError(
            f"{name} must be a number of magnitude <= {MAX_NUMBER:g}, got {in_short(value)}"
        )
    return found


def _remedy(value: Any) -> str:
    """Return the remedy that an error message gives if a value is not a number."""
    if _has_unit(value):
        return ": convert it with samcontact.units.si"
    if isinstance(value, str):
        return ': write it without quotes, or convert it with samcontact.units.si("...", unit)'
    if isinstance(value, (bool, np.bool_)):
        return ": a Boolean value is not accepted as a number"
    return ""


def boolean(name: str, value: Any) -> bool:
    """Return `value` as a bool; raise TypeError for other types, e.g. the text "no"."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} must be True or False, got {in_short(value)}")
    return bool(value)


def finite(name: str, value: Any) -> float:
    """Return `value` as a finite float."""
    result = number(name, value)
    if not math.isfinite(result):
        raise ValueError(f"{name} must be a finite number, got {result!r}")
    return result


def require_type(name: str, value: Any, kind: type) -> None:
    """Raise TypeError, with the argument's name, unless `value` is an instance of `kind`."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a samcontact.{kind.__name__}, got {in_short(value)}")


def require_list(name: str, values: Any, kind: type) -> None:
    """Raise TypeError, with the argument's name, unless `values` is a list or tuple of `kind`."""
    wrong = values
    if isinstance(values, (list, tuple)):
        others = [one for one in values if not isinstance(one, kind)]
        if not others:
            return
        wrong = others[0]
    raise TypeError(f"{name} must be a list of samcontact.{kind.__name__}, got {in_short(wrong)}")


def positive(name: str, value: Any, *, allow_inf: bool = False) -> float:
    """Return `value` as a float > 0, finite unless `allow_inf`."""
    if type(value) is float and 0.0 < value <= MAX_NUMBER:  # the usual case, first to save time
        return value
    result = number(name, value)
    if not result > 0.0 or (math.isinf(result) and not allow_inf):
        kind = "number > 0 (inf allowed)" if allow_inf else "finite number > 0"
        raise ValueError(f"{name} must be a {kind}, got {result!r}")
    return result


def non_negative(name: str, value: Any) -> float:
    """Return `value` as a finite float >= 0."""
    result = number(name, value)
    if not (result >= 0.0 and math.isfinite(result)):
        raise ValueError(f"{name} must be a finite number >= 0, got {result!r}")
    return result


def poisson_ratio(name: str, value: Any) -> float:
    """Return `value` as a float in [0, 0.5], the range of the closed-form solutions."""
    result = number(name, value)
    if not 0.0 <= result <= 0.5:
        raise ValueError(f"{name} must be in [0, 0.5], got {result!r}")
    return result


def integer(
    name: str, value: Any, minimum: int | None = None, largest: int | None = MAX_COUNT
) -> int:
    """Return `value` as an int >= `minimum` with magnitude <= `largest`."""
    if isinstance(value, NON_REAL_TYPES) or not isinstance(value, Integral):
        raise TypeError(f"{name} must be an integer, got {in_short(value)}")
    if minimum is not None and value < minimum:
        raise ValueError(f"{name} must be an integer >= {minimum}, got {in_short(value)}")
    count = int(value)
    if largest is not None and abs(count) > largest:
        raise ValueError(
            f"{name} must be an integer of magnitude <= {largest}, got {in_short(count)}"
        )
    return count


def in_cells(name: str, length: float, step: float) -> float:
    """Return a length [m] as a number of cells; ValueError if above `MAX_CELLS_ALONG_AXIS`."""
    if not abs(length) <= MAX_CELLS_ALONG_AXIS * step:
        raise ValueError(
            f"{name} must be <= {MAX_CELLS_ALONG_AXIS * step:.6g} m ({MAX_CELLS_ALONG_AXIS} cells "
            f"of {step!r} m), got {length!r} m"
        )
    return length / step


def step_list(name: str, steps: Any, known: Iterable[str]) -> list[dict[str, Any]]:
    """Return `steps` as a list of dicts, whose keys must be among the argument names `known`."""
    several = isinstance(steps, Iterable) and not isinstance(
        steps, (Mapping, str, bytes, np.ndarray)
    )
    given = list(islice(steps, MAX_INCREMENTS_OF_PATH + 1)) if several else [steps]
    if len(given) > MAX_INCREMENTS_OF_PATH:
        raise ValueError(f"{name} must have at most {MAX_INCREMENTS_OF_PATH} increments, got more")
    wrong = [step for step in given if not (several and isinstance(step, Mapping))]
    if wrong:
        raise TypeError(
            f"{name} must be a list of arguments of step(), e.g. [{{'load': 300.0}}], "
            f"got {in_short(wrong[0])}"
        )
    known = list(known)
    for number_, step in enumerate(given, 1):
        for key in step:
            if key not in known:
                near = difflib.get_close_matches(str(key), known, 1)
                hint = f": did you mean {near[0]}?" if near else f": use one of {', '.join(known)}"
                raise TypeError(
                    f"increment {number_} of {name} has an unknown argument {in_short(key)}{hint}"
                )
        exactly_one(**{key: step.get(key) for key in ("load", "approach", "pressure")})
        if step.get("pressure") is None:
            load_or_approach(step.get("load"), step.get("approach"))
    return [dict(step) for step in given]  # a copy: the caller may change the original


def step_count(name: str, value: Any) -> int:
    """Return `value` as a number of increments, at most `MAX_INCREMENTS_OF_PATH`."""
    count = integer(name, value, 1)
    if count > MAX_INCREMENTS_OF_PATH:
        raise ValueError(f"{name} must be at most {MAX_INCREMENTS_OF_PATH}, got {count}")
    return count


def choice(name: str, value: Any, allowed: tuple[Any, ...]) -> Any:
    """Return `value` if it is one of `allowed`."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    for item in allowed:
        # True and 1 + 0j are equal to 1; 2.0 is accepted as 2
        kind = Real if isinstance(item, Real) else type(item)
        if isinstance(value, kind) and not isinstance(value, NON_REAL_TYPES) and value == item:
            return item
    listed = ", ".join(repr(item) for item in allowed)
    raise ValueError(f"{name} must be one of {listed}, got {in_short(value)}")


def axis_number(axis: Any) -> int:
    """Return 0, 1 or 2 for "x", "y" or "z"."""
    return ("x", "y", "z").index(choice("axis", axis, ("x", "y", "z")))


def require_fast(name: str, method: str, periodic: str) -> None:
    """Raise ValueError if the method of residual stress is "exact" and the grid is periodic."""
    if method == "exact" and periodic:
        raise ValueError(
            f'{name} must be "fast" on a periodic grid (periodic = {periodic!r}), got '
            '"exact": the exact kernels cannot be summed over all periods'
        )


def exactly_one(**given: Any) -> str:
    """Return the name of the only argument that is not None."""
    names = [name for name, value in given.items() if value is not None]
    if len(names) != 1:
        listed = ", ".join(given)
        got = ", ".join(names) if names else "none"
        raise ValueError(f"exactly one of {listed} must be given, got {got}")
    return names[0]


def real_array(name: str, value: ArrayLike) -> FloatArray:
    """Return `value` as a float64 array of any shape; refuse lossy conversions."""
    return _measured_array(name, value)[0]


def _measured_array(name: str, value: ArrayLike) -> tuple[FloatArray, bool]:
    """Return `value` as `real_array` does, and whether all its numbers are finite."""
    array = value if _is_float_array(value) else _converted(name, value)
    largest, is_finite = _core.magnitude_of(array)
    if largest > MAX_NUMBER:
        raise ValueError(
            f"{name} must be finite everywhere and of magnitude <= {MAX_NUMBER:g}, "
            f"got {in_short(value)}"
        )
    return array, is_finite


def _is_float_array(value: ArrayLike) -> TypeGuard[FloatArray]:
    """Whether a value is a plain float64 array, so that it needs no conversion."""
    return type(value) is np.ndarray and value.dtype == np.float64


def _converted(name: str, value: ArrayLike) -> FloatArray:
    """Convert a value to a float64 array; raise TypeError or ValueError if values would be lost."""
    if _has_unit(value):
        raise TypeError(f"{name} has a unit: convert it to SI units with samcontact.units.si")
    lost = masked_values(value)
    if lost:  # NumPy would use the masked values
        raise ValueError(
            f"{name} must be defined everywhere, got {lost} masked values: fill them first "
            "(heights: samcontact.measured.MeasuredSurface(...).filled())"
        )
    axes = [axis for axis in getattr(value, "dims", ()) if axis in ("x", "y", "z")]
    if axes != sorted(axes):
        raise ValueError(
            f"{name} must have its axes in the order x, y, z, got {value.dims}: "  # type: ignore[union-attr]
            f"use .transpose({', '.join(map(repr, sorted(axes)))})"
        )
    wrong = ""
    try:
        given = np.asarray(value)
        wrong = " and ".join(sorted(not_numbers(value, given)))
        array = np.asarray(given, dtype=np.float64) if not wrong else None
    except OverflowError:  # an integer of more than 308 digits
        array = np.array(sys.float_info.max)
    except Exception:  # unequal rows; any error from the conversion of an object
        array = None
    if array is None:
        rows = "" if wrong else ", whose rows are equally long"
        raise TypeError(f"{name} must be an array of numbers{rows}, got {wrong or in_short(value)}")
    return array


def finite_array(name: str, value: ArrayLike, shape: tuple[int, ...] | None = None) -> FloatArray:
    """Return `value` as a float64 array with finite entries, of exactly this `shape` if given."""
    array, is_finite = _measured_array(name, value)
    if shape is not None and array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}")
    if not is_finite:
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
        where = f" at index {index}" if index else ""
        raise ValueError(f"{name} must be finite everywhere, got {array[index]}{where}")
    return array


def together(**given: ArrayLike) -> list[FloatArray]:
    """Return finite coordinate arrays, broadcast to a common shape."""
    arrays = {name: finite_array(name, value) for name, value in given.items()}
    try:
        return list(np.broadcast_arrays(*arrays.values()))
    except ValueError:
        shapes = ", ".join(str(array.shape) for array in arrays.values())
        allowed = "equal or compatible shapes"
        raise ValueError(f"{', '.join(arrays)} must have {allowed}, got {shapes}") from None


def gap_array(
    name: str, value: ArrayLike, shape: tuple[int, ...], nobody: float = math.inf
) -> FloatArray:
    """Return `value` as a float64 array of exactly this `shape`, finite in at least one cell.

    nobody: infinite value of cells without a body: +inf for a gap, -inf for heights.
    """
    array, is_finite = _measured_array(name, value)
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}")
    if is_finite and array.size:
        return array
    wrong = ~np.isfinite(array) & (array != nobody)
    if wrong.any():
        index = tuple(int(i) for i in np.argwhere(wrong)[0])
        raise ValueError(
            f"{name} must be finite everywhere, or {nobody:+} where there is no body, got "
            f"{array[index]} at index {index}"
        )
    if not np.isfinite(array).any():
        raise ValueError(
            f"{name} must be finite in at least one cell, got {nobody:+} (no body) in all cells"
        )
    return array


def tractions(name: str, value: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    """Return `value` as a contiguous array of tractions [Pa] with magnitudes <= `MAX_STRESS`."""
    array = np.ascontiguousarray(finite_array(name, value, shape))
    largest = float(np.abs(array).max(initial=0.0))
    if largest > MAX_STRESS:
        raise ValueError(f"{name} must be of magnitude <= {MAX_STRESS:g} Pa, got {largest:.6g}")
    return array


def value_per_body(name: str, value: Any) -> tuple[float, float]:
    """Return a finite float >= 0 for each body: (0, value) if `value` is a single number."""
    given = real_array(name, value)
    pair = [0.0, value] if given.ndim == 0 else list(given)
    if given.ndim > 1 or len(pair) != 2:
        raise ValueError(
            f"{name} must be a number, or a pair (body 1, body 2), got {in_short(value)}"
        )
    return non_negative(name, pair[0]), non_negative(name, pair[1])


def file_path(name: str, value: Any) -> Path:
    """Return `value` as the path of a file or folder."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{name} must be a path, got {in_short(value)}")
    text = os.fsdecode(value)
    if not text or "\0" in text:
        raise ValueError(
            f"{name} must be a path that is not empty and has no NUL character, got {text!r:.80}"
        )
    longest = max(Path(text).parts, key=len, default="")
    if len(os.fsencode(longest)) > MAX_FILE_NAME_BYTES:
        raise ValueError(
            f"each folder and file name in {name} must be at most {MAX_FILE_NAME_BYTES} bytes long "
            f"(limit of file systems), got {in_short(longest)}"
        )
    return Path(text)


def load_or_approach(load: float | None, approach: float | None) -> tuple[str, float]:
    """Return the name and the checked value of load or approach, exactly one of which is given."""
    name = exactly_one(load=load, approach=approach)
    # a negative approach separates the bodies; a negative load requires adhesion
    return name, non_negative("load", load) if name == "load" else finite("approach", approach)

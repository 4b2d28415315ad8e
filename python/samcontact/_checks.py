# SPDX-License-Identifier: GPL-3.0-or-later
"""Argument checks shared by the Python layer: name, value and allowed range in every error."""

from __future__ import annotations

import difflib
import math
import os
import sys
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from itertools import islice
from numbers import Integral, Real
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
MOST_COUNT = (1 << 31) - 1
"""The core counts with 32 bits."""
MOST_CELLS = 1 << 24
"""Along one axis, twice as many for transforms included."""
MOST_STRESS = 1e75
"""Like the largest load and modulus [Pa]: products stay in the range of numbers."""
MOST_STEPS = 100_000
"""Increments of one path: more would take months, and a slip of the pen fills the memory."""


def _has_unit(value: Any) -> bool:
    """Whether it is a quantity, e.g. of pint, whose unit NumPy would drop."""
    return hasattr(value, "to_base_units")


def escaped(text: str) -> str:
    """Text without control characters, which would command a terminal; lines and tabs stay."""
    return "".join(
        repr(c)[1:-1] if unicodedata.category(c) in ("Cc", "Cs") and c not in "\n\t" else c
        for c in text
    )


def number(name: str, value: Any) -> float:
    """Return `value` as a float; raise TypeError unless it is a real number (not a bool)."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    # to NumPy a span of time is an integer
    if isinstance(value, (bool, np.bool_, np.timedelta64)) or not isinstance(value, Real):
        hint = ": convert it with samcontact.units.si" if _has_unit(value) else ""
        raise TypeError(f"{name} must be a number, got {value!r}{hint}")
    try:
        return float(value) + 0.0  # never -0.0
    except OverflowError as error:
        raise ValueError(f"{name} must be a finite number, got one beyond 1e308") from error


def finite(name: str, value: Any) -> float:
    """Return `value` as a finite float."""
    result = number(name, value)
    if not math.isfinite(result):
        raise ValueError(f"{name} must be a finite number, got {result!r}")
    return result


def require_type(name: str, value: Any, kind: type) -> None:
    """Raise TypeError naming the argument unless `value` is a `kind`."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a samcontact.{kind.__name__}, got {value!r}")


def positive(name: str, value: Any, *, allow_inf: bool = False) -> float:
    """Return `value` as a float > 0, finite unless `allow_inf`."""
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
    name: str, value: Any, minimum: int | None = None, largest: int | None = MOST_COUNT
) -> int:
    """Return `value` as an int, >= `minimum`, of a size up to `largest`."""
    if isinstance(value, (bool, np.bool_, np.timedelta64)) or not isinstance(value, Integral):
        raise TypeError(f"{name} must be an integer, got {value!r}")
    if minimum is not None and value < minimum:
        raise ValueError(f"{name} must be an integer >= {minimum}, got {value}")
    count = int(value)
    if largest is not None and abs(count) > largest:
        raise ValueError(f"{name} must be an integer of a size up to {largest}, got {count:.6g}")
    return count


def in_cells(name: str, length: float, step: float) -> float:
    """A length [m] as a number of cells, which the core can count."""
    if not abs(length) <= MOST_CELLS * step:
        raise ValueError(
            f"{name} must be at most {MOST_CELLS * step:.6g} m, {MOST_CELLS} cells of {step!r} m, "
            f"got {length!r} m"
        )
    return length / step


def step_list(name: str, steps: Any, known: Iterable[str]) -> list[dict[str, Any]]:
    """Return `steps` as a list of arguments of `Simulation.step`, whose names are `known`."""
    several = isinstance(steps, Iterable) and not isinstance(steps, Mapping)
    given = list(islice(steps, MOST_STEPS + 1)) if several else [steps]
    if len(given) > MOST_STEPS:
        raise ValueError(f"{name} must have at most {MOST_STEPS} increments, got more")
    wrong = [step for step in given if not (several and isinstance(step, Mapping))]
    if wrong:
        raise TypeError(
            f"{name} must be a list of arguments of step(), e.g. [{{'load': 300.0}}], "
            f"got {wrong[0]!r:.80}"
        )
    known = list(known)
    for number_, step in enumerate(given, 1):
        for key in step:
            if key not in known:
                near = difflib.get_close_matches(str(key), known, 1)
                hint = f": did you mean {near[0]}?" if near else f": one of {', '.join(known)}"
                raise TypeError(f"increment {number_} of {name} has an unknown field {key!r}{hint}")
        exactly_one(**{key: step.get(key) for key in ("load", "approach", "pressure")})
        if step.get("pressure") is None:
            load_or_approach(step.get("load"), step.get("approach"))
    return [dict(step) for step in given]  # the caller's may change meanwhile


def step_count(name: str, value: Any) -> int:
    """Return `value` as a number of increments that a list can hold."""
    count = integer(name, value, 1)
    if count > MOST_STEPS:
        raise ValueError(f"{name} must be at most {MOST_STEPS}, got {count}")
    return count


def choice(name: str, value: Any, allowed: tuple[Any, ...]) -> Any:
    """Return `value` when it is one of `allowed`."""
    if (np.ndim(value) if isinstance(value, np.ndarray) else 0) or value not in allowed:
        listed = ", ".join(repr(item) for item in allowed)
        raise ValueError(f"{name} must be one of {listed}, got {value!r}")
    return allowed[allowed.index(value)]  # 2 where 2.0 was given


def axis_number(axis: Any) -> int:
    """Return 0, 1 or 2 for "x", "y" or "z"."""
    return ("x", "y", "z").index(choice("axis", axis, ("x", "y", "z")))


def require_fast(name: str, method: str, periodic: str) -> None:
    """Raise ValueError for the exact residual stress on a periodic grid."""
    if method == "exact" and periodic:
        raise ValueError(
            f'{name} must be "fast" with grid.periodic = {periodic!r}, got "exact": there are '
            "no closed forms of its lattice sums"
        )


def exactly_one(**given: Any) -> str:
    """Return the name of the only argument that is not None."""
    names = [name for name, value in given.items() if value is not None]
    if len(names) != 1:
        listed = ", ".join(given)
        got = ", ".join(names) if names else "none"
        raise ValueError(f"give exactly one of {listed}; got {got}")
    return names[0]


def real_array(name: str, value: ArrayLike) -> FloatArray:
    """Return `value` as a float64 array of any shape; nothing is lost on the way."""
    if _has_unit(value):
        raise TypeError(f"{name} has a unit: convert it with samcontact.units.si")
    lost = _masked_values(value)
    if lost:  # NumPy would take what lies under the mask
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
    try:
        given = np.asarray(value)
        _require_numbers(given)
        return np.asarray(given, dtype=np.float64)
    except OverflowError as error:
        raise ValueError(f"{name} must be finite everywhere, got a number beyond 1e308") from error
    except (TypeError, ValueError) as error:
        raise TypeError(
            f"{name} must be an array of numbers, got {type(value).__name__}: {error}"
        ) from error


def _masked_values(value: ArrayLike) -> int:
    """How many values are masked: none while nobody has loaded masked arrays, which naming them
    would do, for longer than a small contact takes."""
    if "numpy.ma" not in sys.modules:
        return 0
    parts = value if isinstance(value, (list, tuple)) else (value,)
    return sum(int(np.sum(p.mask)) for p in parts if isinstance(p, np.ma.MaskedArray))


def _require_numbers(given: NDArray[Any]) -> None:
    """NumPy would read texts, count days and take a mask for heights without a word."""
    kinds = {np.dtype(type(v)).kind for v in given.flat} if given.dtype.kind == "O" else set()
    wrong = ({given.dtype.kind} | kinds) - set("iufO")
    if wrong:
        names = {"b": "truth values", "c": "complex numbers", "S": "texts", "U": "texts"}
        names |= {"m": "spans of time", "M": "dates"}
        raise TypeError(" and ".join(sorted({names.get(kind, "records") for kind in wrong})))


def finite_array(name: str, value: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    """Return `value` as a float64 array of exactly this `shape` with finite entries."""
    array = real_array(name, value)
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}")
    finite = np.isfinite(array)
    if not finite.all():
        index = tuple(int(i) for i in np.argwhere(~finite)[0])
        where = f" at index {index}" if index else ""
        raise ValueError(f"{name} must be finite everywhere, got {array[index]}{where}")
    return array


def gap_array(
    name: str, value: ArrayLike, shape: tuple[int, ...], nobody: float = math.inf
) -> FloatArray:
    """Return `value` as a float64 array of exactly this `shape`, finite in at least one cell.

    nobody: the infinity that stands where there is no body, +inf of a gap.
    """
    array = real_array(name, value)
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}")
    wrong = ~np.isfinite(array) & (array != nobody)
    if wrong.any():
        index = tuple(int(i) for i in np.argwhere(wrong)[0])
        raise ValueError(
            f"{name} must be finite everywhere, or {nobody:+} where there is no body, got "
            f"{array[index]} at index {index}"
        )
    if not np.isfinite(array).any():
        raise ValueError(f"{name} must be finite somewhere, got {nobody:+}, no body, everywhere")
    return array


def tractions(name: str, value: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    """Return `value` as a contiguous array of stresses [Pa] that a load can be made of."""
    array = np.ascontiguousarray(finite_array(name, value, shape))
    largest = float(np.abs(array).max(initial=0.0))
    if largest > MOST_STRESS:
        raise ValueError(f"{name} must be of a size up to {MOST_STRESS:g} Pa, got {largest:.6g}")
    return array


def of_bodies(name: str, value: float | Sequence[float]) -> tuple[float, float]:
    """Return `value` as two finite floats >= 0, of body 1 and 2; a single one is of body 2."""
    pair = [0.0, value] if np.ndim(value) == 0 else list(real_array(name, value))
    if len(pair) != 2:
        raise ValueError(f"{name} must be a number or a pair, got {len(pair)} values")
    return non_negative(name, pair[0]), non_negative(name, pair[1])


def file_path(name: str, value: Any) -> Path:
    """Return `value` as the path of a file or folder."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{name} must be a path, got {value!r}")
    text = os.fspath(value)
    if not text or "\0" in text:
        raise ValueError(f"{name} must be a path without NUL that is not empty, got {text!r}")
    return Path(text)


def load_or_approach(load: float | None, approach: float | None) -> tuple[str, float]:
    """Return the name and value of the only one that is given."""
    name = exactly_one(load=load, approach=approach)
    # an approach below zero separates the bodies; a negative load would be adhesion
    return name, non_negative("load", load) if name == "load" else finite("approach", approach)

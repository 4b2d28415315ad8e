# SPDX-License-Identifier: GPL-3.0-or-later
"""Argument checks shared by the Python layer: name, value and allowed range in every error."""

from __future__ import annotations

import math
from numbers import Integral, Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
MOST_STEPS = 100_000
"""Increments of one path: more would take months, and a slip of the pen fills the memory."""


def _has_unit(value: Any) -> bool:
    """Whether it is a quantity, e.g. of pint, whose unit NumPy would drop."""
    return hasattr(value, "to_base_units")


def number(name: str, value: Any) -> float:
    """Return `value` as a float; raise TypeError unless it is a real number (not a bool)."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Real):
        hint = ": convert it with samcontact.units.si" if _has_unit(value) else ""
        raise TypeError(f"{name} must be a number, got {value!r}{hint}")
    return float(value)


def finite(name: str, value: Any) -> float:
    """Return `value` as a finite float."""
    result = number(name, value)
    if not math.isfinite(result):
        raise ValueError(f"{name} must be a finite number, got {result!r}")
    return result


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


def integer(name: str, value: Any, minimum: int | None = None) -> int:
    """Return `value` as an int, >= `minimum`."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Integral):
        raise TypeError(f"{name} must be an integer, got {value!r}")
    if minimum is not None and value < minimum:
        raise ValueError(f"{name} must be an integer >= {minimum}, got {value}")
    return int(value)


def step_count(name: str, value: Any) -> int:
    """Return `value` as a number of increments that a list can hold."""
    count = integer(name, value, 1)
    if count > MOST_STEPS:
        raise ValueError(f"{name} must be at most {MOST_STEPS}, got {count}")
    return count


def choice(name: str, value: Any, allowed: tuple[Any, ...]) -> Any:
    """Return `value` when it is one of `allowed`."""
    if value not in allowed:
        listed = ", ".join(repr(item) for item in allowed)
        raise ValueError(f"{name} must be one of {listed}, got {value!r}")
    return value


def exactly_one(**given: Any) -> str:
    """Return the name of the only argument that is not None."""
    names = [name for name, value in given.items() if value is not None]
    if len(names) != 1:
        listed = ", ".join(given)
        got = ", ".join(names) if names else "none"
        raise ValueError(f"give exactly one of {listed}; got {got}")
    return names[0]


def finite_array(name: str, value: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    """Return `value` as a float64 array of exactly this `shape` with finite entries."""
    if _has_unit(value):
        raise TypeError(f"{name} has a unit: convert it with samcontact.units.si")
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise TypeError(
            f"{name} must be an array of numbers, got {type(value).__name__}"
        ) from error
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}")
    bad = np.argwhere(~np.isfinite(array))
    if len(bad):
        index = tuple(int(i) for i in bad[0])
        where = f" at index {index}" if index else ""
        raise ValueError(f"{name} must be finite everywhere, got {array[index]}{where}")
    return array


def load_or_approach(load: float | None, approach: float | None) -> tuple[str, float]:
    """Return the name and value of the only one that is given."""
    name = exactly_one(load=load, approach=approach)
    # an approach below zero separates the bodies; a negative load would be adhesion
    return name, non_negative("load", load) if name == "load" else finite("approach", approach)

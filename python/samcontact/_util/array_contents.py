# SPDX-License-Identifier: GPL-3.0-or-later
"""Search for values in arrays and nested lists that are not real numbers."""

from __future__ import annotations

import sys
from decimal import Decimal
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

NON_REAL_TYPES = (bool, np.bool_, np.timedelta64)
"""Types that are numbers according to Python or NumPy, but not real numbers."""


def masked_values(value: ArrayLike) -> int:
    """Return the number of masked values in an array, or in a list of arrays.

    `numpy.ma` is not imported for this check, because the import takes longer than solving a small
    contact. If another thread is importing it, the check does not wait for the end of the import:
    in a forked process this thread does not exist, and the check would wait indefinitely.
    """
    masked = getattr(sys.modules.get("numpy.ma"), "MaskedArray", None)
    if masked is None:
        return 0
    parts = value if isinstance(value, (list, tuple)) else (value,)
    return sum(int(np.sum(p.mask)) for p in parts if isinstance(p, masked))


def not_numbers(value: ArrayLike, given: NDArray[Any]) -> set[str]:
    """Name the types in `value` that are not real numbers, e.g. "complex numbers"."""
    names = {"b": "Boolean values", "c": "complex numbers", "S": "texts", "U": "texts"}
    names |= {"m": "time spans", "M": "dates"}
    if given.dtype.kind not in "iufO":
        return {names.get(given.dtype.kind, "records")}
    # NumPy converts a list of Boolean values and numbers to an array of numbers
    kinds = _kinds(given.flat if given.dtype.kind == "O" else value)
    wrong = {
        k for k in kinds if not issubclass(k, (Real, Decimal)) or issubclass(k, NON_REAL_TYPES)
    }
    return {names.get(np.dtype(k).kind, k.__name__.removesuffix("Type")) for k in wrong}


def _kinds(value: Any) -> set[type]:
    """Return the types of all entries of nested lists and arrays."""
    if isinstance(value, np.ndarray):
        return {value.dtype.type}
    if not isinstance(value, (list, tuple, np.flatiter)):
        return set()
    found = set(map(type, value))
    if not any(issubclass(kind, (list, tuple, np.ndarray)) for kind in found):
        return found
    return set().union(*(_kinds(item) for item in value))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of values with units to numbers in SI units, by the package pint.

``sc.units.si("210 GPa", "Pa")`` is 210e9. Case files accept such strings directly.
"""

from __future__ import annotations

import math
import re
import sys
from decimal import Decimal, DecimalException
from functools import lru_cache
from typing import Any

import numpy as np

from ._util.short_text import MAX_CHARACTERS, in_short

__all__ = ["si"]

_TEXT = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", re.DOTALL)


@lru_cache(maxsize=1)
def _registry() -> Any:
    if sys.modules.get("pint", sys) is None:  # hidden from xarray in a process of a command
        del sys.modules["pint"]
    try:
        import pint
    except ImportError as error:
        raise ImportError(
            "values with units require pint: pip install samcontact[units], or use plain numbers "
            "in SI units"
        ) from error
    # decimal: "25 um" is then exactly 25e-6, unlike 25 * 1e-6 in floating point
    return pint.UnitRegistry(non_int_type=Decimal)


def from_text(text: str, unit: str) -> float:
    """Convert a text such as "25 um" to a number in the given unit.

    Raises ValueError for any other text; the message begins with "must be", so that the caller can
    put the name of the value before it.
    """
    allowed = (
        f"a number and a unit that converts to {unit}" if unit else "a number, or a percentage"
    )
    match = _TEXT.fullmatch(text) if len(text) <= MAX_CHARACTERS else None
    # pint reads up to a semicolon, comment or new line, and ignores the rest
    if match is None or not match.group(2) or re.search(r"[;#\n\r]", match.group(2)):
        raise ValueError(f"must be {allowed}, got {in_short(text)}")
    registry = _registry()
    try:
        number = Decimal(match.group(1))
        # number and unit separately: temperatures such as "20 degC" cannot be multiplied
        exact = registry.Quantity(number, match.group(2)).to(unit).magnitude
        found = float(exact)
    except (DecimalException, OverflowError):
        raise ValueError(
            f"must be within the range of floating-point numbers, got {in_short(text)}"
        ) from None
    except Exception as error:  # pint also raises errors of the Python tokenizer
        raise ValueError(f"must be {allowed}, got {in_short(text)}") from error
    if math.isinf(found) or (found == 0.0 and exact != 0):
        raise ValueError(
            f"must be within the range of floating-point numbers, got {in_short(text)}"
        )
    return found


def si(value: Any, unit: str) -> Any:
    """Convert a quantity to an SI unit.

    Parameters
    ----------
    value : str, pint.Quantity, float or array_like
        Text such as "1.5 GPa", "25 um", "120 degC", or a quantity of any pint registry, including
        arrays. Numbers without a unit are SI values and are returned unchanged.
    unit : str
        SI unit of the result, e.g. "Pa", "m", "N", "rad", "K", "m**2/s".

    Returns
    -------
    float or ndarray

    Raises
    ------
    ValueError
        The text has no unit, the unit is unknown or has another dimension, or the number exceeds
        the range of floating-point numbers.
    ImportError
        pint is not installed and the value is text.

    Notes
    -----
    Units are converted by pint (https://pint.readthedocs.io).
    """
    if not isinstance(unit, str) or not unit or len(unit) > MAX_CHARACTERS:
        raise ValueError(f'unit must be the name of a unit, such as "Pa", got {in_short(unit)}')
    if isinstance(value, str):
        try:
            return from_text(value, unit)
        except ValueError as error:
            raise ValueError(f"value {error}") from error
    if hasattr(value, "to") and hasattr(value, "magnitude"):
        try:
            value = value.to(unit).magnitude
        except Exception as error:  # errors of a foreign pint registry
            raise ValueError(
                f"value must have a unit that converts to {unit}, got {in_short(value)}"
            ) from error
    if np.ma.is_masked(value):
        raise ValueError("value must be defined everywhere, got masked values")
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "iufO":
            raise TypeError
        array = array.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(
            f"value must be a number, a quantity or text, got {in_short(value)}"
        ) from None
    return float(array) if array.ndim == 0 else array

# SPDX-License-Identifier: GPL-3.0-or-later
"""Values with units, converted to the SI numbers that every function takes; needs pint.

``sc.units.si("210 GPa", "Pa")`` is 210e9. Case files take such strings by themselves.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal, DecimalException
from functools import lru_cache
from typing import Any

import numpy as np

from ._util.short_text import LONGEST, in_short

__all__ = ["si"]

_TEXT = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", re.DOTALL)


@lru_cache(maxsize=1)
def _registry() -> Any:
    try:
        import pint
    except ImportError as error:
        raise ImportError(
            "values with units need pint: pip install samcontact[units]; or give plain numbers in "
            "SI units"
        ) from error
    # decimal: "25 um" is then the very number 25e-6, which 25 * 1e-6 in floats is not
    return pint.UnitRegistry(non_int_type=Decimal)


def from_text(text: str, unit: str) -> float:
    """Number of a text such as "25 um" in this unit; a ValueError that begins with "must be"."""
    allowed = (
        f"a number and a unit that converts to {unit}" if unit else "a number, or a percentage"
    )
    match = _TEXT.fullmatch(text) if len(text) <= LONGEST else None
    # pint reads up to a semicolon, comment or new line, and forgets the rest
    if match is None or not match.group(2) or re.search(r"[;#\n\r]", match.group(2)):
        raise ValueError(f"must be {allowed}, got {in_short(text)}")
    registry = _registry()
    try:
        number = Decimal(match.group(1))
        # number and unit apart: temperatures such as "20 degC" cannot be multiplied
        exact = registry.Quantity(number, match.group(2)).to(unit).magnitude
        found = float(exact)
    except (DecimalException, OverflowError):
        raise ValueError(f"must be within the range of numbers, got {in_short(text)}") from None
    except Exception as error:  # pint lets errors of Python's tokenizer through as well
        raise ValueError(f"must be {allowed}, got {in_short(text)}") from error
    if math.isinf(found) or (found == 0.0 and exact != 0):
        raise ValueError(f"must be within the range of numbers, got {in_short(text)}")
    return found


def si(value: Any, unit: str) -> Any:
    """Value of a quantity in an SI unit.

    Parameters
    ----------
    value : str, pint.Quantity, float or array_like
        "1.5 GPa", "25 um", "120 degC"; or a quantity of any registry, also of an array. Numbers
        without a unit are returned as they are: they are SI already.
    unit : str
        The wanted unit, e.g. "Pa", "m", "N", "rad", "K", "m**2/s".

    Returns
    -------
    float or ndarray

    Raises
    ------
    ValueError
        The text has no unit, the unit is unknown or of another dimension, or the number is beyond
        the range of numbers.
    ImportError
        pint is not installed and the value is a text.

    Notes
    -----
    Units and their conversion are those of pint (https://pint.readthedocs.io).
    """
    if not isinstance(unit, str) or not unit or len(unit) > LONGEST:
        raise ValueError(f'unit must be the name of a unit, such as "Pa", got {in_short(unit)}')
    if isinstance(value, str):
        try:
            return from_text(value, unit)
        except ValueError as error:
            raise ValueError(f"value {error}") from error
    if hasattr(value, "to") and hasattr(value, "magnitude"):
        try:
            value = value.to(unit).magnitude
        except Exception as error:  # the errors of a pint that need not be ours
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
            f"value must be a number, a quantity or a text, got {in_short(value)}"
        ) from None
    return float(array) if array.ndim == 0 else array

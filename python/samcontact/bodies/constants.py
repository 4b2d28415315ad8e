# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of material constants, each given as one number or several numbers, to floats."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from .._util.checks import number
from .._util.short_text import in_short


def as_list(value: Any) -> list[Any]:
    """Return the elements of an iterable, or a single value, as a list."""
    value = value.tolist() if isinstance(value, np.ndarray) else value
    return list(value) if isinstance(value, Iterable) else [value]


def named_numbers(name: str, parts: Sequence[str], given: Any) -> tuple[float, ...]:
    """Return several constants that are given together as floats.

    name: name of the whole, for error messages; parts: names of the constants. Raises ValueError
    unless there is one constant for each name in `parts`.
    """
    values = as_list(given)
    if len(values) != len(parts):
        raise ValueError(f"{name} must contain {', '.join(parts)}, got {in_short(given)}")
    return tuple(number(part, value) for part, value in zip(parts, values, strict=True))

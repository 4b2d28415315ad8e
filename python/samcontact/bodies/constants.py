# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of material constants to floats; a constant may be one number or several."""

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
    """Convert the constants of a group, such as modulus and recovery, to floats.

    name: name of the group, for error messages; parts: names of its constants; given: their values.
    Raises ValueError unless there is one value for each name in `parts`.
    """
    values = as_list(given)
    if len(values) != len(parts):
        raise ValueError(
            f"{name} must contain {', '.join(parts)}, one number each, got {in_short(given)}"
        )
    return tuple(number(part, value) for part, value in zip(parts, values, strict=True))

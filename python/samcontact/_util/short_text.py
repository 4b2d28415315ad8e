# SPDX-License-Identifier: GPL-3.0-or-later
"""Short one-line texts of arbitrary values, for messages and reprs."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Mapping, Set
from typing import Any

import numpy as np

MAX_CHARACTERS = 80
"""Maximum number of characters of a value in a message."""


def escaped(text: str) -> str:
    """Escape all control characters except line breaks and tabs."""
    return "".join(
        repr(c)[1:-1] if unicodedata.category(c) in ("Cc", "Cs") and c not in "\n\t" else c
        for c in text
    )


def in_short(value: Any, longest: int = MAX_CHARACTERS) -> str:
    """Return a repr of at most `longest` characters; large values are given by type and size."""
    if isinstance(value, np.ndarray) and value.ndim > 0:
        return _array(value)
    if isinstance(value, int) and value.bit_length() > 3 * longest:
        return f"<int of about {math.ceil(value.bit_length() * math.log10(2))} digits>"
    if isinstance(value, (str, bytes)) and len(value) > longest:
        return _cut(repr(value[:longest]), longest)
    if isinstance(value, (list, tuple, Set, Mapping)) and len(value) > longest // 10:
        return f"<{type(value).__name__} of {len(value)}>"
    try:
        text = escaped(repr(value))
    except Exception:  # raised by a user class, or by a number of 5000 digits
        return f"<{type(value).__name__}>"
    if len(text) <= longest and "\n" not in text:
        return text
    if isinstance(value, (str, bytes)):
        return _cut(text, longest)
    return f"<{type(value).__name__}>"[:longest]


def _cut(text: str, longest: int) -> str:
    """Truncate the repr of a text to `longest` characters, with closing quotation mark."""
    return f"{text[: longest - 4].rstrip(text[-1])}...{text[-1]}"


def _array(value: Any) -> str:
    shape = " x ".join(map(str, value.shape))
    if value.dtype.kind not in "iuf":
        return f"<array {shape} of {value.dtype}>"[:MAX_CHARACTERS]
    known = value[~np.isnan(value)] if value.dtype.kind == "f" else value
    span = f", {known.min():.4g} to {known.max():.4g}" if known.size else ""
    lost = f", {value.size - known.size} NaN" if known.size < value.size else ""
    return f"<array {shape}{span}{lost}>"[:MAX_CHARACTERS]

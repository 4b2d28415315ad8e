# SPDX-License-Identifier: GPL-3.0-or-later
"""Lubricants as text, for the attributes of results files."""

from __future__ import annotations

import json
from dataclasses import fields, is_dataclass
from typing import Any

from .density import DowsonHigginson, Incompressible, TabulatedDensity, Tait
from .lubricant import Lubricant, LubricantHeat
from .shear import Carreau, Eyring, Newtonian
from .viscosity import Barus, Doolittle, Roelands, Tabulated

_KINDS: dict[str, Any] = {
    kind.__name__: kind
    for kind in (
        Lubricant, LubricantHeat, Barus, Roelands, Doolittle, Tabulated, Incompressible,
        DowsonHigginson, Tait, TabulatedDensity, Newtonian, Eyring, Carreau,
    )
}  # fmt: skip


def stored(lubricant: Lubricant) -> str:
    """Return the constants of a lubricant as text (JSON), from which `restored` recreates it."""
    return json.dumps(_plain(lubricant))


def restored(text: str) -> Lubricant:
    """Return the lubricant that a text from `stored` describes.

    Raises ValueError for other texts.
    """
    try:
        made = _made(json.loads(text))
    except (KeyError, TypeError, ValueError, RecursionError) as error:
        raise ValueError(
            "text must describe a lubricant as `stored` does, got a text whose reading raised "
            f"{type(error).__name__}"
        ) from error
    if not isinstance(made, Lubricant):
        raise ValueError("text must describe a lubricant, got a text of another object")
    return made


def _plain(value: Any) -> Any:
    if not is_dataclass(value):
        return value
    named = {item.name: _plain(getattr(value, item.name)) for item in fields(value)}
    return {"kind": type(value).__name__, **named}


def _made(value: Any) -> Any:
    if not isinstance(value, dict):
        return value
    named = {name: _made(inner) for name, inner in value.items() if name != "kind"}
    return _KINDS[value["kind"]](**named)

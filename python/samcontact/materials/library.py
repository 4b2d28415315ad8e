# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of the library of materials, and search by name."""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping

from .._util.frozen import FrozenDict
from .._util.short_text import in_short
from .data import DATA
from .entry import UNITS, MaterialData, SourcedValue

__all__ = ["get", "names"]

ADVICE = "use Material with your own constants for other materials"
"""Remedy for a material that the library does not have."""


def names() -> tuple[str, ...]:
    """Return the names of all materials of the library."""
    return tuple(_LIBRARY)


def get(name: str) -> MaterialData:
    """Return the constants of a material with their sources.

    Parameters
    ----------
    name : str
        Name or other designation, e.g. "52100", "100Cr6", "Inconel 718". Capitals, spaces, hyphens
        and the prefix "AISI" do not matter.

    Returns
    -------
    MaterialData

    Raises
    ------
    ValueError
        The library has no such material; the message lists all names.
    TypeError
        The name is not text.
    """
    if not isinstance(name, str):
        raise TypeError(f"name must be text, got {in_short(name)}")
    key = _plain(name)
    if key not in _BY_NAME:
        near = difflib.get_close_matches(key, _BY_NAME, 1)
        hint = f" (did you mean {_BY_NAME[near[0]]}?)" if near else ""
        raise ValueError(
            f"name must be one of {', '.join(_LIBRARY)}, got {in_short(name)}{hint}: {ADVICE}"
        )
    return _LIBRARY[_BY_NAME[key]]


def _plain(name: str) -> str:
    return re.sub(r"[^a-z0-9]", "", name.lower()).removeprefix("aisi").removeprefix("en")


def _entry(name: str) -> MaterialData:
    description, aliases, rows = DATA[name]
    values = {
        constant: SourcedValue(value, UNITS[constant], source, condition)
        for constant, value, source, condition in rows
    }
    if {"conductivity", "density", "specific_heat"} <= set(values) and "diffusivity" not in values:
        values["diffusivity"] = _diffusivity(values)
    order = [constant for constant in UNITS if constant in values]
    return MaterialData(
        name, description, FrozenDict({constant: values[constant] for constant in order}), aliases
    )


def _diffusivity(values: Mapping[str, SourcedValue]) -> SourcedValue:
    per_volume = values["density"].value * values["specific_heat"].value
    return SourcedValue(
        values["conductivity"].value / per_volume,
        UNITS["diffusivity"],
        "conductivity / (density specific_heat)",
        "computed from the values of this entry",
    )


_LIBRARY = {name: _entry(name) for name in DATA}
_BY_NAME = {
    _plain(known): name for name, entry in _LIBRARY.items() for known in (name, *entry.aliases)
}

# SPDX-License-Identifier: GPL-3.0-or-later
"""Material laws with their constants and ranges.

The compiled core defines the hardening laws, which are listed in `LAWS`. For each law, `Material`
has a class method of the same name. Checks, case files, tables and checkpoints use `LAWS`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import _core
from .._util.checks import number, real_array
from .._util.frozen import FrozenDict
from .._util.short_text import in_short


@dataclass(frozen=True)
class Constant:
    """Parameter of a law: unit, limits, and whether the value is a list of numbers."""

    unit: str = ""
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None
    many: bool = False
    infinite: bool = False
    """Whether the constant may be infinite."""


@dataclass(frozen=True)
class Law:
    """Description and constants of a law."""

    says: str
    """One-line description."""
    constants: Mapping[str, Constant]
    """Constants, in the order of the arguments of the class method."""
    yields: bool = False


def constant_of(parameter: _core.LawParameter) -> Constant:
    """Convert a law parameter, as described by the compiled core, to a `Constant`."""
    low: dict[str, float] = {}
    if parameter.low > -math.inf:
        low = {"gt" if parameter.above_low else "ge": parameter.low}
    high = parameter.high if parameter.high < math.inf else None
    infinite = parameter.infinite is not None
    return Constant(parameter.unit, **low, le=high, many=parameter.many, infinite=infinite)


_ELASTIC_CONSTANTS = {"E": Constant("Pa", gt=0.0), "nu": Constant(ge=0.0, lt=0.5)}
_CORE_LAWS = {
    law.name: Law(
        law.says, _ELASTIC_CONSTANTS | {p.name: constant_of(p) for p in law.parameters}, law.yields
    )
    for law in _core.hardening_laws()
}
LAWS: Mapping[str, Law] = {
    "elastic": _CORE_LAWS["elastic"],
    "rigid": Law("Body that does not deform.", {}),
    **_CORE_LAWS,
}


def _values(name: str, given: Any) -> tuple[float, ...]:
    values = real_array(name, given)
    if values.ndim != 1:
        raise ValueError(f"{name} must be a list of numbers, got shape {values.shape}")
    return tuple((values + 0.0).tolist())


def checked_constants(law: str, given: Any) -> FrozenDict[Any]:
    """Return the constants of a law in their defined order, after checks of names and types.

    The compiled core checks the ranges.
    """
    if not isinstance(law, str) or law not in LAWS:
        raise ValueError(f"law must be one of {', '.join(LAWS)}, got {in_short(law)}")
    if not isinstance(given, Mapping):
        raise TypeError(f"parameters must be a mapping of names to numbers, got {in_short(given)}")
    names = LAWS[law].constants
    if set(given) != set(names):
        raise ValueError(
            f"parameters of {law!r} must be {', '.join(names) or 'none'}, got "
            f"{', '.join(map(str, given)) or 'none'}: create the material with "
            f"Material.{law}(...)"
        )
    return FrozenDict(
        {
            name: (_values if constant.many else number)(name, given[name])
            for name, constant in names.items()
        }
    )


def core_material(law: str, constants: Mapping[str, Any]) -> _core.Material:
    """Create the material of the compiled core.

    Raises ValueError, which names the constant, if a constant is out of range.
    """
    if law == "rigid":
        return _core.Material.rigid()
    values = {name: np.atleast_1d(value).tolist() for name, value in constants.items()}
    (E,), (nu,) = values.pop("E"), values.pop("nu")
    return _core.Material.with_law(E, nu, law, values)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of materials: of each its constants, and the work of its yield stress.

A law is a factory of the core's `Material` by the same name, an entry of `LAWS`, and a factory of
`Material` in Python. Case files, tables and checkpoints take it from here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ._checks import FloatArray, number
from ._frozen import FrozenDict

Constants = Mapping[str, float]


@dataclass(frozen=True)
class Constant:
    """A parameter of a law: its unit, and its limits as case files check them."""

    unit: str = ""
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None


@dataclass(frozen=True)
class Law:
    """What all materials of a law share."""

    says: str
    """In a line."""
    constants: Mapping[str, Constant]
    """In the order of the factory."""
    work: Callable[[Constants, FloatArray], FloatArray] | None = None
    """Integral of the yield stress up to an equivalent plastic strain [J/m^3]; None: no yield."""


_E = {"E": Constant("Pa", gt=0.0), "nu": Constant(ge=0.0, lt=0.5)}
_STRESS = Constant("Pa", gt=0.0)


def _perfect_work(of: Constants, g: FloatArray) -> FloatArray:
    return of["yield_stress"] * g


def _linear_work(of: Constants, g: FloatArray) -> FloatArray:
    modulus = of["tangent_modulus"] / (1.0 - of["tangent_modulus"] / of["E"])
    return (of["yield_stress"] + 0.5 * modulus * g) * g


def _swift_work(of: Constants, g: FloatArray) -> FloatArray:
    # s^(n+1) (1 - (C/s)^(n+1)) with s = C + 1e6 g, without cancellation where g is small
    power, s = of["n"] + 1.0, of["C"] + 1e6 * g
    part = np.minimum(1e6 * g / s, 1.0 - 2.0**-53)  # 1: C is nothing beside the strain
    grown = -np.expm1(power * np.log1p(-part))
    return np.asarray(of["B"] * s ** of["n"] * (s * grown / (1e6 * power)))


LAWS: Mapping[str, Law] = {
    "elastic": Law("Linear elasticity.", _E),
    "rigid": Law("A body that does not deform.", {}),
    "perfect_plastic": Law(
        "Elastic, perfectly plastic.", _E | {"yield_stress": _STRESS}, _perfect_work
    ),
    "linear_hardening": Law(
        "Linear isotropic hardening; tangent modulus of the uniaxial curve.",
        _E | {"yield_stress": _STRESS, "tangent_modulus": Constant("Pa", ge=0.0)},
        _linear_work,
    ),
    "swift": Law(
        "Swift hardening B (C + 1e6 g)^n.",
        _E | {"B": _STRESS, "C": Constant("microstrain", gt=0.0), "n": Constant(ge=0.0, le=1.0)},
        _swift_work,
    ),
}


def checked_constants(law: str, given: Any) -> FrozenDict[float]:
    """Numbers for all constants of a law, in its order; their ranges are checked by the core."""
    if not isinstance(law, str) or law not in LAWS:
        raise ValueError(f"law must be one of {', '.join(LAWS)}, got {law!r}")
    if not isinstance(given, Mapping):
        raise TypeError(f"parameters must be a mapping of names to numbers, got {given!r}")
    names = LAWS[law].constants
    if set(given) != set(names):
        raise ValueError(
            f"parameters of {law!r} must be {', '.join(names) or 'none'}, "
            f"got {', '.join(map(str, given)) or 'none'}: use Material.{law}(...)"
        )
    return FrozenDict({name: number(name, given[name]) for name in names})

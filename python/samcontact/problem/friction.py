# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction laws. Each class corresponds to a law of the core with the same name.

The core defines the parameters of a law, their ranges and the bound of the shear traction. Checks,
case files, results and checkpoints use these definitions.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, ClassVar

from numpy.typing import ArrayLike

from .. import _core
from .._util.checks import FloatArray, finite_array, non_negative, number
from .._util.display import HtmlTable, Rows, quantity
from .._util.short_text import in_short
from ..bodies.hardening_laws import Constant, constant_of

__all__ = ["CappedCoulomb", "Coulomb", "Tresca"]

_CORE_LAWS = {name: (sticks, parameters) for name, sticks, parameters in _core.friction_laws()}
LAWS: dict[str, type[FrictionLaw]] = {}
"""Friction laws by their names in case files, results and checkpoints."""


@dataclass(frozen=True)
class FrictionLaw(HtmlTable):
    """Friction law: bound of the shear traction as a function of the pressure."""

    law: ClassVar[str]
    """Name of the law in case files and results."""
    sticks: ClassVar[bool]
    """Whether cells stick if their shear is below the bound; otherwise all cells slide along x."""
    constants: ClassVar[Mapping[str, Constant]]
    """Parameters of the law and their ranges."""

    def __init_subclass__(cls) -> None:
        cls.law = re.sub(r"(?<!^)(?=[A-Z])", "_", cls.__name__).lower()
        cls.sticks, parameters = _CORE_LAWS[cls.law]
        cls.constants = {one.name: constant_of(one) for one in parameters}
        LAWS[cls.law] = cls

    def __post_init__(self) -> None:
        for item in fields(self):
            object.__setattr__(self, item.name, number(item.name, getattr(self, item.name)))
        self.to_core()  # checks the ranges

    def to_core(self) -> _core.FrictionLaw:
        """Return the law as an object of the core; raise ValueError for an invalid parameter."""
        return _core.FrictionLaw(self.law, asdict(self))

    def bound(self, pressure: ArrayLike) -> FloatArray:
        """Return the maximum shear [Pa] for a pressure [Pa]: 0 out of contact, inf without slip."""
        bound: FloatArray = self.to_core().bound(finite_array("pressure", pressure))
        return bound

    def ratio(self, pressure: float) -> float:
        """Return maximum shear / pressure [-], which never increases with the pressure [Pa]."""
        return self.to_core().ratio(non_negative("pressure", pressure))

    @property
    def sliding_ratio(self) -> float:
        """Shear / pressure in full sliding [-]; 0 for laws with partial slip."""
        return 0.0 if self.sticks else self.ratio(0.0)

    @property
    def is_frictionless(self) -> bool:
        """Whether the shear traction is zero under any pressure."""
        return float(self.bound(1.0)) == 0.0

    @property
    def prevents_slip(self) -> bool:
        """Whether the shear traction is unbounded, so that no cell slips."""
        return math.isinf(float(self.bound(1.0)))

    @property
    def given(self) -> float | FrictionLaw:
        """Value of the argument `friction` that selects this law."""
        return self

    def to_tree(self) -> dict[str, Any]:
        """Return the name and the parameters of the law, from which `law_of` restores the law."""
        return {"law": self.law, **asdict(self)}

    def _rows(self) -> Rows:
        units = {name: constant.unit for name, constant in self.constants.items()}
        return [(name, quantity(getattr(self, name), unit)) for name, unit in units.items()]


@dataclass(frozen=True, repr=False)
class GrossSliding(FrictionLaw):
    """Full sliding along x with the shear traction mu p; selected by friction = mu."""

    coefficient: float

    @property
    def given(self) -> float:
        """Coefficient of friction [-]."""
        return self.coefficient

    def __repr__(self) -> str:
        return repr(self.coefficient)


@dataclass(frozen=True)
class Coulomb(FrictionLaw):
    """Coulomb friction with partial slip, for `ContactSolver` and `Simulation`.

    The shear traction is at most mu p. Cells with a smaller shear traction stick. Cells whose shear
    traction equals mu p slip in the direction of the shear traction.

    Attributes
    ----------
    coefficient : float
        Coefficient of friction mu [-], >= 0. With `math.inf`, no cell under pressure slips; a
        cell in contact at zero pressure may slip, and may also transmit shear.

    Raises
    ------
    ValueError, TypeError
        The coefficient is negative, NaN or not a number.
    """

    coefficient: float


@dataclass(frozen=True)
class Tresca(FrictionLaw):
    """Friction with a constant shear strength of the interface, independent of the pressure.

    The shear traction is at most the shear strength k in all contact cells. At the edge of the
    contact, the shear traction is discontinuous. With dissimilar materials, neither contact nor
    separation may then be consistent in cells at the edge, and a small tolerance may not be
    reached.

    Attributes
    ----------
    limit : float
        Shear strength k [Pa], >= 0. `math.inf` prevents slip.

    Raises
    ------
    ValueError, TypeError
        The limit is negative, NaN or not a number.
    """

    limit: float


@dataclass(frozen=True)
class CappedCoulomb(FrictionLaw):
    """Coulomb friction with a limit of the shear, such as the shear strength of the softer body.

    The shear traction is at most min(mu p, k).

    Attributes
    ----------
    coefficient : float
        Coefficient of friction mu [-], >= 0 and finite.
    limit : float
        Shear limit k [Pa], >= 0. `math.inf` gives Coulomb friction without a limit.

    Raises
    ------
    ValueError, TypeError
        A parameter is negative, NaN or not a number, or the coefficient is infinite.
    """

    coefficient: float
    limit: float


def is_law(friction: Any) -> bool:
    """Whether a value is a friction law."""
    return isinstance(friction, FrictionLaw)


def friction_law(
    friction: float | FrictionLaw, of_number: Callable[[float], FrictionLaw] = GrossSliding
) -> FrictionLaw:
    """Return a friction law unchanged, or full sliding for a coefficient of friction."""
    return friction if isinstance(friction, FrictionLaw) else of_number(friction)


def sticking_law(friction: Any) -> FrictionLaw:
    """Return a friction law with partial slip; raise TypeError for other values or full sliding."""
    if not (isinstance(friction, FrictionLaw) and friction.sticks):
        raise TypeError(
            f"friction must be a law such as samcontact.Coulomb(mu), got {in_short(friction)}"
        )
    return friction


def law_of(tree: Mapping[str, Any]) -> FrictionLaw:
    """Return the law that `FrictionLaw.to_tree` has stored as a dictionary.

    Raises LookupError, TypeError or ValueError for other content.
    """
    given = dict(tree)
    return LAWS[given.pop("law")](**given)


_ATTRIBUTE_PREFIX = "friction_"


def attributes_of(law: FrictionLaw) -> dict[str, Any]:
    """Return the attributes of results: friction_law and the parameters (friction_...)."""
    return {f"{_ATTRIBUTE_PREFIX}{name}": value for name, value in law.to_tree().items()}


def law_of_attributes(attributes: Mapping[Any, Any]) -> FrictionLaw | None:
    """Return the friction law from the attributes of results; None if they contain none."""
    law = LAWS.get(str(attributes.get(f"{_ATTRIBUTE_PREFIX}law")))
    if law is None:
        return None
    return law(**{name: float(attributes[f"{_ATTRIBUTE_PREFIX}{name}"]) for name in law.constants})

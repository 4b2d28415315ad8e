# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction laws; each class corresponds to the law of its name in the core.

The core defines the parameters of a law, their ranges and its shear bound; checks, case files,
results and checkpoints follow from these definitions.
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
    """Whether cells stick below the bound; if not, all cells slide along x."""
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
        """Friction law of the core; raises ValueError naming a parameter that is out of range."""
        return _core.FrictionLaw(self.law, asdict(self))

    def bound(self, pressure: ArrayLike) -> FloatArray:
        """Maximum shear under a pressure [Pa]: 0 out of contact, inf without slip."""
        bound: FloatArray = self.to_core().bound(finite_array("pressure", pressure))
        return bound

    def ratio(self, pressure: float) -> float:
        """Maximum shear over pressure [-]; it does not increase with the pressure."""
        return self.to_core().ratio(non_negative("pressure", pressure))

    @property
    def sliding_ratio(self) -> float:
        """Shear over pressure in full sliding [-]; 0 for laws with partial slip."""
        return 0.0 if self.sticks else self.ratio(0.0)

    @property
    def is_frictionless(self) -> bool:
        """Whether there is no shear."""
        return float(self.bound(1.0)) == 0.0

    @property
    def prevents_slip(self) -> bool:
        """Whether the shear has no bound."""
        return math.isinf(float(self.bound(1.0)))

    @property
    def given(self) -> float | FrictionLaw:
        """Value of the argument `friction` for this law."""
        return self

    def to_tree(self) -> dict[str, Any]:
        """Name and parameters, from which `law_of` restores the law."""
        return {"law": self.law, **asdict(self)}

    def _rows(self) -> Rows:
        units = {name: constant.unit for name, constant in self.constants.items()}
        return [(name, quantity(getattr(self, name), unit)) for name, unit in units.items()]


@dataclass(frozen=True, repr=False)
class GrossSliding(FrictionLaw):
    """Full sliding along x with the shear mu p; given as the number mu."""

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

    The shear is at most mu p. Cells stick where the shear is smaller, and slip in its direction
    where it equals mu p.

    Attributes
    ----------
    coefficient : float
        mu >= 0 [-]; `math.inf`: no slip.

    Raises
    ------
    ValueError, TypeError
        The coefficient is negative, NaN or not a number.
    """

    coefficient: float


@dataclass(frozen=True)
class Tresca(FrictionLaw):
    """Friction with a constant shear strength of the interface, independent of the pressure.

    The shear is at most k in all contact cells. It jumps at the edge of the contact: with
    dissimilar materials, cells at the edge may then neither touch nor separate, and a small
    tolerance may not be reached.

    Attributes
    ----------
    limit : float
        k >= 0 [Pa]; `math.inf`: no slip.

    Raises
    ------
    ValueError, TypeError
        The limit is negative, NaN or not a number.
    """

    limit: float


@dataclass(frozen=True)
class CappedCoulomb(FrictionLaw):
    """Coulomb friction with a shear limit, such as the shear strength of the softer body.

    The shear is at most min(mu p, k).

    Attributes
    ----------
    coefficient : float
        mu >= 0 [-], finite.
    limit : float
        k >= 0 [Pa]; `math.inf`: Coulomb friction.

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
    """Return a friction law, given as a law or, for full sliding, as a coefficient."""
    return friction if isinstance(friction, FrictionLaw) else of_number(friction)


def sticking_law(friction: Any) -> FrictionLaw:
    """Return a law that allows stick; raise TypeError for anything else, including full sliding."""
    if not (isinstance(friction, FrictionLaw) and friction.sticks):
        raise TypeError(
            f"friction must be a law such as samcontact.Coulomb(mu), got {in_short(friction)}"
        )
    return friction


def law_of(tree: Mapping[str, Any]) -> FrictionLaw:
    """Return the law of a name and parameters; raises LookupError, TypeError or ValueError."""
    given = dict(tree)
    return LAWS[given.pop("law")](**given)


_ATTRIBUTE_PREFIX = "friction_"


def attributes_of(law: FrictionLaw) -> dict[str, Any]:
    """Attributes for results: friction_law, and each parameter, e.g. friction_coefficient."""
    return {f"{_ATTRIBUTE_PREFIX}{name}": value for name, value in law.to_tree().items()}


def law_of_attributes(attributes: Mapping[Any, Any]) -> FrictionLaw | None:
    """Friction law of a results file; None if it has none."""
    law = LAWS.get(str(attributes.get(f"{_ATTRIBUTE_PREFIX}law")))
    if law is None:
        return None
    return law(**{name: float(attributes[f"{_ATTRIBUTE_PREFIX}{name}"]) for name in law.constants})

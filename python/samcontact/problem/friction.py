# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction laws. Each class corresponds to a law of the same name in the compiled core.

The core defines the parameters of a law, their ranges and the bound of the shear traction. Checks,
case files, results and checkpoints use these definitions.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util.cached_property import cached_property
from .._util.checks import FloatArray, finite_array, non_negative, number, positive, real_array
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
    """True: cells stick if their shear is below the bound. False: all cells slide along x."""
    constants: ClassVar[Mapping[str, Constant]]
    """Ranges and units of the parameters of the law, by name."""

    def __init_subclass__(cls) -> None:
        cls.law = re.sub(r"(?<!^)(?=[A-Z])", "_", cls.__name__).lower()
        cls.sticks, parameters = _CORE_LAWS[cls.law]
        cls.constants = {one.name: constant_of(one) for one in parameters}
        LAWS[cls.law] = cls

    def __post_init__(self) -> None:
        for name, constant in self.constants.items():
            checked = _numbers if constant.many else number
            object.__setattr__(self, name, checked(name, getattr(self, name)))
        self.to_core()  # checks the ranges

    def to_core(self) -> _core.FrictionLaw:
        """Return the law as an object of the compiled core; ValueError for invalid parameters."""
        made: _core.FrictionLaw | None = self.__dict__.get("_made")
        if made is None:
            values = {}
            for name in self.constants:
                value = getattr(self, name)
                values[name] = list(value) if isinstance(value, tuple) else [value]
            made = _core.FrictionLaw(self.law, values)
            object.__setattr__(self, "_made", made)  # each solve needs it several times
        return made

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_made"}

    def bound(self, pressure: ArrayLike) -> FloatArray:
        """Return the maximum shear [Pa] at a pressure [Pa]: 0 out of contact, inf if unlimited.

        The result is the maximum over all directions, positions and slip rates.
        """
        bound: FloatArray = self.to_core().bound(finite_array("pressure", pressure))
        return bound

    def ratio(self, pressure: float) -> float:
        """Return the maximum shear at a pressure [Pa], divided by this pressure [-].

        The ratio is constant or decreases with increasing pressure.
        """
        return self.to_core().ratio(non_negative("pressure", pressure))

    @cached_property
    def sliding_ratio(self) -> float:
        """Shear traction divided by pressure in full sliding [-]; 0 for laws with partial slip."""
        return 0.0 if self.sticks else self.to_core().ratio(0.0)

    @cached_property
    def is_frictionless(self) -> bool:
        """Whether the shear traction is zero under any pressure."""
        return self.to_core().ratio(1.0) == 0.0

    @property
    def prevents_slip(self) -> bool:
        """Whether the shear traction is unbounded, so that no cell slips."""
        return math.isinf(self.to_core().ratio(1.0))

    @property
    def needs_duration(self) -> bool:
        """Whether the shear depends on the slip rate, so that increments need a duration."""
        return False

    @property
    def varies_along_x(self) -> bool:
        """Whether the friction varies along x over a body, and thus moves with the body."""
        return False

    @property
    def compliance(self) -> float:
        """Tangential displacement of the layer between the bodies per unit shear [m/Pa], or 0."""
        return 0.0

    @property
    def hardens(self) -> bool:
        """Whether the strength of the layer between the bodies depends on its plastic slip."""
        return False

    @property
    def needs_temperature(self) -> bool:
        """Whether the shear depends on the temperature of the surfaces."""
        return False

    @property
    def given(self) -> float | FrictionLaw:
        """Value of the argument `friction` that selects this law."""
        return self

    def to_tree(self) -> dict[str, Any]:
        """Return the name and the parameters of the law, from which `law_of` restores the law."""
        lists = {name for name, constant in self.constants.items() if constant.many}
        values = {n: list(v) if n in lists else v for n, v in asdict(self).items()}
        return {"law": self.law, **values}

    def __repr__(self) -> str:
        given = (f"{name}={in_short(getattr(self, name))}" for name in self.constants)
        return f"{type(self).__name__}({', '.join(given)})"

    def _rows(self) -> Rows:
        return [
            (name, _shown(getattr(self, name), constant))
            for name, constant in self.constants.items()
        ]


def _numbers(name: str, given: Any) -> tuple[float, ...]:
    """Return a tuple of the numbers in a list, or in a table row after row."""
    values = real_array(name, [] if given is None else given)
    return tuple((values.ravel() + 0.0).tolist())


def _shown(value: Any, constant: Constant) -> str:
    if not constant.many:
        return quantity(value, constant.unit)
    return f"{in_short(list(value))} {constant.unit}".strip() if value else "-"


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
    contact, the shear traction is discontinuous. With dissimilar materials, a cell at the edge may
    therefore have no consistent solution, neither in contact nor separated. A small tolerance can
    then not be reached.

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


@lru_cache(maxsize=16)
def full_sliding(coefficient: float) -> GrossSliding:
    """Return the law of full sliding, which solvers with the same coefficient share."""
    return GrossSliding(coefficient)


def is_law(friction: Any) -> bool:
    """Whether a value is a friction law."""
    return isinstance(friction, FrictionLaw)


def friction_law(
    friction: float | FrictionLaw, of_number: Callable[[float], FrictionLaw] = full_sliding
) -> FrictionLaw:
    """Return a friction law unchanged, or full sliding for a coefficient of friction."""
    return friction if isinstance(friction, FrictionLaw) else of_number(friction)


def sticking_law(friction: Any) -> FrictionLaw:
    """Return a friction law with partial slip; raise TypeError for other values or full sliding."""
    if not (isinstance(friction, FrictionLaw) and friction.sticks):
        raise TypeError(
            "friction must be a law with partial slip, such as samcontact.Coulomb(mu), got "
            f"{in_short(friction)}"
        )
    return friction


def has_history(law: FrictionLaw, bodies: Iterable[Any]) -> bool:
    """Whether partial slip or plastic strain is stored in cells that move with the bodies."""
    return law.sticks or any(body.is_plastic for body in bodies)


def lasting(law: FrictionLaw, duration: float | None, name: str = "duration") -> float:
    """Check and return the duration of an increment [s] or the rolling speed [m/s]; 0 if unused.

    Raises ValueError for a value that is missing, not positive or without effect.
    """
    if law.needs_duration:
        if duration is None:
            raise ValueError(
                f"{name} is required because the friction depends on the slip rate, {law!r}: give "
                f"the {name} {'of the increment [s]' if name == 'duration' else '[m/s]'}"
            )
        return positive(name, duration)
    if duration is not None:
        raise ValueError(
            f"{name} has no effect with friction that is independent of the slip rate, got "
            f"{in_short(duration)}: omit {name}, or use samcontact.FallingCoulomb"
        )
    return 0.0


def law_of(tree: Mapping[str, Any]) -> FrictionLaw:
    """Return the law that `FrictionLaw.to_tree` has stored as a dictionary.

    Raises LookupError, TypeError or ValueError for other content.
    """
    given = dict(tree)
    return LAWS[given.pop("law")](**given)


_ATTRIBUTE_PREFIX = "friction_"


def attributes_of(law: FrictionLaw) -> dict[str, Any]:
    """Return the law as attributes of results.

    They are "friction_law", the name of the law, and "friction_" + name for each parameter.
    """
    given = {name: value for name, value in law.to_tree().items() if value != []}
    return {f"{_ATTRIBUTE_PREFIX}{name}": value for name, value in given.items()}


def law_of_attributes(attributes: Mapping[Any, Any]) -> FrictionLaw | None:
    """Return the friction law from the attributes of results; None if they contain no law."""
    law = LAWS.get(str(attributes.get(f"{_ATTRIBUTE_PREFIX}law")))
    if law is None:
        return None
    values: dict[str, Any] = {}
    for name, constant in law.constants.items():
        key = f"{_ATTRIBUTE_PREFIX}{name}"
        if constant.many:
            values[name] = np.atleast_1d(attributes.get(key, []))
        else:
            values[name] = float(attributes[key])
    return law(**values)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of `ContactSolver` and `Simulation`, with their defaults and ranges.

Argument checks, repr, checkpoints, the section [contact] of case files, and the compiled core
use these definitions.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any

from .. import _core
from .._util import memory
from .._util.checks import choice, in_cells, integer, number
from .._util.frozen import FixedAttributes
from ..bodies.layered import Body
from ..heat import Heat
from .contact_law import ContactLaw, HardContact, require_law
from .friction import FrictionLaw, friction_law, is_law


@dataclass(frozen=True)
class RangeSetting:
    """Bounds of a setting that is a finite number; None for a bound that does not exist."""

    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None
    unit: str = ""

    def __str__(self) -> str:
        lower, upper = (
            None if limit is None else f"{limit:g}".replace("e-0", "e-")
            for limit in (
                self.ge if self.gt is None else self.gt,
                self.le if self.lt is None else self.lt,
            )
        )
        if upper is None:
            return f"a finite number {'>=' if self.gt is None else '>'} {lower}"
        ends = "[" if self.gt is None else "(", "]" if self.lt is None else ")"
        return f"in {ends[0]}{lower}, {upper}{ends[1]}"

    def check(self, name: str, value: Any) -> float:
        """Return the value as a float; raise ValueError if it is out of range."""
        given = number(name, value)
        inside = (
            math.isfinite(given)
            and (self.gt is None or given > self.gt)
            and (self.ge is None or given >= self.ge)
            and (self.lt is None or given < self.lt)
            and (self.le is None or given <= self.le)
        )
        if not inside:
            raise ValueError(f"{name} must be {self}, got {given!r}")
        return given


@dataclass(frozen=True)
class CountSetting:
    """Range of a setting that is an integer >= 1."""

    def check(self, name: str, value: Any) -> int:
        return integer(name, value, 1)


@dataclass(frozen=True)
class ChoiceSetting:
    """Allowed values of a setting that is one of several words."""

    allowed: tuple[str, ...]

    def check(self, name: str, value: Any) -> str:
        word: str = choice(name, value, self.allowed)
        return word


@dataclass(frozen=True)
class FrictionSetting(RangeSetting):
    """Range of the setting `friction`: a coefficient, or a friction law."""

    def check(self, name: str, value: Any) -> Any:
        return value.given if is_law(value) else super().check(name, value)


@dataclass(frozen=True)
class ContactLawSetting:
    """Range of the setting `adhesion`: any contact law."""

    def check(self, name: str, value: Any) -> ContactLaw:
        return require_law(name, value)


Allowed = RangeSetting | CountSetting | ChoiceSetting | ContactLawSetting


def _setting(default: Any, allowed: Allowed) -> Any:
    """Return the dataclass field of a setting with this default and range."""
    return field(default=default, metadata={"allowed": allowed})


def allowed(settings: type[ContactSettings]) -> Mapping[str, Allowed]:
    """Return the allowed values of each setting by name."""
    return {item.name: item.metadata["allowed"] for item in fields(settings)}


@dataclass(frozen=True)
class ContactSettings:
    """Settings of a contact; they are documented in `ContactSolver`."""

    friction: float | FrictionLaw = _setting(0.0, FrictionSetting(ge=0.0))  # noqa: RUF009 (a field)
    tol: float = _setting(1e-8, RangeSetting(ge=1e-13, lt=1.0))
    on_border: str = _setting("error", ChoiceSetting(("error", "warn")))
    on_stall: str = _setting("error", ChoiceSetting(("error", "warn")))
    max_iterations: int = _setting(5000, CountSetting())
    adhesion: ContactLaw = _setting(HardContact(), ContactLawSetting())  # noqa: RUF009 (a field)
    stiffness: float | None = _setting(None, RangeSetting(gt=0.0, unit="N/m"))

    def __post_init__(self) -> None:
        for name, item in self.__dataclass_fields__.items():
            value = getattr(self, name)
            if value is not item.default:
                object.__setattr__(self, name, item.metadata["allowed"].check(name, value))
        if self.stiffness is not None and not self.adhesion.varies:
            raise ValueError(
                f"stiffness = {self.stiffness!r} requires a law of `Adhesion`, got adhesion = "
                f"{self.adhesion!r}: without adhesion, omit stiffness and add load/stiffness to "
                "the approach of the bodies"
            )
        if self.adhesion.rubs_by_compression and (self.law.prevents_slip or self.law.hardens):
            raise ValueError(
                f'friction_on must be "repulsion" with friction = {self.friction!r}, got '
                f'adhesion = {self.adhesion!r}: "compression" is not defined for friction that '
                "prevents slip or hardens"
            )

    @classmethod
    def checked(cls, name: str, value: Any) -> Any:
        """Check the value of the setting with this name, and return the checked value."""
        return allowed(cls)[name].check(name, value)

    @property
    def law(self) -> FrictionLaw:
        """Friction law; if `friction` is a number, the contact slides fully."""
        return friction_law(self.friction)

    @property
    def spring(self) -> float:
        """Compliance of the machine that prescribes the approach [m/N]; 0 if rigid."""
        return 0.0 if self.stiffness is None else 1.0 / self.stiffness

    def arguments(self) -> dict[str, Any]:
        """Return the values of the settings by name."""
        return dict(vars(self))

    def __str__(self) -> str:
        """Return the settings that are not None, written as Python arguments."""
        given = {name: value for name, value in self.arguments().items() if value is not None}
        return ", ".join(f"{name}={value!r}" for name, value in given.items())


@dataclass(frozen=True)
class Settings(ContactSettings):
    """Settings of a simulation; they are documented in `Simulation`."""

    tol: float = _setting(1e-6, RangeSetting(ge=1e-11, lt=1.0))
    max_iterations: int = _setting(60, CountSetting())
    increment_tol: float | None = _setting(None, RangeSetting(gt=0.0, lt=1.0))
    residual_stress: str = _setting("fast", ChoiceSetting(("fast", "exact")))
    image_tol: float = _setting(1e-3, RangeSetting(ge=1e-6, le=0.1))
    zones: str = _setting("auto", ChoiceSetting(("auto", "one")))
    reach: float | None = _setting(None, RangeSetting(ge=0.0, unit="m"))

    def __post_init__(self) -> None:
        super().__post_init__()
        # For increment_tol near tol, residuals dominate the difference of two solutions.
        if self.increment_tol is not None and self.increment_tol < 10 * self.tol:
            raise ValueError(
                f"increment_tol must be in [10 tol, 1) with tol = {self.tol!r}, "
                f"got {self.increment_tol!r}"
            )

    def to_core(self, dx: float) -> _core.Settings:
        """Return the settings for the compiled core; dx: cell size along x [m]."""
        given = self.arguments()
        del given["friction"], given["adhesion"], given["stiffness"]  # passed separately
        given["increment_tol"] = self.increment_tol or 0.0
        given["one_zone"] = given.pop("zones") == "one"
        given["reach"] = round(in_cells("reach", given["reach"], dx))
        return _core.Settings(**given)


class Configured(FixedAttributes):
    """Base class of solver and simulation, with the settings as attributes."""

    friction: Any  # float, or a law
    tol: float
    on_border: str
    on_stall: str
    max_iterations: int
    adhesion: ContactLaw
    stiffness: float | None
    _settings: ContactSettings

    def _configure(self, settings: ContactSettings, **others: Any) -> None:
        """Set the settings and other attributes."""
        vars(self).update(settings.arguments(), _settings=settings, **others)


def memory_of_contact(friction: FrictionLaw, bodies: tuple[Body, Body], heat: Heat) -> float:
    """Return the memory per surface cell that an elastic contact requires [bytes]."""
    body1, body2 = bodies
    return memory.of_contact(
        coupled=not friction.is_frictionless and body1._core.stack != body2._core.stack,
        sticks=friction.sticks,
        heated=any(heat.factor),
    )

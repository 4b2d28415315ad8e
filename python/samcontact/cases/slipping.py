# SPDX-License-Identifier: GPL-3.0-or-later
"""Tangential motions and forces in a loading path, for partial slip."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Any, NamedTuple

from pydantic import model_validator

from .. import paths
from ..problem.friction import FrictionLaw
from .base import Count, Finite, Position, Section
from .converted import Unit

_MOTIONS = ("shift_x", "shift_y", "twist")
_FORCES = ("tangential_load_x", "tangential_load_y", "torque")
TANGENTIAL_FIELDS = (*_MOTIONS, *_FORCES)

Force = Annotated[Finite, Unit("N")]


class EndState(NamedTuple):
    """State at the end of a segment: load or approach, tangential forces, torque, moments, tilts.

    A force is None after a prescribed motion, because this force is unknown before the solution.
    """

    quantity: str = ""
    value: float = 0.0
    forces: tuple[float | None, ...] = (0.0, 0.0, 0.0)
    about: tuple[tuple[float | None, float | None], ...] = ((0.0, 0.0), (0.0, 0.0))
    """Pairs of moment and tilt, first about x, then about y; None stands for an unknown value."""


class TangentialSection(Section):
    """Tangential motion of body 1 relative to body 2 in a segment, or final force on body 2."""

    shift_x: Position | None = None
    shift_y: Position | None = None
    twist: Annotated[Finite, Unit("rad")] | None = None
    tangential_load_x: Force | None = None
    tangential_load_y: Force | None = None
    torque: Annotated[Finite, Unit("N*m")] | None = None

    @model_validator(mode="after")
    def _motion_or_force(self) -> TangentialSection:
        for motion, force in zip(_MOTIONS, _FORCES, strict=True):
            if getattr(self, motion) is not None and getattr(self, force) is not None:
                raise ValueError(
                    f"{motion} cannot be combined with {force}, because the motion follows "
                    "from the force: omit one of them"
                )
        return self

    @property
    def along(self) -> list[str]:
        """Names of the prescribed tangential motions and forces."""
        return [name for name in TANGENTIAL_FIELDS if getattr(self, name) is not None]

    def add_along(
        self, steps: paths.Path, fractions: Sequence[float], reached: EndState
    ) -> EndState:
        """Add tangential motions and forces to the steps; return the end state of the segment.

        fractions: position of the end of each step in the segment, 0 to 1. reached: load or
        approach at the end of the segment, and tangential forces at the start of the segment.
        """
        driven: list[list[tuple[float | None, float | None]]] = []
        forces: list[float | None] = []
        for motion, force, start in zip(_MOTIONS, _FORCES, reached.forces, strict=True):
            moved, end = getattr(self, motion), getattr(self, force)
            if end is not None:
                driven.append([(None, total) for total in _totals(force, start, end, fractions)])
                forces.append(end)
                continue
            before = [0.0, *fractions[:-1]]
            parts = [None if moved is None else moved * (b - a)
                     for a, b in zip(before, fractions, strict=True)]  # fmt: skip
            driven.append([(part, None) for part in parts])
            forces.append(0.0 if start == 0.0 and not moved else None)
        for step, x, y, rotation in zip(steps, *driven, strict=True):
            step.update(_arguments(x, y, rotation))
        if reached.quantity == "load" and reached.value == 0.0:
            forces = [0.0, 0.0, 0.0]
        return reached._replace(forces=tuple(forces))


def _totals(name: str, start: float | None, end: float, fractions: Sequence[float]) -> list[float]:
    if start is None:
        if len(fractions) > 1:
            raise ValueError(
                f"{name} must not change in several increments here, because its initial value is "
                "unknown after a prescribed motion: insert a segment with increments = 1 that "
                f"prescribes {name} before this one"
            )
        return [end]
    return [end if f == 1.0 else start + f * (end - start) for f in fractions]


def _arguments(*directions: tuple[float | None, float | None]) -> dict[str, Any]:
    """Return the tangential arguments of `Simulation.step`, without arguments that are None.

    directions: three pairs (motion, force), along x, along y and about z.
    """
    (x, force_x), (y, force_y), (rotation, torque) = directions
    given: dict[str, Any] = {"shift": (x, y), "tangential_load": (force_x, force_y)}
    given |= {"twist": rotation, "torque": torque}
    return {name: value for name, value in given.items() if value not in (None, (None, None))}


class Fretting(Section):
    """Fretting cycles at the load of the previous segment, see `paths.fretting_loop`."""

    shift_x: Position | None = None
    shift_y: Position | None = None
    tangential_load_x: Force | None = None
    tangential_load_y: Force | None = None
    cycles: Count = 1

    @model_validator(mode="after")
    def _one_kind(self) -> Fretting:
        if (self.shift is None) == (self.force is None):
            raise ValueError(
                "fret requires either a motion (shift_x, shift_y or both) or a force "
                "(tangential_load_x, tangential_load_y or both): give one of the two"
            )
        if not any(self.shift or self.force or ()):
            raise ValueError(
                "the amplitude of the motion or force must not be 0: at least one of the given "
                "components must differ from 0"
            )
        return self

    @property
    def shift(self) -> tuple[float, float] | None:
        """Amplitudes of the motion along x and y [m]; None if the force is prescribed."""
        return _pair(self.shift_x, self.shift_y)

    @property
    def force(self) -> tuple[float, float] | None:
        """Amplitudes of the force along x and y [N]; None if the motion is prescribed."""
        return _pair(self.tangential_load_x, self.tangential_load_y)

    def scaled(self, factor: float) -> Fretting:
        """Return a copy with the tangential forces multiplied by a factor."""
        forces = ("tangential_load_x", "tangential_load_y")
        given = {n: factor * v for n in forces if (v := getattr(self, n)) is not None}
        return self.model_copy(update=given)

    def steps(self, name: str, value: float, increments: int, reached: EndState) -> paths.Path:
        """Return the fretting steps at the load or approach at which the previous segment ended."""
        if reached[:2] != (name, value):
            raise ValueError(
                f"fret requires that the previous segment ends at {name} = {value!r}, got "
                f"{reached.quantity or name} = {reached.value!r}: insert a segment that "
                f"ends at {name} = {value!r}"
            )
        if self.force is not None and any(reached.forces[:2]):
            raise ValueError(
                "fret with a force must start at zero force, but the previous segment ends at "
                f"{list(reached.forces[:2])!r} N: insert a segment that reduces the force to 0"
            )
        if self.force is not None and None in reached.forces[:2]:
            raise ValueError(
                "fret with a force must start at zero force, but the force after a prescribed "
                "motion is unknown: before fret, insert a segment with increments = 1, "
                "tangential_load_x = 0 and tangential_load_y = 0"
            )
        given: dict[str, Any] = {name: value, "increments": increments, "cycles": self.cycles}
        return paths.fretting_loop(**given, force=self.force, shift=self.shift)

    def reached(self, before: EndState) -> EndState:
        ends = (None, None) if self.force is None else self.force
        torque = before.forces[2]
        return before._replace(forces=(*ends, 0.0 if torque == 0.0 else None))


def _pair(x: float | None, y: float | None) -> tuple[float, float] | None:
    return None if x is None and y is None else (x or 0.0, y or 0.0)


def require_held(step: dict[str, Any], friction: FrictionLaw) -> None:
    """Raise ValueError if the tangential force of a step reaches the friction limit."""
    load = step.get("load")
    pulled = math.hypot(*(force or 0.0 for force in step.get("tangential_load", ())))
    if load is None or pulled == 0.0:
        return
    limit = friction.ratio(0.0) * load if load > 0 else 0.0
    if not pulled < limit:
        raise ValueError(
            f"tangential load must be below the friction limit ({limit!r} N at load "
            f"{load!r} N), got {pulled!r} N: prescribe shift_x, shift_y for full sliding"
        )

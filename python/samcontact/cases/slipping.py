# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of a path along the surface, of bodies that stick and slip."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Any, NamedTuple

from pydantic import model_validator

from .. import paths
from ..scene.friction import FrictionLaw
from .base import Count, Finite, Position, Section, in_unit

_MOTIONS = ("shift_x", "shift_y", "twist")
_FORCES = ("tangential_load_x", "tangential_load_y", "torque")
ALONG = (*_MOTIONS, *_FORCES)

Force = Annotated[Finite, in_unit("N")]


class Reached(NamedTuple):
    """What a path has come to: load or approach with its value, and the forces along the surface.

    A force that follows from a motion is None: nothing has been solved yet.
    """

    quantity: str = ""
    value: float = 0.0
    forces: tuple[float | None, ...] = (0.0, 0.0, 0.0)


class Along(Section):
    """Motion of body 1 over body 2 in a segment, or forces on body 2 at its end."""

    shift_x: Position | None = None
    shift_y: Position | None = None
    twist: Annotated[Finite, in_unit("rad")] | None = None
    tangential_load_x: Force | None = None
    tangential_load_y: Force | None = None
    torque: Annotated[Finite, in_unit("N*m")] | None = None

    @model_validator(mode="after")
    def _motion_or_force(self) -> Along:
        for motion, force in zip(_MOTIONS, _FORCES, strict=True):
            if getattr(self, motion) is not None and getattr(self, force) is not None:
                raise ValueError(
                    f"give {motion} or {force}, not both: the motion follows from the force"
                )
        return self

    @property
    def along(self) -> list[str]:
        """Names of what is given along the surface."""
        return [name for name in ALONG if getattr(self, name) is not None]

    def add_along(self, steps: paths.Path, fractions: Sequence[float], reached: Reached) -> Reached:
        """Drive the steps, whose shares of the segment end at these fractions; what they reach.

        `reached` has the load or approach at the end of the segment, and the forces before it.
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
        for step, x, y, turn in zip(steps, *driven, strict=True):
            step.update(_arguments(x, y, turn))
        if reached.quantity == "load" and reached.value == 0.0:
            forces = [0.0, 0.0, 0.0]
        return reached._replace(forces=tuple(forces))


def _totals(name: str, start: float | None, end: float, fractions: Sequence[float]) -> list[float]:
    if start is None:
        if len(fractions) > 1:
            raise ValueError(
                f"{name} starts from a force that follows from a motion before, and is not known "
                "yet: give increments = 1, and go on from there"
            )
        return [end]
    return [end if f == 1.0 else start + f * (end - start) for f in fractions]


def _arguments(*directions: tuple[float | None, float | None]) -> dict[str, Any]:
    """Of `Simulation.step`: motion and force along x, along y, and about z; what is not None."""
    (x, force_x), (y, force_y), (turn, torque) = directions
    given: dict[str, Any] = {"shift": (x, y), "tangential_load": (force_x, force_y)}
    given |= {"twist": turn, "torque": torque}
    return {name: value for name, value in given.items() if value not in (None, (None, None))}


class Fretting(Section):
    """To and fro under the load reached before, see `paths.fretting_loop`."""

    shift_x: Position | None = None
    shift_y: Position | None = None
    tangential_load_x: Force | None = None
    tangential_load_y: Force | None = None
    cycles: Count = 1

    @model_validator(mode="after")
    def _one_kind(self) -> Fretting:
        if (self.shift is None) == (self.force is None):
            raise ValueError("give shift_x, shift_y, or tangential_load_x, tangential_load_y")
        if not any(self.shift or self.force or ()):
            raise ValueError("the amplitude must not be 0")
        return self

    @property
    def shift(self) -> tuple[float, float] | None:
        """Amplitude of the motion [m]; None where that of the force is given."""
        return _pair(self.shift_x, self.shift_y)

    @property
    def force(self) -> tuple[float, float] | None:
        """Amplitude of the force [N]; None where that of the motion is given."""
        return _pair(self.tangential_load_x, self.tangential_load_y)

    def scaled(self, factor: float) -> Fretting:
        """The same with forces multiplied."""
        forces = ("tangential_load_x", "tangential_load_y")
        given = {n: factor * v for n in forces if (v := getattr(self, n)) is not None}
        return self.model_copy(update=given)

    def steps(self, name: str, value: float, increments: int, reached: Reached) -> paths.Path:
        """Under a load or an approach that must be reached already."""
        if reached[:2] != (name, value):
            raise ValueError(
                f"fret holds the {name} at {value!r}, but the segment before ends at "
                f"{reached.quantity or name} = {reached.value!r}: press the bodies in a segment "
                "before"
            )
        if self.force is not None and any(reached.forces[:2]):
            raise ValueError(
                "fret of a force begins without one, but the segment before ends at "
                f"{list(reached.forces[:2])!r} N: end that one at 0"
            )
        if self.force is not None and None in reached.forces[:2]:
            raise ValueError(
                "fret of a force begins without one, but a motion before leaves one that is not "
                "known yet: give tangential_load_x = 0, tangential_load_y = 0 in a segment of one "
                "increment before"
            )
        given: dict[str, Any] = {name: value, "increments": increments, "cycles": self.cycles}
        return paths.fretting_loop(**given, force=self.force, shift=self.shift)

    def reached(self, before: Reached) -> Reached:
        ends = (None, None) if self.force is None else self.force
        turned = before.forces[2]
        return before._replace(forces=(*ends, 0.0 if turned == 0.0 else None))


def _pair(x: float | None, y: float | None) -> tuple[float, float] | None:
    return None if x is None and y is None else (x or 0.0, y or 0.0)


def require_held(step: dict[str, Any], friction: FrictionLaw) -> None:
    """Raise ValueError for a force along the surface that friction does not hold under the load."""
    load = step.get("load")
    pulled = math.hypot(*(force or 0.0 for force in step.get("tangential_load", ())))
    if load is None or pulled == 0.0:
        return
    most = friction.ratio(0.0) * load if load > 0 else 0.0
    if not pulled < most:
        raise ValueError(
            f"tangential_load_x, tangential_load_y must be less than friction times the load, "
            f"{most!r} N under {load!r} N, got {pulled!r} N: the bodies would slide; give shift_x, "
            "shift_y instead"
        )

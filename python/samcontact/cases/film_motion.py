# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [film] of a case file: motion, load, lubricant supply and boundary layer."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from ..lubrication import Boundary
from .base import (
    Count,
    Finite,
    Length,
    NonNegative,
    Pair,
    Position,
    Positive,
    Section,
    changed,
)
from .converted import Unit
from .film_transient import TransientSection, Vectors
from .surface_shape import SurfaceShape

Velocity = Annotated[Finite | Pair, Unit("m/s")]
Angle = Annotated[Finite, Unit("rad")]
AngularSpeed = Annotated[Finite, Unit("rad/s")]


class BoundarySection(Section):
    """Boundary layer, see `lubrication.Boundary`."""

    thickness: Length
    friction: NonNegative = 0.1
    pressure: Annotated[Positive, Unit("Pa")] | None = None

    def build(self) -> Boundary:
        return Boundary(**self.model_dump())


class FilmSection(Section):
    """[film]: motion, load, lubricant supply and boundary layer, see `lubrication.steady`."""

    speed1: Velocity | None = None
    speed2: Velocity | None = None
    entrainment: Annotated[Positive, Unit("m/s")] | None = None
    speeds: Annotated[list[Positive], Field(min_length=1), Unit("m/s")] | None = None
    inner_speed: AngularSpeed | None = None
    outer_speed: AngularSpeed | None = None
    pinion_speed: AngularSpeed | None = None
    slide_to_roll: Finite = 0.0
    angle: Angle = 0.0
    spin: AngularSpeed = 0.0
    load: Annotated[Positive, Unit("N")] | None = None
    load_factor: Positive = 1.0
    approach: Position | None = None
    supply: Length | None = None
    boundary: BoundarySection | None = None
    roughness1: Annotated[NonNegative, Unit("m")] = 0.0
    roughness2: Annotated[NonNegative, Unit("m")] = 0.0
    shear_thinning: bool = False
    thermal: bool = False
    increments: Count = 1
    transient: TransientSection | None = None
    order: Literal[1, 2, 3] = 3
    tol: Annotated[float, Field(ge=1e-10, le=1e-2)] = 1e-6
    max_iterations: Annotated[int, Field(ge=1, le=1000)] = 40

    @model_validator(mode="after")
    def _one_motion(self) -> FilmSection:
        ways = {
            "speed1 and speed2": self.speed1 is not None and self.speed2 is not None,
            "entrainment": self.entrainment is not None,
            "speeds": self.speeds is not None,
            "inner_speed or outer_speed": bool(changed(self, ("inner_speed", "outer_speed"))),
            "pinion_speed": self.pinion_speed is not None,
        }
        if (self.speed1 is None) != (self.speed2 is None):
            raise ValueError("speed1 and speed2 must be given together")
        given = [name for name, there in ways.items() if there]
        if len(given) != 1:
            raise ValueError(
                f"exactly one of {', '.join(ways)} must be given, got {', '.join(given) or 'none'}"
            )
        if given[0] in ("speed1 and speed2", "pinion_speed") and self.slide_to_roll:
            raise ValueError(f"slide_to_roll has no effect with {given[0]}: omit slide_to_roll")
        if self.angle and given[0] != "entrainment":
            raise ValueError(f"angle has effect with entrainment only, got {given[0]}: omit angle")
        self._require_load()
        if self.speeds is not None:
            self._require_stribeck()
        return self

    def _require_load(self) -> None:
        for name in sorted(changed(self, ("load", "load_factor"))):
            if self.approach is not None:
                raise ValueError(f"{name} cannot be combined with approach: omit one of them")
        if self.load is not None and changed(self, ("load_factor",)):
            raise ValueError(
                "load cannot be combined with load_factor (times the load of a part): omit one"
            )

    def _require_stribeck(self) -> None:
        """Raise ValueError for fields that cannot be combined with a Stribeck curve."""
        for name in sorted(changed(self, ("spin", "supply", "approach"))):
            raise ValueError(f"{name} cannot be combined with speeds: omit one of them")
        if self.boundary is None:
            raise ValueError(
                "speeds requires boundary, the layer that carries the load at low speeds: add "
                "boundary = {thickness = 2e-9}"
            )
        speeds = self.speeds or []
        if any(after <= before for before, after in pairwise(speeds)):
            raise ValueError(f"speeds must increase, got {speeds}")

    @property
    def roughness(self) -> float:
        """Combined root-mean-square roughness of both surfaces [m]."""
        return math.hypot(self.roughness1, self.roughness2)

    def velocities(self, surface: SurfaceShape, largest: bool = True) -> Vectors:
        """Return the velocities of bodies 1 and 2 along x and y [m/s].

        surface: shape of the part to which angular speeds refer. largest: whether to use the
        largest value in `speeds` instead of the smallest.
        """
        if self.speed1 is not None and self.speed2 is not None:
            return _vector(self.speed1), _vector(self.speed2)
        rates = {name: value for name in _RATES if (value := getattr(self, name)) is not None}
        if rates:
            of_part = surface.surface_speeds(rates)
            if of_part is None:
                name = next(iter(rates))
                raise ValueError(
                    f"{name} has a meaning only if [surface] is a {_RATES[name]}: use entrainment "
                    "instead, or speed1 and speed2"
                )
            if self.pinion_speed is not None:
                first, second = of_part
                rolls = math.isclose(first, second, rel_tol=1e-12)  # up to rounding
                return (first, 0.0), (first if rolls else second, 0.0)
            mean = of_part[0]
        else:
            mean = self.entrainment or (self.speeds or [0.0])[-1 if largest else 0]
        along = mean * math.cos(self.angle), mean * math.sin(self.angle)
        if self.angle == 0.0:
            along = mean, 0.0
        factors = 1.0 + 0.5 * self.slide_to_roll, 1.0 - 0.5 * self.slide_to_roll
        first_two = [(factor * along[0], factor * along[1]) for factor in factors]
        return first_two[0], first_two[1]

    def settings(self) -> dict[str, Any]:
        """Return the settings as keyword arguments for `steady` and `stribeck`."""
        boundary = None if self.boundary is None else self.boundary.build()
        return {
            "boundary": boundary, "order": self.order, "shear_thinning": self.shear_thinning,
            "thermal": self.thermal, "tol": self.tol, "max_iterations": self.max_iterations,
        }  # fmt: skip


_RATES = {"inner_speed": "bearing", "outer_speed": "bearing", "pinion_speed": "gear"}
"""Machine part to which each angular speed belongs."""


def _vector(speed: float | list[float]) -> tuple[float, float]:
    return (speed[0], speed[1]) if isinstance(speed, list) else (speed, 0.0)

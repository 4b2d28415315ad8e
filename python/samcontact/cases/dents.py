# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [dents] of a case file: hard particles pressed into body 2 before the path."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field, model_validator

from .. import overrolling
from ..bodies.layered import backstresses_of
from ..bodies.material import Material
from ..simulation.given_strain import set_plastic_strain
from .base import Count, Length, NonNegative, Position, Positive, Section
from .converted import Unit

if TYPE_CHECKING:
    from ..simulation.simulation import Simulation

NOT_OF_PARTICLES = ("friction", "adhesion", "stiffness", "on_border", "reach")
"""Settings in [contact] that apply to the path only, not while the particles are pressed in."""


class ParticleSection(Section):
    """[[dents.particles]]: hard sphere pressed into body 2, see `overrolling.Particle`."""

    radius: Length
    load: Annotated[Positive, Unit("N")] | None = None
    approach: Length | None = None
    x: Position = 0.0
    y: Position = 0.0

    @model_validator(mode="after")
    def _presses(self) -> ParticleSection:
        self.build()
        return self

    def build(self) -> overrolling.Particle:
        return overrolling.Particle(**self.model_dump())


class RandomParticlesSection(Section):
    """[dents.random]: random particles on a rectangle, see `overrolling.particles`."""

    length: Length
    width: Length
    density: Annotated[NonNegative, Unit("1/m**2")]
    radius: Length
    spread: NonNegative = 0.0
    depth_ratio: Annotated[Positive, Field(lt=1.0)] = 0.05
    x: Position = 0.0
    y: Position = 0.0
    seed: Annotated[int, Field(ge=0)]

    @model_validator(mode="after")
    def _draws(self) -> RandomParticlesSection:
        if not self.build():
            raise ValueError(
                "no particle was drawn, because the mean number density * length * width is only "
                f"{self.density * self.length * self.width:g}: increase a factor, or change seed"
            )
        return self

    def build(self) -> list[overrolling.Particle]:
        drawn = overrolling.particles(**self.model_dump(exclude={"x", "y"}))
        return [replace(one, x=one.x + self.x, y=one.y + self.y) for one in drawn]


class DentsSection(Section):
    """[dents]: hard particles pressed into body 2 before the path, see `overrolling.indent`."""

    particles: Annotated[list[ParticleSection], Field(min_length=1)] | None = None
    random: RandomParticlesSection | None = None
    increments: Count = 8
    E: Annotated[Positive, Unit("Pa")] | None = None
    nu: Annotated[float, Field(ge=0.0, lt=0.5)] | None = None

    @model_validator(mode="after")
    def _go_together(self) -> DentsSection:
        if (self.particles is None) == (self.random is None):
            raise ValueError("exactly one of particles and random must be given")
        if (self.E is None) != (self.nu is None):
            raise ValueError("give both E and nu of the particles, or neither for rigid particles")
        return self

    def build(self, settings: Mapping[str, Any]) -> Indentation:
        """Return the indentation; settings: those in [contact], as arguments of `Simulation`."""
        drawn = [] if self.random is None else self.random.build()
        given = [one.build() for one in self.particles or ()]
        body = None
        if self.E is not None and self.nu is not None:
            body = Material.elastic(self.E, self.nu)
        return Indentation(
            particles=(*given, *drawn),
            increments=self.increments,
            body1=body,
            settings={n: v for n, v in settings.items() if n not in NOT_OF_PARTICLES},
        )


@dataclass(frozen=True)
class Indentation:
    """Particles that are pressed into body 2 of a simulation before its path is solved.

    Particle positions are coordinates on body 2; the contact is initially at x = 0.
    """

    particles: tuple[overrolling.Particle, ...]
    increments: int
    body1: Material | None
    settings: Mapping[str, Any]

    def __call__(self, simulation: Simulation) -> None:
        """Press the particles into body 2 on a longer grid; set the strain in `simulation`."""
        grid = simulation.grid
        half = 0.5 * grid.ny * grid.dy
        for one in self.particles:
            if abs(one.y) >= half:
                raise ValueError(
                    f"dents: the centre of each particle must lie on the grid along y, within "
                    f"{half:.4g} m of y = 0, got y = {one.y:.4g} m: change y (with dents.random: "
                    "y or width), or increase grid.ny"
                )
        places = [one.x for one in self.particles]
        middle = round(0.5 * (min(places) + max(places)) / grid.dx)
        beyond = math.ceil(0.5 * (max(places) - min(places)) / grid.dx)
        try:
            dented = overrolling.indent(
                replace(grid, nx=grid.nx + 2 * beyond),
                simulation.body2,
                [replace(one, x=one.x - middle * grid.dx) for one in self.particles],
                increments=self.increments,
                body1=self.body1,
                **self.settings,
            )
        except ValueError as error:
            raise type(error)(f"dents: {error}") from error
        first = round((dented.x[0] - grid.x[0]) / grid.dx) + middle
        set_plastic_strain(
            simulation.engine,
            2,
            dented.plastic_strain(),
            dented.equivalent_plastic_strain(),
            dented.backstress() if backstresses_of(simulation.body2) else None,
            first,
            anywhere=True,
        )

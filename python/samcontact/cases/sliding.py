# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of viscoelastic friction as a function of velocity, with the section [sliding]."""

from __future__ import annotations

import os
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
from pydantic import Field, model_validator

from ..sliding import FrictionCurve, over_speed
from .base import CaseError, CaseFile, Finite, OutputPlace, Positive, Section
from .bodies import BodySection
from .converted import Unit
from .sections import (
    CylinderSurface,
    FileSurface,
    GridSection,
    ParaboloidSurface,
    SphereSurface,
    settings_section,
)

if TYPE_CHECKING:
    import xarray as xr

Speed = Annotated[Positive, Unit("m/s")]
_USED = {"law", "E", "nu", "material", "relaxation", "layers", "thickness"}
"""Fields of a body that have an effect on viscoelastic sliding."""


class SlidingSection(Section):
    """[sliding]: load, and velocities of body 1 relative to body 2 along x."""

    load: Annotated[Positive, Unit("N")] | None = None
    mean_pressure: Annotated[Positive, Unit("Pa")] | None = None
    velocities: Annotated[list[Finite], Field(min_length=1), Unit("m/s")] | None = None
    slowest: Speed | None = None
    fastest: Speed | None = None
    per_decade: Annotated[int, Field(ge=1, le=100)] | None = None

    @model_validator(mode="after")
    def _one_form(self) -> SlidingSection:
        if (self.load is None) == (self.mean_pressure is None):
            raise ValueError("exactly one of load and mean_pressure must be given")
        ends = [self.slowest, self.fastest]
        ranged = [value for value in (*ends, self.per_decade) if value is not None]
        if (self.velocities is None) == (None in ends) or (self.velocities and ranged):
            raise ValueError(
                "give either velocities, or slowest and fastest (optionally with per_decade)"
            )
        if self.slowest is not None and self.fastest is not None and self.slowest >= self.fastest:
            raise ValueError(
                f"slowest must be less than fastest = {self.fastest!r} m/s, got {self.slowest!r}"
            )
        return self

    def speeds(self) -> list[float]:
        """Velocities [m/s] in the order of solution."""
        if self.velocities is not None:
            return self.velocities
        assert self.slowest is not None
        assert self.fastest is not None
        per_decade = 3 if self.per_decade is None else self.per_decade
        count = round(per_decade * np.log10(self.fastest / self.slowest))
        speeds: list[float] = np.geomspace(self.slowest, self.fastest, max(count, 1) + 1).tolist()
        return speeds


if TYPE_CHECKING:
    SlidingSolver = Section
else:
    # the contact settings without friction, which is the result, and without adhesion
    SlidingSolver = settings_section(
        "SlidingSolver",
        __name__,
        without=(
            "friction", "adhesion", "stiffness", "on_stall", "increment_tol", "residual_stress",
            "image_tol", "zones", "reach",
        ),
        tol=None,
        max_iterations=None,
    )  # fmt: skip


class SlidingCase(CaseFile):
    """Validated case of viscoelastic sliding, for `sliding.over_speed`; quantities in SI units."""

    KIND: ClassVar[str] = "a sliding contact"

    title: Annotated[str, Field(min_length=1)]
    description: str = ""
    sliding: SlidingSection
    grid: GridSection
    body1: BodySection
    body2: BodySection
    surface: Annotated[
        ParaboloidSurface | SphereSurface | CylinderSurface | FileSurface,
        Field(discriminator="shape"),
    ]
    contact: SlidingSolver = SlidingSolver()
    output: OutputPlace = OutputPlace()

    @property
    def study(self) -> str:
        return "sliding"

    @model_validator(mode="after")
    def _consistent(self) -> SlidingCase:
        if self.grid.dz is not None:
            raise ValueError("grid.dz has no effect with [sliding], which needs no layers: omit it")
        for name in ("body1", "body2"):
            self._require_elastic(name)
        if not self.body2.relaxes:
            raise ValueError(
                "body2.relaxation must be given: the friction is due to the energy lost in body 2, "
                "over which body 1 slides" + (
                    "; body 1 loses no energy, because the contact does not move over it: exchange "
                    "the bodies" if self.body1.relaxes else ""
                )
            )  # fmt: skip
        if self.sliding.mean_pressure is not None and self.grid.periodic != "xy":
            raise ValueError(
                'sliding.mean_pressure requires grid.periodic = "xy", because the area of any '
                "other grid is arbitrary: set it, or use sliding.load"
            )
        return self

    def _require_elastic(self, name: str) -> None:
        body = getattr(self, name)
        if body.is_plastic:
            raise ValueError(
                f'{name}.law must be "elastic" or "rigid" with [sliding], got '
                f"{body.inelastic_laws[0]!r}"
            )
        for part in body.parts:
            for field in sorted(part.model_fields_set - _USED):
                raise ValueError(f"{name}.{field} has no effect with [sliding]: omit it")

    @property
    def load(self) -> float:
        """Normal load [N]."""
        given = self.sliding
        if given.load is not None:
            return given.load
        assert given.mean_pressure is not None
        return given.mean_pressure * self.grid.nx * self.grid.dx * self.grid.ny * self.grid.dy

    def solve(
        self, *, progress: bool = True, checkpoint: str | os.PathLike[str] | None = None
    ) -> FrictionCurve:
        """Run `sliding.over_speed`, whose errors are passed on; CaseError for invalid sections."""
        section, folder = "grid", self.source.parent
        try:
            grid = self.grid.build()
            section = "surface"
            built: Any = self.surface.build(grid, folder)
        except (ValueError, ImportError) as error:
            raise CaseError(f"{self.source}: [{section}] {error}") from error
        if self.surface.is_known and not grid.periodic:  # the grid may be enlarged
            built = partial(self.surface.build, folder=folder)
        return over_speed(
            grid,
            self.body1.build(),
            self.body2.build(),
            built,
            load=self.load,
            velocities=self.sliding.speeds(),
            checkpoint=checkpoint,
            progress=progress,
            **self.contact.model_dump(exclude_none=True),
        )

    def solved(self) -> xr.Dataset:
        """Solve the case; return the quantities that have one value per velocity."""
        return self.solve(progress=False).to_dataset(fields=False)

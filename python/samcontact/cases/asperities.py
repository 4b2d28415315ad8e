# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of asperity collisions, with the section [asperities]."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, cast

from pydantic import Field, model_validator

from ..asperities import Collision, CollisionResult, collide
from ..problem.moving_topography import Relief, relief_rows
from .base import CaseError, CaseFile, Count, Length, OutputPlace, Positive, Section
from .bodies import BodySection
from .cross_checks import (
    require_cold,
    require_hardness_used,
    require_image_tol,
    require_no_layers,
)
from .motion import ReliefSection
from .sections import GridSection, settings_section


class AsperitySection(Section):
    """[asperities]: two colliding spheres, number of passes, and size of the default grid."""

    R1: Length
    R2: Length
    interference: Length
    passes: Count = 1
    back_and_forth: bool = False
    cells_per_increment: Count = 1
    increments: Annotated[int, Field(ge=4)] | None = None
    width: Positive | None = None
    depth: Positive | None = None

    @model_validator(mode="after")
    def _geometry(self) -> AsperitySection:
        self.geometry()
        return self

    def geometry(self) -> Collision:
        return Collision(self.R1, self.R2, self.interference)

    def grid_arguments(self) -> dict[str, Any]:
        """Return the arguments of `Collision.grid` that are given in the section."""
        names = ("increments", "width", "depth")
        return {n: getattr(self, n) for n in names if getattr(self, n) is not None}


if TYPE_CHECKING:
    import xarray as xr

    from ..bodies.material import Material

    AsperitySolver = Section
else:
    # smooth frictionless spheres; without tol, the default tol of `collide` applies
    AsperitySolver = settings_section(
        "AsperitySolver", __name__, without=("friction", "adhesion", "stiffness"), tol=None
    )


class AsperityCase(CaseFile):
    """Validated case of an asperity collision, for `asperities.collide`; quantities in SI units."""

    KIND: ClassVar[str] = "an asperity collision"

    title: Annotated[str, Field(min_length=1)]
    description: str = ""
    asperities: AsperitySection
    grid: GridSection | None = None
    body1: BodySection
    body2: BodySection
    relief1: ReliefSection | None = None
    relief2: ReliefSection | None = None
    contact: AsperitySolver = AsperitySolver()
    output: OutputPlace = OutputPlace()

    @property
    def study(self) -> str:
        return "asperities"

    @model_validator(mode="after")
    def _consistent(self) -> AsperityCase:
        if self.body1.law == "rigid" and self.body2.law == "rigid":
            raise ValueError("body1 and body2 are both rigid: at least one must be deformable")
        if self.grid is not None and self.asperities.grid_arguments():
            given = ", ".join(self.asperities.grid_arguments())
            raise ValueError(f"asperities: {given} and [grid] both set the grid: omit one of them")
        bodies = (("body1", self.body1), ("body2", self.body2))
        require_cold(bodies, "omit it, because [asperities] does not support heat")
        require_no_layers(bodies, "[asperities]")
        require_hardness_used(bodies)
        require_image_tol(self.contact)
        return self

    def solve(
        self, *, progress: bool = True, checkpoint: str | os.PathLike[str] | None = None
    ) -> CollisionResult:
        """Run `asperities.collide`, whose errors are passed on; CaseError for invalid sections."""
        collision, section = self.asperities.geometry(), "grid"
        reliefs: dict[str, Relief] = {}
        try:
            if self.grid is not None:
                grid = self.grid.build()
            else:
                cells = self.asperities.cells_per_increment
                grid = collision.grid(cells_per_increment=cells, **self.asperities.grid_arguments())
            for section in ("relief1", "relief2"):
                given = getattr(self, section)
                if given is not None:
                    reliefs[section] = given.build(grid, self.source.parent)
                    relief_rows(section, reliefs[section], grid)
        except (ValueError, ImportError) as error:
            raise CaseError(f"{self.source}: [{section}] {error}") from error
        return collide(
            collision,
            cast("Material", self.body1.build()),
            cast("Material", self.body2.build()),
            grid,
            passes=self.asperities.passes,
            back_and_forth=self.asperities.back_and_forth,
            cells_per_increment=self.asperities.cells_per_increment,
            relief1=reliefs.get("relief1"),
            relief2=reliefs.get("relief2"),
            checkpoint=checkpoint,
            progress=progress,
            **self.contact.model_dump(exclude_none=True),
        )

    def solved(self) -> xr.Dataset:
        """Solve the case; return the quantities that have a value per increment or per pass."""
        return self.solve(progress=False).series

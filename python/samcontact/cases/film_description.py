# SPDX-License-Identifier: GPL-3.0-or-later
"""Description of a film case: bodies, lubricant, motion, load, grid and gap."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
from pydantic import Field, PrivateAttr

from .base import CaseError, CaseFile, OutputPlace
from .bodies import BodySection
from .film_grid import FilmGridSection, shifted_gap
from .film_motion import FilmSection
from .film_transient import Vectors, moving_heights
from .lubricants import LubricantSection
from .motion import ReliefSection
from .sections import SurfaceSection

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..lubricants import Lubricant
    from ..problem.grid import Grid


class FilmDescription(CaseFile):
    """Description of a lubricated contact in a case file; all quantities in SI units."""

    KIND: ClassVar[str] = "a lubricated contact"

    title: Annotated[str, Field(min_length=1)]
    description: str = ""
    lubricant: LubricantSection
    film: FilmSection
    grid: FilmGridSection = FilmGridSection()
    body1: BodySection
    body2: BodySection
    surface: SurfaceSection
    relief1: ReliefSection | None = None
    relief2: ReliefSection | None = None
    output: OutputPlace = OutputPlace()

    _cells: FilmGridSection = PrivateAttr(default=FilmGridSection())

    @property
    def bodies(self) -> tuple[Any, Any]:
        """Body 1 (upper) and body 2 (lower)."""
        return self.body1.build(), self.body2.build()

    @property
    def yields(self) -> bool:
        """Whether a body is elastic-plastic."""
        return self.body1.is_plastic or self.body2.is_plastic

    @property
    def cells(self) -> Grid:
        """Grid of the case, as given or as chosen from the size of the Hertz contact."""
        grid = self._cells.build()
        assert grid is not None  # `_consistent` has chosen one
        return grid

    @property
    def velocities(self) -> Vectors:
        """Velocities of bodies 1 and 2 along x, y [m/s]; for film.speeds, at the largest speed."""
        return self.film.velocities(self.surface)

    def build_lubricant(self) -> Lubricant:
        """Create the `Lubricant`."""
        return self.lubricant.build()

    def load_on(self, grid: Grid | None) -> float:
        """Return the load of the contact on a grid [N]; ValueError unless given exactly once."""
        nominal = self.surface.nominal_load(grid)
        load = self.film.load
        if load is not None and nominal is not None:
            raise ValueError(
                "film.load cannot be combined with the load of the part: use film.load_factor"
            )
        if load is not None:
            return load
        if nominal is None:
            raise ValueError("film.load is required: add it, or the loads of a part in [surface]")
        return nominal * self.film.load_factor

    def gap(self) -> FloatArray:
        """Return the gap of the undeformed surfaces on the grid [m], shape (nx, ny).

        Raises CaseError if the surface cannot be built, e.g. because its file is missing.
        """
        try:
            gap = shifted_gap(self.surface, self.cells, self.shift, self.source.parent)
            if not np.isfinite(gap).all():
                raise ValueError(
                    "has no material in some cells of the grid, e.g. beyond the tip of a tooth: "
                    "choose another position, or a smaller grid"
                )
            return gap
        except (ValueError, ImportError) as error:
            raise CaseError(f"{self.source}: [surface] {error}") from error

    @property
    def shift(self) -> tuple[int, int]:
        """Position of the contact relative to the centre of the grid along x and y, in cells."""
        mean = np.mean(self.velocities, axis=0)
        length = float(np.hypot(*mean)) or 1.0
        along = float(mean[0]) / length, float(mean[1]) / length
        return self._cells.shift(self.cells, along, self.surface.is_known)

    def standing_gap(self) -> FloatArray:
        """Return the gap with the reliefs at their initial positions [m], shape (nx, ny).

        Raises CaseError if a surface cannot be built.
        """
        gap, grid = self.gap(), self.cells
        x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
        for name in ("relief1", "relief2"):
            section = getattr(self, name)
            if section is None:
                continue
            try:
                gap = gap - moving_heights(section, grid, self.shift, self.source.parent)(x, y)
            except (ValueError, ImportError) as error:
                raise CaseError(f"{self.source}: [{name}] {error}") from error
        return gap

    @property
    def study(self) -> str:
        return "film"

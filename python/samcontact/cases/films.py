# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of lubricated contacts, with [lubricant] and [film]."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
from pydantic import Field, PrivateAttr, model_validator

from .. import hertz as _hertz
from .._util.errors import attach
from ..bodies.layered import softest
from ..lubrication import FilmEstimate, FilmSolution, estimate, moes, steady, stribeck
from ..lubrication.steady import checked_task
from .base import CaseError, CaseFile, OutputPlace
from .bodies import BodySection
from .film_grid import FilmGridSection, grid_of_contact, grid_of_line, shifted_gap
from .film_motion import FilmSection, Vectors
from .lubricants import LubricantSection
from .rolling_parts import with_surface
from .sections import SurfaceSection

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..lubricants import Lubricant
    from ..problem.grid import Grid

_UNUSED = (
    "thermal", "hardness", "residual_stress", "relaxation", "free_faces", "inclusions",
    "random_inclusions",
)  # fmt: skip
"""Sections of a body that a film does not use."""
Contact = _hertz.LineContact | _hertz.EllipticContact


class FilmCase(CaseFile):
    """Validated case of a lubricated contact; all quantities in SI units."""

    KIND: ClassVar[str] = "a lubricated contact"

    title: Annotated[str, Field(min_length=1)]
    description: str = ""
    lubricant: LubricantSection
    film: FilmSection
    grid: FilmGridSection = FilmGridSection()
    body1: BodySection
    body2: BodySection
    surface: SurfaceSection
    output: OutputPlace = OutputPlace()

    _cells: FilmGridSection = PrivateAttr(default=FilmGridSection())

    @model_validator(mode="before")
    @classmethod
    def _in_full(cls, data: Any) -> Any:
        return with_surface(data)

    @model_validator(mode="after")
    def _consistent(self) -> FilmCase:
        self._require_elastic()
        self.surface.on_bodies(*self._bodies)
        self._cells = self.grid if self.grid.build() is not None else self._chosen_grid()
        if self.film.approach is None:
            self.load_on(self.cells)
        elif self.surface.nominal_load(self.cells) is not None:
            raise ValueError("film.approach cannot be combined with the load of the part: omit one")
        try:
            checked_task(
                self.cells, self._bodies, None, 1.0, None, self.velocities, self.film.spin,
                self.build_lubricant(), self.film.supply, None, 1, 1e-6, 1,
            )  # fmt: skip
        except ValueError as error:
            raise ValueError(f"film: {error}") from error
        return self

    def _require_elastic(self) -> None:
        """Raise ValueError for bodies that are rigid, yield, or have fields without effect."""
        bodies = (("body1", self.body1), ("body2", self.body2))
        if all(body.is_rigid for _, body in bodies):
            raise ValueError("body1 and body2 are both rigid: at least one must be deformable")
        for name, body in bodies:
            if body.is_plastic:
                raise ValueError(
                    f"{name} is elastic-plastic (law {body.inelastic_laws[0]}), but the film of a "
                    'case file is between elastic bodies: use law = "elastic", or in Python '
                    "sc.lubrication.press"
                )
            for part in body.parts:
                for field in _UNUSED:
                    if getattr(part, field, None) is not None:
                        raise ValueError(f"{name}.{field} has no effect on a film: omit it")

    @property
    def _bodies(self) -> tuple[Any, Any]:
        return self.body1.build(), self.body2.build()

    @property
    def cells(self) -> Grid:
        """Grid of the case, as given or as chosen for the Hertz contact."""
        grid = self._cells.build()
        assert grid is not None  # `_consistent` has chosen one
        return grid

    @property
    def velocities(self) -> Vectors:
        """Velocities of bodies 1 and 2 along x and y [m/s]; at the largest of several speeds."""
        return self.film.velocities(self.surface)

    def build_lubricant(self) -> Lubricant:
        """Create the `Lubricant`."""
        return self.lubricant.build()

    def load_on(self, grid: Grid | None) -> float:
        """Return the load on a grid [N]; ValueError if it is missing or given twice."""
        nominal = self.surface.nominal_load(grid)
        load = self.film.load
        if load is not None and nominal is not None:
            raise ValueError(
                "film.load cannot be combined with the load of the part: use film.load_factor"
            )
        if load is not None:
            return load
        if nominal is None:
            raise ValueError("film.load is required: add it, or a load of the part other than 0")
        return nominal * self.film.load_factor

    def hertz(self, load: float) -> Contact | None:
        """Return the dry Hertz contact at a load [N] > 0; None if Hertz theory does not apply.

        Hertz theory applies to smooth paraboloids and spheres, and to straight flanks of gears,
        without layers.
        """
        return self._line(load) or self.ellipse(load)

    @property
    def _E_star(self) -> float | None:
        """Contact modulus [Pa]; None for bodies to which Hertz theory does not apply."""
        if self.body1.coating or self.body2.coating or self.surface.roughness is not None:
            return None
        return _hertz.effective_modulus(*map(softest, self._bodies))

    def _line(self, load: float) -> _hertz.LineContact | None:
        """Return the Hertz contact of straight flanks; None for other surfaces."""
        E_star, straight = self._E_star, self.surface.straight
        if straight is None or E_star is None:
            return None
        grid = self._cells.build()
        length = grid.ny * grid.dy if grid is not None and grid.periodic else straight[1]
        return _hertz.line(straight[0], E_star, load_per_length=load / length)

    def ellipse(self, load: float) -> _hertz.EllipticContact | None:
        """Return the dry Hertz contact of surfaces with two finite radii; None for others.

        load [N], > 0.
        """
        E_star, radii = self._E_star, self.surface.radii()
        if radii is None or E_star is None or not np.all(np.isfinite(radii)) or self.grid.periodic:
            return None
        return _hertz.elliptic(radii[0], radii[1], E_star, load=load)

    def estimate(self, load: float, velocities: Vectors) -> FilmEstimate | None:
        """Return the film by a formula; None without a Hertz contact, or out of its range.

        load [N]; velocities: of bodies 1 and 2 along x and y [m/s].
        """
        along_y = any(velocity[1] for velocity in velocities)
        contact = None if along_y or self.film.spin or self.film.supply else self.hertz(load)
        if contact is None:
            return None
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the film is solved; the formula is compared only
                speeds = velocities[0][0], velocities[1][0]
                return estimate(contact, speeds, self.build_lubricant())
        except ValueError:
            return None

    def _chosen_grid(self) -> FilmGridSection:
        """Return the grid for the Hertz contact of the case."""
        if self.film.approach is not None:
            raise ValueError("grid: [grid] with nx, ny, dx and dy is required with film.approach")
        load, mean = self.load_on(None), np.mean(self.velocities, axis=0)
        line, ellipse, speed = self._line(load), self.ellipse(load), float(np.hypot(*mean))
        if not speed > 0.0:
            raise ValueError("film: the mean of both speeds must not be 0")
        direction, asked, oil = mean / speed, self.grid.cells_per_radius, self.build_lubricant()
        if line is not None and self.surface.straight is not None:
            M, length = moes(line, (speed, speed), oil).M, self.surface.straight[1]
            return grid_of_line(line.b, length, M, float(direction[0]), asked)
        if ellipse is not None:
            M = moes(ellipse, (speed, speed), oil).M
            along = float(direction[0]), float(direction[1])
            return grid_of_contact((ellipse.a_x, ellipse.a_y), M, along, asked)
        raise ValueError(
            f"grid: [grid] with nx, ny, dx and dy is required with {self._beyond_hertz()}, since "
            "the contact is not that of Hertz theory"
        )

    def _beyond_hertz(self) -> str:
        """Return the field to which Hertz theory does not apply."""
        layered = [name for name in ("body1", "body2") if getattr(self, name).coating]
        if layered:
            return f"{layered[0]}.layers"
        return "surface.roughness" if self.surface.roughness is not None else "this surface"

    def gap(self) -> FloatArray:
        """Return the gap of the undeformed surfaces on the grid [m], shape (nx, ny).

        Raises CaseError if the surface cannot be built, e.g. because its file is missing.
        """
        mean = np.mean(self.velocities, axis=0)
        length = float(np.hypot(*mean)) or 1.0
        along = float(mean[0]) / length, float(mean[1]) / length
        grid = self.cells
        cells = self._cells.shift(grid, along, self.surface.is_known)
        try:
            gap = shifted_gap(self.surface, grid, cells, self.source.parent)
            if not np.isfinite(gap).all():
                raise ValueError(
                    "has no material in some cells of the grid, e.g. beyond the tip of a tooth: "
                    "choose another position, or a smaller grid"
                )
            return gap
        except (ValueError, ImportError) as error:
            raise CaseError(f"{self.source}: [surface] {error}") from error

    @property
    def study(self) -> str:
        return "film"

    def solve(self) -> tuple[FilmSolution, ...]:
        """Return the film at the speed, or at each of `film.speeds`.

        Raises the errors of `lubrication.steady` and `lubrication.stribeck`; the attribute `result`
        of an error contains the films at lower speeds.
        """
        film, grid, gap = self.film, self.cells, self.gap()
        lubricant = self.build_lubricant()
        if film.speeds is not None:
            try:
                curve = stribeck(
                    grid, *self._bodies, gap, load=self.load_on(grid), speeds=film.speeds,
                    slide_to_roll=film.slide_to_roll, lubricant=lubricant, **film.settings(),
                )  # fmt: skip
            except RuntimeError as error:
                if (done := getattr(error, "curve", None)) is not None:
                    attach(error, result=done.solutions)
                raise
            return curve.solutions
        load = None if film.approach is not None else self.load_on(grid)
        return (
            steady(
                grid, *self._bodies, gap, load=load, approach=film.approach,
                speed=self.velocities, spin=film.spin, lubricant=lubricant, supply=film.supply,
                **film.settings(),
            ),
        )  # fmt: skip

# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of lubricated contacts, with [lubricant] and [film]."""

from __future__ import annotations

import os
import warnings
from typing import Any

import numpy as np
from pydantic import model_validator

from .. import hertz as _hertz
from ..bodies.layered import softest
from ..lubrication import FilmEstimate, FilmSolution, estimate, moes
from ..lubrication.sheared import with_shear
from ..lubrication.steady import checked_task
from .film_checks import require_possible
from .film_description import FilmDescription
from .film_grid import FilmGridSection, grid_of_contact, grid_of_line
from .film_studies import solved
from .film_transient import Vectors
from .rolling_parts import with_surface

Contact = _hertz.LineContact | _hertz.EllipticContact


class FilmCase(FilmDescription):
    """Validated case of a lubricated contact; all quantities in SI units."""

    @model_validator(mode="before")
    @classmethod
    def _in_full(cls, data: Any) -> Any:
        return with_surface(data)

    @model_validator(mode="after")
    def _consistent(self) -> FilmCase:
        require_possible(self)
        self.surface.on_bodies(*self.bodies)
        self._cells = self.grid if self.grid.build() is not None else self._chosen_grid()
        if self.yields:
            self._cells = self._cells.with_depth(self.grid)
        if self.film.approach is None:
            self.load_on(self.cells)
        elif self.surface.nominal_load(self.cells) is not None:
            raise ValueError("film.approach cannot be combined with the load of the part: omit one")
        try:
            task = checked_task(
                self.cells, self.bodies, None, 1.0, None, self.velocities, self.film.spin,
                self.build_lubricant(), self.film.supply, None, 1, 1e-6, 1,
            )  # fmt: skip
            with_shear(task, self.cells, self.film.shear_thinning, self.film.thermal)
        except (TypeError, ValueError) as error:  # pydantic collects ValueError only
            raise ValueError(f"film: {error}") from error
        return self

    def hertz(self, load: float) -> Contact | None:
        """Return the dry Hertz contact at a load [N] > 0; None if Hertz theory does not apply.

        Hertz theory applies to smooth paraboloids and spheres and to straight gear flanks, if the
        bodies have no layers.
        """
        return self._line(load) or self.ellipse(load)

    @property
    def _E_star(self) -> float | None:
        """Contact modulus [Pa]; None with layers or roughness, which Hertz theory excludes."""
        if self.body1.coating or self.body2.coating or self.surface.roughness is not None:
            return None
        return _hertz.effective_modulus(*map(softest, self.bodies))

    def _line(self, load: float) -> _hertz.LineContact | None:
        """Return the Hertz line contact of straight flanks; None for other surfaces."""
        E_star, straight = self._E_star, self.surface.straight
        if straight is None or E_star is None:
            return None
        grid = self._cells.build()
        length = grid.ny * grid.dy if grid is not None and grid.periodic else straight[1]
        return _hertz.line(straight[0], E_star, load_per_length=load / length)

    def ellipse(self, load: float) -> _hertz.EllipticContact | None:
        """Return the dry Hertz contact of surfaces with two finite radii; None for other surfaces.

        load: normal load [N], > 0.
        """
        E_star, radii = self._E_star, self.surface.radii()
        if radii is None or E_star is None or not np.all(np.isfinite(radii)) or self.grid.periodic:
            return None
        return _hertz.elliptic(radii[0], radii[1], E_star, load=load)

    def estimate(self, load: float, velocities: Vectors) -> FilmEstimate | None:
        """Estimate the film by a film-thickness formula; return None if no formula applies.

        load: normal load [N]. velocities: of bodies 1 and 2 along x and y [m/s].
        """
        along_y = any(velocity[1] for velocity in velocities)
        film = self.film
        others = film.transient, self.relief1, self.relief2, film.spin or None, film.supply
        is_alone = not (self.yields or along_y) and all(other is None for other in others)
        contact = self.hertz(load) if is_alone else None
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
        """Return a grid chosen from the Hertz contact of the case."""
        if self.film.approach is not None:
            raise ValueError("grid: [grid] with nx, ny, dx and dy is required with film.approach")
        load, mean = self.load_on(None), np.mean(self.velocities, axis=0)
        line, ellipse, speed = self._line(load), self.ellipse(load), float(np.hypot(*mean))
        if not speed > 0.0:
            raise ValueError("film: without grid.nx, the mean surface velocity must not be 0")
        direction, asked, oil = mean / speed, self.grid.cells_per_radius, self.build_lubricant()
        if line is not None and self.surface.straight is not None:
            M, length = moes(line, (speed, speed), oil).M, self.surface.straight[1]
            return grid_of_line(line.b, length, M, float(direction[0]), asked)
        if ellipse is not None:
            M = moes(ellipse, (speed, speed), oil).M
            along = float(direction[0]), float(direction[1])
            return grid_of_contact((ellipse.a_x, ellipse.a_y), M, along, asked)
        raise ValueError(
            f"grid: [grid] with nx, ny, dx and dy is required with {self._beyond_hertz()}, "
            "because Hertz theory does not apply to this contact"
        )

    def _beyond_hertz(self) -> str:
        """Return the name of the field that excludes Hertz theory, or "this surface"."""
        layered = [name for name in ("body1", "body2") if getattr(self, name).coating]
        if layered:
            return f"{layered[0]}.layers"
        return "surface.roughness" if self.surface.roughness is not None else "this surface"

    def solve(
        self, *, progress: bool = False, checkpoint: str | os.PathLike[str] | None = None
    ) -> tuple[FilmSolution, ...]:
        """Return the film, or the films at all `film.speeds`, loads or times.

        checkpoint: folder in which each load or time step is saved, to resume in a repeated call.
        Raises the errors of `lubrication.steady`, `stribeck`, `press_loads` and `transient`; the
        attribute `result` of an error contains the films solved so far.
        """
        return solved(self, progress, checkpoint)

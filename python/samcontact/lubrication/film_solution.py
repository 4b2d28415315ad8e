# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a lubricated contact."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from .._util.display import HtmlTable, Rows, quantity
from .._util.lazy_scipy import scipy
from ..bodies.layered import Body
from ..lubricants.lubricant import Lubricant
from ..problem.grid import Grid
from .boundary import Boundary
from .film_heat import FilmHeat
from .film_plasticity import FilmPlasticity


class FilmLevel(NamedTuple):
    """Summary of the solution on one of the nested grids."""

    cells: tuple[int, int]
    iterations: int
    """Number of Newton iterations."""
    krylov_steps: int
    """Number of GMRES steps in all Newton iterations."""
    operator_applications: float
    """Number of applications of the elastic operator."""
    residual: float
    central_film: float
    """Film thickness at the contact centre [m]."""


class FilmNotResolvedError(ValueError):
    """Error: the film thickness is not positive everywhere, because the cells are too large."""


class FilmErrors(NamedTuple):
    """Estimated absolute errors due to the grid [m], if `accuracy` was given to `steady`."""

    central_film: float
    minimum_film: float


@dataclass(frozen=True, eq=False)
class FilmPast:
    """Data of earlier instants from which a transient film continues."""

    time: float
    """Time since the start [s]."""
    ways: FloatArray
    """Travels of the surfaces of bodies 1 and 2 along x and y since the start [m]."""
    content: FloatArray
    """Content of the film at the preceding instant [m], see `FilmSolution.content`."""
    gap: FloatArray
    """Gap of the undeformed surfaces [m], excluding topography that moves with a body."""
    peak: float
    """Largest pressure at the start [Pa]."""


@dataclass(frozen=True, repr=False, eq=False)
class FilmSolution(HtmlTable):
    """Pressure and film of a lubricated contact, from `lubrication.steady`.

    Fields have the shape (nx, ny).

    Attributes
    ----------
    grid : Grid
    lubricant : Lubricant
    velocities : ndarray, shape (2, 2)
        Velocities of bodies 1 and 2 along x and y, in the frame of the contact [m/s].
    gap : ndarray
        Gap of the undeformed surfaces [m].
    fluid_pressure, boundary_pressure : ndarray
        Pressure of the fluid, and of the boundary layer [Pa].
    film : ndarray
        Film thickness [m]: the distance between the surfaces.
    filling : ndarray
        Share of the film that is filled with lubricant [-]; below 1 in cavitated cells.
    approach : float
        Rigid-body approach of the bodies [m].
    load : float
        Normal load [N].
    residual : float
        Largest relative residual of the equations for flow, load and boundary layer [-]. That of
        the flow is the largest imbalance of a cell, divided by the flow through the central film.
    levels : tuple of FilmLevel
        Summaries of the solutions on the nested grids, from the coarsest to the given grid.
    boundary : Boundary, or None
    spin : float
        Mean angular velocity of the surfaces about z [rad/s].
    bodies : tuple of Material or Layered
        Upper and lower body.
    past : FilmPast, or None
        Data of earlier instants of a transient contact.
    order : int
        Order of the interpolation of the film thickness to the cell faces.
    supply : float
        Thickness of the film that arrives at the inlet [m]; infinite if fully flooded.
    shear_thinning : bool
        Whether the shear stress reduced the viscosity in the flow.
    heat : FilmHeat, or None
        Temperatures of a heated film.
    errors : FilmErrors, or None
        Estimated errors of central and minimum film, if an accuracy was prescribed.
    share_error : float, or None
        Estimated absolute error of `boundary_share` due to the grid [-]. `steady` and `stribeck`
        estimate it for shares from 0.001 to 0.1; infinite if the estimate fails.
    plasticity : FilmPlasticity, or None
        Stress and plastic strain of elastic-plastic bodies, from `press_loads`.
    """

    grid: Grid
    lubricant: Lubricant
    velocities: FloatArray
    gap: FloatArray
    fluid_pressure: FloatArray
    boundary_pressure: FloatArray
    film: FloatArray
    filling: FloatArray
    approach: float
    load: float
    residual: float
    levels: tuple[FilmLevel, ...]
    boundary: Boundary | None = None
    spin: float = 0.0
    bodies: tuple[Body, ...] = ()
    past: FilmPast | None = None
    order: int = 3
    supply: float = math.inf
    shear_thinning: bool = False
    heat: FilmHeat | None = None
    errors: FilmErrors | None = None
    share_error: float | None = None
    plasticity: FilmPlasticity | None = None

    @cached_property
    def pressure(self) -> FloatArray:
        """Sum of the pressures of fluid and boundary layer [Pa], shape (nx, ny)."""
        return self.fluid_pressure + self.boundary_pressure

    @property
    def time(self) -> float:
        """Time since the start of a transient contact [s]; 0 for a steady one."""
        return 0.0 if self.past is None else self.past.time

    @property
    def content(self) -> FloatArray:
        """Content of the film [m], which is filling times relative density times film thickness.

        This is the thickness that the lubricant would have at zero pressure.
        """
        density = self.lubricant.density(self.fluid_pressure)
        content: FloatArray = self.filling * density * self.film
        return content

    @property
    def smooth_gap(self) -> FloatArray:
        """Gap of the undeformed surfaces [m], excluding topography that moves with a body."""
        return self.gap if self.past is None else self.past.gap

    @property
    def central_film(self) -> float:
        """Film thickness where the gap of the undeformed surfaces is smallest [m].

        Topography that moves with a body does not change this place.
        """
        return film_at_centre(self.film, self.smooth_gap)

    @property
    def minimum_film(self) -> float:
        """Smallest film thickness of all cells [m]."""
        return float(self.film.min())

    @property
    def boundary_share(self) -> float:
        """Share of the load that the boundary layer carries [-]."""
        return float(self.boundary_pressure.sum() / self.pressure.sum())

    @property
    def iterations(self) -> int:
        """Number of Newton iterations on the given grid."""
        return self.levels[-1].iterations

    @property
    def converged(self) -> bool:
        """Always True, because an error is raised if a solution does not converge."""
        return True

    def _rows(self) -> Rows:
        rows = [
            ("load", quantity(self.load, "N")),
            ("largest pressure", quantity(float(self.pressure.max()), "Pa")),
            ("central film", self._with_error(self.central_film, 0)),
            ("minimum film", self._with_error(self.minimum_film, 1)),
        ]
        if self.boundary is not None:
            share = quantity(self.boundary_share)
            if self.share_error is not None:
                share += f" ± {quantity(self.share_error)}"
            rows.append(("share of the boundary layer", share))
        if self.heat is not None:
            rows.append(("largest temperature rise", quantity(self.heat.max_rise, "K")))
        return [*rows, ("residual", quantity(self.residual)), ("cells", str(self.film.shape))]

    def _with_error(self, film: float, number: int) -> str:
        """Text of a film thickness, with its estimated error if known."""
        text = quantity(film, "m")
        return text if self.errors is None else f"{text} ± {quantity(self.errors[number], 'm')}"

    def __repr__(self) -> str:
        parts = ", ".join(f"{name}={value}" for name, value in self._rows()[:4])
        return f"FilmSolution({parts})"


def film_at_centre(film: FloatArray, gap: FloatArray) -> float:
    """Return the film thickness at the minimum of a gap [m].

    The position of the minimum is interpolated between cell centres.
    """
    index = np.unravel_index(int(np.argmin(gap)), gap.shape)
    place = []
    for axis, (i, n) in enumerate(zip(index, gap.shape, strict=True)):
        at = float(i)
        if 0 < i < n - 1:
            before, here, after = (
                float(v) for v in np.take(gap[_line(index, axis)], [i - 1, i, i + 1])
            )
            bend = before - 2.0 * here + after
            if bend > 0:
                at += 0.5 * (before - after) / bend
        place.append([at])
    order = 3 if min(n for n in film.shape if n > 1) > 3 else 1
    return float(scipy.ndimage.map_coordinates(film, place, order=order, mode="nearest")[0])


def _line(index: tuple[np.intp, ...], axis: int) -> tuple[slice | int, ...]:
    """Return the index that selects the line of cells through a given cell along an axis."""
    return tuple(slice(None) if k == axis else int(i) for k, i in enumerate(index))

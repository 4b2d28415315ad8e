# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured heights on a regular grid of samples, for use on the grid of a simulation.

Tilt and curvature of maps are removed, and undefined points are filled, by the optional dependency
SurfaceTopography (https://contactengineering.github.io/SurfaceTopography).
"""

from __future__ import annotations

import importlib
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite, positive, real_array
from .._util.display import ShortRepr
from .._util.frozen import FrozenDict, read_only
from .._util.short_text import in_short
from ..problem.grid import Grid
from ..problem.moving_topography import Relief, rows_within
from ..surfaces import SurfaceGrid, require_surface
from .resampling import Sampling, resampled
from .trends import detrended_profile, filled_profile

TRENDS = ("center", "height", "slope", "curvature")
MAX_UNDEFINED_FRACTION = 0.05  # fraction of all points above which a filled surface is unreliable


def library(module: str = "SurfaceTopography") -> Any:
    """Import a module of SurfaceTopography; raise ImportError with advice if it is missing."""
    try:
        with warnings.catch_warnings():
            # importing it warns of missing MPI, which is not needed here
            warnings.simplefilter("ignore", ImportWarning)
            return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(
            "measured surfaces require SurfaceTopography: pip install samcontact[surfaces]"
        ) from error


def undefined_as_nan(heights: ArrayLike) -> FloatArray:
    """Return a copy of the heights, in which masked samples are NaN."""
    if isinstance(heights, (list, tuple)) and any(np.ma.isMaskedArray(row) for row in heights):
        heights = np.ma.stack(heights)
    if np.ma.isMaskedArray(heights):
        heights = np.ma.filled(np.ma.asarray(heights, dtype=np.float64), np.nan)
    return np.array(real_array("heights", heights), order="C")


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredSurface(ShortRepr):
    """Measured heights on a regular grid of samples.

    Parameters
    ----------
    heights : array_like, shape (nx, ny) or (nx,)
        Heights [m], positive out of the body; the first index runs along x. Undefined samples are
        NaN or masked. There must be at least two samples in each direction; a profile has one
        sample along y and applies at every y.
    dx, dy : float
        Sample spacing along x and y [m]. `dy` defaults to `dx`.
    attrs : mapping, optional
        Attributes that describe the origin of the heights.

    Raises
    ------
    ValueError
        The heights have an invalid shape, contain infinite values or are all undefined; or a
        spacing is not positive.

    Notes
    -----
    The origin is the centre of the samples. Each sample represents the area dx dy around it, so
    the measured area is nx dx long and ny dy wide.
    """

    heights: FloatArray
    dx: float
    dy: float | None = None
    attrs: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        heights = undefined_as_nan(self.heights)
        given = heights.shape
        heights = heights[:, None] if heights.ndim == 1 else heights
        if heights.ndim != 2 or heights.shape[0] < 2 or heights.shape[1] < 1:
            raise ValueError(
                "heights must have shape (nx, ny) with nx, ny >= 2, or (nx, 1) for a profile, got "
                f"{given}"
            )
        if np.isinf(heights).any():
            raise ValueError("heights must be finite, or NaN where undefined, got inf")
        if np.isnan(heights).all():
            raise ValueError("heights must be defined in at least one point, got NaN only")
        object.__setattr__(self, "heights", read_only(heights))
        object.__setattr__(self, "dx", positive("dx", self.dx))
        object.__setattr__(self, "dy", self.dx if self.dy is None else positive("dy", self.dy))
        if not isinstance(self.attrs, Mapping):
            raise TypeError(f"attrs must be a mapping, got {in_short(self.attrs)}")
        object.__setattr__(self, "attrs", FrozenDict(self.attrs))

    @property
    def steps(self) -> tuple[float, float]:
        """Sample spacing along x and y [m]."""
        return self.dx, self.dx if self.dy is None else self.dy

    @property
    def size(self) -> tuple[float, float]:
        """Length and width of the measured area [m]."""
        return self.heights.shape[0] * self.steps[0], self.heights.shape[1] * self.steps[1]

    @property
    def is_profile(self) -> bool:
        """Whether the surface is a profile, one row of samples along x that applies at every y."""
        return bool(self.heights.shape[1] == 1)

    @property
    def undefined(self) -> int:
        """Number of samples with an undefined height."""
        return int(np.isnan(self.heights).sum())

    def _topography(self) -> Any:
        # infinite and NaN heights become masked points
        return library().Topography(np.array(self.heights), self.size, unit="m")

    def _changed(self, heights: Any, **attrs: Any) -> MeasuredSurface:
        filled = np.ma.filled(np.ma.asarray(heights, dtype=np.float64), np.nan)
        return replace(self, heights=filled, attrs={**self.attrs, **attrs})

    def detrended(self, trend: str = "height") -> MeasuredSurface:
        """Return the surface without a trend; the trend is fitted to the defined points.

        Parameters
        ----------
        trend : {"center", "height", "slope", "curvature"}
            Trend to subtract. "center": mean height; "height": plane with minimum rms height of the
            residual; "slope": plane with minimum rms slope of the residual; "curvature":
            second-order polynomial, which also removes the shape of a ball. For maps, every trend
            except "center" requires SurfaceTopography. For profiles, a line replaces the plane, and
            a parabola replaces the polynomial.

        Returns
        -------
        MeasuredSurface

        Raises
        ------
        ValueError
            The trend is unknown.
        ImportError
            SurfaceTopography is not installed.
        """
        if choice("trend", trend, TRENDS) == "center":
            return self._changed(self.heights - np.nanmean(self.heights), detrend=trend)
        if self.is_profile:
            heights = detrended_profile(self.heights[:, 0], trend)[:, None]
            return self._changed(heights, detrend=trend)
        return self._changed(self._topography().detrend(trend).heights(), detrend=trend)

    def filled(self) -> MeasuredSurface:
        """Return the surface with undefined points interpolated.

        Maps are interpolated by harmonic functions, and profiles linearly. For a map with undefined
        points, SurfaceTopography is required (ImportError). `attrs` contains the number of
        interpolated points. A UserWarning is issued if more than 5 % of the points are undefined.
        """
        count = self.undefined
        if count == 0:
            return self
        if count > MAX_UNDEFINED_FRACTION * self.heights.size:
            share = 100.0 * count / self.heights.size
            source = f" of {self.attrs['source']}" if "source" in self.attrs else ""
            warnings.warn(
                f"{share:.1f} % of the measured points{source} are undefined and were interpolated",
                stacklevel=2,
            )
        if self.is_profile:
            heights: Any = filled_profile(self.heights[:, 0])[:, None]
        else:
            heights = self._topography().interpolate_undefined_data().heights()
        return self._changed(heights, filled_points=count)

    def mirrored(self, axis: str = "y") -> MeasuredSurface:
        """Return the surface with x or y reversed.

        A body is measured with its surface facing up, but in a simulation body 1 faces down. A
        surface measured on body 1 must therefore be turned over. Heights remain positive out of the
        body.

        Parameters
        ----------
        axis : {"y", "x"}
            Reversed axis: "y" if the body is turned over about the x axis.

        Returns
        -------
        MeasuredSurface
        """
        along_y = choice("axis", axis, ("y", "x")) == "y"
        heights = self.heights[:, ::-1] if along_y else self.heights[::-1]
        return self._changed(heights, mirrored=axis)

    def on(
        self,
        grid: SurfaceGrid,
        x: float = 0.0,
        y: float = 0.0,
        *,
        method: str = "cubic",
        average: bool = False,
        fill: float | None = None,
        periodic: str = "",
    ) -> FloatArray:
        """Return the heights in the cells of a grid.

        Parameters
        ----------
        grid : Grid
            Grid on which the heights are evaluated.
        x, y : float, optional
            Position of the centre of the measured area in the grid [m].
        method : {"cubic", "linear"}
            Spline through the samples: bicubic (exact for cubic polynomials) or bilinear.
        average : bool, optional
            Whether to use the mean height of each cell instead of the height at its centre. The
            mean removes wavelengths shorter than a cell: use it for cells larger than the sample
            spacing.
        fill : float, optional
            Height outside the measured area [m]; -inf if the body ends there. By default the grid
            must lie inside the measured area.
        periodic : {"", "x", "y", "xy"}, optional
            Directions in which the measured area, nx dx long and ny dy wide, is one period of a
            repeated surface. The spline is smooth across the ends of the period. If the grid is
            periodic along such a direction, the length of the grid must be a whole number of
            periods.

        Returns
        -------
        ndarray, shape (grid.nx, grid.ny)
            Heights [m], positive out of the body. For a surface of body 2, the initial gap is
            `surfaces.from_heights(grid, heights)`; for a surface of body 1,
            `surfaces.from_heights(grid, lower, -heights)`.

        Raises
        ------
        ValueError
            The grid extends beyond the measured area, points are undefined, or an argument is
            outside its range.
        """
        require_surface(grid)
        sampling = Sampling(method, average, fill, periodic, edgeless=True)
        self._require_periods(grid, periodic)
        points = np.asarray(grid.x) - finite("x", x), np.asarray(grid.y) - finite("y", y)
        return self._at(points, (grid.dx, grid.dy), sampling)

    def relief(
        self,
        grid: Grid,
        x: float = 0.0,
        y: float = 0.0,
        *,
        periodic: bool = False,
        method: str = "cubic",
        average: bool = False,
        fill: float | None = None,
    ) -> Relief:
        """Convert the surface, over its whole length along x, to a `Relief` that moves with a body.

        Parameters
        ----------
        grid : Grid
            Grid of the simulation. Without `fill`, the measured area must be at least as wide as
            the grid.
        x, y : float, optional
            Position of the centre of the measured area on the body [m].
        periodic : bool, optional
            Whether to repeat the measured area along x. By default the body is flat (height 0)
            beyond the measured area.
        method, average, fill : optional
            As in `on`.

        Returns
        -------
        Relief
            Relief for the argument `relief1` or `relief2` of a `Simulation`. For body 1, convert
            the `mirrored` surface.

        Raises
        ------
        ValueError
            As for `on`, or the measured area is shorter than a cell.
        """
        require_surface(grid)
        centre = finite("x", x)
        # whole cells inside the measured area; with a margin for rounding
        half = 0.5 * (self.size[0] - grid.dx) + 1e-9 * grid.dx
        along, first = rows_within(grid, centre, half)
        if half < 0.0 or np.abs(along - centre).max() > half * (1.0 + 1e-9):
            raise ValueError(
                f"measured area must be at least one cell of the grid long, {grid.dx!r} m, got "
                f"{self.size[0]!r} m"
            )
        points = along - centre, np.asarray(grid.y) - finite("y", y)
        heights = self._at(points, (grid.dx, grid.dy), Sampling(method, average, fill))
        return Relief(heights, first, periodic)

    def _at(
        self, points: tuple[FloatArray, FloatArray], cell: tuple[float, float], sampling: Sampling
    ) -> FloatArray:
        """Return the heights [m] at all combinations of x and y [m]; the area is centred at 0."""
        if self.undefined:
            first = tuple(int(i) for i in np.argwhere(np.isnan(self.heights))[0])
            raise ValueError(
                f"heights must be defined everywhere, got {self.undefined} undefined points, the "
                f"first at index {first}: interpolate them with filled()"
            )
        return resampled(self.heights, self.steps, points, cell, sampling)

    def _require_periods(self, grid: SurfaceGrid, periodic: str) -> None:
        """Raise ValueError unless a periodic grid contains a whole number of measured periods."""
        for axis, (n, d) in enumerate(((grid.nx, grid.dx), (grid.ny, grid.dy))):
            name = "xy"[axis]
            if name not in periodic or name not in getattr(grid, "periodic", ""):
                continue
            if axis == 1 and self.is_profile:
                continue
            period = self.size[axis]
            periods = n * d / period
            if abs(periods - round(periods)) > 1e-6 or round(periods) < 1:
                raise ValueError(
                    f"n{name} d{name} of the periodic grid must be a whole number of periods of "
                    f"the measured area, {period:.6g} m, got {n * d:.6g} m: use d{name} = "
                    f"{period:.6g}/n{name}"
                )

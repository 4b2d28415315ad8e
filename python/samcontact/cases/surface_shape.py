# SPDX-License-Identifier: GPL-3.0-or-later
"""Base class of the shapes in [surface], and roughness in addition to a shape."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, NamedTuple

from pydantic import Field

from .. import surfaces
from .._util.checks import FloatArray
from .base import Length, NonNegative, Section
from .converted import Unit

if TYPE_CHECKING:
    from ..bodies.layered import Body
    from ..problem.grid import Grid


class SinusoidalRoughness(Section):
    """Sinusoidal roughness A sin(2 pi x/lx) sin(2 pi y/ly)."""

    kind: Literal["sinusoidal"]
    amplitude: Annotated[NonNegative, Unit("m")]
    wavelength_x: Length
    wavelength_y: Length

    def build(self, grid: Grid, cells: Grid | None = None) -> FloatArray:
        return surfaces.sinusoidal(grid, self.amplitude, self.wavelength_x, self.wavelength_y)


class SelfAffineRoughness(Section):
    """Random roughness, see `surfaces.rough_self_affine`."""

    kind: Literal["self_affine"]
    rms_height: Annotated[NonNegative, Unit("m")]
    hurst: Annotated[float, Field(ge=0.0, le=1.0)]
    wavelength_min: Length | None = None
    wavelength_max: Length | None = None
    roll_off: Length | None = None
    seed: Annotated[int, Field(ge=0)]

    def build(self, grid: Grid, cells: Grid | None = None) -> FloatArray:
        """Return the heights in the cells of a grid.

        cells: grid on which the roughness is generated, if it differs from `grid`.
        """
        heights = surfaces.rough_self_affine(
            grid if cells is None else cells, **self.model_dump(exclude={"kind"})
        )
        return heights if cells is None else surfaces.interpolated(heights, cells, grid)

    def sample_steps(self, grid: Grid, folder: Path) -> tuple[float, float]:
        """Return half the shortest wavelengths along x and y [m]."""
        shortest = self.wavelength_min
        return (max(grid.dx, grid.dy) if shortest is None else 0.5 * shortest,) * 2


class FirstGrid(NamedTuple):
    """Expected contact of a machine part, from which a first grid is chosen.

    half: half-widths of the contact along x and y [m]. refined: number of cells along y on the
    first grid, relative to the number for a smooth contact of equal width.
    """

    half: tuple[float, float]
    refined: float


class SurfaceShape(Section):
    """Base class of the sections [surface]: a shape with optional roughness."""

    roughness: (
        Annotated[SinusoidalRoughness | SelfAffineRoughness, Field(discriminator="kind")] | None
    ) = None

    def radii(self) -> tuple[float, float] | None:
        """Radii along x, y [m] of a paraboloid that approximates the surface; None if none does."""
        return None

    def nominal_load(self, grid: Grid | None) -> float | None:
        """Contact load on the grid [N] due to the loads on a machine part; None without these."""
        return None

    @property
    def straight(self) -> tuple[float, float] | None:
        """Radius and length [m] of a line contact along y; None for other contacts."""
        return None

    def surface_speeds(self, rates: Mapping[str, float]) -> tuple[float, float] | None:
        """Return the speeds of bodies 1 and 2 along x, relative to the contact [m/s].

        rates: angular speeds of the part [rad/s] by field of [film], e.g. pinion_speed. Returns
        None if the part has no such angular speeds.
        """
        return None

    @property
    def reason_for_grid(self) -> str:
        """Reason why this shape requires [grid] in a case with the field `accuracy`; "" if none."""
        radii = self.radii()
        if radii is None or not all(map(math.isfinite, radii)):
            return (
                f"surface.shape = {getattr(self, 'shape', '')!r} gives a contact of infinite length"
            )
        return ""

    def first_grid(self, load: float, E_star: float) -> FirstGrid | None:
        """Return the expected contact at a load [N]; None if it is the Hertz contact of `radii`."""
        return None

    def require_path(self, loads: Sequence[float | None]) -> None:
        """Raise ValueError if the loads given in the path [N] contradict the load of the part."""

    def on_bodies(self, *bodies: Body) -> None:
        """Store elastic constants of the bodies if the shape depends on them."""

    @property
    def is_known(self) -> bool:
        """Whether the gap is defined on every grid, i.e. has no random or measured heights."""
        return self.roughness is None or self.roughness.kind == "sinusoidal"

    @abstractmethod
    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        """Return the gap of the shape without roughness on a grid; arguments as for `build`."""

    def build(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        """Return the gap on a grid.

        cells: grid for which heights are given, if it differs from `grid`.
        """
        gap = self.shape_gap(grid, folder, cells)
        return gap if self.roughness is None else gap + self.roughness.build(grid, cells)

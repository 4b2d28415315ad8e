# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [grid] of a lubricated contact: cells, and the position of the contact in the grid."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field, model_validator

from .base import Count, Length, Position, Section
from .surface_shape import SurfaceShape

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..problem.grid import Grid

CELLS, CELLS_OF_LINE = 24, 64
"""Default number of cells: per semi-axis of a point contact, per half-width of a line contact."""
LIGHT = 100.0
"""Moes' load parameter M below which a load is called light and requires a longer inlet."""
INLETS, INLETS_OF_LINE = (4.5, 3.0), (5.0, 3.5)
"""Distance from contact centre to inlet in semi-axes or half-widths, at light and heavy load."""
OUTLET, SIDE = 1.5, 1.75
"""Distance from the contact centre to the outlet edge and to the sides, in semi-axes."""
MAX_RATIO = 2.0
"""Largest aspect ratio of a cell; beyond 2.5, films of long elliptic contacts may not converge."""
CENTRE_SHARE = 1.0 / 6.0
"""Default distance of the contact from the centre of a prescribed grid / side of the grid."""
_MULTIPLE = 8  # cells along x and y, for nested grids


class FilmGridSection(Section):
    """[grid]: cells of the film, and position of the contact in the grid."""

    nx: Count | None = None
    ny: Count | None = None
    dx: Length | None = None
    dy: Length | None = None
    nz: Count | None = None
    dz: Length | None = None
    periodic: Literal["", "y"] = ""
    contact_x: Position | None = None
    contact_y: Position | None = None
    cells_per_radius: Annotated[int, Field(ge=8, le=1000)] | None = None

    @model_validator(mode="after")
    def _complete(self) -> FilmGridSection:
        given = {name: getattr(self, name) for name in ("nx", "ny", "dx", "dy")}
        missing = [name for name, value in given.items() if value is None]
        if missing and len(missing) < len(given):
            raise ValueError(f"nx, ny, dx, dy must be given together: add {', '.join(missing)}")
        if not missing and self.cells_per_radius is not None:
            raise ValueError("cells_per_radius cannot be combined with nx, ny, dx, dy: omit one")
        if missing:
            for name in ("periodic", "contact_x", "contact_y"):
                if name in self.model_fields_set:
                    raise ValueError(f"{name} requires nx, ny, dx, dy: add these, or omit {name}")
        if self.nz is not None and self.dz is None:
            raise ValueError("nz requires dz: add dz, or omit nz")
        if self.periodic and self.contact_y is not None:
            raise ValueError('contact_y has no effect with periodic = "y": omit contact_y')
        return self

    def build(self) -> Grid | None:
        """Create the grid of the section; return None if its size is chosen automatically."""
        from ..problem.grid import Grid

        if self.nx is None or self.ny is None or self.dx is None or self.dy is None:
            return None
        return Grid(self.nx, self.ny, self.dx, self.dy, self.nz or 0, self.dz, self.periodic)

    def with_depth(self, given: FilmGridSection) -> FilmGridSection:
        """Return the grid with nz and dz of `given`; default dz: the shorter side of a cell."""
        assert self.dx is not None
        assert self.dy is not None
        shorter = self.dx if self.ny == 1 else min(self.dx, self.dy)
        return self.model_copy(update={"nz": given.nz, "dz": given.dz or shorter})

    def shift(self, grid: Grid, direction: tuple[float, float], is_known: bool) -> tuple[int, int]:
        """Return the distances of the contact from the grid centre along x and y, in cells.

        direction: unit vector of the entrainment. is_known: whether the surface is defined on every
        grid; heights from a file are moved only if contact_x or contact_y is given.
        """
        found = []
        for place, along, n, step in (
            (self.contact_x, direction[0], grid.nx, grid.dx),
            (self.contact_y, direction[1], grid.ny, grid.dy),
        ):
            if place is None:
                place = CENTRE_SHARE * n * step * along if is_known and n > 1 else 0.0
            found.append(round(place / step))
        return found[0], 0 if grid.periodic else found[1]


def grid_of_contact(
    semi_axes: tuple[float, float],
    M: float,
    direction: tuple[float, float],
    cells_per_radius: int | None,
) -> FilmGridSection:
    """Return a grid around an elliptic Hertz contact.

    semi_axes: along x and y [m]. M: Moes' load parameter. direction: unit vector of entrainment.
    """
    inlet, fewest = INLETS[M >= LIGHT], cells_per_radius or CELLS
    largest = MAX_RATIO * min(semi_axes) / fewest
    cells = [max(fewest, math.ceil(axis / largest)) for axis in semi_axes]
    nx, place_x = _extent(cells[0], inlet, direction[0])
    ny, place_y = _extent(cells[1], inlet, direction[1])
    dx, dy = (axis / n for axis, n in zip(semi_axes, cells, strict=True))
    return FilmGridSection(
        nx=nx, ny=ny, dx=dx, dy=dy, contact_x=place_x * dx, contact_y=place_y * dy
    )


def grid_of_line(
    half_width: float, length: float, M: float, sign: float, cells_per_radius: int | None
) -> FilmGridSection:
    """Return a grid across a line contact with the given half-width and length [m].

    M: Moes' load parameter. sign: sign of the entrainment velocity along x.
    """
    cells = cells_per_radius or CELLS_OF_LINE
    nx, place = _extent(cells, INLETS_OF_LINE[M >= LIGHT], math.copysign(1.0, sign))
    dx = half_width / cells
    return FilmGridSection(nx=nx, ny=1, dx=dx, dy=length, periodic="y", contact_x=place * dx)


def _extent(cells: int, inlet: float, along: float) -> tuple[int, int]:
    """Return the number of cells along an axis, and the offset of the contact from the middle.

    cells: number per semi-axis. along: component of the unit vector of entrainment along the axis.
    """
    share = abs(along)
    before = SIDE + share * (inlet - SIDE)
    behind = SIDE + share * (OUTLET - SIDE)
    n = _MULTIPLE * math.ceil((before + behind) * cells / _MULTIPLE)
    return n, round(math.copysign(0.5 * (before - behind) * cells, along))


def shifted_gap(
    surface: SurfaceShape, grid: Grid, cells: tuple[int, int], folder: Path
) -> FloatArray:
    """Return the gap on a grid [m], with the surface shifted by `cells` from the grid centre."""
    more = [abs(n) for n in cells]
    larger = replace(grid, nx=grid.nx + 2 * more[0], ny=grid.ny + 2 * more[1])
    first = [m - n for m, n in zip(more, cells, strict=True)]
    gap = surface.build(larger, folder)
    return gap[first[0] : first[0] + grid.nx, first[1] : first[1] + grid.ny]

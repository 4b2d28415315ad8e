# SPDX-License-Identifier: GPL-3.0-or-later
"""Regular grid on which all fields are defined."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import _core
from .._util.cached_property import cached_property
from .._util.checks import MAX_CELLS_ALONG_AXIS, FloatArray, choice, integer, number
from .._util.display import HtmlTable, Rows, counts, lengths
from .._util.frozen import read_only


@dataclass(frozen=True)
class Grid(HtmlTable):
    """Regular grid of cells.

    Cell centres are x_i = (i - (nx - 1)/2) dx and y_j = (j - (ny - 1)/2) dy. Layer k spans the
    depths from k dz to (k + 1) dz, with z positive into the body. Values in a layer refer to the
    mid-depth of the layer.

    Parameters
    ----------
    nx, ny : int
        Numbers of cells along x and y, from 1 to 2^24.
    dx, dy : float
        Cell sizes [m], > 0.
    nz : int, optional
        Number of layers in volume fields and in a `Track`. Default: chosen to include all plastic
        strain and the stress below the contact; see `State.depths`. Neither nz nor the sides of the
        grid limit the extent of plastic flow.
    dz : float, optional
        Layer thickness [m], > 0. By default, the grid has no layers.
    periodic : {"", "x", "y", "xy"}, optional
        Directions in which bodies, tractions and strains are periodic, with the period nx dx or
        ny dy. By default, no direction is periodic, and the surfaces beyond the grid are free of
        traction. Along a periodic direction, the number of cells must be even, or 1: "y" with
        ny = 1 is a line contact in plane strain.

    Raises
    ------
    ValueError, TypeError
        A count or size is not positive. A size is below 1e-75 or above 1e75 m. nz is given without
        dz. The number of cells along a periodic direction is odd and not 1, or cells are longer
        than eight times the period of the grid in the other direction.

    Notes
    -----
    On a grid periodic in both directions, the mean surface displacement is zero, and the approach
    refers to the mean planes of the undeformed surfaces. On a grid periodic in one direction, the
    displacement does not tend to a limit far from the contact. The displacement due to a line load
    is therefore set to zero at a distance from it of nx dx with periodic="y", and of ny dy with
    periodic="x". See docs/theory/periodic.md.
    """

    nx: int
    ny: int
    dx: float
    dy: float
    nz: int = 0
    dz: float | None = None
    periodic: str = ""

    def __post_init__(self) -> None:
        for name, minimum in (("nx", 1), ("ny", 1), ("nz", 0)):
            count = integer(name, getattr(self, name), minimum)
            if count > MAX_CELLS_ALONG_AXIS:
                raise ValueError(f"{name} must be <= {MAX_CELLS_ALONG_AXIS}, got {count}")
            object.__setattr__(self, name, count)
        for name in ("dx", "dy"):
            object.__setattr__(self, name, number(name, getattr(self, name)))
        if self.nz > 0 and self.dz is None:
            raise ValueError(f"dz must be a finite number > 0 [m] with nz = {self.nz}, got None")
        if self.dz is not None:
            object.__setattr__(self, "dz", number("dz", self.dz))
        periodic = choice("periodic", self.periodic, ("", "x", "y", "xy"))
        object.__setattr__(self, "periodic", periodic)
        for name in self.periodic:
            if (cells := getattr(self, f"n{name}")) > 1 and cells % 2 == 1:
                raise ValueError(
                    f"n{name} must be even, or 1, on a grid periodic along {name}, got {cells}: to "
                    "use a measured period with an odd number of samples, map it onto an even "
                    f'number of cells with MeasuredSurface.on(grid, periodic="{name}")'
                )
        if self.periodic == "xy" and self.nx == self.ny == 1:
            raise ValueError('nx or ny must be > 1 with periodic="xy", got 1 and 1')
        _ = self._core

    @cached_property
    def _core(self) -> Any:
        dz = 0.0 if self.dz is None else self.dz
        return _core.Grid(
            self.nx, self.ny, self.dx, self.dy, self.nz, dz, self.along_x, self.along_y
        )

    @cached_property
    def x(self) -> FloatArray:
        """Cell centres along x [m], shape (nx,)."""
        return read_only(np.array(self._core.x()))

    @cached_property
    def y(self) -> FloatArray:
        """Cell centres along y [m], shape (ny,)."""
        return read_only(np.array(self._core.y()))

    @cached_property
    def z(self) -> FloatArray:
        """Mid-layer depths [m], shape (nz,); ValueError if nz is not given."""
        return self.depths(self.volume_shape[2])

    def depths(self, layers: int) -> FloatArray:
        """Mid-depths of the uppermost `layers` layers [m], shape (layers,)."""
        return read_only(np.array(self._core.z(integer("layers", layers, 0))))

    @property
    def has_volume(self) -> bool:
        """Whether there are layers below the surface."""
        return self.dz is not None

    @property
    def along_x(self) -> bool:
        """Whether the surfaces are periodic along x."""
        return "x" in self.periodic

    @property
    def along_y(self) -> bool:
        """Whether the surfaces are periodic along y."""
        return "y" in self.periodic

    @property
    def surface_shape(self) -> tuple[int, int]:
        """Shape of a surface field, (nx, ny)."""
        return (self.nx, self.ny)

    @property
    def volume_shape(self) -> tuple[int, int, int]:
        """Shape of a scalar volume field, (nx, ny, nz); ValueError if nz is not given."""
        if self.nz == 0 and self.has_volume:
            raise ValueError(
                "volume_shape requires a grid with nz: without nz, each state has its own number "
                "of layers, which is the length of State.depths"
            )
        return (self.nx, self.ny, self.nz)

    @property
    def cell_area(self) -> float:
        """Area of a surface cell [m^2]."""
        return self.dx * self.dy

    def _rows(self) -> Rows:
        rows = [("cells", counts(self.nx, self.ny)), ("cell size", lengths(self.dx, self.dy))]
        extent = [self.nx * self.dx, self.ny * self.dy]
        if self.dz is not None:
            rows[1] = ("cell size", lengths(self.dx, self.dy, self.dz))
        if self.dz is not None and self.nz > 0:
            rows[0] = ("cells", counts(self.nx, self.ny, self.nz))
            extent.append(self.nz * self.dz)
        rows.append(("extent", lengths(*extent)))
        if self.periodic:
            rows.append(("periodic along", " and ".join(self.periodic)))
        return rows

    def __getstate__(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in self.__dataclass_fields__}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


def within_period(grid: Grid, distance: float) -> float:
    """Return a distance along x [m], reduced by whole periods if the grid is periodic along x."""
    return math.remainder(distance, grid.nx * grid.dx) if grid.along_x else distance

# SPDX-License-Identifier: GPL-3.0-or-later
"""The regular grid on which every field lives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import _core
from .._util.cached_property import cached_property
from .._util.checks import MOST_CELLS, FloatArray, choice, integer, number
from .._util.display import Rows, Shown, counts, lengths
from .._util.frozen import read_only


@dataclass(frozen=True)
class Grid(Shown):
    """Cell-centred regular grid.

    Points x_i = (i - (nx - 1)/2) dx, likewise y; layer k spans [k dz, (k + 1) dz] with z into the
    body and its point at mid-depth.

    Parameters
    ----------
    nx, ny : int
        Cells along x and y, from 1 to 2^24.
    dx, dy : float
        Cell sizes [m], > 0.
    nz : int, optional
        Layers that fields of a state have, and a `Track`. By default they have as many as there is
        plastic strain and stress under the contact to see: `State.depths`. Plastic flow goes as
        deep and as wide as it does, whatever nz is and the sides of the grid are.
    dz : float, optional
        Layer thickness [m]; without it there is the surface only.
    periodic : {"", "x", "y", "xy"}, optional
        Directions in which bodies, tractions and strains repeat themselves for ever, with the
        period nx dx, or ny dy, of the grid; default none: beyond it the surfaces are free. Along
        such a direction there are an even number of cells, or one: "y" with ny = 1 is a line
        contact, in plane strain.

    Raises
    ------
    ValueError, TypeError
        A count or size that is not positive, a size below 1e-75 or above 1e75 m, nz without dz, an
        odd number of cells, other than one, along a periodic direction, or cells
        longer than eight periods across.

    Notes
    -----
    The displacement of a surface that is periodic in both directions is that against its mean
    plane, and the approach that of the mean planes of the undeformed gap. Where one direction is
    periodic, displacement has no limit far away; it is counted from the distance of nx dx (ny dy
    with periodic="x"), at which a line load displaces nothing. docs/theory/periodic.md.
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
            if count > MOST_CELLS:
                raise ValueError(f"{name} must be at most {MOST_CELLS}, got {count}")
            object.__setattr__(self, name, count)
        for name in ("dx", "dy"):
            object.__setattr__(self, name, number(name, getattr(self, name)))
        if self.nz > 0 and self.dz is None:
            raise ValueError(f"dz must be a finite number > 0 [m] when nz = {self.nz}, got None")
        if self.dz is not None:
            object.__setattr__(self, "dz", number("dz", self.dz))
        periodic = choice("periodic", self.periodic, ("", "x", "y", "xy"))
        object.__setattr__(self, "periodic", periodic)
        for name in self.periodic:
            if (cells := getattr(self, f"n{name}")) > 1 and cells % 2 == 1:
                raise ValueError(
                    f"n{name} must be even, or 1, where the grid is periodic along {name}, got "
                    f"{cells}; a measured period of any number of samples is put onto it with "
                    f'MeasuredSurface.on(grid, periodic="{name}")'
                )
        if self.periodic == "xy" and self.nx == self.ny == 1:
            raise ValueError('nx or ny must be larger than 1 with periodic="xy", got 1 and 1')
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
        """Mid-depths of the layers [m], shape (nz,); ValueError where nz is not given."""
        return self.depths(self.volume_shape[2])

    def depths(self, layers: int) -> FloatArray:
        """Mid-depths of the first layers [m], shape (layers,)."""
        return read_only(np.array(self._core.z(integer("layers", layers, 0))))

    @property
    def has_volume(self) -> bool:
        """Whether there are layers below the surface."""
        return self.dz is not None

    @property
    def along_x(self) -> bool:
        """Whether the surfaces repeat themselves along x."""
        return "x" in self.periodic

    @property
    def along_y(self) -> bool:
        """Whether the surfaces repeat themselves along y."""
        return "y" in self.periodic

    @property
    def surface_shape(self) -> tuple[int, int]:
        """Shape of a surface field, (nx, ny)."""
        return (self.nx, self.ny)

    @property
    def volume_shape(self) -> tuple[int, int, int]:
        """Shape of a scalar volume field, (nx, ny, nz); ValueError where nz is not given."""
        if self.nz == 0 and self.has_volume:
            raise ValueError(
                "nz is not given: a field has as many layers as its state needs, see State.depths"
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

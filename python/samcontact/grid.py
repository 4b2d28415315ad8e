# SPDX-License-Identifier: GPL-3.0-or-later
"""The regular grid on which every field lives."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from . import _core
from ._checks import MOST_CELLS, FloatArray, integer, number
from ._frozen import read_only
from ._repr import Rows, Shown, counts, lengths


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
        Layers; 0 (the default) is a surface-only grid.
    dz : float, optional
        Layer thickness [m]; needed when nz > 0.

    Raises
    ------
    ValueError, TypeError
        A count or size that is not positive, a size below 1e-75 or above 1e75 m, or dz without nz
        or nz without dz.
    """

    nx: int
    ny: int
    dx: float
    dy: float
    nz: int = 0
    dz: float | None = None

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
        if self.nz == 0 and self.dz is not None:
            raise ValueError(f"nz must be an integer > 0 when dz = {self.dz!r} is given, got 0")
        if self.dz is not None:
            object.__setattr__(self, "dz", number("dz", self.dz))
        _ = self._core

    @cached_property
    def _core(self) -> Any:
        dz = 0.0 if self.dz is None else self.dz
        return _core.Grid(self.nx, self.ny, self.dx, self.dy, self.nz, dz)

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
        """Mid-depths of the layers [m], shape (nz,)."""
        return read_only(np.array(self._core.z()))

    @property
    def surface_shape(self) -> tuple[int, int]:
        """Shape of a surface field, (nx, ny)."""
        return (self.nx, self.ny)

    @property
    def volume_shape(self) -> tuple[int, int, int]:
        """Shape of a scalar volume field, (nx, ny, nz)."""
        return (self.nx, self.ny, self.nz)

    @property
    def cell_area(self) -> float:
        """Area of a surface cell [m^2]."""
        return self.dx * self.dy

    def _rows(self) -> Rows:
        rows = [("cells", counts(self.nx, self.ny)), ("cell size", lengths(self.dx, self.dy))]
        extent = [self.nx * self.dx, self.ny * self.dy]
        if self.dz is not None:
            rows = [
                ("cells", counts(self.nx, self.ny, self.nz)),
                ("cell size", lengths(self.dx, self.dy, self.dz)),
            ]
            extent.append(self.nz * self.dz)
        return [*rows, ("extent", lengths(*extent))]

    def __getstate__(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in self.__dataclass_fields__}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Residual fields of a body along the whole track of a moving contact."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._util import memory
from .._util.checks import FloatArray, axis_number, boolean
from .._util.field_cache import kept
from .._util.frozen import FixedAttributes, read_only
from .._util.quantities import CONTACT, TRACK
from .._util.tensors import COMPONENTS, von_mises
from ..problem.grid import Grid, within_period

if TYPE_CHECKING:
    import xarray as xr

    from ..bodies.layered import Body

__all__ = ["Track"]


class Track(FixedAttributes):
    """Residual fields of one body along its whole track, unloaded, in the frame of the body.

    On a grid that is periodic along x, the track is one period of the body, as positioned at the
    start.

    Created by `State.track`. Fields are read-only and cached like the fields of a state. The origin
    of x is the position of the contact on the body at the start of the simulation.
    """

    def __init__(
        self, core: Any, grid: Grid, body: int, margin: int, layers: int, material: Body
    ) -> None:
        self.body = body
        self.material = material
        """Material or layered body that the fields belong to."""
        start, rows = core.history_rows(body - 1) or (0, grid.nx)
        first_cell = core.first_cell[body - 1]
        self._wrapped = None
        if grid.along_x:  # the rows of the grid, in their order at the start
            start, rows, margin, self._wrapped = -first_cell, grid.nx, 0, first_cell % grid.nx
        self._first_row = start - margin
        self.first = self._first_row + first_cell
        """First row of the track, counted from the first row of the grid at the start."""
        self.grid = Grid(
            rows + 2 * margin,
            grid.ny,
            grid.dx,
            grid.dy,
            nz=layers if grid.has_volume else 0,
            dz=grid.dz,
            periodic=grid.periodic,
        )
        """Grid of the track, with its origin at the centre."""
        # Cell n of the body was initially at (n - (nx - 1)/2) dx of the grid at the start.
        cells = self.first + np.arange(self.grid.nx)
        self.x: FloatArray = read_only((cells - 0.5 * (grid.nx - 1)) * grid.dx)
        """Positions of the cells on the body [m]."""
        self.contact = within_period(grid, -core.travel[body - 1] * grid.dx)
        """Current position of the contact on the body [m]."""
        self._core = core

    @property
    def y(self) -> FloatArray:
        """Cell centres along y [m]."""
        return self.grid.y

    @property
    def z(self) -> FloatArray:
        """Mid-depths of the layers [m]."""
        return self.grid.z

    def residual_displacement(self, axis: str = "z") -> FloatArray:
        """Residual normal displacement [m], shape (len(x), ny), positive into the body.

        With axis="x" or "y": residual tangential displacement.
        """
        return kept(
            self, f"residual_displacement along {axis_number(axis)}",
            lambda: self._core_field("residual_displacement", axis_number(axis)),
        )  # fmt: skip

    def residual_stress(self) -> FloatArray:
        """Residual stress [Pa], shape (6, len(x), ny, nz).

        It is the stress due to plastic strain plus `initial_stress` and `eigenstress`, without the
        stress due to tractions and heat.
        """
        return self._field("residual_stress")

    def initial_stress(self) -> FloatArray:
        """Initial (residual) stress [Pa], shape (6, len(x), ny, nz).

        It is given by `Material.with_residual_stress`; 0 without it.
        """
        return self._field("initial_stress")

    def eigenstress(self) -> FloatArray:
        """Stress due to the `eigenstrain` alone [Pa], shape (6, len(x), ny, nz)."""
        return self._field("eigenstress")

    def eigenstrain(self) -> FloatArray:
        """Sum of strains from `Simulation.add_eigenstrain` [-], shape (6, len(x), ny, nz)."""
        return self._field("eigenstrain")

    def yield_factor(self) -> FloatArray:
        """Factor on the yield stress due to the yield profile [-], shape (len(x), ny, nz)."""
        return self._field("yield_factor")

    def residual_von_mises(self) -> FloatArray:
        """Von Mises stress of the residual stress [Pa], shape (len(x), ny, nz)."""
        return kept(self, "residual_von_mises", lambda: von_mises(self.residual_stress()))

    def residual_hydrostatic(self) -> FloatArray:
        """Mean normal residual stress [Pa], shape (len(x), ny, nz)."""
        mean: FloatArray = self.residual_stress()[:3].mean(axis=0)
        return mean

    def plastic_strain(self) -> FloatArray:
        """Plastic strain [-], tensor components, shape (6, len(x), ny, nz)."""
        return self._field("plastic_strain")

    def equivalent_plastic_strain(self) -> FloatArray:
        """Accumulated equivalent plastic strain [-], shape (len(x), ny, nz)."""
        return self._field("equivalent_plastic_strain")

    def backstress(self) -> FloatArray:
        """Backstresses of kinematic hardening [Pa], shape (terms, 6, len(x), ny, nz)."""
        return self._field("backstress")

    def to_dataset(self, *, volume: bool = True) -> xr.Dataset:
        """Convert the track to a dataset of labelled fields with units, as used by plots of tracks.

        Parameters
        ----------
        volume : bool, optional
            Whether to include volume fields, if the grid has layers. Without volume fields, only
            the residual normal displacement is included.

        Returns
        -------
        xarray.Dataset
            Dataset with the dimensions x and y, and the residual displacement as variable. With
            volume fields, it also has the dimensions z and component, and as variables the plastic
            strain, the equivalent plastic strain, the residual stress, and the von Mises and mean
            normal stress of the latter. The attributes are the number of the body and the cell
            sizes [m].
        """
        import xarray as xr  # importing the package should not load it

        plane, tensor = ("x", "y"), ("component", "x", "y", "z")
        fields: dict[str, tuple[str, ...]] = {"residual_displacement": plane}
        coordinates = {"x": TRACK["x"].variable("x", self.x, self.body)}
        layered = boolean("volume", volume) and self.grid.has_volume
        if layered:
            fields |= {
                "residual_stress": tensor,
                "residual_von_mises": (*plane, "z"),
                "residual_hydrostatic": (*plane, "z"),
                "plastic_strain": tensor,
                "equivalent_plastic_strain": (*plane, "z"),
            }
            coordinates["component"] = CONTACT["component"].variable("component", list(COMPONENTS))
        axes = ("y", "z") if layered else ("y",)
        coordinates |= {axis: CONTACT[axis].variable(axis, getattr(self, axis)) for axis in axes}
        data = {
            name: TRACK[name].variable(dims, getattr(self, name)(), self.body)
            for name, dims in fields.items()
        }
        sizes = {f"d{axis}": getattr(self.grid, f"d{axis}") for axis in ("x", *axes)}
        return xr.Dataset(data, coordinates, {"body": self.body, **sizes})

    def _field(self, name: str) -> FloatArray:
        return kept(self, name, lambda: self._core_field(name))

    def _core_field(self, name: str, *axis: int) -> FloatArray:
        cell = (
            memory.FAST_RESIDUAL_BYTES if name.startswith("residual") else memory.VOLUME_FIELD_BYTES
        )
        needed = memory.volume(self.grid, cell)
        memory.require_for_grid(f"the field {name} of a track", self.grid, needed)
        method = getattr(self._core, f"{name}_in")
        first = self._first_row if self._wrapped is None else 0
        box = first, 0, self.grid.nx, self.grid.ny, self.grid.nz
        field: FloatArray = method(self.body - 1, box, *axis)
        if self._wrapped is None:
            return field
        along = -2 if name == "residual_displacement" else -3
        return read_only(np.roll(field, self._wrapped, along))

    def __repr__(self) -> str:
        return (
            f"Track(body={self.body}, x=[{self.x[0]:.6g}, {self.x[-1]:.6g}] m, "
            f"contact={self.contact:.6g} m)"
        )

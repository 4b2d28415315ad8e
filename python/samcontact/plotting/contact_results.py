# SPDX-License-Identifier: GPL-3.0-or-later
"""Data for the figures of a run: results of the contact, with one body selected."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from .._util.tensors import von_mises
from ..problem.grid import Grid
from ..results.contact import repulsion_of
from ..results.motion import track_of
from ..results.reading import graded_of, grid_of
from ..results.zones import on_grid
from ..solutions.peak import peak_of_dataset
from .contact import HertzContact
from .parts import MIN_LONG_CONTACT_RATIO, map_height, row_of_interest, section_height

if TYPE_CHECKING:
    import xarray as xr

    from ..bodies.layered import Body


@dataclass
class ContactResults:
    """Results of a contact, number of the body shown, and Hertz contact of the increment `peak`."""

    dataset: xr.Dataset
    body: int
    hertz: HertzContact | None

    @cached_property
    def grid(self) -> Grid:
        return grid_of(self.dataset)

    @cached_property
    def peak(self) -> int:
        """Index (from 0) of the increment with the maximum von Mises stress."""
        return peak_of_dataset(self.dataset)

    @cached_property
    def hottest(self) -> int | None:
        """Index (from 0) of the increment with the hottest surface, or None without heating."""
        rise = self.dataset.get(f"surface_temperature_body{self.body}")
        return None if rise is None else int(np.argmax(rise.values.max(axis=(1, 2))))

    @cached_property
    def track(self) -> xr.Dataset | None:
        """Track of the body if it is elastic-plastic and has moved, otherwise None."""
        return track_of(self.dataset, self.body)

    @cached_property
    def graded(self) -> Body | None:
        """Body if its yield stress or initial stress varies with depth, otherwise None."""
        return graded_of(self.dataset, self.body)

    def number(self, position: int) -> int:
        """Return the number (from 1) of an increment; `position` is its index (from 0)."""
        return int(self.dataset["increment"].values[position])

    def surface(self, name: str, position: int) -> FloatArray:
        """Return a surface field at an increment; `position` is the index (from 0).

        name: name of the variable, without the suffix _body1 or _body2.
        """
        if name == "repulsion":
            known: FloatArray = repulsion_of(self.dataset).values[position]
            return known
        own = f"{name}_body{self.body}"
        field: FloatArray = self.dataset[own if own in self.dataset else name].values[position]
        return field

    def has(self, name: str, number: int) -> bool:
        """Whether a volume field of the body is known in all cells at an increment.

        Strains are known in all cells, because they are 0 where they are not stored. name: name of
        the variable, without the suffix _body1 or _body2. number: number of the increment (from 1).
        """
        stored = self.dataset.get(f"{name}_body{self.body}")
        if stored is None or number not in self.dataset["output_increment"].values:
            return False
        return "x" in stored.dims or "strain" in name  # strains are zero where not stored

    def field(self, name: str, number: int) -> FloatArray:
        """Return a stored volume field of the body at an increment; `number` counts from 1."""
        if name == "residual_von_mises":
            return von_mises(self.field("residual_stress", number))
        stored = self.dataset[f"{name}_body{self.body}"].sel(output_increment=number)
        stored = on_grid(stored, self.dataset)
        last = f"interface_body{self.body}"
        axes = [a for a in ("side", "component", "x", "y", "z", last) if a in stored.dims]
        field: FloatArray = stored.transpose(*axes).values
        return field

    def row(self, field: FloatArray, across: str = "y") -> float:
        """Return the position [m] at which a profile or section of a field is drawn.

        This is the middle row of cells or the row with the maximum, see `row_of_interest`. across:
        coordinate of the returned position, "x" or "y".
        """
        axis = "xy".index(across)
        others = tuple(n for n in range(field.ndim) if n != axis)
        centres = getattr(self.grid, across)
        return float(centres[row_of_interest(np.abs(field).max(axis=others), centres)])

    @property
    def pressure_label(self) -> str | None:
        """Label of the computed pressure; None without a Hertz contact to compare it with."""
        return None if self.hertz is None else "computed"

    @property
    def has_map(self) -> bool:
        """Whether the grid has several cells along both x and y, so that maps are of use."""
        return min(self.grid.nx, self.grid.ny) > 1

    @property
    def interfaces(self) -> FloatArray:
        """Depths of the interfaces between layers of the body [m]."""
        return np.cumsum(self.dataset.attrs.get(f"body{self.body}_thickness", ()))

    @property
    def map_look(self) -> tuple[str, tuple[float, float]]:
        """Horizontal coordinate of maps ("x" or "y"), and width and height of a map [inches]."""
        grid = self.grid
        long, wide = grid.ny * grid.dy, grid.nx * grid.dx
        if long <= MIN_LONG_CONTACT_RATIO * wide:
            return "x", (5.0, 3.6)
        return "y", (5.0, map_height(5.0, long, wide))

    @property
    def section_height(self) -> float:
        """Height of a figure with a section of the whole grid [inches], for a width of 5 inches."""
        grid = self.grid
        return section_height(5.0, grid.nx * grid.dx, grid.nz * (grid.dz or 0.0))

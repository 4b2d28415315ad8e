# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction versus velocity, and its labelled dataset."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray, boolean
from .._util.sliding_quantities import SLIDING
from .._util.version import version
from ..problem.settings import ContactSettings
from ..solutions.moving_solution import SlidingSolution

if TYPE_CHECKING:
    import xarray as xr

    from ..problem.grid import Grid


@dataclass(frozen=True, repr=False, eq=False)
class FrictionCurve:
    """Friction versus velocity, from `over_speed`."""

    solutions: tuple[SlidingSolution, ...]
    """Solution at each velocity."""
    tol: float = ContactSettings.tol
    """Relative tolerance of the solutions [-]."""

    @property
    def velocity(self) -> FloatArray:
        """Velocities [m/s], shape (n,)."""
        return np.array([s.velocity for s in self.solutions])

    @property
    def friction(self) -> FloatArray:
        """Hysteretic friction coefficient at each velocity [-], shape (n,)."""
        return np.array([s.friction for s in self.solutions])

    @property
    def contact_area(self) -> FloatArray:
        """Contact area at each velocity [m^2], shape (n,)."""
        return np.array([s.contact_area for s in self.solutions])

    @property
    def max_pressure(self) -> FloatArray:
        """Largest pressure at each velocity [Pa], shape (n,)."""
        return np.array([float(s.pressure.max()) for s in self.solutions])

    def to_dataset(self, *, fields: bool = True) -> xr.Dataset:
        """Convert to a labelled dataset with units; its dimension `point` counts the velocities.

        Parameters
        ----------
        fields : bool, optional
            Whether to include the pressure of all cells; it is 0 outside the grid of a solution. On
            grids that are periodic along x and y, the dataset also contains the share of the area
            that is in contact.

        Returns
        -------
        xarray.Dataset
        """
        import xarray as xr

        boolean("fields", fields)
        area = np.array([s.grid.nx * s.grid.ny * s.grid.cell_area for s in self.solutions])
        data: dict[str, Any] = {
            "velocity": self.velocity,
            "friction": self.friction,
            "contact_area": self.contact_area,
            "max_pressure": self.max_pressure,
        }
        for name in ("load", "approach", "power", "iterations", "error"):
            data[name] = np.array([getattr(s, name) for s in self.solutions])
        if self.solutions[0].grid.periodic == "xy":  # the area of another grid is arbitrary
            data["contact_share"] = self.contact_area / area
        data["friction_force"] = data["friction"] * data["load"]
        made = xr.Dataset(
            {name: SLIDING[name].variable(("point",), data[name]) for name in SLIDING
             if name in data},
            {"point": SLIDING["point"].variable("point", np.arange(1, len(area) + 1))},
            {"title": "friction over velocity", "samcontact_version": version, "tol": self.tol,
             "dx": self.solutions[0].grid.dx, "dy": self.solutions[0].grid.dy},
        )  # fmt: skip
        return made if not fields else made.assign(self._pressure()).assign_coords(self._cells())

    def _largest(self) -> Grid:
        return max((s.grid for s in self.solutions), key=lambda grid: grid.nx * grid.ny)

    def _cells(self) -> dict[str, xr.Variable]:
        grid = self._largest()
        return {
            name: SLIDING[name].variable(name, np.asarray(getattr(grid, name))) for name in "xy"
        }

    def _pressure(self) -> dict[str, xr.Variable]:
        """Pressure on the largest grid; grids are enlarged evenly on both sides."""
        nx = max(s.grid.nx for s in self.solutions)
        ny = max(s.grid.ny for s in self.solutions)
        values = np.zeros((len(self.solutions), nx, ny))
        for whole, s in zip(values, self.solutions, strict=True):
            i, j = (nx - s.grid.nx) // 2, (ny - s.grid.ny) // 2
            whole[i : i + s.grid.nx, j : j + s.grid.ny] = s.pressure
        return {"pressure": SLIDING["pressure"].variable(("point", "x", "y"), values)}

    def __repr__(self) -> str:
        v, mu = self.velocity, self.friction
        peak = int(np.argmax(mu))
        return (
            f"FrictionCurve({len(v)} velocities from {v[0]:g} to {v[-1]:g} m/s, largest friction "
            f"{mu[peak]:.4g} at {v[peak]:g} m/s)"
        )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Two spheres that slide past each other: their geometry."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .._util.checks import finite, integer, positive
from ..scene.grid import Grid


@dataclass(frozen=True)
class Collision:
    """Geometry of two spheres, one sliding over the other at a constant height.

    Parameters
    ----------
    R1, R2 : float
        Radii of the upper and the lower sphere [m], > 0.
    interference : float
        Of the undeformed spheres when aligned [m]; > 0 and below both radii.

    Raises
    ------
    ValueError
        A value outside its range.
    """

    R1: float
    R2: float
    interference: float

    def __post_init__(self) -> None:
        for name in ("R1", "R2", "interference"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        smallest = min(self.R1, self.R2)
        if self.interference >= smallest:
            raise ValueError(
                f"interference must be below both radii, < {smallest!r} m, "
                f"got {self.interference!r}"
            )

    @property
    def R(self) -> float:
        """Equivalent radius R1 R2/(R1 + R2) [m]."""
        return self.R1 * self.R2 / (self.R1 + self.R2)

    @property
    def height(self) -> float:
        """Of the centre of sphere 1 above that of sphere 2 [m]."""
        return self.R1 + self.R2 - self.interference

    @property
    def half_angle(self) -> float:
        """Angle of the line of centres from the vertical when the spheres touch [rad]."""
        return 2.0 * math.asin(math.sqrt(0.5 * self.interference / (self.R1 + self.R2)))

    @property
    def half_way(self) -> float:
        """Horizontal distance of the centres when the spheres touch [m]."""
        return self.offset(self.half_angle)

    def offset(self, angle: float) -> float:
        """Horizontal distance X of the centres [m] at an angle of their line from the vertical."""
        return self.height * math.tan(finite("angle", angle))

    def separation(self, angle: float) -> float:
        """Distance of the centres [m]."""
        return self.height / math.cos(finite("angle", angle))

    def approach(self, angle: float) -> float:
        """Approach of the spheres along the line of centres [m]; negative: apart."""
        finite("angle", angle)
        # R1 + R2 - separation without cancellation
        return self.interference - 2.0 * self.height * math.sin(0.5 * angle) ** 2 / math.cos(angle)

    def advance(self, angle: float) -> tuple[float, float]:
        """How far the surfaces move through the contact while the line turns by an angle [m].

        Along the local +x: the contact moves backwards over sphere 1 and forwards over sphere 2.
        """
        return self.R1 * finite("angle", angle), -self.R2 * angle

    def grid(
        self,
        increments: int = 24,
        cells_per_increment: int = 1,
        *,
        width: float = 1.8,
        depth: float = 1.9,
        dy: float = 1.0,
        dz: float = 1.0,
    ) -> Grid:
        """Grid for `tug` whose cells fit its increments.

        Parameters
        ----------
        increments : int
            From touching to parting, >= 4.
        cells_per_increment : int
            Cells that the contact moves over body 2 in each, >= 1.
        width : float
            Half the width of the grid over sqrt(2 R interference), the radius of the disc that the
            undeformed spheres share.
        depth : float
            Of the grid over the same.
        dy, dz : float
            Sizes of a cell over its size along x.
        """
        count = integer("increments", increments, 4)
        parts = integer("cells_per_increment", cells_per_increment, 1)
        dx = self.R2 * 2.0 * self.half_angle / count / parts
        reach = math.sqrt(2.0 * self.R * self.interference)
        half = positive("width", width) * reach
        across, down = positive("dy", dy) * dx, positive("dz", dz) * dx
        nx, ny = (2 * math.ceil(half / cell) + 1 for cell in (dx, across))
        layers = math.ceil(positive("depth", depth) * reach / down)
        return Grid(nx, ny, dx, across, layers, down)

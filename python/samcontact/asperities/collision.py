# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometry of two spheres that slide past each other."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .._util.checks import finite, integer, positive
from ..problem.grid import Grid


@dataclass(frozen=True)
class Collision:
    """Geometry of two spheres, one sliding over the other at a constant height.

    Parameters
    ----------
    R1, R2 : float
        Radii of the upper and the lower sphere [m], > 0.
    interference : float
        Overlap of the undeformed spheres when aligned [m]; > 0 and below both radii.

    Raises
    ------
    ValueError
        A value is outside its range.
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
                f"interference must be less than the smaller radius ({smallest!r} m), got "
                f"{self.interference!r} m"
            )

    @property
    def R(self) -> float:
        """Equivalent radius R1 R2/(R1 + R2) [m]."""
        return self.R1 * self.R2 / (self.R1 + self.R2)

    @property
    def height(self) -> float:
        """Height of the centre of sphere 1 above the centre of sphere 2 [m]."""
        return self.R1 + self.R2 - self.interference

    @property
    def half_angle(self) -> float:
        """Angle between the line of centres and the vertical at first contact [rad]."""
        return 2.0 * math.asin(math.sqrt(0.5 * self.interference / (self.R1 + self.R2)))

    @property
    def half_distance(self) -> float:
        """Horizontal distance of the centres at first contact [m]."""
        return self.offset(self.half_angle)

    def offset(self, angle: float) -> float:
        """Horizontal distance X of the centres [m].

        angle: between the line of centres and the vertical [rad].
        """
        return self.height * math.tan(finite("angle", angle))

    def separation(self, angle: float) -> float:
        """Distance of the centres [m].

        angle: between the line of centres and the vertical [rad].
        """
        return self.height / math.cos(finite("angle", angle))

    def approach(self, angle: float) -> float:
        """Approach of the spheres along the line of centres [m]; negative: separated."""
        finite("angle", angle)
        # R1 + R2 - separation without cancellation
        return self.interference - 2.0 * self.height * math.sin(0.5 * angle) ** 2 / math.cos(angle)

    def advance(self, angle: float) -> tuple[float, float]:
        """Displacements [m] of the surfaces of bodies 1 and 2 through the contact.

        angle: rotation of the line of centres [rad].

        Displacements are positive along the local +x. The contact moves backwards over sphere 1 and
        forwards over sphere 2.
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
        """Grid for `collide`, with cells that match the increments of a pass.

        Parameters
        ----------
        increments : int
            Number of increments from first contact to separation, >= 4.
        cells_per_increment : int
            Displacement of the contact over body 2 per increment, in cells of size dx, >= 1.
        width : float
            Half-width of the grid, as a multiple of sqrt(2 R interference), the radius of the disc
            in which the undeformed spheres overlap.
        depth : float
            Depth of the grid, as a multiple of the radius of this disc.
        dy, dz : float
            Cell sizes along y and z, as multiples of the cell size along x.
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

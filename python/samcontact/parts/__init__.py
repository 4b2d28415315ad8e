# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes of machine parts and indenters, as gaps on a grid.

Each function or method that takes a grid returns the gap of the undeformed bodies in the cells of
the grid, with the contact at the origin. Pass this array as the gap to a `ContactSolver` or a
`Simulation`. If you pass a function of the grid instead, e.g. ``lambda grid: parts.cone(grid,
1.2)``, the grid can be enlarged. Angles are in radians.
"""

from .cams import Cam, TappetContact
from .gears import FlankContact, GearPair
from .indenters import berkovich, cone, flat_punch, vickers
from .wheel_rail import WheelRail

__all__ = [
    "Cam",
    "FlankContact",
    "GearPair",
    "TappetContact",
    "WheelRail",
    "berkovich",
    "cone",
    "flat_punch",
    "vickers",
]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Asperity collision: sliding of one spherical asperity over another with interference.

The upper asperity moves along +X at a constant height over the lower one; neither rotates. The
contact is solved in a local frame with z along the line of centres. The approach follows from the
geometry of the spheres. The method follows Boucly (2008), part 4; the kinematics are derived in
docs/theory/moving_contacts.md.
"""

from .collide import CollisionResult, collide
from .collision import Collision

__all__ = ["Collision", "CollisionResult", "collide"]

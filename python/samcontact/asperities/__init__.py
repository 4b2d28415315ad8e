# SPDX-License-Identifier: GPL-3.0-or-later
"""Asperity collision: two spherical asperities slide past each other with interference.

The upper asperity moves along +X at a constant height over the lower one; neither rotates. The
contact is solved in the local frame, whose z axis is the line of centres, for the approach given by
the geometry. Boucly (2008), part 4, with rederived kinematics: docs/theory/moving_contacts.md.
"""

from .collide import CollisionResult, collide
from .collision import Collision

__all__ = ["Collision", "CollisionResult", "collide"]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Tugging: two spherical asperities that slide past each other and interfere.

The upper one moves along +X at a constant height over the lower one; neither rotates. The contact
is solved in the local frame, whose z is the line of the centres, by the approach that geometry
imposes. Boucly (2008), part 4, with its kinematics derived anew: docs/theory/moving_contacts.md.
"""

from .collision import Collision
from .tugging import Tugging, tug

__all__ = ["Collision", "Tugging", "tug"]

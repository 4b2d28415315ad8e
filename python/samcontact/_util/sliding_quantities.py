# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of friction versus velocity by name, with unit, description and display."""

from __future__ import annotations

from .quantities import CONTACT, Q

SLIDING = {
    "point": Q("1", "number of the velocity"),
    "x": CONTACT["x"],
    "y": CONTACT["y"],
    # scalars of each velocity
    "velocity": Q(
        "m/s", "velocity of body 1 relative to body 2 along x", "m/s", "sliding velocity",
        "velocity",
    ),
    "load": CONTACT["load"],
    "friction": Q(
        "1", "hysteretic friction coefficient", "", "hysteretic friction coefficient", "friction"
    ),
    "friction_force": Q(
        "N", "hysteretic friction force against the velocity", "N", "hysteretic friction force",
        "friction\nforce",
    ),
    "power": Q("W", "energy lost in the bodies per time", "W", "power lost", "power"),
    "contact_area": CONTACT["contact_area"],
    "contact_share": Q(
        "1", "contact area over the area of the grid", "%", "contact share", "contact\nshare"
    ),
    "max_pressure": CONTACT["max_pressure"],
    "approach": CONTACT["approach"],
    "iterations": Q("1", "iterations of the contact solver", "", "iterations", "iterations"),
    "error": Q("1", "complementarity error of the solution", "", "complementarity error"),
    # surface fields
    "pressure": CONTACT["pressure"],
}  # fmt: skip

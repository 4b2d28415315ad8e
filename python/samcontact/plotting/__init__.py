# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a simulation. Functions take an `ax` (a new figure by default) and return it.

Only the object-oriented interface of Matplotlib is used: importing this module starts no GUI and
does not change the pyplot state. Lengths are in micrometres, stresses in MPa or GPa; depth points
downward.
"""

from . import tugging, wear
from .animation import rolling_animation, save_animation
from .contact import (
    axis_profile,
    load_approach,
    pressure_profile,
    print_profile,
    temperature_profile,
)
from .fatigue import fatigue_depth, fatigue_map, fatigue_section
from .interface import interface_profile
from .maps import surface_map, track_map
from .parts import column
from .section import section
from .shakedown import shakedown_map, strain_per_cycle
from .slip_animation import stick_slip_animation
from .slipping import creep_curve, fretting_loop, rolling_force, shear_profile, stick_slip_map
from .summary import summary_figures
from .track import loaded_section, track_print, track_section
from .view import save_view, view

__all__ = [
    "axis_profile",
    "column",
    "creep_curve",
    "fatigue_depth",
    "fatigue_map",
    "fatigue_section",
    "fretting_loop",
    "interface_profile",
    "load_approach",
    "loaded_section",
    "pressure_profile",
    "print_profile",
    "rolling_animation",
    "rolling_force",
    "save_animation",
    "save_view",
    "section",
    "shakedown_map",
    "shear_profile",
    "stick_slip_animation",
    "stick_slip_map",
    "strain_per_cycle",
    "summary_figures",
    "surface_map",
    "temperature_profile",
    "track_map",
    "track_print",
    "track_section",
    "tugging",
    "view",
    "wear",
]

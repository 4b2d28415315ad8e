# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a simulation. Functions draw on the axes `ax` (default: new ones) and return them.

Only the object-oriented interface of Matplotlib is used: importing this module starts no GUI and
does not change the pyplot state. Lengths are in micrometres, stresses in MPa or GPa; depth points
downward.
"""

from . import asperities, sliding, wear
from .adhesion import cohesive_zone, pull_off_over_tabor
from .animation import rolling_animation, save_animation
from .contact import (
    axis_profile,
    imprint_profile,
    load_approach,
    pressure_profile,
    temperature_profile,
)
from .fatigue import exposure_depth, fatigue_depth, fatigue_map, fatigue_section
from .film_animation import film_animation
from .film_courses import film_imprint, film_over_time
from .films import (
    film_map,
    film_profile,
    film_temperature,
    interferogram,
    regime_chart,
    stribeck_curve,
    traction_curve,
)
from .inclusions import butterfly, inclusion_outlines, weibull
from .interface import interface_profile
from .maps import surface_map, track_map
from .over_time import over_time
from .parts import journal_column
from .section import section
from .shakedown import shakedown_map, strain_per_cycle
from .sliding import friction_curve
from .slip_animation import partial_slip_animation
from .slipping import creep_curve, fretting_loop, partial_slip_map, rolling_force, shear_profile
from .summary import summary_figures
from .track import loaded_section, track_imprint, track_section
from .view import save_view, view

__all__ = [
    "asperities",
    "axis_profile",
    "butterfly",
    "cohesive_zone",
    "creep_curve",
    "exposure_depth",
    "fatigue_depth",
    "fatigue_map",
    "fatigue_section",
    "film_animation",
    "film_imprint",
    "film_map",
    "film_over_time",
    "film_profile",
    "film_temperature",
    "fretting_loop",
    "friction_curve",
    "imprint_profile",
    "inclusion_outlines",
    "interface_profile",
    "interferogram",
    "journal_column",
    "load_approach",
    "loaded_section",
    "over_time",
    "partial_slip_animation",
    "partial_slip_map",
    "pressure_profile",
    "pull_off_over_tabor",
    "regime_chart",
    "rolling_animation",
    "rolling_force",
    "save_animation",
    "save_view",
    "section",
    "shakedown_map",
    "shear_profile",
    "sliding",
    "strain_per_cycle",
    "stribeck_curve",
    "summary_figures",
    "surface_map",
    "temperature_profile",
    "track_imprint",
    "track_map",
    "track_section",
    "traction_curve",
    "view",
    "wear",
    "weibull",
]

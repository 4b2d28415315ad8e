# SPDX-License-Identifier: GPL-3.0-or-later
"""Lubricated contacts: film thickness, regime of lubrication and friction.

    oil = sc.Lubricant.roelands(viscosity=0.04, pressure_viscosity=22e-9)
    contact = sc.hertz.point(R=0.01, E_star=113.7e9, load=20.0)
    sc.lubrication.estimate(contact, (1.0, 1.0), oil)

The speeds (u1, u2) are the surface velocities along x in the frame of the contact.
"""

from .boundary import Boundary
from .estimate import FilmEstimate, bearing_speeds, estimate, lambda_ratio
from .film_heat import FilmHeat
from .film_plasticity import FilmPlasticity
from .film_solution import FilmErrors, FilmLevel, FilmSolution
from .formulas import (
    FilmThickness,
    dowson_higginson,
    hamrock_dowson,
    inlet_heating_factor,
    nijenbanning,
    regime,
    rigid_isoviscous,
)
from .friction import FilmFriction, friction
from .groups import MoesNumbers, moes
from .loading import press_loads
from .pass_stress import pass_stress
from .running_in import RunningIn, running_in
from .steady import steady
from .stribeck import StribeckCurve, stribeck
from .traction import TractionCurve, traction_curve
from .transient import FilmHistory, transient
from .yielding import FilmIncrement, press

__all__ = [
    "Boundary",
    "FilmErrors",
    "FilmEstimate",
    "FilmFriction",
    "FilmHeat",
    "FilmHistory",
    "FilmIncrement",
    "FilmLevel",
    "FilmPlasticity",
    "FilmSolution",
    "FilmThickness",
    "MoesNumbers",
    "RunningIn",
    "StribeckCurve",
    "TractionCurve",
    "bearing_speeds",
    "dowson_higginson",
    "estimate",
    "friction",
    "hamrock_dowson",
    "inlet_heating_factor",
    "lambda_ratio",
    "moes",
    "nijenbanning",
    "pass_stress",
    "press",
    "press_loads",
    "regime",
    "rigid_isoviscous",
    "running_in",
    "steady",
    "stribeck",
    "traction_curve",
    "transient",
]

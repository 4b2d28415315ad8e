# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of steady rolling and sliding of viscoelastic bodies, with all arguments."""

from calls_of_contact import GAP, GRID, LOAD
from calls_of_formulas import STEEL

import samcontact as sc

RUBBER = sc.Material.elastic(2e11, 0.4).with_relaxation(times=[1e-4, 1e-3], shares=[0.3, 0.2])
BODIES = {"grid": GRID, "body1": STEEL, "body2": RUBBER, "gap": GAP}
SETTINGS = {"tol": 1e-6, "on_border": "error", "max_iterations": 500}
SLID = sc.sliding.steady(**BODIES, load=LOAD, velocity=0.1)
CURVE = sc.sliding.over_speed(**BODIES, load=LOAD, velocities=[0.1])
ROLLED = sc.rolling.steady(**BODIES, load=LOAD, friction=0.0, speed=0.1)

CALLS = [
    (
        "sliding.steady",
        sc.sliding.steady,
        {**BODIES, "load": LOAD, "velocity": 0.1, "start": SLID, **SETTINGS},
    ),
    ("sliding.steady", sc.sliding.steady, {**BODIES, "approach": 1e-7, "velocity": 0.1}),
    (
        "sliding.over_speed",
        sc.sliding.over_speed,
        {
            **BODIES,
            "load": LOAD,
            "velocities": [0.1, 1.0],
            "checkpoint": None,
            "progress": False,
            **SETTINGS,
        },
    ),
    ("sliding.FrictionCurve.to_dataset", CURVE.to_dataset, {"fields": True}),
    (
        "rolling.steady",
        sc.rolling.steady,
        {**BODIES, "load": LOAD, "friction": 0.0, "speed": 0.1, "start": ROLLED, **SETTINGS},
    ),
    (
        "rolling.steady",
        sc.rolling.steady,
        {
            **BODIES,
            "load": LOAD,
            "friction": sc.Coulomb(0.3),
            "creepage": (1e-3, 0.0),
            "speed": 0.1,
            **SETTINGS,
        },
    ),
]

# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every public function of shakedown that computes on a grid."""

import numpy as np
from calls_of_contact import BODIES, GAP, LOAD

import samcontact as sc

PERIODIC = sc.Grid(4, 1, 5e-5, 1e-3, dz=5e-5, periodic="xy")
CYCLE = [{"load": 0.01 * LOAD, "advance": (0.0, 0.0)}, {"load": 0.0}]
RUN = {
    "simulation": sc.Simulation(**BODIES, gap=GAP, tol=1e-4), "cycle": CYCLE, "cycles": 2,
    "tol": 1e-2, "accelerate": True, "progress": False, "checkpoint": None,
}  # fmt: skip
RESULT = sc.shakedown.run(**RUN)

CALLS = [
    ("shakedown.run", sc.shakedown.run, RUN),
    (
        "shakedown.passes",
        sc.shakedown.passes,
        {"grid": PERIODIC, "pressure": np.full((4, 1), 1e8), "cells": 2},
    ),
    ("shakedown.ShakedownResult.strain_per_cycle", RESULT.strain_per_cycle, {"body": 2}),
    ("shakedown.ShakedownResult.residual_stress", RESULT.residual_stress, {"body": 2}),
]

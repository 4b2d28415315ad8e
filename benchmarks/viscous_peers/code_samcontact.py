# SPDX-License-Identifier: GPL-3.0-or-later
"""samcontact: `Simulation` with a viscoelastic body; the load step is elastic."""

from __future__ import annotations

import numpy as np

import samcontact as sc

from .problems import DURATION, MEAN_PRESSURE, MODULUS, RELAXATION_TIME, RIGID, RUBBER, SIDE, Creep


def pressure_after(problem: Creep, steps: int, tol: float) -> np.ndarray:
    """Return the pressure at the end of the creep."""
    load = MEAN_PRESSURE * MODULUS * SIDE**2
    run = sc.Simulation(problem.grid, RIGID, RUBBER, problem.gap * SIDE, tol=tol)
    run.step(load=load, duration=0.0)
    for _ in range(steps):
        run.step(load=load, duration=DURATION * RELAXATION_TIME / steps)
    return np.asarray(run.state.pressure / MODULUS)

# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas: `MaxwellViscoelastic`, the backward Euler rule on the pressure.

Its branches agree with the backward Euler rule only if the long-time shear modulus is 1, which is
therefore the unit of stress.
"""

from __future__ import annotations

import numpy as np
import tamaas as tm

from .problems import DURATION, MEAN_PRESSURE, RELAXING, Creep

tm.initialize(1)
tm.set_log_level(tm.LogLevel.error)


def pressure_after(problem: Creep, steps: int, tol: float) -> np.ndarray:
    """Return the pressure at the end of the creep."""
    n = problem.n
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [1.0, 1.0], [n, n])
    model.E, model.nu = 2.0, 0.0
    surface = np.ascontiguousarray(-problem.gap)
    solver = tm.MaxwellViscoelastic(model, surface, tol, DURATION / steps, [RELAXING], [1.0])
    spectrum = problem.spectrum
    inverse = np.divide(1.0, spectrum, out=np.zeros_like(spectrum), where=spectrum > 0)
    for name, values in (("neumann", spectrum), ("dirichlet", inverse)):
        np.asarray(model.operators[f"westergaard_{name}"]["influence"])[...] = values
    solver.max_iter = 10000
    for _ in range(steps):
        solver.solve(MEAN_PRESSURE)
    return np.array(model.traction).squeeze()

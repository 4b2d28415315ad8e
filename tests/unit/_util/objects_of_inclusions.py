# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of bodies with inclusions, whose reprs are tested."""

import numpy as np

import samcontact as sc
from samcontact._util.frozen import FrozenDict

BALL = sc.Material.elastic(210e9, 0.3)


def fine_box():
    """Return a fine box around a void."""
    grid = sc.Grid(8, 8, 3e-5, 3e-5, dz=3e-5)
    gap = sc.surfaces.paraboloid(grid, 1e-2)
    stressed = BALL.with_residual_stress([0.0, 1.0], [1e8 / 3, 1e8 / 3], [0.0, 0.0])
    state = sc.Simulation(grid, sc.Material.rigid(), stressed, gap, on_border="warn").state
    void = sc.Inclusion.void((1e-5 / 3, 0.0, 1e-4), 1e-5 / 3)
    (box,) = sc.inclusions.fine_boxes(state, [void], cells_per_radius=4.0, tol=1e-2)
    return box


def inclusions_and_lives():
    """Return a body with inclusions, and objects of `samcontact.inclusions`."""
    body = sc.Heterogeneous(BALL, [sc.Inclusion.void((1e-5 / 3, 0.0, 2e-4), 1e-4 / 3)] * 9)
    sphere = sc.inclusions.eshelby_sphere(BALL, None, [1e8 / 3] * 6)
    peak = sc.inclusions.Peak(1e9 / 3, (1e-5 / 3, 0.0, 1e-4), 0, 4 / 3, 0.7)
    named = FrozenDict({"von_mises": peak, "dang_van": peak})
    return [
        body, body.inclusions[0], sphere,
        sc.inclusions.MisfitSphere(1e9, 0.3, 1e-3 / 3, 1e-6, 1e-5),
        peak, sc.inclusions.MatrixStatistics(named, named, FrozenDict({"50": 1e9 / 3}), 9),
        sc.inclusions.Interface(0, 1e8 / 3, (1 / 3,) * 3, 1e8 / 7, 1e9 / 3, (1 / 3,) * 3),
        sc.inclusions.ButterflyMap(np.zeros(36), np.zeros(36, dtype=int), np.ones(36), (0,) * 99),
        sc.inclusions.weibull_fit(np.linspace(1.0, 2.0, 50)),
        fine_box(),
        sc.inclusions.LargestInclusion(2e-5 / 3, 4e-6 / 3, 1.5e-4, 12),
    ]  # fmt: skip

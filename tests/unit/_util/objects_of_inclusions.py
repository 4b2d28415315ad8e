# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of bodies with inclusions, whose reprs are tested."""

import numpy as np

import samcontact as sc
from samcontact._util.frozen import FrozenDict

BALL = sc.Material.elastic(210e9, 0.3)


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
        sc.inclusions.LargestInclusion(2e-5 / 3, 4e-6 / 3, 1.5e-4, 12),
    ]  # fmt: skip

# SPDX-License-Identifier: GPL-3.0-or-later
"""The case that sweeps vary."""

from samcontact.cases import Case

BASE = {
    "title": "ball on flat",
    "grid": {"nx": 15, "ny": 13, "dx": 60e-6, "dy": 60e-6, "nz": 12, "dz": 60e-6},
    "body1": {"law": "elastic", "E": 210e9, "nu": 0.3},
    "body2": {"law": "perfect_plastic", "E": 210e9, "nu": 0.3, "yield_stress": 2e9},
    "surface": {"shape": "paraboloid", "Rx": 7.5e-3},
    "path": [{"load": 500.0, "increments": 2}],
}
CASE = Case.model_validate(BASE)

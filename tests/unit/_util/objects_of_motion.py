# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of viscoelastic bodies in motion, whose texts are tested."""

import samcontact as sc
from case_kinds import SLIDING
from samcontact.cases import SlidingCase


def viscoelastic_motion():
    """Return a case, and solutions of a polymer that slides and rolls over a rigid body."""
    grid = sc.Grid(9, 9, 5e-5, 5e-5)
    polymer = sc.Material.elastic(2e9, 0.4).with_relaxation(times=[1e-3], shares=[1 / 3])
    given = (grid, sc.Material.rigid(), polymer, sc.surfaces.paraboloid(grid, 7.5e-3))
    curve = sc.sliding.over_speed(*given, load=1.0, velocities=[0.1, 1 / 3])
    rolled = sc.rolling.steady(*given, load=1.0, friction=0.0, speed=0.1)
    case = SlidingCase.model_validate(SLIDING | {"description": "d" * 5000})
    return case, curve, curve.solutions[0], rolled

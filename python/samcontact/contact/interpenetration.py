# SPDX-License-Identifier: GPL-3.0-or-later
"""Detection of interpenetration in contacts with friction coupling.

The coupling iteration stops when the set of contact cells no longer changes. With very strong
friction this set may shrink to a single cell, and the bodies then overlap around this cell.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .. import hertz
from .._core import ConvergenceError
from ..bodies.layered import softest

if TYPE_CHECKING:
    from ..bodies.layered import Body
    from ..problem.friction import FrictionLaw
    from ..solutions.contact_solution import ContactSolution
    from ..solutions.state import State

MAX_RELATIVE_OVERLAP = 1e-3
"""Overlap above which an error is raised, divided by (maximum pressure) * (contact size)/E*."""


def may_overlap(bodies: tuple[Body, Body], friction: FrictionLaw) -> bool:
    """Whether the shear of a sliding contact displaces the surfaces normally by unequal amounts."""
    return friction.sliding_ratio > 0 and bodies[0]._core.stack != bodies[1]._core.stack


def require_apart(
    found: ContactSolution | State,
    bodies: tuple[Body, Body],
    friction: FrictionLaw,
    tol: float,
) -> None:
    """Raise ConvergenceError for a sliding contact whose bodies overlap."""
    if not may_overlap(bodies, friction):
        return
    size = math.sqrt(np.count_nonzero(found.in_contact) * found.grid.cell_area)
    scale = float(found.repulsion.max()) * size / hertz.effective_modulus(*map(softest, bodies))
    overlap = -float(found.gap.min())
    if overlap > max(MAX_RELATIVE_OVERLAP, 10 * tol) * scale > 0:
        error = ConvergenceError(
            f"contact did not converge at load {found.load:.6g} N: the bodies overlap by "
            f"{overlap:.3g} m, because with friction = {friction!r} the shear traction displaces "
            "the surfaces more than the pressure does: use less friction, or more similar "
            "materials"
        )
        error.iterations, error.residual = found.iterations, overlap / scale
        raise error

# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether bodies that friction couples stay out of each other.

The iteration of the coupling stops when the pressed cells change no more; where friction is so
strong that it ends in a single cell, that says nothing, and the bodies overlap beside it.
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
    from ..scene.friction import FrictionLaw
    from ..solutions.contact_solution import ContactSolution
    from ..solutions.state import State

SHARE = 1e-3
"""Overlap that is a fault, of largest pressure times size of the contact over E*."""


def may_overlap(bodies: tuple[Body, Body], friction: FrictionLaw) -> bool:
    """Whether the shear of a sliding contact moves the surfaces towards each other."""
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
    if overlap > max(SHARE, 10 * tol) * scale > 0:
        error = ConvergenceError(
            f"contact did not converge at load {found.load:.6g} N: the bodies overlap by "
            f"{overlap:.3g} m, since the shear of friction = {friction!r} moves their surfaces "
            "more than the pressure does: take a smaller friction, or bodies of similar elasticity"
        )
        error.iterations, error.residual = found.iterations, overlap / scale
        raise error

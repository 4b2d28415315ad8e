# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic solutions that the cells spoil: above the limit load, or alternating in depth."""

from __future__ import annotations

import math
import warnings
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from .._util.errors import ResolutionWarning
from ..bodies.material import Material
from .resolution import cells_across, spots

if TYPE_CHECKING:
    from ..solutions.state import State
    from .hertz_estimate import ContactSetup

LIMIT_PRESSURE = 3.0
"""Mean pressure of a fully plastic contact over the yield stress."""
_MOST_OVER = 1.05
_ALTERNATES = 0.15
"""Of the largest strain: zones of four layers stay below, patterns grow to 0.2 and more."""


def warn_of_limit(state: State, scene: ContactSetup, *, stacklevel: int) -> bool:
    """Warn of a mean pressure that a fully plastic body cannot bear; whether it did.

    No contact of one spot bears more than about three times the yield stress on a half-space that
    is the same everywhere: 2.97 in a long contact (Prandtl), about 3 in a round one. Too few cells
    let it bear more, since flow around the edge is no better known than by a cell.
    """
    largest, most = state.outline.largest, _MOST_OVER * LIMIT_PRESSURE
    if largest <= most * scene.weakest:  # the yield stress does not fall, and so is the mean
        return False
    if not state.load > 0 or state.grid.periodic or not math.isfinite(state.approach):
        return False
    strains = {n: state.max_equivalent_plastic_strain(n) for n in (1, 2)}
    found = [
        (float(body.yield_stress(strains[n])), n)
        for n, body in enumerate(scene.bodies, 1)
        if isinstance(body, Material) and body.is_plastic and strains[n] > 0
        and not (body.kinematic or body.yield_profile or body.residual_stress)
    ]  # fmt: skip
    stress, number = min(found, default=(math.inf, 0))
    if largest <= most * stress:
        return False
    mean = state.mean_pressure / stress
    if mean <= most or spots(state.repulsion) > 1:
        return False
    across = cells_across(state.repulsion)
    over = 100 * (mean / LIMIT_PRESSURE - 1)
    text = (
        f"the mean pressure is {mean:.3g} times the yield stress of body {number} at its largest "
        f"plastic strain, and a fully plastic contact bears about {LIMIT_PRESSURE:g}: with "
        f"{across:.0f} cells across the contact the pressure is about {over:.0f} % too high, and "
        "the contact area as much too small. Take smaller cells, or thinner layers (dz)"
    )
    warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def warn_of_alternation(state: State, *, stacklevel: int) -> bool:
    """Warn of plastic strain that alternates from layer to layer; whether it did.

    Only the residual stress "exact" allows it: see docs/theory/accuracy.md.
    """
    if state.setup.settings.residual_stress != "exact":
        return False
    for body in (1, 2):
        if state.max_equivalent_plastic_strain(body) == 0:
            continue
        share = alternation(state.plastic_strain(body))
        if share > _ALTERNATES:
            text = (
                f"the plastic strain of body {body} alternates from layer to layer, by "
                f"{100 * share:.0f} % of its maximum: a pattern of the cells that "
                'residual_stress="exact" does not resist, as it takes the stress at the centres of '
                'the cells. Take residual_stress="fast", or layers of half the cell size (dz)'
            )
            warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
            return True
    return False


def alternation(strain: FloatArray) -> float:
    """Amplitude of a strain that alternates from layer to layer over the largest strain.

    strain: shape (6, nx, ny, nz). It is that of fourth differences, which smooth fields over four
    or more layers hardly have; 0 of fewer.
    """
    largest = float(np.sqrt((strain**2).sum(0)).max())
    if strain.shape[-1] < 5 or np.count_nonzero(strain.any(axis=(0, 1, 2))) < 4:
        return 0.0
    fourth = np.diff(strain, 4, axis=-1) / 16
    return float(np.sqrt((fourth**2).sum(0)).max()) / largest

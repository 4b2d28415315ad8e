# SPDX-License-Identifier: GPL-3.0-or-later
"""Grid artefacts in plastic solutions: pressure above the plastic limit, alternating strain."""

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

LIMIT_PRESSURE_RATIO = 3.0
"""Mean pressure of a fully plastic contact divided by the yield stress."""
_MAX_LIMIT_EXCESS = 1.05
_MIN_ALTERNATION = 0.15
"""Minimum result of `alternation` for a warning. Smooth plastic zones with four layers have smaller
values; grid artefacts have values up to 0.2."""


def warn_of_limit(state: State, setup: ContactSetup, *, stacklevel: int) -> bool:
    """Warn if the mean pressure exceeds the fully plastic limit; return True after a warning.

    The mean pressure of a single contact spot on a homogeneous half-space is at most about three
    yield stresses: 2.97 in a line contact (Prandtl), about 3 in a round contact. With too few cells
    the computed pressure is higher, because the cells do not resolve plastic flow at the edge.
    """
    largest, max_ratio = state.outline.largest, _MAX_LIMIT_EXCESS * LIMIT_PRESSURE_RATIO
    # quick check: mean pressure <= maximum, yield stress >= initial
    if largest <= max_ratio * setup.weakest:
        return False
    if not state.load > 0 or state.grid.periodic or not math.isfinite(state.approach):
        return False
    strains = {n: state.max_equivalent_plastic_strain(n) for n in (1, 2)}
    found = [
        (float(body.yield_stress(strains[n])), n)
        for n, body in enumerate(setup.bodies, 1)
        if isinstance(body, Material) and body.is_plastic and strains[n] > 0
        and not (body.kinematic or body.yield_profile or body.residual_stress)
    ]  # fmt: skip
    stress, number = min(found, default=(math.inf, 0))
    if largest <= max_ratio * stress:
        return False
    mean = state.mean_pressure / stress
    if mean <= max_ratio or spots(state.repulsion) > 1:
        return False
    across = cells_across(state.repulsion)
    over = 100 * (mean / LIMIT_PRESSURE_RATIO - 1)
    text = (
        f"mean pressure exceeds the fully plastic limit: it is {mean:.3g} times the yield stress "
        f"of body {number} at maximum plastic strain (about {LIMIT_PRESSURE_RATIO:g} expected). "
        f"With {across:.0f} cells across the contact, the pressure is about {over:.0f} % too high "
        "and the contact area too small by as much: use smaller cells, or thinner layers (dz)"
    )
    warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def warn_of_alternation(state: State, *, stacklevel: int) -> bool:
    """Warn if plastic strain alternates between layers; return True after a warning.

    The alternation occurs only with residual_stress="exact": see docs/theory/accuracy.md.
    """
    if state.setup.settings.residual_stress != "exact":
        return False
    for body in (1, 2):
        if state.max_equivalent_plastic_strain(body) == 0:
            continue
        share = alternation(state.plastic_strain(body))
        if share > _MIN_ALTERNATION:
            text = (
                f"plastic strain of body {body} alternates between layers by {100 * share:.0f} % "
                "of the "
                'maximum: a grid artefact that residual_stress="exact" does not suppress, because '
                "this method evaluates stress at the centres of the cells. Use "
                'residual_stress="fast", or layers half as deep as the cells are long (dz = dx/2)'
            )
            warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
            return True
    return False


def alternation(strain: FloatArray) -> float:
    """Amplitude of the strain that alternates between layers, relative to the maximum strain [-].

    strain: shape (6, nx, ny, nz). The amplitude is computed from fourth differences, which are
    small for smooth fields over four or more layers. For fewer layers, the result is 0.
    """
    largest = float(np.sqrt((strain**2).sum(0)).max())
    if strain.shape[-1] < 5 or np.count_nonzero(strain.any(axis=(0, 1, 2))) < 4:
        return 0.0
    fourth = np.diff(strain, 4, axis=-1) / 16
    return float(np.sqrt((fourth**2).sum(0)).max()) / largest

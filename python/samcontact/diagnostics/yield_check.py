# SPDX-License-Identifier: GPL-3.0-or-later
"""Detection of yield in bodies treated as elastic."""

from __future__ import annotations

import math
import warnings
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from .._util.display import quantity
from .._util.errors import ElasticStrainWarning
from .._util.tensors import von_mises
from ..bodies.layered import Body, softest
from ..hertz.axis import line_axis, point_axis
from ..hertz.field import sliding_max_von_mises
from ..problem.friction import FrictionLaw
from ..solutions.contact_solution import ContactSolution, ShearedSolution
from .resolution import main_spot

if TYPE_CHECKING:
    from collections.abc import Sequence

_DEPTHS = np.concatenate(([0.0], np.geomspace(0.02, 10.0, 200)))
"""Depths, relative to the half-width of the contact, at which von Mises and yield stress are
compared."""
_MIN_LINE_CONTACT_RATIO = 4.0
"""Ratio of length to width above which a spot is treated as a line contact."""
_MAX_FRICTION = 10.0


def warn_of_yield(
    solution: ContactSolution,
    bodies: Sequence[Body],
    friction: FrictionLaw,
    *,
    stacklevel: int,
) -> bool:
    """Warn if a body treated as elastic would yield; return True after a warning.

    The stress is computed for a Hertz contact with the same maximum pressure, width and friction. A
    rough or non-smooth contact may therefore yield at a slightly lower or higher load.
    """
    plastic = [(number, body) for number, body in enumerate(bodies, 1) if body.is_plastic]
    if not plastic:
        return False
    largest = float(solution.pressure.max())
    found = []
    for number, body in plastic:
        # without friction, von Mises stress does not exceed the maximum pressure
        if (1 + 2 * _traction(solution, friction)) * largest <= body.min_yield_stress:
            continue
        share, stress = _over_yield(solution, body, friction)
        if share > 1:
            found.append((share, stress, number))
    if not found:
        return False
    share, stress, number = max(found)
    text = (
        f"body {number} is treated as elastic, but would yield: under the maximum pressure, "
        f"{quantity(largest, 'Pa')}, the von Mises stress reaches about {quantity(stress, 'Pa')}, "
        f"{share:.3g} times the yield stress there. Use Simulation to include plastic flow, or an "
        "elastic material to ignore it"
    )
    warnings.warn(text, ElasticStrainWarning, stacklevel=stacklevel + 1)
    return True


def _traction(solution: ContactSolution, friction: FrictionLaw) -> float:
    """Ratio of maximum shear to maximum pressure of a solution [-]."""
    if isinstance(solution, ShearedSolution):
        largest = float(solution.pressure.max())
        shear = float(np.hypot(*solution.shear).max())
        return shear / largest if largest > 0 else 0.0
    return friction.sliding_ratio


def _over_yield(
    solution: ContactSolution, body: Body, friction: FrictionLaw
) -> tuple[float, float]:
    """Return the maximum ratio of von Mises stress to local yield stress [-].

    The second value is the von Mises stress at the point of this maximum [Pa].
    """
    grid, largest = solution.grid, float(solution.pressure.max())
    spot = main_spot(solution.repulsion, grid.periodic)
    assert spot is not None  # pressure > 0, so there is a spot
    sides = [
        math.inf if axis in grid.periodic and s.stop - s.start == n else (s.stop - s.start) * d
        for axis, s, n, d in zip(
            "xy", spot, grid.surface_shape, (grid.dx, grid.dy), strict=True
        )
    ]  # fmt: skip
    half = 0.5 * min(sides)
    nu = softest(body).nu
    depths = np.zeros(1) if math.isinf(half) else _DEPTHS * half
    stress = (
        largest
        * _below(nu, is_line=max(sides) >= _MIN_LINE_CONTACT_RATIO * min(sides))[: depths.size]
    )
    strength = np.asarray(body.yield_stress_at(depths))
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.where(strength > 0, stress / strength, 0.0)
    at = int(shares.argmax())
    found = float(shares[at]), float(stress[at])
    traction = _traction(solution, friction)
    if traction > 0:
        ratio, depth = _sliding(nu, round(min(traction, _MAX_FRICTION), 3))
        yield_stress = float(body.yield_stress_at(np.array([depth * half]))[0])
        found = max(found, (ratio * largest / yield_stress, ratio * largest))
    return found


@lru_cache(maxsize=64)
def _sliding(nu: float, friction: float) -> tuple[float, float]:
    """Return the ratio of maximum von Mises stress to maximum pressure in sliding [-].

    The second value is the depth of this stress, divided by the half-width of the contact [-].
    """
    ratio, _, depth = sliding_max_von_mises(nu, friction)
    return ratio, depth


@lru_cache(maxsize=64)
def _below(nu: float, *, is_line: bool) -> FloatArray:
    """Von Mises stress / maximum pressure [-] on the axis of a Hertz contact, at `_DEPTHS`."""
    if not is_line:
        radial, axial = point_axis(_DEPTHS, nu)
        return np.asarray(np.abs(radial - axial))
    normal = np.stack(line_axis(_DEPTHS, nu))
    return von_mises(np.concatenate([normal, np.zeros_like(normal)]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of adhesive contacts: cell size, attraction at the grid edge, friction and yield."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING

from .._util.display import quantity
from .._util.errors import GridTooSmallWarning, ResolutionWarning
from ..problem.adhesion_laws import MAX_RESOLVED, ResolvedAdhesion, resolved_of

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..bodies.layered import Body
    from ..problem.contact_law import ContactLaw
    from ..problem.friction import FrictionLaw
    from ..solutions.contact_solution import ContactSolution
    from ..solutions.state import State

EDGE_ATTRACTION = 1e-3
"""Attraction at the edge of the grid, relative to the maximum attraction, above which a warning is
issued. The relative error of the tension is of this order."""


def warn_of_adhesion(
    law: ContactLaw,
    solution: ContactSolution | State,
    bodies: tuple[Body, Body],
    friction: FrictionLaw,
    *,
    stacklevel: int,
) -> bool:
    """Warn of adhesion that does not suit the grid; return True after a warning.

    The warnings are about attraction that the cells do not resolve, attraction at the edge of the
    grid, and friction or plastic flow that depends on the cell size.
    """
    found = resolved_of(law, solution.grid, *bodies)
    if found is None:
        return False
    unresolved = [*_of_resolution(found, bodies), *_of_friction(found, friction)]
    for text in unresolved:
        warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
    if cut := _of_edge(found, solution.adhesion_stress):
        warnings.warn(cut, GridTooSmallWarning, stacklevel=stacklevel + 1)
    return bool(unresolved or cut)


def attraction_at_edge(attraction: FloatArray, periodic: str) -> float:
    """Return the maximum attraction [Pa] at the edges of the grid that are not periodic.

    attraction: attraction in one or more increments [Pa], shape (..., nx, ny).
    """
    edges = {"x": attraction[..., [0, -1], :], "y": attraction[..., [0, -1]]}
    return max((float(edges[axis].max()) for axis in "xy" if axis not in periodic), default=0.0)


def _of_resolution(found: ResolvedAdhesion, bodies: tuple[Body, Body]) -> Iterator[str]:
    """Texts of the warnings about large cells, and about attraction above the yield stress."""
    if found.kappa > MAX_RESOLVED:
        yield (
            f"the grid does not resolve the adhesion: kappa = {found.kappa:.3g} (at most "
            f"{MAX_RESOLVED:g} expected), so that single cells may jump into contact. Use cells of "
            f"at most {found.finer}, or a longer range"
        )
    strengths = [float(body.yield_stress_at(0.0)) for body in bodies if body.is_plastic]
    weakest = min(strengths, default=math.inf)
    if found.is_refined and found.law.peak > weakest:
        yield (
            f"the attraction of up to {quantity(found.law.peak, 'Pa')} exceeds the yield stress "
            f"{quantity(weakest, 'Pa')}, and its range was chosen for the grid: plastic flow at "
            "the contact edge depends on the cell size. Give the range, and cells that resolve it"
        )


def _of_friction(found: ResolvedAdhesion, friction: FrictionLaw) -> Iterator[str]:
    """Text of the warning if friction depends on a range of attraction chosen for the grid."""
    by_pressure = not friction.prevents_slip and friction.bound(2.0) > friction.bound(1.0)
    if found.is_refined and by_pressure and not found.law.rubs_by_compression:
        yield (
            f"friction depends on the repulsion, which contains the attraction of up to "
            f"{quantity(found.law.peak, 'Pa')}, and the range of this attraction was chosen for "
            "the grid: the friction depends on the cell size. Give the range, or friction_on = "
            '"compression"'
        )


def _of_edge(found: ResolvedAdhesion, attraction: FloatArray) -> str:
    """Text of the warning if the attraction reaches the edge of the grid, else ""."""
    share = attraction_at_edge(attraction, found.grid.periodic) / found.law.peak
    if not share > EDGE_ATTRACTION:
        return ""
    return (
        f"the attraction at the edge of the grid is {share:.2g} of its maximum (at most "
        f"{EDGE_ATTRACTION:g} expected): the tension beyond the edge is missing. Enlarge the grid"
    )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Sharp edges of bodies, at which the pressure of an elastic contact is singular."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import hertz
from .._util.checks import FloatArray
from .._util.display import quantity
from .._util.errors import SingularPressureWarning
from .._util.lazy_scipy import scipy
from ..bodies.layered import Body, softest
from ..problem.contact_law import in_contact
from ..solutions.outline import (
    Sides,
    _rising,
    around,
    away_from_border,
    has_ridge,
    sides_between,
    sides_of,
    steps_next_to,
)

if TYPE_CHECKING:
    from ..solutions.contact_solution import ContactSolution
    from ..solutions.state import State
    from .hertz_estimate import ContactSetup

MIN_STEP_RATIO = 0.25
"""Minimum height of a step divided by p d/E*, with pressure p and cell size d. Without a step, the
elastic deflections of neighbouring cells differ by less than this minimum."""
MIN_EDGE_CELLS = 3
"""Minimum number of cells of an edge; single cells of a rough surface are not an edge."""
MIN_CELLS_OF_ROUNDING = 4
"""Minimum radius [cells] of a rounded edge at which the grid resolves the pressure."""
SINGULAR_QUANTITIES = (
    "max_pressure", "max_von_mises", "max_equivalent_plastic_strain", "max_residual_von_mises",
)  # fmt: skip
"""Names in results files, without the body, of quantities that are unbounded at a sharp edge. They
do not converge when the grid is refined (except stresses in perfect plasticity)."""


class SharpEdge(NamedTuple):
    """Contact cells along the sharp edges of a body."""

    cells: NDArray[np.bool_]
    """Cells at the edge, shape (nx, ny)."""
    peak: tuple[int, int]
    """Indices of the edge cell with the maximum pressure."""
    has_profile: bool = False
    """Whether most cells of the edge are at the end of a body with a crowned or logarithmic
    profile, i.e. the undeformed gap opens increasingly towards the end."""


def sharp_edge(
    pressure: ArrayLike, gap: ArrayLike, grid_sizes: tuple[float, float], E_star: float,
    periodic: str = "", initial_gap: ArrayLike | None = None,
) -> SharpEdge | None:  # fmt: skip
    """Find the sharp edges of a contact, towards which the pressure rises.

    The pressure of a smooth contact falls to zero at the contact edge, like the square root of the
    distance. At the end of a body, or at a step that elastic deflection does not close, the
    pressure rises instead. For two half-spaces it rises like r^-1/2 with the distance r from the
    edge (Johnson 1985, sections 2.8 and 5.1). Other exponents apply to wedges of dissimilar
    materials (Williams 1952, doi:10.1115/1.4010553, Dundurs & Lee 1972).

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa], >= 0; with attraction, the repulsive part.
    gap : array_like, shape (nx, ny)
        Separation under load [m]; NaN or infinite where there is no body.
    grid_sizes : pair of float
        Cell sizes along x and y [m].
    E_star : float
        Contact modulus [Pa].
    periodic : {"", "x", "y", "xy"}, optional
        Periodic directions, as for Grid.
    initial_gap : array_like, shape (nx, ny), optional
        Separation of the undeformed bodies [m]; used to find steps that the load has closed.

    Returns
    -------
    SharpEdge or None
        None unless three or more connected cells lie next to a step of the gap and have a higher
        pressure than the cells further inside.
    """
    p, heights = np.asarray(pressure, dtype=np.float64), np.asarray(gap, dtype=np.float64)
    whole = np.zeros(p.shape, dtype=np.bool_)
    window = around(in_contact(p), periodic)
    p, heights = p[window], heights[window]
    if not has_ridge(p, periodic):
        return None
    found, inside = whole[window], in_contact(p)
    groups = [(sides, heights) for sides in sides_of(inside, periodic)]
    before, count, profiled = None, 0, 0
    if initial_gap is not None:
        before = np.asarray(initial_gap, dtype=np.float64)[window]
        for sides in sides_between(inside, inside, periodic):
            groups.append((away_from_border(sides, p.shape, periodic), before))
    for sides, surface in groups:
        rising = _rising(sides, p)
        if not rising.any():
            continue
        sides = sides._replace(i=sides.i[rising], j=sides.j[rising])
        steps, height = steps_next_to(sides, surface, periodic)
        deflection = p[sides.i, sides.j] * grid_sizes[sides.axis] / E_star
        high = steps & (height > MIN_STEP_RATIO * deflection)
        found[sides.i[high], sides.j[high]] = True
        if before is not None and high.any():
            sides = sides._replace(i=sides.i[high], j=sides.j[high])
            count, profiled = count + len(sides.i), profiled + _at_end_of_profile(sides, before)
    if not found.any():
        return None
    labels, _ = scipy.ndimage.label(found, structure=np.ones((3, 3)))
    sizes = np.bincount(labels.ravel())
    sizes[0] = 0
    found &= (sizes >= min(MIN_EDGE_CELLS, *inside.shape))[labels]
    if not found.any():
        return None
    i, j = np.unravel_index(int(np.where(found, p, -1.0).argmax()), p.shape)
    first = [
        slice_.indices(n)[0] for slice_, n in zip(window, (len(whole), len(whole[0])), strict=True)
    ]
    return SharpEdge(whole, (int(i) + first[0], int(j) + first[1]), 2 * profiled > count)


def _at_end_of_profile(sides: Sides, gap: FloatArray) -> int:
    """Number of cell sides next to the end of a body towards which the gap opens increasingly."""
    found = np.zeros(len(sides.i), dtype=np.bool_)
    for direction in (1, -1):  # a side that the load has closed may face inwards
        further_in, inner, own, outer, next_out = (
            gap[sides.neighbours(gap.shape, direction * n)] for n in (-2, -1, 0, 1, 2)
        )
        ends = ~np.isfinite(outer) | ~np.isfinite(next_out)
        with np.errstate(invalid="ignore"):
            slope = inner - further_in
            found |= ends & (slope > 0.0) & (own - inner > (1.0 + 1e-6) * slope)
    return int(found.sum())


def may_have_edge(solution: ContactSolution | State, setup: ContactSetup) -> bool:
    """Whether `edge_of` may find an edge.

    There is an edge only if the pressure drops to zero at an open step, or if the undeformed gap
    has a step that the load has closed.
    """
    return solution.outline.rises or setup.may_have_steps


def edge_of(
    solution: ContactSolution | State, bodies: tuple[Body, Body], initial_gap: FloatArray | None
) -> SharpEdge | None:
    """Sharp edges of a solution, or None if there are none or if the tractions are prescribed."""
    pressure, grid = solution.repulsion, solution.grid
    if not np.isfinite(solution.approach):
        return None
    if initial_gap is None and not solution.outline.rises:
        return None
    E_star = hertz.effective_modulus(*map(softest, bodies))
    sizes = grid.dx, grid.dy
    return sharp_edge(pressure, solution.gap, sizes, E_star, grid.periodic, initial_gap)


def edge_of_state(state: State) -> SharpEdge | None:
    """Sharp edges of a state, or None. Steps of a relief that the load has closed are not found."""
    domain = state.domain
    known = all(relief is None for relief in domain.reliefs)
    return edge_of(state, state.setup.bodies, domain.initial_gap if known else None)


def is_singular(name: str) -> bool:
    """Whether the quantity with this name in results files is unbounded at a sharp edge."""
    return name.partition("_body")[0] in SINGULAR_QUANTITIES


def _remedy(solution: ContactSolution | State, edge: SharpEdge) -> str:
    if edge.has_profile:
        return (
            "The profile drops towards this edge, but too little for the load and these cells "
            f"({quantity(solution.grid.dx, 'm')} x {quantity(solution.grid.dy, 'm')}): use smaller "
            "cells across the edge, or a larger drop"
        )
    return (
        f"Round the edge with a radius of at least {MIN_CELLS_OF_ROUNDING} cells, or use a crowned "
        "or logarithmic profile"
    )


def warn_of_edge(
    solution: ContactSolution | State, edge: SharpEdge | None, *, stacklevel: int
) -> bool:
    """Warn of singular pressure at a sharp edge; return True if there is an edge."""
    if edge is None:
        return False
    i, j = edge.peak
    x, y = (quantity(float(s), "m") for s in (solution.grid.x[i], solution.grid.y[j]))
    text = (
        f"singular pressure: it rises to {quantity(float(solution.pressure[i, j]), 'Pa')} at a "
        f"sharp edge, next to a step of the gap or the end of a body (x = {x}, y = {y}). In "
        "elastic contact the maximum pressure and the stresses near the edge grow without bound "
        "as the grid is refined. The load, the approach, the pressure a few cells away from the "
        f"edge and forces over a fixed length remain meaningful. {_remedy(solution, edge)}"
    )
    warnings.warn(text, SingularPressureWarning, stacklevel=stacklevel + 1)
    return True

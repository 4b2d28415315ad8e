# SPDX-License-Identifier: GPL-3.0-or-later
"""Load cycles with wear controlled by plastic strain."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, boolean, integer
from ..bodies.layered import Body
from ..contact.enlargement import enlarged_evenly
from ..diagnostics import resolution
from ..problem.domain import SurfaceGeometry
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..simulation.kept_history import heat_of
from ..solutions.state import State, on_common_grid
from .checkpoint import require_own
from .checks import WearSetup, make_filter, make_setup
from .coating import worn_shares
from .plastic import largest, moved_up, rows_of, strains_of
from .problem import BodyStrain, WearProgress, creep_after, simulation_of
from .repeating import repeat
from .results import Cycle, Moments, WearResult
from .steps import Window, depth

LOAD_TOLERANCE = 1e-9
"""Relative difference below which loads count as equal, in view of rounding errors."""


def run(
    grid: Grid,
    body1: Body,
    body2: Body,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    cycle: Iterable[Mapping[str, Any]],
    threshold: float,
    cycles: int = 20,
    worn: Sequence[int] = (2,),
    smoothing_length: float | None = None,
    window: Window = None,
    order: int | None = None,
    strain_depth: str = "exact",
    keep_heat: bool = False,
    friction: float | FrictionLaw = 0.0,
    relief1: Relief | Callable[[Grid], Relief] | None = None,
    relief2: Relief | Callable[[Grid], Relief] | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = True,
    **settings: Any,
) -> WearResult:
    """Simulate repeated load cycles with wear controlled by plastic strain.

    After each cycle, surface material whose plastic strain exceeds a threshold is removed. The
    computation ends when a cycle removes no more material, or after the given number of cycles.

    Parameters
    ----------
    grid, body1, body2, gap, friction, relief1, relief2
        As for `Simulation`; the grid must have `dz`. If all surfaces are given as functions, the
        grid is enlarged when the contact or the smoothed wear reaches its edge. For layered bodies
        see Notes.
    cycle : iterable of dict
        Steps of `Simulation.step`, e.g. ``[{"load": 2000.0}, {"load": 0.0}]``. The last step must
        have zero load, and the advances of each body must add up to 0, or to whole periods on a
        grid that is periodic along x.
    threshold : float
        Accumulated equivalent plastic strain [-] above which material at the surface is removed. It
        must be above `YIELD_STRAIN` (0.002 %) and below 5 %.
    cycles : int, optional
        Maximum number of cycles, >= 1.
    worn : sequence of {1, 2}, optional
        Elastic-plastic bodies that wear. The other body may be viscoelastic; then each step must
        have a `duration`, and the creep of a cycle continues in the next cycle.
    smoothing_length : float, optional
        Standard deviation of the Gaussian filter that smooths the edge of the worn area [m], from
        one cell to 0.29 times the contact size. As this length does not depend on the grid, results
        converge when cells, layers and increments are refined. Exactly one of `smoothing_length`
        and `window` must be given.
    window : int or pair of int, optional
        Width of Boucly's filter in cells, see `smooth`; not larger than the contact. 1 for no
        smoothing. The results with this filter depend on the cell size.
    order : int, optional
        Order of Boucly's filter. Default: 2.
    strain_depth : {"exact", "smoothed"}, optional
        Depth by which the remaining plastic strain is moved up to the new surface. "exact": the
        depth to which the strain exceeded the threshold, before smoothing. The strain at the new
        surface then nowhere exceeds the threshold. "smoothed": the depth removed from the surface,
        after smoothing. Where the filter has reduced this depth, material with a strain above the
        threshold remains, and wears in a later cycle.
    keep_heat : bool, optional
        Whether a cycle continues from the temperatures of the previous cycle. Only with
        `heat.history`. The bodies cool in the last, unloaded step of a cycle, whose `duration` may
        be 0. The heat in the removed material is neglected, and the grid is not enlarged. Default:
        each cycle starts with unheated bodies.
    checkpoint : str or Path, optional
        File written after each cycle. A later call with equal arguments (more `cycles` are allowed)
        resumes from this file with bit-identical results; delete the file to start again. If the
        file is damaged, the run resumes from the checkpoint of the preceding cycle, a file with the
        additional suffix .before.
    progress : bool, optional
        Show a progress bar, or at most ten lines if there is no terminal.
    **settings
        Further arguments of `Simulation`, e.g. ``increment_tol`` or frictional heating.

    Returns
    -------
    WearResult

    Raises
    ------
    ValueError, TypeError
        An argument is outside its range (found before the first cycle); the plastic strain exceeds
        the threshold at the bottom of the grid, or material wears at the sides of the grid; a
        coating is worn through; a checkpoint was written by a run with different arguments. An
        exception after the first cycle holds the result of the completed cycles in its attribute
        `result`.

    Warns
    -----
    WornCoatingWarning
        A layered body has lost more than 20 % of its top layer somewhere; issued once.

    Notes
    -----
    The yield stress, initial stress and plastic strain of each material move up with the worn
    surface. The elastic constants of a layered body do not move; the resulting error is
    proportional to the worn share of the top layer, `Cycle.coating_worn_share`.
    """
    boolean("progress", progress)
    count = integer("cycles", cycles, 1)
    require_own(checkpoint)
    setup = make_setup(
        grid,
        (body1, body2),
        SurfaceGeometry(gap, relief1, relief2),
        cycle,
        threshold,
        worn,
        make_filter(grid, smoothing_length, window, order),
        strain_depth,
        keep_heat,
        friction,
        settings,
    )
    return repeat(WearResult, setup, _advance, count, checkpoint, progress)


def _advance(setup: WearSetup, standing: WearProgress) -> tuple[Moments, WearProgress]:
    moments = _solve(setup, standing)
    end = moments[-1]
    setup = setup.over(end.grid)
    heat = heat_of(end) if setup.keep_heat else {}
    standing = replace(
        standing.over(setup),
        strains=strains_of(setup, end),
        heat=heat,
        creep=creep_after(setup, end),
    )
    setup = _with_room_for_filter(setup, standing.strains)
    return moments, _wear(setup, standing.over(setup), moments[0])


def _with_room_for_filter(setup: WearSetup, strains: Mapping[int, BodyStrain]) -> WearSetup:
    """Return the setup on a grid that also contains the cells over which the filter spreads wear.

    Such a grid is wider along y. The setup is returned unchanged if its grid may not be enlarged.
    """
    side, grid = setup.filter.sides[1] // 2, setup.grid
    lacking = 0
    for body in setup.worn:
        if body in strains:
            worn = strains[body].equivalent[:, :, 0] > setup.threshold
            columns = np.flatnonzero(worn.any(axis=0))
            room = min(columns[0], grid.ny - 1 - columns[-1]) if columns.size else side
            lacking = max(lacking, int(side - room))
    if lacking == 0 or not setup.may_grow:
        return setup
    return setup.over(replace(grid, ny=enlarged_evenly(grid.ny, grid.ny + 2 * lacking)))


def _solve(setup: WearSetup, standing: WearProgress) -> Moments:
    """Solve one cycle; return the state at maximum load and the state at the end.

    Among several states at maximum load (e.g. in rolling), the state with the maximum pressure is
    returned.
    """
    simulation = simulation_of(setup, standing)
    peak = state = simulation.step(**setup.cycle[0])
    for step in setup.cycle[1:]:
        state = simulation.step(**step)
        if state.load >= (1.0 - LOAD_TOLERANCE) * peak.load:
            more = state.load > (1.0 + LOAD_TOLERANCE) * peak.load
            peak = state if more or state.pressure.max() > peak.pressure.max() else peak
    peak, state = on_common_grid([peak, state])
    return peak, state


def _wear(setup: WearSetup, standing: WearProgress, peak: State) -> WearProgress:
    """Remove material whose plastic strain exceeds the threshold; move the remaining strain up.

    standing: heights at the start of the cycle, and plastic strain at the end of the cycle.
    """
    strains = dict(standing.strains)
    bodies = [strains.get(body) for body in setup.worn]
    heights = {body: list(before) for body, before in standing.heights.items()}
    sums: list[tuple[float, float, float]] = []
    for body in setup.worn:
        exact = _worn_depth(setup, body, strains.get(body))
        volume = math.fsum(exact.flat) * setup.grid.cell_area
        worn = setup.smoothed(exact)
        heights[body].append(heights[body][-1] - worn)
        lost = math.fsum((heights[body][-2] - heights[body][-1]).flat) * setup.grid.cell_area
        sums.append((volume, lost, float(worn.max())))
        if body in strains and volume > 0:
            moved = exact if setup.strain_depth == "exact" else worn
            strains[body] = moved_up(setup, body, strains[body], moved)
    volumes, losts, depths = zip(*sums, strict=True)
    number = len(standing.cycles) + 1
    record = Cycle(
        number=number,
        volume=volumes,
        lost_volume=losts,
        depth=depths,
        surface_strain=tuple(largest(b, slice(0, 1)) for b in bodies),
        max_equivalent_plastic_strain=tuple(largest(b, slice(None)) for b in bodies),
        max_pressure=float(peak.pressure.max()),
        max_von_mises=max(float(peak.von_mises(body=body).max()) for body in setup.worn),
        contact_area=peak.contact_area,
        cells_across_contact=resolution.cells_across(peak.repulsion),
        layers_across_plastic_zone=tuple(
            0.0 if b is None else resolution.layers_across(b.equivalent) for b in bodies
        ),
        coating_worn_share=worn_shares(setup.bodies, heights, number),
    )
    cycles = [*standing.cycles, record]
    return replace(standing, heights=heights, strains=strains, cycles=cycles)


def _worn_depth(setup: WearSetup, body: int, kept: BodyStrain | None) -> FloatArray:
    """Return the wear depth before smoothing [m], with the same rows as `WearProgress.heights`."""
    grid = setup.grid
    assert grid.dz is not None
    found = np.zeros((setup.rows(body)[1], grid.ny))
    if kept is None:
        return found
    found[rows_of(setup, body, kept)] = depth(kept.equivalent, grid.dz, setup.threshold)
    side = setup.filter.sides[1] // 2
    if side and (found[:, :side].any() or found[:, -side:].any()):
        raise ValueError(
            f"the worn area of body {body} must be more than {side} cells (half the filter width) "
            f"from the sides of the grid, y = +-{0.5 * grid.ny * grid.dy!r} m: enlarge ny dy, or "
            "smooth less"
        )
    return found

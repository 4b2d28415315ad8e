# SPDX-License-Identifier: GPL-3.0-or-later
"""Load cycles with wear controlled by plastic strain."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, boolean, integer
from ..bodies.material import Material
from ..diagnostics import resolution
from ..problem.domain import SurfaceGeometry
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .checkpoint import BodyStrain, WearProgress, require_own
from .checks import WearSetup, make_filter, make_setup
from .repeating import reliefs_of, repeat
from .results import Cycle, Moments, WearResult
from .steps import Window, below_worn_surface, depth, deviator_below_worn_surface

LOAD_TOLERANCE = 1e-9
"""Relative difference below which loads count as equal, in view of rounding errors."""


def run(
    grid: Grid,
    body1: Material,
    body2: Material,
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
    friction: float = 0.0,
    relief1: Relief | Callable[[Grid], Relief] | None = None,
    relief2: Relief | Callable[[Grid], Relief] | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = True,
    **settings: Any,
) -> WearResult:
    """Simulate repeated load cycles with wear controlled by plastic strain.

    After each cycle overstrained material is removed, until a cycle removes no more material.

    Parameters
    ----------
    grid, body1, body2, gap, friction, relief1, relief2
        As for `Simulation`; the grid must have dz. Surfaces given as functions are evaluated on
        this grid, which is not enlarged.
    cycle : iterable of dict
        Steps of `Simulation.step`, e.g. ``[{"load": 2000.0}, {"load": 0.0}]``. The last step must
        have zero load, and the advances of each body must add up to 0, or to whole periods on a
        grid that is periodic along x.
    threshold : float
        Accumulated equivalent plastic strain [-] above which material at the surface is removed. It
        must be above `YIELD_STRAIN` and below 5 %.
    cycles : int, optional
        Maximum number of cycles, >= 1.
    worn : sequence of {1, 2}, optional
        Elastic-plastic bodies that wear.
    smoothing_length : float, optional
        Standard deviation of the Gaussian that smooths the edge of the wear [m], from one cell to
        0.29 times the contact size. This length is a property of the material: results converge as
        cells, layers and increments are refined. Exactly one of `smoothing_length` and `window`
        must be given.
    window : int or pair of int, optional
        Window of Boucly's filter in cells, see `smooth`; not larger than the contact. The results
        with this filter depend on the cell size. 1 for no smoothing.
    order : int, optional
        Order of Boucly's filter. Default: 2.
    strain_depth : {"exact", "smoothed"}, optional
        Depth by which the remaining plastic strain is moved up to the new surface. "exact": the
        depth to which the strain exceeded the threshold, so that the strain nowhere exceeds the
        threshold at the new surface. "smoothed": the depth removed from the surface. Where the
        filter has reduced this depth, overstrained material remains, and wears in a later cycle.
    checkpoint : str or Path, optional
        File written after each cycle. A later call with equal arguments (more `cycles` are allowed)
        resumes from it with bit-identical results; delete it to start again. If the file is
        damaged, the checkpoint of the preceding cycle is used, with the suffix .before.
    progress : bool, optional
        Show a progress bar, or at most ten lines if there is no terminal.
    **settings
        Further arguments of `Simulation`, e.g. ``increment_tol`` or frictional heating; each cycle
        starts with unheated bodies.

    Returns
    -------
    WearResult

    Raises
    ------
    ValueError, TypeError
        An argument is outside its range (before the first cycle); the plastic strain exceeds the
        threshold at the bottom of the grid, or material wears at the sides of the grid; a
        checkpoint was written by a run with different arguments. The exception of a later cycle
        holds the result of the completed cycles in its attribute `result`.
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
        friction,
        settings,
    )
    return repeat(WearResult, setup, _advance, count, checkpoint, progress)


def _advance(setup: WearSetup, standing: WearProgress) -> tuple[Moments, WearProgress]:
    moments = _solve(setup, standing)
    return moments, _wear(setup, standing, moments)


def _solve(setup: WearSetup, standing: WearProgress) -> Moments:
    """Solve one cycle; return the state at maximum load and the state at the end.

    Among several states at maximum load (e.g. in rolling), the state with the maximum pressure is
    returned.
    """
    body1, body2 = setup.bodies
    relief1, relief2 = reliefs_of(setup, standing)
    simulation = Simulation(
        setup.grid,
        body1,
        body2,
        setup.gap,
        setup.friction,
        relief1=relief1,
        relief2=relief2,
        **setup.settings,
    )
    simulation.monitor.checks_steps = False
    simulation.monitor.checks_increments = False  # not for each of many cycles
    for body, kept in standing.strains.items():
        simulation.set_plastic_strain(
            body, kept.strain, kept.equivalent, kept.backstress, first=kept.first
        )
    peak = state = simulation.step(**setup.cycle[0])
    for step in setup.cycle[1:]:
        state = simulation.step(**step)
        if state.load >= (1.0 - LOAD_TOLERANCE) * peak.load:
            more = state.load > (1.0 + LOAD_TOLERANCE) * peak.load
            peak = state if more or state.pressure.max() > peak.pressure.max() else peak
    return peak, state


def _strain_of(state: State, body: int) -> BodyStrain | None:
    """Return the plastic strain of a body along its whole track; None if there is none."""
    if state._core.strain_beyond(body - 1) is not None:
        raise ValueError(
            f"plastic strain of body {body} must lie within the grid, but extends below "
            "its deepest layer or beyond its sides: omit nz, or enlarge nz, nx or ny"
        )
    track = state.track(body, margin=0)
    fields = [track.equivalent_plastic_strain(), track.plastic_strain(), track.backstress()]
    if state.grid.nz == 0:  # no plastic strain below the grid
        fields = [np.pad(field, [*[(0, 0)] * (field.ndim - 1), (0, 1)]) for field in fields]
    equivalent, strain, back = fields
    rows = np.flatnonzero(strain.any(axis=(0, 2, 3)) | equivalent.any(axis=(1, 2)))
    if not rows.size:
        return None
    part = slice(int(rows[0]), int(rows[-1]) + 1)
    return BodyStrain(
        track.first + part.start,
        strain[:, part],
        equivalent[part],
        back[:, :, part] if len(back) else None,
    )


def _wear(setup: WearSetup, standing: WearProgress, moments: Moments) -> WearProgress:
    """Remove overstrained material after a cycle, and move the remaining plastic strain up."""
    peak, end = moments
    found = {body: _strain_of(end, body) for body in (1, 2) if setup.bodies[body - 1].is_plastic}
    strains = {body: kept for body, kept in found.items() if kept is not None}
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
            strains[body] = _moved_up(setup, body, strains[body], moved)
    volumes, losts, depths = zip(*sums, strict=True)
    bodies = [found[body] for body in setup.worn]
    record = Cycle(
        number=len(standing.cycles) + 1,
        volume=volumes,
        lost_volume=losts,
        depth=depths,
        surface_strain=tuple(_largest(b, slice(0, 1)) for b in bodies),
        max_equivalent_plastic_strain=tuple(_largest(b, slice(None)) for b in bodies),
        max_pressure=float(peak.pressure.max()),
        max_von_mises=max(float(peak.von_mises(body=body).max()) for body in setup.worn),
        contact_area=peak.contact_area,
        cells_across_contact=resolution.cells_across(peak.repulsion),
        layers_across_plastic_zone=tuple(
            0.0 if b is None else resolution.layers_across(b.equivalent) for b in bodies
        ),
    )
    return WearProgress(heights, strains, [*standing.cycles, record])


def _largest(kept: BodyStrain | None, layers: slice) -> float:
    return 0.0 if kept is None else float(kept.equivalent[:, :, layers].max())


def _worn_depth(setup: WearSetup, body: int, kept: BodyStrain | None) -> FloatArray:
    """Return the wear depth before smoothing [m], on the rows of `heights`."""
    grid = setup.grid
    assert grid.dz is not None
    first, rows = setup.rows(body)
    found = np.zeros((rows, grid.ny))
    if kept is None:
        return found
    place = slice(kept.first - first, kept.first - first + len(kept.equivalent))
    found[place] = depth(kept.equivalent, grid.dz, setup.threshold)
    side = setup.filter.sides[1] // 2
    if side and (found[:, :side].any() or found[:, -side:].any()):
        raise ValueError(
            f"wear of body {body} must be more than {side} cells from the sides of the grid, y = "
            f"+-{0.5 * grid.ny * grid.dy!r} m (half the filter width): enlarge ny dy, or smooth "
            "less"
        )
    return found


def _moved_up(setup: WearSetup, body: int, kept: BodyStrain, worn: FloatArray) -> BodyStrain:
    """Return the remaining plastic strain at depths below the worn surface."""
    assert setup.grid.dz is not None
    first, _ = setup.rows(body)
    removed = worn[kept.first - first : kept.first - first + len(kept.equivalent)]
    dz = setup.grid.dz
    back = (
        None
        if kept.backstress is None
        else deviator_below_worn_surface(kept.backstress, removed, dz)
    )
    return BodyStrain(
        kept.first,
        deviator_below_worn_surface(kept.strain, removed, dz),
        np.maximum(below_worn_surface(kept.equivalent, removed, dz), 0.0),
        back,
    )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear by slip, proportional to the frictional work or to pressure times slip distance."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import hertz
from .._util.checks import FloatArray, boolean, integer
from ..bodies.material import Material
from ..diagnostics import resolution
from ..problem.domain import SurfaceGeometry
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .by_slip_checks import FrettingSetup, closing, make_setup
from .checkpoint import WearProgress, require_own
from .repeating import reliefs_of, repeat
from .results import FrettingCycle, FrettingResult

_MAX_PRESSURE_CHANGE = 1.0
"""Maximum relative decrease of the shortest pressure wave on the grid that wear may cause between
two contact solutions. If the decrease were 2 or more, the shortest waves would grow from one
solution to the next.
"""
_MAX_PARTS = 10_000
_MAX_SHEAR_MISMATCH = 1e-2
"""Maximum change of the shear over one repeat, relative to the maximum of mu p.

The limit is not smaller because, at the edge of the stick zone, slip directions rotate slightly
over many repeats. This rotation does not noticeably affect the frictional work.
"""
_MAX_REPEATS = 20


def fretting(
    grid: Grid,
    body1: Material,
    body2: Material,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    cycle: Iterable[Mapping[str, Any]],
    friction: FrictionLaw,
    energy: float | Sequence[float] | None = None,
    archard: float | Sequence[float] | None = None,
    cycles: int = 20,
    repeats: int = 1,
    relief1: Relief | Callable[[Grid], Relief] | None = None,
    relief2: Relief | Callable[[Grid], Relief] | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = True,
    **settings: Any,
) -> FrettingResult:
    """Simulate fretting wear of elastic bodies, by dissipated energy or by Archard's law.

    Parameters
    ----------
    grid, body1, body2, gap, relief1, relief2
        As for `Simulation`; the bodies cannot yield, and do not move except for slip. Surfaces
        given as functions are evaluated on this grid, which is not enlarged.
    cycle : iterable of dict
        Steps of `Simulation.step`, e.g. ``paths.fretting_loop(load=W, force=(Q, 0))``, with load or
        approach, shift or tangential_load, twist or torque. The last step must repeat an earlier
        step. The steps up to this earlier step are a lead-in, which causes no wear. The first
        repetitions, until the shear is periodic, cause no wear either.
    friction : Coulomb
        Friction law with a finite coefficient > 0.
    energy : float or pair of floats
        Wear depth divided by frictional work per unit area [m/(J/m^2) = 1/Pa], >= 0: a number for
        body 2, or a pair for bodies 1 and 2. Fouvry et al. (2003),
        doi:10.1016/S0043-1648(03)00117-0. Cannot be combined with `archard`.
    archard : float or pair of floats
        Wear depth divided by pressure times slip distance [1/Pa], i.e. the wear coefficient divided
        by the hardness. Archard (1953), doi:10.1063/1.1721448. Equivalent to energy = archard/mu.
    cycles : int, optional
        Maximum number of cycles, >= 1.
    repeats : int, optional
        Number of repeats of the loop per cycle, >= 1. The contact is solved again before the wear
        since the last solution changes the shortest pressure wave on the grid by more than 100 %.
    checkpoint, progress
        As for `run`.
    **settings
        Further arguments of `Simulation`.

    Returns
    -------
    FrettingResult

    Raises
    ------
    ValueError, TypeError
        An argument is outside its range (before the first cycle); a cycle requires more than 10 000
        contact solutions, or does not become periodic; a contact reaches the edge of the grid; a
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
        friction,
        energy,
        archard,
        integer("repeats", repeats, 1),
        settings,
    )
    return repeat(FrettingResult, setup, _advance, count, checkpoint, progress)


@dataclass(frozen=True)
class _Repeat:
    """Solution of one repeat of a loop: states, and quantities in each cell, shape (nx, ny)."""

    states: tuple[State, ...]
    work: FloatArray
    """Frictional work [J/m^2]."""
    slip_distance: FloatArray
    """Slip distance [m]."""
    worn: FloatArray
    """Wear depth divided by the wear coefficient [m Pa]."""
    per_pressure: FloatArray
    """Wear depth divided by the wear coefficient and by the pressure [m]."""


def _solve_repeat(setup: FrettingSetup, heights: Mapping[int, list[FloatArray]]) -> _Repeat:
    """Solve one repeat on the current surfaces, after a lead-in from unloaded bodies."""
    relief1, relief2 = reliefs_of(setup, WearProgress(dict(heights)))
    simulation = Simulation(
        setup.grid,
        *setup.bodies,
        setup.gap,
        setup.friction,
        relief1=relief1,
        relief2=relief2,
        **setup.settings,
    )
    simulation.monitor.checks_steps = False
    simulation.monitor.checks_increments = False  # not for each of many repeats
    states = _closed(simulation, setup)
    slips = np.array([np.hypot(*state.slip) for state in states])
    work = np.sum([(state.shear * state.slip).sum(axis=0) for state in states], axis=0)
    slip_distance = slips.sum(axis=0)
    if setup.law == "archard":
        swept = np.sum([state.pressure for state in states] * slips, axis=0)
        return _Repeat(states, work, slip_distance, swept, slip_distance)
    pressures = np.concatenate([state.pressure[state.in_contact] for state in states])
    ratio = setup.friction.ratio(float(pressures.mean())) if pressures.size else 0.0
    return _Repeat(states, work, slip_distance, work, ratio * slip_distance)


def _closed(simulation: Simulation, setup: FrettingSetup) -> tuple[State, ...]:
    """Repeat the loop until the shear is periodic, and return the states of the last repeat."""
    lead = closing(setup.cycle)
    for step in setup.cycle[:lead]:
        simulation.step(**step)
    for _ in range(_MAX_REPEATS):
        start = simulation.state
        states = tuple(simulation.step(**step) for step in setup.cycle[lead:])
        bound = float(setup.friction.bound(max(s.pressure.max() for s in states)))
        if np.abs(states[-1].shear - start.shear).max() <= _MAX_SHEAR_MISMATCH * bound:
            return states
    raise ValueError(
        "cycle must give a periodic response, but the shear at its end still changes "
        f"after {_MAX_REPEATS} repetitions: use a closed cycle"
    )


def _advance(
    setup: FrettingSetup, standing: WearProgress
) -> tuple[tuple[State, ...], WearProgress]:
    """Advance by one cycle, divided into as many contact solutions as stability requires."""
    heights = {body: [*before, before[-1]] for body, before in standing.heights.items()}
    left, parts, work, removed = float(setup.repeats), 0, 0.0, np.zeros(setup.grid.surface_shape)
    first = _solve_repeat(setup, heights)
    if not standing.cycles and not any(state.in_contact.any() for state in first.states):
        raise ValueError(
            "cycle must bring the bodies into contact when it is repeated, "
            "got no contact: increase the load"
        )
    while left > 0:
        now = _solve_repeat(setup, heights) if parts else first
        max_repeats = _max_repeats(setup, now)
        if left > (_MAX_PARTS - parts) * max_repeats:
            raise ValueError(
                f"{setup.law} and repeats are too large: a cycle may be divided into at "
                f"most {_MAX_PARTS} solutions, and each can stand for only {max_repeats:.3g} "
                f"repeats; got {max(setup.coefficients)!r} 1/Pa and {setup.repeats} "
                "repeats: use fewer repeats, or check the unit of the coefficient"
            )
        count = min(left, max_repeats)
        removed += count * now.worn
        work += count * _integral(setup.grid, now.work)
        for body in setup.worn:
            lost = setup.coefficients[body - 1] * removed
            heights[body][-1] = standing.heights[body][-1] - lost
        left, parts = left - count, parts + 1
    volumes = tuple(setup.coefficients[b - 1] * _integral(setup.grid, removed) for b in setup.worn)
    cycle = _record(first, heights, volumes, len(standing.cycles) + 1, parts, work)
    return first.states, WearProgress(heights, {}, [*standing.cycles, cycle])


def _max_repeats(setup: FrettingSetup, now: _Repeat) -> float:
    """Return the number of repeats after which the contact must be solved again.

    Wear of depth c p changes a pressure wave of wavenumber k by the fraction -c E* k/2.
    """
    grid = setup.grid
    steps = [1 / step for n, step in ((grid.nx, grid.dx), (grid.ny, grid.dy)) if n > 1]
    shortest = math.pi * math.hypot(*steps)
    stiffness = 0.5 * hertz.effective_modulus(*setup.bodies) * shortest
    change = sum(setup.coefficients) * float(now.per_pressure.max()) * stiffness
    return _MAX_PRESSURE_CHANGE / change if change > 0 else math.inf


def _record(
    first: _Repeat,
    heights: Mapping[int, list[FloatArray]],
    volumes: tuple[float, ...],
    number: int,
    parts: int,
    work: float,
) -> FrettingCycle:
    losses = [rows[-2] - rows[-1] for rows in heights.values()]
    loaded = max(first.states, key=lambda state: state.load)
    grid, sticking = loaded.grid, loaded.in_contact & (first.slip_distance == 0)
    return FrettingCycle(
        number=number,
        parts=parts,
        friction_work=work,
        volume=volumes,
        lost_volume=tuple(_integral(grid, loss) for loss in losses),
        depth=tuple(float(loss.max()) for loss in losses),
        slip_distance=float(first.slip_distance.max()),
        max_pressure=max(float(state.pressure.max()) for state in first.states),
        contact_area=loaded.contact_area,
        stick_area=int(np.count_nonzero(sticking)) * grid.cell_area,
        cells_across_contact=resolution.cells_across(loaded.repulsion),
    )


def _integral(grid: Grid, field: FloatArray) -> float:
    return math.fsum(field.flat) * grid.cell_area

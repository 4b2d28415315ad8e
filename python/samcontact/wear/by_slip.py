# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear by slip, proportional to the frictional work or to pressure times slip distance."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import hertz
from .._util.checks import FloatArray, boolean, integer
from .._util.errors import IncrementWarning
from ..bodies.layered import Body, homogeneous_for_wave, materials_of
from ..diagnostics import resolution
from ..problem.domain import SurfaceGeometry
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..simulation.simulation import Simulation
from ..solutions.state import State, on_common_grid
from .by_slip_checks import FrettingSetup, closing, make_setup
from .checkpoint import require_own
from .coating import worn_shares
from .plastic import flow_between, largest, moved_up, strains_of
from .problem import WearProgress, centred, creep_after, simulation_of
from .repeating import repeat
from .results import FrettingCycle, FrettingResult

_MAX_PRESSURE_CHANGE = 1.0
"""Maximum relative decrease of a pressure wave by wear between two contact solutions.

The limit applies to the amplitude of the shortest wave on the grid. If the decrease were 2 or more,
this amplitude would grow from one solution to the next.
"""
_MAX_PARTS = 10_000
_MAX_SHEAR_MISMATCH = 1e-2
"""Maximum change of the shear traction over a periodic loop, divided by the maximum of mu p.

The limit is not smaller because, at the edge of the stick zone, slip directions rotate slightly
over many repeats. This rotation does not noticeably affect the frictional work.
"""
_MAX_REPEATS = 20
_MAX_CREEPING_REPEATS = 200
_MIN_MISMATCH_OF_TOL = 10.0
"""Smallest limit for the relative change of pressure and shear over a periodic loop of
viscoelastic bodies, divided by the solver tolerance `tol`."""
_SMALL_FLOW = 0.01
"""Maximum equivalent plastic strain that the last computed repeat may add without a warning,
divided by the yield strain."""


def fretting(
    grid: Grid,
    body1: Body,
    body2: Body,
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
    """Simulate fretting wear by dissipated energy or by Archard's law.

    Parameters
    ----------
    grid, body1, body2, gap, relief1, relief2
        As for `Simulation`. The bodies slip, but must not roll. If all surfaces are given as
        functions, the grid is enlarged when the contact reaches its edge. Plastic strain, and the
        layers of a layered body, are treated as in `run`. Inclusions of elastic bodies come closer
        to the worn surface: each moves up by the mean worn depth above it.
    cycle : iterable of dict
        Steps of `Simulation.step`, e.g. ``paths.fretting_loop(load=W, force=(Q, 0))``. Each step
        has either `load` or `approach`. It may have one of `shift` and `tangential_load`, and one
        of `twist` and `torque`. With ``heat=Heat(partition=...)``, each step also has a `duration`.
        The last step must return to the load and the tangential forces or motions of an earlier
        step. The steps up to this earlier step are a lead-in, and the steps after it form the loop.
        The lead-in causes no wear, and neither do the first loops, until the shear traction is
        periodic. For viscoelastic bodies see Notes.
    friction : Coulomb
        Friction law with a finite coefficient > 0.
    energy : float or pair of floats
        Wear depth divided by frictional work per unit area [m/(J/m^2) = 1/Pa], >= 0. With a single
        number only body 2 wears; a pair gives the values of bodies 1 and 2. Fouvry et al. (2003),
        doi:10.1016/S0043-1648(03)00117-0. Cannot be combined with `archard`.
    archard : float or pair of floats
        Wear depth divided by pressure times slip distance [1/Pa], i.e. the wear coefficient divided
        by the hardness; a number or a pair, as for `energy`. Archard (1953), doi:10.1063/1.1721448.
        Equivalent to energy = archard/mu.
    cycles : int, optional
        Maximum number of cycles, >= 1.
    repeats : int, optional
        Number of repeats of the loop per cycle, >= 1. The contact is not solved for every repeat.
        It is solved again before wear changes the amplitude of the shortest pressure wave on the
        grid by more than 100 %. Each solution starts with unloaded, unheated bodies that have the
        plastic strain of the previous solution. It computes a few repeats of the loop, usually one
        or two, until the response is periodic. The plastic flow in all repeats that are not
        computed is neglected.
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
        An argument is outside its range (found before the first cycle); a cycle requires more than
        10 000 contact solutions, or does not become periodic; a contact reaches the edge of the
        grid; wear reaches a void, or removes the whole top layer; a checkpoint was written by a run
        with different arguments. An exception after the first cycle holds the result of the
        completed cycles in its attribute `result`.

    Warns
    -----
    WornCoatingWarning
        As in `run`.
    IncrementWarning
        The last computed loop still adds a plastic strain of more than 1 % of the yield strain: the
        bodies do not shake down, but the plastic flow in the repeats that are not computed is
        neglected.

    Notes
    -----
    If a body is viscoelastic, each step must have a `duration`. With ``repeats=1`` the loops follow
    each other in time: the lead-in is computed once, and then each cycle is one loop, which
    continues the creep of the previous loop. Wear then starts in the first loop. With more repeats,
    the loop is computed again until pressure and shear are periodic, i.e. until further creep would
    change them by less than 1 %. The remaining loops are assumed to equal the last computed loop.
    Holding the load for a long time in the lead-in reduces the number of computed loops.
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
    result = repeat(FrettingResult, setup, _advance, count, checkpoint, progress)
    _warn_of_flow(setup, result.cycles[-1])
    return result


def _warn_of_flow(setup: FrettingSetup, last: FrettingCycle) -> None:
    """Warn if plastic strain would grow in repeats that are not computed."""
    weak = [m for body in setup.bodies for m in materials_of(body) if m.is_plastic]
    small = min((_SMALL_FLOW * m.min_yield_stress / m.E for m in weak), default=math.inf)
    if setup.repeats > 1 and last.plastic_flow > small:
        warnings.warn(
            f"the bodies have not shaken down: the last computed loop of cycle {last.number} adds "
            f"an equivalent plastic strain of {last.plastic_flow:.3g}, and the plastic strain that "
            "the other loops would add is neglected; use fewer repeats and more cycles, or check "
            "with samcontact.shakedown.run whether the unworn bodies shake down",
            IncrementWarning,
            stacklevel=3,
        )


@dataclass(frozen=True)
class _Repeat:
    """Solution of one repeat of the loop: its states, and surface fields of shape (nx, ny)."""

    states: tuple[State, ...]
    work: FloatArray
    """Frictional work [J/m^2]."""
    slip_distance: FloatArray
    """Slip distance [m]."""
    worn: FloatArray
    """Wear depth divided by the wear coefficient [m Pa]."""
    per_pressure: FloatArray
    """Wear depth divided by the wear coefficient and by the pressure [m]."""
    flow: float
    """Maximum equivalent plastic strain added in the repeat [-]."""


def _solve_repeat(setup: FrettingSetup, standing: WearProgress) -> _Repeat:
    """Solve the lead-in (if needed) and a periodic repeat of the loop, on the current surfaces."""
    states, flow = _closed(simulation_of(setup, standing), setup, bool(standing.creep))
    slips = np.array([np.hypot(*state.slip) for state in states])
    work = np.sum([(state.shear * state.slip).sum(axis=0) for state in states], axis=0)
    slip_distance = slips.sum(axis=0)
    if setup.law == "archard":
        swept = np.sum([state.pressure for state in states] * slips, axis=0)
        return _Repeat(states, work, slip_distance, swept, slip_distance, flow)
    pressures = np.concatenate([state.pressure[state.in_contact] for state in states])
    ratio = setup.friction.ratio(float(pressures.mean())) if pressures.size else 0.0
    return _Repeat(states, work, slip_distance, work, ratio * slip_distance, flow)


def _closed(
    simulation: Simulation, setup: FrettingSetup, continues: bool
) -> tuple[tuple[State, ...], float]:
    """Repeat the loop until the tractions are periodic; return states and flow of the last repeat.

    The flow is the maximum equivalent plastic strain that the last repeat adds [-].

    continues: whether the simulation starts at the end of a loop, so that no lead-in is needed.
    """
    lead = closing(setup.cycle)
    for step in setup.cycle[: 0 if continues else lead]:
        simulation.step(**step)
    count = _MAX_CREEPING_REPEATS if setup.relaxes else _MAX_REPEATS
    for _ in range(count):
        start = simulation.state
        states = [simulation.step(**step) for step in setup.cycle[lead:]]
        start, *states = on_common_grid([start, *states])
        if setup.follows_time or _is_periodic(setup, start, states):
            return tuple(states), flow_between(setup, start, states[-1])
    remedy = (
        "hold the load for a long time in the lead-in"
        if setup.relaxes
        else "use paths.fretting_loop"
    )
    raise ValueError(
        "cycle must contain a loop with a periodic response, but the tractions at the end of the "
        f"loop still change after {count} repetitions: {remedy}"
    )


def _is_periodic(setup: FrettingSetup, start: State, states: Sequence[State]) -> bool:
    """Whether a loop ends with the tractions with which it started."""
    highest = max(float(state.pressure.max()) for state in states)
    bound, limit = float(setup.friction.bound(highest)), _MAX_SHEAR_MISMATCH
    if setup.relaxes:  # all further loops together change the tractions by less than the limit
        limit *= setup.crept_share
        limit = max(limit, _MIN_MISMATCH_OF_TOL * states[-1].setup.settings.tol)
        if np.abs(states[-1].pressure - start.pressure).max() > limit * highest:
            return False
    return bool(np.abs(states[-1].shear - start.shear).max() <= limit * bound)


def _advance(
    setup: FrettingSetup, standing: WearProgress
) -> tuple[tuple[State, ...], WearProgress]:
    """Advance by one cycle, divided into as many contact solutions as stability requires."""
    heights = {body: [*before, before[-1]] for body, before in standing.heights.items()}
    now = replace(standing, heights=heights)
    setup = setup.over(now.grid)
    left, parts, work, removed = float(setup.repeats), 0, 0.0, np.zeros(setup.grid.surface_shape)
    first = _solve_repeat(setup, now)
    if not standing.cycles and not any(state.in_contact.any() for state in first.states):
        raise ValueError(
            "cycle must bring the bodies into contact in the steps that are repeated, "
            "got no contact in them: increase the load"
        )
    while left > 0:
        solved = _solve_repeat(setup, now) if parts else first
        setup = setup.over(solved.states[-1].grid)
        now, removed = now.over(setup), centred(removed, setup.grid.surface_shape)
        max_repeats = _max_repeats(setup, solved)
        if setup.follows_time and max_repeats < 1:
            raise ValueError(
                "for viscoelastic bodies with repeats = 1, "
                f"{setup.law} must be at most {max_repeats * max(setup.coefficients):.3g} 1/Pa, so "
                "that the wear in one loop hardly changes the pressure, got "
                f"{max(setup.coefficients)!r} 1/Pa: check the unit, or use larger cells"
            )
        if left > (_MAX_PARTS - parts) * max_repeats:
            raise ValueError(
                f"{setup.law} and repeats are too large: a cycle may be divided into at "
                f"most {_MAX_PARTS} contact solutions, and each can represent at most "
                f"{max_repeats:.3g} repeats; got {setup.law} = {max(setup.coefficients)!r} 1/Pa "
                f"and repeats = {setup.repeats}: use fewer repeats, or check the unit of "
                f"{setup.law}"
            )
        count = min(left, max_repeats)
        removed = removed + count * solved.worn
        work += count * _integral(setup.grid, solved.work)
        now = _worn(setup, now, solved, count, removed)
        left, parts = left - count, parts + 1
    volumes = tuple(setup.coefficients[b - 1] * _integral(setup.grid, removed) for b in setup.worn)
    cycle = _record(setup, (first, solved), now, volumes, parts, work)
    return first.states, replace(now, cycles=[*standing.cycles, cycle])


def _worn(
    setup: FrettingSetup, now: WearProgress, solved: _Repeat, count: float, removed: FloatArray
) -> WearProgress:
    """Return the progress after `count` repeats, with plastic strain moved up to the worn surface.

    removed: wear depth of the cycle so far, divided by the wear coefficient [m Pa].
    """
    heights = dict(now.heights)
    strains = strains_of(setup, solved.states[-1])
    creep = creep_after(setup, solved.states[-1])
    for body in setup.worn:
        coefficient, before = setup.coefficients[body - 1], heights[body]
        heights[body] = [*before[:-1], before[-2] - coefficient * removed]
        if body in strains:
            part = coefficient * count * solved.worn
            strains[body] = moved_up(setup, body, strains[body], part)
    return replace(now, heights=heights, strains=strains, creep=creep)


def _max_repeats(setup: FrettingSetup, solved: _Repeat) -> float:
    """Return the number of repeats of the loop after which the contact must be solved again.

    Wear to the depth c p, where p is the pressure, changes the amplitude of a pressure wave of
    wavenumber k by the fraction -c E* k/2, where E* is the effective modulus.
    """
    grid = setup.grid
    steps = [1 / step for n, step in ((grid.nx, grid.dx), (grid.ny, grid.dy)) if n > 1]
    shortest = math.pi * math.hypot(*steps)
    bodies = (homogeneous_for_wave(body, shortest) for body in setup.bodies)
    stiffness = 0.5 * hertz.effective_modulus(*bodies) * shortest
    change = sum(setup.coefficients) * float(solved.per_pressure.max()) * stiffness
    return _MAX_PRESSURE_CHANGE / change if change > 0 else math.inf


def _record(
    setup: FrettingSetup,
    solved: tuple[_Repeat, _Repeat],
    after: WearProgress,
    volumes: tuple[float, ...],
    parts: int,
    work: float,
) -> FrettingCycle:
    first, last = solved
    losses = [rows[-2] - rows[-1] for rows in after.heights.values()]
    loaded = max(first.states, key=lambda state: state.load)
    grid, sticking = loaded.grid, loaded.in_contact & (first.slip_distance == 0)
    number = len(after.cycles) + 1
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
        max_equivalent_plastic_strain=tuple(
            largest(after.strains.get(body), slice(None)) for body in setup.worn
        ),
        plastic_flow=last.flow,
        coating_worn_share=worn_shares(setup.bodies, after.heights, number),
    )


def _integral(grid: Grid, field: FloatArray) -> float:
    return math.fsum(field.flat) * grid.cell_area

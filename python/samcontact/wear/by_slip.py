# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear by slip: depths in proportion to the work of friction, or to pressure times slip."""

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
from ..scene.domain import SurfaceGeometry
from ..scene.friction import FrictionLaw
from ..scene.grid import Grid
from ..scene.moving_topography import Relief
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .by_slip_checks import FrettingScene, closing, make_scene
from .checkpoint import Standing, require_own
from .repeating import reliefs_of, repeat
from .results import FrettingCycle, FrettingResult

_STABLE = 1.0
"""Of a part: pressure that its wear takes off the shortest wave, over that of the wave.

From 2 on the shortest waves would grow from part to part.
"""
_MOST_PARTS = 10_000
_CLOSED = 1e-2
"""Of the largest mu p: by how much the shear at both ends of a repeat may differ.

Directions of slip at the border of stick go on turning a little for many repeats, which the work
does not show.
"""
_MOST_TIMES = 20


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
    """Let elastic bodies slip to and fro, and wear them where they slip.

    Parameters
    ----------
    grid, body1, body2, gap, relief1, relief2
        As for `Simulation`; bodies that do not yield, and that stay where they are but for slip.
        Surfaces that are functions are those on this grid, which does
        not grow.
    cycle : iterable of dict
        Steps of `Simulation.step`, e.g. ``paths.fretting_loop(load=W, force=(Q, 0))``: load or
        approach, shift or tangential_load, twist or torque. It ends where it has been: steps up to
        the first of the same load and drive along the surface lead up to what is repeated, and do
        not wear; nor do the first times through, before the shear comes back as it was.
    friction : Coulomb
    energy : float or pair of floats
        Depth that body 2 loses for the work of friction on an area [m/(J/m^2) = 1/Pa], or that of
        body 1 and of body 2, >= 0. Fouvry et al. (2003), doi:10.1016/S0043-1648(03)00117-0. Or
    archard : float or pair of floats
        depth for the pressure times the way of slip [1/Pa]: wear coefficient over hardness. Archard
        (1953), doi:10.1063/1.1721448. The same as an energy of archard/mu.
    cycles : int, optional
        Largest number of cycles, >= 1.
    repeats : int, optional
        How often each is gone through, >= 1. The surface is solved for again whenever the wear
        since it was last would change the pressure of the shortest waves of the grid by as much as
        it is.
    checkpoint, progress
        As for `run`.
    **settings
        Other arguments of `Simulation`.

    Returns
    -------
    FrettingResult

    Raises
    ------
    ValueError, TypeError
        An argument outside its range, before the first cycle; a cycle that takes more than 10 000
        parts, or does not come to repeat itself; a contact that grows to the border of the grid; a
        checkpoint of other arguments. An error of a later cycle has the result of those before in
        its attribute `result`.
    """
    boolean("progress", progress)
    count = integer("cycles", cycles, 1)
    require_own(checkpoint)
    scene = make_scene(
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
    return repeat(FrettingResult, scene, _advance, count, checkpoint, progress)


@dataclass(frozen=True)
class _Repeat:
    """One repeat of a cycle: its states, and what happens to each cell, shape (nx, ny)."""

    states: tuple[State, ...]
    work: FloatArray
    """Of friction [J/m^2]."""
    way: FloatArray
    """Of slip [m]."""
    worn: FloatArray
    """Depth that a coefficient of 1 gives [m Pa]."""
    per_pressure: FloatArray
    """The same over the pressure [m]."""


def _gone_through(scene: FrettingScene, heights: Mapping[int, list[FloatArray]]) -> _Repeat:
    """One repeat over the present surfaces, which bodies without a past lead up to."""
    relief1, relief2 = reliefs_of(scene, Standing(dict(heights)))
    simulation = Simulation(
        scene.grid,
        *scene.bodies,
        scene.gap,
        scene.friction,
        relief1=relief1,
        relief2=relief2,
        **scene.settings,
    )
    simulation.monitor.checks_steps = False
    simulation.monitor.checks_increments = False  # of the many that follow
    states = _closed(simulation, scene)
    ways = np.array([np.hypot(*state.slip) for state in states])
    work = np.sum([(state.shear * state.slip).sum(axis=0) for state in states], axis=0)
    way = ways.sum(axis=0)
    if scene.law == "archard":
        swept = np.sum([state.pressure for state in states] * ways, axis=0)
        return _Repeat(states, work, way, swept, way)
    pressures = np.concatenate([state.pressure[state.in_contact] for state in states])
    ratio = scene.friction.ratio(float(pressures.mean())) if pressures.size else 0.0
    return _Repeat(states, work, way, work, ratio * way)


def _closed(simulation: Simulation, scene: FrettingScene) -> tuple[State, ...]:
    """States of a repeat that ends with the shear with which it began."""
    lead = closing(scene.cycle)
    for step in scene.cycle[:lead]:
        simulation.step(**step)
    for _ in range(_MOST_TIMES):
        start = simulation.state
        states = tuple(simulation.step(**step) for step in scene.cycle[lead:])
        bound = float(scene.friction.bound(max(s.pressure.max() for s in states)))
        if np.abs(states[-1].shear - start.shear).max() <= _CLOSED * bound:
            return states
    raise ValueError(
        f"cycle must come to end as it begins, but its shear still changes after {_MOST_TIMES} "
        "times: take one that closes"
    )


def _advance(scene: FrettingScene, standing: Standing) -> tuple[tuple[State, ...], Standing]:
    """All repeats of one cycle, in as many parts as they are stable in."""
    heights = {body: [*before, before[-1]] for body, before in standing.heights.items()}
    left, parts, work, removed = float(scene.repeats), 0, 0.0, np.zeros(scene.grid.surface_shape)
    first = _gone_through(scene, heights)
    if not standing.cycles and not any(state.in_contact.any() for state in first.states):
        raise ValueError("cycle must bring the bodies into contact where it repeats, got none")
    while left > 0:
        now = _gone_through(scene, heights) if parts else first
        most = _most_repeats(scene, now)
        if left > (_MOST_PARTS - parts) * most:
            raise ValueError(
                f"{scene.law} and repeats must wear a cycle in at most {_MOST_PARTS} parts of "
                f"{most:.3g} repeats, got {max(scene.coefficients)!r} 1/Pa and {scene.repeats}: "
                "take fewer repeats; is the coefficient in SI units?"
            )
        count = min(left, most)
        removed += count * now.worn
        work += count * _integral(scene.grid, now.work)
        for body in scene.worn:
            lost = scene.coefficients[body - 1] * removed
            heights[body][-1] = standing.heights[body][-1] - lost
        left, parts = left - count, parts + 1
    volumes = tuple(scene.coefficients[b - 1] * _integral(scene.grid, removed) for b in scene.worn)
    cycle = _record(first, heights, volumes, len(standing.cycles) + 1, parts, work)
    return first.states, Standing(heights, {}, [*standing.cycles, cycle])


def _most_repeats(scene: FrettingScene, now: _Repeat) -> float:
    """After which the surface has to be solved for again.

    Wear of depth c p changes the pressure of a wave k by -c E* k/2 of it.
    """
    grid = scene.grid
    steps = [1 / step for n, step in ((grid.nx, grid.dx), (grid.ny, grid.dy)) if n > 1]
    shortest = math.pi * math.hypot(*steps)
    stiffness = 0.5 * hertz.effective_modulus(*scene.bodies) * shortest
    change = sum(scene.coefficients) * float(now.per_pressure.max()) * stiffness
    return _STABLE / change if change > 0 else math.inf


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
    grid, sticking = loaded.grid, loaded.in_contact & (first.way == 0)
    return FrettingCycle(
        number=number,
        parts=parts,
        friction_work=work,
        volume=volumes,
        lost=tuple(_integral(grid, loss) for loss in losses),
        depth=tuple(float(loss.max()) for loss in losses),
        slip_path=float(first.way.max()),
        max_pressure=max(float(state.pressure.max()) for state in first.states),
        contact_area=loaded.contact_area,
        sticking_area=int(np.count_nonzero(sticking)) * grid.cell_area,
        contact_cells=resolution.cells_across(loaded.repulsion),
    )


def _integral(grid: Grid, field: FloatArray) -> float:
    return math.fsum(field.flat) * grid.cell_area

# SPDX-License-Identifier: GPL-3.0-or-later
"""Repetition of a load cycle until the long-term plastic response is clear."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from .._util.checks import FloatArray, boolean, in_cells, integer, number, require_type, step_list
from .._util.errors import attach
from .._util.frozen import read_only
from .._util.progress import progress_bar
from .._util.travels import along_x
from ..bodies.layered import materials_of
from ..problem.grid import within_period
from ..simulation.journal import Journal, journal_of
from ..simulation.simulation import Simulation
from ..simulation.steps import STEP_ARGUMENTS
from ..solutions.state import State
from .jumps import MAX_JUMP_CYCLES, Changes, Jump, jump, norm
from .plastic import at_common_depth, change, tracks
from .results import (
    ELASTIC,
    PLASTIC,
    RATCHETING,
    SHAKEDOWN,
    UNDECIDED,
    Cycle,
    NotSteadyWarning,
    ShakedownResult,
)

_MAX_FLOW_CHANGE = 0.02
"""Maximum difference between the plastic flows of two successive cycles in plastic shakedown,
relative to the later flow."""
_MAX_RATE_CHANGE = 0.1
"""Maximum relative change of the ratcheting rate over `_RATE_CYCLES` cycles."""
_RATE_CYCLES = 20


def run(
    simulation: Simulation,
    cycle: Iterable[Mapping[str, Any]],
    *,
    cycles: int = 100,
    tol: float = 1e-3,
    accelerate: bool = True,
    progress: bool = True,
    checkpoint: str | os.PathLike[str] | None = None,
) -> ShakedownResult:
    """Repeat a cycle until plastic flow ceases, cancels over each cycle, or adds strain steadily.

    Parameters
    ----------
    simulation : Simulation
        Simulation with an elastic-plastic body. All plastic strain must lie inside the grid. After
        the call, the simulation is in the state at the end of the last cycle.
    cycle : iterable of dict
        Steps of `Simulation.step` that return both bodies to their initial position, or, on a grid
        that is periodic along x, move them by whole periods. Examples: `passes`,
        ``[*paths.rolling(...), {"load": 0.0, "advance": (s, s)}]``, or a fretting loop.
    cycles : int, optional
        Maximum number of solved cycles, >= 2.
    tol : float, optional
        Tolerance, in [1e-6, 0.1]: strains below tol times the yield strain are neglected.
    accelerate : bool, optional
        Whether to extrapolate the plastic strain over several cycles if its changes in successive
        cycles form a geometric series. An extrapolation is undone unless the next cycle confirms
        it.
    progress : bool, optional
        Show a progress bar.
    checkpoint : path, optional
        Folder for a checkpoint of each cycle. A call with equal arguments and a new simulation
        resumes from this folder, with bit-identical results. Delete the folder when it is no longer
        needed.

    Returns
    -------
    ShakedownResult
        Result whose attribute `response` is one of the following. "elastic shakedown": a cycle adds
        an equivalent plastic strain of less than tol times the yield strain ("elastic" if no cycle
        adds any). "plastic shakedown": a cycle changes the plastic strain by less than tol times
        the yield strain, and the plastic flow in this cycle equals the flow in the preceding cycle
        to 2 %. "ratcheting": the strain added per cycle has changed by less than 10 % over the last
        20 cycles; a rate that decreases more slowly than this cannot be distinguished from a steady
        rate. "undecided": none of these.

    Raises
    ------
    ValueError
        No body can yield; the cycle has no steps or does not return both bodies to their initial
        position; plastic strain lies outside the volume fields; a value is outside its range. If a
        later cycle fails, or is interrupted by Ctrl-C, the exception holds the result of the
        completed cycles in its attribute `result`.
    TypeError
        simulation is not a Simulation.

    Warns
    -----
    NotSteadyWarning
        The response is not clear after the maximum number of cycles: the result is "undecided".

    Notes
    -----
    If the contact always passes in one direction, the ends of the track constrain the plastic flow:
    use a surface that is periodic along x, with `passes`, or a track much longer than the contact.
    """
    require_type("simulation", simulation, Simulation)
    boolean("accelerate", accelerate)
    boolean("progress", progress)
    steps = step_list("cycle", cycle, STEP_ARGUMENTS)
    count, small = integer("cycles", cycles, 2), number("tol", tol)
    if not 1e-6 <= small <= 0.1:
        raise ValueError(f"tol must be in [1e-6, 0.1], got {tol!r}")
    _require_closed(simulation, steps)
    repeated = _RepeatedCycles(simulation, steps, small, bool(accelerate))
    what = {"path": steps, "shakedown": {"tol": small, "accelerate": bool(accelerate)}}
    with (
        journal_of(checkpoint, simulation.engine, **what) as journal,
        progress_bar(count, "cycle", shown=progress) as bar,
    ):
        try:
            while repeated.response == UNDECIDED and repeated.solved < count:
                repeated.next(journal)
                bar.update()
                bar.set_postfix(strain_per_cycle=f"{repeated.cycles[-1].net:.3g}")
        except BaseException as error:  # Ctrl-C too
            if repeated.cycles:
                attach(error, result=repeated.result())
            raise
        finally:
            repeated.take_back()
    if repeated.response == UNDECIDED:
        last = repeated.cycles[-1]
        warnings.warn(
            f"response is not steady after {last.number} cycles: the last cycle has a plastic flow "
            f"of {last.flow:.3g} and a net change of the plastic strain of {last.net:.3g}; "
            f"increase cycles, which is {count}",
            NotSteadyWarning,
            stacklevel=2,
        )
    return repeated.result()


def _require_closed(simulation: Simulation, steps: Sequence[Mapping[str, Any]]) -> None:
    if not steps:
        raise ValueError("cycle must contain at least one step, got none")
    if not any(body.is_plastic for body in (simulation.body1, simulation.body2)):
        raise ValueError("simulation must have an elastic-plastic body, got two elastic bodies")
    dx = simulation.grid.dx
    motions = [along_x(step.get("advance", (0.0, 0.0)), "in a cycle") for step in steps]
    travels = [
        within_period(simulation.grid, math.fsum(
            in_cells("advance", motion[n], dx) * dx for motion in motions
        )) for n in (0, 1)
    ]  # fmt: skip
    if max(map(abs, travels)) > 1e-6 * dx:
        back = tuple(-travel for travel in travels)
        raise ValueError(
            "cycle must move both bodies back to their initial positions, but at its end they have "
            f"travelled by {travels!r} m: "
            f"append {{'load': 0.0, 'advance': {back!r}}}"
        )


class _RepeatedCycles:
    """Cycles solved so far, and the extrapolations between them."""

    def __init__(
        self, simulation: Simulation, steps: list[dict[str, Any]], tol: float, accelerate: bool
    ) -> None:
        self.simulation, self.steps, self.accelerate = simulation, steps, accelerate
        bodies = {1: simulation.body1, 2: simulation.body2}
        self.bodies = [number for number, body in bodies.items() if body.is_plastic]
        yields = [m for n in self.bodies for m in materials_of(bodies[n]) if m.is_plastic]
        self.yield_strain = min(material.min_yield_stress / material.E for material in yields)
        self.small = tol * self.yield_strain
        self.cycles: list[Cycle] = []
        self.response = UNDECIDED
        self.rejected, self.solved = 0, 0
        self._errors: list[float] = []
        self.state = simulation.state
        self.strain: dict[int, FloatArray] = {}
        self._max_jump = MAX_JUMP_CYCLES
        self._number = 0
        self._jump: Jump | None = None
        self._kept: tuple[Jump, Changes] | None = None
        self._changes: list[Changes] = []

    def next(self, journal: Journal | None) -> None:
        """Solve one cycle, classify the response, and extrapolate if that is safe."""
        start = tracks(self.simulation, self.simulation.state, self.bodies)
        state = self._solved(journal)
        end = tracks(self.simulation, state, self.bodies)
        found = {body: change(start[body], end[body]) for body in self.bodies}
        if self._jump is not None:
            if not self._confirmed(found):
                return
        elif self._kept is not None:
            made, first = self._kept
            self._errors[-1], self._kept = made.error(first, found), None
        self._changes, self.state = [*self._changes[-2:], found], state
        self.strain = {body: each.of("plastic_strain") for body, each in found.items()}
        self._number += 1
        if self._number == 1:  # the first cycle of virgin bodies differs from all others
            self._changes = []
        flow, net = (max(getattr(c, name) for c in found.values()) for name in ("flow", "net"))
        self.cycles.append(Cycle(self._number, flow, net))
        self.response = self._classified()
        if self.response == UNDECIDED and self.accelerate and len(self._changes) == 3:
            self._jump = jump(self.simulation, self._changes, self._max_jump)
            if self._jump is not None:
                self._number += self._jump.cycles

    def _solved(self, journal: Journal | None) -> State:
        kept = journal.next() if journal else None
        if kept is not None:
            self.solved += 1
            return kept
        if not self.cycles:
            self.simulation.run(self.steps, progress=False)
            self.simulation.monitor.checks_increments = False  # not for each of many cycles
        else:
            with self.simulation.monitor.deferred_resolution_checks():
                for step in self.steps:
                    self.simulation.step(**step)
        self.solved += 1
        if journal:
            journal.add()
        return self.simulation.state

    def _confirmed(self, found: Changes) -> bool:
        """Undo the last extrapolation unless the next cycle confirms it; return whether it does."""
        made, self._jump = self._jump, None
        assert made is not None
        if made.confirmed(found):
            self._errors.append(made.error(found))
            self._changes, self._kept = [], (made, found)
            self._max_jump = min(MAX_JUMP_CYCLES, 2 * made.cycles)
            return True
        self.rejected += 1
        self._max_jump, self._changes, self._jump = max(made.cycles // 2, 2), [], made
        self.take_back()
        return False

    def take_back(self) -> None:
        """Undo the last extrapolation if no cycle has confirmed it."""
        if self._jump is not None:
            self.simulation.engine.stand_at(self._jump.state)
            self._number -= self._jump.cycles
            self._jump = None

    def _classified(self) -> str:
        last = self.cycles[-1]
        if last.flow <= self.small:
            return SHAKEDOWN if any(c.flow > 0 for c in self.cycles) else ELASTIC
        if len(self._changes) < 2:
            return UNDECIDED
        flow = self.cycles[-2].flow
        if last.net <= self.small:
            steady = abs(last.flow - flow) <= _MAX_FLOW_CHANGE * last.flow
            return PLASTIC if steady else UNDECIDED
        earlier = [c.net for c in self.cycles if c.number <= last.number - _RATE_CYCLES]
        steady = bool(earlier) and abs(earlier[-1] - last.net) <= _MAX_RATE_CHANGE * last.net
        settled = len(self._changes) == 3  # the first cycle after a jump corrects the jump
        return RATCHETING if steady and settled and self._adds_equal_strain() else UNDECIDED

    def _adds_equal_strain(self) -> bool:
        """Whether the last two cycles added approximately equal plastic strains."""
        older, last = (
            [c.of("plastic_strain") for c in each.values()] for each in self._changes[-2:]
        )
        pairs = [at_common_depth(pair) for pair in zip(last, older, strict=True)]
        same = all(a.shape == b.shape for a, b in pairs)
        return same and norm([a - b for a, b in pairs]) <= _MAX_RATE_CHANGE * norm(last)

    def result(self) -> ShakedownResult:
        last = self.cycles[-1]
        return ShakedownResult(
            response=self.response,
            rate=last.net,
            flow=last.flow,
            cycles=tuple(self.cycles),
            solved=self.solved,
            error=sum(self._errors),
            rejected=self.rejected,
            yield_strain=self.yield_strain,
            state=self.state,
            _strain={body: read_only(strain) for body, strain in self.strain.items()},
        )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Solver of the increments of a simulation, on a grid that may be enlarged."""

from __future__ import annotations

import copyreg
import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from .. import _core
from .._core import ConvergenceError, GridTooSmallError
from .._util import memory
from .._util.errors import ConvergenceWarning, GridTooSmallWarning
from ..bodies.free_faces import contact_strip
from ..bodies.layered import matrix_of
from ..contact.border_advice import ENLARGEMENT_HINT, add_border_remedies, advised
from ..contact.enlargement import counts_for, enlarged_evenly, explain_failed_enlargement
from ..contact.interpenetration import may_overlap, require_apart
from ..diagnostics.hertz_estimate import ContactSetup, explain_digits, explain_size
from ..diagnostics.monitor import Monitor
from ..heat import Heat
from ..problem.domain import Domain, require_consistent_overlap
from ..problem.grid import Grid
from ..problem.heating import core_law, heating
from ..problem.mixed_cells import mixed_cells
from ..problem.moving_topography import relief_rows
from ..problem.settings import memory_of_contact
from ..problem.setup import SimulationSetup
from ..restart.file import ForeignCheckpointError
from ..solutions.state import State
from .exclusive_access import ExclusiveAccess
from .history import History
from .snapshot import Snapshot
from .steps import Step, StepArguments

_logger = logging.getLogger("samcontact")

_FIXED = "the grid is fixed"
Preparation = Callable[[Any], None]
"""Function that changes a new simulation before its path, e.g. by dents in a body."""


class Engine:
    """Solver of the increments of a simulation, on a domain (grid, surfaces) that may be enlarged.

    The domain is enlarged if the contact reaches its edge, unless on_border="warn" or the surfaces
    are unknown beyond this edge.
    """

    def __init__(self, setup: SimulationSetup, grid: Grid, heat: Heat) -> None:
        self.setup = setup
        self.heat = heat
        """Heat of the next increment."""
        self.history = History(heat)
        self.preparation: Preparation | None = None
        """Preparation that this simulation began with; repetitions begin with it too."""
        self.access = ExclusiveAccess()
        # Kept here, because the core does not own them.
        self._laws = [core_law(body, grid.dz) for body in setup.bodies]
        self._may_overlap = may_overlap(setup.bodies, setup.friction)
        self._open(self._checked_domain(grid))
        self.first = self.domain
        """The domain before any enlargement."""

    def _open(self, domain: Domain, prepare: Callable[[Any], object] | None = None) -> None:
        """Switch to another domain with a new compiled core; `prepare` sets the state of the core.

        By default, the core is in the initial state. After an error or interrupt, the old domain
        and core remain in use.
        """
        core = self._core_over(domain)
        if prepare is not None:
            prepare(core)
        setup, grid = self.setup, domain.grid
        relieved = any(relief is not None for relief in domain.reliefs)
        relieved = relieved or setup.adhesion.attracts
        # The Hertz estimate omits inclusions.
        bodies = matrix_of(setup.body1), matrix_of(setup.body2)
        self.estimate = ContactSetup(grid, domain.initial_gap, bodies, relieved)
        self._arguments = StepArguments(grid, setup.bodies, setup.friction, setup.settings.spring)
        self.domain, self.core = domain, core

    def _core_over(self, domain: Domain) -> Any:
        grid, setup = domain.grid, self.setup
        reliefs = [relief_rows(f"relief{n}", r, grid) for n, r in enumerate(domain.reliefs, 1)]
        return _core.Simulation(
            grid=grid._core,
            body1=setup.body1._core,
            body2=setup.body2._core,
            gap=domain.initial_gap,
            friction=setup.friction.to_core(),
            settings=setup.settings.to_core(grid.dx),
            march=self.heat.march,
            softening=self._laws,
            reliefs=reliefs,
            contact_law=setup.resolved_adhesion(grid).to_core(),
            inclusions=[mixed_cells(n, body, grid) for n, body in enumerate(setup.bodies, 1)],
        )

    def _checked_domain(self, grid: Grid, current: Domain | None = None) -> Domain:
        """Return the domain of a grid, whose surfaces must agree with `current` in common cells."""
        setup = self.setup
        scanned = grid.has_volume and any(body.is_plastic for body in setup.bodies)
        cell = memory_of_contact(setup.friction, setup.bodies, self.heat)
        cell += (
            memory.PARTIAL_SLIP_SIMULATION_BYTES
            if setup.friction.sticks
            else memory.SIMULATION_BYTES
        )
        cell += memory.YIELD_SCAN_BYTES if scanned else 0.0
        memory.require_for_grid("a simulation", grid, memory.surface(grid, cell))
        domain = setup.surfaces.over(grid, contact_strip(setup.bodies))
        if current is not None:
            larger, smaller = sorted((domain, current), key=lambda d: d.cells, reverse=True)
            require_consistent_overlap(larger, smaller)
        return domain

    @property
    def state(self) -> State:
        """Current state."""
        return self.state_of(self.core.state, self.heat)

    def state_of(self, core: Any, heat: Heat) -> State:
        """Create a `State` from a state of the compiled core and the heat of the next increment."""
        return State(core, self.setup, self.domain, heat, lambda: dict(self.core.counters))

    def solve(self, given: Mapping[str, Any], monitor: Monitor) -> tuple[Step, Any, Any]:
        """Solve an increment; return the step, and the states of the core before and after it.

        The state before the increment is only needed for an overlap of the bodies: it is None if
        the bodies cannot overlap, or if tractions are prescribed.
        """
        with self.access:
            while True:
                step = self._arguments.checked(self.heat, **given, held_tilt=self.core.tilt)
                target = step.target
                self.setup.adhesion.require_possible(
                    step.heat, given, sticks=self.setup.friction.sticks
                )
                if monitor.checks_steps:
                    monitor.warn_of_units(self.estimate, step.heat, target, stacklevel=4)
                if target and not any(step.heat.shares):
                    self.make_room(**target)
                before = self.core.state if target and self._may_overlap else None
                try:
                    return step, before, self.core.step(**step.to_core())
                except ConvergenceError as error:
                    explain_digits(error, self.estimate.gap)
                    raise
                except GridTooSmallError as error:
                    explain_size(error, self.estimate.hertz(**target))
                    self._enlarge(error, **target)

    def advance(
        self, given: Mapping[str, Any], monitor: Monitor
    ) -> tuple[State, list[UserWarning]]:
        """Advance by one increment; return the new state, and the warnings to issue."""
        setup = self.setup
        earlier = self.state if self._arguments.relaxes else None
        step, before, core = self.solve(given, monitor)
        state = self.state_of(core, step.heat)
        if before is not None:
            try:
                require_apart(state, setup.bodies, setup.friction, setup.settings.tol)
            except ConvergenceError:
                self.core.stand_at(before)
                raise
        self.heat = step.heat
        if self.estimate.plastic and step.normal is not None and self.hold_strain(core):
            state = self.state
        self.history.add(given)
        complaints: list[str] = core.warnings
        if complaints and not callable(setup.surfaces.gap):
            complaints = [advised(text, self.estimate) for text in complaints]
        found: list[UserWarning] = list(map(GridTooSmallWarning, complaints))
        if core.stall_warning:
            found.insert(0, ConvergenceWarning(core.stall_warning))
        if earlier is not None:
            found += monitor.relaxation.warnings(earlier, state)
        return state, found

    def make_room(self, load: float | None = None, approach: float | None = None) -> None:
        """Enlarge the domain to contain the expected Hertz contact, if the gap is a paraboloid.

        Raises GridTooSmallError if the domain cannot be enlarged.
        """
        if self.setup.settings.on_border != "error":
            return
        if self.estimate.plastic:
            state = self.core.state
            if state.max_plastic_strain_magnitude(0) or state.max_plastic_strain_magnitude(1):
                return
        try:
            self.estimate.require_room(load, approach)
        except GridTooSmallError as error:
            self._enlarge(error, load, approach)

    def hold_strain(self, core: Any) -> bool:
        """Enlarge the domain to include all plastic strain of the current core state.

        Return whether the domain was enlarged.
        """
        boxes = core.strain_beyond(0), core.strain_beyond(1)
        if not any(boxes):
            return False
        shape = self.domain.grid.surface_shape
        needed = list(shape)
        for box in filter(None, boxes):
            for axis, (n, first, cells) in enumerate(zip(shape, box[:2], box[2:4], strict=True)):
                excess = max(-first, first + cells - n, 0)
                needed[axis] = max(needed[axis], n + 2 * excess)
        counts = [enlarged_evenly(n, m) for n, m in zip(shape, needed, strict=True)]
        if self._reason_fixed or tuple(counts) == shape:
            return False
        try:
            self._switch_to(counts)
        except (ValueError, MemoryError):  # the increment is done; a warning reports it
            return False
        return True

    @property
    def _reason_fixed(self) -> str:
        """Reason why the domain cannot be enlarged; empty if it can be enlarged."""
        setup = self.setup
        if setup.settings.on_border != "error" or self.domain.grid.periodic:
            return _FIXED
        if self.heat.history is not None or setup.body1.softening or setup.body2.softening:
            return "the grid cannot be enlarged with heat.history or thermal softening"
        if setup.adhesion.attracts:
            return "the grid cannot be enlarged with an attractive contact law"
        if not setup.surfaces.are_known:
            return ENLARGEMENT_HINT
        return ""

    def _enlarge(
        self, error: GridTooSmallError, load: float | None = None, approach: float | None = None
    ) -> None:
        """Switch to a larger domain; raise `error` if the domain cannot be enlarged."""
        if reason := self._reason_fixed:
            if reason == ENLARGEMENT_HINT and not callable(self.setup.surfaces.gap):
                add_border_remedies(error, self.estimate)
            elif reason != _FIXED:
                error.args = (f"{error}; {reason}",)
            raise error
        with explain_failed_enlargement(error, self.domain.grid):
            counts = counts_for(error, self.first.grid, self.estimate, load, approach)
            self._switch_to(counts)

    def _switch_to(self, counts: Sequence[int]) -> None:
        """Switch to a domain with larger numbers of cells, and keep the current state."""
        grid = replace(self.domain.grid, nx=counts[0], ny=counts[1])
        domain, smaller = self._checked_domain(grid, self.domain), self.core
        self._open(domain, lambda core: core.take_over(smaller))
        _logger.info("%s", self.enlargement)

    @property
    def enlargement(self) -> str:
        """Text that reports the enlargement of the grid; empty if it was not enlarged."""
        (a, b), (c, d) = self.first.grid.surface_shape, self.domain.grid.surface_shape
        return f"grid enlarged from {a} x {b} to {c} x {d} cells" if (a, b) != (c, d) else ""

    def snapshot(self, state: State | None = None) -> Snapshot:
        """Return a snapshot of the current state, or of an earlier one."""
        return Snapshot.of(self.state if state is None else state)

    def restore(self, kept: Snapshot) -> None:
        """Restore the state and domain of a snapshot of the same setup.

        Raises ForeignCheckpointError if the surfaces of the snapshot differ.
        """
        self.history.forget()
        heat, state = kept.arguments["heat"], kept.state
        given, grid = kept.arguments, kept.arguments["grid"]
        same = self.domain.grid == grid
        domain = self.domain if same else self._checked_domain(grid, self.domain)
        if not callable(given["gap"]):
            before = Domain(grid, given["gap"], given.get("relief1"), given.get("relief2"))
            try:
                require_consistent_overlap(domain, before)
            except ValueError as error:
                message = f"the checkpoint was written for different surfaces: {error}"
                raise ForeignCheckpointError(message) from error
        then = heat
        if heat.partition is None:
            then = replace(heat, factor=[state["heat_factor1"], state["heat_factor2"]])
        entries = heating(then, self.setup.bodies, grid)
        if same:
            self.core.restore(state, kept.counters, entries)
        else:
            self._open(domain, lambda core: core.restore(state, kept.counters, entries))
        self.heat = heat

    def stand_at(self, state: State) -> None:
        """Return to an earlier state on the current domain."""
        self.history.forget()
        self.core.stand_at(state._core)
        self.heat = state.heat


def _state_of(kept: Snapshot) -> State:
    """Return the state of a snapshot, restored by a new engine."""
    engine = Engine(*kept.setup())
    engine.restore(kept)
    return engine.state


copyreg.pickle(State, lambda state: (_state_of, (Snapshot.of(state),)))

# SPDX-License-Identifier: GPL-3.0-or-later
"""The window of a simulation: what lies between the bodies over its grid, and over a larger one."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from .._core import GridTooSmallError
from .._util import memory
from .._util.checks import FloatArray
from ..bodies.layered import Body
from ..contact.border_advice import GROWS, told_of_fixed
from ..contact.enlargement import _even_more, counts_for, told_in
from ..diagnostics import hertz_estimate
from ..heat import Heat
from ..scene.domain import Surfaces, Window, require_continued
from ..scene.friction import Coulomb
from ..scene.grid import Grid
from ..scene.moving_topography import Relief
from ..scene.settings import Configured, Settings
from .steps import Step, checked_step

if TYPE_CHECKING:
    from ..diagnostics.monitor import Told

_logger = logging.getLogger("samcontact")


class Windowed(Configured):
    """Has the fields of a window as attributes; it becomes larger where surfaces are known there.

    With on_border="warn" the window stays.
    """

    grid: Grid
    initial_gap: FloatArray
    relief1: Relief | None
    relief2: Relief | None
    body1: Body
    body2: Body
    _settings: Settings
    _core: Any
    _heat: Heat
    _surfaces: Surfaces
    _first: Window
    _told: Told
    _window: Window
    _scene: hertz_estimate.Scene
    state: Any

    def _made(self, window: Window) -> Any:
        """The core of a simulation over a window."""
        raise NotImplementedError

    def _over(self, grid: Grid) -> Window:
        """The window of another grid."""
        bodies = self.body1, self.body2
        scanned = grid.has_volume and any(body.is_plastic for body in bodies)
        sticks = isinstance(self.friction, Coulomb)
        cell = self._memory_of_contact(*bodies, self._heat)
        cell += memory.STICK_SLIP_SIMULATION if sticks else memory.SIMULATION
        cell += memory.YIELD_SCAN if scanned else 0.0
        memory.require_for_grid("a simulation", grid, memory.surface(grid, cell))
        window = self._surfaces.over(grid)
        if hasattr(self, "_window"):
            larger, smaller = sorted((window, self._window), key=lambda w: w.cells, reverse=True)
            require_continued(larger, smaller)
        return window

    def _open(self, window: Window, stand: Callable[[Any], object] | None = None) -> None:
        """Look through another window, where `stand` makes the core stand: else at the start.

        An error or interrupt leaves all as it was.
        """
        core = self._made(window)
        if stand is not None:
            stand(core)
        relieved = any(relief is not None for relief in window.reliefs)
        bodies = self.body1, self.body2
        scene = hertz_estimate.Scene(window.grid, window.initial_gap, bodies, relieved)
        vars(self).update(vars(window), _window=window, _scene=scene, _core=core)

    @property
    def _stays(self) -> str:
        """Why the window does not become larger; nothing where it does."""
        if self.on_border != "error" or self.grid.periodic:
            return "it stays"
        if self._heat.history is not None or self.body1.softening or self.body2.softening:
            return "the grid stays, with heat of a history or bodies that soften"
        if not self._surfaces.are_known:
            return GROWS
        return ""

    def _checked(self, given: Mapping[str, Any]) -> Step:
        bodies = self.body1, self.body2
        return checked_step(self.grid, bodies, self._heat, self.friction, **given)

    def _solved(self, given: Mapping[str, Any]) -> tuple[Step, Any, Any]:
        """An increment, the state before and the core's after it, in a window that holds it."""
        while True:
            step = self._checked(given)
            if self._told.looks_at_steps:
                self._told.doubt(self._scene, step.heat, step.target, stacklevel=4)
            if not any(step.heat.shares):
                self._make_room(**step.target)
            before = self.state
            try:
                with self._scene.beside(**step.target):
                    return step, before, self._core.step(**step.to_core())
            except GridTooSmallError as error:
                self._widen(error, **step.target)

    def _make_room(self, load: float | None = None, approach: float | None = None) -> None:
        """For what Hertz says will come, where nothing else shapes the gap; refuse what does not
        fit into a window that stays."""
        strained = any(self._core.state.max_plastic_strain_magnitude(body) for body in (0, 1))
        if self.on_border != "error" or strained:
            return
        try:
            self._scene.require_room(load, approach)
        except GridTooSmallError as error:
            self._widen(error, load, approach)

    def _widen(
        self, error: GridTooSmallError, load: float | None = None, approach: float | None = None
    ) -> None:
        """Go on in a larger window; raise the error where there is none."""
        if why := self._stays:
            if why == GROWS and not callable(self._surfaces.gap):
                told_of_fixed(error, self._scene)
            elif why != "it stays":
                error.args = (f"{error}; {why}",)
            raise error
        with told_in(error, self.grid):
            self._go_on_over(counts_for(error, self._first.grid, self._scene, load, approach))

    def _hold_strain(self) -> bool:
        """Make room for all that has flowed where it is, so that fields show it; whether so."""
        needed = list(self.grid.surface_shape)
        for body in (0, 1):
            box = self._core.state.strain_beyond(body)
            if box is None:
                continue
            for axis, (n, first, cells) in enumerate(
                zip(self.grid.surface_shape, box[:2], box[2:4], strict=True)
            ):
                beside = max(-first, first + cells - n, 0)
                needed[axis] = max(needed[axis], n + 2 * beside)
        counts = [_even_more(n, m) for n, m in zip(self.grid.surface_shape, needed, strict=True)]
        if self._stays or tuple(counts) == self.grid.surface_shape:
            return False
        try:
            self._go_on_over(counts)
        except (ValueError, MemoryError):  # the increment is done; a warning tells of it
            return False
        return True

    def _go_on_over(self, counts: Sequence[int]) -> None:
        """In a larger window, from the same moment."""
        window, smaller = self._over(replace(self.grid, nx=counts[0], ny=counts[1])), self._core
        self._open(window, lambda core: core.take_over(smaller))
        _logger.info("%s", self._growth())

    def _growth(self) -> str:
        """What has become of the first window, in words; nothing where it is as it was."""
        (a, b), (c, d) = self._first.grid.surface_shape, self.grid.surface_shape
        return f"the window has grown from {a} x {b} to {c} x {d} cells" if (a, b) != (c, d) else ""

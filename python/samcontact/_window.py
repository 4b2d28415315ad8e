# SPDX-License-Identifier: GPL-3.0-or-later
"""The window of a simulation: what lies between the bodies over its grid, and over a larger one."""

from __future__ import annotations

import logging
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _expected, _memory
from ._border import GROWS, told_of_fixed
from ._checks import FloatArray, gap_array
from ._core import GridTooSmallError
from ._frozen import read_only
from ._settings import Configured, Settings
from ._steps import Step, checked_step
from .friction import Coulomb
from .grid import Grid
from .heat import Heat
from .layered import Body
from .relief import Relief, heights_over, relief_rows

if TYPE_CHECKING:
    from ._told import Told

_logger = logging.getLogger("samcontact")

MOST, LARGE = 64, 1 << 22
"""Times the cells of its first window that a window may have; and cells, where Hertz says so."""
ROOM = 1.25
"""Sides of a window over those of the Hertz contact: yielding bodies touch over more."""
_WIDER, _LEAST = 1.5, 1.25  # a side that the contact touches, and one that needs to be longer
_SAME = 1e-9  # of the heights


@dataclass(frozen=True, eq=False)
class Window:
    """A grid, and what lies between two bodies over it."""

    grid: Grid
    initial_gap: FloatArray
    relief1: Relief | None
    relief2: Relief | None

    @property
    def reliefs(self) -> tuple[Relief | None, Relief | None]:
        return self.relief1, self.relief2

    @property
    def cells(self) -> int:
        return self.grid.nx * self.grid.ny


@dataclass(frozen=True, eq=False)
class Surfaces:
    """What lies between two bodies: fields of one grid, or functions of any."""

    gap: ArrayLike | Callable[[Grid], ArrayLike]
    relief1: Relief | Callable[[Grid], Relief] | None = None
    relief2: Relief | Callable[[Grid], Relief] | None = None

    @property
    def are_known(self) -> bool:
        """Whether on any grid."""
        reliefs = (self.relief1, self.relief2)
        return callable(self.gap) and all(r is None or callable(r) for r in reliefs)

    def over(self, grid: Grid) -> Window:
        """Checked."""
        gap = self.gap(grid) if callable(self.gap) else self.gap
        reliefs = [r(grid) if callable(r) else r for r in (self.relief1, self.relief2)]
        for number, relief in enumerate(reliefs, 1):
            relief_rows(f"relief{number}", relief, grid)
        checked = np.array(gap_array("gap", gap, grid.surface_shape), order="C")
        return Window(grid, read_only(checked), *reliefs)


def require_continued(larger: Window, window: Window) -> None:
    """Raise ValueError unless a larger window shows the same surfaces in its middle."""
    i = (larger.grid.nx - window.grid.nx) // 2
    j = (larger.grid.ny - window.grid.ny) // 2
    columns = slice(j, j + window.grid.ny)
    shown = [("gap", larger.initial_gap[i : i + window.grid.nx, columns], window.initial_gap)]
    for number, (now, before) in enumerate(zip(larger.reliefs, window.reliefs, strict=True), 1):
        if now is not None and before is not None:
            first, rows = before.first, len(before.heights)
            heights = heights_over(now, first + i, rows)[:, columns]
            shown.append((f"relief{number}", heights, before.heights))
    for name, field, known in shown:
        body = np.isfinite(known)
        if not np.array_equal(np.isfinite(field), body):
            raise ValueError(f"{name} on a larger grid is infinite in other cells, no body there")
        off = np.abs(field[body] - known[body])
        if not np.all(off <= _SAME * float(np.ptp(known[body]))):
            raise ValueError(
                f"{name} is another surface on a larger grid, which differs by up to "
                f"{off.max():.3g} m where both know it"
            )


def counts_for(
    error: GridTooSmallError,
    first: Grid,
    scene: _expected.Scene,
    load: float | None = None,
    approach: float | None = None,
) -> list[int]:
    """Cells along x and y of a window larger than that of an error; ValueError for too many."""
    shape, sizes = scene.grid.surface_shape, (scene.grid.dx, scene.grid.dy)
    halves = zip(scene.extent(load, approach), sizes, strict=True)
    needed = [math.ceil(2 * ROOM * half / d) for half, d in halves]
    fits = all(n >= cells for n, cells in zip(shape, needed, strict=True))
    counts = [
        _even_more(n, max(cells, _WIDER * n if fits and axis in (error.axes or "xy") else n))
        for axis, n, cells in zip("xy", shape, needed, strict=True)
    ]
    most = MOST * first.nx * first.ny
    most = max(most, MOST * needed[0] * needed[1] if fits else LARGE)
    if counts[0] * counts[1] > most:
        raise ValueError(f"{counts[0]} x {counts[1]} cells are more than {most}")
    return counts


@contextmanager
def told_in(error: GridTooSmallError, grid: Grid) -> Iterator[None]:
    """Why a grid cannot become larger, as a part of the error that asked for it."""
    try:
        yield
    except (ValueError, MemoryError) as reason:
        cells = f"{grid.nx} x {grid.ny} cells"
        error.args = (f"{error}; the grid of {cells} grows no further: {reason}",)
        raise error from reason


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
    _scene: _expected.Scene
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
        cell += _memory.STICK_SLIP_SIMULATION if sticks else _memory.SIMULATION
        cell += _memory.YIELD_SCAN if scanned else 0.0
        _memory.require_for_grid("a simulation", grid, _memory.surface(grid, cell))
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
        scene = _expected.Scene(window.grid, window.initial_gap, bodies, relieved)
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


def _even_more(n: int, wanted: float) -> int:
    """At least as many cells as wanted, an even number more and a quarter at least, if any."""
    if wanted <= n:
        return n
    return n + 2 * math.ceil((max(wanted, _LEAST * n) - n) / 2)

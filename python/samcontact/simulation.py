# SPDX-License-Identifier: GPL-3.0-or-later
"""Incremental elastic-plastic contact: loading, unloading, reloading."""

from __future__ import annotations

import logging
import os
import threading
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core, _expected, _memory, resolution
from ._checks import (
    FloatArray,
    choice,
    exactly_one,
    finite_array,
    in_cells,
    integer,
    non_negative,
    number,
    of_bodies,
    positive,
    step_list,
    tractions,
)
from ._copies import reduced, restored, stand_at
from ._core import ConvergenceError
from ._frozen import Fixed, read_only
from ._heating import COLD, heating, require_reference
from ._journal import Journal, describe
from ._overlap import require_apart
from ._progress import progress_bar
from ._repr import Rows, Shown, counts, lengths, material_in_short, quantity
from .checkpoint import DAMAGED, CheckpointError, damaged, read_checkpoint, write_checkpoint
from .contact import GridTooSmallWarning, require_type
from .grid import Grid
from .heat import Heat
from .material import Material
from .operators import shear_components
from .relief import Relief, relief_rows
from .state import State

__all__ = ["CheckpointError", "PlasticStrainWarning", "Simulation"]

SMALL_STRAIN = 0.05
"""Equivalent plastic strain sqrt(2/3 e:e) up to which small-strain theory is trusted [-]."""


_logger = logging.getLogger("samcontact")


def _log(state: State, number: int, count: int) -> None:
    """One increment of a run."""
    if not _logger.isEnabledFor(logging.INFO):
        return
    _logger.info(
        "increment %d of %d: load %.6g N, approach %.6g m, largest pressure %.6g Pa",
        number, count, state.load, state.approach, state.pressure.max(),
    )  # fmt: skip
    _logger.debug(
        "increment %d: %d plastic and %d contact iterations in %d parts, residual %.2g",
        number, state.iterations, state.contact_iterations, state.substeps, state.plastic_residual,
    )  # fmt: skip


_TOLD = ("_warned_of_strain", "_warned_of_pressure", "_looks_at_steps", "_largest_load")
"""What a copy of a simulation need not tell again."""


_STEP = (
    "load", "approach", "pressure", "shear", "advance", "heat_factor", "duration",
)  # fmt: skip
"""Arguments of `Simulation.step`."""


def require_over_grid(grid: Grid, strain: FloatArray, first: int) -> None:
    """Refuse a plastic strain that lies beside the grid as a whole."""
    rows = np.flatnonzero(strain.any(axis=(0, 2, 3))) + first
    if rows.size and not ((rows >= 0) & (rows < grid.nx)).any():
        raise ValueError(
            f"strain must lie over the grid at least in part, rows 0 to {grid.nx - 1}; with "
            f"first = {first} it lies in rows {rows[0]} to {rows[-1]}"
        )


class PlasticStrainWarning(UserWarning):
    """The plastic strain is beyond the small-strain theory."""


class Simulation(Fixed, Shown):
    """Elastic-plastic contact of two bodies, increment after increment.

    Each increment solves, implicitly, contact and plastic flow together: the plastic strain
    increment is the fixed point of residual displacement -> contact -> stress -> radial return
    (backward Euler), accelerated by Anderson mixing and halved where it does not converge.

    Parameters
    ----------
    grid : Grid
        Needs layers (nz, dz) when a body is inelastic.
    body1, body2 : Material
        Upper and lower body; any of them inelastic, at most one rigid.
    gap : array_like, shape (nx, ny)
        Initial separation of the undeformed bodies [m].
    friction : float, optional
        Coefficient of friction mu >= 0 (gross sliding along +x on body 2).
    tol : float, optional
        An increment is accepted when the relative change of the plastic strain increment and the
        relative yield excess are below; in [1e-11, 1).
    increment_tol : float, optional
        In [10 tol, 1): divide increments in which a body yields so that the error of their
        division stays below this, in pressure and equivalent plastic strain relative to their
        maxima. Each part is solved as a whole and in halves, which are extrapolated to second
        order. By default increments are taken as given; the error of backward Euler is of first
        order in them.
    on_border : {"error", "warn"}, optional
        What to do when the contact or the plastic zone reaches the border of the grid.
    max_iterations : int, optional
        Of the plastic fixed point, before the increment is halved.
    residual_stress : {"fast", "exact"}, optional
        "fast": sweeps over the layers; time and memory grow with the cells. "exact": influence
        coefficients of cuboids, a reference, right for strain that varies from cell to cell; time
        grows with the square of the layers, memory is 1 kB a cell, and with little hardening
        plastic flow need not converge. See docs/theory.md for their errors.
    image_tol : float, optional
        With "fast": error due to the periodicity of the transforms, relative to the largest
        residual stress; in [1e-6, 0.1].
    heat : Heat, optional
        Frictional heat; default none, `Heat(0.0)`.
    relief1, relief2 : Relief, optional
        Roughness or dents of the surface of body 1 and 2, which move with it.
    reach : float, optional
        How far beyond the grid, along x, the plastic strain of a moving body still acts [m], >= 0;
        default: the length of the grid. See docs/theory.md for the error of what is left out.

    Raises
    ------
    ValueError, TypeError
        An argument out of range or of the wrong kind; the text names it, its value and what is
        allowed.
    MemoryError
        The surface needs more memory than is available, told before any is taken; as does `step`
        for the plastic zone, and `State` for a volume field.
    """

    def __init__(
        self,
        grid: Grid,
        body1: Material,
        body2: Material,
        gap: ArrayLike,
        friction: float = 0.0,
        *,
        tol: float = 1e-6,
        increment_tol: float | None = None,
        on_border: str = "error",
        max_iterations: int = 60,
        residual_stress: str = "fast",
        image_tol: float = 1e-3,
        heat: Heat | None = None,
        relief1: Relief | None = None,
        relief2: Relief | None = None,
        reach: float | None = None,
    ) -> None:
        require_type("grid", grid, Grid)
        require_type("body1", body1, Material)
        require_type("body2", body2, Material)
        self.grid = grid
        self.body1 = body1
        self.body2 = body2
        scanned = grid.nz > 0 and (body1.is_plastic or body2.is_plastic)
        cell = _memory.SIMULATION + (_memory.YIELD_SCAN if scanned else 0.0)
        _memory.require_for_grid("a simulation", grid, _memory.surface(grid, cell))
        checked = np.array(finite_array("gap", gap, grid.surface_shape), order="C")
        self.initial_gap = read_only(checked)
        self.friction = number("friction", friction)
        self.tol = number("tol", tol)
        self.increment_tol = None
        if increment_tol is not None:
            self.increment_tol = number("increment_tol", increment_tol)
            if not 10 * self.tol <= self.increment_tol < 1:
                raise ValueError(
                    f"increment_tol must be in [10 tol, 1) with tol = {self.tol!r}, "
                    f"got {self.increment_tol!r}"
                )
        self.on_border = choice("on_border", on_border, ("error", "warn"))
        self.max_iterations = integer("max_iterations", max_iterations, 1)
        self.residual_stress = choice("residual_stress", residual_stress, ("fast", "exact"))
        self.image_tol = number("image_tol", image_tol)
        if not 1e-6 <= self.image_tol <= 0.1:
            raise ValueError(f"image_tol must be in [1e-6, 0.1], got {self.image_tol!r}")
        self._heat = COLD if heat is None else heat
        require_type("heat", self._heat, Heat)
        heating(self._heat, (body1, body2), grid)  # checks it against the bodies
        self.relief1, self.relief2 = relief1, relief2
        length = grid.nx * grid.dx
        self.reach = length if reach is None else non_negative("reach", reach)
        relieved = relief1 is not None or relief2 is not None
        self._scene = _expected.Scene(grid, self.initial_gap, (body1, body2), relieved)
        self._warned_of_strain = self._warned_of_pressure = False
        self._looks_at_steps = True  # a run looks at its grid as a whole
        self._largest_load = 0.0
        self._turn = threading.Lock()
        self._core = _core.Simulation(
            grid._core,
            body1._core,
            body2._core,
            self.initial_gap,
            self.friction,
            self.tol,
            self.increment_tol or 0.0,
            self.max_iterations,
            self.on_border == "error",
            self.residual_stress,
            self.image_tol,
            [self._softening(body) for body in (body1, body2)],
            self._heat.history or (0.0, 0.0),
            round(in_cells("reach", self.reach, grid.dx)),
            [relief_rows(f"relief{n}", r, grid) for n, r in ((1, relief1), (2, relief2))],
        )

    @property
    def heat(self) -> Heat:
        """Of the next increment; `step` can change its factor."""
        return self._heat

    def step(
        self,
        *,
        load: float | None = None,
        approach: float | None = None,
        pressure: ArrayLike | None = None,
        shear: ArrayLike | None = None,
        advance: Sequence[float] = (0.0, 0.0),
        heat_factor: float | Sequence[float] | None = None,
        duration: float | None = None,
    ) -> State:
        """Go one increment further, to exactly one of load, approach, or given tractions.

        Parameters
        ----------
        load : float
            Total load [N], >= 0 (0: unloaded).
        approach : float
            Rigid-body approach [m].
        pressure : array_like, shape (nx, ny)
            Prescribed pressure [Pa], no contact is solved; with
        shear : array_like, shape (nx, ny) or (2, nx, ny), optional
            prescribed shear s_x, or (s_x, s_y), on body 2 [Pa]; default friction * pressure.
        advance : pair of floats, optional
            How far the surfaces of body 1 and 2 move through the contact, in +x, on the way to the
            target [m]. Equal: rolling, the contact itself travels towards -x over both; different:
            sliding by the difference; one of them 0: simple sliding over the other. Their plastic
            strain moves with them, the grid stays with the contact. Whole cells are exact; see
            `State.origin` for parts of them.
        heat_factor : float or pair of floats, optional
            Of the heat from now on [m/s]; 0: the source is off.
        duration : float, optional
            Of the increment [s], > 0; goes with a `history` of the heat. The flux is that of the
            pressure at its end.

        Returns
        -------
        State
            The new present state.

        Raises
        ------
        ValueError
            Bad arguments, or GridTooSmallError.
        ConvergenceError
            With .iterations and .residual.
        MemoryError
            The plastic zone needs more memory than is available. In every case the state before the
            call stays.
        RuntimeError
            Another thread, or a law of softening, is in the middle of an increment.

        Warns
        -----
        ElasticStrainWarning
            Once in a simulation, when the largest pressure passes half the contact modulus.
        PlasticStrainWarning
            Once in a simulation, when the largest equivalent plastic strain passes 5 %.
        GridTooSmallWarning
            With on_border="warn", where there would be a GridTooSmallError.
        ResolutionWarning
            Once in a simulation, when the contact is fewer than 4 cells across, or a plastic zone
            beyond the strain at yield fewer than 4 layers high; `run` warns below 8.
        """
        kind = exactly_one(load=load, approach=approach, pressure=pressure)
        value, p, shear_x, shear_y = 0.0, None, None, None
        if kind == "pressure":
            shape = self.grid.surface_shape
            p = tractions("pressure", pressure, shape)  # type: ignore[arg-type]
            shear_x, shear_y = shear_components(self.grid, shear)
        elif shear is not None:
            raise ValueError(f"shear goes with pressure, not with {kind}: use friction instead")
        else:
            value = number(kind, load if kind == "load" else approach)
        ways = finite_array("advance", advance, (2,))
        first, second = (in_cells("advance", float(way), self.grid.dx) for way in ways)
        heat, lasts = self._heat, self._duration(duration)
        if heat_factor is not None:
            heat = replace(heat, factor=of_bodies("heat_factor", heat_factor))
        self._check_motion(heat, first, second, lasts or 0.0)
        entries = heating(heat, (self.body1, self.body2), self.grid, lasts)
        if kind == "approach":
            require_reference(heat)
        target = {} if kind == "pressure" else {kind: value}
        if not any(heat.factor):
            self._require_room(**target)
        before = self.state
        with self._alone(), self._scene.beside(**target):
            core = self._core.step(
                kind, value, p, shear_x, shear_y, entries, lasts or 0.0, (first, second)
            )
        state = State(core, self, heat)
        if target:
            try:
                bodies = (self.body1, self.body2)
                require_apart(state, self.grid.cell_area, bodies, self.friction, self.tol)
            except ConvergenceError:
                stand_at(self, before)
                raise
        self._heat = heat
        for warning in core.warnings:
            warnings.warn(warning, GridTooSmallWarning, stacklevel=2)
        if self._looks_at_steps and state.load > self._largest_load:
            self._largest_load = state.load
            warned = resolution.warn_of_step(state, self._scene, stacklevel=2)
            self._looks_at_steps = not warned
        if not self._warned_of_pressure:
            self._warned_of_pressure = resolution.warn_of_strain(
                state.pressure, self._scene, stacklevel=2
            )
        if not self._warned_of_strain:
            strain, body = max((state.max_plastic_strain(b), b) for b in (1, 2))
            if strain > SMALL_STRAIN:
                self._warned_of_strain = True
                warnings.warn(
                    f"the equivalent plastic strain of body {body} reaches {strain:.3g}, more than "
                    f"{SMALL_STRAIN}: strains are taken as small, and results lose their meaning "
                    "beyond",
                    PlasticStrainWarning,
                    stacklevel=2,
                )
        return state

    @contextmanager
    def _alone(self) -> Iterator[None]:
        """Refuse a second thread, or a law of softening, that would change the same simulation."""
        if not self._turn.acquire(blocking=False):
            raise RuntimeError(
                "this simulation is in the middle of an increment: one thread at a time, each "
                "with a simulation of its own (copy.deepcopy makes one)"
            )
        try:
            yield
        finally:
            self._turn.release()

    def _require_room(self, load: float | None = None, approach: float | None = None) -> None:
        """Refuse what Hertz says will not fit, where nothing else shapes the gap."""
        strained = any(self.state.max_plastic_strain(body) for body in (1, 2))
        if self.on_border == "error" and not strained:
            self._scene.require_room(load, approach)

    def _require_room_of(self, steps: Sequence[Mapping[str, Any]]) -> None:
        """The same of the largest load of a path, before its first increment."""
        heated = any(self._heat.factor) or any("heat_factor" in step for step in steps)
        loads = [step.get("load") for step in steps]
        given = [load for load in loads if isinstance(load, (int, float))]
        if given and not heated:
            self._require_room(load=max(given))

    def _softening(self, body: Material) -> Callable[[FloatArray], FloatArray] | None:
        """The law of a material as the core calls it: (nx, ny, nz) in, depth-major out."""
        law = body.softening
        if law is None:
            return None
        shape = self.grid.volume_shape

        def factor(rise: FloatArray) -> FloatArray:
            checked = finite_array("factor of softening", law(rise), shape)
            return np.ascontiguousarray(np.moveaxis(checked, 2, 0))

        return factor

    def _duration(self, duration: float | None) -> float | None:
        """Of an increment [s]; None without a march in time."""
        history = self._heat.history
        if history is None:
            if duration is not None:
                raise ValueError("duration needs a simulation with heat of a history")
            return None
        if duration is None:
            raise ValueError("duration must be given in a simulation with heat of a history")
        seconds, shortest = positive("duration", duration), history[0]
        if seconds < shortest * (1 - 1e-12):
            raise ValueError(
                f"duration must be at least the shortest step of heat.history, {shortest!r} s, "
                f"got {seconds!r}"
            )
        return seconds

    def _check_motion(self, heat: Heat, first: float, second: float, duration: float) -> None:
        """Past heat is known at the cells of the grid, and moves with the velocities."""
        if heat.history is None or first == second == 0:
            return
        for n, cells in ((1, first), (2, second)):
            moved = cells * self.grid.dx
            if abs(cells - round(cells)) > 1e-6:
                raise ValueError(
                    f"advance of body {n} must be a whole number of cells of {self.grid.dx!r} m in "
                    f"a simulation with heat of a history, got {moved!r} m"
                )
            expected = heat.velocity[n - 1][0] * duration
            if heat.factor[n - 1] > 0 and abs(moved - expected) > 1e-6 * self.grid.dx:
                raise ValueError(
                    f"advance of body {n} must be its velocity times duration, {expected!r} m, "
                    f"got {moved!r} m"
                )

    def run(
        self,
        path: Iterable[Mapping[str, Any]],
        *,
        progress: bool = True,
        checkpoint: str | os.PathLike[str] | None = None,
    ) -> list[State]:
        """Run a list of step() arguments, e.g. ``[{"load": 300.0}, {"load": 0.0}]``.

        Parameters
        ----------
        path : iterable of dict
            See `samcontact.paths` for helpers.
        progress : bool, optional
            Show a progress bar; where there is no terminal, ten lines at most.
        checkpoint : path, optional
            Folder in which to keep each increment. The same call of a new simulation goes on from
            it, with the same bits as without interruption. Remove it when it is no longer needed.

        Returns
        -------
        list of State
            One per increment. When an increment fails or is interrupted (Ctrl-C), the error is
            raised with those before it in the attribute `states`, and the simulation stands at the
            last good one. The logger "samcontact" tells each (INFO) and its iterations (DEBUG).

        Raises
        ------
        ValueError
            `checkpoint` holds those of another run; and as `step`. A contact that does not fit into
            the grid by far is refused before the first increment.

        Warns
        -----
        ResolutionWarning
            At the end, when the contact is fewer than 8 cells across under the largest load, a
            plastic zone fewer than 8 layers high, or the layers cannot show whether a body yields.
        """
        states: list[State] = []
        try:
            self._run_into(states, step_list("path", path, _STEP), progress, checkpoint)
        except BaseException as error:  # Ctrl-C too
            error.states = states  # type: ignore[attr-defined]
            raise
        return states

    def _run_into(
        self,
        states: list[State],
        steps: Sequence[Mapping[str, Any]],
        progress: bool,
        checkpoint: str | os.PathLike[str] | None,
    ) -> None:
        """Append the state of each increment as soon as it is done."""
        self._require_room_of(steps)
        journal = None if checkpoint is None else Journal(checkpoint, self, describe(self, steps))
        looks, self._looks_at_steps = self._looks_at_steps, False
        try:
            with progress_bar(len(steps), "increment", shown=progress) as bar:
                for arguments in steps:
                    state = journal.next() if journal else None
                    kept = state is not None
                    try:
                        states.append(self.step(**arguments) if state is None else state)
                    except Warning:  # made an error by a filter: the increment is done
                        states.append(self.state)
                        raise
                    finally:
                        if journal and not kept and len(states) > journal.count:
                            journal.add()
                    _log(states[-1], len(states), len(steps))
                    bar.update()
                    if progress:
                        strain = max(map(states[-1].max_equivalent_plastic_strain, (1, 2)))
                        bar.set_postfix(
                            iterations=states[-1].iterations, plastic_strain=f"{strain:.3g}"
                        )
        finally:
            self._looks_at_steps = looks
        resolution.warn_of_run(states, self._scene, stacklevel=4)

    @property
    def state(self) -> State:
        """The present state."""
        return State(self._core.state, self, self._heat)

    @property
    def counters(self) -> dict[str, int]:
        """Work done so far, as contact_solves, contact_iterations, yield_checks, plastic_solves,
        plastic_iterations, halvings, and volume_bytes (memory of plastic state and kernels)."""
        return dict(self._core.counters)

    def set_plastic_strain(
        self,
        body: int,
        strain: ArrayLike,
        equivalent: ArrayLike | None = None,
        backstress: ArrayLike | None = None,
        first: int | None = None,
    ) -> None:
        """Set the plastic strain (or any eigenstrain) of an inelastic body to go on from.

        Parameters
        ----------
        body : {1, 2}
        strain : array_like, shape (6, nx, ny, nz)
            Any symmetric strain, tensor components xx, yy, zz, yz, xz, xy [-].
        equivalent : array_like, shape (nx, ny, nz), optional
            Accumulated equivalent plastic strain [-], >= 0; default 0.
        backstress : array_like, shape (terms, 6, nx, ny, nz), optional
            For a material with kinematic hardening: a deviator [Pa] for each of its backstresses,
            as `State.backstress` returns them; default 0.
        first : int, optional
            Row of the grid over which the first row of these fields lies; may be negative. They may
            then have any number of rows along x instead of nx, e.g. those of a whole track:
            ``set_plastic_strain(2, track.plastic_strain(), first=track.first)``.

        Raises
        ------
        ValueError
            A field of another shape, not finite, or with values outside their range.
        """
        index = choice("body", body, (1, 2)) - 1
        rows, ny, nz = self.grid.volume_shape
        if first is not None:
            integer("first", first)
            given = np.shape(strain)
            rows = given[1] if len(given) == 4 and given[1] > 0 else rows
        shape = (rows, ny, nz)
        checked_strain = finite_array("strain", strain, (6, *shape))
        depthwise = np.ascontiguousarray(np.moveaxis(checked_strain, 3, 1))
        history: FloatArray | None = None
        if equivalent is not None:
            checked = finite_array("equivalent", equivalent, shape)
            history = np.ascontiguousarray(np.moveaxis(checked, 2, 0))
        centre: FloatArray | None = None
        if backstress is not None:
            terms = len((self.body1, self.body2)[index].kinematic)
            checked = finite_array("backstress", backstress, (terms, 6, *shape))
            centre = np.ascontiguousarray(np.moveaxis(checked, 4, 2))
        require_over_grid(self.grid, checked_strain, first or 0)
        with self._alone():
            self._core.set_plastic_state(index, first or 0, depthwise, history, centre)

    def _rows(self) -> Rows:
        grid, state = self.grid, self.state
        cells = counts(*(grid.volume_shape if grid.dz is not None else grid.surface_shape))
        sizes = lengths(*(size for size in (grid.dx, grid.dy, grid.dz) if size is not None))
        return [
            ("grid", f"{cells} cells of {sizes}"),
            ("body 1", material_in_short(self.body1)),
            ("body 2", material_in_short(self.body2)),
            ("friction", quantity(self.friction)),
            ("tolerance", quantity(self.tol)),
            ("load", quantity(state.load, "N")),
            ("approach", quantity(state.approach, "m")),
            ("maximum pressure", quantity(float(state.pressure.max()), "Pa")),
        ]

    def __repr__(self) -> str:
        settings = (
            "friction", "tol", "increment_tol", "on_border", "max_iterations", "residual_stress",
            "image_tol", "heat", "reach",
        )  # fmt: skip
        values = ((name, getattr(self, name)) for name in settings)
        listed = ", ".join(f"{name}={value!r}" for name, value in values if value is not None)
        return f"Simulation({self.grid!r}, {self.body1!r}, {self.body2!r}, {listed})"

    def __reduce__(self) -> tuple[Any, ...]:
        return restored, reduced(self), {name: getattr(self, name) for name in _TOLD}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a checkpoint (HDF5), replacing an old one only when the new one is complete."""
        write_checkpoint(path, self)

    @classmethod
    def load(
        cls,
        path: str | os.PathLike[str],
        softening: Sequence[Callable[[FloatArray], ArrayLike] | None] = (None, None),
    ) -> Simulation:
        """Read a checkpoint; going on from it gives bit-identical results on the same machine.

        softening: the laws of body 1 and 2, where they are not of `samcontact.softening`.

        Raises CheckpointError (a ValueError) for a file that is no checkpoint or is damaged.
        """
        try:
            law1, law2 = softening
        except (TypeError, ValueError) as error:
            raise TypeError(
                f"softening must be a pair, (law of body 1, law of body 2), got {softening!r}"
            ) from error
        arguments, saved = read_checkpoint(path, (law1, law2))
        try:
            simulation = cls(**arguments)
            simulation._core.restore(saved)
        except DAMAGED as error:
            raise damaged(path, error) from error
        return simulation

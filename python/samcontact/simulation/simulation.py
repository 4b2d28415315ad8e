# SPDX-License-Identifier: GPL-3.0-or-later
"""Incremental elastic-plastic contact: loading, unloading, reloading."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from numpy.typing import ArrayLike

from .._core import ConvergenceError
from .._util.checks import FloatArray, boolean, choice, require_fast, require_type, step_list
from .._util.display import Shown
from ..bodies.layered import Body, backstresses_of, require_bodies
from ..contact.border_advice import advised
from ..contact.interpenetration import require_apart
from ..contact.tangential_drive import require_heat_of
from ..diagnostics.monitor import Monitor
from ..heat import Heat
from ..restart.file import other_version, readable
from ..scene.cell_layers import require_servable_flow
from ..scene.domain import Domain, SurfaceGeometry
from ..scene.friction import Coulomb
from ..scene.grid import Grid
from ..scene.heating import COLD, heating
from ..scene.moving_topography import Relief
from ..scene.settings import Configured, Settings
from ..scene.setup import SimulationSetup
from ..solutions.state import State, in_one_window
from .checkpoint import read_checkpoint, write_checkpoint
from .display import simulation_rows
from .engine import Engine
from .increment_errors import warn_of
from .run import run_into
from .snapshot import Snapshot
from .steps import STEP, largest_cold_load, largest_target, plastic_fields


class Simulation(Configured, Shown):
    """Elastic-plastic contact of two bodies, increment after increment.

    Each increment solves, implicitly, contact and plastic flow together: the plastic strain
    increment is the fixed point of residual displacement -> contact -> stress -> radial return
    (backward Euler), accelerated by Anderson mixing and halved where it does not converge.

    Parameters
    ----------
    grid : Grid
        Needs layers (dz) when a body is inelastic.
    body1, body2 : Material or Layered
        Upper and lower body; any of them inelastic, at most one rigid.
    gap : array_like, shape (nx, ny), or callable
        Initial separation of the undeformed bodies [m], inf where one of them is not; or a function
        of a grid that returns it, e.g. ``lambda grid: surfaces.paraboloid(grid, R)``. Then the grid
        becomes larger by itself where it does not hold the contact, see Notes.
    friction : float or Coulomb, optional
        Coefficient of friction mu >= 0: gross sliding along +x on body 2. `Coulomb(mu)`: the bodies
        stick and slip, driven by `step` along the surface.
    tol : float, optional
        An increment is accepted when the relative change of the plastic strain increment and the
        relative yield excess are below; in [1e-11, 1).
    increment_tol : float, optional
        In [10 tol, 1): divide increments in which a body yields so that the error of their
        division stays below this, in pressure and equivalent plastic strain relative to their
        maxima. Each part is solved as a whole and in halves, which are extrapolated to second
        order. More than 64 parts are a ValueError, which tells the tolerance that takes as many.
        By default increments are taken as given, with errors of first order.
    on_border : {"error", "warn"}, optional
        What to do when the contact reaches the border of a grid that cannot grow; with "warn" it
        does not.
    max_iterations : int, optional
        Of the plastic fixed point, before the increment is halved.
    residual_stress : {"fast", "exact"}, optional
        "fast": sweeps over the layers; time and memory grow with the cells. "exact": influence
        coefficients of cuboids at their centres, a reference, right for strain that varies from
        cell to cell; time grows with the square of the layers, memory is 1 kB a cell. With little
        hardening and cells as deep as wide, plastic strain may alternate from layer to layer (a
        ResolutionWarning) or not converge. See docs/theory.md for their errors.
    image_tol : float, optional
        With "fast": error due to the periodicity of the transforms, relative to the largest
        residual stress; in [1e-6, 0.1].
    zones : {"auto", "one"}, optional
        Whether plastic strain is solved for in many small boxes where that is less work, as on
        rough surfaces, or always in one. They differ by about 1e-3 of the residual stress;
        docs/theory.md, "Zones", has what is always solved in one.
    heat : Heat, optional
        Frictional heat; default none, `Heat(0.0)`.
    relief1, relief2 : Relief or callable, optional
        Roughness or dents of the surface of body 1 and 2, which move with it; or a function of a
        grid that returns them.
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

    Notes
    -----
    A grid grows on both sides, by whole cells of the same size: to 1.25 times the Hertz contact of
    a paraboloid, at the start of a run that of its largest load, else by half along each direction
    whose border is touched. `grid` and the arrays of its shape are then those of the larger one; a
    state keeps its own, and `run` returns all in the last one. It ends at 64 times the cells, with
    a GridTooSmallError, which tells whether gap or reliefs are not known there. Grids that are
    periodic, heat with a history, and bodies that soften keep their grid.
    """

    _last = "engine"

    increment_tol: float | None
    residual_stress: str
    image_tol: float
    zones: str
    reach: float

    def __init__(
        self,
        grid: Grid,
        body1: Body,
        body2: Body,
        gap: ArrayLike | Callable[[Grid], ArrayLike],
        friction: float | Coulomb = Settings.friction,
        *,
        tol: float = Settings.tol,
        increment_tol: float | None = Settings.increment_tol,
        on_border: str = Settings.on_border,
        max_iterations: int = Settings.max_iterations,
        residual_stress: str = Settings.residual_stress,
        image_tol: float = Settings.image_tol,
        zones: str = Settings.zones,
        heat: Heat | None = None,
        relief1: Relief | Callable[[Grid], Relief] | None = None,
        relief2: Relief | Callable[[Grid], Relief] | None = None,
        reach: float | None = Settings.reach,
    ) -> None:
        require_type("grid", grid, Grid)
        require_bodies(body1, body2)
        layered = require_servable_flow(grid, residual_stress, body1, body2)
        self.body1, self.body2 = body1, body2
        settings = Settings(
            friction=friction,
            tol=tol,
            increment_tol=increment_tol,
            on_border=on_border,
            max_iterations=max_iterations,
            residual_stress=residual_stress,
            image_tol=image_tol,
            zones="one" if layered else zones,
            reach=grid.nx * grid.dx if reach is None else reach,
        )
        self._configure(settings)
        require_fast("residual_stress", self.residual_stress, grid.periodic)
        heat = COLD if heat is None else heat
        require_type("heat", heat, Heat)
        heating(heat, (body1, body2), grid)  # checks it against the bodies
        require_heat_of(self.friction, heat)
        self.monitor = Monitor()
        surfaces = SurfaceGeometry(gap, relief1, relief2)
        self.engine = Engine(SimulationSetup(body1, body2, surfaces, settings), grid, heat)

    @property
    def grid(self) -> Grid:
        """Present grid, which may have been enlarged."""
        return self.engine.domain.grid

    @property
    def initial_gap(self) -> FloatArray:
        """Separation of the undeformed bodies over the grid [m], shape (nx, ny)."""
        return self.engine.domain.initial_gap

    @property
    def relief1(self) -> Relief | None:
        """Relief of body 1 over the grid."""
        return self.engine.domain.relief1

    @property
    def relief2(self) -> Relief | None:
        """Relief of body 2 over the grid."""
        return self.engine.domain.relief2

    @property
    def heat(self) -> Heat:
        """Heat of the next increment; `step` can change its factor."""
        return self.engine.heat

    def step(
        self,
        *,
        load: float | None = None,
        approach: float | None = None,
        pressure: ArrayLike | None = None,
        shear: ArrayLike | None = None,
        advance: Sequence[float] = (0.0, 0.0),
        shift: Sequence[float | None] | None = None,
        tangential_load: Sequence[float | None] | None = None,
        twist: float | None = None,
        torque: float | None = None,
        heat_factor: float | Sequence[float] | None = None,
        duration: float | None = None,
    ) -> State:
        """Go one increment further, to exactly one of load, approach, or given tractions.

        Parameters
        ----------
        load, approach : float
            Total load [N], >= 0 (0: unloaded); rigid-body approach [m].
        pressure : array_like, shape (nx, ny)
            Prescribed pressure [Pa], no contact is solved; with
        shear : array_like, shape (nx, ny) or (2, nx, ny), optional
            prescribed shear s_x, or (s_x, s_y), on body 2 [Pa]; default friction * pressure.
        advance : pair of floats, optional
            How far the surfaces of body 1 and 2 move through the contact, in +x, on the way to the
            target [m]. Equal: rolling, the contact itself travels towards -x over both; different:
            sliding by the difference; one of them 0: simple sliding over the other. Their plastic
            strain moves with them, the grid stays with the contact. Whole cells are exact; see
            `State.origin` for parts of them. With `Coulomb` the difference is creepage: it adds to
            the shift along x.
        shift : pair of float, optional
            With `Coulomb`: rigid motion of body 1 over body 2 in this increment [m]. None in place
            of a number, or of both, leaves that direction to `tangential_load`.
        tangential_load : pair of float, optional
            With `Coulomb`: total force on body 2 at the end of the increment [N]. A direction of
            which nothing is told is held: shift 0.
        twist : float, optional
            With `Coulomb`: turn of body 1 over body 2 about z at the origin in this increment
            [rad]; of bodies that move on the spin times their mean way. Or
        torque : float, optional
            the moment on body 2 at its end [N m]; without both the turn is held.
        heat_factor : float or pair of floats, optional
            Of the heat from now on [m/s]; 0: the source is off.
        duration : float, optional
            Of the increment [s], > 0; goes with a `history` of the heat, whose flux is that of the
            pressure at its end, or with its `partition`.

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
        ElasticStrainWarning, SingularPressureWarning, UnitWarning, PlasticStrainWarning, \
        GridTooSmallWarning, ResolutionWarning, IncrementWarning
            Each at most once in a simulation; docs/conventions.md tells when. With
            on_border="warn" a GridTooSmallWarning takes the place of a GridTooSmallError.
        """
        given: dict[str, Any] = {"load": load, "approach": approach, "pressure": pressure}
        given |= {"shear": shear, "advance": advance, "heat_factor": heat_factor}
        given |= {"shift": shift, "tangential_load": tangential_load}
        given |= {"twist": twist, "torque": torque}
        given |= {"duration": duration}
        engine = self.engine
        step, before, core = engine.solve(given, self.monitor)
        state = engine.state_of(core, step.heat)
        if step.target and not isinstance(self.friction, Coulomb):
            try:
                require_apart(state, engine.setup.bodies, self.friction, self.tol)
            except ConvergenceError:
                steps = engine.history.steps
                engine.stand_at(before)
                engine.history.steps = steps
                raise
        engine.heat = step.heat
        if step.target and engine.hold_strain():
            state = self.state
        engine.history.add(given)
        complaints = core.warnings
        if not callable(engine.setup.surfaces.gap):
            complaints = [advised(text, engine.estimate) for text in complaints]
        self.monitor.warn(state, engine.estimate, complaints, stacklevel=2)
        warn_of(engine, self.monitor, [state], 4, self.repeated, stacklevel=2)
        return state

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
            it, with the same bits. Remove it when it is no longer needed.

        Returns
        -------
        list of State
            One per increment. When an increment fails or is interrupted (Ctrl-C), the error is
            raised with those before it in the attribute `states`, and the simulation stands at the
            last good one. The logger "samcontact" tells each (INFO) and its iterations (DEBUG).

        Raises
        ------
        ValueError
            `checkpoint` holds those of another run or of another version of this package, or a
            softening law has no identity (see `Material.with_softening`); and as `step`. A contact
            that does not fit into the grid by far is refused before the first increment.

        Warns
        -----
        UnitWarning, ResolutionWarning
            Before the first increment; at the end, of the largest load: a contact fewer than 8
            cells across, an area of spots uncertain by 10 %, a plastic zone fewer than 8 layers
            high or layers too thick to see.
        IncrementWarning
            At the end: more increments would change pressure, shear or equivalent plastic strain by
            more than 5 % of the largest; docs/theory.md, "Errors by the increments".
        """
        boolean("progress", progress)
        states: list[State] = []
        try:
            self.run_into(states, step_list("path", path, STEP), progress, checkpoint)
            moments = in_one_window(states)
            warn_of(self.engine, self.monitor, moments, 2, self.repeated, stacklevel=2)
        except BaseException as error:  # Ctrl-C too
            error.states = states  # type: ignore[attr-defined]
            raise
        return moments

    def run_into(
        self,
        states: list[State],
        steps: Sequence[Mapping[str, Any]],
        progress: bool,
        checkpoint: str | os.PathLike[str] | None,
        *,
        leave: bool = True,
    ) -> None:
        """Run a path as `run` does, and append the state of each increment once it is done."""
        engine, monitor = self.engine, self.monitor
        monitor.doubt(engine.estimate, engine.heat, largest_target(steps), stacklevel=3)
        if not any(engine.heat.shares) and (load := largest_cold_load(steps)) is not None:
            engine.make_room(load)
        with monitor.as_a_whole():
            run_into(states, engine, self.step, steps, progress, checkpoint, leave=leave)
        monitor.warn_of_run(states, engine.estimate, stacklevel=3)

    def repeated(
        self, setup: SimulationSetup, grid: Grid, heat: Heat, path: Sequence[Mapping[str, Any]]
    ) -> list[State]:
        """The states of another setup along a path, without an estimate of their errors."""
        again = type(self)(**setup.on_grid(grid, heat))
        again.monitor.checks_increments = False
        return again.run(path, progress=False)

    @property
    def state(self) -> State:
        """The present state."""
        return self.engine.state

    @property
    def counters(self) -> dict[str, int]:
        """Work done so far, as contact_solves, contact_iterations, yield_checks, plastic_solves,
        plastic_iterations, halvings, and volume_bytes (memory of plastic state and kernels)."""
        return dict(self.engine.core.counters)

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
            Any symmetric strain, tensor components xx, yy, zz, yz, xz, xy [-], in any number nz of
            layers from the surface on.
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
        terms = backstresses_of((self.body1, self.body2)[index])
        fields = plastic_fields(self.grid, strain, equivalent, backstress, terms, first)
        with self.engine.access:
            self.engine.core.set_plastic_state(index, first or 0, *fields)
        self.engine.history.forget()

    _rows = simulation_rows

    def __repr__(self) -> str:
        scene = f"{self.grid!r}, {self.body1!r}, {self.body2!r}, {self._settings}"
        return f"Simulation({scene}, heat={self.heat!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        kept, surfaces = self.engine.snapshot(), vars(self.engine.setup.surfaces)
        functions = {name: shape for name, shape in surfaces.items() if callable(shape)}
        kept = replace(kept, arguments=kept.arguments | functions)
        return _restored, (type(self), kept, self.engine.first), {"monitor": self.monitor}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a checkpoint (HDF5), replacing an old one only when the new one is complete."""
        write_checkpoint(path, self.engine.snapshot())

    @classmethod
    def load(
        cls,
        path: str | os.PathLike[str],
        softening: Sequence[Callable[[FloatArray], ArrayLike] | None] = (None, None),
        gap: Callable[[Grid], ArrayLike] | None = None,
    ) -> Simulation:
        """Read a checkpoint; going on from it gives bit-identical results on the same machine.

        softening: the laws of body 1 and 2, where they are not of `samcontact.softening`. gap: the
        function of a grid that it was, without which the grid stays as it is.

        Raises CheckpointError (a ValueError) for a file that is no checkpoint or is damaged, and
        where gap is another surface.
        """
        kept, tree = read_checkpoint(path, softening)
        if told := other_version(path, tree):
            text = f"{told}: further increments may differ in their last digits"
            warnings.warn(text, stacklevel=2)
        if gap is not None:
            kept = replace(kept, arguments=kept.arguments | {"gap": gap})
        with readable(path):
            return _restored(cls, kept)


def _restored(cls: type[Simulation], kept: Snapshot, first: Domain | None = None) -> Simulation:
    """A simulation that stands as a snapshot tells."""
    simulation = cls(**kept.arguments)
    simulation.engine.restore(kept)
    if first is not None:
        simulation.engine.first = first
    return simulation

# SPDX-License-Identifier: GPL-3.0-or-later
"""Incremental simulation of elastic-plastic contact."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from numpy.typing import ArrayLike

from .._util.checks import FloatArray, boolean, require_fast, require_type
from .._util.display import HtmlTable
from .._util.errors import attach
from .._util.travels import AT_REST
from ..bodies.layered import Body, require_bodies
from ..diagnostics.monitor import Monitor
from ..heat import Heat
from ..problem.cell_layers import require_servable_flow
from ..problem.contact_law import ContactLaw
from ..problem.domain import SurfaceGeometry
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..problem.relaxing import possible_heat
from ..problem.settings import Configured, Settings
from ..problem.setup import SimulationSetup
from ..solutions.state import State, on_common_grid
from .checkpoint import write_checkpoint
from .display import simulation_rows
from .engine import Engine
from .given_strain import Cells, add_eigenstrain, set_plastic_strain
from .increment_errors import check_errors
from .relaxing import relaxing_step
from .restoring import loaded, reduced, repeat_with
from .run import run_into
from .unfolding import run_list


class Simulation(Configured, HtmlTable):
    """Incremental simulation of the elastic-plastic contact of two bodies.

    Each increment solves contact and plastic flow together, implicitly: the plastic strain
    increment is the fixed point of residual displacement -> contact -> stress -> radial return
    (backward Euler), accelerated by Anderson mixing. An increment that does not converge is halved.

    Parameters
    ----------
    grid : Grid
        Must have layers (dz) if a body is elastic-plastic.
    body1, body2 : Material, Layered or Heterogeneous
        Upper and lower body; at most one is rigid.
    gap : array_like, shape (nx, ny), or callable
        Initial separation of the undeformed bodies [m], inf where a body is absent; or a function
        of a grid, ``lambda grid: surfaces.paraboloid(grid, R)``, to allow a larger grid; see Notes.
    friction : float or FrictionLaw, optional
        Friction law. A float is a coefficient mu >= 0 [-] for full sliding, with shear along +x on
        body 2; `Coulomb(mu)` allows partial slip, driven by `step`.
    tol : float, optional
        Tolerance of an increment [-], in [1e-11, 1): bound of the relative change of the plastic
        strain increment and of the yield violation; with inclusions at least 1e-4 (voids: 1e-3).
    increment_tol : float, optional
        Tolerance of automatic sub-increments [-], in [10 tol, 1): error of pressure and equivalent
        plastic strain relative to their maxima. Each sub-increment is solved in one step and in two
        halves, then extrapolated to second order. If more than 64 are needed, a ValueError states a
        sufficient tolerance. Default: no subdivision, first order.
    on_border : {"error", "warn"}, optional
        Action if the contact reaches the grid edge; "warn" keeps the grid as it is.
    on_stall : {"error", "warn"}, optional
        Action if partial slip of dissimilar bodies does not converge; "warn" takes the best state.
    max_iterations : int, optional
        Maximum number of fixed-point iterations before the increment is halved.
    residual_stress : {"fast", "exact"}, optional
        "fast": recurrence over layers; time and memory are proportional to the number of cells.
        "exact": influence coefficients of cuboids at cell centres, as a reference: 1 kB per cell;
        plastic strain may alternate between layers (`ResolutionWarning`) or not converge.
    image_tol : float, optional
        Limit of the relative error of "fast" due to periodic Fourier transforms, in [1e-6, 0.1].
    zones : {"auto", "one"}, optional
        Boxes of cells with plastic strain. "auto": several boxes if this saves work, e.g. on rough
        surfaces; "one": one box. The choice changes results by about 1e-3 of the residual stress.
    heat : Heat, optional
        Frictional heating. Default: none, `Heat(0.0)`.
    relief1, relief2 : Relief or callable, optional
        Topography (roughness, dents) moving with body 1 or 2, or a function from Grid to Relief.
    reach : float, optional
        Distance beyond the grid along x up to which plastic strain acts [m]. Default: grid length.
    adhesion, stiffness : ContactLaw, float, optional
        Attraction of the surfaces, e.g. `Adhesion.jkr(w)`, default none; stiffness of the machine
        that prescribes an approach [N/m], as in `ContactSolver`, default rigid.

    Raises
    ------
    ValueError, TypeError
        An argument has an invalid value or type; the message says what is allowed.
    MemoryError
        The surface (in `step` the plastic zone) requires more memory than is available.

    Notes
    -----
    If the contact reaches the edge, the grid is enlarged by cells of unchanged size, to at most 64
    times the initial number; `run` returns all states on the last grid. A periodic grid is never
    enlarged, and no grid is enlarged with heat.history, softening or attraction.
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
        friction: float | FrictionLaw = Settings.friction,
        *,
        tol: float = Settings.tol,
        increment_tol: float | None = Settings.increment_tol,
        on_border: str = Settings.on_border,
        on_stall: str = Settings.on_stall,
        max_iterations: int = Settings.max_iterations,
        residual_stress: str = Settings.residual_stress,
        image_tol: float = Settings.image_tol,
        zones: str = Settings.zones,
        heat: Heat | None = None,
        relief1: Relief | Callable[[Grid], Relief] | None = None,
        relief2: Relief | Callable[[Grid], Relief] | None = None,
        reach: float | None = Settings.reach,
        adhesion: ContactLaw = Settings.adhesion,
        stiffness: float | None = Settings.stiffness,
    ) -> None:
        require_type("grid", grid, Grid)
        require_bodies(body1, body2, inclusions=True)
        layered = require_servable_flow(grid, residual_stress, body1, body2)
        self.body1, self.body2 = body1, body2
        settings = Settings(
            friction=friction, tol=tol, increment_tol=increment_tol, on_border=on_border,
            on_stall=on_stall, max_iterations=max_iterations, residual_stress=residual_stress,
            image_tol=image_tol, zones="one" if layered else zones, adhesion=adhesion,
            reach=grid.nx * grid.dx if reach is None else reach, stiffness=stiffness,
        )  # fmt: skip
        self._configure(settings)
        require_fast("residual_stress", self.residual_stress, grid.periodic)
        heat = possible_heat(heat, (body1, body2), grid, settings)
        self.monitor = Monitor(adhesion_warned=not adhesion.varies)
        surfaces = SurfaceGeometry(gap, relief1, relief2)
        self.engine = Engine(SimulationSetup(body1, body2, surfaces, settings), grid, heat)
        self.engine.estimate.prepare(heat)

    @property
    def grid(self) -> Grid:
        """Current grid, which may have been enlarged."""
        return self.engine.domain.grid

    @property
    def initial_gap(self) -> FloatArray:
        """Separation of the undeformed bodies over the grid [m], shape (nx, ny)."""
        return self.engine.domain.initial_gap

    @property
    def relief1(self) -> Relief | None:
        """Moving surface topography of body 1 over the grid."""
        return self.engine.domain.relief1

    @property
    def relief2(self) -> Relief | None:
        """Moving surface topography of body 2 over the grid."""
        return self.engine.domain.relief2

    @property
    def heat(self) -> Heat:
        """Frictional heating of the next increment; `step` can change its factor."""
        return self.engine.heat

    def step(
        self,
        *,
        load: float | None = None,
        approach: float | None = None,
        pressure: ArrayLike | None = None,
        shear: ArrayLike | None = None,
        advance: ArrayLike = AT_REST,
        shift: Sequence[float | None] | None = None,
        tangential_load: Sequence[float | None] | None = None,
        twist: float | None = None,
        torque: float | None = None,
        heat_factor: float | Sequence[float] | None = None,
        duration: float | None = None,
        moment: Sequence[float | None] | None = None,
        tilt: Sequence[float | None] | None = None,
    ) -> State:
        """Advance by one increment under load control, approach control or prescribed pressure.

        Parameters
        ----------
        load, approach : float
            Normal load [N], >= 0 or, with attraction, >= minus the attractive force; approach [m].
        pressure : array_like, shape (nx, ny)
            Prescribed pressure [Pa], without load and approach; the contact is not solved.
        shear : array_like, shape (nx, ny) or (2, nx, ny), optional
            Shear s_x, or (s_x, s_y), on body 2 [Pa], with `pressure`; default friction * pressure.
        advance : pair of floats, or pair of pairs, optional
            Displacement of the surfaces of bodies 1 and 2 through the contact [m], positive along
            +x: equal for rolling towards -x, different for sliding by the difference (creepage with
            `Coulomb`). Plastic strain moves with the body. Fractions of a cell: `State.origin`.
            ((x1, y1), (x2, y2)) adds motion along y: whole cells with `Coulomb` or plastic strain.
        shift : pair of floats, optional
            With `Coulomb`: tangential displacement of body 1 relative to body 2 in this increment
            [m]. None for a component leaves that direction to `tangential_load`.
        tangential_load : pair of floats, optional
            With `Coulomb`: final force on body 2 [N]. Directions without force or shift are held.
        twist : float, optional
            With `Coulomb`: rotation of body 1 relative to body 2 about z in this increment [rad].
        torque : float, optional
            Final moment about z on body 2 [N m]. Without twist and torque: no rotation.
        heat_factor : float or pair of floats, optional
            New heat flux per unit pressure, from this increment on [m/s]; 0 for no heating.
        duration : float, optional
            Duration of the increment [s]: >= 0 with viscoelastic bodies, which move by whole cells;
            > 0 with `heat.partition`, `heat.history` (unloaded: 0 is allowed) or `FallingCoulomb`.
        moment, tilt : pair of floats, optional
            As in `ContactSolver.solve`, at the end of the increment; if omitted, the tilt is kept.

        Returns
        -------
        State

        Raises
        ------
        ValueError
            Invalid arguments, or GridTooSmallError if the contact reaches the grid edge.
        ConvergenceError, PullOffError
            No convergence, or pull-off; has `iterations`, `residual`. Errors keep the old state.
        MemoryError
            The plastic zone requires more memory than is available.
        RuntimeError
            An increment is already in progress, in another thread or from a softening law.

        Warns
        -----
        ElasticStrainWarning, SingularPressureWarning, UnitWarning, PlasticStrainWarning, \
        GridTooSmallWarning, ResolutionWarning, IncrementWarning
            Each is issued at most once per simulation; docs/conventions.md lists the conditions.
            With on_stall="warn", each increment without convergence issues a ConvergenceWarning.
        """
        given = {
            "load": load, "approach": approach, "pressure": pressure, "shear": shear, "tilt": tilt,
            "advance": advance, "shift": shift, "tangential_load": tangential_load, "twist": twist,
            "torque": torque, "heat_factor": heat_factor, "duration": duration, "moment": moment,
        }  # fmt: skip
        state, found = self.engine.advance(given, self.monitor)
        self.monitor.warn(state, self.engine.estimate, found, stacklevel=2)
        check_errors(self.engine, self.monitor, [state], 4, repeat_with(type(self)), stacklevel=2)
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
            Arguments of each step, e.g. from `samcontact.paths`; or `paths.Retraction`.
        progress : bool, optional
            Show a progress bar, or at most ten lines if there is no terminal.
        checkpoint : path, optional
            Folder for checkpoints. A repeated call resumes the run.

        Returns
        -------
        list of State
            One per increment. An error or interrupt (Ctrl-C) holds the completed states in its
            attribute `states`. The logger "samcontact" records increments and iterations.

        Raises
        ------
        ValueError
            `checkpoint` belongs to another run or version of this package, a softening law cannot
            be identified (see `Material.with_softening`), or `step` raises this error.

        Warns
        -----
        UnitWarning, ResolutionWarning, IncrementWarning
            Issued before the first increment or at the end, at stricter limits than in `step`.
        """
        boolean("progress", progress)
        states: list[State] = []
        try:
            steps = run_list("path", path)
            run_into(states, self.engine, self.monitor, self.step, steps, progress, checkpoint)
            found = on_common_grid(states)
            check_errors(self.engine, self.monitor, found, 2, repeat_with(type(self)), stacklevel=2)
        except BaseException as error:  # Ctrl-C too
            attach(error, states=states)
            raise
        return found

    def relax(self, hold: str | None = None) -> State:
        """Advance viscoelastic bodies to their long-time state, at an unchanged time.

        hold: "load" or "approach", kept constant; default: as in the last step. Raises ValueError
        without a viscoelastic body, or for a fluid. `State.viscous_work` assumes a slow advance.
        """
        return self.step(**relaxing_step(self.engine, hold))

    @property
    def state(self) -> State:
        """Current state."""
        return self.engine.state

    @property
    def counters(self) -> dict[str, int]:
        """Counts of contact_solves, contact_iterations, yield_checks, plastic_solves, halvings,
        plastic_iterations, joint_steps; volume_bytes: memory of kernels and strains."""
        return dict(self.engine.core.counters)

    def set_plastic_strain(
        self,
        body: int,
        strain: ArrayLike,
        equivalent: ArrayLike | None = None,
        backstress: ArrayLike | None = None,
        first: int | None = None,
    ) -> None:
        """Set the plastic strain of an elastic-plastic body.

        Raises ValueError for a wrong shape, and for values that are infinite, NaN or out of range.

        Parameters
        ----------
        body : {1, 2}
        strain : array_like, shape (6, nx, ny, nz)
            Strain xx, yy, zz, yz, xz, xy [-], in any number of layers from the surface.
        equivalent : array_like, shape (nx, ny, nz), optional
            Accumulated equivalent plastic strain [-], >= 0; default 0.
        backstress : array_like, shape (terms, 6, nx, ny, nz), optional
            Deviators of kinematic hardening [Pa], as from `State.backstress`; default 0.
        first : int, optional
            Grid row along x at which these fields begin, possibly negative. They may then have any
            length along x: ``set_plastic_strain(2, track.plastic_strain(), first=track.first)``.
        """
        set_plastic_strain(self.engine, body, strain, equivalent, backstress, first)

    def add_eigenstrain(
        self, body: int, strain: ArrayLike, first: Cells = (0, 0, 0), cells: Cells | None = None
    ) -> None:
        """Add an eigenstrain (misfit, swelling, transformation) to a body that is not rigid.

        It acts from the next increment on and moves with the body: see `State.eigenstress`. Raises
        ValueError for cells outside the grid, a grid without dz, a rigid body or non-finite strain.

        Parameters
        ----------
        body : {1, 2}
        strain : array_like, shape (6, nx, ny, nz) or (6,)
            Tensor components xx, yy, zz, yz, xz, xy [-] in the cells of a box, with any trace; six
            numbers are a uniform strain in `cells`. It adds to earlier eigenstrains.
        first : tuple of int, optional
            First cell of the box along x, y and z; the box may lie below the surface.
        cells : tuple of int, optional
            Numbers of cells (nx, ny, nz) of the box. Only with uniform strain.
        """
        add_eigenstrain(self.engine, body, strain, first, cells)

    _rows = simulation_rows

    def __repr__(self) -> str:
        setup_text = f"{self.grid!r}, {self.body1!r}, {self.body2!r}, {self._settings}"
        return f"Simulation({setup_text}, heat={self.heat!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return reduced(type(self), self.engine, self.monitor)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a checkpoint (HDF5). An old file is only replaced when the new one is complete."""
        write_checkpoint(path, self.engine.snapshot())

    @classmethod
    def load(
        cls,
        path: str | os.PathLike[str],
        softening: Sequence[Any] = (None, None),
        gap: Callable[[Grid], ArrayLike] | None = None,
    ) -> Simulation:
        """Load a checkpoint. On the same machine, further results are bit-identical.

        softening: laws of bodies 1 and 2, if not from `samcontact.softening`; of a layered body, a
        list of laws from the surface down. gap: the same function of a grid as before; if missing,
        the grid is not enlarged. Raises CheckpointError (a ValueError) for an unusable file.
        """
        return loaded(cls, path, softening, gap)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Solver for the elastic contact of two half-spaces."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util import memory
from .._util.checks import FloatArray, exactly_one, finite_array, require_type
from .._util.errors import ConvergenceWarning, GridTooSmallWarning
from .._util.travels import AT_REST
from ..bodies.free_faces import contact_strip
from ..bodies.layered import Body, require_bodies
from ..bodies.viscoelastic import require_no_relaxation
from ..diagnostics import adhesion, hertz_estimate, resolution, sharp_edges, yield_check
from ..heat import Heat
from ..problem.contact_law import ContactLaw
from ..problem.domain import Domain, SurfaceGeometry, require_consistent_overlap
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.heating import NO_HEAT, heating, require_heat_of, require_reference
from ..problem.settings import ContactSettings, memory_of_contact
from ..solutions.contact_solution import ContactSolution, ShearedSolution, fits
from .border_advice import add_border_remedies, advised
from .enlargement import counts_for, explain_failed_enlargement
from .fields import ContactFields
from .interpenetration import require_apart
from .normal_drive import NormalDrive
from .tangential_drive import Pressing, TangentialDriver, at_pace, tangential_drive

LOOSEST_ADHESIVE = 1e-7
"""Maximum tolerance with adhesion. Above it, repulsion cannot be distinguished from errors."""


class ContactSolver(ContactFields):
    """Solver for the elastic contact of two half-spaces, with or without friction.

    Tractions are convolved with the exact influence coefficients of Love and Cerruti by FFT. An
    active-set method with a spectral preconditioner finds the pressure, starting on coarser grids.
    Friction given as a number means full sliding along x: the shear mu p acts on body 2 in +x and
    on body 1 in -x. `Coulomb` allows partial slip; the shear is then an unknown, like the pressure.
    If shear displaces the surfaces normally (dissimilar materials), the coupling is iterated to
    convergence.

    Parameters
    ----------
    grid : Grid
    body1, body2 : Material or Layered
        Upper and lower body; at most one is rigid. Plastic materials are treated as elastic.
    friction : float or Coulomb, optional
        Friction law. A float is a coefficient mu >= 0 [-] for full sliding along x; `Coulomb(mu)`
        allows partial slip.
    tol : float, optional
        Tolerance on the complementarity error `ContactSolution.error` [-], in [1e-13, 1).
    on_border : {"error", "warn"}, optional
        Action if the contact reaches the edge of a grid that cannot be enlarged: raise
        `GridTooSmallError` or issue `GridTooSmallWarning`.
    on_stall : {"error", "warn"}, optional
        Action if pressure and shear of dissimilar bodies in partial slip do not converge: raise
        `ConvergenceError`, or issue `ConvergenceWarning` and return the state with the smallest
        error.
    max_iterations : int, optional
        Maximum number of iterations for the pressure, and maximum number of Newton steps for
        pressure and shear together.
    heat : Heat, optional
        Frictional heating; `history` is not supported. Default: no heating, `Heat(0.0)`.
    adhesion : ContactLaw, optional
        Attraction of the surfaces across the gap: a law of `Adhesion`, or `TensileLimit`. Default:
        no attraction, `HardContact()`. Friction acts on the repulsive part of the pressure only.
        Attraction acts over the whole grid, which is then not enlarged.
    stiffness : float, optional
        Stiffness of the machine that prescribes an approach [N/m], with a law of `Adhesion`: the
        approach of the bodies is the prescribed approach minus load/stiffness. Default: rigid.

    Raises
    ------
    ValueError, TypeError
        An argument has an invalid value or type. The message gives its name, its value and the
        allowed range.
    MemoryError
        The grid requires more memory than is available. Checked before allocation.
    """

    def __init__(
        self,
        grid: Grid,
        body1: Body,
        body2: Body,
        friction: float | FrictionLaw = ContactSettings.friction,
        *,
        tol: float = ContactSettings.tol,
        on_border: str = ContactSettings.on_border,
        on_stall: str = ContactSettings.on_stall,
        max_iterations: int = ContactSettings.max_iterations,
        heat: Heat | None = None,
        adhesion: ContactLaw = ContactSettings.adhesion,
        stiffness: float | None = ContactSettings.stiffness,
    ) -> None:
        require_type("grid", grid, Grid)
        require_bodies(body1, body2)
        require_no_relaxation(
            "a single contact has no duration; use Simulation, or the body without relaxation",
            body1,
            body2,
        )
        settings = ContactSettings(
            friction, tol, on_border, on_stall, max_iterations, adhesion, stiffness
        )
        self._configure(
            settings,
            grid=grid,
            body1=body1,
            body2=body2,
            heat=NO_HEAT if heat is None else heat,
        )
        self._law = settings.law
        if heat is not None:
            self._require_possible(heat)
        require_heat_of(self._law, self.heat)
        self._heating = heating(self.heat, (body1, body2), grid)
        cell = memory_of_contact(self._law, (body1, body2), self.heat)
        memory.require_for_grid("a contact", grid, memory.surface(grid, cell))
        self._core = self._new_core()

    def _require_possible(self, heat: Heat) -> None:
        """Raise TypeError or ValueError for heat that a single contact does not support."""
        require_type("heat", heat, Heat)
        remedies = {"history": "set time, or", "partition": "a single contact has no duration;"}
        for name, instead in remedies.items():
            if (given := getattr(heat, name)) is not None:
                raise ValueError(
                    f"heat.{name} must be None for a single contact, got {given!r}: {instead} use "
                    "Simulation"
                )
        if self._law.sticks and any(heat.factor):
            raise ValueError(
                f"heat.factor must be 0 in a ContactSolver with partial slip, got {heat.factor!r} "
                f"and friction = {self.friction!r}: use Simulation"
            )
        self.adhesion.require_possible(heat, {})

    def _new_core(self) -> Any:
        """Return the solver of the compiled core."""
        setup = self.grid._core, self.body1._core, self.body2._core
        adhesion = self.adhesion.resolved(self.grid, self.body1, self.body2)
        law, contact = self._law.to_core(), adhesion.to_core()
        if self._law.sticks:
            return _core.PartialSlipContact(*setup, law, contact)
        return _core.ContactSolver(*setup, law, self._heating, contact)

    def __repr__(self) -> str:
        return (
            f"ContactSolver({self.grid!r}, {self.body1!r}, {self.body2!r}, {self._settings}, "
            f"heat={self.heat!r})"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self.grid, self.body1, self.body2, self._settings.arguments(), self.heat)

    def solve(
        self,
        gap: ArrayLike | Callable[[Grid], ArrayLike],
        *,
        load: float | None = None,
        approach: float | None = None,
        moment: Sequence[float | None] | None = None,
        tilt: Sequence[float | None] | None = None,
        shift: Sequence[float | None] | None = None,
        tangential_load: Sequence[float | None] | None = None,
        twist: float | None = None,
        torque: float | None = None,
        previous: ShearedSolution | None = None,
        advance: Sequence[float] = AT_REST,
        initial_pressure: ArrayLike | None = None,
        duration: float | None = None,
        slip_rate: float | None = None,
    ) -> ContactSolution:
        """Solve the contact for a given load or approach.

        With `Coulomb` friction, one call is one increment of the loading history.

        Parameters
        ----------
        gap : array_like, shape (nx, ny), or callable
            Initial separation of the undeformed bodies [m], inf where one body is absent; or a
            function that returns this array for a grid. With a function, the solution is on an
            enlarged grid if the grid of the solver does not contain the contact, as in a
            `Simulation`; the solver keeps its own grid.
        load : float
            Normal load [N], >= 0; with attraction, >= minus the maximum tensile force.
        approach : float
            Rigid-body approach at the origin of the grid [m]. Exactly one of load and approach must
            be given.
        moment : pair of float, optional
            Moment about x and y on body 2 at the origin of the grid [N m], together with `load`: a
            load that acts at (x, y) has the moment (load y, -load x). The tilt is then computed.
            There is no equilibrium if the load acts beyond the edge of the bodies. None for an
            axis: see `tilt`. If the grid is periodic along x, give no moment or tilt about y, and
            vice versa.
        tilt : pair of float, optional
            Rotation of body 1 relative to body 2 about x and y [rad], which lowers body 1 by
            tilt[0] y - tilt[1] x. Without moment and tilt for an axis, the tilt about it is zero.
        shift : pair of float, optional
            With `Coulomb`: tangential rigid-body displacement of body 1 relative to body 2 in this
            increment [m]. `None` for a component, or for both, means that `tangential_load`
            prescribes the force in that direction.
        tangential_load : pair of float, optional
            With `Coulomb`: force on body 2 at the end of the increment [N], smaller than mu times
            the load. A direction without prescribed force or displacement is held fixed (zero
            shift).
        twist : float, optional
            With `Coulomb`: rotation of body 1 relative to body 2 about z at the origin, in this
            increment [rad]. Mutually exclusive with `torque`.
        torque : float, optional
            Moment about z on body 2 at the end of the increment [N m]. If neither `twist` nor
            `torque` is given, rotation is prevented.
        previous : PartialSlipSolution or RollingSolution, optional
            With `Coulomb`: solution of the preceding increment, from which load and shear change
            together. If omitted, the normal load is applied first and the tangential load second.
            To apply both together from zero, pass the solution for load=0.
        advance : pair of float, optional
            With `Coulomb` and `previous`: displacements s_1, s_2 of both surfaces through the
            contact, positive along +x [m]. The contact rolls towards +x by -(s_1 + s_2)/2, a whole
            number of cells. s_1 - s_2, at most one cell, is added to the shift along x, unless a
            force along x is prescribed.
        initial_pressure : array_like, shape (nx, ny), optional
            Initial pressure of the iteration [Pa]. A good initial pressure, such as the solution
            for a similar gap or load, saves the solutions on coarser grids and most iterations. If
            the iteration does not converge from this pressure, the solve is repeated without it.
            With `Adhesion`, the initial pressure selects one of several solutions, and the solve is
            not repeated.
        duration : float, optional
            Duration of the increment [s], with friction that depends on the slip rate
            (`FallingCoulomb`).
        slip_rate : float, optional
            With `duration`: initial slip rate of all cells in the iteration [m/s], >= 0, which
            selects one of several solutions. Default: the slip rate of `previous`, or 0. By
            default, an increment that may have several solutions is rejected.

        Returns
        -------
        ContactSolution
            A `PartialSlipSolution` with `Coulomb`.

        Raises
        ------
        ValueError
            Invalid arguments, or a tangential load or torque above the friction limit;
            GridTooSmallError if the contact reaches the edge of the grid.
        ConvergenceError
            No convergence; the error has the attributes `iterations` and `residual`. PullOffError
            if the prescribed tension exceeds the maximum tension that can be reached by continuous
            change from the initial pressure.

        Warns
        -----
        ResolutionWarning
            The contact is fewer than 8 cells across, or the area of several contact spots is
            uncertain by more than 10 %.
        ElasticStrainWarning
            The maximum pressure exceeds half the contact modulus, or a body treated as elastic
            would yield under this pressure.
        SingularPressureWarning
            The pressure rises towards a sharp edge, at which the pressure between elastic bodies
            is unbounded.
        UnitWarning
            Before the solve: the Hertz estimate is far outside the range of the grid, or material
            constants are implausible. The message names the quantity that is probably in another
            unit.
        GridTooSmallWarning
            With on_border="warn", instead of a GridTooSmallError.
        ConvergenceWarning
            With on_stall="warn", instead of a ConvergenceError: `converged` is False.
        """
        self.adhesion.require_possible(self.heat, {"advance": advance}, sticks=self._law.sticks)
        drive = tangential_drive(
            self._law, shift, tangential_load, twist, torque, previous, advance, self.grid
        )
        drive = at_pace(drive, self._law, duration, slip_rate)
        name = exactly_one(load=load, approach=approach)
        normal = NormalDrive.of(
            name, load if approach is None else approach, moment, tilt, spring=self._settings.spring
        )
        return solve_driven(self, gap, normal, drive, initial_pressure)

    def _over(self, counts: Sequence[int]) -> ContactSolver:
        """Return a copy of this solver for a grid with other numbers of cells along x and y."""
        grid = replace(self.grid, nx=counts[0], ny=counts[1])
        return _made(grid, self.body1, self.body2, self._settings.arguments(), self.heat)

    def _solved_from(
        self,
        start: FloatArray | None,
        window: Domain,
        normal: NormalDrive,
        drive: TangentialDriver,
    ) -> tuple[ContactSolution, str]:
        """Return the solution, and a message if the contact reaches the grid edge ("" if not).

        If the iteration from `start` does not converge, it is repeated without `start`.
        """
        contact = window.initial_gap, normal.to_core()
        try:
            return self._solved(contact, drive, start)
        except _core.ConvergenceError:
            # with adhesion, the start selects one of several solutions
            if start is None or self.adhesion.varies:
                raise
            return self._solved(contact, drive, None)

    def _solved(
        self, contact: Pressing, drive: TangentialDriver, start: FloatArray | None
    ) -> tuple[ContactSolution, str]:
        tol = min(self.tol, LOOSEST_ADHESIVE) if self.adhesion.varies else self.tol
        settings = tol, self.max_iterations, self.on_border == "error"
        if self._law.sticks:
            accepts = self.on_stall == "warn"
            return drive.solved(self._core, self.grid, contact, start, (*settings, accepts))
        found = self._core.solve(*contact, start, *settings)
        complaint, bodies = found.pop("border_complaint"), (self.body1, self.body2)
        solution = ContactSolution(grid=self.grid, **found)
        require_apart(solution, bodies, self._law, tol)
        return solution, complaint


def _made(
    grid: Grid, body1: Body, body2: Body, settings: dict[str, Any], heat: Heat
) -> ContactSolver:
    return ContactSolver(grid, body1, body2, heat=heat, **settings)


def solve_driven(  # warnings show the line two calls up
    initial: ContactSolver,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    normal: NormalDrive,
    drive: TangentialDriver,
    initial_pressure: ArrayLike | None = None,
) -> ContactSolution:
    """Solve the contact for a normal and a tangential drive."""
    target = normal.target
    if normal.name == "approach":
        require_reference(initial.heat)
    start = None
    if initial_pressure is not None:
        start = finite_array("initial_pressure", initial_pressure, initial.grid.surface_shape)
        # tiny values would cause a division by zero
        start = np.where(np.abs(start) > 1e-75, start, 0.0)
    surfaces, solver, bodies = SurfaceGeometry(gap), initial, (initial.body1, initial.body2)
    if callable(gap) and drive.previous is not None and not fits(drive.previous, initial.grid):
        solver = initial._over(drive.previous.grid.surface_shape)
    window = surfaces.over(solver.grid, contact_strip(bodies))
    pulled = initial.adhesion.attracts
    setup = hertz_estimate.ContactSetup(window.grid, window.initial_gap, bodies, pulled)
    finding = setup.warn_of_units(
        initial.heat, target, is_loaded=drive.previous is not None, stacklevel=3
    )
    while True:
        try:
            solution, complaint = solver._solved_from(start, window, normal, drive)
            break
        except _core.ConvergenceError as error:
            hertz_estimate.explain_digits(error, setup.gap)
            raise
        except _core.GridTooSmallError as error:
            hertz_estimate.explain_size(error, setup.hertz(**target))
            if not callable(gap) and not initial.grid.periodic:
                add_border_remedies(error, setup)
            if not callable(gap) or initial.grid.periodic or pulled:
                raise
            with explain_failed_enlargement(error, window.grid):
                counts = counts_for(error, initial.grid, setup, **target)
                solver, before = initial._over(counts), window
                window = surfaces.over(solver.grid, contact_strip(bodies))
                require_consistent_overlap(window, before)
            setup = hertz_estimate.ContactSetup(window.grid, window.initial_gap, bodies, pulled)
            start = None
    if isinstance(solution, ShearedSolution) and not solution.converged:
        warnings.warn(solution.stall_text, ConvergenceWarning, stacklevel=3)
    if complaint:
        text = complaint if callable(gap) else advised(complaint, setup)
        warnings.warn(text, GridTooSmallWarning, stacklevel=3)
    if finding is None or not finding.of_contact:
        resolution.warn_of_contact(solution, setup, stacklevel=3)
    resolution.warn_of_strain(solution, setup, stacklevel=3)
    yield_check.warn_of_yield(solution, bodies, initial._law, stacklevel=3)
    adhesion.warn_of_adhesion(initial.adhesion, solution, bodies, initial._law, stacklevel=3)
    if sharp_edges.may_have_edge(solution, setup):
        edge = sharp_edges.edge_of(solution, bodies, window.initial_gap)
        sharp_edges.warn_of_edge(solution, edge, stacklevel=3)
    return solution

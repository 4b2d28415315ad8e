# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact of two half-spaces."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util import memory
from .._util.checks import FloatArray, exactly_one, finite_array, number, require_type
from .._util.errors import GridTooSmallWarning
from ..bodies.layered import Body, require_bodies
from ..diagnostics import hertz_estimate, resolution, sharp_edges, yield_check
from ..heat import Heat
from ..scene.contact_law import ContactLaw
from ..scene.domain import Domain, SurfaceGeometry, require_continued
from ..scene.friction import FrictionLaw
from ..scene.grid import Grid
from ..scene.heating import COLD, heating, require_heat_of, require_reference
from ..scene.settings import ContactSettings, memory_of_contact
from ..solutions.contact_solution import ContactSolution, ShearedSolution, fits
from .border_advice import advised, told_of_fixed
from .enlargement import counts_for, told_in
from .fields import ContactFields
from .interpenetration import require_apart
from .tangential_drive import Drive, Pressing, tangential_drive


class ContactSolver(ContactFields):
    """Contact of two elastic half-spaces with friction.

    Exact Love and Cerruti coefficients, discrete convolution by FFT, active sets with a spectral
    preconditioner, started from coarser grids. Friction as a number is gross sliding along x: the
    shear mu p acts on body 2 in +x and on body 1 in -x. With `Coulomb` the bodies stick and slip;
    shear is solved for as pressure is. Where the elastic constants couple shear to the normal
    displacement, the coupling is iterated to convergence.

    Parameters
    ----------
    grid : Grid
    body1, body2 : Material or Layered
        Upper and lower body; at most one is rigid. Plastic materials act elastically here.
    friction : float or Coulomb, optional
        Coefficient of friction mu >= 0 [-]: gross sliding along x. `Coulomb(mu)`: stick and slip.
    tol : float, optional
        Stop when the complementarity error (see ContactSolution.error) is below, in [1e-13, 1).
    on_border : {"error", "warn"}, optional
        What a contact does that touches the border of a grid that cannot grow.
    max_iterations : int, optional
    heat : Heat, optional
        Frictional heat, without a `history`; default none, `Heat(0.0)`.
    contact_law : ContactLaw, optional
        How far the pressure may fall at a gap; default `HardContact()`, p >= 0. Friction goes with
        the repulsion alone. Bodies that attract each other do so all over the grid, which is not
        enlarged.

    Raises
    ------
    ValueError, TypeError
        An argument out of range or of the wrong kind; the text names it, its value and what is
        allowed.
    MemoryError
        The grid needs more memory than is available, told before any is taken.
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
        max_iterations: int = ContactSettings.max_iterations,
        heat: Heat | None = None,
        contact_law: ContactLaw = ContactSettings.contact_law,
    ) -> None:
        require_type("grid", grid, Grid)
        require_bodies(body1, body2)
        self.grid = grid
        self.body1 = body1
        self.body2 = body2
        settings = ContactSettings(friction, tol, on_border, max_iterations, contact_law)
        self._configure(settings)
        self._law = settings.law
        self.heat = COLD if heat is None else heat
        require_type("heat", self.heat, Heat)
        for name, instead in (("history", "give time, or"), ("partition", "slip takes time,")):
            if (given := getattr(self.heat, name)) is not None:
                raise ValueError(
                    f"heat.{name} must be None for a single contact, got {given!r}: {instead} use "
                    "Simulation"
                )
        require_heat_of(self._law, self.heat)
        self.contact_law.require_possible(self.heat, {})
        self._heating = heating(self.heat, (body1, body2), grid)
        cell = memory_of_contact(self._law, (body1, body2), self.heat)
        memory.require_for_grid("a contact", grid, memory.surface(grid, cell))
        scene = grid._core, body1._core.stack, body2._core.stack
        law, contact = self._law.to_core(), self.contact_law.to_core()
        if self._law.sticks:
            self._core = _core.PartialSlipContact(*scene, law, contact)
        else:
            self._core = _core.ContactSolver(*scene, law, self._heating, contact)

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
        shift: Sequence[float | None] | None = None,
        tangential_load: Sequence[float | None] | None = None,
        twist: float | None = None,
        torque: float | None = None,
        previous: ShearedSolution | None = None,
        advance: Sequence[float] = (0.0, 0.0),
        initial_pressure: ArrayLike | None = None,
    ) -> ContactSolution:
        """Solve for a load or an approach; with `Coulomb`, one increment of a history.

        Parameters
        ----------
        gap : array_like, shape (nx, ny), or callable
            Initial separation of the undeformed bodies [m], inf where one of them is not; or a
            function of a grid that returns it. Then the solution is that on a larger grid where
            that of the solver does not hold the contact, as in a `Simulation`; the solver keeps its
            own.
        load : float
            Total load [N], >= 0, or at least the largest tension that the contact law bears; or
        approach : float
            Rigid-body approach [m]; exactly one of the two.
        shift : pair of float, optional
            With `Coulomb`: rigid motion of body 1 over body 2 in this increment [m]. None in place
            of a number, or of both, leaves that direction to `tangential_load`.
        tangential_load : pair of float, optional
            With `Coulomb`: total force on body 2 at the end of the increment [N]; its length is
            less than mu times the load. A direction of which nothing is told is held: shift 0.
        twist : float, optional
            With `Coulomb`: turn of body 1 over body 2 about z at the origin in this increment
            [rad]; or
        torque : float, optional
            the moment on body 2 at its end [N m]; without both the turn is held.
        previous : StickSlipSolution or RollingSolution, optional
            With `Coulomb`: the end of the increment before, from which load and shear go on
            together. Without it the bodies are pressed first, then sheared; the solution for
            load=0 is the start of a path on which both begin together.
        advance : pair of float, optional
            With `Coulomb` and `previous`: ways s_1, s_2 of both surfaces towards +x through the
            contact [m]: it rolls towards +x by -(s_1 + s_2)/2, a whole number of cells. s_1 - s_2,
            at most a cell, adds to the shift along x (none where a force is given there).
        initial_pressure : array_like, shape (nx, ny), optional
            Start of the iteration [Pa]; a good one, such as the solution for a similar gap or load,
            saves the coarser grids and most steps; where one leads nowhere, there is another try
            without.

        Returns
        -------
        ContactSolution
            With `Coulomb` a `StickSlipSolution`.

        Raises
        ------
        ValueError
            Bad arguments, a tangential load or torque beyond what friction holds;
            GridTooSmallError when the contact touches the border of the grid.
        ConvergenceError
            With .iterations and .residual.

        Warns
        -----
        ResolutionWarning
            The contact is fewer than 8 cells across, or the area of several spots uncertain by more
            than 10 %.
        ElasticStrainWarning
            The largest pressure is more than half the contact modulus, or a body that yields would
            do so under it: it acts elastically here.
        SingularPressureWarning
            The pressure rises to a sharp edge, where that of elastic bodies has no limit.
        UnitWarning
            Before the solve: what Hertz expects is far off the grid, or the
            material cannot be; with the quantity that is likely in another unit.
        GridTooSmallWarning
            With on_border="warn", where there would be a GridTooSmallError.
        """
        self.contact_law.require_possible(self.heat, {"advance": advance})
        drive = tangential_drive(
            self._law, shift, tangential_load, twist, torque, previous, advance, self.grid
        )
        return solve_driven(self, gap, load, approach, drive, initial_pressure)

    def _over(self, counts: Sequence[int]) -> ContactSolver:
        """The same on a grid of other counts."""
        grid = replace(self.grid, nx=counts[0], ny=counts[1])
        return _made(grid, self.body1, self.body2, self._settings.arguments(), self.heat)

    def _solved_from(
        self,
        start: FloatArray | None,
        window: Domain,
        driver: str,
        value: float,
        drive: Drive,
    ) -> tuple[ContactSolution, str]:
        """The solution and what is to be said of the border, without a start that leads nowhere."""
        contact = window.initial_gap, driver == "load", value
        try:
            return self._solved(contact, drive, start)
        except _core.ConvergenceError:
            if start is None:
                raise
            return self._solved(contact, drive, None)

    def _solved(
        self, contact: Pressing, drive: Drive, start: FloatArray | None
    ) -> tuple[ContactSolution, str]:
        settings = self.tol, self.max_iterations, self.on_border == "error"
        if self._law.sticks:
            return drive.solved(self._core, self.grid, contact, start, settings)
        found = self._core.solve(*contact, start, *settings)
        complaint, bodies = found.pop("border_complaint"), (self.body1, self.body2)
        solution = ContactSolution(grid=self.grid, **found)
        require_apart(solution, bodies, self._law, self.tol)
        return solution, complaint


def _made(
    grid: Grid, body1: Body, body2: Body, settings: dict[str, Any], heat: Heat
) -> ContactSolver:
    return ContactSolver(grid, body1, body2, heat=heat, **settings)


def solve_driven(  # warnings name the caller's caller
    asked: ContactSolver,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    load: float | None,
    approach: float | None,
    drive: Drive,
    initial_pressure: ArrayLike | None = None,
) -> ContactSolution:
    """Solve the contact for a load or an approach, with what drives it along the surface."""
    driver = exactly_one(load=load, approach=approach)
    value = number(driver, load if approach is None else approach)
    if driver == "approach":
        require_reference(asked.heat)
    start = None
    if initial_pressure is not None:
        start = finite_array("initial_pressure", initial_pressure, asked.grid.surface_shape)
        # numbers that mean nothing beside any load would divide by zero
        start = np.where(np.abs(start) > 1e-75, start, 0.0)
    surfaces, solver = SurfaceGeometry(gap), asked
    if callable(gap) and drive.previous is not None and not fits(drive.previous, asked.grid):
        solver = asked._over(drive.previous.grid.surface_shape)
    window, bodies = surfaces.over(solver.grid), (asked.body1, asked.body2)
    pulled = asked.contact_law.attracts
    scene = hertz_estimate.ContactSetup(window.grid, window.initial_gap, bodies, pulled)
    doubted = scene.doubted(asked.heat, {"load": load, "approach": approach}, stacklevel=3)
    while True:
        try:
            solution, complaint = solver._solved_from(start, window, driver, value, drive)
            break
        except _core.ConvergenceError as error:
            hertz_estimate.explain_digits(error, scene.gap)
            raise
        except _core.GridTooSmallError as error:
            hertz_estimate.explain_size(error, scene.hertz(load, approach))
            if not callable(gap) and not asked.grid.periodic:
                told_of_fixed(error, scene)
            if not callable(gap) or asked.grid.periodic or pulled:
                raise
            with told_in(error, window.grid):
                counts = counts_for(error, asked.grid, scene, load, approach)
                solver, before = asked._over(counts), window
                window = surfaces.over(solver.grid)
                require_continued(window, before)
            scene = hertz_estimate.ContactSetup(window.grid, window.initial_gap, bodies, pulled)
            start = None
    if complaint:
        text = complaint if callable(gap) else advised(complaint, scene)
        warnings.warn(text, GridTooSmallWarning, stacklevel=3)
    if doubted is None or not doubted.of_contact:
        resolution.warn_of_contact(solution, scene, stacklevel=3)
    resolution.warn_of_strain(solution, scene, stacklevel=3)
    yield_check.warn_of_yield(solution, bodies, asked._law, stacklevel=3)
    if sharp_edges.may_have_edge(solution, scene):
        edge = sharp_edges.edge_of(solution, bodies, window.initial_gap)
        sharp_edges.warn_of_edge(solution, edge, stacklevel=3)
    return solution

# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady rolling: elastic bodies with creepage, and viscoelastic bodies."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._util.checks import FloatArray, exactly_one, require_type
from ._util.short_text import in_short
from .bodies.layered import Body, require_bodies
from .bodies.viscoelastic import relaxes
from .contact.creeping_rolling import (
    CreepingRest,
    Motion,
    Tractions,
    intermediate,
    roll_creeping,
)
from .contact.moving import (
    MovingContactSolver,
    pressure_of,
    require_moving,
    speed_of,
)
from .contact.normal_drive import NormalDrive
from .contact.solver import ContactSolver, solve_driven
from .contact.tangential_drive import UNSHEARED, Pressing, Settings, TangentialInput
from .problem.friction import FrictionLaw, lasting, sticking_law
from .problem.grid import Grid
from .problem.settings import ContactSettings
from .solutions.contact_solution import ContactSolution, RollingSolution, before_on
from .solutions.moving_solution import FreeRollingSolution

__all__ = ["steady"]


def steady(
    grid: Grid,
    body1: Body,
    body2: Body,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float | None = None,
    approach: float | None = None,
    friction: FrictionLaw | float,
    creepage: Sequence[float | None] | None = None,
    spin: float | None = None,
    tangential_load: Sequence[float | None] | None = None,
    torque: float | None = None,
    speed: float | None = None,
    start: RollingSolution | FreeRollingSolution | None = None,
    tol: float = ContactSettings.tol,
    on_border: str = ContactSettings.on_border,
    on_stall: str = ContactSettings.on_stall,
    max_iterations: int = ContactSettings.max_iterations,
) -> RollingSolution | FreeRollingSolution:
    """Solve the contact in steady rolling towards +x.

    To within the tolerance, the solution is the limit of a sequence of `ContactSolver.solve` calls.
    In each call, both bodies advance by -d, where d is the cell length, with a rigid slip of d (xi
    - phi y, eta + phi x); xi, eta and phi are the creepages and the spin.

    Parameters
    ----------
    grid : Grid
        Grid that is not periodic along x. `periodic="y"` models rollers in plane strain. Without
        it, a single row of cells is a strip of width dy.
    body1, body2 : Material or Layered
        Upper and lower body; at most one is rigid. Plastic materials are treated as elastic.
    gap : array_like, shape (nx, ny), or callable
        Initial separation [m], or a function of a grid that returns this array, as in
        `ContactSolver`.
    load : float
        Normal load [N], >= 0.
    approach : float
        Rigid-body approach [m]. Exactly one of load and approach must be given.
    friction : friction law, or 0.0
        Friction law; `Coulomb(math.inf)` prevents slip, as in Kalker's linear theory. 0.0: rolling
        without shear; one body must be viscoelastic.
    creepage : pair of float, optional
        xi, eta: rigid slip of body 1 relative to body 2 along x and y, per distance rolled [-].
        `None` for a component, or for both, leaves that direction to `tangential_load`.
    spin : float, optional
        phi: rotation of body 1 relative to body 2 about z at the origin, per distance rolled
        [1/m]. Not on a periodic grid. Cannot be combined with `torque`.
    tangential_load : pair of float, optional
        Force on body 2 along x and y [N], smaller than mu times the load.
    torque : float, optional
        Moment about z on body 2 [N m]. A direction without a prescribed creepage, spin, force or
        torque has zero creepage.
    speed : float, optional
        Speed of the surfaces through the contact [m/s]: with viscoelastic bodies, >= 0 (0: both
        bodies have their long-time moduli); with friction that depends on the slip rate
        (`FallingCoulomb`), > 0. Otherwise the solution does not depend on the speed.
    start : RollingSolution or FreeRollingSolution, optional
        Solution for similar creepages, forces or speed, used as initial guess of the iteration.
    tol, on_border, on_stall, max_iterations
        As in `ContactSolver`; `tol` is also a bound of the error of the shear traction, and of the
        error of prescribed forces relative to their maximum possible values.

    Returns
    -------
    RollingSolution, or FreeRollingSolution of viscoelastic bodies without friction

    Raises
    ------
    ValueError, TypeError
        Invalid arguments or forces above the friction limit, as for `ContactSolver.solve`. With
        viscoelastic bodies: no speed, a fluid, or free faces.
    ConvergenceError
        No convergence; the error has the attributes `iterations` and `residual`.

    Warns
    -----
    ConvergenceWarning
        With on_stall="warn", instead of a ConvergenceError: `converged` is False.

    Notes
    -----
    J. J. Kalker (1990), Three-Dimensional Elastic Bodies in Rolling Contact. The steps are one cell
    long, so the error is proportional to the cell size. docs/theory/rolling.md describes the
    iteration. The creep of viscoelastic bodies includes the whole track behind the contact. Creep
    and tractions are computed in turn, each from the other, until the tractions no longer change.
    """
    require_type("grid", grid, Grid)
    require_bodies(body1, body2)
    name = exactly_one(load=load, approach=approach)
    normal = NormalDrive.of(name, load if approach is None else approach)
    settings: dict[str, Any] = {
        "tol": tol, "on_border": on_border, "max_iterations": max_iterations
    }  # fmt: skip
    creeps = relaxes(body1, body2)
    if creeps and type(friction) in (int, float) and friction == 0:
        _require_free(creepage=creepage, spin=spin, tangential_load=tangential_load, torque=torque)
        _require_rolling(grid, None, None)
        free = _free_solver(grid, require_moving(body1, body2), _rolls(speed), settings)
        pressed = None if start is None else pressure_of(start, FreeRollingSolution)
        return cast("FreeRollingSolution", solve_driven(free, gap, normal, UNSHEARED, pressed))
    law = sticking_law(friction)
    pace = _rolls(speed) if creeps else lasting(law, speed, "speed")
    if law.varies_along_x:
        raise ValueError(
            f"friction must not vary along x in steady rolling, got {in_short(law)}: such "
            "friction has no steady state; use Simulation"
        )
    if start is not None and not isinstance(start, RollingSolution):
        raise TypeError(f"start must be a samcontact.RollingSolution, got {in_short(start)}")
    given = TangentialInput.of(
        {"creepage": creepage, "spin": spin},
        {"tangential_load": tangential_load, "torque": torque},
    )
    _require_rolling(grid, spin, torque)
    elastic, creep = (body1, body2), None
    if creeps:
        bodies = require_moving(body1, body2)
        elastic = intermediate(body1, pace, grid), intermediate(body2, pace, grid)

        def creep(cells: Grid) -> CreepingRest:
            return CreepingRest(cells, bodies, elastic, pace)

    solver = ContactSolver(grid, *elastic, law, on_stall=on_stall, **settings)
    solution = solve_driven(solver, gap, normal, _Rolling(given, law, start, pace, creep))
    assert isinstance(solution, RollingSolution)
    return solution


def _require_free(**tangential: Any) -> None:
    """Raise ValueError if tangential arguments are given without friction."""
    for name, value in tangential.items():
        if value is not None:
            raise ValueError(
                f"{name} must be None with friction = 0.0, got {in_short(value)}: give a friction "
                "law, e.g. Coulomb(0.3)"
            )


def _rolls(speed: Any) -> float:
    """Return the rolling speed of viscoelastic bodies [m/s], after checks."""
    if speed is None:
        raise ValueError(
            "speed must be given with viscoelastic bodies [m/s]: their contact depends on it"
        )
    rolls = speed_of("speed", speed)
    if rolls < 0:
        raise ValueError(f"speed must be >= 0 [m/s], got {rolls!r}: the contact rolls towards +x")
    return rolls


def _free_solver(
    grid: Grid, bodies: tuple[Body, Body], rolls: float, settings: dict[str, Any]
) -> MovingContactSolver:
    def finish(cells: Grid, _: FloatArray, found: dict[str, Any]) -> FreeRollingSolution:
        return FreeRollingSolution(grid=cells, speed=rolls, **found)

    return MovingContactSolver(grid, bodies, (-rolls, -rolls), finish, **settings)


def _require_rolling(grid: Grid, spin: float | None, torque: float | None) -> None:
    """Raise ValueError if the grid does not allow steady rolling along x, or rotation about z."""
    if grid.along_x:
        raise ValueError(
            f"grid.periodic must be '' or 'y' (plane strain), got {grid.periodic!r}: steady "
            "rolling along x requires undeformed material ahead of the contact"
        )
    for name, value in (("spin", spin), ("torque", torque)):
        if value is not None and grid.along_y and (value != 0 or name == "torque"):
            raise ValueError(
                f"{name} must be None with grid.periodic = {grid.periodic!r}, got {value!r}: a "
                "surface periodic along y cannot rotate about z"
            )


@dataclass(frozen=True)
class _Rolling:
    """Solver of a contact in steady rolling under given creepages, spin, forces or torque."""

    given: TangentialInput
    friction: FrictionLaw
    previous: RollingSolution | None
    speed: float = 0.0
    """Rolling speed [m/s]; 0 for friction that does not depend on the slip rate."""
    creep: Callable[[Grid], CreepingRest] | None = None
    """Function that creates the additional displacement of viscoelastic bodies for a grid."""

    def solved(
        self,
        core: _core.PartialSlipContact,
        grid: Grid,
        contact: Pressing,
        start: FloatArray | None,
        settings: Settings,
    ) -> tuple[ContactSolution, str]:
        """Return the solution, and a message if the contact reaches the edge of the grid."""
        shear, creepage = None, (0.0, 0.0, 0.0)
        if self.previous is not None:
            start, shear, *_ = before_on(self.previous, grid, "start")
            creepage = (*self.previous.creepage, self.previous.spin)
        drive = self.given.is_force, self.given.values
        (gap, normal), (tol, most, refuse, accept) = contact, settings
        lasts = 1 / self.speed if self.speed else 0.0

        def roll(
            gap: FloatArray, start: Tractions, motion: Motion, tol: float, moved: FloatArray | None
        ) -> dict[str, Any]:
            return core.roll(
                gap, normal, *drive, *start, motion, tol, most, refuse, accept, lasts, moved
            )

        if self.creep is None:
            found = roll(gap, (start, shear), creepage, tol, None)
        else:
            first = (start, shear), creepage
            found = roll_creeping(self.creep(grid), roll, gap, tol, first)
        return self._solution(grid, found)

    def _solution(self, grid: Grid, found: dict[str, Any]) -> tuple[RollingSolution, str]:
        complaint = found.pop("border_complaint")
        *creepage, spin = found.pop("motion")
        *force, torque = found.pop("force")
        del found["fallbacks"], found["energy_gap"]
        fields = {
            "creepage": np.array(creepage),
            "spin": spin,
            "friction": self.friction,
            "friction_work_per_distance": found.pop("friction_work"),
            "tangential_load": np.array(force),
            "torque": torque,
        }
        return RollingSolution(grid=grid, **fields, **found), complaint

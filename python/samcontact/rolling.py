# SPDX-License-Identifier: GPL-3.0-or-later
"""Rolling with creepage: the steady state of elastic bodies that roll over each other."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._util.checks import FloatArray, require_type
from .bodies.material import Material
from .contact.solver import ContactSolver, solve_driven
from .contact.tangential_drive import GivenAlong, Pressing, Settings
from .scene.friction import FrictionLaw, sticking_law
from .scene.grid import Grid
from .scene.settings import ContactSettings
from .solutions.contact_solution import ContactSolution, RollingSolution, before_on

__all__ = ["steady"]


def steady(
    grid: Grid,
    body1: Material,
    body2: Material,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float | None = None,
    approach: float | None = None,
    friction: FrictionLaw,
    creepage: Sequence[float | None] | None = None,
    spin: float | None = None,
    tangential_load: Sequence[float | None] | None = None,
    torque: float | None = None,
    start: RollingSolution | None = None,
    tol: float = ContactSettings.tol,
    on_border: str = ContactSettings.on_border,
    max_iterations: int = ContactSettings.max_iterations,
) -> RollingSolution:
    """Solve the steady state of a contact that rolls towards +x.

    It is the end of a history of `ContactSolver.solve` with advance = -d (1, 1) and the slip
    d (xi - phi y, eta + phi x) in each step of d, to the tolerance where d is a cell.

    Parameters
    ----------
    grid : Grid
        Not periodic along x. `periodic="y"`: rollers in plane strain; without it a grid of one
        row of cells is a strip of the width dy.
    body1, body2 : Material
        Upper and lower body; at most one is rigid. Plastic materials act elastically here.
    gap : array_like, shape (nx, ny), or callable
        Initial separation [m], or a function of a grid that returns it, as in `ContactSolver`.
    load : float
        Total load [N], >= 0; or
    approach : float
        Rigid-body approach [m]; exactly one of the two.
    friction : Coulomb
        `Coulomb(math.inf)`: no slip, Kalker's linear theory.
    creepage : pair of float, optional
        xi, eta: rigid slip of body 1 over body 2 along x and y per way rolled [-]. None in place of
        a number, or of both, leaves that direction to `tangential_load`.
    spin : float, optional
        phi: turn of body 1 over body 2 about z at the origin per way rolled [1/m], not on a
        periodic grid; or
    tangential_load : pair of float, optional
        Force on body 2 along x and y [N], its length less than mu times the load;
    torque : float, optional
        The moment on body 2 [N m]. A direction of which nothing is told has no creepage.
    start : RollingSolution, optional
        One of similar creepages or forces, from which the iteration starts.
    tol, on_border, max_iterations
        As in `ContactSolver`; tol also bounds the error of the shear, and that of given forces
        over the largest ones.

    Returns
    -------
    RollingSolution

    Raises
    ------
    ValueError, TypeError
        Bad arguments, forces beyond what friction holds, as for `ContactSolver.solve`.
    ConvergenceError
        With .iterations and .residual.

    Notes
    -----
    J. J. Kalker (1990), Three-Dimensional Elastic Bodies in Rolling Contact, in steps of one cell:
    the error is in proportion to the cell. See the theory page for the iteration.
    """
    require_type("grid", grid, Grid)
    sticking_law(friction)
    if start is not None:
        require_type("start", start, RollingSolution)
    given = GivenAlong.of(
        {"creepage": creepage, "spin": spin},
        {"tangential_load": tangential_load, "torque": torque},
    )
    _require_rolling(grid, spin, torque)
    solver = ContactSolver(
        grid,
        body1,
        body2,
        friction,
        tol=tol,
        on_border=on_border,
        max_iterations=max_iterations,
    )
    solution = solve_driven(solver, gap, load, approach, _Rolling(given, friction, start))
    assert isinstance(solution, RollingSolution)
    return solution


def _require_rolling(grid: Grid, spin: float | None, torque: float | None) -> None:
    """Raise ValueError where the grid has no steady rolling along x, or no turn about z."""
    if grid.along_x:
        raise ValueError(
            f"grid.periodic must be '' or 'y' (plane strain), got {grid.periodic!r}: a contact "
            "rolls along x onto material that has not been in it"
        )
    for name, value in (("spin", spin), ("torque", torque)):
        if value is not None and grid.along_y and (value != 0 or name == "torque"):
            raise ValueError(
                f"{name} must be left out with grid.periodic = {grid.periodic!r}, got {value!r}: a "
                "surface that repeats along y cannot turn about z"
            )


@dataclass(frozen=True)
class _Rolling:
    """Drives a contact that rolls steadily."""

    given: GivenAlong
    friction: FrictionLaw
    previous: RollingSolution | None

    def solved(
        self,
        core: _core.PartialSlipContact,
        grid: Grid,
        contact: Pressing,
        start: FloatArray | None,
        settings: Settings,
    ) -> tuple[ContactSolution, str]:
        """The solution, and what is to be said of the border."""
        shear, creepage = None, (0.0, 0.0, 0.0)
        if self.previous is not None:
            start, shear, *_ = before_on(self.previous, grid, "start")
            creepage = (*self.previous.creepage, self.previous.spin)
        drive = self.given.is_force, self.given.values
        tol, most, refuse = settings
        found = core.roll(*contact, *drive, start, shear, creepage, tol, most, refuse)
        return self._solution(grid, found)

    def _solution(self, grid: Grid, found: dict[str, Any]) -> tuple[RollingSolution, str]:
        complaint = found.pop("border_complaint")
        *creepage, spin = found.pop("motion")
        *force, torque = found.pop("force")
        del found["fallbacks"], found["energy_gap"]
        told = {
            "creepage": np.array(creepage),
            "spin": spin,
            "friction": self.friction,
            "work_per_way": found.pop("friction_work"),
            "tangential_load": np.array(force),
            "torque": torque,
        }
        return RollingSolution(grid=grid, **told, **found), complaint

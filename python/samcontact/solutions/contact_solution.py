# SPDX-License-Identifier: GPL-3.0-or-later
"""Solutions of elastic contacts."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from .._util.display import HtmlTable, Rows, ShortRepr, quantity
from ..problem.contact_law import in_contact
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from .contact_area import contact_area
from .outline import Outline, outline_of

Before = tuple[FloatArray, FloatArray, FloatArray | None, float, tuple[float, float]]
"""Pressure, shear, gap (None if unknown), approach and tilt at the end of an increment."""


@dataclass(frozen=True, repr=False, eq=False)  # arrays have no truth value
class ContactSolution(ShortRepr, HtmlTable):
    """Solution of an elastic contact.

    Attributes
    ----------
    grid : Grid
        Grid of the fields: the grid of the solver, or an enlarged grid.
    pressure : ndarray, shape (nx, ny)
        Contact pressure [Pa], >= 0; with attraction a of the contact law, >= -a.
    repulsion : ndarray, shape (nx, ny)
        Contact pressure plus attraction [Pa], >= 0; without attraction, the pressure.
    gap : ndarray, shape (nx, ny)
        Separation under load [m]; zero, to the accuracy `error`, where the repulsion is positive.
    approach : float
        Rigid-body approach at the origin of the grid [m].
    tilt : ndarray, shape (2,)
        Rotation of body 1 relative to body 2 about x and y [rad]: body 1 is lowered by
        ``approach + tilt[0] * y - tilt[1] * x``.
    load : float
        Normal load [N].
    moment : ndarray, shape (2,)
        Moment of the pressure on body 2 about x and y at the origin of the grid [N m]: the sums of
        ``p y`` and ``-p x`` over the area.
    iterations : int
        Conjugate-gradient iterations on this grid; iterations on coarser grids are not counted.
    operator_applications : int
        Number of exact displacement evaluations on the grid, each a pair of zero-padded transforms.
        With coupled friction, evaluations for the shear are included.
    work : float
        Computing work of all transforms of the solve, including transforms for the preconditioner,
        for approximate displacements and on coarser grids, in units of one exact displacement
        evaluation [-].
    error : float
        Complementarity error [-]: maximum of ``|min(r/max r, g/max u)|`` over all cells, for the
        repulsion r, gap g and displacement u.
    converged : bool
        Whether error <= tol; if not, ConvergenceError is raised unless on_stall="warn".
    """

    grid: Grid
    pressure: FloatArray
    repulsion: FloatArray
    gap: FloatArray
    approach: float
    tilt: FloatArray
    load: float
    moment: FloatArray
    iterations: int
    operator_applications: int
    work: float
    error: float
    converged: bool

    @cached_property
    def outline(self) -> Outline:
        """Outline of the contact in cells of the grid."""
        return outline_of(self.repulsion, self.grid.periodic)

    @property
    def in_contact(self) -> NDArray[np.bool_]:
        """Whether each cell is in contact, shape (nx, ny)."""
        return in_contact(self.repulsion)

    @property
    def adhesion_stress(self) -> FloatArray:
        """Attraction between the surfaces, repulsion minus pressure [Pa], >= 0, shape (nx, ny)."""
        found: FloatArray = self.repulsion - self.pressure
        return found

    @property
    def contact_area(self) -> float:
        """Contact area [m^2], with the contact edge located within cells, see `contact_area`."""
        grid = self.grid
        gap = self.gap if self.outline.rises else None
        return contact_area(self.repulsion, grid.cell_area, grid.periodic, gap)

    def _rows(self) -> Rows:
        return [
            ("load", quantity(self.load, "N")),
            ("approach", quantity(self.approach, "m")),
            *rows_of_tilt(self.tilt, self.moment),
            ("maximum pressure", quantity(float(self.pressure.max()), "Pa")),
            ("contact area", quantity(self.contact_area, "m²")),
            ("cells in contact", f"{np.count_nonzero(self.in_contact)} of {self.pressure.size}"),
            ("iterations", str(self.iterations)),
            ("work", quantity(self.work)),
            ("error", quantity(self.error)),
            ("converged", "yes" if self.converged else "no"),
        ]


@dataclass(frozen=True, repr=False, eq=False)
class ShearedSolution(ContactSolution):
    """Base class of solutions with friction and partial slip; see `PartialSlipSolution`."""

    shear: FloatArray
    slip: FloatArray
    sticking: NDArray[np.bool_]
    tangential_load: FloatArray
    torque: float
    tangential_error: float
    sweeps: int
    joint_steps: int
    tangential_iterations: int
    tangential_applications: int
    tangential_work: float
    slip_rate: FloatArray | None = field(default=None, kw_only=True)
    falling_number: float = field(default=0.0, kw_only=True)
    plastic_slip: FloatArray | None = field(default=None, kw_only=True)

    @property
    def stall_text(self) -> str:
        """Message that the solution has not converged."""
        error = max(self.error, self.tangential_error)
        steps = f" and {self.joint_steps} joint Newton steps" if self.joint_steps else ""
        return (
            f"pressure and shear did not converge in {self.sweeps} alternating solutions{steps}: "
            f"the result is the state with the smallest error, {error:.2g}; reduce the "
            "tangential force or the size of the increment, or increase tol"
        )

    def _rows(self) -> Rows:
        return [
            *super()._rows(),
            ("tangential load", both(self.tangential_load, "N")),
            ("torque", quantity(self.torque, "N m")),
            *self._motion(),
            ("sticking cells", str(np.count_nonzero(self.sticking))),
            ("shear error", quantity(self.tangential_error)),
        ]

    def _motion(self) -> Rows:
        return []


@dataclass(frozen=True, repr=False, eq=False)
class PartialSlipSolution(ShearedSolution):
    """Solution of a contact with partial slip; a kind of `ContactSolution`.

    Attributes
    ----------
    shear : ndarray, shape (2, nx, ny)
        Shear traction along x and y on body 2 [Pa], reversed on body 1. Its magnitude is at most
        the bound of the friction law, which is mu p for Coulomb friction.
    slip : ndarray, shape (2, nx, ny)
        Slip of body 1 relative to body 2 in this increment [m]; zero where the surfaces stick or
        are separated.
    sticking : ndarray of bool, shape (nx, ny)
        Contact cells that do not slip in this increment.
    tangential_load : ndarray, shape (2,)
        Force along x and y on body 2 [N].
    torque : float
        Moment of the shear traction on body 2 about z at the origin of the grid [N m].
    shift : ndarray, shape (2,)
        Tangential rigid-body displacement of body 1 relative to body 2 along x and y, accumulated
        over all increments [m].
    twist : float
        Rotation of body 1 relative to body 2 about z at the origin, accumulated over all increments
        [rad].
    friction_work : float
        Frictional dissipation, accumulated over all increments [J].
    tangential_error : float
        Natural residual of the slip conditions [-]: the shear traction is shifted in the direction
        of the slip and limited to its bound, e.g. mu p. The residual is the resulting change of the
        shear traction, relative to the maximum of the bound or to ten times the maximum shear,
        whichever is smaller.
        With dissimilar materials this residual refers to the final pressure, and `error` is the
        complementarity error of the pressure for the final shear.
    energy_gap : float
        Error bound of the shear traction, as an energy [J]. Over the computed slip, any admissible
        shear traction dissipates at most `energy_gap` more than the computed shear traction. The
        elastic energy of the error in the shear traction is at most half of `energy_gap`. NaN for
        infinite friction.
    sweeps : int
        Number of alternating solutions for pressure and for shear; 1 if pressure and shear are
        uncoupled.
    joint_steps : int
        Number of Newton steps for pressure and shear together; 0 if the alternating solutions
        converged.
    tangential_iterations : int
        Number of iterations of the linear solves for the shear on the finest grid.
    tangential_applications : int
        Number of evaluations of the displacement due to shear, on the bounding box of the contact;
        each requires two pairs of transforms.
    tangential_work : float
        Computing work of all transforms for the shear, including transforms for the preconditioner
        and on coarser grids, in units of one evaluation of the shear displacement [-].
    slip_rate : ndarray, shape (nx, ny), or None
        With `FallingCoulomb`: slip rate that determines the friction of each cell [m/s].
    falling_number : float
        With `FallingCoulomb`: maximum of -dmu/dv p C/t over all cells [-], where mu is the
        coefficient of friction at the slip rate v, p the pressure, C the displacement of a cell
        under its own unit shear and t the duration of the increment. If this number is below 1 at
        all slip rates, the solution of the increment is unique.
    plastic_slip : ndarray, shape (nx, ny), or None
        With a `ThirdBody` that hardens: plastic slip accumulated in the layer between the bodies
        [m].
    """

    shift: FloatArray
    twist: float
    friction_work: float
    energy_gap: float

    def _motion(self) -> Rows:
        return [
            ("shift", both(self.shift, "m")),
            ("twist", quantity(self.twist, "rad")),
            ("frictional work", quantity(self.friction_work, "J")),
        ]


@dataclass(frozen=True, repr=False, eq=False)
class RollingSolution(ShearedSolution):
    """Solution of a contact in steady rolling; a kind of `ContactSolution`.

    Attributes
    ----------
    creepage : ndarray, shape (2,)
        Rigid slip of body 1 relative to body 2 along x and y, per distance rolled [-].
    spin : float
        Rotation of body 1 relative to body 2 about z, per distance rolled [1/m].
    friction : FrictionLaw
        Friction law.
    slip : ndarray, shape (2, nx, ny)
        Slip of body 1 relative to body 2 per distance rolled [-]; zero where the surfaces stick or
        are separated.
    friction_work_per_distance : float
        Frictional dissipation per distance rolled [J/m].
    shear, sticking, tangential_load, torque
        As in `PartialSlipSolution`, which also describes the errors and iteration counts.
    """

    creepage: FloatArray
    spin: float
    friction: FrictionLaw
    friction_work_per_distance: float

    @property
    def rolling_resistance(self) -> float:
        """Moment that resists the rolling [N m], the integral of pressure times x.

        It is zero if both bodies are elastic and the gap is symmetric; see `FreeRollingSolution`.
        """
        return -float(self.moment[1])

    def _motion(self) -> Rows:
        return [
            ("creepage", both(self.creepage, "")),
            ("spin", quantity(self.spin, "1/m")),
            ("frictional work per distance", quantity(self.friction_work_per_distance, "J/m")),
        ]


def both(values: FloatArray, unit: str) -> str:
    """Format two numbers; a number that is negligible compared with the other is shown as zero."""
    small = 1e-9 * float(np.abs(values).max())
    return ", ".join(quantity(float(v) if abs(v) > small else 0.0, unit) for v in values)


def rows_of_tilt(tilt: FloatArray, moment: FloatArray) -> Rows:
    """Return table rows of tilt and moment about x and y; no rows if the tilt is zero."""
    if not np.any(tilt):
        return []
    return [("tilt", both(tilt, "rad")), ("moment", both(moment, "N m"))]


def fits(solution: ContactSolution, grid: Grid) -> bool:
    """Whether a grid is that of a solution, possibly enlarged equally on opposite sides."""
    own = solution.grid
    more = [n - m for n, m in zip(grid.surface_shape, own.surface_shape, strict=True)]
    same = (grid.dx, grid.dy, grid.periodic) == (own.dx, own.dy, own.periodic)
    return same and all(n >= 0 and n % 2 == 0 for n in more)


def before_on(solution: ShearedSolution, grid: Grid, name: str = "previous") -> Before:
    """Return pressure, shear, gap, approach and tilt of a solution on an equal or enlarged grid.

    Fields are 0 in added cells; the gap is None if there are any. Raises ValueError unless the grid
    `fits` the solution, which the message calls `name`.
    """
    if not fits(solution, grid):
        raise ValueError(
            f"{name} must be a solution on the given grid, {grid!r}, or on a central part of it "
            f"with the same cell size and periodic directions, got a solution on {solution.grid!r}"
        )
    margins = [
        ((n - m) // 2, (n - m) // 2)
        for n, m in zip(grid.surface_shape, solution.grid.surface_shape, strict=True)
    ]
    p, s = np.pad(solution.pressure, margins), np.pad(solution.shear, [(0, 0), *margins])
    known = grid.surface_shape == solution.grid.surface_shape
    tilt = float(solution.tilt[0]), float(solution.tilt[1])
    return p, s, solution.gap if known else None, solution.approach, tilt


def slip_rate_on(solution: ShearedSolution, grid: Grid) -> FloatArray | None:
    """Return the slip rate of a solution on an equal or enlarged grid [m/s], or None."""
    return _centred_on(solution.slip_rate, solution.grid, grid)


def plastic_slip_on(solution: ShearedSolution, grid: Grid) -> FloatArray | None:
    """Return the plastic slip of a solution on an equal or enlarged grid [m], or None."""
    return _centred_on(solution.plastic_slip, solution.grid, grid)


def _centred_on(field: FloatArray | None, before: Grid, grid: Grid) -> FloatArray | None:
    """Return a field on a larger grid with the same centre, padded with 0 beyond `before`."""
    if field is None:
        return None
    margins = [
        ((n - m) // 2, (n - m) // 2)
        for n, m in zip(grid.surface_shape, before.surface_shape, strict=True)
    ]
    return np.pad(field, margins)

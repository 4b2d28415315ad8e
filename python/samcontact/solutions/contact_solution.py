# SPDX-License-Identifier: GPL-3.0-or-later
"""Solutions of elastic contacts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from .._util.display import Brief, Rows, Shown, quantity
from ..scene.contact_law import in_contact
from ..scene.friction import FrictionLaw
from ..scene.grid import Grid
from .contact_area import contact_area
from .outline import Outline, outline_of

Before = tuple[FloatArray, FloatArray, FloatArray | None, float]
"""Pressure, shear, gap and approach at the end of an increment; None: not known."""


@dataclass(frozen=True, repr=False, eq=False)  # arrays have no truth value
class ContactSolution(Brief, Shown):
    """Solution of one elastic contact.

    Attributes
    ----------
    grid : Grid
        Of the fields: that of the solver, or a larger one.
    pressure : ndarray, shape (nx, ny)
        Contact pressure [Pa], >= 0; less, down to minus the attraction of the contact law.
    repulsion : ndarray, shape (nx, ny)
        What is left of the pressure beside the attraction [Pa], >= 0; without any, the pressure.
    gap : ndarray, shape (nx, ny)
        Separation under load [m], zero (to `error`) where the repulsion is positive.
    approach : float
        Rigid-body approach of the bodies [m].
    load : float
        Total load [N].
    iterations : int
        Conjugate-gradient steps on the grid; the start from coarser grids is not counted.
    operator_applications : int
        Exact displacements computed on the grid, each a pair of zero-padded transforms (with
        coupled friction, those of the shear included).
    work : float
        All transforms of the solve, those of the preconditioner, of its cheap displacements and of
        coarser grids included, in units of one exact displacement [-].
    error : float
        Largest violation of r >= 0, g >= 0, r g = 0 for the repulsion r: largest size of
        min(r/max r, g/max u) [-].
    converged : bool
        Whether error <= tol (a solve that is not raises ConvergenceError).
    """

    grid: Grid
    pressure: FloatArray
    repulsion: FloatArray
    gap: FloatArray
    approach: float
    load: float
    iterations: int
    operator_applications: int
    work: float
    error: float
    converged: bool

    @cached_property
    def outline(self) -> Outline:
        """Outline of the contact in the cells of the grid."""
        return outline_of(self.repulsion, self.grid.periodic)

    @property
    def in_contact(self) -> NDArray[np.bool_]:
        """Cells in contact, shape (nx, ny)."""
        return in_contact(self.repulsion)

    @property
    def contact_area(self) -> float:
        """Contact area [m^2], with its edge between the cells; see the theory page."""
        grid = self.grid
        gap = self.gap if self.outline.rises else None
        return contact_area(self.repulsion, grid.cell_area, grid.periodic, gap)

    def _rows(self) -> Rows:
        return [
            ("load", quantity(self.load, "N")),
            ("approach", quantity(self.approach, "m")),
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
    """What solutions with Coulomb friction share; see `StickSlipSolution`."""

    shear: FloatArray
    slip: FloatArray
    sticking: NDArray[np.bool_]
    tangential_load: FloatArray
    torque: float
    tangential_error: float
    sweeps: int
    tangential_iterations: int
    tangential_applications: int
    tangential_work: float

    def _rows(self) -> Rows:
        return [
            *super()._rows(),
            ("tangential load", both(self.tangential_load, "N")),
            ("torque", quantity(self.torque, "N m")),
            *self._motion(),
            ("cells that stick", str(np.count_nonzero(self.sticking))),
            ("error of the shear", quantity(self.tangential_error)),
        ]

    def _motion(self) -> Rows:
        return []


@dataclass(frozen=True, repr=False, eq=False)
class StickSlipSolution(ShearedSolution):
    """Solution of one contact that sticks and slips by Coulomb's law; also a `ContactSolution`.

    Attributes
    ----------
    shear : ndarray, shape (2, nx, ny)
        Along x and y, on body 2 [Pa]; reversed on body 1. Its length is at most mu p.
    slip : ndarray, shape (2, nx, ny)
        Of body 1 over body 2 in this increment [m]; zero where the bodies stick or do not touch.
    sticking : ndarray of bool, shape (nx, ny)
        Cells in contact that do not slip in this increment.
    tangential_load : ndarray, shape (2,)
        Force along x and y on body 2 [N].
    torque : float
        On body 2 about z at the origin [N m].
    shift : ndarray, shape (2,)
        Rigid motion of body 1 over body 2 along x and y since the first increment [m].
    twist : float
        Turn of body 1 over body 2 about z at the origin since then [rad].
    friction_work : float
        Turned into heat since then [J].
    tangential_error : float
        Natural residual of stick and slip: by how much the shear changes when it is moved along its
        slip and cut at mu p, relative to the largest mu p, or to ten times the largest shear where
        that is less [-]. With unlike bodies it is that for the final pressure, and `error` that of
        the pressure for the final shear.
    energy_gap : float
        What friction could still turn over with these slips [J]: twice the elastic energy of the
        error of the shear is less. NaN where friction is infinite.
    sweeps : int
        Between pressure and shear; 1 where they do not act on each other.
    tangential_iterations : int
        Steps of the linear solves for the shear on the finest grid.
    tangential_applications : int
        Displacements of shear computed on the box of the contact, each two pairs of transforms.
    tangential_work : float
        All transforms for the shear, those of the preconditioner and of coarser grids included, in
        units of such a displacement [-].
    """

    shift: FloatArray
    twist: float
    friction_work: float
    energy_gap: float

    def _motion(self) -> Rows:
        return [
            ("shift", both(self.shift, "m")),
            ("twist", quantity(self.twist, "rad")),
            ("friction work", quantity(self.friction_work, "J")),
        ]


@dataclass(frozen=True, repr=False, eq=False)
class RollingSolution(ShearedSolution):
    """Solution of one contact that rolls steadily; also a `ContactSolution`.

    Attributes
    ----------
    creepage : ndarray, shape (2,)
        Rigid slip of body 1 over body 2 along x and y per way rolled [-].
    spin : float
        Turn of body 1 over body 2 about z per way rolled [1/m].
    friction : Coulomb
        Friction law.
    slip : ndarray, shape (2, nx, ny)
        Of body 1 over body 2 per way rolled [-]; zero where the bodies stick or do not touch.
    work_per_way : float
        Turned into heat per way rolled [J/m].
    shear, sticking, tangential_load, torque
        As in `StickSlipSolution`, and so are errors and counts.
    """

    creepage: FloatArray
    spin: float
    friction: FrictionLaw
    work_per_way: float

    def _motion(self) -> Rows:
        return [
            ("creepage", both(self.creepage, "")),
            ("spin", quantity(self.spin, "1/m")),
            ("friction work per way", quantity(self.work_per_way, "J/m")),
        ]


def both(values: FloatArray, unit: str) -> str:
    """Two numbers, rounding beside the other as zero."""
    small = 1e-9 * float(np.abs(values).max())
    return ", ".join(quantity(float(v) if abs(v) > small else 0.0, unit) for v in values)


def fits(solution: ContactSolution, grid: Grid) -> bool:
    """Whether a grid has the cells of the solution, or more around them."""
    own = solution.grid
    more = [n - m for n, m in zip(grid.surface_shape, own.surface_shape, strict=True)]
    same = (grid.dx, grid.dy, grid.periodic) == (own.dx, own.dy, own.periodic)
    return same and all(n >= 0 and n % 2 == 0 for n in more)


def before_on(solution: ShearedSolution, grid: Grid, name: str = "previous") -> Before:
    """Pressure, shear, gap and approach on a grid that fits; ValueError, with the name of the
    argument, for others."""
    if not fits(solution, grid):
        raise ValueError(
            f"{name} must be a solution on the same cells, got one on {solution.grid!r} for "
            f"{grid!r}"
        )
    margins = [
        ((n - m) // 2, (n - m) // 2)
        for n, m in zip(grid.surface_shape, solution.grid.surface_shape, strict=True)
    ]
    p, s = np.pad(solution.pressure, margins), np.pad(solution.shear, [(0, 0), *margins])
    known = grid.surface_shape == solution.grid.surface_shape
    return p, s, solution.gap if known else None, solution.approach

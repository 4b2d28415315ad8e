# SPDX-License-Identifier: GPL-3.0-or-later
"""Rolling with creepage: the steady state of elastic bodies that roll over each other."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._checks import FloatArray, require_type
from ._settings import ContactSettings
from .contact import ContactSolver
from .friction import Coulomb, GivenAlong, Pressing, Settings
from .grid import Grid
from .material import Material
from .solution import ContactSolution, RollingSolution, before_on

__all__ = ["steady"]

_MOST_SOLVES = 60
_SMALL = 1e-3
"""Creepage over one at which all slips, where a contact answers in proportion."""
_STEP = 0.02
"""Of the creepage, for differences."""


def steady(
    grid: Grid,
    body1: Material,
    body2: Material,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float | None = None,
    approach: float | None = None,
    friction: Coulomb,
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
        Without a period.
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
        phi: turn of body 1 over body 2 about z at the origin per way rolled [1/m]; or
    tangential_load : pair of float, optional
        Force on body 2 along x and y [N], its length less than mu times the load;
    torque : float, optional
        The moment on body 2 [N m]. A direction of which nothing is told has no creepage.
    start : RollingSolution, optional
        One of similar creepages or forces, from which the iteration starts.
    tol, on_border, max_iterations
        As in `ContactSolver`; tol also bounds the error of the shear, and of given forces over the
        largest ones.

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
    require_type("friction", friction, Coulomb)
    if start is not None:
        require_type("start", start, RollingSolution)
    if grid.periodic:
        raise ValueError(
            f"grid must have no period, got periodic={grid.periodic!r}: a contact rolls onto "
            "material that has not been in it"
        )
    given = GivenAlong.of(
        {"creepage": creepage, "spin": spin},
        {"tangential_load": tangential_load, "torque": torque},
    )
    solver = ContactSolver(
        grid,
        body1,
        body2,
        friction,
        tol=tol,
        on_border=on_border,
        max_iterations=max_iterations,
    )
    solution = solver._driven(gap, load, approach, _Rolling(given, friction.coefficient, start))
    assert isinstance(solution, RollingSolution)
    return solution


@dataclass(frozen=True)
class _Rolling:
    """Drives a contact that rolls steadily."""

    given: GivenAlong
    friction: float
    previous: RollingSolution | None

    def solved(
        self,
        core: _core.CoulombContact,
        grid: Grid,
        contact: Pressing,
        start: FloatArray | None,
        settings: Settings,
    ) -> tuple[ContactSolution, str]:
        """The solution, and what is to be said of the border."""
        tol, most, refuse = settings
        forces = any(self.given.is_force)
        inner = max(0.1 * tol, 1e-12) if forces else tol
        near: tuple[FloatArray | None, FloatArray | None] = (start, None)
        if self.previous is not None:
            near = before_on(self.previous, grid)[:2]

        def roll(creepage: FloatArray, found: dict[str, Any] | None) -> dict[str, Any]:
            p, s = near if found is None else (found["pressure"], found["shear"])
            if p is not None and s is None:
                s = np.zeros((2, *p.shape))
            x, y, turn = creepage
            return core.roll(*contact, (x, y, turn), p, s, inner, most, refuse)

        if forces:
            found = _Forces(self, grid, roll, tol).meet()
        else:
            found = roll(np.array(self.given.values), None)
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


class _Forces:
    """Finds the creepages of given forces, by Broyden's method from solution to solution."""

    def __init__(
        self,
        drive: _Rolling,
        grid: Grid,
        roll: Callable[[FloatArray, dict[str, Any] | None], dict[str, Any]],
        tol: float,
    ) -> None:
        self.drive, self.roll, self.tol = drive, roll, tol
        self.is_force = np.array(drive.given.is_force)
        self.target = np.array(drive.given.values)[self.is_force]
        creepage = np.where(self.is_force, 0.0, drive.given.values)
        if drive.previous is not None:
            before = (*drive.previous.creepage, drive.previous.spin)
            creepage[self.is_force] = np.array(before)[self.is_force]
        self.solves = 0
        self.found: dict[str, Any] = {}
        self.found = self._at(creepage)
        pressed = self.found["pressure"]
        x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
        cells = max(int(np.count_nonzero(pressed)), 1)
        self.size = math.sqrt(cells * grid.cell_area / math.pi)
        load = float(self.found["load"])
        arm: float = grid.cell_area * (pressed * np.hypot(x, y)).sum()
        mu: float = drive.friction
        self.largest = np.array([mu * load, mu * load, mu * arm]) if load > 0 else np.zeros(3)
        self._require_held()
        # so that a spin at the edge counts as a creepage does
        self.unit = np.array([1.0, 1.0, 1 / self.size])[self.is_force]
        bounded = min(mu, 1.0) * abs(self.found["approach"]) / self.size
        self.full = bounded if bounded > 0 else 1.0
        arms = np.array([1.0, 1.0, self.size])
        wanted = np.concatenate([self.target / arms[self.is_force], self.found["force"] / arms])
        most = max(10 * float(np.abs(wanted).max()), 1e-12 * min(mu, 1.0) * load, 1e-300)
        self.scale: FloatArray = np.minimum(self.largest, most * arms)[self.is_force]
        self.scale = np.where(self.scale > 0, self.scale, 1.0)

    def _require_held(self) -> None:
        wanted = np.zeros(3)
        wanted[self.is_force] = self.target
        along, torque = float(np.hypot(*wanted[:2])), abs(float(wanted[2]))
        for name, value, most in (
            ("tangential_load", along, float(self.largest[0])),
            ("torque", torque, float(self.largest[2])),
        ):
            if value > 0 and not value < most * (1 - 1e-8):
                unit = "N" if name == "tangential_load" else "N m"
                raise ValueError(
                    f"{name} must be less than {most!r} {unit}, the largest that friction holds, "
                    f"got {value!r} {unit}: where everything slides the creepage does not follow "
                    "from the force; give the creepage instead"
                )

    def _at(self, creepage: FloatArray) -> dict[str, Any]:
        self.solves += 1
        return self.roll(creepage, self.found or None)

    def _with(self, unknown: FloatArray) -> dict[str, Any]:
        creepage = np.array(self.drive.given.values)
        creepage[self.is_force] = unknown * self.unit
        return self._at(creepage)

    def _unknown(self) -> FloatArray:
        creepage: FloatArray = np.array(self.found["motion"])[self.is_force] / self.unit
        return creepage

    def _missing(self, found: dict[str, Any]) -> FloatArray:
        """Over the largest forces, or ten times those there are where these are less."""
        force = np.array(found["force"])[self.is_force]
        missing: FloatArray = (self.target - force) / self.scale
        return missing

    def _slopes(self, step: float) -> FloatArray:
        """Of the forces, by differences."""
        at, base = self._unknown(), np.array(self.found["force"])[self.is_force]
        columns = []
        for k in range(at.size):
            moved = at.copy()
            moved[k] += step
            columns.append((np.array(self._with(moved)["force"])[self.is_force] - base) / step)
        return np.stack(columns, axis=1)

    def meet(self) -> dict[str, Any]:
        """The solution with the forces."""
        if self.drive.previous is None:
            self._guess()
        if self._error() <= self.tol:
            return self.found
        size = max(float(np.abs(self._unknown()).max()), _SMALL * self.full)
        slopes = self._slopes(_STEP * size)
        while self._error() > self.tol:
            if self.solves > _MOST_SOLVES:
                self._give_up()
            slopes = self._step(slopes)
        return self.found

    def _error(self) -> float:
        return float(np.abs(self._missing(self.found)).max())

    def _guess(self) -> None:
        """From small creepages, in proportion, then as forces of a Hertz contact saturate.

        P. J. Vermeulen & K. L. Johnson (1964), doi:10.1115/1.3629610.
        """
        if self._error() <= self.tol:
            return
        slopes = self._slopes(_SMALL * self.full)
        force = np.array(self.found["force"])[self.is_force]
        linear = np.linalg.lstsq(slopes, self.target - force, rcond=None)[0]
        wanted = np.array(self.found["force"])
        wanted[self.is_force] = self.target
        f = max(math.hypot(*wanted[:2]) / self.largest[0], abs(wanted[2]) / self.largest[2])
        f = min(float(f), 1.0)
        stretch = 3 * (1 - (1 - f) ** (1 / 3)) / f if f > 1e-6 else 1.0
        self.found = self._with(self._unknown() + stretch * linear)

    def _step(self, slopes: FloatArray) -> FloatArray:
        """One step, shortened until it gains; the slopes with what it tells."""
        at, before = self._unknown(), self._error()
        force = np.array(self.found["force"])[self.is_force]
        step = np.linalg.lstsq(slopes, self.target - force, rcond=None)[0]
        most = 2 * max(float(np.abs(at).max()), _SMALL * self.full)
        step *= min(1.0, most / max(float(np.abs(step).max()), 1e-300))
        for _ in range(6):
            found = self._with(at + step)
            change = np.array(found["force"])[self.is_force] - force
            surprise = change - slopes @ step
            slopes = slopes + np.outer(surprise, step) / float(step @ step)
            if float(np.abs(self._missing(found)).max()) < before:
                self.found = found
                return slopes
            step = 0.4 * step
        return self._slopes(_STEP * float(np.abs(at).max()))

    def _give_up(self) -> None:
        error = _core.ConvergenceError(
            f"rolling did not come to its forces after {self.solves} solves: reached "
            f"tangential_load = {self.found['force'][:2]!r} N, torque = {self.found['force'][2]!r} "
            "N m: take smaller forces, or give the creepages"
        )
        error.iterations, error.residual = self.solves, self._error()
        raise error

# SPDX-License-Identifier: GPL-3.0-or-later
"""Tangential drive of a contact: prescribed tangential motions and forces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np

from .. import _core
from .._util.checks import FloatArray, finite, finite_array, in_cells, non_negative, require_type
from .._util.short_text import in_short
from .._util.travels import AT_REST
from ..problem.contact_law import in_contact
from ..problem.friction import FrictionLaw, lasting
from ..problem.grid import Grid
from ..solutions.contact_solution import (
    Before,
    ContactSolution,
    PartialSlipSolution,
    ShearedSolution,
    before_on,
    plastic_slip_on,
    slip_rate_on,
)

_DIRECTIONS = ("x", "y")

Pressing = tuple[FloatArray, _core.Drive]
"""Initial gap [m], and the normal drive: load or approach, and moments or tilts."""
Settings = tuple[float, int, bool, bool]
"""Tolerance; maximum number of iterations; whether a contact at the grid edge is an error; whether
the state with the smallest error is accepted if the solver does not converge."""


@dataclass(frozen=True)
class TangentialInput:
    """Prescribed motion, or force if `is_force`, along x, along y and about z."""

    is_force: tuple[bool, bool, bool]
    values: tuple[float, float, float]

    @classmethod
    def of(cls, motions: Mapping[str, Any], forces: Mapping[str, Any]) -> TangentialInput:
        """Combine motions and forces; a direction with neither has a prescribed motion of zero."""
        (moved, motion), (rotation_name, rotation) = motions.items()
        (pulled, force), (wrung, torque) = forces.items()
        given = zip(
            (f"{moved} and {pulled} along x", f"{moved} and {pulled} along y"),
            pair_of(moved, motion),
            pair_of(pulled, force),
            strict=True,
        )
        about_z = _maybe(rotation_name, rotation), _maybe(wrung, torque)
        all_given = [*given, (f"{rotation_name} and {wrung}", *about_z)]
        for names, a, b in all_given:
            if a is not None and b is not None:
                raise ValueError(
                    f"{names} cannot both be given, got {a!r} and {b!r}, because the "
                    "motion follows from the force: set one of them to None"
                )
        x, y, z = (b is not None for _, _, b in all_given)
        u, v, w = ((0.0 if a is None else a) if b is None else b for _, a, b in all_given)
        return cls((x, y, z), (u, v, w))


IN_FULL_SLIDING = TangentialInput((False,) * 3, (0.0,) * 3)
"""Input in full sliding, which prescribes nothing."""


class TangentialDriver(Protocol):
    """Interface of objects that solve a partial-slip contact with tangential drive."""

    @property
    def previous(self) -> ShearedSolution | None:
        """Solution of the preceding increment, whose grid the new solution also uses."""

    def solved(
        self,
        core: _core.PartialSlipContact,
        grid: Grid,
        contact: Pressing,
        start: FloatArray | None,
        settings: Settings,
    ) -> tuple[ContactSolution, str]:
        """Return the solution, and a message if the contact reaches the grid edge ("" if not)."""


@dataclass(frozen=True)
class TangentialDrive:
    """Prescribed tangential motions and forces, and travel of the surfaces, in one increment."""

    given: TangentialInput
    previous: ShearedSolution | None
    travels: tuple[float, float] = (0.0, 0.0)
    """Displacement of each surface through the contact in this increment [m]."""
    duration: float = 0.0
    """Duration of the increment [s]; 0 for friction that does not depend on the slip rate."""
    slip_rate: float | None = None
    """Initial slip rate of the iteration [m/s]; None: slip rate of the preceding increment."""

    @property
    def mean_travel(self) -> float:
        """Mean displacement of both surfaces through the grid [m]."""
        return 0.5 * (self.travels[0] + self.travels[1])

    def _before(self, grid: Grid) -> Before | tuple[None, None, None, float, tuple[float, float]]:
        """Return the fields at the end of the preceding increment, on the current grid."""
        if self.previous is None:
            return None, None, None, 0.0, (0.0, 0.0)
        before = before_on(self.previous, grid)
        cells = round(self.mean_travel / grid.dx)
        if cells == 0:
            return before
        pressure, shear, _, approach, tilt = before
        if grid.along_x:
            return np.roll(pressure, cells, -2), np.roll(shear, cells, -2), None, approach, tilt
        _require_kept(pressure, cells, grid)
        return carried(pressure, cells), carried(shear, cells), None, approach, tilt

    def _rate(self, grid: Grid) -> FloatArray | None:
        """Return the slip rate from which the iteration starts [m/s]; None means 0."""
        if self.duration == 0.0:
            return None
        if self.slip_rate is not None:
            return np.full(grid.surface_shape, self.slip_rate)
        known = None if self.previous is None else slip_rate_on(self.previous, grid)
        return self._carried(known, grid)

    def _plastic(self, grid: Grid) -> FloatArray | None:
        """Return the initial plastic slip [m] of a layer between the bodies; None means 0."""
        known = None if self.previous is None else plastic_slip_on(self.previous, grid)
        return self._carried(known, grid)

    def _carried(self, over: FloatArray | None, grid: Grid) -> FloatArray | None:
        """Return a field of the preceding increment, moved by the mean travel of the surfaces."""
        if over is None:
            return None
        cells = round(self.mean_travel / grid.dx)
        return np.roll(over, cells, -2) if grid.along_x else carried(over, cells)

    def solved(
        self,
        core: _core.PartialSlipContact,
        grid: Grid,
        contact: Pressing,
        start: FloatArray | None,
        settings: Settings,
    ) -> tuple[PartialSlipSolution, str]:
        """Return the solution with accumulated motions, and a message as in `TangentialDriver`."""
        p, s, g, d, tilt = self._before(grid)
        moves = self.mean_travel != 0
        if start is None and moves and self.previous is not None:
            start = before_on(self.previous, grid)[0]  # the contact keeps its position on the grid
        x, y, turn = self.given.values
        # slip due to rotation is taken at the cell positions during, not after, the motion
        lead = _core.spin_lead * self.mean_travel
        if not self.given.is_force[0]:
            x += self.travels[0] - self.travels[1]
        if not self.given.is_force[1]:
            y -= lead * turn
        drive = self.given.is_force, (x, y, turn)
        tol, most, refuse, accept = settings
        found = core.solve(
            *contact, *drive, p, s, g, d, tilt, moves, start, tol, most, refuse, accept,
            self.duration, self._rate(grid), self.slip_rate is not None, self._plastic(grid),
        )  # fmt: skip
        dx, dy, turned = found.pop("motion")
        return self._total(grid, found, (dx, dy + lead * turned), turned)

    def _total(
        self, grid: Grid, found: dict[str, Any], shift: tuple[float, float], twist: float
    ) -> tuple[PartialSlipSolution, str]:
        complaint = found.pop("border_complaint")
        *force, torque = found.pop("force")
        del found["fallbacks"]
        moved = np.array(shift)
        if isinstance(self.previous, PartialSlipSolution):
            moved += self.previous.shift
            twist += self.previous.twist
            found["friction_work"] += self.previous.friction_work
        totals = {
            "tangential_load": np.array(force),
            "torque": torque,
            "shift": moved,
            "twist": twist,
        }
        return PartialSlipSolution(grid=grid, **totals, **found), complaint


def carried(field: FloatArray, cells: int) -> FloatArray:
    """Shift a surface field along x by whole cells; cells that enter the grid are zero."""
    moved = np.zeros_like(field)
    to, of = slice(max(cells, 0), None), slice(max(-cells, 0), None)
    count = max(field.shape[-2] - abs(cells), 0)
    moved[..., to, :][..., :count, :] = field[..., of, :][..., :count, :]
    return moved


UNSHEARED = TangentialDrive(IN_FULL_SLIDING, None)
"""Tangential drive of a contact in full sliding."""


def _require_kept(pressure: FloatArray, cells: int, grid: Grid) -> None:
    """Raise ValueError if a shift by `cells` moves pressure off the grid."""
    rows = np.flatnonzero(in_contact(pressure).any(axis=1))
    low, high = (-int(rows[0]), grid.nx - 1 - int(rows[-1])) if rows.size else (cells, cells)
    if not low <= cells <= high:
        raise ValueError(
            f"advance must move the preceding contact by {low} to {high} cells of {grid.dx!r} m, "
            f"so that it stays on the grid, got {cells} cells (mean of both bodies): use smaller "
            "steps, or a longer grid"
        )


def given_along(
    friction: FrictionLaw,
    shift: Sequence[float | None] | None,
    tangential_load: Sequence[float | None] | None,
    twist: float | None,
    torque: float | None,
    **more: Any,
) -> TangentialInput:
    """Return the prescribed tangential motions and forces; raise ValueError in full sliding."""
    if friction.sticks:
        motions = {"shift": shift, "twist": twist}
        return TangentialInput.of(motions, {"tangential_load": tangential_load, "torque": torque})
    given = dict(shift=shift, twist=twist, tangential_load=tangential_load, torque=torque, **more)
    for name, value in given.items():
        if value is not None:
            raise ValueError(
                f"{name} is not supported in full sliding (friction given as a number), got "
                f"{value!r:.80}: use friction=samcontact.Coulomb(mu) in the solver"
            )
    return IN_FULL_SLIDING


def tangential_drive(
    friction: FrictionLaw,
    shift: Sequence[float | None] | None,
    tangential_load: Sequence[float | None] | None,
    twist: float | None,
    torque: float | None,
    previous: ShearedSolution | None,
    advance: Sequence[float],
    grid: Grid,
) -> TangentialDrive:
    """Check the arguments and create a tangential drive; in full sliding, it prescribes nothing."""
    pair = advance if advance is AT_REST else finite_array("advance", advance, (2,))
    first, second = map(float, pair)
    moves = None if first == second == 0 else advance
    along = given_along(
        friction, shift, tangential_load, twist, torque, previous=previous, advance=moves
    )
    if not friction.sticks:
        return UNSHEARED
    if previous is not None and not isinstance(previous, ShearedSolution):
        require_type("previous", previous, PartialSlipSolution)
    drive = TangentialDrive(along, previous, (first, second))
    if (first, second) != (0.0, 0.0):
        _require_rolling(drive, grid)
    return drive


def at_pace(
    drive: TangentialDrive, law: FrictionLaw, duration: float | None, slip_rate: float | None
) -> TangentialDrive:
    """Add the duration of the increment, and the initial slip rate of the iteration, to a drive."""
    lasts = lasting(law, duration)
    if slip_rate is not None:
        if not lasts:
            raise ValueError(
                f"slip_rate has no effect with friction that does not depend on it, got "
                f"{in_short(slip_rate)}: omit it, or use samcontact.FallingCoulomb"
            )
        slip_rate = non_negative("slip_rate", slip_rate)
    if law.varies_along_x and any(drive.travels):
        raise ValueError(
            f"advance must be (0, 0) with friction that varies along x, got {drive.travels!r}: use "
            "Simulation, in which the coefficients move with their body"
        )
    return replace(drive, duration=lasts, slip_rate=slip_rate) if lasts else drive


def _require_rolling(drive: TangentialDrive, grid: Grid) -> None:
    """Raise ValueError unless the contact can roll the given distance."""
    first, second = drive.travels
    cells = in_cells("advance", drive.mean_travel, grid.dx)
    if drive.previous is None:
        raise ValueError(
            f"advance must be (0, 0) without previous, got {drive.travels!r}: solve the normal "
            "contact first, and pass its solution as previous"
        )
    if abs(cells - round(cells)) > 1e-6:
        raise ValueError(
            f"advance must be, on average over both bodies, a whole number of cells of {grid.dx!r} "
            f"m, got {drive.mean_travel!r} m: use steps of whole cells, or another cell size"
        )
    if abs(first - second) > grid.dx:
        raise ValueError(
            f"advance of body 1 and of body 2 must differ by at most one cell, {grid.dx!r} m, got "
            f"{first!r} and {second!r} m: use smaller steps, or full sliding, e.g. friction = 0.3"
        )
    if drive.given.is_force[0] and first != second:
        raise ValueError(
            "advance must be equal for both bodies if tangential_load has a force along x, got "
            f"{first!r} and {second!r} m: the slip follows from this force"
        )
    if drive.given.is_force[2] and not drive.given.is_force[1]:
        raise ValueError(
            "torque with advance requires tangential_load along y, because spin also moves the "
            f"bodies along y; got a shift of {drive.given.values[1]!r} m along y: prescribe "
            "tangential_load along x and y, or twist instead of torque"
        )


def _maybe(name: str, value: Any) -> float | None:
    return None if value is None else finite(name, value)


def pair_of(name: str, pair: Any, relation: str = "along") -> list[float | None]:
    """Return the two numbers of a pair for x and y, each of which may be None."""
    if pair is None:
        return [None, None]
    if (
        isinstance(pair, (str, Mapping))
        or not hasattr(pair, "__len__")
        or (isinstance(pair, np.ndarray) and pair.ndim == 0)
    ):
        raise TypeError(f"{name} must be two numbers, {relation} x and y, got {in_short(pair)}")
    if len(pair) != 2:
        raise ValueError(f"{name} must be two numbers, {relation} x and y, got {len(pair)} numbers")
    return [_maybe(f"{name} {relation} {a}", v) for a, v in zip(_DIRECTIONS, pair, strict=True)]

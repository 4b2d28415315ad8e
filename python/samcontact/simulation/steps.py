# SPDX-License-Identifier: GPL-3.0-or-later
"""Checked arguments of a step of a simulation, converted for the compiled core."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from numpy.typing import ArrayLike

from .._util.checks import (
    FloatArray,
    exactly_one,
    in_cells,
    number,
    positive,
    tractions,
    value_per_body,
)
from .._util.short_text import in_short
from .._util.travels import AT_REST, both_axes
from ..bodies.viscoelastic import relaxes
from ..contact.normal_drive import UNTILTED, NormalDrive
from ..contact.tangential_drive import TangentialInput, given_along
from ..heat import Heat
from ..problem.cell_fields import shear_components
from ..problem.friction import FrictionLaw, has_history, lasting
from ..problem.grid import Grid
from ..problem.heating import (
    Bodies,
    heating,
    require_heat_of,
    require_reference,
    require_speeds,
)
from ..problem.relaxing import relaxing_duration, require_known_stress

STEP_ARGUMENTS = (
    "load", "approach", "pressure", "shear", "advance", "shift", "tangential_load", "twist",
    "torque", "heat_factor", "duration", "moment", "tilt",
)  # fmt: skip
"""Arguments of `Simulation.step`."""


_BY_CELLS = ("if heat.history is given", "with partial slip or plastic strain")
"""Conditions under which bodies must move by whole cells along x, and along y."""

Travels = tuple[tuple[float, float], tuple[float, float]]
"""Distances [cells] by which the surfaces of bodies 1 and 2 move: two along x, two along y."""


@dataclass(frozen=True)
class Step:
    """Targets and motions of an increment for the compiled core, and the heat from this one on."""

    normal: NormalDrive | None
    """Load or approach, and moments or tilts; None with prescribed tractions."""
    heat: Heat
    heating: list[Any]
    duration: float
    lasts: float
    """Duration for friction that depends on the slip rate [s]; 0: not needed."""
    advance: Travels
    tangential: TangentialInput
    pressure: FloatArray | None = None
    shear_x: FloatArray | None = None
    shear_y: FloatArray | None = None

    @property
    def target(self) -> dict[str, float]:
        """Load or approach, as a dictionary with one entry; empty with prescribed tractions."""
        return {} if self.normal is None else {self.normal.name: self.normal.value}

    def to_core(self) -> dict[str, Any]:
        given = vars(self).copy()
        del given["heat"]
        drive, normal = given.pop("tangential"), given.pop("normal") or _NO_LOAD
        return given | {
            "drive": normal.to_core(),
            "is_force": drive.is_force,
            "tangential": drive.values,
        }


_STANDING: Travels = AT_REST, AT_REST
_NO_LOAD = NormalDrive("load", 0.0)
_NO_MOTION = TangentialInput((False, False, False), (0.0, 0.0, 0.0))


class StepArguments:
    """Checks of increment arguments on one grid; the heat is checked again only if it changes."""

    def __init__(
        self, grid: Grid, bodies: Bodies, friction: FrictionLaw, spring: float = 0.0
    ) -> None:
        self.grid, self.bodies, self.friction, self.spring = grid, bodies, friction, spring
        self._slips_by_rate = friction.needs_duration
        self._has_history = has_history(friction, bodies)
        self.relaxes = relaxes(*bodies)
        self._heated: tuple[Heat, float | None, list[Any]] | None = None

    def checked(
        self,
        heat: Heat,
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
        held_tilt: Sequence[float] = UNTILTED,
    ) -> Step:
        """Check the arguments of `Simulation.step`, given heat and tilt, and return the step."""
        grid, friction = self.grid, self.friction
        kind = exactly_one(load=load, approach=approach, pressure=pressure)
        normal: NormalDrive | None = None
        given: dict[str, FloatArray | None] = {}
        if pressure is not None:
            _require_no_tilt(moment=moment, tilt=tilt)
            given = dict(zip(("shear_x", "shear_y"), shear_components(grid, shear), strict=True))
            given["pressure"] = tractions("pressure", pressure, grid.surface_shape)
        elif shear is not None:
            raise ValueError(f"shear cannot be combined with {kind}: set friction instead")
        else:
            normal = NormalDrive.of(
                kind, load if approach is None else approach, moment, tilt, held_tilt, self.spring
            )
        travels = _STANDING if advance is AT_REST else _travels(grid, advance)
        tangential = _NO_MOTION
        if not (shift is None and tangential_load is None and twist is None and torque is None):
            tangential = given_along(friction, shift, tangential_load, twist, torque)
        if any(travels[1]):
            _require_endless_along_y(self.bodies)
            _require_no_friction_along_y(friction, travels[1], pressure, shear)
            if self._has_history:
                require_whole_cells(travels[1], grid.dy, axis=1)
        if pressure is not None or torque is not None:
            _require_possible(friction, tangential, pressure, shear, torque, travels)
        is_unloaded = normal is not None and normal.name == "load" and normal.value == 0.0
        slides = self._slips_by_rate
        slides_for, of_heat = _of_friction(friction, heat, duration) if slides else (0.0, duration)
        timed = heat.history is not None or (heat.partition is not None and duration != math.inf)
        if self.relaxes and not timed:
            lasts: float | None = relaxing_duration(duration)
        else:
            lasts = _duration(heat, of_heat, is_unloaded=is_unloaded)
        if heat_factor is not None:
            heat = self._heat_with(heat, heat_factor)
        if lasts is not None and travels != _STANDING:
            self._require_heat_of_motion(heat, lasts, travels, is_loaded=not is_unloaded)
        heated = self._heating_of(heat, None if heat.history is None else lasts)
        if kind == "approach":
            require_reference(heat)
        return Step(normal, heat, heated, lasts or 0.0, slides_for, travels, tangential, **given)

    def _require_heat_of_motion(
        self, heat: Heat, duration: float, travels: Travels, *, is_loaded: bool
    ) -> None:
        """Raise ValueError unless the motion in an increment agrees with the data of the heat."""
        grid = self.grid
        if heat.history is not None:
            _require_motion_of_heat(heat, duration, travels, grid)
            if self._has_history:
                require_whole_cells(travels[0], grid.dx, axis=0)
            if heat.track is not None and is_loaded:
                along, across = (
                    [n * size / duration for n in cells]
                    for cells, size in zip(travels, (grid.dx, grid.dy), strict=True)
                )
                require_speeds(heat, self.bodies, grid, list(map(math.hypot, along, across)))
        elif heat.partition is not None and is_loaded:
            _require_velocity_of_heat(heat, duration, travels, grid)

    def _heat_with(self, heat: Heat, factor: float | Sequence[float]) -> Heat:
        """Return the heat with a new factor (heat flux per unit pressure)."""
        if heat.partition is not None:
            raise ValueError(
                f"heat_factor cannot be combined with heat.partition, "
                f"got {in_short(factor)}: omit it, because the frictional power gives the heat flux"
            )
        changed = replace(heat, factor=value_per_body("heat_factor", factor))
        if self.relaxes:
            require_known_stress(changed, self.bodies, self.grid)
        return changed

    def _heating_of(self, heat: Heat, duration: float | None) -> list[Any]:
        """Return the heating of both bodies for the compiled core.

        duration: duration of the increment [s] with heat.history; otherwise None.
        """
        known = self._heated
        if known is None or known[0] is not heat or known[1] != duration:
            require_heat_of(self.friction, heat)
            entries = heating(heat, self.bodies, self.grid, duration)
            known = self._heated = heat, duration, entries
        return known[2]


def _travels(grid: Grid, advance: ArrayLike) -> Travels:
    """Return the distances by which the surfaces move in the increment [cells]."""
    given = both_axes(advance)
    (x1, y1), (x2, y2) = (
        [in_cells("advance", d, size) for d, size in zip(body, (grid.dx, grid.dy), strict=True)]
        for body in given.tolist()
    )
    return (x1, x2), (y1, y2)


def _require_endless_along_y(bodies: Bodies) -> None:
    """Raise ValueError for bodies with free faces, which must not move along y."""
    for n, body in enumerate(bodies, 1):
        if getattr(body, "free_faces", None) is not None:
            raise ValueError(
                f"advance along y must be 0 with free_faces of body {n}, which stay at one place "
                "in the contact: move the bodies along x only"
            )


def _require_no_friction_along_y(
    friction: FrictionLaw,
    travels: tuple[float, float],
    pressure: ArrayLike | None,
    shear: ArrayLike | None,
) -> None:
    """Raise ValueError for bodies that slide along y with friction, which acts along x."""
    given = pressure is not None and shear is not None
    if friction.sticks or friction.is_frictionless or given or travels[0] == travels[1]:
        return
    raise ValueError(
        "advance of both bodies along y must be equal in full sliding, whose shear acts along x, "
        f"got friction = {friction!r} and a difference of {travels[0] - travels[1]:.6g} cells: set "
        "friction = 0, or prescribe pressure and shear"
    )


def _require_possible(
    friction: FrictionLaw,
    tangential: TangentialInput,
    pressure: ArrayLike | None,
    shear: ArrayLike | None,
    torque: float | None,
    advance: Travels,
) -> None:
    """Check that the arguments for partial slip are compatible with each other."""
    if not friction.sticks:
        return
    if pressure is not None and (any(tangential.is_force) or any(tangential.values)):
        raise ValueError(
            "shift, tangential_load, twist and torque cannot be combined with a prescribed "
            "pressure: prescribe shear instead"
        )
    if pressure is not None and shear is None:
        raise ValueError(
            f"shear is required with a prescribed pressure and friction = {friction!r}, got None: "
            "the pressure does not determine the shear; pass zeros for no shear"
        )
    if torque is not None and advance != _STANDING:
        raise ValueError(
            f"torque cannot be combined with advance, got {in_short(torque)}: prescribe the "
            "rotation instead, twist = spin * (distance rolled)"
        )


def _require_no_tilt(**given: Any) -> None:
    for name, value in given.items():
        if value is not None:
            raise ValueError(
                f"{name} cannot be combined with a prescribed pressure, got {in_short(value)}: "
                "omit it, because no equilibrium is solved"
            )


def largest_cold_load(steps: Sequence[Mapping[str, Any]]) -> float | None:
    """Return the maximum load of a path; None if the path has no load or changes the heating."""
    loads = [step.get("load") for step in steps]
    given = [load for load in loads if isinstance(load, (int, float))]
    heated = any("heat_factor" in step for step in steps)
    return max(given) if given and not heated else None


def largest_target(steps: Sequence[Mapping[str, Any]]) -> dict[str, float]:
    """Return the maximum load of a path; the maximum approach if the path has no load."""
    for name in ("load", "approach"):
        given = [v for step in steps if isinstance(v := step.get(name), (int, float))]
        if given:
            return {name: max(given)}
    return {}


def _duration(heat: Heat, duration: float | None, *, is_unloaded: bool) -> float | None:
    """Check and return the duration of an increment [s]; None if the heat requires none."""
    if heat.partition is None and heat.history is None:
        if duration is not None:
            raise ValueError(
                "duration has no effect without heat.history, heat.partition or a viscoelastic "
                "body: omit duration, or use one of these"
            )
        return None
    if duration is None:
        name = "partition" if heat.history is None else "history"
        raise ValueError(
            f"duration is required because heat.{name} is set: give the "
            "duration of the increment [s]"
        )
    if heat.history is not None and is_unloaded and number("duration", duration) == 0.0:
        return 0.0  # unloaded bodies move at once
    seconds = positive("duration", duration)
    if heat.history is None:
        return seconds
    shortest = heat.history[0]
    if seconds < shortest * (1 - 1e-12):
        raise ValueError(
            f"duration must be >= the shortest step of heat.history, {shortest!r} s, "
            f"got {seconds!r}"
        )
    return seconds


def _of_friction(
    friction: FrictionLaw, heat: Heat, duration: float | None
) -> tuple[float, float | None]:
    """Return two durations: for friction that depends on the slip rate, and for the heat."""
    heated = heat.partition is not None or heat.history is not None
    return lasting(friction, duration), duration if heated else None


def _require_motion_of_heat(heat: Heat, duration: float, advance: Travels, grid: Grid) -> None:
    """Raise ValueError unless the bodies move by whole cells along x, and at heat.velocity.

    With heat.track, the velocity follows from the motion, and is not checked. With a track along y,
    the bodies may move by fractions of a cell, except in partial slip or with plastic strain; the
    caller checks this exception.
    """
    if heat.track is not None:
        for axis, (cells, length) in enumerate(zip(advance, heat.tracks, strict=True)):
            if any(cells) and length == 0:
                raise ValueError(
                    f"heat.track must be > 0 along {'xy'[axis]} if bodies move along {'xy'[axis]}, "
                    f"got {heat.track!r}: set it to the lengths of the path along x and y, a pair"
                )
    if heat.tracks[1] == 0:
        require_whole_cells(advance[0], grid.dx, axis=0)
    if heat.track is None:
        _require_velocity_of_heat(heat, duration, advance, grid)


def require_whole_cells(advance: Sequence[float], size: float, axis: int) -> None:
    """Raise ValueError unless the bodies move by whole cells; their history is stored by cell.

    advance: motion of each body along x (axis 0) or y (axis 1) [cells]; size: length of a cell
    along this axis [m].
    """
    for n, cells in enumerate(advance, 1):
        if abs(cells - round(cells)) > 1e-6:
            raise ValueError(
                f"advance of body {n}{' along y' if axis else ''} must be a multiple of the cell "
                f"size, {size!r} m, {_BY_CELLS[axis]}, got {cells * size!r} m"
            )


def _require_velocity_of_heat(heat: Heat, duration: float, advance: Travels, grid: Grid) -> None:
    """Raise ValueError unless heated bodies move at heat.velocity; advance: distances [cells]."""
    axes = 2 if any(advance[1]) else 1
    for (n, share), axis in itertools.product(enumerate(heat.shares, 1), range(axes)):
        size = (grid.dx, grid.dy)[axis]
        moved = advance[axis][n - 1] * size
        expected = heat.velocity[n - 1][axis] * duration
        if share > 0 and abs(moved - expected) > 1e-6 * size:
            where = " along y" if axis else ""
            raise ValueError(
                f"advance of body {n}{where} must be heat.velocity x duration, {expected!r} m, got "
                f"{moved!r} m: change advance, duration or heat.velocity; if bodies with "
                "heat.history stop, turn or return, set heat.track instead of heat.velocity"
            )

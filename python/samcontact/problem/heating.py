# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of frictional heating against bodies and grid, and conversion for the core."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .. import _core
from .._util.checks import FloatArray, finite_array, require_type
from ..bodies.layered import Body, Layered
from ..heat import Heat
from .friction import FrictionLaw
from .grid import Grid

NO_HEAT = Heat(0.0)
"""Absence of heating."""
MAX_PECLET_NUMBER = 1e7
"""Maximum of speed times grid length divided by diffusivity [-]; it limits the computing time."""
MIN_DIFFUSION_LENGTH = 0.02
"""Minimum diffusion length in the shortest step of a history, in cells; it bounds the time and
memory of transient heating."""

Bodies = tuple[Body, Body]


def checked_heat(heat: Heat | None, bodies: Bodies, grid: Grid, friction: FrictionLaw) -> Heat:
    """Check `heat` against bodies, grid and friction law, and return it; None means no heating."""
    checked = NO_HEAT if heat is None else heat
    require_type("heat", checked, Heat)
    heating(checked, bodies, grid)
    require_heat_of(friction, checked)
    return checked


def heating(heat: Heat, bodies: Bodies, grid: Grid, duration: float | None = None) -> list[Any]:
    """Return the heating of each body for the core; raise ValueError if it is not supported.

    duration: length of the increment under transient heating [s].
    """
    age = math.inf if heat.time is None else heat.time
    reference = 1.0 if heat.reference is None else heat.reference
    entries = []
    period = (
        grid.nx * grid.dx if grid.along_x else 0.0,
        grid.ny * grid.dy if grid.along_y else 0.0,
    )
    of_slip = heat.partition is not None
    name = "heat.partition: fraction of the heat" if of_slip else "heat.factor"
    for n, (body, factor, v) in enumerate(zip(bodies, heat.shares, heat.velocity, strict=True), 1):
        if isinstance(body, Layered):
            if factor > 0:
                raise ValueError(
                    f"{name} must be 0 for layered body{n}, got {factor!r}: heat conduction in "
                    "layered bodies is not supported"
                )
            entries.append(_core.Heating())
            continue
        if factor > 0:
            _require_transient(name, heat, grid, n, factor)
            if body.is_rigid:
                raise ValueError(f"{name} must be 0 for rigid body{n}, got {factor!r}")
            if body.thermal is None:
                raise ValueError(
                    f"{name} of body{n} must be 0 without thermal constants, got {factor!r}: "
                    "set them with with_thermal()"
                )
            _require_speed(grid, n, body.thermal[2], math.hypot(*v))
            if heat.history is not None:
                _require_shortest(grid, n, body.thermal[2], heat.history[0])
            if heat.time is not None:
                _require_time("heat.time", heat.time, body.thermal[2], grid)
            if duration is not None:
                _require_time("duration", duration, body.thermal[2], grid)
        constants = body.thermal or (1.0, 0.0, 1.0)
        entries.append(_core.Heating(factor, *constants, *v, age, reference, of_slip, period))
    return entries


def _require_transient(name: str, heat: Heat, grid: Grid, body: int, factor: float) -> None:
    """Raise ValueError for steady heat of a periodic grid, and for motion along its period."""
    if not grid.periodic:
        return
    if heat.time is None and heat.history is None:
        raise ValueError(
            f"{name} of body{body} must be 0 on a periodic grid, got {factor!r} with "
            f"grid.periodic = {grid.periodic!r}: uniform heating of a half-space has no "
            "steady state; set heat.time or heat.history"
        )
    for axis, speed in zip("xy", heat.velocity[body - 1], strict=True):
        if axis in grid.periodic and speed != 0.0:
            raise ValueError(
                f"heat.velocity of body {body} along {axis} must be 0 with grid.periodic = "
                f"{grid.periodic!r}, got {speed!r} m/s"
            )


def _require_speed(grid: Grid, body: int, diffusivity: float, speed: float) -> None:
    """Raise ValueError for a speed outside the range of the heat kernels."""
    extent = max(grid.nx * grid.dx, grid.ny * grid.dy)
    fastest = MAX_PECLET_NUMBER * diffusivity / extent
    if speed > fastest:
        raise ValueError(
            f"heat.velocity of body {body} must be <= {fastest:.4g} m/s on this grid "
            f"({extent:.4g} m long, diffusivity {diffusivity:.4g} m^2/s), got {speed:.4g} m/s"
        )
    minimum = 1e-55 * diffusivity / min(grid.dx, grid.dy)
    if 0 < speed < minimum:
        raise ValueError(
            f"heat.velocity of body {body} must be 0 or >= {minimum:.3g} m/s, got {speed:.3g} m/s"
        )


def require_speeds(heat: Heat, bodies: Bodies, grid: Grid, speeds: Sequence[float]) -> None:
    """Raise ValueError if a heated body moves too fast in an increment; speeds along x [m/s]."""
    for n, (body, share, speed) in enumerate(zip(bodies, heat.shares, speeds, strict=True), 1):
        if share > 0 and not isinstance(body, Layered) and body.thermal is not None:
            _require_speed(grid, n, body.thermal[2], abs(speed))


def _require_shortest(grid: Grid, body: int, diffusivity: float, shortest: float) -> None:
    """Raise ValueError if the shortest step of the history is too short for the cells."""
    cell = max(grid.dx, grid.dy)
    if math.sqrt(diffusivity * shortest) < MIN_DIFFUSION_LENGTH * cell:
        minimum = (MIN_DIFFUSION_LENGTH * cell) ** 2 / diffusivity
        raise ValueError(
            f"heat.history must have a shortest step >= {minimum:.4g} s for body {body}, got "
            f"{shortest:.4g} s: in this time heat must diffuse over at least "
            f"{MIN_DIFFUSION_LENGTH:g} of the cell length {cell:.4g} m "
            f"(diffusivity {diffusivity:.4g} m^2/s)"
        )


def _require_time(name: str, time: float, diffusivity: float, grid: Grid) -> None:
    longest = 1e55 * min(grid.dx, grid.dy) ** 2 / diffusivity
    if time > longest:
        raise ValueError(f"{name} must be <= {longest:.3g} s, got {time:.3g} s")


def core_law(body: Body) -> Callable[[FloatArray], FloatArray] | None:
    """Return the thermal softening law of a body, with results of shape (nz, nx, ny), or None."""
    law = body.softening
    if law is None:
        return None

    def factor(rise: FloatArray) -> FloatArray:
        checked = finite_array("factor of softening", law(rise), rise.shape)
        return np.ascontiguousarray(np.moveaxis(checked, 2, 0))

    return factor


def require_reference(heat: Heat) -> None:
    """Raise ValueError if a steady heat source at rest has no reference distance."""
    if heat.reference is not None or heat.time is not None or heat.history is not None:
        return
    if any(f > 0 and not any(v) for f, v in zip(heat.shares, heat.velocity, strict=True)):
        raise ValueError(
            "heat.reference is required under approach control: the displacement due to a steady "
            "source at rest is defined only relative to a reference distance [m]"
        )


def require_heat_of(friction: FrictionLaw, heat: Heat) -> None:
    """Raise ValueError for heat.partition with full sliding."""
    if not friction.sticks and heat.partition is not None:
        raise ValueError(
            f"heat.partition must be None with friction = {friction!r}, got {heat.partition!r}: in "
            "full sliding the heat flux is proportional to the pressure; use heat.factor, see "
            "heat.factors"
        )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat as the core takes it, and what it asks of bodies and grid."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from .. import _core
from .._util.checks import FloatArray, finite_array, require_type
from ..bodies.layered import Body, Layered
from ..heat import Heat
from .friction import FrictionLaw
from .grid import Grid

COLD = Heat(0.0)
"""No heat."""
MOST_HEAT_WAY = 1e7
"""Largest speed times extent of the grid over diffusivity [-]: the work grows with it."""
LEAST_DIFFUSED = 0.02
"""Of a cell: how far heat must diffuse in the shortest step of a history, else time and memory of
the march have no bounds."""

Bodies = tuple[Body, Body]


def checked_heat(heat: Heat | None, bodies: Bodies, grid: Grid, friction: FrictionLaw) -> Heat:
    """Heat that bodies, kernels and friction allow; default none. Raises ValueError, TypeError."""
    checked = COLD if heat is None else heat
    require_type("heat", checked, Heat)
    heating(checked, bodies, grid)
    require_heat_of(friction, checked)
    return checked


def heating(heat: Heat, bodies: Bodies, grid: Grid, duration: float | None = None) -> list[Any]:
    """One entry for each body; refuses what the bodies or the kernels of heat cannot do.

    duration: of an increment of a march in time [s].
    """
    age = math.inf if heat.time is None else heat.time
    reference = 1.0 if heat.reference is None else heat.reference
    entries = []
    of_slip = heat.partition is not None
    name = "share of the heat" if of_slip else "heat.factor"
    for n, (body, factor, v) in enumerate(zip(bodies, heat.shares, heat.velocity, strict=True), 1):
        if isinstance(body, Layered):
            if factor > 0:
                raise ValueError(
                    f"{name} of body{n} must be 0 where the body has layers, got {factor!r}: "
                    "there are no kernels of heat in layers"
                )
            entries.append(_core.Heating())
            continue
        if factor > 0:
            if grid.periodic:
                raise ValueError(
                    f"{name} of body{n} must be 0 on a periodic grid, got {factor!r} with "
                    f"grid.periodic = {grid.periodic!r}: heat that enters all of a half-space "
                    "has no steady state"
                )
            if body.is_rigid:
                raise ValueError(f"{name} of body{n} is {factor!r}, but the body is rigid")
            if body.thermal is None:
                raise ValueError(
                    f"{name} of body{n} is {factor!r}, but the body has no thermal constants: "
                    "give them with with_thermal()"
                )
            _require_speed(grid, n, body.thermal[2], math.hypot(*v))
            if heat.history is not None:
                _require_shortest(grid, n, body.thermal[2], heat.history[0])
            if heat.time is not None:
                _require_time("heat.time", heat.time, body.thermal[2], grid)
            if duration is not None:
                _require_time("duration", duration, body.thermal[2], grid)
        constants = body.thermal or (1.0, 0.0, 1.0)
        entries.append(_core.Heating(factor, *constants, *v, age, reference, of_slip))
    return entries


def _require_speed(grid: Grid, body: int, diffusivity: float, speed: float) -> None:
    """Refuse what the kernels of heat would, in the words of the user's arguments."""
    extent = max(grid.nx * grid.dx, grid.ny * grid.dy)
    fastest = MOST_HEAT_WAY * diffusivity / extent
    if speed > fastest:
        raise ValueError(
            f"heat.velocity of body {body} must be at most {fastest:.4g} m/s on this grid "
            f"({extent:.4g} m long, diffusivity {diffusivity:.4g} m^2/s), got {speed:.4g} m/s"
        )
    least = 1e-55 * diffusivity / min(grid.dx, grid.dy)
    if 0 < speed < least:
        raise ValueError(
            f"heat.velocity of body {body} must be 0 or at least {least:.3g} m/s, "
            f"got {speed:.3g} m/s"
        )


def _require_shortest(grid: Grid, body: int, diffusivity: float, shortest: float) -> None:
    """Refuse before anything is solved what the march would."""
    cell = max(grid.dx, grid.dy)
    if math.sqrt(diffusivity * shortest) < LEAST_DIFFUSED * cell:
        least = (LEAST_DIFFUSED * cell) ** 2 / diffusivity
        raise ValueError(
            f"heat.history must have a shortest step of at least {least:.4g} s for body {body}, in "
            f"which heat diffuses over {LEAST_DIFFUSED:g} of a cell of {cell:.4g} m (diffusivity "
            f"{diffusivity:.4g} m^2/s), got {shortest:.4g} s"
        )


def _require_time(name: str, time: float, diffusivity: float, grid: Grid) -> None:
    longest = 1e55 * min(grid.dx, grid.dy) ** 2 / diffusivity
    if time > longest:
        raise ValueError(f"{name} must be at most {longest:.3g} s, got {time:.3g} s")


def core_law(body: Body) -> Callable[[FloatArray], FloatArray] | None:
    """The law of softening of a body as the core calls it: (nx, ny, nz) in, depth-major out."""
    law = body.softening
    if law is None:
        return None

    def factor(rise: FloatArray) -> FloatArray:
        checked = finite_array("factor of softening", law(rise), rise.shape)
        return np.ascontiguousarray(np.moveaxis(checked, 2, 0))

    return factor


def require_reference(heat: Heat) -> None:
    """For a given approach: heat at rest in the steady state displaces relative to a distance."""
    if heat.reference is not None or heat.time is not None or heat.history is not None:
        return
    if any(f > 0 and not any(v) for f, v in zip(heat.shares, heat.velocity, strict=True)):
        raise ValueError(
            "heat.reference must be given with an approach: the displacement of a steady source at "
            "rest has no limit far away, it is zero at this distance [m] of a point source"
        )


def require_heat_of(friction: FrictionLaw, heat: Heat) -> None:
    """Raise ValueError for heat of another kind than the friction's."""
    if friction.sticks and any(heat.factor):
        raise ValueError(
            f"heat.factor must be 0 with friction = {friction!r}, got {heat.factor!r}: bodies that "
            "stick and slip are heated by their slip; give heat.partition to a Simulation"
        )
    if not friction.sticks and heat.partition is not None:
        raise ValueError(
            f"heat.partition must be None with friction = {friction!r}, got {heat.partition!r}: "
            "where all slides the heat goes with the pressure; give heat.factor, see heat.factors"
        )

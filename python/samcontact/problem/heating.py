# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that bodies and grid support frictional heating; conversion for the compiled core."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .. import _core
from .._util.checks import FloatArray, finite_array, require_type
from .._util.short_text import in_short
from ..bodies.layered import Body, materials_at, materials_of, matrix_of, thermal_of
from ..bodies.layers import Layered
from ..heat import Heat
from .friction import FrictionLaw
from .grid import Grid

NO_HEAT = Heat(0.0)
"""Absence of heating."""
MAX_PECLET_NUMBER = 1e7
"""Maximum of (speed times grid length)/diffusivity [-]; it limits the computing time."""
MIN_DIFFUSION_LENGTH = 0.02
"""Minimum diffusion length [cells] in the shortest step of a heat history; it limits the computing
time and the memory of transient heating."""
MIN_THICKNESS = 1e-5
"""Minimum thickness of layers of a heated body [cells]; it limits the number of wavenumbers."""
_ANY_CONSTANTS = (1.0, 0.0, 1.0)
"""Placeholder for the thermal constants of a body that is not heated."""
_UNHEATED = _core.Heating()

Bodies = tuple[Body, Body]


def checked_heat(heat: Heat | None, bodies: Bodies, grid: Grid, friction: FrictionLaw) -> Heat:
    """Check `heat` against bodies, grid and friction law, and return it; None means no heating."""
    checked = NO_HEAT if heat is None else heat
    require_type("heat", checked, Heat)
    heating(checked, bodies, grid)
    require_heat_of(friction, checked)
    return checked


def heating(heat: Heat, bodies: Bodies, grid: Grid, duration: float | None = None) -> list[Any]:
    """Return the heating of each body for the compiled core; ValueError if not supported.

    duration: duration of the increment [s], for transient heating.
    """
    if not any(heat.shares) and heat.history is None:
        return [_UNHEATED, _UNHEATED]
    age = math.inf if heat.time is None else heat.time
    reference = 1.0 if heat.reference is None else heat.reference
    entries = []
    period = (
        grid.nx * grid.dx if "x" in grid.periodic else 0.0,
        grid.ny * grid.dy if "y" in grid.periodic else 0.0,
    )
    of_slip = heat.partition is not None
    name = "heat.partition (fraction of the heat)" if of_slip else "heat.factor"
    for n, (body, factor, v) in enumerate(zip(bodies, heat.shares, heat.velocity, strict=True), 1):
        constants: tuple[tuple[float, float, float], ...] = (_ANY_CONSTANTS,)
        thickness: list[float] = []
        thermal = thermal_of(body)
        if thermal is not None and (factor > 0 or heat.history is not None):
            constants = thermal  # of a body that is heated, or may no longer be heated
            thickness = _thicknesses(body)
        if factor > 0:
            constants = _required_constants(name, n, body, factor)
            _require_in_layers(n, body, grid)
            _require_transient(name, heat, grid, n, factor)
            lowest, highest = _diffusivities(constants)
            _require_speed(grid, n, lowest, highest, math.hypot(*v))
            if heat.history is not None:
                _require_shortest(grid, n, lowest, heat.history[0])
            if heat.time is not None:
                _require_time("heat.time", heat.time, highest, grid)
            if duration is not None:
                _require_time("duration", duration, highest, grid)
        entries.append(
            _core.Heating(factor, constants, thickness, *v, age, reference, of_slip, period)
        )
    return entries


def _thicknesses(body: Body) -> list[float]:
    """Thickness of each layer of a body [m]; empty without layers."""
    matrix = matrix_of(body)
    return [h for _, h in matrix.layers] if isinstance(matrix, Layered) else []


def _required_constants(
    name: str, n: int, body: Body, factor: float
) -> tuple[tuple[float, float, float], ...]:
    """Return the thermal constants of a body; ValueError if it has none or is rigid."""
    if body.is_rigid:
        raise ValueError(f"{name} must be 0 for rigid body{n}, got {factor!r}")
    if materials_of(body)[-1].is_rigid:
        raise ValueError(
            f"{name} must be 0 for body{n}, whose substrate is rigid, got {factor!r}: the thermal "
            "expansion of a rigid substrate is unknown; use a stiff elastic substrate"
        )
    thermal = thermal_of(body)
    if thermal is None:
        raise ValueError(
            f"{name} of body{n} must be 0 without thermal constants{_of_missing(body)}, got "
            f"{factor!r}: set them with with_thermal()"
        )
    return thermal


def _of_missing(body: Body) -> str:
    """Return text that names the materials of a layered body that lack thermal constants."""
    body = matrix_of(body)
    if not isinstance(body, Layered):
        return ""
    names = [*(f"layers[{n}]" for n in range(len(body.layers))), "substrate"]
    pairs = zip(names, materials_of(body), strict=True)
    return f" of {' and '.join(name for name, material in pairs if material.thermal is None)}"


def _require_in_layers(n: int, body: Body, grid: Grid) -> None:
    """Raise ValueError if a layer of a heated body is too thin for the cells of the grid."""
    cell = max(grid.dx, grid.dy)
    for k, thickness in enumerate(_thicknesses(body)):
        if thickness < MIN_THICKNESS * cell:
            raise ValueError(
                f"thickness of layers[{k}] of heated body{n} must be >= {MIN_THICKNESS * cell:.4g} "
                f"m ({MIN_THICKNESS:g} of the cell length {cell:.4g} m), got {thickness:.4g} m: "
                "thicknesses are in metres, e.g. 5e-6 for 5 um"
            )


def _diffusivities(thermal: Sequence[tuple[float, float, float]]) -> tuple[float, float]:
    """Return the minimum and the maximum diffusivity [m^2/s]."""
    values = [diffusivity for _, _, diffusivity in thermal]
    return min(values), max(values)


def _require_transient(name: str, heat: Heat, grid: Grid, body: int, factor: float) -> None:
    """Raise ValueError on a periodic grid if a heat source is steady or moves along a period."""
    if not grid.periodic:
        return
    if heat.time is None and heat.history is None:
        raise ValueError(
            f"{name} of body{body} must be 0 on a periodic grid under steady heating, got "
            f"{factor!r} with grid.periodic = {grid.periodic!r}: a uniformly heated half-space has "
            "no steady state; set heat.time or heat.history"
        )
    for axis, length in zip("xy", heat.tracks, strict=True):
        if axis in grid.periodic and length > 0:
            raise ValueError(
                f"heat.track must be {'None' if axis == 'x' else '0 along y'} on a grid that is "
                f"periodic along {axis}, got {heat.track!r}: heat that moves along a period is not "
                "supported"
            )
    for axis, speed in zip("xy", heat.velocity[body - 1], strict=True):
        if axis in grid.periodic and speed != 0.0:
            raise ValueError(
                f"heat.velocity of body {body} along {axis} must be 0 with grid.periodic = "
                f"{grid.periodic!r}, got {speed!r} m/s"
            )


def _require_speed(grid: Grid, body: int, lowest: float, highest: float, speed: float) -> None:
    """Raise ValueError for a speed outside the range of the heat kernels.

    lowest, highest: diffusivity of the body [m^2/s].
    """
    extent = max(grid.nx * grid.dx, grid.ny * grid.dy)
    fastest = MAX_PECLET_NUMBER * lowest / extent
    if speed > fastest:
        raise ValueError(
            f"heat.velocity of body {body} must be <= {fastest:.4g} m/s with a grid that is "
            f"{extent:.4g} m long and a diffusivity of {lowest:.4g} m^2/s, got {speed:.4g} m/s"
        )
    minimum = 1e-55 * highest / min(grid.dx, grid.dy)
    if 0 < speed < minimum:
        raise ValueError(
            f"heat.velocity of body {body} must be 0 or >= {minimum:.3g} m/s, got {speed:.3g} m/s"
        )


def require_speeds(heat: Heat, bodies: Bodies, grid: Grid, speeds: Sequence[float]) -> None:
    """Raise ValueError if a heated body moves too fast; speeds: magnitudes [m/s]."""
    for n, (body, share, speed) in enumerate(zip(bodies, heat.shares, speeds, strict=True), 1):
        thermal = thermal_of(body)
        if share > 0 and thermal is not None:
            _require_speed(grid, n, *_diffusivities(thermal), speed)


def _require_shortest(grid: Grid, body: int, diffusivity: float, shortest: float) -> None:
    """Raise ValueError if heat diffuses over too short a distance in the shortest time step."""
    cell = max(grid.dx, grid.dy)
    if math.sqrt(diffusivity * shortest) < MIN_DIFFUSION_LENGTH * cell:
        minimum = (MIN_DIFFUSION_LENGTH * cell) ** 2 / diffusivity
        raise ValueError(
            f"heat.history must have a shortest step >= {minimum:.4g} s for body {body}, got "
            f"{shortest:.4g} s: in the shortest step, heat must diffuse over at least "
            f"{MIN_DIFFUSION_LENGTH:g} of the cell length {cell:.4g} m "
            f"(diffusivity {diffusivity:.4g} m^2/s)"
        )


def _require_time(name: str, time: float, diffusivity: float, grid: Grid) -> None:
    longest = 1e55 * min(grid.dx, grid.dy) ** 2 / diffusivity
    if time > longest:
        raise ValueError(f"{name} must be <= {longest:.3g} s, got {time:.3g} s")


def softening_of(body: Body, dz: float | None) -> Callable[[FloatArray, int], FloatArray] | None:
    """Return a function for the thermal softening of a body; None if it does not soften.

    dz: thickness of the cells [m]. The arguments of the function are the temperature rises [K] in m
    layers of cells, shape (nx, ny, m), and the number of layers above these. The function returns
    factors on the yield stress, by the law of the material in each cell.
    """
    if body.softening is None:
        return None

    def factor(rise: FloatArray, above: int) -> FloatArray:
        found = np.ones(rise.shape)
        depths = np.asarray(
            (above + np.arange(rise.shape[2]) + 0.5) * (dz or 0.0), dtype=np.float64
        )
        for material, there in materials_at(body, depths):
            if material.softening is not None and there.any():
                own = rise[..., there]
                factors = material.softening(own)
                found[..., there] = finite_array("factor of softening", factors, own.shape)
        return found

    return factor


def core_law(body: Body, dz: float | None) -> Callable[[FloatArray], FloatArray] | None:
    """Return the function of `softening_of` with results of shape (nz, nx, ny), or None."""
    law = softening_of(body, dz)
    if law is None:
        return None
    return lambda rise: np.ascontiguousarray(np.moveaxis(law(rise, 0), 2, 0))


def require_reference(heat: Heat) -> None:
    """Raise ValueError if a steady heat source at rest has no reference distance."""
    if heat.reference is not None or heat.time is not None or heat.history is not None:
        return
    if any(f > 0 and not any(v) for f, v in zip(heat.shares, heat.velocity, strict=True)):
        raise ValueError(
            "heat.reference is required under approach control, because the displacement due to a "
            "steady heat source at rest is defined only relative to that at a reference distance: "
            "give this distance [m]"
        )


def require_heat_of(friction: FrictionLaw, heat: Heat) -> None:
    """Raise ValueError if heat.partition is needed but missing, or is given in full sliding."""
    if friction.needs_temperature and heat.partition is None:
        raise ValueError(
            f"heat.partition is required with friction = {in_short(friction)}, which depends on "
            "the temperature due to slip: use Simulation with heat=samcontact.Heat(partition=...)"
        )
    if not friction.sticks and heat.partition is not None:
        raise ValueError(
            f"heat.partition must be None with friction = {friction!r}, got {heat.partition!r}: in "
            "full sliding the heat flux is proportional to the pressure; use heat.factor, which "
            "samcontact.heat.factors computes"
        )

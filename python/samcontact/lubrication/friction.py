# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction of lubricated contacts: shear of film and boundary layer, rolling resistance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray, require_type
from .._util.display import HtmlTable, Rows, quantity
from .film_heat import Conduction
from .film_solution import FilmSolution

MAX_FLUID_COEFFICIENT = 0.15
"""Largest coefficient of friction that an oil can transmit [-]; traction fluids reach 0.12."""


@dataclass(frozen=True, repr=False, eq=False)
class FilmFriction(HtmlTable):
    """Friction of a lubricated contact, from `friction`.

    Attributes
    ----------
    fluid_shear, boundary_shear : ndarray, shape (2, nx, ny)
        Shear stresses that fluid and boundary layer exert on body 2 along x and y [Pa]. They have
        the direction of the velocity of body 1 relative to body 2.
    traction : ndarray, shape (2,)
        Force on body 2 along x and y [N].
    coefficient : float
        Magnitude of the traction divided by the load [-].
    boundary_share : float
        Share of the boundary layer in the traction [-]; zero without sliding.
    rolling_resistance : float
        Force of the pressure flow on each body, opposite to the mean velocity [N]. It is the
        integral of half the film thickness times the pressure gradient, and also acts in pure
        rolling.
    power : float
        Dissipated power [W].
    """

    fluid_shear: FloatArray
    boundary_shear: FloatArray
    traction: FloatArray
    coefficient: float
    boundary_share: float
    rolling_resistance: float
    power: float

    def _rows(self) -> Rows:
        return [
            ("coefficient", f"{self.coefficient:.4g}"),
            ("share of the boundary layer", f"{self.boundary_share:.4g}"),
            ("rolling resistance", quantity(self.rolling_resistance, "N")),
            ("power", quantity(self.power, "W")),
        ]

    def __repr__(self) -> str:
        return f"FilmFriction({', '.join(f'{name}={value}' for name, value in self._rows())})"


def friction(film: FilmSolution) -> FilmFriction:
    """Return shear stress, traction, rolling resistance and power of a lubricated contact.

    The shear stress of the fluid is `Lubricant.shear_stress` at the shear rate ``|v1 - v2|``/film,
    times the filled fraction of the film. In a heated film, it is evaluated at the computed
    temperatures. The boundary layer adds its coefficient of friction times its pressure. The
    sliding due to spin is not included.

    Raises
    ------
    TypeError
        The argument is not a solution of `steady`, `transient` or `stribeck`.
    ValueError
        The lubricant is Newtonian, and its friction exceeds 0.15 times the load, more than an oil
        can transmit.
    """
    require_type("film", film, FilmSolution)
    sliding = film.velocities[0] - film.velocities[1]
    speed = float(np.hypot(*sliding))
    direction = sliding / speed if speed > 0.0 else np.zeros(2)
    cell = film.grid.dx * film.grid.dy
    # iterates may have negative pressures, for which no law of viscosity is defined
    pressure = np.maximum(film.fluid_pressure, 0.0)
    if film.heat is None:
        fluid = film.filling * film.lubricant.shear_stress(speed / film.film, pressure)
    else:
        warm = Conduction(film.lubricant, pressure, film.film, film.filling, speed)
        fluid = warm.shear(film.heat.wall_rise, film.heat.depth)
    _require_thinning(film, float(fluid.sum()) * cell / film.load)
    layer = film.boundary_pressure * (0.0 if film.boundary is None else film.boundary.friction)
    layer = layer if speed > 0.0 else np.zeros_like(fluid)
    forces = np.array([fluid.sum(), layer.sum()]) * cell
    total = float(forces.sum())
    mean = 0.5 * (film.velocities[0] + film.velocities[1])
    flow = _flow_power(film, mean)
    entrainment = float(np.hypot(*mean))
    return FilmFriction(
        direction[:, None, None] * fluid,
        direction[:, None, None] * layer,
        direction * total,
        total / film.load,
        float(forces[1]) / total if total > 0.0 else 0.0,
        0.5 * flow / entrainment if entrainment > 0.0 else 0.0,
        total * speed + flow,
    )


def _flow_power(film: FilmSolution, mean: FloatArray) -> float:
    """Return the power of the pressure flow [W].

    It is the integral of film thickness times pressure gradient times mean velocity.
    """
    steps = film.grid.dx, film.grid.dy
    power = 0.0
    for axis, (step, speed) in enumerate(zip(steps, mean, strict=True)):
        if speed == 0.0 or film.film.shape[axis] < 2:
            continue
        slope = np.diff(film.fluid_pressure, axis=axis) / step
        ends = np.moveaxis(film.film, axis, 0)
        between = np.moveaxis(0.5 * (ends[1:] + ends[:-1]), 0, axis)
        power += float(speed) * float((slope * between).sum()) * steps[0] * steps[1]
    return power


def _require_thinning(film: FilmSolution, coefficient: float) -> None:
    """Raise ValueError if a Newtonian lubricant has more friction than an oil can transmit."""
    if coefficient > MAX_FLUID_COEFFICIENT and film.lubricant.is_newtonian:
        raise ValueError(
            f"with a Newtonian lubricant, the coefficient of friction must be at most "
            f"{MAX_FLUID_COEFFICIENT:g}, the largest of oils, got {coefficient:.3g}: use a "
            "lubricant with shear thinning or a limiting shear stress (with_eyring, "
            "with_limiting_shear)"
        )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow of a film due to its pressure, as changed by shear thinning and heat, at faces of cells."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .._util.checks import FloatArray
from ..lubricants.lubricant import Lubricant
from ..lubricants.shear import Newtonian, ShearThinning
from ..problem.grid import Grid
from .film_heat import FilmHeat
from .through_film import HEIGHTS, flow_tensor

NODES = np.array([0.5 - 0.15**0.5, 0.5, 0.5 + 0.15**0.5])
SHARES = np.array([5.0, 8.0, 5.0]) / 18.0
"""Gauss points between the pressures of two cells, and their weights."""


class PressureFlow(NamedTuple):
    """Flow at the faces along x and y: see the header `film/reynolds.hpp` of the core."""

    factor_x: FloatArray
    added_x: FloatArray
    slope_x: FloatArray
    factor_y: FloatArray
    added_y: FloatArray
    slope_y: FloatArray


@dataclass(frozen=True)
class Sheared:
    """Film whose flow is to be found."""

    grid: Grid
    lubricant: Lubricant
    sliding: FloatArray
    """Velocity of body 1 relative to body 2 along x and y [m/s]."""
    pressure: FloatArray
    """Pressure of the fluid [Pa]."""
    film: FloatArray
    heat: FilmHeat | None
    thins: bool
    """Whether the viscosity falls with the shear stress."""

    @property
    def law(self) -> ShearThinning:
        """Law of the shear thinning in the flow."""
        return self.lubricant.thinning if self.thins else Newtonian()


def pressure_flow(film: Sheared) -> tuple[PressureFlow, FloatArray]:
    """Return the flow due to the pressure, and the power that it dissipates per area [W/m^2]."""
    along_x, along_y = _along(film, 0), _along(film, 1)
    flow = PressureFlow(*along_x[:3], *along_y[:3])
    return flow, along_x.power + along_y.power


class _Faces(NamedTuple):
    """Flow at the faces along an axis [nx + 1][ny] or [nx][ny + 1], and power per area of cells."""

    factor: FloatArray
    added: FloatArray
    slope: FloatArray
    power: FloatArray


def _along(film: Sheared, axis: int) -> _Faces:
    grid = film.grid
    cells = film.pressure.shape[axis]
    shape = list(film.pressure.shape)
    shape[axis] += 1
    factor, added, slope = np.ones(shape), np.zeros(shape), np.zeros(shape)
    power = np.zeros_like(film.pressure)
    closed = axis == 1 and grid.along_y and cells > 1
    count = cells if closed else cells - 1
    if count < 1:
        return _Faces(factor, added, slope, power)

    def sides(field: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Values before and behind the faces, which are first along the axis."""
        moved = np.moveaxis(field, axis, 0)
        return (np.roll(moved, 1, axis=0), moved) if closed else (moved[:-1], moved[1:])

    *found, loss = _faces(film, axis, sides)
    first = 0 if closed else 1
    for whole, here in zip((factor, added, slope), found, strict=True):
        np.moveaxis(whole, axis, 0)[first : first + count] = here
    total = np.moveaxis(power, axis, 0)  # each cell receives half of the power of its two faces
    if closed:
        total += 0.5 * (loss + np.roll(loss, -1, axis=0))
    else:
        total[:-1] += 0.5 * loss
        total[1:] += 0.5 * loss
    return _Faces(factor, added, slope, power)


def _faces(film: Sheared, axis: int, sides: object) -> tuple[FloatArray, ...]:
    """Return factor, added flow, slope and power per area at the faces between cells."""
    assert callable(sides)
    grid, oil = film.grid, film.lubricant
    step = (grid.dx, grid.dy)[axis]

    def mean(field: FloatArray) -> FloatArray:
        before, behind = sides(field)
        found: FloatArray = 0.5 * (before + behind)
        return found

    before, behind = sides(film.pressure)
    h = mean(film.film)
    slopes = [(behind - before) / step, mean(_slope(film, 1 - axis))]
    gradient = 0.5 * h * np.array(slopes if axis == 0 else slopes[::-1])
    at = before + NODES[:, None, None] * (behind - before)
    inside = np.minimum(at, oil.max_pressure)
    viscosity, density = oil.viscosity(inside), oil.density(inside)
    hot, warm = np.ones_like(h), np.ones((HEIGHTS.size, *h.shape))
    if film.heat is not None:
        hot = film.heat.wall_fluidity(mean(film.heat.wall_rise))
        warm = film.heat.warm(mean(film.heat.depth))
    rate = film.sliding[:, None, None] / h
    many = at.shape
    newtonian = (viscosity / hot) * rate[:, None]
    flat = [
        np.broadcast_to(field[:, None], (len(field), *many)).reshape(len(field), -1)
        for field in (gradient, warm)
    ]
    tensor = flow_tensor(film.law, newtonian.reshape(2, -1), *flat)
    own, cross = (tensor.xx if axis == 0 else tensor.yy), tensor.xy
    steeper = tensor.steeper_x if axis == 0 else tensor.steeper_y
    fluidity = SHARES[:, None, None] * density / viscosity

    def total(factor: FloatArray) -> FloatArray:
        summed: FloatArray = hot * np.sum(fluidity * factor.reshape(many), axis=0)
        return summed

    main, across = total(own), total(cross)
    conductance = h**3 / 12.0
    full = (before > 0.0) & (behind > 0.0)
    slope = np.where(full, conductance / step * np.maximum(total(steeper), 0.0), 0.0)
    # at these pressures, the slope adds nothing
    added = np.where(full, -conductance * across * slopes[1], 0.0) + slope * (behind - before)
    loss = conductance * main * slopes[0] ** 2 / density.mean(axis=0)
    return main / fluidity.sum(axis=0), added, slope, loss


def _slope(film: Sheared, axis: int) -> FloatArray:
    """Return the pressure gradient of the cells along an axis [Pa/m]."""
    p, step = film.pressure, (film.grid.dx, film.grid.dy)[axis]
    if p.shape[axis] < 2:
        return np.zeros_like(p)
    if axis == 1 and film.grid.along_y:
        return (np.roll(p, -1, axis=1) - np.roll(p, 1, axis=1)) / (2.0 * step)
    slope: FloatArray = np.gradient(p, step, axis=axis)
    return slope


__all__ = ["PressureFlow", "Sheared", "pressure_flow"]

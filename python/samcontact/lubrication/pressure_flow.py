# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure flow of a film at the faces of the cells, with shear thinning and heating."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .._util.checks import FloatArray
from ..lubricants.lubricant import Lubricant
from ..lubricants.shear import Newtonian, ShearThinning
from ..problem.grid import Grid
from .film_heat import FilmHeat, wall_fluidity, warm_fluidity
from .through_film import HEIGHTS, FlowTensor, flow_of_warmth, flow_tensor

NODES = np.array([0.5 - 0.15**0.5, 0.5, 0.5 + 0.15**0.5])
SHARES = np.array([5.0, 8.0, 5.0]) / 18.0
"""Gauss points between the pressures of two neighbouring cells, and their weights."""

NEWTONIAN = 1.0, 0.0, 0.0, 0.0
"""Factor, fluidity, slope and added flow of an isothermal Newtonian film."""


class PressureFlow(NamedTuple):
    """Coefficients of the pressure flow at the cell faces, as defined in `film/reynolds.hpp`."""

    factor_x: FloatArray
    fluidity_x: FloatArray
    slope_x: FloatArray
    added_x: FloatArray
    factor_y: FloatArray
    fluidity_y: FloatArray
    slope_y: FloatArray
    added_y: FloatArray


@dataclass(frozen=True)
class Sheared:
    """Film whose pressure flow is to be computed."""

    grid: Grid
    lubricant: Lubricant
    sliding: FloatArray
    """Velocity of body 1 relative to body 2 along x and y [m/s]."""
    pressure: FloatArray
    """Pressure of the fluid [Pa]."""
    film: FloatArray
    heat: FilmHeat | None
    thins: bool
    """Whether the viscosity decreases with the shear stress."""

    @property
    def law(self) -> ShearThinning:
        """Law of shear thinning in the pressure flow."""
        return self.lubricant.thinning if self.thins else Newtonian()


def pressure_flow(film: Sheared) -> PressureFlow:
    """Return the coefficients of the pressure flow at all faces."""
    parts: list[FloatArray] = []
    for axis in (0, 1):
        faces = _Faces(film, axis)
        fields = [faces.spread(1.0), *(faces.spread(0.0) for _ in range(3))]
        if faces.count > 0:
            for whole, here in zip(fields, faces.flow(), strict=True):
                faces.inside(whole)[...] = here
        parts += fields
    return PressureFlow(*parts)


def flow_power(film: Sheared, flow: PressureFlow | None) -> FloatArray:
    """Return the power per area that the pressure flow of a solution dissipates [W/m^2].

    flow: the coefficients with which the pressure was computed; None for an isothermal Newtonian
    film.
    """
    power = np.zeros_like(film.pressure)
    for axis in (0, 1):
        faces = _Faces(film, axis)
        if faces.count > 0:
            parts = NEWTONIAN if flow is None else flow[4 * axis : 4 * axis + 4]
            faces.add_to_cells(faces.power(*map(faces.inside, parts)), power)
    return power


class _Faces:
    """Faces between the cells along an axis; this axis is the first axis of all fields."""

    def __init__(self, film: Sheared, axis: int) -> None:
        self._film, self._axis = film, axis
        self._cells = film.pressure.shape[axis]
        self._closed = axis == 1 and film.grid.along_y and self._cells > 1
        self.count = self._cells if self._closed else self._cells - 1
        if self.count < 1:
            return
        self._step = (film.grid.dx, film.grid.dy)[axis]
        self._before, self._behind = self._sides(film.pressure)
        self._h = self._mean(film.film)
        at = self._before + NODES[:, None, None] * (self._behind - self._before)
        inside = np.minimum(at, film.lubricant.max_pressure)
        self._viscosity = film.lubricant.viscosity(inside)
        density = film.lubricant.density(inside)
        self._density = density.mean(axis=0)
        self._fluidity = SHARES[:, None, None] * density / self._viscosity
        self._slope = (self._behind - self._before) / self._step

    def spread(self, value: float) -> FloatArray:
        """Return a field that is constant over all faces."""
        shape = list(self._film.pressure.shape)
        shape[self._axis] += 1
        return np.full(shape, value)

    def inside(self, field: FloatArray | float) -> FloatArray:
        """Return the values of a face field at the faces between two cells."""
        first = 0 if self._closed else 1
        whole = self.spread(field) if isinstance(field, float) else field
        part: FloatArray = np.moveaxis(whole, self._axis, 0)[first : first + self.count]
        return part

    def add_to_cells(self, loss: FloatArray, power: FloatArray) -> None:
        """Add half of the power of each face to each of the two cells that it separates."""
        total = np.moveaxis(power, self._axis, 0)
        if self._closed:
            total += 0.5 * (loss + np.roll(loss, -1, axis=0))
        else:
            total[:-1] += 0.5 * loss
            total[1:] += 0.5 * loss

    def power(
        self, factor: FloatArray, fluidity: FloatArray, slope: FloatArray, added: FloatArray
    ) -> FloatArray:
        """Return the power per area of the pressure flow with these coefficients [W/m^2]."""
        whole = factor * self._fluidity.sum(axis=0) + fluidity
        difference = self._behind - self._before
        down = self._h**3 / 12.0 * whole * self._slope + slope * difference - added
        found: FloatArray = np.maximum(down * self._slope, 0.0) / self._density
        return found

    def flow(self) -> tuple[FloatArray, ...]:
        """Return the coefficients factor, fluidity, slope and added flow of `PressureFlow`."""
        tensor, warm, hot = self._tensor()
        many = self._fluidity.shape

        def total(factor: FloatArray) -> FloatArray:
            summed: FloatArray = hot * np.sum(self._fluidity * factor.reshape(many), axis=0)
            return summed

        along_x = self._axis == 0
        main, across = total(tensor.xx if along_x else tensor.yy), total(tensor.xy)
        steeper = np.maximum(total(tensor.steeper_x if along_x else tensor.steeper_y), 0.0)
        conductance = self._h**3 / 12.0
        full = (self._before > 0.0) & (self._behind > 0.0)
        slope = np.where(full, conductance / self._step * steeper, 0.0)
        cross_slope = self._mean(_slope(self._film, 1 - self._axis))
        # at these pressures, the slope adds nothing
        added = slope * (self._behind - self._before)
        added = np.where(full, added - conductance * across * cross_slope, 0.0)
        # The more the oil is thinned, the less its fluidity depends on the pressure: the part that
        # still does is multiplied by the factor. The choice changes the convergence only.
        uniform = total(np.broadcast_to(flow_of_warmth(warm)[None], many).ravel())
        share = np.where(full, np.minimum(uniform / main, 1.0) ** 2, 1.0)
        return share * main / self._fluidity.sum(axis=0), (1.0 - share) * main, slope, added

    def _tensor(self) -> tuple[FlowTensor, FloatArray, FloatArray]:
        """Return the flow tensor, and the fluidity ratios across the film and of the walls.

        The tensor is evaluated at the Gauss points `NODES` between two cells. See `warm_fluidity`
        for the ratios across the film, and `wall_fluidity` for those of the walls.
        """
        film, h = self._film, self._h
        hot, warm = np.ones_like(h), np.ones((HEIGHTS.size, *h.shape))
        if film.heat is not None:
            hot = wall_fluidity(film.heat.constants, self._mean(film.heat.wall_rise))
            warm = warm_fluidity(self._mean(film.heat.depth))
        slopes = [self._slope, self._mean(_slope(film, 1 - self._axis))]
        gradient = 0.5 * h * np.array(slopes if self._axis == 0 else slopes[::-1])
        newtonian = (self._viscosity / hot) * (film.sliding[:, None, None] / h)[:, None]
        flat = [
            np.broadcast_to(field[:, None], (len(field), *newtonian.shape[1:]))
            for field in (gradient, warm)
        ]
        tensor = flow_tensor(
            film.law, newtonian.reshape(2, -1), *(each.reshape(len(each), -1) for each in flat)
        )
        return tensor, warm, hot

    def _sides(self, field: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the values in the cells before and behind each face."""
        moved = np.moveaxis(field, self._axis, 0)
        if self._closed:
            return np.roll(moved, 1, axis=0), moved
        return moved[:-1], moved[1:]

    def _mean(self, field: FloatArray) -> FloatArray:
        before, behind = self._sides(field)
        found: FloatArray = 0.5 * (before + behind)
        return found


def _slope(film: Sheared, axis: int) -> FloatArray:
    """Return the pressure gradient of the cells along an axis [Pa/m]."""
    p, step = film.pressure, (film.grid.dx, film.grid.dy)[axis]
    if p.shape[axis] < 2:
        return np.zeros_like(p)
    if axis == 1 and film.grid.along_y:
        return (np.roll(p, -1, axis=1) - np.roll(p, 1, axis=1)) / (2.0 * step)
    slope: FloatArray = np.gradient(p, step, axis=axis)
    return slope


__all__ = ["PressureFlow", "Sheared", "flow_power", "pressure_flow"]

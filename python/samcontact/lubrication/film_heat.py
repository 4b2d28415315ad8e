# SPDX-License-Identifier: GPL-3.0-or-later
"""Temperature of a lubricant film and of the surfaces that it heats.

Heat is conducted across the film to the surfaces (walls). The viscosity decreases as exp(-beta T)
with the temperature rise T above the walls. If the shear stress is uniform across the film, T has a
closed form (Gruntfest 1963): beta T = 2 ln(cosh D/cosh(D t)) at the relative height t in (-1, 1).
The parameter D follows from D tanh D = beta q h/(8 k), where q is the heat generated in the film
per area, h the film thickness and k the thermal conductivity of the lubricant.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from .._util.display import HtmlTable, Rows, quantity
from ..lubricants.lubricant import Lubricant, LubricantHeat
from ..lubricants.shear import thinned
from .through_film import HEIGHTS

FLOW_SHARE = 5.0 / 7.0
"""Share of the heat of the pressure flow that counts as released uniformly across the film [-].

The pressure flow releases its heat near the walls, where it changes the flow less."""
BISECTIONS = 50


@dataclass(frozen=True, repr=False, eq=False)
class FilmHeat(HtmlTable):
    """Temperatures and heat fluxes of a lubricated contact, from `steady` with `thermal=True`.

    Temperature rises are relative to the temperature of the bodies and the inlet. This is the
    temperature for which the viscosity is given. Fields have the shape (nx, ny).

    Attributes
    ----------
    constants : LubricantHeat
        Thermal constants of the lubricant.
    surface_rise : ndarray, shape (2, nx, ny)
        Temperature rise of the surfaces of bodies 1 and 2 [K].
    flux : ndarray, shape (2, nx, ny)
        Heat flux into bodies 1 and 2 [W/m^2].
    depth : ndarray
        Parameter D of the temperature profile across the film [-], the root of
        D tanh D = beta q h/(8 k). Here beta is the temperature coefficient of the viscosity, q the
        heat per area, h the film thickness and k the conductivity.
    middle_rise : ndarray
        Temperature rise in the middle of the film [K].
    cell_area : float
        Area of a cell [m^2].
    """

    constants: LubricantHeat
    surface_rise: FloatArray
    flux: FloatArray
    depth: FloatArray
    middle_rise: FloatArray
    cell_area: float

    @cached_property
    def wall_rise(self) -> FloatArray:
        """Mean of the temperature rises of the two surfaces [K], shape (nx, ny)."""
        mean: FloatArray = self.surface_rise.mean(axis=0)
        return mean

    @property
    def power(self) -> float:
        """Total heat flow into both bodies [W]."""
        return float(self.flux.sum()) * self.cell_area

    @property
    def max_rise(self) -> float:
        """Largest temperature rise in the film [K]."""
        return float(self.middle_rise.max())

    @property
    def temperature(self) -> FloatArray:
        """Temperature in the middle of the film [K], shape (nx, ny)."""
        return self.constants.temperature + self.middle_rise

    def _rows(self) -> Rows:
        return [
            ("largest rise in the film", quantity(self.max_rise, "K")),
            ("largest rise of body 1", quantity(float(self.surface_rise[0].max()), "K")),
            ("largest rise of body 2", quantity(float(self.surface_rise[1].max()), "K")),
            ("heat", quantity(self.power, "W")),
        ]

    def __repr__(self) -> str:
        return f"FilmHeat({', '.join(f'{name}={value}' for name, value in self._rows())})"


@dataclass(frozen=True)
class Conduction:
    """Heat conduction across a film of given pressure and thickness."""

    lubricant: Lubricant
    pressure: FloatArray
    film: FloatArray
    filling: FloatArray
    sliding: float
    """Sliding speed [m/s]."""
    flow_power: FloatArray | float = 0.0
    """Power per area that the pressure flow dissipates [W/m^2]."""

    @property
    def constants(self) -> LubricantHeat:
        """Thermal constants of the lubricant."""
        assert self.lubricant.heat is not None
        return self.lubricant.heat

    @property
    def _resistance(self) -> FloatArray:
        """Temperature rise in the middle of a uniformly heated film per heat and area [K m^2/W]."""
        return self.film / (8.0 * self.constants.conductivity)

    def _power(self, wall_rise: FloatArray, depth: FloatArray) -> FloatArray:
        """Return the heat per area that counts as released uniformly across the film [W/m^2]."""
        return self.shear(wall_rise, depth) * self.sliding + FLOW_SHARE * self.flow_power

    @cached_property
    def _newtonian(self) -> FloatArray:
        """Newtonian shear stress of the film without heating [Pa]."""
        return self.lubricant.viscosity(self.pressure) * (self.sliding / self.film)

    def shear(self, wall_rise: FloatArray, depth: FloatArray) -> FloatArray:
        """Return the shear stress [Pa] of the film at the given temperatures.

        wall_rise: temperature rise of the walls [K]; depth: rise in the middle of the film
        above the temperature of the walls, dimensionless, D in the theory [-].
        """
        warm = shear_factor(depth) / wall_fluidity(self.constants, wall_rise)
        oil = self.lubricant
        stress = thinned(
            oil.thinning, oil.limiting_coefficient, self._newtonian * warm, self.pressure
        )
        return self.filling * stress

    def warming(self, depth: FloatArray, wall_rise: FloatArray) -> FloatArray:
        """Return the dimensionless heating beta q h/(8 k) of the film [-].

        q is the heat per area that counts as released uniformly across the film, beta the
        temperature coefficient of the viscosity, h the film thickness and k the conductivity.
        """
        found: FloatArray = self.constants.beta * self._power(wall_rise, depth) * self._resistance
        return found

    def depth(self, wall_rise: FloatArray) -> FloatArray:
        """Return the parameter D of the temperature profile, the root of D tanh D = `warming(D)`.

        The root is unique, because D tanh D increases with D and `warming` decreases.
        """
        low = np.zeros_like(wall_rise)
        high = 1.0 + self.warming(low, wall_rise)
        for _ in range(BISECTIONS):
            middle = 0.5 * (low + high)
            below = middle * np.tanh(middle) < self.warming(middle, wall_rise)
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        found: FloatArray = 0.5 * (low + high)
        return found

    def middle_rise(self, wall_rise: FloatArray, depth: FloatArray) -> FloatArray:
        """Return the temperature rise in the mid-plane of the film [K]."""
        parabola = self._power(wall_rise, depth) * self._resistance
        # 2 ln cosh D/beta, over the value D tanh D/beta of the parabola
        with np.errstate(invalid="ignore", divide="ignore"):
            ratio = 2.0 * np.log(np.cosh(depth)) / (depth * np.tanh(depth))
        found: FloatArray = wall_rise + parabola * np.where(depth > 1e-4, ratio, 1.0)
        return found


def wall_fluidity(constants: LubricantHeat, rise: FloatArray) -> FloatArray:
    """Return (viscosity without heating)/(viscosity at the walls) [-].

    rise: temperature rise of the walls [K].
    """
    found: FloatArray = np.exp(constants.beta * rise)
    return found


def warm_fluidity(depth: FloatArray) -> FloatArray:
    """Return (viscosity at the walls)/(viscosity at the Gauss points `HEIGHTS`), shape (8, ...)."""
    heights = HEIGHTS.reshape(-1, *(1,) * depth.ndim)
    found: FloatArray = (np.cosh(depth) / np.cosh(heights * depth)) ** 2
    return found


def shear_factor(depth: FloatArray) -> FloatArray:
    """Return (shear rate at the walls)/(mean shear rate of the film), 2 D/sinh 2 D [-]."""
    twice = 2.0 * np.asarray(depth)
    near = twice < 1e-4
    with np.errstate(over="ignore"):
        found: FloatArray = np.where(
            near, 1.0 - twice**2 / 6.0, twice / np.sinh(np.where(near, 1.0, twice))
        )
    return found


__all__ = ["Conduction", "FilmHeat", "shear_factor", "wall_fluidity", "warm_fluidity"]

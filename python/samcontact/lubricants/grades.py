# SPDX-License-Identifier: GPL-3.0-or-later
"""Grades of mineral oils: viscosity versus temperature, and pressure-viscosity coefficient."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite, finite_array, positive
from .._util.display import HtmlTable, Rows
from .._util.short_text import in_short
from .lubricant import Lubricant

ISO_3448 = "ISO 3448, midpoint of the grade, www.united-oil.com"
TYPICAL_100 = "typical value of mineral oils, lubesolut.com/en/herramientas/tabla-viscosidades"
COLD, HOT = 313.15, 373.15
"""Temperatures at which the viscosities of a grade are given [K]: 40 and 100 °C."""
RANGE = 253.15, 423.15
"""Temperature range of Walther's law [K]; mineral oils solidify below, and decompose above it."""
DENSITY = 870.0
"""Default density of mineral oils [kg/m^3], whose densities range from 850 to 900."""

GRADES: dict[int, tuple[float, float]] = {
    10: (10.0, 2.5),
    15: (15.0, 3.5),
    22: (22.0, 4.5),
    32: (32.0, 5.5),
    46: (46.0, 6.5),
    68: (68.0, 8.5),
    100: (100.0, 11.4),
    150: (150.0, 14.5),
    220: (220.0, 19.0),
    320: (320.0, 24.5),
    460: (460.0, 32.0),
    680: (680.0, 42.0),
    1000: (1000.0, 55.0),
    1500: (1500.0, 74.0),
}
"""Kinematic viscosities [mm^2/s]: at 40 °C (ISO 3448), and at 100 °C (typical values)."""


@dataclass(frozen=True, repr=False)
class Oil(HtmlTable):
    """Mineral oil with two known viscosities, from `oil` or `iso_vg`.

    The kinematic viscosity nu follows Walther's law, lg lg (nu + 0.7) = A - B lg T, with nu in
    mm^2/s, T in K and decimal logarithms (ASTM D341; Walther 1931). The constants A and B are
    chosen such that the law gives both known viscosities.

    Attributes
    ----------
    name : str
        Designation, e.g. "ISO VG 68".
    nu40, nu100 : float
        Kinematic viscosity at 40 and 100 °C [m^2/s].
    density : float
        Density [kg/m^3], taken as constant; the real density decreases by about 4 % from 40 to
        100 °C.
    source : str
        Sources of the values.
    """

    name: str
    nu40: float
    nu100: float
    density: float = DENSITY
    source: str = ""

    def __post_init__(self) -> None:
        for name in ("nu40", "nu100", "density"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        if not 1e-7 < self.nu100 < self.nu40 < 1e-1:
            raise ValueError(
                "nu40 must be > nu100, and both between 1e-7 and 0.1 m^2/s, got nu40 = "
                f"{self.nu40!r} and nu100 = {self.nu100!r}: 68 mm^2/s (cSt) is 68e-6 m^2/s"
            )
        if not 300.0 < self.density < 3000.0:
            raise ValueError(
                f"density must be between 300 and 3000 kg/m^3, got {self.density!r}: 0.87 kg/l is "
                "870 kg/m^3"
            )

    def _walther(self) -> tuple[float, float]:
        """Return A and B of Walther's law."""
        cold, hot = (math.log10(math.log10(nu * 1e6 + 0.7)) for nu in (self.nu40, self.nu100))
        slope = (cold - hot) / math.log10(HOT / COLD)
        return cold + slope * math.log10(COLD), slope

    def kinematic_viscosity(self, T: ArrayLike) -> FloatArray:
        """Return the kinematic viscosity [m^2/s] at temperatures T of 253 to 423 K.

        The result has the shape of T. Raises ValueError for other temperatures.
        """
        A, B = self._walther()
        nu: FloatArray = 10.0**10.0 ** (A - B * np.log10(_temperatures(T))) - 0.7
        return 1e-6 * nu

    def viscosity(self, T: ArrayLike) -> FloatArray:
        """Return the viscosity [Pa s] at temperatures T of 253 to 423 K.

        The result has the shape of T. Raises ValueError for other temperatures.
        """
        return self.density * self.kinematic_viscosity(T)

    def beta(self, T: float) -> float:
        """Return the relative decrease of the viscosity per kelvin at a temperature T [K], in 1/K.

        Raises ValueError unless the temperature is 253 to 423 K.
        """
        A, B = self._walther()
        at = _temperature(T)
        logarithm = math.pow(10.0, A - B * math.log10(at))
        nu = 1e6 * float(self.kinematic_viscosity(at))
        return B * logarithm * math.log(10.0) * (nu + 0.7) / (at * nu)

    def pressure_viscosity(self, T: float) -> float:
        """Return the pressure-viscosity coefficient at a temperature T [K], in 1/Pa.

        The coefficient is computed by Wooster's formula for mineral oils, (0.6 + 0.965 lg eta)
        10^-8, with the viscosity eta in mPa s. It differs by -30 to +17 % (on average -12 %) from
        the measured values of thirteen mineral oils at 30, 60 and 100 °C in table 2.3 of Stachowiak
        & Batchelor, *Engineering Tribology* (2011). Raises ValueError unless the temperature is 253
        to 423 K.
        """
        eta = float(self.viscosity(_temperature(T)))
        return max(0.6 + 0.965 * math.log10(1e3 * eta), 0.0) * 1e-8

    def lubricant(self, T: float = COLD) -> Lubricant:
        """Return the lubricant at a temperature T [K] with Roelands' law of viscosity.

        Its density increases with the pressure as that of mineral oils (Dowson & Higginson).

        Raises ValueError unless the temperature is 253 to 423 K.
        """
        at = _temperature(T)
        return Lubricant.roelands(float(self.viscosity(at)), self.pressure_viscosity(at))

    def _rows(self) -> Rows:
        numbers = [(name, f"{1e6 * getattr(self, name):.4g} mm²/s") for name in ("nu40", "nu100")]
        density = f"{self.density:.4g} kg/m³"
        return [("name", self.name), *numbers, ("density", density), ("source", self.source)]

    def __repr__(self) -> str:
        return f"Oil({self.name!r}, nu40={self.nu40!r}, nu100={self.nu100!r})"


def iso_vg(grade: int | str) -> Oil:
    """Return a typical mineral oil of an ISO viscosity grade.

    grade: e.g. 68 or "ISO VG 68". The viscosity at 40 °C is the midpoint of the grade, from which
    oils deviate by up to 10 %; the viscosity at 100 °C is a typical value. If a data sheet states
    both viscosities, use `oil` instead. Raises ValueError for other grades, TypeError for other
    types.
    """
    known = ", ".join(map(str, GRADES))
    if isinstance(grade, bool) or not isinstance(grade, (int, str)):
        raise TypeError(
            f"grade must be a number or text such as 'ISO VG 68', got {in_short(grade)}"
        )
    digits = re.fullmatch(r"(?:iso)?\s*-?(?:vg)?\s*(\d{1,4})", str(grade)[:40].strip().lower())
    number = int(digits.group(1)) if digits else None
    if number not in GRADES:
        raise ValueError(f"grade must be one of ISO VG {known}, got {in_short(grade)}")
    nu40, nu100 = GRADES[number]
    source = f"40 °C: {ISO_3448}; 100 °C: {TYPICAL_100}"
    return Oil(f"ISO VG {number}", 1e-6 * nu40, 1e-6 * nu100, DENSITY, source)


def oil(nu40: float, nu100: float, density: float = DENSITY) -> Oil:
    """Return a mineral oil with the kinematic viscosities of a data sheet.

    nu40, nu100: kinematic viscosities at 40 and 100 °C [m^2/s], where 1 mm^2/s (1 cSt) is 1e-6
    m^2/s; density: density [kg/m^3]. Raises ValueError unless nu40 > nu100.
    """
    return Oil("oil", nu40, nu100, density, "given values")


def _temperatures(T: ArrayLike) -> FloatArray:
    at = finite_array("T", T)
    if at.size and not (RANGE[0] <= at.min() and at.max() <= RANGE[1]):
        raise ValueError(
            f"T must be from {RANGE[0]:g} to {RANGE[1]:g} K, got {at.min():.6g} to "
            f"{at.max():.6g} K: use kelvins, 40 °C is 313.15 K"
        )
    return at


def _temperature(T: float) -> float:
    return float(_temperatures(finite("T", T)))

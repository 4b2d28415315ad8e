# SPDX-License-Identifier: GPL-3.0-or-later
"""Lubricant: viscosity, density, shear stress and reduced pressure."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, non_negative, positive, together
from .._util.display import HtmlTable, Rows, quantity
from .._util.errors import UnitWarning
from .._util.short_text import in_short
from .density import DensityLaw, TabulatedDensity, Tait, density_law, pressures
from .shear import Carreau, Eyring, Newtonian, ShearThinning, thinned
from .tables import LubricantTables, reduced_pressure
from .viscosity import Barus, Doolittle, Tabulated, ViscosityLaw, roelands

MAX_VISCOSITY, MAX_PRESSURE_VISCOSITY, MAX_LIMITING_COEFFICIENT = 10.0, 1e-7, 0.3
"""Largest plausible viscosity at p = 0 [Pa s], pressure-viscosity coefficient [1/Pa], and ratio of
limiting shear stress to pressure [-]; for comparison, ISO VG 3200 has 3 Pa s at 40 °C."""
HEAT_CAPACITY_RANGE = 1e5, 1e7
"""Range of the volumetric heat capacity of liquids [J/(m^3 K)]."""
CONDUCTIVITY_RANGE = 0.01, 10.0
"""Range of the conductivity of liquids that are not metals [W/(m K)]."""
MAX_LOGARITHM = 250.0
"""Largest ln(viscosity ratio); at larger values the lubricant is solid in any contact."""


NEWTONIAN = Newtonian()


@dataclass(frozen=True)
class LubricantHeat:
    """Thermal constants of a lubricant; see `Lubricant.with_thermal`.

    Attributes
    ----------
    conductivity : float
        Conductivity [W/(m K)].
    capacity : float
        Heat capacity per volume [J/(m^3 K)].
    beta : float
        Relative decrease of the viscosity per kelvin [1/K].
    temperature : float
        Temperature for which the viscosity is given [K].
    """

    conductivity: float
    capacity: float
    beta: float
    temperature: float = 313.15

    def __post_init__(self) -> None:
        for name in ("conductivity", "capacity", "temperature"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        object.__setattr__(self, "beta", non_negative("beta", self.beta))
        _warn_outside("conductivity", self.conductivity, CONDUCTIVITY_RANGE, "W/(m K)")
        _warn_outside("capacity", self.capacity, HEAT_CAPACITY_RANGE, "J/(m^3 K)")


@dataclass(frozen=True, repr=False)
class Lubricant(HtmlTable):
    """Lubricant, made by `roelands`, `barus`, `doolittle`, `tabulated` or `lubricants.iso_vg`.

    Attributes
    ----------
    eta0 : float
        Viscosity at zero pressure [Pa s].
    law : ViscosityLaw
        Viscosity versus pressure.
    density_law : DensityLaw
        Density versus pressure.
    thinning : ShearThinning
        Shear stress versus shear rate; see `with_eyring` and `with_carreau`.
    limiting_coefficient : float, or None
        Ratio of the limiting shear stress to the pressure [-]; see `with_limiting_shear`.
    heat : LubricantHeat, or None
        Thermal constants; see `with_thermal`.
    """

    eta0: float
    law: ViscosityLaw
    density_law: DensityLaw
    thinning: ShearThinning = NEWTONIAN
    limiting_coefficient: float | None = None
    heat: LubricantHeat | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "eta0", positive("eta0", self.eta0))
        for name, kind in _KINDS.items():
            if not isinstance(getattr(self, name), kind):
                raise TypeError(
                    f"{name} must be a {kind.__name__}, got {in_short(getattr(self, name))}: use "
                    "Lubricant.roelands or another constructor"
                )
        if self.limiting_coefficient is not None:
            limit = positive("limiting_coefficient", self.limiting_coefficient)
            object.__setattr__(self, "limiting_coefficient", limit)
        if self.heat is not None and not isinstance(self.heat, LubricantHeat):
            raise TypeError(
                f"heat must be a LubricantHeat, got {in_short(self.heat)}: use "
                "Lubricant.with_thermal"
            )

    @classmethod
    def roelands(
        cls,
        viscosity: float,
        pressure_viscosity: float,
        z: float | None = None,
        density: DensityLaw | str | None = "dowson-higginson",
    ) -> Lubricant:
        """Lubricant with the law eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z - 1]} (Roelands 1966).

        viscosity: eta0 [Pa s]; pressure_viscosity: slope alpha of ln(viscosity) at p = 0 [1/Pa]. If
        z is None, p0 = 0.198 GPa and z = alpha p0/(ln eta0 + 9.67); if z is given [-], p0 follows
        from alpha. density: "dowson-higginson", None (incompressible) or a law of
        `samcontact.lubricants`. Raises ValueError for values outside their range.
        """
        eta0, alpha = _plausible(viscosity, pressure_viscosity)
        return cls(eta0, roelands(eta0, alpha, z), density_law(density))

    @classmethod
    def barus(
        cls,
        viscosity: float,
        pressure_viscosity: float,
        density: DensityLaw | str | None = "dowson-higginson",
    ) -> Lubricant:
        """Lubricant with the law eta0 exp(alpha p) (Barus 1893), which is too steep above 0.5 GPa.

        viscosity: eta0 [Pa s]; pressure_viscosity: alpha [1/Pa], 0 for an isoviscous lubricant;
        density: as for `roelands`. Raises ValueError for values outside their range.
        """
        eta0, alpha = _plausible(viscosity, pressure_viscosity)
        return cls(eta0, Barus(alpha), density_law(density))

    @classmethod
    def doolittle(
        cls, viscosity: float, B: float, R0: float, bulk_modulus: float, modulus_slope: float
    ) -> Lubricant:
        """Lubricant with Doolittle's law of free volume and Tait's equation of state.

        viscosity: value at p = 0 [Pa s]; B: Doolittle's constant [-]; R0: occupied volume as a
        share of the volume at p = 0 [-]; bulk_modulus: K at p = 0 [Pa]; modulus_slope: dK/dp [-].
        Raises ValueError for values outside their range. Sources: Doolittle (1951,
        doi:10.1063/1.1699894); Dymond & Malhotra (1988, doi:10.1007/BF01133262).
        """
        state = Tait(bulk_modulus, modulus_slope)
        law = Doolittle(B, R0, state)
        eta0, _ = _plausible(viscosity, law.pressure_viscosity, "bulk_modulus")
        return cls(eta0, law, state)

    @classmethod
    def tabulated(cls, p: ArrayLike, eta: ArrayLike, rho: ArrayLike | None = None) -> Lubricant:
        """Lubricant with a measured viscosity, interpolated monotonically in its logarithm.

        p: pressures, increasing from 0 [Pa]; eta: viscosities [Pa s]; rho: densities in any unit,
        or None (incompressible). Raises ValueError unless eta and rho are positive and do not
        decrease.
        """
        law = Tabulated(p, eta)
        density = density_law(None) if rho is None else TabulatedDensity(law.p, rho)
        eta0, _ = _plausible(float(np.asarray(law.eta)[0]), law.pressure_viscosity, "p")
        return cls(eta0, law, density)

    def with_eyring(self, stress: float) -> Lubricant:
        """Return a copy with Eyring's shear thinning.

        stress: Eyring stress [Pa], > 0. Raises ValueError for other values.
        """
        return replace(self, thinning=Eyring(positive("stress", stress)))

    def with_carreau(self, stress: float, n: float) -> Lubricant:
        """Return a copy with Carreau's shear thinning.

        stress: critical shear stress [Pa], > 0; n: exponent in [0, 1]. Raises ValueError for other
        values.
        """
        return replace(self, thinning=Carreau(positive("stress", stress), n))

    def with_limiting_shear(self, coefficient: float) -> Lubricant:
        """Return a copy whose shear stress stays below `coefficient` times the pressure.

        coefficient: > 0; 0.03 to 0.1 for oils [-]. The limit is approached smoothly, as
        (tau^-6 + (coefficient p)^-6)^(-1/6), where tau is the shear stress without limit and p the
        pressure. Raises ValueError for values that are not > 0.
        """
        limit = positive("coefficient", coefficient)
        if limit > MAX_LIMITING_COEFFICIENT:
            _warn("coefficient", limit, f"<= {MAX_LIMITING_COEFFICIENT:g}", "0.05, not 5 %")
        return replace(self, limiting_coefficient=limit)

    def with_thermal(
        self, conductivity: float, capacity: float, beta: float, temperature: float = 313.15
    ) -> Lubricant:
        """Return a copy with thermal constants.

        conductivity: thermal conductivity [W/(m K)]; capacity: heat capacity per volume
        [J/(m^3 K)]; beta: constant of the viscosity eta(p) exp(-beta (T - T0)) at a temperature T,
        >= 0 [1/K]; temperature: T0, for which the viscosity eta(p) is given [K]. Raises ValueError
        for values outside their range.
        """
        return replace(self, heat=LubricantHeat(conductivity, capacity, beta, temperature))

    @property
    def pressure_viscosity(self) -> float:
        """Slope d(ln viscosity)/dp at p = 0 [1/Pa]."""
        return self.law.pressure_viscosity

    @property
    def is_newtonian(self) -> bool:
        """Whether the shear stress is proportional to the shear rate, without a limit."""
        return self.thinning == NEWTONIAN and self.limiting_coefficient is None

    @property
    def max_pressure(self) -> float:
        """Largest pressure of a tabulated viscosity [Pa]; infinite for other laws."""
        return self.law.max_pressure

    def viscosity(self, p: ArrayLike, T: ArrayLike | None = None) -> FloatArray:
        """Return the viscosity at small shear rates [Pa s].

        p: pressures >= 0 [Pa]; T: temperatures [K] (require `with_thermal`), or None for the
        temperature for which the viscosity is given. p and T are broadcast. Raises ValueError for
        pressures above `max_pressure`.
        """
        given = pressures(p)
        if given.size and given.max() > self.max_pressure:
            raise ValueError(
                f"p must be <= {self.max_pressure:.4g} Pa, the last pressure of the table, got "
                f"{given.max():.4g}: extend the table"
            )
        logarithm = self.law.logarithm(given)
        if T is not None:
            if self.heat is None:
                raise ValueError(
                    "with T, the lubricant must have thermal constants, got none: use "
                    "Lubricant.with_thermal, or omit T"
                )
            given, at = together(p=given, T=T)
            logarithm = self.law.logarithm(given)
            if at.size and at.min() <= 0.0:
                raise ValueError(f"T must be > 0 K, got {at.min():.4g}: use kelvins")
            logarithm = logarithm - self.heat.beta * (at - self.heat.temperature)
        viscosity: FloatArray = self.eta0 * np.exp(np.minimum(logarithm, MAX_LOGARITHM))
        return viscosity

    def density(self, p: ArrayLike) -> FloatArray:
        """Return the density relative to the density at p = 0 [-], at pressures p >= 0 [Pa]."""
        return self.density_law.ratio(p)

    def shear_stress(self, rate: ArrayLike, p: ArrayLike, T: ArrayLike | None = None) -> FloatArray:
        """Return the shear stress [Pa], with the sign of the shear rate.

        rate: shear rates [1/s]; p: pressures >= 0 [Pa]; T: temperatures [K] or None. The arguments
        are broadcast. Shear thinning and the limiting shear stress of the lubricant are included.
        """
        rate, pressure = finite_array("rate", rate), pressures(p)
        try:
            rate, pressure = np.broadcast_arrays(rate, pressure)
        except ValueError:
            raise ValueError(
                "p must have a shape that is compatible with that of rate, "
                f"{rate.shape}, got {pressure.shape}"
            ) from None
        newtonian = self.viscosity(pressure, T) * np.abs(rate)
        stress = thinned(self.thinning, self.limiting_coefficient, newtonian, pressure)
        signed: FloatArray = np.sign(rate) * stress
        return signed

    def tables(self, max_pressure: float) -> LubricantTables:
        """Return tables of density and reduced pressure versus pressure, up to a pressure [Pa].

        The reduced pressure is the integral of (relative density)/viscosity from pressure 0 to p.
        Choose `max_pressure` so large that no iterate of a solver exceeds it. Raises ValueError
        unless `max_pressure` is > 0.
        """
        return reduced_pressure(
            positive("max_pressure", max_pressure), self._fluidity, self.density_law
        )

    def _fluidity(self, p: FloatArray) -> FloatArray:
        """Return (relative density)/viscosity [1/(Pa s)], even above `max_pressure`."""
        logarithm = np.minimum(self.law.logarithm(p), MAX_LOGARITHM)
        return self.density_law.ratio(p) * np.exp(-logarithm) / self.eta0

    def _rows(self) -> Rows:
        alpha = f"{self.pressure_viscosity * 1e9:.4g} 1/GPa"
        rows = [("viscosity", quantity(self.eta0, "Pa s")), ("pressure-viscosity", alpha)]
        rows += [(item.name, repr(getattr(self, item.name))) for item in fields(self)[1:4]]
        if self.limiting_coefficient is not None:
            rows.append(("limiting_coefficient", f"{self.limiting_coefficient:.4g}"))
        return rows if self.heat is None else [*rows, ("heat", repr(self.heat))]

    def __repr__(self) -> str:
        return f"Lubricant({', '.join(f'{name}={value}' for name, value in self._rows())})"


_KINDS = {"law": ViscosityLaw, "density_law": DensityLaw, "thinning": ShearThinning}


def _plausible(
    viscosity: float, pressure_viscosity: float, name: str = "pressure_viscosity"
) -> tuple[float, float]:
    """Return viscosity and pressure-viscosity coefficient; warn of likely unit errors."""
    eta0 = positive("viscosity", viscosity)
    alpha = non_negative(name, pressure_viscosity)
    if eta0 > MAX_VISCOSITY:
        remedy = "Pa s; 40 mPa s (cP) is 0.04 Pa s"
        _warn("viscosity", eta0, f"<= {MAX_VISCOSITY:g} Pa s", remedy)
    if alpha > MAX_PRESSURE_VISCOSITY:
        is_given = name == "pressure_viscosity"
        remedy = "1/Pa; 22 1/GPa is 22e-9 1/Pa" if is_given else f"Pa for {name}"
        text = name if is_given else f"pressure-viscosity coefficient that follows from {name}"
        _warn(text, alpha, f"<= {MAX_PRESSURE_VISCOSITY:g} 1/Pa", remedy)
    return eta0, alpha


def _warn(name: str, value: float, expected: str, remedy: str) -> None:
    warnings.warn(
        f"{name} of a lubricant should be {expected}, got {value:.4g}. Use {remedy}.",
        UnitWarning,
        stacklevel=4,
    )


def _warn_outside(name: str, value: float, limits: tuple[float, float], unit: str) -> None:
    if not limits[0] <= value <= limits[1]:
        _warn(name, value, f"{limits[0]:g} to {limits[1]:g} {unit}", unit)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Lubricants of a case file: one section per viscosity law, and oils by grade or data sheet."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, model_validator

from .. import lubricants
from ..lubricants import Lubricant, LubricantHeat
from ..lubricants.grades import DENSITY
from .base import NonNegative, Positive, Section
from .converted import Unit

Viscosity = Annotated[Positive, Unit("Pa*s")]
PressureViscosity = Annotated[NonNegative, Unit("1/Pa")]
Kinematic = Annotated[Positive, Unit("m**2/s")]
Temperature = Annotated[Positive, Unit("K")]
Stress = Annotated[Positive, Unit("Pa")]
REFERENCE = LubricantHeat.temperature
"""Default temperature at which the viscosity is given [K]."""
Density = Literal["dowson-higginson", "incompressible"]


class LubricantThermal(Section):
    """Thermal constants of a lubricant, see `Lubricant.with_thermal`."""

    conductivity: Annotated[Positive, Unit("W/(m*K)")]
    capacity: Annotated[Positive, Unit("J/(m**3*K)")]
    beta: Annotated[NonNegative, Unit("1/K")] | None = None
    temperature: Temperature | None = None


class _Lubricant(Section):
    """Lubricant, with optional constants for its shear stress (friction) and its heating."""

    eyring_stress: Stress | None = None
    carreau_stress: Stress | None = None
    carreau_exponent: Annotated[float, Field(ge=0.0, le=1.0)] | None = None
    limiting_shear: Positive | None = None
    thermal: LubricantThermal | None = None

    @model_validator(mode="after")
    def _possible(self) -> _Lubricant:
        carreau = [self.carreau_stress, self.carreau_exponent]
        if (carreau[0] is None) != (carreau[1] is None):
            raise ValueError("carreau_stress and carreau_exponent must be given together")
        if self.eyring_stress is not None and carreau[0] is not None:
            raise ValueError("eyring_stress and carreau_stress cannot be combined: omit one")
        self.build()
        return self

    @abstractmethod
    def newtonian(self) -> Lubricant:
        """Return the lubricant without shear thinning."""

    def build(self) -> Lubricant:
        """Create the `Lubricant`."""
        made = self.newtonian()
        if self.eyring_stress is not None:
            made = made.with_eyring(self.eyring_stress)
        if self.carreau_stress is not None and self.carreau_exponent is not None:
            made = made.with_carreau(self.carreau_stress, self.carreau_exponent)
        if self.limiting_shear is not None:
            made = made.with_limiting_shear(self.limiting_shear)
        if self.thermal is not None:
            heat = self.thermal
            beta, temperature = self._warming(heat)
            made = made.with_thermal(heat.conductivity, heat.capacity, beta, temperature)
        return made

    def _warming(self, heat: LubricantThermal) -> tuple[float, float]:
        """Return thermal.beta [1/K], and the temperature [K] to which the viscosity refers."""
        if heat.beta is None:
            raise ValueError("thermal.beta is required unless kind is grade or oil: add it")
        return heat.beta, REFERENCE if heat.temperature is None else heat.temperature


class RoelandsLubricant(_Lubricant):
    """Roelands' law, see `Lubricant.roelands`."""

    kind: Literal["roelands"]
    viscosity: Viscosity
    pressure_viscosity: PressureViscosity
    z: Positive | None = None
    density: Density = "dowson-higginson"

    def newtonian(self) -> Lubricant:
        return Lubricant.roelands(
            self.viscosity, self.pressure_viscosity, self.z, density=_law(self.density)
        )


class BarusLubricant(_Lubricant):
    """Barus' law, see `Lubricant.barus`."""

    kind: Literal["barus"]
    viscosity: Viscosity
    pressure_viscosity: PressureViscosity
    density: Density = "dowson-higginson"

    def newtonian(self) -> Lubricant:
        return Lubricant.barus(self.viscosity, self.pressure_viscosity, density=_law(self.density))


class DoolittleLubricant(_Lubricant):
    """Doolittle's free-volume law, see `Lubricant.doolittle`."""

    kind: Literal["doolittle"]
    viscosity: Viscosity
    B: Positive
    R0: Annotated[float, Field(gt=0.0, lt=1.0)]
    bulk_modulus: Stress
    modulus_slope: Positive

    def newtonian(self) -> Lubricant:
        return Lubricant.doolittle(
            self.viscosity, self.B, self.R0, self.bulk_modulus, self.modulus_slope
        )


class TabulatedLubricant(_Lubricant):
    """Measured viscosity versus pressure, see `Lubricant.tabulated`."""

    kind: Literal["tabulated"]
    p: Annotated[list[NonNegative], Field(min_length=3), Unit("Pa")]
    eta: Annotated[list[Positive], Field(min_length=3), Unit("Pa*s")]
    rho: Annotated[list[Positive], Field(min_length=3), Unit("kg/m**3")] | None = None

    def newtonian(self) -> Lubricant:
        return Lubricant.tabulated(self.p, self.eta, self.rho)


class _MineralOil(_Lubricant):
    """Oil whose viscosity is known at two temperatures."""

    temperature: Temperature

    @abstractmethod
    def oil(self) -> lubricants.Oil:
        """Return the oil."""

    def newtonian(self) -> Lubricant:
        try:
            return self.oil().lubricant(self.temperature)
        except ValueError as error:
            raise ValueError(str(error).replace("T must", "temperature must", 1)) from None

    def _warming(self, heat: LubricantThermal) -> tuple[float, float]:
        if heat.temperature is not None:
            raise ValueError(
                "thermal.temperature cannot be combined with temperature: omit thermal.temperature"
            )
        beta = self.oil().beta(self.temperature) if heat.beta is None else heat.beta
        return beta, self.temperature


class GradeLubricant(_MineralOil):
    """Typical mineral oil of an ISO viscosity grade, see `lubricants.iso_vg`."""

    kind: Literal["grade"]
    grade: Annotated[
        str, BeforeValidator(lambda given: str(given) if type(given) is int else given)
    ]

    def oil(self) -> lubricants.Oil:
        return lubricants.iso_vg(self.grade)


class OilLubricant(_MineralOil):
    """Mineral oil with viscosities from its data sheet, see `lubricants.oil`."""

    kind: Literal["oil"]
    nu40: Kinematic
    nu100: Kinematic
    mass_density: Annotated[Positive, Unit("kg/m**3")] = DENSITY

    def oil(self) -> lubricants.Oil:
        return lubricants.oil(self.nu40, self.nu100, self.mass_density)


def _law(density: str) -> str | None:
    return None if density == "incompressible" else density


def _with_kind(given: Any) -> Any:
    """Add the omitted `kind` to a lubricant if it follows from the fields `grade` or `nu40`."""
    if not isinstance(given, Mapping) or "kind" in given:
        return given
    for name, kind in (("grade", "grade"), ("nu40", "oil")):
        if name in given:
            return {"kind": kind, **given}
    return given


LubricantSection = Annotated[
    Annotated[
        RoelandsLubricant
        | BarusLubricant
        | DoolittleLubricant
        | TabulatedLubricant
        | GradeLubricant
        | OilLubricant,
        Field(discriminator="kind"),
    ],
    BeforeValidator(_with_kind),
]

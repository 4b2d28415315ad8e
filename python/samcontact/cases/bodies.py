# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of a case file for the bodies: one model for each law of `samcontact._laws`."""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, create_model, model_validator

from .._laws import LAWS, Constant, Law
from .base import Finite, NonNegative, Positive, Section, in_unit

if TYPE_CHECKING:
    from ..layered import Body
    from ..material import Material


class KinematicHardening(Section):
    """Moves the yield surface with the plastic strain, see `Material.with_kinematic_hardening`."""

    modulus: Annotated[Positive | list[Positive], in_unit("Pa")]
    recovery: NonNegative | list[NonNegative] = 0.0

    @model_validator(mode="after")
    def _as_many(self) -> KinematicHardening:
        moduli = self.modulus if isinstance(self.modulus, list) else [self.modulus]
        if not 1 <= len(moduli) <= 4:
            raise ValueError(f"modulus must have from 1 to 4 values, got {len(moduli)}")
        if isinstance(self.recovery, list) and len(self.recovery) != len(moduli):
            raise ValueError(
                f"recovery must have as many values as modulus, {len(moduli)}, "
                f"got {len(self.recovery)}"
            )
        return self


class ThermalConstants(Section):
    """Of a body that frictional heat enters, see `Material.with_thermal`."""

    conductivity: Annotated[Positive, in_unit("W/(m*K)")]
    expansion: Annotated[NonNegative, in_unit("1/K")]
    diffusivity: Annotated[Positive, in_unit("m**2/s")]


class JohnsonCookSoftening(Section):
    """Yield stress that falls with the temperature, see `softening.JohnsonCook`."""

    kind: Literal["johnson_cook"]
    melting: Annotated[Positive, in_unit("K")]
    m: Positive
    reference: Annotated[NonNegative, in_unit("K")] = 293.15
    ambient: Annotated[NonNegative, in_unit("K")] = 293.15
    floor: Annotated[float, Field(gt=0.0, le=1.0)] = 0.01

    @model_validator(mode="after")
    def _melts_above_reference(self) -> JohnsonCookSoftening:
        if not self.melting > self.reference:
            raise ValueError(
                f"melting must be > reference = {self.reference!r} K, got {self.melting!r}"
            )
        return self


class LayerSection(Section):
    """An elastic layer on a body, see `Layered`."""

    E: Annotated[Positive, in_unit("Pa")]
    nu: Annotated[Finite, Field(ge=0.0, lt=0.5)]
    thickness: Annotated[Positive, in_unit("m")]


Depths = Annotated[list[NonNegative], Field(min_length=1), in_unit("m")]
Stresses = Annotated[list[Finite], in_unit("Pa")]


class YieldProfile(Section):
    """Yield stress that changes with depth, see `Material.with_yield_profile`."""

    z: Depths
    factor: list[Positive]


class InitialStress(Section):
    """Stress that is there before any contact, see `Material.with_residual_stress`."""

    z: Depths
    sxx: Stresses
    syy: Stresses | None = None
    sxy: Stresses | None = None


_BESIDE = ("kinematic", "thermal", "softening", "yield_profile", "residual_stress")


class _Body(Section):
    if TYPE_CHECKING:
        law: str

    @property
    def is_plastic(self) -> bool:
        return isinstance(self, _PlasticBody)

    @model_validator(mode="after")
    def _possible(self) -> _Body:
        """What the core asks of several constants together."""
        self.build()
        return self

    @property
    def coating(self) -> list[LayerSection]:
        """Layers on it, from the surface down."""
        return getattr(self, "layers", None) or []

    @property
    def is_rigid(self) -> bool:
        return self.law == "rigid" and not self.coating

    def build(self) -> Body:
        """The material, below its layers."""
        from ..layered import Layered
        from ..material import Material

        material = self._material()
        if not self.coating:
            return material
        layers = [(Material.elastic(part.E, part.nu), part.thickness) for part in self.coating]
        return Layered(tuple(layers), material)

    def _material(self) -> Material:
        from ..material import Material
        from ..softening import JohnsonCook

        parameters = self.model_dump(exclude={"layers"})
        extra = {name: parameters.pop(name, None) for name in _BESIDE}
        material: Material = getattr(Material, parameters.pop("law"))(**parameters)
        if extra["kinematic"] is not None:
            material = material.with_kinematic_hardening(**extra["kinematic"])
        if extra["thermal"] is not None:
            material = material.with_thermal(**extra["thermal"])
        if extra["softening"] is not None:
            del extra["softening"]["kind"]
            material = material.with_softening(JohnsonCook(**extra["softening"]))
        if extra["yield_profile"] is not None:
            material = material.with_yield_profile(**extra["yield_profile"])
        if extra["residual_stress"] is not None:
            material = material.with_residual_stress(**extra["residual_stress"])
        return material


class _CoatableBody(_Body):
    layers: Annotated[list[LayerSection], Field(min_length=1)] | None = None


class _ElasticBody(_Body):
    thermal: ThermalConstants | None = None
    residual_stress: InitialStress | None = None


class _CoatableElasticBody(_ElasticBody, _CoatableBody):
    pass


class _PlasticBody(_ElasticBody):
    kinematic: KinematicHardening | None = None
    softening: JohnsonCookSoftening | None = None
    yield_profile: YieldProfile | None = None


def _field(constant: Constant) -> Any:
    limits = Field(gt=constant.gt, ge=constant.ge, lt=constant.lt, le=constant.le)
    value: Any = Annotated[Finite, limits]
    if constant.many:
        value = list[value]
    return (
        value if constant.unit in ("", "microstrain") else Annotated[value, in_unit(constant.unit)]
    )


def _model(name: str, law: Law) -> type[_Body]:
    """The section of a law, e.g. `SwiftBody`."""
    base = _PlasticBody if law.yields else _CoatableElasticBody if law.constants else _CoatableBody
    fields: dict[str, Any] = {"law": (Literal[name], ...)}
    fields |= {constant: (_field(law.constants[constant]), ...) for constant in law.constants}
    title = "".join(word.capitalize() for word in name.split("_"))
    return create_model(f"{title}Body", __base__=base, __doc__=law.says, **fields)


if TYPE_CHECKING:
    BodySection = _Body
else:
    _MODELS = tuple(_model(name, law) for name, law in LAWS.items())
    BodySection = Annotated[reduce(or_, _MODELS), Field(discriminator="law")]

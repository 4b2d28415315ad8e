# SPDX-License-Identifier: GPL-3.0-or-later
"""Body sections of a case file: one model for each hardening law."""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import (
    BeforeValidator,
    Field,
    ModelWrapValidatorHandler,
    create_model,
    model_validator,
)

from .. import materials
from ..bodies.hardening_laws import LAWS, Constant, Law
from ..hardness import HardnessProfile, hardened_case
from ..materials.library import ADVICE
from .base import Finite, NonNegative, Positive, Section, changed, in_unit

if TYPE_CHECKING:
    from typing_extensions import Self

    from ..bodies.layered import Body
    from ..bodies.material import Material


class KinematicHardening(Section):
    """Kinematic hardening, see `Material.with_kinematic_hardening`."""

    modulus: Annotated[Positive | list[Positive], in_unit("Pa")]
    recovery: NonNegative | list[NonNegative] = 0.0

    @model_validator(mode="after")
    def _as_lists(self) -> KinematicHardening:
        moduli = self.modulus if isinstance(self.modulus, list) else [self.modulus]
        if not 1 <= len(moduli) <= 4:
            raise ValueError(f"modulus must have 1 to 4 values, got {len(moduli)}")
        if isinstance(self.recovery, list) and len(self.recovery) != len(moduli):
            raise ValueError(
                f"recovery must have as many values as modulus ({len(moduli)}), got "
                f"{len(self.recovery)}"
            )
        return self


class ThermalConstants(Section):
    """Thermal constants of a body, see `Material.with_thermal`."""

    conductivity: Annotated[Positive, in_unit("W/(m*K)")]
    expansion: Annotated[NonNegative, in_unit("1/K")]
    diffusivity: Annotated[Positive, in_unit("m**2/s")]


class JohnsonCookSoftening(Section):
    """Yield stress that decreases with temperature, see `softening.JohnsonCook`."""

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
                f"melting must be greater than reference ({self.reference!r} K), got "
                f"{self.melting!r} K"
            )
        return self


Depths = Annotated[list[NonNegative], Field(min_length=1), in_unit("m")]
Stresses = Annotated[list[Finite], in_unit("Pa")]


class YieldProfile(Section):
    """Profile of the yield stress over depth, see `Material.with_yield_profile`."""

    z: Depths
    factor: list[Positive]


class InitialStress(Section):
    """Initial (residual) stress, see `Material.with_residual_stress`."""

    z: Depths
    sxx: Stresses
    syy: Stresses | None = None
    sxy: Stresses | None = None


Vickers = Annotated[float, Field(ge=20.0, le=3000.0)]


class HardnessSection(Section):
    """Hardness over depth, which determines the yield stress, see `samcontact.hardness`."""

    surface: Vickers | None = None
    core: Vickers | None = None
    depth: Annotated[Positive, in_unit("m")] | None = None
    limit: Vickers = 550.0
    z: Depths | None = None
    HV: list[Vickers] | None = None

    @model_validator(mode="after")
    def _one_form(self) -> HardnessSection:
        case = [self.surface, self.core, self.depth]
        points = [self.z, self.HV]
        other = points if None not in case else case
        if (None in case) == (None in points) or any(value is not None for value in other):
            raise ValueError("surface, core and depth, or z and HV must be given")
        if self.z is not None and changed(self, ["limit"]):
            raise ValueError("limit belongs to depth: omit it with z and HV")
        self.build()
        return self

    def build(self) -> HardnessProfile:
        """Create the profile."""
        if self.surface is not None and self.core is not None and self.depth is not None:
            return hardened_case(self.surface, self.core, self.depth, self.limit)
        return HardnessProfile(tuple(self.z or ()), tuple(self.HV or ()))


class FreeFaces(Section):
    """Free end faces of a body, see `Material.with_free_faces`."""

    low: Annotated[Finite, in_unit("m")] | None = None
    high: Annotated[Finite, in_unit("m")] | None = None
    method: Literal["exact", "factor"] = "exact"


class RelaxationSection(Section):
    """Viscoelastic relaxation of a body, see `Material.with_relaxation`."""

    times: Annotated[list[Positive], Field(min_length=1), in_unit("s")]
    shares: Annotated[list[Positive], Field(min_length=1)]


_BODY_TABLES = (
    "kinematic", "thermal", "softening", "yield_profile", "residual_stress", "free_faces",
    "relaxation",
)  # fmt: skip
_OTHER_FIELDS = {"layers", "thickness", "material", "hardness"}


class _Solid(Section):
    """Material with a hardening law and optional properties."""

    if TYPE_CHECKING:
        law: str

    @property
    def known(self) -> materials.MaterialData | None:
        """Entry of the library that `material` names."""
        name = getattr(self, "material", None)
        return None if name is None else materials.get(name)

    @property
    def profile(self) -> HardnessProfile | None:
        """Hardness over depth; None if it is not given."""
        section: HardnessSection | None = getattr(self, "hardness", None)
        return None if section is None else section.build()

    @property
    def solid(self) -> Material:
        """Material of the section, without layers."""
        from ..bodies.material import Material
        from ..softening import JohnsonCook

        parameters = self.model_dump(exclude=_OTHER_FIELDS)
        extra = {name: parameters.pop(name, None) for name in _BODY_TABLES}
        material: Material = getattr(Material, parameters.pop("law"))(**parameters)
        if extra["kinematic"] is not None:
            material = material.with_kinematic_hardening(**extra["kinematic"])
        if extra["thermal"] is not None:
            material = material.with_thermal(**extra["thermal"])
        elif self.known is not None and self.known.thermal is not None:
            material = material.with_thermal(*self.known.thermal)
        if extra["softening"] is not None:
            del extra["softening"]["kind"]
            material = material.with_softening(JohnsonCook(**extra["softening"]))
        if extra["yield_profile"] is not None:
            material = material.with_yield_profile(**extra["yield_profile"])
        if self.profile is not None and material.is_plastic:
            if extra["yield_profile"] is not None:
                raise ValueError("hardness cannot be combined with yield_profile: omit one of them")
            material = self.profile.applied_to(material)
        if extra["residual_stress"] is not None:
            material = material.with_residual_stress(**extra["residual_stress"])
        if extra["free_faces"] is not None:
            material = material.with_free_faces(**extra["free_faces"])
        if extra["relaxation"] is not None:
            material = material.with_relaxation(**extra["relaxation"])
        return material


def _with_constants(given: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a body with the constants that the library has for its material."""
    law, name = given.get("law"), given.get("material")
    if not isinstance(law, str) or not isinstance(name, str):
        return given  # refused by the types of the fields
    try:
        known = materials.get(name).constants(law)
    except ValueError as error:
        text = str(error).replace("name must", "material must", 1)
        remedy = "for another material, omit material and write its constants, e.g. E and nu"
        raise ValueError(text.replace(ADVICE, remedy)) from None
    for field in ("E", "nu"):
        if field in given and field in known:
            raise ValueError(
                f"{field} cannot be combined with material = {name!r}, which has {field}: omit one "
                "of them"
            )
    missing = [field for field in LAWS[law].constants if field not in known | given]
    if missing:
        raise ValueError(
            f"{', '.join(missing)} must be given: the library has no such value of {name!r} for "
            f"law = {law!r}"
        )
    return known | given


class _ElasticSolid(_Solid):
    material: str | None = None

    @model_validator(mode="wrap")
    @classmethod
    def _from_library(cls, given: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        """Take constants from the library; mark only fields given in the case file as set."""
        if not isinstance(given, dict) or given.get("material") is None:
            return handler(given)
        if type(given["material"]) is int:  # 52100 and 4140 without quotes
            given = given | {"material": str(given["material"])}
        made = handler(_with_constants(given))
        made.model_fields_set.intersection_update(given)
        return made

    hardness: HardnessSection | None = None
    residual_stress: InitialStress | None = None
    thermal: ThermalConstants | None = None


class _PlasticSolid(_ElasticSolid):
    kinematic: KinematicHardening | None = None
    yield_profile: YieldProfile | None = None
    softening: JohnsonCookSoftening | None = None


class _Layer(_Solid):
    """Layer of a coated body, see `Layered`."""

    thickness: Annotated[Positive, in_unit("m")]


class _ElasticLayer(_ElasticSolid, _Layer):
    relaxation: RelaxationSection | None = None


class _PlasticLayer(_PlasticSolid, _Layer):
    pass


def field_of(constant: Constant) -> Any:
    """Return the annotation of a case-file field for a constant of a hardening law."""
    limits = Field(gt=constant.gt, ge=constant.ge, lt=constant.lt, le=constant.le)
    value: Any = Annotated[float if constant.infinite else Finite, limits]
    if constant.many:
        value = list[value]
    return (
        value if constant.unit in ("", "microstrain") else Annotated[value, in_unit(constant.unit)]
    )


def _model(name: str, law: Law, part: str, *bases: type[_Solid]) -> Any:
    """Create the case-file section of a hardening law, e.g. `SwiftBody`.

    bases: base classes for rigid, elastic and elastic-plastic laws.
    """
    base = bases[2] if law.yields else bases[1] if law.constants else bases[0]
    fields: dict[str, Any] = {"law": (Literal[name], ...)}
    fields |= {constant: (field_of(law.constants[constant]), ...) for constant in law.constants}
    title = "".join(word.capitalize() for word in name.split("_"))
    made = create_model(
        f"{title}{part}", __base__=base, __doc__=law.says, __module__=__name__, **fields
    )
    globals()[made.__name__] = made  # for pickling
    return made


def _models(part: str, *bases: type[_Solid]) -> Any:
    laws = {name: law for name, law in LAWS.items() if law.constants or part == "Body"}
    models = tuple(_model(name, law, part, *bases) for name, law in laws.items())
    return Annotated[reduce(or_, models), Field(discriminator="law")]


def _layer_law(given: Any) -> Any:
    """Add law = "elastic" to layers without a law."""
    if not isinstance(given, list):
        return given
    return [{"law": "elastic"} | part if isinstance(part, dict) else part for part in given]


def _body_law(given: Any) -> Any:
    """Add law = "elastic" to a body with a material of the library but no law."""
    return {"law": "elastic"} | given if isinstance(given, dict) and "material" in given else given


if TYPE_CHECKING:
    LayerSection = _Layer
else:
    LayerSection = _models("Layer", _Layer, _ElasticLayer, _PlasticLayer)


class _Body(_Solid):
    layers: (
        Annotated[list[LayerSection], Field(min_length=1), BeforeValidator(_layer_law)] | None
    ) = None

    @property
    def parts(self) -> list[_Solid]:
        """Layers from the surface down, and the substrate."""
        return [*self.coating, self]

    @property
    def inelastic_laws(self) -> list[str]:
        """Hardening laws of all elastic-plastic materials of the body: layers and substrate."""
        return [part.law for part in self.parts if LAWS[part.law].yields]

    @property
    def is_plastic(self) -> bool:
        return bool(self.inelastic_laws)

    @property
    def relaxes(self) -> bool:
        """Whether the body is viscoelastic."""
        return any(getattr(part, "relaxation", None) is not None for part in self.parts)

    @model_validator(mode="after")
    def _possible(self) -> _Body:
        """Build the body once, so that the core checks the combination of constants."""
        self.build()
        return self

    @property
    def coating(self) -> list[LayerSection]:
        """Layers on the body, from the surface down."""
        return self.layers or []

    @property
    def is_rigid(self) -> bool:
        return self.law == "rigid" and not self.coating

    def build(self) -> Body:
        """Create the `Material`, or a `Layered` body if there are layers."""
        from ..bodies.layered import Layered

        layers = tuple((part.solid, part.thickness) for part in self.coating)
        return Layered(layers, self.solid) if layers else self.solid


class _ElasticBody(_ElasticSolid, _Body):
    pass


class _EndingBody(_ElasticBody):
    free_faces: FreeFaces | None = None
    relaxation: RelaxationSection | None = None


class _PlasticBody(_PlasticSolid, _ElasticBody):
    pass


if TYPE_CHECKING:
    BodySection = _Body
else:
    BodySection = Annotated[
        _models("Body", _Body, _EndingBody, _PlasticBody), BeforeValidator(_body_law)
    ]

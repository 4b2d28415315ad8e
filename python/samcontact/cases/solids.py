# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials in a case file: one model for each hardening law, with its optional properties."""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import (
    Field,
    ModelWrapValidatorHandler,
    create_model,
    model_validator,
)

from .. import materials
from ..bodies.hardening_laws import LAWS, Constant, Law
from ..hardness import HardnessProfile, hardened_case
from ..materials.library import ADVICE
from .base import Finite, NonNegative, Positive, Section, changed
from .converted import Unit

if TYPE_CHECKING:
    from typing_extensions import Self

    from ..bodies.material import Material


class KinematicHardening(Section):
    """Kinematic hardening, see `Material.with_kinematic_hardening`."""

    modulus: Annotated[Positive | list[Positive], Unit("Pa")]
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

    conductivity: Annotated[Positive, Unit("W/(m*K)")]
    expansion: Annotated[NonNegative, Unit("1/K")]
    diffusivity: Annotated[Positive, Unit("m**2/s")]


class JohnsonCookSoftening(Section):
    """Yield stress that decreases with temperature, see `softening.JohnsonCook`."""

    kind: Literal["johnson_cook"]
    melting: Annotated[Positive, Unit("K")]
    m: Positive
    reference: Annotated[NonNegative, Unit("K")] = 293.15
    ambient: Annotated[NonNegative, Unit("K")] = 293.15
    floor: Annotated[float, Field(gt=0.0, le=1.0)] = 0.01

    @model_validator(mode="after")
    def _melts_above_reference(self) -> JohnsonCookSoftening:
        if not self.melting > self.reference:
            raise ValueError(
                f"melting must be greater than reference ({self.reference!r} K), got "
                f"{self.melting!r} K"
            )
        return self


Depths = Annotated[list[NonNegative], Field(min_length=1), Unit("m")]
Stresses = Annotated[list[Finite], Unit("Pa")]


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
    depth: Annotated[Positive, Unit("m")] | None = None
    limit: Vickers = 550.0
    z: Depths | None = None
    HV: list[Vickers] | None = None

    @model_validator(mode="after")
    def _one_form(self) -> HardnessSection:
        case = [self.surface, self.core, self.depth]
        points = [self.z, self.HV]
        other = points if None not in case else case
        if (None in case) == (None in points) or any(value is not None for value in other):
            raise ValueError("give either surface, core and depth, or z and HV")
        if self.z is not None and changed(self, ["limit"]):
            raise ValueError("limit is the hardness at depth: omit it with z and HV")
        self.build()
        return self

    def build(self) -> HardnessProfile:
        """Create the hardness profile."""
        if self.surface is not None and self.core is not None and self.depth is not None:
            return hardened_case(self.surface, self.core, self.depth, self.limit)
        return HardnessProfile(tuple(self.z or ()), tuple(self.HV or ()))


class FreeFaces(Section):
    """Free end faces of a body, see `Material.with_free_faces`."""

    low: Annotated[Finite, Unit("m")] | None = None
    high: Annotated[Finite, Unit("m")] | None = None
    method: Literal["exact", "factor"] = "exact"


class RelaxationSection(Section):
    """Viscoelastic relaxation of a body, see `Material.with_relaxation`."""

    times: Annotated[list[Positive], Field(min_length=1), Unit("s")]
    shares: Annotated[list[Positive], Field(min_length=1)]


_BODY_TABLES = (
    "kinematic", "thermal", "softening", "yield_profile", "residual_stress", "free_faces",
    "relaxation",
)  # fmt: skip


class Solid(Section):
    """Material with a hardening law and optional properties."""

    if TYPE_CHECKING:
        law: str

    @property
    def known(self) -> materials.MaterialData | None:
        """Library data of the material named by `material`; None if no material is named."""
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

        # not by model_dump, for which pydantic would first build a serializer of each section
        given = {name: getattr(self, name) for name in LAWS[self.law].constants}
        sections = {name: getattr(self, name, None) for name in _BODY_TABLES}
        extra = {name: part if part is None else dict(part) for name, part in sections.items()}
        material: Material = getattr(Material, self.law)(**given)
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
    """Return the fields of a body, completed by the library constants of its material."""
    law, name = given.get("law"), given.get("material")
    if not isinstance(law, str) or not isinstance(name, str):
        return given  # refused by the types of the fields
    try:
        known = materials.get(name).constants(law)
    except ValueError as error:
        text = str(error).replace("name must", "material must", 1)
        remedy = "for another material, omit material and give its constants, e.g. E and nu"
        raise ValueError(text.replace(ADVICE, remedy)) from None
    for field in ("E", "nu"):
        if field in given and field in known:
            raise ValueError(
                f"{field} cannot be combined with material = {name!r}, because the library has "
                f"{field} of this material: omit one of them"
            )
    missing = [field for field in LAWS[law].constants if field not in known | given]
    if missing:
        raise ValueError(
            f"{', '.join(missing)} must be given: for material = {name!r} and law = {law!r}, the "
            "library has no value"
        )
    return known | given


class LibrarySolid(Solid):
    """Material whose constants may come from the library."""

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


class ElasticSolid(LibrarySolid):
    hardness: HardnessSection | None = None
    residual_stress: InitialStress | None = None
    thermal: ThermalConstants | None = None


class PlasticSolid(ElasticSolid):
    kinematic: KinematicHardening | None = None
    yield_profile: YieldProfile | None = None
    softening: JohnsonCookSoftening | None = None


def field_of(constant: Constant) -> Any:
    """Return the annotation of a case-file field for a constant of a hardening law."""
    limits = Field(gt=constant.gt, ge=constant.ge, lt=constant.lt, le=constant.le)
    value: Any = Annotated[float if constant.infinite else Finite, limits]
    if constant.many:
        value = list[value]
    return value if constant.unit in ("", "microstrain") else Annotated[value, Unit(constant.unit)]


def _model(name: str, law: Law, part: str, namespace: dict[str, Any], *bases: type[Solid]) -> Any:
    """Create the case-file section of a hardening law, e.g. `SwiftBody`.

    bases: base classes for rigid, elastic and elastic-plastic laws.
    """
    base = bases[2] if law.yields else bases[1] if law.constants else bases[0]
    fields: dict[str, Any] = {"law": (Literal[name], ...)}
    fields |= {constant: (field_of(law.constants[constant]), ...) for constant in law.constants}
    title = "".join(word.capitalize() for word in name.split("_"))
    made = create_model(
        f"{title}{part}",
        __base__=base,
        __doc__=law.says,
        __module__=namespace["__name__"],
        **fields,
    )
    namespace[made.__name__] = made  # for pickling
    return made


def models(
    part: str, namespace: dict[str, Any], *bases: type[Solid], others: tuple[Any, ...] = ()
) -> Any:
    """Create a union of the sections of all laws, whose names end with `part` (`SwiftBody`).

    namespace: globals of the module that defines the sections. bases: as in `_model`.
    others: sections of further laws.
    """
    laws = {name: law for name, law in LAWS.items() if law.constants or part == "Body"}
    made = tuple(_model(name, law, part, namespace, *bases) for name, law in laws.items())
    return Annotated[reduce(or_, (*made, *others)), Field(discriminator="law")]

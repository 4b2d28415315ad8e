# SPDX-License-Identifier: GPL-3.0-or-later
"""Body sections of a case file: a material, with optional layers and inclusions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from pydantic import BeforeValidator, Field, model_validator

from ..bodies.hardening_laws import LAWS
from .base import Positive
from .converted import Unit
from .inclusions import Inclusions, RandomInclusions
from .solids import ElasticSolid, FreeFaces, PlasticSolid, RelaxationSection, Solid, models

if TYPE_CHECKING:
    from ..bodies.layered import Body


class _Layer(Solid):
    """Layer of a coated body, see `Layered`."""

    thickness: Annotated[Positive, Unit("m")]


class _ElasticLayer(ElasticSolid, _Layer):
    relaxation: RelaxationSection | None = None


class _PlasticLayer(PlasticSolid, _Layer):
    pass


def _layer_law(given: Any) -> Any:
    """Add law = "elastic" to layers without a law."""
    if not isinstance(given, list):
        return given
    return [{"law": "elastic"} | part if isinstance(part, dict) else part for part in given]


def _body_law(given: Any) -> Any:
    """Add law = "elastic" to a body that names a material of the library but no law."""
    return {"law": "elastic"} | given if isinstance(given, dict) and "material" in given else given


if TYPE_CHECKING:
    LayerSection = _Layer
else:
    LayerSection = models("Layer", globals(), _Layer, _ElasticLayer, _PlasticLayer)


class _Body(Solid):
    layers: (
        Annotated[list[LayerSection], Field(min_length=1), BeforeValidator(_layer_law)] | None
    ) = None

    inclusions: Inclusions | None = None
    random_inclusions: RandomInclusions | None = None

    @property
    def has_inclusions(self) -> bool:
        """Whether the body has inclusions."""
        return self.inclusions is not None or self.random_inclusions is not None

    @property
    def parts(self) -> list[Solid]:
        """Layers from the surface downwards, then the substrate."""
        return [*self.coating, self]

    @property
    def sections(self) -> dict[str, Any]:
        """Material sections by their place in the body, "" (substrate), ".layers[0]" etc."""
        found: dict[str, Any] = {f".layers[{n}]": x for n, x in enumerate(self.coating)}
        found |= {"": self} | {f".inclusions[{n}]": x for n, x in enumerate(self.inclusions or [])}
        drawn = self.random_inclusions
        return found if drawn is None else found | {".random_inclusions": drawn}

    @property
    def inelastic_laws(self) -> list[str]:
        """Hardening laws of all elastic-plastic materials of the body, inclusions last."""
        inner = [*(self.inclusions or []), *filter(None, [self.random_inclusions])]
        laws = [part.law for part in self.parts if LAWS[part.law].yields]
        return laws + [part.law for part in inner if part.yields]

    @property
    def is_plastic(self) -> bool:
        return bool(self.inelastic_laws)

    @property
    def relaxes(self) -> bool:
        """Whether the body is viscoelastic."""
        return any(getattr(part, "relaxation", None) is not None for part in self.parts)

    @model_validator(mode="after")
    def _possible(self) -> _Body:
        """Build the body once, so that the compiled core checks the combination of constants."""
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
        """Create the body: a `Material`, a `Layered` or a `Heterogeneous` body."""
        from ..bodies.heterogeneous import Heterogeneous
        from ..bodies.layers import Layered

        layers = tuple((part.solid, part.thickness) for part in self.coating)
        matrix = Layered(layers, self.solid) if layers else self.solid
        if not self.has_inclusions:
            return matrix
        inclusions = [one.build() for one in self.inclusions or []]
        if self.random_inclusions is not None:
            inclusions += self.random_inclusions.build()
        return Heterogeneous(matrix, inclusions)


class _ElasticBody(ElasticSolid, _Body):
    pass


class _EndingBody(_ElasticBody):
    free_faces: FreeFaces | None = None
    relaxation: RelaxationSection | None = None


class _PlasticBody(PlasticSolid, _ElasticBody):
    pass


if TYPE_CHECKING:
    BodySection = _Body
else:
    BodySection = Annotated[
        models("Body", globals(), _Body, _EndingBody, _PlasticBody), BeforeValidator(_body_law)
    ]

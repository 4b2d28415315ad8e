# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions of a body in a case file: single and random inclusions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import BeforeValidator, Field, model_validator

from ..bodies.hardening_laws import LAWS
from .base import Finite, Length, NonNegative, Positive, Section
from .converted import Unit
from .solids import LibrarySolid, Solid, ThermalConstants, models

if TYPE_CHECKING:
    from ..bodies.inclusion import Inclusion
    from ..bodies.material import Material

Point = Annotated[list[Finite], Field(min_length=3, max_length=3), Unit("m")]
Direction = Annotated[list[Finite], Field(min_length=3, max_length=3)]
Strain = Finite | Annotated[list[Finite], Field(min_length=6, max_length=6)]
Ends = Annotated[list[Finite], Field(min_length=2, max_length=2), Unit("m")]
Radii = Annotated[list[Positive], Field(min_length=3, max_length=3), Unit("m")]
Limits = Annotated[list[NonNegative], Field(min_length=2, max_length=2), Unit("m")]


class _Phase(Solid):
    """Material and misfit strain of inclusions."""

    misfit: Strain = 0.0
    thermal: ThermalConstants | None = None

    @model_validator(mode="after")
    def _of_a_material(self) -> _Phase:
        if self.law == "void" and self.thermal is not None:
            raise ValueError('thermal must not be given with law = "void": omit it')
        return self

    @property
    def phase(self) -> Material | None:
        """Material of the inclusions; None for voids."""
        return None if self.law == "void" else self.solid

    @property
    def yields(self) -> bool:
        """Whether the inclusions can yield."""
        return self.law != "void" and LAWS[self.law].yields


class _Inclusion(_Phase):
    """Inclusion of a body, see `Inclusion`."""

    shape: Literal["sphere", "ellipsoid"] = "sphere"
    center: Point
    radius: Length | None = None
    radii: Radii | None = None
    axes: Annotated[list[Direction], Field(min_length=3, max_length=3)] | None = None

    @model_validator(mode="after")
    def _one_shape(self) -> _Inclusion:
        expected = "radius" if self.shape == "sphere" else "radii"
        for name in ("radius", "radii"):
            given = getattr(self, name) is not None
            if given != (name == expected):
                verb = "must not be given" if given else "must be given"
                raise ValueError(f'{name} {verb} with shape = "{self.shape}": use {expected}')
        if self.axes is not None and self.shape == "sphere":
            raise ValueError('axes must not be given with shape = "sphere": omit axes')
        self.build()
        return self

    def build(self) -> Inclusion:
        """Create the inclusion."""
        from ..bodies.inclusion import Inclusion

        radii = [self.radius] * 3 if self.radius is not None else self.radii or []
        return Inclusion(self.center, radii, self.axes, self.phase, self.misfit)


class Cluster(Section):
    """Clusters of random inclusions, see `Heterogeneous.random`."""

    members: Positive
    distance: Length


class _RandomInclusions(_Phase):
    """Random spherical inclusions of a body, see `Heterogeneous.random`."""

    fraction: Annotated[float, Field(gt=0.0, le=0.3)]
    radius: Length
    spread: Annotated[float, Field(ge=0.0, le=2.0)] = 0.0
    radius_limits: Limits | None = None
    box: Annotated[list[Ends], Field(min_length=3, max_length=3)]
    seed: Annotated[int, Field(ge=0)]
    gap: NonNegative = 0.1
    cover: Annotated[NonNegative, Unit("m")] = 0.0
    cluster: Cluster | None = None

    @model_validator(mode="after")
    def _possible(self) -> _RandomInclusions:
        self.build()
        return self

    def build(self) -> list[Inclusion]:
        """Generate the random inclusions."""
        from ..bodies.microstructure import random_inclusions

        cluster = None
        if self.cluster is not None:
            cluster = (self.cluster.members, self.cluster.distance)
        return random_inclusions(
            self.phase,
            self.fraction,
            (self.radius, self.spread),
            self.box,
            self.seed,
            self.gap,
            self.cover,
            misfit=self.misfit,
            radius_limits=self.radius_limits,
            cluster=cluster,
        )


class _MaterialInclusion(_Inclusion, LibrarySolid):
    pass


class _MaterialRandomInclusions(_RandomInclusions, LibrarySolid):
    pass


class VoidInclusion(_Inclusion):
    """Void in a body, see `Inclusion.void`."""

    law: Literal["void"]


class VoidRandomInclusions(_RandomInclusions):
    """Random spherical voids in a body, see `Heterogeneous.random`."""

    law: Literal["void"]


def _law(given: Any) -> Any:
    """Add law = "elastic" to inclusions without a law."""
    if isinstance(given, list):
        return [_law(one) for one in given]
    return {"law": "elastic"} | given if isinstance(given, dict) else given


if TYPE_CHECKING:
    InclusionSection = _Inclusion
    RandomSection = _RandomInclusions
else:
    InclusionSection = models(
        "Inclusion", globals(), _Inclusion, _MaterialInclusion, _MaterialInclusion,
        others=(VoidInclusion,),
    )  # fmt: skip
    RandomSection = models(
        "RandomInclusions", globals(), _RandomInclusions, _MaterialRandomInclusions,
        _MaterialRandomInclusions, others=(VoidRandomInclusions,),
    )  # fmt: skip
Inclusions = Annotated[list[InclusionSection], Field(min_length=1), BeforeValidator(_law)]
RandomInclusions = Annotated[RandomSection, BeforeValidator(_law)]

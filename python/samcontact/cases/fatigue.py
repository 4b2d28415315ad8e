# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [fatigue] of a case file."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from ..fatigue import Cycle, Exposure, FatigueField, Life, cycle, exposure, life, steady_cycle
from ..fatigue import criteria as _criteria
from ..hardness import HardnessProfile
from ..solutions.state import State
from .base import Finite, Length, NonNegative, Positive, Section
from .converted import Unit

Slope = Annotated[Finite, Field(ge=0.0, le=10.0)]
Stress = Annotated[Positive, Unit("Pa")]
CRITERIA = ("dang_van", "crossland", "findley", "fatemi_socie", "orthogonal_shear")


class LimitSection(Section):
    """[fatigue.limit]: fatigue limit of the material for each criterion."""

    dang_van: Stress | None = None
    crossland: Stress | None = None
    findley: Stress | None = None
    fatemi_socie: Positive | None = None
    orthogonal_shear: Stress | None = None


class ExposureSection(Section):
    """[fatigue.exposure]: ratio of stress to strength over depth, see `fatigue.exposure`."""

    slope: Slope = 0.3
    axis: Literal["x", "y"] = "x"
    defect: Length | None = None


class LifeSection(Section):
    """[fatigue.life]: constants of the life integral, see `fatigue.life`."""

    criterion: Literal["dang_van", "crossland", "findley", "orthogonal_shear"]
    model: Literal["ioannides_harris", "zaretsky"] = "ioannides_harris"
    limit: Annotated[NonNegative, Unit("Pa")] = 0.0
    exponent: Positive | None = None
    depth_exponent: NonNegative | None = None
    weibull: Positive | None = None
    length: Length = 1.0


class FatigueSection(Section):
    """[fatigue]: criteria for the stress cycle of the path, see `samcontact.fatigue`."""

    dang_van: Slope | None = None
    crossland: Slope | None = None
    findley: Slope | None = None
    fatemi_socie: Slope | None = None
    orthogonal_shear: Literal["x", "y"] | None = None
    steady_axis: Literal["x", "y"] | None = None
    yield_stress: Stress | None = None
    limit: LimitSection = LimitSection()
    exposure: ExposureSection | None = None
    life: LifeSection | None = None

    @model_validator(mode="after")
    def _go_together(self) -> FatigueSection:
        if not self.criteria and self.exposure is None:
            raise ValueError(
                f"at least one of {', '.join(CRITERIA)} and exposure must be given, got none"
            )
        if self.life is not None and self.life.criterion not in self.criteria:
            raise ValueError(
                f"life.criterion requires {self.life.criterion}: add {self.life.criterion}, or "
                "choose another criterion"
            )
        for name in CRITERIA:
            if getattr(self.limit, name) is not None and name not in self.criteria:
                raise ValueError(f"limit.{name} requires {name}: add {name}, or remove the limit")
        if self.yield_stress is not None and "fatemi_socie" not in self.criteria:
            raise ValueError(
                "yield_stress is used by fatemi_socie only: add fatemi_socie, or remove "
                "yield_stress"
            )
        return self

    @property
    def criteria(self) -> list[str]:
        """Names of the specified criteria."""
        return [name for name in CRITERIA if getattr(self, name) is not None]

    def fields(self, states: list[State], body: int) -> list[FatigueField]:
        """Evaluate each criterion in a body over the stress cycle formed by the increments.

        With `steady_axis`, the cycle is the stress history of material that passes through the
        steady stress field of the increment with the highest load.
        """
        seen = self._cycle(states, body)
        return [self._field(name, seen) for name in self.criteria]

    def _cycle(self, states: list[State], body: int) -> Cycle:
        if self.steady_axis is None:
            return cycle(states, body)
        return steady_cycle(max(states, key=lambda state: state.load), body, self.steady_axis)

    def exposed(
        self, states: list[State], body: int, profile: HardnessProfile | None
    ) -> Exposure | None:
        """Return the ratio of stress to strength over depth; None without [fatigue.exposure]."""
        if self.exposure is None:
            return None
        assert profile is not None  # checked with the case
        given: dict[str, Any] = self.exposure.model_dump()
        return exposure(self._cycle(states, body), profile, **given)

    def life_of(self, fields: list[FatigueField]) -> Life | None:
        """Return the life computed from the result of `fields`; None without [fatigue.life]."""
        if self.life is None:
            return None
        given = self.life.model_dump()
        name = given.pop("criterion")
        return life(next(field for field in fields if field.criterion == name), **given)

    def _field(self, name: str, seen: Cycle) -> FatigueField:
        given = getattr(self, name)
        if name == "orthogonal_shear":
            return _criteria.orthogonal_shear(seen, axis=given)
        if name == "findley":
            return _criteria.findley(seen, k=given)
        if name == "fatemi_socie":
            return _criteria.fatemi_socie(seen, k=given, yield_stress=self.yield_stress)
        criterion = _criteria.dang_van if name == "dang_van" else _criteria.crossland
        return criterion(seen, slope=given)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [fatigue] of a case file."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from ..fatigue import Cycle, FatigueField, cycle, steady_cycle
from ..fatigue import criteria as _criteria
from ..solutions.state import State
from .base import Finite, Positive, Section, in_unit

Slope = Annotated[Finite, Field(ge=0.0, le=10.0)]
Stress = Annotated[Positive, in_unit("Pa")]
CRITERIA = ("dang_van", "crossland", "findley", "fatemi_socie", "orthogonal_shear")


class LimitSection(Section):
    """[fatigue.limit]: fatigue limit of the material for each criterion."""

    dang_van: Stress | None = None
    crossland: Stress | None = None
    findley: Stress | None = None
    fatemi_socie: Positive | None = None
    orthogonal_shear: Stress | None = None


class FatigueSection(Section):
    """[fatigue]: fatigue criteria over the path, see `samcontact.fatigue`."""

    dang_van: Slope | None = None
    crossland: Slope | None = None
    findley: Slope | None = None
    fatemi_socie: Slope | None = None
    orthogonal_shear: Literal["x", "y"] | None = None
    steady_axis: Literal["x", "y"] | None = None
    yield_stress: Stress | None = None
    limit: LimitSection = LimitSection()

    @model_validator(mode="after")
    def _go_together(self) -> FatigueSection:
        if not self.criteria:
            raise ValueError(f"at least one of {', '.join(CRITERIA)} must be given, got none")
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
        seen: Cycle
        if self.steady_axis is None:
            seen = cycle(states, body)
        else:
            seen = steady_cycle(max(states, key=lambda state: state.load), body, self.steady_axis)
        return [self._field(name, seen) for name in self.criteria]

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

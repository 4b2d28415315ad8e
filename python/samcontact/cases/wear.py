# SPDX-License-Identifier: GPL-3.0-or-later
"""Section of a case file that makes its path a cycle after which bodies wear."""

from __future__ import annotations

import os
from inspect import signature
from typing import TYPE_CHECKING, Annotated, Any, Literal, cast

from pydantic import Field, model_validator

from .base import BodyNumber, Count, Length, NonNegative, Positive, Section, changed, in_unit

if TYPE_CHECKING:
    from ..bodies.material import Material
    from ..simulation.simulation import Simulation
    from ..wear import FrettingResult, WearResult

Cells = Annotated[int, Field(ge=1)]
WearPerPressure = Annotated[
    Positive | Annotated[list[NonNegative], Field(min_length=2, max_length=2)], in_unit("1/Pa")
]
_LAWS = ("threshold", "energy", "archard")
_OF_STRAIN = ("worn", "smoothing_length", "window", "order", "strain_depth")


class WearSection(Section):
    """[wear]: see `wear.run`, and with energy or archard `wear.fretting`."""

    threshold: Positive | None = None
    energy: WearPerPressure | None = None
    archard: WearPerPressure | None = None
    cycles: Count = 20
    repeats: Count = 1
    worn: list[BodyNumber] = Field([2], min_length=1, max_length=2)
    smoothing_length: Length | None = None
    window: Cells | Annotated[list[Cells], Field(min_length=2, max_length=2)] | None = None
    order: Annotated[int, Field(ge=0)] | None = None
    strain_depth: Literal["exact", "smoothed"] = "exact"

    @property
    def law(self) -> str:
        """The field that is the law."""
        return next(name for name in _LAWS if getattr(self, name) is not None)

    @model_validator(mode="after")
    def _one_law(self) -> WearSection:
        given = [name for name in _LAWS if getattr(self, name) is not None]
        if len(given) != 1:
            listed = ", ".join(_LAWS)
            raise ValueError(f"give exactly one of {listed}; got {', '.join(given) or 'none'}")
        of_strain = given == ["threshold"]
        others = ("repeats",) if of_strain else _OF_STRAIN
        for name in sorted(changed(self, others)):
            laws = "energy and archard" if of_strain else "threshold"
            raise ValueError(f"{name} goes with {laws}, not with {given[0]}: leave it out")
        return self

    def solve(
        self,
        scene: Simulation,
        cycle: list[dict[str, object]],
        checkpoint: str | os.PathLike[str] | None,
        progress: bool,
    ) -> WearResult | FrettingResult:
        """Repeat a cycle of the scene; nothing is computed with the simulation itself."""
        from .. import wear

        # all of them: a setting that is left out would be read and not used
        arguments = signature(type(scene)).parameters.values()
        names = [argument.name for argument in arguments if argument.kind is argument.KEYWORD_ONLY]
        common: dict[str, Any] = {name: getattr(scene, name) for name in names}
        common |= {"friction": scene.friction, "cycle": cycle, "cycles": self.cycles}
        common |= {"checkpoint": checkpoint, "progress": progress}
        bodies = cast("Material", scene.body1), cast("Material", scene.body2)
        given = scene.grid, *bodies, scene.initial_gap
        if self.threshold is None:
            common |= {self.law: getattr(self, self.law), "repeats": self.repeats}
            return wear.fretting(*given, **common)
        return wear.run(
            *given,
            threshold=self.threshold,
            worn=tuple(self.worn),
            smoothing_length=self.smoothing_length,
            window=tuple(self.window) if isinstance(self.window, list) else self.window,
            order=self.order,
            strain_depth=self.strain_depth,
            **common,
        )

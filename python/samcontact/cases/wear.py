# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [wear] of a case file: the path is a load cycle, repeated with wear after each cycle."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field, model_validator

from .base import BodyNumber, Count, Length, NonNegative, Positive, Section, changed
from .converted import Unit

if TYPE_CHECKING:
    from ..simulation.simulation import Simulation
    from ..wear import FrettingResult, WearResult

Cells = Annotated[int, Field(ge=1)]
WearPerPressure = Annotated[
    Positive | Annotated[list[NonNegative], Field(min_length=2, max_length=2)], Unit("1/Pa")
]
_LAWS = ("threshold", "energy", "archard")
_STRAIN_FIELDS = ("worn", "smoothing_length", "window", "order", "strain_depth", "keep_heat")


class WearSection(Section):
    """[wear]: wear over cycles; by `wear.fretting` with energy or archard, else by `wear.run`."""

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
    keep_heat: bool = False

    @property
    def law(self) -> str:
        """Name of the wear law (threshold, energy or archard)."""
        return next(name for name in _LAWS if getattr(self, name) is not None)

    @model_validator(mode="after")
    def _one_law(self) -> WearSection:
        given = [name for name in _LAWS if getattr(self, name) is not None]
        if len(given) != 1:
            listed = ", ".join(_LAWS)
            raise ValueError(
                f"exactly one of {listed} must be given, got {', '.join(given) or 'none'}"
            )
        of_strain = given == ["threshold"]
        others = ("repeats",) if of_strain else _STRAIN_FIELDS
        for name in sorted(changed(self, others)):
            laws = "energy and archard" if of_strain else "threshold"
            raise ValueError(f"{name} applies to {laws} only, got {given[0]}: omit {name}")
        return self

    def solve(
        self,
        simulation: Simulation,
        cycle: list[dict[str, object]],
        checkpoint: str | os.PathLike[str] | None,
        progress: bool,
    ) -> WearResult | FrettingResult:
        """Repeat the load cycle with wear; `simulation` provides settings and is not changed."""
        from .. import wear

        # all settings of the case file, so that none is ignored
        given = simulation.engine.setup.on_grid(simulation.grid, simulation.heat)
        given |= {"cycle": cycle, "cycles": self.cycles}
        given |= {"checkpoint": checkpoint, "progress": progress}
        if self.threshold is None:
            given |= {self.law: getattr(self, self.law), "repeats": self.repeats}
            return wear.fretting(**given)
        return wear.run(
            threshold=self.threshold,
            worn=tuple(self.worn),
            smoothing_length=self.smoothing_length,
            window=tuple(self.window) if isinstance(self.window, list) else self.window,
            order=self.order,
            strain_depth=self.strain_depth,
            keep_heat=self.keep_heat,
            **given,
        )

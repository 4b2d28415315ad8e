# SPDX-License-Identifier: GPL-3.0-or-later
"""Section of a case file that makes its path a cycle after which bodies wear."""

from __future__ import annotations

import os
from inspect import signature
from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field

from .base import Count, Length, Positive, Section

if TYPE_CHECKING:
    from ..simulation import Simulation
    from ..wear import WearResult

Cells = Annotated[int, Field(ge=1)]
Body = Literal[1, 2]


class WearSection(Section):
    """[wear]: see `wear.run`."""

    threshold: Positive
    cycles: Count = 20
    worn: Annotated[list[Body], Field(min_length=1, max_length=2, default_factory=lambda: [2])]
    smoothing_length: Length | None = None
    window: Cells | Annotated[list[Cells], Field(min_length=2, max_length=2)] | None = None
    order: Annotated[int, Field(ge=0)] | None = None
    strain_depth: Literal["exact", "smoothed"] = "exact"

    def solve(
        self,
        scene: Simulation,
        cycle: list[dict[str, object]],
        checkpoint: str | os.PathLike[str] | None,
        progress: bool,
    ) -> WearResult:
        """Repeat a cycle of the scene; nothing is computed with the simulation itself."""
        from .. import wear

        window = tuple(self.window) if isinstance(self.window, list) else self.window
        # all of them: a setting that is left out would be read and not used
        arguments = signature(type(scene)).parameters.values()
        names = [argument.name for argument in arguments if argument.kind is argument.KEYWORD_ONLY]
        return wear.run(
            scene.grid,
            scene.body1,
            scene.body2,
            scene.initial_gap,
            cycle=cycle,
            threshold=self.threshold,
            cycles=self.cycles,
            worn=tuple(self.worn),
            smoothing_length=self.smoothing_length,
            window=window,
            order=self.order,
            strain_depth=self.strain_depth,
            friction=scene.friction,
            checkpoint=checkpoint,
            progress=progress,
            **{name: getattr(scene, name) for name in names},
        )

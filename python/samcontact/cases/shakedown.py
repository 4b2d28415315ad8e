# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [shakedown] of a case file: repetition of the path until shakedown or ratcheting."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from .base import Finite, Section

if TYPE_CHECKING:
    from pathlib import Path as Folder

    from ..paths import Path
    from ..shakedown import ShakedownResult
    from ..simulation.simulation import Simulation


class ShakedownSection(Section):
    """[shakedown]: repetition of the path, see `samcontact.shakedown.run`."""

    cycles: Annotated[int, Field(ge=2)] = 100
    tol: Annotated[Finite, Field(ge=1e-6, le=0.1)] = 1e-3
    accelerate: bool = True

    def solve(
        self, simulation: Simulation, path: Path, progress: bool, checkpoint: Folder | None = None
    ) -> ShakedownResult:
        """Repeat the path by `samcontact.shakedown.run`, beginning at the state of `simulation`."""
        from ..shakedown import run  # needed by few cases

        return run(
            simulation,
            path,
            cycles=self.cycles,
            tol=self.tol,
            accelerate=self.accelerate,
            progress=progress,
            checkpoint=checkpoint,
        )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Retraction of adhesive bodies until they separate, as a segment of a path."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from .. import paths
from .base import Length, Positive, Section
from .converted import Unit
from .slipping import EndState

MAX_INCREMENTS = 400
"""Default maximum number of increments of a pull-off."""


class PullOff(Section):
    """Retraction until the surfaces separate, see `paths.Retraction`."""

    step: Length | None = None
    until: Literal["apart", "maximum"] = "apart"
    speed: Annotated[Positive, Unit("m/s")] | None = None

    def steps(self, increments: int, reached: EndState) -> tuple[paths.Path, EndState]:
        """Return the path and the end state of the segment; `reached` is its initial state.

        increments: maximum number of increments. Raises ValueError without previous segment.
        """
        if not reached.quantity:
            raise ValueError(
                "pull_off requires a previous segment, in which the surfaces make contact: add a "
                "[[path]] with approach or load before it"
            )
        retraction = paths.Retraction(self.step, self.until, increments, self.speed)
        lost = self.until == "apart"
        forces = tuple(0.0 if lost or q == 0.0 else None for q in reached.forces)
        end = reached._replace(quantity="pull_off", value=0.0, forces=forces)
        return [{"pull_off": retraction}], end


def settings_of_pull_off(given: Any) -> Any:
    """Return an empty table for `pull_off = true`, None for false, otherwise the given value."""
    return {True: {}, False: None}.get(given, given) if isinstance(given, bool) else given

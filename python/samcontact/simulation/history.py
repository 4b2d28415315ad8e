# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments of a simulation since its start."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .increment_paths import cleaned

if TYPE_CHECKING:
    from ..heat import Heat


@dataclass
class History:
    """Record of all increments of a simulation since its start."""

    heat: Heat
    """Heat of the first increment."""
    steps: list[dict[str, Any]] | None = field(default_factory=list)
    """Arguments of `Simulation.step` for each increment; None if the arguments of any
    increment are unknown."""
    checked: int = 0
    """Number of increments at the last error estimate."""
    has_given_strain: bool = False
    """Whether a plastic strain was prescribed; a repetition of the increments would lack it."""

    def add(self, given: Mapping[str, Any]) -> None:
        """Add an increment; an increment with prescribed tractions ends the record."""
        if given.get("pressure") is not None:
            self.forget()
        if self.steps is not None:
            self.steps.append(cleaned(given))

    def forget(self) -> None:
        """End the record, because the state no longer results from the recorded increments."""
        self.steps = None

    def is_due(self, factor: int) -> bool:
        """Whether the number of increments has grown by `factor` since the last error estimate."""
        return bool(self.steps) and len(self.steps or ()) >= factor * self.checked

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
    """The increments of a simulation since its start, as far as they are known."""

    heat: Heat
    """Heat of the first increment."""
    steps: list[dict[str, Any]] | None = field(default_factory=list)
    """Arguments of `Simulation.step`; None where the start is not that of undeformed bodies."""
    checked: int = 0
    """The number of increments at the last estimate."""

    def add(self, given: Mapping[str, Any]) -> None:
        """Add an increment; prescribed tractions are not kept, nor what follows them."""
        if given.get("pressure") is not None:
            self.forget()
        if self.steps is not None:
            self.steps.append(cleaned(given))

    def forget(self) -> None:
        """Forget all, after a state that the increments do not lead to."""
        self.steps = None

    def is_due(self, factor: int) -> bool:
        """Whether there are so many times as many increments as at the last estimate."""
        return bool(self.steps) and len(self.steps or ()) >= factor * self.checked

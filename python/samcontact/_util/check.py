# SPDX-License-Identifier: GPL-3.0-or-later
"""One check with its number and its limit, as reports and the self-check list them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Check:
    """A number against its limit.

    Attributes
    ----------
    name : str
        What is checked.
    value : float
        The number; NaN fails.
    limit : float
        What it is compared with, in the same unit.
    at_least : bool
        The limit is a lower one.
    unit : str
        Of both, SI; "" for pure numbers.
    """

    name: str
    value: float
    limit: float
    at_least: bool = False
    unit: str = ""

    @property
    def passed(self) -> bool:
        """Whether the number is within its limit."""
        if self.at_least:
            return self.value >= self.limit
        return self.value <= self.limit

    @property
    def word(self) -> str:
        """ "ok" or "failed"."""
        return "ok" if self.passed else "failed"

    @property
    def shown(self) -> str:
        """The number with its unit."""
        return f"{self.value:.3g} {self.unit}".strip()

    @property
    def condition(self) -> str:
        """The limit with its sense, e.g. "≤ 1e-06"."""
        sign = "≥" if self.at_least else "≤"
        return f"{sign} {self.limit:.3g} {self.unit}".strip()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Check of a number against a limit, as listed by reports and the self-test."""

from __future__ import annotations

from typing import NamedTuple


class Check(NamedTuple):
    """Check of a number against a limit.

    Attributes
    ----------
    name : str
        Name of the quantity that is checked.
    value : float
        Value of the quantity; NaN never passes.
    limit : float
        Limit, in the unit of the value.
    at_least : bool
        Whether the limit is a lower bound.
    unit : str
        SI unit of `value` and `limit`; "" for pure numbers.
    of_input : bool
        True for a check of the input (e.g. of units), False for a check of the results.
    """

    name: str
    value: float
    limit: float
    at_least: bool = False
    unit: str = ""
    of_input: bool = False

    @property
    def passed(self) -> bool:
        """Whether the value is within its limit."""
        if self.at_least:
            return self.value >= self.limit
        return self.value <= self.limit

    @property
    def word(self) -> str:
        """Result of the check, "ok" or "failed"."""
        return "ok" if self.passed else "failed"

    @property
    def shown(self) -> str:
        """Value with its unit."""
        return f"{self.value:.3g} {self.unit}".strip()

    @property
    def condition(self) -> str:
        """Limit with its relation sign, e.g. "≤ 1e-06"."""
        if self.at_least and 0.0 < self.limit < 1e-300:  # any positive value
            return f"> 0 {self.unit}".strip()
        sign = "≥" if self.at_least else "≤"
        return f"{sign} {self.limit:.3g} {self.unit}".strip()

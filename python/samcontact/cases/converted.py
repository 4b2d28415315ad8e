# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of texts with units, such as "25 um", to numbers in SI units."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from functools import partial
from typing import Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from .._util.checks import MAX_NUMBER
from .._util.short_text import in_short
from ..units import from_text


def convert(value: Any, unit: str) -> Any:
    """Convert texts such as "25 um", also within lists, to numbers in `unit`."""
    if isinstance(value, list):
        return [convert(item, unit) for item in value]
    if not isinstance(value, str):
        return value
    if value == "inf":  # as a number, because `from_text` expects a unit
        return math.inf
    try:
        number = from_text(value, unit)
    except ImportError as error:  # pydantic collects ValueError only
        raise ValueError(f"{error}; got {in_short(value)}") from error
    require_magnitude(number)
    return number


def require_magnitude(number: float) -> None:
    """Raise ValueError for a finite number so large that products with it could overflow."""
    if MAX_NUMBER < abs(number) <= sys.float_info.max:
        raise ValueError(f"magnitude must be <= {MAX_NUMBER:g}, got {in_short(number)}")


@dataclass(frozen=True)
class Unit:
    """SI unit of a field, as metadata of its annotation; texts such as "25 um" are converted to it.

    pydantic would inspect the function of a `BeforeValidator` again for each field.
    """

    name: str

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        converted = partial(convert, unit=self.name)
        return core_schema.no_info_before_validator_function(converted, handler(source))

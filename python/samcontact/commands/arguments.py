# SPDX-License-Identifier: GPL-3.0-or-later
"""Argument types of the commands: file names and numbers with an optional unit."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..units import from_text

if TYPE_CHECKING:
    Numbers = click.ParamType[float]
else:
    Numbers = click.ParamType


class FilePath(click.Path):
    """Name of a file or folder."""

    def __init__(self) -> None:
        super().__init__(path_type=Path)

    def convert(
        self, value: Any, param: click.Parameter | None, context: click.Context | None
    ) -> Any:
        """Convert a name to a path; refuse null characters and the empty name, which means "."."""
        if not str(value):
            self.fail("must be the name of a file or folder, got ''", param, context)
        if "\0" in str(value):
            self.fail(f"must not contain a null character, got {str(value)!r}", param, context)
        return super().convert(value, param, context)


class UnitlessNumber(float):
    """Number that the user has given without a unit."""


class QuantityArgument(Numbers):
    """Number in the SI unit of the option, or with another unit of this quantity, e.g. "7.5 mm"."""

    name = "quantity"

    def __init__(self, unit: str) -> None:
        self.unit = unit

    def convert(
        self, value: Any, param: click.Parameter | None, context: click.Context | None
    ) -> float:
        try:
            return UnitlessNumber(value)
        except ValueError:
            pass
        try:
            return from_text(value, self.unit)
        except (ValueError, ImportError) as error:
            self.fail(str(error), param, context)

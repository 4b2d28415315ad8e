# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of arguments of the commands: names of files, and numbers that may have a unit."""

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
    """The name of a file or directory."""

    def __init__(self) -> None:
        super().__init__(path_type=Path)

    def convert(
        self, value: Any, param: click.Parameter | None, context: click.Context | None
    ) -> Any:
        """Refuse names that no system has, and each refuses in its own way; "" would be "."."""
        if not str(value):
            self.fail("must be the name of a file or folder, got ''", param, context)
        if "\0" in str(value):
            self.fail(f"must not hold a null character, got {str(value)!r}", param, context)
        return super().convert(value, param, context)


class Bare(float):
    """A number without a unit."""


class Quantity(Numbers):
    """A number in the SI unit, or a text with another unit of the same kind."""

    name = "quantity"

    def __init__(self, unit: str) -> None:
        self.unit = unit

    def convert(
        self, value: Any, param: click.Parameter | None, context: click.Context | None
    ) -> float:
        try:
            return Bare(value)
        except ValueError:
            pass
        try:
            return from_text(value, self.unit)
        except (ValueError, ImportError) as error:
            self.fail(str(error), param, context)

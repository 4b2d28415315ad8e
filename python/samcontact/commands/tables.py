# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables for the terminal, in which numbers are never truncated or wrapped."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .._util.quantities import CONTACT, Quantity

if TYPE_CHECKING:
    import xarray as xr
    from rich.console import Console, ConsoleOptions
    from rich.table import Table
    from rich.text import Text

UNLIMITED_WIDTH = 10_000
"""Width of tables that are written to a file or a pipe, in characters."""
MIN_WIDTH = 40
"""Minimum width of a table, in characters. A narrower terminal wraps the lines of the table."""
_MAX_WORD_WIDTH = 24  # width of a float with all digits; longer words are folded
_FRAME_WIDTH = 3  # width of a cell's frame: a line, and a space on either side


class Silence:
    """Console that prints nothing; it spares a quiet command the time to load rich."""

    quiet = True

    def print(self, *objects: Any, **settings: Any) -> None:
        """Print nothing."""

    def status(self, text: str) -> AbstractContextManager[Any]:
        """Return a context manager that shows nothing."""
        return nullcontext()


Printer: TypeAlias = "Console | Silence"


def new_console(quiet: bool = False) -> Printer:
    """Return a console as wide as the terminal, or of unlimited width for a file or pipe."""
    if quiet:
        return Silence()
    from rich.console import Console

    console = Console()
    console.width = max(console.width, MIN_WIDTH) if console.is_terminal else UNLIMITED_WIDTH
    return console


def numbers(column: ArrayLike, digits: int = 5) -> list[str]:
    """Format the numbers of a column with a common number of decimals.

    The decimals are chosen so that the largest value has `digits` significant digits. A value that
    would then have fewer than two significant digits is formatted separately. Values that are not
    finite are shown as "-".
    """
    values = np.asarray(column, dtype=np.float64).tolist()
    largest = max((abs(value) for value in values if math.isfinite(value)), default=0.0)
    decimals = 0 if largest == 0 else max(digits - 1 - math.floor(math.log10(largest)), 0)
    odd = largest >= 1e7 or decimals > 8
    plain = [not odd and (value == 0 or abs(value) * 10.0**decimals >= 10) for value in values]
    texts = [f"{abs(v):.{decimals}f}" for v, fixed in zip(values, plain, strict=True) if fixed]
    zeros = min((decimals, *(len(text) - len(text.rstrip("0")) for text in texts)))
    decimals -= zeros

    def text(value: float, fixed: bool) -> str:
        if not math.isfinite(value):
            return "-"
        return f"{value + 0.0:.{decimals}f}" if fixed else f"{value + 0.0:.{digits if odd else 2}g}"

    return [text(value, fixed) for value, fixed in zip(values, plain, strict=True)]


@dataclass
class Sheet:
    """Table that fits the width of the terminal.

    Long headings wrap. Columns that do not fit are printed below, in further parts of the table.
    The first column contains the names of the rows and is repeated in each part.
    """

    title: str
    columns: list[tuple[str, list[str]]] = field(default_factory=list)

    def add(self, heading: str, cells: Sequence[str]) -> None:
        """Add a column; the heading may contain line breaks."""
        self.columns.append((heading, list(cells)))

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[Text | Table]:
        from rich.text import Text

        available = options.max_width
        for number, part in enumerate(self._parts(available)):
            # on a separate line, because Table would wrap a title at the width of the table
            yield Text(self.title if number == 0 else f"{self.title}, continued", style="italic")
            yield self._part(part, available)

    def _parts(self, available: int) -> list[list[int]]:
        """Return the column indices of each part: as few parts as possible, of similar width."""
        narrow = [_FRAME_WIDTH + _narrowest(*column) for column in self.columns]

        def filled(limit: int) -> list[list[int]]:
            parts: list[list[int]] = [[0]]
            for column in range(1, len(narrow)):
                width = 1 + sum(narrow[i] for i in (*parts[-1], column))
                if len(parts[-1]) > 1 and width > limit:
                    parts.append([0])
                parts[-1].append(column)
            return parts

        fewest = filled(available)
        if len(fewest) == 1:
            return fewest
        return next(p for n in range(available + 1) if len(p := filled(n)) == len(fewest))

    def _part(self, chosen: list[int], available: int) -> Table:
        from rich.table import Table
        from rich.text import Text

        widths = {i: _narrowest(*self.columns[i]) for i in chosen}
        left = available - 1 - sum(_FRAME_WIDTH + width for width in widths.values())
        table = Table()
        for i in chosen:
            heading, cells = self.columns[i]
            more = min(max(left, 0), max(_natural(heading, cells) - widths[i], 0))
            left -= more
            table.add_column(
                Text(heading),  # "[mm²]" in a plain string would be read as markup
                justify="right" if i else "left",
                width=widths[i] + more,
                overflow="fold",
            )
        for row in zip(*(self.columns[i][1] for i in chosen), strict=True):
            table.add_row(*(Text(cell) for cell in row))
        return table


def _narrowest(heading: str, cells: Sequence[str]) -> int:
    words = [word for text in (heading, *cells) for word in text.split()]
    return max((min(len(word), _MAX_WORD_WIDTH) for word in words), default=0)


def _natural(heading: str, cells: Sequence[str]) -> int:
    lines = [line for text in (heading, *cells) for line in text.splitlines()]
    return max(map(len, lines), default=0)


CONTACT_COLUMNS = (
    "load", "approach", "max_pressure", "max_von_mises", "max_equivalent_plastic_strain",
    "max_temperature",
)  # fmt: skip
"""Names of the quantities shown in the tables of a contact, as in results files."""


def contact_columns(dataset: xr.Dataset, names: Sequence[str], body: int) -> dict[str, Quantity]:
    """Return the quantities in `names` that the results contain, by name of the variable.

    The keys of the dictionary are names of variables in `dataset`: `{name}_body1` or `{name}_body2`
    for a quantity that is stored for each body, and the name of the quantity otherwise.
    """
    found = ((f"{name}_body{body}", name) for name in names)
    variables = ((own if own in dataset else name, name) for own, name in found)
    return {variable: CONTACT[name] for variable, name in variables if variable in dataset}


def values_sheet(
    title: str, rows: ArrayLike, columns: Iterable[tuple[Quantity, ArrayLike, int | None]]
) -> Sheet:
    """Return a table with one column for each quantity.

    rows: numbers of the rows, e.g. of the increments. columns: for each column the quantity, its
    values in SI units, and the number of the body (or None), which is added to the heading.
    """
    sheet = Sheet(title)
    sheet.add("", [str(number) for number in np.asarray(rows)])
    for quantity, values, body in columns:
        shown = np.asarray(values, dtype=np.float64) * quantity.factor
        sheet.add(quantity.column(body), numbers(shown, quantity.digits))
    return sheet

# SPDX-License-Identifier: GPL-3.0-or-later
"""Display of objects in notebooks: a small table of names and values with units."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields
from html import escape

from .short_text import in_short

Rows = Sequence[tuple[str, str]]
MAX_REPR_CHARACTERS = 160
"""Maximum number of characters of one value in a repr."""

# Units of the fields of dataclasses shown as tables; "": pure number.
UNIT_OF_FIELD = {
    "C": "",
    "E_star": "Pa",
    "R": "m",
    "Rx": "m",
    "Ry": "m",
    "a": "m",
    "a_x": "m",
    "a_y": "m",
    "approach": "m",
    "b": "m",
    "energy": "J",
    "interference": "m",
    "k": "",
    "load": "N",
    "load_per_length": "N/m",
    "p0": "Pa",
    "x": "m",
    "y": "m",
    "z": "m",
}
# Units of area and volume: name, minimum value shown in it, factor; values in m² or m³.
_UNITS_OF_SIZE = {
    "m²": (("m²", 1e-2, 1.0), ("mm²", 1e-8, 1e6), ("µm²", 0.0, 1e12)),
    "m³": (("m³", 1e-3, 1.0), ("mm³", 1e-12, 1e9), ("µm³", 0.0, 1e18)),
}


def percent(share: float) -> str:
    """Return a fraction in per cent with two significant digits, e.g. "0.46 %" or "120 %"."""
    return f"{float(f'{100 * share:.2g}'):g} %"  # not 1.2e+02


def quantity(value: float, unit: str = "", digits: int = 4) -> str:
    """Return a number with its unit and a suitable prefix, e.g. "25 µm" or "1.48 GPa".

    Parameters
    ----------
    value : float
        Value in SI units.
    unit : str, optional
        SI unit. Areas and volumes are shown in powers of m, mm or µm; pure numbers ("") have no
        prefix.
    digits : int, optional
        Number of significant digits.

    Returns
    -------
    str
    """
    if not math.isfinite(value):
        return {math.inf: "∞", -math.inf: "-∞"}.get(value, "none")
    for shown, minimum, factor in _UNITS_OF_SIZE.get(unit, ()):
        if abs(value) >= minimum:
            return f"{value * factor:.{digits}g} {shown}"
    mantissa, power = f"{value:.{digits - 1}e}".split("e")
    place, shift = divmod(int(power), 3)
    if unit in ("", "K") or value == 0 or abs(place) > 10:  # no prefix
        return f"{value:.{digits}g} {unit}".strip()
    prefix = "qryzafpnµm kMGTPEZYRQ"[place + 10].strip()
    return f"{float(f'{mantissa}e{shift}'):g} {prefix}{unit}"


def lengths(*values: float) -> str:
    """Return lengths along the axes [m] as text, e.g. "25 µm × 30 µm"."""
    return " × ".join(quantity(value, "m") for value in values)


def counts(*values: int) -> str:
    """Return numbers of cells along the axes as text, e.g. "31 × 31"."""
    return " × ".join(str(value) for value in values)


def html_table(title: str, rows: Rows) -> str:
    """Return an HTML table of (name, value) rows with a caption; names and values are escaped."""
    style = "text-align: left"
    body = "".join(
        f'<tr><th scope="row" style="{style}">{escape(name)}</th>'
        f'<td style="{style}">{escape(value)}</td></tr>'
        for name, value in rows
    )
    caption = f'<caption style="{style}; font-weight: bold">{escape(title)}</caption>'
    return f"<table>{caption}<tbody>{body}</tbody></table>"


class ShortRepr:
    """Base class of dataclasses with arrays; the repr shortens the arrays."""

    def __repr__(self) -> str:
        shown = [field.name for field in fields(self) if field.repr]  # type: ignore[arg-type]
        listed = ", ".join(
            f"{name}={in_short(getattr(self, name), MAX_REPR_CHARACTERS)}" for name in shown
        )
        return f"{type(self).__name__}({listed})"


def rows_of(shown: HtmlTable) -> Rows:
    """Return the (name, value) rows of the table that shows an object in a notebook."""
    return shown._rows()


class HtmlTable:
    """Base class of objects shown in notebooks as a table, by default of all dataclass fields."""

    def _rows(self) -> Rows:
        return [
            (field.name, quantity(getattr(self, field.name), UNIT_OF_FIELD[field.name]))
            for field in fields(self)  # type: ignore[arg-type]
        ]

    def _repr_html_(self) -> str:
        return html_table(type(self).__name__, self._rows())

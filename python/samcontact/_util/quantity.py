# SPDX-License-Identifier: GPL-3.0-or-later
"""Name, unit and display of one quantity."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import xarray as xr

_DISPLAY_FACTORS = {
    "µm": 1e6, "µm²": 1e12, "mm²": 1e6, "µm³": 1e18, "MPa": 1e-6, "GPa": 1e-9, "%": 1e2, "µJ": 1e6,
    "mrad": 1e3, "ms": 1e3, "nm": 1e9, "kPa": 1e-3,
}  # fmt: skip
"""Factors from SI units to the units shown."""
_MAX_AREA_IN_SQUARE_MICRONS = 1e-8  # area [m^2] below which µm² are shown
_SMALLER_UNITS = {"GPa": "MPa", "MPa": "kPa", "µm": "nm"}
_MIN_SHOWN = 0.1
"""Maximum of a figure, in the unit shown, below which a smaller unit is used."""
_COLOURS = {
    "magnitude": "viridis",
    "criterion": "viridis",
    "signed": "RdBu_r",
    "strain": "magma_r",
    "heat": "inferno",
    "length": "cividis",
    "height": "cividis",
    "any": "viridis",
}
"""Colour map of each kind of field."""


class Quantity(NamedTuple):
    """Names, units and display format of one quantity; empty texts are not shown."""

    unit: str
    """SI unit of values in files and in Python; "1" for a pure number, "" for a text."""
    long_name: str
    """Name in files. The body number replaces "{body}", or is appended."""
    shown: str = ""
    """Unit in tables, reports and figures."""
    heading: str = ""
    """Heading of the column in a report, and name in figures."""
    short: str = ""
    """Heading of the column on a terminal."""
    digits: int = 5
    """Number of significant digits of the maximum on a terminal."""
    kind: str = ""
    """Kind of a field, which determines its colours. Only "signed", "height", "criterion" and
    "any" can be negative."""

    @property
    def factor(self) -> float:
        """Factor that converts a value from the SI unit to the unit shown."""
        return _DISPLAY_FACTORS.get(self.shown, 1.0)

    @property
    def colours(self) -> str:
        """Name of the colour map for this kind of field."""
        return _COLOURS[self.kind]

    @property
    def signed(self) -> bool:
        """Whether the colour map is diverging, with white for zero."""
        return self.kind == "signed"

    @property
    def from_zero(self) -> bool:
        """Whether the quantity is never negative and its colour scale begins at zero."""
        return self.kind not in ("signed", "height", "criterion", "any")

    @property
    def label(self) -> str:
        """Label of an axis or report column, with name and unit."""
        return self.of()

    def of(self, body: int | None = None) -> str:
        """Return the label of the quantity, with the body number if a body is given."""
        name = self.heading if body is None else f"{self.heading}, body {body}"
        return f"{name} [{self.shown}]" if self.shown else name

    def column(self, body: int | None = None) -> str:
        """Return the column heading for a terminal: the name and, on a second line, the unit."""
        name = self.short if body is None else f"{self.short} {body}"
        if not self.shown:
            return name
        return f"{name} [{self.shown}]" if "\n" in name else f"{name}\n[{self.shown}]"

    def fitting(self, largest: float) -> Quantity:
        """Return the quantity, in µm² if it is an area whose maximum `largest` [m^2] is small."""
        small = self.unit == "m2" and largest < _MAX_AREA_IN_SQUARE_MICRONS
        return self._replace(shown="µm²") if small else self

    def scaled(self, largest: float) -> Quantity:
        """Return the quantity in a unit that suits a figure with the maximum `largest` (SI)."""
        small = 0 < largest * self.factor < _MIN_SHOWN
        if small and self.shown in _SMALLER_UNITS:
            return self._replace(shown=_SMALLER_UNITS[self.shown]).scaled(largest)
        return self

    def smaller(self) -> Iterator[Quantity]:
        """Iterate over copies of the quantity that are shown in smaller and smaller units."""
        shown = self.shown
        while shown in _SMALLER_UNITS:
            shown = _SMALLER_UNITS[shown]
            yield self._replace(shown=shown)

    def variable(self, dims: Any, data: Any, body: int | None = None) -> xr.Variable:
        """Return a dataset variable (dimensions, values, attributes) with unit and name."""
        import xarray as xr  # here, so that importing the package does not load it

        text = self.long_name
        if body is not None:
            text = text.format(body=body) if "{body}" in text else f"{text}, body {body}"
        units = {"units": self.unit} if self.unit else {}
        return xr.Variable(dims, data, {**units, "long_name": text})

# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantity shown in a figure, and plausibility checks of the values drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes

from .._util.checks import FloatArray
from .._util.quantities import CONTACT, Quantity

if TYPE_CHECKING:
    from ..problem.grid import Grid

_ROUNDING_ERROR = 1e-6
"""Largest magnitude of negative values that count as rounding errors, relative to the maximum
magnitude of the values or, for lengths, to the grid size if the grid size is larger."""
_HEAT_ROUNDING_ERROR = 1e-3
"""Relative error of the temperature outside a heat source, due to Fourier transforms and
quadrature."""
_MAX_VALUES = {"strain": 1e2, "heat": 1e6}
_MAX_LENGTH_RATIO = 1e3
"""Maximum plausible length, relative to the size of the grid."""
_UNNAMED_QUANTITY = Quantity("", "", "", "value", kind="any")


def quantity_of(
    name: str | None,
    values: FloatArray,
    grid: Grid,
    *,
    argument: str = "field",
    label: str | None = None,
) -> Quantity:
    """Return the quantity with a given name, or a quantity without a unit if no name is given.

    Without a name, values are shown without conversion, with a diverging colour map if negative
    values occur. argument: name of the values in error messages. label: text that replaces the name
    of the quantity in the figure. Raises ValueError for values that are impossible for the named
    quantity.
    """
    if name is None:
        shown = signed(_UNNAMED_QUANTITY) if _is_negative(values, 0.0) else _UNNAMED_QUANTITY
    else:
        shown = CONTACT[name]
        require_possible(argument, values, shown, grid)
    return shown if label is None else shown._replace(heading=label)


def quantity_for_values(name: str, values: FloatArray, grid: Grid) -> Quantity:
    """Return the quantity with a given name, with a diverging colour map if a value is negative.

    Negative values occur with prescribed tractions, which may be tensile and may cause
    interpenetration.
    """
    shown = CONTACT[name]
    return signed(shown) if _is_negative(values, _rounding(values, shown, grid)) else shown


def shown_on(ax: Axes, quantity: str, field: FloatArray) -> Quantity:
    """Return a quantity in the unit of the curves on the axes; without curves, in a suitable unit.

    field: field from whose maximum a suitable unit follows.
    """
    shown, named = CONTACT[quantity], ax.get_ylabel()
    units = (shown.scaled(float(np.nanmax(np.abs(field)))), shown, *shown.smaller())
    return next((unit for unit in units if unit.label == named), units[0])


def signed(quantity: Quantity) -> Quantity:
    """Return the quantity with a diverging colour map in which zero is white."""
    return quantity._replace(kind="signed")


def require_possible(argument: str, values: FloatArray, quantity: Quantity, grid: Grid) -> None:
    """Raise ValueError for values that are impossible for a quantity (wrong field or unit)."""
    minimum, largest = float(np.nanmin(values)), float(np.nanmax(np.abs(values)))
    unit = "" if quantity.unit == "1" else f" {quantity.unit}"
    another = "check values and unit, or call section or surface_map without quantity"
    if quantity.from_zero and minimum < -_rounding(values, quantity, grid):
        raise ValueError(
            f"{argument} must be >= 0 to be shown as {quantity.heading}, got values down to "
            f"{minimum:.4g}{unit}: {another}"
        )
    limit = _MAX_VALUES.get(quantity.kind, np.inf)
    if quantity.unit == "m":
        limit = _MAX_LENGTH_RATIO * _size(grid)
    if largest > limit:
        raise ValueError(
            f"{argument} must be at most {limit:.4g}{unit} to be shown as {quantity.heading}, got "
            f"{largest:.4g}{unit}: {another}"
        )


def _size(grid: Grid) -> float:
    return max(grid.nx * grid.dx, grid.ny * grid.dy)


def _rounding(values: FloatArray, quantity: Quantity, grid: Grid) -> float:
    size = _size(grid) if quantity.unit == "m" else 0.0
    share = _HEAT_ROUNDING_ERROR if quantity.kind == "heat" else _ROUNDING_ERROR
    return share * max(size, float(np.nanmax(np.abs(values))))


def _is_negative(values: FloatArray, rounding: float) -> bool:
    return bool(
        np.nanmin(values) < -max(rounding, _ROUNDING_ERROR * float(np.nanmax(np.abs(values))))
    )

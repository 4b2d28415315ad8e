# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of a fatigue criterion at the points of a body."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, positive
from .._util.display import HtmlTable, Rows, ShortRepr, quantity
from ..diagnostics.plausibility import strength, warn_if_implausible

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["FatigueField"]

_CRITERION_NAMES = {
    "dang_van": "Dang Van",
    "crossland": "Crossland",
    "findley": "Findley",
    "fatemi_socie": "Fatemi-Socie",
    "orthogonal_shear": "orthogonal shear",
    "max_von_mises": "von Mises",
}


@dataclass(frozen=True, repr=False, eq=False)
class FatigueField(ShortRepr, HtmlTable):
    """Values of a fatigue criterion at all points, from a function of `samcontact.fatigue`.

    Attributes
    ----------
    criterion : str
        Name of the criterion.
    parameters : mapping
        Constants of the criterion, in SI units.
    values : ndarray
        Value at each point, in the unit `unit`; axes as in `coordinates`.
    unit : str
        "Pa", or "-" for a strain.
    coordinates : mapping
        Coordinates along each axis of `values` [m]: "x" (on the body), "y", "z"; empty for a
        stress array.
    moments : int
        Number of instants of the cycle.
    normals : ndarray or None
        Normal of the critical plane at each point, shape (3, ...). None for criteria without a
        critical plane.
    """

    criterion: str
    parameters: Mapping[str, Any]
    values: FloatArray
    unit: str
    coordinates: Mapping[str, FloatArray]
    moments: int
    normals: FloatArray | None = None

    @cached_property
    def index(self) -> tuple[int, ...]:
        """Index of the maximum in `values`."""
        return tuple(int(i) for i in np.unravel_index(self._flat, self.values.shape))

    @cached_property
    def _flat(self) -> int:
        return int(self.values.argmax())

    @property
    def max_value(self) -> float:
        """Maximum value, in the unit `unit`."""
        return float(self.values[self.index])

    @property
    def position(self) -> dict[str, float]:
        """Coordinates of the maximum [m]; empty if `coordinates` is empty."""
        named = zip(self.coordinates.items(), self.index, strict=False)
        return {axis: float(values[i]) for (axis, values), i in named}

    @property
    def normal(self) -> FloatArray | None:
        """Normal of the critical plane at the maximum, shape (3,); None without critical planes."""
        return None if self.normals is None else self.normals.reshape(3, -1)[:, self._flat]

    def margin(self, limit: float) -> float:
        """Safety margin [-]: limit / maximum value - 1.

        Parameters
        ----------
        limit : float
            Fatigue limit of the material from tests, in the unit `unit`; > 0.

        Returns
        -------
        float
            Margin: 0 at the limit, negative above the limit, infinite if no value is above 0.
        """
        allowed = positive("limit", limit)
        if self.unit == "Pa":
            warn_if_implausible(strength("limit", allowed), stacklevel=3)
        return allowed / self.max_value - 1.0 if self.max_value > 0 else math.inf

    def over_depth(self) -> FloatArray:
        """Maximum value at each depth, shape (nz,).

        For a stress array, the last axis is taken as the depth.
        """
        maximum: FloatArray = self.values.reshape(-1, self.values.shape[-1]).max(axis=0)
        return maximum

    def to_dataset(self) -> xr.Dataset:
        """Convert to labelled fields with units, for files and plots.

        Returns
        -------
        xarray.Dataset
            Values in a variable named after `criterion`, with the coordinates of `coordinates` and
            the parameters of the criterion as attributes. For critical-plane criteria, a variable
            whose name ends with "_normal" contains the normals; its first dimension is "axis".

        Raises
        ------
        ValueError
            The points have no coordinates, because stress was given as an array.
        """
        import xarray as xr  # importing the package should not load it

        if not self.coordinates:
            raise ValueError(
                "to_dataset requires coordinates, but a field from a stress array has "
                "none: use the array `values` of the field instead"
            )
        unit = {"-": "1"}.get(self.unit, self.unit)
        attributes = {"units": unit, "long_name": self.name, "moments": self.moments}
        axes = tuple(self.coordinates)
        data: dict[str, Any] = {
            self.criterion: (axes, self.values, attributes | dict(self.parameters))
        }
        coordinates: dict[str, Any] = {
            axis: (axis, values, {"units": "m"}) for axis, values in self.coordinates.items()
        }
        if self.normals is not None:
            label = {"long_name": f"{self.name}, normal of the critical plane", "units": "1"}
            data[f"{self.criterion}_normal"] = (("axis", *axes), self.normals, label)
            coordinates["axis"] = ["x", "y", "z"]
        return xr.Dataset(data, coordinates)

    @property
    def name(self) -> str:
        """Name of the criterion for plots."""
        return _CRITERION_NAMES[self.criterion]

    def _rows(self) -> Rows:
        unit = "" if self.unit == "-" else self.unit
        rows = [("criterion", self.name)]
        for name, value in self.parameters.items():
            known = quantity(value, "Pa" if name == "yield_stress" else "")
            rows.append((name, known if isinstance(value, float) else str(value)))
        rows.append(("maximum", quantity(self.max_value, unit)))
        rows += [(axis, quantity(value, "m")) for axis, value in self.position.items()]
        if self.normal is not None:
            rows.append(("critical plane normal", ", ".join(f"{part:.3f}" for part in self.normal)))
        return [*rows, ("instants of the cycle", str(self.moments))]

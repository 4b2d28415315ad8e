# SPDX-License-Identifier: GPL-3.0-or-later
"""Exposure of a hardened case at each depth: equivalent stress divided by the local strength."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, choice, require_type
from .._util.display import HtmlTable, Rows, ShortRepr, quantity
from .._util.frozen import FrozenDict, read_only
from ..hardness import HardnessProfile, bending_limit_from_vickers, yield_from_vickers
from ..solutions.state import State
from .criteria import dang_van, max_von_mises, orthogonal_shear
from .cycle import Cycle, cycle, steady_cycle

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Exposure", "exposure"]

NAMES = {
    "yield": "yield (von Mises)",
    "dang_van": "Dang Van",
    "orthogonal_shear": "orthogonal shear",
}
"""Names of the criteria for figures and tables."""


@dataclass(frozen=True, repr=False, eq=False)
class Exposure(ShortRepr, HtmlTable):
    """Stress divided by strength at each depth, for several criteria; created by `exposure`.

    Attributes
    ----------
    z : ndarray, shape (nz,)
        Depths [m].
    stress : mapping of str to ndarray
        Largest equivalent stress at each depth [Pa], for "yield", "dang_van" and
        "orthogonal_shear".
    strength : mapping of str to ndarray
        Yield stress or fatigue limit of the criterion at each depth [Pa].
    hardness : ndarray, shape (nz,)
        Vickers hardness at each depth.
    slope : float
        Slope of Dang Van's criterion [-].
    """

    z: FloatArray
    stress: Mapping[str, FloatArray]
    strength: Mapping[str, FloatArray]
    hardness: FloatArray
    slope: float

    @cached_property
    def values(self) -> Mapping[str, FloatArray]:
        """Stress divided by strength for each criterion at each depth [-]; failure above 1."""
        return FrozenDict({name: self.stress[name] / self.strength[name] for name in self.stress})

    @cached_property
    def _peaks(self) -> dict[str, int]:
        return {name: int(values.argmax()) for name, values in self.values.items()}

    def max_value(self, criterion: str | None = None) -> float:
        """Largest exposure of a criterion [-]; default: the governing criterion (see `criterion`).

        Raises ValueError if the criterion is unknown.
        """
        name = self._named(criterion)
        return float(self.values[name][self._peaks[name]])

    def depth(self, criterion: str | None = None) -> float:
        """Depth of the largest exposure of a criterion [m]; default: the governing criterion.

        Raises ValueError if the criterion is unknown.
        """
        name = self._named(criterion)
        return float(self.z[self._peaks[name]])

    def _named(self, criterion: str | None) -> str:
        if criterion is None:
            return self.criterion
        return str(choice("criterion", criterion, tuple(self.stress)))

    @property
    def criterion(self) -> str:
        """Name of the governing criterion, which has the largest exposure."""
        return max(self.values, key=lambda name: self.values[name].max())

    def to_dataset(self) -> xr.Dataset:
        """Convert to labelled values over depth with units, for files and plots."""
        import xarray as xr  # importing the package should not load it

        data: dict[str, Any] = {"hardness": ("z", self.hardness, {"units": "HV"})}
        for name, values in self.values.items():
            label = {"units": "1", "long_name": f"exposure, {NAMES[name]}"}
            data[f"exposure_{name}"] = ("z", values, label)
            data[f"strength_{name}"] = ("z", self.strength[name], {"units": "Pa"})
        attributes = {"governing_criterion": self.criterion, "governing_depth": self.depth()}
        return xr.Dataset(data, {"z": ("z", self.z, {"units": "m"})}, attributes)

    def _rows(self) -> Rows:
        rows = [("governs", f"{NAMES[self.criterion]} at {quantity(self.depth(), 'm')}")]
        for name in self.values:
            text = f"{self.max_value(name):.3g} at {quantity(self.depth(name), 'm')}"
            rows.append((NAMES[name], text))
        return rows


def exposure(
    states: Cycle | State | Sequence[State] | ArrayLike,
    hardness: HardnessProfile,
    slope: float = 0.3,
    axis: str = "x",
    defect: float | None = None,
    body: int | None = None,
) -> Exposure:
    """Exposure (stress divided by strength) of a hardened case at each depth, for three criteria.

    The criteria are yield, Dang Van and orthogonal shear.

    Parameters
    ----------
    states : Cycle, State, or sequence of State
        Stress history: a cycle with depths (`hertz_cycle`, `cycle`, `steady_cycle`), the states of
        a pass, or the state of steady rolling along `axis`. The stress includes residual stress.
    hardness : HardnessProfile
        Hardness over depth.
    slope : float, optional
        Slope of Dang Van's criterion, in [0, 10] [-].
    axis : {"x", "y"}, optional
        Rolling direction, which is also the direction of the orthogonal shear stress.
    defect : float, optional
        Square root of the area of the largest inclusion [m], see
        `hardness.bending_limit_from_vickers`. Default: no inclusions, valid up to 400 HV only.
    body : {1, 2}, optional
        Body of the states. Default: 2.

    Returns
    -------
    Exposure
        For yield, the largest von Mises stress divided by the yield stress from hardness. For Dang
        Van and orthogonal shear, the equivalent shear stress divided by the fatigue limit in
        reversed torsion, t = f (1/2 + slope/3), where f is the fatigue limit in reversed bending,
        which follows from the hardness. With this t, 3 (t/f - 1/2) is the given slope, as required
        by `dang_van`.

    Raises
    ------
    ValueError
        The cycle has no depths, or an argument is outside its range.
    TypeError
        An argument has the wrong type.

    Warns
    -----
    HardnessRangeWarning
        A hardness is outside the range in which its relation to a strength is valid.
    """
    require_type("hardness", hardness, HardnessProfile)
    seen = _cycle(states, axis, body)
    if "z" not in seen.coordinates:
        raise ValueError(
            "states must have depths, but stress arrays have none: use hertz_cycle, or states"
        )
    z = seen.coordinates["z"]
    fields = {
        "yield": max_von_mises(seen),
        "dang_van": dang_van(seen, slope=slope),
        "orthogonal_shear": orthogonal_shear(seen, axis=axis),
    }
    used = float(fields["dang_van"].parameters["slope"])
    HV = hardness.at(z)
    torsion = bending_limit_from_vickers(HV, defect) * (0.5 + used / 3)
    strength = {"yield": yield_from_vickers(HV), "dang_van": torsion, "orthogonal_shear": torsion}
    return Exposure(
        z,
        FrozenDict({name: read_only(field.over_depth()) for name, field in fields.items()}),
        FrozenDict({name: read_only(np.asarray(limit)) for name, limit in strength.items()}),
        read_only(HV),
        used,
    )


def _cycle(
    states: Cycle | State | Sequence[State] | ArrayLike, axis: str, body: int | None
) -> Cycle:
    if isinstance(states, Cycle):
        if body is not None:
            raise ValueError("body must be omitted with a Cycle, which is already that of one body")
        return states
    return steady_cycle(states, body, axis) if isinstance(states, State) else cycle(states, body)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of wear computations."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias

import numpy as np

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, choice, integer
from .._util.display import ShortRepr
from .._util.version import version
from .._util.wear_quantities import WEAR
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..solutions.state import State

if TYPE_CHECKING:
    import xarray as xr

Moments = tuple[State, State]
"""Two states of a cycle: at maximum load, and after unloading.

Of several states at maximum load, the one with the maximum pressure is used.
"""


@dataclass(frozen=True)
class Cycle:
    """Results of one cycle; tuples have one value for each worn body."""

    number: int
    """Number of the cycle, from 1."""
    volume: tuple[float, ...]
    """Volume of the material in which the plastic strain exceeded the threshold [m^3]."""
    lost_volume: tuple[float, ...]
    """Decrease of the volume below the surface, from the change of the heights [m^3]."""
    depth: tuple[float, ...]
    """Maximum wear depth after smoothing [m]."""
    surface_strain: tuple[float, ...]
    """Maximum equivalent plastic strain in the first layer, before removal [-]."""
    max_equivalent_plastic_strain: tuple[float, ...]
    """Maximum equivalent plastic strain, before removal [-]."""
    max_pressure: float
    """Maximum pressure of the cycle [Pa]."""
    max_von_mises: float
    """Maximum von Mises stress in the worn bodies at maximum load [Pa]."""
    contact_area: float
    """Contact area at maximum load [m^2]."""
    cells_across_contact: float
    """Cells across the contact at maximum load, see `resolution.cells_across`."""
    layers_across_plastic_zone: tuple[float, ...]
    """Thickness of the plastic zone before removal [layers]; 0 without plastic zone."""
    coating_worn_share: tuple[float, ...]
    """Maximum worn depth so far, relative to the thickness of the top layer [-]; 0 without layers.
    """

    PER_BODY: ClassVar = (
        "volume", "lost_volume", "depth", "surface_strain", "max_equivalent_plastic_strain",
        "layers_across_plastic_zone", "coating_worn_share",
    )  # fmt: skip
    OPTIONAL: ClassVar = ("coating_worn_share",)
    """Quantities that `to_dataset` omits if they are 0 in all cycles."""


@dataclass(frozen=True)
class FrettingCycle:
    """Results of one cycle of `fretting`; tuples have one value for each worn body.

    Pressure, slip and areas refer to the surface at the start of the cycle.
    """

    number: int
    """Number of the cycle, from 1."""
    parts: int
    """Number of parts into which the repeats are divided; the contact is solved for each part."""
    friction_work: float
    """Frictional work of all repeats [J]."""
    volume: tuple[float, ...]
    """Worn volume according to the wear law [m^3]."""
    lost_volume: tuple[float, ...]
    """Decrease of the volume below the surface, from the change of the heights [m^3]."""
    depth: tuple[float, ...]
    """Maximum wear depth [m]."""
    slip_distance: float
    """Maximum slip distance of a cell in one repeat [m]."""
    max_pressure: float
    """Maximum pressure [Pa]."""
    contact_area: float
    """Contact area at maximum load [m^2]."""
    stick_area: float
    """Contact area that sticks during a whole repeat [m^2]."""
    cells_across_contact: float
    """Cells across the contact at maximum load, see `resolution.cells_across`."""
    max_equivalent_plastic_strain: tuple[float, ...]
    """Maximum equivalent plastic strain after removal [-]; 0 in elastic bodies."""
    plastic_flow: float
    """Maximum equivalent plastic strain that the last computed loop added [-]."""
    coating_worn_share: tuple[float, ...]
    """Maximum worn depth so far, relative to the thickness of the top layer [-]; 0 without layers.
    """

    PER_BODY: ClassVar = (
        "volume", "lost_volume", "depth", "max_equivalent_plastic_strain", "coating_worn_share",
    )  # fmt: skip
    OPTIONAL: ClassVar = ("max_equivalent_plastic_strain", "plastic_flow", "coating_worn_share")
    """Quantities that `to_dataset` omits if they are 0 in all cycles."""


AnyCycle: TypeAlias = Cycle | FrettingCycle


@dataclass(eq=False, repr=False)
class BaseWearResult(ShortRepr):
    """Results common to wear by plastic strain and wear by slip."""

    grid: Grid
    worn: tuple[int, ...]
    cycles: Sequence[AnyCycle]
    stopped: bool
    """Whether no material was removed in the last cycle, so that wear has ceased."""
    relief1: Relief | None
    """Final surface of body 1, for further computations."""
    relief2: Relief | None
    heights: dict[int, FloatArray] = field(repr=False)
    """Heights of each worn body before the first cycle and after each cycle [m], shape (cycles + 1,
    rows, ny)."""
    first_row: dict[int, int] = field(repr=False)
    last: tuple[State, ...] = field(repr=False)
    _solve_first: Callable[[], Any] = field(repr=False)

    @cached_property
    def first(self) -> Any:
        """States of the first cycle, in the same order as the states in `last`.

        After a resumed run, the first cycle is solved again to obtain them.
        """
        return self._solve_first()

    def x(self, body: int | None = None) -> FloatArray:
        """Return the coordinate x of each row of `heights` [m]; 0 at the initial contact."""
        chosen = self._body(body)
        rows = self.first_row[chosen] + np.arange(self.heights[chosen].shape[1])
        return np.asarray((rows - 0.5 * (self.grid.nx - 1)) * self.grid.dx, dtype=np.float64)

    def profile(self, cycle: int = -1, body: int | None = None) -> FloatArray:
        """Return the heights of a body after a cycle [m], shape (len(x), ny).

        Cycle 0 gives the initial heights; negative numbers count from the last cycle.
        Raises ValueError for a cycle that was not computed, or a body that does not wear.
        """
        chosen = self._body(body)
        count = len(self.cycles)
        integer("cycle", cycle)
        if not -count - 1 <= cycle <= count:
            raise ValueError(f"cycle must be in [0, {count}], got {cycle}")
        return np.asarray(self.heights[chosen][cycle], dtype=np.float64)

    @property
    def rate(self) -> FloatArray:
        """Worn volume of each cycle, summed over worn bodies [m^3]."""
        return np.array([sum(cycle.volume) for cycle in self.cycles])

    def _body(self, body: int | None) -> int:
        return int(choice("body", self.worn[-1] if body is None else body, self.worn))

    def to_dataset(self) -> xr.Dataset:
        """Convert to a dataset with units: the results of each cycle, and heights after each cycle.

        Returns
        -------
        xarray.Dataset
            Dataset with the dimensions cycle, body (worn bodies) and, for heights, state (0: before
            the first cycle), x_body1 or x_body2, and y. It can be saved by
            `samcontact.results.save` and read by `open_results`.
        """
        import xarray as xr  # here, so that importing the package does not load it

        numbers = [cycle.number for cycle in self.cycles]
        coordinates = {
            "cycle": numbers,
            "body": list(self.worn),
            "state": [0, *numbers],
            "y": np.asarray(self.grid.y),
        }
        dataset = xr.Dataset(coords={n: WEAR[n].variable(n, v) for n, v in coordinates.items()})
        record: type[AnyCycle] = type(self.cycles[0])
        for name in (item.name for item in fields(record) if item.name != "number"):
            dims = ("cycle", "body") if name in record.PER_BODY else "cycle"
            values = np.array([getattr(cycle, name) for cycle in self.cycles])
            if name in record.OPTIONAL and not values.any():
                continue
            dataset[name] = WEAR[name].variable(dims, values)
        dataset["wear_rate"] = WEAR["wear_rate"].variable("cycle", self.rate)
        dataset["worn_volume"] = WEAR["worn_volume"].variable("cycle", np.cumsum(self.rate))
        for body in self.worn:
            x = f"x_body{body}"
            dataset.coords[x] = WEAR["x"].variable(x, self.x(body), body)
            dataset[f"heights_body{body}"] = WEAR["heights"].variable(
                ("state", x, "y"), self.heights[body], body
            )
        dataset.attrs = {"samcontact_version": version, "stopped": int(self.stopped)}
        return dataset


@dataclass(eq=False, repr=False)
class WearResult(BaseWearResult):
    """Results of `run`: cycles, worn surfaces, and states of the first and last cycle."""

    cycles: list[Cycle]
    last: Moments = field(repr=False)
    """States of the last cycle at maximum load and after unloading, before material is removed."""


@dataclass(eq=False, repr=False)
class FrettingResult(BaseWearResult):
    """Results of `fretting`: cycles, worn surfaces, and states of the first and last cycle."""

    cycles: list[FrettingCycle]
    last: tuple[State, ...] = field(repr=False)
    """States of the first repeat of the last cycle; their grid may be smaller than `grid`."""

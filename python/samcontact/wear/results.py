# SPDX-License-Identifier: GPL-3.0-or-later
"""What a wear computation gives."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias

import numpy as np

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, choice, integer
from .._util.display import Brief
from .._util.quantities import WEAR
from .._util.version import version
from ..scene.grid import Grid
from ..scene.moving_topography import Relief
from ..solutions.state import State

if TYPE_CHECKING:
    import xarray as xr

Moments = tuple[State, State]
"""Under the largest load of a cycle, where its pressure is largest, and unloaded at its end."""


@dataclass(frozen=True)
class Cycle:
    """One cycle; tuples have one value for each worn body."""

    number: int
    """From 1."""
    volume: tuple[float, ...]
    """Of the material whose plastic strain exceeds the threshold, removed [m^3]."""
    lost: tuple[float, ...]
    """By how much the volume under the surface is less after it [m^3]."""
    depth: tuple[float, ...]
    """Largest wear depth, after smoothing [m]."""
    surface_strain: tuple[float, ...]
    """Largest equivalent plastic strain of the first layer, before anything is removed [-]."""
    max_equivalent_plastic_strain: tuple[float, ...]
    """Largest equivalent plastic strain, before anything is removed [-]."""
    max_pressure: float
    """Largest pressure of the cycle [Pa]."""
    max_von_mises: float
    """Largest von Mises stress in the worn bodies under the largest load [Pa]."""
    contact_area: float
    """Under the largest load [m^2]."""
    contact_cells: float
    """Across the contact under the largest load, see `resolution.cells_across`."""
    plastic_layers: tuple[float, ...]
    """From top to bottom of the plastic zone, before anything is removed; 0 without one."""

    PER_BODY: ClassVar = (
        "volume", "lost", "depth", "surface_strain", "max_equivalent_plastic_strain",
        "plastic_layers",
    )  # fmt: skip


@dataclass(frozen=True)
class FrettingCycle:
    """One cycle of `fretting`; tuples have one value for each worn body.

    Pressure, slip and areas are those of the surface with which it begins.
    """

    number: int
    """From 1."""
    parts: int
    """Into which its repeats were divided, the worn surface being solved for before each."""
    friction_work: float
    """Of all its repeats [J]."""
    volume: tuple[float, ...]
    """That the law of wear removes [m^3]."""
    lost: tuple[float, ...]
    """By how much the volume under the surface is less after it [m^3]."""
    depth: tuple[float, ...]
    """Largest wear depth [m]."""
    slip_path: float
    """Longest way of slip of a cell in one repeat [m]."""
    max_pressure: float
    """Largest pressure [Pa]."""
    contact_area: float
    """Under the largest load [m^2]."""
    sticking_area: float
    """What touches and does not slip in a whole repeat [m^2]."""
    contact_cells: float
    """Across the contact under the largest load, see `resolution.cells_across`."""

    PER_BODY: ClassVar = ("volume", "lost", "depth")


AnyCycle: TypeAlias = Cycle | FrettingCycle


@dataclass(eq=False, repr=False)
class AnyResult(Brief):
    """What both laws of wear give."""

    grid: Grid
    worn: tuple[int, ...]
    cycles: Sequence[AnyCycle]
    stopped: bool
    """Whether nothing was worn in the last cycle, so that nothing would be in another one."""
    relief1: Relief | None
    """Final surface of body 1, to go on from."""
    relief2: Relief | None
    heights: dict[int, FloatArray] = field(repr=False)
    """Of each worn body, at the start and after each cycle [m], shape (cycles + 1, rows, ny)."""
    first_row: dict[int, int] = field(repr=False)
    last: tuple[State, ...] = field(repr=False)
    _solve_first: Callable[[], Any] = field(repr=False)

    @cached_property
    def first(self) -> Any:
        """As `last`, of the first cycle, which is solved again after going on from a checkpoint."""
        return self._solve_first()

    def x(self, body: int | None = None) -> FloatArray:
        """Positions of the rows of `heights` on a worn body [m]; 0 where the contact starts."""
        chosen = self._body(body)
        rows = self.first_row[chosen] + np.arange(self.heights[chosen].shape[1])
        return np.asarray((rows - 0.5 * (self.grid.nx - 1)) * self.grid.dx, dtype=np.float64)

    def profile(self, cycle: int = -1, body: int | None = None) -> FloatArray:
        """Heights of a worn body after a cycle, 0: before the first [m], shape (len(x), ny).

        Raises ValueError for a cycle that was not computed, or a body that is not worn.
        """
        chosen = self._body(body)
        count = len(self.cycles)
        integer("cycle", cycle)
        if not -count - 1 <= cycle <= count:
            raise ValueError(f"cycle must be in [0, {count}], got {cycle}")
        return np.asarray(self.heights[chosen][cycle], dtype=np.float64)

    @property
    def rate(self) -> FloatArray:
        """Worn volume of each cycle, of all worn bodies [m^3]."""
        return np.array([sum(cycle.volume) for cycle in self.cycles])

    def _body(self, body: int | None) -> int:
        return int(choice("body", self.worn[-1] if body is None else body, self.worn))

    def to_dataset(self) -> xr.Dataset:
        """Labelled results with units: per cycle, and the heights after each cycle.

        Returns
        -------
        xarray.Dataset
            Dimensions cycle, body (the worn ones), and for each of those state (0: before the first
            cycle), x_body1 or x_body2, y. Save it with `samcontact.results.save`,
            read it with `open_results`.
        """
        import xarray as xr  # here, since importing the package should not load it

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
class WearResult(AnyResult):
    """Cycles of `run`, worn surfaces, and the first and last cycle's states."""

    cycles: list[Cycle]
    last: Moments = field(repr=False)
    """States of the last cycle, under its largest load, and unloaded before anything is removed."""


@dataclass(eq=False, repr=False)
class FrettingResult(AnyResult):
    """Cycles of `fretting`, worn surfaces, and the first and last cycle's states."""

    cycles: list[FrettingCycle]
    last: tuple[State, ...] = field(repr=False)
    """States of the first repeat of the last cycle."""

# SPDX-License-Identifier: GPL-3.0-or-later
"""Sequences of successively finer grids on which a case is solved."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from .. import hertz
from .._util.cached_property import cached_property
from .._util.display import quantity
from ..bodies.layered import Body, interfaces_on_cells, softest
from ..simulation import coarsening
from .estimate import REFINEMENT_RATIO

if TYPE_CHECKING:
    from ..cases import Case
    from ..cases.sections import GridSection

CELLS_OF_FIRST_GRID = math.sqrt(32.0)
"""Cells per semi-axis of the Hertz contact on the first grid. Each finer grid has sqrt(2) times as
many as the previous grid."""
HERTZ_MARGIN = 1.35
"""Half-width of the first grid, relative to the semi-axis of the Hertz contact."""
HERTZ_MARGIN_ALONG_TRAVEL = 2.0
"""Half-width of the first grid along x for moving bodies, relative to the semi-axis. Plastic strain
carried along by a body then remains in the grid for a longer distance."""
_MIN_CELLS_OF_DETAIL = 4.0  # cells across the smallest detail of a surface, on the first grid
_CELLS_OF_SAMPLE = 2.0
"""Minimum number of cells of the first grid between two samples of an interpolated surface."""
_ELASTIC_DEPTH = 1.2  # depth of the grid of elastic bodies, relative to the smaller semi-axis
_MIN_CELLS_IN_LAYER = 3
"""Minimum number of cells of the first grid in the largest common divisor of the thicknesses of
elastic-plastic layers. Maxima at an interface are extrapolated from this number of cells."""
_MAX_CELL_ASPECT = 8.0
"""Maximum ratio of the cell width of the first grid to the largest common divisor of the layer
thicknesses."""


class Grids(Protocol):
    """Grids of a case by level; level 0 is the coarsest."""

    def sizes(self, level: int) -> tuple[float, float]:
        """Return the cell sizes along x and y [m]."""
        ...

    def on(self, level: int, *, free: bool) -> GridSection:
        """Return the grid of a level.

        free: whether the solver chooses the number of cell layers along z (nz = 0).
        """
        ...

    def settle(self, level: int, half: tuple[float, float]) -> None:
        """Fit the extent of finer grids to the half-widths [m] of contact and plastic strain."""
        ...


def grids_of(case: Case, bodies: Sequence[Body]) -> Grids:
    """Return grids around the Hertz contact, or with the extent of [grid] if the case needs it."""
    return GivenGrids(case, bodies) if case.reason_for_grid else HertzGrids(case, bodies)


class HertzGrids:
    """Grids of automatically chosen extent around the Hertz contact of a case at maximum load."""

    def __init__(self, case: Case, bodies: Sequence[Body]) -> None:
        self.case, self.bodies = case, bodies
        self._refined = 1.0  # factor on the number of cells along y
        along_x = HERTZ_MARGIN_ALONG_TRAVEL if case.moves else HERTZ_MARGIN
        semi_axes = self.semi_axes
        along_y = HERTZ_MARGIN if self._refined == 1.0 else 1.0  # a roller ends at its faces
        self.half = along_x * semi_axes[0], along_y * semi_axes[1]
        self._depths = Depths(bodies, min(self.semi_axes) / self.cells(0))

    @cached_property
    def semi_axes(self) -> tuple[float, float]:
        """Semi-axes [m] along x and y of the Hertz contact at maximum load, without roughness."""
        E_star = hertz.effective_modulus(*map(softest, self.bodies))
        steps = self.case.steps()
        largest = max((step.get("load", 0.0) for step in steps), default=0.0)
        part = self.case.surface.first_grid(largest, E_star) if largest > 0 else None
        if part is not None:
            self._refined = part.refined
            return part.half
        radii = self.case.surface.radii()
        assert radii is not None
        sizes = []
        for name in ("load", "approach"):
            target = max((step.get(name, 0.0) for step in steps), default=0.0)
            if target > 0:
                given: dict[str, Any] = {name: target}
                if math.isclose(*radii, rel_tol=1e-9):
                    a = hertz.point(radii[0], E_star, **given).a
                    sizes.append((a, a))
                else:
                    found = hertz.elliptic(*radii, E_star, **given)
                    sizes.append((found.a_x, found.a_y))
        if not sizes:
            raise ValueError("path: at least one load or approach must be > 0")
        return max(sizes)

    @cached_property
    def _finer(self) -> float:
        """Factor >= 1 by which roughness, dents and furrows require more cells than the contact."""
        widest = min(self.semi_axes) / CELLS_OF_FIRST_GRID
        return max([1.0, *(_MIN_CELLS_OF_DETAIL * widest / size for size in details(self.case))])

    def cells(self, level: int) -> float:
        """Return the number of cells along a semi-axis of the Hertz contact at a grid level."""
        return float(CELLS_OF_FIRST_GRID * self._finer * REFINEMENT_RATIO**level)

    def sizes(self, level: int) -> tuple[float, float]:
        cells = self.cells(level)
        return self.semi_axes[0] / cells, self.semi_axes[1] / (cells * self._refined)

    def on(self, level: int, *, free: bool) -> GridSection:
        """Return the grid of a level, with the centre of a cell at the grid centre."""
        from ..cases.sections import GridSection

        dx, dy = sizes = self.sizes(level)
        nx, ny = (2 * math.ceil(half / d) + 1 for half, d in zip(self.half, sizes, strict=True))
        layers = 0 if free else math.ceil(_ELASTIC_DEPTH * self.cells(level)) + 2
        dz = self._depths.size(level, min(self.semi_axes) / self.cells(level))
        return GridSection(nx=nx, ny=ny, dx=dx, dy=dy, nz=layers, dz=dz)

    def settle(self, level: int, half: tuple[float, float]) -> None:
        if not any(half):  # unknown
            return
        wide = [1.08 * h + 2.0 * d for h, d in zip(half, self.sizes(level), strict=True)]
        along_x = max(wide[0], self.half[0]) if self.case.moves else wide[0]
        self.half = along_x, wide[1]


class GivenGrids:
    """Grids with the extent of [grid], and with cells small enough for the surface details."""

    def __init__(self, case: Case, bodies: Sequence[Body]) -> None:
        if case.grid is None:
            raise ValueError(
                f"{case.reason_for_grid}, so that accuracy requires [grid]: add [grid] with the "
                "extent of all grids and the cells of the first, coarsest grid"
            )
        self.case, self.grid = case, case.grid
        widest = max(d for n, d in self._axes if n > 1)
        samples = [
            _CELLS_OF_SAMPLE * d / step
            for steps in samples_of(case) for (n, d), step in zip(self._axes, steps, strict=True)
            if n > 1
        ]  # fmt: skip
        waves = [_MIN_CELLS_OF_DETAIL * widest / size for size in details(case)]
        self._finer = max([1.0, *samples, *waves])
        dz = math.inf if self.grid.dz is None else self.grid.dz / self._finer
        self._depths = Depths(bodies, dz)

    @property
    def _axes(self) -> tuple[tuple[int, float], tuple[int, float]]:
        """Number and size [m] of the cells of [grid] along x and y."""
        return (self.grid.nx, self.grid.dx), (self.grid.ny, self.grid.dy)

    def _along(self, axis: int, level: int) -> tuple[int, float]:
        """Return the number and size [m] of cells along an axis."""
        n, d = self._axes[axis]
        if n == 1:
            return n, d
        times = self._finer * REFINEMENT_RATIO**level
        if "xy"[axis] in self.grid.periodic:
            count = 2 * round(0.5 * n * times)
            return count, n * d / count
        # as many cells as fit, and a centre or an edge of a cell at the grid centre as in [grid]
        count = math.floor(n * times + 1e-9)
        return count - (count - n) % 2, d / times

    def sizes(self, level: int) -> tuple[float, float]:
        return self._along(0, level)[1], self._along(1, level)[1]

    def on(self, level: int, *, free: bool) -> GridSection:
        """Return the grid of a level, with cell layers along z if [grid] has them."""
        (nx, dx), (ny, dy) = (self._along(axis, level) for axis in (0, 1))
        changes: dict[str, Any] = {"nx": nx, "ny": ny, "dx": dx, "dy": dy}
        if self.grid.dz is not None:
            dz = self.grid.dz / (self._finer * REFINEMENT_RATIO**level)
            dz = self._depths.size(level, dz)
            layers = 0 if free else math.ceil(self.grid.nz * self.grid.dz / dz)
            changes |= {"dz": dz, "nz": layers}
        return self.grid.model_copy(update=changes)

    def settle(self, level: int, half: tuple[float, float]) -> None:
        """Keep the extent of [grid]: the surface is known only there, or has this period."""


class Depths:
    """Cell sizes along z that divide each elastic-plastic layer into a whole number of cells.

    first: cell size along z on the first grid, for bodies without layers [m].
    """

    def __init__(self, bodies: Sequence[Body], first: float) -> None:
        self._first = first
        self._part: float | None = None
        depths = [
            float(depth) for body in bodies for depth in interfaces_on_cells(body)
        ]  # fmt: skip
        if not depths:
            return
        part = common_part(depths)
        min_thickness = first / _MAX_CELL_ASPECT
        if part is None or part < min_thickness:
            listed = ", ".join(f"{depth:.6g}" for depth in depths)
            raise ValueError(
                f"layers: the depths of the interfaces, {listed} m, must be multiples of a common "
                f"length >= {min_thickness:.2g} m, so that cells fit all layers: round the "
                "thicknesses, or specify [grid] instead of accuracy"
            )
        self._part = part

    def size(self, level: int, wanted: float) -> float:
        """Return the cell size along z [m] at a grid level.

        wanted: cell size for bodies without layers [m].
        """
        if self._part is None:
            return wanted
        cells = max(_MIN_CELLS_IN_LAYER, math.ceil(self._part / self._first))
        return self._part / round(cells * REFINEMENT_RATIO**level)


def details(case: Case) -> list[float]:
    """Return the lengths [m] of the smallest details of surfaces that are given as functions."""
    found: list[float] = []
    roughness: Any = case.surface.roughness
    if roughness is not None and roughness.kind == "sinusoidal":
        found += [0.5 * roughness.wavelength_x, 0.5 * roughness.wavelength_y]
    for relief in (case.relief1, case.relief2):
        kind: Any = relief
        if kind is not None and kind.kind == "dent":
            found.append(2.0 * math.sqrt(2.0 * kind.radius * abs(kind.depth)))
        elif kind is not None and kind.kind == "furrow":
            found.append(2.0 * kind.half_width)
    return [size for size in found if size > 0]


def samples_of(case: Case) -> list[tuple[float, float]]:
    """Return the distances along x and y [m] between the samples of interpolated surfaces."""
    assert case.grid is not None
    folder, grid = case.source.parent, case.grid.build()
    parts: list[Any] = [case.surface.roughness, case.surface, case.relief1, case.relief2]
    return [part.sample_steps(grid, folder) for part in parts if hasattr(part, "sample_steps")]


def interpolated_surface(case: Case) -> str:
    """Return a note on interpolated surface heights, or "" if no heights are interpolated."""
    if not case.reason_for_grid or not (steps := samples_of(case)):
        return ""
    along = [quantity(min(axis), "m", 3) for axis in zip(*steps, strict=True)]
    return (
        f"heights interpolated between samples that are {along[0]} (x) and {along[1]} (y) apart; "
        "errors do not include waves of the real surface that are shorter than this"
    )


def slope_between_samples(case: Case) -> float:
    """Return the fraction of the gap's mean-square slope at wavelengths below four samples.

    Return NaN if no surface is interpolated.
    """
    if case.grid is None or not case.reason_for_grid or not (steps := samples_of(case)):
        return math.nan
    axes = (case.grid.nx, case.grid.dx), (case.grid.ny, case.grid.dy)
    counts = [
        max(2, 2 * round(n * d / min(step) / 2)) if n > 1 else 1  # even, for periodic grids
        for (n, d), step in zip(axes, zip(*steps, strict=True), strict=True)
    ]
    (nx, dx), (ny, dy) = axes
    cells = {"nx": counts[0], "ny": counts[1], "dx": nx * dx / counts[0], "dy": ny * dy / counts[1]}
    grid = case.grid.model_copy(update=cells).build()
    gap = case.surface.build(grid, case.source.parent, case.grid.build())
    return coarsening.slope_beyond(gap, grid.dx, grid.dy) if np.isfinite(gap).all() else math.nan


def common_part(lengths: Sequence[float]) -> float | None:
    """Return the largest common divisor of lengths; None if it is below 1/64 of the first one."""
    for parts in range(1, 65):
        part = lengths[0] / parts
        counts = [length / part for length in lengths]
        if all(abs(count - round(count)) < 1e-8 * count for count in counts):
            return part
    return None

# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the arguments of a wear computation, before expensive work."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._util.checks import (
    FloatArray,
    boolean,
    choice,
    finite_array,
    number,
    positive,
    require_type,
    step_list,
)
from .._util.errors import ElasticStrainWarning
from .._util.short_text import in_short
from .._util.travels import along_x
from ..bodies.free_faces import require_endless
from ..bodies.layered import Body, elastic, require_bodies
from ..bodies.viscoelastic import instantaneous
from ..contact.solver import ContactSolver
from ..diagnostics.monitor import MAX_SMALL_STRAIN
from ..heat import Heat
from ..problem.contact_law import in_contact
from ..problem.domain import SurfaceGeometry
from ..problem.friction import FrictionLaw, is_law
from ..problem.grid import Grid, within_period
from ..problem.moving_topography import heights_over
from ..simulation.steps import STEP_ARGUMENTS
from .problem import WearProblem
from .results import Cycle
from .steps import Gaussian, Polynomials, Window, scaled_to_volume, window_and_order

YIELD_STRAIN = 20e-6
"""Plastic strain at the conventional yield point [-]; the threshold of wear must be larger.

The threshold refers to the plastic strain alone. It need not exceed the elastic strain at yield,
about 1 % for a hard steel. Even a threshold of 0.2 % is far beyond yield.
"""
_MOVING_MEAN_WIDTH = math.sqrt(12.0)
"""Width of a moving mean divided by the standard deviation of a Gaussian with equal variance."""
_MARGIN_ROWS = 4
"""Rows of cells added at both ends of the rows that can wear, for interpolation between cells."""


@dataclass(frozen=True)
class WearSetup(WearProblem):
    """Checked arguments of `samcontact.wear.run`, constant over all cycles."""

    threshold: float
    filter: Gaussian | Polynomials
    strain_depth: str
    keep_heat: bool
    """Whether each cycle continues from the temperatures of the previous cycle."""

    @property
    def may_grow(self) -> bool:
        """Whether the grid may be enlarged.

        It may not with `keep_heat`, because temperatures are stored for one grid only.
        """
        return super().may_grow and not self.keep_heat

    @property
    def record(self) -> type[Cycle]:
        return Cycle

    def rows(self, body: int) -> tuple[int, int]:
        """Return the first row that can wear in a body, and the number of such rows.

        A row is a line of cells along y. Rows that pass through the grid during the cycle can wear.
        Further rows on both sides can wear because the smoothing filter spreads the wear.
        """
        if self.grid.along_x:
            return 0, self.grid.nx
        cells = travels(self.cycle)[:, body - 1] / self.grid.dx
        margin = max(self.filter.sides) + _MARGIN_ROWS
        first = -int(np.ceil(cells.max())) - margin
        end = self.grid.nx - int(np.floor(cells.min())) + margin
        return first, end - first

    def smoothed(self, depth: FloatArray) -> FloatArray:
        """Return a smoothed wear depth [m]; on a periodic grid, the smoothing is periodic."""
        if not self.grid.along_x:
            return self.filter(depth)
        rows = self.grid.nx
        return scaled_to_volume(depth, self.filter(np.tile(depth, (3, 1)))[rows : 2 * rows])


def make_setup(
    grid: Grid,
    bodies: tuple[Body, Body],
    given: SurfaceGeometry,
    cycle: Iterable[Mapping[str, Any]],
    threshold: float,
    worn: Sequence[int],
    smoothing: Gaussian | Polynomials,
    strain_depth: str,
    keep_heat: bool,
    friction: float | FrictionLaw,
    settings: dict[str, Any],
) -> WearSetup:
    """Check all arguments and return them.

    One elastic contact is solved to compare the width of the smoothing filter with the contact
    size.
    """
    require_type("grid", grid, Grid)
    if not grid.has_volume:
        raise ValueError("grid must have layers for wear by plastic strain, got dz = None: set dz")
    require_bodies(*bodies)
    require_endless("wear does not support ends of bodies", *bodies)
    surfaces = given.over(grid)
    finite_array("gap", surfaces.initial_gap)  # finite bodies are not supported
    limit = number("threshold", threshold)
    if not YIELD_STRAIN < limit < MAX_SMALL_STRAIN:
        raise ValueError(
            f"threshold must be > {YIELD_STRAIN!r} (yield) and < {MAX_SMALL_STRAIN!r} (limit of "
            f"small strains), got {limit!r}"
        )
    numbers = tuple(worn) if isinstance(worn, (list, tuple)) else ()
    if not numbers or any(numbers.count(one) > 1 for one in numbers):
        raise ValueError(f"worn must be (1,), (2,) or (1, 2), got {in_short(worn)}")
    for index in numbers:
        material = bodies[choice("worn", index, (1, 2)) - 1]
        if not material.is_plastic:
            raise ValueError(
                "worn must contain only elastic-plastic bodies, got "
                f"body {index} with law {material.law}"
            )
    path = step_list("cycle", cycle, STEP_ARGUMENTS)
    _check_cycle(path, grid)
    setup = WearSetup(
        surfaces=given,
        grid=grid,
        bodies=bodies,
        gap=surfaces.initial_gap,
        reliefs=surfaces.reliefs,
        cycle=path,
        friction=friction if is_law(friction) else number("friction", friction),
        worn=tuple(sorted(numbers)),
        settings=settings,
        threshold=limit,
        filter=smoothing,
        strain_depth=choice("strain_depth", strain_depth, ("exact", "smoothed")),
        keep_heat=_kept_heat(keep_heat, settings.get("heat")),
    )
    _check_filter(setup)
    return setup


def _kept_heat(keep_heat: bool, heat: Heat | None) -> bool:
    """Check `keep_heat`, which requires heating with `history`, and return it."""
    if boolean("keep_heat", keep_heat) and (heat is None or heat.history is None):
        raise ValueError(
            f"keep_heat requires a heat history, got heat = {in_short(heat)}: set "
            "heat.history, or omit keep_heat"
        )
    return keep_heat


def make_filter(
    grid: Grid, smoothing_length: float | None, window: Window, order: int | None
) -> Gaussian | Polynomials:
    """Return the filter that smooths the edge of the worn area, defined by a length or a window."""
    require_type("grid", grid, Grid)
    if (smoothing_length is None) == (window is None):
        given = "none" if window is None else f"{smoothing_length!r} and {window!r}"
        raise ValueError(
            "exactly one of smoothing_length [m] and window [cells] must be given, got "
            f"{given}: for no smoothing, use window = 1"
        )
    if smoothing_length is None:
        x, y, degree = window_and_order(window, 2 if order is None else order)
        return Polynomials((x, y), degree)
    if order is not None:
        raise ValueError(
            "order applies only to the filter given by window, and must be omitted with "
            f"smoothing_length, got order = {in_short(order)}"
        )
    length = positive("smoothing_length", smoothing_length)
    cell = max(grid.dx, grid.dy)
    if length < cell:
        raise ValueError(
            f"smoothing_length must be >= one cell, {cell!r} m, got {length!r}: use smaller cells, "
            "or window = 1 for no smoothing"
        )
    return Gaussian((length / grid.dx, length / grid.dy))


def _check_cycle(path: list[dict[str, Any]], grid: Grid) -> None:
    if not path:
        raise ValueError("cycle must contain at least one step, got none")
    step = path[-1]
    if step.get("load") != 0:
        raise ValueError(
            f"cycle must end unloaded, with a step {{'load': 0.0}}, got {in_short(step)}"
        )
    end = [within_period(grid, travel) for travel in travels(path)[-1].tolist()]
    if max(map(abs, end)) > 1e-6 * grid.dx:
        raise ValueError(
            "cycle must move both bodies back to their initial positions: the sum of the advances "
            f"must be 0, got sums of {end[0]!r} m and {end[1]!r} m: add a step that moves them back"
        )


def travels(path: list[dict[str, Any]]) -> FloatArray:
    """Return the distance travelled by each body at all instants [m], shape (steps + 1, 2).

    The instants are the start of the cycle and the end of each step.
    """
    steps = [along_x(step.get("advance", (0.0, 0.0)), "in a cycle of wear") for step in path]
    return np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])


def _check_filter(setup: WearSetup) -> None:
    """Raise ValueError if the filter is wider than the contact and would spread wear beyond it."""
    with warnings.catch_warnings():
        # in the cycles, bodies yield and do not reach this elastic pressure
        warnings.simplefilter("ignore", ElasticStrainWarning)
        pressure = _elastic_pressure(setup)
    touched_cells = in_contact(pressure)
    if not touched_cells.any():
        raise ValueError("cycle must have at least one step with contact, got none")
    for axis, name in enumerate("xy"):
        touched = np.flatnonzero(touched_cells.any(axis=1 - axis))
        extent = int(touched[-1] - touched[0]) + 1
        size = f"the contact ({extent} cells along {name} at maximum load)"
        if isinstance(setup.filter, Gaussian):
            cells = setup.filter.deviation[axis]
            if cells * _MOVING_MEAN_WIDTH > max(extent, 1):
                dx = (setup.grid.dx, setup.grid.dy)[axis]
                longest = max(extent, 1) * dx / _MOVING_MEAN_WIDTH
                raise ValueError(
                    f"smoothing_length must be <= {longest:.3g} m, so that wear is not spread "
                    f"beyond {size}, got {cells * dx:.6g} m"
                )
        elif setup.filter.sides[axis] > max(extent, 1):
            raise ValueError(
                f"window must not be larger than {size}, got {setup.filter.sides[axis]}"
            )


def _elastic_pressure(setup: WearSetup) -> FloatArray:
    path, grid = setup.cycle, setup.grid
    given = [step["pressure"] for step in path if step.get("pressure") is not None]
    if given:
        fields = [finite_array("pressure", field, grid.surface_shape) for field in given]
        return max(fields, key=lambda field: float(field.sum()))

    def gap_over(larger: Grid) -> FloatArray:
        at = setup.over(larger)
        gap: FloatArray = at.gap.copy()
        for relief in at.reliefs:
            if relief is not None:
                gap -= heights_over(relief, 0, larger.nx, larger)
        return gap

    gap = gap_over if setup.surfaces.are_known else gap_over(grid)
    body1, body2 = (
        elastic(body) if body.is_plastic else instantaneous(body) for body in setup.bodies
    )
    friction = setup.friction
    if isinstance(friction, FrictionLaw):
        friction = friction.sliding_ratio
    solver = ContactSolver(
        grid, body1, body2, friction, on_border=setup.settings.get("on_border", "error")
    )
    loads = [number("load", step["load"]) for step in path if step.get("load") is not None]
    if max(loads) > 0:
        return solver.solve(gap, load=max(loads)).pressure
    depths = [number("approach", s["approach"]) for s in path if s.get("approach") is not None]
    if not depths:
        return np.zeros(grid.surface_shape)
    return solver.solve(gap, approach=max(depths)).pressure

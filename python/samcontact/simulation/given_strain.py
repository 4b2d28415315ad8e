# SPDX-License-Identifier: GPL-3.0-or-later
"""Initial plastic strain and eigenstrain prescribed for a simulation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array, integer, real_array
from .._util.short_text import in_short
from ..bodies.layered import backstresses_of
from ..problem.grid import Grid

if TYPE_CHECKING:
    from .engine import Engine, Preparation

Cells = Sequence[int]
"""Numbers of cells along x, y and z."""


def set_plastic_strain(
    engine: Engine,
    body: int,
    strain: ArrayLike,
    equivalent: ArrayLike | None,
    backstress: ArrayLike | None,
    first: int | None,
    *,
    anywhere: bool = False,
) -> None:
    """Set the plastic strain of a body, see `Simulation.set_plastic_strain`.

    anywhere: whether the strain may lie entirely outside the grid, e.g. the strain of dents that
    enter the grid during the path.
    """
    index = choice("body", body, (1, 2)) - 1
    terms = backstresses_of(engine.setup.bodies[index])
    fields = plastic_fields(engine.domain.grid, strain, equivalent, backstress, terms, first)
    if not anywhere:
        _require_over_grid(engine.domain.grid, fields[0], first or 0)
    with engine.access:
        engine.core.set_plastic_state(index, first or 0, *fields)
    engine.history.forget()
    engine.history.has_given_strain = not anywhere


def prepare(simulation: Any, preparation: Preparation | None) -> None:
    """Apply a preparation, e.g. dents, to a new simulation, and store it for repetitions."""
    if preparation is not None:
        simulation.engine.preparation = preparation
        preparation(simulation)


def add_eigenstrain(
    engine: Engine, body: int, strain: ArrayLike, first: Cells, cells: Cells | None
) -> None:
    """Add an eigenstrain to a body, see `Simulation.add_eigenstrain`."""
    index = choice("body", body, (1, 2)) - 1
    place, field = eigenstrain_field(engine.domain.grid, strain, first, cells)
    with engine.access:
        engine.core.add_eigenstrain(index, place, field)
    engine.history.forget()


def plastic_fields(
    grid: Grid,
    strain: ArrayLike,
    equivalent: ArrayLike | None,
    backstress: ArrayLike | None,
    terms: int,
    first: int | None,
) -> tuple[FloatArray, FloatArray | None, FloatArray | None]:
    """Check a plastic state; return its fields, with axis z before x and y.

    terms: number of backstresses.
    """
    given = real_array("strain", strain).shape
    fits = len(given) == 4 and min(given) > 0
    rows = grid.nx
    if first is not None:
        integer("first", first)
        rows = given[1] if fits else rows
    shape = (rows, grid.ny, given[3] if fits else grid.nz)
    checked = finite_array("strain", strain, (6, *shape))
    history = centre = None
    if equivalent is not None:
        history = np.ascontiguousarray(
            np.moveaxis(finite_array("equivalent", equivalent, shape), 2, 0)
        )
    if backstress is not None:
        deviators = finite_array("backstress", backstress, (terms, 6, *shape))
        centre = np.ascontiguousarray(np.moveaxis(deviators, 4, 2))
    return np.ascontiguousarray(np.moveaxis(checked, 3, 1)), history, centre


def _require_over_grid(grid: Grid, strain: FloatArray, first: int) -> None:
    """Raise ValueError for a plastic strain (6, layers, nx, ny) entirely outside the grid."""
    rows = np.flatnonzero(strain.any(axis=(0, 1, 3))) + first
    if rows.size and not ((rows >= 0) & (rows < grid.nx)).any():
        raise ValueError(
            f"strain must overlap the grid, which has the rows 0 to {grid.nx - 1} along x; "
            f"got rows {rows[0]} to {rows[-1]} (first = {first})"
        )


def eigenstrain_field(
    grid: Grid, strain: ArrayLike, first: Cells, cells: Cells | None
) -> tuple[tuple[int, int, int], FloatArray]:
    """Check an eigenstrain, and return its first cell and its field, shape (6, nz, nx, ny)."""
    place = _three("first", first, 0)
    if not grid.has_volume:
        raise ValueError(f"grid must have dz for an eigenstrain, got {grid!r}")
    shape = real_array("strain", strain).shape
    if cells is not None or shape == (6,):
        if cells is None or shape != (6,):
            raise ValueError(
                "strain must have shape (6,) with cells = (nx, ny, nz), or shape (6, nx, ny, nz) "
                f"without cells, got shape {shape} and cells = {in_short(cells)}"
            )
        uniform = finite_array("strain", strain, (6,))
        field = np.tile(uniform[:, None, None, None], (1, *_three("cells", cells, 1)))
    else:
        if len(shape) != 4 or shape[0] != 6 or min(shape) < 1:
            raise ValueError(f"strain must have shape (6,) or (6, nx, ny, nz), got {shape}")
        field = finite_array("strain", strain, shape)
    sizes = zip("xyz", place, field.shape[1:], (*grid.surface_shape, grid.nz), strict=True)
    for axis, start, count, limit in sizes:
        if start + count > limit and not (axis == "z" and grid.nz == 0):
            raise ValueError(
                f"strain must lie in the grid, which has {limit} cells along {axis}, got cells "
                f"{start} to {start + count - 1}"
            )
    return place, np.ascontiguousarray(np.moveaxis(field, 3, 1))


def _three(name: str, numbers: Cells, minimum: int) -> tuple[int, int, int]:
    """Check that `numbers` are three integers >= `minimum`, and return them."""
    try:
        i, j, k = numbers
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} must be three integers, got {in_short(numbers)}") from error
    for number in (i, j, k):
        integer(name, number, minimum)
    return int(i), int(j), int(k)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress history of the points of a body over a cycle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._util import memory
from .._util.checks import MAX_STRESS, FloatArray, choice, real_array
from .._util.display import HtmlTable, Rows, counts, lengths
from .._util.frozen import FrozenDict, read_only
from .._util.short_text import in_short
from ..bodies.layered import Body
from ..solutions.state import State, on_common_grid
from .paths import GivenPaths, Paths, StatePaths, SteadyPaths

__all__ = ["Cycle", "cycle", "steady_cycle"]

_MAX_UNCHECKED_BYTES = 1e6  # smaller fields fit into memory; shakedown limits need thousands
_MAX_MEMORY_FRACTION = 0.4
"""Maximum fraction of the available memory that a block of points, at all instants, may use."""
_COPIES_OF_BLOCK = 2.5
"""Memory needed for a block, including copies of fields, divided by the memory of the fields."""


@dataclass(frozen=True, repr=False, eq=False)
class Cycle(HtmlTable):
    """Stress history of points of a body; from `cycle`, `steady_cycle` or `hertz_cycle`.

    The stress is computed when a criterion needs it, and cached for the next criterion if it fits
    into memory.
    """

    _paths: Paths
    _body: Body | None
    _places: Mapping[str, FloatArray]

    @property
    def moments(self) -> int:
        """Number of instants of the cycle."""
        return self._paths.moments

    @property
    def points_shape(self) -> tuple[int, ...]:
        """Shape of a scalar field over the points of the cycle."""
        return self._paths.shape

    @property
    def coordinates(self) -> Mapping[str, NDArray[np.float64]]:
        """Coordinates of the points along each axis of a field [m].

        The axes are "x" (on the body, relative to the initial contact), "y" and "z". The mapping is
        empty for a stress array.
        """
        return self._places

    @property
    def body(self) -> Body | None:
        """Body to which the points belong; None for a stress array."""
        return self._body

    def __repr__(self) -> str:
        return f"Cycle(moments={self.moments}, points_shape={self.points_shape})"

    def _rows(self) -> Rows:
        rows = [("instants", str(self.moments)), ("points", counts(*self.points_shape))]
        for axis, values in self.coordinates.items():
            rows.append((axis, f"{lengths(values[0])} to {lengths(values[-1])}"))
        return rows


def has_plastic_strain(of: Cycle) -> bool:
    """Whether any point has plastic strain at any instant of the cycle."""
    return of._paths.has_plastic_strain


def blocks(of: Cycle, fields: int) -> Iterator[slice]:
    """Yield blocks of points, as slices along the last axis of the points (normally the depth).

    Blocks are so small that `fields` tensor fields of a block, at all instants, fit into the
    available memory.
    """
    last = of.points_shape[-1]
    one = 48.0 * of.moments * math.prod(of.points_shape[:-1]) * fields
    there = memory.available() if one * last > _MAX_UNCHECKED_BYTES else None
    fit = last if there is None else int(_MAX_MEMORY_FRACTION * there / (_COPIES_OF_BLOCK * one))
    if fit < 1:
        memory.require(
            "one layer of a cycle",
            _COPIES_OF_BLOCK * one / _MAX_MEMORY_FRACTION,
            "use fewer states",
        )
    size = max(min(fit, last), 1)
    for first in range(0, last, size):
        yield slice(first, min(first + size, last))


def stress_in(of: Cycle, block: slice) -> FloatArray:
    """Return the stress in a block [Pa], shape (instants, 6, points).

    The points are ordered so that the index along the block (normally the depth) varies slowest.
    """
    known: dict[str, FloatArray] = of.__dict__.setdefault("_known", {})
    if "stress" in known:
        each = math.prod(of.points_shape[:-1])
        return known["stress"][:, :, block.start * each : block.stop * each]
    stress = of._paths.stress(block).reshape(of.moments, 6, -1)
    if block == slice(0, of.points_shape[-1]):
        known["stress"] = read_only(stress)
    return stress


def plastic_strain_in(of: Cycle, block: slice) -> FloatArray:
    """Return the plastic strain in a block [-], in the shape of `stress_in`."""
    return of._paths.plastic_strain(block).reshape(of.moments, 6, -1)


def cycle(
    states: Sequence[State] | ArrayLike,
    body: int | None = None,
    plastic_strain: ArrayLike | None = None,
) -> Cycle:
    """Stress history of the points of a body over one cycle, from states or from a stress array.

    Parameters
    ----------
    states : sequence of State, or array_like of shape (n, 6, ...)
        At least two states of one simulation, over a steady pass or loop. The cycle consists of
        these states only: the unloaded state is not added. Alternatively, a stress array [Pa] from
        any source, with the components xx, yy, zz, yz, xz, xy, positive in tension.
    body : {1, 2}, optional
        Body of the states. Default: 2.
    plastic_strain : array_like, optional
        Plastic strain [-], in the shape of the stress array. Default: 0. Not allowed with states.

    Returns
    -------
    Cycle
        If the contact moves over the body, the points are the cells of the body that lie inside the
        grids of all states.

    Raises
    ------
    ValueError
        There are fewer than two instants. The states differ in cell size or material, have no cells
        in common, or have offsets that differ by a fraction of a cell. The stress array has the
        wrong shape or is not finite.
    TypeError
        `states` is neither a sequence of states nor an array of numbers.
    """
    if isinstance(states, State):
        raise ValueError(
            "states must contain at least 2 states, got one: for steady rolling, use the result of "
            "samcontact.fatigue.steady_cycle(state)"
        )
    given = list(states) if isinstance(states, Sequence) else []
    if any(isinstance(one, State) for one in given):
        if plastic_strain is not None:
            raise ValueError(
                "plastic_strain cannot be combined with states, which contain it: omit it"
            )
        return _cycle_from_states(given, 2 if body is None else choice("body", body, (1, 2)))
    stress = _tensors("states", states, "(instants, 6, ...)", 1)
    _require_no_body(body)
    if stress.shape[0] < 2:
        raise ValueError(
            f"states must have shape (n, 6, ...) with at least 2 instants n, got {stress.shape}"
        )
    strain = _strain_like(plastic_strain, stress)
    return Cycle(GivenPaths(stress, strain), None, FrozenDict({}))


def steady_cycle(
    state: State | ArrayLike,
    body: int | None = None,
    axis: str = "x",
    plastic_strain: ArrayLike | None = None,
) -> Cycle:
    """Stress cycle of material that moves through a steady stress field along x or y.

    For steady rolling or sliding one state is enough: a material point moves along a line of the
    field and undergoes the stresses along this line one after another.

    Parameters
    ----------
    state : State, or array_like of shape (6, nx, ny, nz)
        Steady state, or its stress [Pa], e.g. from `ContactSolver.stress`.
    body : {1, 2}, optional
        Body of the state. Default: 2.
    axis : {"x", "y"}, optional
        Direction in which the material moves.
    plastic_strain : array_like, optional
        Plastic strain [-], in the shape of the stress array. Default: 0. Not allowed with a state.

    Returns
    -------
    Cycle
        Cycle in which each point stands for a line along `axis`, so that fields over the points
        have the axes y and z (x and z with `axis="y"`). The instants of the cycle are the cells
        along a line; nothing is interpolated between cells. For a state, the initial stress far
        ahead of the contact adds one more instant, except along a periodic direction. A stress
        array has no additional instant.

    Raises
    ------
    ValueError, TypeError
        `state` is neither a State nor a finite array of this shape, or has fewer than 2 cells along
        `axis`.
    """
    number = ("x", "y").index(choice("axis", axis, ("x", "y")))
    if isinstance(state, State):
        if plastic_strain is not None:
            raise ValueError(
                "plastic_strain cannot be combined with a state, which contains it: omit it"
            )
        which = 2 if body is None else choice("body", body, (1, 2))
        if (cells := state.grid.surface_shape[number]) < 2:
            raise ValueError(
                f"state must have at least 2 cells along {axis}, got n{axis} = {cells}"
            )
        paths = SteadyPaths.of(state, which, number, axis not in state.grid.periodic)
        across = "yx"[number]
        places = {across: getattr(state.grid, across), "z": state.depths}
        return Cycle(paths, _body_of(state, which), FrozenDict(places))
    stress = _tensors("state", state, "(6, nx, ny, nz)", 0)
    _require_no_body(body)
    if stress.ndim != 4 or stress.shape[1 + number] < 2:
        raise ValueError(
            f"state must have shape (6, nx, ny, nz) with at least 2 cells along {axis}, "
            f"got {stress.shape}"
        )
    strain = _strain_like(plastic_strain, stress)
    lines = [np.moveaxis(a, 1 + number, 0) for a in (stress, strain) if a is not None]
    return Cycle(GivenPaths(lines[0], lines[1] if len(lines) > 1 else None), None, FrozenDict({}))


def _require_no_body(body: Any) -> None:
    if body is not None:
        raise ValueError(f"body must be omitted with a stress array, got {in_short(body)}")


def _tensors(name: str, given: Any, shape: str, axis: int) -> FloatArray:
    stress = real_array(name, given)
    if stress.ndim <= axis + 1 or stress.shape[axis] != 6 or 0 in stress.shape:
        raise ValueError(
            f"{name} must be {'a State' if name == 'state' else 'a list of State'}, or a stress "
            f"array of shape {shape}, got an array of shape {stress.shape}"
        )
    if not np.isfinite(stress).all():
        raise ValueError(f"{name} must be finite everywhere")
    if (max_stress := float(np.abs(stress).max())) > MAX_STRESS:
        raise ValueError(
            f"{name} must be at most {MAX_STRESS:g} Pa in magnitude, got {max_stress:.6g}"
        )
    return stress


def _strain_like(given: ArrayLike | None, stress: FloatArray) -> FloatArray | None:
    if given is None:
        return None
    strain = real_array("plastic_strain", given)
    if strain.shape != stress.shape:
        raise ValueError(f"plastic_strain must have shape {stress.shape}, got {strain.shape}")
    if not (np.isfinite(strain).all() and np.abs(strain).max() < 1.0):
        raise ValueError(
            "plastic_strain must be finite and below 1 in magnitude everywhere: it is "
            "dimensionless, e.g. 0.01 for 1 %"
        )
    return strain


def _body_of(state: State, body: int) -> Body:
    return state.setup.bodies[body - 1]


def _cycle_from_states(given: list[Any], body: int) -> Cycle:
    wrong = [one for one in given if not isinstance(one, State)]
    if wrong:
        raise TypeError(
            f"all states must be of type samcontact.State, got {type(wrong[0]).__name__}"
        )
    if len(given) < 2:
        raise ValueError(
            "states must contain at least 2 states, got one: for steady rolling, use the result of "
            "samcontact.fatigue.steady_cycle(state)"
        )
    sizes = {(s.grid.dx, s.grid.dy, s.grid.nz, s.grid.dz, s.grid.periodic) for s in given}
    if len(sizes) > 1:
        raise ValueError(
            "states must have equal cells, layers and periodic directions, got different grids"
        )
    if any(_body_of(s, body) != _body_of(given[0], body) for s in given):
        raise ValueError(f"states must have the same body {body}, got different ones")
    states = on_common_grid(given)
    if len({s.grid.surface_shape for s in states}) > 1:
        raise ValueError("states must be from one simulation, got grids of several simulations")
    grid = states[0].grid
    parts = [s.offset(body) for s in states]
    if max(parts) - min(parts) > 1e-6 * grid.dx:
        raise ValueError(
            f"states must have the cells of body {body} at equal positions within the cells of "
            f"the grid, got offsets of {min(parts):.6g} to {max(parts):.6g} m: move the body by "
            f"whole cells of {grid.dx!r} m"
        )
    paths = StatePaths.of(states, body)
    cells = paths.first + np.arange(paths.shape[0])
    x = read_only(np.asarray((cells - 0.5 * (grid.nx - 1)) * grid.dx, dtype=np.float64))
    deepest = max(states, key=lambda s: s.layers)
    return Cycle(
        paths, _body_of(given[0], body), FrozenDict({"x": x, "y": grid.y, "z": deepest.depths})
    )

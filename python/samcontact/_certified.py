# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of a state whose error is told: between the cells, so that they converge cleanly.

A largest value is that of parabolas through its cell and the neighbours, and an area has its edge
where the squared pressure vanishes: along grids that become finer, both jump far less than the
largest cell and the number of cells do.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ._checks import FloatArray
from ._tensors import von_mises
from .material import Material

if TYPE_CHECKING:
    from .layered import Body
    from .state import State

OF_CONTACT = ("load", "approach", "max_pressure", "contact_area")
OF_BODY = (
    "max_von_mises",
    "max_equivalent_plastic_strain",
    "max_residual_von_mises",
    "print_depth",
)
"""Of bodies, all but the first of those that yield only; followed by `_body1` or `_body2`."""
_CELLS = range(1, 5)  # from the edge, by which a pressure is continued
_RIM = 4  # cells around a field, as many
_FIELDS = {
    "max_von_mises": "stress",
    "max_equivalent_plastic_strain": "equivalent_plastic_strain",
    "max_residual_von_mises": "residual_stress",
}


def names(bodies: Sequence[Body], body: int = 2, *, volume: bool = True) -> list[str]:
    """Of all that a scene has: of each inelastic body, or else of the chosen one."""
    inelastic = [n for n, material in enumerate(bodies, 1) if material.is_plastic]
    found = list(OF_CONTACT)
    if not volume:
        return found
    if not inelastic and bodies[body - 1].law != "rigid":
        return [*found, f"{OF_BODY[0]}_body{body}"]
    return [*found, *(f"{name}_body{n}" for n in inelastic for name in OF_BODY)]


def value(state: State, name: str) -> float:
    """One quantity of a state, by its name in files [SI units]."""
    return max(parts(state, name))


def parts(state: State, name: str) -> tuple[float, ...]:
    """The same as the values whose largest it is, each of which converges by itself.

    Of a field of the volume the largest below the surface and that of the surface: which of them is
    larger may depend on the grid.
    """
    if name in ("load", "approach"):
        return (float(getattr(state, name)),)
    if name == "max_pressure":
        return (peak_value(state.pressure),)
    if name == "contact_area":
        return (area_under(state.pressure, state.grid.cell_area, state.grid.periodic),)
    kind, body = name[: -len("_body1")], int(name[-1])
    if kind == "print_depth":
        own = state._in_own_box("residual_displacement", body)
        return (peak_value(state.residual_displacement(body) if own is None else own),)
    zones = state.zones(body)
    if not zones and kind != "max_von_mises":
        return 0.0, 0.0
    field = _FIELDS[kind]
    if len(zones) > 1:
        fields = [getattr(zone, field)() for zone in zones]
    else:
        own = None if field == "equivalent_plastic_strain" else state._in_own_box(field, body)
        fields = [getattr(state, field)(body) if own is None else own]
    found = [below_and_at_surface(f if f.ndim == 3 else von_mises(f)) for f in fields]
    below, surface = (max(values) for values in zip(*found, strict=True))
    most = _largest_yield_stress(state, body) if kind == "max_von_mises" else math.inf
    return min(below, most), min(surface, most)


def _largest_yield_stress(state: State, body: int) -> float:
    """Which no stress of the body exceeds, whatever a parabola does; inf where it is not known."""
    material = (state._simulation.body1, state._simulation.body2)[body - 1]
    if not isinstance(material, Material) or state.max_plastic_strain(body) == 0:
        return math.inf
    if any((material.kinematic, material.softening, material.yield_profile)):
        return math.inf
    strain = value(state, f"max_equivalent_plastic_strain_body{body}")
    return float(material.yield_stress(max(strain, state.max_equivalent_plastic_strain(body))))


def has_parts(name: str) -> int:
    """How many parts a quantity has."""
    return 2 if name[: -len("_body1")] in _FIELDS else 1


def values(state: State, wanted: Sequence[str]) -> dict[str, float]:
    """Several quantities of a state, by their names in files [SI units]."""
    return {name: value(state, name) for name in wanted}


def peak_value(field: ArrayLike) -> float:
    """Largest value of a field between its cells.

    Parameters
    ----------
    field : array_like
        At the centres of cells.

    Returns
    -------
    float
        The largest cell, and along each axis what a parabola through it and its neighbours rises
        above it.
    """
    values = np.asarray(field, dtype=np.float64)
    if values.size == 0:
        return 0.0
    return _risen(values, np.unravel_index(int(values.argmax()), values.shape))


def _risen(values: FloatArray, at: tuple[np.intp, ...]) -> float:
    """A cell, and what parabolas through it and its neighbours rise above it."""
    risen = float(values[at])
    for axis in range(values.ndim):
        line = np.moveaxis(values, axis, -1)[tuple(np.delete(at, axis))]
        k = int(at[axis])
        if 0 < k < line.size - 1:
            slope, bend = 0.5 * (line[k + 1] - line[k - 1]), line[k + 1] - 2 * line[k] + line[k - 1]
            if bend < 0 and abs(slope) <= -bend:
                risen -= float(0.5 * slope**2 / bend)
    return risen


def below_and_at_surface(field: FloatArray) -> tuple[float, float]:
    """Largest of what rises and falls with the depth, and of a parabola at depth 0.

    The parabola goes through the first three layers where the values grow towards the surface;
    where the third has none it is a line.
    """
    layers = field.shape[2]
    if layers < 3:
        return (0.0, float(field.max())) if field.size else (0.0, 0.0)
    inner = field[:, :, 1:-1]
    turns = np.where((inner >= field[:, :, :-2]) & (inner >= field[:, :, 2:]), inner, -np.inf)
    at = np.unravel_index(int(turns.argmax()), turns.shape)
    below = _risen(field, (at[0], at[1], at[2] + 1)) if np.isfinite(turns[at]) else 0.0
    first, second, third = (field[:, :, k] for k in range(3))
    surface = 1.875 * first - 1.25 * second + 0.375 * third
    surface = np.where(third > 0, surface, 1.5 * first - 0.5 * second)
    return below, peak_value(np.where(first >= second, surface, 0.0))


def area_under(pressure: ArrayLike, cell_area: float, periodic: str = "") -> float:
    """Area of a contact whose edge lies between the cells [m^2].

    Near the edge of a smooth contact the squared pressure falls linearly to zero. A parabola
    through the second to fourth cell from the edge (the first depends on where in it the edge lies)
    continues it over the first cells without pressure, at most to zero in their centres. The area
    inside of its zero line is that of the triangles between the centres of cells.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        [Pa], >= 0.
    cell_area : float
        [m^2].
    periodic : {"", "x", "y", "xy"}, optional
        As of a Grid.
    """
    field = np.asarray(pressure, dtype=np.float64)
    largest = float(field.max())
    if not largest > 0:
        return 0.0
    for axis, name in enumerate("xy"):
        width = [(_RIM, _RIM) if n == axis else (0, 0) for n in (0, 1)]
        field = np.pad(field, width, mode="wrap" if name in periodic else "constant")
    level = _continued((field / largest) ** 2)
    rows, columns = (slice(_RIM if name in periodic else _RIM - 1, 1 - _RIM) for name in "xy")
    return float(_area_above_zero(level[rows, columns]) * cell_area)


def _continued(squared: FloatArray) -> FloatArray:
    """Squared pressures, with those below zero that continue them over the cells beside."""
    inside = squared > 0
    level = np.where(inside, squared, np.nan)
    total, weights = np.zeros_like(level), np.zeros_like(level)
    for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)):
        first, second, third, fourth = (np.roll(level, (n * i, n * j), (0, 1)) for n in _CELLS)
        continued = 6.0 * second - 8.0 * third + 3.0 * fourth
        # a narrow spot: by a line; one of a single cell ends half-way to its neighbours
        line = 2.0 * first - np.where(np.isnan(second), 3.0 * first, second)
        continued = np.where(np.isnan(continued), line, continued)
        known = np.isfinite(continued)
        weight = 0.5 if i and j else 1.0
        total[known] += weight * continued[known]
        weights[known] += weight
    rim = ~inside & (weights > 0)
    level[rim] = np.minimum(total[rim] / weights[rim], 0.0)
    return np.nan_to_num(level, nan=-1.0)


def _area_above_zero(level: FloatArray) -> float:
    """In squares between the points of a lattice, each cut into four triangles at its middle."""
    corners = (level[:-1, :-1], level[1:, :-1], level[1:, 1:], level[:-1, 1:])
    middle = 0.25 * sum(corners)
    area = 0.0
    for first, second in zip(corners, (*corners[1:], corners[0]), strict=True):
        low, mid, high = np.sort(np.stack([first, second, middle]), axis=0)
        with np.errstate(divide="ignore", invalid="ignore"):
            tip = high**2 / ((high - low) * (high - mid))
            blunt = 1.0 - low**2 / ((mid - low) * (high - low))
        share = np.select([low >= 0, mid >= 0, high > 0], [np.ones_like(low), blunt, tip], 0.0)
        area += 0.25 * float(np.sum(share))
    return area

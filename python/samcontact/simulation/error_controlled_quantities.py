# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of a state for which errors can be estimated; maxima are interpolated between cells.

Maxima are interpolated by parabolas through the cell of the maximum and its neighbours. Under grid
refinement, interpolated maxima change more smoothly than maxima over cells. Likewise,
`contact_area` changes more smoothly than a count of cells.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from .._util import memory
from .._util.checks import FloatArray, axis_number
from .._util.tensors import von_mises
from ..bodies.layered import Body, materials_of, matrix_of
from ..bodies.material import Material
from ..bodies.viscoelastic import relaxes

if TYPE_CHECKING:
    from ..problem.grid import Grid
    from ..solutions.state import State

CONTACT_QUANTITIES = ("load", "approach", "max_pressure", "contact_area")
BODY_QUANTITIES = (
    "max_von_mises",
    "max_equivalent_plastic_strain",
    "max_residual_von_mises",
    "imprint_depth",
)
"""Quantities of a body, whose names are followed by `_body1` or `_body2`; all but the first require
an elastic-plastic body."""
OF_RELAXING = ("imprint_depth", "viscous_work")
"""Quantities of a viscoelastic body."""
_FIELDS = {
    "max_von_mises": "stress",
    "max_equivalent_plastic_strain": "equivalent_plastic_strain",
    "max_residual_von_mises": "residual_stress",
}


def names(bodies: Sequence[Body], body: int = 2, *, volume: bool = True) -> list[str]:
    """Return the names of all quantities with error control: of the contact and of its bodies.

    If no body is elastic-plastic, the von Mises stress is included for one body only: `body`.
    """
    inelastic = [n for n, material in enumerate(bodies, 1) if material.is_plastic]
    relaxing = [n for n, material in enumerate(bodies, 1) if relaxes(material)]
    found = [*CONTACT_QUANTITIES, *(f"{name}_body{n}" for n in relaxing for name in OF_RELAXING)]
    if not volume:
        return found
    if not inelastic and bodies[body - 1].law != "rigid":
        return [*found, f"{BODY_QUANTITIES[0]}_body{body}"]
    return [*found, *(f"{name}_body{n}" for n in inelastic for name in BODY_QUANTITIES)]


def value(state: State, name: str) -> float:
    """Return the value [SI units] of a quantity of a state, given its name in results files."""
    return max(parts(state, name))


def parts(state: State, name: str) -> tuple[float, ...]:
    """Return one value or several values, the maximum of which is the quantity.

    For a volume field, these are the maximum below the surface and the maximum at the surface; for
    each layer, the maximum inside the layer and the maxima at both faces. Each value is compared
    separately between grids, because another one may be the largest on another grid.
    """
    if name in ("load", "approach"):
        return (float(getattr(state, name)),)
    if name == "max_pressure":
        return (peak_value(state.pressure),)
    if name == "contact_area":
        return (state.contact_area,)
    kind, body = name[: -len("_body1")], int(name[-1])
    if kind == "viscous_work":
        return (state.viscous_work(body),)
    if kind == "imprint_depth":
        own = in_own_box(state, "residual_displacement", body)
        return (peak_value(state.residual_displacement(body) if own is None else own),)
    ranges = _ranges(_bodies(state)[body - 1], state.grid)
    largest = np.zeros(_count(len(ranges)))
    for field in _fields(state, kind, body):
        of_materials = [
            _parts_of_material(field[:, :, own], is_layer=own is not ranges[-1]) for own in ranges
        ]
        largest = np.maximum(largest, np.concatenate(of_materials))
    if kind == "max_von_mises":
        largest = np.minimum(largest, _bounds(state, body, ranges))
    return tuple(float(part) for part in largest)


def _bodies(state: State) -> tuple[Body, Body]:
    return state.setup.bodies


def in_own_box(state: State, name: str, body: int) -> FloatArray | None:
    """Return a field in the box of plastic cells of a body, as the solver computes it.

    `name` is "stress" or "residual_stress" (the deviator is returned), or "residual_displacement".
    The result is None without plastic strain, if the plastic cells lie in several boxes, or after
    the body has moved.
    """
    index, core = body - 1, state._core
    box = core.own_box(index)
    if box is None:
        return None
    needed = memory.ZONE_FIELD_BYTES * math.prod(box[2:])
    memory.require(f"the field {name} in the plastic zone", needed)
    if name == "residual_displacement":
        field: FloatArray = core.residual_displacement_in(index, box, axis_number("z"))
    else:
        field = core.deviator_in_own_box(index, name == "stress")
    return field


def _fields(state: State, kind: str, body: int) -> list[FloatArray]:
    """Return the scalar fields of a body, over all of which the quantity is the maximum."""
    zones = state.zones(body)
    if not zones and kind != "max_von_mises":
        return []
    name = _FIELDS[kind]
    if len(zones) > 1:
        found = [getattr(zone, name)() for zone in zones]
    else:
        own = None if name == "equivalent_plastic_strain" else in_own_box(state, name, body)
        found = [getattr(state, name)(body) if own is None else own]
    return [field if field.ndim == 3 else von_mises(field) for field in found]


def _ranges(body: Body, grid: Grid) -> list[slice]:
    """Return the range of cell layers of each material; fields may jump between these ranges."""
    body = matrix_of(body)
    if isinstance(body, Material) or grid.dz is None:
        return [slice(None)]
    cuts = np.rint(body.interfaces / grid.dz).astype(int).tolist()
    return [slice(*ends) for ends in zip([0, *cuts], [*cuts, None], strict=True)]


def _parts_of_material(cells: FloatArray, *, is_layer: bool) -> list[float]:
    """Return the maxima of a field inside a material, at its top and, for layers, at its bottom."""
    found = list(below_and_at_surface(cells))
    return [*found, below_and_at_surface(cells[:, :, ::-1])[1]] if is_layer else found


def _count(materials: int) -> int:
    """Return the number of values that `parts` returns for a body with this many materials."""
    return 3 * materials - 1


def _bounds(state: State, body: int, ranges: Sequence[slice]) -> FloatArray:
    """Return upper bounds of the interpolated stress maxima: the yield stresses of materials [Pa].

    A bound is infinite if the yield stress is not known.
    """
    bounds = np.full(_count(len(ranges)), np.inf)
    if state.max_plastic_strain_magnitude(body) == 0:
        return bounds
    fields = _fields(state, "max_equivalent_plastic_strain", body)
    materials = materials_of(_bodies(state)[body - 1])
    for n, (material, own) in enumerate(zip(materials, ranges, strict=True)):
        if any((material.kinematic, material.softening, material.yield_profile)):
            continue
        strains = [field[:, :, own] for field in fields]
        parts = [_parts_of_material(strain, is_layer=True) for strain in strains]
        max_strain = max(strain.max(initial=0.0) for strain in strains)
        bounds[3 * n : 3 * n + 3] = material.yield_stress(max(max_strain, np.max(parts)))
    return bounds


def count_parts(name: str, bodies: Sequence[Body]) -> int:
    """Return how many values, at least one, `parts` returns for a quantity."""
    if name[: -len("_body1")] not in _FIELDS:
        return 1
    return _count(len(materials_of(bodies[int(name[-1]) - 1])))


def values(state: State, quantities: Sequence[str]) -> dict[str, float]:
    """Return the values [SI units] of quantities of a state, by their names in results files."""
    return {name: value(state, name) for name in quantities}


def peak_value(field: ArrayLike) -> float:
    """Return the maximum of a field, interpolated between its cells.

    Parameters
    ----------
    field : array_like
        Values at the cell centres.

    Returns
    -------
    float
        Maximum over the cells plus, for each axis, the excess of a parabola. The parabola passes
        through the cell of the maximum and its two neighbours; the excess is the parabola's maximum
        minus the value in this cell.
    """
    values = np.asarray(field, dtype=np.float64)
    if values.size == 0:
        return 0.0
    return _risen(values, np.unravel_index(int(values.argmax()), values.shape))


def _risen(values: FloatArray, at: tuple[np.intp, ...]) -> float:
    """Return a cell value plus the excess of a parabola along each axis, see `peak_value`."""
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
    """Return the largest local maximum below the surface, and the maximum value at the surface.

    A local maximum is a value that is not exceeded in the layers above and below. In columns with
    values that increase towards the surface, the value at the surface is extrapolated by a parabola
    through the first three layers, or by a line through the first two layers if the value in the
    third layer is zero.
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

# SPDX-License-Identifier: GPL-3.0-or-later
"""Volume fields of a body with plastic strain in several zones: of the cells with strain only.

Gathered in one dimension as the CF conventions have it (section 8.2, "Lossless Compression by
Gathering"): the coordinate of that dimension holds the numbers of the cells in the grid.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from .._util.checks import FloatArray
from .._util.tensors import von_mises
from ..solutions.strained_cells import strained_cells
from .motion import add

if TYPE_CHECKING:
    from ..solutions.state import State
    from ..solutions.zone import Zone

_AXES = ("x", "y", "z")
# name: whether it has components
_FIELDS = {
    "stress": True,
    "von_mises": False,
    "hydrostatic": False,
    "equivalent_plastic_strain": False,
    "plastic_strain": True,
    "residual_stress": True,
}


def is_gathered(states: Sequence[State], body: int) -> bool:
    """Whether the fields of a body are kept so."""
    return any(len(state.zones(body)) > 1 for state in states)


def max_von_mises(state: State, body: int) -> float:
    """Largest von Mises stress [Pa]: where the strain lies in several zones, that in them."""
    zones = state.zones(body)
    if len(zones) < 2:
        return float(state.von_mises(body=body).max())
    return max(float(von_mises(zone.stress()).max()) for zone in zones)


def add_gathered(dataset: xr.Dataset, states: Sequence[State], body: int) -> None:
    """Add the fields of the increments that have volume fields."""
    parts = [_of_state(state, body) for state in states]
    cells = np.unique(np.concatenate([numbers for numbers, _ in parts]))
    dim = f"cell_body{body}"
    add(dataset, "cell", dim, cells, body)
    dataset.coords[dim] = dataset[dim].assign_attrs(compress=" ".join(_AXES))
    for name, has_components in _FIELDS.items():
        shape = (6, cells.size) if has_components else (cells.size,)
        data = np.full((len(states), *shape), _beside(name))
        for values, (numbers, fields) in zip(data, parts, strict=True):
            values[..., np.searchsorted(cells, numbers)] = fields.pop(name)
        dims = ("volume_increment", *(["component"] if has_components else []), dim)
        add(dataset, name, dims, data, body)


def on_grid(field: xr.DataArray, dataset: xr.Dataset) -> xr.DataArray:
    """A field, or a part of it, over x, y and z, where results have its cells only.

    Parameters
    ----------
    field : xarray.DataArray
        Of the dataset, e.g. ``dataset["residual_stress_body2"].sel(component="xx")``. Selecting
        components and increments before takes less memory. One that has x, y and z is returned as
        it is.
    dataset : xarray.Dataset
        From `samcontact.results.to_dataset` or `open_results`.

    Returns
    -------
    xarray.DataArray
        Dimensions x, y and z last. Where there is no plastic strain, strains are 0 and stresses,
        which are not stored there, NaN.
    """
    gathered = [str(dim) for dim in field.dims if "compress" in dataset[dim].attrs]
    if not gathered:
        return field
    (dim,) = gathered
    shape = tuple(dataset.sizes[axis] for axis in _AXES)
    others = [other for other in field.dims if other != dim]
    rows = field.transpose(*others, dim).values
    whole = np.full((*rows.shape[:-1], int(np.prod(shape))), _beside(str(field.name)))
    whole[..., dataset[dim].values] = rows
    kept = {name: c for name, c in field.coords.items() if dim not in c.dims}
    coordinates = kept | {axis: dataset[axis] for axis in _AXES}
    values = whole.reshape(*rows.shape[:-1], *shape)
    return xr.DataArray(values, coordinates, [*others, *_AXES], field.name, field.attrs)


def cells_of(field: xr.DataArray, dataset: xr.Dataset) -> NDArray[np.int64] | None:
    """Rows i, j, k of its cells, shape (3, cells); None where it is that of all of the grid."""
    for dim in field.dims:
        if "compress" in dataset[dim].attrs:
            shape = tuple(dataset.sizes[axis] for axis in _AXES)
            return np.array(np.unravel_index(dataset[dim].values, shape))
    return None


def _beside(name: str) -> float:
    """Of cells without plastic strain; stress there is not known."""
    return 0.0 if "strain" in name else np.nan


def _of_state(state: State, body: int) -> tuple[NDArray[np.int64], dict[str, FloatArray]]:
    """Numbers of the cells with strain, and fields of them, [component][cell]."""
    shape = (*state.grid.surface_shape, len(state.depths))
    numbers = []
    parts: dict[str, list[FloatArray]] = {name: [] for name in _FIELDS}
    for zone in state.zones(body):
        inside, there = strained_cells(zone, shape)
        numbers.append(np.ravel_multi_index(there, shape))
        for name, values in _of_zone(zone, inside).items():
            parts[name].append(values)
    if not numbers:
        none = {name: np.zeros((6, 0) if tensor else 0) for name, tensor in _FIELDS.items()}
        return np.zeros(0, np.int64), none
    return np.concatenate(numbers), {n: np.concatenate(p, axis=-1) for n, p in parts.items()}


def _of_zone(zone: Zone, inside: tuple[NDArray[np.intp], ...]) -> dict[str, FloatArray]:
    i, j, k = inside
    stress = zone.stress()[:, i, j, k]
    return {
        "stress": stress,
        "von_mises": von_mises(stress),
        "hydrostatic": stress[:3].mean(axis=0),
        "equivalent_plastic_strain": zone.equivalent_plastic_strain()[i, j, k],
        "plastic_strain": zone.plastic_strain()[:, i, j, k],
        "residual_stress": zone.residual_stress()[:, i, j, k],
    }

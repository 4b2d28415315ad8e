# SPDX-License-Identifier: GPL-3.0-or-later
"""Volume fields of a body with several plastic subdomains, stored in cells with plastic strain.

These fields are "gathered" in the sense of the CF conventions (section 8.2, "Lossless Compression
by Gathering"): a single dimension replaces x, y and z. Its coordinate contains the index of each
stored cell in the flattened grid.
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
    """Whether the volume fields of a body are stored only for cells with plastic strain."""
    return any(len(state.zones(body)) > 1 for state in states)


def max_von_mises(state: State, body: int) -> float:
    """Return the maximum von Mises stress in a body [Pa].

    If the body has several plastic subdomains, only the stress inside them is considered.
    """
    zones = state.zones(body)
    if len(zones) < 2:
        return float(state.von_mises(body=body).max())
    return max(float(von_mises(zone.stress()).max()) for zone in zones)


def add_gathered(dataset: xr.Dataset, states: Sequence[State], body: int) -> None:
    """Add the gathered volume fields of a body, for all states with volume fields."""
    parts = [_state_fields(state, body) for state in states]
    cells = np.unique(np.concatenate([numbers for numbers, _ in parts]))
    dim = f"cell_body{body}"
    add(dataset, "cell", dim, cells, body)
    dataset.coords[dim] = dataset[dim].assign_attrs(compress=" ".join(_AXES))
    for name, has_components in _FIELDS.items():
        shape = (6, cells.size) if has_components else (cells.size,)
        data = np.full((len(states), *shape), _value_outside(name))
        for values, (numbers, fields) in zip(data, parts, strict=True):
            values[..., np.searchsorted(cells, numbers)] = fields.pop(name)
        dims = ("output_increment", *(["component"] if has_components else []), dim)
        add(dataset, name, dims, data, body)


def on_grid(field: xr.DataArray, dataset: xr.Dataset) -> xr.DataArray:
    """Return a volume field on the full grid, even if it is stored for some cells only.

    Fields of bodies with several plastic subdomains are stored for cells with plastic strain only.

    Parameters
    ----------
    field : xarray.DataArray
        Field of the dataset or part of it, e.g.
        ``dataset["residual_stress_body2"].sel(component="xx")``. Selecting components and
        increments first saves memory. A field with x, y and z is returned unchanged.
    dataset : xarray.Dataset
        Result of `samcontact.results.to_dataset` or `open_results`.

    Returns
    -------
    xarray.DataArray
        Field with x, y and z as last dimensions. In cells without plastic strain, strains are 0 and
        stresses, which are not stored, are NaN.
    """
    gathered = [str(dim) for dim in field.dims if "compress" in dataset[dim].attrs]
    if not gathered:
        return field
    (dim,) = gathered
    shape = tuple(dataset.sizes[axis] for axis in _AXES)
    others = [other for other in field.dims if other != dim]
    rows = field.transpose(*others, dim).values
    whole = np.full((*rows.shape[:-1], int(np.prod(shape))), _value_outside(str(field.name)))
    whole[..., dataset[dim].values] = rows
    kept = {name: c for name, c in field.coords.items() if dim not in c.dims}
    coordinates = kept | {axis: dataset[axis] for axis in _AXES}
    values = whole.reshape(*rows.shape[:-1], *shape)
    return xr.DataArray(values, coordinates, [*others, *_AXES], field.name, field.attrs)


def cells_of(field: xr.DataArray, dataset: xr.Dataset) -> NDArray[np.int64] | None:
    """Return the indices i, j, k of the cells for which a field is stored, shape (3, cells).

    Return None if the field is stored for all cells.
    """
    for dim in field.dims:
        if "compress" in dataset[dim].attrs:
            shape = tuple(dataset.sizes[axis] for axis in _AXES)
            return np.array(np.unravel_index(dataset[dim].values, shape))
    return None


def _value_outside(name: str) -> float:
    """Return the value of a gathered field in other cells: 0 for strains, NaN for stresses."""
    return 0.0 if "strain" in name else np.nan


def _state_fields(state: State, body: int) -> tuple[NDArray[np.int64], dict[str, FloatArray]]:
    """Return flat indices of the cells with plastic strain, and the fields in them by name."""
    shape = (*state.grid.surface_shape, len(state.depths))
    numbers = []
    parts: dict[str, list[FloatArray]] = {name: [] for name in _FIELDS}
    for zone in state.zones(body):
        inside, there = strained_cells(zone, shape)
        numbers.append(np.ravel_multi_index(there, shape))
        for name, values in _zone_fields(zone, inside).items():
            parts[name].append(values)
    if not numbers:
        none = {name: np.zeros((6, 0) if tensor else 0) for name, tensor in _FIELDS.items()}
        return np.zeros(0, np.int64), none
    return np.concatenate(numbers), {n: np.concatenate(p, axis=-1) for n, p in parts.items()}


def _zone_fields(zone: Zone, inside: tuple[NDArray[np.intp], ...]) -> dict[str, FloatArray]:
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

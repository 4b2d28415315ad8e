# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables of the results dataset for bodies with inclusions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.inclusion import Inclusion
from .motion import add

if TYPE_CHECKING:
    import xarray as xr

    from ..simulation.simulation import Simulation
    from ..solutions.state import State

_VOLUME = ("output_increment", "x", "y", "z")
_TENSOR = ("output_increment", "component", "x", "y", "z")
MAX_INTERFACES = 50
"""Maximum number of inclusions of a body for which the stress at their interfaces is computed."""


def add_inclusions(dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]) -> None:
    """Add the geometry of the inclusions, and the maximum stresses in each increment.

    The stresses are those of the matrix and, for up to `MAX_INTERFACES` inclusions, those at the
    interfaces of the inclusions.
    """
    for number, body in enumerate((simulation.body1, simulation.body2), 1):
        if not isinstance(body, Heterogeneous):
            continue
        _add_geometry(dataset, number, body)
        values = [_of_matrix(state, number) for state in states]
        add(dataset, "max_von_mises_matrix", "increment", [v for v, _ in values], number)
        if body.is_plastic:
            strain = [g for _, g in values]
            add(dataset, "max_equivalent_plastic_strain_matrix", "increment", strain, number)
        if not 0 < len(body.inclusions) <= MAX_INTERFACES:
            continue
        found = [_of_interfaces(state, number) for state in states]
        for column, name in enumerate(("max_interface_tension", "max_interface_von_mises")):
            add(dataset, name, "increment", [row[column] for row in found], number)


def add_inclusion_fields(dataset: xr.Dataset, stored: Sequence[State], body: int) -> None:
    """Add volume fields of a body with inclusions: share, phase and eigenstrain of each cell.

    The share is the fraction of the cell that inclusions fill. The phase is the index of the
    inclusion that fills most of the cell (-1 for the matrix).
    """
    if not isinstance(stored[0].setup.bodies[body - 1], Heterogeneous):
        return
    for name, dims in (("share", _VOLUME), ("phase", _VOLUME), ("eigenstrain", _TENSOR)):
        add(dataset, name, dims, np.stack([getattr(s, name)(body=body) for s in stored]), body)


def _add_geometry(dataset: xr.Dataset, number: int, body: Heterogeneous) -> None:
    if not body.inclusions:
        return
    dim = f"inclusion_body{number}"
    columns: dict[str, tuple[tuple[str, ...], Any]] = {
        "inclusion_center": ((dim, "direction"), [one.center for one in body.inclusions]),
        "inclusion_radii": ((dim, "radius_number"), [one.radii for one in body.inclusions]),
        "inclusion_axes": (
            (dim, "radius_number", "direction"), [one.axes for one in body.inclusions]
        ),
        "inclusion_E": ((dim,), [_modulus(one) for one in body.inclusions]),
    }  # fmt: skip
    for name, (dims, values) in columns.items():
        add(dataset, name, dims, np.array(values), number)


def _modulus(inclusion: Inclusion) -> float:
    return 0.0 if inclusion.material is None else inclusion.material.E


def _of_matrix(state: State, body: int) -> tuple[float, float]:
    """Return maximum von Mises stress [Pa] and plastic strain [-] in cells without inclusions."""
    matrix = np.asarray(state.share(body)) == 0.0
    if not matrix.any():
        return np.nan, np.nan
    strain = state.equivalent_plastic_strain(body)
    return _maximum(state.von_mises(body), matrix), _maximum(strain, matrix)


def _maximum(field: FloatArray, where: Any) -> float:
    return float(np.max(field, where=where, initial=0.0))


def _of_interfaces(state: State, body: int) -> tuple[float, float]:
    """Return maximum tension and von Mises stress at the interfaces of the inclusions [Pa].

    Inclusions outside the grid are ignored. Both values are NaN if there is no inclusion in the
    grid, or if the fields of the body do not coincide with grid cells (`State.offset` is not 0).
    """
    if state.offset(body):
        return np.nan, np.nan
    from ..inclusions.interface import interfaces  # needed by few results

    found = interfaces(state, body)
    if not found:
        return np.nan, np.nan
    return max(one.max_tension for one in found), max(one.max_von_mises for one in found)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of the cells of heterogeneous bodies for the compiled core."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._util.checks import BoolArray
from ..bodies.heterogeneous import Heterogeneous, material_around
from ..bodies.inclusion_cells import InclusionCells
from ..bodies.layered import Body, backstresses_of, materials_of
from ..bodies.material import Material
from .grid import Grid
from .two_phase_cells import set_two_phases


def mixed_cells(number: int, body: Body, grid: Grid) -> Any:
    """Return the cells that differ from the matrix of a body, and the materials of its inclusions.

    The result is None for a body without such cells; otherwise it is a tuple of four items:

    1. first cell of a box that contains all differing cells;
    2. for each cell [k][i][j] of the box, its row in item 3, or -1 for a cell of the matrix;
    3. a row of constants for each differing cell: bulk and shear modulus, volume fraction of the
       inclusion, misfit strain, index of the material in item 4, normal of the interface between
       two phases, thermal expansion;
    4. the materials of the inclusions, as objects of the compiled core.

    Raises ValueError for unsupported materials.
    """
    if not isinstance(body, Heterogeneous):
        return None
    _require_supported(number, body)
    cells = body.cells_on(grid)
    differs = _differs(cells, body)
    if not differs.any():
        return None
    materials = [material for material in cells.laws if material is not None]
    of_law = np.array([-1 if m is None else materials.index(m) for m in cells.laws])
    places = np.argwhere(differs)
    used = tuple(
        slice(int(low), int(high) + 1)
        for low, high in zip(places.min(axis=0), places.max(axis=0), strict=True)
    )
    first = tuple(f + s.start for f, s in zip(cells.first, used, strict=True))
    in_core = np.ascontiguousarray(differs[used].transpose(2, 0, 1))
    index = np.full(in_core.shape, -1, dtype=np.int32)
    index[in_core] = np.arange(np.count_nonzero(in_core), dtype=np.int32)
    fields = [cells.bulk, cells.shear, cells.share, *cells.misfit, of_law[cells.law]]
    fields += [*np.zeros((3, *differs.shape)), cells.expansion]
    fields = [np.array(field, dtype=float) for field in fields]
    set_two_phases(body, cells, grid, fields)
    rows = np.stack([field[used].transpose(2, 0, 1)[in_core] for field in fields], axis=1)
    cores = [material._core for material in materials]
    return first, index, np.ascontiguousarray(rows, dtype=float), cores


def _differs(cells: InclusionCells, body: Heterogeneous) -> BoolArray:
    """Return for each cell whether its moduli, misfit or yield law differ from the matrix."""
    own_law = np.array([
        material is None or not _flows_like(material, material_around(body, number))
        for number, material in enumerate(body.phases)
    ])  # fmt: skip
    filled = cells.share > 0.0
    return np.asarray(filled & (cells.is_deformed | own_law[cells.phase]))


def _flows_like(material: Material, matrix: Material) -> bool:
    """Whether both materials have the same yield law with the same parameters."""
    return (material.law, dict(material.parameters)) == (matrix.law, dict(matrix.parameters))


def _require_supported(number: int, body: Heterogeneous) -> None:
    """Raise ValueError for properties of matrix or inclusions that are not supported."""
    materials = materials_of(body)
    if any(material.relaxation_terms is not None for material in materials):
        raise ValueError(
            f"body{number}.matrix must not be viscoelastic, got {body.matrix!r}: inclusions in "
            "viscoelastic bodies are not supported"
        )
    yields = any(m is not None and m.is_plastic for m in body.phases)
    if backstresses_of(body) and yields:
        raise ValueError(
            f"body{number}.matrix must not have kinematic hardening if an inclusion can yield, got "
            f"{body.matrix!r}: use elastic inclusions, or a matrix without kinematic hardening"
        )
    for n, material in enumerate(body.phases):
        if material is None:
            continue
        if material.kinematic:
            raise ValueError(
                f"the material of body{number}.phases[{n}] must not have kinematic hardening, "
                f"which is supported for the matrix only, got {material!r}"
            )

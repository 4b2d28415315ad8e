# SPDX-License-Identifier: GPL-3.0-or-later
"""Partly filled cells in which matrix and inclusion flow plastically, each by its own law."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .._util.checks import BoolArray, FloatArray
from ..bodies.heterogeneous import Heterogeneous, material_around
from ..bodies.inclusion import Inclusion
from ..bodies.inclusion_cells import InclusionCells
from ..bodies.layered import backstresses_of
from ..bodies.phase_mixing import relative_phase
from .grid import Grid

_MAX_MODULUS_RATIO = 20.0
"""Maximum ratio of the larger to the smaller modulus of inclusion and matrix for laminates.

At larger ratios, cells with mean moduli of both phases are more accurate.
"""
FILLED_SHARE, MISFIT, NORMAL, EXPANSION = 2, slice(3, 9), slice(10, 13), 13
"""Positions of these quantities in the constants of a cell, as described in `mixed_cells`."""


def set_two_phases(
    body: Heterogeneous, cells: InclusionCells, grid: Grid, fields: Sequence[FloatArray]
) -> None:
    """Change `fields` in the cells that are computed as laminates of two phases.

    fields: bulk and shear modulus, volume fraction of the inclusion, six misfit strains, index of
    the material, three components of the normal, and thermal expansion of each cell. Partly filled
    cells are computed as laminates, unless nothing yields, the matrix has backstresses, or the
    moduli differ by a large factor, as in a void. In a laminate, the fields are set to the
    constants of the inclusion and to the normal of its surface.
    """
    if not body.is_plastic or backstresses_of(body):
        return
    misfits = [inclusion.misfit for inclusion in body.inclusions]
    misfits += [(0.0,) * 6] * (len(body.phases) - len(misfits))
    cut = np.nonzero(cells.is_cut)
    numbers, of_cell = np.unique(cells.phase[cut], return_inverse=True)
    phases = [relative_phase(material_around(body, n), body.phases[n], misfits[n]) for n in numbers]
    constants = np.array([(*phase[:2], *phase.misfit, phase.expansion) for phase in phases])
    constants = constants.reshape(-1, 9)
    ratios = constants[:, :2]
    moderate: BoolArray = (ratios.min(axis=1) >= 1 / _MAX_MODULUS_RATIO) & (
        ratios.max(axis=1) <= _MAX_MODULUS_RATIO
    )
    if not moderate.any():
        return
    normal = normals(cells, grid, body.inclusions)
    own = moderate[of_cell] & np.asarray(normal.any(axis=0))[cut]
    places = tuple(index[own] for index in cut)
    of_phase = (*fields[:FILLED_SHARE], *fields[MISFIT], fields[EXPANSION])
    for field, value in zip(of_phase, constants[of_cell[own]].T, strict=True):
        field[places] = value
    for field, component in zip(fields[NORMAL], normal, strict=True):
        field[places] = component[places]


def normals(cells: InclusionCells, grid: Grid, inclusions: Sequence[Inclusion] = ()) -> FloatArray:
    """Return unit normals of the inclusion surfaces in the cells of a box, shape (3, n, m, l).

    In a cell that an ellipsoid fills partly, it is the normal of the concentric ellipsoid of the
    same shape through the middle of the cell. In any other cell, it follows from the gradient of
    the volume fraction in the neighbouring cells (Youngs 1982), and is 0 where this gradient is 0.
    """
    found = _from_shares(cells, grid)
    cut = np.nonzero(cells.is_cut & (cells.phase >= 0) & (cells.phase < len(inclusions)))
    if not cut[0].size:
        return found
    assert grid.dz is not None
    number = cells.phase[cut]
    at = []
    for axis, (name, step, count) in enumerate(
        (("x", grid.dx, grid.nx), ("y", grid.dy, grid.ny), ("z", grid.dz, 0))
    ):
        centers = np.array([one.center[axis] for one in inclusions])[number]
        middle = (count - 1) / 2  # exactly opposite in mirrored cells
        distance = step * (cut[axis] + cells.first[axis] - middle) - centers
        if name in grid.periodic:
            distance -= step * count * np.round(distance / (step * count))
        at.append(distance)
    metrics = np.array([one.metric() for one in inclusions])[number]
    gradient = np.einsum("nij,jn->in", metrics, np.array(at))
    found[:, cut[0], cut[1], cut[2]] = gradient / np.linalg.norm(gradient, axis=0)
    return found


def _from_shares(cells: InclusionCells, grid: Grid) -> FloatArray:
    """Return the unit normals from the gradient of the volume fraction of the inclusions."""
    share = np.pad(cells.share, ((1, 1), (1, 1), (0, 1)))
    # Beyond the surface of the body the share continues.
    top = share[:, :, :1] if cells.first[2] == 0 else np.zeros_like(share[:, :, :1])
    share = np.concatenate([top, share], axis=2)
    assert grid.dz is not None
    gradient = []
    for axis, step in enumerate((grid.dx, grid.dy, grid.dz)):
        part = share
        for other in range(3):
            low, middle, high = (
                np.take(part, range(first, part.shape[other] - 2 + first), axis=other)
                for first in range(3)
            )
            part = (high - low) / step if other == axis else low + 2 * middle + high
        gradient.append(part)
    found = np.array(gradient)
    length = np.linalg.norm(found, axis=0)
    return np.asarray(-found / np.where(length > 0.0, length, 1.0))

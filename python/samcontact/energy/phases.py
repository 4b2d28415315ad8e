# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress and inelastic strain of the phases of partly filled cells."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .._util.checks import FloatArray
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.layered import materials_at
from ..problem.mixed_cells import mixed_cells
from ..problem.two_phase_cells import FILLED_SHARE, MISFIT, NORMAL
from .work import product

if TYPE_CHECKING:
    from ..solutions.state import State


class _Moduli(NamedTuple):
    """Bulk and shear modulus of cells [Pa], shape (cells,)."""

    bulk: FloatArray
    shear: FloatArray

    def mixed_with(self, other: _Moduli, share: FloatArray) -> _Moduli:
        pairs = zip(self, other, strict=True)
        return _Moduli(*((1.0 - share) * one + share * two for one, two in pairs))

    def stress(self, strain: FloatArray) -> FloatArray:
        mean = strain[:3].mean(axis=0)
        found = 2.0 * self.shear * strain
        found[:3] += (3.0 * self.bulk - 2.0 * self.shear) * mean
        return np.asarray(found)

    def strain(self, stress: FloatArray) -> FloatArray:
        mean = stress[:3].mean(axis=0)
        found = stress / (2.0 * self.shear)
        found[:3] += (1.0 / (3.0 * self.bulk) - 1.0 / (2.0 * self.shear)) * mean
        return np.asarray(found)


def inelastic_product(body: Heterogeneous, number: int, state: State) -> float:
    """Return the sum of s : e over all cells [Pa], with stress s and inelastic strain e of phases.

    The inelastic strain is the plastic strain plus the misfit. The stresses of the two phases of a
    cell follow from its mean stress, because the phases form a laminate (see
    docs/theory/inclusions.md).
    """
    stress, plastic = state.stress(number), state.plastic_strain(number)
    mixed = mixed_cells(number, body, state.grid)
    if mixed is None:
        return product(stress, plastic)
    first, index, rows, _ = mixed
    k, i, j = np.nonzero(index >= 0)
    place = np.stack([i + first[0], j + first[1], k + first[2]])
    limits = np.array(stress.shape[1:])[:, None]
    inside = ((place >= 0) & (place < limits)).all(axis=0)
    row = rows[index[k, i, j][inside]].T
    at = (slice(None), *place[:, inside])
    normal = row[NORMAL]
    two = normal.any(axis=0)
    inelastic = plastic.copy()
    inelastic[at] += np.where(two, 0.0, row[MISFIT])
    total = product(stress, inelastic)
    if not two.any():
        return total
    own = (slice(None), *place[:, inside][:, two])
    total -= product(stress[own], inelastic[own])
    matrix = _moduli_of_matrix(body, state, own[3])
    return total + _product_of_two(row[:, two], matrix, own, number, state)


def _moduli_of_matrix(body: Heterogeneous, state: State, layer: FloatArray) -> _Moduli:
    """Return the moduli of the matrix in cells; layer: index of the layer of each cell."""
    E, nu = np.empty(state.layers), np.empty(state.layers)
    for material, there in materials_at(body, state.depths):
        E[there], nu[there] = material.E, material.nu
    E, nu = E[layer], nu[layer]
    return _Moduli(E / (3.0 * (1.0 - 2.0 * nu)), E / (2.0 * (1.0 + nu)))


def _product_of_two(
    row: FloatArray, matrix: _Moduli, place: tuple[FloatArray, ...], number: int, state: State
) -> float:
    """Return the sum of s : e over the cells that contain two phases [Pa].

    row: constants of these cells as in `mixed_cells`, shape (constants, cells).
    """
    share, normal = row[FILLED_SHARE], row[NORMAL]
    inclusion = _Moduli(row[0] * matrix.bulk, row[1] * matrix.shear)
    strains = state.phase_strains(number)
    inelastic = strains.matrix[place], strains.inclusion[place] + row[MISFIT]
    strain = matrix.strain(state.stress(number)[place]) + state.eigenstrain(number)[place]
    # The jump of the displacement gradient leaves no jump of the traction.
    traction = _on_plane(matrix.stress(strain - inelastic[0]), normal)
    traction -= _on_plane(inclusion.stress(strain - inelastic[1]), normal)
    bulk, shear = inclusion.mixed_with(matrix, share)
    along = (traction * normal).sum(axis=0)
    less = (bulk + shear / 3.0) / (bulk + 4.0 * shear / 3.0)
    opened = _symmetric((traction - less * along * normal) / shear, normal)
    first = matrix.stress(strain - share * opened - inelastic[0])
    second = inclusion.stress(strain + (1.0 - share) * opened - inelastic[1])
    return product((1.0 - share) * first, inelastic[0]) + product(share * second, inelastic[1])


def _on_plane(stress: FloatArray, normal: FloatArray) -> FloatArray:
    """Return the traction of a stress on planes."""
    xx, yy, zz, yz, xz, xy = stress
    x, y, z = normal
    return np.stack([xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z])


def _symmetric(a: FloatArray, n: FloatArray) -> FloatArray:
    """Return the symmetric part of the dyadic product of two vectors, six components."""
    shear = [0.5 * (a[i] * n[j] + a[j] * n[i]) for i, j in ((1, 2), (0, 2), (0, 1))]
    return np.stack([*(a * n), *shear])

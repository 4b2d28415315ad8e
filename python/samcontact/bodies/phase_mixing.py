# SPDX-License-Identifier: GPL-3.0-or-later
"""Moduli and misfit strain of cells that inclusions fill only partly.

A softer inclusion is mixed with the matrix in parallel (Voigt), a stiffer one in series (Reuss);
bulk and shear modulus are mixed separately. Let f be the fraction of the cell that the inclusion
fills, a the modulus of the inclusion and A the mixed modulus, both divided by that of the matrix.
Then A = f a + 1 - f (softer) or 1/A = f/a + 1 - f (stiffer). The misfit strain is multiplied by f
a/A (softer) or f (stiffer). If a cell contains several inclusions, A is computed from all softer
ones by the first equation and from all stiffer ones by the second; the mixed modulus is the product
of both.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._util.checks import FloatArray
from .material import Material

RIGID_RATIO = 1e3
"""Modulus of a rigid inclusion / modulus of the matrix; larger ratios only increase the cost."""
Index = tuple[NDArray[np.intp], ...]
"""Indices of cells along x, y and z, as `numpy.ix_` returns them."""


class Phase(NamedTuple):
    """Properties of an inclusion relative to the matrix around it."""

    bulk: float
    """Bulk modulus divided by that of the matrix."""
    shear: float
    """Shear modulus divided by that of the matrix."""
    misfit: tuple[float, ...]
    """Misfit strain, six components."""
    expansion: float = 0.0
    """Thermal expansion coefficient minus that of the matrix [1/K]."""


def relative_phase(matrix: Material, material: Material | None, misfit: tuple[float, ...]) -> Phase:
    """Return the properties of an inclusion relative to the matrix.

    The moduli of a void (material None) are 0. If the inclusion or the matrix has no thermal
    constants, both are assumed to expand equally.
    """
    if material is None:
        return Phase(0.0, 0.0, misfit)
    expansion = 0.0
    if material.thermal is not None and matrix.thermal is not None:
        expansion = material.thermal[1] - matrix.thermal[1]
    if material.is_rigid:
        return Phase(RIGID_RATIO, RIGID_RATIO, misfit, expansion)
    if material.E == matrix.E and material.nu == matrix.nu:
        return Phase(1.0, 1.0, misfit, expansion)
    bulk, shear = (material.E / matrix.E * ratio for ratio in (
        (1 - 2 * matrix.nu) / (1 - 2 * material.nu), (1 + matrix.nu) / (1 + material.nu)
    ))  # fmt: skip
    return Phase(bulk, shear, misfit, expansion)


def _components_at(where: Index) -> tuple[Any, ...]:
    """Return the index that selects all components of a field in the given cells."""
    return (slice(None), *where)


class Modulus:
    """Bulk or shear modulus of the cells of a box, and the part of the misfit it acts on.

    The modulus is divided by that of the matrix. The bulk modulus acts on the volumetric part of
    the misfit strain, the shear modulus on the deviatoric part.
    """

    def __init__(self, shape: tuple[int, int, int], components: int) -> None:
        self.softer, self.stiffer = np.zeros(shape), np.zeros(shape)
        self.soft_misfit = np.zeros((components, *shape))
        self.stiff_misfit = np.zeros((components, *shape))

    def shrink(self, where: Index, factor: FloatArray) -> None:
        """Multiply the contributions of earlier inclusions to the cells `where` by a factor."""
        self.softer[where] *= factor
        self.stiffer[where] *= factor
        self.soft_misfit[_components_at(where)] *= factor
        self.stiff_misfit[_components_at(where)] *= factor

    def add(self, where: Index, share: FloatArray, ratio: float, misfit: FloatArray) -> None:
        """Add an inclusion that fills fractions `share` of the cells `where`.

        ratio: modulus of the inclusion divided by that of the matrix; misfit: part of its misfit
        strain that belongs to this modulus, shape (components,).
        """
        weighted = np.multiply.outer(misfit, share) if misfit.any() else None
        if ratio < 1.0:
            self.softer[where] += share * (ratio - 1.0)
            if weighted is not None:
                self.soft_misfit[_components_at(where)] += ratio * weighted
        else:
            self.stiffer[where] += share * (1.0 / ratio - 1.0)
            if weighted is not None:
                self.stiff_misfit[_components_at(where)] += weighted

    def mixed(self) -> FloatArray:
        """Return the mixed modulus of each cell, divided by the modulus of the matrix."""
        return np.asarray(np.maximum(1.0 + self.softer, 0.0) / (1.0 + self.stiffer))

    def mixed_misfit(self) -> FloatArray:
        """Return the mixed misfit strain on which this modulus acts, shape (components, ...)."""
        whole = np.maximum(1.0 + self.softer, np.finfo(float).tiny)
        soft = np.where(self.soft_misfit == 0.0, 0.0, self.soft_misfit / whole)
        return np.asarray(soft + self.stiff_misfit)


class Mixture:
    """Filled fractions, moduli and misfit of the cells of a box, to which inclusions are added."""

    def __init__(self, shape: tuple[int, int, int], *, expands: bool) -> None:
        self.share, self.largest = np.zeros(shape), np.zeros(shape)
        self.phase = np.full(shape, -1, dtype=np.int32)
        self.bulk, self.shear = Modulus(shape, 2 if expands else 1), Modulus(shape, 6)
        self.has_misfit = False

    def add(self, number: int, where: Index, share: FloatArray, phase: Phase) -> None:
        """Add an inclusion, which replaces earlier inclusions where it overlaps them."""
        before = self.share[where]
        room = 1.0 - share
        if (before > room).any():
            factor = np.divide(room, before, out=np.ones_like(room), where=before > room)
            self.share[where] *= factor
            self.largest[where] *= factor
            self.bulk.shrink(where, factor)
            self.shear.shrink(where, factor)
        self.share[where] = np.minimum(self.share[where] + share, 1.0)
        wins = (share > 0.0) & (share >= self.largest[where])
        self.phase[where] = np.where(wins, number, self.phase[where])
        self.largest[where] = np.maximum(self.largest[where], share)
        six = np.array(phase.misfit)
        self.has_misfit |= bool(six.any())
        mean = six[:3].mean()
        deviator = six - mean * np.array([1, 1, 1, 0, 0, 0])
        isotropic = np.array([mean, phase.expansion])[: len(self.bulk.soft_misfit)]
        self.bulk.add(where, share, phase.bulk, isotropic)
        self.shear.add(where, share, phase.shear, deviator)

    def misfit(self) -> FloatArray:
        """Misfit strain of the cells, weighted by the mixing rule, shape (6, ...)."""
        if not self.has_misfit:
            return np.zeros((6, *self.share.shape))
        total = self.shear.mixed_misfit()
        total[:3] += self.bulk.mixed_misfit()[:1]
        return total

    def expansion(self) -> FloatArray:
        """Misfit strain of the cells per temperature rise [1/K], weighted by the mixing rule."""
        isotropic = self.bulk.mixed_misfit()
        return isotropic[1] if len(isotropic) > 1 else np.zeros(self.share.shape)

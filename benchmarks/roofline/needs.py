# SPDX-License-Identifier: GPL-3.0-or-later
"""Operations and bytes that the steps of a solution cannot do without.

Real numbers have 8 bytes. A transform of a plane is done by rows and by columns, so that its
spectrum is written and read between the two; everything else of a step is counted once.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

SWEEP = 240
"""Operations of the two passes over the layers, for a wavenumber and a layer: equations (25) to
(27) of the theory, real and imaginary parts, with the rotation of the tensors."""
RETURN = 100
"""Operations of the radial return of a cell."""
SURFACE_COEFFICIENT, VOLUME_COEFFICIENT = 60, 350
"""Operations of one coefficient of the pressure, and of the twelve coefficients of a cuboid."""
TENSOR = 6
STRAINS = 5
"""Components of plastic strain, which has no trace."""


class Need(NamedTuple):
    """Operations and bytes."""

    flops: float
    bytes: float

    def plus(self, *others: Need) -> Need:
        """Return the sum."""
        every = (self, *others)
        return Need(sum(one.flops for one in every), sum(one.bytes for one in every))

    def times(self, factor: float) -> Need:
        """Return a multiple."""
        return Need(factor * self.flops, factor * self.bytes)


NOTHING = Need(0.0, 0.0)


def transform(nx: float, ny: float, *, padded: bool) -> Need:
    """Return the need of one real transform of nx x ny cells, forwards or backwards.

    padded: the plane is extended by zeros to twice its size; rows of zeros are left out.
    """
    lx, ly = (2 * nx, 2 * ny) if padded else (nx, ny)
    half = ly / 2 + 1
    rows = 2.5 * nx * ly * math.log2(max(ly, 2))
    columns = 5.0 * half * lx * math.log2(max(lx, 2))
    # The plane, the half spectrum of its rows, written and read.
    return Need(rows + columns, 8.0 * nx * ny + 2 * 16.0 * nx * half)


def spectrum(nx: float, ny: float, *, padded: bool) -> float:
    """Return the number of complex values of the half spectrum of a plane."""
    return (2 * nx) * (ny + 1) if padded else nx * (ny / 2 + 1)


def product(nx: float, ny: float, *, padded: bool) -> Need:
    """Return the need of a product with real coefficients, stored for a quarter of the plane."""
    values = spectrum(nx, ny, padded=padded)
    return Need(2.0 * values, 8.0 * values / 2)


def displacement(nx: float, ny: float, *, padded: bool) -> Need:
    """Return the need of one displacement due to a pressure."""
    return transform(nx, ny, padded=padded).times(2).plus(product(nx, ny, padded=padded))


def surface_setup(nx: float, ny: float, *, padded: bool) -> Need:
    """Return the need of the coefficients of a displacement and of their transform."""
    one = transform(
        nx, ny, padded=False
    )  # a quarter of the padded plane, as both parities are even
    return Need(SURFACE_COEFFICIENT * nx * ny * (1 if padded else 0.25), 0.0).plus(one)


def volume(box: Sequence[float], *, padded: bool, components: int = STRAINS) -> Need:
    """Return the need of the stress and displacement due to strain and pressure in a box.

    The transforms of strain and stress, the passes over the layers, the products of the pressure
    with the coefficients of its stress and of the strain with those of its displacement, and the
    radial return.
    """
    nx, ny, nz = box
    plane = transform(nx, ny, padded=padded)
    values = spectrum(nx, ny, padded=padded)
    sweeps = Need(SWEEP * values, 16.0 * values * (2 * components + TENSOR))
    products = product(nx, ny, padded=padded).times(TENSOR + components)
    cells = Need(RETURN * nx * ny, 8.0 * nx * ny * (TENSOR + 2 * components + 1))
    layer = plane.times(components + TENSOR).plus(sweeps, products, cells)
    return layer.times(nz).plus(plane.times(2))


def volume_setup(box: Sequence[float]) -> Need:
    """Return the need of the coefficients of a box, computed and transformed once."""
    nx, ny, nz = box
    of_plane = Need(VOLUME_COEFFICIENT * nx * ny, 0.0)
    return of_plane.plus(transform(nx, ny, padded=False).times(2 * TENSOR)).times(nz)


def tractions(box: Sequence[float], source: Sequence[float]) -> Need:
    """Return the need of the stress in a box due to the pressure on a wider contact."""
    nx, ny, nz = box[0] + source[0], box[1] + source[1], box[2]
    plane = transform(nx, ny, padded=False)
    layer = plane.plus(product(nx, ny, padded=False)).times(TENSOR)
    return layer.times(nz).plus(plane)


def tractions_setup(box: Sequence[float], source: Sequence[float]) -> Need:
    """Return the need of the coefficients of this stress, for a quarter of the plane."""
    half = ((box[0] + source[0]) / 2, (box[1] + source[1]) / 2, box[2])
    return volume_setup(half)


def dissection(n: float) -> Need:
    """Return the need of a sparse decomposition of n equations of a plane, by nested dissection.

    George (1973): 829/84 n^1.5 multiplications, each with a sum, for a symmetric matrix; twice as
    many for others.
    """
    return Need(829 / 21 * n**1.5, 16.0 * factors(n))


def factors(n: float) -> float:
    """Return the number of values of both factors: George (1973), 31/4 n log2(sqrt(n))."""
    return 2 * 31 / 4 * n * max(math.log2(math.sqrt(n)) - 3, 1.0)


def substitution(n: float) -> Need:
    """Return the need of one solution with the factors."""
    return Need(2 * factors(n), 8.0 * factors(n))

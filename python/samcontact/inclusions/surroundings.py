# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of a field around the inclusions of a body."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._util.checks import BoolArray, FloatArray, number, require_type
from .._util.frozen import read_only
from .._util.short_text import in_short
from ..bodies.filled_shares import shares
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.inclusion import Inclusion
from ..fatigue.field import FatigueField

MAX_WITHIN = 10.0
"""Largest distance from the centre of an inclusion that may count as near, in radii."""


def checked_within(within: float) -> float:
    """Check a distance from the centre of an inclusion in radii; it must exceed 1, the surface."""
    ratio = number("within", within)
    if not 1.0 < ratio <= MAX_WITHIN:
        raise ValueError(
            f"within must be above 1 and at most {MAX_WITHIN:g} radii, got {ratio!r}: the surface "
            "of an inclusion is at 1"
        )
    return ratio


class Surroundings(NamedTuple):
    """Positions of the points of a field relative to the nearest inclusion.

    The axes of the arrays are x, y and z.
    """

    number: NDArray[np.int32]
    """Index of the nearest inclusion; -1 if none is near."""
    distance: FloatArray
    """Distance from its centre in radii, 1 at its surface; infinite if no inclusion is near."""
    is_matrix: BoolArray
    """Whether the cell around the point contains the matrix only."""


def checked_field(field: FatigueField, body: Heterogeneous) -> list[FloatArray]:
    """Check that a field has the axes x, y and z, and return its coordinates [m]."""
    require_type("field", field, FatigueField)
    require_type("body", body, Heterogeneous)
    if tuple(field.coordinates) != ("x", "y", "z"):
        raise ValueError(
            "field must have the axes x, y and z, got "
            f"{', '.join(field.coordinates) or 'a stress array'}: evaluate the criterion for "
            "a cycle of states"
        )
    axes = [np.asarray(field.coordinates[name]) for name in "xyz"]
    if min(axis.size for axis in axes) < 2:
        raise ValueError(
            f"field must have at least 2 points along each axis, got {in_short(field)}"
        )
    return axes


def surroundings(
    coordinates: Mapping[str, FloatArray] | Sequence[FloatArray],
    body: Heterogeneous,
    within: float = 1.5,
) -> Surroundings:
    """Find the inclusion that is nearest to each point, up to a distance of `within` radii.

    coordinates: evenly spaced cell centres along x, y and z [m].
    """
    given = coordinates.values() if isinstance(coordinates, Mapping) else coordinates
    x, y, z = given
    shape = (x.size, y.size, z.size)
    size = np.array([axis[1] - axis[0] for axis in (x, y, z)])
    nearest = np.full(shape, -1, dtype=np.int32)
    distance = np.full(shape, np.inf)
    is_matrix = np.ones(shape, dtype=bool)
    for n, inclusion in enumerate(body.inclusions):
        reach = max(within, 1.0) * np.array(inclusion.extent) + size
        at = [
            slice(*np.searchsorted(axis, (c - r, c + r)))
            for axis, c, r in zip((x, y, z), inclusion.center, reach, strict=True)
        ]
        local = [axis[s] - c for axis, s, c in zip((x, y, z), at, inclusion.center, strict=True)]
        if min(part.size for part in local) == 0:
            continue
        index = tuple(at)
        is_matrix[index] &= shares(inclusion.metric(), (local[0], local[1], local[2]), size) == 0.0
        apart = _distance(inclusion, local)
        nearer = (apart < distance[index]) & (apart <= within)
        distance[index] = np.where(nearer, apart, distance[index])
        nearest[index] = np.where(nearer, n, nearest[index])
    if body.measured is not None:
        _exclude_voxels(body, (x, y, z), size, is_matrix)
    return Surroundings(nearest, distance, is_matrix)


def _distance(inclusion: Inclusion, local: Sequence[FloatArray]) -> FloatArray:
    """Distance of points from the centre of an ellipsoid, in radii: 1 at its surface."""
    points = np.stack(np.meshgrid(*local, indexing="ij"), -1)
    return np.asarray(np.linalg.norm(points @ np.linalg.cholesky(inclusion.metric()), axis=-1))


def _exclude_voxels(
    body: Heterogeneous, axes: Sequence[FloatArray], size: FloatArray, is_matrix: BoolArray
) -> None:
    assert body.measured is not None
    places = [
        (float(axis[0] - step / 2), float(step)) for axis, step in zip(axes, size, strict=True)
    ]
    for _, ends, share in body.measured.shares_on(places):
        cells = [np.arange(*pair) for pair in ends]
        inside = [
            (at >= 0) & (at < count) for at, count in zip(cells, is_matrix.shape, strict=True)
        ]
        to = np.ix_(*(at[ok] for at, ok in zip(cells, inside, strict=True)))
        is_matrix[to] &= share[np.ix_(*inside)] == 0.0


def matrix_field(
    field: FatigueField, body: Heterogeneous, within: float | None = None
) -> FatigueField:
    """Return a copy of a field that is 0 in each cell that contains any part of an inclusion.

    Pass the result to `samcontact.fatigue.life`, whose integral then extends over the matrix only.
    Divide this life by the life of the same body without inclusions to see how much the inclusions
    shorten it. The integral depends less on the cell size than the maximum of the criterion does.

    Parameters
    ----------
    field : FatigueField
        Criterion over a cycle of states, with the axes x, y and z.
    body : Heterogeneous
        Body for which the field was computed.
    within : float, optional
        Distance from the centre of an inclusion in radii, above 1 and at most 10. Cells that are
        farther away from all inclusions are set to 0 as well. Default: no limit.

    Returns
    -------
    FatigueField

    Raises
    ------
    ValueError
        The field has axes other than x, y and z, or `within` is outside its range.
    TypeError
        An argument has the wrong type.
    """
    axes = checked_field(field, body)
    ratio = None if within is None else checked_within(within)
    near = surroundings(axes, body, 1.5 if ratio is None else ratio)
    kept = near.is_matrix if ratio is None else near.is_matrix & (near.number >= 0)
    return replace(field, values=read_only(np.where(kept, field.values, 0.0)), normals=None)


def names_near(near: Surroundings) -> list[int]:
    """Indices of the inclusions that have points of the matrix near them."""
    found = np.unique(near.number[near.is_matrix])
    return list(itertools.compress(found.tolist(), found >= 0))

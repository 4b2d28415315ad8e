# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic strain of worn bodies: taken from a state, and moved up to the worn surface."""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray
from ..solutions.state import State
from .problem import BodyStrain, WearProblem
from .steps import below_worn_surface, deviator_below_worn_surface


def strains_of(problem: WearProblem, state: State) -> dict[int, BodyStrain]:
    """Return the plastic strain of each elastic-plastic body where the contact has passed.

    Bodies without plastic strain are omitted. Raises ValueError if plastic strain lies below the
    deepest layer or beyond the sides of the grid.
    """
    found = {n: _strain_of(state, n) for n in (1, 2) if problem.bodies[n - 1].is_plastic}
    return {body: kept for body, kept in found.items() if kept is not None}


def _strain_of(state: State, body: int) -> BodyStrain | None:
    if state._core.strain_beyond(body - 1) is not None:
        raise ValueError(
            f"plastic strain of body {body} must lie within the grid, but extends below "
            "the deepest layer or beyond the sides of the grid: omit nz, or enlarge nz, nx or ny"
        )
    track = state.track(body, margin=0)
    fields = [track.equivalent_plastic_strain(), track.plastic_strain(), track.backstress()]
    if state.grid.nz == 0:  # no plastic strain below the grid
        fields = [np.pad(field, [*[(0, 0)] * (field.ndim - 1), (0, 1)]) for field in fields]
    equivalent, strain, back = fields
    rows = np.flatnonzero(strain.any(axis=(0, 2, 3)) | equivalent.any(axis=(1, 2)))
    if not rows.size:
        return None
    part = slice(int(rows[0]), int(rows[-1]) + 1)
    return BodyStrain(
        track.first + part.start,
        strain[:, part],
        equivalent[part],
        back[:, :, part] if len(back) else None,
    )


def largest(kept: BodyStrain | None, layers: slice) -> float:
    """Return the maximum equivalent plastic strain in the given layers; 0 if there is none."""
    return 0.0 if kept is None else float(kept.equivalent[:, :, layers].max())


def flow_between(problem: WearProblem, start: State, end: State) -> float:
    """Return the maximum increase of the equivalent plastic strain between two states [-].

    The maximum is taken over the cells of both bodies.
    """
    bodies = [n for n in (1, 2) if problem.bodies[n - 1].is_plastic]
    if not bodies:
        return 0.0
    layers = max(start.layers, end.layers, 1)
    before, after = (state.at_layers(layers) for state in (start, end))
    changes = (after.equivalent_plastic_strain(n) - before.equivalent_plastic_strain(n)
               for n in bodies)  # fmt: skip
    return max(float(change.max()) for change in changes)


def rows_of(problem: WearProblem, body: int, kept: BodyStrain) -> slice:
    """Return the rows with plastic strain, as a slice of the rows of the body that can wear."""
    start = kept.first - problem.rows(body)[0]
    return slice(start, start + len(kept.equivalent))


def moved_up(problem: WearProblem, body: int, kept: BodyStrain, worn: FloatArray) -> BodyStrain:
    """Return the plastic strain that remains after wear, at depths below the worn surface.

    worn: removed depth [m], in the rows of the body that can wear.
    """
    assert problem.grid.dz is not None
    removed = worn[rows_of(problem, body, kept)]
    dz = problem.grid.dz
    back = (
        None
        if kept.backstress is None
        else deviator_below_worn_surface(kept.backstress, removed, dz)
    )
    return BodyStrain(
        kept.first,
        deviator_below_worn_surface(kept.strain, removed, dz),
        np.maximum(below_worn_surface(kept.equivalent, removed, dz), 0.0),
        back,
    )

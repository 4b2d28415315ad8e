# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic energy of bodies with inclusions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.layered import Body
from .work import product

if TYPE_CHECKING:
    from ..solutions.state import State


def mismatch_energy(bodies: Sequence[Body], state: State) -> float:
    """Return the elastic energy of bodies minus that of the same bodies without inclusions [J].

    It is 1/2 of the integral of s0 : e* - s : e0, with the stress s0 that the tractions cause in
    the homogeneous matrix, the stress s, the eigenstrain e* of the inclusions and their misfit e0.
    """
    total = 0.0
    for number, body in enumerate(bodies, 1):
        if not isinstance(body, Heterogeneous):
            continue
        cells = body.cells_on(state.grid)
        first, shape = cells.first, cells.share.shape
        deep = state.at_layers(max(state.layers, first[2] + shape[2]))
        stress = deep.stress(number)
        of_tractions = stress - deep.disturbance(number)
        grid = (*state.grid.surface_shape, deep.layers)
        misfit: FloatArray = np.stack([cells.over_grid(part, grid) for part in cells.misfit])
        work = product(of_tractions, deep.eigenstrain(number)) - product(stress, misfit)
        assert state.grid.dz is not None
        total += 0.5 * work * state.grid.cell_area * state.grid.dz
    return float(total)


def not_balanced(bodies: Sequence[Body], states: Sequence[State]) -> str:
    """Return why no energy balance of bodies with inclusions can be computed; "" if it can be."""
    for number, body in enumerate(bodies, 1):
        if not isinstance(body, Heterogeneous):
            continue
        if body.is_plastic:
            return (
                f"body{number} must be elastic if it has inclusions: the plastic work of partly "
                "filled cells is not included in the balance"
            )
        if any(state.has_eigenstrain(number) for state in states):
            return f"body{number} must not have an added eigenstrain if it has inclusions"
        expands = any(
            body.cells_on(state.grid, check=False).expansion.any()
            and np.any(state.surface_temperature(number))
            for state in states
        )
        if expands:
            return (
                f"body{number} must not be heated if its inclusions expand differently: the work "
                "of their thermal misfit is not included in the balance"
            )
        if any(any(state.travel) for state in states):
            return f"body{number} must not move if it has inclusions"
    return ""

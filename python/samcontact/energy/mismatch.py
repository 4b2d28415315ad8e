# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic energy and plastic work of bodies with inclusions."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.layered import Body, backstresses_of
from .phases import inelastic_product
from .work import isotropic_work, product

if TYPE_CHECKING:
    from ..solutions.state import State


def mismatch_energy(bodies: Sequence[Body], state: State) -> float:
    """Return the elastic energy of bodies minus that of the same bodies without inclusions [J].

    It is 1/2 of the integral of (s0 - si) : e* - s : e0, with the stress s0 due to the tractions in
    the homogeneous matrix, the initial stress si, the stress s, the eigenstrain e*, and the
    inelastic strain e0 of each phase, which is its plastic strain plus its misfit.
    """
    total = 0.0
    for number, body in enumerate(bodies, 1):
        if not isinstance(body, Heterogeneous):
            continue
        deep = _whole(body, state)
        of_tractions = deep.stress(number) - deep.disturbance(number)
        of_tractions -= 2.0 * deep.initial_stress(number)
        work = product(of_tractions, deep.eigenstrain(number))
        total += 0.5 * (work - inelastic_product(body, number, deep)) * _cell_volume(state)
    return float(total)


def work_with_inclusions(body: Heterogeneous, number: int, states: Sequence[State]) -> float:
    """Return the plastic work of matrix and inclusions up to the last state [J].

    The work of the isotropic yield stress is integrated in closed form for each phase of a cell,
    with the volume fraction of the phase. The work of the backstress is computed with the mean
    backstress of each increment.
    """
    deep = _whole(body, states[-1])
    track, share = deep.track(number, margin=0), deep.share(number)
    total = float(np.sum((1.0 - share) * isotropic_work(body.matrix, track, deep)))
    own = deep.phase_strains(number).inclusion_equivalent
    phase = deep.phase(number)
    for n, material in enumerate(body.phases):
        if material is not None and material.is_plastic:
            filled = phase == n
            total += float(np.sum(share[filled] * material.plastic_work(own[filled])))
    if backstresses_of(body) > 0:
        voids = [n for n, material in enumerate(body.phases) if material is None]
        # The matrix around a void is in parallel with it, and has the strain of the cell.
        left = np.where(np.isin(phase, voids), 1.0 - share, 1.0)
        total += _work_of_backstress(number, states, left)
    return total * _cell_volume(deep)


def _work_of_backstress(number: int, states: Sequence[State], share: FloatArray) -> float:
    """Return the work of the backstress on the plastic strain, summed over cells [J/m^3].

    share: volume fraction of each cell in which the backstress acts.
    """
    deep = [state.at_layers(share.shape[2]) for state in states]
    back = [share * state.backstress(number).sum(axis=0) for state in deep]
    strain = [state.plastic_strain(number) for state in deep]
    total = 0.5 * product(back[0], strain[0])
    for (old, new), (start, end) in zip(pairwise(back), pairwise(strain), strict=True):
        total += 0.5 * product(old + new, end - start)
    return total


def _whole(body: Heterogeneous, state: State) -> State:
    """Return the state with all layers that contain inclusions."""
    cells = body.cells_on(state.grid)
    return state.at_layers(max(state.layers, cells.first[2] + cells.share.shape[2]))


def _cell_volume(state: State) -> float:
    assert state.grid.dz is not None
    return state.grid.cell_area * state.grid.dz


def not_balanced(bodies: Sequence[Body], states: Sequence[State]) -> str:
    """Return why no energy balance of bodies with inclusions can be computed; "" if it can be."""
    for number, body in enumerate(bodies, 1):
        if not isinstance(body, Heterogeneous):
            continue
        if any(state.has_eigenstrain(number) for state in states):
            return (
                f"body{number} must not have both inclusions and an added eigenstrain: an energy "
                "balance is not available for them"
            )
        heated = any(np.any(state.surface_temperature(number)) for state in states)
        expands = any(body.cells_on(state.grid, check=False).expansion.any() for state in states)
        if heated and expands:
            return (
                f"body{number} must not be heated if its inclusions expand differently: the work "
                "of their thermal misfit is not included in the balance"
            )
        if heated and body.is_plastic:
            return (
                f"body{number} must not be heated if it has inclusions and can yield: the work of "
                "the thermal stress on the mismatch is not included in the balance"
            )
        if any(any(state.travel) for state in states):
            return (
                f"body{number} must not move if it has inclusions: an energy balance is only "
                "available at rest"
            )
    return ""

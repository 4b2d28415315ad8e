# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress on both sides of the interfaces of a layered body."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._util import memory
from .._util.checks import FloatArray, choice
from ..bodies.layered import Body, Layered

if TYPE_CHECKING:
    from .state import State

SIDES = ("above", "below")
_TO_FACE = {1: (1.0,), 2: (1.5, -0.5), 3: (11 / 6, -7 / 6, 1 / 3)}
"""Value at the face of the first of so many cells from the means of a polynomial over them."""


def stress_at_interfaces(state: State, body: int) -> FloatArray:
    """See `State.interface_stress`; that of plastic strain is continued from cells of each side."""
    layered = _layered(state, body)
    depths = layered.interfaces
    sides = np.stack([np.nextafter(depths, 0.0), depths])
    needed = memory.volume(state.grid, memory.STRESS_OF_TRACTIONS, sides.size)
    memory.require_for_grid("the stress at interfaces", state.grid, needed)
    sign = 1.0 if body == 2 else -1.0
    stress = _core.operators.surface_stress(
        state.grid._core, layered._core.stack, _core.Heating(), sides.ravel().tolist(),
        np.ascontiguousarray(state.pressure), *np.ascontiguousarray(sign * state.shear),
    )  # fmt: skip
    found = np.stack(np.split(stress, len(SIDES), axis=-1))
    for component, initial in zip((0, 1, 5), layered.residual_stress_at(sides), strict=True):
        found[:, component] += initial[:, None, None, :]
    if state.max_plastic_strain_magnitude(body) > 0:
        found += _of_strain(state, body, depths)
    return found


def _layered(state: State, body: int) -> Layered:
    simulation = state._simulation
    bodies: tuple[Body, Body] = simulation.body1, simulation.body2
    found = bodies[choice("body", body, (1, 2)) - 1]
    if not isinstance(found, Layered):
        raise ValueError(f"body{body} must have layers, whose interfaces are asked for: {found!r}")
    if state.offset(body):
        raise ValueError(
            f"fields of body{body} lie {state.offset(body):.3g} m beside the cells of the grid, "
            "where tractions are known: let both bodies move by whole cells"
        )
    return found


def _of_strain(state: State, body: int, depths: FloatArray) -> FloatArray:
    dz = state.grid.dz
    assert dz is not None  # without layers of cells there is no plastic strain
    cuts = np.rint(depths / dz).astype(int)
    deep = state._down_to(int(cuts[-1]) + len(_TO_FACE))
    cells = deep.residual_stress(body) - deep.initial_stress(body)
    faces = []
    for above, at, below in zip([0, *cuts], cuts, [*cuts[1:], cells.shape[-1]], strict=False):
        upper, lower = cells[..., above:at][..., ::-1], cells[..., at:below]
        faces.append([_at_face(upper), _at_face(lower)])
    return np.moveaxis(np.array(faces), 0, -1)


def _at_face(cells: FloatArray) -> FloatArray:
    """Of cells of one material, from its face on."""
    weights = _TO_FACE[min(len(_TO_FACE), cells.shape[-1])]
    face: FloatArray = cells[..., : len(weights)] @ np.array(weights)
    return face

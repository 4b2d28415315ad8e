# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress on both sides of the interfaces of a layered body."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from .. import _core
from .._util import memory
from .._util.checks import FloatArray
from ..bodies.layered import Body, matrix_of
from ..bodies.layers import Layered
from ..problem.grid import Grid

SIDES = ("above", "below")
_FACE_WEIGHTS = {1: (1.0,), 2: (1.5, -0.5), 3: (11 / 6, -7 / 6, 1 / 3)}
"""Weights that extrapolate the mean stresses of n cells to the outer face of the first cell."""


def layered_body(bodies: tuple[Body, Body], body: int, offset: float) -> Layered:
    """Return body 1 or 2; ValueError if it has no layers, or its cells are offset from the grid."""
    found = matrix_of(bodies[body - 1])
    if not isinstance(found, Layered):
        raise ValueError(f"body{body} must be layered for the stress at interfaces, got {found!r}")
    if offset:
        raise ValueError(
            f"cells of body{body} must coincide with cells of the grid for the stress at "
            f"interfaces, got an offset of {offset:.3g} m: displace both bodies by whole cells"
        )
    return found


def stress_at_interfaces(
    grid: Grid,
    layered: Layered,
    tractions: tuple[FloatArray, FloatArray],
    residual_stress: Callable[[int], FloatArray] | None,
) -> FloatArray:
    """Return the stress on both sides of each interface [Pa], see `State.interface_stress`.

    tractions: pressure and shear on the body; residual_stress: function that returns the stress due
    to plastic strain in a given number of cell layers, or None if there is no such stress.
    """
    pressure, shear = tractions
    depths = layered.interfaces
    sides = np.stack([np.nextafter(depths, 0.0), depths])
    needed = memory.volume(grid, memory.TRACTION_STRESS_BYTES, sides.size)
    memory.require_for_grid("the stress at the interfaces", grid, needed)
    stress = _core.operators.surface_stress(
        grid._core, layered._core, _core.Heating(), sides.ravel().tolist(),
        np.ascontiguousarray(pressure), *np.ascontiguousarray(shear),
    )  # fmt: skip
    found = np.stack(np.split(stress, len(SIDES), axis=-1))
    for component, initial in zip((0, 1, 5), layered.residual_stress_at(sides), strict=True):
        found[:, component] += initial[:, None, None, :]
    if residual_stress is not None and grid.dz is not None:
        cuts = np.rint(depths / grid.dz).astype(int).tolist()
        found += _continued(residual_stress(cuts[-1] + len(_FACE_WEIGHTS)), cuts)
    return found


def _continued(cells: FloatArray, cuts: Sequence[int]) -> FloatArray:
    """Extrapolate the mean stress of the cells to both sides of each interface."""
    faces = []
    for above, at, below in zip([0, *cuts], cuts, [*cuts[1:], cells.shape[-1]], strict=False):
        upper, lower = cells[..., above:at][..., ::-1], cells[..., at:below]
        faces.append([_at_face(upper), _at_face(lower)])
    return np.moveaxis(np.array(faces), 0, -1)


def _at_face(cells: FloatArray) -> FloatArray:
    """Extrapolate the mean stress of cells of one material to the outer face of the first cell."""
    weights = _FACE_WEIGHTS[min(len(_FACE_WEIGHTS), cells.shape[-1])]
    face: FloatArray = cells[..., : len(weights)] @ np.array(weights)
    return face

# SPDX-License-Identifier: GPL-3.0-or-later
"""Default grid of a roller or bearing if the case has neither [grid] nor `accuracy`."""

from __future__ import annotations

from typing import Any

from .. import hertz
from ..bodies.layered import softest
from .sections import GridSection

CELLS_PER_SEMI_AXIS = 10
"""Cells per semi-axis of the Hertz contact at maximum load."""
_MARGIN = 1.25  # half-width of the grid / half-width of the contact
_LAYERS = 12  # of elastic bodies


def grid_of_part(case: Any) -> GridSection | None:
    """Return the grid for the contact of a roller or bearing at maximum load; None for other parts.

    The grid is enlarged during the solution if a contact or a plastic zone requires it.
    """
    if case.surface.shape not in ("roller", "bearing") or not case.surface.is_known:
        return None
    bodies = case.body1, case.body2
    loads = [segment.load or 0.0 for segment in case.path]
    if max(loads) <= 0.0 or all(body.is_rigid for body in bodies):
        return None
    E_star = hertz.effective_modulus(*(softest(body.build()) for body in bodies))
    surface = case.surface
    part = surface.first_grid(max(loads), E_star)
    cells = (CELLS_PER_SEMI_AXIS, CELLS_PER_SEMI_AXIS)
    if part is not None:
        half, cells = part.half, (cells[0], round(0.5 * cells[1] * part.refined))
    else:
        Rx, Ry = surface.radii()
        contact = hertz.elliptic(Rx, Ry, E_star, load=max(loads))
        half = contact.a_x, contact.a_y
    (dx, dy) = half[0] / cells[0], half[1] / cells[1]
    nx = 2 * round(_MARGIN * cells[0]) + 1
    ny = 2 * round(cells[1] * (_MARGIN if part is None else 1.0)) + 1
    plastic = any(body.is_plastic for body in bodies)
    return GridSection(nx=nx, ny=ny, dx=dx, dy=dy, dz=dx, nz=0 if plastic else _LAYERS)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the material layers of a body match the layers of grid cells."""

from __future__ import annotations

from ..bodies.layered import Body, interfaces_on_cells, matrix_of
from ..bodies.layers import Layered
from .grid import Grid


def require_servable_flow(grid: Grid, residual_stress: str, *bodies: Body) -> bool:
    """Return whether any layered body can yield or has inclusions, after checking these bodies.

    Raises ValueError for such a body if its substrate is rigid, if `residual_stress` is "exact", or
    if the bottom of a layer lies inside a layer of cells.
    """
    flows = False
    for n, given in enumerate(bodies, 1):
        body, interfaces = matrix_of(given), interfaces_on_cells(given)
        if not isinstance(body, Layered) or not interfaces.size:
            continue
        flows = True
        if body.substrate.is_rigid:
            raise ValueError(
                f"on a rigid substrate, the layers of body{n} must be elastic and free of "
                f"inclusions, got {given!r}: use an elastic substrate, a few times stiffer than "
                "the layers"
            )
        if residual_stress == "exact":
            raise ValueError(
                f'residual_stress must be "fast" because body{n} has layers, got "exact", which '
                "requires closed-form kernels: these exist for homogeneous bodies only"
            )
        for place, depth in enumerate(interfaces if grid.dz is not None else ()):
            cells = depth / grid.dz
            if abs(cells - round(cells)) > 1e-6:
                raise ValueError(
                    f"the bottom of layers[{place}] of body{n}, at {float(depth)!r} m, must "
                    f"coincide with a boundary between layers of cells, got grid.dz = {grid.dz!r}: "
                    "choose dz so that each layer is a whole number of cells thick, e.g. 4 or 8"
                )
    return flows

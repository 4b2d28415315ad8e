# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the material layers of a body match the layers of grid cells."""

from __future__ import annotations

from ..bodies.layered import Body, Layered
from .grid import Grid


def require_servable_flow(grid: Grid, residual_stress: str, *bodies: Body) -> bool:
    """Return whether any layered body can yield; raise ValueError if such a body is unsupported."""
    flows = False
    for n, body in enumerate(bodies, 1):
        if not isinstance(body, Layered) or not body.is_plastic:
            continue
        flows = True
        if body.substrate.is_rigid:
            raise ValueError(
                f"layers of body{n} must be elastic on a rigid substrate, got {body!r}: use an "
                "elastic substrate, a few times stiffer than the layers"
            )
        if residual_stress == "exact":
            raise ValueError(
                f'residual_stress must be "fast" because body{n} has layers, got "exact": there '
                "are no closed-form kernels for layered bodies"
            )
        for place, depth in enumerate(body.interfaces if grid.dz is not None else ()):
            cells = depth / grid.dz
            if abs(cells - round(cells)) > 1e-6:
                raise ValueError(
                    f"the bottom of layers[{place}] of body{n}, at {float(depth)!r} m, must "
                    f"coincide with a boundary between layers of cells, got grid.dz = {grid.dz!r}: "
                    "use a whole fraction of the layer thickness (1/4, 1/8, ...)"
                )
    return flows

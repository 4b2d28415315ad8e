# SPDX-License-Identifier: GPL-3.0-or-later
"""Check that each inclusion of a layered body lies within one layer."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .._util.checks import FloatArray
from .._util.display import quantity
from .inclusion import Inclusion
from .voxels import VoxelBlock

_ROUNDING_ERROR = 1e-9  # of the depth of an interface, which an inclusion may touch


def require_within_layers(
    interfaces: FloatArray, inclusions: Sequence[Inclusion], measured: VoxelBlock | None
) -> None:
    """Raise ValueError for an inclusion or a block of voxels that crosses an interface.

    interfaces: depth of the bottom of each layer [m].
    """
    ends = [(one.center[2] - one.extent[2], one.center[2] + one.extent[2]) for one in inclusions]
    names = [f"inclusions[{n}]" for n in range(len(inclusions))]
    if measured is not None:
        ends.append(measured.depths)
        names.append("the block of voxels")
    tops, bottoms = np.array(ends).T
    for number, depth in enumerate(interfaces.tolist()):
        off = _ROUNDING_ERROR * depth
        crossing = (tops < depth - off) & (bottoms > depth + off)
        if crossing.any():
            n = int(crossing.argmax())
            raise ValueError(
                f"{names[n]} must lie within one layer, got depths from "
                f"{quantity(float(tops[n]), 'm')} to {quantity(float(bottoms[n]), 'm')} across "
                f"the bottom of layers[{number}] at {quantity(depth, 'm')}: move the inclusion, "
                "make it smaller, or split it at the interface"
            )

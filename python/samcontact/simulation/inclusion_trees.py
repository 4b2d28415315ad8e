# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of heterogeneous bodies to trees of plain data for checkpoints, and back."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ..bodies.heterogeneous import Heterogeneous
from ..bodies.inclusion import Inclusion
from ..bodies.layers import Layered
from ..bodies.material import Material
from ..bodies.voxels import VoxelBlock
from ..restart.tree import Tree, array

_SIZES = (3, 3, 9, 6)
"""Numbers of values for centre, radii, axes and misfit in a row that describes an inclusion; the
last value of the row is the index of its material."""
_VOID = -1


def tree_of(body: Heterogeneous, tree_of_part: Callable[[Material | Layered], Tree]) -> Tree:
    """Convert a body to a tree; `tree_of_part` converts each of its materials."""
    materials = [m for m in dict.fromkeys(body.phases) if m is not None]

    def index(material: Material | None) -> int:
        return _VOID if material is None else materials.index(material)

    tree: Tree = {
        "law": body.law,
        "matrix": tree_of_part(body.matrix),
        "materials": {str(n): tree_of_part(m) for n, m in enumerate(materials)} or None,
    }
    if body.inclusions:
        tree["inclusions"] = np.array(
            [
                [*one.center, *one.radii, *np.ravel(one.axes), *one.misfit, index(one.material)]
                for one in body.inclusions
            ]
        )
    if body.measured is not None:
        block = body.measured
        tree["voxels"] = {
            "labels": np.asarray(block.labels, dtype=np.float64),
            "are_shares": block.labels.dtype.kind == "f",
            "size": list(block.size),
            "origin": list(block.origin),
            "materials": [index(material) for material in block.materials],
        }
    return tree


def body_of(
    part: Tree, material: Callable[[Tree], Material], matrix: Material | Layered
) -> Heterogeneous:
    """Convert a tree back to a body with this matrix; `material` converts the others."""
    known = part.get("materials", {})
    materials = [material(known[n]) for n in sorted(known, key=int)]

    def at(number: float) -> Material | None:
        if not -1 <= number < len(materials):
            raise ValueError(
                f"checkpoint must contain material {number:g}, to which an inclusion refers"
            )
        return None if number == _VOID else materials[int(number)]

    inclusions = []
    if "inclusions" in part:
        for row in array(part, "inclusions", (None, sum(_SIZES) + 1)):
            center, radii, axes, misfit, number = np.split(row, np.cumsum(_SIZES))
            inclusions.append(
                Inclusion(center, radii, axes.reshape(3, 3), at(number.item()), misfit)
            )
    measured = None
    if "voxels" in part:
        block = part["voxels"]
        labels = array(block, "labels", (None, None, None))
        if not block["are_shares"]:
            labels = labels.astype(np.int32)
        measured = VoxelBlock(
            [at(number) for number in np.atleast_1d(block["materials"])],
            labels,
            block["size"],
            block["origin"],
        )
    return Heterogeneous(matrix, inclusions, measured)


def is_heterogeneous(part: Any) -> bool:
    """Whether a tree describes a heterogeneous body."""
    return bool(part["law"] == Heterogeneous.law)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of a grid with properties mixed from those of a matrix and its inclusions."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from .._util import memory
from .inclusion import NO_MISFIT, Inclusion
from .inclusion_cells import InclusionCells, VolumeGrid, blocks_on, box_of, voxels_on
from .material import Material
from .phase_mixing import Mixture, relative_phase
from .voxels import VoxelBlock

_BYTES_PER_CELL = 400.0  # of the box of all inclusions, while its cells are mixed


def mixed_cells(
    grid: VolumeGrid,
    around: Sequence[Material],
    inclusions: Sequence[Inclusion],
    measured: VoxelBlock | None,
) -> InclusionCells:
    """Return the mixed cells in the smallest box that contains all inclusions and voxels.

    around: material of the matrix around each phase, in the order of `Heterogeneous.phases`: each
    inclusion, then the voxels with label 1, 2, ...
    """
    box = box_of(grid, inclusions, measured)
    memory.require(
        f"a box of {' x '.join(map(str, box.shape))} cells around the inclusions",
        _BYTES_PER_CELL * math.prod(box.shape),
        "use larger cells or fewer inclusions",
    )
    phases = [inclusion.material for inclusion in inclusions]
    misfits = [inclusion.misfit for inclusion in inclusions]
    if measured is not None:
        phases += measured.materials
        misfits += [NO_MISFIT] * len(measured.materials)
    relative = [relative_phase(*each) for each in zip(around, phases, misfits, strict=True)]
    mixture = Mixture(box.shape, expands=any(phase.expansion for phase in relative))
    if measured is not None:
        for number, where, share in voxels_on(grid, box, measured):
            at = len(inclusions) + number
            mixture.add(at, where, share, relative[at])
    for number, where, share in blocks_on(grid, box, inclusions):
        mixture.add(number, where, share, relative[number])
    return _cells(box.first, mixture, phases)


def _cells(
    first: tuple[int, int, int], mixture: Mixture, phases: Sequence[Material | None]
) -> InclusionCells:
    """Return the cells of a mixture, together with the distinct materials of the inclusions."""
    laws = tuple(dict.fromkeys(phases))
    of_phase = np.array([*(laws.index(material) for material in phases), -1], dtype=np.int32)
    law = of_phase[mixture.phase]  # phase -1 is the last entry
    fields = (mixture.bulk.mixed(), mixture.shear.mixed(), mixture.misfit())
    expansion = mixture.expansion()
    for field in (mixture.share, mixture.phase, *fields, law, expansion):
        field.flags.writeable = False
    return InclusionCells(first, laws, mixture.share, mixture.phase, *fields, law, expansion)

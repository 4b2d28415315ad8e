# SPDX-License-Identifier: GPL-3.0-or-later
"""Work of the tangential force in increments at the end of which the whole contact slides."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from .._util.checks import FloatArray
from ..problem.friction import FrictionLaw
from ..solutions.state import State

SHARE_OF_END = 0.6
"""Mean over the motion of a force 1 - (1 - x)^1.5, where the motion x grows from 0 to 1."""


def correction_of_sliding(law: FrictionLaw, states: Sequence[State]) -> FloatArray:
    """Return corrections of the work of the tangential force, by increment [J].

    A correction is the work minus an estimate: the motion times the mean of the forces at the start
    and at the end.
    It is zero in increments at whose end some cells stick. In the other increments, the contact
    first follows the law of Mindlin & Deresiewicz (1953) for balls under constant load: the force
    approaches the friction limit as 1 - (1 - x)^(3/2), where x is the completed fraction of this
    part of the motion. Then the contact slides by the smallest slip of all cells; the force is
    equal to the friction limit, which changes with the load.
    """
    if not law.sticks or law.prevents_slip:
        return np.zeros(len(states) - 1)
    return np.array([_correction(law, *pair) for pair in pairwise(states)])


def _correction(law: FrictionLaw, before: State, after: State) -> float:
    first, last = (np.array(state.tangential_load) for state in (before, after))
    size = float(np.hypot(*last))
    if size == 0.0 or np.any(after.sticking) or not np.any(after.in_contact):
        return 0.0
    along = last / size
    slip = np.tensordot(along, after.slip[:, after.in_contact], axes=1)
    slid = max(float(slip.min()), 0.0)
    if slid == 0.0:
        return 0.0
    motion = np.array(after.shift) - np.array(before.shift)
    sticking = motion - slid * along
    limits = [float(np.sum(law.bound(state.repulsion))) for state in (before, after)]
    share = slid / max(slid, float(motion @ along))
    fall = share * (limits[0] / limits[1] - 1.0) * last  # of the limit while the contact slides
    onset, mean = last + fall, last + 0.5 * fall
    work = mean @ along * slid + (SHARE_OF_END * onset + (1 - SHARE_OF_END) * first) @ sticking
    return float(work - 0.5 * (first + last) @ motion)

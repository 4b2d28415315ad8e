# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear of layered bodies: worn share of the top layer, and limits of this share."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence

from .._util.checks import FloatArray
from .._util.errors import WornCoatingWarning
from ..bodies.layered import Body, top_thickness
from .problem import WearProgress

MAX_WORN_SHARE = 0.2
"""Share of the thickness of a top layer that may wear without a warning [-]."""


def worn_shares(
    bodies: Sequence[Body], heights: Mapping[int, Sequence[FloatArray]], cycle: int
) -> tuple[float, ...]:
    """Return the maximum worn depth of each worn body relative to the thickness of its top layer.

    The share of a body without layers is 0. Raises ValueError if a top layer is worn through.
    """
    shares = []
    for number, rows in heights.items():
        thickness = top_thickness(bodies[number - 1])
        share = float((rows[0] - rows[-1]).max()) / thickness
        if share >= 1.0:
            raise ValueError(
                f"the top layer of body{number} must not be worn through, but in cycle {cycle} "
                f"wear exceeds its thickness of {thickness:.6g} m: use fewer cycles or repeats, or "
                "a thicker layer"
            )
        shares.append(share)
    return tuple(shares)


def warn_of_worn_coating(standing: WearProgress, *, stacklevel: int) -> bool:
    """Warn if more than `MAX_WORN_SHARE` of a top layer is worn; return True after a warning."""
    last = standing.cycles[-1]
    shares = zip(standing.heights, last.coating_worn_share, strict=True)
    worn = {body: share for body, share in shares if share > MAX_WORN_SHARE}
    if worn:
        listed = " and ".join(f"{share:.0%} on body {body}" for body, share in worn.items())
        warnings.warn(
            f"wear exceeds {MAX_WORN_SHARE:.0%} of the thickness of the top layer: it reaches "
            f"{listed} after cycle {last.number}, but displacement and stress are computed with "
            "the initial thickness; for larger wear, repeat the run with a thinner top layer",
            WornCoatingWarning,
            stacklevel=stacklevel + 1,
        )
    return bool(worn)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Plausibility checks of the sizes and slopes of measured heights."""

from __future__ import annotations

import warnings

import numpy as np

from .._util.checks import FloatArray
from .._util.display import lengths, quantity
from .._util.errors import UnitWarning

MAX_LENGTH = 1.0
"""Maximum length of a measured area [m]."""
MAX_RMS_SLOPE = 2.0
"""Maximum plausible rms slope [-]; instruments measure local slopes up to about 70 degrees."""


def warn_of_size(
    heights: FloatArray, steps: tuple[float, float], source: str, *, stacklevel: int
) -> None:
    """Warn if the unit of heights or sample spacings is probably wrong.

    heights: shape (nx, ny) [m], NaN where undefined; steps: sample spacing along x and y [m].
    Issues a UnitWarning if the measured area is longer than 1 m, the rms slope is above 2, or the
    height range exceeds the longer side of the area.
    """
    size = [n * step for n, step in zip(heights.shape, steps, strict=True)]
    sides = size[:1] if heights.shape[1] == 1 else size
    known = heights[np.isfinite(heights)]
    span = float(np.ptp(known)) if known.size else 0.0
    slope = _rms_slope(heights, steps)
    findings = []
    if max(sides) > MAX_LENGTH:
        findings.append(f"its area is longer than {MAX_LENGTH:g} m")
    if slope > MAX_RMS_SLOPE:
        findings.append(f"its rms slope is {slope:.3g}")
    if span > max(sides):
        findings.append("its height range exceeds its length")
    if not findings:
        return
    over = lengths(*sides) if len(sides) == 2 else quantity(sides[0], "m")
    warnings.warn(
        f"likely unit error: {source} has a height range of {quantity(span, 'm')} over {over}, and "
        f"{' and '.join(findings)}: check the units of heights and steps",
        UnitWarning,
        stacklevel=stacklevel + 1,
    )


def _rms_slope(heights: FloatArray, steps: tuple[float, float]) -> float:
    """Return the rms slope between neighbouring samples [-], along x and y together."""
    total = 0.0
    with np.errstate(over="ignore", invalid="ignore"):
        for axis, step in enumerate(steps):
            slopes = np.diff(heights, axis=axis) / step
            known = slopes[np.isfinite(slopes)]
            if known.size:
                total += float(np.mean(known**2))
    return float(np.sqrt(total))

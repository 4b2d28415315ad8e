# SPDX-License-Identifier: GPL-3.0-or-later
"""What helps where the contact of a gap that is known on one grid only touches the border."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._util.display import quantity

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..diagnostics.hertz_estimate import ContactSetup

GROWS = "the grid grows by itself where the gap is a function of it"
"""What helps where it does not."""
_TILTED = 0.5  # of the other heights, from which on a plane is the reason
_ROUNDING = 1e-12  # of the largest height, up to which a rise is none
_REPEAT = 'let it repeat itself with Grid(..., periodic="xy")'
_REMEDY = ": enlarge "
_ASK = ', or set on_border="warn"'


def told_of_fixed(error: ValueError, scene: ContactSetup) -> None:
    """Add to a GridTooSmallError what helps an array as gap: a measured one cannot be enlarged."""
    error.args = (f"{advised(str(error), scene, _ASK)}; {GROWS}",)


def advised(text: str, scene: ContactSetup, ask: str = "") -> str:
    """A complaint of the border with what helps an array as gap.

    ask: what helps any, which stands in the complaint already.
    """
    before, _, remedy = text.partition(_REMEDY)
    if scene.radii is not None or not remedy:
        return text
    if tilt := _tilt(scene.gap):
        return (
            f'{before}. The gap is tilted, {tilt}: level a measured surface with detrend="height"'
            f"{ask}"
        )
    if "covers" in before:
        return (
            f"{before}: a surface that touches everywhere does so on a larger grid too; "
            f"{_REPEAT}{ask}"
        )
    return (
        f'{text}; of a measured surface take the shape off with detrend="curvature", or {_REPEAT}'
    )


def _tilt(gap: FloatArray) -> str:
    """By how much the plane through a gap rises over the grid, where its heights are mostly that;
    else nothing."""
    body = np.isfinite(gap)
    axes = np.meshgrid(*(np.linspace(-0.5, 0.5, n) for n in gap.shape), indexing="ij")
    places = [np.ones(int(body.sum())), *(axis[body] for axis in axes)]
    basis = np.stack(places, axis=1)
    found = np.linalg.lstsq(basis, gap[body], rcond=None)[0]
    others = float(np.ptp(gap[body] - basis @ found))
    rises = [
        abs(float(rise)) if n > 1 else 0.0 for rise, n in zip(found[1:], gap.shape, strict=True)
    ]
    if max(rises) <= max(_TILTED * others, _ROUNDING * float(np.abs(gap[body]).max())):
        return ""
    along = " and ".join(
        f"{quantity(rise, 'm')} along {axis}"
        for rise, axis in zip(rises, "xy", strict=True)
        if rise > 0.1 * max(rises)
    )
    return f"by {along} beside other heights of {quantity(others, 'm')}"

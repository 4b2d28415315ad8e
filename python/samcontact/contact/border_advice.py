# SPDX-License-Identifier: GPL-3.0-or-later
"""Remedies if the contact reaches the edge of a grid that cannot be enlarged."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .._util.display import quantity
from ..bodies.free_faces import contact_strip

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..diagnostics.hertz_estimate import ContactSetup

ENLARGEMENT_HINT = "pass gap and reliefs as functions to enlarge the grid automatically"
"""Remedy if the grid is not enlarged because the gap or a relief is an array."""
_MIN_TILT_SHARE = 0.5  # minimum (rise of the mean plane)/(other heights) for tilt as the cause
_ROUNDING_ERROR = 1e-12  # maximum rise/height that is attributed to rounding
_PERIODIC_HINT = 'make the surface periodic with Grid(..., periodic="xy")'
_REMEDY = ": enlarge "
_WARNING_HINT = ', or set on_border="warn"'


def add_border_remedies(error: ValueError, setup: ContactSetup) -> None:
    """Add remedies to a GridTooSmallError for a gap given as an array (fixed grid)."""
    error.args = (f"{advised(str(error), setup, _WARNING_HINT)}; {ENLARGEMENT_HINT}",)


def advised(text: str, setup: ContactSetup, second_remedy: str = "") -> str:
    """Return the message `text` about the grid edge, with remedies for a gap given as an array.

    The remedy in `text` may be replaced by a better one. Only in this case, `second_remedy`, which
    begins with a comma, is appended to the message.
    """
    before, _, remedy = text.partition(_REMEDY)
    if remedy and "normal to y" in before and (rows := _rows_beyond_faces(setup)):
        return f"{before}: {rows}{second_remedy}"
    if setup.radii is not None or not remedy:
        return text
    if tilt := _tilt(setup.gap):
        return (
            f'{before}. The gap is tilted {tilt}: level a measured surface with detrend="height"'
            f"{second_remedy}"
        )
    if "covers" in before:
        return (
            f"{before}: a surface in contact everywhere reaches the edge of any grid; "
            f"{_PERIODIC_HINT}{second_remedy}"
        )
    remedy = 'remove the shape of a measured surface with detrend="curvature"'
    end = (
        "" if np.isinf(setup.gap).any() else "; if a body ends there, set the gap to inf beyond it"
    )
    return f"{text}; {remedy}, or {_PERIODIC_HINT}{end}"


def _rows_beyond_faces(setup: ContactSetup) -> str:
    """Return a remedy if a nearby free face has no row of grid cells beyond it; otherwise ""."""
    grid, half = setup.grid, 0.5 * setup.grid.ny * setup.grid.dy
    reached = [
        face for face in contact_strip(setup.bodies)
        if half - 0.5 * grid.dy < abs(face) < 2.0 * half
    ]  # fmt: skip
    if not reached:
        return ""
    needed = max(math.ceil((abs(face) - half) / grid.dy - 1e-6) + 1 for face in reached)
    places = " and ".join(f"y = {quantity(face, 'm')}" for face in reached)
    return (
        f"the grid must contain a row of cells beyond the free face at {places}: use ny = "
        f"{grid.ny + 2 * needed} with dy = {quantity(grid.dy, 'm')}"
    )


def _tilt(gap: FloatArray) -> str:
    """Describe the tilt of a gap; "" if other heights exceed twice the rise due to this tilt."""
    body = np.isfinite(gap)
    axes = np.meshgrid(*(np.linspace(-0.5, 0.5, n) for n in gap.shape), indexing="ij")
    places = [np.ones(int(body.sum())), *(axis[body] for axis in axes)]
    basis = np.stack(places, axis=1)
    found = np.linalg.lstsq(basis, gap[body], rcond=None)[0]
    others = float(np.ptp(gap[body] - basis @ found))
    rises = [
        abs(float(rise)) if n > 1 else 0.0 for rise, n in zip(found[1:], gap.shape, strict=True)
    ]
    if max(rises) <= max(
        _MIN_TILT_SHARE * others, _ROUNDING_ERROR * float(np.abs(gap[body]).max())
    ):
        return ""
    along = " and ".join(
        f"{quantity(rise, 'm')} along {axis}"
        for rise, axis in zip(rises, "xy", strict=True)
        if rise > 0.1 * max(rises)
    )
    return f"by {along}, while its other heights span {quantity(others, 'm')}"

# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of standard deep groove ball bearings with their internal dimensions."""

from __future__ import annotations

from typing import NamedTuple

from .._util.checks import require_type
from .._util.short_text import in_short
from .bearing import Bearing


class StandardSize(NamedTuple):
    """Boundary dimensions (ISO 15) and internal dimensions of a deep groove bearing [mm]."""

    bore: float
    outside: float
    width: float
    balls: int
    ball_diameter: float
    pitch_diameter: float
    source: str


_ESTIMATED = (
    "estimated: the ball diameter from the static load rating of catalogues (about 18 kN), the "
    "pitch diameter as the mean of bore and outside diameter; conformities of ISO 76"
)
_RECORDS = "records of the Bearing Data Center, Case Western Reserve University"
SIZES = {
    "6203": StandardSize(17, 40, 12, 8, 6.746, 28.50, _RECORDS),
    "6205": StandardSize(25, 52, 15, 9, 7.940, 39.04, _RECORDS),
    "6208": StandardSize(40, 80, 18, 9, 12.0, 60.0, _ESTIMATED),
    "6209": StandardSize(45, 85, 19, 9, 12.7, 65.0, "209 in Harris, Rolling Bearing Analysis"),
}
"""Sizes by designation; manufacturers do not publish internal dimensions, which vary by maker."""


def standard(designation: str, clearance: float | None = None) -> Bearing:
    """Deep groove ball bearing of a standard size.

    Parameters
    ----------
    designation : {"6203", "6205", "6208", "6209"}
        Designation without suffixes.
    clearance : float, optional
        Diametral clearance of the mounted bearing [m]. Default: None, unknown.

    Returns
    -------
    Bearing
        Its attribute `source` states where the internal dimensions come from; those of 6208 are
        estimated. The conformities are those of ISO 76.

    Raises
    ------
    ValueError
        The designation is not in the table.
    """
    require_type("designation", designation, str)
    if designation not in SIZES:
        raise ValueError(
            f"designation must be one of {', '.join(SIZES)}, got {in_short(designation)}: create a "
            "Bearing from the dimensions of another one"
        )
    size = SIZES[designation]
    return Bearing(
        "deep_groove", size.ball_diameter * 1e-3, size.pitch_diameter * 1e-3, size.balls,
        clearance=clearance, source=size.source,
    )  # fmt: skip

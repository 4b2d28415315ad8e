# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of standard deep groove ball bearings with their internal dimensions."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from .._util.checks import positive
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
"""Sizes by designation. Internal dimensions vary between makers, who do not publish them."""


_SUFFIXES = (
    "2?RS[12RHL]?", "2?ZR?|2?RZ|ZZ|LL[BHU]|DDU?|VV",  # seals and shields
    "NR?", "C[2345NM]", "P[0456]", "M[AB]?|JN?|TN[9H]?", "S[01]",
)  # fmt: skip
"""Suffixes that do not affect the internal dimensions: seals, shields, snap ring, clearance and
tolerance class, cage, and heat treatment."""
_DESIGNATION = re.compile(rf"(\d{{4}})((?:[-/ .]*(?:{'|'.join(_SUFFIXES)})(?![A-Z0-9]))*)", re.I)


def _size_of(designation: str | int) -> StandardSize:
    """Return the dimensions for a designation; known suffixes are ignored."""
    text = str(designation) if type(designation) is int else designation
    if not isinstance(text, str):
        raise TypeError(f'designation must be text, e.g. "6208", got {in_short(designation)}')
    match = _DESIGNATION.fullmatch(text.strip())
    if match is not None and match[1] in SIZES:
        return SIZES[match[1]]
    hint = "for other bearings, create a Bearing from the dimensions"
    if match is None and text.strip()[:4] in SIZES:
        hint = "the suffix is unknown; omit it if it does not affect the internal dimensions"
    raise ValueError(
        f"designation must be one of {', '.join(SIZES)}, got {in_short(designation)}: {hint}"
    )


def standard(designation: str | int, clearance: float | None = None) -> Bearing:
    """Deep groove ball bearing of a standard size.

    Parameters
    ----------
    designation : {"6203", "6205", "6208", "6209"}
        Designation, as text or number. Suffixes for seals, shields, snap rings, cages, clearance
        classes and tolerance classes are ignored: "6208-2RS1/C3" is read as "6208".
    clearance : float, optional
        Diametral clearance of the mounted bearing [m]. Default: None, unknown.

    Returns
    -------
    Bearing
        Its attribute `source` states where the internal dimensions come from; the dimensions of
        6208 are estimated. The conformities are the values of ISO 76.

    Raises
    ------
    ValueError
        The designation is not in the table, or has an unknown suffix.
    TypeError
        The designation is neither text nor a whole number.
    """
    size = _size_of(designation)
    return Bearing(
        "deep_groove", size.ball_diameter * 1e-3, size.pitch_diameter * 1e-3, size.balls,
        clearance=clearance, source=size.source,
    )  # fmt: skip


def from_boundary(bore: float, outside_diameter: float, clearance: float | None = None) -> Bearing:
    """Deep groove ball bearing with internal dimensions estimated from its boundary dimensions.

    The pitch diameter is the mean of bore and outside diameter. The ball diameter is 0.3 times the
    difference between outside diameter and bore. The number of balls is one more than the number
    that fills half of the pitch circle (Conrad assembly). For the sizes of `standard`, the static
    load rating of the estimated bearing differs from catalogues by less than 10 %.

    Parameters
    ----------
    bore, outside_diameter : float
        Boundary dimensions [m].
    clearance : float, optional
        Diametral clearance of the mounted bearing [m]. Default: None, unknown.

    Returns
    -------
    Bearing

    Raises
    ------
    ValueError
        An argument is outside its range, e.g. bore >= outside_diameter.
    """
    inner, outer = positive("bore", bore), positive("outside_diameter", outside_diameter)
    if not 0.1 * outer <= inner <= 0.9 * outer:
        raise ValueError(
            f"bore must be 0.1 to 0.9 times outside_diameter = {outer!r} m, got {inner!r} m"
        )
    pitch, diameter = 0.5 * (inner + outer), 0.3 * (outer - inner)
    balls = round(1.0 + math.radians(93.0) / math.asin(diameter / pitch))
    source = "estimated from bore and outside diameter; conformities of ISO 76"
    return Bearing("deep_groove", diameter, pitch, balls, clearance=clearance, source=source)

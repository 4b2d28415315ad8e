# SPDX-License-Identifier: GPL-3.0-or-later
"""Normal drive of a contact: load or approach, and moments or tilts about x and y."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from .. import _core
from .._util.checks import number
from .._util.short_text import in_short
from .tangential_drive import pair_of

UNTILTED = 0.0, 0.0
MAX_TILT = 0.1
"""Maximum tilt [rad] at which rotations are still small."""


class NormalDrive(NamedTuple):
    """Prescribed load or approach, and for each of the axes x and y a moment or a tilt."""

    name: str
    """"load" or "approach"."""
    value: float
    is_moment: tuple[bool, bool] = (False, False)
    about: tuple[float, float] = UNTILTED
    """Moments [N m] or tilts [rad] about x and y."""
    spring: float = 0.0
    """Compliance of the machine that prescribes the approach [m/N]."""

    @classmethod
    def of(
        cls,
        name: str,
        value: float | None,
        moment: Sequence[float | None] | None = None,
        tilt: Sequence[float | None] | None = None,
        held: Sequence[float] = UNTILTED,
        spring: float = 0.0,
    ) -> NormalDrive:
        """Check and combine the arguments.

        name: "load" or "approach". held: tilts [rad] about x and y, which apply to an axis for
        which neither moment nor tilt is given. spring: compliance of the machine [m/N].
        """
        value = number(name, value)
        if moment is None and tilt is None:
            return cls(name, value, about=(float(held[0]), float(held[1])), spring=spring)
        moments, tilts = pair_of("moment", moment, "about"), pair_of("tilt", tilt, "about")
        about = []
        for axis, m, t, present in zip("xy", moments, tilts, held, strict=True):
            if m is not None and t is not None:
                raise ValueError(
                    f"moment and tilt about {axis} cannot both be given, got {m!r} and {t!r}, "
                    "because the tilt follows from the moment: set one of them to None"
                )
            if t is not None and abs(t) > MAX_TILT:
                raise ValueError(
                    f"tilt about {axis} must be between {-MAX_TILT} and {MAX_TILT} rad, got {t!r}: "
                    "convert degrees to radians, or reduce the tilt"
                )
            about.append(m if m is not None else float(present) if t is None else t)
        is_moment = moments[0] is not None, moments[1] is not None
        if name == "approach" and any(is_moment):
            raise ValueError(
                f"moment cannot be combined with approach, got {in_short(moment)}: prescribe load "
                "and moment, or approach and tilt"
            )
        if (name, value) == ("load", 0.0) and not any(moments):
            # separated bodies keep their tilt
            is_moment = False, False
            about = [about[k] if moments[k] is None else float(held[k]) for k in range(2)]
        return cls(name, value, is_moment, (about[0], about[1]), spring)

    @property
    def target(self) -> dict[str, float]:
        """Load or approach, as a dictionary with one entry."""
        return {self.name: self.value}

    @property
    def tilts(self) -> bool:
        """Whether a moment is given, or a tilt other than zero."""
        return any(self.is_moment) or self.about != UNTILTED

    def to_core(self) -> _core.Drive:
        """Return the drive as an object of the compiled core."""
        return _core.Drive(self.name == "load", self.value, self.is_moment, self.about, self.spring)

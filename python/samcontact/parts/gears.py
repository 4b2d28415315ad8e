# SPDX-License-Identifier: GPL-3.0-or-later
"""Flanks of a pair of spur gears along their line of action."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import hertz
from .._util.cached_property import cached_property
from .._util.checks import FloatArray, choice, finite, integer, non_negative, number, positive
from .._util.short_text import in_short
from ..surfaces import SurfaceGrid, require_surface
from .involute import Flank, involute, involute_angle

_PAIRS = ("teeth", "profile_shift", "tip_relief", "tip_diameter", "relief_length")
_OPTIONAL_PAIRS = _PAIRS[3:]
SHARING = ("equal", "linear")
MAX_MODULE = 0.5
"""Maximum module [m]; larger gears are not made."""


@dataclass(frozen=True)
class GearPair:
    """Pair of external involute spur gears (helix angle 0) without backlash.

    Gear 1 drives. A position is given as a distance from the pitch point along the line of action
    [m], negative before the pitch point. Alternatively, it is one of the letters "A" (start of
    contact), "B" (start of single contact), "C" (pitch point), "D" (end of single contact) and "E"
    (end of contact).

    Parameters
    ----------
    module : float
        Module [m], > 0.
    teeth : pair of int
        Numbers of teeth of gears 1 and 2.
    face_width : float
        Common face width [m], > 0.
    pressure_angle : float, optional
        Pressure angle of the basic rack [rad], 20 degrees by default.
    profile_shift : pair of float, optional
        Profile shift coefficients x1 and x2 [-].
    centre_distance : float, optional
        Distance between the axes [m]. Default: the distance without backlash.
    tip_diameter : pair of float, optional
        Tip diameters [m]. Default: the module times (z + 2 + 2 x), for z teeth and the profile
        shift coefficient x.
    crowning : float, optional
        Depth of the parabolic crowning at the ends of the face, summed over both flanks [m], >= 0.
    tip_relief : pair of float, optional
        Depths of the tip reliefs at the tips of gears 1 and 2 [m], >= 0.
    relief_length : pair of float, optional
        Lengths of the tip reliefs along the line of action [m]. Default: the length of double
        contact, so that the relief begins at D for gear 1 and at B for gear 2.
    relief_exponent : float, optional
        Exponent n of the tip relief, which grows with the n-th power of the distance from its
        start; 1 (linear, default) to 4.

    Raises
    ------
    ValueError
        An argument is outside its range, the teeth interfere, or the contact ratio is not in
        [1, 2).

    Notes
    -----
    Geometry and names as in DIN 3960 and ISO 21771. Deformation of the teeth, errors of the pitch
    and shaft misalignment are not modelled.
    """

    module: float
    teeth: Sequence[int]
    face_width: float
    pressure_angle: float = math.radians(20.0)
    profile_shift: Sequence[float] = (0.0, 0.0)
    centre_distance: float | None = None
    tip_diameter: Sequence[float] | None = None
    crowning: float = 0.0
    tip_relief: Sequence[float] = (0.0, 0.0)
    relief_length: Sequence[float] | None = None
    relief_exponent: float = 1.0

    def __post_init__(self) -> None:
        for name in _PAIRS:
            if name not in _OPTIONAL_PAIRS or getattr(self, name) is not None:
                object.__setattr__(self, name, _pair(name, getattr(self, name)))
        for z in self.teeth:
            integer("teeth", z, 4, 100_000)
        for name in ("module", "face_width"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        object.__setattr__(self, "crowning", non_negative("crowning", self.crowning))
        self._require_metres()
        angle = finite("pressure_angle", self.pressure_angle)
        if not 0.05 <= angle <= 0.8:
            hint = ": degrees instead of radians?" if angle > 1.0 else ""
            raise ValueError(f"pressure_angle must be in [0.05, 0.8] rad, got {angle!r}{hint}")
        for shift in self.profile_shift:
            if not -2.0 <= finite("profile_shift", shift) <= 2.0:
                raise ValueError(f"profile_shift must be in [-2, 2], got {shift!r}")
        for name in ("tip_diameter", "relief_length"):
            for value in getattr(self, name) or ():
                positive(name, value)
        for value in self.tip_relief:
            non_negative("tip_relief", value)
        if not 1.0 <= number("relief_exponent", self.relief_exponent) <= 4.0:
            raise ValueError(f"relief_exponent must be in [1, 4], got {self.relief_exponent!r}")
        self._require_contact()

    def _require_metres(self) -> None:
        """Raise ValueError for lengths that are probably in millimetres or micrometres."""
        hint = "millimetres or micrometres instead of metres?"
        if self.module > MAX_MODULE:
            raise ValueError(
                f"module must be at most {MAX_MODULE:g} m, got {self.module!r} m: {hint}"
            )
        tips = self.tip_diameter or ()
        for name, limit, values in (
            ("crowning", self.module, (self.crowning,)),
            ("tip_relief", self.module, self.tip_relief),
            ("tip_diameter", 2.0 * self.module * (max(self.teeth) + 10), tips),
        ):
            for value in values:
                if value > limit:
                    raise ValueError(
                        f"{name} must be at most {limit:.3g} m for a module of {self.module!r} m, "
                        f"got {value!r} m: {hint}"
                    )

    def _require_contact(self) -> None:
        self._require_centre_distance()
        for gear, tip, base in zip((1, 2), self.tip_radii, self.base_radii, strict=True):
            if tip <= base:
                raise ValueError(
                    f"tip_diameter must exceed the diameter of the base circle of gear {gear}, "
                    f"{2.0 * base!r} m, got {2.0 * tip!r} m"
                )
        start, end = self._ends
        if start <= 0.0 or end >= self._length:
            gear = 1 if start <= 0.0 else 2
            raise ValueError(
                f"the contact on the teeth of gear {gear} must not extend below the base circle, "
                f"got teeth = {self.teeth!r} and profile_shift = {self.profile_shift!r}: use more "
                "teeth, or a larger profile_shift"
            )
        if not 1.0 <= self.contact_ratio < 2.0:
            raise ValueError(
                "teeth, profile_shift, tip_diameter and centre_distance must give a contact ratio "
                f"in [1, 2), got {self.contact_ratio:.4g}"
            )

    def _require_centre_distance(self) -> None:
        if self.centre_distance is None:
            value = involute(self.pressure_angle) + 2.0 * math.tan(self.pressure_angle) * sum(
                self.profile_shift
            ) / sum(self.teeth)
            if value <= 0.0:
                raise ValueError(
                    "profile_shift must give a working pressure angle > 0, got "
                    f"{self.profile_shift!r}: use a larger sum of the profile shifts"
                )
            distance = sum(self.base_radii) / math.cos(involute_angle(value))
            object.__setattr__(self, "centre_distance", distance)
        elif positive("centre_distance", self.centre_distance) <= sum(self.base_radii):
            raise ValueError(
                "centre_distance must exceed the sum of the base radii, "
                f"{sum(self.base_radii)!r} m, got {self.centre_distance!r} m"
            )

    @property
    def ratio(self) -> float:
        """Gear ratio z2/z1 [-]."""
        return self.teeth[1] / self.teeth[0]

    @property
    def base_radii(self) -> tuple[float, float]:
        """Radii of the base circles [m]."""
        half = 0.5 * self.module * math.cos(self.pressure_angle)
        return half * self.teeth[0], half * self.teeth[1]

    @property
    def tip_radii(self) -> tuple[float, float]:
        """Radii of the tip circles [m]."""
        if self.tip_diameter is not None:
            return 0.5 * self.tip_diameter[0], 0.5 * self.tip_diameter[1]
        first, second = (
            0.5 * self.module * (z + 2.0 + 2.0 * x)
            for z, x in zip(self.teeth, self.profile_shift, strict=True)
        )
        return first, second

    @property
    def working_pressure_angle(self) -> float:
        """Angle between the line of action and the common tangent of the pitch circles [rad]."""
        return math.acos(sum(self.base_radii) / self._distance)

    @property
    def base_pitch(self) -> float:
        """Distance between successive flanks of a gear along the line of action [m]."""
        return math.pi * self.module * math.cos(self.pressure_angle)

    @property
    def contact_ratio(self) -> float:
        """Transverse contact ratio, mean number of tooth pairs in contact [-]."""
        start, end = self._ends
        return (end - start) / self.base_pitch

    @cached_property
    def points(self) -> dict[str, float]:
        """Positions of the points A to E of the line of action [m]."""
        pitch_point = self.base_radii[0] * math.tan(self.working_pressure_angle)
        start, end = (radius - pitch_point for radius in self._ends)
        pitch = self.base_pitch
        return {"A": start, "B": end - pitch, "C": 0.0, "D": start + pitch, "E": end}

    def at(self, position: float | str = "C") -> FlankContact:
        """Contact of two flanks at a position on the line of action.

        position: distance from the pitch point [m], or a letter from "A" to "E".
        """
        p = self.points
        if isinstance(position, str):
            where = p[choice("position", position, tuple(p))]
        else:
            where = finite("position", position)
        if not p["A"] <= where <= p["E"]:
            raise ValueError(
                f"position must be between A = {p['A']!r} m and E = {p['E']!r} m, got "
                f"{in_short(position)}"
            )
        first = self.base_radii[0] * math.tan(self.working_pressure_angle) + where
        return FlankContact(self, where, (first, self._length - first))

    def surface(self, grid: SurfaceGrid, position: float | str = "C") -> FloatArray:
        """Gap between the flanks at a position: see `FlankContact.surface`."""
        return self.at(position).surface(grid)

    @property
    def _distance(self) -> float:
        assert self.centre_distance is not None
        return self.centre_distance

    @property
    def _length(self) -> float:
        """Length of the line of action between the base circles [m]."""
        return self._distance * math.sin(self.working_pressure_angle)

    @property
    def _ends(self) -> tuple[float, float]:
        """Radii of curvature of the flank of gear 1 at the start and the end of contact [m]."""
        first, second = (
            math.sqrt(tip**2 - base**2)
            for tip, base in zip(self.tip_radii, self.base_radii, strict=True)
        )
        return self._length - second, first


@dataclass(frozen=True)
class FlankContact:
    """Contact of the flanks of a `GearPair` at one position, from `GearPair.at`.

    Attributes
    ----------
    pair : GearPair
    position : float
        Distance from the pitch point along the line of action [m].
    radii : pair of float
        Radii of curvature of the flanks of gears 1 and 2 [m].
    """

    pair: GearPair
    position: float
    radii: tuple[float, float]

    @property
    def radius(self) -> float:
        """Equivalent radius of curvature [m]."""
        first, second = self.radii
        return first * second / (first + second)

    @property
    def slide_to_roll(self) -> float:
        """Sliding speed divided by the entraining speed [-]; negative before the pitch point."""
        first, second = self.speeds(1.0)
        return 2.0 * (first - second) / (first + second)

    def speeds(self, speed: float) -> tuple[float, float]:
        """Speeds of the flanks of gears 1 and 2 relative to the contact [m/s].

        speed: angular speed of gear 1 [rad/s]. Half the sum of the two speeds is the entraining
        speed, and their difference is the sliding speed.
        """
        omega = finite("speed", speed)
        return omega * self.radii[0], omega / self.pair.ratio * self.radii[1]

    def load_share(self, sharing: str = "equal") -> float:
        """Fraction of the load on this tooth pair [-].

        The fraction is 1 between B and D. Elsewhere two tooth pairs share the load. "equal": the
        fraction is 1/2. "linear": it grows linearly from 1/3 at A to 2/3 at B, and from 1/3 at E to
        2/3 at D (AGMA 925-A03, profiles without relief).
        """
        choice("sharing", sharing, SHARING)
        at, p = self.position, self.pair.points
        rounding = 1e-9 * self.pair.base_pitch
        if p["B"] - rounding <= at <= p["D"] + rounding:
            return 1.0
        from_end = at - p["A"] if at < p["B"] else p["E"] - at
        return 0.5 if sharing == "equal" else (1.0 + from_end / (p["B"] - p["A"])) / 3.0

    def load(self, torque: float, sharing: str = "equal") -> float:
        """Normal load on this tooth pair [N].

        torque: torque of gear 1 [N m], >= 0. sharing: as in `load_share`.
        """
        force = non_negative("torque", torque) / self.pair.base_radii[0]
        return force * self.load_share(sharing)

    def hertz(self, torque: float, E_star: float, sharing: str = "equal") -> hertz.LineContact:
        """Hertz line contact of the flanks; crowning is neglected.

        torque: torque of gear 1 [N m], > 0. E_star: contact modulus [Pa]. sharing: as in
        `load_share`.
        """
        per_width = self.load(positive("torque", torque), sharing) / self.pair.face_width
        return hertz.line(self.radius, E_star, load_per_length=per_width)

    def surface(self, grid: SurfaceGrid) -> FloatArray:
        """Gap between the two flanks.

        x runs along the common tangent, towards the tip of gear 1 and the root of gear 2, so that
        the contact rolls towards +x on both flanks; y runs along the teeth. The gap follows the
        involutes, whose curvature varies along x. The flanks end at the tips, the base circles and
        the ends of the face.

        Parameters
        ----------
        grid : Grid
            Grid on which the gap is evaluated.

        Returns
        -------
        ndarray, shape (nx, ny)
            Gap [m], 0 at the origin; inf beyond the end of a flank.
        """
        require_surface(grid)
        x, y = np.asarray(grid.x), np.asarray(grid.y)
        first, second = (self._flank(gear) for gear in (0, 1))
        profile = first.depth(x) + second.depth(-x)
        along = y / (0.5 * self.pair.face_width)
        lead = np.where(np.abs(along) <= 1.0, self.pair.crowning * along**2, math.inf)
        return np.asarray(profile[:, None] + lead[None, :], dtype=np.float64)

    def _flank(self, gear: int) -> Flank:
        pair = self.pair
        base = pair.base_radii[gear]
        tip = math.sqrt(pair.tip_radii[gear] ** 2 - base**2)
        double = pair.points["E"] - pair.points["D"]
        length = double if pair.relief_length is None else pair.relief_length[gear]
        relief = (pair.tip_relief[gear], max(length, 1e-9 * tip), pair.relief_exponent)
        return Flank(base, self.radii[gear], tip, relief)


def _pair(name: str, values: Any) -> tuple[Any, Any]:
    """Return two numbers as a tuple."""
    listed = values.tolist() if isinstance(values, np.ndarray) else values
    if isinstance(listed, (list, tuple)) and len(listed) == 2:
        first, second = listed
        return _finite_or_int(name, first), _finite_or_int(name, second)
    raise ValueError(f"{name} must be a pair of numbers for gears 1 and 2, got {in_short(values)}")


def _finite_or_int(name: str, value: Any) -> Any:
    """Return a finite number unchanged; raise ValueError for anything else."""
    checked = finite(name, value)
    return value if isinstance(value, int) else checked

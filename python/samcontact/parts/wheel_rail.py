# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of a wheel and a rail with given profiles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite, positive
from ..surfaces import SurfaceGrid, require_surface
from .profiles import Profile

_POSITIONS = 2001
"""Number of points in the first search across the wheel, enough for the details of a profile."""
_LOCAL, _LEVELS = 65, 9
"""Number of points in each later, narrower search, and total number of searches."""
_SLOPE_STEPS = 12
_NEWTON_STEPS = 60


class WheelRail:
    """Contact point of a rigid wheel and a rigid rail, found by direct search, and gap around it.

    Coordinates are in the frame of the track: x along the rail, y across, z down. The wheel is a
    surface of revolution, the rail a prism. The contact is the point with the smallest vertical
    distance between wheel and rail. If there are several such points, the first one found is used.

    Parameters
    ----------
    rail : array_like, shape (n, 2)
        Points (y, z) of the head of the rail [m], ordered by y.
    wheel : array_like, shape (n, 2)
        Points (y, z) of the section of the wheel below its axis [m], ordered by y, in the same
        frame. z = 0 is the running circle.
    wheel_radius : float
        Radius of the running circle [m], > 0. At a point (y, z) of the section, the wheel has the
        radius `wheel_radius` + z.
    shift : float, optional
        Lateral shift of the wheel, towards +y [m].
    yaw : float, optional
        Rotation of the wheel about z [rad], from x to y, in [-0.1, 0.1].
    roll : float, optional
        Rotation of the wheel about an axis along x at the running circle [rad], from y to z, in
        [-0.1, 0.1].
    smoothing : float, optional
        Root-mean-square distance of smoothed profiles from measured points [m]. Default: 0, cubic
        splines through the points, whose curvature contains the scatter of measured points.

    Attributes
    ----------
    x, y : float
        Position of the contact in the frame of the track [m].
    y_wheel : float
        Position of the contact on the profile of the wheel [m].
    angle : float
        Contact angle [rad]: inclination of the tangent plane along y, positive if it falls towards
        +y.
    rolling_radius : float
        Radius of the wheel at the contact [m].
    separation : float
        Vertical distance by which the wheel is lowered until it touches [m].

    Raises
    ------
    ValueError
        An argument is outside its range, or the contact lies at the end of a profile.

    Notes
    -----
    The search treats the bodies as rigid, as in the geometric part of CONTACT (Vollebregt). Within
    the patch, the gap follows both profiles and is not approximated by radii.
    """

    def __init__(
        self,
        rail: ArrayLike,
        wheel: ArrayLike,
        wheel_radius: float,
        *,
        shift: float = 0.0,
        yaw: float = 0.0,
        roll: float = 0.0,
        smoothing: float = 0.0,
    ) -> None:
        self._pose = _Pose(
            positive("wheel_radius", wheel_radius),
            finite("shift", shift),
            _small("yaw", yaw),
            _small("roll", roll),
        )
        self._rail = Profile("rail", rail, smoothing)
        self._wheel = Profile("wheel", wheel, smoothing)
        for end in self._wheel.ends:
            if not abs(end) < self._pose.radius:
                raise ValueError(
                    f"wheel must have |y| < wheel_radius = {wheel_radius!r} m, got {end!r}: points "
                    "in mm instead of m?"
                )
        self.y_wheel, self._turn, self.separation = self._search()
        x, y, _ = self._points(np.array(self.y_wheel), np.array(self._turn))
        self.x, self.y = float(x), float(y)
        self.angle = math.atan(float(self._rail.at(y, 1)))
        self.rolling_radius = self._pose.radius + float(self._wheel.at(self.y_wheel))

    @property
    def radii(self) -> tuple[float, float]:
        """Equivalent radii along the rail and across it at the point of contact [m].

        The relative curvature across the rail may be zero or negative, which gives an infinite or
        negative radius. The bodies then touch along the profile, and Hertz theory does not apply.
        """
        across = self._rail.curvature(self.y) - self._wheel.curvature(self.y_wheel)
        # Meusnier: the normal is inclined to the plane of the running circle
        along = self.rolling_radius / math.cos(self.angle)
        return along, math.inf if across == 0.0 else 1.0 / across

    def surface(self, grid: SurfaceGrid) -> FloatArray:
        """Gap along the common normal at the contact.

        x runs along the rail, y across it in the tangent plane.

        Parameters
        ----------
        grid : Grid
            Grid on which the gap is evaluated.

        Returns
        -------
        ndarray, shape (nx, ny)
            Gap [m], 0 at the origin; inf beyond the end of a profile.
        """
        require_surface(grid)
        x, v = np.asarray(grid.x)[:, None], np.asarray(grid.y)[None, :]
        return np.asarray(self._rail_below(v) - self._wheel_below(x, v), dtype=np.float64)

    def __repr__(self) -> str:
        return (
            f"WheelRail(y={self.y:.6g} m, angle={self.angle:.4g} rad, "
            f"rolling_radius={self.rolling_radius:.6g} m)"
        )

    def _points(self, s: FloatArray, turn: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return points (x, y, z) of the surface of the wheel in the frame of the track [m].

        s: positions on the profile of the wheel [m]. turn: angles about the wheel axis [rad].
        """
        r = self._pose.radius + self._wheel.at(s)
        sagged = r * np.cos(turn) - self._pose.radius
        return self._pose.to_track(r * np.sin(turn), s + 0.0 * turn, sagged)

    def _search(self) -> tuple[float, float, float]:
        """Return the position on the wheel, the angle about its axis, and the vertical distance.

        These values are those of the point with the smallest vertical distance from the rail.
        """
        low, high = self._wheel.ends
        centre, half, count = 0.5 * (low + high), 0.5 * (high - low), _POSITIONS
        best = (0.0, 0.0, math.inf)
        for _ in range(_LEVELS):
            s = np.clip(centre + half * np.linspace(-1.0, 1.0, count), low, high)
            turn = self._lowest(s)
            _, y, z = self._points(s, turn)
            gap = np.where(self._rail.holds(y), self._rail.at(y) - z, math.inf)
            i = int(np.argmin(gap))
            if not math.isfinite(gap[i]):
                raise ValueError(
                    "shift must leave part of the wheel above the rail, got "
                    f"{self._pose.shift!r} m, at which no part is: check that both profiles are "
                    "given in the same frame, in metres"
                )
            best = (float(s[i]), float(turn[i]), float(gap[i]))
            centre, half, count = best[0], 8.0 * half / (count - 1), _LOCAL  # four points each side
        self._require_inside(best)
        return best

    def _lowest(self, s: FloatArray) -> FloatArray:
        """Angles about the axis at which circles of the wheel are nearest to the rail [rad].

        At these angles, the vertical distance is stationary. This condition contains the slope of
        the rail, which varies little with the angle; it is solved by fixed-point iteration.
        """
        pose, turn = self._pose, np.zeros_like(s)
        tilted = math.cos(pose.yaw) * math.sin(pose.roll)
        for _ in range(_SLOPE_STEPS):
            slope = self._rail.at(self._points(s, turn)[1], 1)
            turn = np.arctan(-slope * math.sin(pose.yaw) / (math.cos(pose.roll) + slope * tilted))
        return turn

    def _require_inside(self, found: tuple[float, float, float]) -> None:
        s, turn, _ = found
        y = float(self._points(np.array(s), np.array(turn))[1])
        for profile, at in ((self._wheel, s), (self._rail, y)):
            low, high = profile.ends
            if min(at - low, high - at) < 1e-6 * (high - low):
                raise ValueError(
                    f"{profile.name} must extend beyond the contact, which lies at its end, y = "
                    f"{at:.6g} m: add points, or check shift = {self._pose.shift!r} m"
                )

    def _rail_below(self, v: FloatArray) -> FloatArray:
        """Distance of the rail surface from the tangent plane [m], positive into the rail."""
        sine, cosine = math.sin(self.angle), math.cos(self.angle)
        z0 = float(self._rail.at(self.y))
        h = np.zeros_like(v)
        for _ in range(_NEWTON_STEPS):
            y = self.y + v * cosine - h * sine
            error = z0 + v * sine + h * cosine - self._rail.at(y)
            step = error / (cosine + sine * self._rail.at(y, 1))
            h = h - step
            if np.max(np.abs(step)) < 1e-15:
                break
        return np.where(self._rail.holds(self.y + v * cosine - h * sine), h, math.inf)

    def _wheel_below(self, x: FloatArray, v: FloatArray) -> FloatArray:
        """Distance of the wheel surface from the tangent plane [m], positive towards the rail."""
        sine, cosine = math.sin(self.angle), math.cos(self.angle)
        start = self._points(np.array(self.y_wheel), np.array(self._turn))
        radius = self._pose.radius
        n = self._pose.to_wheel(0.0, -sine, cosine, turned_only=True)
        h = np.zeros(np.broadcast_shapes(x.shape, v.shape))
        for _ in range(_NEWTON_STEPS):
            here = (
                start[0] + x,
                start[1] + v * cosine - h * sine,
                start[2] + v * sine + h * cosine,
            )
            X, Y, Z = self._pose.to_wheel(*here)
            r = np.hypot(X, Z + radius)
            error = r - radius - self._wheel.at(Y)
            slope = (X * n[0] + (Z + radius) * n[2]) / r - self._wheel.at(Y, 1) * n[1]
            step = error / slope
            h = h - step
            if np.max(np.abs(step)) < 1e-15:
                break
        return np.where(self._wheel.holds(Y), h, -math.inf)


@dataclass(frozen=True)
class _Pose:
    """Position of a wheel in the frame of the track: radius and shift [m], yaw and roll [rad]."""

    radius: float
    shift: float
    yaw: float
    roll: float

    def to_track(
        self, x: FloatArray, y: FloatArray, z: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        c, s = math.cos(self.roll), math.sin(self.roll)
        y, z = c * y - s * z, s * y + c * z
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return c * x - s * y, s * x + c * y + self.shift, z

    def to_wheel(
        self, x: ArrayLike, y: ArrayLike, z: ArrayLike, turned_only: bool = False
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return points in the frame of the wheel, from coordinates in the frame of the track.

        turned_only: whether the input is a direction, which is rotated only, not shifted.
        """
        a, b = np.asarray(x), np.asarray(y) - (0.0 if turned_only else self.shift)
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        a, b = c * a + s * b, c * b - s * a
        c, s = math.cos(self.roll), math.sin(self.roll)
        return a, c * b + s * np.asarray(z), c * np.asarray(z) - s * b


def _small(name: str, angle: float) -> float:
    """Return an angle [rad] after checking that its magnitude is at most 0.1."""
    value = finite(name, angle)
    if abs(value) > 0.1:
        raise ValueError(f"{name} must be in [-0.1, 0.1] rad, got {angle!r}")
    return value

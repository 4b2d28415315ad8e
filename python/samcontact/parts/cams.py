# SPDX-License-Identifier: GPL-3.0-or-later
"""Cams on flat-faced tappets."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from .. import hertz
from .._util.checks import FloatArray, finite, finite_array, positive
from .._util.lazy_scipy import scipy
from .._util.short_text import in_short
from ..surfaces import SurfaceGrid, require_surface

_SAMPLES = 3601
"""Number of angles at which the curvature of a cam is checked and its profile is sampled."""

Lift = Callable[[FloatArray, int], FloatArray]
"""Function (angles [rad], order) that returns the lift [m] or its derivative of this order [m]."""


@dataclass(frozen=True)
class Cam:
    """Cam that gives a flat-faced translating tappet a prescribed lift.

    Create it by `eccentric`, `harmonic` or `table`. The lift is a function of the angle by which
    the cam has turned.

    Attributes
    ----------
    base_radius : float
        Radius of the base circle [m].
    lift : callable
        Function ``lift(angles, order)`` for angles in rad. It returns the lift (order 0), or its
        first or second derivative with respect to the angle (order 1 or 2) [m].
    """

    base_radius: float
    lift: Lift = field(repr=False)

    def __post_init__(self) -> None:
        positive("base_radius", self.base_radius)
        if not callable(self.lift):
            raise ValueError(f"lift must be a function, got {in_short(self.lift)}")
        angles = np.linspace(-math.pi, math.pi, _SAMPLES)
        radius = self.base_radius + self.lift(angles, 0) + self.lift(angles, 2)
        least = int(np.argmin(radius))
        if not radius[least] > 0.0:
            raise ValueError(
                "the radius of curvature of the cam, base_radius + lift + second derivative of "
                "lift, must be > 0 everywhere, because a flat tappet cannot follow a concave cam, "
                f"got {radius[least]:.6g} m at {angles[least]:.4g} rad: increase base_radius, or "
                "smooth the lift"
            )

    @classmethod
    def eccentric(cls, radius: float, eccentricity: float) -> Cam:
        """Circular cam that rotates about an eccentric axis.

        radius: radius of the circle [m]. eccentricity: distance between the centre of the circle
        and the axis of rotation [m], >= 0 and smaller than the radius. The lift is 0 at the angle
        0.
        """
        R, e = positive("radius", radius), finite("eccentricity", eccentricity)
        if not 0.0 <= e < R:
            raise ValueError(f"eccentricity must be in [0, radius = {R!r} m), got {e!r}")

        def lift(angle: FloatArray, order: int) -> FloatArray:
            return (e if order == 0 else 0.0) - e * np.cos(angle + 0.5 * math.pi * order)

        return cls(R - e, lift)

    @classmethod
    def harmonic(cls, base_radius: float, max_lift: float, duration: float) -> Cam:
        """Cam with the lift max_lift (1 + cos(2 pi angle/duration))/2 around the angle 0.

        base_radius, max_lift: in metres. duration: range of angles in which the cam lifts the
        tappet [rad], in (0, 2 pi]. The maximum lift is at the angle 0, the middle of this range.
        """
        height = positive("max_lift", max_lift)
        event = positive("duration", duration)
        if event > 2.0 * math.pi * (1.0 + 1e-12):
            hint = ": degrees instead of radians?" if event > 10.0 else ""
            raise ValueError(f"duration must be <= 2 pi rad, got {duration!r}{hint}")
        rate = 2.0 * math.pi / event

        def lift(angle: FloatArray, order: int) -> FloatArray:
            turn = np.mod(angle + math.pi, 2.0 * math.pi) - math.pi
            wave = rate**order * np.cos(rate * turn + 0.5 * math.pi * order)
            wave = wave + (1.0 if order == 0 else 0.0)
            return np.where(np.abs(turn) <= 0.5 * event, 0.5 * height * wave, 0.0)

        return cls(positive("base_radius", base_radius), lift)

    @classmethod
    def table(cls, base_radius: float, angle: ArrayLike, lift: ArrayLike) -> Cam:
        """Cam with a lift given by points, interpolated by a cubic spline.

        base_radius: in metres. angle: at least five increasing angles within one turn [rad]. lift:
        lift at these angles [m], >= 0, with 0 at the first and the last angle. The lift is 0 at all
        angles outside their range. The radius of curvature contains the second derivative of the
        lift: smooth measured lifts before use.
        """
        angles, lifts = finite_array("angle", angle), finite_array("lift", lift)
        if angles.ndim != 1 or angles.size < 5 or (np.diff(angles) <= 0.0).any():
            raise ValueError("angle must be a list of at least 5 increasing angles [rad]")
        if angles[-1] - angles[0] > 2.0 * math.pi * (1.0 + 1e-12):
            raise ValueError(
                "angle must lie within one turn, 2 pi rad, got a range of "
                f"{angles[-1] - angles[0]:.6g}: degrees instead of radians?"
            )
        if lifts.shape != angles.shape:
            raise ValueError(
                f"lift must have the shape of angle, {angles.shape}, got {lifts.shape}"
            )
        rounding = 1e-6 * float(np.max(np.abs(lifts)))
        if lifts.min() < -rounding or max(abs(lifts[0]), abs(lifts[-1])) > rounding:
            raise ValueError("lift must be >= 0, and 0 at the first and the last angle")
        spline = scipy.interpolate.CubicSpline(angles, lifts, bc_type="clamped")
        middle = 0.5 * (angles[0] + angles[-1])

        def at(angle: FloatArray, order: int) -> FloatArray:
            turn = np.mod(angle - middle + math.pi, 2.0 * math.pi) + middle - math.pi
            inside = (turn >= angles[0]) & (turn <= angles[-1])
            return np.where(inside, spline(np.clip(turn, angles[0], angles[-1]), order), 0.0)

        return cls(positive("base_radius", base_radius), at)

    def at(self, angle: float) -> TappetContact:
        """Contact with the tappet at an angle of the cam [rad]."""
        turned = finite("angle", angle)
        value, slope, second = (float(self.lift(np.array(turned), n)) for n in (0, 1, 2))
        return TappetContact(self, turned, value, slope, self.base_radius + value + second, second)


@dataclass(frozen=True)
class TappetContact:
    """Contact of a cam with a flat-faced tappet at one angle, from `Cam.at`.

    Attributes
    ----------
    cam : Cam
    angle : float
        Angle of the cam [rad].
    lift : float
        Lift of the tappet [m].
    position : float
        Distance of the contact from the axis of the cam, along the face of the tappet [m].
    radius : float
        Radius of curvature of the cam [m]. It is also the equivalent radius of the contact, because
        the tappet is flat.
    acceleration : float
        Second derivative of the lift with respect to the angle [m].
    """

    cam: Cam
    angle: float
    lift: float
    position: float
    radius: float
    acceleration: float

    def speeds(self, speed: float) -> tuple[float, float]:
        """Speeds of the surfaces of cam and tappet relative to the contact [m/s].

        speed: angular speed of the cam [rad/s]. The magnitude of the second value is also the speed
        at which the contact moves along the tappet. Half the sum of the two values is the
        entraining speed.
        """
        omega = finite("speed", speed)
        return omega * self.radius, omega * self.acceleration

    def entraining_speed(self, speed: float) -> float:
        """Entraining speed [m/s] at an angular speed of the cam [rad/s]."""
        return 0.5 * sum(self.speeds(speed))

    def hertz(self, load: float, width: float, E_star: float) -> hertz.LineContact:
        """Hertz line contact of the cam and the tappet.

        load: normal load [N], > 0. width: width of the contact along the axis [m]. E_star: contact
        modulus [Pa].
        """
        per_width = positive("load", load) / positive("width", width)
        return hertz.line(self.radius, E_star, load_per_length=per_width)

    def surface(self, grid: SurfaceGrid, crown_radius: float = math.inf) -> FloatArray:
        """Gap between the cam and the tappet.

        x runs along the face of the tappet, in the direction in which the contact rolls over the
        cam; y runs along the axis of the cam. The gap follows the profile of the cam, whose
        curvature varies along x.

        Parameters
        ----------
        grid : Grid
            Grid on which the gap is evaluated.
        crown_radius : float, optional
            Equivalent radius of curvature of both bodies along y [m]. Default: inf, i.e. both
            bodies are straight along y.

        Returns
        -------
        ndarray, shape (nx, ny)
            Gap [m], 0 at the origin; inf beyond a quarter of a turn of the cam to either side.

        Raises
        ------
        ValueError
            `crown_radius` is not positive.
        """
        crown = positive("crown_radius", crown_radius, allow_inf=True)
        require_surface(grid)
        x, y = np.asarray(grid.x), np.asarray(grid.y)
        turns = np.linspace(-0.5 * math.pi, 0.5 * math.pi, _SAMPLES)[1:-1]
        along = self._along(turns)[0]
        inside = (x >= along[0]) & (x <= along[-1])
        target = np.where(inside, x, 0.0)
        turn = np.interp(target, along, turns)
        for _ in range(4):  # Newton's method from a point 1e-3 rad away converges in two steps
            reached, slope = self._along(turn)
            turn = turn - (reached - target) / slope
        p, slope = self._support(turn, 0), self._support(turn, 1)
        depth = p * (2.0 * np.sin(0.5 * turn) ** 2) + slope * np.sin(turn) + (self._top - p)
        profile = np.where(inside, depth, math.inf)
        return np.asarray(profile[:, None] + (0.5 * y**2 / crown)[None, :], dtype=np.float64)

    @property
    def _top(self) -> float:
        return self.cam.base_radius + self.lift

    def _support(self, turn: FloatArray, order: int) -> FloatArray:
        """Distance of the cam axis from the tangent that is rotated by `turn` [m], or a derivative.

        order: order of the derivative with respect to `turn`; 0 for the distance itself.
        """
        value = self.cam.lift(self.angle + turn, order)
        return value + self.cam.base_radius if order == 0 else value

    def _along(self, turn: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Positions x of the points at which the tangent is rotated by `turn`, and dx/d(turn)."""
        p, slope, second = (self._support(turn, order) for order in (0, 1, 2))
        x = p * np.sin(turn) + slope * np.cos(turn) - self.position
        return x, (p + second) * np.cos(turn)

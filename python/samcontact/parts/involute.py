# SPDX-License-Identifier: GPL-3.0-or-later
"""Involute curves: the involute function, its inverse, and the shape next to a point of contact."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray

_MAX_ITERATIONS = 60


def involute(angle: float) -> float:
    """Return inv(angle) = tan(angle) - angle for an angle in radians."""
    return math.tan(angle) - angle


def involute_angle(value: float) -> float:
    """Return the angle [rad], in [0, pi/2), at which `involute` equals a given value >= 0."""
    if value == 0.0:
        return 0.0
    t = max((3.0 * value) ** (1.0 / 3.0), value)  # tan(angle); inv is convex in it
    for _ in range(_MAX_ITERATIONS):
        step = (t - math.atan(t) - value) * (1.0 + t * t) / (t * t)
        t -= step
        if abs(step) <= 1e-15 * t:
            break
    return math.atan(t)


@dataclass(frozen=True)
class Flank:
    """Involute flank next to a point of contact.

    base_radius: radius of the base circle [m]. radius: radius of curvature at the point of contact
    [m]. tip: radius of curvature at the tip [m]. relief: depth of the tip relief at the tip [m],
    length of the relief along the line of action [m], and exponent of its growth towards the tip.
    """

    base_radius: float
    radius: float
    tip: float
    relief: tuple[float, float, float]

    def depth(self, x: FloatArray) -> FloatArray:
        """Depths below the tangent at the point of contact [m]; inf beyond the ends of the flank.

        x: distances along the tangent [m], positive towards the tip. The flank ends at the tip and
        at the base circle.
        """
        start, end = -self.radius / self.base_radius, (self.tip - self.radius) / self.base_radius
        ends = self._along(np.array([start, end]))
        inside = (x >= ends[0]) & (x <= ends[1])
        roll = self._roll(np.where(inside, x, 0.0), start, end)
        # rho0 + rb sin(d) - (rho0 + rb d) cos(d) for a roll angle d from the point of contact
        depth = 2.0 * self.radius * np.sin(0.5 * roll) ** 2
        depth += self.base_radius * (np.sin(roll) - roll * np.cos(roll))
        relief = self.relieved(self.radius + self.base_radius * roll)
        return np.where(inside, depth + relief - self.relieved(np.array(self.radius)), math.inf)

    def relieved(self, radius: FloatArray) -> FloatArray:
        """Depths of the tip relief [m] at the points with the given radii of curvature [m]."""
        amount, length, exponent = self.relief
        if amount == 0.0:
            return np.zeros_like(radius)
        beyond = np.clip((radius - self.tip) / length + 1.0, 0.0, 1.0)
        return np.asarray(amount * beyond**exponent, dtype=np.float64)

    def _along(self, roll: FloatArray) -> FloatArray:
        """Distances along the tangent [m] of points with given roll angles from the contact."""
        turned = (self.radius + self.base_radius * roll) * np.sin(roll)
        return np.asarray(turned - 2.0 * self.base_radius * np.sin(0.5 * roll) ** 2)

    def _roll(self, x: FloatArray, start: float, end: float) -> FloatArray:
        """Return the roll angles of points at distances x along the tangent (Newton's method)."""
        root = np.sqrt(np.maximum(self.radius**2 + 2.0 * self.base_radius * x, 0.0))
        roll = np.clip(2.0 * x / (self.radius + root), start, end)
        for _ in range(_MAX_ITERATIONS):
            radius = self.radius + self.base_radius * roll
            slope = np.maximum(radius * np.cos(roll), 1e-12 * self.base_radius)
            new = np.clip(roll - (self._along(roll) - x) / slope, start, end)
            done = np.max(np.abs(new - roll)) <= 1e-15
            roll = new
            if done:
                break
        return roll

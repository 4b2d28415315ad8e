# SPDX-License-Identifier: GPL-3.0-or-later
"""First yield under a Hertz pressure in a body with depth-dependent yield or initial stress."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from .._util.checks import FloatArray
from .._util.lazy_scipy import scipy
from .._util.tensors import von_mises
from ..bodies.material import Material
from ..hertz.field import field
from ..hertz.line_field import line_field

_PRESSURE_FACTOR = 1.1
"""Factor by which the pressure is increased until the body yields."""
_MAX_RADIUS, _MAX_DEPTH = 1.3, 12.0
"""Limits of the searched region in contact radii: distance from the axis, and depth."""
_NUMBER_OF_ANGLES = 8
"""Number of searched planes through the axis if the in-plane residual stress is not equal in all
directions."""
_MAX_KINKS = 150
_REFINEMENTS = 4
"""Number of local refinements, each by a factor of ten."""


class YieldPosition(NamedTuple):
    """Maximum of (von Mises stress)/(yield stress) - 1, and its position; r, z in contact radii."""

    excess: float
    r: float
    angle: float
    z: float


ExcessAt = Callable[[float], YieldPosition]
"""Function of the maximum pressure [Pa] that returns the maximum excess and the position."""


def first_yield(body: Material, spread: float, friction: float | None) -> tuple[float, FloatArray]:
    """Maximum Hertz pressure [Pa] at first yield of a body, and position (x, y, z) of yield [m].

    spread: contact radius divided by maximum pressure [m/Pa]. friction: coefficient of a point
    contact, or None for a frictionless line contact along y; "radius" then means half-width.
    """
    around = _GlobalSearch(body, spread, friction)
    low, p0 = 0.0, 1e-3 * body.min_yield_stress
    highest = 1e2 * float(body.yield_stress(0.0)) * float(body.yield_factor(_kinks(body)).max())
    while around(p0).excess < 0:
        low, p0 = p0, _PRESSURE_FACTOR * p0
        if p0 > highest:
            raise ValueError(
                f"body must yield, but no yield was found up to p0 = {highest:.4g} Pa: check the "
                "yield stress and the yield profile"
            )
    if low == 0:
        raise ValueError(
            "body must not yield before contact, but its residual stress already reaches "
            "the yield stress: reduce residual_stress"
        )
    p0 = _root(around, low, p0)
    place = around(p0)
    for zoom in range(_REFINEMENTS):
        near = _LocalSearch(body, spread, friction, place, 0.1**zoom)
        p0 = _root(near, p0 / _PRESSURE_FACTOR, p0)
        place = near(p0)
    across = place.r * np.array([math.cos(place.angle), math.sin(place.angle)])
    return p0, spread * p0 * np.array([*across, place.z])


def _root(yield_at: ExcessAt, low: float, high: float) -> float:
    while yield_at(low).excess >= 0:
        low /= _PRESSURE_FACTOR
    while yield_at(high).excess < 0:
        high *= _PRESSURE_FACTOR
    root = scipy.optimize.brentq(
        lambda p: yield_at(p).excess, low, high, xtol=1e-12 * high, rtol=1e-12
    )
    return float(root)


def _kinks(body: Material) -> FloatArray:
    profiles = [p for p in (body.yield_profile, body.residual_stress) if p is not None]
    return np.unique(np.concatenate([[0.0], *(np.asarray(p[0]) for p in profiles)]))


def _is_even(body: Material) -> bool:
    """Whether the residual stress is equal in all directions parallel to the surface."""
    if body.residual_stress is None:
        return True
    _, sxx, syy, sxy = body.residual_stress
    return sxx == syy and not any(sxy)


def _angles(body: Material, friction: float | None) -> int:
    """Number of planes through the axis in which the onset of yield is searched."""
    return 1 if friction is None or _is_even(body) else _NUMBER_OF_ANGLES


def _unit_stress(
    body: Material, friction: float | None, angle: FloatArray, r: FloatArray, z: FloatArray
) -> FloatArray:
    """Contact stress divided by maximum pressure [-], shape (6, angles, r, z)."""
    theta, out, down = np.meshgrid(angle, r, z, indexing="ij")
    if friction is None:
        return line_field(out, down, body.nu)
    return field(out * np.cos(theta), out * np.sin(theta), down, body.nu, friction)


def _max_excess(
    body: Material, stress: FloatArray, a: float, angle: FloatArray, r: FloatArray, z: FloatArray
) -> YieldPosition:
    """Maximum relative excess of the von Mises stress over the yield stress, with position.

    stress: contact stress [Pa], shape (6, angles, r, z), with r, z in contact radii.
    """
    sxx, syy, sxy = body.residual_stress_at(a * z)
    total = stress.copy()
    for component, start in ((0, sxx), (1, syy), (5, sxy)):
        total[component] += start
    limit = float(body.yield_stress(0.0)) * body.yield_factor(a * z)
    excess = von_mises(total) / limit - 1.0
    n, i, k = np.unravel_index(int(np.argmax(excess)), excess.shape)
    return YieldPosition(float(excess[n, i, k]), float(r[i]), float(angle[n]), float(z[k]))


class _GlobalSearch:
    """Search in the whole region, with stored contact stresses.

    At depths at which the profiles of the body have kinks, the stresses are interpolated.
    """

    def __init__(self, body: Material, spread: float, friction: float | None) -> None:
        self._body, self._spread = body, spread
        r = np.asarray(_MAX_RADIUS * np.linspace(0.0, 1.0, 27), dtype=np.float64)
        self._r = r if not friction else np.concatenate([-r[:0:-1], r])
        angles = _angles(body, friction)
        self._angle: FloatArray = np.arange(angles, dtype=np.float64) * (math.pi / angles)
        near, far = np.linspace(0.0, 2.0, 121), np.geomspace(2.05, _MAX_DEPTH, 50)
        self._z: FloatArray = np.asarray(np.concatenate([near, far]), dtype=np.float64)
        self._stress = _unit_stress(body, friction, self._angle, self._r, self._z)
        kinks = _kinks(body)
        self._kinks: FloatArray = kinks[:: math.ceil(kinks.size / _MAX_KINKS)]

    def __call__(self, p0: float) -> YieldPosition:
        a = self._spread * p0
        more = self._kinks[self._kinks < _MAX_DEPTH * a] / a
        below = np.clip(np.searchsorted(self._z, more), 1, self._z.size - 1)
        part = (more - self._z[below - 1]) / (self._z[below] - self._z[below - 1])
        between = self._stress[..., below - 1] * (1 - part) + self._stress[..., below] * part
        stress = p0 * np.concatenate([self._stress, between], axis=-1)
        z = np.concatenate([self._z, more])
        return _max_excess(self._body, stress, a, self._angle, self._r, z)


class _LocalSearch:
    """Search on a finer grid around a position. The grid includes all kinks of depth profiles."""

    def __init__(
        self,
        body: Material,
        spread: float,
        friction: float | None,
        place: YieldPosition,
        size: float,
    ) -> None:
        self._body, self._spread, self._friction = body, spread, friction
        offsets = np.linspace(-1.0, 1.0, 21)
        r = place.r + 0.05 * size * offsets
        self._r: FloatArray = np.unique(np.append(r if friction else np.abs(r), place.r))
        rotation = np.zeros(1) if _angles(body, friction) == 1 else 0.4 * size * offsets
        self._angle: FloatArray = np.asarray(place.angle + rotation, dtype=np.float64)
        reach = 0.2 * size * max(1.0, place.z)
        low, high = max(0.0, place.z - reach), place.z + reach
        self._z: FloatArray = np.unique(np.append(np.linspace(low, high, 41), place.z))

    def __call__(self, p0: float) -> YieldPosition:
        a, kinks = self._spread * p0, _kinks(self._body)
        inside = kinks[(kinks >= a * self._z[0]) & (kinks <= a * self._z[-1])]
        z = np.unique(np.concatenate([self._z, inside / a]))
        stress = p0 * _unit_stress(self._body, self._friction, self._angle, self._r, z)
        return _max_excess(self._body, stress, a, self._angle, self._r, z)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Equilibrium of the inner ring of a bearing under radial load, axial load and moment."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray
from .._util.display import ShortRepr

LINE_CONTACT_EXPONENT = 10.0 / 9.0
"""Exponent n in load ~ approach^n for a roller between two races."""
LINE_STIFFNESS = 3.5948e10
"""Stiffness constant of steel rollers between two races, in SI units.

A roller of length L has load = LINE_STIFFNESS L^(8/9) approach^(10/9). ISO/TS 16281 gives the
factor 35948 L^(8/9) N/mm^(10/9), with L in mm.
"""
SLICES = 40
"""Number of slices into which a roller is divided."""
_MAX_ITERATIONS = 300
_TOLERANCE = 1e-10

Energy = Callable[[FloatArray], tuple[float, FloatArray, FloatArray]]


@dataclass(frozen=True, eq=False, repr=False)
class ElementLoads(ShortRepr):
    """Loads of the rolling elements of a bearing row in equilibrium.

    Attributes
    ----------
    angles : ndarray, shape (Z,)
        Angular positions psi of the elements from the direction of the radial load [rad]; the first
        one is 0.
    loads : ndarray, shape (Z,)
        Loads along the contact normals [N].
    contact_angles : ndarray, shape (Z,)
        Contact angles under load [rad].
    displacement : ndarray, shape (3,)
        Displacement of the inner ring: radial [m], axial [m], and rotation [rad] in the plane of
        the radial load. A positive rotation moves the ring axially at psi = 0.
    """

    angles: FloatArray
    loads: FloatArray
    contact_angles: FloatArray
    displacement: FloatArray

    @property
    def max_load(self) -> float:
        """Load of the most heavily loaded element [N]."""
        return float(self.loads.max())

    @property
    def loaded(self) -> int:
        """Number of elements that carry load."""
        return int(np.count_nonzero(self.loads > 0.0))

    @property
    def tilt(self) -> float:
        """Misalignment of the rings at the most heavily loaded element [rad]."""
        at = int(self.loads.argmax())
        return float(self.displacement[2] * np.cos(self.angles[at]))


def balls_in_equilibrium(
    forces: FloatArray, balls: int, stiffness: float, centre_distance: float, free_angle: float,
    arm: float, clearance: float, tilts: bool,
) -> ElementLoads:  # fmt: skip
    """Solve the equilibrium of a ball bearing (Harris, *Rolling Bearing Analysis*, chapter 7).

    forces: radial load, axial load [N] and moment [N m]. stiffness: load/approach^1.5 of a ball
    between two races [N/m^1.5]. centre_distance: distance A between the centres of curvature of the
    grooves without load [m]. free_angle: contact angle without load [rad]. arm: radius of the
    circle on which the centres of curvature of the inner groove lie [m]. clearance: diametral
    clearance [m]. tilts: whether the inner ring can rotate; if not, its rotation is 0.
    """
    psi = 2.0 * np.pi * np.arange(balls) / balls
    zero = np.zeros(balls)
    radial = np.stack([np.cos(psi), zero, zero])
    axial = np.stack([zero, zero + 1.0, arm * np.cos(psi)])
    start_r = centre_distance * np.cos(free_angle) - 0.5 * clearance
    start_z = centre_distance * np.sin(free_angle)

    # r^2 + z^2 - A^2 without load; the rest is evaluated without cancellation
    start = -centre_distance * np.cos(free_angle) * clearance + 0.25 * clearance**2

    def state(u: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        dr, dz = u @ radial, u @ axial
        r, z = start_r + dr, start_z + dz
        length = np.hypot(r, z)
        longer = dr * (2.0 * start_r + dr) + dz * (2.0 * start_z + dz) + start
        return r, z, length, np.maximum(longer / (length + centre_distance), 0.0)

    def energy(u: FloatArray) -> tuple[float, FloatArray, FloatArray]:
        r, z, length, s = state(u)
        along = (r * radial + z * axial) / length
        across = (r * axial - z * radial) / length
        load = stiffness * s**1.5
        gradient = along @ load - forces
        hessian = (along * (1.5 * stiffness * np.sqrt(s))) @ along.T
        hessian += (across * (load / length)) @ across.T
        return float(0.4 * stiffness * np.sum(s**2.5) - u @ forces), gradient, hessian

    first = (_typical(forces, arm) / stiffness) ** (2.0 / 3.0)
    scales = np.array([first, first, first / arm if tilts else 0.0])
    u = _minimum(energy, forces, scales)
    r, z, _, s = state(u)
    return ElementLoads(psi, stiffness * s**1.5, np.arctan2(z, r), u)


def rollers_in_equilibrium(
    forces: FloatArray, rollers: int, length: float, clearance: float, slices: FloatArray,
    drop: FloatArray, tilts: bool,
) -> ElementLoads:  # fmt: skip
    """Solve the equilibrium of a cylindrical roller bearing by slices (ISO/TS 16281).

    forces: radial load [N], axial load (0) and moment [N m]. clearance: diametral clearance [m].
    slices: positions of the slices along the roller [m]. drop: drop of the roller profile at these
    positions [m]. tilts: as for `balls_in_equilibrium`.
    """
    psi = 2.0 * np.pi * np.arange(rollers) / rollers
    n, count = LINE_CONTACT_EXPONENT, len(slices)
    factor = LINE_STIFFNESS * length ** (8.0 / 9.0) / count
    cosine = np.repeat(np.cos(psi), count)
    along = np.stack([cosine, np.zeros_like(cosine), cosine * np.tile(slices, rollers)])
    relief = 0.5 * clearance + 2.0 * np.tile(drop, rollers)

    def energy(u: FloatArray) -> tuple[float, FloatArray, FloatArray]:
        s = np.maximum(u @ along - relief, 0.0)
        gradient = along @ (factor * s**n) - forces
        slope = np.zeros_like(s)
        slope[s > 0.0] = n * factor * s[s > 0.0] ** (n - 1.0)
        work = factor * np.sum(s ** (n + 1.0)) / (n + 1.0)
        return float(work - u @ forces), gradient, (along * slope) @ along.T

    first = (_typical(forces, 0.5 * length) / (factor * count)) ** (1.0 / n)
    u = _minimum(energy, forces, np.array([first, first, 2.0 * first / length if tilts else 0.0]))
    s = np.maximum(u @ along - relief, 0.0)
    loads = factor * (s**n).reshape(rollers, count).sum(axis=1)
    return ElementLoads(psi, loads, np.zeros(rollers), u)


def _typical(forces: FloatArray, arm: float) -> float:
    """Typical force [N]: the largest magnitude of radial load, axial load and moment/`arm`."""
    return float(max(abs(forces[0]), abs(forces[1]), abs(forces[2]) / arm))


def _minimum(energy: Energy, forces: FloatArray, scales: FloatArray) -> FloatArray:
    """Return the displacements that minimise an energy, by Newton's method with damping.

    scales: typical size of each displacement; a displacement whose scale is 0 is held at 0. Raises
    ValueError if no displacement is found at which the elements carry the loads.
    """
    size = float(np.abs(scales * forces).max())
    u, damping = np.zeros(3), 1e-2
    value, gradient, hessian = energy(u)
    for _ in range(_MAX_ITERATIONS):
        if np.abs(scales * gradient).max() <= _TOLERANCE * size:
            return u
        scaled = hessian * np.outer(scales, scales)
        # no element carries load at the start, where the stiffness is zero
        added = damping * max(float(np.trace(scaled)), size) * np.eye(3)
        step = -scales * np.linalg.solve(scaled + added, scales * gradient)
        trial = energy(u + step)
        # rounding errors hide the last steps, which reduce the imbalance
        near = trial[0] <= value + 1e-9 * (abs(value) + size)
        calmer = np.abs(scales * trial[1]).max() < 0.5 * np.abs(scales * gradient).max()
        if trial[0] <= value or (near and calmer):
            u, (value, gradient, hessian) = u + step, trial
            damping = max(0.1 * damping, 1e-15)
        else:
            damping = min(10.0 * damping, 1e12)
    raise ValueError(
        "the elements must be able to carry radial_load, axial_load and moment, but no "
        "equilibrium was found: check the units"
    )

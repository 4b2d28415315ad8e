# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow of a film whose viscosity varies over its thickness due to shear thinning and temperature.

At the relative height t in (-1, 1), the shear stress is tau = tau_m + t w, where tau_m is the shear
stress in the mid-plane and w is half the film thickness times the pressure gradient. The shear rate
is f(abs(tau)) g(t) tau/eta, where eta is the Newtonian viscosity at the walls, f the fluidity ratio
of the shear-thinning law and g the fluidity ratio due to the temperature.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .._util.checks import FloatArray
from ..lubricants.shear import ShearThinning

HEIGHTS, WEIGHTS = np.polynomial.legendre.leggauss(8)
"""Gauss points of the relative height in (-1, 1), and their weights in a mean over the height."""
WEIGHTS = 0.5 * WEIGHTS
MAX_STEPS = 60
"""Maximum number of Newton steps for the shear stress in the mid-plane."""
TOLERANCE = 1e-11
_NEGLIGIBLE = 1e-5  # stresses, relative to those of thinning, that change nothing


class FlowTensor(NamedTuple):
    """Symmetric tensor of the pressure flow, relative to an isothermal Newtonian film [-]."""

    xx: FloatArray
    yy: FloatArray
    xy: FloatArray
    steeper_x: FloatArray
    """Derivative of the flow along x with respect to the pressure gradient along x, minus xx."""
    steeper_y: FloatArray


def flow_tensor(
    law: ShearThinning, newtonian: FloatArray, gradient: FloatArray, warm: FloatArray
) -> FlowTensor:
    """Return the factors by which thinning and heat increase the flow due to the pressure.

    law: law of shear thinning; newtonian: Newtonian shear stress eta (v1 - v2)/h along x and y
    [Pa], shape (2, n); gradient: half the film thickness times the pressure gradient [Pa], shape
    (2, n); warm: viscosity at the walls divided by the viscosity at each of the 8 heights, shape
    (8, n). The tensor gives the exact flow: the mean of its velocity over the thickness is
    h^2/(12 eta) times the tensor times the pressure gradient.
    """
    plain = flow_of_warmth(warm)
    found = FlowTensor(plain.copy(), plain.copy(), *np.zeros((3, plain.size)))
    size = np.hypot(*newtonian) + np.hypot(*gradient)
    thins = size > _NEGLIGIBLE * law.scale
    if thins.any():
        part = _thinned(law, newtonian[:, thins], gradient[:, thins], warm[:, thins])
        for whole, here in zip(found, part, strict=True):
            whole[thins] = here
    return found


def flow_of_warmth(warm: FloatArray) -> FloatArray:
    """Return the pressure flow of a heated Newtonian film relative to an isothermal film [-].

    warm: as for `flow_tensor`.
    """
    flow: FloatArray = np.tensordot(3.0 * WEIGHTS * HEIGHTS**2, warm, axes=1)
    return flow


def _thinned(law: ShearThinning, newtonian: FloatArray, w: FloatArray, g: FloatArray) -> FlowTensor:
    middle = mid_plane_stress(law, newtonian, w, g)
    stress = middle[:, None] + HEIGHTS[:, None] * w[:, None]
    ratio, change = law.fluidity(np.hypot(*stress))
    squares = WEIGHTS * HEIGHTS**2
    plain = 3.0 * squares @ (g * ratio)
    # The mean of t f is odd in w: its quotient by the product of tau_m and w makes the flow a
    # symmetric tensor times w, whose limit for small w is the tangent.
    along = np.sum(middle * w, axis=0)
    small = np.abs(along) <= 1e-4 * np.sum(middle**2 + w**2, axis=0)
    tangent = squares @ (g * change)
    mean = (WEIGHTS * HEIGHTS) @ (g * ratio)
    bend = 3.0 * np.where(small, tangent, mean / np.where(small, 1.0, along))
    xx, yy = plain + bend * middle[0] ** 2, plain + bend * middle[1] ** 2
    steep_x, steep_y = _tangent(stress, g * ratio, g * change)
    return FlowTensor(xx, yy, bend * middle[0] * middle[1], steep_x - xx, steep_y - yy)


def _tangent(
    stress: FloatArray, ratio: FloatArray, change: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return d(flow along x)/d(gradient along x) and d(flow along y)/d(gradient along y).

    The mid-plane stress changes with the gradient so that the mean shear rate stays constant.
    """
    x, y = stress

    def moments(power: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        share = WEIGHTS * HEIGHTS**power
        return (
            share @ (ratio + change * x**2), share @ (ratio + change * y**2),
            share @ (change * x * y),
        )  # fmt: skip

    (a, b, c), (d, e, f), (g, h, _) = moments(0), moments(1), moments(2)
    determinant = a * b - c**2
    along_x = g - (b * d**2 - 2.0 * c * d * f + a * f**2) / determinant
    along_y = h - (b * f**2 - 2.0 * c * f * e + a * e**2) / determinant
    return 3.0 * along_x, 3.0 * along_y


def mid_plane_stress(
    law: ShearThinning, newtonian: FloatArray, gradient: FloatArray, warm: FloatArray
) -> FloatArray:
    """Return the shear stress in the middle of the film [Pa], shape (2, n), by Newton's method.

    Arguments as for `flow_tensor`. With this stress, the mean shear rate over the thickness is
    (v1 - v2)/h.
    """
    size = np.hypot(*newtonian)
    mean_warmth = WEIGHTS @ warm
    start = law.stress(size / mean_warmth)
    stress: FloatArray = newtonian * (start / np.maximum(size, 1e-300))
    for _ in range(MAX_STEPS):
        at = stress[:, None] + HEIGHTS[:, None] * gradient[:, None]
        ratio, change = law.fluidity(np.hypot(*at))
        f = WEIGHTS[:, None] * warm * ratio
        c = WEIGHTS[:, None] * warm * change
        miss = newtonian - np.sum(f * at, axis=1)
        xx = np.sum(f + c * at[0] ** 2, axis=0)
        yy = np.sum(f + c * at[1] ** 2, axis=0)
        xy = np.sum(c * at[0] * at[1], axis=0)
        determinant = xx * yy - xy**2
        step = np.stack([yy * miss[0] - xy * miss[1], xx * miss[1] - xy * miss[0]]) / determinant
        stress = stress + step
        if np.all(np.hypot(*step) <= TOLERANCE * np.maximum(np.hypot(*stress), law.scale)):
            break
    return stress

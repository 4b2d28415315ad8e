# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress / p0 at any point below a sliding point contact; lengths are divided by its radius a.

The potential of a Hertz pressure equals the potential of point forces on an imaginary line,

    integral of sqrt(1 - s^2)/distance over the disc s < 1
        = pi/2 integral of (1 - t^2)/R(z + i t) dt over -1 < t < 1

with R(zeta) = sqrt(r^2 + zeta^2), at the distance r from the axis (Copson 1947; Green and Zerna
1968, section 5.7). Each harmonic function f in the solution for a point force is therefore replaced
by -2 pi (Re f_2 - Im f_3)(z + i) for a Hertz pressure, where f_n is the result of n integrations of
f with respect to z. The harmonic functions of Boussinesq's and Cerruti's solutions (Johnson 1985,
section 3.2) have elementary primitives h_n, with h_0 = 1/R. The primitives contain T = R + zeta.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .._util.checks import FloatArray
from .._util.lazy_scipy import scipy


def _disc(second: NDArray[np.complex128], third: NDArray[np.complex128]) -> FloatArray:
    return np.asarray(third.imag - second.real, dtype=np.float64)


def field(x: FloatArray, y: FloatArray, z: FloatArray, nu: float, friction: float) -> FloatArray:
    """Return the stress / p0, components xx, yy, zz, yz, xz, xy, shape (6, ...).

    x, y, z: coordinates divided by the contact radius a, in arrays of equal shape; z >= 0.
    """
    zeta = z + 1j
    # z = 0 takes the limit from below the surface: the root with the positive imaginary part
    r2 = x**2 + y**2
    R = np.sqrt((r2 - 1.0 + z**2) + 2j * z)
    T = R + zeta
    log_T, q = np.log(T), zeta / T
    # z/R tends to zero at the rim, where R does
    z_R = np.divide(z, R, out=np.zeros_like(R), where=z > 0.0)

    # (1/r d/dr)^k h_n as "hn_k"; functions in 1/R, always multiplied by z, as "z_hn_k"
    z_h0, z_h1_1, z_h2_2, z_h3_3 = z_R, z_R / T, z_R / T**2, z_R / T**3
    h1, h2 = log_T, zeta * log_T - R
    h2_1, h3_1 = -1.0 / T, -0.5 * (log_T + q)
    h4_1 = R / 3.0 - zeta * (0.5 * log_T + q / 6.0)
    h3_2, h4_2 = -0.5 / T**2, (2.0 - q) / (6.0 * T)
    h5_2 = (3.0 * log_T + 5.0 * q - q**2) / 24.0
    h4_3, h5_3 = -1.0 / (3.0 * T**3), (3.0 - 2.0 * q) / (24.0 * T**2)

    # derivatives of F = 1/(2 pi) integral of pressure * ln(rho + z); "zF..." is z times one
    F_zz = _disc(h1, h2)
    zF_zzz = _disc(z_h0, z * h1)
    zF_rzz = _disc(z_h1_1, z * h2_1)
    F_rz, zF_rz = _disc(h2_1, h3_1), z * _disc(h2_1, h3_1)
    zF_rrz = _disc(z_h2_2, z * h3_2)
    F_r, F_rr = _disc(h3_1, h4_1), _disc(h3_2, h4_2)

    k = 1.0 - 2.0 * nu
    xx = 2.0 * nu * F_zz - (zF_rz + x**2 * zF_rrz) - k * (F_r + x**2 * F_rr)
    yy = 2.0 * nu * F_zz - (zF_rz + y**2 * zF_rrz) - k * (F_r + y**2 * F_rr)
    zz = F_zz - zF_zzz
    yz, xz = -y * zF_rzz, -x * zF_rzz
    xy = -x * y * (k * F_rr + zF_rrz)
    if friction != 0.0:
        zF_rr, zF_rrr = z * F_rr, _disc(z_h3_3, z * h4_3)
        G_rr, G_rrr = _disc(h4_2, h5_2), _disc(h4_3, h5_3)  # derivatives of a primitive G of F
        xx = xx + friction * x * (
            (2.0 + 2.0 * nu) * F_rz
            + 2.0 * nu * (3.0 * G_rr + x**2 * G_rrr)
            - (3.0 * zF_rr + x**2 * zF_rrr)
        )
        yy = yy + friction * x * (2.0 * nu * (F_rz + G_rr + y**2 * G_rrr) - (zF_rr + y**2 * zF_rrr))
        zz = zz - friction * x * zF_rzz
        yz = yz - friction * x * y * zF_rrz
        xz = xz + friction * (F_zz - zF_rz - x**2 * zF_rrz)
        xy = xy + friction * y * (F_rz + 2.0 * nu * (G_rr + x**2 * G_rrr) - (zF_rr + x**2 * zF_rrr))
    return np.stack([xx, yy, zz, yz, xz, xy])


def _von_mises(stress: FloatArray) -> FloatArray:
    xx, yy, zz, yz, xz, xy = stress
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.asarray(np.sqrt(0.5 * normal + 3.0 * (yz**2 + xz**2 + xy**2)), dtype=np.float64)


def sliding_max_von_mises(nu: float, friction: float) -> tuple[float, float, float]:
    """Return the maximum von Mises stress / p0 of a sliding point contact, and its place x/a, z/a.

    The maximum lies in the plane y = 0. The stress has two competing maxima: one below the surface,
    and one on the diameter of the contact at the surface. The search replaces x by the angle t,
    x/a = -cos t, of which the stress is a smooth function. At the edge of the contact (t = 0) the
    surface stress is finite and increases linearly with t.
    """

    def von_mises(t: FloatArray, z: FloatArray) -> FloatArray:
        t, z = np.broadcast_arrays(t, z)
        return _von_mises(field(-np.cos(t), np.zeros(t.shape), z, nu, friction))

    def negative(t: float, z: float) -> float:
        return -float(von_mises(np.array(t), np.array(z)))

    angles, depths = np.linspace(0.0, np.pi, 121), np.linspace(0.02, 1.0, 50)
    grid = von_mises(angles[:, None], depths[None, :])
    i, k = np.unravel_index(int(np.argmax(grid)), grid.shape)
    below = scipy.optimize.minimize(
        lambda point: negative(point[0], abs(point[1])),
        (angles[i], depths[k]),
        method="Nelder-Mead",
        options={"xatol": 1e-9, "fatol": 1e-15},
    )
    line = von_mises(angles, np.zeros(1))
    top = int(np.argmax(line))
    bounds = (angles[max(top - 1, 0)], angles[min(top + 1, len(angles) - 1)])
    surface = scipy.optimize.minimize_scalar(
        lambda t: negative(t, 0.0), bounds=bounds, method="bounded", options={"xatol": 1e-10}
    )
    # the bounded search never reaches its ends
    found = max(
        (-float(surface.fun), -float(np.cos(surface.x)), 0.0),
        (float(line[top]), -float(np.cos(angles[top])), 0.0),
    )
    # if the maximum is at the surface, this search also ends there, up to rounding
    if -below.fun > found[0] * (1.0 + 1e-12):
        found = -float(below.fun), -float(np.cos(below.x[0])), abs(float(below.x[1]))
    return found

# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat sources on a half-space by other routes than the package: point sources integrated over the
rectangle by quadrature (temperature, displacement), frequency responses inverted by quadrature in
the plane of wavenumbers (stress).

Numbers without dimension: lengths in one unit, `heated` = kappa t and `speed` = V/kappa in it, V
the velocity of the body relative to the source; results are k T/q, k u_z/(alpha (1 + nu) q) and
k (1 - nu) sigma/(E alpha q). Rectangles have HALF sizes a, b; (x, y) is field minus centre; z >= 0.

H. S. Carslaw & J. C. Jaeger, Conduction of Heat in Solids (1959), sections 10.2 to 10.7; S. Liu &
Q. Wang, Int. J. Solids Struct. 40 (2003), for the frequency responses; T. Boucly (2008).
"""

from __future__ import annotations

import numpy as np
from scipy.special import erfcx, i0e, i1e, wofz

from . import quadrature


def point_temperature(x, y, z, heated, speed):
    """k T / Q of a point source of heat Q on the surface, on since `heated` (inf: steady).

    The integral of exp(-|r - s X|^2/4X)/(4 (pi X)^(3/2)) over the ages X in closed form.
    """
    R = np.sqrt(x * x + y * y + z * z)
    s = np.hypot(*speed)
    along = (speed[0] * x + speed[1] * y) / 2
    steady = np.exp(along - s * R / 2)
    if np.isinf(heated):
        return steady / (2 * np.pi * R)
    p, m = R / (2 * np.sqrt(heated)), s * np.sqrt(heated) / 2
    front = np.exp(along - p * p - m * m)
    late = p >= m
    towards = np.where(
        late,
        front * erfcx(np.where(late, p - m, 0.0)),
        2 * steady - front * erfcx(np.where(late, 0.0, m - p)),
    )
    return (towards + front * erfcx(p + m)) / (4 * np.pi * R)


def temperature(x, y, z, a, b, heated, speed):
    """k T / q under a rectangle; the surface as a limit."""
    height = z
    if z == 0.0 and abs(x) <= a and abs(y) <= b:
        height = quadrature.LIMIT_HEIGHT * min(a, b)
    u, v, weight = quadrature.points(-a - x, a - x, -b - y, b - y, height)
    return point_temperature(-u, -v, height, heated, speed) @ weight


def _panels(edges, n):
    """Gauss-Legendre nodes and weights on the panels between the edges."""
    at, weight = np.polynomial.legendre.leggauss(n)
    low, high = np.asarray(edges[:-1])[:, None], np.asarray(edges[1:])[:, None]
    half = (high - low) / 2
    return ((low + high) / 2 + half * at).ravel(), (half * weight).ravel()


def instantaneous_displacement(r2, age):
    """u_z of a unit of heat released at a point `age` = kappa tau ago, r2 = distance squared."""
    eta = r2 / (8 * age)
    return -2 * (i0e(eta) - i1e(eta)) / (8 * np.pi * age)


def displacement(x, y, a, b, heated, speed):
    """u_z of the surface: the above over the rectangle, then over the ages.

    In polar coordinates about the field point, int_0^R u r dr = -(1 - exp(-eta) I0(eta))/pi with
    eta = R^2/8 age, so that the area becomes a line integral of that along the edges, d/(d^2 + t^2)
    dt = dq/cosh q for t = d sinh q.
    """
    youngest = 1e-9 * min(a, b) ** 2
    size = np.hypot(abs(x) + a, abs(y) + b)
    last = heated
    if np.isinf(heated):  # the rest is below 1e-9: it falls with age^(-3/2)
        last = 1e7 * max(size / np.hypot(*speed), np.hypot(*speed) ** -2.0)
    edges = np.append(youngest * 2.0 ** np.arange(0, np.log2(last / youngest)), last)
    age, weight = _panels(edges, 16)
    X, Y = x - speed[0] * age, y - speed[1] * age
    at, weight_q = np.polynomial.legendre.leggauss(48)
    total = np.zeros_like(age)
    # outward distance of each edge, and its ends in the order that circles the rectangle
    for d, t0, t1 in ((a - X, -b - Y, b - Y), (b - Y, X - a, X + a)):
        total += _edge(d, t0, t1, age, at, weight_q)
    for d, t0, t1 in ((a + X, Y - b, Y + b), (b + Y, -a - X, a - X)):
        total += _edge(d, t0, t1, age, at, weight_q)
    inside = 0.25 * (np.sign(a - abs(x)) + 1) * (np.sign(b - abs(y)) + 1)
    return -weight @ total / np.pi - 2 * inside * youngest


def _edge(d, t0, t1, age, at, weight):
    size = np.maximum(abs(d), 1e-14 * (abs(t0) + abs(t1)))
    q0, q1 = np.arcsinh(t0 / size)[:, None], np.arcsinh(t1 / size)[:, None]
    total = 0.0
    for low, high in ((q0, np.clip(0.0, q0, q1)), (np.clip(0.0, q0, q1), q1)):
        cosh = np.cosh((low + high) / 2 + (high - low) / 2 * at)
        eta = (size[:, None] * cosh) ** 2 / (8 * age[:, None])
        total = total + ((high - low)[:, 0] / 2) * (((1 - i0e(eta)) / cosh) @ weight)
    return np.sign(d) * total


def frequency_response(w1, w2, z, heated, speed):
    """T, P, dP/dz and P(0) per unit flux, with P'' - w^2 P = -T, P'(0) = 0.

    P is the displacement potential without its homogeneous part.
    """
    w = np.hypot(w1, w2)
    a = -1j * (w1 * speed[0] + w2 * speed[1])
    wm = np.sqrt(w * w - a)
    delta = -a / (w + wm)
    if np.isinf(heated):
        phi = np.where(abs(delta * z) < 1e-5, 1 - delta * z / 2, -np.expm1(-delta * z))
        phi = np.where(
            abs(delta * z) < 1e-5, phi, phi / np.where(delta == 0, 1, delta * z + 1e-300)
        )
        decay = np.exp(-w * z)
        P0 = 1 / (w * wm * (w + wm))
        return (
            np.exp(-wm * z) / wm,
            P0 * decay * (1 + w * z * phi),
            -z * decay * phi / (w + wm),
            P0,
        )

    def at(depth):
        root = np.sqrt(heated)
        h = depth / (2 * root)
        E = np.exp(-w * w * heated - h * h)
        growth = np.exp(a * heated)
        plus, minus = _erfcx_pair(E, w * root, h, w * depth)
        minus = 2 * np.exp(-w * depth) - minus
        g_plus, g_minus = _erfcx_pair(E * growth, wm * root, h, wm * depth)
        T = (g_minus - g_plus) / (2 * wm)
        decay = np.exp(-w * depth)
        small = abs(a) * np.minimum(heated, 1 / w**2) < 1e-8
        b = np.where(small, 1, a)
        J = (growth * (plus + minus) - 2 * decay + w / wm * (g_minus - g_plus)) / b
        J_z = w * (growth * (plus - minus) + 2 * decay - g_minus - g_plus) / b
        J_rest = (
            plus * (heated + (w * depth - 1) / (2 * w * w))
            + minus * (heated - (w * depth + 1) / (2 * w * w))
            - 2 * np.sqrt(heated / np.pi) * E / w
            + decay * (w * depth + 1) / w**2
        )
        J_z_rest = (
            plus * (w * heated + depth / 2) - minus * (w * heated - depth / 2) - depth * decay
        )
        J, J_z = np.where(small, J_rest, J), np.where(small, J_z_rest, J_z)
        return T, J / (2 * w), J_z / (2 * w)

    T, P, P_z = at(z)
    return T, P, P_z, at(0.0)[1]


def _erfcx_pair(E, root, h, wz):
    """E exp((h +- root)^2) erfc(h +- root), without overflow; E exp((h - root)^2) = exp(-wz)."""

    def scaled(x):
        return wofz(1j * x)

    below = (h - root).real >= 0
    up = E * scaled(np.where(below, h - root, 0))
    down = 2 * np.exp(-wz) - E * scaled(np.where(below, 0, root - h))
    return E * scaled(root + h), np.where(below, up, down)


def stress(points, z, a, b, nu, heated, speed, low=-30, n=16):
    """Stress (6, len(points)) at (x, y) in points and depth z > 0, components xx, yy, zz, yz, xz,
    xy: frequency responses in polar wavenumbers, where exp(-w z) > 1e-14; panels double from
    2**low/z on and resolve the waves, and those of the direction shrink towards that across the
    motion, where the response turns fast."""
    top = 32 / z
    far = max(abs(x) + abs(y) for x, y in points) + a + b
    step = 6 / far
    edges = [0.0, *(e for e in top * 2.0 ** np.arange(low, 0) if e < step)]
    edges += [*np.linspace(step, top, 2 + int((top - step) / step))]
    w, weight_w = _panels(edges, n)
    quarter = np.unique(
        np.concatenate([np.linspace(0, 1, 3 + int(0.1 * far * top)), 1 - 2.0 ** -np.arange(1, 9.0)])
    )
    direction = np.arctan2(speed[1], speed[0])
    half = np.concatenate([quarter, 2 - quarter[-2::-1]]) * np.pi / 2
    psi, weight_psi = _panels(half + direction, n)
    w, psi = w[:, None], psi[None, :]
    w1, w2 = w * np.cos(psi), w * np.sin(psi)
    T, P, P_z, P0 = frequency_response(w1, w2, z, heated, speed)
    k = 1 - 2 * nu - w * z
    B = P0 * np.exp(-w * z)
    response = (
        -T + w1**2 * P + (k * w1**2 + 2 * nu * w * w) * B,
        -T + w2**2 * P + (k * w2**2 + 2 * nu * w * w) * B,
        w * w * ((1 + w * z) * B - P),
        -1j * w2 * (P_z + z * w * w * B),
        -1j * w1 * (P_z + z * w * w * B),
        w1 * w2 * (P + k * B),
    )
    # the other half of the plane is the complex conjugate
    source = 4 * a * b * np.sinc(w1 * a / np.pi) * np.sinc(w2 * b / np.pi) / (2 * np.pi**2)
    kernel = source * w * weight_w[:, None] * weight_psi
    waves = [kernel * np.exp(1j * (w1 * x + w2 * y)) for x, y in points]
    return np.array([[(part * wave).sum().real for wave in waves] for part in response])

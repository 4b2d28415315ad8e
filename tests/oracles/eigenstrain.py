# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuboid with uniform eigenstrain in a half-space, from Mindlin's point force inside a half-space.

With the eigenstress P = C : eps the displacement is u_k = int P_mn dG_km/dx'_n dV', and as P is
uniform the divergence theorem makes it the surface integral of G_km P_mn n_n over the cuboid's
six faces. Stress is C : (grad u - eps inside). G: R. D. Mindlin, Physics 7 (1936) 195-202,
doi:10.1063/1.1745385, as printed there; its gradient comes from carrying first derivatives along
(class Jet), so no further formula enters.

z >= 0 points into the body, stress is positive in tension, components are ordered xx, yy, zz, yz,
xz, xy. Shear eigenstrains are tensor components; each column belongs to eps_ij = eps_ji = 1.
"""

from __future__ import annotations

import numpy as np

from . import quadrature

PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))


class Jet:
    """Values (n,) with their derivatives (3, n) with respect to the field point."""

    __slots__ = ("grad", "value")
    __array_ufunc__ = None

    def __init__(self, value, grad):
        self.value, self.grad = value, grad

    def __add__(self, other):
        if isinstance(other, Jet):
            return Jet(self.value + other.value, self.grad + other.grad)
        return Jet(self.value + other, self.grad)

    def __neg__(self):
        return Jet(-self.value, -self.grad)

    def __sub__(self, other):
        return self + (-other)

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if isinstance(other, Jet):
            return Jet(self.value * other.value, self.value * other.grad + other.value * self.grad)
        return Jet(self.value * other, self.grad * other)

    def __pow__(self, n):
        return Jet(self.value**n, n * self.value ** (n - 1) * self.grad)

    __radd__ = __add__
    __rmul__ = __mul__


def mindlin(x, y, z, depth, above, nu):
    """16 pi mu (1 - nu) G_km: k displacement at (x, y, z), m unit force at (0, 0, depth); numbers
    or Jets.

    `above` = z - depth is passed apart from both, because it can be far smaller than either.
    """
    below = z + depth
    R1, R2 = (x * x + y * y + above * above) ** 0.5, (x * x + y * y + below * below) ** 0.5
    k, w = 3.0 - 4.0 * nu, 4.0 * (1.0 - nu) * (1.0 - 2.0 * nu)
    i1, i2, T = R1**-1.0, R2**-1.0, (R2 + below) ** -1.0
    i13, i23 = i1 * i1 * i1, i2 * i2 * i2
    i25 = i23 * i2 * i2
    cz = z * depth

    def horizontal(p, q):
        along = (
            k * i1 + i2 + p * p * i13 + k * (p * p * i23) + 2.0 * (cz * (i23 - 3.0 * (p * p * i25)))
        ) + w * (T - p * p * i2 * T * T)
        across = p * q * (i13 + k * i23 - 6.0 * (cz * i25) - w * (i2 * T * T))
        down = p * (above * i13 + k * (above * i23) - 6.0 * (cz * below * i25) + w * (i2 * T))
        return along, across, down

    radial = above * i13 + k * (above * i23) - w * (i2 * T) + 6.0 * (cz * below * i25)
    vertical = (k * i1 + (8.0 * (1.0 - nu) ** 2 - k) * i2 + above * above * i13) + (
        (k * (below * below) - 2.0 * cz) * i23 + 6.0 * (cz * below * below * i25)
    )
    xx, yx, zx = horizontal(x, y)
    yy, xy, zy = horizontal(y, x)
    return [[xx, xy, x * radial], [yx, yy, y * radial], [zx, zy, vertical]]


def _faces(X, Y, z, zc, a, b, c):
    """Yield nodes on each face: normal axis, its sign, source minus field in x, y, z, weights."""
    low, high = (-a - X, -b - Y, zc - c - z), (a - X, b - Y, zc + c - z)
    for axis in range(3):
        p, q = [i for i in range(3) if i != axis]
        for sign, offset in ((-1.0, low[axis]), (1.0, high[axis])):
            u, v, weight = quadrature.points(low[p], high[p], low[q], high[q], abs(offset))
            relative = [None, None, None]
            relative[axis], relative[p], relative[q] = np.full_like(u, offset), u, v
            yield axis, sign, relative, weight


def _elasticity(E, nu):
    """Return the isotropic stiffness C_ijkl [Pa]."""
    mu, one = E / (2.0 * (1.0 + nu)), np.eye(3)
    lam = 2.0 * mu * nu / (1.0 - 2.0 * nu)
    return lam * np.einsum("ij,kl->ijkl", one, one) + mu * (
        np.einsum("ik,jl->ijkl", one, one) + np.einsum("il,jk->ijkl", one, one)
    )


def _unit_eigenstrains():
    unit = np.zeros((6, 3, 3))
    for column, (i, j) in enumerate(PAIRS):
        unit[column, i, j] = unit[column, j, i] = 1.0
    return unit


def solve(X, Y, z, zc, a, b, c, E, nu):
    """Displacement (3, 6) [m] and stress (6, 6) [Pa] at a point; last index: unit eigenstrain.

    X, Y: field minus source; z, zc: depths of field and source; a, b, c: half sides. A field
    point on the free surface above a cuboid that touches it is taken as the limit from inside.
    """
    if z == 0.0 and zc <= c and abs(X) <= a and abs(Y) <= b:
        z = quadrature.LIMIT_HEIGHT * min(a, b, c)
    mu = E / (2.0 * (1.0 + nu))
    value, gradient = np.zeros((3, 3, 3)), np.zeros((3, 3, 3, 3))
    for axis, sign, (u, v, w), weight in _faces(X, Y, z, zc, a, b, c):
        one, zero = np.ones_like(u), np.zeros_like(u)
        x = Jet(-u, np.array([one, zero, zero]))
        y = Jet(-v, np.array([zero, one, zero]))
        down = np.array([zero, zero, one])
        G = mindlin(x, y, Jet(z * one, down), np.maximum(z + w, 0.0), Jet(-w, down), nu)
        for k in range(3):
            for m in range(3):
                value[k, m, axis] += sign * (G[k][m].value @ weight)
                gradient[k, m, axis] += sign * (G[k][m].grad @ weight)
    factor = 1.0 / (16.0 * np.pi * mu * (1.0 - nu))
    stiffness, unit = _elasticity(E, nu), _unit_eigenstrains()
    eigenstress = np.einsum("ijkl,ekl->eij", stiffness, unit)
    displacement = factor * np.einsum("kmn,emn->ke", value, eigenstress)
    grad_u = factor * np.einsum("kmnl,emn->ekl", gradient, eigenstress)
    stress = np.einsum("ijkl,ekl->eij", stiffness, grad_u)
    if abs(X) < a and abs(Y) < b and abs(z - zc) < c:
        stress = stress - eigenstress
    return displacement, np.array([stress[:, i, j] for i, j in PAIRS])


def surface_displacement(X, Y, zc, a, b, c, nu):
    """u_x, u_y, u_z (3, 6) [m] of the free surface per unit eigenstrain; independent of E."""
    return solve(X, Y, 0.0, zc, a, b, c, 1.0, nu)[0]


def stress(X, Y, z, zc, a, b, c, E, nu):
    """Stress (6, 6) [Pa]: [component, eigenstrain component]."""
    return solve(X, Y, z, zc, a, b, c, E, nu)[1]

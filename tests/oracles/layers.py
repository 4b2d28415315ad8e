# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers on a substrate: Fourier modes by integration of the elasticity equations over depth.

Unknowns of a mode exp(i q x), z into the body, all real: U = i u_x, W = u_z, T = i s_xz, N = s_zz.
"""

import numpy as np
from scipy.linalg import expm, schur
from scipy.special import j0, j1


def equations(q, E, nu):
    """d(U, W, T, N)/dz of plane strain: Hooke's law and equilibrium."""
    mu, lam = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))
    plane = lam + 2 * mu
    return np.array(
        [
            [0, q, 1 / mu, 0],
            [-q * lam / plane, 0, 0, 1 / plane],
            [q * q * (plane - lam * lam / plane), 0, 0, q * lam / plane],
            [0, 0, -q, 0],
        ]
    )


def wave_compliance(q, layers, substrate):
    """u_z over the pressure of a wave [m/Pa]; layers (E, nu, thickness), substrate (E, nu) or None
    for a rigid one. For q times the thickness up to 10: the propagators grow exponentially."""
    if substrate is None:
        states = np.eye(4)[:, 2:]  # any tractions, no displacement
    else:
        units = np.diag([1.0, 1.0, substrate[0] * q, substrate[0] * q])
        scaled = np.linalg.inv(units) @ equations(q, *substrate) @ units / q
        _, vectors, count = schur(scaled, sort=lambda re, im=0.0: np.real(re) < 0)
        assert count == 2
        states = units @ vectors[:, :2]
    for E, nu, thickness in reversed(layers):
        states = expm(-equations(q, E, nu) * thickness) @ states
    _, down, shear, normal = states
    return float(down @ np.linalg.solve(np.array([shear, normal]), [0.0, -1.0]))


def hankel(rest, r, first, last):
    """Displacement at distances from a point load, and the waves' wavenumbers and weights: `rest`
    is the compliance of waves less that of a half-space whose own part is to be added."""
    edges = [0.0, first]
    while edges[-1] < last:
        edges.append(min(1.1 * edges[-1], edges[-1] + 10 / max(r)))
    x, weight = np.polynomial.legendre.leggauss(12)
    edges = np.array(edges)
    q = (edges[:-1, None] + np.diff(edges)[:, None] * (x + 1) / 2).ravel()
    of_waves = rest(q) * q * (np.diff(edges)[:, None] * weight / 2).ravel() / (2 * np.pi)
    return np.array([j0(q * distance) @ of_waves for distance in r]), q, of_waves


def cell_displacement(i, j, rest, first, last):
    """u_z at the offset (i, j) from a square cell of 1 under unit pressure, for `rest`."""
    x, weight = np.polynomial.legendre.leggauss(12)
    if i == j == 0:
        # A disc, whose transform is a Bessel function, and the corners around it.
        turn = np.pi / 4 * (x + 1) / 2
        r = 0.5 / np.cos(turn)
        of_points, q, of_waves = hankel(rest, r, first, last)
        corners = (
            np.pi / 8 * weight * 0.5 * np.tan(turn) / np.cos(turn) * r * (2 * np.pi - 8 * turn)
        )
        return np.pi * (j1(q / 2) / q) @ of_waves + corners @ of_points
    r = np.hypot((i + x / 2)[:, None], (j + x / 2)[None, :]).ravel()
    far, back = np.unique(np.round(r, 12), return_inverse=True)
    of_points = hankel(rest, far, first, last)[0][back.ravel()]
    return np.outer(weight, weight).ravel() / 4 @ of_points

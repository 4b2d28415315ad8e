# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscoelastic bodies in motion, and their displacement on a grid that holds the whole track."""

import numpy as np

import samcontact as sc

RUBBER = sc.Material.elastic(1e7, 0.4).with_relaxation(times=[2e-3, 2e-2], shares=[0.4, 0.4])


def creep_of(body):
    """Return shares and retardation times, from the zeros of the relaxation function."""
    tau, r = (np.array(values) for values in body.relaxation_terms)
    rest = 1 - r.sum()
    # numerator of r_inf + sum r s tau/(1 + s tau) as a polynomial in s
    factors = [np.poly1d([t, 1.0]) for t in tau]
    whole = np.poly1d([rest])
    for factor in factors:
        whole *= factor
    for k, (t, share) in enumerate(zip(tau, r, strict=True)):
        term = np.poly1d([share * t, 0.0])
        for other in factors[:k] + factors[k + 1 :]:
            term *= other
        whole += term
    theta = np.sort(-1 / whole.roots.real)
    slopes = (r * tau / (1 - tau / theta[:, None]) ** 2).sum(axis=1)
    return theta / slopes, theta


def crept(pressure, cells, body, speed):
    """Return the elastic pressure of the displacement, with `cells` rows of track behind.

    Material moves towards -x; pressure is linear between cell centres.
    """
    amounts, theta = creep_of(body)
    rows = np.concatenate([np.zeros((cells, pressure.shape[1])), pressure])
    total = rows.copy()
    for amount, z in zip(amounts, 1 / (speed * theta), strict=True):
        decay = np.exp(-z)
        own, ahead = 1 - (1 - decay) / z, (1 - decay) / z - decay
        state, before = np.zeros(pressure.shape[1]), np.zeros(pressure.shape[1])
        for i in range(len(rows) - 1, -1, -1):
            state = decay * state + ahead * before + own * rows[i]
            before = rows[i]
            total[i] += amount * state
    return total


def displaced_by_creep(found, body, speed, moving=1):
    """Return the displacement of a solution by `moving` equal bodies on a rigid or equal one."""
    grid = found.grid
    longest = speed * creep_of(body)[1].max()
    cells = 2 * int(np.ceil(20 * longest / grid.dx))
    # lengths in cells
    acting = crept(found.pressure, cells, body, speed / grid.dx)
    track = sc.Grid(len(acting), grid.ny, grid.dx, grid.dy, periodic=grid.periodic)
    elastic = sc.Material.elastic(body.E, body.nu)
    solver = sc.ContactSolver(track, sc.Material.rigid(), elastic)
    return moving * solver.displacement(acting)[2][cells:]

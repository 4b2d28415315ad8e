# SPDX-License-Identifier: GPL-3.0-or-later
"""Setup of a rolling or sliding ball, and comparison of tracks."""

import numpy as np

import samcontact as sc

RADIUS, LOAD = 4.7625e-3, 1150.0  # p0 = 5.7 GPa
CELL = 80e-6
CERAMIC = sc.Material.elastic(310e9, 0.29)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
SOFT = sc.Material.linear_hardening(210e9, 0.3, 1.5e9, 20e9)
KINEMATIC = sc.Material.perfect_plastic(210e9, 0.3, 1.4e9).with_kinematic_hardening(30e9, 40.0)
HEATED = STEEL.with_thermal(50.2, 11.7e-6, 1.367e-5)
RAMP = [{"load": LOAD * f} for f in (0.25, 0.5, 0.75, 1.0)]


def grid(n=41, ny=15, nz=12, cell=CELL):
    return sc.Grid(n, ny, cell, cell, nz, 0.75 * cell)


def roll(steps, first=-CELL, second=-CELL, load=LOAD):
    return [{"load": load, "advance": (first, second)}] * steps


def ball(body1=CERAMIC, body2=STEEL, cells=None, shape=(RADIUS, RADIUS), **settings):
    cells = cells or grid()
    gap = sc.surfaces.paraboloid(cells, *shape)
    return sc.Simulation(cells, body1, body2, gap, **settings)


def assert_same_track(one, other, body=2, tol=1e-8):
    """Compare common cells; elsewhere neither has plastic strain."""
    a, b = one.track(body, margin=0), other.track(body, margin=0)
    first, last = max(a.x[0], b.x[0]), min(a.x[-1], b.x[-1])
    inside = [(t.x > first - 1e-9) & (t.x < last + 1e-9) for t in (a, b)]
    for name in ("residual_displacement", "equivalent_plastic_strain"):
        x, y = (getattr(t, name)() for t in (a, b))
        scale = np.abs(y).max()
        np.testing.assert_allclose(x[inside[0]], y[inside[1]], rtol=0, atol=tol * scale)
        if name == "equivalent_plastic_strain":
            assert scale > 1e-3
            assert not x[~inside[0]].any()
            assert not y[~inside[1]].any()

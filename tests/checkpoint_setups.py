# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations with each material law, for tests of checkpoints, journals and copies."""

import numpy as np

import samcontact as sc
from samcontact import hertz, surfaces

E, NU = 210e9, 0.3
MATERIALS = {
    "elastic": sc.Material.elastic(1.2 * E, 0.25),
    "rigid": sc.Material.rigid(),
    "perfect": sc.Material.perfect_plastic(E, NU, 1e9),
    "linear": sc.Material.linear_hardening(E, NU, 1e9, 0.1 * E),
    "swift": sc.Material.swift(E, NU, 700e6, 20.0, 0.15),
}
RADIUS = 7.5e-3
EXACT = hertz.point(R=RADIUS, E_star=E / (1 - NU**2) / 2, p0=2e9)
SIZE = EXACT.a / 4
GRID = sc.Grid(15, 17, SIZE, 0.9 * SIZE, 9, SIZE)
GAP = surfaces.paraboloid(GRID, RADIUS) + 1e-4 * GRID.x[:, None]
LOAD = EXACT.load
STATE = ("pressure", "shear", "gap", "load", "approach", "iterations", "contact_iterations")
STATE += ("substeps", "converged", "plastic_strain_residual", "yield_violation")
BODY = ("stress", "plastic_strain", "equivalent_plastic_strain", "residual_displacement")


def assert_same(one, other):
    for name in STATE:
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)
    for body in (1, 2):
        for name in BODY:
            fields = []
            for state in (one, other):
                try:
                    fields.append(getattr(state, name)(body))
                except ValueError as error:  # a rigid body, or no layers
                    fields.append(str(error))
            np.testing.assert_array_equal(*fields, err_msg=f"{name} {body}")


def simulation(body1="elastic", body2="linear", **settings):
    return sc.Simulation(GRID, MATERIALS[body1], MATERIALS[body2], GAP, **settings)


def halved(rise):
    return np.full(rise.shape, 0.5)

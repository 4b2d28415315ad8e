# SPDX-License-Identifier: GPL-3.0-or-later
"""Setup of a ball on an elastic-plastic half-space, and comparison of states."""

import numpy as np

import samcontact as sc
from samcontact import hertz, surfaces

E, NU = 210e9, 0.3
STEEL = sc.Material.elastic(E, NU)
SOFT = sc.Material.linear_hardening(E, NU, 1e9, 0.1 * E)
OTHER = sc.Material.linear_hardening(1.5 * E, 0.25, 1.2e9, 0.1 * E)
RIGID = sc.Material.rigid()
RADIUS = 7.5e-3
EXACT = hertz.point(R=RADIUS, E_star=hertz.effective_modulus(STEEL, STEEL), p0=2.4e9)
LOAD = EXACT.load
SIZE = EXACT.a / 6
GRID = sc.Grid(19, 21, SIZE, 0.9 * SIZE, 10, SIZE)
BALL = surfaces.paraboloid(GRID, RADIUS)
# Beside the middle, so that nothing hides behind the symmetry of the grid.
PRESSURE = EXACT.pressure(GRID.x[:, None] - SIZE, GRID.y[None, :])
SURFACE = ("pressure", "shear", "gap")
SCALARS = ("load", "approach", "iterations", "contact_iterations", "substeps", "converged")
VOLUME = ("plastic_strain", "equivalent_plastic_strain", "stress", "residual_displacement")


def simulation(body1=STEEL, body2=SOFT, gap=BALL, grid=GRID, **settings):
    return sc.Simulation(grid, body1, body2, gap, **settings)


def snapshot(state):
    """Return all quantities of a state as arrays."""
    fields = {name: np.array(getattr(state, name)) for name in SURFACE + SCALARS}
    for body in (1, 2):
        fields |= {f"{name} {body}": np.array(getattr(state, name)(body)) for name in VOLUME}
    return fields


def assert_same(actual, expected):
    for name, values in snapshot(expected).items():
        np.testing.assert_array_equal(snapshot(actual)[name], values, err_msg=name)


def assert_close(actual, expected, tolerance):
    difference = np.abs(actual - expected).max()
    assert difference <= tolerance * np.abs(expected).max()

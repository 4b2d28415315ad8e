# SPDX-License-Identifier: GPL-3.0-or-later
"""Rough contact with many plastic spots, and differences of two solutions."""

import numpy as np

import samcontact as sc

E, NU = 210e9, 0.3
RIGID = sc.Material.rigid()
ELASTIC = sc.Material.elastic(E, NU)
STEEL = sc.Material.swift(E, NU, 945e6, 20.0, 0.121)
SOFT = sc.Material.linear_hardening(E, NU, 1.2e9, 20e9)
PERFECT = sc.Material.perfect_plastic(E, NU, 1.3e9)
KINEMATIC = sc.Material.perfect_plastic(E, NU, 1e9).with_kinematic_hardening(40e9)
CELLS, LAYERS, SIZE = 64, 10, 1e-6
GRID = sc.Grid(CELLS, CELLS, SIZE, SIZE, LAYERS, SIZE)
PERCENT = 0.01 * 4.2e9 * (CELLS * SIZE) ** 2
"""Load under which steel is in contact on about one percent of the surface [N]."""


def rough_gap(bowl=3.0, grid=GRID):
    """Roughness of slope 0.06; a steep bowl keeps the contact away from the grid edge."""
    side = grid.nx * SIZE
    gap = sc.surfaces.rough_self_affine(
        grid, 1e-6, 0.8, wavelength_min=8 * SIZE, roll_off=side / 4, seed=7
    )
    gap *= 0.06 / np.sqrt(np.mean(np.square(np.gradient(gap, SIZE))) * 2)
    far = np.maximum(abs(grid.x[:, None]), abs(grid.y)) / (side / 2)
    return gap - gap.min() + bowl * gap.std() * far**8


GAP = rough_gap()


def simulation(body1=RIGID, body2=STEEL, *, grid=GRID, gap=GAP, **options):
    return sc.Simulation(grid, body1, body2, gap, on_border="warn", **options)


WIDE_GRID = sc.Grid(128, 128, SIZE, SIZE, LAYERS, SIZE)
WIDE_PERCENT = 4 * PERCENT


def rolling(body1, body2, **options):
    """Return a simulation in which body 1 is rough and rolls or slides with its roughness."""
    heights = -rough_gap(0.0, WIDE_GRID)
    bowl = rough_gap(grid=WIDE_GRID) + heights
    relief = sc.Relief(heights, periodic=True)
    return simulation(
        body1, body2, grid=WIDE_GRID, gap=bowl - bowl.min(), relief1=relief, **options
    )


def zones_of(sim, body):
    """Return the boxes of the last solution of a body, [box][i0, j0, nx, ny, nz]."""
    return sim.engine.snapshot().state.get(f"flow_boxes{body}", np.zeros((0, 5), np.int64))


def zone_counts(sim):
    return [len(zones_of(sim, body)) for body in (1, 2)]


def rms(actual, expected):
    return np.sqrt(np.mean((actual - expected) ** 2) / np.mean(expected**2))


def fields(state, bodies=(2,)):
    found = {"pressure": state.pressure, "gap": state.gap}
    for body in bodies:
        found[f"strain {body}"] = state.equivalent_plastic_strain(body)
        found[f"tensor {body}"] = state.plastic_strain(body)
        found[f"print {body}"] = state.residual_displacement(body)
        for axis in "xy":
            found[f"along {axis} {body}"] = state.residual_displacement(body, axis)
    return found


def errors(state, expected, bodies=(2,)):
    """Return the differences of the fields over their rms."""
    wanted = fields(expected, bodies)
    return {name: rms(field, wanted[name]) for name, field in fields(state, bodies).items()}


def assert_few_errors(state, expected, bodies, tol):
    """Assert small errors; tangential displacement may have three times the errors of the rest."""
    found = errors(state, expected, bodies)
    assert all(error < (3 * tol if "along" in name else tol) for name, error in found.items())


def same(state, expected, bodies=(2,)):
    wanted = fields(expected, bodies)
    return all(np.array_equal(field, wanted[name]) for name, field in fields(state, bodies).items())

# SPDX-License-Identifier: GPL-3.0-or-later
"""Random bodies that end at free faces: drawn setups, and the conditions of contact."""

import math
import warnings

import numpy as np
import pytest

import samcontact as sc

NAMED = (sc.ConvergenceError, sc.GridTooSmallError)
SIZE = 20e-6


def ended(draw, body, grid):
    """Return a body with one free face or two, on edges of cells within the grid."""
    edges = SIZE * (np.arange(grid.ny + 1) - grid.ny / 2)
    low, high = float(edges[draw.integers(1, 4)]), float(edges[-int(draw.integers(2, 5))])
    kind = draw.integers(3)
    faces = {"low": low} if kind == 0 else {"high": high}
    if kind == 2:
        faces["low"] = low
    return body.with_free_faces(**faces, method=str(draw.choice(["exact", "factor"])))


def setup(seed):
    """Return a simulation and the loads of its path."""
    draw = np.random.default_rng(seed)
    grid = sc.Grid(*(int(n) for n in draw.integers(12, 21, 2)), SIZE, SIZE, dz=SIZE, nz=6)
    body = sc.Material.elastic(10 ** draw.uniform(6, 11.5), draw.uniform(0, 0.49))
    first = ended(draw, body, grid)
    kind = draw.integers(4)
    E = body.E * 10 ** draw.uniform(-1, 1)
    if kind == 0:
        second = sc.Material.rigid()
    elif kind == 1:
        second = ended(draw, sc.Material.elastic(E, draw.uniform(0, 0.49)), grid)
    elif kind == 2:
        second = sc.Material.linear_hardening(E, 0.3, E * 10 ** draw.uniform(-3, -2), 0.1 * E)
    else:
        second = sc.Material.elastic(E, draw.uniform(0, 0.49))
    radius = 10 ** draw.uniform(-3, -1)
    gap = sc.surfaces.paraboloid(grid, radius, radius * 10 ** draw.uniform(0, 1))
    if draw.random() < 0.4:
        gap = gap + sc.surfaces.rough_self_affine(grid, 10 ** draw.uniform(-9, -7), 0.8, seed=seed)
    bodies = (first, second) if draw.random() < 0.5 or kind == 2 else (second, first)
    simulation = sc.Simulation(grid, *bodies, gap - gap.min(), on_border="warn")
    width = 0.3 * SIZE * min(grid.surface_shape)
    load = 4 / 3 * min(E, body.E) * width**3 / radius
    return simulation, [load * draw.uniform(0.05, 1) for _ in range(2)] + [0.0]


def followed(seed):
    """Follow a random path; return its states, or an error. Wrong states raise an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        simulation, loads = setup(seed)
        strip = [body.free_faces for body in (simulation.body1, simulation.body2)]
        states = []
        for load in loads:
            try:
                states.append(simulation.step(load=load))
            except NAMED as error:
                return error
            check(states[-1], load, [faces for faces in strip if faces is not None])
    return states


def check(state, load, faces):
    """Assert the load, the conditions of contact, and that nothing touches beyond a face."""
    p, gap, y = state.pressure, state.gap, state.grid.y
    low = max(-math.inf if face[0] is None else face[0] for face in faces)
    high = min(math.inf if face[1] is None else face[1] for face in faces)
    within = (y > low) & (y < high)
    assert np.isfinite(p).all()
    assert np.isfinite(gap[:, within]).all()
    assert np.all(gap[:, ~within] == np.inf)
    assert not p[:, ~within].any()
    assert p.min() >= 0.0
    assert state.converged
    assert p.sum() * state.grid.cell_area == pytest.approx(load, rel=1e-9)
    if load:
        scale = max(np.abs(gap[:, within]).max(), abs(state.approach))
        assert gap[:, within].min() >= -1e-4 * scale
        assert np.abs(gap[p > 0.01 * p.max()]).max() <= 1e-4 * scale

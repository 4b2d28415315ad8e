# SPDX-License-Identifier: GPL-3.0-or-later
"""Random histories of viscoelastic contacts: drawn setups, and the conditions of contact."""

import warnings

import numpy as np
import pytest

import samcontact as sc

NAMED = (sc.ConvergenceError, sc.GridTooSmallError)
CONTACT_TOL = 1e-8
"""Tolerance of the contact in an increment: a hundredth of the default tolerance."""


def relaxing(draw):
    """Return a random viscoelastic material, of which at least 2 % of the modulus remain."""
    terms = int(draw.integers(1, 6))
    shares = draw.dirichlet(np.ones(terms)) * draw.uniform(0.1, 0.98)
    body = sc.Material.elastic(10 ** draw.uniform(5, 10), draw.uniform(0, 0.499))
    return body.with_relaxation(10 ** draw.uniform(-4, 4, terms), shares)


def setup(seed):
    """Return a simulation and its path."""
    draw = np.random.default_rng(seed)
    n = int(draw.choice([12, 16]))
    periodic = str(draw.choice(["", "", "xy", "y"]))
    grid = sc.Grid(n, n, 20e-6, 20e-6, dz=20e-6, periodic=periodic)
    lower = relaxing(draw)
    upper = (sc.Material.rigid(), lower, relaxing(draw), sc.Material.elastic(lower.E, 0.3))[
        draw.integers(4)
    ]
    gap = sc.surfaces.rough_self_affine(grid, 10 ** draw.uniform(-9, -6), 0.8, seed=seed)
    if periodic == "":
        gap = gap + sc.surfaces.paraboloid(grid, 10 ** draw.uniform(-3, -1))
    gap = gap - gap.min()
    sticks = periodic != "xy" and draw.random() < 0.4
    friction = sc.Coulomb(draw.choice([0.2, np.inf])) if sticks else 0.0
    simulation = sc.Simulation(
        grid, upper, lower, gap, friction, on_border="warn" if periodic != "xy" else "error"
    )
    load = lower.E * 1e-3 * (n * 20e-6) ** 2 * 10 ** draw.uniform(-2, 0)
    path = []
    for _ in range(6):
        step = {"load": load * draw.choice([0.0, 0.3, 1.0, 1.0])}
        step["duration"] = float(draw.choice([0.0, 1e-9, 1e-3, 1.0, 1e6])) * draw.uniform(0.5, 1)
        if sticks:
            step["shift"] = tuple(1e-7 * draw.uniform(-1, 1, 2))
        path.append(step)
    return simulation, path


def followed(seed):
    """Run a random path; return its states, or an error. Wrong states raise an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        simulation, path = setup(seed)
        states, work, scale = [], 0.0, 0.0
        for step in path:
            try:
                state = simulation.step(**step)
            except NAMED as error:
                return error
            check(state, step)
            scale = max(scale, state.load * abs(state.approach))
            assert state.viscous_work(2) >= work - 1e-6 * scale
            work = state.viscous_work(2)
            states.append(state)
    return states


def check(state, step):
    """Assert finite fields, the load, the conditions of contact, and the limit of the shear."""
    p, gap = state.pressure, state.gap
    for field in (p, gap, state.shear, state.stress(2), state.residual_displacement(2)):
        assert np.isfinite(field).all()
    assert p.min() >= 0.0
    assert p.sum() * state.grid.cell_area == pytest.approx(step["load"], rel=CONTACT_TOL)
    if step["load"]:
        moved = [np.abs(state.surface_displacement(body)).max() for body in (1, 2)]
        scale = max(np.abs(gap).max(), *moved)
        assert gap.min() >= -1e-4 * scale
        assert np.abs(gap[p > 0.01 * p.max()]).max() <= 1e-4 * scale
    law = state.setup.friction
    if law.sticks and np.isfinite(law.coefficient):
        assert np.all(np.hypot(*state.shear) <= law.coefficient * p + 1e-6 * p.max())

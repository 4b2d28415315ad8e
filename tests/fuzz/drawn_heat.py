# SPDX-License-Identifier: GPL-3.0-or-later
"""Random heated bodies with layers: drawn setups, and checks of their temperatures."""

import warnings

import numpy as np
import pytest

import samcontact as sc

NAMED = (sc.ConvergenceError, sc.GridTooSmallError)
SIZE, RADIUS = 20e-6, 5e-3
MAX_THERMAL_STRAIN = 0.3
"""Largest thermal strain relative to that of the pressure."""


def part_of(draw, E, yields):
    """Return a material with thermal constants over two to three decades."""
    E, nu = E * 10 ** draw.uniform(-1, 1), draw.uniform(0.05, 0.45)
    body = sc.Material.elastic(E, nu)
    if yields and draw.random() < 0.5:
        body = sc.Material.linear_hardening(E, nu, E * 10 ** draw.uniform(-2.7, -2), 0.1 * E)
    conductivity, diffusivity = 10 ** draw.uniform(-0.5, 2.3), 10 ** draw.uniform(-6.5, -4)
    return body.with_thermal(conductivity, 10 ** draw.uniform(-6, -4.7), diffusivity)


def layered(draw, E, yields):
    """Return a body with one to three layers, each a whole number of cells thick."""
    layers = [(part_of(draw, E, yields), SIZE * int(draw.integers(1, 4)))
              for _ in range(draw.integers(1, 4))]  # fmt: skip
    return sc.Layered(layers, part_of(draw, E, yields))


def setup(seed):
    """Return a simulation and its path."""
    draw = np.random.default_rng(seed)
    n = int(draw.choice([10, 12]))
    periodic = str(draw.choice(["", "", "xy"]))
    grid = sc.Grid(n, n, SIZE, SIZE, nz=4, dz=SIZE, periodic=periodic)
    E = 10 ** draw.uniform(9, 11.5)
    body = layered(draw, E, draw.random() < 0.4)
    other = sc.Material.elastic(E, 0.3)
    if draw.random() < 0.3:
        other = layered(draw, E, False)
    a = SIZE * n * draw.uniform(0.2, 0.3)
    stiff = min(part.E for part in body.materials)
    load = 4 / 3 * stiff * a**3 / RADIUS
    worst = max(part.thermal[1] / part.thermal[0] for part in body.materials)
    flux = (
        MAX_THERMAL_STRAIN * draw.random() / (worst * a * E)
    )  # per unit pressure: expansion below E a/R
    heat = {"factor": (flux if isinstance(other, sc.Layered) else 0.0, flux)}
    slowest = min(part.thermal[2] for part in body.materials)
    moment, timed = a**2 / slowest, draw.integers(3)
    if timed == 0:
        heat["history"] = (moment * draw.uniform(0.02, 0.2), moment * draw.uniform(2, 20))
    elif timed == 1 or periodic:
        heat["time"] = moment * 10 ** draw.uniform(-1, 1)
    if timed != 0 and not periodic and draw.random() < 0.5:
        heat["velocity"] = tuple(slowest / a * draw.uniform(-5, 5, 2))
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    if draw.random() < 0.3:
        gap = gap + sc.surfaces.rough_self_affine(grid, 1e-3 * a**2 / RADIUS, 0.8, seed=seed)
    friction = draw.uniform(0, 0.5)
    simulation = sc.Simulation(
        grid, other, body, gap - gap.min(), friction, heat=sc.Heat(**heat), on_border="warn"
    )
    path = [{"load": load * draw.uniform(0.1, 1)} for _ in range(2)] + [{"load": 0.0}]
    if timed == 0:
        for step in path:
            step["duration"] = heat["history"][0] * draw.uniform(1, 5)
    return simulation, path


def followed(seed):
    """Follow a random path; return its states, or an error. Wrong states raise an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        simulation, path = setup(seed)
        states = []
        for step in path:
            try:
                states.append(simulation.step(**step))
            except NAMED as error:
                return error
            check(simulation, states[-1], step["load"])
    return states


def check(simulation, state, load):
    """Assert finite fields, the load, the conditions of contact, and that nothing is cooled."""
    p, gap = state.pressure, state.gap
    hot = [body for body in (1, 2) if simulation.heat.factor[body - 1] > 0]
    for field in (p, gap, *(state.stress(body) for body in (1, 2))):
        assert np.isfinite(field).all()
    assert state.converged
    assert p.min() >= 0.0
    assert p.sum() * state.grid.cell_area == pytest.approx(load, rel=1e-9)
    if load:
        scale = max(np.abs(gap).max(), abs(state.approach))
        assert gap.min() >= -1e-4 * scale
        assert np.abs(gap[p > 0.01 * p.max()]).max() <= 1e-4 * scale
    for body in hot:
        surface, volume = state.surface_temperature(body), state.temperature(body)
        assert np.isfinite(surface).all()
        assert np.isfinite(volume).all()
        warmest = max(surface.max(), volume.max())
        assert min(surface.min(), volume.min()) >= -1e-3 * warmest
        if load:
            assert warmest > 0.0

# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties along any path of elastic-plastic bodies with partial slip and rolling."""

import numpy as np
import pytest

import samcontact as sc

QUICK_SEEDS, ALL = range(12), range(600)
pytestmark = [
    pytest.mark.filterwarnings(f"ignore::samcontact.{name}Warning")
    for name in ("Resolution", "ElasticStrain", "PlasticStrain", "GridTooSmall", "Unit")
]


def any_body(draw, least):
    modulus, nu = 10 ** draw.uniform(10.7, 11.5), draw.uniform(0.05, 0.45)
    limit, slope = draw.uniform(0.6e9, 1.5e9), modulus * draw.uniform(0.01, 0.1)
    kind = draw.integers(least, 4)
    if kind == 0:
        return sc.Material.elastic(modulus, nu)
    if kind == 1:
        return sc.Material.linear_hardening(modulus, nu, limit, slope)
    if kind == 2:
        return sc.Material.perfect_plastic(modulus, nu, limit).with_kinematic_hardening(slope)
    return sc.Material.swift(modulus, nu, 945e6, 20.0, 0.121)


def any_step(draw, mu, cell):
    """Draw a load with a shift, a force, a rotation, or some cells of rolling with creepage."""
    load, kind = float(draw.uniform(20, 400)), draw.integers(4)
    if kind == 0:
        return {"load": load, "shift": (draw.normal(size=2) * 2e-6 * mu).tolist()}
    if kind == 1:
        return {"load": load, "tangential_load": (draw.uniform(-0.6, 0.6, 2) * mu * load).tolist()}
    if kind == 2:
        return {"load": load, "twist": float(draw.normal() * 5e-3 * mu)}
    way, creepage, across = -cell * draw.integers(1, 3), *(draw.normal(size=2) * 2e-3)
    ways = (float(way * (1 + creepage)), float(way))
    return {"load": load, "advance": ways, "shift": (0.0, float(across * abs(way)))}


def follow(seed):
    draw = np.random.default_rng(seed)
    cells = int(draw.integers(10, 18))
    grid = sc.Grid(cells, cells, 1e-3 / cells, 1e-3 / cells, dz=1e-3 / cells)
    bodies = any_body(draw, 0), any_body(draw, 1)
    if draw.random() < 0.3:
        bodies = bodies[1], bodies[1]
    mu = float(draw.choice([0.05, 0.2, 0.5, 0.9]))
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    gap = gap + draw.choice([0, 0, 2e-7]) * draw.random(grid.surface_shape)
    run = sc.Simulation(grid, *bodies, gap, sc.Coulomb(mu), on_border="warn")
    work = 0.0
    for _ in range(5):
        step = any_step(draw, mu, grid.dx)
        state = run.step(**step)
        assert state.load == pytest.approx(step["load"], rel=1e-9)
        assert (np.hypot(*state.shear) <= mu * state.pressure * (1 + 1e-6) + 1.0).all()
        assert state.friction_work >= work - 1e-12 * step["load"]
        if "tangential_load" in step:
            wanted = step["tangential_load"]
            assert state.tangential_load == pytest.approx(wanted, abs=1e-5 * step["load"])
        assert np.isfinite(state.equivalent_plastic_strain()).all()
        work = state.friction_work


@pytest.mark.parametrize("seed", QUICK_SEEDS)
def test_a_path_with_plastic_flow_satisfies_coulombs_law(seed):
    follow(seed)


@pytest.mark.slow
def test_hundreds_of_paths_with_plastic_flow_satisfy_coulombs_law():
    for seed in ALL:
        follow(seed)

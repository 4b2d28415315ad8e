# SPDX-License-Identifier: GPL-3.0-or-later
"""Constant shear limit: full sliding, a closed form of partial slip, loops, rolling, yield."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact import results

STEEL = sc.Material.elastic(210e9, 0.3)
BRASS = sc.Material.elastic(100e9, 0.2)
YIELDS = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 10e9)
GRID = sc.Grid(28, 28, 36e-6, 36e-6, dz=36e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
LOAD, K = 300.0, 2e8


def slide(shift, law, bodies=(STEEL, STEEL), **more):
    return sc.ContactSolver(GRID, *bodies, law).solve(GAP, load=LOAD, shift=shift, **more)


def require_law(law, found):
    """Assert shear within its bound, and slip only at the bound and along the shear."""
    bound, length = law.bound(found.pressure), np.hypot(*found.shear)
    assert (length <= bound * (1 + 1e-12)).all()
    slipping = (found.pressure > 0) & ~found.sticking
    np.testing.assert_allclose(length[slipping], bound[slipping], rtol=1e-5)
    assert not found.slip[:, ~slipping].any()
    power, slip = (found.shear * found.slip).sum(axis=0), np.hypot(*found.slip)
    np.testing.assert_allclose(power, bound * slip, atol=1e-4 * K * max(slip.max(), 1e-300))


@pytest.mark.parametrize("bodies", [(STEEL, STEEL), (BRASS, STEEL)], ids=["alike", "dissimilar"])
def test_full_sliding_has_uniform_shear(bodies):
    found = slide((1e-3, 0.0), sc.Tresca(K), bodies)
    touching = found.pressure > 0
    assert not found.sticking.any()
    np.testing.assert_allclose(np.hypot(*found.shear)[touching], K, rtol=1e-12)
    assert not found.shear[:, ~touching].any()
    np.testing.assert_allclose(found.shear[0][touching], K, rtol=1e-4)  # slip turns by strain
    force = K * np.count_nonzero(touching) * GRID.cell_area
    assert found.tangential_load[0] == pytest.approx(force, rel=1e-4)


def test_force_increases_with_the_shear_limit():
    forces = []
    for limit in (0.0, 0.3 * K, K, 3 * K, 1e12, math.inf):
        found = slide((2e-6, 1e-6), sc.Tresca(limit))
        require_law(sc.Tresca(limit), found) if 0 < limit < 1e12 else None
        forces.append(math.hypot(*found.tangential_load))
    assert forces[0] == 0.0
    assert (np.diff(forces[:-1]) > 0).all()
    assert forces[-2] == pytest.approx(forces[-1], rel=1e-7)
    stuck = slide((2e-6, 1e-6), sc.Coulomb(math.inf))
    assert np.array_equal(slide((2e-6, 1e-6), sc.Tresca(math.inf)).shear, stuck.shear)


def test_partial_slip_of_a_cylinder():
    """The stick zone follows the crack model with a cohesive zone (Bilby, Cottrell & Swinden 1963).

    Contact |x| < a: uniform displacement of |x| < c under the shear
    2 k/pi atan(sqrt((a^2 - c^2)/(c^2 - x^2))), and k beyond: c^2 = a^2 - (Q/(2 k))^2 for a force Q
    per length. The cells in contact give a.
    """
    errors = []
    for cells in (51, 201):
        dx = 3e-4 / cells
        grid = sc.Grid(cells, 1, dx, dx, periodic="y")
        gap = sc.surfaces.paraboloid(grid, 7.5e-3, np.inf)
        modulus = sc.hertz.effective_modulus(STEEL, STEEL)
        load = 0.25 * math.pi * modulus * 1e-4**2 / 7.5e-3 * dx
        k, force = 3e7, 1.6 * 3e7 * 1e-4 * dx
        solver = sc.ContactSolver(grid, STEEL, STEEL, sc.Tresca(k))
        found = solver.solve(gap, load=load, tangential_load=(force, 0.0))
        a = 0.5 * dx * np.count_nonzero(found.pressure)
        c = math.sqrt(a * a - (force / dx / (2 * k)) ** 2)
        x = np.abs(np.arange(cells) - (cells - 1) / 2) * dx
        with np.errstate(divide="ignore", invalid="ignore"):
            inner = 2 * k / math.pi * np.arctan(np.sqrt((a * a - c * c) / (c * c - x * x)))
        wrong = np.abs(found.shear[0, :, 0] - np.where(x < c, inner, k)) / k
        errors.append(wrong[x < a].mean())
        assert 0.5 * dx * np.count_nonzero(found.sticking) == pytest.approx(c, abs=dx)
    assert errors[1] < 0.25 * errors[0] < 5e-4


def test_a_force_beyond_the_limit_times_the_area_is_refused():
    area = GRID.cell_area * np.count_nonzero(slide((0.0, 0.0), sc.Tresca(K)).pressure)
    solver = sc.ContactSolver(GRID, STEEL, STEEL, sc.Tresca(K))
    found = solver.solve(GAP, load=LOAD, tangential_load=(0.99 * K * area, 0.0))
    assert found.tangential_load[0] == pytest.approx(0.99 * K * area)
    with pytest.raises(
        ValueError, match=r"tangential_load must be less than .*, the friction limit"
    ):
        solver.solve(GAP, load=LOAD, tangential_load=(1.01 * K * area, 0.0))


def test_friction_work_of_a_loop_is_shear_limit_times_slip():
    law = sc.Tresca(K)
    solver, before, works = sc.ContactSolver(GRID, BRASS, STEEL, law), None, []
    for shift in (3e-6, -6e-6, 6e-6, -6e-6, 6e-6):
        now = solver.solve(GAP, load=LOAD, shift=(shift, 0.0), previous=before)
        require_law(law, now)
        done = now.friction_work - (before.friction_work if before else 0.0)
        slip = GRID.cell_area * (law.bound(now.pressure) * np.hypot(*now.slip)).sum()
        assert done == pytest.approx(slip, rel=1e-5)
        works.append(done)
        before = now
    assert works[3] == pytest.approx(works[4], rel=1e-2)
    assert works[0] < works[1]


def test_steady_rolling():
    law, drive = sc.Tresca(K), {"load": LOAD, "friction": sc.Tresca(K)}
    little = sc.rolling.steady(GRID, STEEL, STEEL, GAP, creepage=(1e-3, 2e-4), **drive)
    require_law(law, little)
    assert little.friction == law
    assert 0 < np.count_nonzero(little.sticking) < np.count_nonzero(little.pressure)
    slides = sc.rolling.steady(GRID, STEEL, STEEL, GAP, creepage=(1.0, 0.0), **drive)
    force = K * GRID.cell_area * np.count_nonzero(slides.pressure)
    assert slides.tangential_load[0] == pytest.approx(force, rel=1e-4)
    half = sc.rolling.steady(GRID, STEEL, STEEL, GAP, tangential_load=(0.5 * force, 0.0), **drive)
    assert half.tangential_load[0] == pytest.approx(0.5 * force, rel=1e-6)


PATH = [
    {"load": 400.0},
    {"load": 400.0, "shift": (3e-6, 1e-6)},
    {"load": 400.0, "shift": (-4e-6, 0.0)},
    {"load": 300.0, "shift": (0.0, 2e-6), "twist": 1e-3},
]


@pytest.mark.parametrize("body1", [STEEL, BRASS, YIELDS], ids=["ball", "dissimilar", "both yield"])
def test_elastic_plastic_bodies_satisfy_the_law(body1):
    law = sc.Tresca(K)
    run = sc.Simulation(GRID, body1, YIELDS, GAP, law)
    work = 0.0
    for step in PATH:
        state = run.step(**step)
        require_law(law, state)
        slip = GRID.cell_area * (law.bound(state.pressure) * np.hypot(*state.slip)).sum()
        assert state.friction_work - work == pytest.approx(slip, rel=1e-5, abs=1e-12)
        work = state.friction_work
    assert state.max_equivalent_plastic_strain(2) > 1e-4


def test_checkpoints_and_results_contain_the_law(tmp_path):
    run = sc.Simulation(GRID, STEEL, YIELDS, GAP, sc.Tresca(K))
    states = [run.step(**step) for step in PATH[:2]]
    run.save(tmp_path / "run.h5")
    kept = sc.Simulation.load(tmp_path / "run.h5")
    assert kept.friction == sc.Tresca(K)
    for step in PATH[2:]:
        one, other = run.step(**step), kept.step(**step)
        assert np.array_equal(one.shear, other.shear)
        assert np.array_equal(one.slip, other.slip)
    results.save(results.to_dataset(run, states), tmp_path / "results.nc")
    with results.open_results(tmp_path / "results.nc") as dataset:
        assert dataset.attrs["friction_law"] == "tresca"
        assert dataset.attrs["friction_limit"] == K
        checks = {check.name: check for check in sc.report.checks(dataset)}
    assert checks[
        "friction law: maximum excess of shear over its bound, relative to the maximum bound"
    ].passed


def test_fretting_wear_by_work_or_by_pressure():
    grid = sc.Grid(20, 20, 10e-6, 10e-6)
    gap = sc.surfaces.paraboloid(grid, 5e-3)
    cycle = [{"load": 8.0, "shift": (s * 4e-7, 0.0)} for s in (0, 1, -2, 2)]
    for law in ("energy", "archard"):
        found = sc.wear.fretting(
            grid, STEEL, STEEL, gap, cycle=cycle, friction=sc.Tresca(1e8), cycles=2,
            repeats=200, progress=False, **{law: 1e-14},
        )  # fmt: skip
        for worn in found.cycles:
            assert worn.friction_work > 0
            assert worn.lost_volume == pytest.approx(worn.volume, rel=1e-12)
        if law == "energy":
            assert worn.volume[0] == pytest.approx(1e-14 * worn.friction_work)

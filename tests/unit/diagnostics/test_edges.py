# SPDX-License-Identifier: GPL-3.0-or-later
"""Sharp edges are detected if and only if the pressure rises towards them."""

import math
import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact import report, results
from samcontact.accuracy import run as accuracy_run
from samcontact.diagnostics import sharp_edges
from samcontact.solutions import outline
from samcontact.solutions.outline import away_from_border, has_ridge, sides_between, sides_of

STEEL, RIGID = sc.Material.elastic(210e9, 0.3), sc.Material.rigid()
E_STAR = sc.hertz.effective_modulus(STEEL, STEEL)
RADIUS, LENGTH, LINE_LOAD = 4e-3, 10e-3, 1.5e6
HERTZ = sc.hertz.line(RADIUS, E_STAR, LINE_LOAD)


def roller(cells, end=1e-3):
    """Return grid and gap function of a roller with straight ends on a flat."""

    def gap(grid):
        profile = grid.x[:, None] ** 2 / (2 * RADIUS)
        outside = np.abs(grid.y) > LENGTH / 2
        return profile + np.where(outside, end, 0.0)

    return sc.Grid(25, cells, HERTZ.b / 8, 1.04 * LENGTH / cells), gap


def crowned(grid):
    """Return the roller with a logarithmic profile, including the ends of the body."""
    profile = sc.surfaces.paraboloid(grid, RADIUS, math.inf)
    s = np.clip(np.abs(grid.y) / (LENGTH / 2), 0.0, 0.999)
    drop = -2 * LINE_LOAD / (math.pi * E_STAR) * np.log1p(-(s**2))
    return profile + drop + np.where(np.abs(grid.y) > LENGTH / 2, 1e-3, 0.0)


def kinds(solve):
    """Return the warnings of singular pressure."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        solve()
    return [str(w.message) for w in caught if w.category is sc.SingularPressureWarning]


def test_the_end_of_a_roller_causes_one_warning():
    load, largest = LINE_LOAD * LENGTH, []
    for cells in (64, 128):
        grid, gap = roller(cells)
        solver = sc.ContactSolver(grid, STEEL, STEEL)
        with pytest.warns(sc.SingularPressureWarning, match=r"sharp edge.*crowned or logarithmic"):
            largest.append(solver.solve(gap(grid), load=load).pressure.max())
    assert largest[1] > 1.25 * largest[0]  # which is why
    grid, gap = roller(64)
    run = sc.Simulation(grid, STEEL, STEEL, gap(grid))
    assert len(kinds(lambda: [run.step(load=load), run.step(load=1.1 * load)])) == 1
    run = sc.Simulation(grid, STEEL, STEEL, gap(grid))
    assert len(kinds(lambda: run.run([{"load": load}, {"load": 1.1 * load}], progress=False))) == 1
    assert not kinds(lambda: sc.ContactSolver(grid, STEEL, STEEL).solve(crowned(grid), load=load))


def test_punches_and_steps_cause_a_warning():
    grid = sc.Grid(64, 64, 2e-5, 2e-5)
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    ball = (x**2 + y**2) / (2 * 10e-3)
    for gap in (
        np.where(np.hypot(x, y) < 3e-4, 0.0, 1e-6),  # a low step too
        np.where(np.maximum(abs(x), abs(y)) < 3e-4, 0.0, 1e-4),
        np.where(np.maximum(abs(x), abs(y)) < 3e-4, 1e-6 * x / 3e-4, 1e-4),  # tilted
        ball + np.where(x > 5e-5, 3e-6, 0.0),
    ):
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        assert len(kinds(lambda s=solver, g=gap: s.solve(g - g.min(), load=100.0))) == 1
    # a step that the load has closed
    fine = sc.Grid(128, 128, 1e-3 / 128, 1e-3 / 128)
    gap = (fine.x[:, None] ** 2 + fine.y**2) / (2 * 10e-3)
    gap = gap + np.where(fine.x[:, None] > 5e-5, 1e-7, 0.0)
    assert len(kinds(lambda: sc.ContactSolver(fine, RIGID, STEEL).solve(gap, load=50.0))) == 1


def smooth_problems():
    grid = sc.Grid(64, 64, 2e-5, 2e-5)
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    r = np.hypot(x, y)
    radius = 1e-4  # 5 cells
    rounded = np.where(r < 3e-4, 0.0, (np.maximum(r - 3e-4, 0.0)) ** 2 / (2 * radius))
    dent = 2e-6 * np.exp(-((r / 8e-5) ** 2))
    joined = sc.Grid(128, 128, 1e-6, 1e-6, periodic="xy")
    noise = 1e-7 * np.random.default_rng(0).standard_normal(joined.surface_shape)
    waves = 1e-7 * np.outer(*(np.cos(2 * np.pi * np.arange(128) / 64) for _ in "xy"))
    rough = sc.surfaces.rough_self_affine(joined, 1e-7, 0.4, seed=3)
    side = 128e-6
    yield "rounded punch", grid, rounded, 100.0
    yield "ball with a dent", grid, r**2 / 20e-3 + dent, 50.0
    yield "ball", grid, r**2 / 20e-3, 50.0
    yield "wedge", grid, 0.02 * np.abs(x) + y**2 / 20e-3, 50.0
    yield "noise of single cells", joined, noise, 0.02 * E_STAR * side**2
    yield "closed waves", joined, waves, 0.02 * E_STAR * side**2
    yield "open waves", joined, waves, 0.001 * E_STAR * side**2
    yield "rough", joined, rough, 0.002 * E_STAR * side**2
    steps = np.round(rough / 2e-8) * 2e-8  # as from an instrument with few bits
    yield "rough, in steps", joined, steps, 0.002 * E_STAR * side**2


def test_smooth_and_rough_contacts_cause_no_edge_warning():
    for name, grid, gap, load in smooth_problems():
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        assert not kinds(lambda s=solver, g=gap, n=load: s.solve(g - g.min(), load=n)), name


def test_no_body_beyond_an_edge_is_an_edge():
    pressure, gap = np.zeros((9, 9)), np.full((9, 9), np.nan)
    pressure[2:7, 2:7], gap[2:7, 2:7] = 1e9, 0.0
    pressure[2] = np.where(pressure[2] > 0, 2e9, 0.0)
    for outside in (np.nan, np.inf):
        gap[~(pressure > 0)] = outside
        found = sharp_edges.sharp_edge(pressure, gap, (1e-5, 1e-5), 1e11)
        assert found is not None
        assert found.peak[0] == 2
        assert np.array_equal(np.nonzero(found.cells.any(axis=1))[0], [2])
    assert sharp_edges.sharp_edge(pressure, np.zeros((9, 9)), (1e-5, 1e-5), 1e11) is None


def test_errors_state_that_the_largest_pressure_does_not_converge():
    grid, gap = roller(64)
    run, path = sc.Simulation(grid, STEEL, STEEL, gap), [{"load": LINE_LOAD * LENGTH}]
    with pytest.warns(sc.SingularPressureWarning):
        states = run.run(path, progress=False)
    found = sc.estimate_errors(run, path, states)
    assert math.isinf(found.errors["max_pressure"][0])
    assert 0 < found.errors["approach"][0] < 0.1 * found.values["approach"][0]
    assert "does not converge" in dict(found._rows())["maximum pressure"]
    dataset = results.to_dataset(run, states)
    found.add_to(dataset)
    checks = {check.name: check for check in report.checks(dataset)}
    assert dataset["sharp_edge_cells"].values.max() >= 20
    sharp = "contact cells at sharp edges, where the pressure does not converge"
    assert not checks[sharp].passed
    assert any(
        "maximum estimated relative grid error" in name for name in checks
    )  # of what converges


def test_a_run_to_an_accuracy_ends_if_nothing_converges():
    class WithWarning:
        solved = type(
            "Solved", (), {"issued": [type("W", (), {"category": sc.SingularPressureWarning})]}
        )

    search = object.__new__(accuracy_run.AccuracySearch)
    search.targets, search.needs = {"max_pressure": 0.01, "approach": 0.01}, ""
    search.target_values = np.array([0.01, 0.01])
    search._leave_out_singular(WithWarning)
    assert search.target_values.tolist() == [math.inf, 0.01]
    assert "do not converge" in search.needs


@pytest.mark.parametrize("periodic", ["", "x", "y", "xy"])
def test_the_quick_check_misses_no_edge(periodic):
    """The fast preliminary checks miss no edge."""
    rng = np.random.default_rng(5)
    found = 0
    for _ in range(300):
        shape = tuple(rng.integers(1, 9, 2))
        pressure = np.where(rng.random(shape) < 0.6, rng.random(shape), 0.0)
        inside = pressure > 0
        groups = [*sides_of(inside, periodic), *sides_between(inside, inside, periodic)]
        rising = any(
            (outline._rising(away_from_border(sides, shape, periodic), pressure)).any()
            for sides in groups
        )
        found += rising
        assert has_ridge(pressure, periodic) or not rising
    assert found > 100


def test_the_remedy_for_a_roller_with_a_profile_is_not_a_profile():
    """Its edge is that of cells too coarse for the drop at the ends."""
    grid = sc.Grid(32, 101, HERTZ.b / 10, 1.1 * LENGTH / 101)

    def texts(profile):
        gap = sc.surfaces.roller(grid, RADIUS, LENGTH, profile)
        solver = sc.ContactSolver(grid, STEEL, STEEL)
        return kinds(lambda: solver.solve(gap, load=LINE_LOAD * LENGTH))

    (text,) = texts("logarithmic")
    assert "smaller cells across the edge, or a larger drop" in text
    assert "logarithmic profile" not in text
    assert "or use a crowned or logarithmic profile" in texts("straight")[0]

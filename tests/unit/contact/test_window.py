# SPDX-License-Identifier: GPL-3.0-or-later
"""Automatic grid enlargement with surfaces given as functions of the grid."""

import copy
import pickle
from functools import partial

import h5py
import numpy as np
import pytest

import samcontact as sc
from case_texts import MINIMAL
from checkpoint_setups import assert_same
from command import check_failure, invoke
from samcontact import results, surfaces
from samcontact.files.checksum import seal

CELL, RADIUS, LOAD = 25e-6, 5e-3, 300.0
STEEL, BRASS = sc.Material.elastic(210e9, 0.3), sc.Material.elastic(60e9, 0.3)
SOFT = sc.Material.linear_hardening(210e9, 0.3, 1e9, 20e9)
CHABOCHE = SOFT.with_kinematic_hardening(20e9, 50.0)
PATH = [{"load": part * LOAD} for part in (0.02, 0.3, 1.0, 0.0)]


def grid(nx, ny):
    return sc.Grid(nx, ny, CELL, CELL, dz=CELL)


def punch(grid):
    """Return a gap without a Hertz estimate, longer along x and off centre in y."""
    x, y = grid.x[:, None] / 200e-6, (grid.y - 0.5 * CELL)[None, :] / 100e-6
    return 3e-6 * (x**2 + y**2) ** 2


def simulation(shape, gap=punch, upper=CHABOCHE, lower=SOFT, friction=0.1, **settings):
    return sc.Simulation(grid(*shape), upper, lower, gap, friction, **settings)


FULL = (29, 22)


@pytest.fixture(scope="module")
def full():
    sim = simulation(FULL)
    return [sim.step(**step) for step in PATH]


@pytest.fixture(scope="module")
def grown():
    sim = simulation((7, 6))
    return sim, [sim.step(**step) for step in PATH]


def inner(field, shape, axis=0):
    """Return the middle cells of a surface field."""
    cut = [
        slice((n - m) // 2, (n + m) // 2) for n, m in zip(field.shape[axis:], shape, strict=False)
    ]
    return field[(*[slice(None)] * axis, *cut)]


def test_results_equal_those_of_a_grid_that_is_large_enough(grown, full):
    sim, states = grown
    shapes = [state.grid.surface_shape for state in states]
    assert shapes[0] != shapes[1] != shapes[2] == shapes[3] == sim.grid.surface_shape
    assert all((n - m) % 2 == 0 for shape in shapes for n, m in zip(shape, (7, 6), strict=True))
    for state, expected in zip(states, full, strict=True):
        assert state.approach == pytest.approx(expected.approach, rel=1e-4)
        shape = [min(n, m) for n, m in zip(state.grid.surface_shape, FULL, strict=True)]
        for name, args in (("pressure", ()), ("gap", ()), ("residual_displacement", (1,))):
            one, other = getattr(state, name), getattr(expected, name)
            one, other = (inner(f(*args) if args else f, shape) for f in (one, other))
            np.testing.assert_allclose(one, other, rtol=0, atol=1e-4 * np.abs(other).max())
    for body in (1, 2):
        one, other = (s[-1].max_equivalent_plastic_strain(body) for s in (states, full))
        assert 1e-3 < one == pytest.approx(other, rel=1e-4)


def test_earlier_fields_are_extended_to_the_last_grid(grown):
    sim, states = grown
    dataset = results.to_dataset(sim, states, volume="all")
    nx, ny = sim.grid.surface_shape
    assert (dataset.sizes["x"], dataset.sizes["y"]) == (nx, ny)
    for number, state in enumerate(states):
        pressure = dataset["pressure"].values[number]
        shape = state.grid.surface_shape
        np.testing.assert_array_equal(inner(pressure, shape), state.pressure)
        assert pressure.sum() == pytest.approx(state.pressure.sum(), rel=1e-14)
        residual = dataset["residual_stress_body2"].values[number]
        layers = min(residual.shape[-1], len(state.depths))
        expected = state.residual_stress()[..., :layers]
        found = inner(residual, shape, axis=1)[..., :layers]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-3 * np.abs(expected).max() + 1)
    work = sc.energy.plastic_work(CHABOCHE, states[2].track(1), states[1].track(1))
    assert work > 0


def test_a_run_resumes_with_identical_bits(tmp_path):
    def run(gap=punch):
        return simulation((7, 6), gap).run(PATH, progress=False, checkpoint=tmp_path)

    whole = run()
    assert len({state.grid for state in whole}) == 1
    assert len(list(tmp_path.glob("*.h5"))) == 4
    for name in ("increment_00003.h5", "increment_00004.h5"):
        (tmp_path / name).unlink()
    for one, other in zip(run(), whole, strict=True):
        assert_same(one, other)
    with pytest.raises(sc.CheckpointError, match="different surfaces: gap must give the same"):
        run(lambda grid: np.minimum(punch(grid), 2e-6))
    # belongs to another grid than the current one, which is kept if restoring fails
    with h5py.File(tmp_path / "increment_00002.h5", "a") as file:
        file["state"].attrs["past_symmetry"] = 7
    seal(tmp_path / "increment_00002.h5")
    with pytest.warns(UserWarning, match="increment 2 is solved again"):
        again = run()
    for one, other in zip(again, whole, strict=True):
        assert_same(one, other)


def test_copies_and_files_keep_the_enlarged_grid(grown, tmp_path):
    sim = simulation((7, 6))
    first = sim.step(**PATH[0])
    sim.step(**PATH[1])
    others = [copy.deepcopy(sim), pickle.loads(pickle.dumps(sim))]
    sim.save(tmp_path / "state.h5")
    others.append(sc.Simulation.load(tmp_path / "state.h5", gap=punch))
    assert_same(copy.deepcopy(first), first)
    for other in others:
        assert_same(other.state, grown[1][1])
        assert_same(other.step(**PATH[2]), grown[1][2])
    unchanged = sc.Simulation.load(tmp_path / "state.h5")
    with pytest.raises(sc.GridTooSmallError, match=r"to enlarge the grid automatically$"):
        unchanged.step(load=20 * LOAD)
    with pytest.raises(sc.CheckpointError, match="gap must give the same result on every grid"):
        sc.Simulation.load(tmp_path / "state.h5", gap=lambda grid: punch(grid) * 1.01)


def test_the_grid_is_enlarged_by_hertz_before_the_first_increment():
    ball = partial(surfaces.paraboloid, Rx=RADIUS, Ry=0.3 * RADIUS)
    sim = simulation((7, 7), ball, STEEL, STEEL, 0.0)
    states = sim.run([{"load": part * LOAD} for part in (0.1, 1.0)], progress=False)
    assert sim.counters["contact_solves"] == 2  # none was unnecessary
    nx, ny = sim.grid.surface_shape
    assert nx > ny > 7
    fixed = simulation((nx, ny), ball, STEEL, STEEL, 0.0)
    expected = fixed.step(load=LOAD).pressure
    np.testing.assert_allclose(states[1].pressure, expected, rtol=0, atol=1e-6 * expected.max())


def test_elastic_contact():
    solver = sc.ContactSolver(grid(7, 6), STEEL, STEEL, 0.1)
    start = np.full((7, 6), 1e9)
    found = solver.solve(punch, load=LOAD, initial_pressure=start)
    nx, ny = found.grid.surface_shape
    assert solver.grid == grid(7, 6)
    assert found.pressure.shape == found.gap.shape == (nx, ny)
    expected = sc.ContactSolver(found.grid, STEEL, STEEL, 0.1).solve(punch(found.grid), load=LOAD)
    np.testing.assert_array_equal(found.pressure, expected.pressure)
    ball = partial(surfaces.paraboloid, Rx=RADIUS)
    assert solver.solve(ball, approach=10e-6).load == pytest.approx(
        sc.hertz.point(RADIUS, sc.hertz.effective_modulus(STEEL, STEEL), approach=10e-6).load,
        rel=0.01,
    )
    for gap, text in (
        (punch(grid(7, 6)), "gap and reliefs as functions"),
        (REFUSED["flat"][0]["gap"], "2688"),
    ):
        with pytest.raises(sc.GridTooSmallError, match=text):
            solver.solve(gap, load=LOAD)


@pytest.mark.parametrize("relieved", [False, True])
def test_rolling_contact(relieved):
    """Travel, history and relief keep their positions on the bodies."""
    ball = partial(surfaces.paraboloid, Rx=RADIUS)
    dent = partial(sc.dents.spherical, depth=1e-6, radius=80e-6, x=60e-6)
    steps = [{"load": 0.1 * LOAD}, {"load": 0.1 * LOAD, "advance": (-3.3 * CELL, -3.3 * CELL)}]
    steps += [{"load": LOAD, "advance": (-2 * CELL, -2 * CELL)}, {"load": 0.0}]
    tracks = []
    for shape in ((9, 9), (27, 27)):
        sim = simulation(shape, ball, STEEL, SOFT, 0.0, relief2=dent if relieved else None)
        states = [sim.step(**step) for step in steps]
        tracks.append(states[-1].track())
        if shape == (9, 9):
            assert states[0].grid != states[2].grid
    one, other = tracks
    places = np.intersect1d(np.round(one.x / CELL, 3), np.round(other.x / CELL, 3))
    rows = [np.isin(np.round(t.x / CELL, 3), places) for t in tracks]
    assert rows[0].sum() > 12
    prints = [t.residual_displacement()[r] for t, r in zip(tracks, rows, strict=True)]
    ny = min(p.shape[1] for p in prints)
    one, other = (inner(p, (p.shape[0], ny)) for p in prints)
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-3 * np.abs(other).max())


TOUCHES = "^at load .* reaches the edge .*"
REFUSED = {
    "flat": (
        {"gap": lambda grid: np.zeros(grid.surface_shape)},
        "grid of .* x .* cells cannot be enlarged: .* x .* cells exceed the limit of 2688",
    ),
    "made on the grid": (
        {"gap": lambda grid: surfaces.rough_self_affine(grid, 1e-7, 0.8, seed=1)},
        "grid of 7 x 6 cells cannot be enlarged: gap must give the same result on every grid",
    ),
    "not known": (
        {"gap": partial(surfaces.sphere, R=4.6 * CELL), "upper": BRASS, "lower": BRASS},
        "cannot be enlarged: R must be >=",
    ),
    "relief of its own": (
        {"relief2": sc.Relief(np.zeros((7, 6)))}, "pass gap and reliefs as functions",
    ),
    "modulus in gigapascals": (
        {"gap": partial(surfaces.paraboloid, Rx=RADIUS), "upper": sc.Material.elastic(210.0, 0.3)},
        r"E is in pascals.* cannot be enlarged: .* cells exceed the limit of 4194304",
    ),
    "array": ({"gap": punch(grid(7, 6))}, "pass gap and reliefs as functions"),
}  # fmt: skip


@pytest.mark.parametrize(("given", "text"), REFUSED.values(), ids=REFUSED)
def test_the_error_states_why_the_grid_is_not_enlarged(given, text):
    sim = simulation((7, 6), **given)
    before = sim.grid
    with pytest.raises(sc.GridTooSmallError, match=TOUCHES + text):
        sim.step(load=LOAD)
    assert sim.state.load == 0.0
    if text != REFUSED["flat"][1]:
        assert sim.grid == before


def test_a_run_reports_an_enlarged_grid(tmp_path):
    file = tmp_path / "case.toml"
    text = MINIMAL.replace("nz = 12\n", "").replace("load = 600.0", "load = 2000.0")
    file.write_text(text)
    outcome = invoke("run", file, "--output", tmp_path, "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    with results.open_results(tmp_path / "results.nc") as data:
        nx, ny = data.sizes["x"], data.sizes["y"]
    assert nx > 15
    assert f"grid enlarged from 15 x 13 to {nx} x {ny} cells; [grid] spec" in outcome.stdout
    rough = '[surface.roughness]\nkind = "self_affine"\nrms_height = 1e-8\nhurst = 0.8\nseed = 1\n'
    file.write_text(text + rough)
    check_failure(invoke("run", file, "--output", tmp_path / "rough", "--quiet"), 2, "border")


def test_grids_with_warnings_or_periods_are_not_enlarged():
    sim = simulation((7, 6), upper=STEEL, lower=STEEL, on_border="warn")
    with pytest.warns(sc.GridTooSmallWarning, match="reaches the edge"):
        assert sim.step(load=LOAD).grid == grid(7, 6)
    line = sc.Grid(8, 1, CELL, CELL, dz=CELL, periodic="y")
    sim = sc.Simulation(line, STEEL, SOFT, partial(surfaces.paraboloid, Rx=RADIUS, Ry=np.inf))
    with pytest.raises(sc.GridTooSmallError, match=r'on_border="warn"$'):
        sim.step(load=100.0)

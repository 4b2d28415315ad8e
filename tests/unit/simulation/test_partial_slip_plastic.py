# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic-plastic partial slip against elastic solutions, full sliding and energy."""

import copy

import numpy as np
import pytest

import samcontact as sc
from samcontact import energy, results

GRID = sc.Grid(28, 28, 36e-6, 36e-6, dz=36e-6)
BALL = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 10e9)
BRASS = sc.Material.linear_hardening(100e9, 0.2, 0.9e9, 5e9)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
LAW = sc.Coulomb(0.3)


def simulation(body1=BALL, body2=STEEL, friction=LAW, **settings):
    return sc.Simulation(GRID, body1, body2, GAP, friction, **settings)


def by_parts(path, parts):
    """Yield the steps of a path of loads and forces, divided into equal increments."""
    load, force = 0.0, np.zeros(2)
    for end, to in path:
        for part in np.arange(1, parts + 1) / parts:
            now = force + part * (np.array(to) - force)
            yield {"load": load + part * (end - load), "tangential_load": tuple(now)}
        load, force = end, np.array(to)


def test_without_yielding_it_is_the_elastic_solution():
    hard = sc.Material.linear_hardening(100e9, 0.2, 1e12, 5e9)  # unlike the ball
    path = [
        {"load": 100.0, "tangential_load": (10.0, 0.0)},
        {"load": 150.0, "tangential_load": (10.0, 20.0)},
        {"load": 150.0, "shift": (2e-7, -2e-7), "torque": 1e-4},
        {"load": 100.0, "shift": (-1e-6, None), "tangential_load": (None, 8.0), "twist": 1e-4},
        {"approach": 3e-6},
    ]
    solver = sc.ContactSolver(GRID, BALL, hard, LAW, tol=1e-10)
    run, solution = simulation(body2=hard, tol=1e-9), solver.solve(GAP, load=0.0)
    for step in path:
        solution, state = solver.solve(GAP, previous=solution, **step), run.step(**step)
        scale = 0.3 * solution.pressure.max()
        np.testing.assert_allclose(state.pressure, solution.pressure, atol=1e-8 * scale)
        np.testing.assert_allclose(state.shear, solution.shear, atol=1e-8 * scale)
        np.testing.assert_allclose(state.slip, solution.slip, atol=1e-8 * abs(solution.slip).max())
        np.testing.assert_allclose(state.shift, solution.shift, atol=1e-13)
        assert state.twist == pytest.approx(solution.twist, rel=1e-7, abs=1e-9)
        assert state.torque == pytest.approx(solution.torque, rel=1e-7, abs=1e-12)
        assert state.friction_work == pytest.approx(solution.friction_work, rel=1e-6)


@pytest.mark.parametrize(("body1", "body2"), [(BALL, STEEL), (BRASS, STEEL)])
def test_work_is_elastic_plastic_or_friction_work(body1, body2):
    path = [(400.0, (0, 0)), (400.0, (80, 30)), (300.0, (-60, 0)), (400.0, (0, 20))]
    lost = []
    for parts in (3, 6):
        run, work = simulation(body1, body2), 0.0
        before = run.state
        for step in by_parts(path, parts):
            state = run.step(**step)
            work += 0.5 * (state.load + before.load) * (state.approach - before.approach)
            force = 0.5 * (state.tangential_load + before.tangential_load)
            work += force @ (state.shift - before.shift)
            assert state.friction_work >= before.friction_work
            before = state
        solver = sc.ContactSolver(GRID, body1, body2, LAW)
        u1, u2 = (solver.displacement(state.pressure, state.shear, body) for body in (1, 2))
        stored = np.sum(state.pressure * (u1[2] + u2[2])) + np.sum(state.shear * (u2 - u1)[:2])
        kept = 0.5 * GRID.cell_area * stored + state.friction_work
        for number, body in enumerate((body1, body2), 1):
            if body.is_plastic:
                track = state.track(number)
                kept += energy.plastic_work(body, track) + energy.residual_energy(track)
        lost.append(abs(work - kept) / work)
    assert lost[1] < 0.55 * lost[0] < 0.03


def test_swapped_bodies_mirror_the_solution():
    path = list(by_parts([(400.0, (0, 0)), (400.0, (70, 30)), (350.0, (-50, 10))], 2))
    one, two = simulation(BRASS, STEEL, tol=1e-10), simulation(STEEL, BRASS, tol=1e-10)
    for step in path:
        first, second = one.step(**step), two.step(**step)
    # The force pulls the other body now: all is turned by half a turn about z.
    scale = first.pressure.max()
    np.testing.assert_allclose(second.pressure[::-1, ::-1], first.pressure, atol=1e-10 * scale)
    np.testing.assert_allclose(second.shear[:, ::-1, ::-1], first.shear, atol=1e-10 * scale)
    np.testing.assert_allclose(second.shift, first.shift, rtol=1e-9, atol=1e-16)
    for body in (1, 2):
        strain = first.plastic_strain(body)
        turned = second.plastic_strain(3 - body)[:, ::-1, ::-1].copy()
        turned[3:5] *= -1
        np.testing.assert_allclose(turned, strain, atol=1e-10 * abs(strain).max())


def test_full_slip_equals_full_sliding():
    slides, sticks = simulation(friction=0.2), simulation(friction=sc.Coulomb(0.2))
    for load in (250.0, 400.0):
        expected, state = slides.step(load=load), sticks.step(load=load, shift=(1e-3, 0.0))
    assert not state.sticking.any()
    scale = expected.pressure.max()
    # Slip turns a little where surfaces strain: by strain over slip.
    np.testing.assert_allclose(state.pressure, expected.pressure, atol=1e-3 * scale)
    np.testing.assert_allclose(state.shear, expected.shear, atol=1e-3 * scale)
    strain = expected.equivalent_plastic_strain()
    np.testing.assert_allclose(state.equivalent_plastic_strain(), strain, atol=2e-3 * strain.max())
    further = sticks.step(load=400.0, shift=(1e-3, 0.0)).friction_work - state.friction_work
    assert further == pytest.approx(0.2 * 400 * 1e-3, rel=2e-3)


def test_vanishing_friction_tends_to_no_friction():
    smooth, sticks = simulation(friction=0.0), simulation(friction=sc.Coulomb(1e-9))
    expected, state = smooth.step(load=400.0), sticks.step(load=400.0, shift=(1e-6, 0.0))
    np.testing.assert_allclose(
        state.pressure, expected.pressure, atol=1e-6 * expected.pressure.max()
    )
    strain = expected.equivalent_plastic_strain()
    np.testing.assert_allclose(state.equivalent_plastic_strain(), strain, atol=1e-5 * strain.max())


def test_identical_bodies_under_normal_load_have_no_shear():
    state = simulation(STEEL, STEEL).step(load=400.0)
    expected = simulation(STEEL, STEEL, 0.0).step(load=400.0)
    assert not state.shear.any()
    assert state.sticking.sum() == np.count_nonzero(state.pressure)
    np.testing.assert_allclose(state.pressure, expected.pressure, rtol=1e-6)


def test_a_copy_continues_with_identical_bits(tmp_path):
    run = simulation(BRASS, STEEL)
    run.step(load=400.0, tangential_load=(60.0, 0.0))
    run.save(tmp_path / "run.h5")
    path = [{"load": 400.0, "tangential_load": (60.0, 0.0)}]
    for _ in range(2):
        (kept,) = simulation(BRASS, STEEL).run(path, progress=False, checkpoint=tmp_path / "kept")
        assert np.array_equal(kept.slip, run.state.slip)
    others = [copy.deepcopy(run), sc.Simulation.load(tmp_path / "run.h5")]
    expected = run.step(load=400.0, shift=(-1e-6, 1e-7), twist=1e-5)
    for other in others:
        assert other.friction == LAW
        state = other.step(load=400.0, shift=(-1e-6, 1e-7), twist=1e-5)
        for name in ("pressure", "shear", "slip", "shift", "twist", "friction_work"):
            assert np.array_equal(getattr(state, name), getattr(expected, name)), name


def test_grid_enlargement_keeps_shear_and_slip():
    small = sc.Grid(16, 16, 36e-6, 36e-6, dz=36e-6)
    grows = sc.Simulation(small, BALL, STEEL, lambda g: sc.surfaces.paraboloid(g, 7.5e-3), LAW)
    wide = simulation()
    for step in ({"load": 100.0, "tangential_load": (15.0, 0.0)}, {"load": 400.0}):
        state, expected = grows.step(**step), wide.step(**step)
    assert state.grid.nx > 16
    margin = (state.grid.nx - GRID.nx) // 2
    inner = slice(max(margin, 0), state.grid.nx - max(margin, 0))
    outer = slice(max(-margin, 0), GRID.nx - max(-margin, 0))
    np.testing.assert_allclose(
        state.shear[:, inner, inner], expected.shear[:, outer, outer],
        atol=2e-3 * abs(expected.shear).max(),
    )  # fmt: skip


def test_parts_of_an_increment_lead_to_its_end():
    whole, parts = simulation(), simulation(increment_tol=1e-3)
    divided = 1
    for step in by_parts([(400.0, (0, 0)), (400.0, (70, 0)), (400.0, (-70, 0))], 1):
        one, two = whole.step(**step), parts.step(**step)
        divided = max(divided, two.substeps)
    assert divided > 1
    np.testing.assert_allclose(two.tangential_load, one.tangential_load, rtol=1e-6, atol=1e-6)
    assert two.shift[0] == pytest.approx(one.shift[0], rel=0.1)
    assert two.friction_work == pytest.approx(one.friction_work, rel=0.05)


def slid_surfaces(state):
    """Return the elastic and plastic displacement of body 2 relative to body 1."""
    solver = sc.ContactSolver(state.grid, BALL, STEEL, LAW)
    u1, u2 = (solver.displacement(state.pressure, state.shear, body)[:2] for body in (1, 2))
    return u2 - u1 + np.stack([state.residual_displacement(2, axis=axis) for axis in "xy"])


def test_stick_zones_move_rigidly_in_sub_increments():
    run = simulation(increment_tol=1e-3)
    before = run.step(load=250.0)
    for force in (0.0, 90.0):
        state = run.step(load=400.0, tangential_load=(force, 20.0))
        assert state.substeps > 1
        moved = (state.shift - before.shift)[:, None, None]
        slip = moved - slid_surfaces(state) + slid_surfaces(before)
        touches = before.pressure > 0
        np.testing.assert_allclose(state.slip[:, touches], slip[:, touches], atol=1e-12)
        before = state


def test_rolling_over_an_elastic_plastic_rail_reaches_a_steady_force():
    forces, creepage = [], 5e-4
    for cells in (1, 2):
        run, way = simulation(), -cells * GRID.dx
        run.step(load=400.0)
        for _ in range(24 // cells):
            advance = (way * (1 + creepage / 2), way * (1 - creepage / 2))
            before, state = run.state, run.step(load=400.0, advance=advance)
        force = state.tangential_load
        forces.append(force[0])
        assert abs(force[1]) < 1e-6
        assert abs(force[0] - before.tangential_load[0]) < 0.03 * cells * abs(force[0])
        assert 0 < state.sticking.sum() < np.count_nonzero(state.pressure)
        assert state.shift[0] == pytest.approx(24 * -GRID.dx * creepage)
    assert min(forces) > -120
    assert max(forces) < -5
    assert forces[1] == pytest.approx(forces[0], rel=0.1)


@pytest.mark.parametrize(
    ("friction", "step", "text"),
    [
        (0.3, {"load": 1.0, "shift": (0.0, 0.0)}, "shift is not supported in full sliding"),
        (LAW, {"load": 10.0, "tangential_load": (4.0, 0.0)}, "the friction limit"),
        (LAW, {"load": 10.0, "shift": (1e-7, 0), "tangential_load": (1, None)}, "cannot both"),
        (LAW, {"pressure": np.zeros(GRID.surface_shape)}, "shear is required"),
        (
            LAW,
            {"load": 10.0, "torque": 0.0, "advance": (36e-6, 36e-6)},
            "torque cannot be",
        ),
        (LAW, {"load": 10.0, "heat_factor": 1.0}, "heat"),
    ],
)
def test_unsupported_arguments_are_refused(friction, step, text):
    with pytest.raises(ValueError, match=text):
        simulation(friction=friction).step(**step)


def test_full_sliding_has_no_slip_field():
    state = simulation(friction=0.3).step(load=10.0)
    assert state.tangential_load[0] == pytest.approx(3.0)
    for name in ("slip", "sticking", "shift", "twist", "friction_work"):
        with pytest.raises(ValueError, match=f"{name}|slip"):
            getattr(state, name)


def test_elastic_rolling_agrees_with_the_contact_solver():
    path, dx = [{"load": 100.0}], GRID.dx
    for cells in (1, 1, 2):
        ways = (-cells * dx * 1.0005, -cells * dx * 0.9995)
        moved = {"shift": (0.0, 2e-4 * cells * dx), "twist": 0.2 * cells * dx}
        path.append({"load": 100.0, "advance": ways} | moved)
    run = simulation(body2=BALL, tol=1e-9)
    solver = sc.ContactSolver(GRID, BALL, BALL, LAW, tol=1e-10)
    solution = solver.solve(GAP, load=0.0)
    for step in path:
        state, solution = run.step(**step), solver.solve(GAP, previous=solution, **step)
        atol = 1e-8 * solution.pressure.max()
        np.testing.assert_allclose(state.shear, solution.shear, atol=atol)
        np.testing.assert_allclose(state.shift, solution.shift, atol=1e-15)


SOFT = sc.Material.elastic(100e9, 0.2)


def moved(field, cells):
    """Return a surface field shifted by whole cells."""
    out, count = np.zeros_like(field), field.shape[-2] - abs(cells)
    to, of = max(cells, 0), max(-cells, 0)
    out[..., to : to + count, :] = field[..., of : of + count, :]
    return out


@pytest.mark.parametrize(
    "bodies",
    [(BALL, SOFT), (BALL, sc.Material.linear_hardening(100e9, 0.2, 1e12, 5e9)),
     (sc.Material.linear_hardening(210e9, 0.3, 1e12, 5e9), SOFT)],
    ids=["elastic", "follows 2", "follows 1"],
)  # fmt: skip
@pytest.mark.parametrize("ways", [(3, -1), (-3, 5), (14, 14)])
def test_plastic_displacement_moves_with_its_body(bodies, ways):
    run = simulation(*bodies, tol=1e-9)
    before = run.step(load=100.0, tangential_load=(12.0, 9.0))
    shift = (0.0, 3e-7)
    state = run.step(load=100.0, advance=tuple(n * GRID.dx for n in ways), shift=shift)
    wide = sc.Grid(84, 28, 36e-6, 36e-6)  # for what leaves the grid
    solver = sc.ContactSolver(wide, *bodies, LAW)
    slip = np.array([(ways[0] - ways[1]) * GRID.dx, shift[1]])[:, None, None] * np.ones((84, 28))
    rim = ((0, 0), (28, 28), (0, 0))
    loads = {s: (np.pad(s.pressure, rim[1:]), np.pad(s.shear, rim)) for s in (before, state)}
    for body, way, sign in ((1, ways[0], 1), (2, ways[1], -1)):
        then = solver.displacement(*(moved(t, way) for t in loads[before]), body=body)
        slip += sign * (solver.displacement(*loads[state], body=body) - then)[:2]
    slips = (state.pressure > 0) & ~state.sticking
    scale = max(abs(slip[:, 28:56][:, slips]).max(initial=0), 1e-7)
    np.testing.assert_allclose(state.slip[:, slips], slip[:, 28:56][:, slips], atol=1e-6 * 1e-7)
    assert abs(slip[:, 28:56][:, state.sticking]).max(initial=0) < 1e-6 * scale


def test_swapped_bodies_mirror_large_motions():
    one, two = simulation(SOFT, STEEL, tol=1e-10), simulation(STEEL, SOFT, tol=1e-10)
    for run in (one, two):
        run.step(load=300.0, tangential_load=(40.0, 30.0))
    for ways in ((2.0, -1.0), (-1.0, 1.0), (0.5, -0.5)):
        first, second = (
            run.step(load=300.0, advance=np.multiply(turned, GRID.dx), shift=(0.0, 1e-6))
            for run, turned in ((one, ways), (two, (-ways[1], -ways[0])))
        )
    scale = first.pressure.max()
    np.testing.assert_allclose(second.pressure[::-1, ::-1], first.pressure, atol=1e-10 * scale)
    np.testing.assert_allclose(second.shear[:, ::-1, ::-1], first.shear, atol=1e-10 * scale)
    slip = abs(first.slip).max()
    np.testing.assert_allclose(second.slip[:, ::-1, ::-1], first.slip, atol=1e-9 * slip)
    strain = first.plastic_strain(2)
    turned = second.plastic_strain(1)[:, ::-1, ::-1].copy()
    turned[3:5] *= -1
    np.testing.assert_allclose(turned, strain, atol=1e-10 * abs(strain).max())


def per_cycle(cells, share, cycles=4):
    """Return strain and friction work per cycle for a fraction of the maximum force."""
    size = 1e-3 / cells
    grid = sc.Grid(cells, cells, size, size, dz=size)
    body2 = sc.Material.perfect_plastic(210e9, 0.3, 1.2e9).with_kinematic_hardening(7e9)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    run = sc.Simulation(grid, BALL, body2, gap, sc.Coulomb(0.6))
    loop = sc.paths.fretting_loop(
        load=300.0, force=(share * 0.6 * 300.0, 0.0), cycles=cycles, increments=2
    )
    states = run.run([{"load": 150.0}, {"load": 300.0}, *loop], progress=False)[3::8]
    strain = [state.max_equivalent_plastic_strain() for state in states]
    return np.diff(strain), np.diff([state.friction_work for state in states])


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.filterwarnings("ignore::samcontact.PlasticStrainWarning")
def test_fretting_shakes_down_or_ratchets_by_its_force():
    work = []
    for cells in (20, 28):
        small, _ = per_cycle(cells, 0.5)
        large, turned = per_cycle(cells, 0.85)
        assert small[-1] < 0.01 * small[0]
        assert large[-1] > 0.2 * large[0]
        assert large[-1] > 1000 * small[-1]
        work.append(turned[-1])
    assert work[0] == pytest.approx(work[1], rel=0.08)


def test_results_have_forces_motions_and_slip(tmp_path):
    run = simulation()
    states = run.run(list(by_parts([(400.0, (0, 0)), (400.0, (90.0, 30.0))], 2)), progress=False)
    path = tmp_path / "results.nc"
    results.save(results.to_dataset(run, states), path)
    with results.open_results(path) as kept:
        assert kept.attrs["friction_law"] == "coulomb"
        assert kept.attrs["friction_coefficient"] == 0.3
        np.testing.assert_allclose(kept["tangential_load_y"], [0, 0, 15, 30], atol=1e-3)
        for n, state in enumerate(states):
            assert np.array_equal(kept["slip_x"][n], state.slip[0])
            assert np.array_equal(kept["sticking"][n], state.sticking)
            assert kept["shift_x"][n] == state.shift[0]
            assert kept["friction_work"][n] == state.friction_work

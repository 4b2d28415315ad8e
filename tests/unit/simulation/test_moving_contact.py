# SPDX-License-Identifier: GPL-3.0-or-later
"""A moving contact: the plastic strain of the bodies moves through the grid."""

import numpy as np
import pytest
from moving_setups import (
    CELL,
    CERAMIC,
    HEATED,
    KINEMATIC,
    LOAD,
    RADIUS,
    RAMP,
    SOFT,
    STEEL,
    assert_same_track,
    ball,
    grid,
    roll,
)

import samcontact as sc

STEEL_AGAIN = sc.Material.swift(210e9, 0.3, 945e6, 20.0, np.nextafter(0.121, 1))


def fixed_frame(cells, shape, body1, body2, **settings):
    """Simulate a fixed grid over which the shape of the ball travels."""
    wide = sc.Grid(3 * cells.nx, cells.ny, cells.dx, cells.dy)
    heights = -sc.surfaces.paraboloid(wide, *shape)
    flat = np.zeros(cells.surface_shape)
    ball_shape = sc.Relief(heights, first=-cells.nx)
    return sc.Simulation(cells, body1, body2, flat, relief1=ball_shape, **settings)


@pytest.mark.parametrize(
    ("body1", "body2", "shape", "settings"),
    [
        (CERAMIC, STEEL, (RADIUS, RADIUS), {}),
        (CERAMIC, STEEL, (0.7 * RADIUS, 1.6 * RADIUS), {"friction": 0.2}),
        (CERAMIC, KINEMATIC, (RADIUS, RADIUS), {}),
        pytest.param(CERAMIC, SOFT, (RADIUS, RADIUS), {}, marks=pytest.mark.slow),
    ],
    ids=["swift", "elliptic with friction", "kinematic", "linear hardening"],
)
def test_moving_the_frame_equals_moving_the_contact(body1, body2, shape, settings):
    settings = {"tol": 1e-10, "residual_stress": "exact", **settings}
    cells = grid()
    load = 0.7 * LOAD
    there, back = roll(3, 0.0, -CELL, load), roll(3, 0.0, CELL, load)
    moved_there, moved_back = roll(3, CELL, 0.0, load), roll(3, -CELL, 0.0, load)
    start = [{"load": 0.5 * load}, {"load": load}]
    moving = ball(body1, body2, cells, shape, **settings)
    fixed = fixed_frame(cells, shape, body1, body2, **settings)
    for path, moved in ((start + there, start + moved_there), (back, moved_back)):
        here, over_there = (
            s.run(p, progress=False)[-1] for s, p in ((moving, path), (fixed, moved))
        )
        assert_same_track(here, over_there)
        # In the fixed frame the same pressure is at another position.
        cells_moved = round(over_there.travel[0] / CELL)
        np.testing.assert_allclose(
            np.roll(here.pressure, cells_moved, axis=0), over_there.pressure, rtol=0, atol=1.0
        )
    ends = [s.step(load=0.0) for s in (moving, fixed)]
    assert_same_track(*ends)


def test_the_fast_operator_agrees_with_the_exact_one():
    # Smooth on the scale of the cells, which the fast one takes the strain to be.
    cells = sc.Grid(37, 29, 40e-6, 40e-6, 16, 40e-6)
    path = [{"load": 575.0}, {"load": LOAD}, *roll(3, -40e-6, -40e-6), {"load": 0.0}]
    exact, fast = (
        ball(cells=cells, residual_stress=method, reach=0.5e-3).run(path, progress=False)[-1]
        for method in ("exact", "fast")
    )
    one, other = exact.track(margin=0), fast.track(margin=0)
    for name, tol in (("residual_displacement", 5e-3), ("equivalent_plastic_strain", 0.06)):
        a, b = (getattr(t, name)().max() for t in (one, other))
        assert a == pytest.approx(b, rel=tol), name


@pytest.mark.parametrize(
    ("settings", "body2"),
    [
        ({}, STEEL),
        ({"friction": 0.15}, KINEMATIC),
        ({"heat": sc.Heat(0.03, (0.5, 0.0))}, HEATED),
    ],
    ids=["cold", "friction and kinematic", "heated"],
)
def test_an_increment_that_moves_is_a_step_over_shifted_strain(settings, body2):
    settings = {"tol": 1e-10, "residual_stress": "exact", **settings}
    load = 0.7 * LOAD
    moving = ball(SOFT, body2, grid(25), **settings)
    before = moving.run([{"load": 0.5 * load}, {"load": load}], progress=False)[-1]
    after = moving.step(load=load, advance=(2 * CELL, -3 * CELL))

    again = ball(SOFT, body2, grid(25), **settings)
    for body, cells in ((1, 2), (2, -3)):
        shifted = [
            np.roll(f, cells, axis=axis)
            for f, axis in (
                (before.plastic_strain(body), 1),
                (before.equivalent_plastic_strain(body), 0),
                (before.backstress(body), 2),
            )
        ]
        again.set_plastic_strain(body, *shifted)
    expected = again.step(load=load)
    np.testing.assert_allclose(after.pressure, expected.pressure, rtol=0, atol=10.0)
    assert after.approach == pytest.approx(expected.approach, rel=1e-9)
    for body in (1, 2):
        for name, scale in (("stress", 1e9), ("plastic_strain", 1e-3), ("backstress", 1e9)):
            a, b = getattr(after, name)(body), getattr(expected, name)(body)
            np.testing.assert_allclose(a, b, rtol=0, atol=1e-7 * scale, err_msg=name)


@pytest.mark.parametrize("method", ["exact", "fast"])
def test_identical_rolling_bodies_stay_identical(method):
    path = [*RAMP, *roll(3), {"load": 0.0}]
    settings = {"residual_stress": method, "tol": 1e-9}
    short = ball(STEEL, STEEL, **settings).run(path, progress=False)[-1]
    general = ball(STEEL, STEEL_AGAIN, **settings).run(path, progress=False)[-1]
    for name in ("residual_displacement", "equivalent_plastic_strain", "plastic_strain"):
        upper, lower = (getattr(short.track(body), name)() for body in (1, 2))
        assert np.array_equal(upper, lower)
        for body in (1, 2):
            other = getattr(general.track(body), name)()
            np.testing.assert_allclose(other, lower, rtol=0, atol=1e-7 * np.abs(lower).max())


def test_sliding_bodies_have_separate_histories():
    # Body 1 stays under the contact, body 2 passes.
    end = ball(STEEL, STEEL).run([*RAMP, *roll(8, 0.0, -CELL), {"load": 0.0}], progress=False)[-1]
    upper, lower = end.track(1), end.track(2)
    assert upper.contact == 0
    assert lower.contact == pytest.approx(8 * CELL)
    long = [np.ptp(t.x[t.equivalent_plastic_strain().any(axis=(1, 2))]) for t in (upper, lower)]
    assert long[1] == pytest.approx(long[0] + 8 * CELL, abs=1.5 * CELL)


@pytest.mark.parametrize("increments", [100, pytest.param(500, marks=pytest.mark.slow)])
def test_a_symmetric_scene_stays_symmetric(increments):
    # The exact operator knows no mirror planes.
    cells = sc.Grid(15, 11, 1.2e-4, 1.2e-4, 8, 1e-4)
    simulation = ball(cells=cells, residual_stress="exact", reach=3e-4)
    simulation.step(load=LOAD)
    for _ in range(increments):
        state = simulation.step(load=LOAD, advance=(-1.2e-4, -1.2e-4))
    for field in (state.pressure, state.residual_displacement(), state.von_mises()[..., 0]):
        scale = np.abs(field).max()
        np.testing.assert_allclose(field, field[:, ::-1], rtol=0, atol=1e-10 * scale)
    history = state.equivalent_plastic_strain()
    np.testing.assert_allclose(history, history[:, ::-1], rtol=0, atol=1e-12)


def test_the_cost_per_increment_does_not_grow():
    simulation = ball(residual_stress="fast")
    simulation.run(RAMP, progress=False)
    work, memory = [], []
    for _ in range(60):
        before = simulation.counters["plastic_iterations"]
        simulation.step(load=LOAD, advance=(-CELL, -CELL))
        work.append(simulation.counters["plastic_iterations"] - before)
        memory.append(simulation.counters["volume_bytes"])
    # 3 and 10 contact radii are 12 and 39 cells. Memory grows by the plastic strain alone.
    assert np.mean(work[36:42]) <= 1.3 * np.mean(work[9:15])
    strain = np.diff(memory)[-8:]
    assert 0 < strain.min() <= strain.max() <= 8 * 12 * 15 * 6


def test_steady_rolling_is_steady():
    states = ball(residual_stress="fast").run([*RAMP, *roll(40)], progress=False)
    p1, p2 = states[-1].pressure, states[-5].pressure
    np.testing.assert_allclose(p1, p2, rtol=0, atol=1e-4 * p1.max())
    # The guess from the increment before saves most of the iterations.
    assert states[-1].iterations < 0.7 * states[len(RAMP)].iterations


def test_strain_beyond_the_reach():
    cells = grid(31)
    path = [*RAMP, *roll(33)]
    long, half, whole = (
        ball(cells=cells, residual_stress="fast", reach=reach).run(path, progress=False)[-1]
        for reach in (1.0, 0.5 * 31 * CELL, 31 * CELL)
    )
    for state, limit in ((half, 3e-4), (whole, 3e-5)):
        error = np.abs(state.pressure - long.pressure).max() / long.pressure.max()
        assert error < limit


def test_motion_by_fractions_of_a_cell():
    # The same way in whole cells, and from a start half a cell off: exact but for the mesh.
    errors = []
    for cells_per_radius in (3, 6):
        cell = 310e-6 / cells_per_radius
        cells = grid(8 * cells_per_radius + 1, 4 * cells_per_radius + 1, 3 * cells_per_radius, cell)
        ends = []
        for start in (0.0, 0.5 * cell):
            simulation = ball(SOFT, STEEL, cells, residual_stress="fast")
            # Body 1 alone: its cells lie between those of body 2.
            simulation.step(load=0.0, advance=(start, 0.0))
            path = [*RAMP, *roll(cells_per_radius, -2 * cell, -cell)]
            state = simulation.run(path, progress=False)[-1]
            assert state.offset(2) == 0
            assert abs(state.offset(1)) == pytest.approx(start)
            assert state.pressure.sum() * cells.cell_area == pytest.approx(LOAD, rel=1e-6)
            ends.append(state)
        peak, print_2 = (
            [max_of(s) for s in ends]
            for max_of in (lambda s: s.pressure.max(), lambda s: s.residual_displacement().max())
        )
        errors.append([abs(peak[1] / peak[0] - 1), abs(print_2[1] / print_2[0] - 1)])
    assert np.all(np.array(errors[0]) < [1.5e-2, 8e-2])
    assert np.all(np.array(errors[1]) < 0.4 * np.array(errors[0]))


def test_the_origin_moves_within_the_grid_by_fractions_of_a_cell():
    simulation = ball(residual_stress="fast")
    simulation.step(load=0.4 * LOAD)
    state = simulation.step(load=0.4 * LOAD, advance=(-0.3 * CELL, -0.3 * CELL))
    assert state.origin == pytest.approx(0.3 * CELL)
    assert state.travel == pytest.approx((-0.3 * CELL, -0.3 * CELL))
    centre = (state.pressure.sum(axis=1) @ simulation.grid.x) / state.pressure.sum()
    assert centre == pytest.approx(0.3 * CELL, abs=0.02 * CELL)
    for _ in range(9):
        state = simulation.step(load=0.4 * LOAD, advance=(-0.3 * CELL, -0.3 * CELL))
    assert state.origin == 0
    assert state.track().contact == pytest.approx(3 * CELL)


def test_a_halved_increment_reaches_its_target():
    simulation = ball(residual_stress="fast", max_iterations=9)
    simulation.run([{"load": LOAD * f} for f in np.linspace(0.05, 1.0, 20)], progress=False)
    state = simulation.step(load=LOAD, advance=(-3 * CELL, -3 * CELL))
    assert state.substeps > 1
    assert state.travel == pytest.approx((-3 * CELL, -3 * CELL), rel=1e-14)
    assert state.origin == 0


def test_automatic_increments():
    # A tolerance divides a long step over the track.
    def print_of(steps, **settings):
        simulation = ball(residual_stress="fast", **settings)
        simulation.run(RAMP, progress=False)
        advance = -4 * CELL / steps
        return simulation.run(roll(steps, advance, advance), progress=False)[-1]

    reference = print_of(16)
    errors, parts = [], []
    for state in (print_of(1), print_of(1, increment_tol=1e-2)):
        u, v = state.residual_displacement(), reference.residual_displacement()
        errors.append(np.abs(u - v).max() / v.max())
        parts.append(state.substeps)
    assert parts[1] > parts[0]
    assert errors[1] < 0.3 * errors[0]


def test_prescribed_tractions_move_with_the_contact():
    pressure = ball().step(load=LOAD).pressure
    simulation = ball(residual_stress="exact", tol=1e-10)
    simulation.step(pressure=pressure)
    state = simulation.step(pressure=pressure, advance=(0.0, -2 * CELL))
    assert_same_track(state, state)
    assert state.track().x[0] < simulation.state.track().contact
    half = simulation.step(pressure=pressure, advance=(0.0, -0.5 * CELL))
    assert half.load == pytest.approx(state.load, rel=1e-12)
    shifted = 0.5 * (pressure + np.roll(pressure, np.sign(half.origin).astype(int), axis=0))
    np.testing.assert_allclose(half.pressure, shifted, rtol=0, atol=1e-3)


def test_motion_does_not_affect_elastic_bodies():
    still = ball(CERAMIC, CERAMIC).step(load=LOAD)
    moved = ball(CERAMIC, CERAMIC).step(load=LOAD, advance=(-1e-3, 3.3e-5))
    assert np.array_equal(still.pressure, moved.pressure)
    assert moved.travel == pytest.approx((-1e-3, 3.3e-5))

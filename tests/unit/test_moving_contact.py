# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact that moves over its bodies: the bodies' plastic strain moves through the grid."""

import subprocess
import sys

import numpy as np
import pytest

import samcontact as sc

RADIUS, LOAD = 4.7625e-3, 1150.0  # p0 = 5.7 GPa
CELL = 80e-6
CERAMIC = sc.Material.elastic(310e9, 0.29)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
STEEL_AGAIN = sc.Material.swift(210e9, 0.3, 945e6, 20.0, np.nextafter(0.121, 1))
SOFT = sc.Material.linear_hardening(210e9, 0.3, 1.5e9, 20e9)
KINEMATIC = sc.Material.perfect_plastic(210e9, 0.3, 1.4e9).with_kinematic_hardening(30e9, 40.0)
HEATED = STEEL.with_thermal(50.2, 11.7e-6, 1.367e-5)
RAMP = [{"load": LOAD * f} for f in (0.25, 0.5, 0.75, 1.0)]


def grid(n=41, ny=15, nz=12, cell=CELL):
    return sc.Grid(n, ny, cell, cell, nz, 0.75 * cell)


def roll(steps, first=-CELL, second=-CELL, load=LOAD):
    return [{"load": load, "advance": (first, second)}] * steps


def ball(body1=CERAMIC, body2=STEEL, cells=None, shape=(RADIUS, RADIUS), **settings):
    cells = cells or grid()
    gap = sc.surfaces.paraboloid(cells, *shape)
    return sc.Simulation(cells, body1, body2, gap, **settings)


def assert_same_track(one, other, body=2, tol=1e-8):
    """Where both have cells; where one has none the other has no plastic strain."""
    a, b = one.track(body, margin=0), other.track(body, margin=0)
    first, last = max(a.x[0], b.x[0]), min(a.x[-1], b.x[-1])
    inside = [(t.x > first - 1e-9) & (t.x < last + 1e-9) for t in (a, b)]
    for name in ("residual_displacement", "equivalent_plastic_strain"):
        x, y = (getattr(t, name)() for t in (a, b))
        scale = np.abs(y).max()
        np.testing.assert_allclose(x[inside[0]], y[inside[1]], rtol=0, atol=tol * scale)
        if name == "equivalent_plastic_strain":
            assert scale > 1e-3
            assert not x[~inside[0]].any()
            assert not y[~inside[1]].any()


def fixed_frame(cells, shape, body1, body2, **settings):
    """The grid stays on body 2 and the ball's shape travels over it."""
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
        (CERAMIC, SOFT, (RADIUS, RADIUS), {}),
    ],
    ids=["swift", "elliptic with friction", "kinematic", "linear hardening"],
)
def test_moving_the_frame_is_moving_the_contact(body1, body2, shape, settings):
    settings = {"tol": 1e-10, "residual_stress": "exact", **settings}
    cells = grid()
    load = 0.7 * LOAD
    there, back = roll(7, 0.0, -CELL, load), roll(7, 0.0, CELL, load)
    moved_there, moved_back = roll(7, CELL, 0.0, load), roll(7, -CELL, 0.0, load)
    start = [{"load": 0.5 * load}, {"load": load}]
    moving = ball(body1, body2, cells, shape, **settings)
    fixed = fixed_frame(cells, shape, body1, body2, **settings)
    for path, moved in ((start + there, start + moved_there), (back, moved_back)):
        here, over_there = (
            s.run(p, progress=False)[-1] for s, p in ((moving, path), (fixed, moved))
        )
        assert_same_track(here, over_there)
        # The frame that stays sees the same pressure elsewhere.
        cells_moved = round(over_there.travel[0] / CELL)
        np.testing.assert_allclose(
            np.roll(here.pressure, cells_moved, axis=0), over_there.pressure, rtol=0, atol=1.0
        )
    ends = [s.step(load=0.0) for s in (moving, fixed)]
    assert_same_track(*ends)


def test_the_fast_operator_agrees_with_the_exact_one():
    # Smooth on the scale of the cells, which the fast one takes the strain to be.
    cells = sc.Grid(49, 33, 40e-6, 40e-6, 18, 40e-6)
    path = [{"load": 575.0}, {"load": LOAD}, *roll(12, -40e-6, -40e-6), {"load": 0.0}]
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
        ({"heat_factor": 0.03, "velocity": (0.5, 0.0)}, HEATED),
    ],
    ids=["cold", "friction and kinematic", "heated"],
)
def test_an_increment_that_moves_is_a_step_over_shifted_strain(settings, body2):
    settings = {"tol": 1e-10, "residual_stress": "exact", **settings}
    load = 0.7 * LOAD
    moving = ball(SOFT, body2, **settings)
    before = moving.run([{"load": 0.5 * load}, {"load": load}], progress=False)[-1]
    after = moving.step(load=load, advance=(2 * CELL, -3 * CELL))

    again = ball(SOFT, body2, **settings)
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
    path = [*RAMP, *roll(12), {"load": 0.0}]
    settings = {"residual_stress": method, "tol": 1e-9}
    short = ball(STEEL, STEEL, **settings).run(path, progress=False)[-1]
    general = ball(STEEL, STEEL_AGAIN, **settings).run(path, progress=False)[-1]
    for name in ("residual_displacement", "equivalent_plastic_strain", "plastic_strain"):
        upper, lower = (getattr(short.track(body), name)() for body in (1, 2))
        assert np.array_equal(upper, lower)
        for body in (1, 2):
            other = getattr(general.track(body), name)()
            np.testing.assert_allclose(other, lower, rtol=0, atol=1e-7 * np.abs(lower).max())


def test_bodies_that_slide_have_histories_of_their_own():
    # Body 1 stays under the contact, body 2 passes.
    end = ball(STEEL, STEEL).run([*RAMP, *roll(8, 0.0, -CELL), {"load": 0.0}], progress=False)[-1]
    upper, lower = end.track(1), end.track(2)
    assert upper.contact == 0
    assert lower.contact == pytest.approx(8 * CELL)
    long = [np.ptp(t.x[t.equivalent_plastic_strain().any(axis=(1, 2))]) for t in (upper, lower)]
    assert long[1] == pytest.approx(long[0] + 8 * CELL, abs=1.5 * CELL)


def test_a_symmetric_scene_stays_symmetric():
    # The exact operator knows no mirror planes.
    cells = sc.Grid(15, 11, 1.2e-4, 1.2e-4, 8, 1e-4)
    simulation = ball(cells=cells, residual_stress="exact", reach=3e-4)
    simulation.step(load=LOAD)
    for _ in range(500):
        state = simulation.step(load=LOAD, advance=(-1.2e-4, -1.2e-4))
    for field in (state.pressure, state.residual_displacement(), state.von_mises()[..., 0]):
        scale = np.abs(field).max()
        np.testing.assert_allclose(field, field[:, ::-1], rtol=0, atol=1e-10 * scale)
    history = state.equivalent_plastic_strain()
    np.testing.assert_allclose(history, history[:, ::-1], rtol=0, atol=1e-12)


def test_what_is_done_per_increment_does_not_grow():
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
    assert strain.max() == strain.min() <= 8 * 12 * 15 * 6


def test_steady_rolling_is_steady():
    states = ball(residual_stress="fast").run([*RAMP, *roll(40)], progress=False)
    p1, p2 = states[-1].pressure, states[-5].pressure
    np.testing.assert_allclose(p1, p2, rtol=0, atol=1e-4 * p1.max())
    # The guess from the increment before saves most of the iterations.
    assert states[-1].iterations < 0.7 * states[len(RAMP)].iterations


@pytest.mark.parametrize("reach", [0.5, 1.0])
def test_strain_beyond_the_reach(reach):
    cells = grid(31)
    path = [*RAMP, *roll(40)]
    long = ball(cells=cells, residual_stress="fast", reach=1.0).run(path, progress=False)[-1]
    short = ball(cells=cells, residual_stress="fast", reach=reach * 31 * CELL)
    state = short.run(path, progress=False)[-1]
    error = np.abs(state.pressure - long.pressure).max() / long.pressure.max()
    assert error < {0.5: 3e-4, 1.0: 3e-5}[reach]


def test_parts_of_a_cell():
    # The same way in whole cells, and from a start half a cell off: exact but for the mesh.
    errors = []
    for cells_per_radius in (4, 8):
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
    assert np.all(np.array(errors[0]) < [1e-2, 6e-2])
    assert np.all(np.array(errors[1]) < 0.4 * np.array(errors[0]))


def test_the_origin_moves_within_the_grid_by_parts_of_a_cell():
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


def test_a_halved_increment_arrives_where_it_should():
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
        advance = -8 * CELL / steps
        return simulation.run(roll(steps, advance, advance), progress=False)[-1]

    reference = print_of(64)
    errors, parts = [], []
    for state in (print_of(2), print_of(2, increment_tol=1e-2)):
        u, v = state.residual_displacement(), reference.residual_displacement()
        errors.append(np.abs(u - v).max() / v.max())
        parts.append(state.substeps)
    assert parts[1] > parts[0]
    assert errors[1] < 0.3 * errors[0]


def test_prescribed_tractions_go_with_the_contact():
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


def test_elastic_bodies_do_not_notice():
    still = ball(CERAMIC, CERAMIC).step(load=LOAD)
    moved = ball(CERAMIC, CERAMIC).step(load=LOAD, advance=(-1e-3, 3.3e-5))
    assert np.array_equal(still.pressure, moved.pressure)
    assert moved.travel == pytest.approx((-1e-3, 3.3e-5))


@pytest.mark.parametrize("body", [1, 2])
def test_relief_moves_with_its_body(body):
    cells = sc.Grid(33, 21, CELL, CELL)
    heights = 1e-6 * np.random.default_rng(1).standard_normal((60, 21))
    rough = ball(CERAMIC, CERAMIC, cells, **{f"relief{body}": sc.Relief(heights, first=-10)})
    advance = [0.0, 0.0]
    advance[body - 1] = 4 * CELL
    state = rough.step(load=LOAD, advance=advance)
    gap = sc.surfaces.paraboloid(cells, RADIUS) - heights[6:39]
    expected = sc.Simulation(cells, CERAMIC, CERAMIC, gap).step(load=LOAD)
    assert np.array_equal(state.pressure, expected.pressure)


def test_periodic_relief_and_its_end():
    cells = sc.Grid(33, 21, CELL, CELL)
    heights = 1e-6 * np.random.default_rng(2).standard_normal((7, 21))
    for periodic in (True, False):
        relief = sc.Relief(heights, periodic=periodic)
        state = ball(CERAMIC, CERAMIC, cells, relief2=relief).step(load=LOAD, advance=(0, 2 * CELL))
        rows = np.arange(33) - 2
        surface = heights[rows % 7]
        if not periodic:
            surface[(rows < 0) | (rows >= 7)] = 0.0
        gap = sc.surfaces.paraboloid(cells, RADIUS) - surface
        expected = sc.Simulation(cells, CERAMIC, CERAMIC, gap).step(load=LOAD)
        assert np.array_equal(state.pressure, expected.pressure)


def test_relief_of_two_bodies_between_each_others_cells():
    # Waves long enough for the mean of two neighbours.
    cells = sc.Grid(33, 21, CELL, CELL)
    rows = np.arange(-40, 80)
    wave = lambda shift: 1e-6 * np.sin(2 * np.pi * (rows[:, None] - shift) / 30) * np.ones(21)  # noqa: E731
    moved = ball(
        CERAMIC,
        CERAMIC,
        cells,
        relief1=sc.Relief(wave(0.0), first=-40),
        relief2=sc.Relief(wave(0.0), first=-40),
    ).step(load=LOAD, advance=(0.4 * CELL, 0.0))
    gap = sc.surfaces.paraboloid(cells, RADIUS) - wave(0.0)[40:73] - wave(0.4)[40:73]
    expected = sc.Simulation(cells, CERAMIC, CERAMIC, gap).step(load=LOAD)
    error = np.abs(moved.pressure - expected.pressure).max() / expected.pressure.max()
    assert 0 < error < 2e-3


def test_past_heat_moves_with_the_material():
    step = CELL / 0.5  # s, one cell at 0.5 m/s
    settings = {"heat_factor": 0.03, "velocity": (0.5, 0.0), "heat_history": (step, 1.0)}
    simulation = ball(CERAMIC, HEATED, **settings)
    for load in (0.3, 0.6, 0.6, 0.6):
        state = simulation.step(load=load * LOAD, duration=step, advance=(0.0, CELL))
    surface = state.surface_temperature()[:, 7]
    assert surface[30] > 10 * surface[10]  # downstream
    with pytest.raises(ValueError, match="whole number of cells"):
        simulation.step(load=LOAD, duration=step, advance=(0.0, 0.5 * CELL))
    with pytest.raises(ValueError, match="velocity times duration"):
        simulation.step(load=LOAD, duration=step, advance=(0.0, -CELL))


def test_bad_motion():
    simulation = ball()
    for advance in ((1e-6,), (np.nan, 0.0), (0.0, np.inf), 1e-6):
        with pytest.raises((ValueError, TypeError), match="advance"):
            simulation.step(load=100.0, advance=advance)
    with pytest.raises(ValueError, match=r"reach must be .*-1"):
        ball(reach=-1.0)
    with pytest.raises(TypeError, match="relief1 must be a Relief"):
        ball(relief1=np.zeros((15, 15)))
    with pytest.raises(ValueError, match=r"relief2 must have heights of shape \(rows, 15\)"):
        ball(relief2=sc.Relief(np.zeros((41, 14))))
    for heights in (np.zeros(5), np.full((3, 15), np.nan)):
        with pytest.raises(ValueError, match="heights"):
            sc.Relief(heights)
    with pytest.raises(TypeError, match="first must be an integer, got nan"):
        sc.Relief(np.zeros((3, 15)), first=float("nan"))
    with pytest.raises(ValueError, match="margin"):
        simulation.state.track(margin=-1)
    with pytest.raises(ValueError, match="body"):
        simulation.state.track(3)


def test_a_track_without_plastic_strain_is_flat():
    track = ball().state.track()
    assert not track.residual_displacement().any()
    assert not track.residual_von_mises().any()
    assert "Track(body=2" in repr(track)


RESUMED = """
import os, signal, sys
sys.path.insert(0, sys.argv[2])
from test_moving_contact import LOAD, RAMP, SOFT, STEEL, CELL, ball, roll
simulation = ball(SOFT, STEEL, residual_stress="fast")
simulation.run([*RAMP, *roll(5, -1.4 * CELL, -CELL)], progress=False)
simulation.save(sys.argv[1])
for arguments in roll(50, -1.4 * CELL, -CELL):
    simulation.step(**arguments)
    os.kill(os.getpid(), signal.SIGKILL)
"""


def test_killed_and_resumed_bit_for_bit(tmp_path):
    checkpoint = tmp_path / "rolling.h5"
    folder = __file__.rpartition("/")[0]
    killed = subprocess.run([sys.executable, "-c", RESUMED, checkpoint, folder], check=False)
    assert killed.returncode == -9
    rest = [*roll(6, -1.4 * CELL, -CELL), {"load": 0.0}]
    resumed = sc.Simulation.load(checkpoint).run(rest, progress=False)[-1]
    through = ball(SOFT, STEEL, residual_stress="fast")
    path = [*RAMP, *roll(5, -1.4 * CELL, -CELL), *rest]
    whole = through.run(path, progress=False)[-1]
    for body in (1, 2):
        for name in ("residual_displacement", "residual_stress", "equivalent_plastic_strain"):
            one, other = (getattr(s.track(body), name)() for s in (resumed, whole))
            assert np.array_equal(one, other), name
    assert resumed.travel == whole.travel


def test_a_checkpoint_keeps_the_relief(tmp_path):
    heights = 1e-6 * np.random.default_rng(3).standard_normal((50, 15))
    settings = {"relief1": sc.Relief(heights, first=-4, periodic=True), "reach": 1e-3}
    simulation = ball(**settings)
    simulation.step(load=0.5 * LOAD)
    simulation.save(tmp_path / "c.h5")
    again = sc.Simulation.load(tmp_path / "c.h5")
    assert again.reach == 1e-3
    move = {"load": 0.5 * LOAD, "advance": (3 * CELL, 0.0)}
    assert np.array_equal(again.step(**move).pressure, simulation.step(**move).pressure)


@pytest.mark.parametrize("body2", [STEEL, KINEMATIC], ids=["swift", "kinematic"])
def test_a_track_can_be_gone_on_from_in_another_simulation(body2):
    """Longer than the grid: it is set by rows that lie beside it."""
    settings = {"tol": 1e-10, "residual_stress": "exact"}
    first = ball(body2=body2, **settings)
    there = 34
    first.run([{"load": LOAD}, *roll(there, 0.0, -CELL), {"load": 0.0}], progress=False)
    back = first.step(load=0.0, advance=(0.0, there * CELL))
    track = back.track(margin=3)
    assert track.grid.nx > first.grid.nx

    second = ball(body2=body2, **settings)
    second.set_plastic_strain(
        2,
        track.plastic_strain(),
        track.equivalent_plastic_strain(),
        track.backstress(),
        track.first,
    )
    again = [{"load": LOAD}, *roll(3, 0.0, -CELL), {"load": 0.0}]
    states = [s.run(again, progress=False)[-1] for s in (first, second)]
    assert_same_track(*states)
    tracks = [s.track(margin=0) for s in states]
    last = min(t.first + t.grid.nx for t in tracks)
    start = max(t.first for t in tracks)
    expected, found = (t.backstress()[:, :, start - t.first : last - t.first] for t in tracks)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-8 * np.abs(expected).max(initial=1))


def test_a_track_that_does_not_fit():
    simulation = ball()
    shape = (6, 5, simulation.grid.ny, simulation.grid.nz)
    with pytest.raises(ValueError, match=r"strain must have shape"):
        simulation.set_plastic_strain(2, np.zeros(shape))
    simulation.set_plastic_strain(2, np.zeros(shape), first=-2)
    with pytest.raises(ValueError, match=r"equivalent must have shape"):
        simulation.set_plastic_strain(2, np.zeros(shape), np.zeros((4, *shape[2:])), first=-2)
    with pytest.raises(TypeError, match="first must be an integer"):
        simulation.set_plastic_strain(2, np.zeros(shape), first=0.5)

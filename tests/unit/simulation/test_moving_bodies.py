# SPDX-License-Identifier: GPL-3.0-or-later
"""Relief, heat and checkpoints of bodies that move through the contact."""

import subprocess
import sys

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

    def wave(shift):
        return 1e-6 * np.sin(2 * np.pi * (rows[:, None] - shift) / 30) * np.ones(21)

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
    settings = {"heat": sc.Heat(0.03, (0.5, 0.0), history=(step, 1.0))}
    simulation = ball(CERAMIC, HEATED, **settings)
    for load in (0.3, 0.6, 0.6, 0.6):
        state = simulation.step(load=load * LOAD, duration=step, advance=(0.0, CELL))
    surface = state.surface_temperature()[:, 7]
    assert surface[30] > 10 * surface[10]  # downstream
    with pytest.raises(ValueError, match="multiple of the cell size"):
        simulation.step(load=LOAD, duration=step, advance=(0.0, 0.5 * CELL))
    with pytest.raises(ValueError, match="velocity x duration"):
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
from moving_setups import LOAD, RAMP, SOFT, STEEL, CELL, ball, roll
simulation = ball(SOFT, STEEL, residual_stress="fast")
simulation.run([*RAMP, *roll(5, -1.4 * CELL, -CELL)], progress=False)
simulation.save(sys.argv[1])
for arguments in roll(50, -1.4 * CELL, -CELL):
    simulation.step(**arguments)
    os.kill(os.getpid(), signal.SIGKILL)
"""


def test_a_resumed_run_is_bit_identical(tmp_path):
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


@pytest.mark.parametrize(
    "body2",
    [pytest.param(STEEL, marks=pytest.mark.slow), KINEMATIC],
    ids=["swift", "kinematic"],
)
def test_a_track_can_be_continued_in_another_simulation(body2):
    """A travel longer than the grid, set by rows outside it."""
    settings = {"tol": 1e-10, "residual_stress": "exact"}
    first = ball(body2=body2, cells=grid(25), **settings)
    there = 20
    there_by_twos = roll(there // 2, 0.0, -2 * CELL)
    first.run([{"load": LOAD}, *there_by_twos, {"load": 0.0}], progress=False)
    back = first.step(load=0.0, advance=(0.0, there * CELL))
    track = back.track(margin=3)
    assert track.grid.nx > first.grid.nx

    second = ball(body2=body2, cells=grid(25), **settings)
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


def test_a_track_of_wrong_shape_is_refused():
    simulation = ball()
    shape = (6, 5, simulation.grid.ny, simulation.grid.nz)
    with pytest.raises(ValueError, match=r"strain must have shape"):
        simulation.set_plastic_strain(2, np.zeros(shape))
    simulation.set_plastic_strain(2, np.zeros(shape), first=-2)
    with pytest.raises(ValueError, match=r"equivalent must have shape"):
        simulation.set_plastic_strain(2, np.zeros(shape), np.zeros((4, *shape[2:])), first=-2)
    with pytest.raises(TypeError, match="first must be an integer"):
        simulation.set_plastic_strain(2, np.zeros(shape), first=0.5)

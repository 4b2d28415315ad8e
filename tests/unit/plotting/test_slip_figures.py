# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of partial slip: contents, and the figures written by a run."""

import math

import numpy as np
import PIL.Image
import pytest
from drawn_fields import drawn_values
from matplotlib.quiver import Quiver

import samcontact as sc
from samcontact import plotting
from samcontact.plotting.slip_animation import course_of
from samcontact.plotting.slip_summary import chosen
from samcontact.plotting.slipping import STICK_AND_SLIP_COLOURS, creepages
from samcontact.results import to_dataset

GRID = sc.Grid(21, 19, 40e-6, 44e-6)
BALL = sc.Material.elastic(210e9, 0.3)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
LOAD, MU = 300.0, 0.3
LAW = sc.Coulomb(MU)


def run(path, friction=LAW):
    simulation = sc.Simulation(GRID, BALL, BALL, GAP, friction)
    states = simulation.run([{"load": LOAD}, *path], progress=False)
    return states, to_dataset(simulation, states)


@pytest.fixture(scope="module")
def fretting():
    return run(sc.paths.fretting_loop(load=LOAD, force=(42.0, 42.0), increments=8))


@pytest.fixture(scope="module")
def rolling():
    distance = -GRID.dx
    path = []
    for xi in (1e-3, 4e-3):
        travels = {"advance": (distance * (1 - xi / 2), distance * (1 + xi / 2))}
        path += [{"load": LOAD, "shift": (0.0, 1e-4 * distance)} | travels] * 4
    return run(path)


def test_the_map_shows_each_cell_and_the_directions_of_slip(fretting):
    state = fretting[0][8]
    ax = plotting.partial_slip_map(state.pressure, state.slip, GRID, unit="m")
    assert 0 < state.sticking.sum() < np.count_nonzero(state.pressure)
    (arrows,) = (item for item in ax.collections if isinstance(item, Quiver))
    assert 10 < arrows.N < np.count_nonzero(state.pressure)
    for x, y, u, v in zip(arrows.X, arrows.Y, arrows.U, arrows.V, strict=True):
        cell = np.argmin(abs(GRID.x - x * 1e-6)), np.argmin(abs(GRID.y - y * 1e-6))
        slip = state.slip[:, cell[0], cell[1]]
        assert math.atan2(v, u) == pytest.approx(math.atan2(slip[1], slip[0]))
    largest = np.hypot(*state.slip).max()
    assert f"{largest * 1e9:.3g} nm" in ax.get_title()
    stated = [text.get_text() for text in ax.get_legend().get_texts()]
    assert stated == ["stick", "slip"]
    kinds = drawn_values(ax, GRID.x, GRID.y)
    np.testing.assert_array_equal(kinds == 0, state.sticking)
    np.testing.assert_array_equal(np.isnan(kinds), state.pressure == 0)
    assert len(set(STICK_AND_SLIP_COLOURS)) == 2


def test_a_horizontal_map_is_the_rotated_map(fretting):
    """A horizontal map is rotated by 90 degrees clockwise in cells, arrows and labels."""
    state = fretting[0][8]
    stands, lies = (
        plotting.partial_slip_map(state.pressure, state.slip, GRID, across=across)
        for across in "xy"
    )
    kinds = drawn_values(lies, GRID.y, GRID.x)
    np.testing.assert_array_equal(kinds.T, drawn_values(stands, GRID.x, GRID.y))
    one, two = (
        next(item for item in ax.collections if isinstance(item, Quiver)) for ax in (stands, lies)
    )
    arrows = sorted(zip(one.X, one.Y, one.U, one.V, strict=True))
    np.testing.assert_allclose(arrows, sorted(zip(two.Y, two.X, two.V, two.U, strict=True)))
    assert (lies.get_xlabel(), lies.get_ylabel()) == ("y [µm]", "x [µm]")
    low, high = lies.get_ylim()
    assert low > high  # x downward


def test_a_map_without_slip_is_labelled(fretting):
    state = fretting[0][0]
    ax = plotting.partial_slip_map(state.pressure, np.zeros((2, 21, 19)), GRID)
    assert ax.get_title() == "no slip"
    assert not any(isinstance(item, Quiver) for item in ax.collections)


def test_shear_lies_between_its_bounds(fretting):
    state = fretting[0][8]
    ax = plotting.shear_profile(state.pressure, state.shear, GRID, MU, component="y")
    shear, upper, lower = (line.get_ydata() for line in ax.lines)
    np.testing.assert_allclose(shear, state.shear[1, :, 9] * 1e-6)
    np.testing.assert_allclose(upper, MU * state.pressure[:, 9] * 1e-6)
    np.testing.assert_array_equal(lower, -upper)
    assert len(plotting.shear_profile(state.pressure, state.shear, GRID, math.inf).lines) == 1


def test_the_loop_area_is_the_friction_work(fretting):
    """Between two states of equal force, the work of the forces is dissipated by friction."""
    states, data = fretting
    area = 0.0
    for direction in "xy":
        ax = plotting.fretting_loop(data, direction=direction)
        (line,) = ax.lines
        assert ax.get_xlabel() == f"tangential displacement, {direction} [µm]"
        x, y = line.get_xdata()[-33:] * 1e-6, line.get_ydata()[-33:]
        area += np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(x))
    work = states[-1].friction_work - states[-33].friction_work
    assert area == pytest.approx(work, rel=0.02)
    assert f"{states[-1].friction_work * 1e6:.4g} µJ" in ax.get_title()


def test_creepages_are_the_given_ones(rolling):
    states, data = rolling
    xi, force = creepages(data, "x")
    np.testing.assert_allclose(xi, [1e-3] * 4 + [4e-3] * 4, rtol=1e-9)
    np.testing.assert_allclose(force, [state.tangential_load[0] for state in states[1:]])
    np.testing.assert_allclose(creepages(data, "y")[0], -1e-4, rtol=1e-9)
    ax = plotting.creep_curve(xi, force, largest=MU * LOAD)
    curve, bound = ax.lines
    np.testing.assert_allclose(curve.get_xdata(), xi * 100)
    assert set(bound.get_ydata()) == {MU * LOAD}


def test_forces_along_the_distance_rolled(rolling):
    ax = plotting.rolling_force(rolling[1])
    curve, bound = ax.lines
    np.testing.assert_allclose(curve.get_xdata(), np.arange(9) * GRID.dx * 1e6, atol=1e-9)
    np.testing.assert_allclose(curve.get_ydata(), rolling[1]["tangential_load_x"])
    assert bound.get_ydata() == pytest.approx([MU * LOAD] * 2)


def test_the_map_is_that_of_the_largest_force(fretting, rolling):
    assert chosen(fretting[1]) == 40
    force = abs(rolling[1]["tangential_load_x"].values)
    assert force[chosen(rolling[1])] == pytest.approx(force.max(), rel=2e-3)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_runs_write_slip_figures(fretting, rolling, tmp_path, undrawn):
    names = [path.name for path in plotting.summary_figures(fretting[1], tmp_path)]
    assert names[-2:] == ["partial_slip.png", "fretting_loop.png"]
    names = [path.name for path in plotting.summary_figures(rolling[1], tmp_path)]
    assert names[-3:] == ["partial_slip.png", "rolling_force.png", "creep_curve.png"]
    steady = rolling[1].isel(increment=slice(0, 5))  # of one creepage, which is no curve
    names = [path.name for path in plotting.summary_figures(steady, tmp_path)]
    assert names[-2:] == ["partial_slip.png", "rolling_force.png"]
    _, slides = run([], friction=0.3)
    written = plotting.summary_figures(slides, tmp_path)
    assert not {"partial_slip.png", "fretting_loop.png"} & {path.name for path in written}
    with pytest.raises(ValueError, match="dataset must be from a run with partial slip"):
        plotting.fretting_loop(slides)
    with pytest.raises(ValueError, match="dataset must be from a run with rolling bodies"):
        plotting.rolling_force(fretting[1])


def test_an_animation_shows_each_increment(fretting, rolling, tmp_path):
    states, _ = fretting
    animation = plotting.partial_slip_animation(states[::8])
    left, right = animation._fig.axes[:2]
    animation._fig.canvas.draw()  # which begins with the first frame
    animation._func(1)
    (point,) = (line for line in right.lines if line.get_marker() == "o")
    assert point.get_ydata() == pytest.approx([states[8].tangential_load[0]])
    kinds = drawn_values(left, GRID.x, GRID.y)
    np.testing.assert_array_equal(kinds == 0, states[8].sticking)
    assert point.get_xdata() == pytest.approx([states[8].shift[0] * 1e6])
    low, high = left.get_xlim()
    assert low < GRID.x[states[8].pressure.any(axis=1)][0] * 1e6 < 0 < high
    path = plotting.save_animation(animation, tmp_path / "a.gif", dpi=40)
    with PIL.Image.open(path) as image:
        assert image.n_frames == len(states[::8]) > 2
    course = course_of(rolling[0])
    np.testing.assert_allclose(course.across, np.arange(9) * GRID.dx * 1e6, atol=1e-9)
    np.testing.assert_allclose(course.force, rolling[1]["tangential_load_x"])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: plotting.partial_slip_map(s.pressure, s.slip[0], GRID), "slip must have shape"),
        (lambda s: plotting.partial_slip_map(s.pressure, s.slip, GRID, unit="km"), "unit must be"),
        (
            lambda s: plotting.partial_slip_map(s.pressure, s.slip, GRID, across="z"),
            "across must be",
        ),
        (lambda s: plotting.shear_profile(s.pressure, s.shear, GRID, -1.0), "coefficient must be"),
        (lambda s: plotting.creep_curve([1.0, 2.0], [1.0]), "force must have shape"),
        (lambda s: plotting.partial_slip_animation([]), "at least one state, got none"),
        (lambda s: plotting.partial_slip_animation([s], interval=0.0), "interval must be a finite"),
    ],
)
def test_bad_input_is_named(fretting, call, message):
    with pytest.raises(ValueError, match=message):
        call(fretting[0][8])

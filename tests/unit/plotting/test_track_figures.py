# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures and animation of a moving contact: the data shown, in the frame of the body."""

import matplotlib.animation
import numpy as np
import pytest
import xarray as xr
from drawn_fields import shows
from matplotlib.figure import Figure
from PIL import Image

import samcontact as sc
from samcontact import plotting, results
from samcontact.plotting.track import positions_on_body, track_summary
from samcontact.results.motion import track_of

SOFT = sc.Material.swift(210e9, 0.3, 945e6, 20, 0.121)
STEP = 60e-6
GRID = sc.Grid(15, 13, STEP, STEP, 12, STEP)
DISTANCE = 10  # cells in a pass


def make_simulation(body1=None):
    steel = sc.Material.elastic(210e9, 0.3)
    return sc.Simulation(GRID, body1 or steel, SOFT, sc.surfaces.paraboloid(GRID, 7.5e-3))


def run(steps, body1=None):
    return make_simulation(body1).run(steps, progress=False)


@pytest.fixture(scope="module")
def states():
    return run(
        sc.paths.rolling(load=700.0, distance=DISTANCE * STEP, step=2.5 * STEP, increments=1)
    )


@pytest.fixture(scope="module")
def track(states):
    return states[-1].track(2)


@pytest.fixture(scope="module")
def shown(track):
    return track.to_dataset()


@pytest.fixture
def ax():
    return Figure().subplots()


def test_cell_positions_are_those_of_the_track():
    steps = sc.paths.rolling(
        load=700.0, distance=2 * STEP, step=0.8 * STEP, slide_to_roll=-0.3, increments=1
    )
    for state in run(steps, body1=SOFT):
        for body in (1, 2):
            x, cells = positions_on_body(state, body), state.track(body, margin=GRID.nx)
            first = np.argmin(np.abs(cells.x - x[0]))
            np.testing.assert_allclose(cells.x[first : first + GRID.nx], x, atol=1e-9 * STEP)
            # and what lies there is the same
            np.testing.assert_allclose(
                cells.equivalent_plastic_strain()[first : first + GRID.nx],
                state.equivalent_plastic_strain(body),
                atol=1e-15,
            )


def test_figures_of_a_track_and_of_results_agree(states, shown):
    dataset = results.to_dataset(make_simulation(), states)
    xr.testing.assert_identical(track_of(dataset, 2), shown)
    assert track_of(dataset, 1) is None  # elastic
    assert shown["residual_stress"].attrs["units"] == "Pa"


def test_imprint_along_the_track(track, shown, ax):
    assert plotting.track_imprint(shown, ax, positions=(0.0, 1.9 * STEP)) is ax
    u = track.residual_displacement() * 1e9  # small: in nm
    for line, row, label in zip(ax.get_lines(), (6, 8), ("y = 0 µm", "y = 120 µm"), strict=True):
        np.testing.assert_allclose(line.get_xdata(), track.x * 1e6)
        np.testing.assert_allclose(line.get_ydata(), u[:, row])
        assert line.get_label() == label
    assert ax.yaxis_inverted()
    assert ax.get_xlabel() == "x on body 2 [µm]"


def test_imprint_across_the_track(track, shown, ax):
    plotting.track_imprint(shown, ax, axis="y", positions=(0.0, DISTANCE * STEP))
    u = track.residual_displacement() * 1e9
    rows = [int(np.argmin(np.abs(track.x - x))) for x in (0.0, DISTANCE * STEP)]
    assert rows[1] - rows[0] == DISTANCE
    for line, row in zip(ax.get_lines(), rows, strict=True):
        np.testing.assert_allclose(line.get_xdata(), GRID.y * 1e6)
        np.testing.assert_allclose(line.get_ydata(), u[row])
    assert ax.get_lines()[1].get_label() == "x = 600 µm"


@pytest.mark.parametrize(
    ("quantity", "method", "factor"),
    [
        ("residual_von_mises", "residual_von_mises", 1e-6),
        ("residual_hydrostatic", "residual_hydrostatic", 1e-6),
        ("equivalent_plastic_strain", "equivalent_plastic_strain", 1e2),
    ],
)
def test_section_along_the_track(track, shown, ax, quantity, method, factor):
    assert plotting.track_section(shown, ax, quantity=quantity, cells=True) is ax
    (mesh,) = ax.collections
    values = getattr(track, method)()[:, 6, :]
    np.testing.assert_allclose(mesh.get_array(), values.T * factor)
    corners = mesh.get_coordinates()
    assert corners[0, 0, 0] == pytest.approx((track.x[0] - STEP / 2) * 1e6)
    assert corners[0, -1, 0] == pytest.approx((track.x[-1] + STEP / 2) * 1e6)
    assert corners[-1, 0, 1] == pytest.approx(12 * STEP * 1e6)
    assert ax.yaxis_inverted()
    assert ax.get_xlabel() == "x on body 2 [µm]"
    assert ax.get_title().endswith("[%]" if factor == 1e2 else "[MPa]")


def test_section_across_the_track(track, shown, ax):
    plotting.track_section(shown, ax, quantity="xx", plane="x", position=5.2 * STEP, cells=True)
    row = int(np.argmin(np.abs(track.x - 5 * STEP)))
    (mesh,) = ax.collections
    np.testing.assert_allclose(mesh.get_array(), track.residual_stress()[0, row].T * 1e-6)
    assert ax.get_title() == r"residual $\sigma_{xx}$ [MPa]"
    assert ax.get_xlabel() == "y [µm]"


def test_section_under_load_moves_with_the_contact(states, ax):
    state = states[3]
    plotting.loaded_section(state, ax, cells=True)
    (mesh,) = ax.collections
    np.testing.assert_allclose(mesh.get_array(), state.von_mises()[:, 6, :].T * 1e-6)
    middle = mesh.get_coordinates()[0, :, 0].mean()
    # parts of a cell: the cells stay those of the body
    assert middle == pytest.approx(-state.travel[1] * 1e6, abs=0.51 * STEP * 1e6)
    across = plotting.loaded_section(
        state, quantity="zz", plane="x", position=-state.travel[1], cells=True
    )
    row = int(np.argmin(np.abs(positions_on_body(state, 2) + state.travel[1])))
    np.testing.assert_allclose(across.collections[0].get_array(), state.stress()[2, row].T * 1e-6)


def test_summary(states, track, shown):
    figures = track_summary(shown, np.array([state.travel[1] for state in states]))
    assert list(figures) == ["track_imprint", "track_sections"]
    along, across = figures["track_imprint"].axes
    assert len(along.get_lines()) == 1
    assert (along.get_title(), along.get_legend()) == ("y = 0 µm", None)
    labels = [line.get_label() for line in across.get_lines()]
    assert labels == ["x = 0 µm", "x = 300 µm", "x = 600 µm"]
    fields = ("residual_von_mises", "residual_hydrostatic", "equivalent_plastic_strain")
    for ax, name in zip(figures["track_sections"].axes, fields, strict=False):
        values = getattr(track, name)()[:, 6, :] * (1e2 if "strain" in name else 1e-6)
        assert shows(ax, track.x, GRID.z, values, within=0.1)
    assert figures["track_sections"].axes[3].get_title().endswith("[MPa], x = 300 µm")


def test_summary_profiles_run_through_the_maximum(states, shown):
    moved = shown.copy(deep=True)
    values = shown["residual_von_mises"].values
    moved["residual_von_mises"].values[:] = np.roll(values, 3, axis=1)
    row = int(np.argmax(moved["residual_von_mises"].values.max(axis=(0, 2))))
    figures = track_summary(moved, np.array([state.travel[1] for state in states]))
    first = figures["track_sections"].axes[0]
    expected = moved["residual_von_mises"].values[:, row] * 1e-6
    assert first.get_title().endswith(f"y = {float(moved['y'][row]) * 1e6:.4g} µm")
    assert shows(first, moved["x"].values, GRID.z, expected, within=0.1)


def test_bad_input_is_named(states, shown, ax):
    with pytest.raises(ValueError, match="axis must be one of 'x', 'y', got 'z'"):
        plotting.track_imprint(shown, ax, axis="z")
    with pytest.raises(ValueError, match="positions must contain at least one value"):
        plotting.track_imprint(shown, ax, positions=())
    with pytest.raises(ValueError, match="positions must be a finite number, got nan"):
        plotting.track_imprint(shown, ax, positions=(np.nan,))
    with pytest.raises(
        ValueError, match=r"quantity must be one of 'residual_von_mises', .* 'heat'"
    ):
        plotting.track_section(shown, ax, quantity="heat")
    with pytest.raises(ValueError, match="plane must be one of 'y', 'x', got 'z'"):
        plotting.track_section(shown, ax, plane="z")
    with pytest.raises(ValueError, match=r"quantity must be one of 'von_mises', .* got 'heat'"):
        plotting.loaded_section(states[0], ax, quantity="heat")
    with pytest.raises(ValueError, match="body must be one of 1, 2, got 3"):
        plotting.loaded_section(states[0], ax, body=3)
    steel = sc.Material.elastic(210e9, 0.3)
    grid = sc.Grid(15, 13, STEP, STEP)
    flat = sc.Simulation(grid, steel, steel, sc.surfaces.paraboloid(grid, 7.5e-3)).step(load=100.0)
    for call in (plotting.loaded_section, lambda s: plotting.rolling_animation([s])):
        with pytest.raises(ValueError, match="grid must have layers, got a grid without dz"):
            call(flat)


class Recorder(matplotlib.animation.AbstractMovieWriter):
    """Movie writer that stores the contents of each frame."""

    def __init__(self):
        super().__init__()
        self.frames = []

    def setup(self, fig, outfile, dpi=None):
        super().setup(fig, outfile, dpi=dpi)

    def grab_frame(self, **_):
        above, middle, below, *_ = self.fig.axes
        (image,) = middle.images
        lines = [ax.get_lines()[0].get_xydata().copy() for ax in (above, below)]
        self.frames.append((above.get_title(), *lines, np.array(image.get_array())))

    def finish(self):
        pass

    @classmethod
    def isAvailable(cls):
        return True


@pytest.fixture(scope="module")
def animation(states):
    made = plotting.rolling_animation(states)
    made._fig.canvas.draw()  # otherwise its deletion warns, in any later test
    return made


class TestAnimation:
    def test_frames_show_the_states(self, states, animation, tmp_path):
        recorder = Recorder()
        animation.save(tmp_path / "none", writer=recorder)
        assert len(recorder.frames) == len(states)
        left = min(positions_on_body(state, 2)[0] for state in states)
        for state, (title, pressure, print_, section) in zip(states, recorder.frames, strict=True):
            place = -state.travel[1]
            assert f"load {state.load:.4g} N, contact at {place * 1e6 + 0.0:.4g} µm" == title
            x = GRID.x - state.origin + place
            np.testing.assert_allclose(pressure[:, 0], x * 1e6)
            np.testing.assert_allclose(pressure[:, 1], state.pressure[:, 6] * 1e-9)
            track = state.track(2)
            np.testing.assert_allclose(print_[:, 0], track.x * 1e6)
            np.testing.assert_allclose(print_[:, 1], track.residual_displacement()[:, 6] * 1e6)
            start = round((positions_on_body(state, 2)[0] - left) / STEP)
            inside = section[:, start : start + GRID.nx]
            np.testing.assert_allclose(inside, state.von_mises()[:, 6, :].T * 1e-6)
        # behind the grid there is what the contact left; what nobody computed is blank
        *_, last = recorder.frames[-1]
        yielded = track.equivalent_plastic_strain().any(axis=(1, 2))
        columns = np.round((track.x - left) / STEP).astype(int)
        behind = yielded & (columns < start)
        assert behind.any()
        residual = track.residual_von_mises()[behind, 6] * 1e-6
        np.testing.assert_allclose(last[:, columns[behind]], residual.T)
        beyond = np.setdiff1d(np.arange(start), columns[behind])
        assert beyond.size
        assert np.isnan(last[:, beyond]).all()
        assert not np.isnan(last[:, start : start + GRID.nx]).any()

    def test_section_of_strain(self, states, tmp_path):
        recorder = Recorder()
        animation = plotting.rolling_animation(states[-1:], quantity="equivalent_plastic_strain")
        animation.save(tmp_path / "none", writer=recorder)
        shown = recorder.frames[-1][3]
        assert shown.max() == pytest.approx(states[-1].max_equivalent_plastic_strain(2) * 100)

    def test_gif(self, states, tmp_path):
        some = states[-3:]
        animation = plotting.rolling_animation(some)
        path = plotting.save_animation(animation, tmp_path / "out.gif", fps=5, dpi=50)
        assert path == tmp_path / "out.gif"
        with Image.open(path) as image:
            assert image.n_frames == len(some) > 2
            assert image.info["duration"] == 200  # ms

    def test_formats(self, animation, tmp_path, monkeypatch):
        with pytest.raises(ValueError, match=r"path must end in \.gif or \.mp4, got .*out\.avi"):
            plotting.save_animation(animation, tmp_path / "out.avi")
        with pytest.raises(ValueError, match="fps must be a finite number > 0, got 0"):
            plotting.save_animation(animation, tmp_path / "out.gif", fps=0)
        monkeypatch.setattr(matplotlib.animation.FFMpegWriter, "isAvailable", lambda: False)
        with pytest.raises(RuntimeError, match=r"\.mp4 requires the program ffmpeg.*in \.gif"):
            plotting.save_animation(animation, tmp_path / "out.mp4")
        assert not list(tmp_path.iterdir())

    def test_bad_input_is_named(self, states):
        with pytest.raises(ValueError, match="states must contain at least one state"):
            plotting.rolling_animation([])
        with pytest.raises(ValueError, match=r"quantity must be one of 'von_mises', .* got 'heat'"):
            plotting.rolling_animation(states, quantity="heat")
        with pytest.raises(ValueError, match="interval must be a finite number > 0, got 0"):
            plotting.rolling_animation(states, interval=0)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard figures of a run: selection, contents and legibility."""

import itertools

import matplotlib.image
import numpy as np
import pytest
from drawn_fields import shows
from overlapping_texts import overlaps, overlaps_when_saved, texts

import samcontact as sc
from core_fakes import ELASTIC, SWIFT, FakeState, make_grid, make_simulation
from samcontact import plotting
from samcontact.plotting import parts, summary
from samcontact.results import to_dataset

WARM = SWIFT.with_thermal(50.0, 1e-5, 1e-5)
PROFILES = ("pressure", "load_approach", "flash_temperature", "imprint")
"""Figures whose size does not depend on the grid."""
PARTS = ("pressure", "axis_stress", "gap_map", "sections")
"""The other figures consist of the same parts as these."""
OTHERS = (*PROFILES[1:], "pressure_map", "imprint_map", "residual", "temperature")
SURFACE = ["pressure.png", "pressure_map.png", "gap_map.png"]


@pytest.fixture
def left_out():
    """Return the names of figures that are not drawn, because drawing is slow."""
    return ()


@pytest.fixture
def drawn(monkeypatch, left_out):
    """Return the written figures by name."""
    figures = {}

    def keep(figure, path):
        if path.stem in left_out:
            return path
        figures[path.stem] = figure
        figure.set_dpi(50)
        return parts.save(figure, path)

    monkeypatch.setattr(summary, "save", keep)
    return figures


def longest_blank(image):
    """Return the longest run of white rows or columns, as a fraction of their number."""
    white = image[..., :3].min(axis=2) > 0.99
    longest = 0.0
    for axis in (0, 1):
        lines = white.all(axis=axis)
        runs = (len(list(run)) for blank, run in itertools.groupby(lines) if blank)
        longest = max(longest, max(runs, default=0) / lines.size)
    return longest


# cells along x and y, layers: flat, deep, long
@pytest.mark.parametrize(
    ("cells", "left_out"),
    [((41, 9, 3), ()), ((11, 9, 20), PROFILES), ((9, 41, 10), PROFILES)],
)
def test_written_figures_are_legible(cells, left_out, tmp_path, drawn):
    simulation = make_simulation(body2=WARM)
    grid = simulation.grid = make_grid(nx=cells[0], ny=cells[1], nz=cells[2], dz=1e-4)
    simulation.initial_gap = np.zeros(cells[:2])
    states = [FakeState(grid, load) for load in (1500.0, 0.0)]
    for state in states:
        state.gap = 1e-3 * np.abs(grid.x)[:, None] + 1e-3 * np.abs(grid.y)
    dataset = to_dataset(simulation, states)
    with overlaps_when_saved() as hidden:
        written = plotting.summary_figures(dataset, tmp_path / "new" / "folder")
    assert [path.name for path in written] == [
        *SURFACE,
        "axis_stress.png",
        "sections.png",
        "load_approach.png",
        "flash_temperature.png",
        "temperature.png",
        "imprint.png",
        "imprint_map.png",
        "residual.png",
    ]
    assert len(drawn) == len(written) - len(left_out)
    for path in (path for path in written if path.stem in drawn):
        image = matplotlib.image.imread(path)
        assert min(image.shape[:2]) > 40
        assert image[..., :3].std() > 0.01  # something is drawn
        assert longest_blank(image) < 0.2, path.name
        assert hidden[drawn[path.stem]] == [], path.name


def test_without_a_volume(tmp_path, undrawn):
    surface = make_simulation(nz=0, body2=ELASTIC.with_thermal(50.0, 1e-5, 1e-5))
    states = [FakeState(surface.grid, 1500.0)]
    written = plotting.summary_figures(to_dataset(surface, states), tmp_path)
    # a single increment has no curve
    assert [path.name for path in written] == [*SURFACE, "flash_temperature.png"]


def test_profiles_run_through_the_maximum(tmp_path, drawn, undrawn):
    """Profiles run through the maximum: the middle of a rough surface may be out of contact."""
    simulation = make_simulation()
    grid = simulation.grid
    state = FakeState(grid, 1500.0)
    state.pressure = np.roll(state.pressure, 3, axis=1)
    plotting.summary_figures(to_dataset(simulation, [state]), tmp_path)
    row = int(np.argmax(state.pressure.max(axis=0)))
    ax = drawn["pressure"].axes[0]
    np.testing.assert_allclose(ax.get_lines()[0].get_ydata(), state.pressure[:, row] * 1e-9)
    assert ax.get_title() == f"load 1500 N, y = {grid.y[row] * 1e6:.4g} µm"


def test_the_whole_track_of_a_moving_body_is_shown(tmp_path, drawn, undrawn):
    step = 60e-6
    grid = sc.Grid(15, 13, step, step, 12, step)
    simulation = sc.Simulation(grid, ELASTIC, SWIFT, sc.surfaces.paraboloid(grid, 7.5e-3))
    move = {"load": 700.0, "advance": (-2 * step, -2 * step)}
    states = simulation.run([{"load": 700.0}, *[move] * 5, {"load": 0.0}], progress=False)
    plotting.summary_figures(to_dataset(simulation, states), tmp_path)
    track = states[-1].track(2)
    depth = track.residual_displacement()
    ax = drawn["imprint"].axes[0]
    (line,) = ax.get_lines()
    deepest = track.x[int(np.argmax(depth[:, 6]))] * 1e6
    assert line.get_ydata().max() == pytest.approx(depth.max() * 1e9)  # a small one, in nm
    left, right = ax.get_xlim()
    assert left < deepest < right
    assert left < 0.0 < 10 * step * 1e6 < right  # all of the way
    factors = {"y": 1e9, "z": 1e-6}
    for name, shown in (("imprint_map", depth), ("residual", track.residual_von_mises()[:, 6])):
        rows = "y" if name == "imprint_map" else "z"
        along = getattr(grid, rows)
        assert shows(drawn[name].axes[0], track.x, along, shown * factors[rows], within=0.1)
    for name in ("imprint", "imprint_map", "residual", "track_imprint", "track_sections"):
        assert overlaps(drawn[name]) == [], name


def test_shown_increments(tmp_path, undrawn):
    simulation = make_simulation(body2=WARM)
    states = [FakeState(simulation.grid, load) for load in (1500.0, 700.0, 100.0)]
    states[1].pressure = 3.0 * states[0].pressure  # warmest where the stress is not largest
    stored = to_dataset(simulation, states)
    shown = summary.increments_shown(stored, 2)
    assert shown == {1, 2, 3}
    assert stored["output_increment"].values.tolist() == [1, 3]
    assert "temperature" not in {path.stem for path in plotting.summary_figures(stored, tmp_path)}
    whole = to_dataset(simulation, states, volume=sorted(shown))
    assert whole["output_increment"].values.tolist() == [1, 2, 3]
    assert "temperature" in {path.stem for path in plotting.summary_figures(whole, tmp_path)}


def test_bad_input_is_named(tmp_path):
    simulation = make_simulation()
    states = [FakeState(simulation.grid, 1.0)]
    with pytest.raises(ValueError, match="body must be one of 1, 2, got 3"):
        plotting.summary_figures(to_dataset(simulation, states), tmp_path, body=3)
    with pytest.raises(ValueError, match=r"volume .* got 2"):
        to_dataset(simulation, states, volume=[2])
    with pytest.raises(ValueError, match="format must be one of 'png', 'pdf', 'svg', got 'jpg'"):
        plotting.summary_figures(to_dataset(simulation, states), tmp_path, format="jpg")
    with (
        pytest.raises(ValueError, match="width must be one of 'single', 'double', 'screen'"),
        plotting.journal_column("wide"),
    ):
        pass


@pytest.mark.parametrize(
    ("width", "mm", "left_out"),
    [
        ("single", 88.0, ()),  # the one with less room
        ("double", 180.0, OTHERS),
        pytest.param("double", 180.0, (), marks=pytest.mark.slow),
    ],
)
def test_figures_as_wide_as_a_column(width, mm, left_out, tmp_path, drawn):
    """Nothing is cut off, nothing overlaps, and letters are those of print."""
    simulation = make_simulation(body2=WARM)
    grid = simulation.grid = make_grid(nx=21, ny=15, nz=8, dz=1e-4)
    simulation.initial_gap = np.zeros((21, 15))
    states = [FakeState(grid, load) for load in (1500.0, 0.0)]
    dataset = to_dataset(simulation, states)
    with plotting.journal_column(width), overlaps_when_saved() as hidden:
        written = plotting.summary_figures(dataset, tmp_path)
        assert len(drawn) == len(written) - len(left_out)
        for path in (path for path in written if path.stem in drawn):
            figure = drawn[path.stem]
            image = matplotlib.image.imread(path)
            assert image.shape[1] == pytest.approx(mm / 25.4 * 200, abs=1.1)
            border = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
            assert border[:, :3].min() == 1.0, path.name  # white: nothing goes beyond
            assert hidden[figure] == [], path.name
            sizes = {text.get_fontsize() for ax in figure.axes for text in texts(ax)}
            assert min(sizes) >= 5.5
            assert max(sizes) <= 8.0
    assert matplotlib.rcParams["font.size"] == 10.0


@pytest.mark.parametrize(
    ("ending", "once", "again"),
    # fonts make PDF slow
    [("pdf", PARTS, ("pressure", "sections")), ("svg", (*PARTS, *OTHERS), PARTS)],
)
def test_vector_files_are_reproducible(ending, once, again, tmp_path, monkeypatch):
    """Files repeat bit by bit; letters in a PDF remain letters, only field colours are pixels."""
    simulation = make_simulation()
    state = FakeState(simulation.grid, 1500.0)
    state.gap = 1e-3 * np.abs(simulation.grid.x)[:, None] + 1e-3 * np.abs(simulation.grid.y)
    dataset = to_dataset(simulation, [state])
    for folder, names in (("a", once), ("b", again)):

        def some(figure, path, names=names):
            return parts.save(figure, path) if path.stem in names else path

        monkeypatch.setattr(summary, "save", some)
        written = plotting.summary_figures(dataset, tmp_path / folder, format=ending)
        assert {path.suffix for path in written} == {f".{ending}"}
    for name in again:
        one, other = (tmp_path / folder / f"{name}.{ending}" for folder in "ab")
        assert one.read_bytes() == other.read_bytes(), name
    files = list((tmp_path / "a").glob(f"*.{ending}"))
    assert {path.stem for path in files} == {path.stem for path in written} & set(once)
    for path in files:
        found = path.read_bytes()
        colours = b"/Subtype /Image" if ending == "pdf" else b"<image"
        fields = ("pressure_map", "gap_map", "sections", "imprint_map", "residual")
        assert (colours in found) == (path.stem in fields), path.name
        if ending == "pdf":
            assert b"/Type0" in found  # TrueType, as journals ask

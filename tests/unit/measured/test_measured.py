# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured surfaces: files written by SurfaceTopography, resampling, trends, case files."""

import sys
import warnings

import numpy as np
import pytest

import samcontact as sc
from core_fakes import make_grid
from samcontact import measured
from samcontact.cases import CaseError, load_case
from samcontact.measured import MeasuredSurface

with warnings.catch_warnings():
    warnings.simplefilter("ignore", ImportWarning)  # no MPI
    from SurfaceTopography import Topography


def polynomial(x, y):
    """Return heights that are quadratic along each axis, with different coefficients [m, m]."""
    x, y = np.meshgrid(x, y, indexing="ij")
    return 1e-6 + 2e-3 * x - 1e-3 * y + 5.0 * x**2 - 3.0 * y**2 + 4.0 * x * y


def samples(n, d):
    return (np.arange(n) - 0.5 * (n - 1)) * d


@pytest.fixture
def surface():
    return MeasuredSurface(polynomial(samples(40, 2e-6), samples(30, 3e-6)), 2e-6, 3e-6)


@pytest.fixture
def rough():
    return np.random.default_rng(3).standard_normal((12, 9)) * 1e-7


@pytest.mark.parametrize("suffix", ["nc", "x3p", "txt"])
@pytest.mark.parametrize("unit", ["um", "nm"])
def test_round_trip_through_a_file(tmp_path, rough, suffix, unit):
    scale = {"um": 1e6, "nm": 1e9}[unit]
    topography = Topography(rough * scale, (12 * 2e-6 * scale, 9 * 3e-6 * scale), unit=unit)
    path = tmp_path / f"s.{suffix}"
    write = {"nc": "to_netcdf", "x3p": "to_x3p", "txt": "to_matrix"}[suffix]
    getattr(topography, write)(str(path))
    read = measured.read(path, detrend=None)
    np.testing.assert_allclose(read.heights, rough, atol=1e-15)
    assert (read.dx, read.dy) == (pytest.approx(2e-6), pytest.approx(3e-6))
    assert read.size == (pytest.approx(24e-6), pytest.approx(27e-6))
    assert read.attrs["source"] == str(path)
    assert read.attrs["format"] == {"txt": "asc"}.get(suffix, suffix)
    assert read.undefined == 0
    centred = measured.read(path)
    np.testing.assert_allclose(centred.heights, rough - rough.mean(), atol=1e-15)
    assert centred.attrs["detrend"] == "center"


def test_plain_arrays_need_no_library(tmp_path, rough, monkeypatch):
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    np.save(tmp_path / "h.npy", rough)
    np.savetxt(tmp_path / "h.txt", rough)
    np.savetxt(tmp_path / "h.csv", rough, delimiter=",")
    for name in ("h.npy", "h.txt", "h.csv"):
        read = measured.read(tmp_path / name, dx=1e-6)
        np.testing.assert_allclose(read.heights, rough - rough.mean(), atol=1e-20)
        assert (read.dx, read.dy) == (1e-6, 1e-6)
        assert read.on(make_grid(nx=4, ny=4, dx=1e-6, dy=1e-6)).shape == (4, 4)


def test_a_missing_library_is_reported_with_its_installation(tmp_path, surface, monkeypatch):
    for name in ("SurfaceTopography", "SurfaceTopography.IO"):
        monkeypatch.setitem(sys.modules, name, None)
    for call in (
        lambda: measured.read(tmp_path / "s.sur"),
        lambda: surface.detrended("height"),
        lambda: MeasuredSurface([[1.0, np.nan], [2.0, 3.0]], 1.0)._topography(),
    ):
        with pytest.raises(ImportError, match=r"pip install samcontact\[surfaces\]"):
            call()


def test_units_and_sizes_missing_in_the_file(tmp_path, rough):
    np.save(tmp_path / "h.npy", rough * 1e9)
    read = measured.read(tmp_path / "h.npy", dx=2e-6, dy=3e-6, unit="nm", detrend=None)
    np.testing.assert_allclose(read.heights, rough, rtol=1e-14)
    assert (read.dx, read.dy) == (pytest.approx(2e-6), pytest.approx(3e-6))
    with pytest.raises(ValueError, match=r"dx is required, because .*h\.npy does not contain it"):
        measured.read(tmp_path / "h.npy")
    Topography(rough, (1.0, 1.0), unit="um").to_netcdf(str(tmp_path / "s.nc"))
    with pytest.raises(ValueError, match=r"dx must be None, got .*s\.nc contains it"):
        measured.read(tmp_path / "s.nc", dx=1e-6)
    with pytest.raises(ValueError, match="unit must be None"):
        measured.read(tmp_path / "s.nc", unit="nm")
    Topography(rough, (1.0, 1.0)).to_netcdf(str(tmp_path / "t.nc"))
    with pytest.raises(ValueError, match="unit is required"):
        measured.read(tmp_path / "t.nc")


def test_channels_are_named(tmp_path, rough):
    Topography(rough, (1.0, 1.0), unit="um").to_netcdf(str(tmp_path / "s.nc"))
    first = measured.read(tmp_path / "s.nc", channel=0)
    np.testing.assert_array_equal(
        first.heights, measured.read(tmp_path / "s.nc", channel="Default").heights
    )
    with pytest.raises(ValueError, match=r"channel must be one of 0: 'Default' in .*, got 'phase'"):
        measured.read(tmp_path / "s.nc", channel="phase")


def test_unreadable_files_are_named(tmp_path):
    with pytest.raises(ValueError, match=r"cannot read heights from .*missing\.sur"):
        measured.read(tmp_path / "missing.sur")
    (tmp_path / "bad.sur").write_bytes(b"\x00\x01" * 500)
    with pytest.raises(ValueError, match="no format supported by SurfaceTopography"):
        measured.read(tmp_path / "bad.sur")


def test_trends_are_removed_exactly(surface):
    x, y = samples(40, 2e-6)[:, None], samples(30, 3e-6)[None, :]
    plane = MeasuredSurface(1e-6 + 3e-3 * x - 2e-3 * y, 2e-6, 3e-6)
    for trend in ("height", "slope", "curvature"):
        assert np.abs(plane.detrended(trend).heights).max() < 1e-20
    assert np.abs(surface.detrended("curvature").heights).max() < 1e-20
    left = surface.detrended("height").heights
    assert np.abs(left).max() > 1e-10
    for direction in (np.ones_like(left), x + 0 * y, y + 0 * x):  # least squares
        assert abs(np.sum(left * direction)) < 1e-13 * np.sum(np.abs(left * direction))
    assert surface.detrended("center").heights.mean() == pytest.approx(0.0, abs=1e-20)


def test_undefined_points(tmp_path, surface):
    holes = np.array(surface.heights)
    holes[5, 7] = holes[0, 0] = np.nan
    raw = MeasuredSurface(holes, 2e-6, 3e-6)
    assert raw.undefined == 2
    with pytest.raises(ValueError, match=r"got 2 undefined points, .* index \(0, 0\)"):
        raw.on(make_grid(nx=4, ny=4, dx=1e-6, dy=1e-6))
    # the trend is that of the defined points: a polynomial is removed exactly all the same
    assert np.nanmax(np.abs(raw.detrended("curvature").heights)) < 1e-20
    filled = raw.filled()
    assert (filled.undefined, filled.attrs["filled_points"]) == (0, 2)
    around = [holes[4, 7], holes[6, 7], holes[5, 6], holes[5, 8]]
    assert filled.heights[5, 7] == pytest.approx(np.mean(around), rel=1e-12)
    np.testing.assert_array_equal(filled.heights[6:], holes[6:])
    path = tmp_path / "s.nc"
    Topography(holes * 1e6, (80.0, 90.0), unit="um").to_netcdf(str(path))
    assert measured.read(path).attrs["filled_points"] == 2
    assert measured.read(path, undefined="keep").undefined == 2
    with pytest.raises(ValueError, match=r"s\.nc must have no undefined points, got 2"):
        measured.read(path, undefined="error")


def test_many_undefined_points_warn(rough):
    rough[:, :2] = np.nan
    with pytest.warns(UserWarning, match=r"22\.2 % of the measured points are undefined"):
        assert MeasuredSurface(rough, 1.0).filled().undefined == 0


def test_resampling_is_exact_for_polynomials(surface):
    grid = make_grid(nx=17, ny=13, dx=1.3e-6, dy=2.1e-6)
    x0, y0 = 5e-6, -4e-6
    expected = polynomial(grid.x - x0, grid.y - y0)
    np.testing.assert_allclose(surface.on(grid, x0, y0), expected, rtol=0, atol=1e-20)
    # bilinear: a plane exactly, a parabola to curvature times step^2/8
    linear = surface.on(grid, x0, y0, method="linear")
    bound = (10.0 * 2e-6**2 + 6.0 * 3e-6**2) / 8.0
    assert 0.2 * bound < np.abs(linear - expected).max() <= bound * (1 + 1e-9)


def test_resampling_onto_the_samples_returns_them(rough):
    surface = MeasuredSurface(rough, 2e-6, 3e-6)
    grid = make_grid(nx=12, ny=9, dx=2e-6, dy=3e-6)
    for method in ("cubic", "linear"):
        np.testing.assert_allclose(surface.on(grid, method=method), rough, atol=1e-20)


def test_average_is_the_mean_over_cells(rough):
    surface = MeasuredSurface(rough, 2e-6, 3e-6)
    grid = make_grid(nx=4, ny=3, dx=6e-6, dy=9e-6)
    means = rough.reshape(4, 3, 3, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(surface.on(grid, average=True), means, atol=1e-20)
    centres = surface.on(grid)
    np.testing.assert_allclose(centres, rough[1::3, 1::3], atol=1e-20)


def test_a_surface_smaller_than_the_grid_is_refused(surface):
    grid = make_grid(nx=21, ny=5, dx=5e-6, dy=5e-6)
    with pytest.raises(ValueError, match=r"along x .* extend from -5e-05 to 5e-05 m: .* set fill"):
        surface.on(grid)
    with pytest.raises(ValueError, match="along y"):
        surface.on(make_grid(nx=3, ny=3, dx=1e-6, dy=1e-6), y=50e-6)
    heights = surface.on(grid, fill=7e-6)
    assert np.all(heights[[0, 1, -2, -1]] == 7e-6)
    expected = polynomial(grid.x, grid.y)
    np.testing.assert_allclose(heights[3:-3], expected[3:-3], atol=1e-20)
    # whole cells must lie inside for their mean
    fitting = make_grid(nx=17, ny=5, dx=5e-6, dy=5e-6)
    surface.on(fitting)
    with pytest.raises(ValueError, match="along x"):
        surface.on(fitting, average=True)


def test_relief_carries_all_rows(surface):
    grid = sc.Grid(nx=8, ny=9, dx=2.5e-6, dy=2.5e-6)
    relief = surface.relief(grid, x=33e-6)
    x = (relief.first + np.arange(len(relief.heights)) - 3.5) * grid.dx
    np.testing.assert_allclose(relief.heights, polynomial(x - 33e-6, grid.y), atol=1e-20)
    assert 78e-6 - 2.5e-6 <= len(x) * grid.dx <= 80e-6 * (1 + 1e-9)
    # whole measured cells, exactly
    same = surface.relief(sc.Grid(nx=40, ny=30, dx=2e-6, dy=3e-6), periodic=True)
    assert (same.first, same.periodic) == (0, True)
    np.testing.assert_allclose(same.heights, surface.heights, atol=1e-20)
    with pytest.raises(ValueError, match="along y"):
        surface.relief(sc.Grid(nx=8, ny=40, dx=2.5e-6, dy=2.5e-6))
    with pytest.raises(ValueError, match=r"must be at least one cell of the grid long, 0\.001 m"):
        surface.relief(sc.Grid(nx=8, ny=8, dx=1e-3, dy=1e-6))


def test_mirrored(surface):
    np.testing.assert_array_equal(surface.mirrored().heights, surface.heights[:, ::-1])
    np.testing.assert_array_equal(surface.mirrored("x").heights, surface.heights[::-1])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: MeasuredSurface(np.zeros((1, 3)), 1.0), r"nx, ny >= 2, .* profile, got \(1, 3\)"),
        (lambda: MeasuredSurface(0.0, 1.0), r"shape \(nx, ny\) with .* got \(\)"),
        (lambda: MeasuredSurface(np.full((2, 2), np.nan), 1.0), "defined in at least one point"),
        (lambda: MeasuredSurface([[0, np.inf], [0, 0]], 1.0), "finite, or NaN"),
        (lambda: MeasuredSurface(np.zeros((2, 2)), 0.0), "dx must be a finite number > 0"),
        (lambda: MeasuredSurface(np.zeros((2, 2)), 1.0).detrended("x"), "trend must be one of"),
        (lambda: MeasuredSurface(np.zeros((2, 2)), 1.0).mirrored("z"), "axis must be one of"),
        (lambda: measured.read("h.npy", dy=1.0), "dx is required if dy is given"),
        (lambda: measured.read("h.npy", detrend="no"), "detrend must be one of 'center', "),
        (lambda: measured.read("h.npy", undefined="no"), "undefined must be one of"),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


CASE = """
title = "measured"
[grid]
nx = 16
ny = 16
dx = 2e-6
dy = 2e-6
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "file"
path = "s.nc"
detrend = "height"
Rx = 1e-3
[relief1]
kind = "file"
path = "s.nc"
mirror = "y"
x = 4e-6
fill = 0.0
[[path]]
load = 0.02
increments = 1
"""


@pytest.fixture
def case_file(tmp_path):
    x, y = samples(50, 1e-6)[:, None], samples(40, 1e-6)[None, :]
    heights = 1e-8 * np.sin(2e5 * x) * np.cos(3e5 * y) + 1e-3 * x + 1e-3 * y
    Topography(heights * 1e6, (50.0, 40.0), unit="um").to_netcdf(str(tmp_path / "s.nc"))
    path = tmp_path / "case.toml"

    def write(*changes):
        text = CASE
        for old, new in changes:
            assert old in text
            text = text.replace(old, new, 1)
        path.write_text(text, encoding="utf-8")
        return load_case(path)

    return write


def test_case_with_measured_surfaces(case_file, tmp_path):
    simulation, path = case_file().build()
    grid = sc.Grid(nx=16, ny=16, dx=2e-6, dy=2e-6)
    surface = measured.read(tmp_path / "s.nc", detrend="height")
    gap = sc.surfaces.from_heights(grid, surface.on(grid), sc.surfaces.paraboloid(grid, 1e-3))
    relief = measured.read(tmp_path / "s.nc").mirrored().relief(grid, 4e-6, fill=0.0)
    expected = sc.Simulation(
        grid, sc.Material.rigid(), sc.Material.elastic(E=210e9, nu=0.3), gap, relief1=relief
    )
    states = [s.run(path, progress=False)[-1] for s in (simulation, expected)]
    np.testing.assert_array_equal(states[0].pressure, states[1].pressure)
    assert states[0].load == pytest.approx(0.02)


def test_plain_files_with_samples_of_their_own(case_file, tmp_path):
    heights = 1e-8 * samples(60, 1.0)[:, None] ** 2 * np.ones(50)
    np.savetxt(tmp_path / "h.txt", heights)
    plain = ('path = "s.nc"\ndetrend = "height"', 'path = "h.txt"\ndx = "1 um"\nx = 1e-6')
    grid = sc.Grid(nx=16, ny=16, dx=2e-6, dy=2e-6)
    gap = case_file(plain, ("Rx = 1e-3\n", "")).surface.build(grid, tmp_path)
    exact = -1e-8 * (grid.x / 1e-6 - 1.0) ** 2
    np.testing.assert_allclose(gap[:, 3], exact - exact.min(), atol=1e-18)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            'detrend = "height"',
            'detrend = "tilt"',
            r'surface\.detrend: must be one of "none", "center"',
        ),
        ("nx = 16", "nx = 99", r"\[surface\] grid must lie inside .* along x"),
        ('path = "s.nc"', 'path = "h.xlsx"', r"\[surface\] path: cannot read heights from .*xlsx"),
        ('detrend = "height"', "channel = 3", r"\[surface\] channel must be one of 0: 'Default'"),
    ],
)
def test_case_errors(case_file, old, new, message):
    with pytest.raises(CaseError, match=message):
        case_file((old, new)).build()


def test_case_without_the_library(case_file, monkeypatch):
    monkeypatch.setitem(sys.modules, "SurfaceTopography.IO", None)
    with pytest.raises(CaseError, match=r"\[surface\] .*pip install samcontact\[surfaces\]"):
        case_file().build()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of heights: one axis convention for all readers, undefined points, foreign texts."""

import os
import warnings

import h5py
import numpy as np
import pytest
from scipy.io import savemat

import samcontact as sc
from samcontact import kernels, measured
from samcontact.cases import Case, CaseError
from samcontact.measured import MeasuredSurface
from samcontact.measured.plain import is_plain

with warnings.catch_warnings():
    warnings.simplefilter("ignore", ImportWarning)  # no MPI
    from SurfaceTopography import Topography

NX, NY, DX, DY = 7, 5, 2e-6, 3e-6
UM = np.random.default_rng(1).standard_normal((NX, NY))  # no symmetry, not square


def write_sdf(path):
    """Write an ISO 25178-71 file: profiles along x in sequence."""
    head = (
        f"aISO-1.0\nManufacID = x\nCreateDate = 010120200000\nModDate = 010120200000\n"
        f"NumPoints = {NX}\nNumProfiles = {NY}\nXscale = {DX}\nYscale = {DY}\nZscale = 1e-15\n"
        "Zresolution = -1\nCompression = 0\nDataType = 6\nCheckType = 0\n*\n"
    )
    counts = np.round(UM.T.ravel() * 1e9).astype(int)
    path.write_text(head + "".join(f"{count}\n" for count in counts) + "*\n*\n")


def write_points(path, transposed, delimiter=" "):
    x, y = np.meshgrid(np.arange(NX) * DX * 1e6, np.arange(NY) * DY * 1e6, indexing="ij")
    columns = [a.T.ravel() if transposed else a.ravel() for a in (x, y, UM)]
    np.savetxt(path, np.column_stack(columns), delimiter=delimiter)


def write_h5(path):
    with h5py.File(path, "w") as file:
        file["heights"] = UM


def topography():
    return Topography(UM, (NX * DX * 1e6, NY * DY * 1e6), unit="um")


WITH_SIZES = {
    "s.nc": lambda p: topography().to_netcdf(str(p)),
    "s.x3p": lambda p: topography().to_x3p(str(p)),
    "s.gwy": lambda p: topography().to_gwy(str(p)),
    "s.txt": lambda p: topography().to_matrix(str(p)),
    "s.asc": lambda p: topography().to_matrix(str(p)),
    "s.sdf": write_sdf,
}
WITHOUT = {
    "s.npy": lambda p: np.save(p, UM),
    "s.npz": lambda p: np.savez(p, heights=UM),
    "s.mat": lambda p: savemat(p, {"heights": UM}),
    "s.h5": write_h5,
    "s.txt": lambda p: np.savetxt(p, UM),
    "s.dat": lambda p: np.savetxt(p, UM, header="heights of a ball"),
    "t.txt": lambda p: np.savetxt(p, UM, header="measured on: Monday"),
    "s.asc": lambda p: np.savetxt(p, UM),
    "s.csv": lambda p: np.savetxt(p, UM, delimiter=","),
    "t.csv": lambda p: np.savetxt(p, UM, delimiter=";"),
    "u.csv": lambda p: np.savetxt(p, UM, delimiter=",", encoding="utf-8-sig", header="heights"),
    "w.csv": lambda p: np.savetxt(p, UM, delimiter="\t", encoding="utf-16"),
}
# what else is known of arrays without units, and what to multiply the heights read with
PLAIN = {"s.npy", "s.txt", "s.dat", "t.txt", "s.asc", "s.csv", "t.csv", "u.csv", "w.csv"}


def close(surface, heights=1e-6 * UM):
    np.testing.assert_allclose(surface.heights, heights, rtol=1e-6, atol=1e-14)
    assert surface.steps == (pytest.approx(DX), pytest.approx(DY))


@pytest.mark.parametrize("name", WITH_SIZES)
def test_first_index_runs_along_x_in_files_with_sizes(tmp_path, name):
    path = tmp_path / name
    WITH_SIZES[name](path)
    close(measured.read(path, detrend=None))
    close(measured.read(path, detrend=None, channel=0))
    for given, argument in (({"dx": DX}, "dx"), ({"dx": DX, "unit": "um"}, "dx|unit")):
        with pytest.raises(ValueError, match=f"({argument}) must be None"):
            measured.read(path, **given)


@pytest.mark.parametrize("name", WITHOUT)
def test_first_index_runs_along_x_in_plain_arrays(tmp_path, name):
    path = tmp_path / name
    WITHOUT[name](path)
    given = {"dx": DX, "dy": DY, "detrend": None}
    close(measured.read(path, unit="um", **given))
    close(measured.read(path, unit="um", channel=0, **given))
    if name in PLAIN:
        close(measured.read(path, **given), UM)
        close(measured.read(path, channel=0, **given), UM)
    with pytest.raises(
        ValueError, match=r"dx is required|no format supported by SurfaceTopography"
    ):
        measured.read(path, unit="um")


@pytest.mark.parametrize("name", ["a.xyz", "b.xyz", "c.csv"])
def test_points_in_any_order(tmp_path, name):
    write_points(tmp_path / name, name == "b.xyz", "," if name == "c.csv" else " ")
    close(measured.read(tmp_path / name, unit="um", detrend=None))


@pytest.mark.parametrize("name", [*sorted(PLAIN - {"t.txt"}), "plain.sdf", "sized.txt"])
def test_case_files_read_the_same_surface(tmp_path, name):
    write = {"plain.sdf": write_sdf, "sized.txt": WITH_SIZES["s.txt"]}.get(name) or WITHOUT[name]
    write(tmp_path / name)
    plain = name in PLAIN
    case = Case.model_validate(
        {
            "title": "t",
            "grid": {"nx": NX, "ny": NY, "dx": DX, "dy": DY},
            "body1": {"law": "rigid"},
            "body2": {"law": "elastic", "E": 1e9, "nu": 0.3},
            "surface": {"shape": "file", "path": name},
            "relief1": {"kind": "file", "path": name},
            "path": [{"load": 1.0}],
        }
    )
    heights = UM if plain else 1e-6 * (UM - UM.mean())
    folder = tmp_path
    grid = case.grid.build()
    atol = 1e-6 * np.abs(heights).max()
    np.testing.assert_allclose(
        case.surface.build(grid, folder), heights.max() - heights, rtol=0, atol=atol
    )
    relief = case.relief1.build(grid, folder).heights
    np.testing.assert_allclose(relief, heights, rtol=0, atol=atol)
    if plain:  # as a measured surface, on the same cells
        same = type(case.surface)(shape="file", path=name, dx=DX, dy=DY, detrend="none")
        np.testing.assert_allclose(same.build(grid, folder), UM.max() - UM, atol=atol)


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("s.csv", "1,5;2,5\n3,5;4,5\n", r"decimal points.* got '1,5;2,5'"),
        ("s.txt", "1,5 2,5\n3,5 4,5\n", "decimal points"),
        ("s.csv", "1.5;2.5\n3,5;4.5\n", "could not convert string '3,5'"),
        ("s.csv", "1;2\n3;x\n", "could not convert string 'x'"),
    ],
)
def test_number_formats_of_other_countries_are_never_misread(tmp_path, name, text, message):
    (tmp_path / name).write_text(text)
    with pytest.raises(ValueError, match=rf"cannot read heights from .*{name}: .*{message}"):
        measured.read(tmp_path / name, dx=DX)


def test_unknown_unit_is_named(tmp_path):
    np.save(tmp_path / "s.npy", UM)
    for unit in ("parsec", "V"):
        with pytest.raises(ValueError, match=f"unit must be a length unit, .* got '{unit}'"):
            measured.read(tmp_path / "s.npy", dx=DX, unit=unit)


def lost_points():
    heights = np.ma.array(1e-6 * UM, mask=False)
    heights[2, 3] = np.ma.masked
    heights.data[2, 3] = 1.0  # what lies under the mask is anything
    return heights


def test_lost_points_of_a_measured_surface_are_undefined():
    for given in (lost_points(), list(lost_points())):
        surface = MeasuredSurface(given, DX, DY)
        assert surface.undefined == 1
        assert np.isnan(surface.heights[2, 3])
        assert np.nanmax(np.abs(surface.filled().heights)) < 1e-5
    counts = np.ma.array(np.arange(6).reshape(2, 3), mask=[[0, 1, 0], [0, 0, 0]])
    np.testing.assert_array_equal(MeasuredSurface(counts, DX).heights, [[0, np.nan, 2], [3, 4, 5]])
    with pytest.raises(ValueError, match="heights must be defined in at least one point"):
        MeasuredSurface(np.ma.masked_all((3, 3)), DX)


def test_masked_values_are_refused_by_name_elsewhere():
    grid = sc.Grid(NX, NY, DX, DY)
    steel, lost = sc.Material.elastic(210e9, 0.3), lost_points()
    row = lost[2]
    solver = sc.ContactSolver(grid, sc.Material.rigid(), steel)
    hertz = sc.hertz.point(1e-3, 1e11, load=1.0)
    calls = {
        "heights_lower": lambda: sc.surfaces.from_heights(grid, lost),
        "heights_upper": lambda: sc.surfaces.from_heights(grid, 0 * UM, list(lost)),
        "heights": lambda: sc.Relief(lost),
        "gap": lambda: sc.Simulation(grid, sc.Material.rigid(), steel, lost),
        "pressure": lambda: solver.stress(lost, 1e-6),
        "z": lambda: solver.stress(abs(UM), abs(row)),
        "g": lambda: steel.yield_stress(abs(row)),
        "strain": lambda: steel.uniaxial_stress(row),
        "X": lambda: kernels.pressure_displacement(row, 0.0, 1.0, 1.0, 1e9, 0.3),
        "x": lambda: hertz.pressure(row),
        "velocity": lambda: sc.Heat(0.0, row[2:4]),
        "factor": lambda: sc.Heat(row[2:4]),
        "interference": lambda: sc.flattening.kogut_etsion(abs(row), 1e-3, 1e11, 0.3, 1e9),
    }
    for name, call in calls.items():
        with pytest.raises(ValueError, match=rf"^{name} must be defined everywhere, got 1 masked"):
            call()
    with pytest.raises(ValueError, match="defined everywhere"):
        sc.units.si(row, "m")
    with pytest.raises(TypeError, match="gap must be an array of numbers"):
        sc.Simulation(grid, sc.Material.rigid(), steel, 1j * UM)


def test_errors_of_spreadsheet_files_in_cases_name_the_section(tmp_path):
    (tmp_path / "s.csv").write_text("1,5;2,5\n3,5;4,5\n")
    case = Case.model_validate(
        {
            "title": "t",
            "grid": {"nx": 2, "ny": 2, "dx": DX, "dy": DY},
            "body1": {"law": "rigid"},
            "body2": {"law": "elastic", "E": 1e9, "nu": 0.3},
            "surface": {"shape": "file", "path": str(tmp_path / "s.csv")},
            "path": [{"load": 1.0}],
        }
    )
    with pytest.raises(CaseError, match=r"\[surface\] path: cannot read .*decimal points"):
        case.build()


@pytest.mark.parametrize("name", ["s.npy", "s.txt", "s.dat"])
def test_an_array_is_known_by_its_content(name, tmp_path):
    with (tmp_path / name).open("wb") as file:
        np.save(file, UM)
    surface = measured.read(tmp_path / name, dx=DX, dy=DY, unit="um", detrend=None)
    np.testing.assert_array_equal(surface.heights, UM * 1e-6)
    assert surface.attrs["format"] == "npy"
    assert is_plain(tmp_path / name)
    with pytest.raises(ValueError, match="dx is required"):
        measured.read(tmp_path / name)
    with pytest.raises(ValueError, match="channel must be 0"):
        measured.read(tmp_path / name, dx=DX, channel=1)


def test_pipes_and_endless_files_are_refused(tmp_path):
    os.mkfifo(tmp_path / "s.txt")
    for path in (tmp_path / "s.txt", "/dev/zero"):
        with pytest.raises(ValueError, match="must be a regular file, got a pipe or device"):
            measured.read(path, dx=DX)


@pytest.mark.parametrize("name", ["s.npy", "s.txt"])
def test_an_array_with_a_wrong_size_in_its_header(name, tmp_path):
    """Readers that trust the size in the header would not end."""
    with (tmp_path / name).open("wb") as file:
        shape = (2**40, 2**20)
        header = {"descr": "<f8", "fortran_order": False, "shape": shape}
        np.lib.format.write_array_header_1_0(file, header)
        file.write(bytes(800))
    with pytest.raises(ValueError, match="cannot read heights"):
        measured.read(tmp_path / name, dx=DX, unit="um")

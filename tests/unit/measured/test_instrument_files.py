# SPDX-License-Identifier: GPL-3.0-or-later
"""Instrument files: readers, reasons of refusal, units, profiles, points."""

import gzip
import hashlib
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc
from samcontact import measured
from samcontact.cases import Case
from samcontact.measured import MeasuredSurface, instruments

FILES = Path(__file__).parent / "instruments"
UM = 1e-6


def nms(path, nx=24, ny=16, step=6250.0):
    """NanoFocus: steps in nm, heights in um as 16 bit counts; the library takes the steps for mm
    and its reader of Matlab files accepts the header."""
    head = bytearray(3468)
    head[:16] = bytes.fromhex("02000000 01000000 00000000 ffff0000")
    struct.pack_into("<2d", head, 16, 6.3, 8.3)
    struct.pack_into("<2I2d", head, 1368, nx, ny, step, step)
    counts = np.linspace(0, 65534, nx * ny).round().astype("<u2").reshape(ny, nx)
    path.write_bytes(bytes(head) + counts.tobytes())
    return (6.3 + 2.0 * counts.T / 65534) * UM


X3P = """<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1><Revision>{revision}</Revision>
<FeatureType>SUR</FeatureType><Axes>{axes}</Axes></Record1>
<Record2><Date>2020-01-01T00:00:00</Date><Instrument><Manufacturer>N</Manufacturer><Model>N</Model>
<Serial>N</Serial><Version>N</Version></Instrument><CalibrationDate>2020-01-01T00:00:00
</CalibrationDate><ProbingSystem><Type>Software</Type><Identification>N</Identification>
</ProbingSystem></Record2><Record3><MatrixDimension><SizeX>5</SizeX><SizeY>5</SizeY><SizeZ>1</SizeZ>
</MatrixDimension><DataLink><PointDataLink>bindata/data.bin</PointDataLink>
<MD5ChecksumPointData>{md5}</MD5ChecksumPointData></DataLink></Record3>
<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4></p:ISO5436_2>"""


def x3p(path, revision="ISO5436 - 2000", folder=""):
    axis = "<{0}><AxisType>{1}</AxisType><DataType>D</DataType>{2}</{0}>"
    step = "<Increment>1e-6</Increment><Offset>0</Offset>"
    axes = "".join(axis.format(*a) for a in (("CX", "I", step), ("CY", "I", step), ("CZ", "A", "")))
    data = (1e-7 * np.arange(25.0)).astype("<f8").tobytes()
    md5 = hashlib.md5(data).hexdigest()
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(folder + "main.xml", X3P.format(revision=revision, axes=axes, md5=md5))
        archive.writestr(folder + "bindata/data.bin", data)
        archive.writestr(folder + "md5checksum.hex", md5)


READ = {  # options, format, shape, size [m], span of the heights [m]
    "csv-1.csv": ({"unit": "um"}, "xyz", (8, 1), 8 * 0.0386143e-6, 0.15444e-6),
    "csv-2.csv": ({}, "xyz", (8, 1), 8 / 12 * 1e-6, 0.0),
    "gwyddion-export-german.txt": ({}, "asc", (3, 4), 12.34e-6, 15.0),
    "matrix-5.txt": ({"dx": 1e-6, "unit": "nm"}, "txt", (10, 10), 1e-5, 2e-9),
    "sdf-1.sdf": ({}, "sdf", (7, 4), 7e-6, 0.05093e-6),
    "xy-1.txt": ({"unit": "um"}, "xyz", (132, 1), 132 / 131 * 187.190e-6, 13.29e-6),
    "xyz-1.txt": ({"unit": "um"}, "xyz", (4, 4), 4e-6, 1e-6),
    "xyz-2.txt": ({"unit": "um", "undefined": "keep"}, "xyz", (4, 4), 4e-6, 1e-6),
}
READER_ARGUMENTS = {
    "csv-1.csv": 'unit is required, e.g. unit="um": .* a profile, .* specifies only x in um',
    "matrix-5.txt": "dx is required",
    "xy-1.txt": "unit is required, .* a profile, columns x and z .* specifies no unit",
    "xyz-1.txt": "unit is required, .* points, columns x, y and z .* specifies no unit",
}


@pytest.mark.parametrize("name", READ)
def test_files_of_instruments(name):
    options, format_, shape, size, span = READ[name]
    surface = measured.read(FILES / name, detrend=None, **options)
    assert surface.attrs["format"] == format_
    assert surface.heights.shape == shape
    assert surface.size[0] == pytest.approx(size, rel=1e-3)
    assert np.nanmax(surface.heights) - np.nanmin(surface.heights) == pytest.approx(span, rel=1e-3)
    assert surface.undefined == (2 if name == "xyz-2.txt" else 0)


@pytest.mark.parametrize("name", READER_ARGUMENTS)
def test_information_missing_in_files_is_requested(name):
    with pytest.raises(ValueError, match=READER_ARGUMENTS[name]):
        measured.read(FILES / name)


def test_nanofocus_steps_are_nanometres(tmp_path):
    heights = nms(tmp_path / "s.nms")
    surface = measured.read(tmp_path / "s.nms", detrend=None)
    assert surface.attrs["format"] == "nms"
    assert surface.size == (pytest.approx(24 * 6.25e-6), pytest.approx(16 * 6.25e-6))
    np.testing.assert_allclose(surface.heights, heights, rtol=1e-4)
    # a library that gives the right size is not corrected a second time
    with (tmp_path / "s.nms").open("rb") as file:
        right = instruments._nms_steps(file, (24, 16), (6.25e-6, 6.25e-6))
        assert right == pytest.approx((6.25e-6, 6.25e-6))
    # steps that give no field of an objective are left to the library
    nms(tmp_path / "t.nms", step=1e-2)
    assert measured.read(tmp_path / "t.nms").size[0] > 24e-11


def test_a_reader_that_finds_no_data_is_rejected(tmp_path):
    nms(tmp_path / "s.nms")
    with pytest.raises(ValueError, match=r"MATLAB \(mat\): the file has no channels"):
        measured.read(tmp_path / "s.nms", format="mat")
    (tmp_path / "s.nms").rename(tmp_path / "s.data")
    assert measured.read(tmp_path / "s.data").attrs["format"] == "nms"


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        ({"revision": "ISO5436 \N{EN DASH} 2000"}, r"X3P.*Revision should be 'ISO5436 - 2000'"),
        ({"folder": "scan/"}, r"X3P.*Archive member `main.xml` is missing"),
    ],
)
def test_the_reason_of_the_reader_is_reported(tmp_path, given, reason):
    x3p(tmp_path / "s.x3p")
    assert measured.read(tmp_path / "s.x3p").heights.shape == (5, 5)
    x3p(tmp_path / "s.x3p", **given)
    for format_ in (None, "x3p"):
        with pytest.raises(ValueError, match=rf"cannot read heights from .*s\.x3p: .*{reason}"):
            measured.read(tmp_path / "s.x3p", format=format_)


def test_reasons_are_sentences(tmp_path):
    (tmp_path / "s.sur").write_bytes(b"\x00\x01" * 500)
    with pytest.raises(ValueError, match=r"; it does not begin like a .*SUR.* file"):
        measured.read(tmp_path / "s.sur")
    (tmp_path / "s.txt.gz").write_bytes(gzip.compress(b"1 2 3 4\n" * 4))
    with pytest.raises(ValueError, match="compressed with gzip: unpack it first"):
        measured.read(tmp_path / "s.txt.gz")
    with pytest.raises(ValueError, match=r"cannot read heights from .*: no such file"):
        measured.read(tmp_path / "none.sur")

    def fails():
        raise IndexError("list index out of range")

    with pytest.raises(
        instruments._ReaderError, match=r"IndexError: list.*damaged, or is a variant"
    ):
        instruments._call_reader(instruments.library("SurfaceTopography.IO"), fails)


@pytest.mark.parametrize(
    ("given", "kind", "message"),
    [
        ("nsm", ValueError, "format must be the name of a reader, got 'nsm': did you mean 'nms'"),
        ("quite another thing", ValueError, "one of al3d, array, asc"),
        (3, TypeError, "format must be a string"),
    ],
)
def test_format_is_a_known_reader(tmp_path, given, kind, message):
    with pytest.raises(kind, match=message):
        measured.read(tmp_path / "s.nms", format=given)


def test_format_chooses_the_reader(tmp_path):
    heights = np.random.default_rng(2).standard_normal((6, 3)) * 1e-9
    heights[:, 0] = np.arange(6) * 1e-9
    np.savetxt(tmp_path / "h.txt", heights)
    with pytest.raises(ValueError, match=r"points x, y, z, which must fill a grid.*\"array\""):
        measured.read(tmp_path / "h.txt", dx=UM, unit="m")
    found = measured.read(tmp_path / "h.txt", dx=UM, format="array", detrend=None)
    np.testing.assert_allclose(found.heights, heights)
    with pytest.raises(ValueError, match='format must not be "array"'):
        measured.read(FILES / "sdf-1.sdf", format="array")


class TestColumns:
    x = np.linspace(0.0, 1e-3, 200)
    z = 1e-6 * np.cos(2e4 * x)

    @pytest.mark.parametrize("suffix", ["txt", "csv", "npy", "xyz"])
    @pytest.mark.parametrize("descending", [False, True])
    def test_a_two_column_profile_is_not_read_as_a_map(self, tmp_path, suffix, descending):
        path = tmp_path / f"p.{suffix}"
        table = np.column_stack([self.x, self.z])[:: -1 if descending else 1]
        if suffix == "npy":
            np.save(path, table)
        else:
            np.savetxt(path, table, delimiter="," if suffix == "csv" else " ")
        found = measured.read(path, unit="m", detrend=None)
        assert found.is_profile
        np.testing.assert_allclose(found.heights[:, 0], self.z, atol=1e-18)
        assert found.dx == pytest.approx(1e-3 / 199)
        with pytest.raises(ValueError, match=r"dx must be None, got .* a profile, columns x and"):
            measured.read(path, dx=5e-6)
        with pytest.raises(ValueError, match="unit is required"):
            measured.read(path)

    def test_rounded_positions_are_equal_steps(self, tmp_path):
        """Positions as written by a stylus instrument: 0.15625 um rounded to 0.1 um."""
        x, z = 0.15625 * np.arange(200), np.random.default_rng(4).standard_normal(200)
        text = "\n".join(f"{a:.1f},{b:.5f},," for a, b in zip(x, z, strict=True))
        head = "Scan Parameters\nStylus,Radius: 2.5 um\n\nScan Data\n\nLateral um,Raw Micrometer,\n"
        path = tmp_path / "dektak.csv"
        path.write_text(head.replace("Scan Data\n\n", "Scan Data\n\n") + text + "\n")
        found = measured.read(path, detrend=None)
        assert "interpolated_from" not in found.attrs
        assert found.dx == pytest.approx(0.15625e-6, rel=1e-4)
        np.testing.assert_allclose(found.heights[:, 0], z * UM, atol=6e-12)

    def test_unequal_steps_are_interpolated_with_a_warning(self, tmp_path):
        x = np.sort(np.random.default_rng(5).uniform(0, 1e-3, 400))
        np.savetxt(tmp_path / "p.txt", np.column_stack([x, 2.0 * x]))
        found = measured.read(tmp_path / "p.txt", unit="m", detrend=None)
        even = x[0] + found.dx * np.arange(400)
        np.testing.assert_allclose(found.heights[:, 0], 2.0 * even, rtol=1e-12)
        assert found.attrs["interpolated_from"].startswith("steps of ")
        # with a header of values by the library, to which steps below 1e-6 m are all the same
        np.savetxt(tmp_path / "p.txt", np.column_stack([x, 2.0 * x]), header="measured: today")
        again = measured.read(tmp_path / "p.txt", unit="m", detrend=None)
        np.testing.assert_allclose(again.heights, found.heights, rtol=1e-12)

    def test_points_that_are_neither_profile_nor_grid_are_refused(self, tmp_path):
        table = np.column_stack([self.x, self.z])
        table[50, 0] = 0.0
        np.savetxt(tmp_path / "p.txt", table)
        with pytest.raises(ValueError, match=r"must increase or decr.* at row 51; .*\"array\""):
            measured.read(tmp_path / "p.txt", unit="m")
        x, y = np.meshgrid(np.arange(4.0), np.arange(5.0), indexing="ij")
        points = np.column_stack([x.ravel(), y.ravel(), x.ravel()])
        for wrong, text in (
            (points[:-1], "19 points at 4 values of x and 5 values of y"),
            (np.vstack([points[:-1], points[:1]]), "20 points at 4 values of x and 5 values of y"),
            (points * [1, 1, 1] + (points[:, :1] == 3) * [0.5, 0, 0], "equal steps along x"),
        ):
            np.savetxt(tmp_path / "c.txt", wrong)
            with pytest.raises(ValueError, match=text):
                measured.read(tmp_path / "c.txt", unit="um")
        line = np.column_stack([self.x, np.full(200, 0.3), self.z])
        np.savetxt(tmp_path / "c.txt", line)
        found = measured.read(tmp_path / "c.txt", unit="m", detrend=None)
        np.testing.assert_allclose(found.heights[:, 0], self.z, atol=1e-18)
        np.savetxt(tmp_path / "c.txt", np.random.default_rng(0).permutation(points))
        found = measured.read(tmp_path / "c.txt", unit="um", detrend=None)
        np.testing.assert_allclose(found.heights, x * UM)


class TestProfiles:
    @pytest.fixture
    def profile(self):
        x = (np.arange(81) - 40) * UM
        return MeasuredSurface(-(x**2) / (2 * 1e-3), UM)

    def test_a_profile_is_pressed_in_plane_strain(self, profile):
        """Agreement with the sampled parabola, in one row of cells and in several."""
        bodies = sc.Material.rigid(), sc.Material.elastic(E=210e9, nu=0.3)
        for ny in (1, 4):
            grid = sc.Grid(60, ny, UM, UM, periodic="y")
            gap = sc.surfaces.from_heights(grid, profile.on(grid))
            exact = sc.surfaces.paraboloid(grid, 1e-3, np.inf)
            np.testing.assert_allclose(gap - gap.min(), exact - exact.min(), atol=1e-20)
            solver = sc.ContactSolver(grid, *bodies)
            load = 1e5 * grid.ny * grid.dy
            found, expected = (solver.solve(g, load=load) for g in (gap, exact))
            np.testing.assert_allclose(found.pressure, expected.pressure, rtol=1e-9)

    def test_trends_of_profiles_and_their_undefined_points(self, profile):
        x = (np.arange(81) - 40) * UM
        tilted = MeasuredSurface(profile.heights[:, 0] + 1e-2 * x + 1e-6, UM)
        assert np.abs(tilted.detrended("curvature").heights).max() < 1e-20
        for trend in ("height", "slope"):
            level = tilted.detrended(trend).heights - profile.detrended("center").heights
            assert np.abs(level).max() < 1e-20
        holes = np.array(tilted.heights)
        holes[7] = np.nan
        filled = MeasuredSurface(holes, UM).filled()
        assert filled.heights[7] == pytest.approx((holes[6] + holes[8]) / 2)
        assert filled.attrs["filled_points"] == 1

    def test_a_case_file_can_name_the_reader(self, tmp_path):
        np.savetxt(tmp_path / "p.dat", [[x, -(x**2) / 2e3] for x in range(-30, 31)])
        given = {
            "title": "t",
            "grid": {"nx": 32, "ny": 1, "dx": UM, "dy": UM, "periodic": "y"},
            "body1": {"law": "rigid"},
            "body2": {"law": "elastic", "E": 1e9, "nu": 0.3},
            "surface": {"shape": "file", "path": "p.dat", "format": "xyz", "unit": "um"},
            "path": [{"load": 1.0}],
        }
        case = Case.model_validate(given)
        grid = case.grid.build()
        gap = case.surface.build(grid, tmp_path)
        exact = grid.x[:, None] ** 2 / 2e-3
        np.testing.assert_allclose(gap, exact - exact.min(), atol=1e-15)


@pytest.mark.parametrize("n", [15, 16])
def test_a_period_of_any_number_of_samples(n):
    """A wave has no step at its ends for any origin, and is periodic beyond them."""
    length, cells = 30e-6, 64
    at = (np.arange(n) - 0.5 * (n - 1)) * length / n
    wave = MeasuredSurface(np.cos(2 * np.pi * at / length)[:, None] * np.ones(5), length / n)
    grid = sc.Grid(cells, 8, length / cells, 5 * length / n / 8, periodic="xy")
    for x in (0.0, 0.3 * length, 7.1 * length):
        found = wave.on(grid, x, periodic="xy")
        exact = np.cos(2 * np.pi * (grid.x - x) / length)[:, None] + 0 * grid.y
        assert np.abs(found - exact).max() < 2 * (2 * np.pi / n) ** 4 / 384 * 2
    with pytest.raises(ValueError, match=r"nx dx .* whole number of periods .* use dx = 3e-05/nx"):
        wave.on(sc.Grid(64, 8, UM, grid.dy, periodic="xy"), periodic="xy")
    with pytest.raises(ValueError, match=r"got 15: .*MeasuredSurface\.on\(grid, periodic=\"x\"\)"):
        sc.Grid(15, 8, UM, UM, periodic="x")


@pytest.mark.parametrize(
    ("heights", "dx", "text"),
    [
        (
            np.eye(4) * 1e-9,
            0.3,
            r"1 nm over 1\.2 m × 1\.2 m, and its area is longer than 1 m",
        ),
        (np.eye(40) * 1e-6, 1e-7, "its rms slope is"),
        (np.arange(8.0)[:, None] * 2e-6, 1e-6, "its height range exceeds its length"),
    ],
)
def test_implausible_sizes_cause_a_warning(tmp_path, heights, dx, text):
    np.save(tmp_path / "h.npy", heights)
    with pytest.warns(sc.UnitWarning, match=text):
        measured.read(tmp_path / "h.npy", dx=dx)


def test_plausible_sizes_cause_no_warning(tmp_path, recwarn):
    np.savetxt(tmp_path / "h.txt", np.random.default_rng(1).standard_normal((9, 9)) * 1e-7)
    measured.read(tmp_path / "h.txt", dx=1e-6)
    assert not [w for w in recwarn if w.category is sc.UnitWarning]

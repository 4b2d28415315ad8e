# SPDX-License-Identifier: GPL-3.0-or-later
"""Files are complete or absent; digests; inputs of extreme or zero size."""

import os
import re
import signal

import h5py
import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from samcontact import dents, measured, paths, report, results
from samcontact.files.atomic import replacing, replacing_hdf5, undisturbed
from samcontact.files.checksum import check_seal, seal

GRID = sc.Grid(8, 8, 1e-5, 1e-5)


class TestSeal:
    @pytest.fixture
    def path(self, tmp_path):
        path = tmp_path / "file.h5"
        with h5py.File(path, "w") as file:
            file["values"] = np.arange(100.0)
        return path

    def test_round_trip(self, path):
        assert not check_seal(path)
        seal(path)
        assert check_seal(path)
        with h5py.File(path, "r") as file:
            assert file["values"][99] == 99

    def test_any_changed_byte_is_detected(self, path):
        seal(path)
        content = path.read_bytes()
        for place in range(0, len(content) - 80, 97):
            path.write_bytes(content[:place] + bytes([content[place] ^ 1]) + content[place + 1 :])
            with pytest.raises(ValueError, match="the file has changed"):
                check_seal(path)

    def test_part_of_a_digest(self, path):
        seal(path)
        content = path.read_bytes()
        for end in (content[:-1], content[:-64], content[:-79], content + b"x"):
            path.write_bytes(end)
            with pytest.raises(ValueError, match="the file is incomplete, or data was appended"):
                check_seal(path)

    def test_a_deliberate_change_removes_the_digest(self, path):
        seal(path)
        with h5py.File(path, "a") as file:
            file.attrs["more"] = 1
        assert not check_seal(path)

    @pytest.mark.parametrize("content", [b"", b"x", b"x" * 200])
    def test_files_without_a_digest(self, path, content):
        path.write_bytes(content)
        assert not check_seal(path)


class TestReplacing:
    def test_errors_name_the_file_even_if_the_system_does_not(self, tmp_path):
        path = tmp_path / "text"
        path.write_text("old")
        message = re.escape(f"[Errno 28] {os.strerror(28)}: '{path}'")

        def fill():
            with replacing(path) as part:
                part.write_text("new")
                raise OSError(28, os.strerror(28))

        with pytest.raises(OSError, match=message):
            fill()
        assert path.read_text() == "old"
        assert list(tmp_path.iterdir()) == [path]

    def test_errors_unrelated_to_the_disk_are_unchanged(self, tmp_path):
        def read():
            with replacing_hdf5(tmp_path / "a.h5") as file, h5py.File(file, "w") as opened:
                return opened["missing"]

        with pytest.raises(KeyError):
            read()
        assert list(tmp_path.iterdir()) == []

    def test_ctrl_c_waits(self):
        done = []

        def write():
            with undisturbed():
                signal.raise_signal(signal.SIGINT)
                done.append("written")

        with pytest.raises(KeyboardInterrupt):
            write()
        assert done == ["written"]


class TestExtremes:
    """Extreme sizes are refused at once, with a clear error: most would exhaust the memory."""

    @pytest.mark.parametrize(
        "make",
        [
            lambda: paths.ramp(load=1.0, increments=10**9),
            lambda: paths.hold(load=1.0, increments=10**9),
            lambda: paths.load_unload(load=1.0, unload_increments=10**9),
            lambda: paths.rolling(load=1.0, distance=1.0, step=1e-9),
            lambda: paths.rolling(load=1.0, distance=1.0, step=0.1, passes=10**5),
            lambda: paths.rolling(load=1.0, distance=1e300, step=5e-324),
        ],
    )
    def test_paths(self, make):
        with pytest.raises(ValueError, match=r"must be (at most|>=) "):
            make()

    def test_grid(self):
        with pytest.raises(ValueError, match="ny must be <= 16777216, got 1073741824"):
            sc.Grid(1, 2**30, 1.0, 1.0)

    def test_dents(self):
        with pytest.raises(ValueError, match="must be within 1048576 cells"):
            dents.furrow(GRID, 1e-6, 1e3)
        with pytest.raises(ValueError, match="depth must be of magnitude >= 1e-12 radius"):
            dents.spherical(GRID, 1e-200, 1e-5)

    def test_circles(self):
        with pytest.raises(ValueError, match="R must be <= 1e150 m"):
            sc.surfaces.sphere(GRID, 1e200)

    def test_an_overflowing_pressure_does_not_converge(self):
        elastic = sc.Material.elastic(210e9, 0.3)
        solver = sc.ContactSolver(GRID, elastic, elastic, on_border="warn")
        with pytest.raises(sc.ConvergenceError, match="the solution is not finite"):
            solver.solve(sc.surfaces.paraboloid(GRID, 1e-3), approach=3.4e145)

    @pytest.mark.parametrize("value", [5e-324, 1e-76, 2e75, 1e300])
    def test_numbers_with_overflowing_products(self, value):
        with pytest.raises(ValueError, match=r"E must be between 1e-75 and 1e75 \[Pa\], got"):
            sc.Material.elastic(value, 0.3)
        with pytest.raises(ValueError, match=r"dx must be between 1e-75 and 1e75 \[m\], got"):
            sc.Grid(2, 2, value, 1.0)
        elastic = sc.Material.elastic(210e9, 0.3)
        solver = sc.ContactSolver(GRID, elastic, elastic)
        with pytest.raises(ValueError, match=r"load must be between 1e-75 and 1e75 \[N\], or 0"):
            solver.solve(np.zeros(GRID.surface_shape), load=value)

    def test_values_up_to_the_limits(self):
        assert len(paths.ramp(load=1.0, increments=100_000)) == 100_000
        assert sc.Grid(2**24, 1, 1.0, 1.0).nx == 2**24
        assert dents.spherical(GRID, 1e-15, 1e-5).heights.max() <= 0


class TestHeights:
    @pytest.mark.parametrize("suffix", [".npy", ".txt", ".csv"])
    def test_empty_file(self, tmp_path, suffix):
        path = tmp_path / f"heights{suffix}"
        path.write_bytes(b"")
        with pytest.raises(ValueError, match=re.escape(str(path))):
            measured.read(path, dx=1e-6)

    @pytest.mark.parametrize(
        "values", [np.zeros((3, 3), complex), np.zeros(3), np.zeros((0, 3)), np.zeros((2, 2), "S3")]
    )
    def test_invalid_height_arrays(self, tmp_path, values):
        np.save(tmp_path / "heights.npy", values)
        with pytest.raises(ValueError, match=r"must contain rows of numbers, got"):
            measured.read(tmp_path / "heights.npy", dx=1e-6)


class TestResults:
    """Results with a variable of wrong dimensions, and unusable files."""

    @pytest.fixture
    def dataset(self):
        elastic = sc.Material.elastic(210e9, 0.3)
        simulation = sc.Simulation(GRID, elastic, elastic, np.zeros((8, 8)), on_border="warn")
        state = simulation.step(pressure=np.ones((8, 8)))
        return results.to_dataset(simulation, [state])

    def test_reports(self, dataset, tmp_path):
        report.write(dataset, tmp_path / "report.html")
        broken = dataset.drop_vars("pressure").assign(pressure=xr.Variable((), 1.0))
        for use in (report.checks, lambda data: report.write(data, tmp_path / "other.html")):
            with pytest.raises(ValueError, match="a part is missing or has the wrong type"):
                use(broken)
        assert not (tmp_path / "other.html").exists()

    def test_a_changed_byte(self, dataset, tmp_path):
        path = results.save(dataset, tmp_path / "results.nc")
        content = path.read_bytes()
        place = content.index(b"long_name")
        path.write_bytes(content[:place] + b"L" + content[place + 1 :])
        with pytest.raises(ValueError, match="the file has changed"):
            results.open_results(path)

    def test_a_refused_file_is_closed(self, dataset, tmp_path):
        path = tmp_path / "results.nc"
        results.save(dataset, path)
        with h5py.File(path, "a") as file:
            file["increment"].attrs["units"] = "days since never"
        with pytest.raises(ValueError, match="netCDF4"):
            results.open_results(path)
        with h5py.File(path, "a") as file:  # HDF5 refuses to write to a file that is being read
            file.attrs["free"] = 1

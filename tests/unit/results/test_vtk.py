# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK files, read by VTK's own reader and compared cell by cell."""

import resource
import sys
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkDataArray
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader

import samcontact as sc
from core_fakes import ELASTIC, SWIFT, FakeState, make_simulation
from samcontact import results
from samcontact.commands.folder import is_own
from samcontact.commands.main import main

LOADS = (100.0, 300.0, 0.0)


def dataset(nz=4, bodies=(SWIFT, SWIFT), **options):
    simulation = make_simulation(nz, *bodies)
    states = [FakeState(simulation.grid, load) for load in LOADS]
    return results.to_dataset(simulation, states, **options)


def read(path):
    reader = vtkXMLRectilinearGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    # VTK keeps no reference to what its output's reader owns
    grid.reader = reader
    return grid


def value(grid, name, x, y, z):
    """Return the components of a field in the cell that contains a point."""
    cell = grid.FindCell((x, y, z), None, 0, 1e-12, mutable(0), [0.0] * 3, [0.0] * 8)
    assert cell >= 0
    return np.array(grid.GetCellData().GetArray(name).GetTuple(cell))


def names(grid):
    data = grid.GetCellData()
    return {data.GetArrayName(index) for index in range(data.GetNumberOfArrays())}


def test_a_failed_write_keeps_the_vtk_file(tmp_path, capfd):
    data, file = dataset(), tmp_path / "out.vtr"
    results.to_vtk(data, file)
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    unlimited = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, unlimited[1]))
    try:
        with pytest.raises(OSError, match="File too large") as caught:
            results.to_vtk(data, file, increment=2)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, unlimited)
    assert caught.value.filename == str(file)
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before
    assert capfd.readouterr().err == ""


def test_an_undecodable_file_name(tmp_path):
    written = results.to_vtk(dataset(), tmp_path / "out\udcff.vtr")
    assert all(path.stat().st_size > 0 for path in written)


@pytest.mark.parametrize(("body", "up"), [(1, 1.0), (2, -1.0)])
def test_volume_fields_have_the_right_positions(tmp_path, body, up):
    data = dataset()
    volume, _ = results.to_vtk(data, tmp_path / "out.vtr", increment=2, body=body)
    grid = read(volume)
    assert grid.GetNumberOfCells() == 11 * 9 * 4
    assert grid.GetBounds() == pytest.approx(
        (-5.5e-4, 5.5e-4, -5.4e-4, 5.4e-4, *sorted((0.0, up * 4e-4)))
    )
    for i, j, k in ((0, 0, 0), (3, 5, 1), (10, 8, 3), (7, 2, 2)):
        point = float(data.x[i]), float(data.y[j]), up * float(data.z[k])
        picked = data.sel(output_increment=2).isel(x=i, y=j, z=k)
        for name in ("von_mises", "hydrostatic", "equivalent_plastic_strain"):
            assert value(grid, name, *point) == pytest.approx(
                [float(picked[f"{name}_body{body}"])], rel=1e-14
            )
        for name in ("stress", "plastic_strain", "residual_stress"):
            tensor = picked[f"{name}_body{body}"]
            # with z turned round, so are the components that have one z
            expected = [
                float(tensor.sel(component=c)) * (up if c in ("yz", "xz") else 1.0)
                for c in ("xx", "yy", "zz", "xy", "yz", "xz")
            ]
            assert value(grid, name, *point) == pytest.approx(expected, rel=1e-14)


def test_tensors_name_their_components_and_fields_their_units(tmp_path):
    volume, surface = results.to_vtk(dataset(), tmp_path / "out.vtr")
    stress = read(volume).GetCellData().GetArray("stress")
    found = [stress.GetComponentName(index) for index in range(6)]
    assert found == ["xx", "yy", "zz", "xy", "yz", "xz"]
    unit = vtkDataArray.UNITS_LABEL()
    assert stress.GetInformation().Get(unit) == "Pa"
    grid = read(surface)
    assert grid.GetCellData().GetArray("gap").GetInformation().Get(unit) == "m"
    assert grid.GetFieldData().GetArray("increment").GetTuple(0) == (3.0,)
    assert grid.GetFieldData().GetArray("body").GetTuple(0) == (2.0,)


def test_surface_fields(tmp_path):
    data = dataset()
    _, surface = results.to_vtk(data, tmp_path / "out.vtr", increment=2, body=1)
    assert surface.name == "out_surface.vtr"
    grid = read(surface)
    assert grid.GetNumberOfCells() == 11 * 9
    assert grid.GetBounds()[4:] == (0.0, 0.0)
    assert {"pressure", "gap", "initial_gap", "residual_displacement"} <= names(grid)
    picked = data.sel(increment=2)
    for i, j in ((5, 4), (0, 8), (6, 4)):
        point = float(data.x[i]), float(data.y[j]), 0.0
        for name, stored in (
            ("pressure", "pressure"),
            ("residual_displacement", "residual_displacement_body1"),
        ):
            assert value(grid, name, *point) == [float(picked[stored][i, j])]
    assert value(grid, "pressure", 0.0, 0.0, 0.0)[0] > 0


def test_volume_fields_follow_the_offset_of_their_body(tmp_path):
    data = dataset()
    data["offset_body2"] = ("increment", [0.0, 2e-5, 4e-5])
    volume, _ = results.to_vtk(data, tmp_path / "out.vtr")
    assert read(volume).GetBounds()[:2] == pytest.approx((-5.1e-4, 5.9e-4))


def test_only_the_surface_is_written_without_volume(tmp_path):
    written = results.to_vtk(dataset(nz=0, bodies=(ELASTIC, ELASTIC)), tmp_path / "flat")
    assert [path.name for path in written] == ["flat_surface.vtr"]
    assert read(written[0]).GetFieldData().GetArray("increment").GetTuple(0) == (3.0,)


def test_increments_that_are_not_stored(tmp_path):
    with pytest.raises(
        ValueError, match=r"one of the increments with volume fields \(2, 3\), got 1"
    ):
        results.to_vtk(dataset(), tmp_path / "out.vtr", increment=1)
    with pytest.raises(
        ValueError, match=r"one of the increments with volume fields \(2, 3\), got -3"
    ):
        results.to_vtk(dataset(), tmp_path / "out.vtr", increment=-3)
    with pytest.raises(ValueError, match="body must be one of 1, 2, got 3"):
        results.to_vtk(dataset(), tmp_path / "out.vtr", body=3)
    assert list(tmp_path.iterdir()) == []


def test_a_missing_directory_is_an_error(tmp_path):
    with pytest.raises(FileNotFoundError, match="none"):
        results.to_vtk(dataset(), tmp_path / "none" / "out.vtr")


def export(*arguments):
    return CliRunner().invoke(main, ["export", *map(str, arguments)])


@pytest.mark.parametrize("write", [results.to_vtk, results.to_pvd])
@pytest.mark.parametrize("path", ["", ".", "..", "/", "folder/.."])
def test_a_path_without_a_name_is_refused(write, path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ValueError, match=r"path must be the name of a file, got '.*', a folder"):
        write(dataset(), path)
    assert list(tmp_path.iterdir()) == []


def test_command(tmp_path):
    file = results.save(dataset(), tmp_path / "results.nc")
    outcome = export(file, "--vtk", "--increment", 2, "--body", 1)
    assert outcome.exit_code == 0, outcome.output
    assert outcome.stdout.splitlines() == [
        str(tmp_path / "results.vtr"),
        str(tmp_path / "results_surface.vtr"),
    ]
    assert read(tmp_path / "results.vtr").GetFieldData().GetArray("body").GetTuple(0) == (1.0,)
    outcome = export(file, "--vtk", "--output", tmp_path / "other.vtr")
    assert outcome.exit_code == 0, outcome.output
    assert (tmp_path / "other_surface.vtr").is_file()


def test_command_refuses(tmp_path):
    file = results.save(dataset(), tmp_path / "results.nc")
    assert "--vtk" in export(file).stderr
    assert export(file).exit_code == 2
    outcome = export(file, "--vtk", "--increment", 7)
    assert (outcome.exit_code, outcome.stderr[:6]) == (2, "error:")
    assert "(2, 3), got 7" in outcome.stderr
    assert export(tmp_path / "none.nc", "--vtk").exit_code == 1


def test_without_vtk_the_message_names_the_extra(tmp_path, monkeypatch):
    file = results.save(dataset(), tmp_path / "results.nc")
    monkeypatch.setitem(sys.modules, "vtkmodules.vtkIOXML", None)
    outcome = export(file, "--vtk")
    assert outcome.exit_code == 1
    assert "pip install samcontact[vtk]" in outcome.stderr
    assert not (tmp_path / "results.vtr").exists()


@pytest.mark.parametrize("nz", [0, 12])
def test_the_track_of_a_moving_body(tmp_path, nz):
    """Cells of the file have the positions and values of the dataset."""
    grid = sc.Grid(15, 13, 60e-6, 60e-6, 12, 60e-6)
    simulation = sc.Simulation(grid, ELASTIC, SWIFT, sc.surfaces.paraboloid(grid, 7.5e-3))
    move = {"load": 600.0, "advance": (-60e-6, -60e-6)}
    states = simulation.run([{"load": 600.0}, move, move, {"load": 0.0}], progress=False)
    data = results.to_dataset(simulation, states, volume="last" if nz else "none")
    written = results.to_vtk(data, tmp_path / "out.vtr", body=2)
    ends = ["out", "out_surface", "out_track", "out_track_surface"] if nz else [
        "out_surface", "out_track_surface"]  # fmt: skip
    assert [file.name for file in written] == [f"{end}.vtr" for end in ends]
    surface = read(written[-1])
    x = data["track_position_body2"]
    assert len(x) > 15
    assert names(surface) == {"residual_displacement"}
    place = data.isel(track_position_body2=9, y=5)
    at = float(x[9]), float(data.y[5])
    expected = place["track_residual_displacement_body2"]
    assert value(surface, "residual_displacement", *at, 0.0) == pytest.approx(float(expected))
    assert float(expected) > 1e-9
    if nz:
        volume = read(written[2])
        assert {"residual_stress", "plastic_strain", "residual_von_mises"} <= names(volume)
        for k in (0, 4):
            one = place.isel(z=k)
            found = value(volume, "residual_stress", *at, -float(data.z[k]))
            stress = one["track_residual_stress_body2"]
            order = ("xx", "yy", "zz", "xy", "yz", "xz")
            signs = (1, 1, 1, 1, -1, -1)
            picked = [s * float(stress.sel(component=c)) for c, s in zip(order, signs, strict=True)]
            assert found == pytest.approx(picked)


def collected(path):
    """Return the times and names listed in a collection."""
    (collection,) = ElementTree.parse(path).getroot()
    return [(float(entry.get("timestep")), entry.get("file")) for entry in collection]


def test_a_collection_has_every_increment(tmp_path):
    data = dataset(volume="peak_and_last")
    files = results.to_pvd(data, tmp_path / "out")
    assert sorted(files) == sorted(tmp_path.iterdir())
    assert [file.name for file in files[:2]] == ["out.pvd", "out_surface.pvd"]
    assert collected(files[0]) == [(2.0, "out_00002.vtr"), (3.0, "out_00003.vtr")]
    assert collected(files[1]) == [(n, f"out_0000{n}_surface.vtr") for n in (1, 2, 3)]
    # each is what one increment alone gives
    volume, surface = results.to_vtk(data, tmp_path / "alone", increment=2)
    for alone, listed in ((volume, "out_00002.vtr"), (surface, "out_00002_surface.vtr")):
        one, other = read(alone), read(tmp_path / listed)
        assert names(one) == names(other)
        assert one.GetBounds() == other.GetBounds()
        for name in names(one):
            arrays = (vtk_to_numpy(grid.GetCellData().GetArray(name)) for grid in (one, other))
            np.testing.assert_array_equal(*arrays)


def test_a_collection_knows_the_time(tmp_path):
    data = dataset(volume="none").assign(time=("increment", [0.5, 1.0, 2.5]))
    files = results.to_pvd(data, tmp_path / "out.pvd", body=1)
    assert [file.name for file in files[:1]] == ["out_surface.pvd"]
    assert [time for time, _ in collected(files[0])] == [0.5, 1.0, 2.5]


def test_the_command_exports_all(tmp_path):
    file = results.save(dataset(), tmp_path / "results.nc")
    outcome = CliRunner().invoke(main, ["export", str(file), "--vtk", "--all"])
    assert outcome.exit_code == 0, outcome.output
    written = [line.rsplit("/", 1)[1] for line in outcome.stdout.splitlines()]
    assert written[:2] == ["results.pvd", "results_surface.pvd"]
    assert [name for name in written if not is_own(tmp_path / name)] == []
    outcome = CliRunner().invoke(main, ["export", str(file), "--vtk", "--all", "--increment", "1"])
    assert outcome.exit_code == 2
    assert "--increment and --all cannot be combined" in outcome.stderr

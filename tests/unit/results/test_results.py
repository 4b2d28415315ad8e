# SPDX-License-Identifier: GPL-3.0-or-later
"""Labelled results: the right number under the right label, with units, on disk and back."""

from datetime import datetime, timedelta, timezone
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from comparing import assert_stored
from core_fakes import ELASTIC, RIGID, SWIFT, FakeState, make_simulation
from samcontact import results

LOADS = (100.0, 300.0, 200.0, 0.0)


@pytest.fixture
def simulation():
    return make_simulation()


@pytest.fixture
def states(simulation):
    return [FakeState(simulation.grid, load) for load in LOADS]


def test_labels_find_the_right_numbers(simulation, states):
    data = results.to_dataset(simulation, states)
    np.testing.assert_array_equal(data["increment"], [1, 2, 3, 4])
    np.testing.assert_array_equal(data["load"], LOADS)
    np.testing.assert_array_equal(data["pressure"].sel(increment=2), states[1].pressure)
    np.testing.assert_array_equal(data["output_increment"], [2, 4])  # peak and last
    tensor = states[1].stress(body=2)
    for index, name in enumerate(("xx", "yy", "zz", "yz", "xz", "xy")):
        picked = data["stress_body2"].sel(output_increment=2, component=name)
        np.testing.assert_array_equal(picked.transpose("x", "y", "z"), tensor[index])
    value = (
        data["von_mises_body2"]
        .sel(output_increment=2)
        .sel(
            x=simulation.grid.x[3], y=simulation.grid.y[5], z=simulation.grid.z[1], method="nearest"
        )
    )
    assert float(value) == states[1].von_mises(body=2)[3, 5, 1]
    np.testing.assert_array_equal(
        data["residual_displacement_body2"].sel(increment=4),
        states[3].residual_displacement(body=2),
    )


def test_shear_is_stored_if_present(simulation, states):
    assert "shear_x" not in results.to_dataset(simulation, states)
    states[1].shear[0] = 0.2 * states[1].pressure
    data = results.to_dataset(simulation, states)
    np.testing.assert_array_equal(data["shear_x"].sel(increment=2), 0.2 * states[1].pressure)
    assert "shear_y" not in data


def test_scalars(simulation, states):
    table = results.scalars(results.to_dataset(simulation, states))
    assert list(table.index) == [1, 2, 3, 4]
    assert table.loc[2, "max_pressure"] == states[1].pressure.max()
    assert table.loc[2, "contact_area"] == states[1].contact_area > 0
    assert table.loc[2, "max_von_mises_body2"] == states[1].von_mises(body=2).max()
    assert table.loc[2, "max_equivalent_plastic_strain_body2"] == pytest.approx(
        states[1].equivalent_plastic_strain(body=2).max()
    )
    assert "pressure" not in table.columns


def test_every_variable_has_units_and_a_name(simulation, states):
    data = results.to_dataset(simulation, states, volume="all")
    assert data.sizes["output_increment"] == 4
    for name, variable in data.variables.items():
        if name == "component":
            continue
        assert variable.attrs["units"] in {"m", "m2", "N", "Pa", "1"}, name
        assert variable.attrs["long_name"], name
    assert data["stress_body2"].attrs["units"] == "Pa"
    assert data["load"].attrs["units"] == "N"


def test_bodies_and_volumes_stored(states):
    def names(**options):
        simulation = make_simulation(**options.pop("scene", {}))
        made = [FakeState(simulation.grid, load) for load in LOADS]
        return set(results.to_dataset(simulation, made, **options).data_vars)

    both = names(scene={"body1": SWIFT, "body2": SWIFT})
    assert {"plastic_strain_body1", "plastic_strain_body2", "max_von_mises_body1"} <= both
    elastic = names(scene={"body2": ELASTIC})
    assert "stress_body2" in elastic
    assert not any("plastic" in name or "residual" in name for name in elastic)
    chosen = names(scene={"body2": ELASTIC}, body=1)
    assert "stress_body1" in chosen
    assert "stress_body2" not in chosen
    rigid = names(scene={"body1": RIGID}, body=1)
    assert "stress_body1" not in rigid
    assert "stress_body2" in rigid
    assert "stress_body2" not in names(volume="none")
    assert "max_von_mises_body2" in names(volume="none")
    surface_only = names(scene={"nz": 0, "body2": ELASTIC})
    assert not any("von_mises" in name for name in surface_only)


def test_attributes(simulation, states):
    case = SimpleNamespace(
        title="scene",
        description="of two",
        text="[grid]\nnx = 3\n",
        output=SimpleNamespace(body=2, volume="last"),
    )
    data = results.to_dataset(simulation, states, case)
    assert data.sizes["output_increment"] == 1
    assert data.attrs["title"] == "scene"
    assert data.attrs["case"] == "[grid]\nnx = 3\n"
    assert data.attrs["body2_law"] == "swift"
    assert data.attrs["body2_B"] == 945e6
    assert data.attrs["samcontact_version"] == sc.__version__
    created = datetime.fromisoformat(data.attrs["created"])
    assert abs(datetime.now(timezone.utc) - created) < timedelta(minutes=5)


def test_round_trip(simulation, states, tmp_path):
    data = results.to_dataset(simulation, states)
    path = results.save(data, tmp_path / "out.nc")
    assert [p.name for p in tmp_path.iterdir()] == ["out.nc"]
    with results.open_results(path) as again:
        assert_stored(again, data)


def test_texts_of_any_language(simulation, states, tmp_path):
    data = results.to_dataset(simulation, states).assign_attrs(title="Köpfe µ")
    data["error"] = ("increment", np.array(["", "12 µm", "接触", "x"], dtype=object))
    with results.open_results(results.save(data, tmp_path / "out.nc")) as again:
        assert_stored(again, data)


def test_failed_write_leaves_the_old_file(simulation, states, tmp_path, monkeypatch):
    path = results.save(results.to_dataset(simulation, states), tmp_path / "out.nc")
    before = path.read_bytes()

    def broken(self, store, **_):
        store.ds.attrs["half"] = 1
        raise OSError("disk full")

    monkeypatch.setattr(xr.Dataset, "dump_to_store", broken)
    with pytest.raises(OSError, match="disk full"):
        results.save(results.to_dataset(simulation, states), path)
    assert path.read_bytes() == before
    assert [p.name for p in tmp_path.iterdir()] == ["out.nc"]


def test_open_refuses_other_files(tmp_path):
    with pytest.raises(FileNotFoundError, match="no results file at"):
        results.open_results(tmp_path / "none.nc")
    (tmp_path / "text.nc").write_text("hello")
    with pytest.raises(ValueError, match="must be a netCDF4 file"):
        results.open_results(tmp_path / "text.nc")
    xr.Dataset({"a": 1}).to_netcdf(tmp_path / "other.nc", engine="h5netcdf")
    with pytest.raises(ValueError, match="written by samcontact"):
        results.open_results(tmp_path / "other.nc")


def test_bad_arguments(simulation, states):
    with pytest.raises(ValueError, match="at least one state"):
        results.to_dataset(simulation, [])
    with pytest.raises(ValueError, match=r"volume must be one of 'none', .* got 'some'"):
        results.to_dataset(simulation, states, volume="some")
    with pytest.raises(ValueError, match="body must be one of 1, 2, got 3"):
        results.to_dataset(simulation, states, body=3)


def test_real_simulation(tmp_path):
    grid = sc.Grid(13, 13, 60e-6, 60e-6, 12, 60e-6)
    steel = sc.Material.elastic(210e9, 0.3)
    soft = sc.Material.swift(210e9, 0.3, 945e6, 20, 0.121)
    simulation = sc.Simulation(grid, steel, soft, sc.surfaces.paraboloid(grid, 7.5e-3))
    states = simulation.run([{"load": 600.0}, {"load": 0.0}], progress=False)
    path = results.save(results.to_dataset(simulation, states), tmp_path / "real.nc")
    with results.open_results(path) as data:
        table = results.scalars(data)
        assert float(data["pressure"].sel(increment=1).sum()) * 60e-6**2 == pytest.approx(600.0)
        assert table.loc[2, "contact_area"] == 0.0
        assert table.loc[2, "max_equivalent_plastic_strain_body2"] > 0.0
        np.testing.assert_array_equal(
            data["stress_body2"].sel(output_increment=1).transpose("component", "x", "y", "z"),
            states[0].stress(body=2),
        )
        assert data.attrs["body1_E"] == 210e9


def test_each_increment_has_its_own_heat_factor(tmp_path):
    steel = sc.Material.elastic(210e9, 0.3).with_thermal(50.0, 1e-5, 1.4e-5)
    grid = sc.Grid(9, 9, 60e-6, 60e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    heat = {"heat": sc.Heat([0.0, 2e-3], time=1e-3), "on_border": "warn"}
    simulation = sc.Simulation(grid, steel, steel, gap, **heat)
    path = [{"load": 10.0}, {"load": 10.0, "heat_factor": [1e-3, 0.0]}, {"load": 5.0}]
    path.append({"load": 5.0, "heat_factor": 0.0})
    states = simulation.run(path, progress=False)
    file = results.save(results.to_dataset(simulation, states), tmp_path / "results.nc")
    with results.open_results(file) as data:
        factors = data["heat_factor"]
        assert factors.dims == ("increment", "body")
        assert factors.attrs["units"] == "m/s"
        np.testing.assert_array_equal(
            factors.values, [[0.0, 2e-3], [1e-3, 0.0], [1e-3, 0.0], [0.0, 0.0]]
        )
        assert "heat_factor" not in data.attrs
        # what the largest rise says too: a source that is off heats no more
        assert (data["max_temperature_body2"].values > 0).tolist() == [True, False, False, False]


def test_imprint_depth(simulation, states):
    data = results.to_dataset(simulation, states)
    expected = [float(state.residual_displacement(2).max()) for state in states]
    assert data["imprint_depth_body2"].values.tolist() == expected
    assert expected[-1] > 0
    assert "imprint_depth_body2" in results.scalars(data)


def test_a_file_states_its_conventions_and_history(simulation, states, tmp_path):
    data = results.to_dataset(simulation, states)
    for count in (1, 2):
        with results.open_results(results.save(data, tmp_path / "out.nc")) as again:
            assert again.attrs["Conventions"] == "CF-1.11"
            lines = again.attrs["history"].splitlines()
            data = again.load()
        assert len(lines) == count
        for line in lines:
            when, _, what = line.partition(": ")
            assert datetime.fromisoformat(when).tzinfo is not None
            assert what == f"written by samcontact {sc.__version__}"

# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of a moving contact: travel and tracks under their labels, on disk and back."""

import numpy as np
import pytest

import samcontact as sc
from comparing import assert_stored
from samcontact import paths, results

STEEL = sc.Material.elastic(210e9, 0.3)
SOFT = sc.Material.swift(210e9, 0.3, 945e6, 20, 0.121)
STEP = 60e-6
GRID = sc.Grid(15, 13, STEP, STEP, 12, STEP)


def rolled(body1=STEEL, body2=SOFT, **options):
    simulation = sc.Simulation(GRID, body1, body2, sc.surfaces.paraboloid(GRID, 7.5e-3))
    given = {"load": 700.0, "distance": 20 * STEP, "step": 2 * STEP, "increments": 2}
    return simulation, simulation.run(paths.rolling(**{**given, **options}), progress=False)


@pytest.fixture(scope="module")
def run():
    return rolled()


def test_travel_and_tracks(run, tmp_path):
    simulation, states = run
    data = results.to_dataset(simulation, states)
    with results.open_results(results.save(data, tmp_path / "out.nc")) as again:
        assert_stored(again, data)
    way = -np.concatenate([[0, 0], np.arange(2, 22, 2), [20, 20]]) * STEP
    for body in (1, 2):
        np.testing.assert_allclose(data[f"travel_body{body}"], way, atol=1e-17)
    np.testing.assert_array_equal(data["contact_origin"], 0.0)
    assert "offset_body2" not in data
    assert "track_position_body1" not in data.coords  # elastic

    track = states[-1].track(2)
    np.testing.assert_array_equal(data["track_position_body2"], track.x)
    tensor, volume = (
        ("component", "track_position_body2", "y", "z"),
        ("track_position_body2", "y", "z"),
    )
    for name, dims, field in (
        ("residual_displacement", volume[:2], track.residual_displacement()),
        ("residual_stress", tensor, track.residual_stress()),
        ("plastic_strain", tensor, track.plastic_strain()),
        ("equivalent_plastic_strain", volume, track.equivalent_plastic_strain()),
        ("residual_von_mises", volume, track.residual_von_mises()),
        ("residual_hydrostatic", volume, track.residual_hydrostatic()),
    ):
        variable = data[f"track_{name}_body2"]
        assert variable.dims == dims
        assert variable.attrs["units"] in {"m", "Pa", "1"}
        assert "body 2" in variable.attrs["long_name"]
        np.testing.assert_array_equal(variable, field)
        assert np.any(field)
    assert data.attrs["reach"] == simulation.reach


def test_maximum_of_the_strain_is_that_of_the_whole_track(run):
    simulation, states = run
    largest = results.scalars(results.to_dataset(simulation, states))
    largest = largest["max_equivalent_plastic_strain_body2"].to_numpy()
    assert np.all(np.diff(largest) >= 0)  # it never shrinks, though the place leaves the grid
    assert largest[-1] == states[-1].track(2).equivalent_plastic_strain().max()


def test_imprints_are_stored_without_volume_fields(run):
    data = results.to_dataset(*run, volume="none")
    tracks = {name for name in data.variables if name.startswith("track")}
    assert tracks == {"track_position_body2", "track_residual_displacement_body2"}


def test_bodies_that_do_not_move_have_no_track():
    simulation = sc.Simulation(GRID, SOFT, SOFT, sc.surfaces.paraboloid(GRID, 7.5e-3))
    path = paths.sliding(load=600.0, distance=2 * STEP, step=STEP, increments=1)
    data = results.to_dataset(simulation, simulation.run(path, progress=False))
    assert "track_residual_stress_body2" in data
    assert not any("track" in name and "body1" in name for name in data.variables)
    still = sc.Simulation(GRID, STEEL, SOFT, sc.surfaces.paraboloid(GRID, 7.5e-3))
    data = results.to_dataset(still, [still.step(load=600.0)])
    assert not any("track" in name or "travel" in name for name in data.variables)


def test_offsets_of_motions_by_fractions_of_a_cell():
    options = {"distance": 2 * STEP, "step": STEP, "slide_to_roll": -0.5, "increments": 1}
    simulation, states = rolled(body1=SOFT, **options)
    data = results.to_dataset(simulation, states)
    np.testing.assert_allclose(data["travel_body1"][2], -1.5 * STEP)
    np.testing.assert_allclose(data["travel_body2"][2], -2.5 * STEP)
    for number, state in enumerate(states, start=1):
        picked = data.sel(increment=number)
        assert float(picked["contact_origin"]) == state.origin
        for body in (1, 2):
            if f"offset_body{body}" in data:
                assert float(picked[f"offset_body{body}"]) == state.offset(body)
    assert {"offset_body1", "offset_body2"} & set(data.data_vars)


def test_motion_of_surfaces_without_volume():
    grid = sc.Grid(15, 13, STEP, STEP)
    simulation = sc.Simulation(grid, STEEL, STEEL, sc.surfaces.paraboloid(grid, 7.5e-3))
    path = paths.rolling(load=300.0, distance=STEP, step=STEP, increments=1)
    data = results.to_dataset(simulation, simulation.run(path, progress=False))
    np.testing.assert_allclose(data["travel_body2"], [0.0, -STEP, -STEP])

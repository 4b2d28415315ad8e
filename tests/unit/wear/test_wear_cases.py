# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files with wear cycles, and the output of the command."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from case_texts import SCAR, WEAR
from command import check_failure, invoke
from samcontact import wear
from samcontact.cases import CaseError, load_case


@pytest.fixture
def case_file(tmp_path):
    path = tmp_path / "ball.toml"
    path.write_text(WEAR)
    return path


def test_the_command_is_the_call_that_the_case_describes(case_file, tmp_path, undrawn):
    case_file.write_text(WEAR.replace("figures = false", "figures = true"))
    outcome = invoke("run", case_file, "--output", tmp_path / "out", "--resume")
    assert outcome.exit_code == 0, outcome.output
    pictures = ["wear_rate", "profile_body2", "surface_body2", "first_cycle_body2"]
    pictures.append("last_cycle_body2")
    names = [".samcontact-files", "wear.nc", "wear.csv", *(f"{name}.png" for name in pictures)]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == sorted(names)
    simulation, cycle = load_case(case_file).build()
    expected = wear.run(
        simulation.grid, simulation.body1, simulation.body2, simulation.initial_gap, cycle=cycle,
        threshold=0.002, cycles=1, window=(3, 5), order=1, friction=0.4, progress=False,
    )  # fmt: skip
    assert expected.rate[0] > 0
    with xr.open_dataset(tmp_path / "out" / "wear.nc", engine="h5netcdf") as dataset:
        np.testing.assert_array_equal(dataset.heights_body2.values, expected.heights[2])
        assert dataset.attrs["title"] == "Wearing ball"
    table = pd.read_csv(tmp_path / "out" / "wear.csv")
    np.testing.assert_allclose(table.wear_rate, expected.rate)
    assert f"{1e18 * expected.rate[0]:.0f}" in outcome.stdout
    assert "wear has not ceased after 1 cycles" in outcome.stdout


def test_a_run_whose_wear_ceases_reports_no_further_wear(case_file, tmp_path):
    case_file.write_text(WEAR.replace("1700.0", "170.0").replace("cycles = 1", "cycles = 3"))
    outcome = invoke("run", case_file, "--output", tmp_path / "out")
    assert outcome.exit_code == 0, outcome.output
    assert "not ceased" not in outcome.stdout


def test_the_command_computes_a_scar(case_file, tmp_path, undrawn):
    case_file.write_text(SCAR)
    outcome = invoke("run", case_file, "--output", tmp_path / "out")
    assert outcome.exit_code == 0, outcome.output
    names = [".samcontact-files", "wear.nc", "wear.csv", "fretting.png", "wear_rate.png"]
    names += [f"{kind}_body{body}.png" for kind in ("profile", "surface") for body in (1, 2)]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == sorted(names)
    simulation, cycle = load_case(case_file).build()
    expected = wear.fretting(
        simulation.grid, simulation.body1, simulation.body2, simulation.initial_gap, cycle=cycle,
        energy=(1e-14, 3e-14), repeats=20000, cycles=2, friction=simulation.friction,
        progress=False,
    )  # fmt: skip
    with xr.open_dataset(tmp_path / "out" / "wear.nc", engine="h5netcdf") as dataset:
        np.testing.assert_array_equal(dataset.heights_body2.values, expected.heights[2])
    assert "stick" in outcome.stdout


def test_a_case_of_a_coated_yielding_body_in_partial_slip(case_file, tmp_path):
    layer = """
[[body2.layers]]
thickness = 96e-6
law = "perfect_plastic"
E = 210e9
nu = 0.3
yield_stress = 1000e6
"""
    text = WEAR.replace("friction = 0.4", "friction = {coulomb = 0.4}").replace("1700.0", "300.0")
    case_file.write_text(text.replace("[surface]", layer + "[surface]"))
    outcome = invoke("run", case_file, "--output", tmp_path / "out")
    assert outcome.exit_code == 0, outcome.output
    simulation, cycle = load_case(case_file).build()
    expected = wear.run(
        simulation.grid, simulation.body1, simulation.body2, simulation.initial_gap, cycle=cycle,
        threshold=0.002, cycles=1, window=(3, 5), order=1, friction=simulation.friction,
        progress=False,
    )  # fmt: skip
    with xr.open_dataset(tmp_path / "out" / "wear.nc", engine="h5netcdf") as dataset:
        found = dataset["max_equivalent_plastic_strain"].values.ravel()
    assert found == [cycle.max_equivalent_plastic_strain for cycle in expected.cycles]
    assert found[0] > 0


def test_a_case_of_a_hot_scar_on_a_small_grid(case_file, tmp_path):
    thermal = "nu = 0.3\nthermal = {conductivity = 50.0, expansion = 12e-6, diffusivity = 1e-5}"
    text = SCAR.replace("nu = 0.3", thermal).replace(
        "increments = 1", "increments = 1\nduration = 1e-4"
    )
    text = text.replace("nx = 24", "nx = 14").replace("ny = 24", "ny = 14")
    case_file.write_text(text + "[heat]\npartition = 0.5\n")
    outcome = invoke("run", case_file, "--output", tmp_path / "out", "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    with xr.open_dataset(tmp_path / "out" / "wear.nc", engine="h5netcdf") as dataset:
        assert dataset.sizes["y"] > 14
        assert dataset["friction_work"].values[0] > 0


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        ("threshold = 0.002", "threshold = 0.00001", "threshold must be"),
        ("window = [3, 5]", "window = 4", "window must be"),
        ("window = [3, 5]", "window = 31", "window"),
        ("load = 0.0", "load = 10.0", "cycle"),
        ("cycles = 1", "cycles = 1\nworn = [1]", "worn"),
    ],
)
def test_fields_refused_with_wear(case_file, tmp_path, old, new, text):
    case_file.write_text(WEAR.replace(old, new))
    check_failure(invoke("run", case_file, "--output", tmp_path / "out", "--quiet"), 2, text)


def test_invalid_wear_sections(case_file, tmp_path):
    check_failure(
        invoke("run", case_file, "--animate"), 2, "--animate cannot be combined with [wear]"
    )
    case_file.write_text(WEAR.replace("threshold", "treshold"))
    with pytest.raises(CaseError, match=r"wear.treshold: unknown field; allowed here: threshold"):
        load_case(case_file)

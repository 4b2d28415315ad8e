# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps of wear, fatigue, shakedown and of load searches: each case as solved alone."""

import csv
import re

import numpy as np
import pytest
from sweep_cases import BASE

import samcontact as sc
from command import invoke
from samcontact.cases import Case
from samcontact.results import open_results

CYCLE_CASE = """title = "ball on flat"
fatigue = {dang_van = 0.3, limit = {dang_van = 5e8}}
shakedown = {cycles = 4, tol = 0.01}
grid = {nx = 15, ny = 13, dx = 60e-6, dy = 60e-6, nz = 12, dz = 60e-6}
body1 = {law = "elastic", E = 210e9, nu = 0.3}
body2 = {law = "perfect_plastic", E = 210e9, nu = 0.3, yield_stress = 2e9}
surface = {shape = "paraboloid", Rx = 7.5e-3}
path = [{load = 500.0, increments = 1}, {load = 0.0, increments = 1}]
"""
STEEL = {"law": "elastic", "E": 210e9, "nu": 0.3}
FRETTED = {
    "title": "scar",
    "grid": {"nx": 15, "ny": 15, "dx": 4e-5, "dy": 4e-5},
    "body1": STEEL,
    "body2": STEEL,
    "surface": {"shape": "paraboloid", "Rx": 0.01},
    "contact": {"friction": {"coulomb": 0.4}},
    "path": [
        {"load": 100.0, "increments": 1},
        {"load": 100.0, "increments": 2, "fret": {"shift_x": 2e-6}},
    ],
    "wear": {"energy": [1e-14, 3e-14], "cycles": 2},
}


def test_a_sweep_of_wear_has_the_cycles_of_each_case(tmp_path):
    case = Case.model_validate(FRETTED)
    cycles = [1, 2]
    found = sc.sweep(case, {"wear.cycles": cycles}, output=tmp_path, progress=False)
    assert list(found["status"].values) == ["done", "done"]
    alone = case.wear.solve(*case.build(), None, False).to_dataset()
    longer = found.isel({"wear.cycles": 1})
    for body in (1, 2):
        volume = longer[f"volume_body{body}"]
        assert np.array_equal(volume, alone["volume"].sel(body=body))
        assert volume.attrs["units"] == "m3"
    assert np.array_equal(longer["worn_volume"], alone["worn_volume"])
    assert longer["volume_body2"][0] == pytest.approx(3 * float(longer["volume_body1"][0]))
    # a shorter case has no value after its last cycle, and stored cases are not solved again
    assert np.isnan(found["worn_volume"].isel({"wear.cycles": 0})[1])
    again = sc.sweep(case, {"wear.cycles": cycles}, output=tmp_path, progress=False)
    assert again.identical(found)


def test_a_sweep_judges_fatigue_and_shakedown_of_each_case(tmp_path, undrawn):
    closed = [{"load": 500.0, "increments": 1}, {"load": 0.0, "increments": 1}]
    case = Case.model_validate(
        BASE
        | {
            "path": closed,
            "fatigue": {"dang_van": 0.3, "limit": {"dang_van": 5e8}},
            "shakedown": {"cycles": 4, "tol": 0.01},
        }
    )
    yields = {"body2.yield_stress": [1e9, 9e9]}
    found = sc.sweep(case, yields, output=tmp_path / "out", progress=False)
    assert list(found["status"].values) == ["done", "done"]
    assert found["shakedown_response"].values.tolist() == ["elastic shakedown", "elastic"]
    again = sc.sweep(case, yields, output=tmp_path / "out", progress=False)  # from stored numbers
    assert again["shakedown_response"].identical(found["shakedown_response"])
    file = tmp_path / "case.toml"
    file.write_text(CYCLE_CASE)
    setting = "body2.yield_stress=1e9,9e9"
    shown = invoke("sweep", file, "--set", setting, "--output", tmp_path / "out")
    assert re.search(r"elastic\s+shakedown", shown.stdout), shown.output
    with open(tmp_path / "out" / "sweep.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["shakedown_response"] for row in rows] == ["elastic shakedown", "elastic"]
    assert [float(row["body2.yield_stress [Pa]"]) for row in rows] == [1e9, 9e9]
    assert float(rows[0]["fatigue_dang_van [Pa]"]) == found["fatigue_dang_van"].values[0]
    assert rows[1]["status"] == "done"
    assert found["shakedown_yield_strain"].values[0] == pytest.approx(1e9 / 210e9)
    soft = case.model_copy(update={"body2": case.body2.model_copy(update={"yield_stress": 1e9})})
    simulation, path = soft.build()
    (field,) = case.fatigue.fields(simulation.run(path, progress=False), 2)
    assert found["fatigue_dang_van"].values[0] == field.max_value
    assert found["fatigue_margin_dang_van"].values[0] == field.margin(5e8)
    assert found["load"].sizes["increment"] == 2


def test_wear_has_no_load_search():
    case = Case.model_validate(FRETTED)
    for quantity in ("worn_volume", "max_pressure"):
        with pytest.raises(ValueError, match=r"does not support wear: remove \[wear\]"):
            sc.sweep(case, {"wear.cycles": [1]}, find={"quantity": quantity}, progress=False)


def test_a_sweep_of_load_searches_finds_loads_of_hertz(tmp_path):
    text = f"""title = "ball"
[grid]
nx = 24
ny = 24
dx = 2e-5
dy = 2e-5
[body1]
law = "rigid"
[body2]
law = "elastic"
E = {STEEL["E"]}
nu = {STEEL["nu"]}
[surface]
shape = "paraboloid"
Rx = 5e-3
[[path]]
load = 50.0
increments = 1
"""
    file = tmp_path / "ball.toml"
    file.write_text(text)
    outcome = invoke(
        "sweep", file, "--set", "surface.Rx=1e-2", "--find", "max_pressure=2 GPa",
        "--output", tmp_path / "out",
    )  # fmt: skip
    assert outcome.exit_code == 0, outcome.output
    assert "Load search" in outcome.stdout
    found = open_results(tmp_path / "out" / "sweep.nc")
    loads, errors = found["found_load"].values, found["found_load_error"].values
    # Hertz
    exact = (np.pi * 2e9) ** 3 * 1e-2**2 / (6 * (STEEL["E"] / (1 - STEEL["nu"] ** 2)) ** 2)
    assert np.all(np.abs(loads - exact) < errors)
    assert np.all(errors < 0.3 * loads)
    outcome = invoke("sweep", file, "--set", "path[0].approach=1e-6", "--find", "yield")
    assert outcome.exit_code == 2


@pytest.mark.parametrize(
    ("find", "message"),
    [
        ({"value": 1e9}, "find must have the key 'quantity'"),
        ({"quantity": "max_presure"}, "did you mean max_pressure"),
        ({"quantity": "worn_volume"}, "does not support wear; solve the case for several"),
        ({"quantity": "depth_body2"}, "does not support wear; solve the case for several"),
        ({"quantity": "yield", "load": 3.0}, "find must have the key 'quantity', and may have"),
    ],
)
def test_searches_are_checked_before_any_case_is_solved(find, message):
    with pytest.raises(ValueError, match=message):
        sc.sweep(Case.model_validate(BASE), {"body2.E": [2e11]}, find=find, progress=False)

# SPDX-License-Identifier: GPL-3.0-or-later
"""[fatigue] of a case file: output of the command against results from Python."""

import re

import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from case_texts import MINIMAL
from command import check_failure, invoke
from samcontact import cases, report, results

FATIGUE = """
[fatigue]
dang_van = 0.3
crossland = 0.4
findley = 0.2
fatemi_socie = 0.5
orthogonal_shear = "y"
yield_stress = "2 GPa"
limit = {dang_van = "300 MPa", fatemi_socie = 0.004}
"""
PASSING = '[fatigue]\nsteady_axis = "x"\nfatemi_socie = 0.5\n'


@pytest.fixture
def run(tmp_path):
    def run(more, *options):
        path = tmp_path / "case.toml"
        path.write_text(f"{MINIMAL}\n{more}")
        return invoke("run", path, "--output", tmp_path / "out", *options), tmp_path / "out"

    return run


def states_of(more):
    simulation, path = cases.parse_case(f"{MINIMAL}\n{more}").build()
    return simulation.run(path, progress=False)


def test_the_cycle_is_the_path(run, undrawn):
    outcome, folder = run(FATIGUE)
    assert outcome.exit_code == 0, outcome.output
    assert "Fatigue of body 2 over 3 instants" in outcome.stdout
    with results.open_results(folder / "fatigue.nc") as stored:
        found = stored.load()
    seen = sc.fatigue.cycle(states_of(FATIGUE))
    expected = {
        "dang_van": sc.fatigue.dang_van(seen, slope=0.3),
        "crossland": sc.fatigue.crossland(seen, slope=0.4),
        "findley": sc.fatigue.findley(seen, k=0.2),
        "fatemi_socie": sc.fatigue.fatemi_socie(seen, k=0.5, yield_stress=2e9),
        "orthogonal_shear": sc.fatigue.orthogonal_shear(seen, axis="y"),
    }
    assert set(found.data_vars) == {*expected, "findley_normal", "fatemi_socie_normal"}
    for name, field in expected.items():
        np.testing.assert_array_equal(found[name].values, field.values)
    margin = 100 * expected["dang_van"].margin(300e6)
    assert f"│ {margin:6.1f} │" in outcome.stdout
    assert {"fatigue_depth.png", "fatigue_strain.png", "fatigue_section.png"} <= {
        file.name for file in folder.iterdir()
    }


def test_passing_material(run, undrawn):
    """Passing material uses the increment of maximum load, independent of the rest of the path."""
    outcome, folder = run(PASSING)
    assert outcome.exit_code == 0, outcome.output
    loaded = states_of(PASSING)[1]
    field = sc.fatigue.fatemi_socie(sc.fatigue.steady_cycle(loaded), k=0.5)
    with xr.open_dataset(folder / "fatigue.nc") as found:
        assert found["fatemi_socie"].dims == ("y", "z")
        np.testing.assert_array_equal(found["fatemi_socie"].values, field.values)
    assert not (folder / "fatigue_depth.png").exists()
    # a later run without [fatigue] removes its results
    outcome, _ = run("")
    assert outcome.exit_code == 0
    assert [file.name for file in folder.iterdir() if "fatigue" in file.name] == []


def test_unsupported_criteria_are_refused_before_the_run(run):
    outcome, _ = run("[fatigue]\ndang_van = 300e6")
    check_failure(outcome, 2, "fatigue.dang_van", "must be a number in [0, 10]")
    outcome, _ = run("[fatigue]\nfatemi_socie = 0.5\n[output]\nbody = 1")
    check_failure(outcome, 2, "fatigue.yield_stress is required")


WEAR = "[wear]\nthreshold = 2e-3\n"
SINGLE = MINIMAL.replace("increments = 2", "increments = 1").split("[[path]]")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            f"{MINIMAL}\n{WEAR}[fatigue]\ndang_van = 0.3",
            r"fatigue cannot be combined with \[wear\]",
        ),
        (f"{MINIMAL}\n[fatigue]\nsteady_axis = 'x'", "at least one of dang_van, crossland"),
        (f"{MINIMAL}\n[fatigue]\ndang_van = 0.3\nyield_stress = 1e9", "by fatemi_socie only"),
        (
            f"{MINIMAL}\n[fatigue]\ndang_van = 0.3\nlimit = {{findley = 1e8}}",
            r"limit\.findley requires",
        ),
        (f"{'[[path]]'.join(SINGLE[:2])}\n[fatigue]\ndang_van = 0.3", "at least 2 increments"),
    ],
)
def test_incompatible_fields_are_refused(text, message):
    with pytest.raises(cases.CaseError, match=message):
        cases.parse_case(text)


JUDGED = """
[body2.hardness]
surface = 390.0
core = 250.0
depth = 0.3e-3
limit = 320.0
[fatigue]
dang_van = 0.3
limit = {dang_van = "300 MPa"}
exposure = {slope = 0.3}
life = {criterion = "dang_van"}
"""


def test_a_report_shows_criteria_exposure_and_life(run, monkeypatch):
    """All numbers are those of the fields in fatigue.nc."""
    monkeypatch.setattr("samcontact.report.contact.contact_figures", lambda *_: [])
    outcome, folder = run(JUDGED, "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    page = invoke("report", folder)
    assert page.exit_code in (0, 1), page.output
    text = (folder / "report.html").read_text(encoding="utf-8")

    def numbers(name):
        (table,) = re.findall(rf'<table id="{name}-table">.*?</table>', text, re.DOTALL)
        return [float(value) for value in re.findall(r'<data value="([^"]*)">', table)]

    with results.open_results(folder / "fatigue.nc") as stored:
        found = stored.load()
    largest, depth, limit, margin = numbers("fatigue")
    assert largest == found["dang_van"].values.max()
    assert (limit, margin) == (300e6, pytest.approx(300e6 / largest - 1))
    assert depth in found["z"].values
    exposure, where, stress, strength, hardness = numbers("exposure")[:5]
    assert exposure == found["exposure_yield"].values.max() == pytest.approx(stress / strength)
    at = {"z": where, "method": "nearest"}
    assert hardness == found["hardness"].sel(**at)
    assert strength == found["strength_yield"].sel(**at)
    assert f"logarithm of the integral {found.attrs['life_log_integral']:.6g}" in text
    assert text.count("data:image/png") == 2  # criteria and exposure over depth
    with pytest.raises(ValueError, match=r"fatigue must be the dataset .* has no dang_van"):
        report.write(found, folder / "other.html", fatigue=xr.Dataset())

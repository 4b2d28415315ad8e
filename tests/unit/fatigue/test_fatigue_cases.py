# SPDX-License-Identifier: GPL-3.0-or-later
"""[fatigue] of a case file: output of the command against results from Python."""

import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from case_texts import MINIMAL
from command import check_failure, invoke
from samcontact import cases, results

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
    def run(more):
        path = tmp_path / "case.toml"
        path.write_text(f"{MINIMAL}\n{more}")
        return invoke("run", path, "--output", tmp_path / "out"), tmp_path / "out"

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

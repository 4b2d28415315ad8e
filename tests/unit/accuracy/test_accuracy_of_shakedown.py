# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs to an accuracy of repeated load cycles."""

import pytest

import samcontact as sc
from command import fields, invoke
from samcontact.cases import Case, CaseError
from samcontact.results import open_results
from samcontact.simulation import error_controlled_quantities

YIELDS = {"law": "perfect_plastic", "E": 210e9, "nu": 0.3, "yield_stress": 1.6e9}
PRESSED = {
    "title": "pressed again",
    "body1": {"law": "rigid"},
    "body2": YIELDS,
    "surface": {"shape": "paraboloid", "Rx": 7.5e-3},
    "path": [{"load": 500.0}, {"load": 0.0}],
    "shakedown": {"cycles": 4, "tol": 0.01},
}
STRAIN, DEPTH = "max_equivalent_plastic_strain_body2", "imprint_depth_body2"
TEXT = """title = "pressed again"
accuracy = {imprint_depth_body2 = 0.9}
[body1]
law = "rigid"
[body2]
law = "perfect_plastic"
E = 210e9
nu = 0.3
yield_stress = 1.6e9
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[[path]]
load = 200.0
[[path]]
load = 0.0
[shakedown]
cycles = 2
tol = 0.05
"""


@pytest.mark.slow
def test_repeated_pressing_is_closer_to_a_finer_grid_than_the_stated_error():
    rough, fine = (
        sc.to_accuracy(PRESSED, accuracy, quantities=[STRAIN, DEPTH], progress=False)
        for accuracy in (0.3, 0.06)
    )
    assert rough.reached
    assert rough.shakedown.response == fine.shakedown.response == "elastic shakedown"
    for name, value in rough.values.items():
        assert abs(value - fine.values[name]) <= rough.errors[name] + fine.errors[name]
        assert rough.errors[name] > 0
    state = rough.shakedown.state
    found = error_controlled_quantities.value(state, STRAIN)
    assert found == pytest.approx(rough.values[STRAIN], rel=0.3)


def test_a_case_file_of_shakedown_has_errors_of_the_last_state(tmp_path, undrawn):
    file = tmp_path / "again.toml"
    file.write_text(TEXT)
    outcome = invoke("run", file, "--output", tmp_path / "out", "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    data = fields(tmp_path / "out")
    assert data.sizes["increment"] == 1
    assert 0 < data[f"{DEPTH}_error"][0] < 0.9 * data[f"{DEPTH}_best"][0]
    assert open_results(tmp_path / "out" / "shakedown.nc").attrs["response"] == "elastic shakedown"


def test_fatigue_needs_all_states_of_the_path():
    with pytest.raises(CaseError, match="fatigue cannot be combined with both shakedown and acc"):
        Case.model_validate(PRESSED | {"accuracy": 0.1, "fatigue": {"dang_van": 0.3}})

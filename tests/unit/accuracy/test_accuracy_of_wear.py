# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs to an accuracy of cycles of wear."""

import numpy as np
import pytest

import samcontact as sc
from command import invoke
from samcontact.accuracy import estimate
from samcontact.accuracy.refinable_case import RefinableCase
from samcontact.cases import Case
from samcontact.results import open_results

E, LOAD, RADIUS, MU, SHIFT, ENERGY = 210e9, 100.0, 0.01, 0.4, 2e-6, 1e-14
STEEL = sc.Material.elastic(E, 0.0)
HERTZ = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(STEEL, STEEL), load=LOAD)
CELLS = 17
STEP = 3.6 * HERTZ.a / CELLS
BODY = {"law": "elastic", "E": E, "nu": 0.0}
FRETTED = {
    "title": "scar",
    "grid": {"nx": CELLS, "ny": CELLS, "dx": STEP, "dy": STEP},
    "body1": BODY,
    "body2": BODY,
    "surface": {"shape": "paraboloid", "Rx": RADIUS},
    "contact": {"friction": {"coulomb": MU}},
    "path": [{"load": LOAD}, {"load": LOAD, "fret": {"shift_x": SHIFT}}],
    "wear": {"energy": ENERGY, "cycles": 2},
}
TEXT = f"""title = "scar"
accuracy = 0.02
quantities = ["worn_volume", "friction_work"]
[grid]
nx = {CELLS}
ny = {CELLS}
dx = {STEP!r}
dy = {STEP!r}
[body1]
law = "elastic"
E = {E}
nu = 0.0
[body2]
law = "elastic"
E = {E}
nu = 0.0
[surface]
shape = "paraboloid"
Rx = {RADIUS}
[contact]
friction = {{coulomb = {MU}}}
[[path]]
load = {LOAD}
[[path]]
load = {LOAD}
fret = {{shift_x = {SHIFT}}}
[wear]
energy = {ENERGY}
cycles = 1
"""


def test_worn_volume_of_gross_slip_is_closer_to_its_closed_form_than_the_stated_error(
    tmp_path, undrawn
):
    """Johnson (1985), eqs. 7.42 and 7.60: work of a loop that slides fully at both ends."""
    file = tmp_path / "scar.toml"
    file.write_text(TEXT)
    outcome = invoke("run", file, "--output", tmp_path / "out", "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    assert "Estimated errors" in outcome.stdout
    data = open_results(tmp_path / "out" / "wear.nc")
    compliance = 2 * 2 / (E / 2)
    stuck = 3 * MU * LOAD / (16 * HERTZ.a) * compliance
    work = 9 * (MU * LOAD) ** 2 / (10 * HERTZ.a) * compliance / 6
    work += 4 * MU * LOAD * (SHIFT - stuck)
    for name, exact in (("friction_work", work), ("worn_volume", ENERGY * work)):
        value, error = (data[f"{name}_{part}"].values for part in ("best", "error"))
        assert np.all(np.abs(value - exact) <= error + 2e-5 * exact)  # wear is not infinitesimal
        assert np.all(error <= 0.02 * exact)
    assert data.attrs["accuracy_reached"] == 1


def test_wear_needs_a_grid_and_a_length_of_smoothing():
    with pytest.raises(ValueError, match="wear changes the size of the contact"):
        sc.to_accuracy({k: v for k, v in FRETTED.items() if k != "grid"}, 0.1)
    yields = {"law": "perfect_plastic", "E": E, "nu": 0.3, "yield_stress": 1e9}
    pressed = {
        "grid": FRETTED["grid"] | {"dz": STEP},
        "body2": yields,
        "contact": {},
        "path": [{"load": LOAD}, {"load": 0.0}],
        "wear": {"threshold": 5e-3, "window": 3},
    }
    case = Case.model_validate(FRETTED | pressed)
    with pytest.raises(ValueError, match=r"wear\.window, a number of cells.*smoothing_length"):
        sc.to_accuracy(case, 0.1)


@pytest.mark.slow
def test_errors_of_wear_in_partial_slip_cover_the_true_ones():
    """Against two finer grids, with wear that changes the pressure."""
    path = [{"load": LOAD}, {"load": LOAD, "fret": {"shift_x": 8e-7}}]
    wear = {"energy": ENERGY, "cycles": 3, "repeats": 20000}
    case = FRETTED | {"path": path, "wear": wear, "accuracy": 0.02}
    refinable = RefinableCase(Case.model_validate(case))
    refinable.accept(0.02)
    runs = [refinable.run(level, 2) for level in range(6)]
    values = [run.values for run in runs]
    truth = estimate.extrapolate_grids(values, np.full(values[0].shape[1], 1.99)).values
    found = estimate.extrapolate_grids(values[:4], refinable.orders)
    errors = found.errors + runs[3].margins
    assert np.all(np.abs(found.values - truth).max(axis=0) <= errors.max(axis=0))

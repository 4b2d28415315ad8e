# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of films that sliding thins and heats: constants, results, figures and checks."""

import numpy as np
import pytest

import samcontact as sc
from case_kinds import BALL, KINDS
from command import invoke
from samcontact import report, results
from samcontact.cases import CaseError, FilmCase, load_case

CASE = """
title = "Roller on a disc"
[lubricant]
grade = 68
temperature = 333.15
eyring_stress = 5e6
thermal = {conductivity = 0.14, capacity = 1.7e6}
[film]
load = 60.0
entrainment = 3.0
slide_to_roll = 0.5
shear_thinning = true
thermal = true
[grid]
nx = 96
ny = 1
dx = 6e-6
dy = 1e-3
periodic = "y"
[body1]
law = "elastic"
E = 210e9
nu = 0.3
thermal = {conductivity = 46.0, expansion = 12e-6, diffusivity = 12.5e-6}
[body2]
law = "elastic"
E = 210e9
nu = 0.3
thermal = {conductivity = 46.0, expansion = 12e-6, diffusivity = 12.5e-6}
[surface]
shape = "cylinder"
R = 0.01
"""
HEATED = KINDS["heated film"]


def test_a_run_has_the_heat_of_the_film(tmp_path, undrawn):
    """Film, temperatures and friction are those of `steady`, and the heat is that dissipated."""
    (tmp_path / "case.toml").write_text(CASE)
    outcome = invoke("run", tmp_path / "case.toml", "--output", tmp_path / "out")
    assert outcome.exit_code == 0, outcome.output
    assert (tmp_path / "out" / "film_temperature.png").exists()
    case = load_case(tmp_path / "case.toml")
    oil, grid = sc.lubricants.iso_vg(68), case.cells
    body = sc.Material.elastic(210e9, 0.3).with_thermal(46.0, 12e-6, 12.5e-6)
    alone = sc.lubrication.steady(
        grid, body, body, case.gap(), load=60.0, speed=(3.75, 2.25), shear_thinning=True,
        thermal=True, lubricant=oil.lubricant(333.15).with_eyring(5e6).with_thermal(
            0.14, 1.7e6, oil.beta(333.15), 333.15
        ),
    )  # fmt: skip
    with results.open_results(tmp_path / "out" / "film.nc") as data:
        (film,) = results.films_of(data)
        np.testing.assert_allclose(film.film, alone.film, rtol=1e-6)
        np.testing.assert_allclose(film.heat.middle_rise, alone.heat.middle_rise, atol=1e-4)
        assert film.heat.max_rise > 5.0
        assert film.shear_thinning
        assert film.heat.constants == alone.heat.constants
        coefficient = sc.lubrication.friction(film).coefficient
        assert coefficient == pytest.approx(float(data["friction_coefficient"][0]), rel=1e-12)
        assert float(data["max_film_rise"][0]) == film.heat.max_rise
        checks = report.checks(data)
        assert all(check.passed for check in checks)
        data.load()
        data["heat"] = 0.5 * data["heat"]
        failed = [check.name.split(":")[0] for check in report.checks(data) if not check.passed]
        assert failed == ["heat balance"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"body2": BALL}, r"film: .* body2 must have thermal constants"),
        ({"lubricant": {"grade": 68, "temperature": 313.15, "eyring_stress": 5e6}},
         r"film\.thermal requires lubricant\.thermal"),
        ({"film": {"load": 20.0, "entrainment": 1.0, "shear_thinning": True}},
         r"body1\.thermal has no effect"),
        ({"film": {"load": 20.0, "entrainment": 1.0}, "body1": BALL, "body2": BALL},
         r"lubricant\.thermal has no effect"),
        ({"lubricant": HEATED["lubricant"] | {"eyring_stress": None}},
         r"lubricant must have a law of shear thinning"),
        ({"lubricant": {"grade": 68, "temperature": 313.15, "eyring_stress": 5e6, "thermal": {
            "conductivity": 0.14, "capacity": 1.7e6, "temperature": 300.0}}},
         r"thermal\.temperature cannot be combined"),
        ({"lubricant": HEATED["lubricant"] | {
            "thermal": {"conductivity": 0.14, "capacity": 1.7e6}}}, r"thermal\.beta is required"),
    ],
)  # fmt: skip
def test_constants_and_heat_go_together(change, message):
    FilmCase.model_validate(HEATED)
    with pytest.raises(CaseError, match=message):
        FilmCase.model_validate(HEATED | change)

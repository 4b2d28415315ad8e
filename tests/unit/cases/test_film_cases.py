# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of lubricated contacts: fields, grids, runs, results and reports."""

import warnings

import numpy as np
import pytest

import samcontact as sc
from case_kinds import BALL, FILM, OIL
from command import invoke
from samcontact import report, results
from samcontact.cases import CaseError, FilmCase, load_case
from samcontact.lubricants.stored import restored, stored
from samcontact.lubrication.balance import outflow
from samcontact.lubrication.mixed import MixedFilm

CASE = """
title = "Ball on a disc"
[lubricant]
kind = "roelands"
viscosity = 0.04
pressure_viscosity = 22e-9
eyring_stress = 5e6
[film]
load = 20.0
entrainment = 1.0
slide_to_roll = 0.05
roughness1 = 50e-9
[grid]
cells_per_radius = 13
[body1]
law = "elastic"
E = 207e9
nu = 0.3
[body2]
law = "elastic"
E = 207e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 0.01
"""
GEAR = {"shape": "gear", "module": 4e-3, "teeth": [20, 40], "face_width": 0.03, "torque": 200.0}
BASE = {"title": "t", "lubricant": OIL, "body1": BALL, "body2": BALL}
FLAT = {"shape": "paraboloid", "Rx": 0.01}


def run(folder, text):
    file = folder / "case.toml"
    file.write_text(text)
    outcome = invoke("run", file, "--output", folder / "out")
    assert outcome.exit_code == 0, outcome.output
    return outcome


def test_run_and_report(tmp_path):
    """The run has the film of `steady` on its grid, and the report its values and checks."""
    run(tmp_path, CASE)
    case = load_case(tmp_path / "case.toml")
    assert invoke("report", tmp_path / "out").exit_code == 0
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "9 of 9 checks passed" in page
    assert "Hamrock &amp; Dowson" in page
    with results.open_results(tmp_path / "out" / "film.nc") as data:
        data.load()
        assert all(check.passed for check in report.checks(data))
        (film,) = results.films_of(data)
        steel = sc.Material.elastic(207e9, 0.3)
        contact = case.hertz(20.0)
        x = film.grid.x - 20 * film.grid.dx  # M 61: inlet of 4.5 radii, outlet of 1.5
        gap = 0.5 * (x[:, None] ** 2 + film.grid.y[None, :] ** 2) / 0.01
        assert film.grid.dx == pytest.approx(contact.a_x / 13)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            alone = sc.lubrication.steady(
                film.grid, steel, steel, gap, load=20.0, speed=(1.025, 0.975),
                lubricant=film.lubricant,
            )  # fmt: skip
        np.testing.assert_allclose(film.film, alone.film, rtol=1e-6)
        expected = sc.lubrication.friction(alone).coefficient
        assert float(data["friction_coefficient"][0]) == pytest.approx(expected, rel=1e-5)
        assert float(data["lambda_ratio"][0]) == pytest.approx(alone.minimum_film / 50e-9, rel=1e-5)
        through = 1.0 * film.central_film * film.grid.dy
        assert np.abs(outflow(film)).max() < 1e-6 * through
        # a changed field fails its check
        data["film"] = -data["film"]
        data["pressure"] = 1.1 * data["pressure"]
        failed = [check.name for check in report.checks(data) if not check.passed]
        assert [name.split(":")[0] for name in failed] == ["load balance", "minimum film"]


def test_curve_over_the_speed(tmp_path, undrawn):
    """One command: share and friction at each speed, with a figure; the share falls."""
    text = CASE.replace("entrainment = 1.0", "speeds = [1e-4, 1e-2]")
    text = text.replace("cells_per_radius = 13", "nx = 32\nny = 32\ndx = 14e-6\ndy = 12e-6")
    run(tmp_path, text.replace("[grid]", "boundary = {thickness = 2e-9}\norder = 1\n[grid]"))
    assert (tmp_path / "out" / "stribeck.png").exists()
    with results.open_results(tmp_path / "out" / "film.nc") as data:
        share = data["boundary_share"].values
        assert share[0] > 0.5 > 0.1 > share[1]
        films = results.films_of(data)
        assert films[0].boundary == sc.lubrication.Boundary(2e-9)
        np.testing.assert_allclose([film.boundary_share for film in films], share, rtol=1e-12)
        np.testing.assert_allclose(data["speed"], [1e-4, 1e-2])
        # the small share is uncertain on these cells
        uncertainty = data["share_uncertainty"].values
        assert np.isnan(uncertainty[0])
        assert films[1].share_error == uncertainty[1] > 0.1 * share[1]
        failed = [check.name for check in report.checks(data) if not check.passed]
        assert any(name.startswith("load share of the boundary layer") for name in failed)


def test_films_before_an_error_are_written(tmp_path, monkeypatch):
    """The curve of a run that fails at its third speed has the first two."""
    text = CASE.replace("entrainment = 1.0", "speeds = [1e-4, 1e-3, 1e-2]")
    text = text.replace("cells_per_radius = 13", "nx = 32\nny = 32\ndx = 14e-6\ndy = 12e-6")
    file = tmp_path / "case.toml"
    file.write_text(text.replace("[grid]", "boundary = {thickness = 2e-9}\norder = 1\n[grid]"))
    solve = MixedFilm.at

    def fails(mixed, factor):
        return solve(mixed, factor) | {"converged": factor < 5e-3}

    monkeypatch.setattr(MixedFilm, "at", fails)
    outcome = invoke("run", file, "--output", tmp_path / "out", "--no-figures")
    assert outcome.exit_code != 0
    assert "2 of 3 speeds" in " ".join(outcome.stderr.split())
    with results.open_results(tmp_path / "out" / "film.nc") as data:
        np.testing.assert_allclose(data["speed"], [1e-4, 1e-3])
        (failed,) = [check.name for check in report.checks(data) if not check.passed][:1]
        assert failed == "increments: complete path (1) or part of it (0)"


def test_impossible_friction_is_stated_not_stored(tmp_path):
    outcome = run(tmp_path, CASE.replace("eyring_stress = 5e6", ""))
    assert "shear thinning or a limiting shear stress" in " ".join(outcome.output.split())
    with results.open_results(tmp_path / "out" / "film.nc") as data:
        assert np.isnan(data["friction_coefficient"]).all()


def test_speeds_of_parts():
    """A bearing by its speed, and a flank by that of the pinion, as in `samcontact.lubrication`."""
    bearing = {"designation": "6208", "radial_load": 4000.0}
    case = FilmCase.model_validate(BASE | {"bearing": bearing, "film": {"inner_speed": "3000 rpm"}})
    speed = sc.lubrication.bearing_speeds(sc.bearings.standard("6208"), 3000 * np.pi / 30)
    assert np.transpose(case.velocities)[0] == pytest.approx(speed)
    E_star = sc.hertz.effective_modulus(*[sc.Material.elastic(210e9, 0.3)] * 2)
    of_bearing = sc.bearings.standard("6208").hertz("inner", case.load_on(None), E_star)
    found = case.estimate(case.load_on(None), case.velocities)
    oil = case.build_lubricant()
    assert found.minimum == pytest.approx(
        sc.lubrication.estimate(of_bearing, speed, oil).minimum, rel=1e-6
    )
    pair = sc.parts.GearPair(module=4e-3, teeth=(20, 40), face_width=0.03)
    for position in ("B", "D"):
        case = FilmCase.model_validate(
            BASE | {"surface": GEAR | {"position": position}, "film": {"pinion_speed": 150.0}}
        )
        flank = pair.at(position)
        assert np.transpose(case.velocities)[0] == pytest.approx(flank.speeds(150.0))
        contact = flank.hertz(200.0, E_star)
        found = case.estimate(case.load_on(case.cells), case.velocities)
        formula = sc.lubrication.estimate(contact, flank.speeds(150.0), oil)
        assert found.minimum == pytest.approx(formula.minimum, rel=1e-9)
        assert case.cells.periodic == "y"
        assert case.gap().min() == pytest.approx(0.0, abs=1e-10)


def test_contact_lies_behind_the_centre_in_the_direction_of_flow():
    for angle, sign in ((0.0, (1, 0)), (np.pi, (-1, 0)), (np.pi / 2, (0, 1))):
        case = FilmCase.model_validate(
            BASE | {"surface": FLAT, "film": {"load": 20.0, "entrainment": 1.0, "angle": angle}}
        )
        at = np.unravel_index(np.argmin(case.gap()), case.cells.surface_shape)
        place = case.cells.x[at[0]], case.cells.y[at[1]]
        assert [round(v / np.abs(place).max()) for v in place] == list(sign)
    given = FilmCase.model_validate(FILM)
    at = np.unravel_index(np.argmin(given.gap()), (24, 24))
    np.testing.assert_allclose(
        (given.cells.x[at[0]], given.cells.y[at[1]]), (4e-5, 2e-5), atol=1.01e-5
    )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"film": {"load": 1.0}}, "exactly one of speed1 and speed2, entrainment, speeds"),
        ({"film": {"load": 1.0, "speed1": 1.0}}, "speed1 and speed2 must be given together"),
        ({"film": {"load": 1.0, "speed1": 1.0, "speed2": -1.0}}, "mean surface velocity must not"),
        ({"film": {"entrainment": 1.0}}, r"film\.load is required"),
        ({"film": {"load": 1.0, "pinion_speed": 9.0}}, "pinion_speed has a meaning only if"),
        ({"film": {"load": 1.0, "speeds": [1.0]}}, "speeds requires boundary"),
        ({"film": {"load": 1.0, "speeds": [2.0, 1.0], "boundary": {"thickness": 1e-9}}},
         "speeds must increase"),
        ({"film": {"load": 1.0, "speed1": 1.0, "speed2": 1.0, "angle": 1.0}}, "angle has effect"),
        ({"surface": {"shape": "cylinder", "R": 0.01}}, r"\[grid\] with nx, ny, dx and dy is"),
        ({"surface": GEAR}, r"film\.load cannot be combined with the load of the part"),
        ({"grid": {"nx": 32}}, "nx, ny, dx, dy must be given together"),
        ({"body2": BALL | {"thermal": {"conductivity": 46.0, "expansion": 1e-5,
                                       "diffusivity": 1e-5}}}, r"body2\.thermal has no effect"),
        ({"lubricant": {"grade": "ISO VG 67", "temperature": 343.0}}, "grade must be one of ISO"),
        ({"lubricant": {"grade": 68, "temperature": 70.0}}, "temperature must be from 253"),
        ({"lubricant": OIL | {"carreau_stress": 1e6}}, "must be given together"),
    ],
)  # fmt: skip
def test_errors_name_the_field(change, message):
    film = {"load": 20.0, "entrainment": 1.0}
    with pytest.raises(CaseError, match=message):
        FilmCase.model_validate(BASE | {"surface": FLAT, "film": film} | change)


def test_lubricants_as_text():
    for oil in (
        sc.Lubricant.roelands(0.04, 22e-9, 0.6).with_carreau(1e7, 0.4),
        sc.Lubricant.barus(0.04, 22e-9, density=None).with_limiting_shear(0.05),
        sc.Lubricant.doolittle(0.04, 4.0, 0.7, 1.4e9, 11.0).with_thermal(0.14, 1.7e6, 0.04),
        sc.Lubricant.tabulated([0, 5e8, 1e9], [0.04, 10, 1e3], [870, 970, 1000]).with_eyring(5e6),
    ):
        assert restored(stored(oil)) == oil
    for text in ("", "{}", '{"kind": "Barus", "alpha": 1e-8}', '{"kind": "os"}'):
        with pytest.raises(ValueError, match="text must describe a lubricant"):
            restored(text)


def test_sweep_of_the_temperature(tmp_path):
    """The film of a case falls with the temperature of the oil."""
    case = FilmCase.model_validate(
        BASE | {"surface": FLAT, "film": {"load": 20.0, "entrainment": 1.0},
                "grid": {"cells_per_radius": 12},
                "lubricant": {"grade": 68, "temperature": 313.15}}
    )  # fmt: skip
    found = sc.sweep(case, {"lubricant.temperature": [313.15, 343.15]}, progress=False)
    film = found["central_film"].values[:, 0]
    hot, cold = (sc.lubricants.iso_vg(68).lubricant(T) for T in (343.15, 313.15))
    ratio = (hot.eta0 / cold.eta0) ** 0.67 * (
        hot.pressure_viscosity / cold.pressure_viscosity
    ) ** 0.53  # Hamrock & Dowson
    assert film[1] / film[0] == pytest.approx(ratio, rel=0.05)

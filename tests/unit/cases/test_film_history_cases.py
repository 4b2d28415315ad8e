# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of films in time and on elastic-plastic bodies: runs, checks, resumption, errors."""

import warnings

import numpy as np
import pytest
from PIL import Image

import samcontact as sc
from case_kinds import BALL, DENT, KINDS
from command import invoke
from samcontact import report, results
from samcontact.cases import CaseError, FilmCase, film_studies, parse_case
from samcontact.commands import solve_study

CASE = """
title = "a dent in oil"
[lubricant]
kind = "roelands"
viscosity = 0.04
pressure_viscosity = 20e-9
eyring_stress = 5e6
[film]
load = 30.0
entrainment = 1.0
order = 1
[film.transient]
duration = 2.16e-4
times = [0.0, 1.08e-4, 2.16e-4]
load_factors = [1.0, 1.4, 1.4]
speed_factors = [1.0, 1.0, 0.4]
[grid]
nx = 32
ny = 22
dx = 18e-6
dy = 18e-6
contact_x = 90e-6
[body1]
law = "elastic"
E = 207e9
nu = 0.3
[body2]
law = "elastic"
E = 207e9
nu = 0.3
[surface]
shape = "sphere"
R = 0.01
[relief2]
kind = "dent"
depth = 0.2e-6
radius = 90e-6
x = -180e-6
"""
YIELDS = CASE[: CASE.index("[film.transient]")] + CASE[CASE.index("[grid]") :]
YIELDS = YIELDS[: YIELDS.index("[relief2]")].replace("load = 30.0", "load = 900.0\nincrements = 2")
YIELDS = YIELDS.replace("entrainment = 1.0", "entrainment = 4.0").replace("18e-6", "54e-6")
YIELDS = YIELDS.replace("viscosity = 0.04", "viscosity = 0.1").replace("90e-6", "270e-6")
YIELDS = YIELDS.replace(
    'law = "elastic"\nE = 207e9\nnu = 0.3\n[surface]',
    'law = "linear_hardening"\nE = 207e9\nnu = 0.3\nyield_stress = 0.9e9\ntangent_modulus = 5e9\n'
    "[surface]",
)


def run(folder, text):
    (folder / "case.toml").write_text(text)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        outcome = invoke("run", folder / "case.toml", "--output", folder / "out")
    return outcome


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_a_dent_passes_as_in_python(tmp_path):
    """The films are those of `transient` with the same functions, and oil is conserved."""
    case = parse_case(CASE)
    found = case.solve()
    grid, steel = case.cells, sc.Material.elastic(207e9, 0.3)
    oil = case.build_lubricant()
    x, y = grid.x[:, None] - 90e-6, grid.y[None, :]
    gap = 0.01 - np.sqrt(0.01**2 - x**2 - y**2)

    def dent(x, y):
        r = np.minimum(np.hypot(x - 90e-6 + 180e-6, y), 90e-6)
        radius = 0.5 * (90e-6**2 + 0.2e-6**2) / 0.2e-6
        return np.sqrt(radius**2 - 90e-6**2) - np.sqrt(radius**2 - r**2)

    there = dent(*np.meshgrid(grid.x, grid.y, indexing="ij"))
    start = sc.lubrication.steady(
        grid, steel, steel, gap - there, load=30.0, speed=(1.0, 1.0), lubricant=oil, order=1
    )
    np.testing.assert_allclose(found[0].film, start.film, rtol=1e-5)
    assert len(found) == 1 + 12  # a cell in each step
    last, travel = found[-1], 1.7 * 1.08e-4
    assert last.time == pytest.approx(2.16e-4)
    np.testing.assert_allclose(last.velocities, [[0.4, 0.0]] * 2)
    assert last.load == pytest.approx(1.4 * 30.0, rel=1e-5)
    np.testing.assert_allclose(last.past.ways[:, 0], travel, rtol=1e-9)
    moved = found[6].past.ways[1, 0]  # whole cells until the speed falls
    here = dent(*np.meshgrid(grid.x - moved, grid.y, indexing="ij"))
    np.testing.assert_allclose(found[6].gap, gap - here, atol=1e-13)
    data = results.films_dataset(found, case)
    assert data["flow_imbalance"].max() < 1e-5
    again = results.films_of(data)
    np.testing.assert_array_equal(again[5].past.content, found[5].past.content)
    assert again[-1].central_film == found[-1].central_film
    failed = {check.name.split(":")[0] for check in report.checks(data) if not check.passed}
    assert failed <= {
        "cells per contact radius",
        "change of the central film between the last two grids, relative to the film",
    }
    stored = [film.content.sum() for film in found]
    assert np.ptp(stored) > 1e-2 * stored[0]  # the balance is one of changing amounts


def test_a_run_that_stops_resumes_bit_identically(tmp_path, monkeypatch, undrawn_files):
    """The films so far are results, and the resumed run has the digits of an undisturbed one."""
    monkeypatch.setattr(solve_study, "MAX_FRAMES", 2)
    (tmp_path / "case.toml").write_text(CASE)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        outcome = invoke("run", tmp_path / "case.toml", "--output", tmp_path / "out", "--animate")
    assert outcome.exit_code == 0, outcome.output
    with Image.open(tmp_path / "out" / "film.gif") as image:
        assert image.n_frames == 2
    for name in ("film_over_time.png", "film_map.png"):
        assert (tmp_path / "out" / name).exists()
    with results.open_results(tmp_path / "out" / "film.nc") as data:
        whole = data["film"].values
    step = film_studies.transient
    other = tmp_path / "other"
    other.mkdir()

    def stops(start, *, load, **more):
        def failing(time):
            if time > 1.1e-4 and more["checkpoint"] is not None and stops.armed:
                raise sc.ConvergenceError("stopped by the test")
            return load(time)

        return step(start, load=failing, **more)

    stops.armed = False
    monkeypatch.setattr(film_studies, "transient", stops)
    described = sc.lubrication.transient.__globals__["_Course"].described

    def disarmed(course, *given):
        stops.armed = False
        found = described(course, *given)
        stops.armed = stops.planned
        return found

    monkeypatch.setattr(sc.lubrication.transient.__globals__["_Course"], "described", disarmed)
    stops.planned = True
    stopped = run(other, CASE)
    assert stopped.exit_code != 0
    assert "of 12 steps" in " ".join(stopped.stderr.split())
    with results.open_results(other / "out" / "film.nc") as data:
        assert 2 < data.sizes["increment"] < 13
    stops.planned = False
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        resumed = invoke("resume", other / "out")
    assert resumed.exit_code == 0, resumed.output
    with results.open_results(other / "out" / "film.nc") as data:
        np.testing.assert_array_equal(data["film"].values, whole)


def test_only_films_in_time_are_animated(tmp_path):
    (tmp_path / "case.toml").write_text(YIELDS)
    outcome = invoke("run", tmp_path / "case.toml", "--output", tmp_path / "out", "--animate")
    assert outcome.exit_code != 0
    assert "--animate cannot be combined with [film], except with film.transient" in outcome.stderr


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")
def test_a_race_that_yields_as_in_python(tmp_path, undrawn):
    """Films and strains are those of two increments by `press`; gap and imprint agree."""
    outcome = run(tmp_path, YIELDS)
    assert outcome.exit_code == 0, outcome.output
    case = parse_case(YIELDS)
    body1, body2 = case.bodies
    simulation = sc.Simulation(case.cells, body1, body2, case.gap(), on_border="warn")
    given = {"speed": (4.0, 4.0), "lubricant": case.build_lubricant(), "order": 1}
    pressed = [sc.lubrication.press(simulation, load=W, **given) for W in (450.0, 900.0)]
    for name in ("film_stress.png", "film_imprint.png"):
        assert (tmp_path / "out" / name).exists()
    assert invoke("report", tmp_path / "out").exit_code == 0
    with results.open_results(tmp_path / "out" / "film.nc") as data:
        for film, one in zip(results.films_of(data), pressed, strict=True):
            np.testing.assert_array_equal(film.film, one.film.film)
        state = pressed[-1].state
        strain = data["equivalent_plastic_strain"].sel(body=2).values
        np.testing.assert_array_equal(strain, state.equivalent_plastic_strain(2))
        assert strain.max() > 1e-4
        moved = data["residual_displacement"].sel(body=2).values[-1]
        np.testing.assert_array_equal(moved, state.residual_displacement(2))
        assert float(data["gap_mismatch"].max()) < 0.02
        np.testing.assert_allclose(data["load"], [450.0, 900.0], rtol=1e-5)


IN_TIME = KINDS["transient film"]
PRESSED = KINDS["pressed film"]


@pytest.mark.parametrize(
    ("kind", "change", "message"),
    [
        (IN_TIME, {"film": {"load": 20.0, "entrainment": 1.0}}, "relief1 moves with body 1"),
        (IN_TIME, {"film": {"load": 20.0, "speed1": 1.0, "speed2": [1.0, 0.1],
                            "transient": {"duration": 1e-4}}}, "velocity of body 2 along y"),
        (IN_TIME, {"film": IN_TIME["film"] | {"transient": {
            "duration": 1e-4, "times": [0.0, 1.0]}}},
         "`times` requires load_factors or speed_factors"),
        (IN_TIME, {"film": IN_TIME["film"] | {"transient": {
            "duration": 1e-4, "times": [0.0, 1.0], "load_factors": [1.0, 2.0, 3.0]}}},
         "load_factors must have as many values as times"),
        (IN_TIME, {"film": IN_TIME["film"] | {"thermal": True},
                   "lubricant": KINDS["heated film"]["lubricant"]},
         r"film\.thermal cannot be combined with film\.transient: the surface temp"),
        (IN_TIME, {"relief1": None, "relief2": None, "film": {
            "load": 20.0, "entrainment": 1.0, "transient": {"duration": 1e-4}}},
         r"film\.transient has no effect without relief1"),
        (IN_TIME, {"film": IN_TIME["film"] | {"increments": 2}}, r"film\.increments has no effect"),
        (IN_TIME, {"grid": {"cells_per_radius": 8, "dz": 1e-5}}, r"grid\.dz has no effect"),
        (PRESSED, {"film": {"load": 20.0, "entrainment": 1.0, "spin": 1.0}},
         r"film\.spin cannot be combined with an elastic-plastic body"),
        (PRESSED, {"film": {"load": 20.0, "entrainment": 1.0, "transient": {"duration": 1.0}}},
         r"film\.transient cannot be combined with an elastic-plastic body"),
        (PRESSED, {"body1": BALL | {"hardness": {"surface": 700.0, "core": 400.0, "depth": 1e-3}}},
         r"body1\.hardness has no effect"),
        (PRESSED, {"relief1": DENT}, "relief1 moves with body 1"),
    ],
)  # fmt: skip
def test_errors_name_the_field(kind, change, message):
    with pytest.raises(CaseError, match=message):
        FilmCase.model_validate(kind | change)

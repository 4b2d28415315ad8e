# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparison with other codes: computed values, page, and small runs of the adapters."""

import importlib
import json

import numpy as np
import pytest
from click.testing import CliRunner

from benchmarks.peers import code_samcontact, figures, page, problems, running, schedule
from benchmarks.peers.__main__ import main
from benchmarks.tables import between_markers


@pytest.fixture(scope="module")
def stored():
    return json.loads(schedule.STORED.read_text(encoding="utf-8"))


def test_the_page_follows_from_the_measurements(stored):
    text = page.PAGE.read_text(encoding="utf-8")
    assert between_markers(text, page.tables_of(stored)) == text


class TestWhatItSays:
    """Claims of the page in words."""

    @pytest.fixture(scope="class")
    @classmethod
    def ladders(cls, stored):
        """Return measurements by cells across, for a problem, a code and a case."""
        found = {}
        for (problem, case, n), codes in page.by_place(stored).items():
            for code, rungs in codes.items():
                found.setdefault((problem, code, case), {})[n] = rungs
        return found

    def test_first_solves_are_closest_on_the_smallest_grid(self, stored, ladders):
        ours, places = ladders["hertz", "samcontact", ""], page.by_place(stored)
        ends = [places["hertz", "", n] for n in (min(ours), max(ours))]
        for target in page.TARGETS["hertz"]:
            small, large = (page.ratio_at(codes, "ASPHER", "pressure", "with_setup_s", target)
                            for codes in ends)  # fmt: skip
            assert small < large > 1
        for rounds in ours[min(ours)].values():
            best = min(rounds, key=lambda row: row["with_setup_s"])
            assert best["without_setup_s"] < 0.5 * best["with_setup_s"]

    def test_smooth_contact_needs_few_products_and_those_of_others_grow(self, ladders):
        def counts(problem, code, case, what):
            rows = {n: page.row_at(rungs, "pressure", 1e-6)
                    for n, rungs in ladders[problem, code, case].items()}  # fmt: skip
            return {n: row["counts"][what] for n, row in rows.items() if row}

        def growth(problem, code, case=""):
            """Return the exponent of the iterations in the number of cells across."""
            needed = counts(problem, code, case, "iterations")
            small, large = min(needed), max(needed)
            return np.log(needed[large] / needed[small]) / np.log(large / small)

        for code in ("samcontact", "ASPHER", "tamaas"):
            for applied in counts("hertz", code, "", "applications").values():
                assert (applied <= 5) == (code == "samcontact")
        assert min(growth("hertz", "tamaas"), growth("hertz", "ContactMechanics")) > 0.2
        for case in ("light", "half"):
            ours, theirs = (growth("periodic", code, case) for code in ("samcontact", "tamaas"))
            assert 0.25 > ours < theirs / 2

    def test_small_errors_of_slip_and_of_h2_are_not_reached(self, ladders):
        for (problem, code, case), ladder in ladders.items():
            for n, rungs in ladder.items():
                if (problem, code) == ("slip", "ASPHER"):
                    assert page.row_at(rungs, "shear", 1e-3) is None
                    assert min(rows[0]["counts"]["iterations"] for rows in rungs.values()) > 300
                    assert n < max(ladders["slip", "samcontact", case])
                if code == "ASPHER, H2":
                    assert page.row_at(rungs, "pressure", 1e-6) is None

    def test_grids_of_periodic_surfaces(self, stored):
        for case in problems.PERIODIC_CASES:
            ours, theirs = (page.grids_of("periodic", case, stored)[code]
                            for code in ("samcontact", "tamaas"))  # fmt: skip
            for n in ours.keys() & theirs.keys():
                assert theirs[n][0] < ours[n][0]
        ours, theirs = page.grid_lines("plastic", stored)[:2]
        pressure, strain = (f"maximum {q} / finest - 1" for q in ("pressure", "plastic strain"))
        assert abs(theirs[pressure]) < abs(ours[pressure])
        assert abs(theirs[strain]) > abs(ours[strain])


def test_a_small_grid_has_the_stored_errors(stored):
    elastic, task = problems.hertz(64), running.Task("hertz", "", 64, "samcontact", 1e-8)
    found = code_samcontact.Contact(elastic, 1e-8).solve()
    known = stored["rows"]["hertz||64|samcontact|1e-08"][0]
    errors = running.elastic_errors(task, elastic, found)
    shared = errors.keys() & known["errors"].keys()
    assert "largest pressure, exact" in shared
    for name in shared:
        assert errors[name] == pytest.approx(known["errors"][name], rel=0.01), name
    assert found.counts["iterations"] == pytest.approx(known["counts"]["iterations"], rel=0.2)


def test_figures(stored):
    drawn = figures.figure(stored, "hertz")
    assert all(axes.get_xscale() == axes.get_yscale() == "log" for axes in drawn.axes)
    assert figures.figure({"rows": {}}, "hertz") is None


def test_time_at_an_error():
    curve = [(1e-2, 1.0), (1e-4, 100.0), (1e-6, 400.0)]
    assert page.time_at(curve, 1e-3) == pytest.approx(10.0)
    assert page.time_at(curve, 1e-4) == pytest.approx(100.0)
    assert page.time_at(curve, 0.1) == 1.0  # the loosest is good enough
    assert page.time_at(curve, 1e-7) is None


def made_up(times, error=1e-7):
    """Return made-up rounds of one tolerance."""
    return [
        {
            "with_setup_s": time,
            "without_setup_s": time / 2,
            "memory_MB": 1.0,
            "contact_fraction": 0.1,
            "counts": {"iterations": 3},
            "errors": {"pressure": error},
        }
        for time in times
    ]


def test_ratios_use_minimum_times_and_faster_codes_are_listed():
    rows = {
        "hertz||64|samcontact|1e-06": made_up([2.0, 4.0, 2.5]),
        "hertz||64|ASPHER|1e-06": made_up([0.5, 0.5, 0.5]),
        "hertz||64|tamaas|1e-06": made_up([3.0]),
        "hertz||128|tamaas|1e-06": [{"failed": "no memory"}],
    }
    data = {"versions": {"samcontact": "1"}, "rows": rows}
    codes = page.by_place(data)["hertz", "", 64]
    assert page.ratio_at(codes, "ASPHER", "pressure", "with_setup_s", 1e-6) == 0.25
    assert page.ratio_at(codes, "tamaas", "pressure", "with_setup_s", 1e-6) == 1.5
    assert page.ratio_at(codes, "tamaas", "pressure", "with_setup_s", 1e-8) is None
    text = page.tables_of(data)
    assert "Minimum ratio of the time" not in text  # nothing of 256 cells across
    large = {key.replace("64", "256"): rounds for key, rounds in rows.items() if "64" in key}
    assert page.smallest_ratios(data | {"rows": large}) == (
        "elastic contact 0.25 at an error of 1e-06 on grids of 256² cells or more"
    )
    assert "Hertz contact, ASPHER, with set-up: 64² (0.25)" in text
    assert "tamaas, with set-up" not in text
    assert "tamaas: no memory: Hertz contact, 128², tolerance 1e-06" in text


def test_equal_error_of_grids_is_between_the_grids():
    def grid(time, error):
        loose = made_up([time], error=error / 100)
        for row in loose:
            row["errors"] |= {page.FINE_PRESSURE: error, page.FINE_AREA: error}
        return loose

    rows = {}
    for n, time, error in ((256, 1.0, 1e-2), (512, 4.0, 2.5e-3)):
        for tol in (1e-4, 1e-12):  # the second is the reference
            rows[f"periodic|half|{n}|samcontact|{tol:g}"] = grid(time, error)
    for tol in (1e-4, 1e-12):
        rows[f"periodic|half|256|tamaas|{tol:g}"] = grid(5.0, 5e-3)
    first, second, third = page.accuracy_lines("periodic", {"rows": rows})
    assert (first["code"], second["code"], third["cells"]) == ("samcontact", "tamaas", "512²")
    assert second["time, equal cells"] == pytest.approx(5.0)
    assert second["time, equal error"] == pytest.approx(2.5)


def test_points_of_the_periodic_surface_are_shared_by_all_grids():
    coarse, fine = (problems.elastic("periodic", "half", n).gap for n in (128, 384))
    np.testing.assert_allclose(fine[::3, ::3], coarse, atol=1e-9 * np.abs(coarse).max())


def test_results_are_stored_and_read_back(tmp_path):
    task = running.Task("hertz", "", 64, "samcontact", 1e-6)
    results = schedule.Results(tmp_path / "kept.json")
    results.rounds(task).append({"with_setup_s": 0.123456789, "errors": {"pressure": 0.0}})
    results.save()
    again = schedule.Results(tmp_path / "kept.json")
    assert again.rounds(task) == [{"with_setup_s": 0.12346, "errors": {"pressure": 0.0}}]
    larger = running.Task("hertz", "", 128, "samcontact", 1e-6)
    assert not schedule.too_long(larger, again, limit=1.0)
    assert schedule.too_long(larger, again, limit=0.4)


def test_a_longer_limit_repeats_failed_measurements(tmp_path):
    results = schedule.Results(tmp_path / "kept.json")
    task = running.Task("hertz", "", 64, "samcontact", 1e-6)
    results.rounds(task).append({"failed": "more than 5 s", "limit_s": 5.0})
    results.forget_shorter(5.0)
    assert len(results.rounds(task)) == 1
    results.forget_shorter(6.0)
    assert results.rounds(task) == []


def test_samcontact_has_an_adapter_for_every_problem():
    elastic = problems.hertz(32)
    found = code_samcontact.Contact(elastic, 1e-8).solve()
    assert found.pressure.sum() * elastic.cell**2 == pytest.approx(elastic.load)
    task = running.Task("hertz", "", 32, "samcontact", 1e-8)
    assert running.elastic_errors(task, elastic, found)["largest pressure, exact"] < 5e-3
    for case in problems.ROUGH_CASES:
        assert problems.elastic("rough", case, 32).gap.shape == (32, 32)
    plastic = problems.plastic(12)
    assert code_samcontact.Plasticity(plastic, 1e-3).solve().plastic_strain.max() > 1e-3
    task = running.Task("stress", "", 48, "samcontact", 0.0)
    problem, given = running.prepare(task)
    assert running.errors_of(task, problem, code_samcontact.Stress(*given).solve())["stress"] < 0.05


def test_a_measurement_in_a_process_of_its_own(tmp_path):
    task = running.Task("hertz", "", 32, "samcontact", 1e-12, str(tmp_path))
    server = running.Server("samcontact")
    try:
        row = server.run(task, 60.0)
        assert row["errors"]["pressure"] == 0.0  # it is the reference itself
        assert 0 < row["setup_s"] < row["with_setup_s"]
        assert row["memory_MB"] >= 0
        loose = running.Task("hertz", "", 32, "samcontact", 1e-2, str(tmp_path))
        assert 1e-6 < server.run(loose, 60.0)["errors"]["pressure"] < 0.1
        unknown = running.Task("rough", "none", 32, "samcontact", 1e-2, str(tmp_path))
        assert "KeyError" in server.run(unknown, 60.0)["failed"]
    finally:
        server.close()


def test_a_measurement_that_takes_too_long(monkeypatch):
    def busy(task):
        while True:
            pass

    monkeypatch.setattr(running, "run_here", busy)
    task = running.Task("hertz", "", 32, "samcontact", 1e-2)
    assert running.measured_in_a_fork(task, 1.0) == {"failed": "more than 1 s"}


@pytest.mark.parametrize("code", [code for code in running.CODES if code != "samcontact"])
def test_peers_find_the_same_pressure(code):
    pytest.importorskip(running.PACKAGES[code.split(",")[0]])
    case = problems.rough(128, "heavy")
    kind = running.code_class(code, "rough")
    found = kind(case, 1e-6).solve()
    ours = code_samcontact.Contact(case, 1e-8).solve()
    largest = ours.pressure.max()
    np.testing.assert_allclose(found.pressure, ours.pressure, atol=1e-3 * largest)


@pytest.mark.parametrize("case", problems.PULLED)
def test_partial_slip_is_that_of_cattaneo_and_mindlin(case):
    given = problems.elastic("slip", case, 64)
    found = code_samcontact.Slip(given, 1e-8).solve()
    pulled = found.shear.sum(axis=(1, 2)) * given.cell**2
    half = problems.PULL * problems.FRICTION * given.load
    assert pulled == pytest.approx([half, 0.0], rel=2e-3, abs=1e-6 * half)


def test_aspher_finds_the_same_shear():
    pytest.importorskip("aspher")
    peer = importlib.import_module("benchmarks.peers.code_aspher")
    given = problems.elastic("slip", "force given", 32)
    ours, theirs = code_samcontact.Slip(given, 1e-8).solve(), peer.Slip(given, 1e-2).solve()
    assert running.rms_error(theirs.shear, ours.shear) < 0.1


def test_tamaas_finds_the_same_plastic_contact_and_stress():
    pytest.importorskip("tamaas")
    peer = importlib.import_module("benchmarks.peers.code_tamaas")
    # four cells across a contact radius: both have their discretisation errors
    plastic = problems.plastic(24)
    ours = code_samcontact.Plasticity(plastic, 1e-4).solve()
    theirs = peer.Plasticity(plastic, 1e-3).solve()
    assert theirs.pressure.max() == pytest.approx(ours.pressure.max(), rel=0.05)
    assert theirs.plastic_strain.max() == pytest.approx(ours.plastic_strain.max(), rel=0.15)
    task = running.Task("stress", "", 48, "tamaas", 0.0)
    problem, given = running.prepare(task)
    assert running.errors_of(task, problem, peer.Stress(*given).solve())["stress"] < 0.05


def test_tamaas_finds_the_same_periodic_contacts():
    pytest.importorskip("tamaas")
    peer = importlib.import_module("benchmarks.peers.code_tamaas")
    rough = problems.elastic("periodic", "half", 256)
    ours, theirs = (code.Contact(rough, 1e-8).solve() for code in (code_samcontact, peer))
    # two discretisations of eight cells across the shortest wave
    assert running.rms_error(theirs.pressure, ours.pressure) < 0.01
    plastic = problems.plastic(24, periodic="xy")
    ours, theirs = (code.Plasticity(plastic, 1e-3).solve() for code in (code_samcontact, peer))
    assert theirs.pressure.max() == pytest.approx(ours.pressure.max(), rel=0.02)
    assert theirs.plastic_strain.max() == pytest.approx(ours.plastic_strain.max(), rel=0.1)


def test_tamaas_has_the_same_mean_stress():
    """Fields uniform along the surface: no lateral strain, no normal stress from below."""
    tm = pytest.importorskip("tamaas")
    grid = problems.plastic(12, periodic="xy").grid
    deviator = np.array([1e-3, -0.5e-3, -0.5e-3, 0, 0, 0])
    strain = np.broadcast_to(deviator[:, None, None, None], (6, *grid.volume_shape))
    pressed = problems.sc.ContactSolver(grid, code_samcontact.RIGID, code_samcontact.ELASTIC)
    ours = (
        pressed.stress(np.full(grid.surface_shape, 1e6), np.zeros(1))[:3, 0, 0, 0],
        problems.sc.operators.residual_stress(grid, strain, problems.E, problems.NU, method="fast")[
            :3, 0, 0, 0
        ],
    )
    size, kind = [grid.nz * grid.dz, *[grid.nx * grid.dx] * 2], tm.model_type.volume_2d
    model = tm.ModelFactory.createModel(kind, size, [grid.nz + 1, grid.nx, grid.ny])
    model.E, model.nu = problems.E, problems.NU
    tm.ModelFactory.registerVolumeOperators(model)
    model.traction[..., 2] = 1e6
    field, eigen = np.zeros([*model.shape, 6]), np.zeros([*model.shape, 6])
    theirs = []
    for given, operator in ((0.0, "boussinesq_gradient"), (deviator, "mindlin_gradient")):
        field[...], eigen[...] = given, 0.0
        model.operators["hooke"](field, eigen)
        source, total = (eigen if operator == "mindlin_gradient" else model.traction), 0 * field
        model.operators[operator](source, total)
        stress = 0 * field
        model.operators["hooke"](total - given, stress)
        theirs.append(stress[0, 0, 0, :3])
    for one, other in zip(ours, theirs, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-6, atol=1e-6 * np.abs(other).max())


def test_the_command_refuses_other_problems():
    done = CliRunner().invoke(main, ["nothing"])
    assert done.exit_code == 2
    assert "'nothing' is not one of 'hertz', 'rough'" in done.output

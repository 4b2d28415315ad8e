# SPDX-License-Identifier: GPL-3.0-or-later
"""However the command ends after an increment, its results or checkpoints are kept."""

import errno
import html
import os

import pytest
import xarray as xr

import samcontact as sc
from case_texts import ASPERITIES, MINIMAL, SCAR, WEAR
from command import check_failure, fields, invoke, pressed
from samcontact import plotting, report, results
from samcontact.commands import interrupted, solve_contact
from samcontact.restart import checkpoint_files, lock
from samcontact.restart.lock import LOCK_FILE, locked
from samcontact.simulation import journal

OPTIONS = ("--no-figures", "--quiet")


@pytest.fixture(scope="module")
def case_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("case") / "case.toml"
    path.write_text(f"estimate_error = false\n{MINIMAL}")
    return path


@pytest.fixture(scope="module")
def expected(case_file, tmp_path_factory):
    """Return the results of an undisturbed run."""
    out = tmp_path_factory.mktemp("plain")
    assert invoke("run", case_file, "--output", out, *OPTIONS).exit_code == 0
    return fields(out)


def after(function, action):
    """Return a function that calls `function`, then `action`, which ends the command."""

    def called(*arguments, **named):
        value = function(*arguments, **named)
        action()
        return value

    return called


def fails(error):
    def called(*_, **__):
        raise error

    return called


# Places at which Ctrl-C is pressed after the last increment.
PLACES = {
    "after the last increment": (solve_contact, "run_into", None),
    "before the dataset": (results, "to_dataset", pressed),
    "before saving": (results, "save", pressed),
    "after saving": (results, "save", None),
    "in the table": (solve_contact, "_summary", pressed),
    "in the figures": (plotting, "summary_figures", pressed),
    "before forgetting": (interrupted.Checkpoints, "forget", pressed),
    "while forgetting": (checkpoint_files, "_files", pressed),
}


LIKE_OTHERS = {"before the dataset", "after saving", "in the table"}


@pytest.mark.parametrize(
    ("place", "journal"),
    [
        *(
            pytest.param(
                *(place, "while" in place), marks=[pytest.mark.slow] * (place in LIKE_OTHERS)
            )
            for place in PLACES
        ),
        ("before saving", True),
    ],
)
def test_ctrl_c_after_the_last_increment(case_file, expected, tmp_path, place, journal):
    owner, name, action = PLACES[place]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(owner, name, action or after(getattr(owner, name), pressed))
        command = ["run", case_file, "--output", tmp_path, "--quiet", *["--resume"] * journal]
        outcome = invoke(*command, *["--no-figures"] * ("figures" not in place))
    assert outcome.exit_code == 130, outcome.output
    left = interrupted.is_interrupted(tmp_path)
    # all results are written before checkpoints are removed, or if there are none
    if not left:
        assert place.endswith("forgetting")
        xr.testing.assert_identical(fields(tmp_path), expected)
        return
    assert outcome.stderr == f"interrupted; resume with:\n  samcontact resume {tmp_path}\n"
    assert len(list((tmp_path / "checkpoints").glob("*.h5"))) == 3
    outcome = invoke("resume", tmp_path, *OPTIONS)
    assert outcome.exit_code == 0, outcome.output
    xr.testing.assert_identical(fields(tmp_path), expected)
    assert not (tmp_path / "checkpoints").exists()


def stop_at(number, error):
    """`Simulation.step` that fails at one increment."""
    step, count = sc.Simulation.step, [0]

    def counted(self, **arguments):
        count[0] += 1
        if count[0] == number:
            raise error
        return step(self, **arguments)

    return counted


# The second is handled like the first.
ERRORS = [
    sc.ConvergenceError("residual 0.1 after 200 iterations"),
    sc.GridTooSmallError("the contact reaches the border"),
    MemoryError(),
    OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "increment_00003.h5"),
]


@pytest.mark.parametrize(
    "error",
    [ERRORS[0], pytest.param(ERRORS[1], marks=pytest.mark.slow), *ERRORS[2:]],
    ids=lambda error: type(error).__name__,
)
def test_an_error_keeps_the_computed_results(
    case_file, expected, tmp_path, monkeypatch, error, undrawn
):
    with monkeypatch.context() as patch:
        patch.setattr(sc.Simulation, "step", stop_at(3, error))
        outcome = invoke("run", case_file, "--output", tmp_path, "--quiet")
    message = (f"2 of 3 increments are in {tmp_path}, marked as incomplete",)
    reason = str(error) or "not enough memory"
    if isinstance(error, OSError):
        reason = f"{error.filename}: {error.strerror}: free some space"
    check_failure(outcome, 1, reason, *message, f"resume {tmp_path}")
    found = fields(tmp_path)
    assert found.attrs["complete"] == 0
    assert found.attrs["stopped_by"] == f"{type(error).__name__}: {error}"
    xr.testing.assert_equal(found["pressure"], expected["pressure"].sel(increment=[1, 2]))
    assert interrupted.is_interrupted(tmp_path)
    if not isinstance(error, OSError):
        return
    checks = {check.name: check for check in report.checks(found)}
    assert not checks["increments: complete path (1) or part of it (0)"].passed
    outcome = invoke("report", tmp_path)
    assert "check failed: increments: complete path" in outcome.stderr
    assert str(error) in html.unescape((tmp_path / "report.html").read_text())
    # with what was missing
    outcome = invoke("resume", tmp_path / "results.nc", *OPTIONS)
    assert outcome.exit_code == 0, outcome.output
    xr.testing.assert_identical(fields(tmp_path), expected)
    assert expected.attrs["complete"] == 1
    assert [path.name for path in tmp_path.iterdir()] == ["results.nc"]


def test_an_error_at_the_first_increment_leaves_nothing(case_file, tmp_path, monkeypatch):
    monkeypatch.setattr(sc.Simulation, "step", stop_at(1, ERRORS[1]))
    outcome = invoke("run", case_file, "--output", tmp_path, "--quiet")
    check_failure(outcome, 2, "error: the contact reaches the border\n")
    assert list(tmp_path.iterdir()) == []


def test_an_error_of_this_program_is_shown_with_its_place(case_file, tmp_path, monkeypatch):
    monkeypatch.setattr(sc.Simulation, "step", stop_at(3, AttributeError("a slip")))
    outcome = invoke("run", case_file, "--output", tmp_path, *OPTIONS)
    assert isinstance(outcome.exception, AttributeError)
    assert "2 of 3 increments are in" in outcome.stderr
    assert fields(tmp_path).attrs["complete"] == 0


@pytest.mark.parametrize("name", ["to_dataset", "save"])
def test_results_that_cannot_be_written_leave_checkpoints(
    case_file, expected, tmp_path, monkeypatch, name
):
    with monkeypatch.context() as patch:
        patch.setattr(results, name, fails(OSError("no room")))
        check_failure(invoke("run", case_file, "--output", tmp_path, *OPTIONS), 1, "no room")
    # the file of the run, which is not there yet
    assert invoke("resume", tmp_path / "results.nc", *OPTIONS).exit_code == 0
    xr.testing.assert_identical(fields(tmp_path), expected)


def test_a_full_disk_reports_the_first_error(case_file, tmp_path, monkeypatch):
    """The command reports the first of two errors, and the results that could not be stored."""
    full = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    monkeypatch.setattr(sc.Simulation, "step", stop_at(3, ERRORS[0]))
    monkeypatch.setattr(results, "save", fails(full))
    monkeypatch.setattr(journal.Journal, "add", fails(full))
    outcome = invoke("run", case_file, "--output", tmp_path, *OPTIONS)
    assert outcome.exit_code == 1
    assert "error: did not converge: residual 0.1" in outcome.stderr
    assert "2 of 3 increments were completed, but could not all be written" in outcome.stderr
    assert "could not write all checkpoints" in outcome.stderr


# Case, results file, failing increment, and first increment that must not be solved again.
STUDIES = {
    "asperities": (ASPERITIES.replace("passes = 2", "passes = 1"), "series.nc", 5, 1),
    "wear": (WEAR.replace("cycles = 1", "cycles = 2"), "wear.nc", 3, 5),
    "wear by slip": (SCAR.replace("20000", "2000"), "wear.nc", 8, 7),
}


class TestStudies:
    """Passes of asperity collisions and cycles of wear."""

    @pytest.fixture(
        params=["asperities", "wear", pytest.param("wear by slip", marks=pytest.mark.slow)]
    )
    def study(self, request, tmp_path):
        text, *rest = STUDIES[request.param]
        file = tmp_path / "study.toml"
        file.write_text(text)
        return file, *rest

    def test_ctrl_c_after_the_last_increment(self, study, tmp_path, monkeypatch):
        case, name, _, too_many = study
        out = tmp_path / "out"
        with monkeypatch.context() as patch:
            patch.setattr(results, "save", pressed)
            outcome = invoke("run", case, "--output", out, *OPTIONS)
        assert outcome.exit_code == 130
        assert "samcontact resume" in outcome.stderr
        done = len(list((out / "checkpoints").glob("*.h5")))
        with monkeypatch.context() as patch:
            # only the last cycle of wear is solved again
            again = stop_at(too_many, AssertionError("solved again"))
            patch.setattr(sc.Simulation, "step", again)
            outcome = invoke("resume", out, *OPTIONS)
        assert outcome.exit_code == 0, outcome.output
        assert done > 0
        assert (out / name).exists()
        assert not (out / "checkpoints").exists()

    def test_an_error_keeps_the_computed_results(self, study, tmp_path, monkeypatch, undrawn):
        case, name, failing, _ = study
        out = tmp_path / "out"
        with monkeypatch.context() as patch:
            patch.setattr(sc.Simulation, "step", stop_at(failing, ERRORS[0]))
            outcome = invoke("run", case, "--output", out, *OPTIONS)
        what = "1 of up to 2 cycles" if "wear" in name else "1 of 1 passes (the last incomplete)"
        check_failure(outcome, 1, "did not converge: residual 0.1", f"{what} are in {out}")
        with results.open_results(out / name) as found:
            assert found.attrs["complete"] == 0
            assert not all(check.passed for check in report.checks(found))
            if "series" in name:
                assert found.sizes["increment"] == 3
                assert found["force_x"].notnull().all()
                assert found["net_energy"].isnull().all()
            else:
                assert found.sizes["cycle"] == 1
        assert invoke("report", out).exit_code == 0
        assert invoke("resume", out, *OPTIONS).exit_code == 0
        with results.open_results(out / name) as found:
            assert found.attrs["complete"] == 1


class TestOneRunAtATime:
    def test_a_second_run_in_a_folder_is_refused(self, case_file, tmp_path):
        with locked(tmp_path):
            for command in (
                ("run", case_file, "--output", tmp_path, *OPTIONS),
                ("sweep", case_file, "--set", "path[0].load=1,2", "--output", tmp_path, "--quiet"),
            ):
                outcome = invoke(*command)
                words = f"another run of samcontact writes to {tmp_path}, process {os.getpid()}:"
                check_failure(outcome, 1, words)
        assert list(tmp_path.iterdir()) == []

    def test_python_runs_are_locked_out_too(self, case_file, tmp_path):
        elastic, grid = sc.Material.elastic(210e9, 0.3), sc.Grid(9, 9, 5e-5, 5e-5, 4, 5e-5)
        steel, gap = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121), [[0.0] * 9] * 9
        steps = [{"load": 1.0}, {"load": 0.0}]
        simulation = sc.Simulation(grid, elastic, steel, gap)
        with locked(tmp_path), pytest.raises(OSError, match="another run"):
            simulation.run(steps, checkpoint=tmp_path)
        with locked(tmp_path), pytest.raises(OSError, match="another run"):
            sc.sweep(case_file, {"path[0].load": [1.0]}, output=tmp_path)
        with locked(tmp_path, name=".wear.h5.lock"), pytest.raises(OSError, match="another run"):
            sc.wear.run(
                grid, elastic, steel, sc.surfaces.paraboloid(grid, 7.5e-3), cycle=steps,
                threshold=3e-3, window=1, checkpoint=tmp_path / "wear.h5",
            )  # fmt: skip

    def test_a_process_that_died_leaves_no_lock(self, tmp_path):
        (tmp_path / LOCK_FILE).write_text("1\n")
        with locked(tmp_path):
            assert (tmp_path / LOCK_FILE).read_text() == f"{os.getpid()}\n"
        assert list(tmp_path.iterdir()) == []

    def test_a_lock_removed_meanwhile_does_not_count(self, tmp_path, monkeypatch):
        flock, calls = lock.fcntl.flock, []

        def late(handle, operation):
            """The previous run ends between opening and locking of its file."""
            if not calls:
                (tmp_path / LOCK_FILE).unlink()
            calls.append(handle)
            flock(handle, operation)

        monkeypatch.setattr(lock.fcntl, "flock", late)
        with locked(tmp_path):
            assert len(calls) == 2
            with pytest.raises(OSError, match="another run"), locked(tmp_path):
                pass

    def test_file_systems_without_locks(self, tmp_path, monkeypatch):
        monkeypatch.setattr(lock.fcntl, "flock", fails(OSError(errno.ENOLCK, "no locks")))
        with locked(tmp_path):
            pass
        assert list(tmp_path.iterdir()) == []


def test_a_run_replaces_the_files_of_the_previous_run(case_file, tmp_path, monkeypatch, undrawn):
    """A run removes old figures, reports and exports once new results exist, but no other files."""
    command = ("run", case_file, "--output", tmp_path, "--quiet")
    assert invoke(*command).exit_code == 0
    assert invoke("report", tmp_path).exit_code == 0
    assert invoke("export", tmp_path / "results.nc", "--vtk").exit_code == 0
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert {"report.html", "results.vtr", "results_surface.vtr", "pressure.png"} <= set(before)
    mine = ["notes.txt", "my_pressure.png", "wear.csv", "track_imprint.pdf", "results_00002.vtr"]
    for name in mine:
        (tmp_path / name).write_text("old")
    with monkeypatch.context() as patch:
        patch.setattr(sc.Simulation, "step", stop_at(1, ERRORS[0]))
        assert invoke(*command).exit_code == 1
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before | {
        name: b"old" for name in mine
    }
    outcome = invoke(*command, "--no-figures")
    assert outcome.exit_code == 0
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {"results.nc", *mine}
    assert all((tmp_path / name).read_text() == "old" for name in mine)

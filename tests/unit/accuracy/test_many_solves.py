# SPDX-License-Identifier: GPL-3.0-or-later
"""Interrupted runs to an accuracy and load searches resume: no increment is
repeated, and the bits are those of an undisturbed run."""

import errno
import os
import sys

import numpy as np
import pytest

import samcontact as sc
from command import check_failure, fields, invoke
from samcontact import report
from samcontact.accuracy import grids, refinable_case

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TEXT = """title = "ball"
accuracy = 0.01
quantities = ["max_pressure", "contact_area"]
body1 = {law = "rigid"}
body2 = {law = "elastic", E = 210e9, nu = 0.3}
surface = {shape = "paraboloid", Rx = 7.5e-3}
path = [{load = 100.0}, {load = 300.0}, {load = 500.0}]
output = {volume = "none"}
"""
ELASTIC = tomllib.loads(TEXT)
SWIFT = {"law": "swift", "E": 210e9, "nu": 0.3, "B": 945e6, "C": 20.0, "n": 0.121}
YIELDING = ELASTIC | {"accuracy": 0.1, "body2": SWIFT, "path": [{"load": 500.0}]}
OPTIONS = ("--no-figures", "--quiet")


@pytest.fixture
def steps(monkeypatch):
    """Counter of increments; increment number `at` raises `error` instead."""
    step = sc.Simulation.step

    class Steps:
        made, at, error = 0, 0, KeyboardInterrupt()

        def stop(self, at, error=error):
            self.made, self.at, self.error = 0, at, error

    message = Steps()

    def counted(self, **arguments):
        message.made += 1
        if message.made == message.at:
            raise message.error
        return step(self, **arguments)

    monkeypatch.setattr(sc.Simulation, "step", counted)
    return message


def solved(case, **settings):
    return sc.to_accuracy(case, progress=False, **settings)


@pytest.fixture(scope="module")
def expected():
    return solved(ELASTIC)


def assert_same(found, other):
    assert (found.values, found.errors) == (other.values, other.errors)
    assert found.grid == other.grid
    assert [run[:3] for run in found.runs] == [run[:3] for run in other.runs]
    for mine, theirs in zip(found.states, other.states, strict=True):
        assert np.array_equal(mine.pressure, theirs.pressure)


@pytest.mark.parametrize("at", [2, 6, 7, 11])
@pytest.mark.usefixtures("steps_alone")
def test_an_interrupted_run_to_an_accuracy_resumes_with_identical_bits(
    expected, steps, tmp_path, at
):
    assert len(expected.runs) == 5
    steps.stop(at)
    with pytest.raises(KeyboardInterrupt) as stop:
        solved(ELASTIC, checkpoint=tmp_path)
    if at > 9:  # three grids are done, which have errors
        best = stop.value.result
        pressure = best.values["max_pressure"], best.errors["max_pressure"]
        assert abs(pressure[0] - expected.values["max_pressure"]) < pressure[1]
        assert len(best.runs) == 3
        assert not best.reached
    else:
        assert stop.value.result is None
    steps.stop(0)
    assert_same(solved(ELASTIC, checkpoint=tmp_path), expected)
    assert steps.made == 15 - (at - 1)
    # a repeated call solves nothing, and another case uses none of the files
    steps.stop(0)
    assert_same(solved(ELASTIC, checkpoint=tmp_path), expected)
    assert steps.made == 0
    with pytest.raises(sc.CheckpointError, match=r"of another run.*path"):
        solved(ELASTIC | {"path": [{"load": 501.0}]}, checkpoint=tmp_path)


def test_increments_of_error_estimates_are_not_repeated(steps, tmp_path, monkeypatch):
    monkeypatch.setattr(grids, "CELLS_OF_FIRST_GRID", 2.5)  # few cells are sufficient for a resume
    whole = solved(YIELDING)
    total = steps.made
    steps.stop(4 + 4 + 6)  # in the second of the runs on the second grid
    with pytest.raises(KeyboardInterrupt):
        solved(YIELDING, checkpoint=tmp_path)
    steps.stop(0)
    again = solved(YIELDING, checkpoint=tmp_path)
    assert steps.made == total - (4 + 4 + 5)
    assert_same(again, whole)
    strains = (found.states[-1].plastic_strain() for found in (again, whole))
    assert np.array_equal(*strains)


def test_a_damaged_file_is_solved_again(expected, tmp_path, steps):
    solved(ELASTIC, checkpoint=tmp_path)
    file = tmp_path / f"{refinable_case.name_of(0, 1)}.h5"
    file.write_bytes(file.read_bytes()[:-10])
    steps.stop(0)
    with pytest.warns(UserWarning, match="is damaged: .* this checkpoint is not used"):
        assert_same(solved(ELASTIC, checkpoint=tmp_path), expected)
    assert steps.made == 3


@pytest.mark.parametrize(
    ("journal", "error"), [(False, None), (True, OSError(errno.ENOSPC, os.strerror(errno.ENOSPC)))]
)
@pytest.mark.usefixtures("steps_alone")
def test_the_command_stores_the_best_values_and_resumes(expected, steps, tmp_path, journal, error):
    file, out = tmp_path / "case.toml", tmp_path / "out"
    file.write_text(TEXT, encoding="utf-8")
    steps.stop(11, KeyboardInterrupt() if error is None else error)
    outcome = invoke("run", file, "--output", out, *OPTIONS, *["--resume"] * journal)
    message = f"values of 3 grids are in {out}, marked as incomplete"
    if error is None:
        assert outcome.exit_code == 130
        assert (
            outcome.stderr == f"{message}\ninterrupted; resume with:\n  samcontact resume {out}\n"
        )
    else:
        check_failure(outcome, 1, f"{message}; resume with:\n  samcontact resume {out}")
    left = fields(out)
    assert left.attrs["complete"] == 0
    assert left["max_pressure_error"][-1] > expected.errors["max_pressure"]
    failed = [check.name for check in report.checks(left) if not check.passed]
    assert failed == [
        "increments: complete path (1) or part of it (0)",
        "estimated relative error, contact area",
    ]
    steps.stop(0)
    outcome = invoke("resume", out, *OPTIONS)
    assert outcome.exit_code == 0, outcome.output
    assert steps.made == 5
    done = fields(out)
    assert done.attrs["complete"] == 1
    assert float(done["max_pressure_best"][-1]) == expected.values["max_pressure"]
    assert np.array_equal(done["pressure"][-1], expected.states[-1].pressure)
    assert not (out / "checkpoints").exists()


def test_each_grid_is_reported_with_the_errors_above_the_target(capsys):
    found = sc.to_accuracy(ELASTIC)
    out, err = capsys.readouterr()
    lines = err.splitlines()
    assert out == ""
    grids = [line for line in lines if line.startswith("grid")]
    assert len(grids) == len(found.runs)
    for line, (nx, ny, *_) in zip(grids, found.runs, strict=True):
        assert f": {nx} × {ny} cells, " in line
    assert lines[-3].startswith("  estimated errors: contact_area 1.")
    assert lines[-1] == "  estimated errors: all below the prescribed accuracy"


def found(build, **settings):
    return sc.find_load(build, "approach", 4e-6, largest_load=400.0, progress=False, **settings)


def ball(load):
    grid = sc.Grid(25, 25, 25e-6, 25e-6)
    body = sc.Material.elastic(210e9, 0.3)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    return sc.Simulation(grid, body, body, gap), [{"load": 0.5 * load}, {"load": load}]


@pytest.mark.parametrize("end", [0, 1, 2, 3])
def test_an_interrupted_load_search_resumes_with_identical_bits(steps, tmp_path, end):
    whole = found(ball)
    total = steps.made
    estimate = 2  # increments on the coarsened grid, for the error of the found load
    at = [4, total - estimate - 3, total - estimate, total][end]
    steps.stop(at)
    with pytest.raises(KeyboardInterrupt):
        found(ball, checkpoint=tmp_path)
    steps.stop(0)
    again = found(ball, checkpoint=tmp_path)
    assert (again.load, again.value, again.load_error) == (
        whole.load,
        whole.value,
        whole.load_error,
    )
    assert np.array_equal(again.states[-1].pressure, whole.states[-1].pressure)
    assert steps.made == total - (at - 1)
    with pytest.raises(sc.CheckpointError, match="of another run"):
        found(lambda load: (ball(load)[0], [{"load": load}]), checkpoint=tmp_path)


@pytest.mark.usefixtures("steps_alone")
def test_the_command_resumes_a_load_search(steps, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "case.toml"
    grid = "[grid]\nnx = 25\nny = 25\ndx = 25e-6\ndy = 25e-6\n"
    of_accuracy = ("accuracy", "quantities", "path", "output")
    lines = [line for line in TEXT.splitlines() if not line.startswith(of_accuracy)]
    text = "\n".join([*lines, "path = [{load = 500.0, increments = 1}]", ""])
    file.write_text(text + grid, encoding="utf-8")
    command = ("find", file, "max_pressure=1e9")
    whole = invoke(*command, "--quiet")
    assert whole.exit_code == 0, whole.output
    assert whole.stderr == ""
    total = steps.made
    steps.stop(total // 2)
    outcome = invoke(*command)
    assert outcome.exit_code == 130
    *lines, last, end = outcome.stderr.splitlines()
    assert end == "interrupted"
    assert last.startswith("progress saved in results/case/find_")
    assert all("(target " in line for line in lines)
    steps.stop(0)
    again = invoke(*command, "--quiet")
    assert again.stdout == whole.stdout
    assert steps.made == total - (total // 2 - 1)
    assert list((tmp_path / "results" / "case").iterdir()) == []

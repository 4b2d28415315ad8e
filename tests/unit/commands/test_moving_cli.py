# SPDX-License-Identifier: GPL-3.0-or-later
"""The command with moving contacts: figures, animation, and resuming after a kill."""

import logging
import signal
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr
from PIL import Image

from case_texts import MINIMAL, MOVING
from command import check_failure, fields, invoke, pressed
from samcontact import Simulation, results
from samcontact.cases import load_case
from samcontact.commands import solve_contact

WITHOUT_ERROR_ESTIMATE = f"estimate_error = false\n{MOVING}"


@pytest.fixture
def case_file(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(MOVING)
    return path


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """Return the results of a run of `WITHOUT_ERROR_ESTIMATE` from begin to end."""
    folder = tmp_path_factory.mktemp("plain")
    (folder / "case.toml").write_text(WITHOUT_ERROR_ESTIMATE)
    command = ("run", folder / "case.toml", "--output", folder, "--no-figures", "--quiet")
    assert invoke(*command).exit_code == 0
    return fields(folder)


def test_figures_and_animation(case_file, tmp_path, monkeypatch, undrawn_files):
    monkeypatch.setattr(solve_contact, "MAX_FRAMES", 4)
    case_file.write_text(MOVING.replace("passes = 2", "passes = 1"))
    outcome = invoke("run", case_file, "--output", tmp_path / "out", "--animate")
    assert outcome.exit_code == 0, outcome.output
    files = [line.rsplit("/", 1)[1] for line in outcome.stdout.splitlines() if "/out/" in line]
    assert files[0] == "results.nc"
    assert files[-4:] == ["residual.png", "track_imprint.png", "track_sections.png", "rolling.gif"]
    with Image.open(tmp_path / "out" / "rolling.gif") as image:
        assert image.n_frames == 3  # every second of 6 increments
    assert "travel" in outcome.stdout
    assert " -180 " in outcome.stdout


def test_animation_of_a_static_contact_is_refused(case_file, tmp_path):
    case_file.write_text(MINIMAL)
    outcome = invoke("run", case_file, "--output", tmp_path / "out", "--animate")
    check_failure(outcome, 2, "--animate requires Coulomb friction, or bodies that move")
    assert not (tmp_path / "out").exists()


# Run from the command line that is killed while it writes a checkpoint.
KILLED = """
import os, signal, sys
from samcontact import Simulation
from samcontact.restart import file
from samcontact.commands.main import main
write, count = file.write_tree, 0
def counted(opened, tree):
    global count
    write(opened, tree)
    count += 1
    if count == int(sys.argv[1]):
        opened.flush()
        os.kill(os.getpid(), signal.SIGKILL)
file.write_tree = counted
main(sys.argv[2:])
"""


def test_a_killed_run_resumes(case_file, tmp_path, undisturbed):
    resumed = tmp_path / "resumed"
    case_file.write_text(WITHOUT_ERROR_ESTIMATE)
    options = ("--no-figures", "--quiet")
    arguments = ["run", str(case_file), "--output", str(resumed), "--resume", *options]
    command = [sys.executable, "-c", KILLED, "9", *arguments]  # in the second pass
    assert subprocess.run(command, check=False).returncode == -signal.SIGKILL
    whole = sorted((resumed / "checkpoints").glob("*.h5"))
    assert [file.name for file in whole] == [f"increment_{number:05d}.h5" for number in range(1, 9)]
    assert not (resumed / "results.nc").exists()
    outcome = invoke(*arguments)
    assert outcome.exit_code == 0, outcome.output
    assert [path.name for path in resumed.iterdir()] == ["results.nc"]
    assert float(np.abs(undisturbed["track_residual_stress_body2"]).max()) > 0
    xr.testing.assert_identical(fields(resumed), undisturbed)


class TestForeignCheckpoints:
    @pytest.fixture
    def folder(self, case_file, tmp_path, monkeypatch):
        """Return a folder with checkpoints of one increment of the case."""
        step = Simulation.step

        def once(self, **arguments):
            if self.state.load > 0:
                raise KeyboardInterrupt
            return step(self, **arguments)

        with monkeypatch.context() as patch:
            patch.setattr(Simulation, "step", once)
            assert invoke(*self.command(case_file, tmp_path)).exit_code != 0
        found = tmp_path / "out" / "checkpoints"
        assert sorted(path.name for path in found.iterdir()) == [
            "case.txt",
            "increment_00001.h5",
        ]
        return found

    @staticmethod
    def command(case_file, tmp_path):
        return ("run", case_file, "--output", tmp_path / "out", "--resume", "--quiet")

    def test_another_load(self, folder, case_file, tmp_path):
        case_file.write_text(MOVING.replace("load = 600.0", "load = 500.0"))
        outcome = invoke(*self.command(case_file, tmp_path))
        check_failure(outcome, 2, str(folder), "of another run", "use another path")
        # it still belongs to the previous run
        _, source, text = (folder / "case.txt").read_text().split("\n", 2)
        assert (source, text) == (str(case_file), MOVING)

    def test_without_a_description(self, folder, case_file, tmp_path):
        Simulation.load(folder / "increment_00001.h5").save(folder / "increment_00001.h5")
        check_failure(invoke(*self.command(case_file, tmp_path)), 2, "of another run")

    def test_damaged(self, folder, case_file, tmp_path):
        file = folder / "increment_00001.h5"
        file.write_bytes(file.read_bytes()[:-500])
        with pytest.warns(UserWarning, match="is damaged: .* increment 1 is solved again"):
            outcome = invoke(*self.command(case_file, tmp_path), "--no-figures")
        assert outcome.exit_code == 0, outcome.output
        assert not folder.exists()

    def test_a_new_run_moves_foreign_checkpoints(self, folder, case_file, tmp_path):
        case_file.write_text(MINIMAL)
        plain = ("run", case_file, "--output", tmp_path / "out", "--quiet", "--no-figures")
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(solve_contact.results, "to_dataset", pressed)
            outcome = invoke(*plain)
        aside = folder.with_name("checkpoints.old")
        assert outcome.exit_code == 130
        assert outcome.stderr.startswith(f"checkpoints of a different run were moved to {aside}\n")
        assert (aside / "increment_00001.h5").exists()
        outcome = invoke(*plain)  # of the same run: none is lost
        assert outcome.exit_code == 0
        assert (
            outcome.stderr == f"continuing from the checkpoints of an interrupted run: {folder}\n"
        )
        assert [path.name for path in folder.parent.iterdir()] == ["results.nc"]


def test_changed_heights_are_another_run(case_file, tmp_path, monkeypatch):
    relief = '[relief2]\nkind = "file"\npath = "h.npy"\n[contact]'
    case_file.write_text(MOVING.replace("[contact]", relief, 1))
    np.save(tmp_path / "h.npy", np.zeros((3, 13)))
    command = ("run", case_file, "--output", tmp_path / "out", "--resume", "--quiet")
    with monkeypatch.context() as patch:
        patch.setattr(results, "save", lambda *_: (_ for _ in ()).throw(OSError("disk full")))
        check_failure(invoke(*command), 1, "disk full")
    np.save(tmp_path / "h.npy", np.full((3, 13), 1e-9))
    check_failure(invoke(*command), 2, "of another run")


INTERRUPTED = """
import os, signal, sys
from samcontact import Simulation
from samcontact.commands.main import main
step, count = Simulation.step, 0
def counted(self, **arguments):
    global count
    if count == 4:
        os.kill(os.getpid(), signal.SIGINT)
    count += 1
    return step(self, **arguments)
Simulation.step = counted
main(sys.argv[1:])
"""


def test_ctrl_c_prints_the_resume_command(case_file, tmp_path, undisturbed):
    stopped = tmp_path / "stopped"
    case_file.write_text(WITHOUT_ERROR_ESTIMATE)
    options = ("--no-figures", "--quiet")
    command = [sys.executable, "-c", INTERRUPTED, "run", str(case_file)]
    ended = subprocess.run(
        [*command, "--output", str(stopped), *options], capture_output=True, text=True, check=False
    )
    assert ended.returncode == 130
    assert f"samcontact resume {stopped}" in ended.stderr
    assert len(list((stopped / "checkpoints").glob("*.h5"))) == 4
    outcome = invoke("resume", stopped, *options)
    assert outcome.exit_code == 0, outcome.output
    assert [path.name for path in stopped.iterdir()] == ["results.nc"]
    xr.testing.assert_identical(fields(stopped), undisturbed)
    check_failure(invoke("resume", stopped), 2, "no interrupted run found in")


def test_resume_refuses_a_case_that_changed(case_file, tmp_path):
    folder = tmp_path / "out" / "checkpoints"
    folder.mkdir(parents=True)
    (folder / "case.txt").write_text(f"samcontact run 0\n{case_file}\n{MOVING}")
    case_file.write_text(MOVING.replace("600.0", "500.0"))
    check_failure(invoke("resume", tmp_path / "out"), 2, "has changed since the interruption")


def test_a_run_reports_its_increments(case_file, caplog):
    simulation, path = load_case(case_file).build()
    with caplog.at_level(logging.DEBUG, logger="samcontact"):
        states = simulation.run(path[:2], progress=False)
    message = [record.getMessage() for record in caplog.records]
    assert message[0].startswith(f"increment 1 of 2: load {states[0].load:.6g} N")
    assert f"{states[1].contact_iterations} contact iterations" in message[3]
    strain = states[1].track(margin=0).equivalent_plastic_strain()
    assert states[1].plastic_cells() == (strain > 0).sum() > 0

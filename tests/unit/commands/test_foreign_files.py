# SPDX-License-Identifier: GPL-3.0-or-later
"""Foreign files are never replaced or removed; a conflict is refused before the solve."""

import fcntl
import os
import signal
import stat
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from case_texts import MINIMAL, SCAR
from command import check_failure, invoke
from samcontact import plotting, report, results, wear
from samcontact.commands.folder import publish
from samcontact.files.atomic import replacing
from samcontact.files.ownership import RECORD_FILE, recording
from samcontact.restart.checkpoint_files import remove_checkpoints
from samcontact.restart.lock import LOCK_FILE
from samcontact.results.isolated_read import try_to_read

GRID = sc.Grid(8, 8, 1e-5, 1e-5)
ELASTIC = sc.Material.elastic(210e9, 0.3)
FOREIGN = "what nobody else has"


def snapshot(folder):
    """Return all names in a folder, with their types and contents."""
    found = {}
    for path in sorted(folder.rglob("*")):
        mode = path.lstat().st_mode
        content = path.read_bytes() if stat.S_ISREG(mode) else b""
        target = os.readlink(path) if stat.S_ISLNK(mode) else ""
        found[str(path.relative_to(folder))] = stat.S_IFMT(mode), content, target
    return found


def simulation():
    return sc.Simulation(GRID, ELASTIC, ELASTIC, np.ones((8, 8)), on_border="warn")


def state_file(folder):
    file = folder / "state.h5"
    simulation().save(file)
    return file


def dataset():
    problem = simulation()
    return results.to_dataset(problem, [problem.step(pressure=np.ones((8, 8)))])


def wear_of(checkpoint):
    grid, steel = sc.Grid(8, 8, 1e-5, 1e-5, 4, 1e-5), sc.Material.perfect_plastic(2e11, 0.3, 1e9)
    cycle = [{"load": 1.0}, {"load": 0.0}]  # too much for the grid
    problem = (grid, ELASTIC, steel, np.ones((8, 8)))
    wear.run(*problem, cycle=cycle, threshold=1e-3, cycles=1, window=3, checkpoint=checkpoint)


def text(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(FOREIGN)


def link(path):
    elsewhere = path.parent.parent / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "keep").write_text(FOREIGN)
    path.symlink_to(elsewhere)


def another_hdf5(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    with h5py.File(path, "w") as file:
        file["weights"] = np.arange(3.0)


class TestCommands:
    @pytest.fixture(autouse=True)
    def unsolved(self, monkeypatch):
        """Assert that nothing is solved before a folder is refused."""

        def solved(*_, **__):
            raise AssertionError("solved")

        monkeypatch.setattr(sc.Simulation, "step", solved)

    @pytest.mark.parametrize(
        ("name", "make"),
        [
            ("checkpoints/model.pt", text),
            ("checkpoints/sub/case.txt", text),
            ("checkpoints/increment_00001.h5", another_hdf5),
            ("checkpoints/empty.py", lambda path: (path.parent.mkdir(), path.touch())),
            ("checkpoints/linked.h5", lambda path: (path.parent.mkdir(), link(path))),
            ("checkpoints/pipe.h5", lambda path: (path.parent.mkdir(), os.mkfifo(path))),
            ("checkpoints", text),
            ("checkpoints", link),
            ("checkpoints.old/keep.txt", text),
            (".checkpoints.done/keep.txt", text),
            ("results.nc", text),
            ("results.nc", another_hdf5),
            ("results.nc", link),
            ("results.nc", Path.mkdir),
            ("results.nc", os.mkfifo),
            ("pressure.png", text),
            ("partial_slip.png", text),
            (RECORD_FILE, text),
            (RECORD_FILE, os.mkfifo),
        ],
    )
    def test_foreign_files_in_the_way_are_refused(self, tmp_path, name, make):
        out, case = tmp_path / "out", tmp_path / "case.toml"
        out.mkdir()
        case.write_text(MINIMAL)
        make(out / name)
        before = snapshot(tmp_path)
        outcome = invoke("run", case, "--output", out)
        check_failure(outcome, 2, str(out / name), ": move ")
        assert snapshot(tmp_path) == before

    @pytest.mark.parametrize("make", [text, link, Path.mkdir, os.mkfifo])
    def test_foreign_locks(self, tmp_path, make):
        out, case = tmp_path / "out", tmp_path / "case.toml"
        out.mkdir()
        case.write_text(MINIMAL)
        make(out / LOCK_FILE)
        before = snapshot(tmp_path)
        outcome = invoke("run", case, "--output", out)
        check_failure(
            outcome, 1, str(out / LOCK_FILE), "is not a lock file of samcontact: move this"
        )
        assert snapshot(tmp_path) == before

    def test_a_case_file_by_the_name_of_a_result(self, tmp_path):
        case = tmp_path / "wear.csv"
        case.write_text(SCAR)
        outcome = invoke("run", case, "--output", tmp_path)
        check_failure(outcome, 2, f"the case file {case} has the name of a file that the run may")
        assert case.read_text() == SCAR

    @pytest.mark.parametrize("name", ["sweep.nc", "cases"])
    def test_sweeps(self, tmp_path, name):
        case = tmp_path / "case.toml"
        case.write_text(MINIMAL)
        text(tmp_path / "out" / name)
        command = ("sweep", case, "--set", "path[0].load=100,200", "--output", tmp_path / "out")
        outcome = invoke(*command)
        assert outcome.exit_code == 2
        assert "move this file" in outcome.stderr
        assert (tmp_path / "out" / name).read_text() == FOREIGN


def test_a_changed_figure_is_not_replaced(tmp_path, undrawn):
    """A figure edited by the user is kept; unchanged figures are replaced without a message."""
    data = dataset()
    written = plotting.summary_figures(data, tmp_path)
    assert plotting.summary_figures(data, tmp_path) == written
    retouched = written[0].read_bytes() + b"retouched"
    written[0].write_bytes(retouched)
    with pytest.raises(
        ValueError, match=f"{written[0].name} was not written by samcontact, or has"
    ):
        plotting.summary_figures(data, tmp_path)
    assert written[0].read_bytes() == retouched


def test_unchanged_files_of_a_second_run_are_listed_again(tmp_path):
    for _ in range(3):
        with recording(tmp_path):
            publish(dataset(), tmp_path / "wear.nc")
            with replacing(tmp_path / "wear.csv") as part:
                part.write_text("the same")
    (tmp_path / "wear.csv").write_text("another")
    with recording(tmp_path), pytest.raises(ValueError, match=r"wear\.csv was not written by"):  # noqa: SIM117
        with replacing(tmp_path / "wear.csv"):
            pass


def test_a_figure_is_listed_before_it_gets_its_name(tmp_path, monkeypatch, undrawn):
    """A figure left by a killed run must not be regarded as a foreign file."""
    data = dataset()

    def killed(*_):
        raise KeyboardInterrupt

    plotting.summary_figures(data, tmp_path / "whole")
    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", killed)
        with pytest.raises(KeyboardInterrupt):
            plotting.summary_figures(data, tmp_path / "killed")
    whole = (tmp_path / "whole" / "pressure.png").read_bytes()
    (tmp_path / "killed" / "pressure.png").write_bytes(whole)
    plotting.summary_figures(data, tmp_path / "killed")
    with (tmp_path / "killed" / RECORD_FILE).open("a") as record:  # a disk that was full
        record.write('["12')
    plotting.summary_figures(data, tmp_path / "killed")


@pytest.mark.parametrize(
    "write",
    [
        lambda path: simulation().save(path),
        lambda path: results.save(dataset(), path),
        lambda path: wear_of(path),
        lambda path: wear_of(path.with_suffix("")),
    ],
    ids=["checkpoint", "results", "wear", "wear before"],
)
@pytest.mark.parametrize("make", [text, another_hdf5, Path.mkdir, os.mkfifo])
def test_foreign_files_with_a_name_of_ours_are_kept(tmp_path, write, make):
    """A mistyped name, such as the name of the script, destroys no file."""
    path = tmp_path / "mine.before"
    make(path)
    before = snapshot(tmp_path)
    with pytest.raises((ValueError, OSError), match=r"mine\.before"):
        write(path)
    assert snapshot(tmp_path) == before


@pytest.mark.parametrize("name", ["increment_00001.h5", "increment_00007.h5"])
def test_journals(tmp_path, name):
    another_hdf5(tmp_path / name)
    content = (tmp_path / name).read_bytes()
    with pytest.raises(ValueError, match=f"{name} was not written by samcontact.* move "):
        simulation().run([{"approach": -1.0}], progress=False, checkpoint=tmp_path)
    assert (tmp_path / name).read_bytes() == content


@pytest.mark.parametrize("make", [Path.mkdir, os.mkfifo])
def test_reports_are_regular_files(tmp_path, make):
    make(tmp_path / "report.html")
    before = snapshot(tmp_path)
    with pytest.raises(OSError, match="must be a file, but is a"):
        report.write(dataset(), tmp_path / "report.html")
    assert snapshot(tmp_path) == before


def test_behind_a_link(tmp_path):
    file = state_file(tmp_path)
    before = file.read_bytes()
    (tmp_path / "link.h5").symlink_to(file)
    problem = simulation()
    problem.step(pressure=np.ones((8, 8)))
    problem.save(tmp_path / "link.h5")
    assert (tmp_path / "link.h5").is_symlink()
    assert file.read_bytes() != before


def test_foreign_files_among_checkpoints_are_kept(tmp_path):
    folder = tmp_path / "checkpoints"
    (folder / "inner").mkdir(parents=True)
    state_file(folder / "inner")
    text(folder / "inner" / "notes.txt")
    link(folder / "linked")
    remove_checkpoints(folder)
    assert sorted(path.name for path in folder.rglob("*")) == ["inner", "linked", "notes.txt"]
    assert (tmp_path / "elsewhere" / "keep").exists()


KILLED = """
import os, signal, sys
from samcontact.files.atomic import replacing
with replacing(sys.argv[1]) as part:
    part.write_bytes(b"half of it")
    print(part, flush=True)
    sys.stdin.read()
"""


class TestLeftovers:
    @pytest.fixture
    def writing(self, tmp_path):
        """Return a process that is writing a file, and this file."""
        file = tmp_path / "results.nc"
        command = [sys.executable, "-c", KILLED, str(file)]
        pipe = subprocess.PIPE
        with subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True) as process:
            yield process, Path(process.stdout.readline().strip())
            process.kill()

    def test_of_a_killed_process(self, tmp_path, writing):
        process, part = writing
        other = tmp_path / ".results.nc.abcdefgh.part"
        text(other)
        results.save(dataset(), tmp_path / "results.nc")
        assert part.read_bytes() == b"half of it"  # it is alive
        process.send_signal(signal.SIGKILL)
        process.wait()
        case = tmp_path / "case.toml"
        case.write_text(MINIMAL)
        assert invoke("run", case, "--output", tmp_path, "--no-figures").exit_code == 0
        left = {path.name for path in tmp_path.iterdir()}
        assert left == {"results.nc", "case.toml", other.name}

    def test_by_the_next_that_writes_the_file(self, tmp_path, writing):
        process, part = writing
        process.kill()
        process.wait()
        assert part.exists()
        results.save(dataset(), tmp_path / "results.nc")
        assert list(tmp_path.iterdir()) == [tmp_path / "results.nc"]

    def test_a_part_file_removed_before_its_lock_is_created_again(self, tmp_path, monkeypatch):
        lock, taken = fcntl.flock, []

        def late(handle, how):
            if not taken:
                (found,) = tmp_path.iterdir()
                found.unlink()
                taken.append(found)
            lock(handle, how)

        monkeypatch.setattr(fcntl, "flock", late)
        with replacing(tmp_path / "file") as part:
            part.write_text("new")
        assert (tmp_path / "file").read_text() == "new"


class TestUnsealed:
    """Results without a digest, as written by other programs."""

    @pytest.fixture
    def edited(self, tmp_path):
        file = results.save(dataset(), tmp_path / "results.nc")
        with h5py.File(file, "a") as opened:
            opened.attrs["more"] = 1
        return file

    def test_unsealed_results_are_read(self, edited, tmp_path):
        whole = results.save(dataset(), tmp_path / "whole.nc")
        with results.open_results(edited) as one, results.open_results(whole) as other:
            for changing in ("more", "created", "history"):
                one.attrs.pop(changing), other.attrs.pop(changing, None)
            xr.testing.assert_identical(one.load(), other.load())

    def test_unsealed_results_that_would_never_end_are_refused(self, edited):
        """A heap object of HDF5 with rounded length 0 makes HDF5 search without end."""
        content = bytearray(edited.read_bytes())
        heap = content.index(b"GCOL\x01\0\0\0")
        size = heap + 16 + 8  # of the first object: number, references, 4 bytes, size
        content[size : size + 8] = b"\xf0" + b"\xff" * 7
        edited.write_bytes(content)
        with pytest.raises(ValueError, match="reading it does not terminate"):
            try_to_read(edited, call=0.5)

    def test_unsealed_results_that_would_crash_are_refused(self, edited, monkeypatch):
        monkeypatch.setattr(
            "samcontact.results.isolated_read._READER_PROGRAM",
            "import os; os.kill(os.getpid(), 11)",
        )
        with pytest.raises(
            ValueError, match=r"results\.nc: the file is damaged: reading it ends with SIGSEGV"
        ):
            results.open_results(edited)

    @pytest.mark.parametrize("kind", ["link", "virtual", "storage"])
    @pytest.mark.parametrize("group", ["", "inner/"])
    def test_parts_in_other_files(self, edited, tmp_path, kind, group):
        other, name = tmp_path / "other.h5", f"{group}secret"
        another_hdf5(other)
        with h5py.File(edited, "a") as file:
            if kind == "link":
                file[name] = h5py.ExternalLink(str(other), "/weights")
            elif kind == "virtual":
                layout = h5py.VirtualLayout((3,), "f8")
                layout[:] = h5py.VirtualSource(str(other), "weights", (3,))
                file.create_virtual_dataset(name, layout)
            else:
                file.create_dataset(name, (8,), "u1", external=[(str(other), 0, 8)])
        with pytest.raises(ValueError, match=f"{name} .*another file.* is not supported"):
            results.open_results(edited)
        with h5py.File(edited, "r") as file, pytest.raises(ValueError, match="another file"):
            sc.restart.file.require_self_contained(file)


def test_an_unsealed_checkpoint_is_refused_without_being_opened(tmp_path, monkeypatch):
    file = state_file(tmp_path)
    file.write_bytes(file.read_bytes()[:-1000])

    def opened(*_, **__):
        raise AssertionError("opened")

    monkeypatch.setattr(h5py, "File", opened)
    with pytest.raises(sc.CheckpointError, match="checksum at the end is missing"):
        sc.Simulation.load(file)

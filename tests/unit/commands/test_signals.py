# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that end the command: from batch systems and terminals, repeated, during loading."""

import signal
import subprocess
import sys

import pytest

from case_texts import ASPERITIES, MINIMAL, WEAR
from command import invoke
from samcontact import results
from samcontact._util.silent_interrupt import is_command

# Command that gets a signal before its n-th increment.
COMMAND = """
import os, signal, sys
from samcontact import Simulation
from samcontact.simulation import increment_errors
from samcontact.commands.main import main
step, left = Simulation.step, int(sys.argv[1])
increment_errors.estimated = lambda *_, **__: None  # whose steps are those of no path
def counted(self, **arguments):
    global left
    left -= 1
    if left == 0:
        os.kill(os.getpid(), int(sys.argv[2]))
    return step(self, **arguments)
Simulation.step = counted
main(sys.argv[3:])
"""
OPTIONS = ("--no-figures", "--quiet")


# Case and signal for each kind of run.
WITHOUT_ERROR_ESTIMATE = f"estimate_error = false\n{MINIMAL}"
TEXTS = {
    "run": (WITHOUT_ERROR_ESTIMATE, signal.SIGHUP),
    "sweep": (WITHOUT_ERROR_ESTIMATE, signal.SIGTERM),
    "asperities": (ASPERITIES.replace("passes = 2", "passes = 1"), signal.SIGTERM),
    "wear": (WEAR.replace("cycles = 1", "cycles = 2"), signal.SIGTERM),
}


def start(script, *arguments):
    command = [sys.executable, "-c", script, *map(str, arguments)]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    # nohup for all tests must not reach the command
    return subprocess.Popen(
        command, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL), **pipes
    )


@pytest.mark.parametrize(
    "kind",
    ["run", "sweep", *(pytest.param(kind, marks=pytest.mark.slow) for kind in list(TEXTS)[2:])],
)
def test_signals_of_a_batch_system_or_a_closed_terminal(tmp_path, kind):
    case, out = tmp_path / "case.toml", tmp_path / "out"
    text, number = TEXTS[kind]
    case.write_text(text)
    arguments = ["run", str(case), "--output", str(out), *OPTIONS]
    if kind == "sweep":
        arguments = ["sweep", str(case), "--set", "path[0].load=300,200", "--output", str(out)]
    count = 5 if kind == "sweep" else 3
    with start(COMMAND, count, int(number), *arguments) as process:
        _, errors = process.communicate()
    assert process.returncode == 128 + number, errors
    assert "Traceback" not in errors
    if kind == "sweep":
        with results.open_results(out / "sweep.nc") as found:
            assert found["status"].values.tolist() == ["done", "cancelled"]
        return
    assert errors == f"interrupted; resume with:\n  samcontact resume {out}\n"
    kept = [file.name for file in (out / "checkpoints").glob("*.h5")]
    assert len(kept) == (1 if kind == "wear" else 2)
    assert invoke("resume", out, *OPTIONS).exit_code == 0


AGAIN = """
import os, signal
from samcontact.restart import file
write = file.write_tree
def pressed(*arguments):  # again while it keeps what it has
    os.kill(os.getpid(), signal.SIGINT)
    os.kill(os.getpid(), signal.SIGTERM)
    write(*arguments)
file.write_tree = pressed
"""
# A batch system signals the process and its group; the second signal arrives during the first.
TWICE = AGAIN + COMMAND.replace(
    """        os.kill(os.getpid(), int(sys.argv[2]))
""",
    """        try:
            os.kill(os.getpid(), int(sys.argv[2]))
        finally:
            os.kill(os.getpid(), int(sys.argv[2]))
            sys.stderr.write("twice, ")
""",
)


def test_repeated_ctrl_c(tmp_path):
    case, out = tmp_path / "case.toml", tmp_path / "out"
    case.write_text(WITHOUT_ERROR_ESTIMATE)
    with start(TWICE, 3, int(signal.SIGTERM), "run", case, "--output", out, *OPTIONS) as process:
        _, errors = process.communicate()
    assert process.returncode in (130, 143)
    assert errors == f"twice, interrupted; resume with:\n  samcontact resume {out}\n"
    assert len(list((out / "checkpoints").glob("*.h5"))) == 2


LOADING = """
import os, signal, sys
sys.argv[0] = sys.argv[1]
class Slow:  # what takes long to import
    def find_spec(self, name, path=None, target=None):
        if name == "numpy":
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, Slow())
from samcontact.commands.main import main
raise SystemExit("loaded")
"""


@pytest.mark.parametrize(("script", "silent"), [("/usr/bin/samcontact", True), ("mine.py", False)])
def test_ctrl_c_while_the_command_is_loaded(script, silent):
    with start(LOADING, script) as process:
        output, errors = process.communicate()
    assert process.returncode == -signal.SIGINT
    assert output == ""
    assert (errors == "") == silent  # a script of the user gets the KeyboardInterrupt


@pytest.mark.parametrize(
    ("script", "words", "expected"),
    [
        ("/home/me/bin/samcontact", ["python", "/home/me/bin/samcontact", "run"], True),
        ("-m", ["python", "-m", "samcontact", "run"], True),
        ("-m", ["python", "-X", "dev", "-m", "samcontact"], True),
        ("-m", ["python", "-m", "pytest", "samcontact"], False),
        ("-c", ["python", "-c", "import samcontact"], False),
        ("", ["python"], False),
        ("samcontact.py", ["python", "samcontact.py"], False),
    ],
)
def test_calls_of_the_command_are_recognised(script, words, expected):
    assert is_command(script, words) == expected


# A signal ignored by the parent, as under nohup, is also ignored by the command.
IGNORED = "import signal, sys; signal.signal(signal.SIGHUP, signal.SIG_IGN)\n" + COMMAND


def test_nohup(tmp_path):
    case, out = tmp_path / "case.toml", tmp_path / "out"
    case.write_text(WITHOUT_ERROR_ESTIMATE)
    command = (IGNORED, 2, int(signal.SIGHUP), "run", case, "--output", out, *OPTIONS)
    with start(*command) as process:
        _, errors = process.communicate()
    assert process.returncode == 0, errors
    assert (out / "results.nc").exists()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared tools of the fault tests: number of trials, and processes to be disturbed."""

import contextlib
import os
import subprocess
import sys
import tempfile
import time

import pytest

# Trials: in every run of the tests, and with the marker `slow`.
TRIALS = {
    "kill: run": (1, 50),
    "kill: wear": (1, 50),
    "kill: asperities": (1, 50),
    "kill: sweep": (1, 50),
    "kill: kinds of runs": (1, 50),
    "full disk": (3, 200),
    "interrupt: step": (3, 80),
    "interrupt: run": (2, 50),
    "stop: command": (1, 25),
    "memory: estimates": (11, 21),
    "memory: refusals": (12, 12),
    "threads": (3, 20),
}


def with_trials(name):
    """Run a test with `count` trials, and as a slow test with more."""
    few, many = TRIALS[name]
    slow = pytest.param(many, marks=pytest.mark.slow, id="many")
    return pytest.mark.parametrize("count", [pytest.param(few, id="few"), slow])


def with_trials_of_each(names):
    """Run a test for each name, with `count` trials, and as a slow test with more."""
    few = [pytest.param(name, TRIALS[name][0], id=f"{name}-few") for name in names]
    many = [
        pytest.param(name, TRIALS[name][1], marks=pytest.mark.slow, id=f"{name}-many")
        for name in names
    ]
    return pytest.mark.parametrize(("name", "count"), [*few, *many])


def start(script, *arguments, **options):
    """Start a single-threaded Python process."""
    return subprocess.Popen(
        [sys.executable, "-c", script, *map(str, arguments)],
        env=os.environ | {"OMP_NUM_THREADS": "1"},
        stdout=subprocess.PIPE,
        text=True,
        **{"stderr": subprocess.PIPE} | options,
    )


def finished(script, *arguments):
    """Return the output of a process, which must end without an error."""
    process = start(script, *arguments)
    output, errors = process.communicate()
    assert process.returncode == 0, errors
    return output


NURSERY = """
import os, sys, traceback
for line in sys.stdin:
    wait, go = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.read(wait, 1)  # its number comes first
            print("result", computed(line.strip()), flush=True)
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(0)
    print("child", child, flush=True)
    os.write(go, b".")
    os.close(wait), os.close(go)
    os.waitpid(child, 0)
    print("ended", flush=True)
"""


class Nursery:
    """Process with all imports done, which forks to call `computed(argument)` of a script."""

    def __init__(self, script):
        # An unread pipe is full after many interrupts, and would block its writer.
        self.errors = tempfile.TemporaryFile("w+")  # noqa: SIM115
        self.process = start(script + NURSERY, stdin=subprocess.PIPE, stderr=self.errors)

    def run(self, argument, seconds=None, number=None):
        """Return the result and its time; after these seconds the child gets a signal."""
        self.process.stdin.write(f"{argument}\n")
        self.process.stdin.flush()
        word, child = self._line()
        assert word == "child", self.message()
        begun, result = time.perf_counter(), None
        if seconds is not None:
            time.sleep(seconds)
            with contextlib.suppress(ProcessLookupError):  # the child has already ended
                os.kill(int(child), number)
        while (line := self._line())[0] != "ended":
            result = line[1]
        return result, time.perf_counter() - begun

    def _line(self):
        word, _, rest = self.process.stdout.readline().strip().partition(" ")
        return word, rest

    def message(self):
        """Return the end of the standard error output."""
        self.errors.seek(0)
        return self.errors.read()[-4000:]

    def close(self):
        self.process.communicate()
        self.errors.close()

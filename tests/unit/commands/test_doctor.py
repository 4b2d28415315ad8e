# SPDX-License-Identifier: GPL-3.0-or-later
"""The command doctor: correct versions, and detection of a broken installation."""

import os
import platform
import re
import subprocess
import sys
from importlib import metadata

import numpy as np
import pytest
from click.testing import CliRunner

import samcontact as sc
from samcontact.commands import self_check
from samcontact.commands.main import main

LINE = re.compile(r"(ok|failed) +(.+): (\S+), limit ([≤≥]) (\S+)")


def invoke():
    return CliRunner().invoke(main, ["doctor"])


def verdict_lines(text):
    """Return result, name, number, sense and limit of each line of the self-test."""
    return [LINE.fullmatch(line).groups() for line in text.split("\n\n")[1].splitlines()]


def test_a_sound_installation():
    outcome = invoke()
    assert outcome.exit_code == 0, outcome.output
    lines = verdict_lines(outcome.stdout)
    assert len(lines) == 7
    for word, name, number, sense, limit in lines:
        assert word == "ok", name
        value, bound = float(number), float(limit)
        assert value >= bound if sense == "≥" else value <= bound
    assert {name.split(":")[0] for _, name, *_ in lines} == {
        "Hertz",
        "elastic-plastic",
        "checkpoint",
    }


def test_versions():
    message = dict(self_check.installation())
    assert message["samcontact"] == sc.__version__
    assert message["Python"].startswith(platform.python_version())
    assert message["numpy"] == np.__version__
    assert message["vtk"] == metadata.version("vtk")
    assert re.match(r"\d+\.\d+\.\d+.*, plans by estimate", message["FFTW"])
    assert re.search(r"(GCC|clang).*\d+\.\d+", message["compiler"])
    assert "missing" not in " ".join(message.values())


def test_threads_are_those_of_the_environment():
    code = (
        "from samcontact.commands import self_check\n"
        "print(dict(self_check.installation())['threads'])"
    )
    found = subprocess.run(
        [sys.executable, "-c", code],
        env=os.environ | {"OMP_NUM_THREADS": "3"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert found.stdout == f"3 of {os.cpu_count()} processors (OMP_NUM_THREADS=3)\n"


def test_threads_are_never_thousands():
    """The number of threads is limited: thousands would wait for each other without end."""
    code = """
import os, samcontact as sc
from samcontact.commands import self_check
grid = sc.Grid(200, 200, 1e-5, 1e-5)
steel = sc.Material.elastic(210e9, 0.3)
sc.ContactSolver(grid, steel, steel).solve(sc.surfaces.paraboloid(grid, 7.5e-3), load=300.0)
print(len(os.listdir("/proc/self/task")), "OMP_THREAD_LIMIT" in os.environ)
print(dict(self_check.installation())["threads"])
"""
    most = 8 * os.cpu_count()
    environment = {k: v for k, v in os.environ.items() if not k.startswith("OMP_")}
    found = subprocess.run(
        [sys.executable, "-c", code],
        env=environment
        | {"OMP_NUM_THREADS": "3000", "OMP_DYNAMIC": "false", "OPENBLAS_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        check=True,
    )
    threads, message = found.stdout.splitlines()
    assert threads == f"{most} False"
    assert message.startswith(f"{most} of {os.cpu_count()} processors (OMP_NUM_THREADS=3000")


@pytest.mark.parametrize(
    ("flags", "level"),
    [
        ("sse2", "x86-64 (SSE2)"),
        ("sse2 avx2 bmi1 bmi2 f16c fma abm movbe", "x86-64-v3 (AVX2)"),
        # the lower level has to be complete too
        ("sse2 avx512f avx512bw avx512cd avx512dq avx512vl", "x86-64 (SSE2)"),
        (
            "avx2 bmi1 bmi2 f16c fma abm movbe avx512f avx512bw avx512cd avx512dq avx512vl",
            "x86-64-v4 (AVX-512)",
        ),
    ],
)
def test_level_of_the_processor(flags, level, monkeypatch):
    monkeypatch.setattr(platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(
        self_check.Path, "read_text", lambda self: f"model\t: 1\nflags\t\t: {flags}\n"
    )
    assert self_check._simd() == level


def test_an_absent_library_is_named_with_its_extra(monkeypatch):
    def version(name):
        if name == "vtk":
            raise metadata.PackageNotFoundError(name)
        return "1.0"

    monkeypatch.setattr(metadata, "version", version)
    outcome = invoke()
    assert outcome.exit_code == 0  # it is optional
    assert "absent (export for ParaView): pip install samcontact[vtk]" in outcome.stdout


def failing(monkeypatch, name, value):
    """Return the lines of a self-test in which a property of states is wrong."""
    monkeypatch.setattr(sc.State, name, property(lambda self: value))
    outcome = invoke()
    assert outcome.exit_code == 1
    return {name for word, name, *_ in verdict_lines(outcome.stdout) if word == "failed"}


def test_wrong_numbers_fail(monkeypatch):
    assert failing(monkeypatch, "approach", 1.0) == {"Hertz: relative error of the approach"}


def test_residuals_beyond_the_tolerance_fail(monkeypatch):
    failed = failing(monkeypatch, "plastic_strain_residual", 1e-3)
    assert failed == {"elastic-plastic: plastic-strain residual"}


def test_wrong_pressures_fail(monkeypatch):
    assert failing(monkeypatch, "pressure", np.ones((15, 15))) == {
        "Hertz: relative error of the maximum pressure",
        "elastic-plastic: load balance",
    }


def test_ctrl_c_ends_the_doctor(monkeypatch):
    def stopped():
        raise KeyboardInterrupt

    monkeypatch.setattr(self_check, "self_check", stopped)
    outcome = invoke()
    assert (outcome.exit_code, outcome.stderr) == (130, "interrupted\n")


def test_an_error_is_reported_and_other_checks_continue(monkeypatch):
    def refuse(self, path):
        raise OSError("disk full")

    monkeypatch.setattr(sc.Simulation, "save", refuse)
    outcome = invoke()
    assert outcome.exit_code == 1
    last = outcome.stdout.splitlines()[-1]
    assert last == "failed  checkpoint: OSError: disk full: nan, limit ≤ 0"
    assert outcome.stdout.count("\nok ") == 6

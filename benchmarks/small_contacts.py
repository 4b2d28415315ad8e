# SPDX-License-Identifier: GPL-3.0-or-later
"""Small contacts: share of the time outside the core, start of Python, and one command."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import samcontact as sc

from .harness import Meter, Task
from .steel import ELASTIC, LOAD, RADIUS, balls, hertz
from .study import ROOT

NAME = "small_contacts"
TITLE = "Small contacts"
HIDDEN_COLUMNS = ("memory_MB", "cells")
CASES = ("elastic contact", "partial slip", "ball that yields")
PROGRAMS = ("numpy", "samcontact")
TRIES = 5
SECONDS = 3
LIBRARIES = ("_core.", "libfftw", "libgomp", "libm", "libc", "libstdc++", "[kernel", "[vdso")
"""Parts of the names of the core and of the libraries that it calls."""
CASE = """
title = "small"
[grid]
nx = 64
ny = 64
dx = 20e-6
dy = 20e-6
[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[[path]]
load = 500.0
increments = 1
"""


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (32, 64) if quick else (32, 64, 128)
    contacts = [
        Task(NAME, case, "solution", "solve", {"case": case, "n": n})
        for case in CASES
        for n in sizes
    ]
    imports = [
        Task(NAME, f"import {name}", "process", "start", {"name": name}) for name in PROGRAMS
    ]
    return [*contacts, *imports, Task(NAME, "samcontact run --no-figures", "process", "command")]


def contact(case: str, n: int) -> Callable[[], object]:
    """Return a solution on about n x n cells to repeat, of a new solver or simulation."""
    if case == CASES[2]:
        return lambda: balls(int(n / 2.5)).step(load=LOAD)
    d = 2.6 * hertz().a / n
    grid = sc.Grid(n, n, d, d)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    if case == CASES[0]:
        return lambda: sc.ContactSolver(grid, ELASTIC, ELASTIC).solve(gap, load=LOAD)
    law, force = sc.Coulomb(0.3), (0.15 * LOAD, 0.0)
    return lambda: sc.ContactSolver(grid, ELASTIC, ELASTIC, law).solve(
        gap, load=LOAD, tangential_load=force
    )


def solve(meter: Meter, case: str, n: int) -> dict[str, Any]:
    """Measure a solution, and the share of Python and NumPy in its time by sampling."""
    work = contact(case, n)
    work()
    meter(work)
    return {"cells": n * n, "across": n, "outside the core [%]": 100 * sampled(case, n)}


def sampled(case: str, n: int) -> float:
    """Return the share of the samples of `perf` in Python and NumPy of a repeated contact."""
    words = [sys.executable, "-m", f"benchmarks.{NAME}", case, str(n)]
    with (
        tempfile.TemporaryDirectory() as folder,
        subprocess.Popen(words, stdout=subprocess.PIPE, cwd=ROOT) as repeated,
    ):
        try:
            assert repeated.stdout is not None
            repeated.stdout.readline()  # all modules are loaded
            data = str(Path(folder) / "perf.data")
            record = ["perf", "record", "-q", "-F", "2000", "-o", data, "-p", str(repeated.pid)]
            subprocess.run([*record, "--", "sleep", str(SECONDS)], check=True, capture_output=True)
        finally:
            repeated.kill()
        report = ["perf", "report", "-i", data, "--sort", "dso", "--stdio", "-q"]
        found = subprocess.run(report, check=True, capture_output=True, text=True).stdout
    return share_of_python(found)


def share_of_python(report: str) -> float:
    """Return the share of all samples that are neither in the core nor in its libraries."""
    inside = outside = 0.0
    for line in report.splitlines():
        percent, _, library = line.strip().partition("%")
        if library:
            ours = any(name in library for name in LIBRARIES)
            inside, outside = inside + ours * float(percent), outside + (not ours) * float(percent)
    return outside / (inside + outside)


def repeat(case: str, n: int) -> None:
    """Repeat a contact until the process is killed."""
    warnings.simplefilter("ignore")
    work = contact(case, n)
    work()
    print("ready", flush=True)
    while True:
        work()


def of_process(words: list[str]) -> float:
    """Return the smallest processor time of a new Python process [s].

    A process before it stores the compiled modules.
    """
    with tempfile.TemporaryDirectory() as folder:
        kept = {"PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
        times = []
        for _ in range(TRIES + 1):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run(
                [sys.executable, *words], check=True, capture_output=True, env=os.environ | kept
            )
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(times[1:])


def start(meter: Meter, name: str) -> dict[str, Any]:
    """Measure a process that imports a package."""
    return {"processor time [s]": meter(lambda: of_process(["-c", f"import {name}"]))}


def command(meter: Meter) -> dict[str, Any]:
    """Measure `samcontact run` of a contact on 64 x 64 cells, without figures."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "small.toml"
        file.write_text(CASE, encoding="utf-8")
        words = ["-m", "samcontact", "run", str(file), "--no-figures", "--quiet"]
        spent = meter(lambda: of_process([*words, "--output", str(Path(folder) / "results")]))
    return {"processor time [s]": spent}


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return sentences on the largest share, and on the processes."""
    shares = [row["outside the core [%]"] for row in rows if row.get("across", 0) >= 64]
    times = {row["case"]: row["processor time [s]"] for row in rows if "processor time [s]" in row}
    lines = []
    if shares:
        lines.append(
            f"From 64 × 64 cells on, at most {max(shares):.0f} % of the time is outside the core."
        )
    if "import samcontact" in times and "import numpy" in times:
        lines.append(
            f"`import samcontact` takes {times['import samcontact']:.2f} s of processor time, of "
            f"which NumPy takes {times['import numpy']:.2f} s."
        )
    if "samcontact run --no-figures" in times:
        lines.append(
            f"`samcontact run` takes {times['samcontact run --no-figures']:.2f} s, most of it to "
            "load xarray with pandas and to build the checks of case files."
        )
    return [" ".join(lines)] if lines else []


if __name__ == "__main__":
    repeat(sys.argv[1], int(sys.argv[2]))

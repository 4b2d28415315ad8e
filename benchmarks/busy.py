# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor and wall time of one and two threads while other processes load the machine.

Processes with one and with two threads alternate, so that other work of the machine affects both.
"""

from __future__ import annotations

import contextlib
import os
import statistics
import subprocess
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import samcontact as sc

from .harness import ROOT, Meter, Task

NAME = "busy"
TITLE = "Busy machine"
HIDDEN_COLUMNS = ("memory_MB",)
BUSY_PROCESSES = (0, 3, 8)
ROUNDS = 5
GOAL = 1.3
"""Maximum processor time of two threads over that of one."""


def tasks(quick: bool, folder: Path) -> list[Task]:
    rounds = 1 if quick else ROUNDS
    return [
        Task(NAME, case, f"{count} busy processes", "compare",
             {"case": case, "count": count, "rounds": rounds})
        for count in BUSY_PROCESSES
        for case in CASES
    ]  # fmt: skip


def balls() -> None:
    """Load two balls in four increments on 41 x 41 x 24 cells, three times."""
    for _ in range(3):
        grid = sc.Grid(41, 41, 25e-6, 25e-6, 24, 20e-6)
        steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
        gap = sc.surfaces.paraboloid(grid, 7.5e-3)
        elastic = sc.Material.elastic(210e9, 0.3)
        simulation = sc.Simulation(grid, elastic, steel, gap, on_border="warn")
        for load in (300.0, 600.0, 900.0, 1200.0):
            simulation.step(load=load)


def pressed(load: float) -> tuple[sc.Simulation, list[dict[str, float]]]:
    """Load and unload a ball."""
    grid = sc.Grid(25, 25, 40e-6, 40e-6, 14, 35e-6)
    steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    simulation = sc.Simulation(grid, sc.Material.elastic(210e9, 0.3), steel, gap)
    return simulation, [{"load": 0.5 * load}, {"load": load}, {"load": 0.0}]


def searches() -> None:
    """Search for the loads that cause two given values of the maximum plastic strain."""
    for strain in (0.001, 0.002):
        sc.find_load(
            pressed, "max_equivalent_plastic_strain_body2", strain, largest_load=5e3, progress=False
        )


CASES: dict[str, Callable[[], None]] = {"three balls on a flat": balls, "two find_load": searches}


def compare(meter: Meter, case: str, count: int, rounds: int) -> dict[str, Any]:
    """Measure one and two threads in turn next to `count` busy processes; return the ratios."""
    with background_load(count):
        pairs = meter(lambda: [[measured(case, n) for n in (1, 2)] for _ in range(rounds)])
    (clock, processor), (clock2, processor2) = (
        [statistics.median(pair[k][quantity] for pair in pairs) for quantity in (0, 1)]
        for k in (0, 1)
    )
    return {"wall time 2 / 1": clock2 / clock, "processor time 2 / 1": processor2 / processor}


def measured(case: str, threads: int) -> tuple[float, float]:
    """Return wall and processor time [s] of a case in a new process, without process start."""
    done = subprocess.run(
        [sys.executable, "-m", f"benchmarks.{NAME}", case],
        env=os.environ | {"OMP_NUM_THREADS": str(threads), "OPENBLAS_NUM_THREADS": "1"},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    clock, processor = map(float, done.stdout.split())
    return clock, processor


def solve(case: str) -> None:
    """Measure a case, after a first solution that loads all libraries."""
    warnings.simplefilter("ignore")
    balls()
    clock, processor = time.perf_counter(), time.process_time()
    CASES[case]()
    print(time.perf_counter() - clock, time.process_time() - processor)


@contextlib.contextmanager
def background_load(count: int) -> Iterator[None]:
    """Load `count` processors with processes that do nothing else."""
    processes = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for process in processes:
            process.kill()
            process.wait()


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return a sentence on the largest ratio next to busy processes."""
    loaded = [row for row in rows if not str(row["method"]).startswith("0 ")]
    if not loaded:
        return []
    worst = max(row["processor time 2 / 1"] for row in loaded)
    return [
        f"While other processes are busy, two threads take at most {worst:.2f} times the processor "
        "time of one."
    ]


if __name__ == "__main__":
    solve(sys.argv[1])

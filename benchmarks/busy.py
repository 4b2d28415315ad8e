# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor and wall time of one and two threads while other processes load the machine.

Runs with one and with two threads alternate, so that other work of the machine affects both. While
other processes are busy, two threads should cost at most 1.3 times the processor time of one
thread, and not take longer.
"""

from __future__ import annotations

import contextlib
import os
import statistics
import subprocess
import sys
import time
import warnings
from collections.abc import Iterator

import click

import samcontact as sc

BUSY_PROCESSES = (0, 3, 8)
CASES = ("three balls on a flat", "two find_load")


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


def measured(case: str, threads: int) -> tuple[float, float]:
    """Return wall and processor time [s] of a case in a new process, without process start."""
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.busy", "--case", case],
        env=os.environ | {"OMP_NUM_THREADS": str(threads), "OPENBLAS_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        check=True,
    )
    clock, processor = map(float, done.stdout.split())
    return clock, processor


def solve(case: str) -> None:
    """Measure a case, after a first solution that loads all libraries."""
    warnings.simplefilter("ignore")
    work = balls if case == CASES[0] else searches
    balls()
    clock, processor = time.perf_counter(), time.process_time()
    work()
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


@click.command(help=__doc__)
@click.argument("rounds", default=5)
@click.option("--case", hidden=True, help="Only measure this case, in this process.")
def main(rounds: int, case: str | None) -> None:
    if case:
        solve(case)
        return
    print(
        "busy  case                   clock of 1 [s]  clock 2/1  processor of 1 [s]  processor 2/1"
    )
    for busy in BUSY_PROCESSES:
        for case in CASES:
            with background_load(busy):
                pairs = [[measured(case, threads) for threads in (1, 2)] for _ in range(rounds)]
            medians = [
                [statistics.median(pair[k][quantity] for pair in pairs) for k in (0, 1)]
                for quantity in (0, 1)
            ]
            (clock, clock2), (processor, processor2) = medians
            print(
                f"{busy:4d}  {case:22} {clock:14.2f}  {clock2 / clock:9.2f}  {processor:18.2f}  "
                f"{processor2 / processor:13.2f}",
                flush=True,
            )


if __name__ == "__main__":
    main(prog_name="python -m benchmarks.busy")

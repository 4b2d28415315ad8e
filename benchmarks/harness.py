# SPDX-License-Identifier: GPL-3.0-or-later
"""Measurements in new processes: time, peak memory and solver counters.

A part is a module with a NAME, a TITLE, a function `tasks(quick, folder)` that lists its
measurements, and functions `f(meter, **arguments)`, whose names the tasks contain. Each of these
functions prepares a case, passes the work to be measured to the meter, and returns a dictionary:
"cells", "errors" (by quantity) and other numbers for the table.
"""

from __future__ import annotations

import importlib
import json
import math
import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import scipy.ndimage  # noqa: F401  (loaded by the first solve of a process: no part of its time)

from .study import ROOT

T = TypeVar("T")
MAX_REPEATED_SECONDS = 0.5  # s; shorter runs are timed three times, and the minimum counts


@dataclass(frozen=True)
class Task:
    """Measurement of a case by a method."""

    part: str
    case: str
    method: str
    function: str
    """Name of a function in the part's module."""
    arguments: dict[str, Any] = field(default_factory=dict)
    """Keyword arguments that can be written as JSON; tasks may differ only in these arguments."""
    reference: str = ""
    """Method by whose time the times of tasks with equal case and arguments are divided."""
    threads: int = 0
    """Number of threads of this task; 0 for the common number of all tasks."""
    rounds: int = 1
    """Number of repetitions, each in a new process; the minimum time counts."""
    hidden: bool = False
    """Whether the task only prepares data for other tasks and has no row in the tables."""


def peak_memory() -> int:
    """Return the peak memory of this process so far [bytes].

    The peak is read from /proc if available, because a process inherits ru_maxrss from its parent.
    """
    status = Path("/proc/self/status")
    if status.exists():
        for line in status.read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit


class Meter:
    """Meter of the time of calls, and of the memory that the calls add to the process."""

    def __init__(self) -> None:
        self.time = 0.0
        self.cpu = 0.0  # processor time [s] of all threads
        self.memory = 0

    def __call__(self, work: Callable[[], T]) -> T:
        """Run the work, repeatedly if it is short, and store time and memory in the meter."""
        before = peak_memory()
        times, processor = [], []
        while len(times) < (3 if sum(times) < MAX_REPEATED_SECONDS else 1):
            start, used = time.perf_counter(), time.process_time()
            result = work()
            times.append(time.perf_counter() - start)
            processor.append(time.process_time() - used)
            if len(times) == 1:
                self.memory = max(peak_memory() - before, 0)  # never negative
        self.time, self.cpu = min(times), min(processor)
        return result


def largest_error(computed: Any, reference: Any) -> float:
    """Return the maximum difference relative to the maximum reference value."""
    return float(np.abs(np.subtract(computed, reference)).max() / np.abs(reference).max())


def rms_error(computed: Any, reference: Any) -> float:
    """Return the rms difference relative to the rms of the reference."""
    difference = np.subtract(computed, reference)
    return float(np.sqrt(np.mean(difference**2) / np.mean(np.square(reference))))


def relative_error(computed: float, reference: float) -> float:
    """Return the unsigned relative error of a number."""
    return abs(float(computed) / float(reference) - 1)


def work_of(simulation: Any) -> dict[str, int]:
    """Return the counters of a Simulation as columns."""
    counters = simulation.counters
    found = {
        "contact_iterations": counters["contact_iterations"],
        "volume_applications": counters["plastic_iterations"],
    }
    if "operator_applications" in counters:
        found["surface_applications"] = counters["operator_applications"]
    return found


def run_here(task: Task) -> dict[str, Any]:
    """Run the measurement in this process."""
    meter = Meter()
    function = getattr(importlib.import_module(f"benchmarks.{task.part}"), task.function)
    found = function(meter, **task.arguments)
    row: dict[str, Any] = {"part": task.part, "case": task.case, "method": task.method}
    row["options"] = options_text(task)
    errors = found.pop("errors", {})
    row.update(found, time_s=meter.time, memory_MB=meter.memory / 1e6)
    row.update({f"error: {quantity}": value for quantity, value in errors.items()})
    return row


def options_text(task: Task) -> str:
    """Return the arguments of a task as text for a table, without file paths."""
    shown = {k: v for k, v in task.arguments.items() if not str(v).endswith(".npz")}
    return ", ".join(f"{k}={v}" for k, v in shown.items())


def measure(task: Task) -> dict[str, Any]:
    """Run the measurement in a new process; a failure becomes a row with its message."""
    command = [sys.executable, "-m", "benchmarks.harness", json.dumps(task.__dict__)]
    threads = {"OMP_NUM_THREADS": str(task.threads)} if task.threads else {}
    done = subprocess.run(command, cwd=ROOT, capture_output=True, env=os.environ | threads)
    if done.returncode == 0:
        row: dict[str, Any] = json.loads(done.stdout.decode().splitlines()[-1])
        return row
    lines = done.stderr.decode().strip().splitlines() or [f"exit code {done.returncode}"]
    row = {"part": task.part, "case": task.case, "method": task.method}
    return {**row, "options": options_text(task), "failed": lines[-1]}


def same_but_method(task: Task) -> tuple[str, str]:
    """Return a key shared by tasks that differ only in their method."""
    rest = {k: v for k, v in task.arguments.items() if k != "method"}
    return task.case, json.dumps(rest, sort_keys=True)


def run_tasks(
    tasks: list[Task], report: Callable[[str], None] = lambda line: None
) -> list[dict[str, Any]]:
    """Measure tasks in order and add the ratios of times."""
    # All tasks are repeated in rounds, so that a slow phase of the machine affects all of them.
    best: list[dict[str, Any]] = [{} for _ in tasks]
    for n in range(max((task.rounds for task in tasks), default=0)):
        for at, task in enumerate(tasks):
            if n >= task.rounds:
                continue
            row = measure(task)
            outcome = row.get("failed") or f"{row['time_s']:.3g} s"
            report(f"{task.part}: {task.case}, {task.method}, {row['options']}: {outcome}")
            if row.get("time_s", 0.0) < best[at].get("time_s", math.inf):
                best[at] = row
    rows, times = [], {}
    for task, row in zip(tasks, best, strict=True):
        times[(*same_but_method(task), task.method)] = row.get("time_s")
        if not task.hidden or "failed" in row:
            rows.append((task, row))
    for task, row in rows:
        reference = times.get((*same_but_method(task), task.reference))
        if reference and "time_s" in row:
            row["time_ratio"] = row["time_s"] / reference
    return [row for _, row in rows]


if __name__ == "__main__":
    print(json.dumps(run_here(Task(**json.loads(sys.argv[1])))))

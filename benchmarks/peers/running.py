# SPDX-License-Identifier: GPL-3.0-or-later
"""Measurements in separate processes: `python -m benchmarks.peers.running CODE`."""

from __future__ import annotations

import ctypes
import gc
import importlib
import json
import os
import resource
import signal
import subprocess
import sys
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ..harness import ROOT, peak_memory, relative_error, rms_error
from . import problems

# Environment for one thread: OpenMP of the codes, BLAS of NumPy.
ONE_THREAD = {
    name: "1"
    for name in (
        "OMP_NUM_THREADS",
        "OPENBLAS_NUM_THREADS",
        "MKL_NUM_THREADS",
        "NUMEXPR_NUM_THREADS",
    )
}
TIMEOUT_MARK = "more than"
REPEAT_FOR = 0.5  # total time [s] of repeated solves after set-up
REPEATS = 20
# Tolerances of the references: of one code where all solve the same discrete problem, else of each.
REFERENCE_TOL = {"samcontact": 1e-12}
REFERENCE_TOL_PERIODIC = {"samcontact": 1e-12, "tamaas": 1e-12}
REFERENCE_TOL_SLIP = {"samcontact": 1e-11}
REFERENCE_TOL_PLASTIC = {"samcontact": 1e-9, "tamaas": 1e-7}
# Cells across of a grid of samcontact that shows the errors of the others.
MIN_REFINEMENT = 3
MAX_CELLS = {"plastic": 96, "periodic": 4096, "periodic_plastic": 120}
# Codes as columns: module and the class for elastic contact.
CODES = {
    "samcontact": ("code_samcontact", "Contact"),
    "tamaas": ("code_tamaas", "Contact"),
    "ContactMechanics": ("code_contact_mechanics", "Contact"),
    "ASPHER": ("code_aspher", "Contact"),
    "ASPHER, mixed": ("code_aspher", "Mixed"),
    "ASPHER, H2": ("code_aspher", "Hierarchical"),
}
PACKAGES = {"tamaas": "tamaas", "ContactMechanics": "ContactMechanics", "ASPHER": "aspher"}


@dataclass
class Outcome:
    """Results of one code for one problem."""

    pressure: np.ndarray
    counts: dict[str, float]
    approach: float | None = None
    plastic_strain: np.ndarray | None = None
    stress: np.ndarray | None = None
    shear: np.ndarray | None = None
    setup_share: float = 0.0
    """Fraction of the solve time that the code reports as set-up [-]."""


@dataclass(frozen=True)
class Task:
    """Measurement of one code on a problem with n cells across; each code has its own tolerance."""

    problem: str
    case: str
    n: int
    code: str
    tol: float
    folder: str = ""
    """Folder of the references; tasks that differ only in folder or clock are equal."""
    clock: str = "perf_counter"
    """Name of the clock, a function of the module `time`."""

    @property
    def key(self) -> str:
        return f"{self.problem}|{self.case}|{self.n}|{self.code}|{self.tol:g}"


def code_class(code: str, problem: str) -> Any:
    """Return the class that solves a problem with a code; ImportError if the code is missing."""
    module, contact = CODES[code]
    kinds = dict.fromkeys(problems.PLASTIC, "Plasticity") | {"stress": "Stress", "slip": "Slip"}
    return getattr(
        importlib.import_module(f"benchmarks.peers.{module}"), kinds.get(problem, contact)
    )


def tight(problem: str) -> dict[str, float]:
    """Return the tolerance of the reference solutions of a problem, by code."""
    if problem in problems.PLASTIC:
        return REFERENCE_TOL_PLASTIC
    if problem == "slip":
        return REFERENCE_TOL_SLIP
    return REFERENCE_TOL_PERIODIC if problem == "periodic" else REFERENCE_TOL


def reference_file(task: Task, code: str = "samcontact") -> Path:
    name = f"{task.problem}-{task.case or 'one'}-{task.n}-{code}.npz"
    return Path(task.folder) / name.replace(" ", "")


def fine_errors(task: Task, found: Outcome) -> dict[str, float]:
    """Return errors relative to the solution on the finest grid, at the common points."""
    file = reference_file(replace(task, n=MAX_CELLS.get(task.problem, 0)))
    if "periodic" not in task.problem or not file.exists():
        return {}
    with np.load(file) as finest:
        fine = finest["pressure"]
    step = fine.shape[0] // task.n
    if step < MIN_REFINEMENT:
        return {}
    # Points of the rough surface start at 0; the other points are cell centres.
    shared = slice(0 if task.problem == "periodic" else step // 2, None, step)
    area = relative_error(np.mean(found.pressure > 0), np.mean(fine > 0))
    return {
        "pressure, finest": rms_error(found.pressure, fine[shared, shared]),
        "contact area, finest": area,
    }


def elastic_errors(task: Task, problem: problems.Elastic, found: Outcome) -> dict[str, float]:
    """Return errors relative to the reference solution, and to the exact solution if known."""
    code = task.code if task.code in tight(task.problem) else "samcontact"
    file = reference_file(task, code)
    errors = fine_errors(task, found)
    if file.exists():
        with np.load(file) as converged:
            errors["pressure"] = rms_error(found.pressure, converged["pressure"])
            if found.shear is not None:
                errors["shear"] = rms_error(found.shear, converged["shear"])
    if task.problem == "hertz":
        theory, grid = problems.hertz_theory(), problem.grid
        exact = theory.pressure(grid.x[:, None], grid.y[None, :])
        errors["pressure, exact"] = rms_error(found.pressure, exact)
        errors["largest pressure, exact"] = relative_error(found.pressure.max(), theory.p0)
        if found.approach is not None:
            errors["approach, exact"] = relative_error(found.approach, theory.approach)
    return errors


def prepare(task: Task) -> tuple[Any, tuple[Any, ...]]:
    """Return the problem of a task, and the arguments of the class that solves the problem."""
    if task.problem in problems.PLASTIC:
        periodic = "xy" if task.problem == "periodic_plastic" else ""
        plastic = problems.plastic(task.n, periodic=periodic)
        return plastic, (plastic, task.tol)
    if task.problem == "stress":
        plastic = problems.plastic(task.n, problems.STRESS_SIDE)
        theory, grid = sphere_of(plastic), plastic.grid
        pressure = theory.pressure(grid.x[:, None], grid.y[None, :])
        return plastic, (plastic, pressure, depths(plastic))
    elastic = problems.elastic(task.problem, task.case, task.n)
    return elastic, (elastic, task.tol)


def depths(problem: problems.Plastic) -> np.ndarray:
    """Return the depths of the planes between layers, starting with the surface."""
    return np.linspace(0.0, problem.depth, problem.layers + 1)


def sphere_of(problem: problems.Plastic) -> Any:
    return problems.sc.hertz.point(R=problem.radius, E_star=problems.E_STAR, load=problem.load)


def stress_errors(problem: problems.Plastic, found: Outcome) -> dict[str, float]:
    """Return the error of the stress within 1.5 contact radii below the surface."""
    assert found.stress is not None
    grid, z = problem.grid, depths(problem)[1:]
    half = round(1.5 * problem.n / problems.STRESS_SIDE)
    middle = slice(problem.n // 2 - half, problem.n // 2 + half)
    x, y = grid.x[middle, None, None], grid.y[None, middle, None]
    exact = sphere_of(problem).stress(x, y, z[None, None, :], problems.NU)
    return {"stress": rms_error(found.stress[:, middle, middle, 1:], exact)}


def plastic_errors(task: Task, found: Outcome) -> dict[str, float]:
    """Return errors relative to the tightly converged solution of the same code and grid."""
    file = reference_file(task, task.code)
    errors = fine_errors(task, found)
    if not file.exists():
        return errors
    with np.load(file) as tight:
        return errors | {
            "pressure": rms_error(found.pressure, tight["pressure"]),
            "plastic strain": rms_error(found.plastic_strain, tight["plastic_strain"]),
        }


def errors_of(task: Task, problem: Any, found: Outcome) -> dict[str, float]:
    if task.problem == "stress":
        return stress_errors(problem, found)
    if task.problem in problems.PLASTIC:
        return plastic_errors(task, found)
    return elastic_errors(task, problem, found)


def run_here(task: Task) -> dict[str, Any]:
    """Set up and solve a task; repeat the solution without set-up if it takes little time."""
    warnings.simplefilter("ignore")
    kind = code_class(task.code, task.problem)
    problem, arguments = prepare(task)
    clock = getattr(time, task.clock)
    before = peak_memory()
    start = clock()
    code = kind(*arguments)
    built = clock()
    found = code.solve()
    first = clock() - start
    memory = peak_memory()
    # A plastic body keeps its strain, so the solve cannot be repeated.
    again = [] if task.problem in problems.PLASTIC else solve_again(code, first, clock)
    if task.tol == tight(task.problem).get(task.code):
        fields = {"pressure": found.pressure, "plastic_strain": found.plastic_strain}
        fields["shear"] = found.shear
        np.savez(
            reference_file(task, task.code), **{k: v for k, v in fields.items() if v is not None}
        )
    row = {
        "clock": task.clock,
        "with_setup_s": first,
        "setup_s": built - start + found.setup_share * first,
        "without_setup_s": typical(again, task.clock)
        or (first - (built - start)) * (1 - found.setup_share),
        "memory_MB": (memory - before) / 1e6,
        "peak_MB": memory / 1e6,
        "contact_fraction": float(np.mean(found.pressure > 0)),
        "largest_pressure": float(found.pressure.max()),
        "counts": found.counts,
        "errors": errors_of(task, problem, found),
    }
    if found.plastic_strain is not None:
        row["largest_plastic_strain"] = float(found.plastic_strain.max())
    return row


def typical(times: list[float], clock: str) -> float:
    """Return the minimum of wall times, or the mean of processor times (their clock is coarse)."""
    if not times:
        return 0.0
    return min(times) if clock == "perf_counter" else sum(times) / len(times)


def solve_again(code: Any, first: float, clock: Callable[[], float]) -> list[float]:
    """Return the times of solutions without set-up, repeated for about half a second in total."""
    times: list[float] = []
    min_count = 4 if first < 2.0 else 1 if first < 20.0 else 0
    while len(times) < min_count or (first < REPEAT_FOR > sum(times) and len(times) < REPEATS):
        start = clock()
        found = code.solve()
        times.append((clock() - start) * (1 - found.setup_share))
    return times


class Server:
    """Process that imports one code and forks for each measurement, to import only once."""

    def __init__(self, code: str) -> None:
        command = [sys.executable, "-m", "benchmarks.peers.running", code]
        environment = {**os.environ, **ONE_THREAD, "MPLBACKEND": "Agg"}
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(
            command, cwd=ROOT, env=environment, stdin=pipe, stdout=pipe, text=True
        )

    def run(self, task: Task, limit: float) -> dict[str, Any]:
        """Run a measurement; return its row, or a message if it fails or exceeds the time limit."""
        assert self.process.stdin
        assert self.process.stdout
        self.process.stdin.write(json.dumps([task.__dict__, limit]) + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        if not answer:
            raise RuntimeError(f"the process of {task.code} ended: {self.process.wait()}")
        row: dict[str, Any] = json.loads(answer)
        return row

    def close(self) -> None:
        with self.process:  # closes both pipes; the process ends when the first one closes
            pass


def own_memory() -> None:
    """Copy the memory shared with the parent process; a normal process shares no memory.

    The system would otherwise copy the memory page by page during the measurement, which takes a
    third of the time of a short solution.
    """
    gc.collect()
    page = os.sysconf("SC_PAGE_SIZE")
    with open("/proc/self/pagemap", "rb") as pagemap:
        for line in Path("/proc/self/maps").read_text().splitlines():
            span, access = line.split()[:2]
            if not access.startswith("rw"):
                continue
            first, end = (int(at, 16) for at in span.split("-"))
            pagemap.seek(8 * (first // page))
            entries = np.frombuffer(pagemap.read(8 * ((end - first) // page)), np.uint64)
            memory = (ctypes.c_char * (end - first)).from_address(first)
            for at in np.flatnonzero(entries >> np.uint64(63)) * page:  # pages in memory
                memory[at] = memory[at]


def measured_in_a_fork(task: Task, limit: float) -> dict[str, Any]:
    """Fork a process, solve the task in it, and return the row of results."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        seconds = max(1, round(limit))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        try:
            own_memory()
            row = run_here(task)
        except Exception as error:
            row = {"failed": f"{type(error).__name__}: {error}"[:200]}
        with os.fdopen(writing, "w") as file:
            json.dump(row, file)
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as file:
        text = file.read()
    _, status = os.waitpid(child, 0)
    if text:
        answer: dict[str, Any] = json.loads(text)
        return answer
    # The kernel ends a process beyond its limits by one of these signals.
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL):
        return {"failed": f"{TIMEOUT_MARK} {limit:g} s"}
    return {"failed": f"exit status {status}"}


def serve(code: str) -> None:
    """Read tasks from standard input, one per line, and measure each until the input ends."""
    importlib.import_module(f"benchmarks.peers.{CODES[code][0]}")
    for line in sys.stdin:
        task, limit = json.loads(line)
        print(json.dumps(measured_in_a_fork(Task(**task), limit)), flush=True)


if __name__ == "__main__":
    serve(sys.argv[1])

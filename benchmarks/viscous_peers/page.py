# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of creep of rough surfaces at equal error, in samcontact and tamaas."""

from __future__ import annotations

import importlib
import time
import warnings
from pathlib import Path as File
from typing import Any

import numpy as np

from ..study import Record, Study, table
from .problems import DURATION, MEAN_PRESSURE, RELAXING, Creep, error

TEXT = File(__file__).with_name("template.md")
CODES = ("samcontact", "tamaas")
ALLOWED = {64: (1e-2, 1e-3), 128: (1e-2, 1e-3), 256: (1e-2, 1e-3)}
"""Errors of the pressure at which times are compared, by the number of cells along a side."""
TOL = 1e-6
REFERENCE_STEPS, REFERENCE_TOL = 96, 1e-9
MAX_STEPS = 4096
ROUNDS = 2


def points(quick: bool) -> list[Record]:
    return [
        {"of": "creep", "n": n, "allowed": allowed}
        for n in (min(ALLOWED),) * quick or ALLOWED
        for allowed in (ALLOWED[n][:1] if quick else ALLOWED[n])
    ]


def reference(problem: Creep) -> np.ndarray:
    """Return the pressure at the end, extrapolated from two numbers of steps (second order)."""
    solve = importlib.import_module(f"{__package__}.code_samcontact").pressure_after
    coarse, fine = (
        solve(problem, steps, REFERENCE_TOL) for steps in (REFERENCE_STEPS, 2 * REFERENCE_STEPS)
    )
    return np.asarray((4 * fine - coarse) / 3)


def timed(solve: Any, problem: Creep, steps: int) -> tuple[float, np.ndarray]:
    """Return processor time and pressure."""
    start = time.process_time()
    pressure = solve(problem, steps, TOL)
    return time.process_time() - start, pressure


def run(of: str, n: int, allowed: float) -> list[Record]:
    """Return a record for each installed code, with the fewest steps (of powers of 2)."""
    warnings.simplefilter("ignore", UserWarning)
    problem = Creep(n)
    _ = problem.spectrum  # not part of the times
    exact = reference(problem)
    rows = []
    for name in CODES:
        try:
            solve = importlib.import_module(f"{__package__}.code_{name}").pressure_after
        except ImportError:
            continue
        steps = 1
        seconds, pressure = timed(solve, problem, steps)
        while error(pressure, exact) > allowed and steps < MAX_STEPS:
            steps *= 2
            seconds, pressure = timed(solve, problem, steps)
        for _ in range(ROUNDS - 1):
            seconds = min(seconds, timed(solve, problem, steps)[0])
        rows.append({
            "code": name, "steps": steps, "cpu_s": seconds, "error": error(pressure, exact),
            "contact": float((exact > 0).mean()),
        })  # fmt: skip
    for row in rows:
        row["ratio"] = row["cpu_s"] / rows[0]["cpu_s"]
    return rows


def times(records: list[Record]) -> str:
    """Return the table of all records."""
    lines = [
        [f"{row['n']} × {row['n']}", f"{row['allowed']:g}", row["code"], str(row["steps"]),
         f"{row['error']:.1e}", f"{row['cpu_s']:.3g}", f"{row['ratio']:.1f}"]
        for row in records
    ]  # fmt: skip
    return table(
        ["cells", "allowed error", "code", "increments", "error of the pressure", "time [s]",
         "time / samcontact"], lines,
    )  # fmt: skip


def page(records: list[Record]) -> str:
    finest = [row for row in records if row["n"] == max(ALLOWED)]
    return TEXT.read_text(encoding="utf-8").format(
        times=times(records),
        contact=f"{100 * finest[-1]['contact']:.0f}",
        relaxing=f"{RELAXING:g}",
        pressure=f"{MEAN_PRESSURE:g}",
        duration=f"{DURATION:g}",
        tol=f"{TOL:g}",
    )


STUDY = Study("viscous_peers", "Creep of rough surfaces, compared with tamaas.", points, run, page)

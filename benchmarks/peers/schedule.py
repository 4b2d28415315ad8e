# SPDX-License-Identifier: GPL-3.0-or-later
"""Order of the measurements, in which the codes alternate, and the file that stores them."""

from __future__ import annotations

import importlib
import json
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from . import problems
from .running import CODES, MAX_CELLS, PACKAGES, TIMEOUT_MARK, Server, Task, code_class, tight

SIZES = {
    "hertz": (64, 128, 256, 512, 1024),
    "rough": (256, 512, 1024, 2048),
    "plastic": (24, 32, 48),
    "stress": (48, 96, 192),
    "periodic": (128, 256, 512, 1024),
    "periodic_plastic": (24, 40),
    "slip": (32, 64, 128),
}
LARGER = {("rough", "light"): (4096,)}  # within the memory of a desktop computer
QUICK_SIZES = {"hertz": (64, 128), "rough": (64, 128), "plastic": (12,), "stress": (48,)}
QUICK_SIZES |= {"periodic": (128,), "periodic_plastic": (12,), "slip": (32,)}
PROBLEMS = tuple(SIZES)
STORED = Path(__file__).with_name("results.json")
BOTH = ("samcontact", "tamaas")  # for problems with a volume or a period
MAX_REPEATED_SECONDS = 3.0  # s; longer runs are measured once
GROWTH = 4.0  # minimum factor of time from one size to the next


def cases(problem: str) -> tuple[str, ...]:
    named = {"rough": problems.ROUGH_CASES, "periodic": problems.PERIODIC_CASES}
    named["slip"] = dict.fromkeys(problems.PULLED)
    return tuple(named.get(problem, ("",)))


def sizes(problem: str, case: str, *, quick: bool = False) -> tuple[int, ...]:
    if quick:
        return QUICK_SIZES[problem]
    return SIZES[problem] + LARGER.get((problem, case), ())


def installed(codes: tuple[str, ...] = tuple(CODES)) -> dict[str, str]:
    """Return the versions of the codes that can be imported."""
    found = {}
    for code in codes:
        try:
            module = importlib.import_module(f"benchmarks.peers.{CODES[code][0]}")
        except ImportError:
            continue
        found[code] = module.version()
    return found


def codes_for(problem: str, available: dict[str, str]) -> list[str]:
    """Return the available codes that are measured on a problem."""
    codes = tuple(CODES) if problem in ("hertz", "rough") else BOTH
    if problem == "slip":
        codes = ("samcontact", "ASPHER")
    if problem == "hertz":
        codes = tuple(code for code in codes if code != "ASPHER, H2")
    return [code for code in codes if code in available]


def references(problem: str, case: str, n: int, available: dict[str, str]) -> list[Task]:
    """Return the tasks of the tightly converged reference solutions."""
    if problem == "stress":
        return []
    codes = [code for code in tight(problem) if code in available]
    return [Task(problem, case, n, code, tight(problem)[code]) for code in codes]


def alternating(problem: str, case: str, n: int, available: dict[str, str]) -> Iterator[Task]:
    """Iterate over the tasks of all codes in turn, from the loosest to the tightest tolerance."""
    codes = codes_for(problem, available)
    ladders = {code: code_class(code, problem).tolerances for code in codes}
    for step in range(max(map(len, ladders.values()))):
        for code in codes:
            if step < len(ladders[code]):
                yield Task(problem, case, n, code, ladders[code][step])


class Results:
    """Rows by task and round, stored in a file after each measurement."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.data: dict[str, Any] = {"versions": {}, "rows": {}}
        if file.exists():
            self.data = json.loads(file.read_text(encoding="utf-8"))

    def rounds(self, task: Task) -> list[dict[str, Any]]:
        rows: list[dict[str, Any]] = self.data["rows"].setdefault(task.key, [])
        return rows

    def forget_shorter(self, limit: float, chosen: Sequence[str] = PROBLEMS) -> None:
        """Discard rows that exceeded a time limit shorter than the present one."""
        for key, rounds in self.data["rows"].items():
            if key.split("|")[0] not in chosen:
                continue
            self.data["rows"][key] = [
                row
                for row in rounds
                if TIMEOUT_MARK not in row.get("failed", "") or row.get("limit_s", 0.0) >= limit
            ]

    def save(self) -> None:
        part = self.file.with_suffix(".part")
        part.write_text(rounded_json(self.data), encoding="utf-8")
        os.replace(part, self.file)


def rounded_json(data: Any) -> str:
    """Return JSON with one row per line and numbers of five digits; no measurement has more."""

    def short(value: Any) -> Any:
        if isinstance(value, float):
            return float(f"{value:.5g}")
        if isinstance(value, dict):
            return {k: short(v) for k, v in value.items()}
        return [short(v) for v in value] if isinstance(value, list) else value

    rows = ",\n".join(
        f"{json.dumps(key)}: {json.dumps(short(rows))}" for key, rows in data["rows"].items()
    )
    head = json.dumps({k: v for k, v in data.items() if k != "rows"})
    return f'{head[:-1]}, "rows": {{\n{rows}\n}}}}\n'


def too_long(task: Task, results: Results, limit: float) -> bool:
    """Return whether a timeout is certain, judged from the time at the preceding size."""
    every = sizes(task.problem, task.case) + sizes(task.problem, task.case, quick=True)
    last = max((n for n in every if n < task.n), default=None)
    if last is None:
        return False
    before = results.rounds(Task(task.problem, task.case, last, task.code, task.tol))
    if not before:
        return False
    if "failed" in before[0]:
        return TIMEOUT_MARK in before[0]["failed"]
    growth = GROWTH * (task.n / last) ** 2 / 4
    return growth * before[0]["with_setup_s"] > limit


def measure_all(
    chosen: list[str],
    results: Results,
    folder: Path,
    *,
    quick: bool,
    rounds: int,
    limit: float,
    clock: str,
    report: Callable[[str], None],
) -> None:
    """Measure all tasks that are not in the file yet."""
    available = installed()
    versions = {name: available[name] for name in ("samcontact", *PACKAGES) if name in available}
    results.data["versions"].update(versions)
    results.forget_shorter(limit, chosen)
    servers = {code: Server(code) for code in available}
    settings = {"folder": str(folder), "clock": clock}
    measure = partial(attempt, results=results, servers=servers, settings=settings, report=report)
    for finest in [] if quick else finest_of(chosen):
        if not results.rounds(finest):
            measure(finest, limit=3 * limit)
    places = [
        (problem, case, n)
        for problem in chosen
        for case in cases(problem)
        for n in sizes(problem, case, quick=quick)
    ]
    for problem, case, n in places:
        for task in references(problem, case, n, available):
            if not results.rounds(task):
                measure(task, limit=3 * limit)
        for number in range(rounds):
            for task in alternating(problem, case, n, available):
                done = results.rounds(task)
                again = number == 0 or (
                    "failed" not in done[0] and done[0]["with_setup_s"] < MAX_REPEATED_SECONDS
                )
                if len(done) <= number and again:
                    measure(task, limit=limit)
    for server in servers.values():
        server.close()


def finest_of(chosen: list[str]) -> list[Task]:
    """Return the finest task of each problem and case, run first as the reference for errors."""
    return [
        Task(problem, case, MAX_CELLS[problem], "samcontact", tight(problem)["samcontact"])
        for problem in chosen
        if problem in MAX_CELLS
        for case in cases(problem)
    ]


def attempt(
    task: Task,
    *,
    limit: float,
    results: Results,
    servers: dict[str, Server],
    settings: dict[str, str],
    report: Callable[[str], None],
) -> None:
    """Run one measurement and store it immediately."""
    if too_long(task, results, limit):
        row: dict[str, Any] = {"failed": f"expected to take {TIMEOUT_MARK} {limit:g} s"}
    else:
        row = servers[task.code].run(replace(task, **settings), limit)
    if "failed" in row:
        row["limit_s"] = limit
    results.rounds(task).append(row)
    results.save()
    outcome = row.get("failed") or f"{row['with_setup_s']:.3g} s, {row['errors']}"
    report(f"{task.key}: {outcome}")

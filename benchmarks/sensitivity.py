# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.sensitivity: how much the gallery's stated numbers move with their meshes.

Each part of the gallery is computed again with cells, layers and increments halved and with a
window and depth a quarter larger, one at a time. A number that moves by more than is said of it
wants a finer mesh, a limit, or a sentence. --docs writes docs/sensitivity.md from the kept table.
"""

from __future__ import annotations

import argparse
import importlib
import os
import re
import sys
import warnings
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest import mock

import pandas as pd

from .harness import ROOT

# Tugging and running-in state limits, or their own studies of convergence.
PARTS = ("nano_indentation", "flattening", "two_plastic_bodies", "friction", "heat",
         "transient_heat", "rolling", "rolling_ellipticity", "rolling_load", "rolling_two_bodies",
         "wear")  # fmt: skip
CHANGES = ("cells", "layers", "increments", "window")
PAGE = ROOT / "docs" / "sensitivity.md"
HEAD = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.sensitivity --docs -->
# What the gallery's numbers depend on

By how much each number that a page of the [gallery](gallery.md) states moves [%] when the cells are
halved in both directions, the layers are halved, the increments of the load are halved, or the
window and its depth are made a quarter larger, one at a time. {mesh}

Of a list of numbers it is the largest move over the largest number. Numbers in a text are those it
shows, with their last digit. A dash: the scene has nothing of that kind to change, or gives another
number of values. Tugging and running-in are not here: they state [limits](gallery/tugging.md) and
have a page of their [convergence](wear_convergence.md).
"""
MESHES = {
    True: """The meshes are the
coarse ones of the tests, about half as fine as the page's: the moves are about what a page is
better by, and about an upper bound of what it is still off by.""",
    False: "The meshes are the pages'.",
}
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")


@contextmanager
def changed(what: str | None) -> Iterator[None]:
    """Grids and steps that parts of the gallery make are finer, or larger, in one respect."""
    import samcontact as sc

    def grid(nx: int, ny: int, dx: float, dy: float, nz: int = 0, dz: float | None = None) -> Any:
        if what == "cells":  # an odd number stays odd: the middle stays a cell
            nx, ny, dx, dy = 2 * nx - nx % 2, 2 * ny - ny % 2, dx / 2, dy / 2
        elif what == "layers" and dz is not None:
            nz, dz = 2 * nz, dz / 2
        elif what == "window":
            nx, ny, nz = nx + 2 * round(nx / 8), ny + 2 * round(ny / 8), nz + round(nz / 4)
        return real_grid(nx, ny, dx, dy, nz, dz)

    def step(simulation: Any, **target: Any) -> Any:
        kind = next((k for k in ("load", "approach") if target.get(k) is not None), None)
        before = getattr(simulation.state, kind) if kind else float("nan")
        if before == before and target[kind] != 0:  # elastic unloading has no path
            half = {kind: 0.5 * (before + target[kind])}
            if "advance" in target:
                half["advance"] = target["advance"] = [0.5 * way for way in target["advance"]]
            if target.get("duration") is not None:
                half["duration"] = target["duration"] = 0.5 * target["duration"]
            real_step(simulation, **(target | half))
        return real_step(simulation, **target)

    real_grid, real_step = sc.Grid, sc.Simulation.step
    with mock.patch.object(sc, "Grid", grid):
        if what != "increments":
            yield
        else:
            with mock.patch.object(sc.Simulation, "step", step):
                yield


def stated(task: tuple[str, str | None, bool]) -> dict[str, list[float]]:
    """All numbers of each stated value; nothing where the scene cannot be computed so."""
    name, what, quick = task
    part = importlib.import_module(f"gallery.{name}")
    with warnings.catch_warnings(), changed(what):
        warnings.simplefilter("ignore")
        try:
            entries = part.stated(part.compute(quick))
        except Exception as error:  # told in the table: the others go on
            return {"(not computed)": [float("nan")], str(error)[:60]: []}
    return {
        entry.quantity: [float(entry.ours)]
        if hasattr(entry, "unit")
        else [float(number) for number in NUMBER.findall(entry.ours)]
        for entry in entries
    }


def moved(before: list[float], after: list[float] | None) -> float:
    """Largest relative change [%] of a list of numbers, over the largest of them."""
    if not before or after is None or len(after) != len(before):
        return float("nan")
    scale = max(map(abs, before)) or 1.0
    return 100 * max(abs(b - a) for a, b in zip(before, after, strict=True)) / scale


def _numbers(text: str) -> list[float]:
    return [float(number) for number in text.strip("[]").split(",") if number.strip()]


def page(table: pd.DataFrame, quick: bool) -> str:
    """The table as a page of the docs; values that never move by more than 0.5 % are counted."""
    text = [HEAD.format(mesh=MESHES[quick])]
    moves = [f"{what} [%]" for what in CHANGES]
    for part, rows in table.groupby("part", sort=False):
        title = importlib.import_module(f"gallery.{part}").TITLE
        largest = rows[moves].max(axis=1)
        shown, steady = rows[~(largest <= 0.5)], int((largest <= 0.5).sum())
        text.append(f"## {title}\n")
        if steady:
            text.append(f"{steady} of {len(rows)} values move by less than 0.5 %.\n")
        if len(shown):
            text.append("| value | numbers | cells | layers | increments | window |")
            text.append("| --- | --- | --- | --- | --- | --- |")
            for row in shown.to_dict("records"):
                numbers = ", ".join(f"{number:.4g}" for number in row["values"][:6])
                more = ", ..." if len(row["values"]) > 6 else ""
                moved = " | ".join("-" if row[m] != row[m] else f"{row[m]:.2f}" for m in moves)
                text.append(f"| {row['quantity']} | {numbers}{more} | {moved} |")
            text.append("")
    return "\n".join(text)


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.sensitivity")
    parser.add_argument("parts", nargs="*", default=PARTS)
    parser.add_argument("--quick", action="store_true", help="the coarse meshes of the tests")
    parser.add_argument("--processes", type=int, default=1)
    output = ROOT / "benchmarks" / "sensitivity.csv"
    parser.add_argument("--output", type=Path, default=output)
    parser.add_argument("--docs", action="store_true", help=f"write {PAGE.relative_to(ROOT)} of it")
    chosen = parser.parse_args(given)
    if chosen.docs:
        kept = pd.read_csv(chosen.output, converters={"values": _numbers})
        PAGE.write_text(page(kept, chosen.quick), encoding="utf-8")
        return 0
    os.environ["OMP_NUM_THREADS"] = "1"
    tasks = [(part, what, chosen.quick) for part in chosen.parts for what in (None, *CHANGES)]
    with ProcessPoolExecutor(chosen.processes) as pool:
        found = dict(zip(tasks, pool.map(stated, tasks), strict=True))
    rows = []
    for part in chosen.parts:
        base = found[part, None, chosen.quick]
        for quantity, values in base.items():
            row: dict[str, Any] = {"part": part, "quantity": quantity, "values": values}
            for what in CHANGES:
                other = found[part, what, chosen.quick]
                row[f"{what} [%]"] = moved(values, other.get(quantity))
            rows.append(row)
    table = pd.DataFrame(rows)
    chosen.output.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(chosen.output, index=False)
    print(table.drop(columns="values").round(2).to_string(index=False))
    return 0


if __name__ == "__main__":
    sys.exit(main())

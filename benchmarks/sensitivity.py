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

from gallery import moves
from gallery.moves import CHANGES
from gallery.parts import PARTS as FIGURES

from .harness import ROOT

PARTS = tuple(FIGURES)

# The contact of tugging moves by whole cells: its increments can be halved when its cells are.
AFTER = {("tugging", "increments"): "cells"}
PAGE = ROOT / "docs" / "sensitivity.md"
HEAD = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.sensitivity --docs -->
# What the gallery's numbers depend on

By how much each number that a page of the [gallery](gallery.md) states moves [%] when the cells are
halved in both directions, the layers are halved, the increments of the load are halved, or the
window and its depth are made a quarter larger, one at a time. Each section says whether this is
done to the mesh of the page or to the coarse one of the tests, about half as fine: the moves of
that are about what the page is better by, and about an upper bound of what it is still off by.

Of several numbers it is the largest move over the largest number. Numbers in a text are those it
shows, with their last digit: a difference of one digit moves by large shares. A dash: the scene has
nothing of that kind to change, or gives another number of values. Rolling goes on by a step for
each cell, so that halved cells halve its steps too; tugging can have smaller increments on smaller
cells only, and is compared with these.
"""
MESHES = {
    moves.OWN: "The page's mesh.\n",
    moves.COARSE: "The coarse mesh.\n",
    moves.BOTH: "The page's mesh; in brackets, the coarse one.\n",
}
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
ROUNDING = 1e-8
Row = dict[str, Any]


def resized(
    what: str | None, nx: int, ny: int, dx: float, dy: float, nz: int = 0, dz: float | None = None
) -> tuple[Any, ...]:
    """What a `Grid` is made of, finer or larger in one respect."""
    if what == "cells":  # an odd number stays odd: the middle stays a cell
        nx, ny, dx, dy = 2 * nx - nx % 2, 2 * ny - ny % 2, dx / 2, dy / 2
    elif what == "layers" and dz is not None:
        nz, dz = 2 * nz, dz / 2
    elif what == "window":
        nx, ny, nz = nx + 2 * round(nx / 8), ny + 2 * round(ny / 8), nz + round(nz / 4)
    return nx, ny, dx, dy, nz, dz


@contextmanager
def changed(what: str | None) -> Iterator[None]:
    """Grids and steps that parts of the gallery make are finer, or larger, in one respect."""
    import samcontact as sc
    from samcontact import asperities

    def grid(*sizes: Any) -> Any:
        return real_grid(*resized(what, *sizes))

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

    def tug(collision: Any, body1: Any, body2: Any, mesh: Any, **settings: Any) -> Any:
        # The contact moves by whole cells: half the increments are compared with half the cells.
        cells = 2 if what == "cells" else 1
        finer = resized(
            "cells" if what == "increments" else what,
            mesh.nx, mesh.ny, mesh.dx, mesh.dy, mesh.nz, mesh.dz,
        )  # fmt: skip
        with mock.patch.object(sc.Simulation, "step", real_step):
            return real_tug(
                collision, body1, body2, real_grid(*finer), cells_per_increment=cells, **settings
            )

    real_grid, real_step, real_tug = sc.Grid, sc.Simulation.step, asperities.tug
    with mock.patch.object(sc, "Grid", grid), mock.patch.object(asperities, "tug", tug):
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
    """Largest change [%] of a list of numbers, over the largest of them."""
    if not before or after is None or len(after) != len(before):
        return float("nan")
    if max(map(abs, [*before, *after])) < ROUNDING:
        return 0.0
    scale = max(map(abs, before)) or 1.0
    return 100 * max(abs(b - a) for b, a in zip(before, after, strict=True)) / scale


def compared(part: str, mesh: str, found: dict[str | None, dict[str, list[float]]]) -> list[Row]:
    """A row for each stated value; a column for each change is empty where it was not made."""
    rows = []
    for quantity, given in found[None].items():
        row: Row = {"part": part, "mesh": mesh, "quantity": quantity, "values": given}
        for what in CHANGES:
            before = found[AFTER.get((part, what))].get(quantity, []) if what in found else []
            row[f"{what} [%]"] = moved(before, found.get(what, {}).get(quantity))
        rows.append(row)
    return rows


def page(table: Path) -> str:
    """The table as a page of the docs; values that never move by more than 0.5 % are counted."""
    text = [HEAD]
    for part in PARTS:
        found = [row for row in moves.of_part(part, table) if row.values]
        meshes = moves.note(found)
        text.append(f"## {importlib.import_module(f'gallery.{part}').TITLE}\n")
        text.append(MESHES[meshes])
        shown = [row for row in found if not row.largest or row.largest.percent > 0.5]
        if steady := len(found) - len(shown):
            text.append(f"{steady} of {len(found)} values move by less than 0.5 %.\n")
        if shown:
            text.append("| value | numbers | cells | layers | increments | window |")
            text.append("| --- | --- | --- | --- | --- | --- |")
        for row in shown:
            numbers = ", ".join(f"{number:.4g}" for number in row.values[:6])
            more = ", ..." if len(row.values) > 6 else ""
            cells = [cell(row.by.get(what), meshes == moves.BOTH) for what in CHANGES]
            text.append(f"| {row.quantity} | {numbers}{more} | {' | '.join(cells)} |")
        if shown:
            text.append("")
    return "\n".join(text)


def cell(move: moves.Move | None, mixed: bool) -> str:
    if move is None:
        return "-"
    return f"({move.percent:.2f})" if mixed and not move.own else f"{move.percent:.2f}"


def updated(file: Path, rows: list[Row]) -> pd.DataFrame:
    """The kept table with these rows in place of those of their parts and mesh."""
    new = {(row["part"], row["mesh"]) for row in rows}
    kept = pd.read_csv(file).to_dict("records") if file.exists() else []
    rows = rows + [row for row in kept if (row["part"], row["mesh"]) not in new]
    rows.sort(key=lambda row: (PARTS.index(row["part"]), row["mesh"] == "coarse"))
    return pd.DataFrame(rows)


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.sensitivity")
    parser.add_argument("parts", nargs="*", default=PARTS)
    parser.add_argument("--quick", action="store_true", help="the coarse meshes of the tests")
    parser.add_argument("--changes", nargs="+", choices=CHANGES, default=CHANGES)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--output", type=Path, default=moves.TABLE)
    parser.add_argument("--docs", action="store_true", help=f"write {PAGE.relative_to(ROOT)} of it")
    chosen = parser.parse_args(given)
    if chosen.docs:
        PAGE.write_text(page(chosen.output), encoding="utf-8")
        return 0
    os.environ["OMP_NUM_THREADS"] = "1"
    computed = (None, *chosen.changes)
    tasks = [(part, what, chosen.quick) for part in chosen.parts for what in computed]
    with ProcessPoolExecutor(chosen.processes) as pool:
        found = dict(zip(tasks, pool.map(stated, tasks), strict=True))
    mesh = "coarse" if chosen.quick else "page"
    rows: list[Row] = []
    for part in chosen.parts:
        of_part = {what: found[part, what, chosen.quick] for what in computed}
        rows += compared(part, mesh, of_part)
    chosen.output.parent.mkdir(parents=True, exist_ok=True)
    table = updated(chosen.output, rows)
    table.to_csv(chosen.output, index=False)
    print(table.drop(columns="values").round(2).to_string(index=False))
    return 0


if __name__ == "__main__":
    sys.exit(main())

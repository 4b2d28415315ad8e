# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.sensitivity: how much the gallery's stated numbers move with their meshes.

Each part of the gallery is computed again with cells, layers and increments halved and with a
window and depth a quarter larger, one at a time. A number that moves by more than is said of it
wants a finer mesh, a limit, or a sentence. --docs writes docs/sensitivity.md from the kept table.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any
from unittest import mock

import samcontact as sc
from gallery import moves
from gallery.moves import CHANGES
from gallery.parts import PARTS as FIGURES
from samcontact import asperities

from .study import Record, Study, table

PARTS = tuple(FIGURES)

# The contact of tugging moves by whole cells: its increments can be halved when its cells are.
AFTER = {("asperities", "increments"): "cells"}
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
    moves.OWN_MESH_NOTE: "The page's mesh.\n",
    moves.COARSE_MESH_NOTE: "The coarse mesh.\n",
    moves.BOTH_MESHES_NOTE: "The page's mesh; in brackets, the coarse one.\n",
}
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
ROUNDING = 1e-8


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

    def collide(collision: Any, body1: Any, body2: Any, mesh: Any, **settings: Any) -> Any:
        # The contact moves by whole cells: half the increments are compared with half the cells.
        cells = 2 if what == "cells" else 1
        finer = resized(
            "cells" if what == "increments" else what,
            mesh.nx, mesh.ny, mesh.dx, mesh.dy, mesh.nz, mesh.dz,
        )  # fmt: skip
        with mock.patch.object(sc.Simulation, "step", real_step):
            return real_collide(
                collision, body1, body2, real_grid(*finer), cells_per_increment=cells, **settings
            )

    real_grid, real_step, real_collide = sc.Grid, sc.Simulation.step, asperities.collide
    with mock.patch.object(sc, "Grid", grid), mock.patch.object(asperities, "collide", collide):
        if what != "increments":
            yield
        else:
            with mock.patch.object(sc.Simulation, "step", step):
                yield


@cache
def stated(name: str, what: str | None, coarse: bool) -> dict[str, list[float]]:
    """All numbers of each stated value; nothing where the scene cannot be computed so."""
    part = importlib.import_module(f"gallery.{name}")
    with changed(what):
        try:
            entries = part.stated(part.compute(coarse))
        except Exception as error:  # told in the table: the others go on
            return {"(not computed)": [float("nan")], str(error)[:60]: []}
    return {
        entry.quantity: [float(entry.ours)]
        if hasattr(entry, "unit")
        else [float(number) for number in NUMBER.findall(entry.ours)]
        for entry in entries
    }


def moved(before: list[float], after: list[float] | None) -> float | None:
    """Largest change [%] of a list of numbers, over the largest of them; None of others."""
    if not before or after is None or len(after) != len(before):
        return None
    if max(map(abs, [*before, *after])) < ROUNDING:
        return 0.0
    scale = max(map(abs, before)) or 1.0
    return 100 * max(abs(b - a) for b, a in zip(before, after, strict=True)) / scale


def points(quick: bool) -> list[Record]:
    mesh = "coarse" if quick else "page"
    return [{"of": part, "mesh": mesh, "change": what} for part in PARTS
            for what in ("none", *CHANGES)]  # fmt: skip


def run(of: str, mesh: str, change: str) -> Record:
    """The numbers of a part, or how much a change of its mesh moves them."""
    coarse = mesh == "coarse"
    if change == "none":
        return {"values": stated(of, None, coarse)}
    before, after = stated(of, AFTER.get((of, change)), coarse), stated(of, change, coarse)
    found = {
        name: moved(before.get(name, []), after.get(name)) for name in stated(of, None, coarse)
    }
    return {"moves": {name: percent for name, percent in found.items() if percent is not None}}


def page(records: list[Record]) -> str:
    """The table as a page of the docs; values that never move by more than 0.5 % are counted."""
    text = [HEAD]
    for part in PARTS:
        found = [row for row in moves.of_part(part, records) if row.values]
        meshes = moves.note(found)
        text.append(f"## {importlib.import_module(f'gallery.{part}').TITLE}\n")
        text.append(MESHES[meshes])
        shown = [row for row in found if not row.largest or row.largest.percent > 0.5]
        if steady := len(found) - len(shown):
            text.append(f"{steady} of {len(found)} values move by less than 0.5 %.\n")
        lines = []
        for row in shown:
            numbers = ", ".join(f"{number:.4g}" for number in row.values[:6])
            more = ", ..." if len(row.values) > 6 else ""
            cells = [cell(row.by.get(what), meshes == moves.BOTH_MESHES_NOTE) for what in CHANGES]
            lines.append([row.quantity, f"{numbers}{more}", *cells])
        if lines:
            text.append(table(["value", "numbers", *CHANGES], lines) + "\n")
    return "\n".join(text)


def cell(move: moves.Move | None, mixed: bool) -> str:
    if move is None:
        return "-"
    return f"({move.percent:.2f})" if mixed and not move.own else f"{move.percent:.2f}"


STUDY = Study(
    "sensitivity", "How much the gallery's stated numbers move with their meshes.", points, run,
    page, lasting=True, keeps_quick=True,
)  # fmt: skip

if __name__ == "__main__":
    STUDY.main()

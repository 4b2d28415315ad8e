# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.sensitivity: sensitivity of the gallery's stated numbers to the mesh.

Each part of the gallery is computed again with halved cells, layers and increments and with a grid
a quarter larger and deeper, one at a time. A number that changes by more than its stated tolerance
needs a finer mesh, an extrapolated limit or a remark. --docs writes docs/sensitivity.md from the
stored table.
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

# Colliding asperities move by whole cells, so increments are halved only together with cells.
AFTER = {("asperities", "increments"): "cells"}
HEAD = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.sensitivity --docs -->
# Sensitivity of the gallery to the mesh

This page states by how much [%] the numbers on each page of the [gallery](gallery.md) change when
the mesh is changed. Four changes are made, one at a time: cells of half the size along x and y
(column "cells"), layers of half the thickness ("layers"), load increments of half the size
("increments"), and a grid that is a quarter wider and deeper ("grid size"). Each section states
which of two meshes was changed: the mesh of the gallery page, or the coarse mesh of the tests,
which is about half as fine. If the coarse mesh is refined, a number changes by about as much as
from the coarse mesh to the mesh of the page. This change is also approximately an upper bound of
the remaining error of the page.

If a row of a gallery page contains several numbers, the table gives the largest change, relative to
the largest of these numbers. Numbers in text are rounded as on the page, so a change of the last
digit of a small number is a large percentage. A dash means that the change of the mesh does not
apply to this contact, or that the row contains more or fewer numbers after the change. In rolling,
the contact advances by one cell per step, so halved cells also halve the steps. In asperity
collisions, increments can be halved only if the cells are halved too. The column "increments" then
gives the change relative to the results on halved cells.
"""
MESHES = {
    moves.OWN_MESH_NOTE: "Mesh of the page.\n",
    moves.COARSE_MESH_NOTE: "Coarse mesh.\n",
    moves.BOTH_MESHES_NOTE: "Mesh of the page; values in brackets: coarse mesh.\n",
}
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
ROUNDING = 1e-8


def resized(
    what: str | None, nx: int, ny: int, dx: float, dy: float, nz: int = 0, dz: float | None = None
) -> tuple[Any, ...]:
    """Return the arguments of a `Grid`, finer or larger in one respect."""
    if what == "cells":  # an odd number stays odd, so that the middle remains a cell centre
        nx, ny, dx, dy = 2 * nx - nx % 2, 2 * ny - ny % 2, dx / 2, dy / 2
    elif what == "layers" and dz is not None:
        nz, dz = 2 * nz, dz / 2
    elif what == "grid size":
        nx, ny, nz = nx + 2 * round(nx / 8), ny + 2 * round(ny / 8), nz + round(nz / 4)
    return nx, ny, dx, dy, nz, dz


@contextmanager
def changed(what: str | None) -> Iterator[None]:
    """Context manager in which gallery grids and steps are finer or larger in one respect."""

    def grid(*sizes: Any) -> Any:
        return real_grid(*resized(what, *sizes))

    def step(simulation: Any, **target: Any) -> Any:
        kind = next((k for k in ("load", "approach") if target.get(k) is not None), None)
        before = getattr(simulation.state, kind) if kind else float("nan")
        if before == before and target[kind] != 0:  # elastic unloading does not depend on the path
            half = {kind: 0.5 * (before + target[kind])}
            if "advance" in target:
                half["advance"] = target["advance"] = [
                    0.5 * distance for distance in target["advance"]
                ]
            if target.get("duration") is not None:
                half["duration"] = target["duration"] = 0.5 * target["duration"]
            real_step(simulation, **(target | half))
        return real_step(simulation, **target)

    def collide(collision: Any, body1: Any, body2: Any, mesh: Any, **settings: Any) -> Any:
        # The contact moves by whole cells: halved increments are compared with halved cells.
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
    """Return the numbers in each result stated by a gallery part, by name of the result."""
    part = importlib.import_module(f"gallery.{name}")
    with changed(what):
        try:
            entries = part.stated(part.compute(coarse))
        except Exception as error:  # marked in the table; other parts continue
            return {"(not computed)": [float("nan")], str(error)[:60]: []}
    return {
        entry.quantity: [float(entry.ours)]
        if hasattr(entry, "unit")
        else [float(number) for number in NUMBER.findall(entry.ours)]
        for entry in entries
    }


def moved(before: list[float], after: list[float] | None) -> float | None:
    """Return the largest change [%], relative to the largest number; None if the counts differ."""
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
    """Return the numbers of a gallery part, or the changes of the numbers with a change of mesh."""
    coarse = mesh == "coarse"
    if change == "none":
        return {"values": stated(of, None, coarse)}
    before, after = stated(of, AFTER.get((of, change)), coarse), stated(of, change, coarse)
    found = {
        name: moved(before.get(name, []), after.get(name)) for name in stated(of, None, coarse)
    }
    return {"moves": {name: percent for name, percent in found.items() if percent is not None}}


def page(records: list[Record]) -> str:
    """Return the page; rows that never change by more than 0.5 % are only counted."""
    text = [HEAD]
    for part in PARTS:
        found = [row for row in moves.of_part(part, records) if row.values]
        meshes = moves.note(found)
        text.append(f"## {importlib.import_module(f'gallery.{part}').TITLE}\n")
        text.append(MESHES[meshes])
        shown = [row for row in found if not row.largest or row.largest.percent > 0.5]
        if steady := len(found) - len(shown):
            text.append(
                f"Rows that change by at most 0.5 % (not listed): {steady} of {len(found)}.\n"
            )
        lines = []
        for row in shown:
            numbers = ", ".join(f"{number:.4g}" for number in row.values[:6])
            more = ", ..." if len(row.values) > 6 else ""
            cells = [cell(row.by.get(what), meshes == moves.BOTH_MESHES_NOTE) for what in CHANGES]
            lines.append([row.quantity, f"{numbers}{more}", *cells])
        if lines:
            text.append(table(["quantity", "numbers", *CHANGES], lines) + "\n")
    return "\n".join(text)


def cell(move: moves.Move | None, mixed: bool) -> str:
    if move is None:
        return "-"
    return f"({move.percent:.2f})" if mixed and not move.own else f"{move.percent:.2f}"


STUDY = Study(
    "sensitivity", "Sensitivity of the gallery's stated numbers to the mesh.", points, run,
    page, lasting=True, keeps_quick=True,
)  # fmt: skip

if __name__ == "__main__":
    STUDY.main()

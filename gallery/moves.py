# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes of the computed values of a gallery page with the mesh, stored in benchmarks."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

TABLE = Path(__file__).parents[1] / "benchmarks" / "sensitivity.json"
CHANGES = ("cells", "layers", "increments", "grid size")
OWN_MESH_NOTE = """\
Sensitivity: the largest change of the numbers when the cells, layers or increments of the mesh of
this page are halved in size, or when the grid is enlarged
([sensitivity of the gallery to the mesh](../sensitivity.md)).
"""
COARSE_MESH_NOTE = """\
Sensitivity: the numbers are also computed with a mesh about half as fine as the mesh of this page.
This coarser mesh is then changed in one respect at a time: the cells, the layers or the increments
are halved in size, or the grid is enlarged. The column gives the largest of the resulting changes
of the numbers ([sensitivity of the gallery to the mesh](../sensitivity.md)). This change is
approximately an upper bound of the error of this page.
"""
BOTH_MESHES_NOTE = """\
Sensitivity: the largest change of the numbers when the cells, layers or increments of the mesh of
this page are halved in size, or when the grid is enlarged
([sensitivity of the gallery to the mesh](../sensitivity.md)). Changes in brackets were found with a
mesh about half as fine; they are approximately upper bounds of the error of this page.
"""


@dataclass(frozen=True, order=True)
class Move:
    """Change of a value with the mesh [%]; `own`: whether the mesh of the page was changed."""

    percent: float
    own: bool


@dataclass(frozen=True)
class Moves:
    """Quantity of a page, its computed numbers, and the change due to each change of the mesh."""

    quantity: str
    values: list[float]
    by: dict[str, Move]

    @property
    def largest(self) -> Move | None:
        return max(self.by.values(), default=None)


def words(quantity: str) -> str:
    """Return the letters of a quantity, as a key: its numbers may differ between meshes."""
    return "".join(letter for letter in quantity if letter.isalpha())


def kept() -> list[dict[str, Any]]:
    """Read the stored records of `python -m benchmarks.sensitivity`."""
    found: list[dict[str, Any]] = json.loads(TABLE.read_text(encoding="utf-8"))
    return found


def of_part(name: str, records: list[dict[str, Any]]) -> list[Moves]:
    """Return the changes on the mesh of the page or, where missing, on the coarse mesh."""
    found: dict[bool, list[Moves]] = {True: [], False: []}
    for record in (record for record in records if record["of"] == name):
        own = record["mesh"] == "page"
        if "values" in record:
            found[own] = [Moves(key, values, {}) for key, values in record["values"].items()]
        for moves in found[own]:
            if moves.quantity in record.get("moves", {}):
                moves.by[record["change"]] = Move(record["moves"][moves.quantity], own)
    if not found[True]:
        return found[False]
    done = {change for moves in found[True] for change in moves.by}
    for moves in found[True]:
        for other in found[False]:
            if words(other.quantity) == words(moves.quantity):
                for change in other.by.keys() - done:
                    move = other.by[change]
                    moves.by[change] = max(move, moves.by.get(change, move))
    return found[True]


def note(table: list[Moves]) -> str:
    """Return the explanation of the column "sensitivity" of a page."""
    own = {move.own for moves in table for move in moves.by.values()}
    return (
        BOTH_MESHES_NOTE if len(own) == 2 else OWN_MESH_NOTE if own == {True} else COARSE_MESH_NOTE
    )


def column(table: list[Moves]) -> dict[str, str]:
    """Return the maximum change of each quantity; changes on coarse meshes are in brackets."""
    mixed = note(table) == BOTH_MESHES_NOTE
    largest: dict[str, Move] = {}
    for moves in table:
        if move := moves.largest:
            key = words(moves.quantity)
            largest[key] = max(move, largest.get(key, move))
    texts = {
        key: f"{move.percent:.2g} %" if move.percent < 100 else "> 100 %"
        for key, move in largest.items()
    }
    return {
        key: f"({text})" if mixed and not largest[key].own else text for key, text in texts.items()
    }

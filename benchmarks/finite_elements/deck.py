# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks for CalculiX: an elastic paraboloid pressed onto a half-space that yields, and released.

Axisymmetric, quadratic elements with reduced integration, graded towards a far border; face to face
contact. Millimetres, newtons, megapascals.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import samcontact as sc

RADIUS = 7.5  # equivalent [mm]
CONTACT = 0.41817  # Hertz radius at 1500 N [mm]
APPROACH = 23.363e-3  # under about 1500 N [mm]
UP, DOWN = 12, 4  # increments
FAR = 4000.0  # Hertz radii to the border
FINE = 1.4  # radii of the evenly divided part
GROWTH = 1.3  # of elements beyond it
HOLE = 1e-3  # radii of a hole on the axis: faces that end in a point lose their contact pressure
STIFFNESS = 1e9  # of the contact [N/mm^3]: 4 nm of penetration
RESIDUAL = 5e-4  # relative, where an increment has converged

FloatArray = NDArray[np.float64]


class Block(NamedTuple):
    """Elements of a body."""

    nodes: dict[tuple[int, int], int]  # number of a node by its row and column, corners even
    lines: list[str]
    elements: dict[tuple[int, int], int]

    def column(self, i: int) -> list[int]:
        """Nodes at one radius."""
        return [number for (a, _), number in self.nodes.items() if a == i]

    def row(self, j: int) -> list[int]:
        """Nodes at one depth."""
        return [number for (_, b), number in self.nodes.items() if b == j]


def ticks(per_radius: int) -> FloatArray:
    """Corners of elements along r or z [mm]."""
    step = 1.0 / per_radius
    found = [n * step for n in range(round(FINE * per_radius) + 1)]
    while found[-1] < FAR:
        step *= GROWTH
        found.append(found[-1] + step)
    return np.array(found) * CONTACT


def lifted(r: float, depth: float, flatter: float = 1.0) -> float:
    """What the paraboloid adds to the height of a node of the upper body [mm]."""
    height = min(r, FINE * CONTACT) ** 2 / (2 * RADIUS * flatter)
    return float(height * np.exp(-depth / (20 * CONTACT)))


def block(
    per_radius: int, upper: bool, flatter: float, first_node: int, first_element: int
) -> Block:
    """One of the two bodies."""
    z = ticks(per_radius)
    r = z.copy()
    r[0] = HOLE * CONTACT
    fine_r, fine_z = (np.sort(np.r_[v, 0.5 * (v[1:] + v[:-1])]) for v in (r, z))
    nodes: dict[tuple[int, int], int] = {}
    lines = ["*NODE, NSET=ALL"]
    for i, radius in enumerate(fine_r):
        for j, depth in enumerate(fine_z):
            if i % 2 and j % 2:
                continue
            nodes[i, j] = first_node + len(nodes)
            y = depth + lifted(radius, depth, flatter) if upper else -depth
            lines.append(f"{nodes[i, j]}, {radius:.12g}, {y:.12g}")
    name = "UPPER" if upper else "LOWER"
    lines.append(f"*ELEMENT, TYPE=CAX8R, ELSET={name}")
    elements: dict[tuple[int, int], int] = {}
    for i in range(0, len(fine_r) - 1, 2):
        for j in range(0, len(fine_z) - 1, 2):
            a, b = (j, j + 2) if upper else (j + 2, j)
            corners = [(i, a), (i + 2, a), (i + 2, b), (i, b)]
            sides = [(i + 1, a), (i + 2, j + 1), (i + 1, b), (i, j + 1)]
            number = elements[i // 2, j // 2] = first_element + len(elements)
            lines.append(", ".join(map(str, [number, *(nodes[at] for at in corners + sides)])))
    return Block(nodes, lines, elements)


def steel(elastic_only: bool) -> list[str]:
    """Both materials: AISI 52100, and the same without flow."""
    law = sc.Material.swift(210e9, 0.3, B=945e6, C=20, n=0.121)
    strains = np.r_[0.0, np.geomspace(1e-6, 0.2, 150)]
    curve = [f"{law.yield_stress(g) / 1e6:.10g}, {g:.10g}" for g in strains]
    if elastic_only:
        curve = ["1e6, 0."]
    elastic = ["*ELASTIC", "210000., 0.3"]
    return [
        "*MATERIAL, NAME=ELASTIC", *elastic, "*SOLID SECTION, ELSET=UPPER, MATERIAL=ELASTIC",
        "*MATERIAL, NAME=STEEL", *elastic, "*PLASTIC", *curve,
        "*SOLID SECTION, ELSET=LOWER, MATERIAL=STEEL",
    ]  # fmt: skip


def named(kind: str, name: str, numbers: list[int]) -> list[str]:
    """A set of nodes or elements."""
    return [f"*{kind}, {kind}={name}", *(f"{n}," for n in numbers)]


def step(approach: float, increments: int) -> list[str]:
    """To an approach, and what is printed at its end."""
    return [
        "*STEP, INC=10000", "*STATIC, DIRECT", f"{1.0 / increments:.10g}, 1.",
        "*CONTROLS, PARAMETERS=FIELD", f"{RESIDUAL:g}, {100 * RESIDUAL:g}",
        "*BOUNDARY", f"TOP, 2, 2, {-approach:.10g}",
        "*NODE PRINT, NSET=TOP, TOTALS=ONLY, FREQUENCY=10000", "RF",
        "*EL PRINT, ELSET=AXIAL, FREQUENCY=10000", "S, PEEQ",
        "*NODE PRINT, NSET=APEX, FREQUENCY=10000", "U",
        "*END STEP",
    ]  # fmt: skip


def write(path: Path, per_radius: int, flatter: float | None = None) -> int:
    """Write the deck with this many elements on the Hertz radius; how many it has in all.

    flatter: without flow, a radius so many times as large, and the approach that gives the same
    Hertz contact.
    """
    scale = flatter or 1.0
    lower = block(per_radius, False, scale, 1, 1)
    upper = block(per_radius, True, scale, len(lower.nodes) + 1, len(lower.elements) + 1)
    last = 2 * (len(ticks(per_radius)) - 1)
    fine = round(FINE * per_radius)
    lines = [*lower.lines, *upper.lines]
    lines += named("NSET", "AXIS", lower.column(0) + upper.column(0))
    lines += named("NSET", "BOTTOM", lower.row(last))
    lines += named("NSET", "TOP", upper.row(last))
    lines += named("NSET", "APEX", [lower.nodes[0, 0]])
    lines += named("ELSET", "AXIAL", [lower.elements[0, j] for j in range(fine)])
    lines += ["*SURFACE, NAME=BELOW, TYPE=ELEMENT"]
    lines += [f"{lower.elements[i, 0]}, S3" for i in range(fine)]
    lines += ["*SURFACE, NAME=ABOVE, TYPE=ELEMENT"]
    lines += [f"{upper.elements[i, 0]}, S1" for i in range(fine)]
    lines += steel(flatter is not None)
    lines += [
        "*SURFACE INTERACTION, NAME=TOUCH",
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{STIFFNESS:g}, 1e-3",
        "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "BELOW, ABOVE",
        "*BOUNDARY", "AXIS, 1, 1", "BOTTOM, 1, 2", "TOP, 1, 1",
    ]  # fmt: skip
    up, down = (UP, DOWN) if flatter is None else (1, 1)
    lines += step(APPROACH / scale, up) + step(0.0, down)
    path.write_text("\n".join(lines) + "\n")
    return len(lower.elements) + len(upper.elements)

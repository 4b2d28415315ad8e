# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks for CalculiX: an elastic paraboloid on an elastic-plastic half-space, loaded and unloaded.

The model has axisymmetric quadratic elements with reduced integration, which become larger towards
a distant border. Contact is face to face. Units are millimetres, newtons and megapascals.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from .deck import FloatArray, contact, named, steel, step, surface

RADIUS = 7.5  # equivalent [mm]
CONTACT = 0.41817  # Hertz radius at 1500 N [mm]
APPROACH = 23.363e-3  # under about 1500 N [mm]
LOADING_INCREMENTS, UNLOADING_INCREMENTS = 12, 4  # increments
OUTER_RADIUS = 4000.0  # Hertz radii to the border
FINE_RADIUS = 1.4  # radii; extent of the uniform part
GROWTH = 1.3  # growth factor of elements beyond the uniform part
HOLE = 1e-3  # radius of a hole on the axis: faces that end in a point lose their contact pressure
STIFFNESS = 1e9  # contact stiffness [N/mm^3]: 4 nm of penetration


class Block(NamedTuple):
    """Mesh of one body: node numbers, lines of the deck, and element numbers."""

    nodes: dict[tuple[int, int], int]  # node numbers by row and column; corners have even indices
    lines: list[str]
    elements: dict[tuple[int, int], int]

    def column(self, i: int) -> list[int]:
        """Return the numbers of the nodes at the radius with index i."""
        return [number for (a, _), number in self.nodes.items() if a == i]

    def row(self, j: int) -> list[int]:
        """Return the numbers of the nodes at the depth with index j."""
        return [number for (_, b), number in self.nodes.items() if b == j]


def ticks(per_radius: int) -> FloatArray:
    """Return the coordinates of the element corners along r or z [mm]."""
    step = 1.0 / per_radius
    found = [n * step for n in range(round(FINE_RADIUS * per_radius) + 1)]
    while found[-1] < OUTER_RADIUS:
        step *= GROWTH
        found.append(found[-1] + step)
    return np.array(found) * CONTACT


def lifted(r: float, depth: float, flatter: float = 1.0) -> float:
    """Return the height of the paraboloid at a node of the upper body [mm]."""
    height = min(r, FINE_RADIUS * CONTACT) ** 2 / (2 * RADIUS * flatter)
    return float(height * np.exp(-depth / (20 * CONTACT)))


def block(
    per_radius: int, upper: bool, flatter: float, first_node: int, first_element: int
) -> Block:
    """Return the mesh of the upper or the lower body."""
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


def to_approach(approach: float, increments: int) -> list[str]:
    """Return the deck lines of a step to an approach [mm], with output at the end of the step."""
    drive = ["*BOUNDARY", f"TOP, 2, 2, {-approach:.10g}"]
    printed = [
        "*NODE PRINT, NSET=TOP, TOTALS=ONLY, FREQUENCY=10000", "RF",
        "*EL PRINT, ELSET=AXIAL, FREQUENCY=10000", "S, PEEQ",
        "*NODE PRINT, NSET=APEX, FREQUENCY=10000", "U",
    ]  # fmt: skip
    return step(drive, increments, printed)


def write(path: Path, per_radius: int, flatter: float | None = None) -> int:
    """Write a deck with `per_radius` elements per Hertz radius; return the number of elements.

    flatter: factor on the ball radius. If it is given, the bodies are elastic, and the approach is
    chosen such that the Hertz contact radius is unchanged.
    """
    scale = flatter or 1.0
    lower = block(per_radius, False, scale, 1, 1)
    upper = block(per_radius, True, scale, len(lower.nodes) + 1, len(lower.elements) + 1)
    last = 2 * (len(ticks(per_radius)) - 1)
    fine = round(FINE_RADIUS * per_radius)
    lines = [*lower.lines, *upper.lines]
    lines += named("NSET", "AXIS", lower.column(0) + upper.column(0))
    lines += named("NSET", "BOTTOM", lower.row(last))
    lines += named("NSET", "TOP", upper.row(last))
    lines += named("NSET", "APEX", [lower.nodes[0, 0]])
    lines += named("ELSET", "AXIAL", [lower.elements[0, j] for j in range(fine)])
    lines += surface("BELOW", [lower.elements[i, 0] for i in range(fine)], "S3")
    lines += surface("ABOVE", [upper.elements[i, 0] for i in range(fine)], "S1")
    lines += steel(flatter is not None) + contact(STIFFNESS)
    lines += ["*BOUNDARY", "AXIS, 1, 1", "BOTTOM, 1, 2", "TOP, 1, 1"]
    up, down = (LOADING_INCREMENTS, UNLOADING_INCREMENTS) if flatter is None else (1, 1)
    lines += to_approach(APPROACH / scale, up) + to_approach(0.0, down)
    path.write_text("\n".join(lines) + "\n")
    return len(lower.elements) + len(upper.elements)

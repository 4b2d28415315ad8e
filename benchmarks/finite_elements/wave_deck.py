# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks for CalculiX: a rigid wavy surface pressed onto an elastic-plastic half-space and lifted.

The model is three-dimensional: a quarter of the period, whose sides slide, in quadratic elements
with reduced integration that become longer with depth. Contact is face to face. Units are
millimetres, newtons and megapascals.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from .deck import FloatArray, contact, named, steel, step, surface

PERIOD = 1.0  # period along x and y [mm]
AMPLITUDE = 4e-3  # amplitude of the wave along x, and of the wave along y [mm]
PRESSURE = 1160.0  # mean pressure [MPa]: a fifth of the pressure that closes the elastic gap
LOADING_INCREMENTS, UNLOADING_INCREMENTS = 6, 3  # increments
FINE_DEPTH = 0.25  # periods; depth of the uniform part
GROWTH = 1.3  # growth factor of elements below the uniform part
DEPTH = 1.0  # periods to the bottom
OVERLAP = 1e-4  # initial overlap [mm]: without contact a load has no equilibrium
LIFT = 1e-4  # final lift beyond the initial position of the crest [mm]
STIFFNESS = 5e8  # contact stiffness [N/mm^3]: 10 nm of penetration

EDGES = (
    (0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7),
)  # fmt: skip
CORNERS = (
    (0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
)  # fmt: skip
At = tuple[int, int, int]


class Block(NamedTuple):
    """Mesh of one body: node numbers, lines of the deck, and element numbers."""

    nodes: dict[At, int]  # node numbers by position in x, y, z; corners have even indices
    lines: list[str]
    elements: dict[At, int]

    def plane(self, axis: int, *places: int) -> list[int]:
        """Return the numbers of the nodes in planes perpendicular to an axis, given by indices."""
        return [number for at, number in self.nodes.items() if at[axis] in places]

    def layer(self, k: int) -> list[int]:
        """Return the numbers of the elements of one layer."""
        return [number for at, number in self.elements.items() if at[2] == k]


def depths(across: int) -> FloatArray:
    """Return the depths of the element corners from the surface to the bottom [mm]."""
    step = 0.5 * PERIOD / across
    fine = round(FINE_DEPTH * PERIOD / step)
    found = [step * n for n in range(fine + 1)]
    while found[-1] < DEPTH * PERIOD:
        step *= GROWTH
        found.append(found[-1] + step)
    z = np.array(found)
    z[fine:] = z[fine] + (z[fine:] - z[fine]) * (DEPTH * PERIOD - z[fine]) / (z[-1] - z[fine])
    return z


def height(x: float, y: float) -> float:
    """Return the height of the wavy surface above its crest [mm]."""
    k = 2 * np.pi / PERIOD
    return float(AMPLITUDE * (2.0 - np.cos(k * x) - np.cos(k * y)))


def with_middles(corners: FloatArray) -> FloatArray:
    """Return the values and the midpoints between them."""
    return np.sort(np.r_[corners, 0.5 * (corners[1:] + corners[:-1])])


def block(
    name: str, x: FloatArray, z: FloatArray, wavy: bool, first_node: int, first_element: int
) -> Block:
    """Return the mesh with element corners at `x` along x and y, and at `z` along z [mm].

    If `wavy` is True, the nodes are raised by the height of the wavy surface.
    """
    across, down = with_middles(x), with_middles(z)
    nodes: dict[At, int] = {}
    lines = [f"*NODE, NSET=OF{name}"]
    for at in np.ndindex(len(across), len(across), len(down)):
        if sum(n % 2 for n in at) > 1:
            continue  # edges have one midside node; faces and the interior have none
        nodes[at] = first_node + len(nodes)
        place = across[at[0]], across[at[1]], down[at[2]]
        up = height(*place[:2]) - OVERLAP if wavy else 0.0
        lines.append(f"{nodes[at]}, {place[0]:.12g}, {place[1]:.12g}, {place[2] + up:.12g}")
    lines.append(f"*ELEMENT, TYPE=C3D20R, ELSET={name}")
    elements: dict[At, int] = {}
    middles = [tuple(np.add(CORNERS[a], CORNERS[b]) // 2) for a, b in EDGES]
    for at in np.ndindex(len(x) - 1, len(x) - 1, len(z) - 1):
        number = elements[at] = first_element + len(elements)
        i, j, k = (2 * n for n in at)
        own = [nodes[i + a, j + b, k + c] for a, b, c in (*CORNERS, *middles)]
        words = [str(n) for n in (number, *own)]
        lines += [", ".join(words[:11]) + ",", ", ".join(words[11:])]
    return Block(nodes, lines, elements)


def steps(pushed: int) -> list[str]:
    """Return the deck lines of both steps: load by a force on a node, unload by its motion."""
    printed = [
        "*NODE PRINT, NSET=PUSHED, FREQUENCY=10000", "U",
        "*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY, FREQUENCY=10000", "RF",
        "*EL PRINT, ELSET=ZONE, FREQUENCY=10000", "S, PEEQ",
        "*NODE PRINT, NSET=TOP, FREQUENCY=10000", "U",
    ]  # fmt: skip
    force = PRESSURE * (0.5 * PERIOD) ** 2
    return [
        *step(["*CLOAD", f"{pushed}, 3, {-force:.10g}"], LOADING_INCREMENTS, printed),
        *step(
            ["*CLOAD, OP=NEW", "*BOUNDARY", f"PUSHED, 3, 3, {OVERLAP + LIFT:g}"],
            UNLOADING_INCREMENTS,
            printed,
        ),
    ]


def write(path: Path, across: int) -> int:
    """Write a deck with `across` elements per half period; return how many the lower body has."""
    x = np.linspace(0.0, 0.5 * PERIOD, across + 1)
    z = -depths(across)[::-1]
    lower = block("LOWER", x, z, False, 1, 1)
    beyond = x[1]  # the rigid surface is one element wider
    wide, thick = np.r_[-beyond, x, x[-1] + beyond], np.array([0.0, beyond])
    upper = block("UPPER", wide, thick, True, len(lower.nodes) + 1, len(lower.elements) + 1)
    layers = len(z) - 1
    fine = round(FINE_DEPTH * PERIOD / beyond)
    pushed = upper.nodes[0, 0, 2]
    lines = [*lower.lines, *upper.lines]
    lines += named("NSET", "ACROSSX", lower.plane(0, 0, 2 * across))
    lines += named("NSET", "ACROSSY", lower.plane(1, 0, 2 * across))
    lines += named("NSET", "BOTTOM", lower.plane(2, 0))
    lines += named("NSET", "TOP", lower.plane(2, 2 * layers))
    lines += named("NSET", "PUSHED", [pushed])
    zone = [number for k in range(layers - fine, layers) for number in lower.layer(k)]
    lines += named("ELSET", "ZONE", zone)
    lines += surface("BELOW", lower.layer(layers - 1), "S2")
    lines += surface("ABOVE", upper.layer(0), "S1")
    lines += steel(False) + contact(STIFFNESS)
    for number in upper.nodes.values():
        if number != pushed:  # all nodes move with this one
            lines += ["*EQUATION", "2", f"{number}, 3, 1., {pushed}, 3, -1."]
    lines += ["*BOUNDARY", "OFUPPER, 1, 2", "ACROSSX, 1, 1", "ACROSSY, 2, 2", "BOTTOM, 3, 3"]
    path.write_text("\n".join(lines + steps(pushed)) + "\n")
    return len(lower.elements)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials and grids that several parts of the gallery use."""

from __future__ import annotations

import math

import samcontact as sc

RIGID = sc.Material.rigid()
CERAMIC = sc.Material.elastic(310e9, 0.29)
ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL_52100 = sc.Material.swift(210e9, 0.3, B=945e6, C=20, n=0.121)
STEEL_M50 = sc.Material.swift(210e9, 0.3, B=1280e6, C=4, n=0.095)
MICRO_STRAIN = 20e-6
"""Plastic strain at the micro-yield stress."""


def tolerance(quick: bool) -> float:
    """Return the tolerance; it is larger if quick, which changes results by less than 0.1 %."""
    return 1e-3 if quick else 1e-6


def square(
    a: float,
    cells: float,
    width: float,
    depth: float = 0.0,
    per_cell: int = 1,
    layer: float | None = None,
) -> sc.Grid:
    """Return a square grid; `width` and `depth` are its half-width and depth in multiples of a.

    The centre of one cell lies at the origin. With depth 0 the grid has no layers. cells: number of
    cells per length a [m]; per_cell: number of layers per cell size, unless `layer` gives the layer
    thickness [m].
    """
    n, d = 2 * int(width * cells) + 1, a / cells
    if depth == 0.0:
        return sc.Grid(n, n, d, d)
    if layer is None:
        return sc.Grid(n, n, d, d, int(depth * cells * per_cell), d / per_cell)
    return sc.Grid(n, n, d, d, math.ceil(depth * a / layer), layer)

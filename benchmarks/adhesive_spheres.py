# SPDX-License-Identifier: GPL-3.0-or-later
"""Retraction of a sphere with constant attraction, against the theory of Maugis (1992)."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence

import numpy as np

import samcontact as sc

from .study import table

RADIUS, WORK, MODULUS = 1e-6, 0.05, 1e9
RIGID, ELASTIC = sc.Material.rigid(), sc.Material.elastic(MODULUS, 0.0)
JKR = sc.adhesion.jkr(RADIUS, WORK, MODULUS)
FORCE = math.pi * WORK * RADIUS
RADIUS_AT_START = 1.6  # of the contact / that of JKR at pull-off
BOX = 2.2  # side of the grid / radius of the attraction at the start
TRANSITIONS = (0.1, 0.5, 1.0, 3.0)


def maugis_error(transition: float, cells: int, step: float = 0.05) -> float:
    """Return the largest error of the load along the stable branch, relative to pi w R.

    step: decrease of the approach in an increment, relative to the approach of JKR at pull-off.
    """
    stress = transition / 2 * (math.pi * WORK * (4 * MODULUS / 3) ** 2 / RADIUS) ** (1 / 3)
    sphere = sc.adhesion.maugis(RADIUS, WORK, MODULUS, stress)
    unit = JKR.radius_at_pull_off
    length = float(-JKR.approach(unit / 3 ** (2 / 3)))
    radii = np.linspace(0.02, RADIUS_AT_START, 300) * unit
    approach, load = sphere.approach(radii), sphere.load(radii)
    end = int(np.argmin(approach))
    path = np.arange(approach[-1], approach[end] + 0.05 * length, -step * length)
    size = BOX * float(sphere.outer_radius(radii[-1])) / cells
    grid = sc.Grid(cells, cells, size, size)
    law = sc.Adhesion.dugdale(WORK, stress)
    solver = sc.ContactSolver(grid, RIGID, ELASTIC, adhesion=law, tol=1e-9)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    solution, found = None, []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for at in path:
            start = None if solution is None else solution.pressure
            solution = solver.solve(gap, approach=at, initial_pressure=start)
            found.append(solution.load)
    return float(np.abs(found - np.interp(path, approach[end:], load[end:])).max() / FORCE)


def maugis(
    transitions: Sequence[float] = TRANSITIONS, cells: Sequence[int] = (64, 128, 256)
) -> str:
    """Return the table of the largest errors of the load along the stable branch."""
    rows = [
        [f"{one:g}", *(f"{100 * maugis_error(one, n):.2f} %" for n in cells)] for one in transitions
    ]
    return table(["λ", *(f"{n} × {n} cells" for n in cells)], rows)

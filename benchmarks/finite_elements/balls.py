# SPDX-License-Identifier: GPL-3.0-or-later
"""Axisymmetric contact of an elastic and an elastic-plastic ball, solved by both codes."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

import samcontact as sc
from samcontact import hertz
from samcontact.surfaces import paraboloid

from ..accuracy_cases import BALL, SWIFT
from ..accuracy_cases import STEEL as WITHOUT_FLOW
from ..steel import ELASTIC, RADIUS, STEEL
from ..truth import finest
from . import balls_deck as deck
from . import calculix
from .tables import (
    Points,
    Runs,
    both,
    difference_range,
    error_against,
    numbers,
    points,
    points_against,
    ratios,
    time_cells,
    time_rows,
    times,
)

ELEMENTS = (5, 10, 20)  # per Hertz radius
CELLS = (8, 16, 32, 64)
ACCURACIES = (0.05, 0.01, 0.002)
REFERENCE_SECONDS = 150.0  # time limit [s] of the reference for prescribed accuracies
FLATTER, SLOPES_ON = (1.0, 4.0), 10
REPEATS = 3  # runs to a prescribed accuracy; the minimum time counts
FIGURE = "finite_elements.png"
WEDGE = 180.0  # the model covers two degrees of the circumference
QUANTITIES = {
    "load": ("load [N]", 1.0),
    "von_mises": ("maximum von Mises stress [MPa]", 1e-6),
    "plastic_strain": ("maximum plastic strain [%]", 100.0),
    "residual_von_mises": ("maximum residual von Mises stress [MPa]", 1e-6),
    "print": ("imprint depth [µm]", 1e6),
}
CONTROLLED_QUANTITIES = {
    "load": "load",
    "von_mises": "max_von_mises_body2",
    "plastic_strain": "max_equivalent_plastic_strain_body2",
    "residual_von_mises": "max_residual_von_mises_body2",
    "print": "imprint_depth_body2",
}
"""Names of the quantities in `to_accuracy`."""
TEXT = """## Two balls

An elastic ball is pressed on an elastic-plastic ball of AISI 52100, each of 15 mm radius. The
approach of {approach:.3f} µm (1500 N, 4.1 GPa by Hertz) is applied in {up} increments and released
in {down}:

- CalculiX, axisymmetric: quadratic elements with reduced integration. The table states the number
  of elements on the contact radius. Elements are of uniform size up to {fine} contact radii in
  depth and width; each further element is {growth} times as large as the previous one, out to
  {far:.0f} contact radii. The contact is face to face, with a stiffness that permits 4 nm of
  interpenetration. This model has the advantage of two dimensions: samcontact does not use the
  axisymmetry.
- samcontact, three-dimensional: cubic cells. The table states the number of cells on the contact
  radius. `nz` is not given, and all settings have their defaults; samcontact detects the mirror
  planes.
- samcontact with a prescribed accuracy of 5, 1 and 0.2 % (`sc.to_accuracy`), which chooses cells
  and increments. The time includes all grids of the sequence; the table states the number of cells
  of the finest grid. The reference for these errors is the limit of both fine grids and small
  increments.

![Maximum error of two balls against time](../build/figures/finite_elements.png)

### Errors of two balls

{times}

{ratios}

### Results of two balls

{numbers}

Extrapolated to zero cell size, the two codes differ by {differ}. One reason is the slope of the
surface, which reaches {slope:.0f} % in the finite element model, whereas the surface of a
half-space is plane. In elastic contact, the finite elements differ from Hertz by {load:+.2f} % in
the load and by {stress:+.2f} % in the maximum von Mises stress; with a ball radius four times as
large, they differ by {flat_load:+.2f} and {flat_stress:+.2f} %. CalculiX evaluates stress and
strain at integration points near the axis, samcontact at cell centres on the axis.
"""


def solve(across: int) -> dict[str, float]:
    """Solve the contact by samcontact; return number of cells, processor time [s] and results."""
    start = time.process_time()
    cell = 1e-3 * deck.CONTACT / across
    n = 2 * int(1.25 * across) + 1
    grid = sc.Grid(n, n, cell, cell, dz=cell)
    simulation = sc.Simulation(grid, ELASTIC, STEEL, lambda grid: paraboloid(grid, RADIUS))
    for part in range(1, deck.LOADING_INCREMENTS + 1):
        loaded = simulation.step(approach=1e-3 * deck.APPROACH * part / deck.LOADING_INCREMENTS)
    found = {
        "load": loaded.load,
        "von_mises": float(loaded.von_mises(2).max()),
        "plastic_strain": float(loaded.equivalent_plastic_strain(2).max()),
    }
    for part in range(1, deck.UNLOADING_INCREMENTS + 1):
        released = simulation.step(load=loaded.load * (1 - part / deck.UNLOADING_INCREMENTS))
    found["residual_von_mises"] = float(released.von_mises(2).max())
    found["print"] = float(released.residual_displacement(2).max())
    return {"cells": n * n * len(loaded.depths), "seconds": time.process_time() - start, **found}


def finite_elements(folder: Path, across: int, flatter: float | None = None) -> dict[str, float]:
    """Solve by finite elements; return number of elements, processor time [s] and results.

    flatter: as for `balls_deck.write`.

    Raises
    ------
    RuntimeError
        CalculiX fails.
    """
    elements = deck.write(folder / calculix.DECK, across, flatter)
    spent = calculix.run(folder)
    return {"elements": elements, "seconds": spent, **numbers_of(folder / calculix.PRINTED)}


def numbers_of(file: Path) -> dict[str, float]:
    """Return load, stresses, strain and imprint depth, read from the output of CalculiX."""
    tables = calculix.tables_of(file)
    loaded, released = tables["stresses", "AXIAL"]
    strain = tables["equivalent plastic strain", "AXIAL"][0]
    force = tables["total force", "TOP"][0]
    return {
        "load": -WEDGE * float(force[0, 1]),
        "von_mises": float(calculix.von_mises(loaded).max()),
        "plastic_strain": float(strain[:, 2].max()),
        "residual_von_mises": float(calculix.von_mises(released).max()),
        "print": -1e-3 * float(tables["displacements", "APEX"][1][0, 2]),
    }


CASE = {
    "body1": WITHOUT_FLOW, "body2": SWIFT, "surface": BALL,
    "path": [{"approach": 1e-3 * deck.APPROACH}, {"approach": 0.0}],
}  # fmt: skip


def limit() -> dict[str, float]:
    """Return the quantities in the limit of fine grids and small increments."""
    truth = finest(CASE, REFERENCE_SECONDS)
    return {quantity: truth[name] for quantity, name in CONTROLLED_QUANTITIES.items()}


def measure_accuracy(accuracy: float) -> dict[str, float]:
    """Solve to a prescribed accuracy; return number of cells, processor time [s] and results."""
    timed = []
    for _ in range(REPEATS):
        start = time.process_time()
        run = sc.to_accuracy(CASE, accuracy, quantities=list(CONTROLLED_QUANTITIES.values()))
        timed.append(time.process_time() - start)
    values = {quantity: run.values[name] for quantity, name in CONTROLLED_QUANTITIES.items()}
    cells = run.grid.nx * run.grid.ny * len(run.states[-1].depths)
    return {"cells": cells, "seconds": min(timed), **values}


def measure_slopes(flatter: float) -> dict[str, float]:
    """Return load and von Mises stress of an elastic FE contact, divided by the Hertz values."""
    with tempfile.TemporaryDirectory() as folder:
        run = finite_elements(Path(folder), SLOPES_ON, flatter)
    approach = 1e-3 * deck.APPROACH / flatter
    modulus = hertz.effective_modulus(ELASTIC, ELASTIC)
    expected = hertz.point(R=RADIUS * flatter, E_star=modulus, approach=approach)
    stress = run["von_mises"] / expected.max_von_mises(0.3)[0]
    return {"load": run["load"] / expected.load, "von_mises": stress}


def section(found: dict[str, Runs]) -> str:
    """Return the text of the section on the balls."""
    runs = both(found)
    name = "elements or cells on the contact radius"
    rows = time_rows(runs, QUANTITIES)
    for accuracy, run in found["an accuracy"].items():
        error = error_against(found["truth"]["0"], run, QUANTITIES)
        cells = time_cells(f"{run['cells']} cells (finest grid)", error, run)
        rows.append([f"samcontact, to {100 * float(accuracy):g} %", "", *cells])
    off = {
        at: {q: 100 * (run[q] - 1) for q in ("load", "von_mises")}
        for at, run in found["slopes"].items()
    }
    return TEXT.format(
        load=off["1"]["load"],
        stress=off["1"]["von_mises"],
        flat_load=off["4"]["load"],
        flat_stress=off["4"]["von_mises"],
        approach=1e3 * deck.APPROACH,
        up=deck.LOADING_INCREMENTS,
        down=deck.UNLOADING_INCREMENTS,
        fine=deck.FINE_RADIUS,
        growth=deck.GROWTH,
        far=deck.OUTER_RADIUS,
        times=times(name, rows),
        ratios=ratios(runs["CalculiX"], QUANTITIES, ours(found)),
        numbers=numbers(name, runs, QUANTITIES),
        differ=difference_range(runs, QUANTITIES),
        slope=100 * deck.FINE_RADIUS * deck.CONTACT / deck.RADIUS,
    )


def ours(found: dict[str, Runs]) -> dict[str, Points]:
    """Return errors and times of samcontact, by the way in which its grid is chosen."""
    return {
        "a grid": points(found["samcontact"], QUANTITIES),
        "an accuracy": points_against(found["truth"]["0"], found["an accuracy"], QUANTITIES),
    }

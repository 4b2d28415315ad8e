# SPDX-License-Identifier: GPL-3.0-or-later
"""An elastic ball on a ball that yields, by both codes and to accuracies; it has an axis."""

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
    apart,
    both,
    error_against,
    numbers,
    points,
    points_against,
    ratios,
    time_cells,
    time_rows,
    times,
)

ELEMENTS = (5, 10, 20)  # on the Hertz radius
CELLS = (8, 16, 32, 64)
ACCURACIES = (0.05, 0.01, 0.002)
REFERENCE_SECONDS = 150.0  # s for what these are compared with
FLATTER, SLOPES_ON = (1.0, 4.0), 10
REPEATS = 3  # of what is asked for to an accuracy: the least time counts
FIGURE = "finite_elements.png"
WEDGE = 180.0  # two degrees of the circumference are modelled
QUANTITIES = {
    "load": ("load [N]", 1.0),
    "von_mises": ("largest von Mises stress [MPa]", 1e-6),
    "plastic_strain": ("largest plastic strain [%]", 100.0),
    "residual_von_mises": ("largest residual von Mises stress [MPa]", 1e-6),
    "print": ("depth of the print [µm]", 1e6),
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

An elastic ball on a ball of AISI 52100 that yields, of 15 mm radius each: pressed by
{approach:.3f} µm (1500 N, 4.1 GPa by Hertz) in {up} increments, and released in {down}:

- CalculiX, axisymmetric: quadratic
  elements with reduced integration, as many on the contact's radius as the table says, evenly down
  to {fine} radii and beside it, then each {growth} times as large as the last, out to
  {far:.0f} radii; contact face to face with a stiffness that lets 4 nm through. It has the
  advantage of two dimensions: the scene has an axis, of which samcontact does not know.
- samcontact, three-dimensional: cubic cells, as many on the contact's radius, no `nz`, all settings
  as they come; the mirror planes are found;
- the same asked for to 5, 1 and 0.2 % (`sc.to_accuracy`), which chooses cells and increments;
  its time is that of all its grids. Its limit is also that of ever more increments.

![Largest error of two balls over time](../build/figures/finite_elements.png)

### Errors of two balls

{times}

{ratios}

### Numbers of two balls

{numbers}

The limits differ by {differ}: the finite elements' surface has slopes, up to {slope:.0f} % here,
while half-spaces are plane. Without flow, finite elements differ from Hertz by {load:+.2f} % in
the load and {stress:+.2f} % in the largest von Mises stress; with a radius four times as large by
{flat_load:+.2f} and {flat_stress:+.2f} %. CalculiX has stress and strain at integration points
beside the axis, samcontact in the middle of cells on it.
"""


def solve(across: int) -> dict[str, float]:
    """The scene of the decks with so many cells on the Hertz radius; time [s] of the processor."""
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
    """Numbers of the scene on a mesh, with its elements and the processor's time [s].

    flatter: as of decks.

    Raises
    ------
    RuntimeError
        When CalculiX fails.
    """
    elements = deck.write(folder / calculix.DECK, across, flatter)
    spent = calculix.run(folder)
    return {"elements": elements, "seconds": spent, **numbers_of(folder / calculix.PRINTED)}


def numbers_of(file: Path) -> dict[str, float]:
    """Load, stresses, strain and print of what was printed at the ends of both steps."""
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
    """Limit of the scene for finer grids and more increments."""
    truth = finest(CASE, REFERENCE_SECONDS)
    return {quantity: truth[name] for quantity, name in CONTROLLED_QUANTITIES.items()}


def measure_accuracy(asked: float) -> dict[str, float]:
    """The scene to an accuracy."""
    timed = []
    for _ in range(REPEATS):
        start = time.process_time()
        run = sc.to_accuracy(CASE, asked, quantities=list(CONTROLLED_QUANTITIES.values()))
        timed.append(time.process_time() - start)
    values = {quantity: run.values[name] for quantity, name in CONTROLLED_QUANTITIES.items()}
    cells = run.grid.nx * run.grid.ny * len(run.states[-1].depths)
    return {"cells": cells, "seconds": min(timed), **values}


def measure_slopes(flatter: float) -> dict[str, float]:
    """What the slopes of the surface do to an elastic contact: numbers over those of Hertz."""
    with tempfile.TemporaryDirectory() as folder:
        run = finite_elements(Path(folder), SLOPES_ON, flatter)
    approach = 1e-3 * deck.APPROACH / flatter
    modulus = hertz.effective_modulus(ELASTIC, ELASTIC)
    expected = hertz.point(R=RADIUS * flatter, E_star=modulus, approach=approach)
    stress = run["von_mises"] / expected.max_von_mises(0.3)[0]
    return {"load": run["load"] / expected.load, "von_mises": stress}


def section(found: dict[str, Runs]) -> str:
    """Of the page."""
    runs = both(found)
    name = "on the radius"
    rows = time_rows(runs, QUANTITIES)
    for asked, run in found["an accuracy"].items():
        error = error_against(found["truth"]["0"], run, QUANTITIES)
        cells = time_cells(f"{run['cells']} cells and coarser", error, run)
        rows.append([f"samcontact, to {100 * float(asked):g} %", "", *cells])
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
        differ=apart(runs, QUANTITIES),
        slope=100 * deck.FINE_RADIUS * deck.CONTACT / deck.RADIUS,
    )


def ours(found: dict[str, Runs]) -> dict[str, Points]:
    """Errors and times of samcontact, by how its cells are chosen."""
    return {
        "a grid": points(found["samcontact"], QUANTITIES),
        "an accuracy": points_against(found["truth"]["0"], found["an accuracy"], QUANTITIES),
    }

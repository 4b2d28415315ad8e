# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.finite_elements: two balls by finite elements and by samcontact.

On one thread: OMP_NUM_THREADS must be 1. Writes what was measured to results.json, and with --docs
a page of the documentation.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
import time
from pathlib import Path

import matplotlib.pyplot as plt

import samcontact as sc
from samcontact import hertz
from samcontact.surfaces import paraboloid

from ..accuracy import finest
from ..accuracy_cases import BALL, SWIFT
from ..accuracy_cases import STEEL as WITHOUT_FLOW
from ..harness import ROOT
from ..steel import ELASTIC, RADIUS, STEEL
from . import calculix, deck
from .page import ASKED_FOR, Runs, error_against, error_of, page

KEPT = Path(__file__).parent / "results.json"
PAGE = ROOT / "docs" / "finite_elements.md"
FIGURE = ROOT / "docs" / "figures" / "finite_elements.png"
ELEMENTS = (5, 10, 20)  # on the Hertz radius
CELLS = (8, 16, 32, 64)
ASKED = (0.05, 0.01, 0.002)
TRUTH = 150.0  # s for what these are compared with
FLATTER, SLOPES_ON = (1.0, 4.0), 10
REPEATS = 3  # the least time counts: what disturbs only adds


def solve(across: int) -> dict[str, float]:
    """The scene of the decks with so many cells on the Hertz radius; time [s] of the processor."""
    start = time.process_time()
    cell = 1e-3 * deck.CONTACT / across
    n = 2 * int(1.25 * across) + 1
    grid = sc.Grid(n, n, cell, cell, dz=cell)
    simulation = sc.Simulation(grid, ELASTIC, STEEL, lambda grid: paraboloid(grid, RADIUS))
    for part in range(1, deck.UP + 1):
        loaded = simulation.step(approach=1e-3 * deck.APPROACH * part / deck.UP)
    found = {
        "load": loaded.load,
        "von_mises": float(loaded.von_mises(2).max()),
        "plastic_strain": float(loaded.equivalent_plastic_strain(2).max()),
    }
    for part in range(1, deck.DOWN + 1):
        released = simulation.step(load=loaded.load * (1 - part / deck.DOWN))
    found["residual_von_mises"] = float(released.von_mises(2).max())
    found["print"] = float(released.residual_displacement(2).max())
    return {"cells": n * n * len(loaded.depths), "seconds": time.process_time() - start, **found}


def measure(elements: tuple[int, ...], cells: tuple[int, ...]) -> dict[str, Runs]:
    """Both codes on all meshes, by name and size."""
    found: dict[str, Runs] = {"CalculiX": {}, "samcontact": {}}
    for across in cells:
        runs = [solve(across) for _ in range(REPEATS)]
        found["samcontact"][str(across)] = min(runs, key=lambda run: run["seconds"])
        print("samcontact", across, found["samcontact"][str(across)], flush=True)
    for across in elements:
        with tempfile.TemporaryDirectory() as folder:
            found["CalculiX"][str(across)] = calculix.solve(Path(folder), across)
        print("CalculiX", across, found["CalculiX"][str(across)], flush=True)
    return found


def measure_accuracy() -> dict[str, Runs]:
    """The scene to accuracies, and what it tends to with finer grids and more increments."""
    case = {
        "body1": WITHOUT_FLOW, "body2": SWIFT, "surface": BALL,
        "path": [{"approach": 1e-3 * deck.APPROACH}, {"approach": 0.0}],
    }  # fmt: skip
    truth = finest(case, TRUTH)
    found: dict[str, Runs] = {"truth": {"limit": {q: truth[n] for q, n in ASKED_FOR.items()}}}
    found["runs"] = {}
    for asked in ASKED:
        timed = []
        for _ in range(REPEATS):
            start = time.process_time()
            run = sc.to_accuracy(case, asked, quantities=list(ASKED_FOR.values()))
            timed.append(time.process_time() - start)
        values = {quantity: run.values[name] for quantity, name in ASKED_FOR.items()}
        cells = run.grid.nx * run.grid.ny * len(run.states[-1].depths)
        found["runs"][f"{asked:g}"] = {"cells": cells, "seconds": min(timed), **values}
        print("to an accuracy", asked, found["runs"][f"{asked:g}"], flush=True)
    return found


def measure_slopes() -> Runs:
    """What the slopes of the surface do to an elastic contact: numbers over those of Hertz."""
    found: Runs = {}
    modulus = hertz.effective_modulus(ELASTIC, ELASTIC)
    for flatter in FLATTER:
        with tempfile.TemporaryDirectory() as folder:
            run = calculix.solve(Path(folder), SLOPES_ON, flatter)
        approach = 1e-3 * deck.APPROACH / flatter
        expected = hertz.point(R=RADIUS * flatter, E_star=modulus, approach=approach)
        found[f"{flatter:g}"] = {
            "load": run["load"] / expected.load,
            "von_mises": run["von_mises"] / expected.max_von_mises(0.3)[0],
        }
    return found


def draw(results: dict[str, Runs], accuracy: dict[str, Runs]) -> None:
    """Largest error of all quantities over time."""
    figure, ax = plt.subplots(figsize=(5.2, 3.6), layout="constrained")
    for (code, runs), marker in zip(results.items(), "so", strict=True):
        errors = [error_of(runs, size) for size in runs]
        seconds = [run["seconds"] for run in runs.values()]
        ax.loglog(seconds, [100 * e for e in errors], marker=marker, label=code)
    runs, truth = accuracy["runs"], accuracy["truth"]["limit"]
    errors = [error_against(truth, run) for run in runs.values()]
    seconds = [run["seconds"] for run in runs.values()]
    label = "samcontact, to an accuracy"
    ax.loglog(seconds, [100 * e for e in errors], marker="d", label=label)
    ax.set(xlabel="processor's time [s]", ylabel="largest error [%]")
    ax.grid(which="major", alpha=0.3)
    ax.legend()
    figure.savefig(FIGURE, dpi=150)


def main() -> None:
    """Measure, keep, and write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="coarse meshes only, keep nothing")
    parser.add_argument("--docs", action="store_true", help="write the page of the documentation")
    parser.add_argument("--accuracy", action="store_true", help="to accuracies anew, keep the rest")
    parser.add_argument("--page", action="store_true", help="only that, from what is kept")
    given = parser.parse_args()
    if not given.page and os.environ.get("OMP_NUM_THREADS") != "1":
        parser.error("both codes are to have one thread: set OMP_NUM_THREADS=1")
    if given.quick:
        measure(ELEMENTS[:1], CELLS[:2])
        return
    if given.accuracy:
        kept = json.loads(KEPT.read_text(encoding="utf-8")) | {"accuracy": measure_accuracy()}
        KEPT.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")
    elif not given.page:
        kept = {
            "runs": measure(ELEMENTS, CELLS),
            "slopes": measure_slopes(),
            "accuracy": measure_accuracy(),
        }
        KEPT.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")
    if given.docs or given.page:
        results = json.loads(KEPT.read_text(encoding="utf-8"))
        draw(results["runs"], results["accuracy"])
        PAGE.write_text(page(**results), encoding="utf-8")


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.wear_convergence: what wear and running-in depend on, as a page of the docs.

Both scenes of Boucly's thesis (2008), section 5.2, with cells, layers and increments made smaller
one at a time: with the filter that has a length in metres, and with the thesis's in cells.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from .harness import ROOT

PAGE = ROOT / "docs" / "wear_convergence.md"
KEPT = Path(__file__).with_suffix(".json")
SMOOTHING = 7.2e-6  # m: spreads as far as a moving mean over half a wavelength of 50 um
HEAD = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.wear_convergence --docs -->
# Convergence of wear and running-in

Both scenes of section 5.2 of the thesis ([running-in](gallery/running_in.md),
[wear](gallery/wear.md)), with cells dx, layers dz and load increments made smaller, one at a
time. Volumes are those removed in all cycles.
"""
TEXTS = {
    "gaussian": """## Running-in, a filter with a length

`smoothing_length` = 7.2 µm, which spreads as far as a moving mean over half a wavelength of the
roughness (25 µm). A Gaussian leaves no edges, and running-in stops on every mesh. The last cycles
wear next to nothing. How many of them there are depends on the layers: they decide at which depth
the strain of the surface is compared with the threshold.
""",
    "cells": """## Running-in, the thesis's filter

A moving mean over 25 µm (`window` in cells, `order` 1), as far as the cells allow. Its border is
a ramp with sharp edges. On coarse cells they are no sharper than a cell, and running-in stops. On
finer ones each edge carries the next contact, at a pressure that grows as the cells shrink, is
strained beyond the threshold, breaks off, and leaves edges of its own: the volume of a cycle
rises again, and nothing stops. The pressure of a sharp edge grows without limit as the cells
shrink, so that no finer mesh removes it.
""",
    "lens": """## Wear of the flat surface

Two balls under 2000 N, `smoothing_length` = 87 µm (a moving mean over 300 µm). The first cycle
removes a lens deeper than the balls came closer, and the contacts after it run on its rim, beyond
the Hertz pressure and with strains beyond those of a small-strain theory: wear does not stop, and
each cycle depends more on the mesh than the one before.
""",
}
COMPARED = {
    "gaussian": (
        2.5,
        ("volume [µm³]", "largest pressure, last cycle [GPa]", "roughness that is left [µm]"),
    ),
    "lens": (45.0, tuple(f"volume of cycle {n} [mm³]" for n in (1, 2, 3))),
}


@dataclass
class Scene:
    """One run: cells and layers [m], load increments, and what smooths the border."""

    dx: float
    dz: float
    increments: int
    filter: dict[str, Any]

    def grid(self, side: float, depth: float) -> Any:
        import samcontact as sc

        count = 2 * round(0.5 * side / self.dx) + 1
        return sc.Grid(count, count, self.dx, self.dx, round(depth / self.dz), self.dz)


def solve(scene: Scene, side: float, depth: float, load: float, rough: bool, cycles: int) -> Any:
    """The wear, with the thesis's ball and steel."""
    import samcontact as sc
    from gallery.wear import ELASTIC, FRICTION, RADIUS, STEEL, THRESHOLD

    grid = scene.grid(side, depth)
    relief = sc.Relief(sc.surfaces.sinusoidal(grid, 0.5e-6, 50e-6, 50e-6)) if rough else None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return sc.wear.run(
            grid,
            ELASTIC,
            STEEL,
            sc.surfaces.paraboloid(grid, RADIUS),
            cycle=sc.paths.load_unload(load=load, increments=scene.increments, unload_increments=1),
            threshold=THRESHOLD,
            cycles=cycles,
            friction=FRICTION,
            relief2=relief,
            progress=False,
            **scene.filter,
        )


def running_in(scene: Scene) -> dict[str, str]:
    found = solve(scene, 335e-6, 20e-6, 30.0, True, 16)
    x, y = found.x(), found.grid.y
    middle = np.hypot(x[:, None], y[None, :]) < 75e-6
    last = found.cycles[-1]
    worn = np.cumsum(found.rate)
    cycles = f"{len(found.cycles) - 1}" if found.stopped else "does not stop in 16"
    return _mesh(scene) | {
        "cycles that wear": cycles,
        "for 99 % of the volume": str(int(np.searchsorted(worn / worn[-1], 0.99)) + 1),
        "volume [µm³]": f"{1e18 * found.rate.sum():.0f}",
        "of the last cycle [µm³]": f"{1e18 * found.rate[-1]:.3g}",
        "largest pressure, last cycle [GPa]": f"{1e-9 * last.max_pressure:.2f}",
        "roughness that is left [µm]": f"{1e6 * found.profile(-1)[middle].std():.3f}",
    }


def lens(scene: Scene) -> dict[str, str]:
    found = solve(scene, 3.6e-3, 650e-6, 2000.0, False, 3)
    values = _mesh(scene)
    for cycle in found.cycles:
        values[f"volume of cycle {cycle.number} [mm³]"] = f"{1e9 * sum(cycle.volume):.4f}"
    values["depth after the first [µm]"] = f"{1e6 * found.cycles[0].depth[0]:.1f}"
    values["largest pressure, cycles 1 to 3 [GPa]"] = ", ".join(
        f"{1e-9 * cycle.max_pressure:.2f}" for cycle in found.cycles
    )
    return values


def _mesh(scene: Scene) -> dict[str, str]:
    return {
        "dx [µm]": f"{1e6 * scene.dx:.3g}",
        "dz [µm]": f"{1e6 * scene.dz:.3g}",
        "increments": str(scene.increments),
    }


def scenes() -> Iterator[tuple[str, Callable[[Scene], dict[str, str]], Scene]]:
    um = 1e-6
    smooth = {"smoothing_length": SMOOTHING}
    meshes = [(5, 1, 1), (10 / 3, 1, 1), (2.5, 1, 1), (5 / 3, 1, 1), (1.25, 1, 1), (2.5, 0.5, 1),
              (2.5, 0.25, 1), (2.5, 1, 2), (2.5, 1, 4), (5 / 3, 0.5, 2)]  # fmt: skip
    for dx, dz, increments in meshes:
        yield "gaussian", running_in, Scene(dx * um, dz * um, increments, smooth)
    for dx, window in ((5, 5), (25 / 7, 7), (25 / 9, 9), (25 / 15, 15)):
        thesis = {"window": window, "order": 1}
        yield "cells", running_in, Scene(dx * um, um, 1, thesis)
    for dx, dz, increments in ((60, 24, 1), (45, 24, 1), (30, 24, 1), (45, 12, 1), (45, 24, 4)):
        wide = {"smoothing_length": 300 * um / 12**0.5}
        yield "lens", lens, Scene(dx * um, dz * um, increments, wide)


def _run(task: tuple[str, Callable[[Scene], dict[str, str]], Scene]) -> dict[str, str]:
    _, study, scene = task
    return study(scene)


def spread(rows: list[dict[str, str]], finest: float, names: tuple[str, ...]) -> str:
    """By how much values differ between the meshes of cells up to this size [µm]."""
    fine = [row for row in rows if float(row["dx [µm]"]) <= finest]
    parts = []
    for name in names:
        values = np.array([float(row[name]) for row in fine])
        share = 100 * (values.max() - values.min()) / (values.max() + values.min())
        parts.append(f"{name.rsplit(' [', 1)[0]} ±{share:.0f} %")
    return f"Between the meshes with dx up to {finest:g} µm: {', '.join(parts)}."


def table(rows: list[dict[str, str]]) -> str:
    lines = [list(rows[0]), ["---"] * len(rows[0]), *(list(row.values()) for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


Rows = dict[str, list[dict[str, str]]]
"""Lines of each table, as they are written."""


def kept() -> Rows:
    found: Rows = json.loads(KEPT.read_text(encoding="utf-8"))
    return found


def page(rows: Rows) -> str:
    """All of it."""
    parts = [
        f"{text}\n{table(rows[name])}\n\n{spread(rows[name], *COMPARED[name])}\n"
        if name in COMPARED
        else f"{text}\n{table(rows[name])}\n"
        for name, text in TEXTS.items()
    ]
    return "\n".join([HEAD, *parts])


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.wear_convergence")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--docs", action="store_true", help=f"write {PAGE.relative_to(ROOT)}")
    chosen = parser.parse_args(given)
    os.environ["OMP_NUM_THREADS"] = "1"
    tasks = list(scenes())
    show = partial(print, flush=True)
    rows: Rows = {name: [] for name in TEXTS}
    with ProcessPoolExecutor(chosen.processes) as pool:
        for (name, *_), row in zip(tasks, pool.map(_run, tasks), strict=True):
            rows[name].append(row)
            show(name, row)
    if chosen.docs:
        KEPT.write_text(json.dumps(rows, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        PAGE.write_text(page(rows), encoding="utf-8")
    else:
        show(page(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())

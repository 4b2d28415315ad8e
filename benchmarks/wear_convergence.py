# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.wear_convergence: convergence of wear and running-in, as a page.

Both contacts of Boucly's thesis (2008), section 5.2, on several meshes: with a filter length
given in metres, and with the filter of the thesis, whose length is given in cells.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import samcontact as sc
from gallery.wear import ELASTIC, FRICTION, RADIUS, STEEL, THRESHOLD

from .study import Record, Study, by_group, table_of

SMOOTHING = 7.2e-6  # m: equivalent to a moving average over 25 um, half a wavelength
HEAD = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.wear_convergence --docs -->
# Convergence of wear and running-in

This page shows how computed wear and running-in depend on the mesh and on the smoothing of the worn
surface. Both contacts of section 5.2 of Boucly's thesis ([running-in](gallery/running_in.md),
[wear](gallery/wear.md)) are solved with smaller cells dx, thinner layers dz and more load
increments. Volumes are sums over all cycles.
"""
TEXTS = {
    "gaussian": """## Running-in with a filter of fixed length

The smoothing length is 7.2 µm (`smoothing_length`), equivalent to a moving average over 25 µm, half
a wavelength of the roughness. A Gaussian filter leaves no edges, and running-in ends on every mesh.
The last cycles remove almost nothing. The number of these cycles depends on the thickness of the
layers, which determines the depth at which the strain is compared with the threshold.
""",
    "cells": """## Running-in with the filter of the thesis

The filter is a moving average over 25 µm (`window` in cells, `order` 1), as closely as the cells
permit. The border of the worn region is then a ramp with sharp edges. On coarse grids the edges are
no sharper than a cell, and running-in ends. On finer grids the next contact is on these edges, at a
pressure that increases as the cells shrink. The edge is strained beyond the threshold, is removed,
and leaves new edges: the volume per cycle increases again, and wear does not cease. The pressure at
a sharp edge grows without limit as the cells shrink, so refinement does not help.
""",
    "lens": """## Wear of the smooth surface

Two smooth balls are loaded by 2000 N, with a smoothing length of 87 µm (equivalent to a moving
average over 300 µm). The first cycle removes a lens deeper than the approach of the balls. The
contacts of the following cycles are on the rim of this pit; the pressures there exceed the Hertz
pressure, and the strains exceed the small-strain limit. Wear does not cease, and each cycle depends
more on the mesh than the previous one.
""",
}
COMPARED = {
    "gaussian": (
        2.5,
        ("volume [µm³]", "maximum pressure, last cycle [GPa]", "residual roughness [µm]"),
    ),
    "lens": (45.0, tuple(f"volume of cycle {n} [mm³]" for n in (1, 2, 3))),
}


FILTERS: dict[str, dict[str, Any]] = {
    "gaussian": {"smoothing_length": SMOOTHING},
    "lens": {"smoothing_length": 300e-6 / 12**0.5},
}
"""Arguments for smoothing the edge of the wear, by group of points."""


def solve(
    point: Record, side: float, depth: float, load: float, rough: bool, cycles: int
) -> sc.wear.WearResult:
    """Compute the wear for the ball and the steel of Boucly's thesis."""
    dx, dz = point["dx"], point["dz"]
    count = 2 * round(0.5 * side / dx) + 1
    grid = sc.Grid(count, count, dx, dx, round(depth / dz), dz)
    relief = sc.Relief(sc.surfaces.sinusoidal(grid, 0.5e-6, 50e-6, 50e-6)) if rough else None
    window = {"window": point["window"], "order": 1} if "window" in point else {}
    return sc.wear.run(
        grid,
        ELASTIC,
        STEEL,
        sc.surfaces.paraboloid(grid, RADIUS),
        cycle=sc.paths.load_unload(load=load, increments=point["increments"], unload_increments=1),
        threshold=THRESHOLD,
        cycles=cycles,
        friction=FRICTION,
        relief2=relief,
        progress=False,
        **FILTERS.get(point["of"], window),
    )


def run(**point: Any) -> Record:
    """Simulate the wear on a mesh; return a row of the table."""
    return {"line": lens(point) if point["of"] == "lens" else running_in(point)}


def mesh(point: Record) -> dict[str, str]:
    """Return the columns of a row that describe the mesh."""
    return {
        "dx [µm]": f"{1e6 * point['dx']:.3g}",
        "dz [µm]": f"{1e6 * point['dz']:.3g}",
        "increments": str(point["increments"]),
    }


def running_in(point: Record) -> dict[str, str]:
    found = solve(point, 335e-6, 20e-6, 30.0, True, 16)
    x, y = found.x(), found.grid.y
    middle = np.hypot(x[:, None], y[None, :]) < 75e-6
    last = found.cycles[-1]
    worn = np.cumsum(found.rate)
    cycles = f"{len(found.cycles) - 1}" if found.stopped else "not ceased in 16"
    return {
        "cycles with wear": cycles,
        "cycles for 99 % of the volume": str(int(np.searchsorted(worn / worn[-1], 0.99)) + 1),
        "volume [µm³]": f"{1e18 * found.rate.sum():.0f}",
        "volume of the last cycle [µm³]": f"{1e18 * found.rate[-1]:.3g}",
        "maximum pressure, last cycle [GPa]": f"{1e-9 * last.max_pressure:.2f}",
        "residual roughness [µm]": f"{1e6 * found.profile(-1)[middle].std():.3f}",
    }


def lens(point: Record) -> dict[str, str]:
    found = solve(point, 3.6e-3, 650e-6, 2000.0, False, 3)
    volumes = {f"volume of cycle {one.number} [mm³]": f"{1e9 * sum(one.volume):.4f}"
               for one in found.cycles}  # fmt: skip
    pressures = ", ".join(f"{1e-9 * cycle.max_pressure:.2f}" for cycle in found.cycles)
    return volumes | {
        "depth after cycle 1 [µm]": f"{1e6 * found.cycles[0].depth[0]:.1f}",
        "maximum pressure, cycles 1 to 3 [GPa]": pressures,
    }


def points(quick: bool) -> list[Record]:
    um = 1e-6
    meshes = [(5, 1, 1), (10 / 3, 1, 1), (2.5, 1, 1), (5 / 3, 1, 1), (1.25, 1, 1), (2.5, 0.5, 1),
              (2.5, 0.25, 1), (2.5, 1, 2), (2.5, 1, 4), (5 / 3, 0.5, 2)]  # fmt: skip
    wide = [(60, 24, 1), (45, 24, 1), (30, 24, 1), (45, 12, 1), (45, 24, 4)]
    found = [
        {"of": name, "dx": dx * um, "dz": dz * um, "increments": increments}
        for name, some in (("gaussian", meshes), ("lens", wide))
        for dx, dz, increments in some
    ]
    windows = ((5, 5), (25 / 7, 7), (25 / 9, 9), (25 / 15, 15))
    found += [{"of": "cells", "dx": dx * um, "dz": um, "increments": 1, "window": window}
              for dx, window in windows]  # fmt: skip
    return [point for point in found if point["of"] == "lens"][:1] if quick else found


def spread(rows: list[dict[str, str]], finest: float, names: tuple[str, ...]) -> str:
    """Return a sentence on the spread of values between meshes with cells up to this size [µm]."""
    fine = [row for row in rows if float(row["dx [µm]"]) <= finest]
    parts = []
    for name in names:
        values = np.array([float(row[name]) for row in fine])
        share = 100 * (values.max() - values.min()) / (values.max() + values.min())
        quantity = name.rsplit(" [", 1)[0].replace(", ", " of the ")
        parts.append(f"{quantity} ±{share:.0f} %")
    return f"Spread between the meshes with dx up to {finest:g} µm: {'; '.join(parts)}."


def page(records: list[Record]) -> str:
    """Return the text of the page."""
    parts = [HEAD]
    for name, text in TEXTS.items():
        rows = [mesh(record) | record["line"] for record in by_group(records)[name]]
        parts.append(f"{text}\n{table_of(rows)}\n")
        if name in COMPARED:
            parts[-1] += f"\n{spread(rows, *COMPARED[name])}\n"
    return "\n".join(parts)


STUDY = Study("wear_convergence", "Convergence of wear and running-in.", points, run, page)

if __name__ == "__main__":
    STUDY.main()

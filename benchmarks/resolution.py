# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.resolution: page of the documentation on resolution of rough contact.

One rough surface, a sum of waves, is pressed onto steel on increasingly fine grids.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import scipy

import samcontact as sc
import samcontact.diagnostics.resolution as resolution
from gallery.profiles import von_mises

from .harness import peak_memory
from .roughness import heights, surface_rms, wave_amplitudes
from .steel import STEEL
from .study import Record, Study, table

MIN_WAVELENGTH = 16e-6  # m, wavelength
WAVES = 8  # number of shortest waves along a side
SIDE = WAVES * MIN_WAVELENGTH
MIN_WAVES = 2  # number of longest waves along a side
HURST, SLOPE, SEED = 0.8, 0.06, 5
BOWL = 3.0  # height of the raised border over the rms roughness: keeps the contact inside
DEPTH = MIN_WAVELENGTH / 20  # m; depth below which the residual stress converges
HARDNESS = 4.2e9  # Pa; approximate load over contact area
PERCENT = (1.0, 2.0)
CELLS_PER_WAVE = (8, 16, 32, 64, 128)  # cells per shortest wave
QUICK_CELLS_PER_WAVE = (16, 32)
PARTS = (1, 4, 16)  # increments from load to load
CELLS_PER_WAVE_OF_PARTS = 32  # cells per shortest wave in the runs with these increments
SERIES = {
    "area": "contact area",
    "pressure": "mean pressure in contact",
    "strain": "maximum plastic strain",
    "stress": "maximum residual stress below 0.8 µm",
}
UNITS = {"area": ("%", 100.0), "pressure": ("GPa", 1e-9), "strain": ("%", 100.0)} | {
    "stress": ("MPa", 1e-6)
}
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.resolution --docs -->
# Resolution of rough contact

This page shows how errors of rough contact depend on the cell size, and recommends a resolution. A
rigid rough flat is pressed onto steel (210 GPa, Swift's law). The roughness of the flat is a sum of
waves from {longest:.0f} to {shortest:.0f} µm, self-affine with Hurst exponent {hurst} and rms slope
{slope}; every grid samples the same surface. Layers are as thick as the cells are wide, and
extend as deep as the plastic zone (`nz` is not given). The finest grid has {cells} x {cells} cells
and needed {memory:.1f} GB.

![Errors against the cells per shortest wave](figures/rough_resolution.png)

Errors of area and mean pressure are relative to values extrapolated from the two finest grids,
assuming first-order convergence; errors of strain and stress are relative to the finest grid. At
the edges of contact spots, single cells have peaks of pressure and, in the first layer, peaks of
strain, at any tolerance of the solver. These peaks grow as the cells become finer: the maximum
pressure and the residual stress of the first layer do not converge.

{tables}

## Increments

Each load above is reached in one increment. The next table is for the first load, reached in
several increments, with {parted} cells per shortest wave:

{parts}

The residual stress depends more on the number of increments than on the cell size.

## Source of the error

The error is determined by the number of cells across a contact spot, not across the shortest wave.
A cell is counted as either in contact or not, so the outline of a spot is wrong by a fraction of a
cell. The relative error of the area is about

$$\\frac{{\\pi - 1 + \\ln 2}}{{24}} \\, \\frac{{S}}{{N}} = {side:.3f} \\, \\frac{{S}}{{N}},$$

where S is the number of cell sides between contact and open cells, and N the number of cells in
contact (Yastrebov, Anciaux and Molinari 2017,
[doi:10.1016/j.triboint.2017.04.023](https://doi.org/10.1016/j.triboint.2017.04.023)). This is the
column "area uncertainty" of the tables; it follows from a single solution. The errors found are
{low:.2f} to {high:.2f} times this value, and the area is always too large. The uncertainty of a
round spot d cells across is {round:.2f}/d of its area: {eight:.0f} % with 8 cells, {four:.0f} %
with 4. The column "cells across a spot" is the value of d for round spots with the same S/N.

The [contact area](theory/contact.md#contact-area) in states and results is corrected for this error
if spots are small. If spots are large, the area follows from the position of their edge within the
cells. The area in the tables is the number of cells in contact times the area of a cell, without
correction; the mean pressure is too low by the same factor by which this area is too large. Plastic
strain and residual stress below the surface are largest in spots that are wider than the average,
and are therefore considerably more accurate than the area.

## Recommendations

- Choose cells that give contact spots of 8 or more cells across at the load of interest. Lighter
  loads need smaller cells; at first contact, no grid resolves the spots of a rough surface.
- Apply the load in several increments if the residual stress matters.
- The error is proportional to the cell size. If two grids are solved, the second with half the cell
  size, twice the area on the finer grid minus the area on the coarser grid is more accurate than
  either area.
- `ResolutionWarning` is issued if there are several contact spots and the area uncertainty exceeds
  {warn:.0f} % in a run, or {fail:.0f} % in a single increment. Results contain this uncertainty as
  `area_uncertainty`, and the check of a report fails above {fail:.0f} %.
"""


def surface(n: int) -> tuple[np.ndarray, float]:
    """Return the heights of the rough surface in n x n cells, and their rms [m]."""
    waves = wave_amplitudes(WAVES, HURST, seed=SEED, lowest=MIN_WAVES)
    kx, ky = np.arange(-WAVES, WAVES + 1)[:, None], np.arange(WAVES + 1)
    slopes = [surface_rms(2j * np.pi / SIDE * k * waves) for k in (kx, ky)]
    rms = SLOPE * surface_rms(waves) / np.hypot(*slopes)
    return heights(n, waves, rms), float(rms)


def gap(grid: sc.Grid) -> np.ndarray:
    """Return the gap of a rigid rough flat, increased near the borders [m]."""
    rough, rms = surface(grid.nx)
    side = np.maximum(abs(grid.x[:, None]), abs(grid.y)) / (0.5 * SIDE)
    return rough + BOWL * rms * side**8


def run(of: str, fine: int, parts: int) -> list[Record]:
    """Solve all loads with `fine` cells per shortest wavelength; return a row for each load.

    Each load is reached from the previous load in `parts` increments. The memory is the maximum
    over all loads.
    """
    n, cell = WAVES * fine, MIN_WAVELENGTH / fine
    grid = sc.Grid(n, n, cell, cell, dz=cell)
    simulation = sc.Simulation(grid, sc.Material.rigid(), STEEL, gap(grid), tol=1e-3)
    rows = []
    for before, percent in pairwise((0.0, *PERCENT)):
        for share in np.linspace(before, percent, parts + 1)[1:]:
            state = simulation.step(load=share / 100 * HARDNESS * SIDE**2)
        _, spots = scipy.ndimage.label(state.pressure > 0, structure=np.ones((3, 3)))
        surface, below = residual_stress(state)
        rows.append(
            {
                "percent": percent,
                "spots": spots,
                "area": float(np.mean(state.pressure > 0)),
                "uncertainty": resolution.area_uncertainty(state.pressure),
                "pressure": float(state.pressure[state.pressure > 0].mean()),
                "strain": state.max_equivalent_plastic_strain(),
                "stress": below,
                "surface": surface,
                "peak": float(state.pressure.max()),
            }
        )
    return [row | {"memory": float(peak_memory())} for row in rows]


def points(quick: bool) -> list[Record]:
    grids = [
        {"of": "grids", "fine": n, "parts": 1}
        for n in (QUICK_CELLS_PER_WAVE if quick else CELLS_PER_WAVE)
    ]
    more = [
        {"of": "increments", "fine": CELLS_PER_WAVE_OF_PARTS, "parts": parts} for parts in PARTS
    ]
    return grids if quick else [*grids, *more]


def residual_stress(state: sc.State) -> tuple[float, float]:
    """Return the maximum residual von Mises stress [Pa], in the first layer and below `DEPTH`."""
    surface = below = 0.0
    for zone in state.zones():
        stress = von_mises(zone.residual_stress())
        surface = max(surface, float(stress[:, :, 0].max()))
        below = max(below, float(stress[:, :, zone.z > DEPTH].max(initial=0.0)))
    return surface, below


def references(rows: list[Record]) -> dict[str, float]:
    """Return the reference values for one load; rows: results on all grids, coarsest first."""
    coarse, fine = rows[-2:]
    area = 2 * fine["area"] - coarse["area"]
    force = fine["pressure"] * fine["area"]
    return {"area": area, "pressure": force / area, "strain": fine["strain"]} | {
        "stress": fine["stress"]
    }


def errors(rows: list[Record]) -> list[Record]:
    """Return the signed relative errors for one load on all grids, coarsest first."""
    exact = references(rows)
    return [{name: row[name] / exact[name] - 1 for name in SERIES} for row in rows]


def order(values: list[float]) -> float:
    """Return the observed order of convergence of a quantity on the three finest grids."""
    coarse, middle, fine = values[-3:]
    return float(np.log2((middle - coarse) / (fine - middle)))


def area_table(rows: list[Record]) -> str:
    """Return the table of errors from counting cells."""
    head = (
        "cells per shortest wave", "spots", "cells across a spot", "contact area [%]",
        "area uncertainty [%]", "error of the area [%]", "mean pressure [GPa]",
        "error of the mean pressure [%]",
    )  # fmt: skip
    lines = []
    for row, error in zip(rows, errors(rows), strict=True):
        lines.append(
            (
                str(row["fine"]), str(row["spots"]),
                f"{resolution.ROUND_SPOT_AREA_ERROR / row['uncertainty']:.1f}",
                f"{100 * row['area']:.3f}",
                f"{100 * row['uncertainty']:.1f}", percent(error["area"]),
                f"{1e-9 * row['pressure']:.3f}", percent(error["pressure"]),
            )
        )  # fmt: skip
    return table(head, lines)


def strain_table(rows: list[Record]) -> str:
    head = (
        "cells per shortest wave", "maximum plastic strain [%]", "error of the strain [%]",
        "residual von Mises stress below 0.8 µm [MPa]", "error of the stress [%]",
        "residual von Mises stress, first layer [MPa]", "maximum pressure [GPa]",
    )  # fmt: skip
    lines = []
    for row, error in zip(rows, errors(rows), strict=True):
        lines.append(
            (
                str(row["fine"]), f"{100 * row['strain']:.3f}", percent(error["strain"]),
                f"{1e-6 * row['stress']:.0f}", percent(error["stress"]),
                f"{1e-6 * row['surface']:.0f}", f"{1e-9 * row['peak']:.2f}",
            )
        )  # fmt: skip
    return table(head, lines)


def percent(share: float) -> str:
    return f"{round(100 * share, 1) + 0.0:.1f}"


def parts_table(rows: list[Record]) -> str:
    """Return the table of the first load in several increments."""
    head = "increments", *(f"{SERIES[name]} [{unit}]" for name, (unit, _) in UNITS.items())
    lines = []
    for row in rows:
        values = (f"{row[name] * factor:#.4g}" for name, (_, factor) in UNITS.items())
        lines.append((str(row["parts"]), *values))
    return table(head, lines)


def by_load(rows: list[Record]) -> dict[float, list[Record]]:
    return {load: [row for row in rows if row["percent"] == load] for load in PERCENT}


def page(records: list[Record]) -> str:
    rows = [record for record in records if record["of"] == "grids"]
    parted = [row for row in records if row["of"] == "increments" and row["percent"] == PERCENT[0]]
    tables, ratios = [], []
    for load, mine in by_load(rows).items():
        orders = f"{order([row['area'] for row in mine]):.1f}" if len(mine) > 2 else "unknown"
        tables += [
            f"## Load {load / 100 * HARDNESS * SIDE**2:.3g} N",
            area_table(mine),
            strain_table(mine),
            f"Observed order of convergence of the area on the three finest grids: {orders}.",
        ]
        found = zip(mine, errors(mine), strict=True)
        ratios += [error["area"] / row["uncertainty"] for row, error in found]
    spot = 100 * resolution.ROUND_SPOT_AREA_ERROR
    return TEXT.format(
        longest=1e6 * SIDE / MIN_WAVES, shortest=1e6 * MIN_WAVELENGTH, hurst=HURST, slope=SLOPE,
        cells=WAVES * int(rows[-1]["fine"]), parted=CELLS_PER_WAVE_OF_PARTS,
        parts=parts_table(parted), memory=1e-9 * rows[-1]["memory"], tables="\n\n".join(tables),
        side=resolution.AREA_PER_SIDE, low=min(ratios), high=max(ratios), round=spot / 100,
        eight=spot / 8, four=spot / 4, warn=100 * resolution.AREA_ERROR_WARNING,
        fail=100 * resolution.AREA_ERROR_LIMIT,
    )  # fmt: skip


def draw(records: list[Record]) -> dict[str, Any]:
    from matplotlib.figure import Figure

    from .plots import COLOURS, MARKERS

    rows = [record for record in records if record["of"] == "grids"]
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    axes = figure.subplots(1, 2, sharey=True)
    for ax, (load, mine) in zip(axes, by_load(rows).items(), strict=True):
        fine = [row["fine"] for row in mine]
        for n, (name, label) in enumerate(SERIES.items()):
            wrong = [100 * abs(error[name]) or np.nan for error in errors(mine)]
            ax.loglog(fine, wrong, f"{MARKERS[n]}-", color=COLOURS[n], label=label)
        ax.loglog(fine, [100 * row["uncertainty"] for row in mine], "k--", label="area uncertainty")
        ax.set(
            xlabel="cells per shortest wave [-]",
            title=f"{load / 100 * HARDNESS * SIDE**2:.3g} N",
            xticks=fine,
            xticklabels=fine,
        )
        ax.minorticks_off()
        ax.grid(color="0.9")
    axes[0].set(ylabel="relative error [%]")
    axes[0].set_ylim(0.05, 30.0)  # smaller errors are accidental
    axes[0].yaxis.set_major_formatter("{x:g}")
    axes[1].legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return {"rough_resolution.png": figure}


STUDY = Study(
    "resolution", "Resolution of rough contact.", points, run, page, draw,
    document="rough_resolution", fresh=True, figures="docs/figures",
)  # fmt: skip

if __name__ == "__main__":
    STUDY.main()

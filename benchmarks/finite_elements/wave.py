# SPDX-License-Identifier: GPL-3.0-or-later
"""Three-dimensional contact of a rigid wavy surface and an elastic-plastic half-space."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np

import samcontact as sc

from ..steel import STEEL
from . import calculix
from . import wave_deck as deck
from .tables import Points, Runs, difference_range, numbers, points, ratios, time_rows, times

ELEMENTS = (4, 8, 12)  # per half period
CELLS = (16, 32, 64, 128)  # per period
FIGURE = "finite_elements_wave.png"
RELEASED = 1e-6  # fraction of the load that may remain after release
QUANTITIES = {
    "approach": ("approach [µm]", 1e6),
    "von_mises": ("maximum von Mises stress [MPa]", 1e-6),
    "plastic_strain": ("maximum plastic strain [%]", 100.0),
    "residual_von_mises": ("maximum residual von Mises stress [MPa]", 1e-6),
    "print": ("imprint, peak to valley [µm]", 1e6),
}
TEXT = """## A wavy surface

A rigid surface z = {amplitude:g} µm (2 - cos(2πx/L) - cos(2πy/L)), L = {period:g} mm, is pressed on
a half-space of AISI 52100. The mean pressure of {pressure:g} MPa, a fifth of the pressure that
closes the gap in elastic contact, is applied in {up} increments and released in {down}. The contact
is not axisymmetric; both codes solve it in three dimensions:

- CalculiX, a quarter of the periodic domain with frictionless supports at the sides: quadratic
  elements with reduced integration. The table states the number of elements on half a period.
  Elements are cubes to a depth of {fine:g} periods; each further layer is {growth} times as thick
  as the previous one, to a bottom at a depth of {depth:g} period, which is fixed along z. The
  contact is face to face, with a stiffness that permits 10 nm of interpenetration. Loading is
  force-controlled, unloading displacement-controlled.
- samcontact: cubic cells on the whole period (`periodic="xy"`). The table states the number of
  cells on a period. `nz` is not given, and all settings have their defaults; samcontact detects the
  mirror planes.

![Maximum error against time](../build/figures/finite_elements_wave.png)

### Errors of the wavy surface

{times}

{ratios}

### Results of the wavy surface

The uniform compression of the finite element model over its depth is subtracted from its approach.

{numbers}

Extrapolated to zero cell size, the two codes differ by {differ}. The slope of the surface is up to
{slope:.1f} %, and the approach of the finite elements includes the interpenetration due to the
finite stiffness of their contact. Approach and imprint of the finite elements vary irregularly with
the mesh; their limits are therefore less certain than the limits of samcontact.
"""


def solve(across: int) -> dict[str, float]:
    """Solve the contact by samcontact; return number of cells, processor time [s] and results."""
    start = time.process_time()
    period, amplitude = 1e-3 * deck.PERIOD, 1e-3 * deck.AMPLITUDE
    cell = period / across
    grid = sc.Grid(across, across, cell, cell, dz=cell, periodic="xy")
    x = grid.x - grid.x[across // 2]  # the crest lies at a cell centre
    wave = 1.0 - np.cos(2 * np.pi * x / period)
    gap = amplitude * (wave[:, None] + wave[None, :])
    simulation = sc.Simulation(grid, sc.Material.rigid(), STEEL, gap)
    full = 1e6 * deck.PRESSURE * period**2
    for part in range(1, deck.LOADING_INCREMENTS + 1):
        loaded = simulation.step(load=full * part / deck.LOADING_INCREMENTS)
    found = {
        "approach": loaded.approach,
        "von_mises": float(loaded.von_mises(2).max()),
        "plastic_strain": float(loaded.equivalent_plastic_strain(2).max()),
    }
    for part in range(1, deck.UNLOADING_INCREMENTS + 1):
        released = simulation.step(load=full * (1 - part / deck.UNLOADING_INCREMENTS))
    found["residual_von_mises"] = float(released.von_mises(2).max())
    found["print"] = float(np.ptp(released.residual_displacement(2)))
    cells = across**2 * len(loaded.depths)
    return {"cells": cells, "seconds": time.process_time() - start, **found}


def finite_elements(folder: Path, across: int) -> dict[str, float]:
    """Solve by finite elements; return number of elements, processor time [s] and results.

    Raises
    ------
    RuntimeError
        CalculiX fails, or a load remains after release.
    """
    elements = deck.write(folder / calculix.DECK, across)
    spent = calculix.run(folder)
    return {"elements": elements, "seconds": spent, **numbers_of(folder / calculix.PRINTED)}


def numbers_of(file: Path) -> dict[str, float]:
    """Return approach, stresses, strain and imprint depth, read from the output of CalculiX.

    Raises
    ------
    RuntimeError
        A load remains after release.
    """
    tables = calculix.tables_of(file)
    load, left = (force[0, 2] for force in tables["total force", "BOTTOM"])
    if abs(left) > RELEASED * load:
        raise RuntimeError(f"load must vanish after release, but {left / load:.3g} of it remains")
    loaded, released = tables["stresses", "ZONE"]
    moved = -float(tables["displacements", "PUSHED"][0][0, 3]) + deck.OVERLAP
    printed = tables["displacements", "TOP"][1][:, 3]
    return {
        "approach": 1e-3 * (moved - uniform_compression()),
        "von_mises": float(calculix.von_mises(loaded).max()),
        "plastic_strain": float(tables["equivalent plastic strain", "ZONE"][0][:, 2].max()),
        "residual_von_mises": float(calculix.von_mises(released).max()),
        "print": 1e-3 * float(np.ptp(printed)),
    }


def uniform_compression() -> float:
    """Return the compression of the lower mesh under uniform pressure, with sliding sides [mm]."""
    E, nu = 1e-6 * STEEL.E, STEEL.nu
    return deck.PRESSURE * deck.DEPTH * deck.PERIOD * (1 + nu) * (1 - 2 * nu) / (E * (1 - nu))


def section(runs: dict[str, Runs]) -> str:
    """Return the text of the section on the wavy surface."""
    name = "elements on half a period (CalculiX), cells on a period (samcontact)"
    return TEXT.format(
        amplitude=1e3 * deck.AMPLITUDE,
        period=deck.PERIOD,
        pressure=deck.PRESSURE,
        up=deck.LOADING_INCREMENTS,
        down=deck.UNLOADING_INCREMENTS,
        fine=deck.FINE_DEPTH,
        growth=deck.GROWTH,
        depth=deck.DEPTH,
        times=times(name, time_rows(runs, QUANTITIES)),
        ratios=ratios(runs["CalculiX"], QUANTITIES, ours(runs)),
        numbers=numbers(name, runs, QUANTITIES),
        differ=difference_range(runs, QUANTITIES),
        slope=100 * 2 * np.pi * deck.AMPLITUDE / deck.PERIOD,
    )


def ours(runs: dict[str, Runs]) -> dict[str, Points]:
    """Return errors and times of samcontact, by the way in which its grid is chosen."""
    return {"a grid": points(runs["samcontact"], QUANTITIES)}

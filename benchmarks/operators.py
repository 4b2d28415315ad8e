# SPDX-License-Identifier: GPL-3.0-or-later
"""Residual stress of a real plastic zone: errors of the exact and the fast method.

The plastic strain is from a fine axisymmetric solution for two balls at the largest load, and is
sampled at the cell centres of a box around the plastic zone. For the reference it is sampled in
cells that are smaller by an odd factor, so that each coarse cell centre is also a fine cell centre.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import RegularGridInterpolator

import samcontact as sc
from gallery.profiles import von_mises

from .harness import Meter, Task, largest_error, relative_error, rms_error
from .steel import LOAD, STEEL, balls

NAME = "operators"
TITLE = "Residual stress of a plastic zone"
MATERIALS = {
    "steel 52100": STEEL,
    "perfect plasticity": sc.Material.perfect_plastic(STEEL.E, STEEL.nu, 1.4e9),
}
REFINEMENT = {8: 9, 16: 5, 32: 3}
REFERENCE_TOLERANCE = 1e-5  # image tolerance of the reference


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes, finest = ((8, 16), 20) if quick else ((8, 16, 32), 40)
    found = []
    for case in MATERIALS:
        profile = str(folder / f"{NAME}-{case.replace(' ', '-')}-{finest}.npz")
        arguments: dict[str, Any] = {"material": case, "across": finest, "file": profile}
        found.append(Task(NAME, case, "fine solution", "make_profile", arguments, hidden=True))
        for cells in sizes:
            stored = str(folder / f"{NAME}-{case.replace(' ', '-')}-{finest}-{cells}.npz")
            arguments = {"cells": cells, "profile": profile, "file": stored}
            found.append(Task(NAME, case, "reference", "make_reference", arguments, hidden=True))
            for method in ("exact", "fast"):
                found.append(
                    Task(NAME, case, method, "apply", {**arguments, "method": method}, "exact")
                )
    return found


def make_profile(meter: Meter, material: str, across: int, file: str) -> dict[str, Any]:
    """Return the plastic strain of a fine solution in the half-plane y = 0, x >= 0."""
    simulation = balls(
        across, width=1.15, lower=MATERIALS[material], residual_stress="fast", tol=1e-5
    )
    for k in range(1, 5):
        loaded = simulation.step(load=LOAD * k / 4)
    grid, c = simulation.grid, simulation.grid.nx // 2
    np.savez(
        file,
        r=grid.x[c:],
        z=grid.z,
        strain=loaded.plastic_strain()[:, c:, c, :],
        equivalent=loaded.equivalent_plastic_strain()[c:, c],
    )
    return {}


def plastic_box(profile: dict[str, np.ndarray], cells: int) -> sc.Grid:
    """Return a grid that exceeds the plastic zone by a cell; `cells`: cells per zone radius."""
    i, k = np.nonzero(profile["equivalent"] > 1e-7)
    d = profile["r"][i.max()] / cells
    n = 2 * (cells + 1) + 1
    return sc.Grid(n, n, d, d, int(np.ceil(profile["z"][k.max()] / d + 1)), d)


def sample(profile: dict[str, np.ndarray], grid: sc.Grid) -> np.ndarray:
    """Return the tensor of an axisymmetric strain at the cell centres of a grid."""
    r_known, z_known = profile["r"], profile["z"]
    # Cylindrical components, mirrored for r < 0: rz is odd.
    columns = {"rr": (0, 1), "tt": (1, 1), "zz": (2, 1), "rz": (4, -1)}
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    r = np.hypot(x, y)
    c, s = np.where(r > 0, (x, y) / np.maximum(r, 1e-30), [[[1.0]], [[0.0]]])
    axes = (np.concatenate([-r_known[:0:-1], r_known]), z_known)
    value = {
        name: RegularGridInterpolator(
            axes,
            np.concatenate([parity * profile["strain"][i][:0:-1], profile["strain"][i]]),
            bounds_error=False,
            fill_value=None,
        )
        for name, (i, parity) in columns.items()
    }
    out = np.zeros((6, *grid.volume_shape))
    inside = r <= r_known[-1]
    for k, z in enumerate(grid.z):
        points = np.stack([r, np.full_like(r, z)], axis=-1)
        rr, tt, zz, rz = (np.where(inside, value[name](points), 0.0) for name in columns)
        xx, yy, xy = rr * c**2 + tt * s**2, rr * s**2 + tt * c**2, (rr - tt) * c * s
        out[..., k] = xx, yy, zz, rz * s, rz * c, xy
    return out


def stress(grid: sc.Grid, strain: np.ndarray, method: str, image_tol: float) -> np.ndarray:
    return sc.operators.residual_stress(
        grid, strain, STEEL.E, STEEL.nu, method=method, image_tol=image_tol
    )


def load_arrays(file: str) -> dict[str, np.ndarray]:
    with np.load(file) as stored:
        return dict(stored)


def make_reference(meter: Meter, cells: int, profile: str, file: str) -> dict[str, Any]:
    known, times = load_arrays(profile), REFINEMENT[cells]
    coarse = plastic_box(known, cells)
    fine = sc.Grid(
        *(times * n for n in (coarse.nx, coarse.ny)),
        coarse.dx / times,
        coarse.dy / times,
        times * coarse.nz,
        coarse.dz / times,
    )
    field = meter(lambda: stress(fine, sample(known, fine), "fast", REFERENCE_TOLERANCE))
    centres = slice(times // 2, None, times)
    np.savez(file, stress=field[:, centres, centres, centres])
    return {}


def apply(meter: Meter, cells: int, profile: str, file: str, method: str) -> dict[str, Any]:
    """Measure the set-up of the operator and one application."""
    known = load_arrays(profile)
    grid = plastic_box(known, cells)
    strain = sample(known, grid)
    field = meter(lambda: stress(grid, strain, method, 1e-3))
    reference = load_arrays(file)["stress"]
    errors = {
        "stress, rms": rms_error(field, reference),
        "stress, largest": largest_error(field, reference),
        "largest von Mises": relative_error(von_mises(field).max(), von_mises(reference).max()),
    }
    return {
        "cells": grid.nx * grid.ny * grid.nz,
        "across": cells,
        "volume_applications": 1,
        "errors": errors,
    }


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return a sentence on the ranges of time and error of the fast method."""
    exact, fast = ([row for row in rows if row["method"] == name] for name in ("exact", "fast"))
    if not fast:
        return []
    errors = [
        one["error: stress, rms"] / two["error: stress, rms"]
        for one, two in zip(fast, exact, strict=True)
    ]
    times = [row["time_ratio"] for row in fast]
    return [
        f"The rms error of the fast method is {min(errors):.2f} to {max(errors):.2f} times the rms "
        "error of exact coefficients applied to the strain at cell centres. The time for set-up "
        f"and one application is {min(times):.2f} to {max(times):.2f} times the time with exact "
        "coefficients."
    ]

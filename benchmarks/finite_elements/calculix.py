# SPDX-License-Identifier: GPL-3.0-or-later
"""Run CalculiX on a deck, and read what it prints."""

from __future__ import annotations

import os
import resource
import shutil
import subprocess
from pathlib import Path

import numpy as np

from .deck import FloatArray, write

WEDGE = 180.0  # two degrees of the circumference are modelled
INSIDE = 4  # integration points of an element that differ: the wedge has each twice


class NotInstalledError(RuntimeError):
    """There is no `ccx` on the path."""


def solve(folder: Path, per_radius: int, flatter: float | None = None) -> dict[str, float]:
    """Numbers of the scene on a mesh, with its elements and the processor's time [s].

    flatter: as of decks.

    Raises
    ------
    NotInstalledError
        Without CalculiX.
    RuntimeError
        When it fails.
    """
    program = shutil.which("ccx")
    if program is None:
        raise NotInstalledError("ccx is not installed: Debian has it as calculix-ccx")
    elements = write(folder / "deck.inp", per_radius, flatter)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [program, "-i", "deck"],
        cwd=folder,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0 or not (folder / "deck.dat").exists():
        raise RuntimeError("CalculiX failed: " + done.stdout[-500:])
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"elements": elements, "seconds": spent, **numbers_of(folder / "deck.dat")}


def numbers_of(file: Path) -> dict[str, float]:
    """Load, stresses, strain and print of what was printed at the ends of both steps."""
    tables = tables_of(file)
    (_, loaded), (_, released) = tables["stresses"]
    strain = tables["equivalent plastic strain"][0][1]
    force = tables["total force"][0][1]
    return {
        "load": -WEDGE * float(force[0, 1]),
        "von_mises": float(von_mises(loaded).max()),
        "plastic_strain": float(strain[:, 2].max()),
        "residual_von_mises": float(von_mises(released).max()),
        "print": -1e-3 * float(tables["displacements"][1][1][0, 2]),
    }


def von_mises(printed: FloatArray) -> FloatArray:
    """Of rows of element, integration point and six components [MPa], in pascals."""
    xx, yy, zz, xy, xz, yz = printed[:, 2:].T
    normal = 0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2)
    return np.asarray(1e6 * np.sqrt(normal + 3 * (xy**2 + xz**2 + yz**2)))


def tables_of(file: Path) -> dict[str, list[tuple[float, FloatArray]]]:
    """Tables by the beginning of their heading, each with its time."""
    found: dict[str, list[tuple[float, list[list[float]]]]] = {}
    kinds = ("stresses", "equivalent plastic strain", "total force", "displacements")
    for line in file.read_text().splitlines():
        words = line.split()
        kind = next((kind for kind in kinds if line.strip().startswith(kind)), None)
        if kind is not None:
            rows: list[list[float]] = []
            found.setdefault(kind, []).append((float(words[-1]), rows))
        elif words:
            rows.append([float(word) for word in words])
    return {kind: [(time, np.array(r)) for time, r in tables] for kind, tables in found.items()}

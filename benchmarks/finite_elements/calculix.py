# SPDX-License-Identifier: GPL-3.0-or-later
"""Execution of CalculiX on a deck, and reading of its output."""

from __future__ import annotations

import os
import resource
import shutil
import subprocess
from pathlib import Path

import numpy as np

from .deck import FloatArray

DECK, PRINTED = "deck.inp", "deck.dat"
ONE_THREAD = {"OMP_NUM_THREADS": "1", "CCX_NPROC_EQUATION_SOLVER": "1"}


class NotInstalledError(RuntimeError):
    """The program `ccx` was not found."""


def run(folder: Path) -> float:
    """Solve the deck of a folder; return the processor time [s].

    Raises
    ------
    NotInstalledError
        CalculiX is not installed.
    RuntimeError
        CalculiX fails.
    """
    program = shutil.which("ccx")
    if program is None:
        raise NotInstalledError("ccx is not installed: Debian has it as calculix-ccx")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [program, "-i", DECK.removesuffix(".inp")],
        cwd=folder,
        env={**os.environ, **ONE_THREAD},
        capture_output=True,
        text=True,
        check=False,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0 or not (folder / PRINTED).exists():
        raise RuntimeError("CalculiX failed: " + done.stdout[-500:])
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def von_mises(printed: FloatArray) -> FloatArray:
    """Return the von Mises stress of each printed row [Pa].

    A row contains element, integration point and six stress components [MPa].
    """
    xx, yy, zz, xy, xz, yz = printed[:, 2:].T
    normal = 0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2)
    return np.asarray(1e6 * np.sqrt(normal + 3 * (xy**2 + xz**2 + yz**2)))


def tables_of(file: Path) -> dict[tuple[str, str], list[FloatArray]]:
    """Return the output tables, with one array per step, by quantity and node or element set."""
    found: dict[tuple[str, str], list[list[list[float]]]] = {}
    kinds = ("stresses", "equivalent plastic strain", "total force", "displacements")
    for line in file.read_text().splitlines():
        words = line.split()
        kind = next((kind for kind in kinds if line.strip().startswith(kind)), None)
        if kind is not None:
            rows: list[list[float]] = []
            found.setdefault((kind, words[words.index("set") + 1]), []).append(rows)
        elif words:
            rows.append([float(word) for word in words])
    return {key: [np.array(rows) for rows in tables] for key, tables in found.items()}

# SPDX-License-Identifier: GPL-3.0-or-later
"""Finite-element results of a sphere below a contact, see README.md."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).parent
MPA = 1e6


def case(name: str) -> dict[str, Any]:
    """Return constants, path and summary of a case; stresses in MPa, lengths in a."""
    loaded: dict[str, Any] = json.loads((FOLDER / name / "case.json").read_text())
    return loaded


def cells(name: str, key: str, per_radius: int) -> NDArray[np.void]:
    """Return the results at centres of cells: i, j, k, material, stress [MPa], plastic strain.

    key: "loaded" or "unloaded"; per_radius: cells per radius of the sphere.
    """
    path = FOLDER / name / f"cells_{key}_{per_radius}.csv"
    found: NDArray[np.void] = np.genfromtxt(path, delimiter=",", names=True)
    return found

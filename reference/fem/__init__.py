# SPDX-License-Identifier: GPL-3.0-or-later
"""Reader of the finite element reference curves in this folder (see its README)."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

DATA = Path(__file__).parent
CASES = ("1b", "1c", "2a", "2b1500", "2d", "graded")


@dataclass(frozen=True)
class FemCase:
    """One case; curves are structured arrays with the column names of the files, SI units."""

    name: str
    parameters: dict[str, Any]
    """Contents of case.json except its summary: E_Pa, nu, material, load, mesh, comparisons."""
    summary: dict[str, Any]
    axis_loaded: np.ndarray
    """z_m, srr_Pa, szz_Pa, stt_Pa, vonMises_Pa, hydrostatic_Pa, gamma_p; r = 0, largest load."""
    axis_unloaded: np.ndarray
    """Columns as in the previous table, after unloading."""
    surface_uz: np.ndarray
    """r_m, uz_loaded_m, uz_residual_m."""
    pressure_r: np.ndarray
    """r_m, p_Pa at the largest load."""
    load_displacement: np.ndarray
    """Contact: approach_m, load_N, p_max_Pa, ...; given pressure: p0_Pa, uz_center_m, load_N."""


def _read(path: Path) -> np.ndarray:
    return np.genfromtxt(path, delimiter=",", names=True)


def load(name: str) -> FemCase:
    """Read the case `name`, one of CASES."""
    if name not in CASES:
        raise ValueError(f"case {name!r}: expected one of {CASES}")
    folder = DATA / name
    parameters = json.loads((folder / "case.json").read_text())
    summary = parameters.pop("summary")
    curves = ("axis_loaded", "axis_unloaded", "surface_uz", "pressure_r", "load_displacement")
    return FemCase(
        name, parameters, summary, **{curve: _read(folder / f"{curve}.csv") for curve in curves}
    )

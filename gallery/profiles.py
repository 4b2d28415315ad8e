# SPDX-License-Identifier: GPL-3.0-or-later
"""What several parts do with stresses and profiles: invariants, signs, the looks of axes."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes


def von_mises(stress: np.ndarray) -> np.ndarray:
    """Of components xx, yy, zz, yz, xz, xy, shape (6, ...), in their unit."""
    xx, yy, zz, yz, xz, xy = stress
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.asarray(np.sqrt(0.5 * normal + 3.0 * (yz**2 + xz**2 + xy**2)))


def succession(values: np.ndarray, negligible: float) -> list[str]:
    """Signs of a stress from the surface down, without what is negligible."""
    found: list[str] = []
    for value in values[np.abs(values) > negligible]:
        sign = "tensile" if value > 0 else "compressive"
        if not found or found[-1] != sign:
            found.append(sign)
    return found


def finish(ax: Axes, xlabel: str = "", ylabel: str = "", legend: bool = True) -> None:
    """Labels, grid and legend."""
    ax.set(xlabel=xlabel, ylabel=ylabel)
    ax.grid(True, linewidth=0.4, alpha=0.5)
    if legend:
        ax.legend(frameon=False, fontsize="small")

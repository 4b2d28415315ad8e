# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions for stresses, profiles and lists of numbers that several parts use."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np


def von_mises(stress: np.ndarray) -> np.ndarray:
    """Return the von Mises stress of components xx, yy, zz, yz, xz, xy, shape (6, ...)."""
    xx, yy, zz, yz, xz, xy = stress
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.asarray(np.sqrt(0.5 * normal + 3.0 * (yz**2 + xz**2 + xy**2)))


def succession(values: np.ndarray, negligible: float) -> list[str]:
    """Describe the signs of a stress from the surface down; negligible values are omitted."""
    found: list[str] = []
    for value in values[np.abs(values) > negligible]:
        sign = "tensile" if value > 0 else "compressive"
        if not found or found[-1] != sign:
            found.append(sign)
    return found


def top(x: np.ndarray, values: np.ndarray) -> tuple[float, float]:
    """Return the maximum of a profile and its position, by a parabola through three samples."""
    k = int(values.argmax())
    if k in (0, len(values) - 1):
        return float(values[k]), float(x[k])
    c = np.polyfit(x[k - 1 : k + 2] - x[k], values[k - 1 : k + 2], 2)
    at = -c[1] / (2 * c[0])
    return float(np.polyval(c, at)), float(x[k] + at)


def largest(plane: np.ndarray, x: np.ndarray, z: np.ndarray) -> tuple[float, float, float]:
    """Return the maximum of a field in a plane (x, z), and its position."""
    i, k = np.unravel_index(int(plane.argmax()), plane.shape)
    return float(plane[i, k]), float(x[i]), float(z[k])


def each(values: Iterable[float], form: str = ".3g") -> str:
    """Return numbers as a comma-separated text."""
    return ", ".join(f"{value:{form}}" for value in values)


def grows(values: Sequence[float] | np.ndarray) -> bool:
    return bool(np.all(np.diff(values) > 0))


def falls(values: Sequence[float] | np.ndarray) -> bool:
    return bool(np.all(np.diff(values) < 0))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Tensors of six components in the order xx, yy, zz, yz, xz, xy; directions on a sphere."""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray

_ROW, _COLUMN = np.array([0, 1, 2, 1, 0, 0]), np.array([0, 1, 2, 2, 2, 1])


def mean(six: FloatArray) -> FloatArray:
    """Isotropic part of a tensor (its mean normal component), shape (6, ...)."""
    part = np.zeros_like(six)
    part[:3] = six[:3].mean(axis=0)
    return part


def deviator(six: FloatArray) -> FloatArray:
    """Deviator of a tensor, shape (6, ...)."""
    return np.asarray(six - mean(six))


def as_matrix(six: FloatArray) -> FloatArray:
    """Tensor of shape (6, ...) as an array of shape (3, 3, ...)."""
    full = np.empty((3, 3, *six.shape[1:]))
    full[_ROW, _COLUMN] = six
    full[_COLUMN, _ROW] = six
    return full


def as_six(full: FloatArray) -> FloatArray:
    """Symmetric tensor of shape (3, 3, ...) as an array of shape (6, ...)."""
    return np.asarray(full[_ROW, _COLUMN])


def stress_of(strain: FloatArray, E: float, nu: float) -> FloatArray:
    """Stress of an elastic strain in an isotropic body, shape (6, ...)."""
    return np.asarray(
        E / (1 - 2 * nu) * mean(strain) + E / (1 + nu) * deviator(strain), dtype=np.float64
    )


def strain_of(stress: FloatArray, E: float, nu: float) -> FloatArray:
    """Elastic strain of a stress in an isotropic body, shape (6, ...)."""
    return np.asarray(
        (1 - 2 * nu) / E * mean(stress) + (1 + nu) / E * deviator(stress), dtype=np.float64
    )


def fibonacci_directions(count: int) -> FloatArray:
    """Evenly distributed unit vectors, shape (3, count)."""
    n = np.arange(count)
    z = 1 - (2 * n + 1) / count
    angle = np.pi * (3 - np.sqrt(5)) * n
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(angle), r * np.sin(angle), z])

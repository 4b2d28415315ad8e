# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress and plastic strain of elastic-plastic bodies under a film."""

from __future__ import annotations

from dataclasses import dataclass

from .._util.checks import FloatArray
from .._util.display import ShortRepr


@dataclass(frozen=True, repr=False, eq=False)
class FilmPlasticity(ShortRepr):
    """Stress and plastic strain of both bodies under a film, from `press_loads`.

    The first index of fields with the shape (2, ...) is the body. Fields of a rigid body are 0.

    Attributes
    ----------
    initial_gap : ndarray, shape (nx, ny)
        Gap of the surfaces before any plastic strain [m].
    residual_displacement : ndarray, shape (2, nx, ny)
        Residual normal displacement of the surfaces [m], positive into the body.
    z : ndarray, shape (nz,)
        Depths at which stress and strain are given [m].
    von_mises : ndarray, shape (2, nx, ny, nz)
        Von Mises stress under the film [Pa].
    residual_von_mises : ndarray, shape (2, nx, ny, nz)
        Von Mises equivalent of the residual stress, which remains after elastic unloading [Pa].
    equivalent_plastic_strain : ndarray, shape (2, nx, ny, nz)
        Accumulated equivalent plastic strain [-].
    """

    initial_gap: FloatArray
    residual_displacement: FloatArray
    z: FloatArray
    von_mises: FloatArray
    residual_von_mises: FloatArray
    equivalent_plastic_strain: FloatArray

# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of a lubricant versus pressure: reduced pressure and density."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray
from .._util.display import ShortRepr
from .._util.frozen import read_only
from .density import DensityLaw

PRESSURE_SCALE = 1e6
"""Pressure [Pa] below which nodes are equidistant; above it, their logarithms are equidistant."""
POINTS = 40_001
"""Number of nodes of a table."""


@dataclass(frozen=True, repr=False)
class LubricantTables(ShortRepr):
    """Reduced pressure and density of a lubricant, from `Lubricant.tables`.

    Node n has the pressure scale (exp(n step) - 1). Between the nodes, values are interpolated by
    cubic Hermite polynomials.

    Attributes
    ----------
    scale : float
        Pressure below which the nodes are nearly equidistant [Pa].
    step : float
        Distance between neighbouring nodes in ln(1 + p/scale) [-].
    reduced : ndarray
        Reduced pressure at the nodes, the integral of `fluidity` over the pressure [1/s].
    fluidity : ndarray
        Relative density divided by viscosity [1/(Pa s)].
    density : ndarray
        Relative density [-].
    density_slope : ndarray
        Derivative of the relative density with respect to the pressure [1/Pa].
    """

    scale: float
    step: float
    reduced: FloatArray
    fluidity: FloatArray
    density: FloatArray
    density_slope: FloatArray

    @property
    def pressure(self) -> FloatArray:
        """Pressures of the nodes [Pa]."""
        pressure: FloatArray = self.scale * np.expm1(self.step * np.arange(self.reduced.size))
        return pressure


def reduced_pressure(
    max_pressure: float, fluidity: Callable[[FloatArray], FloatArray], density: DensityLaw
) -> LubricantTables:
    """Return the tables up to a pressure [Pa], by four-point Gauss quadrature in each interval."""
    step = float(np.log1p(max_pressure / PRESSURE_SCALE)) / (POINTS - 1)
    p = PRESSURE_SCALE * np.expm1(step * np.arange(POINTS))
    nodes, weights = np.polynomial.legendre.leggauss(4)
    half = 0.5 * np.diff(p)
    inside = 0.5 * (p[1:] + p[:-1])[:, None] + half[:, None] * nodes
    steps = half * (fluidity(inside) @ weights)
    reduced = np.concatenate(([0.0], np.cumsum(steps)))
    columns = (reduced, fluidity(p), density.ratio(p), density.slope(p))
    return LubricantTables(PRESSURE_SCALE, step, *map(read_only, columns))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Yield stress, plastic work and uniaxial stress-strain curve of a material."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, real_array


class HasFlowCurve:
    """Base class of `Material` with yield stress, plastic work and uniaxial stress."""

    _core: Any
    is_rigid: Any

    def yield_stress(self, g: ArrayLike) -> float | FloatArray:
        """Yield stress [Pa] at equivalent plastic strain g [-] (scalar or array), same shape as g.

        With kinematic hardening, the result is the radius of the yield surface; it does not include
        the backstress. It does not include the factor of a yield profile either, see
        `yield_factor`. For an elastic or rigid body, it is infinite. Raises ValueError if g is
        negative or not finite.
        """
        return self._at(g, self._core.yield_stress)

    def _at(self, g: ArrayLike, function: Callable[[FloatArray], FloatArray]) -> float | FloatArray:
        strain = real_array("g", g)
        bad = ~(np.isfinite(strain) & (strain >= 0))
        if bad.any():
            raise ValueError(f"g must be finite and >= 0, got {float(strain[bad].flat[0])!r}")
        values = function(np.ascontiguousarray(strain).ravel())
        return float(values[0]) if strain.ndim == 0 else values.reshape(strain.shape)

    def plastic_work(self, g: ArrayLike) -> float | FloatArray:
        """Plastic work [J/m^3] up to equivalent plastic strain g: integral of the yield stress.

        This is the energy dissipated per volume. It includes neither the work of backstresses
        (kinematic hardening) nor the effect of thermal softening or of a yield profile. The result
        has the shape of g; it is 0 for an elastic or rigid body. Raises ValueError if g is negative
        or not finite.
        """
        return self._at(g, self._core.work)

    def uniaxial_stress(self, strain: ArrayLike) -> FloatArray:
        """Axial stress in a bar of this material under a prescribed history of axial strain.

        Parameters
        ----------
        strain : array_like, shape (n,)
            History of the total axial strain [-], tension positive, from the virgin state. Each
            value is reached in one increment of the backward Euler method, which is exact for
            linear hardening; for other laws, the error is proportional to the size of the
            increments.

        Returns
        -------
        ndarray, shape (n,)
            Axial stress [Pa]; the lateral stresses are zero.

        Raises
        ------
        ValueError
            `strain` is not one-dimensional or not finite, or the body is rigid.
        """
        if self.is_rigid:
            raise ValueError("uniaxial_stress requires a deformable material, got a rigid one")
        history = real_array("strain", strain)
        if history.ndim != 1 or not np.isfinite(history).all():
            raise ValueError("strain must be a list of finite numbers")
        stress = np.asarray(self._core.uniaxial_stress(history.tolist()), dtype=np.float64)
        if not np.isfinite(stress).all():
            largest = float(np.abs(history).max())
            raise ValueError(
                "strain must be small enough to give a finite stress, got "
                f"values up to {largest!r}: strain is dimensionless, not in "
                "percent"
            )
        return stress

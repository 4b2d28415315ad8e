# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties that a heterogeneous body has from its matrix."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from numpy.typing import ArrayLike

from .._util.checks import FloatArray
from .depth_profiles import Profile
from .material import Material


class LikeMatrix:
    """Base class of `Heterogeneous` with the constants of the matrix."""

    matrix: Material

    @property
    def E(self) -> float:
        """Young's modulus of the matrix [Pa]."""
        return self.matrix.E

    @property
    def nu(self) -> float:
        """Poisson's ratio of the matrix [-]."""
        return self.matrix.nu

    @property
    def parameters(self) -> Mapping[str, Any]:
        """Parameters of the matrix."""
        return self.matrix.parameters

    @property
    def thermal(self) -> tuple[float, float, float] | None:
        """Thermal constants of the matrix, see `Material.with_thermal`."""
        return self.matrix.thermal

    @property
    def softening(self) -> Callable[[FloatArray], ArrayLike] | None:
        """Softening law of the matrix."""
        return self.matrix.softening

    @property
    def kinematic(self) -> tuple[tuple[float, float], ...]:
        """Backstresses of the matrix, see `Material.with_kinematic_hardening`."""
        return self.matrix.kinematic

    @property
    def _core(self) -> Any:
        return self.matrix._core

    @property
    def is_rigid(self) -> bool:
        """Always False."""
        return False

    @property
    def yield_profile(self) -> Profile | None:
        """Profile of the yield stress of the matrix, see `Material.with_yield_profile`."""
        return self.matrix.yield_profile

    @property
    def residual_stress(self) -> Profile | None:
        """Initial stress of the matrix, see `Material.with_residual_stress`."""
        return self.matrix.residual_stress

    def yield_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial yield stress of the matrix [Pa], see `Material.yield_stress_at`."""
        return self.matrix.yield_stress_at(z)

    def residual_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial stresses of the matrix [Pa], see `Material.residual_stress_at`."""
        return self.matrix.residual_stress_at(z)

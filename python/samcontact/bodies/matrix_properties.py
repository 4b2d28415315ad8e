# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties that a heterogeneous body takes from its matrix."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from numpy.typing import ArrayLike

from .._util.checks import FloatArray
from .depth_profiles import Profile
from .layers import Layered
from .material import Material


class LikeMatrix:
    """Base class of `Heterogeneous` with the constants of the matrix."""

    matrix: Material | Layered

    def _only_material(self, name: str) -> Material:
        """Material of the matrix; raises AttributeError for a layered matrix."""
        if isinstance(self.matrix, Layered):
            raise AttributeError(
                f"a layered matrix has no single {name}: use matrix.materials or "
                "matrix.material_at(z)"
            )
        return self.matrix

    @property
    def E(self) -> float:
        """Young's modulus of the matrix [Pa]."""
        return self._only_material("E").E

    @property
    def nu(self) -> float:
        """Poisson's ratio of the matrix [-]."""
        return self._only_material("nu").nu

    @property
    def parameters(self) -> Mapping[str, Any]:
        """Parameters of the matrix, see `Material` and `Layered.parameters`."""
        return self.matrix.parameters

    @property
    def thermal(self) -> Any:
        """Thermal constants of the matrix, see `Material.with_thermal` and `Layered.thermal`."""
        return self.matrix.thermal

    @property
    def softening(self) -> Any:
        """Softening law of the matrix; for a layered matrix, the laws of all its materials."""
        return self.matrix.softening

    @property
    def kinematic(self) -> tuple[tuple[float, float], ...]:
        """Backstresses of the matrix, see `Material.with_kinematic_hardening`."""
        return self._only_material("kinematic").kinematic

    @property
    def _core(self) -> Any:
        return self.matrix._core

    @property
    def is_rigid(self) -> bool:
        """Always False, because the material around the inclusions must not be rigid."""
        return False

    @property
    def yield_profile(self) -> Profile | None:
        """Profile of the yield stress of the matrix, see `Material.with_yield_profile`."""
        return self._only_material("yield_profile").yield_profile

    @property
    def residual_stress(self) -> Profile | None:
        """Initial stress of the matrix, see `Material.with_residual_stress`."""
        return self._only_material("residual_stress").residual_stress

    def yield_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial yield stress of the matrix [Pa], see `Material.yield_stress_at`."""
        return self.matrix.yield_stress_at(z)

    def residual_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial stresses of the matrix [Pa], see `Material.residual_stress_at`."""
        return self.matrix.residual_stress_at(z)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: isotropic elasticity with an isotropic hardening law (J2 plasticity)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._checks import FloatArray, number


@dataclass(frozen=True)
class Material:
    """A material; make it with one of the factories, e.g. `Material.swift(...)`.

    Attributes
    ----------
    law : str
        "elastic", "rigid", "perfect_plastic", "linear_hardening" or "swift".
    parameters : dict
        The factory's arguments, SI units.
    """

    law: str
    parameters: dict[str, float]

    def __post_init__(self) -> None:
        checked = {name: number(name, value) for name, value in self.parameters.items()}
        object.__setattr__(self, "parameters", checked)
        _ = self._core

    @classmethod
    def elastic(cls, E: float, nu: float) -> Material:
        """Elastic body: Young's modulus E [Pa], Poisson's ratio nu in [0, 0.5)."""
        return cls("elastic", {"E": E, "nu": nu})

    @classmethod
    def rigid(cls) -> Material:
        """Rigid body (E is infinite)."""
        return cls("rigid", {})

    @classmethod
    def perfect_plastic(cls, E: float, nu: float, yield_stress: float) -> Material:
        """Elastic, perfectly plastic: constant yield stress [Pa]."""
        return cls("perfect_plastic", {"E": E, "nu": nu, "yield_stress": yield_stress})

    @classmethod
    def linear_hardening(
        cls, E: float, nu: float, yield_stress: float, tangent_modulus: float
    ) -> Material:
        """Bilinear uniaxial curve with slope tangent_modulus Et [Pa] beyond yield, 0 <= Et < E.

        The yield stress grows with the equivalent plastic strain at E Et/(E - Et).
        """
        parameters = {
            "E": E,
            "nu": nu,
            "yield_stress": yield_stress,
            "tangent_modulus": tangent_modulus,
        }
        return cls("linear_hardening", parameters)

    @classmethod
    def swift(cls, E: float, nu: float, B: float, C: float, n: float) -> Material:
        """Swift's law sigma_y(g) = B (C + 1e6 g)^n, B [Pa]; C > 0 counts microstrain, 0 <= n <= 1.

        Boucly (2008), eq. (2.162), with the strain in microstrain as its numbers require.
        """
        return cls("swift", {"E": E, "nu": nu, "B": B, "C": C, "n": n})

    @cached_property
    def _core(self) -> Any:
        factories = ("elastic", "rigid", "perfect_plastic", "linear_hardening", "swift")
        if self.law not in factories:
            raise ValueError(f"law must be one of {', '.join(factories)}, got {self.law!r}")
        return getattr(_core.Material, self.law)(**self.parameters)

    @property
    def E(self) -> float:
        """Young's modulus [Pa]; infinite for a rigid body."""
        return float(self._core.elastic_constants.E)

    @property
    def nu(self) -> float:
        """Poisson's ratio [-]."""
        return float(self._core.elastic_constants.nu)

    @property
    def is_rigid(self) -> bool:
        """Whether the body is rigid."""
        return self.law == "rigid"

    @property
    def is_plastic(self) -> bool:
        """Whether the body can yield."""
        return bool(self._core.is_plastic)

    def yield_stress(self, g: ArrayLike) -> float | FloatArray:
        """Yield stress [Pa] at equivalent plastic strain g [-], scalar or array (same shape).

        Infinite for an elastic or rigid body. Raises ValueError where g is negative or not finite.
        """
        strain = np.asarray(g, dtype=np.float64)
        bad = ~(np.isfinite(strain) & (strain >= 0))
        if bad.any():
            raise ValueError(f"g must be finite and >= 0, got {strain[bad].flat[0]!r}")
        values = self._core.yield_stress(np.ascontiguousarray(strain).ravel())
        return float(values[0]) if strain.ndim == 0 else values.reshape(strain.shape)

    def __hash__(self) -> int:
        return hash((self.law, tuple(sorted(self.parameters.items()))))

    def __getstate__(self) -> dict[str, Any]:
        return {"law": self.law, "parameters": self.parameters}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

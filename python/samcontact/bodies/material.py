# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: isotropic elasticity; J2 plasticity with isotropic and kinematic hardening."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, number, real_array
from .._util.display import Rows, Shown
from .._util.short_text import in_short
from .depth_profiles import PARTS, Graded, Profile, profile
from .display import material_rows
from .hardening_laws import checked_constants, core_material


def _many(value: Any) -> list[Any]:
    value = value.tolist() if isinstance(value, np.ndarray) else value
    return list(value) if isinstance(value, Iterable) else [value]


def _numbers(name: str, parts: Sequence[str], given: Any) -> tuple[float, ...]:
    """Constants that belong together, e.g. those of heat."""
    values = _many(given)
    if len(values) != len(parts):
        raise ValueError(f"{name} must hold {', '.join(parts)}, got {in_short(given)}")
    return tuple(number(part, value) for part, value in zip(parts, values, strict=True))


@dataclass(frozen=True, repr=False)
class Material(Graded, Shown):
    """A material; make it with one of the factories, e.g. `Material.swift(...)`.

    Attributes
    ----------
    law : str
        The factory's name, e.g. "swift".
    parameters : mapping of str to float or tuple of floats
        The factory's arguments, SI units; cannot be changed.
    kinematic : tuple of (float, float)
        Modulus [Pa] and recovery [-] of each backstress, see `with_kinematic_hardening`.
    thermal : tuple of float, or None
        Conductivity, expansion and diffusivity, see `with_thermal`.
    softening : callable, or None
        See `with_softening`.
    yield_profile, residual_stress : tuple of tuples of float, or None
        Depths [m] and values at each, see `with_yield_profile` and `with_residual_stress`.
    """

    law: str
    parameters: Mapping[str, Any]
    kinematic: tuple[tuple[float, float], ...] = ()
    thermal: tuple[float, float, float] | None = None
    softening: Callable[[FloatArray], ArrayLike] | None = None
    yield_profile: Profile | None = None
    residual_stress: Profile | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "parameters", checked_constants(self.law, self.parameters))
        terms = tuple(
            _numbers("kinematic", ("modulus", "recovery"), t) for t in _many(self.kinematic)
        )
        object.__setattr__(self, "kinematic", terms)
        if self.thermal is not None:
            names = ("conductivity", "expansion", "diffusivity")
            object.__setattr__(self, "thermal", _numbers("thermal", names, self.thermal))
        for name in PARTS:
            if getattr(self, name) is not None:
                object.__setattr__(self, name, profile(name, getattr(self, name)))
        if self.softening is not None:
            self._check_softening("softening", self.softening)
        if self.is_plastic and not np.isfinite(self.yield_stress(0.0)):
            raise ValueError(
                f"yield stress of law {self.law} must be finite: its constants are too large"
            )

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

    @classmethod
    def voce(
        cls, E: float, nu: float, yield_stress: float, saturation_stress: float, rate: float
    ) -> Material:
        """Voce's law sigma_y(g) = s_inf - (s_inf - s_0) exp(-rate g), which saturates.

        s_0 = yield_stress [Pa], s_inf = saturation_stress >= s_0 [Pa], rate > 0 [-]. Voce (1948),
        J. Inst. Metals 74, 537-562.
        """
        parameters = {
            "E": E,
            "nu": nu,
            "yield_stress": yield_stress,
            "saturation_stress": saturation_stress,
            "rate": rate,
        }
        return cls("voce", parameters)

    @classmethod
    def tabulated(
        cls, E: float, nu: float, plastic_strain: ArrayLike, stress: ArrayLike
    ) -> Material:
        """Points of a curve, as a test gives them: straight between them, constant beyond the last.

        Parameters
        ----------
        E, nu : float
            As of `elastic`.
        plastic_strain : array_like, shape (n,)
            Plastic strains [-] of a bar, total strain - true stress/E; the first 0, rising, at
            most 4096.
        stress : array_like, shape (n,)
            True stress [Pa] at each, > 0; it must not fall.

        Returns
        -------
        Material

        Raises
        ------
        ValueError
            The curve has another first strain, two stresses at a strain, or falls; a value is
            outside its range, or the numbers of values differ.
        TypeError
            One is not a number.
        """
        parameters = {"E": E, "nu": nu, "plastic_strain": plastic_strain, "stress": stress}
        return cls("tabulated", parameters)

    def with_kinematic_hardening(
        self, modulus: float | Sequence[float], recovery: float | Sequence[float] = 0.0
    ) -> Material:
        """The same material with a yield surface that also moves with the plastic strain.

        Each backstress X follows the plastic strain e and its equivalent g by
        dX = 2/3 modulus de - recovery X dg; several add up. The isotropic law of this material goes
        on beside: with `perfect_plastic` the hardening is purely kinematic.

        Parameters
        ----------
        modulus : float or sequence of up to 4 floats
            Slope of the uniaxial stress against plastic strain that each adds [Pa], > 0. A tangent
            modulus Et of the uniaxial curve needs the sum E Et/(E - Et).
        recovery : float or sequence of floats, optional
            >= 0 [-]. 0: linear (Prager 1949). Otherwise X saturates at modulus/recovery
            (Armstrong and Frederick 1966); several: Chaboche (1986),
            doi:10.1016/0749-6419(86)90010-0.

        Returns
        -------
        Material
            In place of any kinematic hardening it had.

        Raises
        ------
        ValueError
            The body does not yield, there are more than 4 backstresses, modulus and recovery differ
            in number, or one is outside its range.
        TypeError
            One is not a number.
        """
        moduli, recoveries = _many(modulus), _many(recovery)
        if not isinstance(recovery, (list, tuple)) and len(recoveries) == 1:  # one for all
            recoveries *= len(moduli)
        if len(moduli) != len(recoveries) or not moduli:
            raise ValueError(
                f"modulus and recovery must be as many, at least one each, got {len(moduli)} and "
                f"{len(recoveries)}"
            )
        terms = tuple(zip(moduli, recoveries, strict=True))
        return replace(self, kinematic=terms)

    def with_thermal(self, conductivity: float, expansion: float, diffusivity: float) -> Material:
        """The same material with thermal constants, as frictional heat needs them.

        Parameters
        ----------
        conductivity : float
            k [W/(m K)], > 0.
        expansion : float
            Linear expansion alpha [1/K], >= 0.
        diffusivity : float
            kappa = k/(rho c) [m^2/s], > 0; it has no effect in the steady state of a source at
            rest.

        Returns
        -------
        Material

        Raises
        ------
        ValueError
            The body is rigid, or a constant is outside its range.
        TypeError
            One is not a number.
        """
        return replace(self, thermal=(conductivity, expansion, diffusivity))

    def with_softening(self, law: Callable[[FloatArray], ArrayLike]) -> Material:
        """The same material with a yield stress that depends on the temperature.

        Parameters
        ----------
        law : callable
            Factor of the yield stress, in (0, 1], from the rise of temperature [K]; takes and
            returns an array of shape (nx, ny, nz), once in each increment, with the temperature
            of its first contact solution. `samcontact.softening.JohnsonCook` is one. A checkpoint
            stores that one only; for others give the law again to `Simulation.load`. A run with
            `checkpoint` continues only with the same law: its code and all data it uses are
            compared (defaults, closures, globals, attributes). A law with hidden state, such as a
            compiled object, must hold in an attribute `identity` all that it depends on, e.g.
            ``law.identity = ("my law", 2e-4)``.

        Returns
        -------
        Material

        Raises
        ------
        ValueError
            The body does not yield.
        TypeError
            The law is not callable.
        """
        self._check_softening("law", law)
        return replace(self, softening=law)

    def _check_softening(self, name: str, law: Any) -> None:
        if not callable(law):
            raise TypeError(f"{name} must be a function of the temperature, got {in_short(law)}")
        if not self.is_plastic:
            raise ValueError("softening needs a body that yields, not an elastic one")

    @cached_property
    def _core(self) -> Any:
        core = core_material(self.law, self.parameters)
        if self.kinematic:
            core = core.with_backstresses(list(self.kinematic))
        if self.thermal is not None:
            core = core.with_thermal(*self.thermal)
        if self.yield_profile is not None:
            core = core.with_yield_profile(*self.yield_profile)
        if self.residual_stress is not None:
            core = core.with_initial_stress(*self.residual_stress)
        return core

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

        With kinematic hardening the radius of the yield surface, without its backstress; without
        the factor of a yield profile, see `yield_factor`. Infinite for an elastic or rigid body.
        Raises ValueError where g is negative or not finite.
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
        """Work of the yield stress up to equivalent plastic strain g, its integral [J/m^3].

        What is dissipated per volume, without what kinematic hardening does (its backstress), and
        without the factors of thermal softening and of a yield profile. Scalar or array (same
        shape); 0 for a body that cannot yield. Raises ValueError where g is negative or not finite.
        """
        return self._at(g, self._core.work)

    def uniaxial_stress(self, strain: ArrayLike) -> FloatArray:
        """Axial stress in a bar of this material that is stretched and compressed.

        Parameters
        ----------
        strain : array_like, shape (n,)
            History of the total axial strain [-], tension positive, from the virgin state. Each
            value is one increment (backward Euler: exact for straight hardening, of first order in
            the steps otherwise).

        Returns
        -------
        ndarray, shape (n,)
            Axial stress [Pa]; the lateral stresses are zero.

        Raises
        ------
        ValueError
            Not one-dimensional, not finite, or a rigid body.
        """
        if self.is_rigid:
            raise ValueError("a rigid body has no uniaxial stress")
        history = real_array("strain", strain)
        if history.ndim != 1 or not np.isfinite(history).all():
            raise ValueError("strain must be one-dimensional and finite everywhere")
        stress = np.asarray(self._core.uniaxial_stress(history.tolist()), dtype=np.float64)
        if not np.isfinite(stress).all():
            largest = float(np.abs(history).max())
            raise ValueError(f"strain leads beyond the range of numbers, got up to {largest!r}")
        return stress

    def _rows(self) -> Rows:
        return material_rows(self)

    def __repr__(self) -> str:
        """All that it is."""
        beside = [field.name for field in fields(self)[2:]]
        extra = {name: getattr(self, name) for name in beside}
        given = {
            **self.parameters,
            **{name: value for name, value in extra.items() if value not in ((), None)},
        }
        return f"Material({', '.join([repr(self.law), *(f'{n}={v!r}' for n, v in given.items())])})"

    def __hash__(self) -> int:
        return hash(tuple(getattr(self, field.name) for field in fields(self)))

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: isotropic elasticity; J2 plasticity with isotropic and kinematic hardening."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from .._util.display import HtmlTable, Rows
from .._util.short_text import in_short
from .constants import as_list, named_numbers
from .depth_profiles import PROFILE_ARGUMENTS, HasDepthProfiles, Profile, profile
from .display import material_rows
from .flow_curve import HasFlowCurve
from .free_faces import FreeFaces, HasFreeFaces, checked_faces
from .hardening_laws import checked_constants, core_material
from .relaxation import HasRelaxation, RelaxationTerms, checked_relaxation
from .tension_test import FromTest


@dataclass(frozen=True, repr=False)
class Material(HasDepthProfiles, HasFlowCurve, HasFreeFaces, HasRelaxation, FromTest, HtmlTable):
    """Material of a body. Create it with a class method such as `Material.swift`.

    Attributes
    ----------
    law : str
        Name of the class method, e.g. "swift".
    parameters : mapping of str to float or tuple of floats
        Arguments of the class method in SI units; read-only.
    kinematic : tuple of (float, float)
        Modulus [Pa] and recovery [-] of each backstress, see `with_kinematic_hardening`.
    thermal : tuple of float, or None
        Conductivity, expansion and diffusivity, see `with_thermal`.
    softening : callable, or None
        Softening law, see `with_softening`.
    yield_profile, residual_stress : tuple of tuples of float, or None
        Depths [m] and the values at each depth, see `with_yield_profile` and
        `with_residual_stress`.
    free_faces : tuple of (float, float, str), or None
        Coordinates y of both free faces [m] and method, see `with_free_faces`.
    relaxation_terms : tuple of tuples of float, or None
        Relaxation times [s] and their shares of E [-], see `with_relaxation`.
    """

    law: str
    parameters: Mapping[str, Any]
    kinematic: tuple[tuple[float, float], ...] = ()
    thermal: tuple[float, float, float] | None = None
    softening: Callable[[FloatArray], ArrayLike] | None = None
    yield_profile: Profile | None = None
    residual_stress: Profile | None = None
    free_faces: FreeFaces | None = None
    relaxation_terms: RelaxationTerms | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "parameters", checked_constants(self.law, self.parameters))
        terms = tuple(
            named_numbers("kinematic", ("modulus", "recovery"), t) for t in as_list(self.kinematic)
        )
        object.__setattr__(self, "kinematic", terms)
        if self.thermal is not None:
            names = ("conductivity", "expansion", "diffusivity")
            object.__setattr__(self, "thermal", named_numbers("thermal", names, self.thermal))
        for name in PROFILE_ARGUMENTS:
            if getattr(self, name) is not None:
                object.__setattr__(self, name, profile(name, getattr(self, name)))
        if self.free_faces is not None:
            object.__setattr__(self, "free_faces", checked_faces(self.free_faces))
        if self.relaxation_terms is not None:
            terms = checked_relaxation(self.relaxation_terms)
            object.__setattr__(self, "relaxation_terms", terms)
        if self.softening is not None:
            self._check_softening("softening", self.softening)
        if self.is_plastic and not np.isfinite(self.yield_stress(0.0)):
            raise ValueError(
                f"parameters of law {self.law} must give a finite yield stress, got inf or "
                "NaN: use smaller values"
            )

    @classmethod
    def elastic(cls, E: float, nu: float) -> Material:
        """Elastic body: Young's modulus E [Pa], Poisson's ratio nu in [0, 0.5)."""
        return cls("elastic", {"E": E, "nu": nu})

    @classmethod
    def rigid(cls) -> Material:
        """Rigid body (infinite E)."""
        return cls("rigid", {})

    @classmethod
    def perfect_plastic(cls, E: float, nu: float, yield_stress: float) -> Material:
        """Elastic, perfectly plastic body with constant yield stress [Pa]."""
        return cls("perfect_plastic", {"E": E, "nu": nu, "yield_stress": yield_stress})

    @classmethod
    def linear_hardening(
        cls, E: float, nu: float, yield_stress: float, tangent_modulus: float
    ) -> Material:
        """Bilinear uniaxial curve with slope Et = tangent_modulus [Pa] above yield, 0 <= Et < E.

        The yield stress increases with the equivalent plastic strain at the rate E Et/(E - Et).
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
        """Swift's law sigma_y(g) = B (C + 1e6 g)^n, B [Pa], C > 0 in microstrain, 0 <= n <= 1.

        g is the equivalent plastic strain [-]. Boucly (2008), eq. (2.162), with the strain in
        microstrain, as the published constants require.
        """
        return cls("swift", {"E": E, "nu": nu, "B": B, "C": C, "n": n})

    @classmethod
    def voce(
        cls, E: float, nu: float, yield_stress: float, saturation_stress: float, rate: float
    ) -> Material:
        """Voce's law sigma_y(g) = s_inf - (s_inf - s_0) exp(-rate g), which saturates.

        g is the equivalent plastic strain [-], s_0 = yield_stress [Pa], s_inf = saturation_stress
        >= s_0 [Pa], rate > 0 [-]. Voce (1948), J. Inst. Metals 74, 537-562.
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
        """Hardening by linear interpolation of a measured curve, constant beyond its last point.

        Parameters
        ----------
        E, nu : float
            As in `elastic`.
        plastic_strain : array_like, shape (n,)
            Uniaxial plastic strains [-], i.e. total strain minus true stress/E. At most 4096
            increasing values; the first value is 0.
        stress : array_like, shape (n,)
            True stress [Pa] at each plastic strain, > 0, not decreasing.

        Returns
        -------
        Material

        Raises
        ------
        ValueError
            The first strain is not 0, strains do not increase, stresses decrease, a value is
            outside its range, or the arguments differ in length.
        TypeError
            An argument is not a number.
        """
        parameters = {"E": E, "nu": nu, "plastic_strain": plastic_strain, "stress": stress}
        return cls("tabulated", parameters)

    def with_kinematic_hardening(
        self, modulus: float | Sequence[float], recovery: float | Sequence[float] = 0.0
    ) -> Material:
        """Return a copy with a yield surface that translates with the plastic strain.

        Each backstress X evolves with the plastic strain e and the equivalent plastic strain g by
        dX = 2/3 modulus de - recovery X dg. Several backstresses are summed. The isotropic law of
        this material stays in effect: with `perfect_plastic` the hardening is purely kinematic.

        Parameters
        ----------
        modulus : float or sequence of up to 4 floats
            Contribution of each backstress to the slope of uniaxial stress against plastic strain
            [Pa], > 0. For a tangent modulus Et of the uniaxial curve, the sum of the moduli must
            be E Et/(E - Et).
        recovery : float or sequence of floats, optional
            Dynamic recovery >= 0 [-]. With 0, hardening is linear (Prager 1949); otherwise X
            saturates at modulus/recovery (Armstrong and Frederick 1966). Several backstresses:
            Chaboche (1986), doi:10.1016/0749-6419(86)90010-0. Default: 0.

        Returns
        -------
        Material
            Material in which this hardening replaces any earlier kinematic hardening.

        Raises
        ------
        ValueError
            The body does not yield, there are more than 4 backstresses, modulus and recovery differ
            in length, or a value is outside its range.
        TypeError
            An argument is not a number.
        """
        moduli, recoveries = as_list(modulus), as_list(recovery)
        if not isinstance(recovery, (list, tuple)) and len(recoveries) == 1:  # for all
            recoveries *= len(moduli)
        if len(moduli) != len(recoveries) or not moduli:
            raise ValueError(
                f"modulus and recovery must have equal lengths >= 1, got {len(moduli)} and "
                f"{len(recoveries)}"
            )
        terms = tuple(zip(moduli, recoveries, strict=True))
        return replace(self, kinematic=terms)

    def with_thermal(self, conductivity: float, expansion: float, diffusivity: float) -> Material:
        """Return a copy with thermal constants, required for frictional heating.

        Parameters
        ----------
        conductivity : float
            Thermal conductivity k [W/(m K)], > 0.
        expansion : float
            Linear thermal expansion alpha [1/K], >= 0.
        diffusivity : float
            Thermal diffusivity kappa = k/(rho c) [m^2/s], > 0, with density rho and specific heat
            c; kappa does not affect the steady state of a source at rest.

        Returns
        -------
        Material

        Raises
        ------
        ValueError
            The body is rigid, or a constant is outside its range.
        TypeError
            An argument is not a number.
        """
        return replace(self, thermal=(conductivity, expansion, diffusivity))

    def with_softening(self, law: Callable[[FloatArray], ArrayLike]) -> Material:
        """Return a copy with a temperature-dependent yield stress.

        Parameters
        ----------
        law : callable
            Function of the temperature rise [K] that returns the factor on the yield stress, from 0
            (excluded) to 1; argument and result are arrays of shape (nx, ny, nz). The law is called
            once per increment, after the contact has been solved for the first time in this
            increment, with the temperature rise of this solution.
            `samcontact.softening.JohnsonCook` is stored in checkpoints; any other law must be
            passed to `Simulation.load` again. A run with the argument `checkpoint` resumes only
            with an identical law: the code of the law and all data that the code uses are compared
            (defaults, closures, globals, attributes). A law with hidden state, such as a compiled
            object, must have an attribute `identity` that contains all data on which the law
            depends, e.g. ``law.identity = ("my law", 2e-4)``.

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
            raise TypeError(
                f"{name} must be a function of the temperature rise, got {in_short(law)}"
            )
        if not self.is_plastic:
            raise ValueError(
                "softening requires an elastic-plastic material: give the "
                "material a hardening law first"
            )

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
        if self.free_faces is not None:
            low, high, method = self.free_faces
            core = core.with_free_faces(low, high, method == "exact")
        if self.relaxation_terms is not None:
            core = core.with_relaxation(*self.relaxation_terms)
        return core

    @cached_property
    def E(self) -> float:
        """Young's modulus [Pa]; infinite for a rigid body."""
        return float(self._core.elastic_constants.E)

    @cached_property
    def nu(self) -> float:
        """Poisson's ratio [-]."""
        return float(self._core.elastic_constants.nu)

    @property
    def is_rigid(self) -> bool:
        """Whether the body is rigid."""
        return self.law == "rigid"

    @property
    def is_viscoelastic(self) -> bool:
        """Whether the body relaxes, see `with_relaxation`."""
        return self.relaxation_terms is not None

    @cached_property
    def is_plastic(self) -> bool:
        """Whether the body can yield."""
        return bool(self._core.is_plastic)

    def _rows(self) -> Rows:
        return material_rows(self)

    def __repr__(self) -> str:
        """Constructor call with all attributes."""
        other_fields = [field.name for field in fields(self)[2:]]
        extra = {name: getattr(self, name) for name in other_fields}
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

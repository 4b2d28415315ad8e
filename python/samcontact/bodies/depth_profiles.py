# SPDX-License-Identifier: GPL-3.0-or-later
"""Depth profiles of a material: yield stress and initial (residual) stress."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, real_array
from .._util.short_text import in_short

if TYPE_CHECKING:
    from typing_extensions import Self

Profile = tuple[tuple[float, ...], ...]
"""The first tuple contains the depths, each further tuple one quantity at these depths."""

PROFILE_ARGUMENTS: Mapping[str, Sequence[str]] = {
    "yield_profile": ("z", "factor"),
    "residual_stress": ("z", "sxx", "syy", "sxy"),
}
"""Names of the arguments for each kind of depth profile."""

MAX_PROFILE_POINTS = 4096
"""Maximum number of depths in a profile, limited by the size of attributes in HDF5 files."""


def profile(kind: str, given: Any) -> Profile:
    """Check the depths and values of a profile, and return them as tuples of equal length.

    kind: kind of profile, a key of `PROFILE_ARGUMENTS`. The compiled core checks the ranges of the
    values.
    """
    names = PROFILE_ARGUMENTS[kind]
    holds = f"{kind} must contain {len(names)} lists of numbers ({', '.join(names)})"
    if not isinstance(given, (list, tuple)):
        raise TypeError(f"{holds}, got {in_short(given)}")
    parts = tuple(given)
    if len(parts) != len(names):
        raise ValueError(f"{holds}, got {len(parts)} lists")
    names = [f"{name} of {kind}" for name in names]
    values = [real_array(name, part) for name, part in zip(names, parts, strict=True)]
    for name, part in zip(names, values, strict=True):
        if part.ndim != 1 or not 1 <= part.size <= MAX_PROFILE_POINTS:
            raise ValueError(
                f"{name} must be a list of 1 to {MAX_PROFILE_POINTS} numbers, got shape "
                f"{part.shape}"
            )
        if part.shape != values[0].shape:
            raise ValueError(
                f"{name} must have as many values as z ({values[0].size}), got {part.size}"
            )
        if not np.isfinite(part).all():
            raise ValueError(f"{name} must contain finite numbers only, got NaN or inf")
    return tuple(tuple((part + 0.0).tolist()) for part in values)


class HasDepthProfiles:
    """Base class of `Material` with yield stress and initial stress that depend on depth."""

    yield_profile: Profile | None
    residual_stress: Profile | None

    def with_yield_profile(self, z: ArrayLike, factor: ArrayLike) -> Self:
        """Return a copy with a yield stress that varies with depth, as in case hardening.

        Elastic constants are unchanged. At depth z, the initial and the hardened yield stress are
        factor(z) times the values that the hardening law gives.

        Parameters
        ----------
        z : array_like, shape (n,)
            Increasing depths below the surface [m], >= 0; at most 4096 values. The profile is
            linear between these depths, and constant above the first and below the last one. Each
            layer of grid cells has the value at its mid-depth.
        factor : array_like, shape (n,)
            Yield stress at each depth divided by that of the hardening law [-], from 1e-6 to 1e6,
            e.g. the local hardness divided by the hardness of the unhardened core.

        Returns
        -------
        Material
            Material in which this profile replaces any earlier one.

        Raises
        ------
        ValueError
            The material is not elastic-plastic, z does not increase, z and factor differ in length,
            a value is outside its range, or the residual stress exceeds the yield stress.
        TypeError
            An argument is not a number.
        """
        checked = profile("yield_profile", (z, factor))
        return cast("Self", replace(cast("Any", self), yield_profile=checked))

    def with_residual_stress(
        self,
        z: ArrayLike,
        sxx: ArrayLike,
        syy: ArrayLike | None = None,
        sxy: ArrayLike | None = None,
    ) -> Self:
        """Return a copy with initial (residual) stress, as from peening or case hardening.

        The stress acts in the plane of the surface and varies with depth only. It is therefore in
        equilibrium for any profile and causes no displacement. In a half-space, compression near
        the surface needs no balancing tension below. For a component of finite thickness, include
        the balancing stress in the profile. The initial stress enters the yield condition and is
        included in all stresses of a `State`, also in its residual stress.

        Parameters
        ----------
        z : array_like, shape (n,)
            Increasing depths below the surface [m], >= 0; at most 4096 values. The profile is
            linear between these depths, and constant above the first and below the last one. If the
            stress is to vanish at greater depths, let the stresses end with 0.
        sxx : array_like, shape (n,)
            Normal stress along x [Pa], tension positive.
        syy : array_like, shape (n,), optional
            Normal stress along y [Pa]. Default: `sxx`.
        sxy : array_like, shape (n,), optional
            In-plane shear stress [Pa]. Default: 0.

        Returns
        -------
        Material
            Material in which this stress replaces any earlier one.

        Raises
        ------
        ValueError
            The material is rigid, z does not increase, the arguments differ in length, a value is
            not finite, or the von Mises stress exceeds the yield stress of the material at some
            depth. If the material yielded while the residual stress formed, include the resulting
            hardening in the hardening law or in a yield profile.
        TypeError
            An argument is not a number.
        """
        along_y = sxx if syy is None else syy
        shear = np.zeros_like(real_array("sxx", sxx)) if sxy is None else sxy
        checked = profile("residual_stress", (z, sxx, along_y, shear))
        return cast("Self", replace(cast("Any", self), residual_stress=checked))

    def yield_factor(self, z: ArrayLike) -> FloatArray:
        """Yield stress at depths z [m] / yield stress of the hardening law; 1 without a profile.

        The result has the shape of z. Raises ValueError if z is negative or not finite.
        """
        depths = checked_depths(z)
        if self.yield_profile is None:
            return np.ones_like(depths)
        factor: FloatArray = _at(self.yield_profile, depths)[0]
        return factor

    def yield_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial yield stress [Pa] at depths z [m]; infinite for a body that cannot yield.

        The result has the shape of z. Raises ValueError if z is negative or not finite.
        """
        factor = self.yield_factor(z)
        return float(cast("Any", self).yield_stress(0.0)) * factor

    @cached_property
    def min_yield_stress(self) -> float:
        """Minimum initial yield stress over depth [Pa]; infinite for a body that cannot yield."""
        initial = float(cast("Any", self).yield_stress(0.0))
        return initial if self.yield_profile is None else initial * min(self.yield_profile[1])

    def residual_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial stresses sxx, syy and sxy [Pa] at depths z [m], each with the shape of z.

        They are 0 in a material without residual stress. Raises ValueError if z is negative or not
        finite.
        """
        depths = checked_depths(z)
        if self.residual_stress is None:
            return np.zeros((3, *depths.shape))
        return _at(self.residual_stress, depths)


def checked_depths(z: ArrayLike) -> FloatArray:
    """Return depths [m] as an array; raise ValueError if a depth is negative or not finite."""
    depths = real_array("z", z)
    bad = ~(np.isfinite(depths) & (depths >= 0))
    if bad.any():
        raise ValueError(f"z must be finite and >= 0, got {float(depths[bad].flat[0])!r}")
    return depths


def _at(of: Profile, z: FloatArray) -> FloatArray:
    """Interpolate the quantities of a profile to depths z [m]; shape (quantities, *z.shape)."""
    return np.array([np.interp(z, of[0], values) for values in of[1:]])

# SPDX-License-Identifier: GPL-3.0-or-later
"""What changes with depth in a material: yield stress, and stress that is there from the start."""

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
"""Depths, and one or more values at each."""

PARTS: Mapping[str, Sequence[str]] = {
    "yield_profile": ("z", "factor"),
    "residual_stress": ("z", "sxx", "syy", "sxy"),
}
"""The profiles of a material, and what each holds."""

MOST = 4096
"""Depths of a profile, which attributes of HDF5 files can hold."""


def profile(kind: str, given: Any) -> Profile:
    """Depths and values, as many of each; what they may be is checked by the core."""
    holds = f"{kind} must hold {', '.join(PARTS[kind])}, a list of numbers each"
    if not isinstance(given, (list, tuple)):
        raise TypeError(f"{holds}, got {in_short(given)}")
    parts = tuple(given)
    if len(parts) != len(PARTS[kind]):
        raise ValueError(f"{holds}, got {len(parts)} of them")
    names = [f"{name} of {kind}" for name in PARTS[kind]]
    values = [real_array(name, part) for name, part in zip(names, parts, strict=True)]
    for name, part in zip(names, values, strict=True):
        if part.ndim != 1 or not 1 <= part.size <= MOST:
            raise ValueError(
                f"{name} must be a list of 1 to {MOST} numbers, got shape {part.shape}"
            )
        if part.shape != values[0].shape:
            raise ValueError(
                f"{name} must have as many values as z, {values[0].size}, got {part.size}"
            )
        if not np.isfinite(part).all():
            raise ValueError(f"{name} must be finite everywhere")
    return tuple(tuple((part + 0.0).tolist()) for part in values)


class Graded:
    """The part of a material that knows of depth."""

    yield_profile: Profile | None
    residual_stress: Profile | None

    def with_yield_profile(self, z: ArrayLike, factor: ArrayLike) -> Self:
        """The same material with a yield stress that changes with depth, as of a hardened case.

        Elastic constants stay as they are, and so does the hardening but for the factor: at depth z
        the yield stress is factor(z) times that of the law.

        Parameters
        ----------
        z : array_like, shape (n,)
            Depths below the surface [m], >= 0 and rising, at most 4096. The profile is straight
            between them and constant beyond; layers of a grid take its value at mid-depth.
        factor : array_like, shape (n,)
            From 1e-6 to 1e6 [-]; e.g. the hardness there over that of the core.

        Returns
        -------
        Material
            In place of any profile it had.

        Raises
        ------
        ValueError
            The body does not yield, z does not rise, z and factor differ in number, a value is
            outside its range, or the residual stress of the material is above its yield stress.
        TypeError
            One is not a number.
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
        """The same material with stress that is there before any contact, as of peening or a case.

        It acts along the surface and changes with depth only: so it is in equilibrium, whatever
        its profile, and moves nothing. A half-space needs no tension to balance it; what balances
        it in a part of finite thickness is yours to add. It counts in yield and in all stresses of
        states, residual ones too.

        Parameters
        ----------
        z : array_like, shape (n,)
            Depths below the surface [m], >= 0 and rising, at most 4096. The profile is straight
            between them and constant beyond: end it with 0 where it is to end.
        sxx : array_like, shape (n,)
            Normal stress along x [Pa], tension positive.
        syy : array_like, shape (n,), optional
            The same along y; default as along x.
        sxy : array_like, shape (n,), optional
            Shear stress in the plane of the surface [Pa]; default 0.

        Returns
        -------
        Material
            In place of any residual stress it had.

        Raises
        ------
        ValueError
            The body is rigid, z does not rise, the numbers of values differ, a value is not finite,
            or the von Mises stress is above the yield stress of the material at some depth: what
            flowed while the stress arose has hardened, which the law or a yield profile must say.
        TypeError
            One is not a number.
        """
        along_y = sxx if syy is None else syy
        shear = np.zeros_like(real_array("sxx", sxx)) if sxy is None else sxy
        checked = profile("residual_stress", (z, sxx, along_y, shear))
        return cast("Self", replace(cast("Any", self), residual_stress=checked))

    def yield_factor(self, z: ArrayLike) -> FloatArray:
        """Factor of the yield stress at depths z [m], same shape; 1 without a yield profile.

        Raises ValueError where z is negative or not finite.
        """
        depths = checked_depths(z)
        if self.yield_profile is None:
            return np.ones_like(depths)
        factor: FloatArray = _at(self.yield_profile, depths)[0]
        return factor

    def yield_stress_at(self, z: ArrayLike) -> FloatArray:
        """Yield stress before hardening at depths z [Pa], same shape; infinite without yield.

        Raises ValueError where z is negative or not finite.
        """
        factor = self.yield_factor(z)
        return float(cast("Any", self).yield_stress(0.0)) * factor

    @cached_property
    def least_yield_stress(self) -> float:
        """Smallest yield stress of all depths before hardening [Pa]; infinite without yield."""
        initial = float(cast("Any", self).yield_stress(0.0))
        return initial if self.yield_profile is None else initial * min(self.yield_profile[1])

    def residual_stress_at(self, z: ArrayLike) -> FloatArray:
        """Stress of the start at depths z [m]: sxx, syy and sxy [Pa], one array of z's shape each.

        0 without. Raises ValueError where z is negative or not finite.
        """
        depths = checked_depths(z)
        if self.residual_stress is None:
            return np.zeros((3, *depths.shape))
        return _at(self.residual_stress, depths)


def checked_depths(z: ArrayLike) -> FloatArray:
    """Depths below a surface; ValueError where one is negative or not finite."""
    depths = real_array("z", z)
    bad = ~(np.isfinite(depths) & (depths >= 0))
    if bad.any():
        raise ValueError(f"z must be finite and >= 0, got {float(depths[bad].flat[0])!r}")
    return depths


def _at(of: Profile, z: FloatArray) -> FloatArray:
    """Values at depths, one array after the other, shape (values, *z.shape)."""
    return np.array([np.interp(z, of[0], values) for values in of[1:]])

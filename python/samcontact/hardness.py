# SPDX-License-Identifier: GPL-3.0-or-later
"""Strength of steel from its hardness: yield stress, fatigue limit, profiles of hardened cases.

    case = sc.hardness.hardened_case(surface=620.0, core=380.0, depth=0.8e-3)  # CHD 550 [m]
    steel = case.applied_to(sc.Material.linear_hardening(E, nu, yield_stress, tangent_modulus))

All relations are estimates from the bulk hardness with a stated range. The shape of the profile of
`hardened_case` is assumed: use measured points (`HardnessProfile`) where you have them.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._util.checks import FloatArray, choice, number, positive, real_array, require_type
from ._util.display import HtmlTable, Rows, ShortRepr, lengths
from .bodies.depth_profiles import MAX_PROFILE_POINTS, checked_depths
from .bodies.material import Material

__all__ = [
    "HardnessProfile",
    "HardnessRangeWarning",
    "bending_limit_from_vickers",
    "flow_stress_from_vickers",
    "hardened_case",
    "yield_from_vickers",
]

STANDARD_GRAVITY = 9.80665
"""Standard gravity [m/s^2], to convert Vickers numbers in kgf/mm^2."""
FITTED_RANGE = (129.0, 632.0)
"""Range of Vickers numbers of the steels to which the yield stress was fitted."""
BENDING_RANGE = (70.0, 400.0)
"""Range of Vickers numbers in which the fatigue limit is proportional to the hardness."""
DEFECT_RANGE = (70.0, 720.0)
"""Range of Vickers numbers in which the fatigue limit depends on the size of a defect."""
MAX_DEFECT = 1e-3
"""Maximum square root of the area of a defect [m]."""
MAX_CASE_DEPTH = 0.02
"""Maximum depth of a case [m]; a larger number is probably in millimetres."""
PLAUSIBLE_RANGE = (20.0, 3000.0)
"""Range of Vickers numbers of metals and hard carbides; numbers in MPa or GPa are outside."""


class HardnessRangeWarning(UserWarning):
    """Warning that a hardness is outside the range of the data to which the relation was fitted."""


def _vickers(HV: ArrayLike, name: str = "HV") -> FloatArray:
    hardness = real_array(name, HV)
    wrong = hardness[~((hardness >= PLAUSIBLE_RANGE[0]) & (hardness <= PLAUSIBLE_RANGE[1]))]
    if wrong.size:
        raise ValueError(
            f"{name} must be Vickers numbers (kgf/mm^2) from {PLAUSIBLE_RANGE[0]:g} to "
            f"{PLAUSIBLE_RANGE[1]:g}, got {wrong.flat[0]:g}: convert GPa, e.g. 7 GPa is HV 714"
        )
    return hardness


def _warn_beyond(hardness: FloatArray, data: tuple[float, float]) -> None:
    """Warn if a hardness is outside the range of the data of a linear relation."""
    beyond = hardness[(hardness < data[0]) | (hardness > data[1])]
    if beyond.size:
        warnings.warn(
            f"HV = {beyond.flat[0]:g} is outside the range of the data, {data[0]:g} to "
            f"{data[1]:g}: the linear relation is extrapolated",
            HardnessRangeWarning,
            stacklevel=3,
        )


def yield_from_vickers(HV: ArrayLike) -> FloatArray:
    """Yield stress of steel [Pa] by the regression -90.7 MPa + 2.876 MPa * HV.

    The data are from 165 non-austenitic, hypoeutectoid steels of HV 129 to 632; the standard error
    is 102 MPa. E. J. Pavlina, C. J. Van Tyne, J. Mater. Eng. Perform. 17 (2008) 888-893, table 1,
    doi:10.1007/s11665-008-9225-5.

    Parameters
    ----------
    HV : array_like
        Vickers hardness [kgf/mm^2], of any shape.

    Returns
    -------
    ndarray
        0.2 % yield stress [Pa], in the shape of `HV`.

    Raises
    ------
    ValueError
        A value is not a Vickers number of a metal.

    Warns
    -----
    HardnessRangeWarning
        A hardness is outside the range of the data; the linear relation is extrapolated.
    """
    hardness = _vickers(HV)
    _warn_beyond(hardness, FITTED_RANGE)
    return np.asarray(-90.7e6 + 2.876e6 * hardness)


def flow_stress_from_vickers(HV: ArrayLike) -> FloatArray:
    """Flow stress at about 8 % plastic strain [Pa], a third of the hardness.

    The relation holds for metals that harden little further: D. Tabor, *The Hardness of Metals*
    (1951), chapter 7.
    This stress is a point on the hardening curve, not the yield stress.

    Parameters
    ----------
    HV : array_like
        Vickers hardness [kgf/mm^2], of any shape.

    Returns
    -------
    ndarray
        Flow stress [Pa], in the shape of `HV`.

    Raises
    ------
    ValueError
        A value is not a Vickers number of a metal.
    """
    return np.asarray(_vickers(HV) * STANDARD_GRAVITY * 1e6 / 3.0)


def bending_limit_from_vickers(
    HV: ArrayLike, defect: float | None = None, location: str = "internal"
) -> FloatArray:
    """Fatigue limit of steel in reversed bending or tension [Pa].

    Without a defect, the limit is 1.6 MPa HV (scatter 0.1 MPa HV), for HV 70 to 400. Harder steels
    fail from inclusions. With `defect`, the limit is C MPa (HV + 120) / s^(1/6), but at most
    1.6 MPa HV. Here s is the square root of the projected area of the largest inclusion in
    micrometres; C is 1.56 in the interior and 1.43 at the surface. The relation holds for HV 70 to
    720 and s up to 1000, with a scatter of 10 %.
    Y. Murakami, *Metal Fatigue: Effects of Small Defects and Nonmetallic Inclusions* (2002),
    chapters 1 and 5.

    Parameters
    ----------
    HV : array_like
        Vickers hardness [kgf/mm^2], of any shape.
    defect : float, optional
        Square root of the area of the largest defect, projected onto a plane normal to the stress
        [m], > 0, at most 1 mm. Default: no defect.
    location : {"internal", "surface"}, optional
        Place of the defect.

    Returns
    -------
    ndarray
        Stress amplitude at the limit, without mean stress [Pa], in the shape of `HV`.

    Raises
    ------
    ValueError
        A value is not a Vickers number, the defect is larger than 1 mm, or the location is unknown.

    Warns
    -----
    HardnessRangeWarning
        A hardness is outside the range of the relation. Above HV 400 and without a defect, the
        limit is overestimated.
    """
    hardness = _vickers(HV)
    C = {"internal": 1.56e6, "surface": 1.43e6}[
        choice("location", location, ("internal", "surface"))
    ]
    smooth = 1.6e6 * hardness
    if defect is None:
        _warn_beyond(hardness, BENDING_RANGE)
        return np.asarray(smooth)
    size = positive("defect", defect)
    if size > MAX_DEFECT:
        raise ValueError(f"defect must be at most {MAX_DEFECT:g} m, got {size:g}")
    _warn_beyond(hardness, DEFECT_RANGE)
    return np.asarray(np.minimum(smooth, C * (hardness + 120.0) / (size * 1e6) ** (1 / 6)))


@dataclass(frozen=True, repr=False)
class HardnessProfile(ShortRepr, HtmlTable):
    """Vickers hardness over depth, piecewise linear, constant beyond its ends.

    Parameters
    ----------
    z : array_like, shape (n,)
        Increasing depths below the surface [m], >= 0; at most 4096 values.
    HV : array_like, shape (n,)
        Vickers hardness [kgf/mm^2] at these depths.

    Raises
    ------
    ValueError
        The depths do not increase, exceed 20 mm (given in millimetres?) or differ in number from
        the hardness values, or a hardness is not a Vickers number.
    TypeError
        An argument is not a number.
    """

    z: tuple[float, ...]
    HV: tuple[float, ...]

    def __post_init__(self) -> None:
        z, HV = real_array("z", self.z), _vickers(self.HV)
        if z.ndim != 1 or not 1 <= z.size <= MAX_PROFILE_POINTS or z.shape != HV.shape:
            raise ValueError(
                f"z and HV must be lists of the same length, 1 to {MAX_PROFILE_POINTS}, got shapes "
                f"{z.shape} and {HV.shape}"
            )
        if not (np.isfinite(z).all() and z[0] >= 0 and (np.diff(z) > 0).all()):
            raise ValueError("z must contain increasing depths >= 0 only")
        if z[-1] > MAX_CASE_DEPTH:
            raise ValueError(
                f"z must be depths in m, at most {MAX_CASE_DEPTH:g}, got {z[-1]:g}: multiply "
                "millimetres by 1e-3"
            )
        object.__setattr__(self, "z", tuple((z + 0.0).tolist()))
        object.__setattr__(self, "HV", tuple(HV.tolist()))

    def at(self, z: ArrayLike) -> FloatArray:
        """Return the Vickers hardness at depths z [m], in the shape of z.

        Raises ValueError for depths < 0.
        """
        return np.asarray(np.interp(checked_depths(z), self.z, self.HV))

    def depth_of(self, HV: float) -> float:
        """Smallest depth at which the hardness falls below `HV` [m]: the CHD for HV = 550.

        The depth is 0 if the surface is softer than `HV`. Raises ValueError if the hardness does
        not fall below `HV`.
        """
        wanted = float(_vickers(number("HV", HV)))
        if self.HV[0] < wanted:
            return 0.0
        below = np.flatnonzero(np.asarray(self.HV) < wanted)
        if below.size == 0:
            raise ValueError(
                f"HV must be above the smallest hardness of the profile, {min(self.HV):g}, got "
                f"{wanted:g}"
            )
        i = int(below[0])
        part = (self.HV[i - 1] - wanted) / (self.HV[i - 1] - self.HV[i])
        return self.z[i - 1] + part * (self.z[i] - self.z[i - 1])

    def applied_to(self, material: Material) -> Material:
        """Return an elastic-plastic material whose initial yield stress follows this hardness.

        The yield stress of `yield_from_vickers` at each depth replaces the initial yield stress of
        the law; the hardening of the law is scaled by the same factor.

        Raises
        ------
        ValueError
            The material does not yield.
        TypeError
            The argument is not a Material.

        Warns
        -----
        HardnessRangeWarning
            A hardness is outside the range of the data.
        """
        require_type("material", material, Material)
        if not material.is_plastic:
            raise ValueError(
                "material must be elastic-plastic: give it a hardening law, whose yield stress the "
                "hardness then scales"
            )
        factor = yield_from_vickers(self.HV) / float(material.yield_stress(0.0))
        return material.with_yield_profile(self.z, factor)

    def _rows(self) -> Rows:
        return [
            ("hardness", f"HV {self.HV[0]:g} to {self.HV[-1]:g}"),
            ("depths", f"{lengths(self.z[0])} to {lengths(self.z[-1])}"),
        ]


def hardened_case(
    surface: float, core: float, depth: float, limit: float = 550.0
) -> HardnessProfile:
    """Return the hardness profile of a case with a given hardening depth.

    Parameters
    ----------
    surface, core : float
        Vickers hardness of the surface and of the core [kgf/mm^2].
    depth : float
        Case hardening depth, at which the hardness is `limit` [m], > 0, at most 20 mm; CHD of
        ISO 18203 for the limit 550. The nitriding hardness depth has the limit core + 50.
    limit : float, optional
        Hardness at this depth, between core and surface. Default: 550.

    Returns
    -------
    HardnessProfile
        Assumed bell curve core + (surface - core) exp(-(z/d)^2) through the limit, in 61 points.

    Raises
    ------
    ValueError
        A value is not a Vickers number, the values are not in the order surface > limit > core, or
        the depth is outside its range.
    TypeError
        An argument is not a number.
    """
    hard, soft, at = (
        float(_vickers(number(name, value), name))
        for name, value in (("surface", surface), ("core", core), ("limit", limit))
    )
    chd = positive("depth", depth)
    if not soft < at < hard:
        raise ValueError(
            f"limit must be between core and surface, got core {soft:g}, limit {at:g}, surface "
            f"{hard:g}"
        )
    if chd > MAX_CASE_DEPTH:
        raise ValueError(
            f"depth must be in m, at most {MAX_CASE_DEPTH:g}, got {chd:g}: multiply millimetres by "
            "1e-3"
        )
    length = chd / math.sqrt(math.log((hard - soft) / (at - soft)))
    z = np.unique(np.append(np.linspace(0.0, 2.6 * length, 60), chd))
    curve = soft + (hard - soft) * np.exp(-((z / length) ** 2))
    curve[np.searchsorted(z, chd)] = at
    if z[-1] > MAX_CASE_DEPTH:
        inside = z <= MAX_CASE_DEPTH
        z, curve = z[inside], curve[inside]
    return HardnessProfile(tuple(z.tolist()), tuple(curve.tolist()))

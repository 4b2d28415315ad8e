# SPDX-License-Identifier: GPL-3.0-or-later
"""Gap between a roller of finite length and a raceway, with profile, tilt and skew."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite, finite_array, non_negative, positive
from .._util.lazy_scipy import scipy
from .._util.short_text import in_short
from .shapes import SurfaceGrid, coordinates

PROFILES = ("straight", "crowned", "logarithmic", "lundberg")
SHORT_FACTOR, LONG_FACTOR, LONG_RATIO = 0.35e-3, 0.5e-3, 2.5
"""Factors of the logarithmic profile in ISO/TS 16281, divided by the roller diameter: for rollers
of up to LONG_RATIO diameters in length, and for longer rollers."""
MAX_ANGLE = 0.1
"""Maximum tilt and skew [rad], because the gap is linearised with respect to the tilt."""

_USERS = {
    "crown_radius": "crowned",
    "straight_length": "crowned",
    "diameter": "logarithmic",
    "design_load": "lundberg",
    "E_star": "lundberg",
}
"""Profile to which each optional argument belongs."""
_REQUIRED = {"crowned": ("crown_radius",), "lundberg": ("design_load", "E_star")}


def roller(
    grid: SurfaceGrid,
    radius: float,
    length: float,
    profile: str | tuple[ArrayLike, ArrayLike] = "straight",
    *,
    race_radius: float = math.inf,
    crown_radius: float | None = None,
    straight_length: float | None = None,
    diameter: float | None = None,
    design_load: float | None = None,
    E_star: float | None = None,
    tilt: float = 0.0,
    skew: float = 0.0,
) -> FloatArray:
    """Gap between a raceway and a roller of finite length along y.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    radius : float
        Radius of the roller [m], or the equivalent radius of roller and race if `race_radius` is
        omitted.
    length : float
        Effective length of the roller, without corner radii [m].
    profile : {"straight", "crowned", "logarithmic", "lundberg"} or pair of array_like
        Name of the profile, see Notes, or a table (y, drop): positions along the roller and the
        drop of the profile there [m]. In a table, y must increase from -length/2 (from 0 for a
        symmetric profile) to length/2. Between its points, the drop is interpolated by monotone
        cubics.
    race_radius : float, optional
        Radius of the raceway in the plane of rolling [m], negative for the concave race of an outer
        ring. Default: inf, flat.
    crown_radius, straight_length : float, optional
        Only for "crowned": radius of the arc along y, and length of the straight middle part
        (default 0) [m].
    diameter : float, optional
        Only for "logarithmic": diameter of the roller [m]. Default: 2 `radius`.
    design_load, E_star : float, optional
        Only for "lundberg": load at which the pressure is uniform along y [N], and contact modulus
        [Pa].
    tilt : float, optional
        Rotation of the roller about x [rad]: a positive tilt brings the end at y > 0 closer to the
        race.
    skew : float, optional
        Rotation of the roller about z, from x towards y [rad].

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap [m], 0 at the middle of the roller and infinite beyond its end faces.

    Raises
    ------
    ValueError
        An argument is outside its range, is missing, or does not belong to the profile.

    Notes
    -----
    With u = 2 y/L and the length L, the drop of the profile is

    - straight: 0; the pressure is singular at the ends (`SingularPressureWarning`);
    - crowned: (abs(y) - s/2)^2/(2 R_c) beyond the straight length s, with the crown radius R_c;
    - logarithmic (ISO/TS 16281): 0.00035 D ln(1/(1 - u^2)) with the diameter D; for L > 2.5 D, 0 in
      the middle and 0.0005 D ln(1/(1 - v^2)), v = (2 abs(y) - L + 2.5 D)/(2.5 D), at the ends;
    - lundberg: Q/(pi E* L) ln(1/(1 - u^2)) with the design load Q (Lundberg 1939).

    The last two profiles have an infinite drop at the ends, so that the pressure is bounded. Cells
    near the ends must be smaller than the distance between the end of the contact and the end of
    the roller. The roller is parabolic along x, as in Hertz theory.
    """
    across, along = coordinates(grid)
    R, L = positive("radius", radius), positive("length", length)
    optional = {
        "crown_radius": crown_radius, "straight_length": straight_length, "diameter": diameter,
        "design_load": design_load, "E_star": E_star,
    }  # fmt: skip
    race = finite("race_radius", race_radius) if race_radius != math.inf else math.inf
    if race == 0.0 or (race < 0.0 and -race <= R):
        raise ValueError(
            "race_radius must be > 0 (convex), inf (flat), or negative (concave) and larger than "
            f"the radius {R!r} m of the roller, got {race!r}"
        )
    angles = {"tilt": finite("tilt", tilt), "skew": finite("skew", skew)}
    for name, angle in angles.items():
        if abs(angle) > MAX_ANGLE:
            raise ValueError(
                f"{name} must be between {-MAX_ANGLE} and {MAX_ANGLE} rad, got {angle!r}"
            )
    c, s = math.cos(angles["skew"]), math.sin(angles["skew"])
    x, y = c * across + s * along, c * along - s * across
    y = np.where(np.abs(y) <= 0.5 * L * (1.0 + 1e-12), np.clip(y, -0.5 * L, 0.5 * L), np.nan)
    drop = _drop(profile, y, R, L, optional)
    gap = x**2 / (2.0 * R) + across**2 / (2.0 * race) + drop - angles["tilt"] * y
    if not np.isfinite(gap).any():
        raise ValueError(
            f"length must be larger than a cell of the grid, got {length!r}: no cell centre lies "
            "between the end faces"
        )
    return np.where(np.isfinite(gap), gap, np.inf)


def _drop(
    profile: str | tuple[ArrayLike, ArrayLike],
    y: FloatArray,
    radius: float,
    length: float,
    optional: dict[str, float | None],
) -> FloatArray:
    """Drop of the profile [m] at the positions y [m], NaN beyond the end faces."""
    kind = profile if isinstance(profile, str) else "table"
    if kind != "table":
        choice("profile", kind, PROFILES)
    for name, value in optional.items():
        if value is not None and _USERS[name] != kind:
            raise ValueError(
                f'{name} belongs to profile = "{_USERS[name]}", got {value!r} with profile = '
                f"{in_short(profile)}: omit it"
            )
    for name in _REQUIRED.get(kind, ()):
        if optional[name] is None:
            raise ValueError(f'{name} is required with profile = "{kind}": a number > 0')
    if kind == "table":
        return _tabulated(profile, y, length)
    if kind == "crowned":
        return _crowned(y, length, optional["crown_radius"], optional["straight_length"])
    if kind == "lundberg":
        load, modulus = optional["design_load"], optional["E_star"]
        factor = positive("design_load", load) / (math.pi * positive("E_star", modulus) * length)
        return factor * _logarithm(2.0 * y / length)
    if kind == "logarithmic":
        given = optional["diameter"]
        return iso_drop(y, length, 2.0 * radius if given is None else positive("diameter", given))
    return 0.0 * y


def _logarithm(u: FloatArray) -> FloatArray:
    """ln(1/(1 - u^2)), infinite at abs(u) = 1."""
    with np.errstate(divide="ignore"):
        return np.asarray(-np.log1p(-np.minimum(u**2, 1.0)), dtype=np.float64)


def iso_drop(y: FloatArray, length: float, diameter: float) -> FloatArray:
    """Logarithmic drop [m] of ISO/TS 16281 at positions y [m] of a roller."""
    ends = LONG_RATIO * diameter
    if length <= ends:
        return SHORT_FACTOR * diameter * _logarithm(2.0 * y / length)
    v = np.maximum(2.0 * np.abs(y) - (length - ends), 0.0) / ends
    return LONG_FACTOR * diameter * _logarithm(v)


def _crowned(
    y: FloatArray, length: float, crown_radius: float | None, straight: float | None
) -> FloatArray:
    """Drop [m] of a crowned profile: one arc, or an arc on either side of a straight middle."""
    crown = positive("crown_radius", crown_radius)
    middle = 0.0 if straight is None else non_negative("straight_length", straight)
    if middle > length:
        raise ValueError(f"straight_length must be <= length = {length!r} m, got {middle!r}")
    return np.asarray(np.maximum(np.abs(y) - 0.5 * middle, 0.0) ** 2 / (2.0 * crown))


def _tabulated(profile: object, y: FloatArray, length: float) -> FloatArray:
    """Drop [m] interpolated between the points of a table (monotone cubic: PCHIP)."""
    if not (isinstance(profile, (tuple, list)) and len(profile) == 2):
        raise ValueError(
            f"profile must be one of {', '.join(PROFILES)}, or a table (y, drop), got "
            f"{in_short(profile)}"
        )
    at = finite_array("profile y", profile[0])
    drop = finite_array("profile drop", profile[1], at.shape)
    if at.ndim != 1 or at.size < 2 or not (np.diff(at) > 0.0).all():
        raise ValueError(
            f"profile must have at least 2 positions y that increase, got {in_short(profile[0])}"
        )
    symmetric = at[0] >= 0.0
    first, last = (0.0 if symmetric else -0.5 * length), 0.5 * length
    if at[0] > first + 1e-9 * length or at[-1] < last - 1e-9 * length:
        raise ValueError(
            f"profile must cover y from {first!r} to {last!r} m, got {float(at[0])!r} to "
            f"{float(at[-1])!r}: extend the table, or use the unit m"
        )
    position = np.clip(np.abs(y) if symmetric else y, at[0], at[-1])
    interpolant = scipy.interpolate.PchipInterpolator(at, drop)
    return np.asarray(interpolant(position), dtype=np.float64)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz point contact: size, pressure, gap, approach and stress."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, exactly_one, non_negative, poisson_ratio, positive, together
from .._util.display import HtmlTable
from .axis import point_axis, point_max_von_mises
from .field import field
from .points import depth_ratio, require_range, semi_ellipsoid


@dataclass(frozen=True)
class PointContact(HtmlTable):
    """Hertz contact of a sphere and a half-space (Johnson 1985, section 4.2).

    Attributes
    ----------
    R : float
        Equivalent radius, 1/R = 1/R1 + 1/R2 [m].
    E_star : float
        Contact modulus [Pa].
    load : float
        Normal load [N].
    a : float
        Contact radius [m].
    p0 : float
        Maximum pressure [Pa].
    approach : float
        Rigid-body approach [m].
    """

    R: float
    E_star: float
    load: float
    a: float
    p0: float
    approach: float

    def pressure(self, x: ArrayLike, y: ArrayLike = 0.0) -> FloatArray:
        """Pressure [Pa] at x, y [m] (broadcast), zero outside the contact; Johnson (4.24)."""
        across, along = together(x=x, y=y)
        return semi_ellipsoid(self.p0, across / self.a, along / self.a)

    def gap(self, x: ArrayLike, y: ArrayLike = 0.0) -> FloatArray:
        """Gap under load [m] at x, y [m] (broadcast), zero inside the contact; Johnson (3.42)."""
        r = np.maximum(np.hypot(*together(x=x, y=y)) / self.a, 1.0)
        # approach - displacement - r^2/2R, all lengths in contact radii
        outside = (2.0 - r**2) * np.arcsin(1.0 / r) + np.sqrt(r**2 - 1.0)
        scale = self.a**2 / self.R
        return np.asarray(scale * (0.5 * r**2 - 1.0 + outside / math.pi), dtype=np.float64)

    def axis_stress(self, z: ArrayLike, nu: float) -> tuple[FloatArray, FloatArray]:
        """Elastic stresses on the axis below the centre; Johnson (3.45).

        Parameters
        ----------
        z : array_like
            Depths [m], >= 0.
        nu : float
            Poisson's ratio of the loaded body, in [0, 0.5].

        Returns
        -------
        sigma_rr, sigma_zz : ndarray
            Radial stress, which equals the circumferential stress, and axial stress [Pa], in the
            shape of `z`.
        """
        s = depth_ratio(z, self.a)
        radial, axial = point_axis(s, poisson_ratio("nu", nu))
        return self.p0 * radial, self.p0 * axial

    def stress(
        self, x: ArrayLike, y: ArrayLike, z: ArrayLike, nu: float, friction: float = 0.0
    ) -> FloatArray:
        """Elastic stress at any point of a half-space under the Hertz pressure, at rest or sliding.

        Parameters
        ----------
        x, y, z : array_like
            Points [m], broadcast; z is the depth, >= 0.
        nu : float
            Poisson's ratio of the loaded body, in [0, 0.5].
        friction : float, optional
            Coefficient of friction mu [-], >= 0: the shear traction mu p acts on the body along +x.

        Returns
        -------
        ndarray, shape (6, ...)
            Stress components xx, yy, zz, yz, xz, xy [Pa], positive in tension; at z = 0, the limit
            from inside the body.

        Raises
        ------
        ValueError
            An argument is outside its range.

        Notes
        -----
        The closed form is derived from the potentials of Boussinesq and Cerruti (Johnson 1985,
        section 3.2) and is equivalent to the solution of Hamilton (1983),
        doi:10.1243/PIME_PROC_1983_197_076_02. Rounding errors are about 1e-15 p0 near the contact,
        and r/a times larger at a distance r. The effect of shear on the normal displacement is
        neglected; it is zero for identical materials.
        """
        across, along, depth = together(x=x, y=y, z=z)
        points = across / self.a, along / self.a, depth_ratio(depth, self.a)
        nu, friction = poisson_ratio("nu", nu), non_negative("friction", friction)
        return self.p0 * field(points[0], points[1], points[2], nu, friction)

    def max_von_mises(self, nu: float) -> tuple[float, float]:
        """Maximum von Mises stress on the axis [Pa] and its depth [m]."""
        ratio, depth = point_max_von_mises(nu)
        return ratio * self.p0, depth * self.a


def point(
    R: float,
    E_star: float,
    load: float | None = None,
    approach: float | None = None,
    p0: float | None = None,
) -> PointContact:
    """Hertz point contact for a given load, approach or maximum pressure.

    Parameters
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus [Pa], see `effective_modulus`.
    load, approach, p0 : float, optional
        Normal load [N], rigid-body approach [m] or maximum pressure [Pa]. Exactly one is required.

    Returns
    -------
    PointContact
        Contact after Johnson (1985), equations (4.22) to (4.24).

    Raises
    ------
    ValueError
        An argument is not finite and positive; load, approach and p0 are all missing, or several
        are given; or the contact dimensions overflow.
    """
    R, E_star = positive("R", R), positive("E_star", E_star)
    given = exactly_one(load=load, approach=approach, p0=p0)
    if given == "load":
        a = (0.75 * positive("load", load) * R / E_star) ** (1.0 / 3.0)
    elif given == "approach":
        a = math.sqrt(R * positive("approach", approach))
    else:
        a = 0.5 * math.pi * R * positive("p0", p0) / E_star
    sizes = {
        # not a**3, which raises OverflowError where a product is infinite
        "load": 4.0 * E_star * a * a * a / (3.0 * R) if load is None else float(load),
        "a": a,
        "p0": 2.0 * E_star * a / (math.pi * R) if p0 is None else float(p0),
        "approach": a * a / R if approach is None else float(approach),
    }
    require_range(given, **sizes)
    return PointContact(R=R, E_star=E_star, **sizes)

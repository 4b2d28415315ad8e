# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz line contact: size, pressure and stress."""

from __future__ import annotations

import math
from dataclasses import dataclass

from numpy.typing import ArrayLike

from .._util.checks import FloatArray, exactly_one, non_negative, poisson_ratio, positive, together
from .._util.display import HtmlTable
from .axis import line_axis, line_max_von_mises
from .plane_field import plane_field
from .points import coordinates, depth_ratio, require_range, semi_ellipsoid


@dataclass(frozen=True)
class LineContact(HtmlTable):
    """Hertz contact of a cylinder along y and a half-space (Johnson 1985, section 4.2(c)).

    The bodies are in plane strain.

    Attributes
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus [Pa].
    load_per_length : float
        Normal load per unit length [N/m].
    b : float
        Half-width of the contact [m].
    p0 : float
        Maximum pressure [Pa].
    """

    R: float
    E_star: float
    load_per_length: float
    b: float
    p0: float

    def pressure(self, x: ArrayLike) -> FloatArray:
        """Pressure [Pa] at x [m], zero outside the contact; Johnson (4.44)."""
        return semi_ellipsoid(self.p0, coordinates(x=x)[0] / self.b)

    def axis_stress(self, z: ArrayLike, nu: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Elastic stresses sigma_xx, sigma_yy, sigma_zz [Pa] on the axis; Johnson (4.46).

        z: depths [m], >= 0. nu: Poisson's ratio of the loaded body.
        """
        s = depth_ratio(z, self.b)
        sxx, syy, szz = line_axis(s, poisson_ratio("nu", nu))
        return self.p0 * sxx, self.p0 * syy, self.p0 * szz

    def stress(self, x: ArrayLike, z: ArrayLike, nu: float, friction: float = 0.0) -> FloatArray:
        """Elastic stress at any point of a half-space under the Hertz pressure, at rest or sliding.

        Parameters
        ----------
        x, z : array_like
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
        The closed form is derived from the complex potential of the pressure (Johnson 1985, section
        2.5; Muskhelishvili 1953) and is equivalent to the solution of McEwen (1949). The effect of
        shear on the normal displacement is neglected; it is zero for identical materials.
        """
        across, depth = together(x=x, z=z)
        points = across / self.b, depth_ratio(depth, self.b)
        nu, friction = poisson_ratio("nu", nu), non_negative("friction", friction)
        return self.p0 * plane_field(points[0], points[1], nu, friction)

    def max_von_mises(self, nu: float) -> tuple[float, float]:
        """Maximum von Mises stress on the axis [Pa] and its depth [m]."""
        ratio, depth = line_max_von_mises(nu)
        return ratio * self.p0, depth * self.b


def line(
    R: float,
    E_star: float,
    load_per_length: float | None = None,
    p0: float | None = None,
) -> LineContact:
    """Hertz line contact for a given load per unit length or maximum pressure.

    The approach is not available, because in a line contact it depends on the choice of datum.

    Parameters
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus [Pa].
    load_per_length, p0 : float, optional
        Load per unit length [N/m] or maximum pressure [Pa]. Exactly one must be given.

    Returns
    -------
    LineContact
        Contact after Johnson (1985), equations (4.43) to (4.45).

    Raises
    ------
    ValueError
        An argument is not finite and positive, load_per_length and p0 are both missing or both
        given, or the contact dimensions overflow.
    """
    R, E_star = positive("R", R), positive("E_star", E_star)
    given = exactly_one(load_per_length=load_per_length, p0=p0)
    if given == "load_per_length":
        b = math.sqrt(4.0 * positive("load_per_length", load_per_length) * R / (math.pi * E_star))
    else:
        b = 2.0 * R * positive("p0", p0) / E_star
    sizes = {
        "load_per_length": (
            math.pi * E_star * b * b / (4.0 * R)
            if load_per_length is None
            else float(load_per_length)
        ),
        "b": b,
        "p0": E_star * b / (2.0 * R) if p0 is None else float(p0),
    }
    require_range(given, **sizes)
    return LineContact(R=R, E_star=E_star, **sizes)

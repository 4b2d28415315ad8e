# SPDX-License-Identifier: GPL-3.0-or-later
"""Critical values of a contact: onset of yield in an elastic-plastic body.

I. Green, *Poisson ratio effects and critical values in spherical and cylindrical Hertzian
contacts*, Int. J. Appl. Mech. Eng. 10 (2005) 451-462. C is always the maximum Hertz pressure p0 at
the onset of yield divided by the yield stress.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass

from .._util.checks import non_negative, poisson_ratio, positive, require_type
from .._util.display import HtmlTable
from ..bodies.material import Material
from ..hertz.axis import line_max_von_mises, point_max_von_mises
from ..hertz.field import sliding_max_von_mises
from .first_yield import first_yield

__all__ = [
    "CriticalCylinder",
    "CriticalCylinderOverDepth",
    "CriticalSlidingSphere",
    "CriticalSphere",
    "CriticalSphereOverDepth",
    "green",
    "green_cylinder",
    "jackson_green",
    "kogut_etsion",
    "onset",
    "onset_cylinder",
    "onset_cylinder_over_depth",
    "onset_over_depth",
    "onset_sliding",
]


@dataclass(frozen=True)
class CriticalSphere(HtmlTable):
    """Onset of yield in a point contact.

    Attributes
    ----------
    interference : float
        Rigid-body approach at the onset [m].
    load : float
        Normal load [N].
    energy : float
        Elastic energy stored at the onset [J], the integral of load over interference.
    C : float
        Maximum pressure divided by yield stress [-].
    p0 : float
        Maximum pressure [Pa].
    a : float
        Contact radius [m].
    """

    interference: float
    load: float
    energy: float
    C: float
    p0: float
    a: float


@dataclass(frozen=True)
class CriticalSlidingSphere(CriticalSphere):
    """Onset of yield in a sliding point contact; `energy` is the work of the normal load.

    Attributes
    ----------
    x, z : float
        Position of first yield in the plane y = 0 [m]; z = 0 is the surface.
    """

    x: float
    z: float


@dataclass(frozen=True)
class CriticalSphereOverDepth(CriticalSphere):
    """Onset of yield in a point contact of a body with depth-dependent yield or initial stress.

    Attributes
    ----------
    x, y, z : float
        Position of first yield [m]; z = 0 is the surface. Only one of several equivalent positions
        is returned.
    """

    x: float
    y: float
    z: float


@dataclass(frozen=True)
class CriticalCylinder(HtmlTable):
    """Onset of yield in a line contact.

    Attributes
    ----------
    load_per_length : float
        Normal load per unit length [N/m].
    C : float
        Maximum pressure divided by yield stress [-].
    p0 : float
        Maximum pressure [Pa].
    b : float
        Half-width of the contact [m].
    """

    load_per_length: float
    C: float
    p0: float
    b: float


@dataclass(frozen=True)
class CriticalCylinderOverDepth(CriticalCylinder):
    """Onset of yield in a line contact of a body with depth-dependent yield or initial stress.

    Attributes
    ----------
    x, z : float
        Position of first yield [m], x from the centre of the contact; z = 0 is the surface.
    """

    x: float
    z: float


def _require_numbers(R: float, E_star: float, yield_stress: float, C: float = 1.0) -> None:
    """Raise ValueError if the critical load or energy would overflow."""
    p0 = C * yield_stress
    powers = [5 * math.log10(p0), 3 * math.log10(R), -4 * math.log10(E_star)]
    if not all(abs(sum(powers[: n + 1])) < 300 for n in range(3)):
        raise ValueError(
            "R, E_star and yield_stress must give finite critical values, got "
            f"R = {R!r}, E_star = {E_star!r}, yield_stress = {yield_stress!r}"
        )


def _sphere(R: float, E_star: float, C: float, yield_stress: float) -> CriticalSphere:
    R, E_star = positive("R", R), positive("E_star", E_star)
    yield_stress = positive("yield_stress", yield_stress)
    p0 = C * yield_stress
    strength = math.pi * p0
    _require_numbers(R, E_star, yield_stress, C)
    return CriticalSphere(
        interference=(strength / (2.0 * E_star)) ** 2 * R,
        load=strength**3 * R**2 / (6.0 * E_star**2),
        energy=strength**5 * R**3 / (60.0 * E_star**4),
        C=C,
        p0=p0,
        a=strength * R / (2.0 * E_star),
    )


def _cylinder(R: float, E_star: float, C: float, yield_stress: float) -> CriticalCylinder:
    R, E_star = positive("R", R), positive("E_star", E_star)
    yield_stress = positive("yield_stress", yield_stress)
    p0 = C * yield_stress
    _require_numbers(R, E_star, yield_stress, C)
    return CriticalCylinder(
        load_per_length=math.pi * R * p0**2 / E_star, C=C, p0=p0, b=2.0 * p0 * R / E_star
    )


def green(R: float, E_star: float, nu: float, yield_stress: float) -> CriticalSphere:
    """Green's critical values of a sphere: C = p0/Y = 1.30075 + 0.87825 nu + 0.54373 nu^2.

    Parameters
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus of the pair [Pa].
    nu : float
        Poisson's ratio of the yielding body, in [0, 0.5] [-].
    yield_stress : float
        Uniaxial yield stress of the yielding body [Pa].

    Returns
    -------
    CriticalSphere
        Values by Green (2005), with the yield stress Y; C is within 0.4 % of C from `onset`.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    nu = poisson_ratio("nu", nu)
    return _sphere(R, E_star, 1.30075 + 0.87825 * nu + 0.54373 * nu**2, yield_stress)


def onset(R: float, E_star: float, nu: float, yield_stress: float) -> CriticalSphere:
    """Critical values of a sphere, with C = p0/yield stress from the exact von Mises stress.

    Parameters and errors as for `green`.

    Returns
    -------
    CriticalSphere
        Values with 1/C = max((sigma_rr - sigma_zz)/p0) on the axis, Johnson (1985), (3.45).
    """
    return _sphere(R, E_star, 1.0 / point_max_von_mises(nu)[0], yield_stress)


def onset_sliding(
    R: float, E_star: float, nu: float, yield_stress: float, friction: float
) -> CriticalSlidingSphere:
    """Exact critical values of a sphere in full sliding with Coulomb friction.

    Parameters
    ----------
    R, E_star, nu, yield_stress : float
        As for `green`.
    friction : float
        Friction coefficient mu >= 0 [-]; the shear mu p acts on the yielding body along +x.

    Returns
    -------
    CriticalSlidingSphere
        Critical values from the maximum von Mises stress in the half-space, including the surface,
        under a Hertz pressure p and a shear mu p (`hertz.PointContact.stress`). With nu = 0.3, the
        body first yields below the surface and ahead of the centre if mu <= 0.304, and at the
        trailing edge of the contact for higher friction.

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    For mu = 0, the result equals `onset`. The effect of shear on the normal displacement is
    neglected (it is zero for identical materials).
    """
    nu, friction = poisson_ratio("nu", nu), non_negative("friction", friction)
    if friction == 0.0:
        ratio, z = point_max_von_mises(nu)
        x = 0.0
    else:
        ratio, x, z = sliding_max_von_mises(nu, friction)
    sphere = _sphere(R, E_star, 1.0 / ratio, yield_stress)
    return CriticalSlidingSphere(**asdict(sphere), x=x * sphere.a, z=z * sphere.a)


def onset_over_depth(
    R: float, E_star: float, body: Material, friction: float = 0.0
) -> CriticalSphereOverDepth:
    """Critical values of a sphere on a body with a yield profile or residual stress.

    Parameters
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus of the pair [Pa].
    body : Material
        Body that yields. E_star must include the elastic constants of this body.
    friction : float, optional
        Friction coefficient mu >= 0 [-]; the shear acts along +x, as in `onset_sliding`.

    Returns
    -------
    CriticalSphereOverDepth
        Values at the smallest load for which the von Mises stress, including residual stress,
        reaches the local yield stress anywhere within 1.3 contact radii of the axis and down to a
        depth of 12 contact radii. The stress is the closed form of Hamilton (1983),
        doi:10.1243/PIME_PROC_1983_197_076_02; the search for this load has a relative error of
        about 1e-5. C is the maximum pressure divided by the yield stress of the hardening law; the
        factors of the yield profile are not included in this yield stress.

    Raises
    ------
    ValueError
        An argument is outside its range; the body cannot yield, or its residual stress already
        reaches yield.
    TypeError
        `body` is not a Material.
    """
    yield_stress = _yield_stress_of(body)
    R, E_star = positive("R", R), positive("E_star", E_star)
    friction = non_negative("friction", friction)
    _require_numbers(R, E_star, yield_stress)
    p0, place = first_yield(body, math.pi * R / (2.0 * E_star), friction)
    x, y, z = map(float, place)
    sphere = _sphere(R, E_star, p0 / yield_stress, yield_stress)
    return CriticalSphereOverDepth(**asdict(sphere), x=x, y=y, z=z)


def kogut_etsion(
    R: float,
    E_star: float,
    nu: float,
    yield_stress: float,
    hardness: float | None = None,
) -> CriticalSphere:
    """Critical values of Kogut and Etsion for a sphere: interference (pi K H / (2 E*))^2 R.

    Parameters
    ----------
    R, E_star, nu, yield_stress : float
        As for `green`.
    hardness : float, optional
        Hardness H of the softer body [Pa]. Default: 2.8 times the yield stress.

    Returns
    -------
    CriticalSphere
        Critical values with K = 0.454 + 0.41 nu; load and energy follow from Hertz theory at this
        interference. Kogut and Etsion (2002), doi:10.1115/1.1490373.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    yield_stress = positive("yield_stress", yield_stress)
    H = 2.8 * yield_stress if hardness is None else positive("hardness", hardness)
    C = (0.454 + 0.41 * poisson_ratio("nu", nu)) * H / yield_stress
    return _sphere(R, E_star, C, yield_stress)


def jackson_green(R: float, E_star: float, nu: float, yield_stress: float) -> CriticalSphere:
    """Critical values of Jackson and Green for a sphere, C = p0/yield stress = 1.295 exp(0.736 nu).

    Parameters and errors as for `green`.

    Returns
    -------
    CriticalSphere
        Critical values by Jackson and Green (2005), doi:10.1115/1.1866166; C is within 0.4 % of the
        exact C from `onset`.
    """
    return _sphere(R, E_star, 1.295 * math.exp(0.736 * poisson_ratio("nu", nu)), yield_stress)


def green_cylinder(R: float, E_star: float, nu: float, yield_stress: float) -> CriticalCylinder:
    """Green's critical values of a cylinder in plane strain.

    Parameters and errors as for `green`.

    Returns
    -------
    CriticalCylinder
        C = p0/yield stress = 1/sqrt(1 + 4 (nu - 1) nu) if the surface yields first (nu <= 0.1938),
        else 1.164 + 2.975 nu - 2.906 nu^2, within 0.12 % of `onset_cylinder`. Green (2005).
    """
    nu = poisson_ratio("nu", nu)
    if nu <= 0.1938:
        C = 1.0 / math.sqrt(1.0 + 4.0 * (nu - 1.0) * nu)
    else:
        C = 1.164 + 2.975 * nu - 2.906 * nu**2
    return _cylinder(R, E_star, C, yield_stress)


def onset_cylinder(R: float, E_star: float, nu: float, yield_stress: float) -> CriticalCylinder:
    """Critical values of a cylinder with exact C (Johnson 1985, (4.46)); arguments: see `green`."""
    return _cylinder(R, E_star, 1.0 / line_max_von_mises(nu)[0], yield_stress)


def onset_cylinder_over_depth(R: float, E_star: float, body: Material) -> CriticalCylinderOverDepth:
    """Critical values of a cylinder on a body with a yield profile or residual stress.

    Parameters
    ----------
    R, E_star, body
        As for `onset_over_depth`; the cylinder lies along y, in plane strain, without friction.

    Returns
    -------
    CriticalCylinderOverDepth
        Values at the smallest load for which the von Mises stress, including residual stress,
        reaches the local yield stress within 1.3 half-widths of the centre and down to a depth of
        12 half-widths. The stress is McEwen's closed form (Johnson 1985, (4.49)); the search for
        this load has a relative error of about 1e-5. C is defined as for `onset_over_depth`: with
        the yield stress of the hardening law, without the factors of the yield profile.

    Raises
    ------
    ValueError, TypeError
        As for `onset_over_depth`.
    """
    yield_stress = _yield_stress_of(body)
    R, E_star = positive("R", R), positive("E_star", E_star)
    _require_numbers(R, E_star, yield_stress)
    p0, place = first_yield(body, 2.0 * R / E_star, None)
    cylinder = _cylinder(R, E_star, p0 / yield_stress, yield_stress)
    return CriticalCylinderOverDepth(**asdict(cylinder), x=float(place[0]), z=float(place[2]))


def _yield_stress_of(body: Material) -> float:
    require_type("body", body, Material)
    if not body.is_plastic:
        raise ValueError(f"body must be elastic-plastic, got law {body.law!r}")
    return float(body.yield_stress(0.0))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence coefficients of one rectangle or cuboid, in closed form.

X, Y [m] are the coordinates of the field point relative to the centre of the source; a, b, c are
HALF sizes; z points into the body. Arrays broadcast. Components: xx, yy, zz, yz, xz, xy, tensor
(not engineering) shear strains.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._util.checks import FloatArray, axis_number, choice, number, positive, together

__all__ = [
    "eigenstrain_displacement",
    "eigenstrain_stress",
    "pressure_displacement",
    "pressure_stress",
    "shear_displacement",
    "shear_stress",
]

_PRESSURE = 2  # tractions are numbered by the axis along which they act


def _shear(along: str) -> int:
    return ("x", "y").index(choice("along", along, ("x", "y")))


def _points(*coordinates: ArrayLike) -> tuple[list[FloatArray], tuple[int, ...]]:
    arrays = together(**dict(zip("XYz", coordinates, strict=False)))
    return [np.ascontiguousarray(array).ravel() for array in arrays], arrays[0].shape


def _sizes(**sizes: float) -> list[float]:
    return [positive(name, value) for name, value in sizes.items()]


def _constants(E: float, nu: float) -> tuple[float, float]:
    elastic = _core.Elastic.isotropic(number("E", E), number("nu", nu))
    return elastic.E, elastic.nu


def _depths(z: FloatArray) -> FloatArray:
    if (z < 0).any():
        raise ValueError(f"z must be >= 0 [m], got {z.min()!r}")
    return z


def _displacement(
    traction: int, axis: str, X: ArrayLike, Y: ArrayLike, a: float, b: float, E: float, nu: float
) -> FloatArray:
    (x, y), shape = _points(X, Y)
    a, b = _sizes(a=a, b=b)
    number = axis_number(axis)
    values = _core.kernels.traction_displacement(traction, number, x, y, a, b, *_constants(E, nu))
    return values.reshape(shape)


def pressure_displacement(
    X: ArrayLike, Y: ArrayLike, a: float, b: float, E: float, nu: float, *, axis: str = "z"
) -> FloatArray:
    """Return the surface displacement [m] per unit pressure on a rectangle; shape of X.

    `axis` is the direction of the displacement: "z", positive into the body (Love 1929), or "x" or
    "y" (integral of Boussinesq's solution for a point force; Johnson 1985, section 3.2). In the
    plane of the surface, points are displaced towards the rectangle.
    """
    return _displacement(_PRESSURE, axis, X, Y, a, b, E, nu)


def shear_displacement(
    X: ArrayLike,
    Y: ArrayLike,
    a: float,
    b: float,
    E: float,
    nu: float,
    *,
    along: str = "x",
    axis: str = "z",
) -> FloatArray:
    """Return the surface displacement [m] per unit shear traction on a rectangle; shape of X.

    The shear acts on the body along +x or +y, given by `along`; the displacement is along
    `axis`: "x", "y" or "z". Cerruti (1882); Johnson (1985), section 3.6, integrated.
    """
    return _displacement(_shear(along), axis, X, Y, a, b, E, nu)


def _stress(
    traction: int, X: ArrayLike, Y: ArrayLike, z: ArrayLike, a: float, b: float, nu: float
) -> FloatArray:
    nu = _constants(1.0, nu)[1]
    (x, y, depth), shape = _points(X, Y, z)
    a, b = _sizes(a=a, b=b)
    values = _core.kernels.traction_stress(traction, x, y, _depths(depth), a, b, nu)
    return values.reshape(6, *shape)


def pressure_stress(
    X: ArrayLike, Y: ArrayLike, z: ArrayLike, a: float, b: float, nu: float
) -> FloatArray:
    """Return the stress [-] per unit pressure, shape (6, ...). Boucly (2008), eqs (2.81)-(2.86)."""
    return _stress(_PRESSURE, X, Y, z, a, b, nu)


def shear_stress(
    X: ArrayLike,
    Y: ArrayLike,
    z: ArrayLike,
    a: float,
    b: float,
    nu: float,
    *,
    along: str = "x",
) -> FloatArray:
    """Return the stress [-] per unit shear traction on a rectangle, shape (6, ...).

    The traction acts `along` +x or +y. Boucly (2008), eqs (2.88)-(2.93), with L_22 corrected.
    """
    return _stress(_shear(along), X, Y, z, a, b, nu)


def eigenstrain_displacement(
    X: ArrayLike,
    Y: ArrayLike,
    zc: float,
    a: float,
    b: float,
    c: float,
    nu: float,
    *,
    axis: str = "z",
) -> FloatArray:
    """Return the surface displacement [m] per unit eigenstrain of a cuboid, shape (6, ...).

    The displacement is along `axis`: "x", "y" or "z", with z into the body. zc is the depth of the
    centre of the cuboid. For a unit shear component, e.g. xy, the component yx is also 1.
    Raises ValueError if the cuboid extends beyond the half-space. u_z follows from Boucly (2008),
    eqs (2.64)-(2.71), corrected, with an added term for the trace of the eigenstrain; u_x and u_y
    follow by reciprocity, see docs/theory/half_space.md.
    """
    number = axis_number(axis)
    (x, y), shape = _points(X, Y)
    a, b, c = _sizes(a=a, b=b, c=c)
    nu = _constants(1.0, nu)[1]
    values = _core.kernels.eigenstrain_displacement(number, x, y, _centre_depth(zc, c), a, b, c, nu)
    return values.reshape(6, *shape)


def eigenstrain_stress(
    X: ArrayLike,
    Y: ArrayLike,
    z: ArrayLike,
    zc: float,
    a: float,
    b: float,
    c: float,
    E: float,
    nu: float,
) -> FloatArray:
    """Return the stress [Pa] per unit eigenstrain of a cuboid, shape (6, 6, ...).

    The first index is the stress component, the second index is the eigenstrain component.
    Inside the cuboid, the stress follows from the elastic strain: total strain minus eigenstrain.
    Mindlin's half-space solution is integrated in closed form, see docs/theory/half_space.md.
    """
    (x, y, depth), shape = _points(X, Y, z)
    a, b, c = _sizes(a=a, b=b, c=c)
    values: FloatArray = _core.kernels.eigenstrain_stress(
        x, y, _depths(depth), _centre_depth(zc, c), a, b, c, *_constants(E, nu)
    )
    return values.reshape(6, 6, *shape)


def _centre_depth(zc: float, c: float) -> float:
    depth = positive("zc", zc)
    if depth < c * (1 - 1e-12):
        raise ValueError(f"zc must be >= c = {c!r} [m] (the cuboid is inside the body), got {zc!r}")
    return depth

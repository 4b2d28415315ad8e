# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence coefficients of one rectangle or cuboid, in closed form.

X, Y are field point minus centre of the source; a, b, c are HALF sizes; z is into the body. Arrays
broadcast. Components: xx, yy, zz, yz, xz, xy, tensor (not engineering) shear strains.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._checks import FloatArray, positive, real_array


def _points(*coordinates: ArrayLike) -> tuple[list[FloatArray], tuple[int, ...]]:
    named = zip("XYz", coordinates, strict=False)
    arrays = np.broadcast_arrays(*(real_array(name, given) for name, given in named))
    for name, array in zip("XYz", arrays, strict=False):
        if not np.isfinite(array).all():
            raise ValueError(f"{name} must be finite everywhere")
    return [np.ascontiguousarray(array).ravel() for array in arrays], arrays[0].shape


def _sizes(**sizes: float) -> list[float]:
    return [positive(name, value) for name, value in sizes.items()]


def _constants(E: float, nu: float) -> tuple[float, float]:
    elastic = _core.Elastic.isotropic(E, nu)
    return elastic.E, elastic.nu


def _depths(z: FloatArray) -> FloatArray:
    if (z < 0).any():
        raise ValueError(f"z must be >= 0 [m], got {z.min()!r}")
    return z


def pressure_displacement(
    X: ArrayLike, Y: ArrayLike, a: float, b: float, E: float, nu: float
) -> FloatArray:
    """u_z [m] per unit pressure [Pa] on a rectangle (Love 1929); shape of X."""
    (x, y), shape = _points(X, Y)
    a, b = _sizes(a=a, b=b)
    E, nu = _constants(E, nu)
    return _core.kernels.pressure_displacement(x, y, a, b, E, nu).reshape(shape)


def shear_displacement(
    X: ArrayLike, Y: ArrayLike, a: float, b: float, E: float, nu: float
) -> FloatArray:
    """u_z [m] per unit shear s_x [Pa] acting on a rectangle in +x (Cerruti 1882); shape of X."""
    (x, y), shape = _points(X, Y)
    a, b = _sizes(a=a, b=b)
    E, nu = _constants(E, nu)
    return _core.kernels.shear_displacement(x, y, a, b, E, nu).reshape(shape)


def _stress(function: Any, X: ArrayLike, Y: ArrayLike, z: ArrayLike, *rest: float) -> FloatArray:
    (x, y, depth), shape = _points(X, Y, z)
    values: FloatArray = function(x, y, _depths(depth), *rest)
    return values.reshape(6, *shape)


def pressure_stress(
    X: ArrayLike, Y: ArrayLike, z: ArrayLike, a: float, b: float, nu: float
) -> FloatArray:
    """Stress [-] per unit pressure on a rectangle, shape (6, ...). Boucly (2008), (2.81)-(2.86)."""
    nu = _constants(1.0, nu)[1]
    return _stress(_core.kernels.pressure_stress, X, Y, z, *_sizes(a=a, b=b), nu)


def shear_stress(
    X: ArrayLike, Y: ArrayLike, z: ArrayLike, a: float, b: float, nu: float
) -> FloatArray:
    """Stress [-] per unit shear s_x on a rectangle, shape (6, ...).

    Boucly (2008), eqs (2.88)-(2.93), with L_22 corrected.
    """
    nu = _constants(1.0, nu)[1]
    return _stress(_core.kernels.shear_stress, X, Y, z, *_sizes(a=a, b=b), nu)


def eigenstrain_displacement(
    X: ArrayLike, Y: ArrayLike, zc: float, a: float, b: float, c: float, nu: float
) -> FloatArray:
    """Surface u_z [m] per unit eigenstrain component of a cuboid at depth zc, shape (6, ...).

    A shear component counts once (with its transpose). Raises ValueError when the cuboid sticks out
    of the half-space. Boucly (2008), eqs (2.64)-(2.71), corrected, with the term of the trace.
    """
    (x, y), shape = _points(X, Y)
    a, b, c = _sizes(a=a, b=b, c=c)
    nu = _constants(1.0, nu)[1]
    values: FloatArray = _core.kernels.eigenstrain_displacement(
        x, y, _centre_depth(zc, c), a, b, c, nu
    )
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
    """Stress [Pa] per unit eigenstrain of a cuboid, shape (6, 6, ...): [stress, strain] component.

    Inside the cuboid the eigenstrain's own part is subtracted. Mindlin's half-space solution
    integrated in closed form; docs/theory.md.
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

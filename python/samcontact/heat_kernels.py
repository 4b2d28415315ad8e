# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence coefficients of one rectangle of uniform heat flux on a half-space.

The flux flows into the body; the rest of the surface is insulated. All results are per unit flux
q [W/m^2]. Heat causes a temperature rise and, by thermal expansion of the free half-space, stress
and displacement (quasi-static, uncoupled).

x, y (X, Y) [m] are the coordinates of the field point relative to the centre of the rectangle,
whose HALF sizes are a and b [m]. The axes are fixed to the source; z >= 0 [m] points into the body.
The `velocity` (Vx, Vy) [m/s] is the velocity of the body relative to the source: the hot wake lies
downstream. Stress is positive in tension, components xx, yy, zz, yz, xz, xy; u_z is positive into
the body, so heated surfaces bulge to negative u_z.

The material has the conductivity k [W/(m K)], diffusivity kappa [m^2/s], thermal expansion alpha
[1/K], Young's modulus E [Pa] and Poisson's ratio nu.

The functions `steady_...` are closed forms for a steady source at rest, at arbitrary points; arrays
broadcast. The other functions tabulate all pairs of x and y: each table is a sum of products
f_a(x) f_b(y), which is fast to evaluate (docs/theory/heat.md).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._util.checks import FloatArray, finite, non_negative, number, positive, real_array
from ._util.short_text import in_short
from .kernels import _constants, _depths, _points, _sizes

__all__ = [
    "displacement",
    "steady_displacement",
    "steady_stress",
    "steady_temperature",
    "stress",
    "temperature",
]

Velocity = tuple[float, float]


def steady_temperature(
    X: ArrayLike, Y: ArrayLike, z: ArrayLike, a: float, b: float, *, conductivity: float
) -> FloatArray:
    """Return the temperature rise [K m^2/W] due to a steady source at rest; shape of X.

    Raises ValueError for non-finite points, z < 0, sizes or conductivity <= 0. Carslaw & Jaeger
    (1959), section 10.5.
    """
    (x, y, depth), shape = _points(X, Y, z)
    a, b = _sizes(a=a, b=b)
    k = positive("conductivity", conductivity)
    values: FloatArray = _core.kernels.steady_heat_temperature(x, y, _depths(depth), a, b) / k
    return values.reshape(shape)


def steady_stress(
    X: ArrayLike,
    Y: ArrayLike,
    z: ArrayLike,
    a: float,
    b: float,
    *,
    E: float,
    expansion: float,
    conductivity: float,
) -> FloatArray:
    """Return the stress [Pa m^2/W] due to a steady source at rest, shape (6, ...).

    The state is plane stress: zz, yz and xz vanish everywhere, and xx + yy = -E alpha T. Poisson's
    ratio has no influence. Raises ValueError like `steady_temperature`. Sternberg & McDowell
    (1957).
    """
    (x, y, depth), shape = _points(X, Y, z)
    a, b = _sizes(a=a, b=b)
    scale = _constants(E, 0.0)[0] * finite("expansion", expansion)
    scale /= positive("conductivity", conductivity)
    stress = np.zeros((6, x.size))
    stress[[0, 1, 5]] = scale * _core.kernels.steady_heat_stress(x, y, _depths(depth), a, b)
    return stress.reshape(6, *shape)


def steady_displacement(
    X: ArrayLike,
    Y: ArrayLike,
    a: float,
    b: float,
    *,
    nu: float,
    expansion: float,
    conductivity: float,
    r0: float,
) -> FloatArray:
    """Return the surface displacement u_z [m^3/W] due to a steady source at rest; shape of X.

    The displacement grows with the logarithm of the distance, so only differences are meaningful;
    `r0` [m] is the distance at which the displacement due to a point source is defined as zero.
    Near a source that has been on for a time t, r0 = 4 exp(-(1 + gamma)/2) sqrt(kappa t) = 1.818
    sqrt(kappa t) (gamma: Euler's constant). Johnson (1985), section 12.2; Boucly (2008), eqs
    (2.53)-(2.60).
    """
    (x, y), shape = _points(X, Y)
    a, b = _sizes(a=a, b=b)
    values: FloatArray = _core.kernels.steady_heat_displacement(x, y, a, b, positive("r0", r0))
    return values.reshape(shape) * _distortion(nu, expansion, conductivity)


def temperature(
    x: ArrayLike,
    y: ArrayLike,
    z: float,
    a: float,
    b: float,
    *,
    conductivity: float,
    diffusivity: float,
    time: float = math.inf,
    velocity: Velocity = (0.0, 0.0),
    tol: float = 1e-6,
) -> FloatArray:
    """Return the temperature rise [K m^2/W] at one depth, shape (len(x), len(y)).

    Parameters
    ----------
    x, y : array_like, shapes (nx,), (ny,)
        Coordinates of the field points [m] in any order. The result is even in x if velocity[0] is
        0, and even in y if velocity[1] is 0; coordinates >= 0 then suffice.
    z : float
        Depth [m], >= 0.
    a, b : float
        Half-sides of the uniformly heated rectangle along x and y [m].
    time : float
        Time since the source was switched on [s]; default inf, the steady state.
    tol : float
        Tolerance relative to the maximum of the table, in [1e-12, 1e-2]; the error is usually far
        smaller. Even the small values far from the source are accurate to several digits.

    Raises
    ------
    ValueError
        A time or depth is negative; a size, the conductivity or the diffusivity is <= 0; a number
        is not finite; or the speed V is so high that the body crosses the extent L of the table in
        less than 1e-7 of the diffusion time L^2/kappa. The computing time is proportional to
        V L/kappa; near this limit of the speed, a table of displacements takes seconds.

    Notes
    -----
    Carslaw & Jaeger (1959), sections 10.4 (at rest) and 10.7 (moving).
    """
    table = _Table(x, y, a, b, diffusivity, time, velocity, tol)
    k = positive("conductivity", conductivity)
    values = _core.kernels.heat_temperature(
        table.x, table.y, non_negative("z", z), table.a, table.b, *table.history
    )
    rise: FloatArray = table.expand(values)[0] / k
    return rise


def displacement(
    x: ArrayLike,
    y: ArrayLike,
    a: float,
    b: float,
    *,
    nu: float,
    expansion: float,
    conductivity: float,
    diffusivity: float,
    time: float = math.inf,
    velocity: Velocity = (0.0, 0.0),
    tol: float = 1e-6,
) -> FloatArray:
    """Return the surface displacement u_z [m^3/W], shape (len(x), len(y)), zero far away.

    Parameters and symmetry as in `temperature`. Also raises ValueError for a source at rest with
    time = inf, whose displacement has no limit far away; see `steady_displacement`.

    Notes
    -----
    The solution is derived by reciprocity with the normal point force. It corrects Boucly (2008),
    eq. (2.45).
    """
    table = _Table(x, y, a, b, diffusivity, time, velocity, tol)
    scale = _distortion(nu, expansion, conductivity)
    if math.isinf(table.time) and table.speed == (0.0, 0.0):
        raise ValueError(
            f"time must be finite for a source at rest, got {table.time!r}: use "
            "steady_displacement for the steady state"
        )
    values = _core.kernels.heat_displacement(table.x, table.y, table.a, table.b, *table.history)
    bulge: FloatArray = table.expand(values)[0] * scale
    return bulge


def stress(
    x: ArrayLike,
    y: ArrayLike,
    z: float,
    a: float,
    b: float,
    *,
    E: float,
    nu: float,
    expansion: float,
    conductivity: float,
    diffusivity: float,
    time: float = math.inf,
    velocity: Velocity = (0.0, 0.0),
    tol: float = 1e-6,
) -> FloatArray:
    """Return the stress [Pa m^2/W] at one depth, shape (6, len(x), len(y)).

    Parameters and errors as in `temperature`, with the tolerance relative to the largest component
    in the table. zz, yz and xz vanish at the surface and for a steady source at rest. If the
    temperature is even in x, xz and xy are odd in x; if it is even in y, yz and xy are odd in y.

    Notes
    -----
    Liu & Wang (2003); Boucly (2008), appendix 1, with corrections.
    """
    table = _Table(x, y, a, b, diffusivity, time, velocity, tol)
    E, nu = _constants(E, nu)
    scale = E * finite("expansion", expansion) / (1 - nu) / positive("conductivity", conductivity)
    values = _core.kernels.heat_stress(
        table.x, table.y, non_negative("z", z), table.a, table.b, nu, *table.history
    )
    return table.expand(values) * scale


def _distortion(nu: float, expansion: float, conductivity: float) -> float:
    """Return the thermal distortion coefficient alpha (1 + nu)/k [m/W]."""
    nu = _constants(1.0, nu)[1]
    return finite("expansion", expansion) * (1 + nu) / positive("conductivity", conductivity)


def _offsets(name: str, value: ArrayLike) -> tuple[FloatArray, Any]:
    array = real_array(name, value)
    if array.ndim != 1 or array.size == 0:
        raise ValueError(f"{name} must be one-dimensional and not empty, got shape {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite everywhere")
    return np.unique(array, return_inverse=True)


class _Table:
    """Checked arguments that all tables of coefficients share, as the compiled core needs them."""

    def __init__(
        self,
        x: ArrayLike,
        y: ArrayLike,
        a: float,
        b: float,
        diffusivity: float,
        time: float,
        velocity: Velocity,
        tol: float,
    ) -> None:
        self.x, self._rows = _offsets("x", x)
        self.y, self._columns = _offsets("y", y)
        self.a, self.b = _sizes(a=a, b=b)
        kappa = positive("diffusivity", diffusivity)
        self.time = number("time", time)
        if not self.time >= 0.0:
            raise ValueError(f"time must be a number >= 0 [s] (inf allowed), got {self.time!r}")
        if real_array("velocity", velocity).shape != (2,):
            raise ValueError(
                f"velocity must be two numbers (Vx, Vy) [m/s], got {in_short(velocity)}"
            )
        speeds = [finite(f"velocity[{n}]", velocity[n]) / kappa for n in (0, 1)]
        self.speed = (speeds[0], speeds[1])
        self._check_range(kappa)
        tolerance = number("tol", tol)
        if not 1e-12 <= tolerance <= 1e-2:
            raise ValueError(f"tol must be in [1e-12, 1e-2], got {tolerance!r}")
        self.history = (kappa * self.time, self.speed, tolerance)

    def _check_range(self, kappa: float) -> None:
        unit = 2 * self.a
        if math.isfinite(self.time) and kappa * self.time > 1e59 * unit**2:
            raise ValueError(
                "time must be inf or <= 1e60 a^2/diffusivity (a: half-length "
                f"of the source along x), got {self.time!r} s"
            )
        speed = math.hypot(*self.speed)
        if 0.0 < speed * unit < 1e-59:
            raise ValueError(
                "velocity must be 0 or have a magnitude >= 1e-59 "
                "diffusivity/a (a: half-length of the source along x), got "
                f"{speed * kappa!r} m/s"
            )
        extent = max(self.a, self.b, float(np.abs(self.x).max()), float(np.abs(self.y).max()))
        if not speed * extent < 1e7:
            raise ValueError(
                f"velocity must have a magnitude < {1e7 * kappa / extent:.4g} m/s (1e7 diffusivity/"
                "extent; extent: the largest of |x|, |y| and the half-lengths of the source), "
                f"got {speed * kappa!r} m/s"
            )

    def expand(self, values: FloatArray) -> FloatArray:
        """Return the table at the given x and y, from values at the distinct x and y."""
        expanded: FloatArray = values[:, self._rows[:, None], self._columns]
        return expanded

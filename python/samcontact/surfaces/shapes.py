# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps of simple shapes, roughness, and gaps between measured heights."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from .._util import memory
from .._util.checks import FloatArray, choice, gap_array, integer, non_negative, number, positive
from .._util.lazy_scipy import scipy
from .._util.short_text import in_short


class SurfaceGrid(Protocol):
    """Interface of a grid of surface cells: attributes that `samcontact.Grid` has."""

    @property
    def nx(self) -> int: ...
    @property
    def ny(self) -> int: ...
    @property
    def dx(self) -> float: ...
    @property
    def dy(self) -> float: ...
    @property
    def x(self) -> FloatArray: ...
    @property
    def y(self) -> FloatArray: ...


def require_surface(grid: SurfaceGrid) -> None:
    """Raise TypeError for an object that has no attributes of surface cells."""
    if not all(hasattr(grid, name) for name in ("nx", "ny", "dx", "dy", "x", "y")):
        raise TypeError(f"grid must be a samcontact.Grid, got {in_short(grid)}")


def _require_memory(grid: SurfaceGrid) -> None:
    require_surface(grid)
    what = f"a surface of nx = {grid.nx}, ny = {grid.ny}"
    memory.require(what, memory.SURFACE_BYTES * grid.nx * grid.ny)


def coordinates(grid: SurfaceGrid) -> tuple[FloatArray, FloatArray]:
    """Return the cell centres as a column of x and a row of y [m]."""
    _require_memory(grid)
    return np.asarray(grid.x)[:, None], np.asarray(grid.y)[None, :]


def paraboloid(grid: SurfaceGrid, Rx: float, Ry: float | None = None) -> FloatArray:
    """Paraboloid x^2/(2 Rx) + y^2/(2 Ry), the surface of Hertz theory.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    Rx, Ry : float
        Radii of curvature in the planes y = 0 and x = 0 [m]; inf for no curvature. Ry is Rx by
        default.

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap [m].

    Raises
    ------
    ValueError
        A radius is not positive, or so small that the gap overflows.
    """
    Rx = positive("Rx", Rx, allow_inf=True)
    Ry = Rx if Ry is None else positive("Ry", Ry, allow_inf=True)
    x, y = coordinates(grid)
    with np.errstate(over="ignore"):
        gap = np.asarray(0.5 * x**2 / Rx + 0.5 * y**2 / Ry, dtype=np.float64)
    if not np.isfinite(gap).all():
        raise ValueError(
            f"Rx and Ry must give a finite gap on the grid, got {Rx!r} and {in_short(Ry)}"
        )
    return gap


def _circular(r2: FloatArray, R: float) -> FloatArray:
    """Return R - sqrt(R^2 - r^2), evaluated without cancellation."""
    if R > 1e150:
        raise ValueError(f"R must be <= 1e150 m, or inf for a paraboloid, got {R!r}")
    if np.max(r2) > R**2:
        raise ValueError(f"R must be >= {np.sqrt(np.max(r2)):.6g} to cover the grid, got {R!r}")
    return np.asarray(r2 / (R + np.sqrt(R**2 - r2)), dtype=np.float64)


def sphere(grid: SurfaceGrid, R: float) -> FloatArray:
    """Gap between an exact sphere of radius R and a plane that it touches.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    R : float
        Radius [m].

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap R - sqrt(R^2 - x^2 - y^2) [m].

    Raises
    ------
    ValueError
        R is not finite and positive, or the grid extends beyond the sphere.
    """
    x, y = coordinates(grid)
    return _circular(x**2 + y**2, positive("R", R))


def cylinder(grid: SurfaceGrid, R: float, axis: str = "y") -> FloatArray:
    """Gap between an exact circular cylinder of radius R and the plane on which it lies.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    R : float
        Radius [m].
    axis : {"y", "x"}
        Direction of the axis. The parabolic form is ``paraboloid(grid, R, math.inf)``.

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap [m].

    Raises
    ------
    ValueError
        R is not finite and positive, the grid extends beyond the cylinder, or the axis is unknown.
    """
    choice("axis", axis, ("y", "x"))
    x, y = coordinates(grid)
    profile = _circular(x**2 if axis == "y" else y**2, positive("R", R))
    return np.array(np.broadcast_to(profile, (grid.nx, grid.ny)))


def sinusoidal(
    grid: SurfaceGrid, amplitude: float, wavelength_x: float, wavelength_y: float
) -> FloatArray:
    """Roughness A sin(2 pi x/lx) sin(2 pi y/ly), to be added to a gap.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    amplitude : float
        A [m], >= 0.
    wavelength_x, wavelength_y : float
        lx and ly [m], at least two cells long.

    Returns
    -------
    ndarray, shape (nx, ny)
        Contribution to the gap [m], positive or negative.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    amplitude = non_negative("amplitude", amplitude)
    lengths = []
    require_surface(grid)
    for name, value, step in (
        ("wavelength_x", wavelength_x, grid.dx),
        ("wavelength_y", wavelength_y, grid.dy),
    ):
        lengths.append(positive(name, value))
        if value < 2.0 * step:
            raise ValueError(f"{name} must be >= {2.0 * step!r} (two cells), got {value!r}")
    x, y = coordinates(grid)
    wave_x = np.sin(2.0 * np.pi * x / lengths[0])
    wave_y = np.sin(2.0 * np.pi * y / lengths[1])
    return np.asarray(amplitude * wave_x * wave_y, dtype=np.float64)


def from_heights(
    grid: SurfaceGrid, heights_lower: ArrayLike, heights_upper: ArrayLike | None = None
) -> FloatArray:
    """Gap between two measured surfaces, shifted so that they just touch.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    heights_lower : array_like, shape (nx, ny)
        Heights of the lower surface (body 2) [m], positive upwards (out of body 2); -inf where
        there is no surface.
    heights_upper : array_like, shape (nx, ny), optional
        Heights of the upper surface (body 1) [m], positive upwards (into body 1); +inf where there
        is no surface. Default: flat.

    Returns
    -------
    ndarray, shape (nx, ny)
        Heights of the upper minus heights of the lower surface, shifted so that the minimum is 0
        [m]; +inf where either surface is absent.

    Raises
    ------
    ValueError
        Wrong shape, NaN, an infinity of the wrong sign, or no cell in which both bodies exist.
    """
    require_surface(grid)
    shape = (grid.nx, grid.ny)
    gap = -gap_array("heights_lower", heights_lower, shape, -math.inf)
    if heights_upper is not None:
        gap = gap + gap_array("heights_upper", heights_upper, shape)
    if not np.isfinite(gap).any():
        raise ValueError("heights_lower and heights_upper must both be finite in at least one cell")
    return np.asarray(gap - gap.min(), dtype=np.float64)


def rough_self_affine(
    grid: SurfaceGrid,
    rms_height: float,
    hurst: float,
    *,
    wavelength_min: float | None = None,
    wavelength_max: float | None = None,
    roll_off: float | None = None,
    seed: int,
) -> FloatArray:
    """Isotropic self-affine random roughness, periodic over the grid, to be added to a gap.

    The surface is filtered white Gaussian noise. From the long cut-off wavelength to the roll-off,
    its power spectral density is constant. From the roll-off to the short cut-off, it decreases
    with the wavenumber q as q^(-2 (1 + hurst)). It is zero elsewhere (Persson et al. 2005,
    doi:10.1088/0953-8984/17/1/R01).

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    rms_height : float
        Root-mean-square height of the generated surface [m].
    hurst : float
        Hurst exponent, in [0, 1] [-].
    wavelength_min, wavelength_max : float, optional
        Short and long cut-off wavelength [m]. Default: two cells, and the longer side of the grid.
    roll_off : float, optional
        Wavelength of the roll-off [m], between the cut-offs. Default: `wavelength_max`.
    seed : int
        Seed of `numpy.random.default_rng`: equal seeds give equal surfaces.

    Returns
    -------
    ndarray, shape (nx, ny)
        Heights [m] with zero mean.

    Raises
    ------
    ValueError
        An argument is outside its range, or no Fourier mode of the grid lies between the cut-offs.
    MemoryError
        The grid requires more memory than is available. The other functions of this module also
        raise this error.
    """
    rms_height = non_negative("rms_height", rms_height)
    if not 0.0 <= number("hurst", hurst) <= 1.0:
        raise ValueError(f"hurst must be in [0, 1], got {hurst!r}")
    require_surface(grid)
    shortest = 2.0 * max(grid.dx, grid.dy)
    longest = max(grid.nx * grid.dx, grid.ny * grid.dy)
    low = shortest if wavelength_min is None else positive("wavelength_min", wavelength_min)
    high = longest if wavelength_max is None else positive("wavelength_max", wavelength_max)
    middle = high if roll_off is None else positive("roll_off", roll_off)
    # a wavelength computed by the caller as nx * dx may have a rounding error
    if low < shortest * (1.0 - 1e-9):
        raise ValueError(f"wavelength_min must be >= {shortest!r} (two cells), got {low!r}")
    if not low <= middle <= high:
        raise ValueError(
            f"roll_off must be between wavelength_min ({low!r} m) and wavelength_max "
            f"({high!r} m), got {middle!r} m"
        )

    _require_memory(grid)
    qx = scipy.fft.fftfreq(grid.nx, grid.dx)[:, None]
    qy = scipy.fft.rfftfreq(grid.ny, grid.dy)[None, :]
    q = np.hypot(qx, qy)
    inside = (q >= (1.0 - 1e-9) / high) & (q <= (1.0 + 1e-9) / low) & (q > 0.0)
    if not inside.any():
        raise ValueError(
            "wavelength_min and wavelength_max must have at least one Fourier mode of the "
            f"grid between them, got {low!r} and {high!r} m: widen the range, or enlarge "
            "the grid"
        )
    filter_ = np.zeros_like(q)
    filter_[inside] = np.maximum(q[inside] * middle, 1.0) ** -(1.0 + float(hurst))
    rng = np.random.default_rng(integer("seed", seed, 0, None))
    noise = scipy.fft.rfft2(rng.standard_normal((grid.nx, grid.ny)))
    heights = scipy.fft.irfft2(noise * filter_, s=(grid.nx, grid.ny))
    heights *= rms_height / np.sqrt(np.mean(heights**2))
    return np.asarray(heights, dtype=np.float64)


def interpolated(heights: FloatArray, cells: SurfaceGrid, grid: SurfaceGrid) -> FloatArray:
    """Interpolate periodic heights by their Fourier series, at the cell centres of another grid.

    heights: heights in the cells of the grid `cells` [m], which is one period long and wide. The
    interpolant equals them at the centres of `cells`; its shortest wavelength is two of these
    cells.
    """
    _require_memory(grid)
    transform = scipy.fft.fft2(heights) / heights.size
    waves = []
    for positions, origin, n, d in (
        (grid.x, cells.x, cells.nx, cells.dx),
        (grid.y, cells.y, cells.ny, cells.dy),
    ):
        distance = np.asarray(positions)[:, None] - np.asarray(origin)[0]
        waves.append(np.exp(2j * np.pi * distance * scipy.fft.fftfreq(n, d)))
    return np.asarray((waves[0] @ transform @ waves[1].T).real, dtype=np.float64)

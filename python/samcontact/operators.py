# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear operators of a half-space that map fields on a grid to stress or displacement.

Each call computes new kernels; `ContactSolver` and `Simulation` keep their kernels for later use.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._util import memory
from ._util.checks import (
    FloatArray,
    axis_number,
    choice,
    finite_array,
    number,
    require_fast,
    require_type,
)
from .bodies.material import Material
from .problem.cell_fields import depth_major, depths_of, shear_components
from .problem.grid import Grid
from .problem.settings import Settings

__all__ = ["residual_displacement", "residual_stress", "surface_displacement", "surface_stress"]


def _require_volume(grid: Grid) -> None:
    require_type("grid", grid, Grid)
    if grid.nz == 0:
        raise ValueError("grid.nz must be > 0 for volume fields, got 0")


def surface_displacement(
    grid: Grid,
    pressure: ArrayLike,
    E: float,
    nu: float,
    shear: ArrayLike | None = None,
    *,
    axis: str = "z",
) -> FloatArray:
    """Return the surface displacement along an axis [m], shape (nx, ny); u_z points into the body.

    Parameters
    ----------
    grid : Grid
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa], positive in compression.
    E, nu : float
        Young's modulus [Pa], Poisson's ratio.
    shear : array_like, shape (nx, ny) or (2, nx, ny), optional
        Shear traction s_x, or (s_x, s_y), acting on the body [Pa].
    axis : {"x", "y", "z"}, optional
        Axis of the displacement; `ContactSolver.displacement` gives all three components.

    Notes
    -----
    Love (1929) and Cerruti (1882); Boucly (2008), eqs (2.34), (2.37) with the prefactor corrected.
    """
    require_type("grid", grid, Grid)
    number_of_axis = axis_number(axis)
    needed = memory.surface(grid, memory.DISPLACEMENT_BYTES)
    memory.require_for_grid("a displacement", grid, needed)
    p = np.ascontiguousarray(finite_array("pressure", pressure, grid.surface_shape))
    body = Material.elastic(number("E", E), number("nu", nu))._core
    field: FloatArray = _core.operators.surface_displacement(
        grid._core, body, _core.Heating(), p, *shear_components(grid, shear), number_of_axis
    )
    return field


def surface_stress(
    grid: Grid, pressure: ArrayLike, z: ArrayLike, nu: float, shear: ArrayLike | None = None
) -> FloatArray:
    """Return the stress [Pa] due to surface tractions at depths z, shape (6, nx, ny, len(z)).

    Parameters
    ----------
    grid : Grid
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa].
    z : array_like, shape (m,) or scalar
        Depths [m], >= 0.
    nu : float
        Poisson's ratio in [0, 0.5).
    shear : array_like, shape (nx, ny) or (2, nx, ny), optional
        Shear traction s_x, or (s_x, s_y), acting on the body [Pa].

    Notes
    -----
    Boucly (2008), eqs (2.81)-(2.93), L_22 corrected.
    """
    require_type("grid", grid, Grid)
    depths = depths_of(z)
    needed = memory.volume(grid, memory.TRACTION_STRESS_BYTES, len(depths))
    memory.require_for_grid(f"the stress at {len(depths)} depths", grid, needed)
    p = np.ascontiguousarray(finite_array("pressure", pressure, grid.surface_shape))
    # The stress due to tractions does not depend on Young's modulus.
    body = Material.elastic(1.0, number("nu", nu))._core
    field: FloatArray = _core.operators.surface_stress(
        grid._core, body, _core.Heating(), depths.tolist(), p, *shear_components(grid, shear)
    )
    return field


def residual_stress(
    grid: Grid,
    strain: ArrayLike,
    E: float,
    nu: float,
    *,
    method: str = "exact",
    image_tol: float = Settings.image_tol,
) -> FloatArray:
    """Return the stress [Pa] due to a field of eigenstrain, shape (6, nx, ny, nz).

    Parameters
    ----------
    grid : Grid
        Grid with layers (dz).
    strain : array_like, shape (6, nx, ny, nz)
        Eigenstrain [-], e.g. plastic strain, uniform in each cell; tensor components xx, yy, zz,
        yz, xz, xy.
    E, nu : float
    method : {"exact", "fast"}, optional
        "exact": influence coefficients of cuboids in a half-space (Mindlin's solution integrated in
        closed form), at the cell centres. "fast": the strain is taken as band-limited in the plane
        and uniform in each layer, and the stress is averaged over each layer. This method is for
        smooth fields; time and memory are proportional to the number of cells.
        docs/theory/residual_stress.md describes both methods.
    image_tol : float, optional
        Only with "fast": limit of the error due to the periodicity of the Fourier transforms,
        relative to the maximum stress, in [1e-6, 0.1].
    """
    _require_volume(grid)
    elastic = _core.Elastic.isotropic(number("E", E), number("nu", nu))
    exact = choice("method", method, ("exact", "fast")) == "exact"
    require_fast("method", method, grid.periodic)
    images = Settings.checked("image_tol", image_tol)
    cell = memory.EXACT_RESIDUAL_BYTES if exact else memory.FAST_RESIDUAL_BYTES
    memory.require_for_grid(f"the {method} stress", grid, memory.volume(grid, cell))
    field: FloatArray = _core.operators.residual_stress(
        grid._core, depth_major(grid, "strain", strain), elastic, exact, images
    )
    return field


def residual_displacement(
    grid: Grid, strain: ArrayLike, nu: float, *, axis: str = "z"
) -> FloatArray:
    """Return the surface displacement [m] due to an eigenstrain field, shape (nx, ny).

    Parameters
    ----------
    grid : Grid
        Grid with layers (dz).
    strain : array_like, shape (6, nx, ny, nz)
        As in `residual_stress`.
    nu : float
    axis : {"x", "y", "z"}, optional
        Axis of the displacement; u_z is positive into the body. On periodic grids, the displacement
        is relative to the body far below the surface.

    Notes
    -----
    u_z follows from Boucly (2008), eqs (2.62)-(2.71), corrected and completed by a term for the
    trace of the eigenstrain; u_x and u_y follow by reciprocity from the stress due to surface
    shear, see docs/theory/half_space.md.
    """
    number_of_axis = axis_number(axis)
    _require_volume(grid)
    nu = _core.Elastic.isotropic(1.0, number("nu", nu)).nu
    needed = memory.volume(grid, memory.FAST_RESIDUAL_BYTES)
    memory.require_for_grid("a displacement", grid, needed)
    field: FloatArray = _core.operators.residual_displacement(
        grid._core, depth_major(grid, "strain", strain), nu, number_of_axis
    )
    return field

# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsening of a simulation setup to half as many cells along x, y and z."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array
from .._util.lazy_scipy import scipy
from .._util.travels import AT_REST, both_axes, plain
from ..bodies.layered import interfaces_on_cells
from ..diagnostics.hertz_estimate import ContactSetup
from ..problem.domain import SurfaceGeometry
from ..problem.moving_topography import Relief, over_period
from .increment_paths import Sizes, are_multiples

if TYPE_CHECKING:
    from ..bodies.layered import Body
    from ..problem.domain import Domain
    from ..problem.grid import Grid
    from ..problem.setup import SimulationSetup

__all__ = ["coarser", "coarser_grid", "coarser_path", "coarser_strain", "slope_beyond"]

Path = Sequence[Mapping[str, Any]]


def coarser(setup: SimulationSetup, domain: Domain) -> tuple[SimulationSetup, Domain]:
    """Return the setup and domain of a simulation on cells twice as long, wide and deep.

    Each elastic-plastic layer must be a whole number of coarse cells thick. With such layers, the
    cells therefore become deeper by a factor that may exceed 2 or, if no factor fits, keep their
    depth. Surfaces given as functions are evaluated on the coarser grid. Surfaces given as arrays
    of heights are averaged over the coarser cells; smooth paraboloids are interpolated instead.

    Raises
    ------
    ValueError
        The number of cells along a periodic direction cannot be halved, or a periodic relief has an
        odd number of rows.
    """
    grid, surfaces = coarser_grid(domain.grid, setup.bodies), setup.surfaces
    gap: Any = surfaces.gap
    if not callable(gap):
        gap = _gap(setup, domain, grid)
    reliefs = [
        given if given is None or callable(given) else _relief(given, domain.grid, grid)
        for given in (surfaces.relief1, surfaces.relief2)
    ]
    found = replace(setup, surfaces=SurfaceGeometry(gap, *reliefs))
    return found, found.surfaces.over(grid)


def coarser_grid(grid: Grid, bodies: Sequence[Body] = ()) -> Grid:
    """Return a grid of cells twice as large that covers at least the area of the given grid.

    Interfaces of elastic-plastic layers still lie between two layers of cells. An odd number of
    cells along x or y remains odd, so that the origin remains at the centre of a cell. An even
    number remains even, so that the origin remains between two cells.
    """
    given: dict[str, Any] = {}
    for axis, n, d in zip("xy", (grid.nx, grid.ny), (grid.dx, grid.dy), strict=True):
        if n == 1:  # a line contact
            given |= {f"n{axis}": 1, f"d{axis}": d}
            continue
        half = math.ceil(n / 2)
        if axis in grid.periodic:
            if n % 4 != 0 and n != 2:
                raise ValueError(
                    f"on a periodic grid, n{axis} must be a multiple of 4 for coarsening, got {n}"
                )
        elif half % 2 != n % 2:
            half += 1
        given |= {f"n{axis}": half, f"d{axis}": 2 * d}
    if grid.dz is not None:
        deeper = times_as_deep(grid.dz, bodies)
        given |= {"nz": math.ceil(grid.nz / deeper), "dz": grid.dz * deeper}
    return replace(grid, **given)


def times_as_deep(dz: float, bodies: Sequence[Body]) -> float:
    """Return the ratio of coarse to fine cell depth, preferably 2.

    With elastic-plastic layers, the result is the smallest ratio >= 2 for which each of these
    layers is a whole number of coarse cells thick; 1 if there is no such ratio.
    """
    ends = [
        round(float(depth) / dz) for body in bodies for depth in interfaces_on_cells(body)
    ]  # fmt: skip
    part = math.gcd(*ends)
    return part / (part // 2) if part > 1 else 1.0 if ends else 2.0


def coarser_path(path: Path, sizes: Sizes) -> tuple[list[dict[str, Any]], list[int]]:
    """Convert a path to cells twice as long; also return the new index of each old increment.

    An odd number of cells is not a whole number of the longer cells. Two equal successive
    increments that move a surface by an odd number of cells are therefore merged.

    sizes: cell sizes, see `SimulationSetup.steps_of_motion`.
    """
    larger = 2 * sizes[0], None if sizes[1] is None else 2 * sizes[1]
    steps: list[dict[str, Any]] = []
    which: list[int] = []
    waiting = False
    for step in path:
        given = dict(step)
        whole = are_multiples(both_axes(given.get("advance", AT_REST)), larger)
        if waiting and given == path[len(which) - 1]:
            steps[-1] |= _sum_of_two(given)
            if given.get("duration") is not None:
                steps[-1]["duration"] = 2 * given["duration"]
            waiting = False
        else:
            steps.append(given)
            waiting = not whole
        which.append(len(steps) - 1)
    return steps, which


def _sum_of_two(step: Mapping[str, Any]) -> dict[str, Any]:
    """Combine two equal increments: add the motions, and use the forces of the second increment."""
    moved: dict[str, Any] = {"advance": plain(2 * both_axes(step["advance"]))}
    if step.get("shift") is not None:
        moved["shift"] = tuple(None if s is None else 2 * s for s in step["shift"])
    if step.get("twist") is not None:
        moved["twist"] = 2 * step["twist"]
    return moved


def coarser_strain(strain: FloatArray, fine: Grid, grid: Grid) -> FloatArray:
    """Average a strain (6, nx, ny, layers) over coarser cells; outside the fine grid it is 0."""
    for axis, (m, n) in enumerate(_counts(grid, fine), 1):
        if n > 1:
            pad = max(0, math.ceil(0.5 * (2 * m - n)))
            edges = 0.5 * n + pad + 2.0 * (np.arange(m + 1, dtype=np.float64) - 0.5 * m)
            strain = _means_along(strain, axis, (pad, pad), edges)
    layers, deeper = strain.shape[3], float(grid.dz or 0.0) / float(fine.dz or 1.0)
    edges = deeper * np.arange(math.ceil(layers / deeper) + 1, dtype=np.float64)
    return _means_along(strain, 3, (0, math.ceil(edges[-1]) - layers), edges)


def _means_along(
    field: FloatArray, axis: int, zeros: tuple[int, int], edges: FloatArray
) -> FloatArray:
    """Pad a field with zeros along one axis, and average it between given edges [cells]."""
    width = [zeros if axis == other else (0, 0) for other in range(field.ndim)]
    lines = np.moveaxis(np.pad(field, width), axis, 0)
    means = _means(lines.reshape(len(lines), -1), edges, 0)
    return np.moveaxis(means.reshape(-1, *lines.shape[1:]), 0, axis)


def slope_beyond(heights: ArrayLike, dx: float, dy: float) -> float:
    """Return the fraction of the mean square slope that cells twice as large cannot resolve.

    Parameters
    ----------
    heights : array_like, shape (nx, ny)
        Heights of the surface [m]; a best-fit paraboloid is subtracted, and the edges are tapered
        (Hann window).
    dx, dy : float
        Cell sizes [m].

    Returns
    -------
    float
        Fraction in [0, 1] that is due to waves shorter than 4 dx along x or 4 dy along y. NaN for a
        smooth surface, and for fewer than 8 cells per side.

    Notes
    -----
    The waves in this fraction are the last octave of wavenumbers on this grid. If the slope
    spectrum is a power law of the wavenumber, as for a self-affine surface, the next octave, which
    this grid cannot resolve, contains at least this fraction times r. Here, r is the mean square
    slope in the last octave divided by that in the octave before it.
    """
    field = np.asarray(heights, dtype=np.float64)
    finite_array("heights", field, field.shape)
    if min(field.shape) < 8:
        return math.nan
    x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in field.shape), indexing="ij")
    basis = np.stack([v.ravel() for v in (np.ones_like(x), x, y, x * x, x * y, y * y)], axis=1)
    fitted = basis @ np.linalg.lstsq(basis, field.ravel(), rcond=None)[0]
    rough = field - fitted.reshape(field.shape)
    if not rough.std() > 1e-6 * np.ptp(field):
        return math.nan
    faded = rough * np.outer(*(scipy.signal.windows.hann(n) for n in field.shape))
    spectrum = np.abs(np.fft.fft2(faded)) ** 2
    q_x, q_y = (np.fft.fftfreq(n) for n in field.shape)  # cycles per cell
    slopes = spectrum * ((q_x[:, None] / dx) ** 2 + (q_y[None, :] / dy) ** 2)
    short = (np.abs(q_x)[:, None] > 0.25) | (np.abs(q_y)[None, :] > 0.25)
    return float(slopes[short].sum() / slopes.sum())


def _gap(setup: SimulationSetup, domain: Domain, grid: Grid) -> FloatArray:
    body = np.isfinite(domain.initial_gap)
    if not body.all():  # cells mostly covered by a body get its height
        share = _averaged(body.astype(np.float64), domain.grid, grid)
        height = _averaged(np.where(body, domain.initial_gap, 0.0), domain.grid, grid)
        kept = share >= 0.5
        return np.where(kept, height / np.where(kept, share, 1.0), np.inf)
    relieved = any(relief is not None for relief in domain.reliefs)
    contact = ContactSetup(domain.grid, domain.initial_gap, setup.bodies, relieved)
    if contact.radii is None:
        return _averaged(domain.initial_gap, domain.grid, grid)
    fine = domain.grid
    pads = [max(0, math.ceil(0.5 * (2 * m - n))) + 1 for m, n in _counts(grid, fine)]
    field = np.pad(domain.initial_gap, [(p, p) for p in pads], "reflect", reflect_type="odd")
    axes = [
        (np.arange(n + 2 * p) - 0.5 * (n + 2 * p - 1)) * d
        for n, p, d in zip(fine.surface_shape, pads, (fine.dx, fine.dy), strict=True)
    ]
    spline = scipy.interpolate.RectBivariateSpline(*axes, field)
    found: FloatArray = spline(grid.x, grid.y)
    return found


def _counts(grid: Grid, fine: Grid) -> list[tuple[int, int]]:
    return list(zip(grid.surface_shape, fine.surface_shape, strict=True))


def _averaged(field: FloatArray, fine: Grid, grid: Grid) -> FloatArray:
    """Average a field over the cells of a coarser grid with the same centre."""
    for axis, (m, n) in enumerate(_counts(grid, fine)):
        if n == 1:
            continue
        pad = max(0, math.ceil(0.5 * (2 * m - n)))
        width = [(pad, pad) if axis == other else (0, 0) for other in (0, 1)]
        longer = np.pad(field, width, "reflect", reflect_type="odd")
        middle = 0.5 * (n + 2 * pad)
        edges: FloatArray = middle + 2.0 * (np.arange(m + 1, dtype=np.float64) - 0.5 * m)
        field = _means(longer, edges, axis)
    return field


def _means(field: FloatArray, edges: FloatArray, axis: int) -> FloatArray:
    """Average a field of cells along one axis between given edges [cells]."""
    lines = np.moveaxis(field, axis, 0)
    sums = np.concatenate([np.zeros((1, lines.shape[1])), np.cumsum(lines, axis=0)])
    below = np.clip(np.floor(edges).astype(int), 0, len(lines) - 1)
    at_edges = sums[below] + (edges - below)[:, None] * lines[below]
    return np.moveaxis(np.diff(at_edges, axis=0) / np.diff(edges)[:, None], 0, axis)


def _relief(relief: Relief, fine: Grid, grid: Grid) -> Relief:
    """Average the rows of a relief over the cells of a coarser grid."""
    if fine.along_x:
        relief = over_period(relief, fine.nx)
    rows = len(relief.heights)
    if relief.periodic and rows % 2 != 0:
        raise ValueError(
            "a periodic relief must have an even number of rows so that every two rows "
            f"can be merged, got {rows}"
        )
    begins = relief.first - 0.5 * fine.nx  # from the centre of the grid, in fine cells
    first = math.floor(0.5 * begins + 0.5 * grid.nx)
    ends = math.ceil(0.5 * (begins + rows) + 0.5 * grid.nx)
    count = rows // 2 if relief.periodic else ends - first
    numbers = np.arange(count + 1, dtype=np.float64)
    edges: FloatArray = 2.0 * (first + numbers - 0.5 * grid.nx) - begins
    mode: Any = "wrap" if relief.periodic else "constant"
    across = [replace(g, nx=1, periodic="") for g in (fine, grid)]

    def means(field: FloatArray) -> FloatArray:
        along = _means(np.pad(field, [(2, 2), (0, 0)], mode), edges + 2.0, 0)
        return _averaged(along, across[0], across[1])

    # Linear extrapolation outside the rows of the grid, where heights may be below 0.
    worn = None if relief.worn is None else np.maximum(means(relief.worn), 0.0)
    return Relief(means(relief.heights), first, relief.periodic, worn)

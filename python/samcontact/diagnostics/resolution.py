# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the resolution of contact and plastic zone, and of the range of linear elasticity."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._util.checks import FloatArray
from .._util.display import lengths, quantity
from .._util.errors import ElasticStrainWarning, ResolutionWarning
from .._util.lazy_scipy import scipy
from ..problem.contact_law import in_contact
from ..solutions.contact_area import AREA_PER_SIDE
from ..solutions.outline import Outline, outline_of
from ..solutions.strained_cells import strained_extent

if TYPE_CHECKING:
    import xarray as xr

    from ..solutions.contact_solution import ContactSolution
    from ..solutions.state import State
    from .hertz_estimate import ContactSetup

RECOMMENDED_CELLS = 8
"""Recommended cells across a contact, and layers of a plastic zone; fewer cause a warning."""
MINIMUM_CELLS = 4
"""Minimum number of cells or layers; with fewer, the check of a report fails."""
ROUND_SPOT_AREA_ERROR = 16 / math.pi * AREA_PER_SIDE
"""Relative area uncertainty of a round spot, multiplied by the spot diameter in cells."""
AREA_ERROR_WARNING, AREA_ERROR_LIMIT = 0.1, 0.2
"""Relative area uncertainty above which a warning is issued, and above which the check of a report
fails."""
MAX_ELASTIC_STRAIN = 0.5
"""Limit of the ratio of maximum pressure to E*; a Hertz contact reaches this limit at a/R = 0.8."""
_MAX_STRESS_DEPTH = 0.8
"""Largest ratio of depth of maximum von Mises stress to half-width: 0.48 in a point contact, 0.79
in a line contact."""


def warn_of_strain(
    solution: ContactSolution | State, setup: ContactSetup, *, stacklevel: int
) -> bool:
    """Warn of pressures beyond linear elasticity; return True after a warning."""
    largest = solution.outline.largest
    share = largest / setup.E_star
    if not share > MAX_ELASTIC_STRAIN:
        return False
    text = (
        f"pressure beyond linear elasticity: its maximum {quantity(largest, 'Pa')} is {share:.3g} "
        f"of the contact modulus E* (at most {MAX_ELASTIC_STRAIN} expected), which implies large "
        "slopes and strains. Reduce the load, or check that lengths, loads and moduli are in m, N "
        "and Pa"
    )
    warnings.warn(text, ElasticStrainWarning, stacklevel=stacklevel + 1)
    return True


def main_spot(pressure: ArrayLike, periodic: str = "") -> tuple[slice, slice] | None:
    """Range of cells along x and y of the contact spot with the maximum pressure.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa], >= 0.
    periodic : {"", "x", "y", "xy"}, optional
        Periodic directions, as for Grid. The pressure is first shifted along these directions, so
        that the maximum lies at the centre.

    Returns
    -------
    pair of slice, or None without contact
    """
    found, peak = _centred(pressure, periodic)
    if not found[peak]:
        return None
    if (alone := _only_spot(found)) is not None:
        return alone
    labels = _labels(found)
    rows, columns = scipy.ndimage.find_objects((labels == labels[peak]).astype(np.int8))[0]
    return rows, columns


def spots(pressure: ArrayLike, periodic: str = "") -> int:
    """Number of contact spots: groups of contact cells connected by sides or corners.

    Arguments as in `main_spot`.
    """
    found, _ = _centred(pressure, periodic)
    if not found.any():
        return 0
    return int(_labels(found).max()) if _only_spot(found) is None else 1


def _only_spot(found: NDArray[np.bool_]) -> tuple[slice, slice] | None:
    """Return the range of cells if the contact is one spot without holes, otherwise None.

    The range is found from the first and last contact cell of each row, without loading SciPy.
    """
    rows = np.flatnonzero(found.any(axis=1))
    if not rows.size or rows[-1] - rows[0] + 1 != rows.size:
        return None
    part = found[rows[0] : rows[-1] + 1]
    first = part.argmax(axis=1)
    last = part.shape[1] - 1 - part[:, ::-1].argmax(axis=1)
    if np.any(last - first + 1 != part.sum(axis=1)):
        return None
    if np.any(first[1:] > last[:-1] + 1) or np.any(first[:-1] > last[1:] + 1):
        return None
    return slice(int(rows[0]), int(rows[-1]) + 1), slice(int(first.min()), int(last.max()) + 1)


def _labels(found: NDArray[np.bool_]) -> NDArray[np.int32]:
    labels: NDArray[np.int32]
    labels, _ = scipy.ndimage.label(found, structure=np.ones((3, 3)))
    return labels


def _centred(pressure: ArrayLike, periodic: str) -> tuple[NDArray[np.bool_], tuple[int, int]]:
    """Return the cells in contact, and the indices of the cell of maximum pressure.

    The pressure is first shifted along periodic directions, so that this cell is at the centre.
    """
    field: FloatArray = np.asarray(pressure, dtype=np.float64)
    peak = divmod(int(field.argmax()), field.shape[1])
    shifts = [
        n // 2 - at if name in periodic else 0
        for name, at, n in zip("xy", peak, field.shape, strict=True)
    ]
    field = np.roll(field, shifts, (0, 1))
    return in_contact(field), (peak[0] + shifts[0], peak[1] + shifts[1])


def cells_across(pressure: ArrayLike, periodic: str = "") -> float:
    """Number of cells across the contact: shorter side of the spot with the maximum pressure.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa], >= 0.
    periodic : {"", "x", "y", "xy"}, optional
        Periodic directions, as for Grid. The pressure is first shifted along these directions, so
        that the maximum lies at the centre.

    Returns
    -------
    float
        Integer value; NaN without contact. A side of the spot that spans the whole grid is ignored,
        because the grid edge limits it.
    """
    spot = main_spot(pressure, periodic)
    if spot is None:
        return math.nan
    sides = [s.stop - s.start for s in spot]
    inside = [side for side, n in zip(sides, np.shape(pressure), strict=True) if side < n]
    return float(min(inside)) if inside else math.nan


def area_uncertainty(pressure: ArrayLike, periodic: str = "") -> float:
    """Relative uncertainty of the contact area [-] due to coarsely resolved spots.

    The uncertainty is (pi - 1 + ln 2)/24 times the number of cell sides between contact cells and
    open cells, divided by the number of contact cells. This is the error of counting cells,
    averaged over directions, for spots with smooth outlines (Yastrebov, Anciaux and Molinari 2017,
    doi:10.1016/j.triboint.2017.04.023). For a round spot n cells in diameter it is 0.6/n.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa], >= 0.
    periodic : {"", "x", "y", "xy"}, optional
        Periodic directions, as for Grid.

    Returns
    -------
    float
        Uncertainty; NaN without contact. Cell sides on the grid edge are not counted.
    """
    return _uncertainty(outline_of(pressure, periodic))


def _uncertainty(outline: Outline) -> float:
    return AREA_PER_SIDE * outline.sides / outline.cells if outline.cells else math.nan


def _is_wide(pressure: FloatArray) -> bool:
    """Whether the spot with the maximum pressure is at least `RECOMMENDED_CELLS` wide on both axes.

    Only the lines through the cell of maximum pressure are checked. If the check passes, the spot
    is wide enough; if not, the spot may still be wide enough.
    """
    i, j = divmod(int(pressure.argmax()), pressure.shape[1])
    around = (
        pressure[max(0, i - RECOMMENDED_CELLS) : i + RECOMMENDED_CELLS, j],
        pressure[i, max(0, j - RECOMMENDED_CELLS) : j + RECOMMENDED_CELLS],
    )
    return all(_longest_run(in_contact(line)) >= RECOMMENDED_CELLS for line in around)


def _longest_run(inside: NDArray[np.bool_]) -> int:
    ends = np.flatnonzero(np.diff(np.concatenate(([0], inside.astype(np.int8), [0]))))
    return int(max(ends[1::2] - ends[::2], default=0))


def layers_across(equivalent: ArrayLike) -> float:
    """Number of layers from the top to the bottom of the plastic zone.

    Parameters
    ----------
    equivalent : array_like, shape (nx, ny, nz)
        Equivalent plastic strain [-].

    Returns
    -------
    float
        Integer value; NaN without plastic strain.
    """
    strained = np.flatnonzero(np.asarray(equivalent).any(axis=(0, 1)))
    return float(strained[-1] - strained[0] + 1) if strained.size else math.nan


def layers_across_plastic_zone(extent: Sequence[tuple[int, int]]) -> float:
    """Number of layers of a plastic zone; `extent` is the result of `strained_extent`."""
    return float(extent[2][1] - extent[2][0] + 1) if extent else math.nan


def warn_of_contact(
    solution: ContactSolution | State,
    setup: ContactSetup,
    few: int = RECOMMENDED_CELLS,
    *,
    stacklevel: int,
) -> bool:
    """Warn if contact or spots are fewer than `few` cells wide; return True after a warning."""
    pressure, grid = solution.repulsion, setup.grid
    outline = solution.outline
    share = _uncertainty(outline)
    thin = share > (AREA_ERROR_WARNING if few >= RECOMMENDED_CELLS else AREA_ERROR_LIMIT)
    if not thin and 2 * outline.reach >= few:
        return False
    cell = lengths(grid.dx, grid.dy)
    if thin and (count := spots(pressure, grid.periodic)) > 1:
        text = (
            f"area is uncertain by about {100 * share:.0f} %, and so is the mean pressure: {count} "
            f"spots are about {ROUND_SPOT_AREA_ERROR / share:.1f} cells across ({cell}). Use "
            "smaller cells; with round spots of 8 cells the uncertainty would be "
            f"{100 * ROUND_SPOT_AREA_ERROR / RECOMMENDED_CELLS:.0f} %"
        )
    elif not _is_wide(pressure) and (cells := cells_across(pressure, grid.periodic)) < few:
        text = (
            f"is only {cells:.0f} cells across ({cell}; at least {RECOMMENDED_CELLS} recommended). "
            f"{_remedy(solution, setup)}"
        )
    elif thin:
        width = 2 * AREA_PER_SIDE / share
        text = (
            f"is a ring or line about {width:.1f} cells wide ({cell}), and the area is uncertain "
            f"by about {100 * share:.0f} %: use smaller cells"
        )
    else:
        return False
    message = f"under-resolved contact: at load {solution.load:.6g} N the contact {text}"
    warnings.warn(message, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def _remedy(solution: ContactSolution | State, setup: ContactSetup) -> str:
    expected = setup.hertz(load=solution.load)
    if expected is None:
        return "Use smaller cells"
    widest = quantity(2 * expected.semi_axes[1] / RECOMMENDED_CELLS, "m")
    return f"{expected}: use cells of at most {widest}"


def warn_of_zone(
    states: Sequence[State], body: int, few: int = RECOMMENDED_CELLS, *, stacklevel: int
) -> bool:
    """Warn if the plastic zone of a body has fewer than `few` layers; return True after a warning.

    The deepest plastic zone of all states is used, because plastic strain that moves with a body
    may leave the grid.
    """
    heights = [layers_across_plastic_zone(strained_extent(state, body)) for state in states]
    layers = max((height for height in heights if height > 0), default=math.nan)
    if not layers < few:
        return False
    text = (
        f"under-resolved plastic zone of body {body}: {layers:.0f} layers of "
        f"{quantity(states[0].grid.dz or 0.0, 'm')} (at least {RECOMMENDED_CELLS} recommended), "
        "so that plastic strain and residual stress depend on the grid. Reduce dz"
    )
    warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def warn_if_yield_unresolved(
    peak: State, last: State, setup: ContactSetup, few: int = MINIMUM_CELLS, *, stacklevel: int
) -> bool:
    """Warn if layers may be too thick to show yield below a contact; return True after a warning.

    The condition is that the contact pressure suffices for yield and that the half-width of the
    contact is less than `few` times dz.
    """
    grid = peak.grid
    if grid.dz is None or (hardest := peak.outline.largest) < setup.weakest:
        return False
    if peak.outline.reach * min(grid.dx, grid.dy) >= few * grid.dz * (1 + 1e-9):
        return False
    doubtful = [
        body.number
        for body in setup.plastic
        if hardest >= body.weakest and not last.max_equivalent_plastic_strain(body.number) > 0
    ]
    if not doubtful:
        return False
    spot = main_spot(peak.repulsion, grid.periodic)
    if spot is None:
        return False
    sizes = grid.dx, grid.dy
    half = 0.5 * min((s.stop - s.start) * d for s, d in zip(spot, sizes, strict=True))
    if half / grid.dz >= few:
        return False
    text = (
        f"body {doubtful[0]} appears elastic at load {peak.load:.6g} N because dz = "
        f"{quantity(grid.dz, 'm')} is too coarse to resolve the maximum stress, at a depth of "
        f"0.5 to {_MAX_STRESS_DEPTH} times the half-width {quantity(half, 'm')}: reduce dz"
    )
    warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def warn_of_step(state: State, setup: ContactSetup, *, stacklevel: int) -> bool:
    """Warn of poor resolution that more increments cannot improve; return True after a warning."""
    if math.isfinite(state.approach):
        if warn_of_contact(state, setup, MINIMUM_CELLS, stacklevel=stacklevel + 1):
            return True
        if warn_if_yield_unresolved(state, state, setup, 1, stacklevel=stacklevel + 1):
            return True
    for body, _, yielding in setup.plastic:
        strain = state.max_strains[body - 1][0]
        beyond = False
        for E, stress in yielding:
            beyond = beyond or strain * E > stress
        if beyond and warn_of_zone([state], body, MINIMUM_CELLS, stacklevel=stacklevel + 1):
            return True
    return False


def warn_of_run(states: Sequence[State], setup: ContactSetup, *, stacklevel: int) -> bool:
    """Warn if the grid does not resolve contact or plastic zones; return True after a warning."""
    solved = [state for state in states if math.isfinite(state.approach)]
    peak = max(solved, key=lambda state: state.load, default=None)
    if peak is not None and warn_of_contact(peak, setup, stacklevel=stacklevel + 1):
        return True
    moments = [peak, states[-1]] if peak is not None else list(states[-1:])
    warned = [
        warn_of_zone(moments, body, stacklevel=stacklevel + 1)
        for body in (1, 2)
        if moments and moments[-1].max_equivalent_plastic_strain(body) > 0
    ]
    if peak is not None:
        warned.append(warn_if_yield_unresolved(peak, states[-1], setup, stacklevel=stacklevel + 1))
    return any(warned)


def warn_of_sweep(dataset: xr.Dataset, *, stacklevel: int) -> None:
    """Warn, in one message, of all under-resolved cases of a sweep."""
    found = []
    for name, what in (
        ("cells_across_contact", f"fewer than {RECOMMENDED_CELLS} cells across the contact"),
        (
            "layers_across_plastic_zone_body1",
            f"fewer than {RECOMMENDED_CELLS} layers across the plastic zone of body 1",
        ),
        (
            "layers_across_plastic_zone_body2",
            f"fewer than {RECOMMENDED_CELLS} layers across the plastic zone of body 2",
        ),
    ):
        if name not in dataset:
            continue
        within = [dim for dim in dataset[name].dims if dim not in dataset["status"].dims]
        if count := int((dataset[name].max(within) < RECOMMENDED_CELLS).sum()):
            found.append(f"{count} with {what}")
    if found:
        text = (
            f"under-resolved cases, of {dataset['status'].size} cases: {', '.join(found)}; see "
            "cells_across_contact and layers_across_plastic_zone_bodyN"
        )
        warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)

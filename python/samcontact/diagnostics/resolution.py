# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a grid resolves a contact and the plastic zone below it, and elasticity carries it."""

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
from ..scene.contact_law import in_contact
from ..solutions.contact_area import AREA_OF_A_SIDE
from ..solutions.outline import Outline, outline_of
from ..solutions.strained_cells import strained_extent

if TYPE_CHECKING:
    import xarray as xr

    from ..solutions.contact_solution import ContactSolution
    from ..solutions.state import State
    from .hertz_estimate import ContactSetup

FEW = 8
"""Cells across a contact, and layers of a plastic zone, below which there is a warning."""
TOO_FEW = 4
"""Below this results are numbers of the grid: the check of a report fails."""
ROUND_SPOT = 16 / math.pi * AREA_OF_A_SIDE
"""That of a round spot, times its diameter in cells."""
UNCERTAIN, TOO_UNCERTAIN = 0.1, 0.2
"""Of the area of a contact of several spots: a warning, and the failed check of a report."""
LARGEST_STRAIN = 0.5
"""Of the largest pressure over E*: that of a Hertz contact with a/R = 0.8."""
_CLASSIC_DEPTH = 0.8
"""Depth of the largest von Mises stress over the half width: 0.48 (point) to 0.79 (line)."""


def warn_of_strain(
    solution: ContactSolution | State, scene: ContactSetup, *, stacklevel: int
) -> bool:
    """Warn of pressures that linear elasticity cannot carry; whether it did."""
    largest = solution.outline.largest
    share = largest / scene.E_star
    if not share > LARGEST_STRAIN:
        return False
    text = (
        f"the largest pressure, {quantity(largest, 'Pa')}, is {share:.3g} of the contact modulus "
        f"E*, more than {LARGEST_STRAIN}: slopes and strains of this size are beyond linear "
        "elasticity. Lengths are in metres, loads in newtons, moduli in pascals"
    )
    warnings.warn(text, ElasticStrainWarning, stacklevel=stacklevel + 1)
    return True


def main_spot(pressure: ArrayLike, periodic: str = "") -> tuple[slice, slice] | None:
    """Rows and columns of the spot (of touching cells) under the largest pressure.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        [Pa], >= 0.
    periodic : {"", "x", "y", "xy"}, optional
        As of a Grid: along these the spot is counted from the largest pressure in the middle.

    Returns
    -------
    pair of slice, or None without contact
    """
    labels, peak = _labelled(pressure, periodic)
    if not labels[peak]:
        return None
    rows, columns = scipy.ndimage.find_objects((labels == labels[peak]).astype(np.int8))[0]
    return rows, columns


def spots(pressure: ArrayLike, periodic: str = "") -> int:
    """How many spots of touching cells, also by a corner, there are; the arguments as before."""
    return int(_labelled(pressure, periodic)[0].max())


def _labelled(pressure: ArrayLike, periodic: str) -> tuple[NDArray[np.int32], tuple[int, int]]:
    """Numbers of the spots, and the cell of the largest pressure: in the middle where periodic."""
    field: FloatArray = np.asarray(pressure, dtype=np.float64)
    peak = divmod(int(field.argmax()), field.shape[1])
    shifts = [
        n // 2 - at if name in periodic else 0
        for name, at, n in zip("xy", peak, field.shape, strict=True)
    ]
    field = np.roll(field, shifts, (0, 1))
    labels: NDArray[np.int32]
    labels, _ = scipy.ndimage.label(in_contact(field), structure=np.ones((3, 3)))
    return labels, (peak[0] + shifts[0], peak[1] + shifts[1])


def cells_across(pressure: ArrayLike, periodic: str = "") -> float:
    """Cells across the contact: along the shorter side of the spot under the largest pressure.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        [Pa], >= 0.
    periodic : {"", "x", "y", "xy"}, optional
        As of a Grid: along these the spot is counted from the largest pressure in the middle.

    Returns
    -------
    float
        A whole number; NaN without contact. A side of the spot that spans the grid does not count:
        it is cut by the border, not by the cells.
    """
    spot = main_spot(pressure, periodic)
    if spot is None:
        return math.nan
    sides = [s.stop - s.start for s in spot]
    inside = [side for side, n in zip(sides, np.shape(pressure), strict=True) if side < n]
    return float(min(inside)) if inside else math.nan


def area_uncertainty(pressure: ArrayLike, periodic: str = "") -> float:
    """Relative uncertainty of a contact area whose spots are resolved coarsely.

    (pi - 1 + ln 2)/24 of the sides that cells in contact share with those that are not, over the
    cells in contact: what counting cells is wrong by, on average over directions, for spots with
    smooth outlines (Yastrebov, Anciaux and Molinari 2017, doi:10.1016/j.triboint.2017.04.023). A
    round spot has 0.6 over its diameter in cells.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        [Pa], >= 0.
    periodic : {"", "x", "y", "xy"}, optional
        As of a Grid.

    Returns
    -------
    float
        NaN without contact. The border of the grid is no side.
    """
    return _uncertainty(outline_of(pressure, periodic))


def _uncertainty(outline: Outline) -> float:
    return AREA_OF_A_SIDE * outline.sides / outline.cells if outline.cells else math.nan


def _is_wide(pressure: FloatArray) -> bool:
    """Whether `FEW` cells along x and y through the largest pressure are in contact; costs little.

    Then the spot is as wide; where not, it may still be.
    """
    i, j = divmod(int(pressure.argmax()), pressure.shape[1])
    around = (pressure[max(0, i - FEW) : i + FEW, j], pressure[i, max(0, j - FEW) : j + FEW])
    return all(_longest_run(in_contact(line)) >= FEW for line in around)


def _longest_run(inside: NDArray[np.bool_]) -> int:
    ends = np.flatnonzero(np.diff(np.concatenate(([0], inside.astype(np.int8), [0]))))
    return int(max(ends[1::2] - ends[::2], default=0))


def layers_across(equivalent: ArrayLike) -> float:
    """Layers from the top of a plastic zone to its bottom.

    Parameters
    ----------
    equivalent : array_like, shape (nx, ny, nz)
        Equivalent plastic strain [-].

    Returns
    -------
    float
        A whole number; NaN without plastic strain.
    """
    strained = np.flatnonzero(np.asarray(equivalent).any(axis=(0, 1)))
    return float(strained[-1] - strained[0] + 1) if strained.size else math.nan


def plastic_layers(extent: Sequence[tuple[int, int]]) -> float:
    """The same of what `strained_extent` finds."""
    return float(extent[2][1] - extent[2][0] + 1) if extent else math.nan


def warn_of_contact(
    solution: ContactSolution | State, scene: ContactSetup, few: int = FEW, *, stacklevel: int
) -> bool:
    """Warn when fewer than `few` cells lie across a contact, or its spots; whether it did."""
    pressure, grid = solution.repulsion, scene.grid
    outline = solution.outline
    share = _uncertainty(outline)
    thin = share > (UNCERTAIN if few >= FEW else TOO_UNCERTAIN)
    if not thin and 2 * outline.reach >= few:
        return False
    cell = lengths(grid.dx, grid.dy)
    if thin and (count := spots(pressure, grid.periodic)) > 1:
        text = (
            f"area is uncertain by about {100 * share:.0f} %, and the mean pressure with it: its "
            f"{count} spots are {ROUND_SPOT / share:.1f} cells across ({cell}). Take smaller "
            f"cells; with round spots of 8 it would be {100 * ROUND_SPOT / FEW:.0f} %"
        )
    elif not _is_wide(pressure) and (cells := cells_across(pressure, grid.periodic)) < few:
        text = (
            f"is only {cells:.0f} of {FEW} or more cells across ({cell}): its pressures depend on "
            f"the grid. {_remedy(solution, scene)}"
        )
    elif thin:
        width = 2 * AREA_OF_A_SIDE / share
        text = (
            f"is a ring, a line or the like, about {width:.1f} cells wide ({cell}): its pressures "
            f"depend on the grid, and its area is uncertain by about {100 * share:.0f} %. Take "
            "smaller cells; lengths are in metres"
        )
    else:
        return False
    told = f"at load {solution.load:.6g} N the contact {text}"
    warnings.warn(told, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def _remedy(solution: ContactSolution | State, scene: ContactSetup) -> str:
    expected = scene.hertz(load=solution.load)
    if expected is None:
        return "Take smaller cells; lengths are in metres"
    widest = quantity(2 * expected.semi_axes[1] / FEW, "m")
    return f"{expected}: take cells of at most {widest}. Lengths are in metres"


def warn_of_zone(states: Sequence[State], body: int, few: int = FEW, *, stacklevel: int) -> bool:
    """Warn when fewer than `few` layers lie across the plastic zone of a body; whether it did.

    In the state where it is highest: a moving body carries its strain out of the grid.
    """
    heights = [plastic_layers(strained_extent(state, body)) for state in states]
    layers = max((height for height in heights if height > 0), default=math.nan)
    if not layers < few:
        return False
    text = (
        f"the plastic zone of body {body} is only {layers:.0f} of {FEW} or more layers high "
        f"({quantity(states[0].grid.dz or 0.0, 'm')} each): its strains and residual stresses "
        "depend on the grid. Take thinner layers, a smaller dz"
    )
    warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def warn_of_unseen(
    peak: State, last: State, scene: ContactSetup, few: int = TOO_FEW, *, stacklevel: int
) -> bool:
    """Warn of layers that cannot show whether a body yields below a contact; whether it did.

    Where the contact presses hard enough and there are fewer than `few` layers in its half width.
    """
    grid = peak.grid
    if grid.dz is None or (hardest := peak.outline.largest) < scene.weakest:
        return False
    if peak.outline.reach * min(grid.dx, grid.dy) >= few * grid.dz * (1 + 1e-9):
        return False
    doubtful = [
        body.number
        for body in scene.plastic
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
        f"at load {peak.load:.6g} N body {doubtful[0]} does not yield, but the contact's half "
        f"width is {quantity(half, 'm')}, and the stress is largest at half to {_CLASSIC_DEPTH} of "
        f"that depth: the layers are too thick, dz = {quantity(grid.dz, 'm')}"
    )
    warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)
    return True


def warn_of_step(state: State, scene: ContactSetup, *, stacklevel: int) -> bool:
    """Warn of what no later increment can mend, since this may be the first of many; whether so."""
    if math.isfinite(state.approach):
        if warn_of_contact(state, scene, TOO_FEW, stacklevel=stacklevel + 1):
            return True
        if warn_of_unseen(state, state, scene, 1, stacklevel=stacklevel + 1):
            return True
    for body, _, yielding in scene.plastic:
        strain = state.largest_strains[body - 1][0]
        beyond = False
        for E, stress in yielding:
            beyond = beyond or strain * E > stress
        if beyond and warn_of_zone([state], body, TOO_FEW, stacklevel=stacklevel + 1):
            return True
    return False


def warn_of_run(states: Sequence[State], scene: ContactSetup, *, stacklevel: int) -> bool:
    """Warn when the grid does not resolve contact and plastic zones of a whole run; whether so."""
    solved = [state for state in states if math.isfinite(state.approach)]
    peak = max(solved, key=lambda state: state.load, default=None)
    if peak is not None and warn_of_contact(peak, scene, stacklevel=stacklevel + 1):
        return True
    moments = [peak, states[-1]] if peak is not None else list(states[-1:])
    warned = [
        warn_of_zone(moments, body, stacklevel=stacklevel + 1)
        for body in (1, 2)
        if moments and moments[-1].max_equivalent_plastic_strain(body) > 0
    ]
    if peak is not None:
        warned.append(warn_of_unseen(peak, states[-1], scene, stacklevel=stacklevel + 1))
    return any(warned)


def warn_of_sweep(dataset: xr.Dataset, *, stacklevel: int) -> None:
    """Warn of the cases of a sweep that their grids do not resolve, in one text."""
    found = []
    for name, what in (
        ("contact_cells", f"a contact of fewer than {FEW} cells across"),
        ("plastic_layers_body1", f"a plastic zone of body 1 of fewer than {FEW} layers"),
        ("plastic_layers_body2", f"a plastic zone of body 2 of fewer than {FEW} layers"),
    ):
        if name in dataset and (count := int((dataset[name].max("increment") < FEW).sum())):
            found.append(f"{count} with {what}")
    if found:
        text = (
            f"of {dataset['status'].size} cases there are {', '.join(found)}: see contact_cells "
            "and plastic_layers_bodyN of each"
        )
        warnings.warn(text, ResolutionWarning, stacklevel=stacklevel + 1)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of inclusions: outlines in sections, butterfly maps and Weibull plots."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FixedFormatter, FixedLocator, NullFormatter, NullLocator
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite, finite_array, require_type
from ..bodies.filled_shares import is_cut
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.inclusion import Inclusion
from ..bodies.material import Material
from ..inclusions.butterflies import ButterflyMap
from ..inclusions.weibull import WeibullFit
from .parts import axes_or_new, edges, finish, nearest, new_figure

if TYPE_CHECKING:
    from ..problem.grid import Grid
    from .contact_results import ContactResults

_OUTLINE: dict[str, Any] = {"color": "k", "linewidth": 1.1}
_VOID: dict[str, Any] = {"color": "k", "linewidth": 1.1, "linestyle": (0, (4, 2))}
_HATCH: dict[str, Any] = {"hatches": ["/////"], "colors": "none"}
_POINTS = 181  # of an outline
_FAILED = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 0.632, 0.9, 0.99)  # ticks of a Weibull plot


def inclusion_outlines(
    body: Heterogeneous,
    ax: Axes,
    *,
    plane: str = "y",
    position: float = 0.0,
    share: ArrayLike | None = None,
    grid: Grid | None = None,
) -> Axes:
    """Draw the outlines of inclusions into a section; outlines of voids are dashed.

    Parameters
    ----------
    body : Heterogeneous
        Body of the section.
    ax : matplotlib.axes.Axes
        Axes of the section, from `section`.
    plane : {"y", "x"}
        Coordinate that is constant on the section.
    position : float
        Value of the constant coordinate [m].
    share : array_like, shape (nx, ny, nz), optional
        Fraction of each cell that is filled by inclusions, from `State.share`. Partly filled cells
        are hatched, because their stress is a mean over inclusion and matrix.
    grid : Grid, optional
        Grid of `share`; required if `share` is given.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The plane is unknown, `share` has the wrong shape, or `share` is given but `grid` is missing
        or has no layers.
    TypeError
        The body is not heterogeneous.
    """
    require_type("body", body, Heterogeneous)
    choice("plane", plane, ("y", "x"))
    at = finite("position", position)
    if share is not None:
        if grid is None or grid.dz is None:
            raise ValueError(
                "if share is given, grid must be the grid of share, with layers (dz), got "
                f"{'none' if grid is None else 'a grid without dz'}"
            )
        given = finite_array("share", share)
        if given.ndim != 3 or given.shape[:2] != (grid.nx, grid.ny):
            raise ValueError(f"share must have shape ({grid.nx}, {grid.ny}, nz), got {given.shape}")
        _hatch(ax, given, grid, plane, at)
    for inclusion in body.inclusions:
        _outline(ax, inclusion, plane, at)
    return ax


def _hatch(ax: Axes, share: FloatArray, grid: Grid, plane: str, at: float) -> None:
    """Hatch the cells of a section that are partly filled by inclusions."""
    along_x = plane == "y"
    centres, step = (grid.x, grid.dx) if along_x else (grid.y, grid.dy)
    row = nearest(grid.y if along_x else grid.x, at)
    cut = is_cut(share[:, row] if along_x else share[row])
    if not cut.any():
        return
    assert grid.dz is not None
    depths = grid.dz * np.arange(share.shape[2] + 1)
    across = edges(np.asarray(centres), step)
    sides = [np.repeat(side * 1e6, 2)[1:-1] for side in (across, depths)]
    cells = np.repeat(np.repeat(cut.astype(float), 2, axis=0), 2, axis=1)
    limits = ax.get_xlim(), ax.get_ylim()
    ax.contourf(*sides, cells.T, levels=[0.5, 1.5], **_HATCH)
    ax.set(xlim=limits[0], ylim=limits[1])


def _outline(ax: Axes, inclusion: Inclusion, plane: str, at: float) -> None:
    """Draw the ellipse along which a plane cuts an inclusion, if the plane cuts the inclusion."""
    q = inclusion.metric()
    n = 1 if plane == "y" else 0
    shown = [0, 2] if plane == "y" else [1, 2]
    offset = at - inclusion.center[n]
    inner = q[np.ix_(shown, shown)]
    toward = np.linalg.solve(inner, q[shown, n])
    rest = 1.0 - offset**2 * (q[n, n] - q[n, shown] @ toward)
    if rest <= 0.0:
        return
    angle = np.linspace(0.0, 2 * math.pi, _POINTS)
    circle = math.sqrt(rest) * np.stack([np.cos(angle), np.sin(angle)])
    line = np.linalg.solve(np.linalg.cholesky(inner).T, circle) - (offset * toward)[:, None]
    middle = np.array(inclusion.center)[shown]
    x, z = (line + middle[:, None]) * 1e6
    below = np.where(z >= 0.0, z, np.nan)  # a part above the surface is not in the body
    ax.plot(x, below, scalex=False, scaley=False, **(_VOID if inclusion.is_void else _OUTLINE))


def outline_in_section(results: ContactResults, ax: Axes, y: float, number: int) -> None:
    """Draw the outlines of the inclusions of a body into a section along x.

    Nothing is drawn if the body has no inclusions or has moved. results: results, with the body to
    be shown. y: position of the section [m]. number: number of the increment.
    """
    dataset, name = results.dataset, f"body{results.body}"
    if f"inclusion_center_{name}" not in dataset or results.track is not None:
        return
    if np.any(dataset.get(f"travel_{name}", 0.0)):
        return
    centers, radii, axes, moduli = (
        dataset[f"inclusion_{part}_{name}"].values for part in ("center", "radii", "axes", "E")
    )
    if results.has("share", number):
        _hatch(ax, results.field("share", number), results.grid, "y", y)
    for center, size, turned, E in zip(centers, radii, axes, moduli, strict=True):
        material = Material.elastic(E, 0.3) if 0 < E < np.inf else None
        _outline(ax, Inclusion(center, size, turned, material), "y", y)


def butterfly(of: ButterflyMap, ax: Axes | None = None) -> Axes:
    """Draw a butterfly map: a fatigue criterion versus the direction from the inclusion centres.

    Around each inclusion, the criterion is divided by its maximum around this inclusion; the line
    shows the mean of all inclusions. Bars show in which directions the maxima lie: the length of a
    bar is proportional to the number of inclusions with their maximum in the sector of the bar, and
    the longest bar has the length 1.

    Parameters
    ----------
    of : ButterflyMap
        Map from `samcontact.inclusions.butterflies`.
    ax : matplotlib.axes.Axes, optional
        Polar axes to draw on; default: a new figure. The rolling direction is to the right, the
        surface at the top.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    TypeError
        `of` is not a `ButterflyMap`, or the axes are not polar.
    """
    require_type("of", of, ButterflyMap)
    if ax is None:
        ax = new_figure(4.2, 4.2).add_subplot(projection="polar")
    if ax.name != "polar":
        raise TypeError(f"ax must be polar axes, got {ax.name!r}")
    width = 2 * math.pi / len(of.angle)
    share = np.asarray(of.count) / max(int(of.count.max()), 1)
    ax.bar(of.angle, share, width=width, color="C0", alpha=0.5, label="places of the maxima")
    ring = np.append(of.angle, of.angle[0])
    ax.plot(ring, np.append(of.relative, of.relative[0]), color="C3", linewidth=1.2,
            label="criterion, mean of all")  # fmt: skip
    ax.set_ylim(0.0, 1.05)
    ax.set_yticks([0.5, 1.0])
    ax.set_xticks(np.radians([0, 45, 90, 135, 180, 225, 270, 315]))
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, -0.28), frameon=False, fontsize="small")
    ax.set_title(f"{len(of.numbers)} inclusions, surface at the top", fontsize="medium")
    return ax


def weibull(
    fits: WeibullFit | Mapping[str, WeibullFit] | Sequence[WeibullFit],
    ax: Axes | None = None,
    *,
    confidence: float = 0.9,
    label: str = "life",
) -> Axes:
    """Draw lives, fitted Weibull distributions and confidence bands on Weibull paper.

    Parameters
    ----------
    fits : WeibullFit, or sequence or mapping of them
        Distributions from `samcontact.inclusions.weibull_fit`. The keys of a mapping are shown in
        the legend.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    confidence : float, optional
        Confidence level of the bands [-], in (0, 1). Default: 0.9.
    label : str, optional
        Label of the axis of lives, with the unit of the lives.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        `confidence` is not between 0 and 1.
    TypeError
        `fits` is not a `WeibullFit`, or contains another object.
    """
    named = _named(fits)
    ax = axes_or_new(ax)
    share = np.array([0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.99])
    for number, (name, fit) in enumerate(named.items()):
        require_type("fits", fit, WeibullFit)
        colour = f"C{number}"
        ax.plot(fit.lives, _paper(fit.median_ranks), "o", color=colour, markersize=3.5)
        text = f"{name}, " if name else ""
        ax.plot([fit.life(float(f)) for f in share], _paper(share), color=colour, linewidth=1.2,
                label=f"{text}slope {fit.shape:.3g}")  # fmt: skip
        band = np.array([fit.life_interval(float(f), confidence) for f in share])
        ax.fill_betweenx(_paper(share), band[:, 0], band[:, 1], color=colour, alpha=0.15,
                         linewidth=0)  # fmt: skip
    ax.set_xscale("log")
    ticks = np.array(_FAILED)
    ax.yaxis.set_major_locator(FixedLocator(_paper(ticks).tolist()))
    ax.yaxis.set_major_formatter(FixedFormatter([f"{100 * f:g}" for f in ticks]))
    ax.yaxis.set_minor_locator(NullLocator())
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.set_ylim(*_paper(np.array([0.009, 0.993])))
    ax.set(xlabel=label, ylabel="failed [%]")
    ax.legend(frameon=False, fontsize="small")
    return finish(ax)


def _named(
    fits: WeibullFit | Mapping[str, WeibullFit] | Sequence[WeibullFit],
) -> Mapping[str, WeibullFit]:
    if isinstance(fits, Mapping):
        return fits
    several = [fits] if isinstance(fits, WeibullFit) else list(fits)
    return {str(n) if len(several) > 1 else "": fit for n, fit in enumerate(several, 1)}


def _paper(failed: FloatArray) -> FloatArray:
    """Return the ordinate of Weibull paper, ln(-ln(1 - failed)); failed: failed fraction [-]."""
    return np.log(-np.log1p(-failed))

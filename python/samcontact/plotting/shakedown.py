# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of shakedown.

Like `samcontact.plotting`, which offers these functions too: each takes an `ax` and returns it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .. import shakedown
from .._util.checks import choice, poisson_ratio
from .parts import axes_or_new, finish
from .ticks import FittedLocator

if TYPE_CHECKING:
    from ..shakedown import Limit, ShakedownResult

_FRICTION = np.linspace(0.0, 0.6, 31)


def shakedown_map(ax: Axes | None = None, *, contact: str = "line", nu: float = 0.3) -> Axes:
    """Limits of shakedown by friction: what a pressure does at first, and in the end.

    Parameters
    ----------
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    contact : {"line", "point"}
        A line contact, whose limits are exact; or a circle, with bounds of perfect plasticity.
    nu : float, optional
        Poisson's ratio.

    Returns
    -------
    matplotlib.axes.Axes
        p0/k by the coefficient of friction, k being the yield stress in shear, with von Mises'
        criterion; dashed with Tresca's, or the lower bound. A dot where the surface begins to
        decide.

    Raises
    ------
    ValueError
        Another contact, or a Poisson's ratio outside [0, 0.5].
    """
    nu, ax = poisson_ratio("nu", nu), axes_or_new(ax)
    curves: list[tuple[str, str, Callable[[float], Limit]]]
    if choice("contact", contact, ("line", "point")) == "line":
        curves = [
            (
                "shakedown, kinematic hardening",
                "tab:blue",
                lambda m: shakedown.line_kinematic(m, nu),
            ),
            (
                "shakedown, perfectly plastic",
                "tab:red",
                lambda m: shakedown.line(m, nu, "von_mises"),
            ),
            ("the same, Tresca", "--tab:red", lambda m: shakedown.line(m, nu)),
            ("first yield", "0.3", lambda m: shakedown.first_yield(m, nu, "von_mises")),
        ]
    else:
        curves = [
            ("shakedown, kinematic hardening", "tab:blue",
             lambda m: shakedown.point_kinematic(m, nu)),
            ("shakedown, perfectly plastic, at most", "tab:red", lambda m: shakedown.point(m, nu)),
            ("the same, at least", "--tab:red", lambda m: shakedown.point_safe(m, nu)),
        ]  # fmt: skip
    for label, colour, function in curves:
        limits = [function(float(mu)) for mu in _FRICTION]
        ratios = np.array([limit.ratio for limit in limits])
        style = "--" if colour.startswith("--") else "-"
        colour = colour.removeprefix("--")
        ax.plot(_FRICTION, ratios, style, color=colour, label=label)
        at_surface = [limit.depth == 0.0 for limit in limits]
        if any(at_surface):
            first = at_surface.index(True)
            ax.plot(_FRICTION[first], ratios[first], "o", color=colour, markersize=4)
    ax.set(xlabel="coefficient of friction", ylabel="largest pressure / yield stress in shear")
    ax.set(xlim=(0.0, _FRICTION[-1]), ylim=(0.0, 5.0))
    ax.legend(frameon=False, fontsize="small", loc="lower left")
    return finish(ax)


def strain_per_cycle(
    result: ShakedownResult, ax: Axes | None = None, *, label: str | None = None
) -> Axes:
    """How much plastic strain each cycle leaves, and how much flows in it.

    Parameters
    ----------
    result : ShakedownResult
        Of `shakedown.run`.
    ax : matplotlib.axes.Axes, optional
        Where to draw; of several results each has its own colour.
    label : str, optional
        Of the curves; default the verdict.

    Returns
    -------
    matplotlib.axes.Axes
        Over the yield strain, on a logarithmic scale: flow dashed, what is left solid, dots where a
        cycle was solved and gaps where it was extrapolated.
    """
    return draw_cycles(
        [cycle.number for cycle in result.cycles],
        [cycle.net / result.yield_strain for cycle in result.cycles],
        [cycle.flow / result.yield_strain for cycle in result.cycles],
        result.verdict if label is None else label,
        axes_or_new(ax),
    )


def draw_cycles(numbers: ArrayLike, net: ArrayLike, flow: ArrayLike, label: str, ax: Axes) -> Axes:
    """`strain_per_cycle` of strains over the yield strain."""
    (line,) = ax.plot(numbers, net, "o-", markersize=3, label=label)
    ax.plot(numbers, flow, "--", color=line.get_color(), linewidth=1)
    ax.set_yscale("log")
    ax.xaxis.set_major_locator(FittedLocator(integer=True))
    ax.set(xlabel="cycle", ylabel="plastic strain in a cycle / yield strain")
    ax.legend(frameon=False, fontsize="small")
    return finish(ax)

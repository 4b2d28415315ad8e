# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of shakedown.

The functions are also available from `samcontact.plotting`. Each draws on the axes `ax` and returns
them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .. import shakedown
from .._util.checks import choice, poisson_ratio
from .parts import axes_or_new, finish
from .ticks import FittedLocator

if TYPE_CHECKING:
    from ..shakedown import ShakedownLimit, ShakedownResult

_FRICTION = np.linspace(0.0, 0.6, 31)


def shakedown_map(ax: Axes | None = None, *, contact: str = "line", nu: float = 0.3) -> Axes:
    """Draw the shakedown map: limits of the Hertz pressure versus the coefficient of friction.

    Parameters
    ----------
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    contact : {"line", "point"}
        Line contact, with exact limits; or circular point contact, with upper and lower bounds for
        perfect plasticity.
    nu : float, optional
        Poisson's ratio.

    Returns
    -------
    matplotlib.axes.Axes
        Axes with p0/k versus the coefficient of friction, where k is the shear yield stress by the
        von Mises criterion. A dashed line shows the limit by the Tresca criterion (line contact) or
        the lower bound (point contact). On each curve, a dot marks the coefficient of friction
        above which the limit is determined by the stress at the surface.

    Raises
    ------
    ValueError
        The contact is unknown, or Poisson's ratio is outside [0, 0.5].
    """
    nu, ax = poisson_ratio("nu", nu), axes_or_new(ax)
    curves: list[tuple[str, str, Callable[[float], ShakedownLimit]]]
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
            ("shakedown, perfectly plastic (Tresca)", "--tab:red", lambda m: shakedown.line(m, nu)),
            ("first yield", "0.3", lambda m: shakedown.first_yield(m, nu, "von_mises")),
        ]
    else:
        curves = [
            ("shakedown, kinematic hardening", "tab:blue",
             lambda m: shakedown.point_kinematic(m, nu)),
            ("shakedown, perfectly plastic (upper bound)", "tab:red",
             lambda m: shakedown.point(m, nu)),
            ("shakedown, perfectly plastic (lower bound)", "--tab:red",
             lambda m: shakedown.point_lower_bound(m, nu)),
        ]  # fmt: skip
    # All limits for one friction in turn: they share the stresses below the contact.
    table = [[function(float(mu)) for _, _, function in curves] for mu in _FRICTION]
    for (label, colour, _), limits in zip(curves, zip(*table, strict=True), strict=True):
        ratios = np.array([limit.ratio for limit in limits])
        style = "--" if colour.startswith("--") else "-"
        colour = colour.removeprefix("--")
        ax.plot(_FRICTION, ratios, style, color=colour, label=label)
        at_surface = [limit.depth == 0.0 for limit in limits]
        if any(at_surface):
            first = at_surface.index(True)
            ax.plot(_FRICTION[first], ratios[first], "o", color=colour, markersize=4)
    ylabel = "maximum Hertz pressure /\nshear yield stress, $p_0/k$ [-]"
    ax.set(xlabel="coefficient of friction [-]", ylabel=ylabel)
    ax.set(xlim=(0.0, _FRICTION[-1]), ylim=(0.0, 5.0))
    ax.legend(frameon=False, fontsize="small", loc="lower left")
    return finish(ax)


def strain_per_cycle(
    result: ShakedownResult, ax: Axes | None = None, *, label: str | None = None
) -> Axes:
    """Draw net plastic strain and plastic flow of each cycle.

    The net plastic strain is the change of the plastic strain over a cycle; the plastic flow is the
    equivalent plastic strain added by the cycle. Both quantities are maxima over the body, divided
    by the yield strain.

    Parameters
    ----------
    result : ShakedownResult
        Result of `shakedown.run`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure. Several results on the same axes have different
        colours.
    label : str, optional
        Label of the curve of net plastic strain; default: name of the long-term response.

    Returns
    -------
    matplotlib.axes.Axes
        Axes with strains relative to the yield strain, on a logarithmic scale. Solid lines show the
        net plastic strain, dashed lines the plastic flow. Dots mark solved cycles; extrapolated
        cycles have no dots.
    """
    return draw_cycles(
        [cycle.number for cycle in result.cycles],
        [cycle.net / result.yield_strain for cycle in result.cycles],
        [cycle.flow / result.yield_strain for cycle in result.cycles],
        result.response if label is None else label,
        axes_or_new(ax),
    )


def draw_cycles(numbers: ArrayLike, net: ArrayLike, flow: ArrayLike, label: str, ax: Axes) -> Axes:
    """Draw the curves of `strain_per_cycle`; `net` and `flow` are divided by the yield strain."""
    (line,) = ax.plot(numbers, net, "o-", markersize=3, label=label)
    dashed: dict[str, Any] = {
        "color": line.get_color(),
        "linewidth": 1,
        "label": "flow in the cycle",
    }
    ax.plot(numbers, flow, "--", **dashed)
    ax.set_yscale("log")
    ax.xaxis.set_major_locator(FittedLocator(integer=True))
    ax.set(xlabel="cycle", ylabel="plastic strain per cycle / yield strain [-]")
    ax.legend(frameon=False, fontsize="small")
    return finish(ax)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of steady sliding over viscoelastic bodies.

The functions are also available from `samcontact.plotting`: each takes an `ax` and returns it.
"""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._util.checks import finite_array
from .parts import axes_or_new

_AREA_COLOUR = "tab:orange"


def friction_curve(
    velocity: ArrayLike,
    friction: ArrayLike,
    ax: Axes | None = None,
    *,
    contact_share: ArrayLike | None = None,
    label: str | None = None,
) -> Axes:
    """Draw the friction coefficient versus the sliding velocity, on a logarithmic axis.

    Parameters
    ----------
    velocity : array_like, shape (n,)
        Velocities [m/s]; the sign is not shown, and velocity 0 has no place on the axis.
    friction : array_like, shape (n,)
        Friction coefficients [-].
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    contact_share : array_like, shape (n,), optional
        Contact area over the area of the surface [-], drawn on a second axis on the right.
    label : str, optional
        Label of the friction curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The arrays have different lengths, or no velocity differs from 0.
    """
    count = np.size(velocity)
    v, mu = (
        finite_array(name, values, (count,))
        for name, values in (("velocity", velocity), ("friction", friction))
    )
    moving = v != 0
    if not moving.any():
        raise ValueError(f"velocity must have values other than 0, got {v.tolist()!r:.80}")
    ax = axes_or_new(ax)
    order = np.argsort(np.abs(v[moving]))
    speeds = np.abs(v[moving])[order]
    ax.semilogx(speeds, mu[moving][order], "o-", markersize=3, linewidth=1.2, label=label)
    if label is not None:
        ax.legend(frameon=False)
    if contact_share is not None:
        share = finite_array("contact_share", contact_share, (count,))
        right = ax.twinx()
        right.semilogx(speeds, 100 * share[moving][order], "s--", markersize=3, color=_AREA_COLOUR)
        right.set_ylabel("contact area [% of the surface]", color=_AREA_COLOUR)
        right.set_ylim(bottom=0.0)
    ax.set_xlabel("sliding velocity [m/s]")
    ax.set_ylabel("friction coefficient [-]")
    ax.set_ylim(bottom=min(0.0, float(mu.min())))
    ax.grid(True, linewidth=0.4, alpha=0.5)
    ax.set_axisbelow(True)
    return ax

# SPDX-License-Identifier: GPL-3.0-or-later
"""Animation of partial slip, with a plot of the tangential force."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.animation import FuncAnimation
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from .._util.checks import FloatArray, positive
from .._util.quantities import CONTACT
from ..solutions.state import on_common_grid
from .parts import MIN_LONG_CONTACT_RATIO, finish, new_figure
from .slipping import partial_slip_map

if TYPE_CHECKING:
    from ..problem.grid import Grid
    from ..solutions.state import State

_CONTACT_MARGIN = 0.15  # margin around the contact, relative to its size


class ForceHistory(NamedTuple):
    """Displacement and force of all increments in the units of the figure, and the axis labels."""

    across: FloatArray
    force: FloatArray
    labels: tuple[str, str]


def partial_slip_animation(states: Sequence[State], *, interval: float = 100.0) -> FuncAnimation:
    """Animate partial slip, with a plot of tangential force against displacement.

    For rolling bodies, the force is plotted against the distance rolled.

    Parameters
    ----------
    states : sequence of State
        States in the order of the path, from a simulation with `Coulomb` friction.
    interval : float, optional
        Interval between frames during playback [ms], > 0.

    Returns
    -------
    matplotlib.animation.FuncAnimation
        Animation for `save_animation`, or ``to_jshtml()`` in a notebook. Assign it to a variable:
        Matplotlib deletes animations that no variable refers to.

    Raises
    ------
    ValueError
        `states` is empty, no state is in contact, friction is a constant coefficient (full
        sliding), or `interval` is not positive.
    """
    if len(states) == 0:
        raise ValueError("states must contain at least one state, got none")
    positive("interval", interval)
    states = on_common_grid(states)
    grid, course = states[0].grid, course_of(states)
    limits = _limits(states, grid)
    lies = bool(np.ptp(limits[1]) > MIN_LONG_CONTACT_RATIO * np.ptp(limits[0]))
    across = "y" if lies else "x"
    figure = new_figure(7.0, 4.8) if lies else new_figure(9.0, 4.0)
    left, right = figure.subplots(2, 1) if lies else figure.subplots(1, 2)
    point = _course_panel(right, course)

    def draw(number: int) -> list[Any]:
        state = states[number]
        left.clear()
        partial_slip_map(state.repulsion, state.slip, grid, left, unit="m", across=across)
        left.set(xlim=limits[lies], ylim=limits[0][::-1] if lies else limits[1])
        right.set_title(f"load {state.load:.4g} N", fontsize="medium")
        point.set_data([course.across[number]], [course.force[number]])
        return [left, point]

    draw(0)
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # panels must not move between frames
    return FuncAnimation(
        figure, draw, frames=len(states), interval=interval, cache_frame_data=False, blit=False
    )


def course_of(states: Sequence[State]) -> ForceHistory:
    """Return displacement and force in the direction, x or y, in which the force is larger.

    If there is no tangential force, twist and torque are returned instead. For rolling bodies, the
    displacement is replaced by the distance rolled.
    """
    forces = np.array([state.tangential_load for state in states])
    motions = np.array([state.shift for state in states])
    direction = int(np.argmax(np.abs(forces).max(axis=0)))
    name = "xy"[direction]
    largest = max(state.load for state in states)
    if np.abs(forces).max() > 1e-8 * largest:
        force, motion = f"tangential_load_{name}", f"shift_{name}"
        pull, moved = forces[:, direction], motions[:, direction]
    else:
        force, motion = "torque", "twist"
        pull = np.array([state.torque for state in states])
        moved = np.array([state.twist for state in states])
    up, along = CONTACT[force], CONTACT[motion]
    label = along.label
    travels = -np.mean([state.travel for state in states], axis=1)
    if travels.any():
        moved, along, label = travels, CONTACT["travel"], "distance rolled [µm]"
    return ForceHistory(moved * along.factor, pull * up.factor, (label, up.label))


def _limits(states: Sequence[State], grid: Grid) -> list[tuple[float, float]]:
    """Return the limits along x and y [µm] of a region that contains the contacts of all states."""
    touched = np.any([state.in_contact for state in states], axis=0)
    if not touched.any():
        raise ValueError("states must contain at least one state in contact, got none")
    found = []
    for centres, cell, axis in ((grid.x, grid.dx, 1), (grid.y, grid.dy, 0)):
        there = np.asarray(centres)[touched.any(axis=axis)]
        margin = _CONTACT_MARGIN * float(np.ptp(there)) + 2 * cell
        found.append(((there[0] - margin) * 1e6, (there[-1] + margin) * 1e6))
    return found


def _course_panel(ax: Axes, course: ForceHistory) -> Line2D:
    """Draw the forces of all states as a thin line; return the marker for the current state."""
    ax.plot(course.across, course.force, "-", linewidth=0.8, color="0.6")
    (point,) = ax.plot([], [], "o", color="C3")
    ax.set_xlabel(course.labels[0])
    ax.set_ylabel(course.labels[1])
    finish(ax)
    return point

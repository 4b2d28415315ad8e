# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of contacts with partial slip.

The functions are also available from `samcontact.plotting`. Each draws on the axes `ax` and returns
them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array, non_negative
from .._util.quantities import CONTACT
from ..problem.contact_law import in_contact
from ..problem.friction import Coulomb, FrictionLaw, friction_law, law_of_attributes
from ..results.contact import rubbing_pressure_of
from .fields import Plane, clip, inside_of_contact, inside_of_slip, name_sides, outline
from .parts import axes_or_new, edges, finish, prefixed, surface_line
from .shown import require_possible

if TYPE_CHECKING:
    import xarray as xr

    from ..problem.grid import Grid

STICK_AND_SLIP_COLOURS = "#9ecae1", "#fdae6b"
"""Colours of the stick zone and of the slip zone."""
_ARROWS_PER_SIDE = 15  # number along the longer side of the contact
_MAX_ARROW_LENGTH = 0.95  # maximum length of an arrow, relative to the distance between arrows
_SLIP_UNITS = {"1": "of the distance rolled", None: ""}
FORCE_AND_MOTION = {"x": ("tangential_load_x", "shift_x"), "y": ("tangential_load_y", "shift_y"),
               "z": ("torque", "twist")}  # fmt: skip


def partial_slip_map(
    pressure: ArrayLike,
    slip: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    unit: str | None = None,
    across: str = "x",
) -> Axes:
    """Draw a map of stick and slip zones, with arrows for the slip.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        Pressure [Pa] or, with adhesion, repulsion [Pa]; the map is white where this field is zero.
    slip : array_like, shape (2, nx, ny)
        Slip of body 1 relative to body 2, e.g. of a `State` or a solution; zero in the stick zone.
        The length of the arrows is proportional to the slip; the title states the maximum slip.
    grid : Grid
        Grid of both fields.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    unit : {"m", "1"}, optional
        Unit of the slip for the title: "m" for a `State`, "1" (per distance rolled) for a
        `RollingSolution`. If omitted, the title states the maximum slip without a unit.
    across : {"x", "y"}, optional
        Coordinate that runs from left to right. "y" rotates the map by 90°, with x downward, for
        contacts that are long along y.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A field has the wrong shape, or `unit` or `across` is unknown.
    """
    if unit is not None:
        choice("unit", unit, ("m", "1"))
    choice("across", across, ("x", "y"))
    shape = (grid.nx, grid.ny)
    pressed = finite_array("pressure", pressure, shape)
    touching = in_contact(pressed)
    moved = np.where(touching, finite_array("slip", slip, (2, *shape)), 0.0)
    plane = Plane(edges(grid.x, grid.dx), edges(grid.y, grid.dy))
    if across == "y":
        plane, pressed, moved = Plane(*plane[::-1]), pressed.T, moved[::-1].transpose(0, 2, 1)
    ax = axes_or_new(ax)
    ax.grid(False)
    if touching.any():
        _kinds(ax, np.hypot(*moved), np.maximum(pressed, 0.0), plane)
    largest = _arrows(ax, moved, in_contact(pressed), plane)
    handles = [Patch(color=colour, label=label) for colour, label in zip(
        STICK_AND_SLIP_COLOURS, ("stick", "slip"), strict=True)]  # fmt: skip
    ax.legend(handles=handles, loc="upper right", fontsize="small", framealpha=0.85, borderpad=0.3)
    factor, name = prefixed(largest, "m") if unit == "m" else (1.0, _SLIP_UNITS[unit])
    title = f"maximum slip {largest * factor:.3g} {name}".rstrip() if largest > 0 else "no slip"
    ax.set_title(title, fontsize="medium")
    ax.set_aspect("equal")
    return name_sides(ax, across)


def _kinds(ax: Axes, slip: FloatArray, pressure: FloatArray, plane: Plane) -> None:
    """Draw the stick zone and the slip zone in their colours, with the contact edge."""
    inside, slips = inside_of_contact(pressure), inside_of_slip(slip, in_contact(pressure))
    levels = [slips.min() - 1.0, 0.0, slips.max() + 1.0]
    parts = ax.contourf(*plane.smooth(slips), levels=levels, colors=STICK_AND_SLIP_COLOURS)
    clip(ax, [parts], plane, inside)
    outline(ax, plane, inside)


def _arrows(ax: Axes, slip: FloatArray, touching: np.ndarray[Any, Any], plane: Plane) -> float:
    """Draw the slip as arrows in regularly spaced cells, and return the maximum slip."""
    size: FloatArray = np.hypot(*slip)
    largest = float(size.max(initial=0.0))
    if not largest > 0:
        return 0.0
    cells = np.argwhere(touching)
    size_of_cell = np.array([side[1] - side[0] for side in plane])
    sides = (np.ptp(cells, axis=0) + 1) * size_of_cell
    several = np.array(touching.shape) > 1  # not along the period of a line contact
    spacing = max(float(sides[several].max()) / _ARROWS_PER_SIDE, *size_of_cell[several])
    every = [max(round(spacing / d), 1) for d in size_of_cell]
    middle = cells.mean(axis=0).round().astype(int)
    shown = np.zeros(touching.shape, dtype=bool)
    shown[middle[0] % every[0] :: every[0], middle[1] % every[1] :: every[1]] = True
    shown &= size > 0.02 * largest
    i, j = np.nonzero(shown)
    ax.quiver(
        plane.across[i] * 1e6 + 0.5e6 * size_of_cell[0],
        plane.down[j] * 1e6 + 0.5e6 * size_of_cell[1],
        slip[0][shown] / largest,
        slip[1][shown] / largest,
        angles="xy",
        scale_units="xy",
        scale=1e-6 / (_MAX_ARROW_LENGTH * spacing),
        width=0.004,
        color="k",
        pivot="mid",
    )
    return largest


def shear_profile(
    pressure: ArrayLike,
    shear: ArrayLike,
    grid: Grid,
    friction: float | FrictionLaw,
    ax: Axes | None = None,
    *,
    component: str = "x",
    axis: str = "x",
    position: float = 0.0,
    label: str = "shear",
) -> Axes:
    """Draw the shear traction along an axis, with the limits set by friction in both directions.

    Parameters
    ----------
    pressure, shear : array_like, shapes (nx, ny) and (2, nx, ny)
        Pressure, and shear traction on body 2 [Pa].
    grid : Grid
        Grid of both fields.
    friction : float or Coulomb
        Coefficient of friction >= 0 [-], or a friction law; with `math.inf`, no limits are drawn.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    component : {"x", "y"}
        Component of the shear traction.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Position of the profile [m]: y for a profile along x, x for a profile along y. The nearest
        row of cells is used.
    label : str
        Label of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A field has the wrong shape, `component` or `axis` is unknown, or a pressure is negative.
    """
    choice("component", component, ("x", "y"))
    shape = (grid.nx, grid.ny)
    fields = finite_array("shear", shear, (2, *shape))
    pressed = finite_array("pressure", pressure, shape)
    require_possible("pressure", pressed, CONTACT["pressure"], grid)
    s, p = surface_line(pressed, "pressure", grid, axis, position)
    _, values = surface_line(fields["xy".index(component)], "shear", grid, axis, position)
    ax = axes_or_new(ax)
    shown = CONTACT["shear_x"]
    ax.plot(s * 1e6, values * shown.factor, "o-", markersize=3, linewidth=1.2, label=label)
    law = friction_law(friction, Coulomb)
    if not law.prevents_slip:
        bound = law.bound(p) * shown.factor
        for sign, name in ((1, "friction limit"), (-1, "_other side")):
            ax.plot(s * 1e6, sign * bound, "k--", linewidth=0.8, label=name)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    ax.set_xlabel(f"{axis} [µm]")
    ax.set_ylabel(f"shear traction, {component} [{shown.shown}]")
    return finish(ax)


def fretting_loop(
    dataset: xr.Dataset, ax: Axes | None = None, *, direction: str = "x", label: str | None = None
) -> Axes:
    """Draw tangential force versus displacement, with the frictional work in the title.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results with partial slip, from `samcontact.results.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    direction : {"x", "y", "z"}
        "x", "y": force and displacement along this axis; "z": torque and twist about z.
    label : str, optional
        Label of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The direction is unknown, or the results are from full sliding.
    """
    force, motion = FORCE_AND_MOTION[choice("direction", direction, tuple(FORCE_AND_MOTION))]
    require_slip(dataset)
    ax = axes_or_new(ax)
    distance, pull = (
        np.append(0.0, dataset[n].values) * CONTACT[n].factor for n in (motion, force)
    )
    ax.plot(distance, pull, "o-", markersize=3, linewidth=1.0, label=label)
    work = float(dataset["friction_work"].values[-1])
    factor, unit = prefixed(work, "J")
    ax.set_title(f"frictional work {work * factor:.4g} {unit}", fontsize="medium")
    ax.set_xlabel(CONTACT[motion].label)
    ax.set_ylabel(CONTACT[force].label)
    if label is not None:
        ax.legend(frameon=False)
    return finish(ax)


def creep_curve(
    creepage: ArrayLike,
    force: ArrayLike,
    ax: Axes | None = None,
    *,
    largest: float | None = None,
    label: str | None = None,
) -> Axes:
    """Draw the tangential force of a rolling contact versus the creepage.

    Parameters
    ----------
    creepage : array_like, shape (n,)
        Creepage: rigid-body slip per distance rolled [-].
    force : array_like, shape (n,)
        Tangential force [N].
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    largest : float, optional
        Force at full sliding (coefficient of friction times load) [N]; drawn as a dashed line for
        each sign of the force that occurs.
    label : str, optional
        Label of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The arrays have different lengths.
    """
    count = np.size(creepage)
    xi, pulls = (
        finite_array(name, values, (count,))
        for name, values in (("creepage", creepage), ("force", force))
    )
    ax = axes_or_new(ax)
    ax.plot(xi * 100, pulls, "o-", markersize=3, linewidth=1.2, label=label)
    if largest is not None:
        _bounds(ax, pulls, non_negative("largest", largest))
    if largest is not None or label is not None:
        ax.legend(frameon=False)
    ax.set_xlabel("creepage [%]")
    ax.set_ylabel("tangential force [N]")
    return finish(ax)


def _bounds(ax: Axes, forces: FloatArray, largest: float) -> None:
    """Draw lines at the force of full sliding: one for each sign of the force that occurs."""
    small = 1e-6 * np.abs(forces).max(initial=0.0)
    sides = [side for side in (-1, 1) if np.any(side * forces > small)]
    for side in sides:
        text = "friction limit" if side == sides[0] else "_other side"
        ax.axhline(side * largest, color="k", linestyle="--", linewidth=0.8, label=text)
    ax.margins(y=0.08)


def rolling_force(dataset: xr.Dataset, ax: Axes | None = None, *, direction: str = "x") -> Axes:
    """Draw the tangential force versus the distance rolled under load.

    The line is interrupted at increments without load, so that each pass has its own line.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of rolling with partial slip.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    direction : {"x", "y"}
        Direction of the force.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The direction is unknown, or the results are from full sliding or from bodies that do not
        move through the contact.
    """
    require_slip(dataset)
    choice("direction", direction, ("x", "y"))
    if "travel_body1" not in dataset:
        raise ValueError(
            "dataset must be from a run with rolling bodies, got results without travel_body1"
        )
    force = CONTACT[FORCE_AND_MOTION[direction][0]]
    distance = -0.5 * sum(dataset[f"travel_body{body}"].values for body in (1, 2))
    pull = np.where(
        dataset["load"].values > 0, dataset[FORCE_AND_MOTION[direction][0]].values, np.nan
    )
    ax = axes_or_new(ax)
    ax.plot(distance * 1e6, pull, "o-", markersize=3, linewidth=1.0)
    if (largest := largest_force(dataset)) is not None:
        _bounds(ax, np.nan_to_num(pull), largest)
        ax.legend(frameon=False)
    ax.set_xlabel("distance rolled [µm]")
    ax.set_ylabel(force.label)
    return finish(ax)


def require_slip(dataset: xr.Dataset) -> None:
    """Raise ValueError if the results are from full sliding."""
    if "friction_work" not in dataset:
        raise ValueError(
            "dataset must be from a run with partial slip, got results of full sliding: run it "
            "with friction=Coulomb(mu)"
        )


def creepages(dataset: xr.Dataset, direction: str) -> tuple[FloatArray, FloatArray]:
    """Return creepage [-] and tangential force [N] of all increments of rolling under load.

    The creepage is the change of the rigid-body displacement divided by the distance rolled in the
    increment.
    """
    force, motion = FORCE_AND_MOTION[direction]
    travels = [np.diff(dataset[f"travel_body{body}"].values, prepend=0.0) for body in (1, 2)]
    distance = -0.5 * (travels[0] + travels[1])
    rolls = (np.abs(distance) > 1e-3 * float(dataset.attrs["dx"])) & (dataset["load"].values > 0)
    slip = np.diff(dataset[motion].values, prepend=0.0)
    return slip[rolls] / distance[rolls], dataset[force].values[rolls]


def largest_force(dataset: xr.Dataset) -> float | None:
    """Return the tangential force at full sliding [N], for the increment in which it is largest.

    Return None if the results have no friction law, or if the law prevents slip.
    """
    law = law_of_attributes(dataset.attrs)
    if law is None or law.prevents_slip:
        return None
    area = float(dataset.attrs["dx"]) * float(dataset.attrs["dy"])
    bound = law.bound(np.nan_to_num(rubbing_pressure_of(dataset)))
    return area * float(bound.sum(axis=(1, 2)).max())

# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of bodies that stick and slip.

Like `samcontact.plotting`, which offers these functions too: each takes an `ax` and returns it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array, non_negative
from .._util.quantities import CONTACT
from ..scene.contact_law import in_contact
from ..scene.friction import Coulomb, FrictionLaw, friction_law, law_of_attributes
from .fields import Plane, clip, inside_of_contact, inside_of_slip, name_sides, outline
from .parts import axes_or_new, edges, finish, prefixed, surface_line
from .shown import require_possible

if TYPE_CHECKING:
    import xarray as xr

    from ..scene.grid import Grid

COLOURS = "#9ecae1", "#fdae6b"
"""Of what sticks and of what slips."""
_ARROWS = 15  # along the longer side of the contact
_LONGEST = 0.95  # times their distance
_OF_SLIP = {"1": "of the way", None: ""}
DIRECTIONS = {"x": ("tangential_load_x", "shift_x"), "y": ("tangential_load_y", "shift_y"),
               "z": ("torque", "twist")}  # fmt: skip


def stick_slip_map(
    pressure: ArrayLike,
    slip: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    unit: str | None = None,
    across: str = "x",
) -> Axes:
    """Where the bodies stick and where they slip, from above, with arrows along the slip.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        [Pa], where surfaces attract each other the repulsion; white where it is zero.
    slip : array_like, shape (2, nx, ny)
        Of body 1 over body 2, e.g. of a `State` or a solution; it sticks where it is zero. Arrows
        are as long as the slip, the longest of them named in the title.
    grid : Grid
        Of both fields.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    unit : {"m", "1"}, optional
        Of the slip, for the title: "m" as of a `State`, "1" per way rolled, as of a
        `RollingSolution`. Without it the title has the number alone.
    across : {"x", "y"}, optional
        Coordinate from left to right. "y" turns the map by a quarter, with x downward: for contacts
        that are long along y.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of a field, or an unknown unit or coordinate.
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
        COLOURS, ("sticks", "slips"), strict=True)]  # fmt: skip
    ax.legend(handles=handles, loc="upper right", fontsize="small", framealpha=0.85, borderpad=0.3)
    factor, name = prefixed(largest, "m") if unit == "m" else (1.0, _OF_SLIP[unit])
    title = f"slip up to {largest * factor:.3g} {name}".rstrip() if largest > 0 else "no slip"
    ax.set_title(title, fontsize="medium")
    ax.set_aspect("equal")
    return name_sides(ax, across)


def _kinds(ax: Axes, slip: FloatArray, pressure: FloatArray, plane: Plane) -> None:
    """The parts of the contact in their colours, and its edge."""
    inside, slips = inside_of_contact(pressure), inside_of_slip(slip, in_contact(pressure))
    levels = [slips.min() - 1.0, 0.0, slips.max() + 1.0]
    parts = ax.contourf(*plane.smooth(slips), levels=levels, colors=COLOURS)
    clip(ax, [parts], plane, inside)
    outline(ax, plane, inside)


def _arrows(ax: Axes, slip: FloatArray, touching: np.ndarray[Any, Any], plane: Plane) -> float:
    """Draw some, the same part of the cells along both sides; the largest slip."""
    size: FloatArray = np.hypot(*slip)
    largest = float(size.max(initial=0.0))
    if not largest > 0:
        return 0.0
    cells = np.argwhere(touching)
    size_of_cell = np.array([side[1] - side[0] for side in plane])
    sides = (np.ptp(cells, axis=0) + 1) * size_of_cell
    apart = max(float(sides.max()) / _ARROWS, *size_of_cell)
    every = [max(round(apart / d), 1) for d in size_of_cell]
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
        scale=1e-6 / (_LONGEST * apart),
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
    """Shear along an axis between the bounds that friction gives it.

    Parameters
    ----------
    pressure, shear : array_like, shapes (nx, ny) and (2, nx, ny)
        [Pa], the shear on body 2.
    grid : Grid
        Of both fields.
    friction : float or Coulomb
        Its coefficient, >= 0 [-], or a friction law; `math.inf`: without bounds.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    component : {"x", "y"}
        Of the shear.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Where it runs [m]: y of a profile along x, and the other way round. Nearest cells.
    label : str
        Of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of a field, an unknown component or axis, or pressure below zero.
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
    ax.set_ylabel(f"shear along {component} [{shown.shown}]")
    return finish(ax)


def fretting_loop(
    dataset: xr.Dataset, ax: Axes | None = None, *, direction: str = "x", label: str | None = None
) -> Axes:
    """Force along the surface over the motion, with the work of friction in the title.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of bodies that stick and slip, see `samcontact.results.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    direction : {"x", "y", "z"}
        Along x, along y, or about z: torque over twist.
    label : str, optional
        Of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        An unknown direction, or results of gross sliding.
    """
    force, motion = DIRECTIONS[choice("direction", direction, tuple(DIRECTIONS))]
    require_slip(dataset)
    ax = axes_or_new(ax)
    way, pull = (np.append(0.0, dataset[n].values) * CONTACT[n].factor for n in (motion, force))
    ax.plot(way, pull, "o-", markersize=3, linewidth=1.0, label=label)
    work = float(dataset["friction_work"].values[-1])
    factor, unit = prefixed(work, "J")
    ax.set_title(f"work of friction {work * factor:.4g} {unit}", fontsize="medium")
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
    """Force along the surface of a contact that rolls, over its creepage.

    Parameters
    ----------
    creepage : array_like, shape (n,)
        Rigid slip per way rolled [-].
    force : array_like, shape (n,)
        [N].
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    largest : float, optional
        Friction times load [N], the force where all slips: a dashed line, on each side where there
        are forces.
    label : str, optional
        Of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Arrays of different lengths.
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
    ax.set_ylabel("force [N]")
    return finish(ax)


def _bounds(ax: Axes, forces: FloatArray, largest: float) -> None:
    """Lines of the largest force, on each side where there are forces."""
    small = 1e-6 * np.abs(forces).max(initial=0.0)
    sides = [side for side in (-1, 1) if np.any(side * forces > small)]
    for side in sides:
        text = "friction limit" if side == sides[0] else "_other side"
        ax.axhline(side * largest, color="k", linestyle="--", linewidth=0.8, label=text)
    ax.margins(y=0.08)


def rolling_force(dataset: xr.Dataset, ax: Axes | None = None, *, direction: str = "x") -> Axes:
    """Force along the surface over the way that a contact has rolled under load.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of bodies that stick and slip while they roll.
    ax : matplotlib.axes.Axes, optional
        Where to draw. Way there and back, and of each pass, are lines of their own.
    direction : {"x", "y"}
        Of the force.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        An unknown direction, or results of gross sliding or without a way.
    """
    require_slip(dataset)
    choice("direction", direction, ("x", "y"))
    if "travel_body1" not in dataset:
        raise ValueError("dataset must be of bodies that roll, got one without a way")
    force = CONTACT[DIRECTIONS[direction][0]]
    way = -0.5 * sum(dataset[f"travel_body{body}"].values for body in (1, 2))
    pull = np.where(dataset["load"].values > 0, dataset[DIRECTIONS[direction][0]].values, np.nan)
    ax = axes_or_new(ax)
    ax.plot(way * 1e6, pull, "o-", markersize=3, linewidth=1.0)
    if (largest := largest_force(dataset)) is not None:
        _bounds(ax, np.nan_to_num(pull), largest)
        ax.legend(frameon=False)
    ax.set_xlabel("way rolled [µm]")
    ax.set_ylabel(force.label)
    return finish(ax)


def require_slip(dataset: xr.Dataset) -> None:
    """Raise ValueError for results that tell nothing of stick and slip."""
    if "friction_work" not in dataset:
        raise ValueError("dataset must be of bodies that stick and slip, with friction=Coulomb(mu)")


def creepages(dataset: xr.Dataset, direction: str) -> tuple[FloatArray, FloatArray]:
    """Of increments that roll under load: slip per way rolled, and the force at their end [N]."""
    force, motion = DIRECTIONS[direction]
    ways = [np.diff(dataset[f"travel_body{body}"].values, prepend=0.0) for body in (1, 2)]
    way = -0.5 * (ways[0] + ways[1])
    rolls = (np.abs(way) > 1e-3 * float(dataset.attrs["dx"])) & (dataset["load"].values > 0)
    slip = np.diff(dataset[motion].values, prepend=0.0)
    return slip[rolls] / way[rolls], dataset[force].values[rolls]


def largest_force(dataset: xr.Dataset) -> float | None:
    """Largest force that friction holds in an increment [N]; None without slip."""
    law = law_of_attributes(dataset.attrs)
    if law is None or law.prevents_slip:
        return None
    area = float(dataset.attrs["dx"]) * float(dataset.attrs["dy"])
    return area * float(law.bound(dataset["pressure"].fillna(0.0).values).sum(axis=(1, 2)).max())

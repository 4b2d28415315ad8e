# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a stationary contact."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array
from .._util.quantities import CONTACT
from .._util.tensors import von_mises
from ..bodies.layered import interfaces_of
from ..hertz import EllipticContact, PointContact
from .adhesion import adhesion_curve, is_adhesive
from .parts import (
    COMPONENT_INDEX,
    INTERFACE_STYLE,
    axes_or_new,
    depths_of,
    finish,
    nearest,
    surface_line,
)
from .shown import require_possible, shown_on

if TYPE_CHECKING:
    import xarray as xr

    from ..bodies.layered import Body
    from ..problem.grid import Grid

HertzContact = PointContact | EllipticContact
_MIN_CHANGE = 1e-3
"""Range of the loads or approaches, relative to their maximum, above which a curve is drawn."""
_MAX_MARKERS = 150
"""Number of cells above which a profile is drawn without a marker at each cell."""


def pressure_profile(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    hertz: HertzContact | None = None,
    axis: str = "x",
    position: float = 0.0,
    label: str = "computed",
) -> Axes:
    """Draw the pressure along an axis and, for comparison, the Hertz pressure.

    Parameters
    ----------
    field : array_like, shape (nx, ny)
        Pressure [Pa] of a state or a dataset.
    grid : Grid
        Grid of the field.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    hertz : PointContact or EllipticContact, optional
        Hertz contact whose pressure is drawn as a dashed line along the same row of cells.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Position of the profile [m]: y for a profile along x, x for a profile along y. The nearest
        row of cells is used.
    label : str
        Label of the computed curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The field has the wrong shape or negative values, or the axis is unknown.
    """
    _require_quantity(field, "pressure", grid)
    return draw_pressure(field, grid, ax, hertz, axis, position, label)


def draw_pressure(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None,
    hertz: HertzContact | None,
    axis: str,
    position: float,
    label: str | None = "computed",
) -> Axes:
    """Draw a pressure as `pressure_profile` does, but accept negative values (tractions)."""
    s = np.asarray(grid.x if axis == "x" else grid.y)
    style: dict[str, Any] = {"marker": "o", "markersize": 3} if s.size <= _MAX_MARKERS else {}
    ax = _profile(field, "pressure", grid, ax, axis, position, label, **style)
    scale = shown_on(ax, "pressure", np.asarray(field)).factor
    if hertz is not None:
        fine = np.linspace(s[0], s[-1], 801)
        if axis == "x":
            curve = hertz.pressure(fine, grid.y[nearest(grid.y, position)])
        else:
            curve = hertz.pressure(grid.x[nearest(grid.x, position)], fine)
        ax.plot(fine * 1e6, curve * scale, "k--", linewidth=1.0, label="Hertz")
        ax.legend(frameon=False)
    return ax


def _require_quantity(field: ArrayLike, quantity: str, grid: Grid) -> None:
    shown = CONTACT[quantity]
    values = finite_array(shown.heading, field, (grid.nx, grid.ny))
    require_possible(shown.heading, values, shown, grid)


def _profile(
    field: ArrayLike,
    quantity: str,
    grid: Grid,
    ax: Axes | None,
    axis: str,
    position: float,
    label: str | None,
    **style: Any,
) -> Axes:
    """Draw a surface field along an axis."""
    s, values = surface_line(field, CONTACT[quantity].heading, grid, axis, position)
    ax = axes_or_new(ax)
    shown = shown_on(ax, quantity, np.asarray(field))
    ax.plot(s * 1e6, values * shown.factor, "-", linewidth=1.2, label=label, **style)
    ax.set_xlabel(f"{axis} [µm]")
    ax.set_ylabel(shown.label)
    if label is not None:
        ax.legend(frameon=False)
    return finish(ax)


def load_approach(
    dataset: xr.Dataset, ax: Axes | None = None, *, hertz: HertzContact | None = None
) -> Axes:
    """Draw the load–approach curve and, for comparison, the Hertz curve (load ~ approach^1.5).

    Each point is an increment. Thin lines join the points; on these lines, the approach is linear
    in load^(2/3), as in elastic contact and during the elastic unloading of an imprint (Johnson
    1985, section 6.4). On periodic grids the lines are straight and only show the order of the
    increments.

    With a law of adhesion, approach and retraction have different colours. A dashed line between
    two increments marks a jump, in which the load changes by more than a fifth of the largest
    tension and by more than four times the median change between increments. For a sphere, three
    theoretical curves are added: those of Johnson, Kendall & Roberts (JKR), of Maugis, for the
    maximum attraction of the law of adhesion, and of Derjaguin, Muller & Toporov (DMT).

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of `samcontact.results.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    hertz : PointContact or EllipticContact, optional
        Hertz contact of the two bodies, from which the Hertz curve is calculated; its load may be
        any load of these bodies. Not used with a law of adhesion.

    Returns
    -------
    matplotlib.axes.Axes
    """
    if is_adhesive(dataset):
        return adhesion_curve(dataset, ax)
    ax = axes_or_new(ax)
    load, approach = dataset["load"].values, dataset["approach"].values
    power = 1.0 if dataset.attrs.get("periodic") else 1.5
    path = _between(np.stack([np.maximum(load, 0.0) ** (1 / power), approach]))
    ax.plot(path[1] * 1e6, path[0] ** power, "-", color="C0", linewidth=0.8, label="_between")
    ax.plot(approach * 1e6, load, "o", color="C0", markersize=3, label="increments")
    if hertz is not None:
        # prescribed tractions have no approach (NaN)
        largest = np.max(approach, initial=0.0, where=np.isfinite(approach))
        fine = np.linspace(0.0, float(largest), 201)
        curve = hertz.load * (fine / hertz.approach) ** 1.5
        ax.plot(fine * 1e6, curve, "k--", linewidth=1.0, label="Hertz")
    ax.legend(frameon=False)
    ax.set_xlabel(CONTACT["approach"].label)
    ax.set_ylabel(CONTACT["load"].label)
    return finish(ax)


def has_curve(dataset: xr.Dataset) -> bool:
    """Whether the loads or approaches of the increments differ enough to draw `load_approach`."""
    for name in ("load", "approach"):
        values = dataset[name].values
        values = values[np.isfinite(values)]
        if values.size < 2:
            return False
        if np.ptp(values) > _MIN_CHANGE * np.abs(values).max():
            return True
    return False


def _between(points: FloatArray) -> FloatArray:
    """Insert linearly interpolated points between the points of a curve, shape (2, points)."""
    count, parts = points.shape[1], 24
    fine = np.linspace(0.0, count - 1.0, parts * (count - 1) + 1)
    return np.stack([np.interp(fine, np.arange(count), row) for row in points])


def imprint_profile(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    axis: str = "x",
    position: float = 0.0,
    label: str | None = None,
) -> Axes:
    """Draw the residual imprint (residual normal displacement) along an axis, depth downward.

    Parameters
    ----------
    field : array_like, shape (nx, ny)
        Residual displacement [m], positive into the body.
    grid : Grid
        Grid of the field.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Position of the profile [m]: y for a profile along x, x for a profile along y. The nearest
        row of cells is used.
    label : str, optional
        Label of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The field has the wrong shape, a value exceeds a thousand times the longer side of the grid,
        or the axis is unknown.
    """
    _require_quantity(field, "residual_displacement", grid)
    ax = _profile(field, "residual_displacement", grid, ax, axis, position, label)
    if not ax.yaxis_inverted():
        ax.invert_yaxis()
    return ax


def temperature_profile(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    axis: str = "x",
    position: float = 0.0,
    label: str | None = None,
) -> Axes:
    """Draw the temperature rise of the surface (flash temperature) along an axis.

    Parameters
    ----------
    field : array_like, shape (nx, ny)
        Temperature rise of the surface [K].
    grid : Grid
        Grid of the field.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Position of the profile [m]: y for a profile along x, x for a profile along y. The nearest
        row of cells is used.
    label : str, optional
        Label of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The field has the wrong shape, negative values or values above 1e6 K, or the axis is
        unknown.
    """
    _require_quantity(field, "surface_temperature", grid)
    return _profile(field, "surface_temperature", grid, ax, axis, position, label)


def axis_profile(
    stress: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    components: Sequence[str] = ("von_mises", "hydrostatic", "xx", "zz"),
    body: Body | None = None,
    interfaces: ArrayLike = (),
) -> Axes:
    """Draw the stresses below the point x = y = 0 versus depth.

    Parameters
    ----------
    stress : array_like, shape (6, nx, ny, nz)
        Stress of a body [Pa].
    grid : Grid
        Grid of the field, with layers (dz).
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    components : sequence of str
        Any of "von_mises", "hydrostatic", "xx", "yy", "zz", "yz", "xz", "xy".
    body : Material or Layered, optional
        Body whose initial yield stress and initial residual stresses are also drawn.
    interfaces : array_like, shape (n,), optional
        Depths of the interfaces between layers [m], e.g. `Layered.interfaces`.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The grid has no layers, the stress has the wrong shape, or a component is unknown.
    """
    depths = depths_of(grid, stress)
    for component in components:
        choice("components", component, ("von_mises", "hydrostatic", *COMPONENT_INDEX))
    tensor = finite_array("stress", stress, (6, grid.nx, grid.ny, len(depths)))
    tensor = tensor[:, nearest(grid.x, 0.0), nearest(grid.y, 0.0)]
    lines = dict(zip(COMPONENT_INDEX, tensor, strict=True))
    lines |= {"von_mises": von_mises(tensor), "hydrostatic": tensor[:3].mean(axis=0)}
    between = finite_array("interfaces", interfaces, np.shape(interfaces))
    between = between[between < depths[-1]]
    first = np.searchsorted(depths, between)  # curves are not joined across interfaces
    ax = axes_or_new(ax)
    for name in components:
        label = rf"$\sigma_{{{name}}}$" if name in COMPONENT_INDEX else CONTACT[name].heading
        values = np.insert(lines[name] * CONTACT["stress"].factor, first, np.nan)
        ax.plot(values, np.insert(depths * 1e6, first, between * 1e6), linewidth=1.2, label=label)
    for depth in between:
        ax.axhline(depth * 1e6, **INTERFACE_STYLE)
    if body is not None:
        _add_strength(ax, body, depths)
    ax.set_ylim(float(depths[-1]) * 1e6, 0.0)
    ax.set_xlabel("stress along the axis [MPa]")
    ax.set_ylabel("depth z [µm]")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    return finish(ax)


def _add_strength(ax: Axes, body: Body, depths: FloatArray) -> None:
    """Draw the initial yield stress and the initial residual stress of a body versus depth."""
    z, factor = np.append(0.0, depths), CONTACT["stress"].factor
    interfaces = interfaces_of(body)
    if interfaces.size:  # points on both sides of them
        between = interfaces[interfaces < depths[-1]]
        z = np.sort(np.concatenate([z, np.nextafter(between, 0.0), between]))
    if body.is_plastic:
        limit = factor * body.yield_stress_at(z)
        limit[~np.isfinite(limit)] = np.nan
        ax.plot(limit, z * 1e6, "k--", linewidth=1.0, label="initial yield stress")
    along_x, along_y, _ = factor * body.residual_stress_at(z)
    if np.any(along_x) or np.any(along_y):
        even = np.array_equal(along_x, along_y)
        name = r"$\sigma_{xx}$" if not even else r"$\sigma_{xx} = \sigma_{yy}$"
        ax.plot(along_x, z * 1e6, "k:", linewidth=1.0, label=f"initial {name}")
        if not even:
            ax.plot(along_y, z * 1e6, "k-.", linewidth=1.0, label=r"initial $\sigma_{yy}$")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawing of fields in colour: smooth with contour lines, or one colour per cell."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

from .._util.checks import BoolArray, FloatArray, boolean
from .._util.lazy_scipy import scipy
from .._util.quantities import Quantity
from .parts import MAX_FLAT_MAP_RATIO, MIN_SECTION_RATIO, axes_or_new, without_seams
from .ticks import FittedLocator, fit_ticks

_FLAT_SECTION_RATIO = (
    0.45  # depth/width below which the label of the colour bar would exceed the section
)
_SHORT_LABEL_RATIO = 0.22  # depth/width below which the label of the depth would exceed the section
_BANDS_PER_CONTOUR = 8  # colour bands between contour lines: more cannot be distinguished
_MIN_SHOWN_STRAIN = 1e-2  # strain, relative to its maximum, below which no colour is drawn
_CONTOUR_STYLE: dict[str, Any] = {"colors": "k", "linewidths": 0.4, "alpha": 0.35}
EDGE_STYLE: dict[str, Any] = {"colors": "k", "linewidths": 0.9}
"""Style of the line along the contact edge."""
_CONTACT_BAR_STYLE: dict[str, Any] = {
    "linewidth": 2.5,
    "solid_capstyle": "butt",
    "clip_on": False,
    "zorder": 3,
}


class Plane(NamedTuple):
    """Cell edges [m] along the horizontal and the vertical axis of a figure."""

    across: FloatArray
    down: FloatArray

    @property
    def ratio(self) -> float:
        """Ratio of height to width."""
        return float((self.down[-1] - self.down[0]) / (self.across[-1] - self.across[0]))

    def smooth(self, values: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return coordinates [µm] and values at the cell centres and along the sides of the plane.

        Values along the sides are those of the nearest cells.
        """
        sides = [
            np.concatenate([side[:1], 0.5 * (side[1:] + side[:-1]), side[-1:]]) * 1e6
            for side in (self.across, self.down)
        ]
        return sides[0], sides[1], np.pad(values, 1, mode="edge").T


def show_section(
    ax: Axes | None,
    plane: Plane,
    values: FloatArray,
    quantity: Quantity,
    name: str,
    *,
    titled: bool = False,
    equal: bool = True,
    cells: bool = False,
) -> Axes:
    """Draw a plane section of a volume field with a colour bar; depth points downward.

    values: field in SI units. name: name of the horizontal coordinate. titled: whether the name of
    the quantity is shown as the title and not along the colour bar; in a flat section it is always
    the title. equal: whether both axes have the same scale. cells: whether to show one colour per
    cell.
    """
    ax = axes_or_new(ax)
    titled = titled or plane.ratio < _FLAT_SECTION_RATIO
    _show(ax, plane, values, quantity, titled=titled, equal=equal, cells=cells)
    if equal and plane.ratio < MIN_SECTION_RATIO:
        ax.set_aspect(MIN_SECTION_RATIO / plane.ratio)
    ax.set_xlabel(f"{name} [µm]")
    ax.set_ylabel("z [µm]" if equal and plane.ratio < _SHORT_LABEL_RATIO else "depth z [µm]")
    ax.invert_yaxis()
    return ax


def show_surface(
    ax: Axes | None,
    plane: Plane,
    values: FloatArray,
    quantity: Quantity,
    name: str,
    note: str = "",
    *,
    inside: FloatArray | None = None,
    cells: bool = False,
) -> Axes:
    """Draw a map of a surface field with a colour bar.

    name: name of the horizontal coordinate. note: text after the name of the quantity. inside:
    field that is positive where the map is drawn; the rest of the map is white. cells: whether to
    show one colour per cell.
    """
    ax = axes_or_new(ax)
    if inside is not None and cells:
        values = np.where(inside > 0, values, np.nan)
    below = plane.ratio < MAX_FLAT_MAP_RATIO
    drawn = _show(ax, plane, values, quantity, note, titled=True, cells=cells, below=below)
    if inside is not None and not cells:
        clip(ax, drawn, plane, inside)
    ax.set_xlabel(f"{name} [µm]")
    ax.set_ylabel("y [µm]")
    return ax


def name_sides(ax: Axes, across: str) -> Axes:
    """Label the axes of a map in which the coordinate `across` runs from left to right."""
    ax.set_xlabel(f"{across} [µm]")
    ax.set_ylabel("y [µm]" if across == "x" else "x [µm]")
    if across == "y":
        ax.set_ylim(*sorted(ax.get_ylim(), reverse=True))
    return ax


def clip(ax: Axes, drawn: list[Any], plane: Plane, inside: FloatArray) -> None:
    """Clip drawn objects to the region in which the field `inside` is positive."""
    region = ax.contourf(*plane.smooth(inside), levels=[0.0, 1.0 + float(inside.max())])
    path = region.get_paths()[0]
    region.remove()
    for artist in drawn:
        artist.set_clip_path(path, ax.transData)


def outline(ax: Axes, plane: Plane, inside: FloatArray, **style: Any) -> None:
    """Draw the line along which the field `inside` is zero."""
    ax.contour(*plane.smooth(inside), levels=[0.0], **(EDGE_STYLE | style))


def inside_of_contact(contact: FloatArray) -> FloatArray:
    """Return a field that is positive in the contact and crosses zero along the contact edge.

    The field is based on the squared pressure, which for smooth bodies is approximately
    proportional to the distance from the contact edge. contact: pressure, or 1 in contact cells
    and 0 elsewhere.
    """
    return _crossing(np.square(contact))


def inside_of_slip(slip: FloatArray, touching: BoolArray) -> FloatArray:
    """Return a field that is positive in the slip zone, and zero at the edge of the stick zone.

    The field is based on slip^(2/3), because the slip is approximately proportional to the power
    3/2 of the distance from the stick zone. slip: magnitude of the slip. touching: contact cells.
    """
    return _crossing(np.cbrt(np.square(spread(slip, touching))))


def _crossing(values: FloatArray) -> FloatArray:
    """Return a field in which zeros next to a positive region are replaced by negative values.

    The negative values are extrapolated linearly from the two nearest positive values. If these do
    not decrease towards the edge of the region, the mean slope at the edge is used instead.
    """
    there = values > 0
    cross = scipy.ndimage.generate_binary_structure(2, 1)
    border = there & ~scipy.ndimage.binary_erosion(there, cross, border_value=1)
    slope = 2.0 * float(values[border].mean()) if border.any() else 1.0
    (nx, ny), padded = values.shape, np.pad(values, 2, mode="edge")
    total, count = np.zeros_like(values), np.zeros_like(values)
    for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        near = padded[2 + i : 2 + i + nx, 2 + j : 2 + j + ny]
        far = padded[2 + 2 * i : 2 + 2 * i + nx, 2 + 2 * j : 2 + 2 * j + ny]
        line = np.where(far > near, 2.0 * near - far, near - slope)
        total += np.where(near > 0, np.minimum(line, -0.05 * slope), 0.0)
        count += near > 0
    beyond = np.divide(total, count, out=np.full_like(total, -0.5 * slope), where=count > 0)
    return np.where(there, values, beyond)


def spread(kinds: FloatArray, touching: BoolArray) -> FloatArray:
    """Extend a field beyond the contact.

    Each cell outside the contact gets the value of the nearest contact cell.
    """
    nearest = scipy.ndimage.distance_transform_edt(
        ~touching, return_distances=False, return_indices=True
    )
    return np.asarray(kinds[tuple(nearest)], dtype=np.float64)


def touching_along(
    ax: Axes, across: FloatArray, touching: BoolArray, height: float = 0.0, **options: Any
) -> None:
    """Draw a bar along the contact cells of a row.

    across: cell edges along the row [m]. height: vertical position of the bar; 0 is the surface in
    a section.
    """
    for run in scipy.ndimage.find_objects(scipy.ndimage.label(touching)[0]):
        ends = across[[run[0].start, run[0].stop]] * 1e6
        ax.plot(ends, [height, height], "k-", **_CONTACT_BAR_STYLE, **options)


def scale_of(values: FloatArray, quantity: Quantity) -> tuple[Normalize, FloatArray, FloatArray]:
    """Return the colour scale of a field, the limits of the colour bands, and contour levels."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if quantity.from_zero:
        low = 0.0
    elif low == high:
        low, high = min(low, 0.0), max(high, 0.0)
    if quantity.signed:
        span = max(abs(low), abs(high))
        norm = Normalize(-span, span)  # white is zero
    else:
        norm = Normalize(low, high)
    lines = np.asarray(MaxNLocator(8, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    band = float(lines[1] - lines[0]) / _BANDS_PER_CONTOUR
    first, last = np.floor(low / band), np.floor(high / band) + 2
    bands = np.arange(first, last) * band
    if quantity.signed:
        bands = np.arange(first, last + 1) * band - 0.5 * band  # zero is in the middle of a band
    elif quantity.kind == "strain" and high > 0:
        bands[0] = _MIN_SHOWN_STRAIN * high
    return norm, bands, lines[(lines > low) & (lines < high) & (np.abs(lines) > 1e-3 * band)]


def _show(
    ax: Axes,
    plane: Plane,
    values: FloatArray,
    quantity: Quantity,
    note: str = "",
    *,
    titled: bool,
    equal: bool = True,
    cells: bool = False,
    below: bool = False,
) -> list[Any]:
    """Draw a field with a colour bar (at the side, or below), and return the drawn objects.

    If the field is zero everywhere, the text "identically zero" is shown instead.
    """
    boolean("cells", cells)
    quantity = quantity.scaled(float(np.nanmax(np.abs(values))))
    shown, label = values * quantity.factor, quantity.label + note
    if quantity.from_zero:
        shown = np.maximum(shown, 0.0)  # negative values are rounding errors
    ax.grid(False)  # a grid from user settings would cover the colours
    drawn: list[Any] = []
    if zero := not np.any(np.nan_to_num(shown)):
        ax.set(xlim=plane.across[[0, -1]] * 1e6, ylim=plane.down[[0, -1]] * 1e6)
        ax.text(0.5, 0.5, "identically\nzero", transform=ax.transAxes, ha="center", va="center")
    else:
        norm, bands, lines = scale_of(shown, quantity)
        style: dict[str, Any] = {"cmap": quantity.colours, "norm": norm}
        if cells:
            sides = plane.across * 1e6, plane.down * 1e6
            drawn = [ax.pcolormesh(*sides, shown.T, rasterized=True, **style)]
        else:
            field = plane.smooth(shown)
            drawn = [without_seams(ax.contourf(*field, levels=bands, **style))]
            if len(lines):
                drawn.append(ax.contour(*field, levels=lines, linestyles="solid", **_CONTOUR_STYLE))
        bar_options: dict[str, Any] = {"label": "" if titled else label, "ticks": FittedLocator()}
        ends = max(bands[0], norm.vmin), min(bands[-1], norm.vmax)
        if below:
            bar_options |= {"location": "bottom", "aspect": 40, "fraction": 0.3}
        bar = ax.figure.colorbar(ScalarMappable(**style), ax=ax, **bar_options)
        (bar.ax.set_xlim if below else bar.ax.set_ylim)(*ends)
    if titled or zero:
        ax.set_title(label, fontsize="medium")
    if equal:
        ax.set_aspect("equal")
    fit_ticks(ax)
    return drawn

# SPDX-License-Identifier: GPL-3.0-or-later
"""Helper functions for all figures: creation without pyplot, labels, units, profiles of fields."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite, finite_array
from ..files.atomic import replacing
from .ticks import FittedLocator, fit_ticks

if TYPE_CHECKING:
    from ..problem.grid import Grid

SECTIONS = (
    "von_mises", "hydrostatic", "equivalent_plastic_strain", "residual_von_mises",
    "residual_hydrostatic", "stress", "residual_stress", "plastic_strain", "temperature",
)  # fmt: skip
SURFACES = {
    "pressure": "pressure", "gap": "gap", "imprint": "residual_displacement", "shear_x": "shear_x",
    "shear_y": "shear_y", "temperature": "surface_temperature",
}  # fmt: skip
"""Names of surface fields in the figure functions (keys), and in a `State` or dataset (values)."""
INTERFACE_STYLE: dict[str, Any] = {"color": "0.55", "linewidth": 0.9, "linestyle": (0, (5, 3))}
MIN_SECTION_RATIO = 0.2
"""Minimum ratio of height to width of a section; the depth of flatter sections is stretched."""
MAX_FLAT_MAP_RATIO = 0.2
"""Ratio of height to width below which the colour bar of a map is placed below the map."""
MIN_LONG_CONTACT_RATIO = 2.5
"""Ratio of length along y to length along x above which maps are rotated."""
COMPONENT_INDEX = {"xx": 0, "yy": 1, "zz": 2, "yz": 3, "xz": 4, "xy": 5}


_COLUMNS = {"single": (88.0, 7.0), "double": (180.0, 8.0)}
"""Width [mm] and font size [pt] of figures for journal columns."""
_MIN_DOUBLE_COLUMN_WIDTH = 6.5  # width [in] above which a figure takes the double column
_PADDING = 0.08  # margin [in]
_COLUMN_WIDTH_ID = "as wide as a column"
_in_column: ContextVar[str] = ContextVar("_in_column", default="screen")


@contextmanager
def journal_column(width: str = "single") -> Iterator[None]:
    """Give all figures within a ``with`` block the width and font size for a journal column.

    Create and save the figures in the block: ``with plotting.journal_column("double"):
    summary_figures(...)``. Even with "single", figures with several panels side by side have the
    width of a double column. A function that receives an `ax` draws into the existing figure and
    does not change its size.

    Parameters
    ----------
    width : {"single", "double", "screen"}
        "single": 88 mm wide with a 7 pt font; "double": 180 mm with an 8 pt font; "screen": default
        size and font.

    Raises
    ------
    ValueError
        The width is unknown.
    """
    choice("width", width, (*_COLUMNS, "screen"))
    rc_settings: Any = {}
    if width in _COLUMNS:
        thin = dict.fromkeys(("axes.linewidth", "xtick.major.width", "ytick.major.width"), 0.6)
        rc_settings = {"font.size": _COLUMNS[width][1], **thin}
    token = _in_column.set(width)
    try:
        with matplotlib.rc_context(rc_settings):
            yield
    finally:
        _in_column.reset(token)


def new_figure(width: float = 5.0, height: float = 3.6) -> Figure:
    """Return a figure of a given size [inches], or of the column width within `journal_column`."""
    given = _in_column.get()
    name = "double" if given == "single" and width > _MIN_DOUBLE_COLUMN_WIDTH else given
    size = _COLUMNS[name][0] / 25.4 if name in _COLUMNS else width
    figure = Figure(figsize=(size, height * size / width), layout="compressed", dpi=200)
    if name in _COLUMNS:
        figure.set_gid(_COLUMN_WIDTH_ID)
    FigureCanvasAgg(figure)
    return figure


def save(figure: Figure | None, path: Path) -> Path:
    """Write a figure to a file without blank margins, and return the path."""
    assert figure is not None
    with replacing(path) as part:
        draw(figure, part, format=path.suffix[1:] or "png", **_SAVE_OPTIONS.get(path.suffix, {}))
    return path


_SAVE_OPTIONS: dict[str, dict[str, Any]] = {
    ".pdf": {"dpi": 400, "metadata": {"CreationDate": None}},
    ".svg": {"dpi": 400, "metadata": {"Date": None}},
}
"""Options of vector files: resolution of rasterised fields, and no date, so that repeated runs give
identical files."""


def draw(figure: Figure, target: Path | BinaryIO, **options: Any) -> None:
    """Write a figure to a file or a buffer; `options` are passed to `Figure.savefig`."""
    box: Any = "tight"
    try:
        if figure.get_gid() == _COLUMN_WIDTH_ID:  # full column width, not cropped
            figure.draw_without_rendering()  # computes the layout
            shown = figure.get_tightbbox()
            ends = (shown.y0 - _PADDING, figure.get_figwidth(), shown.y1 + _PADDING)
            box = Bbox.from_extents(0.0, *ends)
        with matplotlib.rc_context({"pdf.fonttype": 42, "svg.hashsalt": "samcontact"}):
            figure.savefig(target, bbox_inches=box, pad_inches=_PADDING, **options)
    except RuntimeError as error:  # e.g. LaTeX, requested by a matplotlibrc, is missing
        raise OSError(f"cannot draw a figure: {error}") from error


def depths_of(grid: Grid, field: ArrayLike) -> FloatArray:
    """Return the mid-layer depths [m] of all layers of a volume field."""
    require_volume(grid)
    shape = np.shape(field)
    return grid.depths(grid.nz or (shape[-1] if shape else 1))


def require_volume(grid: Grid) -> None:
    """Raise ValueError for a grid without layers."""
    if not grid.has_volume:
        raise ValueError("grid must have layers, got a grid without dz")


def _panel_height(width: float, across: float, down: float) -> float:
    return min(max(0.75 * width * down / across, 0.5), 1.5 * width) + 0.95


def section_height(width: float, across: float, depth: float) -> float:
    """Return the figure height [inches] at which a single section leaves no blank space."""
    return _panel_height(width, across, max(depth, MIN_SECTION_RATIO * across))


def map_height(width: float, across: float, down: float) -> float:
    """Return the figure height [inches] of a map, including the colour bar below a flat map."""
    return _panel_height(width, across, down) + (
        0.55 if down < MAX_FLAT_MAP_RATIO * across else 0.0
    )


def axes_or_new(ax: Axes | None) -> Axes:
    return new_figure().subplots() if ax is None else ax


def finish(ax: Axes) -> Axes:
    ax.grid(True, linewidth=0.4, alpha=0.5)
    ax.set_axisbelow(True)
    fit_ticks(ax)
    return ax


def counted(ax: Axes) -> Axes:
    """Place x ticks at whole numbers only, e.g. for passes or cycles, and return the axes."""
    ax.xaxis.set_major_locator(FittedLocator(integer=True))
    left, right = ax.get_xlim()
    if right - left < 1.0:  # a single number
        ax.set_xlim(left - 1.0, right + 1.0)
    return ax


def nearest(values: ArrayLike, position: float) -> int:
    return int(np.argmin(np.abs(np.asarray(values) - position)))


def row_of_interest(values: ArrayLike, coordinate: ArrayLike) -> int:
    """Return the index of the row of cells to show: the middle row, or the row with the maximum.

    The row with the maximum is chosen if the value in the middle row is below 90 % of the maximum.
    values: maximum magnitude in each row. coordinate: positions of the rows [m].
    """
    sizes = np.asarray(values, dtype=np.float64)
    middle = nearest(coordinate, 0.0)
    if sizes[middle] >= 0.9 * sizes.max():
        return middle
    return int(
        np.argmax(sizes >= (1.0 - 1e-6) * sizes.max())
    )  # a unique row for mirror-symmetric fields


def place(name: str, value: float) -> str:
    """Return the position of a row of cells as text, e.g. "y = 12 µm"; value: position [m]."""
    shown = value * 1e6 + 0.0
    return f"{name} = {shown:{'.4g' if abs(shown) < 1e4 else '.0f'}} µm"


def elsewhere(name: str, value: float, cell: float) -> str:
    """Return the position of a row of cells as text, or "" for the middle row of the grid."""
    return "" if abs(value) <= 0.5 * cell else place(name, value)


def add_to_title(ax: Axes, *texts: str) -> None:
    ax.set_title(", ".join(text for text in (ax.get_title(), *texts) if text), fontsize="medium")


def prefixed(largest: float, unit: str) -> tuple[float, str]:
    """Return the factor to a unit whose prefix suits the value `largest`, and this unit."""
    place = int(np.clip(np.floor(np.log10(largest) / 3), -4, 3)) if largest > 0 else 0
    return 10.0 ** (-3 * place), "pnµm kMG"[place + 4].strip() + unit


def edges(centres: ArrayLike, step: float) -> FloatArray:
    centres = np.asarray(centres, dtype=np.float64)
    return np.append(centres - 0.5 * step, centres[-1] + 0.5 * step)


def surface_line(
    field: ArrayLike, name: str, grid: Grid, axis: str, position: float
) -> tuple[FloatArray, FloatArray]:
    """Return coordinates [m] and values of a surface field along an axis, in one row of cells."""
    choice("axis", axis, ("x", "y"))
    values = finite_array(name, field, (grid.nx, grid.ny))
    finite("position", position)
    if axis == "x":
        return np.asarray(grid.x), values[:, nearest(grid.y, position)]
    return np.asarray(grid.y), values[nearest(grid.x, position), :]


def without_seams(bands: ContourSet) -> ContourSet:
    """Rasterise filled contours in vector files, which would otherwise show seams.

    With Matplotlib before 3.11 the contours remain vectors.
    """
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Rasterization of", category=UserWarning)
        bands.set_rasterized(True)
    return bands

# SPDX-License-Identifier: GPL-3.0-or-later
"""Interactive three-dimensional view of a body, cut open below the contact.

Views are drawn by PyVista (extra ``3d``), in a notebook or on a separate page.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray, choice
from .._util.quantities import CONTACT
from ..files.atomic import replacing
from ..problem.contact_law import in_contact
from ..results.contact import repulsion_of
from ..results.reading import body_shown
from ..results.vtk import stored_number, volume_names
from .contact_results import ContactResults
from .fields import Plane, inside_of_contact, scale_of
from .parts import edges

if TYPE_CHECKING:
    import pyvista
    import xarray as xr

_FIELDS = (
    "von_mises", "hydrostatic", "equivalent_plastic_strain", "residual_von_mises", "temperature",
)  # fmt: skip
_ICON_URL = "https://kitware.github.io/vtk-js/icon/"
"""Address of the icons that a page written by PyVista would load from the network."""


def view(
    dataset: xr.Dataset,
    *,
    increment: int = -1,
    body: int | None = None,
    quantity: str = "von_mises",
) -> pyvista.Plotter:
    """Show a body in three dimensions, coloured by a field and cut open at the field's maximum.

    A quarter of the body is removed; the corner of the cut lies at the maximum. Body 2 is at z < 0,
    body 1 at z > 0. Lines mark the contact edge and the interfaces of layers. Inclusions are grey
    and are shown whole, even in the removed quarter. In a notebook, ``view(...).show()`` displays
    the view.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results with volume fields, see `samcontact.results.to_dataset`.
    increment : int, optional
        Number of the increment, from 1. Negative numbers count only increments with volume fields;
        -1 is the last of these.
    body : {1, 2}, optional
        Body whose field is shown. Default: the body set in [output] of the case; if only the other
        body has volume fields, that body.
    quantity : {"von_mises", "hydrostatic", "equivalent_plastic_strain", "residual_von_mises", \
"temperature"}, optional
        Stored quantity to show.

    Returns
    -------
    pyvista.Plotter
        Plotter for `save_view`, or for further use with PyVista.

    Raises
    ------
    ValueError
        `body` or `quantity` is unknown, or the field is not stored in all cells at the increment.
    ModuleNotFoundError
        PyVista is not installed.
    """
    body = body_shown(dataset, body)
    choice("quantity", quantity, _FIELDS)
    if not volume_names(dataset, body):
        raise ValueError(
            f"dataset must have volume fields of body {body}, got none: pass body and volume to "
            "samcontact.results.to_dataset"
        )
    results, number = ContactResults(dataset, body, None), stored_number(dataset, increment, True)
    if not results.has("stress" if quantity == "residual_von_mises" else quantity, number):
        raise ValueError(
            f"dataset must contain {quantity} of body {body} in all cells at increment {number}: "
            "choose another quantity or increment"
        )
    pv = _pyvista()
    with pv.vtk_verbosity("off"):
        plotter: pyvista.Plotter = _drawn(pv, results, number, quantity)
    return plotter


def _drawn(pv: Any, results: ContactResults, number: int, quantity: str) -> Any:
    field, shown = results.field(quantity, number) * CONTACT[quantity].factor, CONTACT[quantity]
    sign = 1.0 if results.body == 1 else -1.0
    grid = results.grid
    depths = np.append(0.0, (np.arange(field.shape[2]) + 1.0) * (grid.dz or 0.0))
    sides = (edges(grid.x, grid.dx) * 1e6, edges(grid.y, grid.dy) * 1e6, sign * depths * 1e6)
    norm, _, _ = scale_of(field, shown)
    plotter = pv.Plotter(off_screen=True)
    plotter.set_background("white")
    plotter.add_mesh(
        _cut_open(pv, sides, field),
        scalars="values",
        cmap=shown.colours,
        clim=(norm.vmin, norm.vmax),
        lighting=False,
        scalar_bar_args={"title": f"{shown.label}\n", "color": "black"},
    )
    if results.has("share", number):
        surface = _inclusions(pv, sides, results.field("share", number))
        if surface.n_points > 0:
            plotter.add_mesh(surface, color="lightgrey", smooth_shading=True)
    repulsion = repulsion_of(results.dataset).sel(increment=number).values
    for line in _edge(results, repulsion):
        plotter.add_mesh(pv.lines_from_points(line), color="black", line_width=3)
    for depth in results.interfaces[results.interfaces < depths[-1]] * 1e6 * sign:
        plotter.add_mesh(_loop(pv, sides, float(depth)), color="black", line_width=2)
    plotter.show_bounds(xtitle="x [µm]", ytitle="y [µm]", ztitle="z [µm]", color="black")
    plotter.camera_position = [(1.0, -1.2, -0.8 * sign), (0, 0, 0), (0, 0, -sign)]
    plotter.reset_camera()
    return plotter


def _cut_open(pv: Any, sides: tuple[FloatArray, ...], field: FloatArray) -> Any:
    """Return the surface of the body without the quarter on the +x and -y side of the maximum.

    sides: cell edges along x, y and z [µm]. field: values in the cells.
    """
    size = np.abs(field)
    middle = [
        float(0.5 * (side[at] + side[at + 1]))
        for side, at in zip(sides, np.unravel_index(int(size.argmax()), size.shape), strict=True)
    ]
    block = pv.RectilinearGrid(*sides)
    block.cell_data["values"] = field.ravel(order="F")
    points = block.cell_data_to_point_data()
    low, high = sides[2].min(), sides[2].max()
    quarter = (middle[0], sides[0][-1], sides[1][0], middle[1], low, high)
    return points.clip_box(quarter, invert=True).extract_surface(algorithm="dataset_surface")


def _inclusions(pv: Any, sides: tuple[FloatArray, ...], share: FloatArray) -> Any:
    """Return the surface of the inclusions: the contour on which their fraction of a cell is 0.5.

    share: fraction of each cell that is filled by inclusions.
    """
    padded = np.pad(share, 1)  # closes inclusions that the sides of the grid cut
    centres = [0.5 * (side[1:] + side[:-1]) for side in sides]
    axes = [np.concatenate([[s[0]], c, [s[-1]]]) for s, c in zip(sides, centres, strict=True)]
    points = pv.RectilinearGrid(*axes)
    points.point_data["share"] = padded.ravel(order="F")
    return points.contour([0.5], scalars="share")


def _edge(results: ContactResults, repulsion: FloatArray) -> list[FloatArray]:
    """Return the contact edge as lines on the surface: coordinates x, y, z of points [µm]."""
    import contourpy  # a dependency of Matplotlib

    if not repulsion.any() or np.all(in_contact(repulsion)):
        return []
    grid = results.grid
    plane = Plane(edges(grid.x, grid.dx), edges(grid.y, grid.dy))
    contours = contourpy.contour_generator(*plane.smooth(inside_of_contact(repulsion)))
    lines: Any = contours.lines(0.0)
    return [np.column_stack([line, np.zeros(len(line))]) for line in lines]


def _loop(pv: Any, sides: tuple[FloatArray, ...], depth: float) -> Any:
    """Return a closed line around the body along its four sides, at a given z coordinate [µm]."""
    x, y = sides[0][[0, -1, -1, 0, 0]], sides[1][[0, 0, -1, -1, 0]]
    return pv.lines_from_points(np.column_stack([x, y, np.full(5, depth)]))


def save_view(plotter: pyvista.Plotter, path: str | Path) -> Path:
    """Write a view as one HTML file that requires neither a network nor this package.

    Parameters
    ----------
    plotter : pyvista.Plotter
        Result of `view`.
    path : str or Path
        File name ending in .html.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        The file name does not end in .html.
    OSError
        The file cannot be written.
    """
    target = Path(path)
    if target.suffix.lower() != ".html":
        raise ValueError(f"path must end in .html, got {str(target)!r}")
    with _pyvista().vtk_verbosity("off"):  # works without a screen
        page = plotter.export_html(None)
    assert page is not None
    with replacing(target) as temporary:
        temporary.write_text(page.getvalue().replace(_ICON_URL, "data:,"), encoding="utf-8")
    return target


def _pyvista() -> Any:
    try:
        import pyvista
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            f"views require the package pyvista ({error}): run pip install samcontact[3d]"
        ) from error
    return pyvista

# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard figures of a run, written to files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from .._util.checks import choice
from ..files.ownership import recording
from ..results.reading import body_shown, grid_of
from .adhesion import adhesion_figures
from .contact import (
    HertzContact,
    axis_profile,
    draw_pressure,
    has_curve,
    imprint_profile,
    load_approach,
    temperature_profile,
)
from .contact_results import ContactResults
from .inclusions import outline_in_section
from .interface import interface_figure
from .maps import peak_map, surface_map, track_map
from .over_time import has_times, time_figure
from .parts import add_to_title, elsewhere, map_height, new_figure, save
from .section import section
from .slip_summary import slip_figures
from .track import imprint_along, residual_along, track_summary

if TYPE_CHECKING:
    import xarray as xr

_SECTION_FIELDS = ("von_mises", "hydrostatic", "equivalent_plastic_strain")
_WIDTH = 5.0  # width of a figure [in]


def summary_figures(
    dataset: xr.Dataset,
    directory: str | Path,
    *,
    body: int | None = None,
    hertz: HertzContact | None = None,
    format: str = "png",
) -> list[Path]:
    """Write the standard figures of a run to files.

    Each profile or section passes through the middle of the grid or, if the values there are below
    90 % of the maximum (common on rough surfaces), through the row of cells with the maximum.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of `samcontact.results.to_dataset`. Sections are drawn for the increments with
        maximum stress and maximum temperature and for the last one, if their volume fields are
        stored.
    directory : str or Path
        Folder of the figures; created if missing.
    body : {1, 2}
        Body whose stresses and residual imprint are shown. Default: the body set in [output] of the
        case; if only the other body has volume fields, that body.
    hertz : PointContact or EllipticContact, optional
        Hertz contact at the load of the increment with maximum stress.
    format : {"png", "pdf", "svg"}
        File format; in PDF and SVG files, lines and text are vectors.

    Returns
    -------
    list of Path
        Files written, with the suffix of the format:

        - pressure and, with several rows of cells, pressure_map and gap_map;
        - load_approach if load or approach differs between increments;
        - with layers of the grid: axis_stress, sections and, for a layered body, interface;
        - with partial slip: partial_slip (increment of maximum force), and fretting_loop or, for
          rolling, rolling_force and, with varying creepage, creep_curve;
        - of viscoelastic bodies, with several increments: over_time;
        - with a law of adhesion: cohesive_zone and, for a sphere under tension, pull_off;
        - with heating: flash_temperature and, with layers of the grid, temperature (hottest
          increment);
        - for an elastic-plastic body: imprint, imprint_map and residual (last increment, or the
          whole track of a moving body) and, for a moving body, track_imprint and track_sections;
        - for a viscoelastic body: imprint and imprint_map.

    Raises
    ------
    ValueError
        `body` or `format` is unknown, or the folder has a file with one of these names that was not
        written by this package, or that was changed after this package wrote it.
    """
    choice("format", format, ("png", "pdf", "svg"))
    body = body_shown(dataset, body)
    results = ContactResults(dataset, body, hertz)
    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    figures = _peak_figures(results)
    if has_curve(dataset):
        figures["load_approach"] = _panel()
        load_approach(dataset, figures["load_approach"].axes[0], hertz=hertz)
    if has_times(dataset):
        figures["over_time"] = time_figure(dataset)
    figures |= adhesion_figures(dataset)
    figures |= slip_figures(results)
    figures |= _temperature_figures(results)
    if results.track is not None:
        travel = dataset[f"travel_body{body}"].values
        figures |= _track_figures(results.track)
        if "z" in results.track.sizes:
            figures |= track_summary(results.track, travel)
    elif f"residual_displacement_body{body}" in dataset:
        figures |= _imprint_figures(results)
    with recording(folder) as record:
        files = {folder / f"{name}.{format}": figure for name, figure in figures.items()}
        for file in files:
            record.require(file)
        return [save(figure, file) for file, figure in files.items()]


def increments_shown(dataset: xr.Dataset, body: int) -> set[int]:
    """Return the numbers (from 1) of the increments that the figures show.

    These are the increments with maximum stress and maximum temperature, and the last increment.
    """
    results = ContactResults(dataset, body, None)
    shown = {results.peak, dataset.sizes["increment"] - 1}
    if results.hottest is not None:
        shown.add(results.hottest)
    return {results.number(position) for position in shown}


def _panel(width: float = _WIDTH, height: float = 3.6) -> Figure:
    figure = new_figure(width, height)
    figure.subplots()
    return figure


def _load_text(results: ContactResults, position: int) -> str:
    return f"load {float(results.dataset['load'].values[position]):.6g} N"


def _peak_figures(results: ContactResults) -> dict[str, Figure]:
    """Return figures of pressure, gap and stresses at the increment with the maximum stress."""
    grid, number = results.grid, results.number(results.peak)
    _, size = results.map_look
    figures = {"pressure": _panel()}
    pressure = results.surface("pressure", results.peak)
    # adhering bodies pull along the edge, where the traction may be larger than in the middle
    y = results.row(np.maximum(pressure, 0.0))
    ax = figures["pressure"].axes[0]
    draw_pressure(pressure, grid, ax, results.hertz, "x", y, results.pressure_label)
    add_to_title(ax, _load_text(results, results.peak), elsewhere("y", y, grid.dy))
    for name in ("pressure", "gap") if results.has_map else ():
        figures[f"{name}_map"] = _panel(*size)
        peak_map(results, name, figures[f"{name}_map"].axes[0])
    if results.has("stress", number):
        figures["axis_stress"] = _panel(4.6, 4.2)
        ax, stress = figures["axis_stress"].axes[0], results.field("stress", number)
        axis_profile(stress, grid, ax, body=results.graded, interfaces=results.interfaces)
    if results.has("interface_stress", number):
        figures["interface"] = interface_figure(results, number)
    if any(results.has(name, number) for name in _SECTION_FIELDS):
        figures["sections"] = _sections(results, number)
    return figures


def _sections(results: ContactResults, number: int) -> Figure:
    fields = {
        name: results.field(name, number) for name in _SECTION_FIELDS if results.has(name, number)
    }
    y = results.row(next(iter(fields.values())))
    figure = new_figure(_WIDTH, results.section_height * len(fields))
    panels = np.ravel(figure.subplots(len(fields), 1))
    for ax, (name, field) in zip(panels, fields.items(), strict=True):
        lines: Any = {
            "interfaces": results.interfaces,
            "contact": results.surface("repulsion", results.peak),
        }
        section(field, results.grid, ax, quantity=name, position=y, **lines)
        outline_in_section(results, ax, y, number)
        add_to_title(ax, elsewhere("y", y, results.grid.dy))
    return figure


def _temperature_figures(results: ContactResults) -> dict[str, Figure]:
    """Return figures of the temperature rise of the body, or an empty dict without heating."""
    if results.hottest is None:
        return {}
    grid, rise = results.grid, results.surface("surface_temperature", results.hottest)
    figures = {"flash_temperature": _panel()}
    y = results.row(rise)
    ax = temperature_profile(rise, grid, figures["flash_temperature"].axes[0], position=y)
    add_to_title(ax, _load_text(results, results.hottest), elsewhere("y", y, grid.dy))
    if results.has("temperature", number := results.number(results.hottest)):
        figures["temperature"] = _panel(_WIDTH, results.section_height)
        field, ax = results.field("temperature", number), figures["temperature"].axes[0]
        section(field, grid, ax, quantity="temperature", position=y)
    return figures


def _imprint_figures(results: ContactResults) -> dict[str, Figure]:
    """Return figures of residual imprint and residual stress of a stationary contact."""
    grid, depth = results.grid, results.surface("residual_displacement", -1)
    across, size = results.map_look
    figures = {"imprint": _panel()}
    y = results.row(depth)
    ax = imprint_profile(depth, grid, figures["imprint"].axes[0], position=y)
    add_to_title(ax, _load_text(results, -1), elsewhere("y", y, grid.dy))
    if results.has_map:
        pressed = results.surface("repulsion", results.peak)
        below: Any = {"quantity": "imprint", "contact": pressed, "across": across}
        figures["imprint_map"] = _panel(*size)
        surface_map(depth, grid, figures["imprint_map"].axes[0], **below)
    if results.has("residual_stress", number := results.number(-1)):
        residual = results.field("residual_von_mises", number)
        y = results.row(residual)
        figures["residual"] = _panel(_WIDTH, results.section_height)
        ax = figures["residual"].axes[0]
        section(
            residual,
            grid,
            ax,
            quantity="residual_von_mises",
            position=y,
            interfaces=results.interfaces,
        )
        outline_in_section(results, ax, y, number)
        add_to_title(ax, elsewhere("y", y, grid.dy))
    return figures


def _track_figures(track: xr.Dataset) -> dict[str, Figure]:
    """Return figures of residual imprint and residual stress along the track of a contact."""
    grid, length = grid_of(track), float(np.ptp(track["x"].values))
    figures = {"imprint": _panel()}
    imprint_along(track, figures["imprint"].axes[0])
    if grid.ny > 1:
        figures["imprint_map"] = _panel(_WIDTH, map_height(_WIDTH, length, grid.ny * grid.dy))
        track_map(track, figures["imprint_map"].axes[0])
    if grid.nz == 0:  # only the residual imprint is stored
        return figures
    figures["residual"] = residual_along(track, _WIDTH)
    return figures

# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a contact, drawn from a results file and embedded in the page."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure

from .. import plotting
from .._util.checks import FloatArray
from .._util.display import quantity
from .._util.quantities import CONTACT
from .._util.tensors import von_mises
from ..plotting.adhesion import adhesion_figures
from ..plotting.contact import HertzContact, draw_pressure, has_curve
from ..plotting.contact_results import ContactResults
from ..plotting.interface import interface_figure
from ..plotting.maps import peak_map
from ..plotting.over_time import has_times, time_figure
from ..plotting.parts import (
    add_to_title,
    counted,
    draw,
    elsewhere,
    finish,
    map_height,
    new_figure,
    place,
)
from ..results.contact import repulsion_of
from ..solutions.peak import peak_of_dataset
from . import slipping
from .quality_checks import flow_tol

if TYPE_CHECKING:
    import xarray as xr

DOTS_PER_INCH = 120
_LEGEND_ABOVE: Any = {
    "loc": "lower center",
    "bbox_to_anchor": (0.5, 1.0),
    "ncols": 3,
    "frameon": False,
}
"""Legend options that place the legend above the axes, where it does not hide points."""


class ReportFigure(NamedTuple):
    """Figure of a report: caption, description for screen readers, and image as text."""

    caption: str
    description: str
    source: str
    wide: bool = False
    """Whether the figure takes a whole row, because its panels are side by side."""


def contact_figures(
    dataset: xr.Dataset, body: int, hertz: HertzContact | None
) -> list[ReportFigure]:
    """Return all figures of a contact for which the required fields are stored."""
    results = ContactResults(dataset, body, hertz)
    drawn = []
    parts = (
        _contact,
        _adhesion,
        _over_time,
        slipping.figures,
        _volume,
        _temperature,
        _imprint,
        _track,
    )
    for part in (*parts, _convergence):
        drawn += [embedded(*made) for made in part(results)]
    return drawn


def _increment_text(results: ContactResults, number: int) -> str:
    load = float(results.dataset["load"].sel(increment=number))
    return f"increment {number}, {quantity(load, 'N', digits=6)}"


Made = tuple[str, str, Figure]


def embedded(caption: str, description: str, figure: Figure) -> ReportFigure:
    """Return a figure with its image encoded as text, so that the page needs no separate file."""
    buffer = io.BytesIO()
    draw(figure, buffer, format="png", dpi=DOTS_PER_INCH)
    text = base64.b64encode(buffer.getvalue()).decode("ascii")
    wide = bool(figure.get_size_inches()[0] > 6.5)
    return ReportFigure(caption, description, f"data:image/png;base64,{text}", wide)


def _contact(results: ContactResults) -> Iterator[Made]:
    number = results.number(results.peak)
    pressure = results.surface("pressure", results.peak)
    hertz_text = ", with the Hertz contact as a dashed line" if results.hertz is not None else ""
    for axis, across in (("x", "y"), ("y", "x")):
        if pressure.shape["xy".index(axis)] == 1:  # a line contact
            continue
        # adhering bodies pull along the edge, where the traction may be larger than in the middle
        row = results.row(np.maximum(pressure, 0.0), across)
        figure, cell = new_figure(), getattr(results.grid, f"d{across}")
        ax, label = figure.subplots(), results.pressure_label
        draw_pressure(pressure, results.grid, ax, results.hertz, axis, row, label)
        add_to_title(ax, elsewhere(across, row, cell))
        text = f"Pressure along {axis} at {place(across, row)}{hertz_text}; the maximum in the "
        text += f"grid is {pressure.max() * 1e-9:.4g} GPa."
        yield f"Pressure along {axis}, {_increment_text(results, number)}", text, figure
    for name in ("pressure", "gap") if results.has_map else ():
        figure = new_figure(*results.map_look[1])
        peak_map(results, name, figure.subplots())
        text = f"Map of the {name} on the whole grid."
        yield f"Map of the {name}, {_increment_text(results, number)}", text, figure
    if not has_curve(results.dataset):
        return
    figure = new_figure()
    plotting.load_approach(results.dataset, figure.subplots(), hertz=results.hertz)
    yield "Load–approach curve", f"Load versus approach of all increments{hertz_text}.", figure


def _volume(results: ContactResults) -> Iterator[Made]:
    if f"stress_body{results.body}" not in results.dataset:
        return
    data = results.dataset
    stored = data["output_increment"].values
    number = int(stored[peak_of_dataset(data.sel(increment=stored))])
    if results.has("stress", number):
        figure, stress = new_figure(4.6, 4.2), results.field("stress", number)
        plotting.axis_profile(
            stress,
            results.grid,
            figure.subplots(),
            body=results.graded,
            interfaces=results.interfaces,
        )
        when = f"body {results.body}, {_increment_text(results, number)}"
        text = f"Stresses along the axis versus depth.{_utilisation(results, stress)}"
        yield f"Stress along the axis, {when}", text, figure
    if results.has("interface_stress", number):
        yield _interfaces(results, number)
    for name in ("von_mises", "hydrostatic", "equivalent_plastic_strain"):
        if results.has(name, number):
            yield _section(results, name, number)


def _interfaces(results: ContactResults, number: int) -> Made:
    stress = results.field("interface_stress", number)
    shear = float(np.hypot(stress[:, 3], stress[:, 4]).max())
    tension = max(float(stress[:, :2].max()), 0.0), max(float(stress[:, 2].max()), 0.0)
    along, across, sheared = (f"{CONTACT['stress'].factor * v:.4g}" for v in (*tension, shear))
    text = (
        "Stress on both sides of the interfaces, along x. Maxima over the interfaces: in-plane "
        f"tension {along} MPa, normal tension {across} MPa, shear {sheared} MPa."
    )
    when = f"body {results.body}, {_increment_text(results, number)}"
    return f"Stress at the interfaces, {when}", text, interface_figure(results, number)


def _utilisation(results: ContactResults, stress: FloatArray) -> str:
    """Return a sentence that states the maximum ratio of von Mises to initial yield stress.

    The result is "" for an elastic body, and for a body that has neither layers nor a yield-stress
    profile nor an initial stress.
    """
    body, grid = results.graded, results.grid
    if body is None or not body.is_plastic:
        return ""
    ratio = von_mises(stress) / body.yield_stress_at(grid.z)
    n = np.unravel_index(int(np.argmax(ratio)), ratio.shape)
    centres = zip("xyz", (grid.x, grid.y, grid.z), n, strict=True)
    where = ", ".join(f"{axis} = {at[i] * 1e6:.4g} µm" for axis, at, i in centres)
    return f" Maximum of von Mises stress / initial yield stress: {ratio.max():.4g}, at {where}."


def _section(results: ContactResults, quantity: str, number: int) -> Made:
    values, shown = results.field(quantity, number), CONTACT[quantity]
    figure = new_figure(5.0, results.section_height)
    y = results.row(values)
    ax = plotting.section(
        values,
        results.grid,
        figure.subplots(),
        quantity=quantity,
        position=y,
        interfaces=results.interfaces,
        contact=repulsion_of(results.dataset).sel(increment=number).values,
    )
    add_to_title(ax, elsewhere("y", y, results.grid.dy))
    low, high = (f"{shown.factor * float(value):.4g}" for value in (values.min(), values.max()))
    text = (
        f"Section of the {shown.heading} in the plane {place('y', y)}. In the whole volume, its "
        f"values are from {low} to {high} {shown.shown}."
    )
    name = f"{shown.heading[0].upper()}{shown.heading[1:]}"
    return f"{name}, body {results.body}, {_increment_text(results, number)}", text, figure


def _adhesion(results: ContactResults) -> Iterator[Made]:
    captions = {
        "cohesive_zone": "Pressure, repulsion and attraction along x at the largest tension",
        "pull_off": "Largest tension versus Tabor number, with the curve of Maugis",
    }
    for name, figure in adhesion_figures(results.dataset).items():
        largest = -float(results.dataset["load"].min())
        yield captions[name], f"{captions[name]}: {quantity(largest, 'N')}.", figure


def _over_time(results: ContactResults) -> Iterator[Made]:
    data = results.dataset
    if not has_times(data):
        return
    last = float(data["time"].values[-1]) if "time" in data else 0.0
    text = f"Approach, contact radius and maximum pressure versus time, up to {last:.4g} s."
    yield "Contact over time", text, time_figure(data)


def _temperature(results: ContactResults) -> Iterator[Made]:
    if results.hottest is None:
        return
    rise, figure = results.surface("surface_temperature", results.hottest), new_figure()
    y = results.row(rise)
    ax = plotting.temperature_profile(rise, results.grid, figure.subplots(), position=y)
    add_to_title(ax, elsewhere("y", y, results.grid.dy))
    text = f"Temperature rise of the surface along x, up to {rise.max():.4g} K."
    when = f"body {results.body}, {_increment_text(results, results.number(results.hottest))}"
    yield f"Flash temperature, {when}", text, figure


def _imprint(results: ContactResults) -> Iterator[Made]:
    """Iterate over figures of residual imprint and residual stress after the last increment.

    If the results contain the track of a moving body, `_track` draws these figures instead.
    """
    if results.track is not None:
        return
    data, number = results.dataset, results.number(-1)
    figure = new_figure()
    ax, deepest = figure.subplots(), list[str]()
    for body in (1, 2):
        name = f"residual_displacement_body{body}"
        if name in data:
            values = data[name].values[-1]
            plotting.imprint_profile(values, results.grid, ax, label=f"body {body}")
            ax.lines[-1].set_linestyle("--" if deepest else "-")  # the imprints may coincide
            deepest.append(f"{values.max() * 1e9:.4g} nm in body {body}")
    if deepest:
        ax.legend(frameon=False)  # again, with the line styles
        text = f"Residual displacement of the surface along x, at most {', '.join(deepest)}."
        yield f"Residual imprint, {_increment_text(results, number)}", text, figure
    if f"residual_displacement_body{results.body}" in data and results.has_map:
        values = results.surface("residual_displacement", -1)
        across, size = results.map_look
        pressed, figure = results.surface("repulsion", results.peak), new_figure(*size)
        seen: Any = {"quantity": "imprint", "contact": pressed, "across": across}
        plotting.surface_map(values, results.grid, figure.subplots(), **seen)
        caption = (
            f"Map of the residual imprint, body {results.body}, {_increment_text(results, number)}"
        )
        yield caption, "Map of the residual displacement of the whole surface.", figure
    if results.has("residual_stress", number):
        yield _section(results, "residual_von_mises", number)


def _track(results: ContactResults) -> Iterator[Made]:
    if (track := results.track) is None:
        return
    depth, when = track["residual_displacement"].values, f"body {results.body}, unloaded"
    figure = new_figure()
    plotting.track.imprint_along(track, figure.subplots())
    text = f"Residual displacement along the track, at most {depth.max() * 1e9:.4g} nm."
    yield f"Residual imprint of the track, {when}", text, figure
    length, y = float(np.ptp(track["x"].values)), track["y"].values
    if results.has_map:
        figure = new_figure(5.0, map_height(5.0, length, float(np.ptp(y))))
        plotting.track_map(track, figure.subplots())
        text = "Map of the residual displacement of the track."
        yield f"Map of the residual imprint of the track, {when}", text, figure
    if "residual_von_mises" not in track:
        return
    text = f"Section along the track, up to {track['residual_von_mises'].max() * 1e-6:.4g} MPa."
    yield (
        f"Residual von Mises stress of the track, {when}",
        text,
        plotting.track.residual_along(track),
    )


def _convergence(results: ContactResults) -> Iterator[Made]:
    data = results.dataset
    number = data["increment"].values
    if number.size == 1:  # the table of convergence shows the same numbers
        return
    figure = new_figure(5.6, 5.2 if "plastic_strain_residual" in data else 2.7)
    if "plastic_strain_residual" in data:
        upper, lower = figure.subplots(2, 1, sharex=True)
        for name in ("plastic_strain_residual", "yield_violation"):
            values = data[name].values
            # zero and negative values are not shown on a logarithmic axis
            shown = np.where(values > 0, values, np.nan)
            upper.plot(number, shown, "o", markersize=3, label=CONTACT[name].heading)
        if "tol" in data.attrs:
            upper.axhline(flow_tol(data), color="k", linestyle="--", linewidth=1, label="tolerance")
        upper.set_yscale("log")
        upper.set_ylabel("relative residual [-]")
        upper.legend(**_LEGEND_ABOVE)
        finish(upper)
    else:
        lower = figure.subplots()
    for name, marker in (("contact_iterations", "s"), ("iterations", "o"), ("substeps", "^")):
        counts = data[name].values
        if name == "iterations" and not np.any(counts):  # elastic bodies
            continue
        lower.plot(number, counts, marker, markersize=3, label=CONTACT[name].heading)
    lower.set_xlabel("increment")
    lower.set_ylabel("number per increment")
    lower.legend(**_LEGEND_ABOVE)
    finish(counted(lower))
    text = "Residuals, tolerance and iterations of each increment; see the table."
    yield "Convergence", text, figure

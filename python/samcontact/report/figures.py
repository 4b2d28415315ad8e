# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a contact, drawn from a results file alone and kept as text."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from dataclasses import dataclass
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure

from .. import plotting
from .._peak import peak_of_dataset
from .._tensors import von_mises
from ..grid import Grid
from ..plotting.contact import HertzContact
from ..plotting.parts import (
    QUANTITIES,
    counted,
    draw,
    finish,
    new_figure,
    place,
    row_of_interest,
    section_height,
)
from ..results.vtk import cell_size

if TYPE_CHECKING:
    import xarray as xr

DOTS_PER_INCH = 120


class ReportFigure(NamedTuple):
    """A figure with its caption, its description for those who do not see it, and its image."""

    caption: str
    description: str
    source: str


@dataclass
class Scene:
    """What all figures need."""

    dataset: xr.Dataset
    grid: Grid
    body: int
    peak: int  # position of the increment with the largest stress
    hertz: HertzContact | None

    def field(self, name: str, increment: int) -> Any:
        """A volume field of the body at an increment that has one."""
        stored = self.dataset[f"{name}_body{self.body}"].sel(volume_increment=increment)
        axes = [axis for axis in ("component", "x", "y", "z") if axis in stored.dims]
        return stored.transpose(*axes).values

    def has(self, name: str) -> bool:
        return f"{name}_body{self.body}" in self.dataset

    def moment(self, increment: int) -> str:
        load = float(self.dataset["load"].sel(increment=increment))
        return f"increment {increment}, {load:.6g} N"


def grid_of(dataset: xr.Dataset) -> Grid:
    """The grid of a results file."""
    nx, ny = dataset.sizes["x"], dataset.sizes["y"]
    dx, dy = cell_size(dataset, "x"), cell_size(dataset, "y")
    if "z" not in dataset.sizes:
        return Grid(nx, ny, dx, dy)
    return Grid(nx, ny, dx, dy, dataset.sizes["z"], cell_size(dataset, "z"))


def contact_figures(
    dataset: xr.Dataset, body: int, peak: int, hertz: HertzContact | None
) -> list[ReportFigure]:
    """Of a contact: all that the stored fields allow."""
    scene = Scene(dataset, grid_of(dataset), body, peak, hertz)
    drawn = []
    for part in (_contact, _volume, _temperature, _remains, _track, _convergence):
        drawn += [embedded(*made) for made in part(scene)]
    return drawn


Made = tuple[str, str, Figure]


def embedded(caption: str, description: str, figure: Figure) -> ReportFigure:
    """The image as text, so that the page needs no other file."""
    buffer = io.BytesIO()
    draw(figure, buffer, format="png", dpi=DOTS_PER_INCH)
    text = base64.b64encode(buffer.getvalue()).decode("ascii")
    return ReportFigure(caption, description, f"data:image/png;base64,{text}")


def _contact(scene: Scene) -> Iterator[Made]:
    data, number = scene.dataset, int(scene.dataset["increment"][scene.peak])
    pressure, gap = (data[name].values[scene.peak] for name in ("pressure", "gap"))
    beside = ", with the Hertz contact as a dashed line" if scene.hertz is not None else ""
    for index, axis in enumerate("xy"):
        across = data["y" if axis == "x" else "x"].values
        row = float(across[row_of_interest(pressure.max(axis=index), across)])
        where = place("y" if axis == "x" else "x", row)
        figure = new_figure()
        plotting.pressure_profile(
            pressure, scene.grid, figure.subplots(), hertz=scene.hertz, axis=axis, position=row
        )
        text = f"Pressure along {axis} at {where}{beside}; its maximum in the grid is "
        text += f"{pressure.max() * 1e-9:.4g} GPa."
        yield f"Pressure along {axis}, {scene.moment(number)}", text, figure
    state: Any = SimpleNamespace(pressure=pressure, gap=gap)
    for quantity in ("pressure", "gap"):
        figure = new_figure()
        plotting.surface_map(state, scene.grid, figure.subplots(), quantity=quantity)
        text = f"The {quantity} of the whole grid from above."
        yield f"Map of the {quantity}, {scene.moment(number)}", text, figure
    if not np.any(np.isfinite(data["approach"])):
        return
    states: Any = [
        SimpleNamespace(load=float(load), approach=float(approach))
        for load, approach in zip(data["load"].values, data["approach"].values, strict=True)
    ]
    figure = new_figure()
    plotting.load_approach(states, figure.subplots(), hertz=scene.hertz)
    yield "Load against approach", f"Load against approach of all increments{beside}.", figure


def _volume(scene: Scene) -> Iterator[Made]:
    if not scene.has("stress"):
        return
    data = scene.dataset
    stored = data["volume_increment"].values
    number = int(stored[peak_of_dataset(data.sel(increment=stored))])
    state: Any = SimpleNamespace(
        **{
            name: lambda body, name=name: scene.field(name, number)
            for name in ("stress", "von_mises", "hydrostatic")
        }
    )
    figure = new_figure(4.6, 4.2)
    plotting.axis_profile(state, scene.grid, figure.subplots(), body=scene.body)
    when = f"body {scene.body}, {scene.moment(number)}"
    yield f"Stress under the middle, {when}", "Stresses on the axis against depth.", figure
    for name in ("von_mises", "hydrostatic", "equivalent_plastic_strain"):
        if scene.has(name):
            values = scene.field(name, number)
            yield _section(scene, values, name, when)


def _section(scene: Scene, values: Any, quantity: str, when: str) -> Made:
    grid = scene.grid
    height = section_height(5.0, grid.nx * grid.dx, grid.nz * (grid.dz or 0.0))
    figure = new_figure(5.0, height)
    y = float(grid.y[row_of_interest(np.abs(values).max(axis=(0, 2)), grid.y)])
    plotting.section(values, grid, figure.subplots(), quantity=quantity, position=y)
    label, factor, unit, _ = QUANTITIES[quantity]
    low, high = (f"{factor * float(value):.4g}" for value in (np.min(values), np.max(values)))
    where = place("y", y)
    text = (
        f"Section in the plane {where} of the {label}, from {low} to {high} {unit} in the volume."
    )
    return f"{label[0].upper()}{label[1:]}, {when}", text, figure


def _temperature(scene: Scene) -> Iterator[Made]:
    name = f"surface_temperature_body{scene.body}"
    if name not in scene.dataset:
        return
    rises = scene.dataset[name].values
    hottest = int(np.argmax(rises.max(axis=(1, 2))))
    figure = new_figure()
    y = float(scene.grid.y[row_of_interest(rises[hottest].max(axis=0), scene.grid.y)])
    plotting.temperature_profile(rises[hottest], scene.grid, figure.subplots(), position=y)
    text = f"Rise of temperature of the surface along x, up to {rises[hottest].max():.4g} K."
    number = int(scene.dataset["increment"][hottest])
    yield f"Flash temperature, body {scene.body}, {scene.moment(number)}", text, figure


def _remains(scene: Scene) -> Iterator[Made]:
    """Print and residual stress after the last increment; of a track all of it, see there."""
    data, number = scene.dataset, int(scene.dataset["increment"][-1])
    if f"track_residual_displacement_body{scene.body}" in data:
        return
    figure, deepest = new_figure(), []
    ax = figure.subplots()
    for body in (1, 2):
        name = f"residual_displacement_body{body}"
        if name in data:
            values = data[name].values[-1]
            plotting.print_profile(values, scene.grid, ax, label=f"body {body}")
            deepest.append(f"{values.max() * 1e9:.4g} nm in body {body}")
    if deepest:
        text = f"Permanent displacement of the surface along x, at most {', '.join(deepest)}."
        yield f"Print, {scene.moment(number)}", text, figure
    if f"residual_displacement_body{scene.body}" in data:
        values = data[f"residual_displacement_body{scene.body}"].values[-1]
        figure = new_figure()
        plotting.surface_map(values, scene.grid, figure.subplots(), quantity="print")
        caption = f"Map of the print, body {scene.body}, {scene.moment(number)}"
        yield caption, "Permanent displacement of the whole surface from above.", figure
    if scene.has("residual_stress") and number in data["volume_increment"].values:
        values = von_mises(scene.field("residual_stress", number))
        when = f"body {scene.body}, {scene.moment(number)}"
        yield _section(scene, values, "residual_von_mises", when)


def _track(scene: Scene) -> Iterator[Made]:
    body = scene.body
    name = f"track_residual_displacement_body{body}"
    if name not in scene.dataset:
        return
    values = scene.dataset[name].values
    track: Any = SimpleNamespace(
        x=scene.dataset[f"track_x_body{body}"].values,
        y=scene.dataset["y"].values,
        grid=scene.grid,
        body=body,
        residual_displacement=lambda: values,
    )
    when = f"body {body}, unloaded"
    figure = new_figure()
    plotting.track.print_along(track, figure.subplots())
    text = f"Permanent displacement along the track, at most {values.max() * 1e9:.4g} nm."
    yield f"Print of the track, {when}", text, figure
    length = float(np.ptp(track.x))
    figure = new_figure(5.0, section_height(5.0, length, float(np.ptp(track.y))))
    plotting.track_map(track, figure.subplots())
    yield f"Map of the print of the track, {when}", "The track from above.", figure
    name = f"track_residual_von_mises_body{body}"
    if name not in scene.dataset:
        return
    residual = scene.dataset[name].values
    y = float(track.y[row_of_interest(residual.max(axis=(0, 2)), track.y)])
    track.residual_von_mises = lambda: residual
    depth = scene.grid.nz * (scene.grid.dz or 0.0)
    figure = new_figure(5.0, section_height(5.0, length, depth))
    plotting.track_section(track, figure.subplots(), position=y)
    text = f"Section along the track at {place('y', y)}, up to {residual.max() * 1e-6:.4g} MPa."
    yield f"Residual von Mises stress of the track, {when}", text, figure


def _convergence(scene: Scene) -> Iterator[Made]:
    data = scene.dataset
    number = data["increment"].values
    figure = new_figure(5.6, 4.6 if "plastic_residual" in data else 2.4)
    if "plastic_residual" in data:
        upper, lower = figure.subplots(2, 1, sharex=True)
        for name in ("plastic_residual", "yield_excess"):
            values = data[name].values
            # a logarithm shows what is above zero
            shown = np.where(values > 0, values, np.nan)
            upper.plot(number, shown, "o", markersize=3, label=name.replace("_", " "))
        if "tol" in data.attrs:
            upper.axhline(data.attrs["tol"], color="k", linestyle="--", linewidth=1, label="tol")
        upper.set_yscale("log")
        upper.set_ylabel("relative [-]")
        upper.legend(frameon=False)
        finish(upper)
    else:
        lower = figure.subplots()
    for name, marker in (("contact_iterations", "s"), ("iterations", "o"), ("substeps", "^")):
        label = {"iterations": "plastic iterations"}.get(name, name.replace("_", " "))
        lower.plot(number, data[name].values, marker, markersize=3, label=label)
    lower.set_xlabel("increment")
    lower.set_ylabel("count")
    lower.legend(frameon=False)
    finish(counted(lower))
    text = "Residuals against the tolerance, and iterations, of each increment; see the table."
    yield "Convergence", text, figure

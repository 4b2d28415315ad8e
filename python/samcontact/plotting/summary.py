# SPDX-License-Identifier: GPL-3.0-or-later
"""The standard figures of a run, as files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .._checks import choice
from .._peak import peak_of_states
from .._tensors import von_mises
from .contact import (
    HertzContact,
    axis_profile,
    load_approach,
    pressure_profile,
    print_profile,
    section,
    temperature_profile,
)
from .maps import surface_map, track_map
from .parts import new_figure, place, row_of_interest, save, section_height
from .track import print_along, track_section, track_summary

if TYPE_CHECKING:
    from ..simulation import Simulation
    from ..state import State

_WIDTH = 5.0  # of a figure [in]


def summary_figures(
    simulation: Simulation,
    states: Sequence[State],
    directory: str | Path,
    *,
    body: int = 2,
    hertz: HertzContact | None = None,
    peak: State | None = None,
) -> list[Path]:
    """Write the standard figures of a run as PNG files.

    Profiles and sections run through the middle, or where there is most to see if that is
    elsewhere, as on rough surfaces.

    Parameters
    ----------
    simulation : Simulation
        Gives the grid and the materials.
    states : sequence of State
        In the order of the path.
    directory : str or Path
        Created when missing.
    body : {1, 2}
        Whose stresses and print are shown.
    hertz : PointContact or EllipticContact, optional
        Hertz contact at the load of the peak.
    peak : State, optional
        Whose pressure, gap and stresses are shown; default that of the largest von Mises stress.

    Returns
    -------
    list of Path
        pressure.png, pressure_map.png, gap_map.png and load_approach.png; with a volume
        axis_stress.png and sections.png; for a heated body flash_temperature.png and, with a
        volume, temperature.png (hottest increment); for an inelastic body print.png, print_map.png
        and residual.png (last increment; all of its track when it moved) and, when it moved,
        track_print.png and track_sections.png.

    Raises
    ------
    ValueError
        No states, or an unknown body.
    """
    if len(states) == 0:
        raise ValueError("states must hold at least one state, got none")
    choice("body", body, (1, 2))
    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    material = simulation.body1 if body == 1 else simulation.body2
    if peak is None:
        peak = states[peak_of_states(states, body)]
    figures = _of_the_peak(peak, body, material.law == "rigid", material.is_plastic, hertz)
    figures["load_approach"] = _panel()
    load_approach(states, figures["load_approach"].axes[0], hertz=hertz)
    figures |= _of_the_hottest(states, body)
    if material.is_plastic:
        if any(state.travel[body - 1] for state in states):
            figures |= _of_the_track(states[-1], body) | track_summary(states, body)
        else:
            figures |= _of_the_print(states[-1], body)
    return [save(figure, folder / f"{name}.png") for name, figure in figures.items()]


def _panel(width: float = _WIDTH, height: float = 3.6) -> Figure:
    figure = new_figure(width, height)
    figure.subplots()
    return figure


def _moment(state: State) -> str:
    return f"load {state.load:.6g} N"


def _titled(ax: Axes, *texts: str) -> None:
    """Add to the title of an axes."""
    ax.set_title(", ".join(text for text in (ax.get_title(), *texts) if text), fontsize="medium")


def _of_the_peak(
    state: State, body: int, rigid: bool, inelastic: bool, hertz: HertzContact | None
) -> dict[str, Figure]:
    """Pressure and gap, and stresses where there is a volume."""
    grid = state.grid
    figures = {name: _panel() for name in ("pressure", "pressure_map", "gap_map")}
    row = row_of_interest(state.pressure.max(axis=0), grid.y)
    y = float(grid.y[row])
    ax = pressure_profile(state, grid, figures["pressure"].axes[0], hertz=hertz, position=y)
    _titled(ax, _moment(state), _where(y, grid.dy))
    for quantity in ("pressure", "gap"):
        surface_map(state, grid, figures[f"{quantity}_map"].axes[0], quantity=quantity)
    if grid.nz > 0 and not rigid:
        figures["axis_stress"] = _panel(4.6, 4.2)
        ax = axis_profile(state, grid, figures["axis_stress"].axes[0], body=body)
        figures["sections"] = _sections(state, body, inelastic)
    return figures


def _where(y: float, cell: float) -> str:
    """Of a row that is not in the middle."""
    return "" if abs(y) <= 0.5 * cell else place("y", y)


def _sections(state: State, body: int, inelastic: bool) -> Figure:
    grid = state.grid
    names = ["von_mises", "hydrostatic"] + ["equivalent_plastic_strain"] * inelastic
    fields = {name: getattr(state, name)(body=body) for name in names}
    y = float(grid.y[row_of_interest(fields["von_mises"].max(axis=(0, 2)), grid.y)])
    height = section_height(_WIDTH, grid.nx * grid.dx, grid.nz * (grid.dz or 0.0))
    figure = new_figure(_WIDTH, height * len(names))
    for ax, name in zip(np.ravel(figure.subplots(len(names), 1)), names, strict=True):
        section(fields[name], grid, ax, quantity=name, position=y)
    _titled(figure.axes[0], _where(y, grid.dy))
    return figure


def _of_the_hottest(states: Sequence[State], body: int) -> dict[str, Figure]:
    """Temperatures of a heated body."""
    hottest = max(states, key=lambda state: float(state.surface_temperature(body=body).max()))
    rise, grid = hottest.surface_temperature(body=body), hottest.grid
    if not np.any(rise):
        return {}
    figures = {"flash_temperature": _panel()}
    y = float(grid.y[row_of_interest(rise.max(axis=0), grid.y)])
    ax = temperature_profile(rise, grid, figures["flash_temperature"].axes[0], position=y)
    _titled(ax, _moment(hottest), _where(y, grid.dy))
    if grid.nz > 0:
        height = section_height(_WIDTH, grid.nx * grid.dx, grid.nz * (grid.dz or 0.0))
        figures["temperature"] = _panel(_WIDTH, height)
        field, ax = hottest.temperature(body=body), figures["temperature"].axes[0]
        section(field, grid, ax, quantity="temperature", position=y)
    return figures


def _of_the_print(state: State, body: int) -> dict[str, Figure]:
    """What stays of a contact in its place: the print, and the residual stress."""
    grid = state.grid
    depth = state.residual_displacement(body=body)
    figures = {name: _panel() for name in ("print", "print_map")}
    y = float(grid.y[row_of_interest(np.abs(depth).max(axis=0), grid.y)])
    ax = print_profile(depth, grid, figures["print"].axes[0], position=y)
    _titled(ax, _moment(state), _where(y, grid.dy))
    surface_map(depth, grid, figures["print_map"].axes[0], quantity="print")
    residual = von_mises(np.asarray(state.residual_stress(body=body)))
    y = float(grid.y[row_of_interest(residual.max(axis=(0, 2)), grid.y)])
    height = section_height(_WIDTH, grid.nx * grid.dx, grid.nz * (grid.dz or 0.0))
    figures["residual"] = _panel(_WIDTH, height)
    ax = figures["residual"].axes[0]
    section(residual, grid, ax, quantity="residual_von_mises", position=y)
    _titled(ax, _where(y, grid.dy))
    return figures


def _of_the_track(state: State, body: int) -> dict[str, Figure]:
    """The same of a contact that moved: all of what it left, not what is in the grid at last."""
    track = state.track(body=body)
    grid, length = track.grid, float(np.ptp(track.x))
    figures = {"print": _panel()}
    print_along(track, figures["print"].axes[0])
    height = section_height(_WIDTH, length, grid.ny * grid.dy)
    figures["print_map"] = _panel(_WIDTH, height)
    track_map(track, figures["print_map"].axes[0])
    height = section_height(_WIDTH, length, grid.nz * (grid.dz or 0.0))
    figures["residual"] = _panel(_WIDTH, height)
    residual = track.residual_von_mises()
    y = float(track.y[row_of_interest(residual.max(axis=(0, 2)), track.y)])
    ax = track_section(track, figures["residual"].axes[0], position=y)
    _titled(ax, _where(y, grid.dy))
    return figures

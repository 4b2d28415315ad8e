# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of a lubricated contact: films, formulas, checks and figures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.check import Check
from .._util.film_quantities import FILMS
from ..lubrication.share_error import MAX_ERROR
from ..lubrication.steady import CELLS_PER_RADIUS, MAX_CHANGE, MAX_EDGE_PRESSURE
from ..plotting.film_summary import film_figures
from ..results.reading import cell_size
from .figures import embedded
from .tables import Cell, Table, cell, maxima_table, values_table

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import FilmCase

REQUIRED_VARIABLES = ("central_film", "minimum_film", "film", "filling", "pressure", "residual")
DEFAULT_TOL = 1e-6
MAX_LOAD_ERROR = 1e-5
"""Limit of the relative difference between the load and the integral of the pressure."""
MAX_FLOW_IMBALANCE = 1e-4
"""Limit of the net outflow from the grid, relative to the flow through the central film."""
MAX_HEAT_IMBALANCE = 0.1
"""Limit of the relative difference between the heat that enters both bodies and the dissipated
power. The power includes the work of the flow against the pressure gradient; the work of
compression is omitted."""
MAX_GAP_MISMATCH = 0.02
"""Limit of the difference between the gap for which the film was solved and the gap of the
plastically deformed bodies, relative to the central film thickness."""
_VALUES = (
    "time", "speed", "load", "approach", "max_pressure", "central_film", "minimum_film",
    "lambda_ratio", "boundary_share", "share_uncertainty", "friction_coefficient",
    "rolling_resistance", "power", "max_film_rise", "max_surface_rise", "max_von_mises",
    "max_plastic_strain", "max_residual_stress", "imprint",
)  # fmt: skip
_CONVERGENCE = (
    "iterations", "residual", "flow_imbalance", "inlet_pressure", "outlet_pressure",
    "cells_per_radius", "film_change", "heat", "gap_mismatch",
)  # fmt: skip


def content(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the variables of the page template for a lubricated contact."""
    answers = maxima_table(dataset, "increment", FILMS, _VALUES)
    of = "instants" if "time" in dataset else "loads" if "imprint" in dataset else "speeds"
    note = f"Maximum magnitude over the {of}, and the number of the {of[:-1]} at which it occurs."
    if text := str(dataset.attrs.get("friction_note", "")):
        note = f"{note} No {text}."
    first = f"{of[:-1]} no."
    answers = answers._replace(headings=[first, *answers.headings[1:]], note=note)
    found = [("results", "Results", answers)]
    if "formula_minimum_film" in dataset:
        found.append(("formula", "Comparison with the formula", _formula_table(dataset, first)))

    def table(names: tuple[str, ...]) -> Table:
        return values_table(dataset, "increment", FILMS, names)._replace(first=first)

    drawn = film_figures(dataset, stored_film_case(dataset))
    return {
        "file": "film.nc",
        "answers": found,
        "values": [("speeds", of.capitalize(), table(_VALUES))],
        "convergence": [("convergence", "Convergence", table(_CONVERGENCE))],
        "figures": [embedded(one.caption, one.description, one.figure) for one in drawn],
    }  # fmt: skip


def checks(dataset: xr.Dataset) -> Iterator[Check]:
    """Check load, flow and mass balances, cavitation, pressure at the edges, and resolution."""
    area = cell_size(dataset, "x") * cell_size(dataset, "y")
    load, pressure = dataset["load"].values, dataset["pressure"].values
    carried = pressure.sum(axis=(1, 2)) * area
    name = "load balance: difference of load and integral of the pressure, relative to the load"
    yield Check(name, float(np.abs(carried / load - 1.0).max()), MAX_LOAD_ERROR)
    name = "flow balance: largest imbalance of a cell, relative to the flow of the central film"
    tol = float(dataset.attrs.get("tol", DEFAULT_TOL))
    yield Check(name, float(dataset["residual"].max()), tol)
    name = "mass balance: net outflow of the grid, relative to the flow of the central film"
    if "time" in dataset:
        name = "mass balance: net outflow plus rate of change of the oil, relative to the flow"
    yield Check(name, float(dataset["flow_imbalance"].max()), MAX_FLOW_IMBALANCE)
    layer = dataset["boundary_pressure"].values if "boundary_pressure" in dataset else 0.0
    cavitated = np.where(dataset["filling"].values < 1.0, np.abs(pressure - layer), 0.0)
    name = "cavitation: pressure of the fluid in cavitated cells, relative to the maximum pressure"
    yield Check(name, float(cavitated.max() / pressure.max()), MAX_LOAD_ERROR)
    name = "minimum film"
    yield Check(name, float(dataset["film"].min()), np.finfo(np.float64).tiny, True, "m")
    name = "inlet: pressure next to the edge where lubricant enters, relative to the maximum"
    yield Check(name, float(dataset["inlet_pressure"].max()), MAX_EDGE_PRESSURE)
    name = "outlet: pressure next to the edge where lubricant leaves, relative to the maximum"
    yield Check(name, float(dataset["outlet_pressure"].max()), MAX_EDGE_PRESSURE)
    name = "cells per contact radius"
    yield Check(name, float(dataset["cells_per_radius"].min()), CELLS_PER_RADIUS, True)
    if "gap_mismatch" in dataset:
        name = "plastic flow: mismatch of the gaps of film and bodies, relative to the central film"
        yield Check(name, float(dataset["gap_mismatch"].max()), MAX_GAP_MISMATCH)
    if "share_uncertainty" in dataset:
        name = "load share of the boundary layer: estimated relative error due to the grid"
        errors = (dataset["share_uncertainty"] / dataset["boundary_share"]).values
        yield Check(name, float(np.nanmax(errors)), MAX_ERROR)
    if "heat" in dataset:
        name = "heat balance: difference of heat and dissipated power, relative to the power"
        lost = float(np.nanmax(np.abs(dataset["heat"] / dataset["power"] - 1.0)))
        yield Check(name, lost, MAX_HEAT_IMBALANCE)
    if "film_change" in dataset:
        name = "change of the central film between the last two grids, relative to the film"
        yield Check(name, float(dataset["film_change"].max()), MAX_CHANGE)


def stored_film_case(dataset: xr.Dataset) -> FilmCase | None:
    """Return the case stored with the results, or None if the case is missing or unreadable."""
    from ..cases import CaseError, FilmCase, parse_case

    try:
        case = parse_case(str(dataset.attrs.get("case", "")))
    except CaseError:
        return None
    return case if isinstance(case, FilmCase) else None


def _formula_table(dataset: xr.Dataset, first: str) -> Table:
    """Return the table of film thicknesses by the formula and by the solution."""
    names = [name for name in ("central_film", "minimum_film") if f"formula_{name}" in dataset]
    headings, columns = [], []
    for name in names:
        shown = FILMS[name]
        formula, solved = dataset[f"formula_{name}"].values, dataset[name].values
        headings += [FILMS[f"formula_{name}"].label, shown.label, "difference [%]"]
        columns.append((formula, solved, shown.factor))
    rows = []
    for n, number in enumerate(dataset["increment"].values):
        cells: list[Cell] = []
        for formula, solved, factor in columns:
            cells += [cell(formula[n], factor), cell(solved[n], factor)]
            cells.append(cell(solved[n] / formula[n] - 1.0, 100.0))
        rows.append((str(number), cells))
    regime = str(dataset.attrs.get("regime", ""))
    note = (
        f"Formula of {dataset.attrs.get('formula', '')}, regime {regime}, without a boundary layer."
    )
    return Table(headings, rows, first, note)

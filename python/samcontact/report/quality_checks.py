# SPDX-License-Identifier: GPL-3.0-or-later
"""What a results file tells about whether its run can be trusted, computed from its fields."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from .._util.check import Check
from .._util.checks import FloatArray
from ..accuracy.grid_errors import LARGEST_ERROR, LARGEST_SHARE, error_rows
from ..diagnostics.expected_contact import Expected
from ..diagnostics.monitor import SMALL_STRAIN
from ..diagnostics.plausibility import Contact, doubts_of
from ..diagnostics.resolution import FEW, TOO_FEW, TOO_UNCERTAIN
from ..results.contact import repulsion_of
from ..results.reading import cell_size, grid_of
from ..scene.contact_law import in_contact
from ..scene.heating import COLD
from . import slipping

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case

DEFAULT_TOL = 1e-6  # of files that do not tell theirs


def verdicts(dataset: xr.Dataset, case: Case | None) -> list[Check]:
    """Check balance, complementarity, yield, borders, resolution and strain, as far as stored."""
    tol = float(dataset.attrs.get("tol", DEFAULT_TOL))
    return [
        _load_balance(dataset, case, tol),
        *_complementarity(dataset, tol),
        *slipping.checks(dataset, case, tol),
        *_yield_condition(dataset, tol),
        *_borders(dataset),
        *_resolution(dataset, case),
        *([] if case is None else _plausibility(dataset, case)),
        *_strains(dataset),
        *_errors(dataset),
    ]


def _load_balance(dataset: xr.Dataset, case: Case | None, tol: float) -> Check:
    """Against what the case asks for; a load that the run has found is only recomputed."""
    area = cell_size(dataset, "x") * cell_size(dataset, "y")
    total = area * dataset["pressure"].values.sum(axis=(1, 2))
    wanted = dataset["load"].values.copy()
    steps = case.steps() if case is not None else []
    if len(steps) == len(wanted):
        for index, step in enumerate(steps):
            wanted[index] = step.get("load", wanted[index])
    scale = float(np.max(np.abs(wanted))) or 1.0
    error = float(np.max(np.abs(total - wanted))) / scale
    return Check("load balance: sum of p dA against the load, relative", error, tol)


def _complementarity(dataset: xr.Dataset, tol: float) -> Iterator[Check]:
    """Pressure and gap, both without a sign, where a contact was solved."""
    approach = dataset["approach"].values
    solved = np.isfinite(approach)  # prescribed tractions have no approach
    if not np.any(solved):
        return
    pressure = repulsion_of(dataset).values[solved]
    gap = dataset["gap"].values[solved]
    initial = dataset["initial_gap"].values
    body = np.isfinite(initial)
    moved = gap - np.where(body, initial, 0.0) + approach[solved, None, None]
    # nothing is known of it where there is no body
    displacement: FloatArray = np.max(np.abs(moved), axis=(1, 2), initial=0.0, where=body)
    yield Check("least pressure", float(pressure.min()), 0.0, at_least=True, unit="Pa")
    largest = float(displacement.max())
    if largest > 0:
        name = "least gap over the largest displacement"
        yield Check(name, float(gap.min()) / largest, -tol, at_least=True)
    loaded = in_contact(np.max(pressure, axis=(1, 2)))
    if np.any(loaded):
        peak = np.max(pressure[loaded], axis=(1, 2), keepdims=True)
        ratio = gap[loaded] / displacement[loaded, None, None]
        both = np.abs(np.minimum(pressure[loaded] / peak, ratio))
        name = "complementarity: least of p/max p and gap/displacement, largest in a cell"
        yield Check(name, float(both.max()), tol)


def _yield_condition(dataset: xr.Dataset, tol: float) -> Iterator[Check]:
    for variable, name in (
        ("yield_excess", "stress beyond the yield stress, relative"),
        ("plastic_residual", "last change of the plastic strain, relative"),
    ):
        if variable in dataset:
            yield Check(name, float(dataset[variable].max()), tol)


def _borders(dataset: xr.Dataset) -> Iterator[Check]:
    names = {"contact_margin": "cells between contact and border of the grid"}
    for body in (1, 2):
        text = f"cells between plastic zone and border of the volume, body {body}"
        names[f"plastic_margin_body{body}"] = text
    for variable, name in names.items():
        if variable not in dataset:
            continue
        margins = dataset[variable].values
        if np.any(np.isfinite(margins)):  # else there was no contact, no flow
            yield Check(name, float(np.nanmin(margins)), 1.0, at_least=True)


def _resolution(dataset: xr.Dataset, case: Case | None) -> Iterator[Check]:
    """Under the largest load, and of the whole plastic zone."""
    if "contact_cells" in dataset:
        cells = dataset["contact_cells"].values
        peak = int(np.argmax(np.where(np.isnan(cells), -1.0, dataset["load"].values)))
        load = float(dataset["load"].values[peak])
        hertz = case.hertz(load) if case is not None and load > 0 else None
        if np.isfinite(cells[peak]):
            beside = "" if hertz is None else f" ({Expected(hertz)})"
            yield contact_cells(float(cells[peak]), beside, FEW)
        uncertain = dataset.get("area_uncertainty")
        if "sharp_cells" in dataset:
            name = "cells at sharp edges, where the pressure does not converge"
            yield Check(name, float(dataset["sharp_cells"].max()), 0.0)
        if uncertain is not None and np.isfinite(uncertain[peak]):
            name = "relative uncertainty of the contact area under the largest load"
            yield Check(name, float(uncertain[peak]), TOO_UNCERTAIN)
    for body in (1, 2):
        layers = dataset.get(f"plastic_layers_body{body}")
        if layers is not None:
            yield from plastic_layers(layers.values, body)


def _plausibility(dataset: xr.Dataset, case: Case) -> Iterator[Check]:
    """Of the scene as it was given, under the largest load."""
    load = float(dataset["load"].max())
    hertz = case.hertz(load) if load > 0 else None
    expected = None if hertz is None else Expected(hertz)
    contact = None if expected is None else Contact(expected, expected.along_axes)
    heat = COLD if case.heat is None else case.heat.build()
    bodies = case.body1.build(), case.body2.build()
    grid = grid_of(dataset) if case.grid is None else case.grid.build()
    for doubt in doubts_of(contact, grid, bodies, heat):
        yield doubt.verdict


def contact_cells(cells: float, beside: str = "", few: int = TOO_FEW) -> Check:
    """Whether the grid resolves the contact; what is expected of that goes beside."""
    name = f"cells across the contact under the largest load{beside}"
    return Check(name, cells, few, at_least=True)


def plastic_layers(layers: ArrayLike, body: int) -> Iterator[Check]:
    """Whether the layers resolve the plastic zone where it is highest; none without one."""
    highest = np.max(np.nan_to_num(layers))
    if highest > 0:
        name = f"layers of the plastic zone, body {body}"
        yield Check(name, float(highest), TOO_FEW, at_least=True)


def _strains(dataset: xr.Dataset) -> Iterator[Check]:
    for body in (1, 2):
        variable = f"max_plastic_strain_magnitude_body{body}"
        if variable in dataset:
            name = f"largest plastic strain magnitude, body {body}"
            yield Check(name, float(dataset[variable].max()), SMALL_STRAIN)


def _errors(dataset: xr.Dataset) -> Iterator[Check]:
    """The largest of all, or each that an accuracy was asked for; what a surface has beyond its
    grid."""
    rows = error_rows(dataset)
    estimated = [row for row in rows if row.asked is None and np.isfinite(row.relative)]
    if estimated:
        worst = max(estimated, key=lambda row: row.relative)
        name = f"largest estimated error by the cells, relative: {worst.label}"
        yield Check(name, worst.relative, LARGEST_ERROR)
    start = "increment_error_"
    if shares := [share for name, share in dataset.attrs.items() if str(name).startswith(start)]:
        name = "largest estimated error by the increments, relative"
        yield Check(name, float(max(shares)), LARGEST_ERROR)
    for row in rows:
        if row.asked is not None:
            yield Check(f"estimated relative error, {row.label}", row.relative, row.asked)
    if "slope_beyond" in dataset.attrs:
        name = "share of the mean square slope of the surface in waves shorter than four cells"
        yield Check(name, float(dataset.attrs["slope_beyond"]), LARGEST_SHARE)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the reliability of a run, computed from the fields of its results file."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from .._util.check import Check
from .._util.checks import FloatArray
from ..accuracy.error_rows import error_rows
from ..accuracy.grid_errors import MAX_RELATIVE_ERROR, MAX_SLOPE_FRACTION
from ..diagnostics.adhesion import EDGE_ATTRACTION, attraction_at_edge
from ..diagnostics.expected_contact import ExpectedContact, ExpectedExtent
from ..diagnostics.monitor import MAX_SMALL_STRAIN
from ..diagnostics.plausibility import plausibility_checks
from ..diagnostics.resolution import AREA_ERROR_LIMIT, MINIMUM_CELLS, RECOMMENDED_CELLS
from ..problem.adhesion_laws import MAX_RESOLVED
from ..problem.contact_law import in_contact
from ..problem.heating import NO_HEAT
from ..results.contact import repulsion_of
from ..results.reading import cell_size, grid_of
from . import slipping

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case

INCLUSION_TOL = 1e-3
"""Minimum tolerance for checks of bodies with inclusions [-]: the smallest tolerance that can be
reached with voids, see docs/theory/inclusions.md."""
DEFAULT_TOL = 1e-6  # tolerance [-] assumed for files without one


def all_checks(dataset: xr.Dataset, case: Case | None) -> list[Check]:
    """Return the checks of a contact: equilibrium, yield, edges, resolution, strain and errors.

    A check is omitted if the required variables are not stored. Plausibility checks of the input
    are marked `of_input`.
    """
    tol = float(dataset.attrs.get("tol", DEFAULT_TOL))
    return [
        _load_balance(dataset, case, tol),
        *_complementarity(dataset, tol),
        *slipping.checks(dataset, case, tol),
        *_yield_condition(dataset),
        *_borders(dataset),
        *_adhesion(dataset),
        *_resolution(dataset, case),
        *([] if case is None else _plausibility(dataset, case)),
        *_strains(dataset),
        *_errors(dataset),
    ]


def _load_balance(dataset: xr.Dataset, case: Case | None, tol: float) -> Check:
    """Compare the integrated pressure with the load prescribed by the case.

    Without a prescribed load, the stored load is used.
    """
    area = cell_size(dataset, "x") * cell_size(dataset, "y")
    total = area * dataset["pressure"].values.sum(axis=(1, 2))
    targets = dataset["load"].values.copy()
    steps = case.steps() if case is not None else []
    if len(steps) == len(targets):
        for index, step in enumerate(steps):
            targets[index] = step.get("load", targets[index])
    scale = float(np.max(np.abs(targets))) or 1.0
    error = float(np.max(np.abs(total - targets))) / scale
    name = "load balance: relative difference between integrated pressure and load"
    return Check(name, error, tol)


def _lowered_by_tilt(dataset: xr.Dataset) -> FloatArray:
    """Return how far tilt moves body 1 towards body 2 [m], shape (increment, x, y)."""
    if "tilt_x" not in dataset:
        return np.zeros((dataset.sizes["increment"], 1, 1))
    x, y = dataset["x"].values, dataset["y"].values
    about_x, about_y = (dataset[f"tilt_{axis}"].values[:, None, None] for axis in "xy")
    lowered: FloatArray = about_x * y - about_y * x[:, None]
    return lowered


def _complementarity(dataset: xr.Dataset, tol: float) -> Iterator[Check]:
    """Check that pressure and gap are not negative and that one of them is zero in each cell."""
    approach = dataset["approach"].values
    solved = np.isfinite(approach)  # prescribed tractions have no approach
    if not np.any(solved):
        return
    pressure = repulsion_of(dataset).values[solved]
    gap = dataset["gap"].values[solved]
    initial = dataset["initial_gap"].values
    body = np.isfinite(initial)
    lowered = approach[solved, None, None] + _lowered_by_tilt(dataset)[solved]
    moved = gap - np.where(body, initial, 0.0) + lowered
    # the displacement is undefined where there is no body
    displacement: FloatArray = np.max(np.abs(moved), axis=(1, 2), initial=0.0, where=body)
    name = "minimum contact pressure"
    yield Check(name, float(pressure.min()), 0.0, at_least=True, unit="Pa")
    largest = float(displacement.max())
    if largest > 0:
        name = "minimum gap, relative to the maximum displacement (negative: interpenetration)"
        yield Check(name, float(gap.min()) / largest, -tol, at_least=True)
    loaded = in_contact(np.max(pressure, axis=(1, 2)))
    if np.any(loaded):
        peak = np.max(pressure[loaded], axis=(1, 2), keepdims=True)
        ratio = gap[loaded] / displacement[loaded, None, None]
        both = np.abs(np.minimum(pressure[loaded] / peak, ratio))
        name = "complementarity error: max |min(p/p_max, gap/u_max)|"
        yield Check(name, float(both.max()), tol)


def _yield_condition(dataset: xr.Dataset) -> Iterator[Check]:
    for variable, name in (
        ("yield_violation", "maximum relative violation of the yield condition"),
        (
            "plastic_strain_residual",
            "relative change of the plastic strain increment at convergence",
        ),
    ):
        if variable not in dataset:
            continue
        yield Check(name, float(dataset[variable].max()), flow_tol(dataset))


def flow_tol(dataset: xr.Dataset) -> float:
    """Return the tolerance for the checks of plastic strain and yield condition [-]."""
    tol = float(dataset.attrs.get("tol", DEFAULT_TOL))
    return max(tol, INCLUSION_TOL) if _has_inclusions(dataset) else tol


def _has_inclusions(dataset: xr.Dataset) -> bool:
    return any(f"max_von_mises_matrix_body{body}" in dataset for body in (1, 2))


def _borders(dataset: xr.Dataset) -> Iterator[Check]:
    names = {"contact_edge_distance": "minimum distance between contact and grid edge [cells]"}
    for body in (1, 2):
        text = f"minimum distance between plastic zone and volume edge [cells], body {body}"
        names[f"plastic_edge_distance_body{body}"] = text
    for variable, name in names.items():
        if variable not in dataset:
            continue
        margins = dataset[variable].values
        if np.any(np.isfinite(margins)):  # otherwise there was no contact or no plastic flow
            yield Check(name, float(np.nanmin(margins)), 1.0, at_least=True)


def _adhesion(dataset: xr.Dataset) -> Iterator[Check]:
    """Check whether the grid resolves the adhesive attraction and is large enough for it."""
    if "kappa" not in dataset.attrs or "adhesion_stress" not in dataset:
        return
    name = "resolution number kappa of the adhesion"
    yield Check(name, float(dataset.attrs["kappa"]), MAX_RESOLVED)
    name = "maximum attraction at the edge of the grid, relative to its peak"
    periodic = str(dataset.attrs.get("periodic", ""))
    largest = attraction_at_edge(dataset["adhesion_stress"].values, periodic)
    yield Check(name, largest / float(dataset.attrs["peak_used"]), EDGE_ATTRACTION)


def _resolution(dataset: xr.Dataset, case: Case | None) -> Iterator[Check]:
    """Check whether the grid resolves the contact at maximum load, and the plastic zone."""
    if "cells_across_contact" in dataset:
        cells = dataset["cells_across_contact"].values
        peak = int(np.argmax(np.where(np.isnan(cells), -1.0, dataset["load"].values)))
        load = float(dataset["load"].values[peak])
        hertz = case.hertz(load) if case is not None and load > 0 else None
        if np.isfinite(cells[peak]):
            suffix = "" if hertz is None else f" ({ExpectedContact(hertz)})"
            yield cells_across_contact(float(cells[peak]), suffix, RECOMMENDED_CELLS)
        uncertain = dataset.get("area_uncertainty")
        if "sharp_edge_cells" in dataset:
            name = "contact cells at sharp edges, where the pressure does not converge"
            yield Check(name, float(dataset["sharp_edge_cells"].max()), 0.0)
        if uncertain is not None and np.isfinite(uncertain[peak]):
            name = "relative uncertainty of the contact area at maximum load"
            yield Check(name, float(uncertain[peak]), AREA_ERROR_LIMIT)
    for body in (1, 2):
        layers = dataset.get(f"layers_across_plastic_zone_body{body}")
        if layers is not None:
            yield from layers_across_plastic_zone(layers.values, body)


def _plausibility(dataset: xr.Dataset, case: Case) -> Iterator[Check]:
    """Check the plausibility of the input at maximum load."""
    load = float(dataset["load"].max())
    hertz = case.hertz(load) if load > 0 else None
    expected = None if hertz is None else ExpectedContact(hertz)
    contact = None if expected is None else ExpectedExtent(expected, expected.along_axes)
    heat = NO_HEAT if case.heat is None else case.heat.build()
    bodies = case.body1.build(), case.body2.build()
    grid = grid_of(dataset) if case.grid is None else case.grid.build()
    for finding in plausibility_checks(contact, grid, bodies, heat):
        yield finding.check._replace(of_input=True)


def cells_across_contact(cells: float, suffix: str = "", few: int = MINIMUM_CELLS) -> Check:
    """Check whether the grid resolves the contact.

    cells: number of cells across the contact. suffix: text after the name of the check, e.g. " of
    the first cycle". few: minimum number of cells for which the check passes.
    """
    name = f"cells across the contact at maximum load{suffix}"
    return Check(name, cells, few, at_least=True)


def layers_across_plastic_zone(layers: ArrayLike, body: int) -> Iterator[Check]:
    """Check whether the grid layers resolve the plastic zone; no check without plastic strain.

    layers: number of layers across the plastic zone in each increment.
    """
    highest = np.max(np.nan_to_num(layers))
    if highest > 0:
        name = f"layers across the plastic zone, body {body}"
        yield Check(name, float(highest), MINIMUM_CELLS, at_least=True)


def _strains(dataset: xr.Dataset) -> Iterator[Check]:
    for body in (1, 2):
        variable = f"max_plastic_strain_magnitude_body{body}"
        if variable in dataset:
            name = f"maximum plastic strain magnitude, body {body}"
            yield Check(name, float(dataset[variable].max()), MAX_SMALL_STRAIN)


def _errors(dataset: xr.Dataset) -> Iterator[Check]:
    """Check the largest estimated error or, with a prescribed accuracy, the error of each quantity.

    For a surface that is known at the grid points only, the fraction of its mean-square slope at
    wavelengths below four cells is checked too.
    """
    rows = error_rows(dataset)
    estimated = [row for row in rows if row.target is None and np.isfinite(row.relative)]
    if estimated:
        worst = max(estimated, key=lambda row: row.relative)
        name = f"maximum estimated relative grid error: {worst.label}"
        yield Check(name, worst.relative, MAX_RELATIVE_ERROR)
    start = "increment_error_"
    if shares := [share for name, share in dataset.attrs.items() if str(name).startswith(start)]:
        name = "maximum estimated relative error due to increments"
        yield Check(name, float(max(shares)), MAX_RELATIVE_ERROR)
    for row in rows:
        if row.target is not None:
            yield Check(f"estimated relative error, {row.label}", row.relative, row.target)
    if "slope_beyond" in dataset.attrs:
        name = "fraction of the mean-square slope at wavelengths below four cells"
        yield Check(name, float(dataset.attrs["slope_beyond"]), MAX_SLOPE_FRACTION)

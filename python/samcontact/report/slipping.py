# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of a contact with partial slip: checks and figures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from .._util.check import Check
from .._util.checks import FloatArray
from ..plotting.slip_summary import chosen, slip_figures
from ..plotting.slipping import largest_force
from ..problem.friction import law_of_attributes
from ..results.contact import rubbing_pressure_of
from ..results.reading import cell_size
from ..results.slipping import balance_of

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from ..plotting.contact_results import ContactResults

MAX_MISSING_ENERGY = 0.05
"""Limit of the unaccounted work, relative to the work input. The unaccounted work decreases with
smaller increments."""


def checks(dataset: xr.Dataset, case: Case | None, tol: float) -> Iterator[Check]:
    """Check friction law, tangential forces and energy balance; no checks for full sliding."""
    if "friction_work" not in dataset:
        return
    law = law_of_attributes(dataset.attrs)
    shear = _shear(dataset)
    reference = largest_force(dataset)
    solved = np.isfinite(dataset["approach"].values)  # prescribed tractions obey no friction law
    if law is not None and not law.prevents_slip and np.any(solved):
        bound = law.bound(_pressure_of_touching_cells(dataset, tol)[solved])
        beyond, largest = np.hypot(*shear[:, solved]) - bound, float(bound.max())
        name = "friction law: maximum excess of shear over its bound, relative to the maximum bound"
        yield Check(name, float(beyond.max()) / largest if largest > 0 else 0.0, tol)
    steps = case.steps() if case is not None else []
    pulled = any("tangential_load" in step for step in steps)
    if pulled and len(steps) == dataset.sizes["increment"] and reference:
        name = (
            "tangential force balance: difference from the prescribed force, relative to the "
            "maximum force"
        )
        yield Check(name, _force_difference(dataset, shear, steps) / reference, tol)
    work = np.diff(dataset["friction_work"].values, prepend=0.0)
    yield Check("minimum frictional work in an increment", float(work.min()), 0.0, True, "J")
    if (balance := balance_of(dataset)) is not None:
        name = "energy balance: unaccounted work, relative to the work input"
        yield Check(name, abs(balance.imbalance), MAX_MISSING_ENERGY)


def _pressure_of_touching_cells(dataset: xr.Dataset, tol: float) -> FloatArray:
    """Return the pressure on which friction depends [Pa], positive in all cells with a closed gap.

    If the pressure of a cell with a closed gap is 0, it is replaced by a tiny positive value. This
    marks the cell as in contact: a friction law with a constant shear strength allows shear there.
    """
    pressure = rubbing_pressure_of(dataset)
    closed = dataset["gap"].values <= tol * np.abs(dataset["approach"].values[:, None, None])
    return np.where(closed & (pressure == 0), np.finfo(np.float64).tiny, pressure)


def _shear(dataset: xr.Dataset) -> FloatArray:
    """Return the shear traction [Pa], shape (2, increment, x, y); a component not stored is 0."""
    shape = dataset["pressure"].shape
    names = ("shear_x", "shear_y")
    return np.stack([dataset[n].values if n in dataset else np.zeros(shape) for n in names])


def _force_difference(dataset: xr.Dataset, shear: FloatArray, steps: list[dict[str, Any]]) -> float:
    area = cell_size(dataset, "x") * cell_size(dataset, "y")
    totals = area * shear.sum(axis=(2, 3))
    missed = [
        abs(totals[direction, index] - target)
        for index, step in enumerate(steps)
        for direction, target in enumerate(step.get("tangential_load", ()))
        if target is not None
    ]
    return float(max(missed, default=0.0))


def figures(results: ContactResults) -> Iterator[tuple[str, str, Figure]]:
    """Iterate over the figures of partial slip, as tuples (caption, description, figure)."""
    data = results.dataset
    for name, figure in slip_figures(results).items():
        title = figure.axes[0].get_title()
        if name == "partial_slip":
            number, share = (
                results.number(chosen(data)),
                data["stick_fraction"].values[chosen(data)],
            )
            text = f"Map of the contact with a stick fraction of {100 * share:.3g} %; {title}."
            yield f"Stick and slip zones, increment {number}", text, figure
        elif name == "fretting_loop":
            text = f"Tangential force versus tangential displacement; {title}."
            yield "Tangential force versus displacement", text, figure
        else:
            over = "distance rolled" if name == "rolling_force" else "creepage"
            text = f"Tangential force versus {over}, under load."
            yield f"Tangential force versus {over}", text, figure

# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of a contact: checks, tables and figures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._util.check import Check
from ..results.reading import body_shown
from ..solutions.peak import peak_of_dataset
from . import tables
from .figures import contact_figures
from .quality_checks import all_checks

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case

REQUIRED_VARIABLES = ("load", "approach", "pressure", "gap", "initial_gap")

_MODULI = (
    "The Hertz contact is computed with the instantaneous moduli; relaxation before this "
    "increment is a further cause of differences. "
)


def checks(dataset: xr.Dataset) -> list[Check]:
    return all_checks(dataset, stored_case(dataset))


def content(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the variables of the page template for a contact."""
    case = stored_case(dataset)
    peak = peak_of_dataset(dataset)
    load = float(dataset["load"].values[peak])
    hertz = case.hertz(load) if case is not None and load > 0 else None
    body = body_shown(dataset)
    accurate = "accuracy_reached" in dataset.attrs
    heading = "Increments (finest grid)" if accurate else "Increments"
    values = [("increments", heading, tables.scalars_table(dataset))]
    values += tables.slipping_tables(dataset)
    answers = tables.errors_table(dataset)
    title = "Results with estimated errors"
    if text := dataset.attrs.get("accuracy_surface"):
        title += f" ({text})"
    if not answers.rows:
        answers, title = tables.results_table(dataset), "Results"
    return {
        "file": "results.nc",
        "answers": [("results", title, answers)],
        "hertz": tables.hertz_table(dataset, peak, hertz, body) if hertz else [],
        "hertz_load": f"{load:.6g}",
        "hertz_moduli": _MODULI if case is not None and case.relaxes else "",
        "hertz_increment": int(dataset["increment"][peak]),
        "values": values,
        "convergence": [("convergence", "Convergence", tables.convergence_table(dataset))],
        "figures": contact_figures(dataset, body, hertz),
    }


def stored_case(dataset: xr.Dataset) -> Case | None:
    """Return the case stored with the results, or None if the case is missing or unreadable."""
    from ..cases import Case, CaseError, parse_case

    try:
        case = parse_case(dataset.attrs.get("case", ""))
    except CaseError:
        return None
    return case if isinstance(case, Case) else None

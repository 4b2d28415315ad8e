# SPDX-License-Identifier: GPL-3.0-or-later
"""A report of a run: one HTML file that needs nothing else, for reading, printing and filing."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from . import _report_checks, _report_tables
from ._report_figures import figures
from ._verdict import Verdict

if TYPE_CHECKING:
    import xarray as xr

    from .cases import Case

__all__ = ["checks", "write"]


def write(dataset: xr.Dataset, path: str | Path) -> Path:
    """Write the report of a run.

    It has the parameters, the values of each increment, figures, a comparison with Hertz where
    there is one, how each increment converged, and `checks` of the results.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `samcontact.results.to_dataset` or `open_results`.
    path : str or Path
        The file, customarily ending in .html; its directory must exist. Replaced when it exists.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        The dataset is not that of a run.
    OSError
        The file cannot be written.
    """
    _require_run(dataset)
    environment = Environment(
        loader=PackageLoader("samcontact", "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    text = environment.get_template("report.html.j2").render(**_content(dataset))
    target = Path(path)
    target.write_text(text, encoding="utf-8")
    return target


def checks(dataset: xr.Dataset) -> list[Verdict]:
    """Check the results of a run, from its stored fields.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `samcontact.results.to_dataset` or `open_results`.

    Returns
    -------
    list of Verdict
        Each with name, value, limit and whether it passed: balance of the load, complementarity
        of pressure and gap, yield condition, distance from the border of the grid, small strain.

    Raises
    ------
    ValueError
        The dataset is not that of a run.
    """
    _require_run(dataset)
    return _report_checks.verdicts(dataset, stored_case(dataset))


def stored_case(dataset: xr.Dataset) -> Case | None:
    """The case that is stored with results; None where there is none that this version reads."""
    from .cases import Case, CaseError, parse_case

    try:
        case = parse_case(dataset.attrs.get("case", ""))
    except CaseError:
        return None
    return case if isinstance(case, Case) else None


def _require_run(dataset: xr.Dataset) -> None:
    needed = ("load", "approach", "pressure", "gap", "initial_gap")
    missing = [name for name in needed if name not in dataset]
    if missing:
        raise ValueError(f"dataset must be that of a run, but has no {', '.join(missing)}")


def _content(dataset: xr.Dataset) -> dict[str, Any]:
    """Everything that the template names."""
    case = stored_case(dataset)
    peak = int(np.argmax(dataset["load"].values))
    load = float(dataset["load"].values[peak])
    hertz = case.hertz(load) if case is not None and load > 0 else None
    body = _body(dataset)
    attributes = dataset.attrs
    return {
        "title": attributes.get("title") or "Contact",
        "description": attributes.get("description", ""),
        "version": attributes.get("samcontact_version", ""),
        "created": attributes.get("created", ""),
        "case_text": attributes.get("case", ""),
        "parameters": _report_tables.parameters(dataset),
        "checks": _report_checks.verdicts(dataset, case),
        "hertz": _report_tables.hertz_table(dataset, peak, hertz, body) if hertz else [],
        "hertz_load": f"{load:.6g}",
        "scalars": _report_tables.scalars_table(dataset),
        "convergence": _report_tables.convergence_table(dataset),
        "figures": figures(dataset, body, peak, hertz),
    }


def _body(dataset: xr.Dataset) -> int:
    """The body of interest, or the other one where only that has volume fields."""
    body = int(dataset.attrs.get("body", 2))
    other = 3 - body
    only_other = f"stress_body{body}" not in dataset and f"stress_body{other}" in dataset
    return other if only_other else body

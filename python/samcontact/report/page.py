# SPDX-License-Identifier: GPL-3.0-or-later
"""Assembly of the HTML page of a report."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from .._util.check import Check
from ..files.atomic import replacing
from ..results.reading import parts_of_a_run
from . import asperities, contact, films, sliding, tables, wear
from . import fatigue as fatigue_report
from . import shakedown as shakedown_report

if TYPE_CHECKING:
    import xarray as xr


_PLURALS = {"increment": "increments", "pass": "passes", "cycle": "cycles", "point": "velocities"}


def write(
    dataset: xr.Dataset,
    path: str | Path,
    *,
    shakedown: xr.Dataset | None = None,
    fatigue: xr.Dataset | None = None,
) -> Path:
    """Write the report of a run.

    The page shows the main results with their estimated errors, figures, the `checks` of the
    results, and the parameters. For a contact, it also shows the values and the convergence of each
    increment and, where applicable, a comparison with Hertz contact. For asperity collisions, the
    page shows the values of each pass; for wear, it shows the values of each cycle; for lubricated
    contacts and for sliding, it shows the values at each speed.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results from `samcontact.results.to_dataset`, `open_results`, `CollisionResult.series`,
        `WearResult.to_dataset` or `FrictionCurve.to_dataset`.
    path : str or Path
        File to write, customarily ending in .html, in an existing folder. An existing file is
        replaced.
    shakedown : xarray.Dataset, optional
        Content of ``shakedown.nc``, for a case with a repeated path. Its long-term response is
        added to the page, with a table and a figure.
    fatigue : xarray.Dataset, optional
        Content of ``fatigue.nc``, for a case with fatigue. The maxima of the criteria, the life and
        the exposure over depth are added to the page.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        A dataset does not contain the results of a run.
    OSError
        The file cannot be written.
    """
    if shakedown is not None:
        shakedown_report.require_cycles(shakedown)
    if fatigue is not None:
        fatigue_report.require_fatigue(fatigue)
    environment = Environment(
        loader=PackageLoader("samcontact.report", "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    with parts_of_a_run():
        content = _content(dataset)
        if shakedown is not None:
            repeated = ("shakedown", "Repeated load cycles", shakedown_report.table(shakedown))
            content["answers"] = [*content["answers"], repeated]
            content["figures"] = [*content["figures"], shakedown_report.figure(shakedown)]
        if fatigue is not None:
            content["answers"] = [*content["answers"], *fatigue_report.tables(fatigue)]
            content["figures"] = [*content["figures"], *fatigue_report.figures(fatigue)]
    text = environment.get_template("report.html.j2").render(**content)
    target = Path(path)
    with replacing(target) as part:
        part.write_text(text, encoding="utf-8")
    return target


_TEXT_ATTRIBUTES = ("stopped_by", "title", "description", "samcontact_version", "created", "case")


def checks(dataset: xr.Dataset) -> list[Check]:
    """Check the results of a run, from its stored fields alone.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results from `samcontact.results.to_dataset`, `open_results`, `CollisionResult.series`,
        `WearResult.to_dataset` or `FrictionCurve.to_dataset`.

    Returns
    -------
    list of Check
        Checks with name, value, limit and result. An incomplete run has a failed check. The other
        checks depend on the kind of run, as follows. Contact: load balance, complementarity of
        pressure and gap, yield condition, distance from the edge of the grid, small strain, and
        plausibility of the input (`Check.of_input`); with partial slip also the friction law,
        tangential forces and energy balance. Asperity collision: energy balance, and zero force at
        the end of a pass. Wear: volume balance. Lubricated contact: balances of load, flow and
        mass, cavitation, inlet, resolution. Sliding: load balance, complementarity, and no negative
        friction.

    Raises
    ------
    ValueError
        The dataset does not contain the results of a run.
    """
    with parts_of_a_run():
        return [*_end(dataset), *_kind(dataset).checks(dataset)]


def _kind(dataset: xr.Dataset) -> ModuleType:
    """Return the module that creates the report of a dataset, e.g. `contact` or `wear`."""
    missing: dict[ModuleType, list[str]] = {
        kind: [name for name in kind.REQUIRED_VARIABLES if name not in dataset]
        for kind in (contact, asperities, wear, films, sliding)
    }
    kind, lacking = min(missing.items(), key=lambda item: len(item[1]))
    if lacking:
        raise ValueError(f"dataset must be from a run, but has no {', '.join(lacking)}")
    return kind


def _end(dataset: xr.Dataset) -> list[Check]:
    """Return a failed check if the run is incomplete, and an empty list if it is complete."""
    if dataset.attrs.get("complete", 1):
        return []
    dim = next(dim for dim in ("pass", "cycle", "increment", "point") if dim in dataset.sizes)
    name = f"{_PLURALS[dim]}: complete path (1) or part of it (0)"
    return [Check(name, 0.0, 1.0, at_least=True)]


def _content(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the values of all variables of the page template."""
    # text attributes may have been changed by other programs
    words = {name: str(dataset.attrs.get(name, "")) for name in _TEXT_ATTRIBUTES}
    kind = _kind(dataset)
    return {
        **words,
        "title": words["title"] or "Contact",
        "parameters": tables.parameters(dataset),
        "checks": [*_end(dataset), *kind.checks(dataset)],
        "hertz": [],
        "convergence": [],
        **kind.content(dataset),
    }

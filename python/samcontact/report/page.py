# SPDX-License-Identifier: GPL-3.0-or-later
"""The page, put together from its parts."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from .._util.check import Check
from ..files.atomic import replacing
from ..results.reading import parts_of_a_run
from . import contact, tables, tugging, wear
from . import shakedown as shakedown_report

if TYPE_CHECKING:
    import xarray as xr


_MANY = {"increment": "increments", "pass": "passes", "cycle": "cycles"}


def write(dataset: xr.Dataset, path: str | Path, *, shakedown: xr.Dataset | None = None) -> Path:
    """Write the report of a run.

    It has the parameters, the values of each increment, figures, a comparison with Hertz where
    there is one, how each increment converged, and `checks` of the results. Of tugging it has the
    values of each pass, of wear those of each cycle.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `samcontact.results.to_dataset`, `open_results`, `Tugging.series` or
        `WearResult.to_dataset`.
    path : str or Path
        The file, customarily ending in .html; its directory must exist. Replaced when it exists.
    shakedown : xarray.Dataset, optional
        Of ``shakedown.nc``, where the case has its path repeated: verdict, table and figure.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        A dataset is not that of a run.
    OSError
        The file cannot be written.
    """
    if shakedown is not None:
        shakedown_report.require_cycles(shakedown)
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
            repeated = ("shakedown", "The path, repeated", shakedown_report.table(shakedown))
            content["values"] = [*content["values"], repeated]
            content["figures"] = [*content["figures"], shakedown_report.figure(shakedown)]
    text = environment.get_template("report.html.j2").render(**content)
    target = Path(path)
    with replacing(target) as part:
        part.write_text(text, encoding="utf-8")
    return target


_WORDS = ("stopped_by", "title", "description", "samcontact_version", "created", "case")


def checks(dataset: xr.Dataset) -> list[Check]:
    """Check the results of a run, from its stored fields alone.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `samcontact.results.to_dataset`, `open_results`, `Tugging.series` or
        `WearResult.to_dataset`.

    Returns
    -------
    list of Check
        Each with name, value, limit and whether it passed. Of a run that did not reach its end:
        that it did not. Of a contact: balance of the load, complementarity of pressure and gap,
        yield condition, distance from the border of the grid,
        small strain; of bodies that stick and slip Coulomb's law, forces and energy. Of tugging:
        energy, and no force at the end of a pass. Of wear: volume.

    Raises
    ------
    ValueError
        The dataset is not that of a run.
    """
    with parts_of_a_run():
        return [*_end(dataset), *_kind(dataset).checks(dataset)]


def _kind(dataset: xr.Dataset) -> ModuleType:
    """What makes the parts of this dataset's page."""
    missing: dict[ModuleType, list[str]] = {
        kind: [name for name in kind.NEEDED if name not in dataset]
        for kind in (contact, tugging, wear)
    }
    kind, lacking = min(missing.items(), key=lambda item: len(item[1]))
    if lacking:
        raise ValueError(f"dataset must be that of a run, but has no {', '.join(lacking)}")
    return kind


def _end(dataset: xr.Dataset) -> list[Check]:
    """Whether the run reached its end, of one that did not."""
    if dataset.attrs.get("complete", 1):
        return []
    dim = next(dim for dim in ("pass", "cycle", "increment") if dim in dataset.sizes)
    return [Check(f"{_MANY[dim]}: the whole path (1) or a part (0)", 0.0, 1.0, at_least=True)]


def _content(dataset: xr.Dataset) -> dict[str, Any]:
    """Everything that the template names."""
    # other programs may have put anything there
    words = {name: str(dataset.attrs.get(name, "")) for name in _WORDS}
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

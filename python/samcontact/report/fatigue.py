# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of a case with fatigue: maxima of the criteria, exposure over depth, and life."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from .._util.frozen import FrozenDict
from ..cases.fatigue import CRITERIA
from ..fatigue import Exposure
from ..fatigue.exposure import NAMES
from ..plotting.fatigue import exposure_depth
from ..plotting.parts import finish, new_figure
from .figures import ReportFigure, embedded
from .tables import Cell, Table, cell

if TYPE_CHECKING:
    import xarray as xr

_UNITS = {"Pa": (1e-6, "MPa"), "1": (1e2, "%")}
"""For each unit in which a criterion is stored, the factor to the displayed unit, and that unit."""
_NONE = Cell("", "")


def require_fatigue(dataset: xr.Dataset) -> None:
    """Raise ValueError unless the dataset is the fatigue result of a run."""
    if not (_criteria(dataset) or _is_exposed(dataset)):
        raise ValueError(
            "fatigue must be the dataset of a run with [fatigue], but has no "
            f"{', '.join(CRITERIA)} or exposure_yield"
        )


def tables(dataset: xr.Dataset) -> Iterator[tuple[str, str, Table]]:
    """Iterate over the tables of the criteria and of exposure, as tuples (name, title, table)."""
    body = int(dataset.attrs["body"])
    if _criteria(dataset):
        yield "fatigue", f"Fatigue of body {body}", _criteria_table(dataset)
    if _is_exposed(dataset):
        yield "exposure", f"Exposure of body {body} over depth", _exposure_table(dataset)


def figures(dataset: xr.Dataset) -> Iterator[ReportFigure]:
    """Iterate over the figures of stress criteria and of the exposure over depth."""
    stresses = [name for name in _criteria(dataset) if dataset[name].attrs["units"] == "Pa"]
    if any("z" in dataset[name].dims for name in stresses):
        yield _criteria_figure(dataset, [n for n in stresses if "z" in dataset[n].dims])
    if _is_exposed(dataset):
        drawn, found = new_figure(), _exposure_of(dataset)
        exposure_depth(found, drawn.subplots())
        text = (
            "Equivalent stress of each criterion divided by the local strength, over depth: "
            f"{_governing(found)}."
        )
        yield embedded("Exposure over depth", text, drawn)


def _criteria(dataset: xr.Dataset) -> list[str]:
    return [name for name in CRITERIA if name in dataset]


def _is_exposed(dataset: xr.Dataset) -> bool:
    return all(f"{kind}_{name}" in dataset for name in NAMES for kind in ("exposure", "strength"))


def _criteria_table(dataset: xr.Dataset) -> Table:
    rows = []
    for name in _criteria(dataset):
        field = dataset[name]
        factor, unit = _UNITS[str(field.attrs["units"])]
        largest, place = _peak(field)
        limit = float(field.attrs.get("limit", np.nan))
        cells = [cell(largest, factor), Cell(unit, "")]
        cells.append(cell(place["z"], 1e6) if "z" in place else _NONE)
        bounded = np.isfinite(limit)
        cells.append(cell(limit, factor) if bounded else _NONE)
        cells.append(cell(limit / largest - 1.0, 1e2) if bounded and largest > 0 else _NONE)
        rows.append((str(field.attrs["long_name"]), cells))
    headings = ["maximum", "unit", "depth [µm]", "limit", "margin [%]"]
    moments = int(dataset[_criteria(dataset)[0]].attrs["moments"])
    note = f"Maximum of each criterion over a stress cycle of {moments} instants.{_life(dataset)}"
    return Table(headings, rows, "criterion", note)


def _life(dataset: xr.Dataset) -> str:
    if "life_log_integral" not in dataset.attrs:
        return ""
    integral, slope = (float(dataset.attrs[f"life_{name}"]) for name in ("log_integral", "weibull"))
    return (
        f" Life: logarithm of the integral {integral:.6g}, Weibull slope {slope:.4g}. The ratio of "
        "this life to the life of a reference is exp((logarithm of the integral of the reference "
        "- this logarithm)/slope)."
    )


def _exposure_table(dataset: xr.Dataset) -> Table:
    found, rows = _exposure_of(dataset), []
    for name in found.values:
        at = int(found.values[name].argmax())
        rows.append((NAMES[name], [
            cell(found.max_value(name), 1.0), cell(found.depth(name), 1e6),
            cell(found.stress[name][at], 1e-6), cell(found.strength[name][at], 1e-6),
            cell(found.hardness[at], 1.0),
        ]))  # fmt: skip
    headings = ["exposure", "depth [µm]", "stress [MPa]", "strength [MPa]", "hardness [HV]"]
    note = f"Largest stress divided by the strength at the same depth: {_governing(found)}."
    return Table(headings, rows, "criterion", note)


def _governing(found: Exposure) -> str:
    value, depth = found.max_value(), found.depth() * 1e6
    return f"{NAMES[found.criterion]} governs with {value:.3g} at a depth of {depth:.4g} µm"


def _exposure_of(dataset: xr.Dataset) -> Exposure:
    values = {name: dataset[f"exposure_{name}"].values for name in NAMES}
    strength = {name: dataset[f"strength_{name}"].values for name in NAMES}
    stress = {name: values[name] * strength[name] for name in NAMES}
    hardness = dataset["hardness"].values
    return Exposure(dataset["z"].values, FrozenDict(stress), FrozenDict(strength), hardness, np.nan)


def _peak(field: xr.DataArray) -> tuple[float, dict[str, float]]:
    """Return the maximum of a field and the coordinates of this maximum [m]."""
    at = np.unravel_index(int(np.nanargmax(field.values)), field.shape)
    place = {str(d): float(field[d].values[n]) for d, n in zip(field.dims, at, strict=True)}
    return float(field.values[at]), place


def _criteria_figure(dataset: xr.Dataset, names: list[str]) -> ReportFigure:
    drawn = new_figure()
    ax = drawn.subplots()
    for name in names:
        field = dataset[name]
        over_depth = field.max([dim for dim in field.dims if dim != "z"])
        ax.plot(over_depth * 1e-6, dataset["z"] * 1e6, label=str(field.attrs["long_name"]))
    ax.set_ylim(float(dataset["z"].values[-1]) * 1e6, 0.0)
    label = f"maximum of {ax.lines[0].get_label()}" if len(names) == 1 else "maximum"
    ax.set(xlabel=f"{label} at this depth [MPa]", ylabel="depth z [µm]")
    if len(names) > 1:
        ax.legend(frameon=False, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    finish(ax)
    return embedded("Fatigue over depth", "Maximum of each fatigue criterion over depth.", drawn)

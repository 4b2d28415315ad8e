# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of a repeated load path: long-term response, strains of each cycle, and a figure."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..plotting.parts import new_figure
from ..plotting.shakedown import draw_cycles
from .figures import ReportFigure, embedded
from .tables import Table, cell

if TYPE_CHECKING:
    import xarray as xr

_CYCLE_LABELS = {"flow": "equivalent plastic strain increment", "net": "net plastic strain"}


def require_cycles(dataset: xr.Dataset) -> None:
    """Raise ValueError unless the dataset is the result of repeated load cycles."""
    known = {*map(str, dataset.variables), *map(str, dataset.attrs)}
    needed = (*_CYCLE_LABELS, "cycle", "response", "yield_strain")
    if lacking := [name for name in needed if name not in known]:
        raise ValueError(
            f"shakedown must be the dataset of a run with [shakedown], but has no "
            f"{', '.join(lacking)}"
        )


def table(dataset: xr.Dataset) -> Table:
    """Return a table of plastic strain increment and net plastic strain of each solved cycle."""
    numbers = dataset["cycle"].values.tolist()
    columns = [dataset[name].values for name in _CYCLE_LABELS]
    rows = [
        (str(number), [cell(values[index], 1.0) for values in columns])
        for index, number in enumerate(numbers)
    ]
    note = (
        f"Long-term response to the repeated path: {dataset.attrs['response']} after {numbers[-1]} "
        f"cycles. Maximum plastic strains of each cycle [-]; the yield strain is "
        f"{float(dataset.attrs['yield_strain']):.3g}."
    )
    return Table(list(_CYCLE_LABELS.values()), rows, "cycle", note)


def figure(dataset: xr.Dataset) -> ReportFigure:
    drawn, response = new_figure(), str(dataset.attrs["response"])
    net, flow = (dataset[name].values / dataset.attrs["yield_strain"] for name in ("net", "flow"))
    draw_cycles(dataset["cycle"].values, net, flow, response, drawn.subplots())
    text = f"Net plastic strain and (dashed) plastic flow in each cycle: {response}."
    return embedded("Repeated load cycles", text, drawn)

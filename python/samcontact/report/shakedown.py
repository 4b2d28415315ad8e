# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page of a contact has of its path repeated: the verdict, each cycle, a figure."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..plotting.parts import new_figure
from ..plotting.shakedown import draw_cycles
from .figures import ReportFigure, embedded
from .tables import Table, cell

if TYPE_CHECKING:
    import xarray as xr

_TOLD = {"flow": "plastic flow", "net": "plastic strain left"}


def require_cycles(dataset: xr.Dataset) -> None:
    """Raise ValueError for what is not the dataset of repeated cycles."""
    known = {*map(str, dataset.variables), *map(str, dataset.attrs)}
    needed = (*_TOLD, "cycle", "verdict", "yield_strain")
    if lacking := [name for name in needed if name not in known]:
        raise ValueError(
            f"shakedown must be what a run with [shakedown] has written, but has no "
            f"{', '.join(lacking)}"
        )


def table(dataset: xr.Dataset) -> Table:
    """Strains of each cycle that was solved."""
    numbers = dataset["cycle"].values.tolist()
    columns = [dataset[name].values for name in _TOLD]
    rows = [
        (str(number), [cell(values[index], 1.0) for values in columns])
        for index, number in enumerate(numbers)
    ]
    note = (
        f"The whole path, from the start on: {dataset.attrs['verdict']} after {numbers[-1]} "
        f"cycles. Largest equivalent plastic strains [-] of a cycle; the yield strain is "
        f"{float(dataset.attrs['yield_strain']):.3g}."
    )
    return Table(list(_TOLD.values()), rows, "cycle", note)


def figure(dataset: xr.Dataset) -> ReportFigure:
    drawn, verdict = new_figure(), str(dataset.attrs["verdict"])
    net, flow = (dataset[name].values / dataset.attrs["yield_strain"] for name in ("net", "flow"))
    draw_cycles(dataset["cycle"].values, net, flow, verdict, drawn.subplots())
    text = f"Plastic strain left by each cycle, and flow in it as a dashed line: {verdict}."
    return embedded("The path, repeated", text, drawn)

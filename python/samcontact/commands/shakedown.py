# SPDX-License-Identifier: GPL-3.0-or-later
"""Shakedown results of a case with a section [shakedown]: table, file and figure."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import xarray as xr

from .. import results
from .._util.display import rows_of
from .._util.version import version
from .interrupted import Checkpoints
from .tables import Sheet

if TYPE_CHECKING:
    from ..cases import Case
    from ..shakedown import ShakedownResult
    from .tables import Printer


def write_shakedown(
    case: Case,
    checkpoints: Checkpoints,
    console: Printer,
    *,
    figures: bool,
    found: ShakedownResult | None = None,
) -> list[Path]:
    """Repeat the loading path, print a table, write shakedown.nc and a figure, return the files.

    A checkpoint is written after each cycle, because many cycles take long. found: response if it
    is already known; the path is then not repeated.
    """
    assert case.shakedown is not None
    if found is None:
        kept = checkpoints.remember() / "shakedown"
        found = case.shakedown.solve(*case.build(), not console.quiet, kept)
    directory = checkpoints.directory
    rows = rows_of(found)
    sheet = Sheet("Repeated load cycles")
    sheet.add("", [label for label, _ in rows])
    sheet.add("", [value for _, value in rows])
    console.print(sheet)
    written = [results.save(_dataset(found, case.title), directory / "shakedown.nc")]
    if figures:
        from ..plotting import strain_per_cycle
        from ..plotting.parts import new_figure, save

        figure = new_figure()
        strain_per_cycle(found, figure.subplots())
        written.append(save(figure, directory / "shakedown.png"))
    return written


def _dataset(found: ShakedownResult, title: str) -> xr.Dataset:
    def variable(name: str, meaning: str) -> tuple[str, list[float], dict[str, str]]:
        values = [float(getattr(cycle, name)) for cycle in found.cycles]
        return "cycle", values, {"units": "1", "long_name": meaning}

    return xr.Dataset(
        {
            "flow": variable("flow", "maximum equivalent plastic strain increment of the cycle"),
            "net": variable("net", "maximum net plastic strain of the cycle"),
        },
        {"cycle": [cycle.number for cycle in found.cycles]},
        {
            "title": title,
            "samcontact_version": version,
            "response": found.response,
            "rate": found.rate,
            "yield_strain": found.yield_strain,
            "solved": found.solved,
            "error": found.error,
        },
    )

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command does with [shakedown]: repeat the path, and tell what it comes to."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import xarray as xr
from rich.console import Console

from .. import results
from .._util.display import rows_of
from .._util.version import version
from .interrupted import Checkpoints
from .tables import Sheet

if TYPE_CHECKING:
    from ..cases import Case
    from ..shakedown import ShakedownResult


def write_shakedown(
    case: Case, checkpoints: Checkpoints, console: Console, *, figures: bool
) -> list[Path]:
    """A table of what repeated cycles come to, shakedown.nc and a figure; the files.

    Each cycle leaves a checkpoint: they take longer than the path.
    """
    assert case.shakedown is not None
    kept = checkpoints.remember() / "shakedown"
    found = case.shakedown.solve(*case.build(), not console.quiet, kept)
    directory = checkpoints.directory
    rows = rows_of(found)
    sheet = Sheet("The path, repeated")
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
    def told(name: str, meaning: str) -> tuple[str, list[float], dict[str, str]]:
        values = [float(getattr(cycle, name)) for cycle in found.cycles]
        return "cycle", values, {"units": "1", "long_name": meaning}

    return xr.Dataset(
        {
            "flow": told("flow", "largest equivalent plastic strain added in the cycle"),
            "net": told("net", "largest plastic strain left by the cycle"),
        },
        {"cycle": [cycle.number for cycle in found.cycles]},
        {
            "title": title,
            "samcontact_version": version,
            "verdict": found.verdict,
            "rate": found.rate,
            "yield_strain": found.yield_strain,
            "solved": found.solved,
            "error": found.error,
        },
    )

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command does with a case of wear: solve it, print and write its cycles, figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from ..plotting import wear
from ..plotting.parts import new_figure
from ..results import save
from .tables import new_table

if TYPE_CHECKING:
    from ..cases import Case
    from ..wear import WearResult

# of Cycle: name, heading, factor, format
COLUMNS = (
    ("volume", "worn\n[µm³]", 1e18, ".5g"),
    ("depth", "depth\n[µm]", 1e6, ".4f"),
    ("max_pressure", "p_max\n[MPa]", 1e-6, ".1f"),
    ("max_von_mises", "von Mises\n[MPa]", 1e-6, ".1f"),
    ("max_plastic_strain", "plastic\nstrain [%]", 1e2, ".4f"),
)


def solve_wear(
    case: Case, directory: Path, checkpoints: Path | None, console: Console, figures: bool
) -> list[Path]:
    """Write wear.nc, wear.csv and figures; the files."""
    simulation, cycle = case.build()
    assert case.wear is not None
    kept = None
    if checkpoints is not None:
        checkpoints.mkdir(parents=True, exist_ok=True)
        kept = checkpoints / "cycle.h5"
    result = case.wear.solve(simulation, cycle, kept, not console.quiet)
    dataset = result.to_dataset().assign_attrs(title=case.title, case=case.text)
    console.print(_table(result))
    if not result.stopped:
        console.print(f"still wearing after {len(result.cycles)} cycles", highlight=False)
    written = [save(dataset, directory / "wear.nc"), directory / "wear.csv"]
    by_cycle = [str(name) for name, field in dataset.items() if field.dims == ("cycle",)]
    dataset[by_cycle].to_dataframe().to_csv(written[-1])
    if case.output.figures and figures:
        written += _draw(result, directory)
    return written


def _draw(result: WearResult, directory: Path) -> list[Path]:
    written = []
    for body in result.worn:
        for name, ax in (
            (f"profile_body{body}", wear.worn_profile(result, body=body)),
            (f"surface_body{body}", wear.surface_map(result, body=body)),
        ):
            written.append(directory / f"{name}.png")
            ax.get_figure(root=True).savefig(written[-1])  # type: ignore[union-attr]
        for name, moments in (("first", result.first), ("last", result.last)):
            written.append(directory / f"{name}_cycle_body{body}.png")
            wear.cycle_panels(moments, body=body).savefig(written[-1])
    written.append(directory / "wear_rate.png")
    figure = new_figure()
    wear.wear_rate(result, figure.subplots())
    figure.savefig(written[-1])
    return written


def _table(result: WearResult) -> Table:
    """One row for each cycle; the largest of all worn bodies, or the sum of their volumes."""
    table = new_table("Cycles", "", *(heading for _, heading, _, _ in COLUMNS))
    for cycle in result.cycles:
        row = [str(cycle.number)]
        for name, _, factor, form in COLUMNS:
            value = getattr(cycle, name)
            if isinstance(value, tuple):
                value = sum(value) if name == "volume" else max(value)
            row.append(format(value * factor, form))
        table.add_row(*row)
    return table

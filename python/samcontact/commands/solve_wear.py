# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command does with a case of wear: solve it, print and write its cycles, figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console

from ..plotting import wear
from ..plotting.parts import save as save_figure
from ..results.dataset import completeness
from .errors import StoppedEarlyError, tell_partial
from .folder import publish
from .interrupted import checkpoints_of
from .tables import Sheet, numbers

if TYPE_CHECKING:
    from ..cases import Case
    from ..wear import WearResult

# of Cycle: name, heading, factor
COLUMNS = (
    ("volume", "worn\n[µm³]", 1e18),
    ("depth", "depth\n[µm]", 1e6),
    ("max_pressure", "p_max\n[MPa]", 1e-6),
    ("max_von_mises", "von Mises\n[MPa]", 1e-6),
    ("max_plastic_strain", "plastic\nstrain [%]", 1e2),
)


def solve_wear(
    case: Case, directory: Path, console: Console, *, figures: bool, resume: bool
) -> list[Path]:
    """Write wear.nc, wear.csv and figures; the files. Each cycle leaves a checkpoint."""
    simulation, cycle = case.build()
    assert case.wear is not None

    def write(result: WearResult, stopped_by: str = "") -> list[Path]:
        return _write(case, result, stopped_by, directory, console, figures)

    with checkpoints_of(directory, case) as checkpoints:
        checkpoints.claim(resume)
        console.print(case.title, style="bold", markup=False, highlight=False)
        try:
            with checkpoints.used() as folder:
                file = folder / "cycle.h5"
                result = case.wear.solve(simulation, cycle, file, not console.quiet)
        except Exception as error:
            done: WearResult | None = getattr(error, "result", None)
            if done is None:
                raise
            what = f"{len(done.cycles)} of up to {case.wear.cycles} cycles"
            told = tell_partial(lambda reason: write(done, reason), error, what, directory)
            raise StoppedEarlyError(told) from error
        return write(result)


def _write(
    case: Case,
    result: WearResult,
    stopped_by: str,
    directory: Path,
    console: Console,
    figures: bool,
) -> list[Path]:
    attributes = {"title": case.title, "case": case.text, **completeness(stopped_by)}
    dataset = result.to_dataset().assign_attrs(attributes)
    written = [publish(dataset, directory / "wear.nc"), directory / "wear.csv"]
    console.print(_table(result))
    if not (result.stopped or stopped_by):
        console.print(f"still wearing after {len(result.cycles)} cycles", highlight=False)
    by_cycle = [str(name) for name, field in dataset.items() if field.dims == ("cycle",)]
    dataset[by_cycle].to_dataframe().to_csv(written[-1])
    if case.output.figures and figures:
        written += _draw(result, directory)
    return written


def _draw(result: WearResult, directory: Path) -> list[Path]:
    figures = {}
    for body in result.worn:
        for name, ax in (
            (f"profile_body{body}", wear.worn_profile(result, body=body)),
            (f"surface_body{body}", wear.surface_map(result, body=body)),
        ):
            figures[name] = ax.get_figure(root=True)
        for name, moments in (("first", result.first), ("last", result.last)):
            figures[f"{name}_cycle_body{body}"] = wear.cycle_panels(moments, body=body)
    figures["wear_rate"] = wear.wear_rate(result).get_figure(root=True)
    return [save_figure(figure, directory / f"{name}.png") for name, figure in figures.items()]


def _table(result: WearResult) -> Sheet:
    """One row for each cycle; the largest of all worn bodies, or the sum of their volumes."""
    sheet = Sheet("Cycles")
    sheet.add("", [str(cycle.number) for cycle in result.cycles])
    for name, heading, factor in COLUMNS:
        values = []
        for cycle in result.cycles:
            value = getattr(cycle, name)
            if isinstance(value, tuple):
                value = sum(value) if name == "volume" else max(value)
            values.append(value * factor)
        sheet.add(heading, numbers(values))
    return sheet

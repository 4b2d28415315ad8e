# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.peers: comparison with other open codes. See docs/peers.md."""

from __future__ import annotations

import os
from pathlib import Path

import click

from ..harness import ROOT
from ..study import save
from .running import ONE_THREAD
from .schedule import PROBLEMS, STORED


@click.command(help=__doc__)
@click.argument("problems", nargs=-1, metavar="[PROBLEM]...", type=click.Choice(PROBLEMS))
@click.option("--quick", is_flag=True, help="Small grids; the page is not changed.")
@click.option("--rounds", default=3, help="Repetitions of each measurement (3).")
@click.option("--limit", default=60.0, help="Time limit of one measurement in seconds (60).")
@click.option("--fresh", is_flag=True, help="Discard the stored measurements.")
@click.option("--page", "only_page", is_flag=True, help="Only write the page and figures.")
@click.option("--processor-time", is_flag=True, help="Measure processor time.")
@click.option("--folder", type=Path, default=ROOT / "results" / "benchmarks" / "peers")
def main(
    problems: tuple[str, ...], quick: bool, rounds: int, limit: float, fresh: bool,
    only_page: bool, processor_time: bool, folder: Path,
) -> None:  # fmt: skip
    os.environ.update(ONE_THREAD)
    os.environ.setdefault("MPLBACKEND", "Agg")
    # Imported late: the codes read their number of threads at import.
    from . import figures, page
    from .schedule import Results, measure_all

    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "quick.json" if quick else STORED
    if fresh:
        file.unlink(missing_ok=True)
    results = Results(file)
    if not only_page:
        measure_all(
            list(problems or PROBLEMS), results, folder.resolve(), quick=quick, rounds=rounds,
            limit=limit, clock="process_time" if processor_time else "perf_counter",
            report=click.echo,
        )  # fmt: skip
    if quick:
        click.echo(page.tables_of(results.data))
    else:
        page.write(results.data)
        save(figures.draw(results.data))


if __name__ == "__main__":
    main(prog_name="python -m benchmarks.peers")

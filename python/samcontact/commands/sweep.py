# SPDX-License-Identifier: GPL-3.0-or-later
"""The command that solves a case file for many values of its fields."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .arguments import FilePath
from .errors import short_errors


@click.command()
@click.argument("case_file", metavar="CASE.toml", type=FilePath())
@click.option(
    "--set",
    "settings",
    metavar="FIELD=VALUE,...",
    multiple=True,
    required=True,
    help="Values of a field, e.g. body2.yield_stress=1e9,2e9; once for each field.",
)
@click.option("--zip", "zipped", is_flag=True, help="First values, second ones, ... together.")
@click.option("--jobs", type=click.IntRange(min=1), help="Worker processes of one thread each.")
@click.option("--dask", "address", metavar="ADDRESS", help="Scheduler of a Dask cluster.")
@click.option("--output", type=FilePath(), help="Directory of the results.")
@click.option("--quiet", is_flag=True, help="Print the path of the results only.")
def sweep(case_file: Path, **options: Any) -> None:
    """Solve a case file for many values of its fields; write sweep.nc.

    The same command goes on with a sweep that was interrupted, and tries failed cases again.
    """
    with short_errors(files=True):
        from .solve_sweep import run_sweep

        code = run_sweep(case_file, **options)
    raise SystemExit(code)

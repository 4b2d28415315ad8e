# SPDX-License-Identifier: GPL-3.0-or-later
"""Command `sweep`, which runs a parameter study of a case file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .arguments import FilePath
from .errors import short_errors


@click.command(short_help="Solve a case file for many values of its fields.")
@click.argument("case_file", metavar="CASE.toml", type=FilePath())
@click.option(
    "--set",
    "settings",
    metavar="FIELD=VALUE,...",
    multiple=True,
    required=True,
    help="Values of a field, e.g. body2.yield_stress=1e9,2e9; repeat the option for each field.",
)
@click.option(
    "--zip", "zipped", is_flag=True, help="Combine values pairwise instead of in all combinations."
)
@click.option(
    "--jobs", type=click.IntRange(min=1), help="Number of worker processes, with one thread each."
)
@click.option(
    "--dask", "address", metavar="ADDRESS", help="Address of the scheduler of a Dask cluster."
)
@click.option(
    "--find",
    metavar="QUANTITY=VALUE",
    help="For each case, find the load at which a quantity reaches a value, as samcontact find.",
)
@click.option("--output", type=FilePath(), help="Folder of the results.")
@click.option("--quiet", is_flag=True, help="Print only the paths of the results.")
def sweep(case_file: Path, **options: Any) -> None:
    """Solve a case file for many values of its fields and write sweep.nc, sweep.csv and sweep.png.

    Repeat the command to continue an interrupted sweep; failed cases are solved again.
    """
    with short_errors(files=True):
        from .solve_sweep import run_sweep

        code = run_sweep(case_file, **options)
    raise SystemExit(code)

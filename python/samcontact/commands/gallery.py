# SPDX-License-Identifier: GPL-3.0-or-later
"""The command that computes what the thesis shows."""

from __future__ import annotations

from pathlib import Path

import click

from .arguments import FilePath
from .errors import FAILED, short_errors


@click.command()
@click.argument("names", metavar="[PART | FIGURE]...", nargs=-1)
@click.option("--quick", is_flag=True, help="Coarse grids: seconds for each part.")
@click.option("--list", "listing", is_flag=True, help="Print the parts and their figures.")
@click.option(
    "--output",
    type=FilePath(),
    default=Path("gallery"),
    show_default=True,
    help="Directory of the pages.",
)
def gallery(names: tuple[str, ...], quick: bool, listing: bool, output: Path) -> None:
    """Compute figures and stated values of Boucly's thesis (2008), all or those named.

    Exit code 1 when a value differs from what is stated.
    """
    with short_errors():
        from ..gallery import parts

        if listing:
            for name in parts.PARTS:
                click.echo(f"{name:<22}{parts.figures_of(name)}")
            return
        chosen = dict.fromkeys(parts.part_of(name) for name in names) or parts.PARTS
        if parts.make(list(chosen), output, quick, click.echo):
            raise SystemExit(FAILED)

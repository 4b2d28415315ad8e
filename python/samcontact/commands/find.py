# SPDX-License-Identifier: GPL-3.0-or-later
"""The command that finds the load at which a quantity of a case reaches a value."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

import click

from .arguments import FilePath, Quantity
from .errors import short_errors

if TYPE_CHECKING:
    from ..cases import Case
    from ..find import FoundLoad, Search


@click.command()
@click.argument("case_file", metavar="CASE.toml", type=FilePath())
@click.argument("target", metavar="QUANTITY=VALUE")
@click.option("--tolerance", type=float, default=1e-3, show_default=True, help="Relative.")
@click.option("--largest-load", type=Quantity("N"), help="Default: 100 times that of the case.")
@click.option("--quiet", is_flag=True, help="Print the load only [N].")
def find(
    case_file: Path, target: str, tolerance: float, largest_load: float | None, quiet: bool
) -> None:
    """Find the load at which a quantity reaches a value, or a body first yields ("yield").

    All loads of the case are multiplied by the same factor. max_plastic_strain=0.001,
    "max_pressure=4 GPa", "print_depth_body2=0.1 um", "permanent_deformation=1 um" (both prints
    together, at the end). What is interrupted is kept in the directory
    of the results of the case, and the same command goes on.
    """
    with short_errors(files=True):
        from ..cases import load_case
        from ..cases.tugging import TuggingCase
        from ..find import searched
        from .tables import Sheet, new_console

        case = load_case(case_file)
        if isinstance(case, TuggingCase):
            raise ValueError("a load is found of a contact, not of a case with [tugging]")
        name, given, text = target.partition("=")
        value = _value(name.strip(), text.strip()) if given else 1.0
        if not given and name != "yield":
            raise ValueError(f"QUANTITY=VALUE must have a value, got {target!r}")
        search = searched(
            case, name.strip(), value, tolerance=tolerance, largest_load=largest_load,
            progress=not quiet,
        )  # fmt: skip
        found = _found(case, search)
        if quiet:
            click.echo(repr(found.load))
            return
        sheet = Sheet(case.title)
        labels, shown = zip(*found._rows(), strict=True)
        sheet.add("", labels)
        sheet.add("found", shown)
        new_console().print(sheet)


def _found(case: Case, search: Search) -> FoundLoad:
    """From what an interrupted search has left, if there is one; another one leaves the same."""
    from .._atomic import undisturbed
    from ..runs.identity import digest

    folder = case.output_directory / f"find_{digest(search.solves.who)[:12]}"
    kept = folder if folder.exists() else None
    try:
        with search.solves.kept_in(kept):
            found = search.find()
    except (KeyboardInterrupt, MemoryError, OSError):
        if kept is None and (search.solves.given or search.solves.increments):
            with undisturbed():
                search.solves.keep(folder)
        if folder.exists():
            click.echo(f"the same command goes on from {folder}", err=True)
        raise
    if kept is not None:
        shutil.rmtree(kept)
    return found


def _value(name: str, text: str) -> float:
    """In SI units, of a number or a text with a unit."""
    from .._load_scenes import PERMANENT, SYNONYMS
    from .._quantities import CONTACT
    from ..units import from_text

    try:
        return float(text)
    except ValueError:
        kind = SYNONYMS.get(name, name).partition("_body")[0]
        unit = CONTACT[kind].unit if kind in CONTACT else "m" if kind == PERMANENT else "1"
        return from_text(text, {"m2": "m**2", "1": ""}.get(unit, unit))

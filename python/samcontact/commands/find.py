# SPDX-License-Identifier: GPL-3.0-or-later
"""Command `find`, which finds the load at which a quantity of a case reaches a value."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from .._util.short_text import in_short
from ..bearings.bearing import RACES
from .arguments import FilePath, QuantityArgument
from .bearing_loads import (
    cases_by_race,
    diameter_of,
    in_metres,
    largest_contact_load,
    load_on_bearing,
    table,
    unit_of,
)
from .errors import short_errors

if TYPE_CHECKING:
    from ..accuracy.load_search import FoundLoad, LoadSearch
    from ..cases import Case


@click.command(short_help="Find the load at which a quantity reaches a value.")
@click.argument("case_file", metavar="CASE.toml", type=FilePath())
@click.argument("target", metavar="QUANTITY=VALUE")
@click.option(
    "--tolerance", type=float, default=1e-3, show_default=True, help="Relative tolerance."
)
@click.option(
    "--largest-load",
    type=QuantityArgument("N"),
    help="Upper limit of the load [N]; for a bearing, the load on the bearing. Default: 100 times "
    "the load of the case.",
)
@click.option("--quiet", is_flag=True, help="Print only the load [N].")
def find(
    case_file: Path, target: str, tolerance: float, largest_load: float | None, quiet: bool
) -> None:
    """Find the load at which a quantity reaches a value or, with "yield", the load at first yield.

    All loads of the case are multiplied by a common factor. Examples of QUANTITY=VALUE:
    max_equivalent_plastic_strain=0.001, "max_pressure=4 GPa", "imprint_depth_body2=0.1 um",
    "permanent_deformation=1 um" (sum of the residual imprint depths of both bodies at the end).
    An interrupted search is saved in the results folder of the case; repeat the command to
    continue it.

    For a bearing, both races are solved unless the case specifies one of them. The loads on the
    bearing are shown with C0 and s0 of ISO 76. With --quiet, only the radial load on the bearing is
    printed. For bearings and rollers, lengths may be given in diameters D of the rolling element:
    "permanent_deformation=1e-4 D".
    """
    with short_errors(files=True):
        from ..accuracy.given_case import case_of_contact
        from ..accuracy.load_search import prepare_search
        from .tables import Sheet, new_console

        case = case_of_contact("CASE.toml", case_file)
        name, value = parse_target(in_metres(target, case))
        cases = cases_by_race(case)
        founds = {}
        for race, one in cases.items():
            search = prepare_search(
                one, name, value, tolerance=tolerance,
                largest_load=largest_contact_load(one, largest_load), progress=not quiet,
            )  # fmt: skip
            founds[race] = _run_search(one, search)
        governing = min(founds, key=lambda race: founds[race].load)
        if quiet:
            found, one = founds[governing], cases[governing]
            is_bearing = one.surface.shape == "bearing"
            click.echo(repr(load_on_bearing(one, found) if is_bearing else found.load))
            return
        sheet = Sheet(case.title)
        columns = table(founds, cases, diameter_of(target, case))
        labels = list(next(iter(columns.values())))
        sheet.add("", labels)
        for heading, rows in columns.items():
            sheet.add(f"{heading} race" if heading in RACES else heading, [rows[n] for n in labels])
        new_console().print(sheet)
        if len(founds) > 1:
            click.echo(f"governing: {governing} race")


def _run_search(case: Case, search: LoadSearch) -> FoundLoad:
    """Run or continue a load search; if it is interrupted, save the solutions obtained so far."""
    from ..files.atomic import undisturbed
    from ..restart.checkpoint_files import remove_checkpoints
    from ..restart.identity import digest

    folder = case.output_directory / f"find_{digest(search.solves.run_identity)[:12]}"
    kept = folder if folder.exists() else None
    try:
        with search.solves.kept_in(kept):
            found = search.find()
    except (KeyboardInterrupt, MemoryError, OSError):
        if kept is None and (search.solves.given or search.solves.increments):
            with undisturbed():
                search.solves.keep(folder)
        if folder.exists():
            click.echo(f"progress saved in {folder}; repeat the command to continue", err=True)
        raise
    if kept is not None:
        remove_checkpoints(kept)
    return found


def parse_target(target: str) -> tuple[str, float]:
    """Split QUANTITY=VALUE into the name of the quantity and its value in SI units."""
    from ..accuracy.load_search_cases import YIELD, require_known

    name, given, text = (part.strip() for part in target.partition("="))
    if not name:
        raise ValueError(
            'QUANTITY=VALUE must name a quantity, e.g. "max_pressure=4 GPa", '
            f"got {in_short(target)}"
        )
    require_known(name)
    if not text and (given or name != YIELD):
        raise ValueError(
            f'QUANTITY=VALUE must have a value, e.g. "max_pressure=4 GPa", got {in_short(target)}'
        )
    return name, _value(name, text) if text else 1.0


def _value(name: str, text: str) -> float:
    """Return the value of a quantity in SI units, from a number or a number with a unit."""
    from ..units import from_text

    try:
        return float(text)
    except ValueError:
        unit = unit_of(name)
        try:
            return from_text(text, {"m2": "m**2", "1": ""}.get(unit, unit))
        except ValueError as error:
            what = " (a number without a unit)" if unit == "1" else ""
            raise ValueError(f"QUANTITY=VALUE: value of {name} {error}{what}") from None

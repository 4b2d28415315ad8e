# SPDX-License-Identifier: GPL-3.0-or-later
"""Command `materials`, which lists the material library: constants and their sources."""

from __future__ import annotations

import click

from .. import materials as _library
from .errors import short_errors


@click.command(short_help="List the library of materials.")
@click.argument("name", required=False)
def materials(name: str | None) -> None:
    """List the library of materials, or all constants of the material NAME with their sources.

    In a case file, write material = "52100" in [body1] or [body2].
    """
    with short_errors():
        entries = [_library.get(known) for known in ([name] if name else _library.names())]
    if name:
        (entry,) = entries
        also = f" (also {', '.join(entry.aliases)})" if entry.aliases else ""
        click.echo(f"{entry.name}{also}: {entry.description}")
        for constant, known in entry.values.items():
            note = f"; {known.condition}" if known.condition else ""
            click.echo(f"  {constant:<14}{known!s:<18}{known.source}{note}")
        click.echo(f"  laws: {', '.join(entry.laws) or 'none, constants are missing'}")
        return
    from .tables import Sheet, new_console

    sheet = Sheet("Library of materials; samcontact materials NAME shows the sources")
    sheet.add("name", [entry.name for entry in entries])
    for constant in ("E", "nu"):
        sheet.add(constant, [str(entry.values.get(constant, "-")) for entry in entries])
    sheet.add("heat", ["yes" if entry.thermal else "-" for entry in entries])
    sheet.add("laws", [", ".join(entry.laws) or "-" for entry in entries])
    sheet.add("description", [entry.description for entry in entries])
    new_console().print(sheet)

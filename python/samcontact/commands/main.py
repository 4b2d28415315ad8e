# SPDX-License-Identifier: GPL-3.0-or-later
"""Command ``samcontact``: solve case files and parameter studies, write reports and exports.

Exit codes: 0 success, 1 failure of the computation or of writing results, 2 bad input,
130 interrupted (Ctrl-C), 143 terminated, 129 terminal closed.
"""

from __future__ import annotations

import os
from typing import Any

import click

from .._util.version import version
from .doctor import doctor
from .examples import cases, new
from .find import find
from .hertz import hertz
from .materials import materials
from .results import export, report
from .run import resume, run
from .signals import stoppable
from .streams import guarded_output
from .sweep import sweep


def _print_version(context: click.Context, _: click.Parameter, value: bool) -> None:
    if not value or context.resilient_parsing:
        return
    click.echo(f"samcontact {version}")
    context.exit()


class _GuardedGroup(click.Group):
    """Command group that handles failing output and termination signals in all its commands.

    This includes help texts and usage errors; see `guarded_output` and `stoppable`.
    """

    def main(self, *args: Any, **settings: Any) -> Any:
        os.environ.pop(
            "MPLBACKEND", None
        )  # figures are written to files and need no backend; an invalid one would fail
        with stoppable(), guarded_output():
            return super().main(*args, **settings)


@click.group(cls=_GuardedGroup, context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_version,
    help="Show the version and exit.",
)
def main() -> None:
    """Semi-analytical elastic-plastic contact of two half-spaces."""


for _command in (
    new, cases, run, resume, sweep, find, report, export, hertz, materials, doctor,
):  # fmt: skip
    main.add_command(_command)

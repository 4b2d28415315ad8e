# SPDX-License-Identifier: GPL-3.0-or-later
"""The command that tells what is installed and whether it works."""

from __future__ import annotations

import click

from .errors import FAILED, short_errors


@click.command()
def doctor() -> None:
    """Tell what is installed, and check that it computes: exit code 1 when it does not."""
    failed = False
    with short_errors():
        from . import self_check as checkup

        for name, text in checkup.installation():
            click.echo(f"{name:<12}{text}")
        click.echo()
        for verdict in checkup.self_check():
            number = f"{verdict.shown}, limit {verdict.condition}"
            click.echo(f"{verdict.word:<8}{verdict.name}: {number}")
            failed = failed or not verdict.passed
    if failed:
        raise SystemExit(FAILED)

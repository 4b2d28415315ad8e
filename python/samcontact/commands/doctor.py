# SPDX-License-Identifier: GPL-3.0-or-later
"""Command `doctor`: versions and a self-test of the installation."""

from __future__ import annotations

import click

from .errors import EXIT_FAILED, short_errors


@click.command(short_help="Show versions and run a self-test.")
def doctor() -> None:
    """Show versions and run a self-test; exit code 1 if the test fails."""
    failed = False
    with short_errors():
        from . import self_check as checkup

        for name, text in checkup.installation():
            click.echo(f"{name:<12}{text}")
        click.echo()
        for check in checkup.self_check():
            number = f"{check.shown}, limit {check.condition}"
            click.echo(f"{check.word:<8}{check.name}: {number}")
            failed = failed or not check.passed
    if failed:
        raise SystemExit(EXIT_FAILED)

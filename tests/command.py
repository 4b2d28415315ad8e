# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of the command `samcontact` in this process, and checks of its files."""

from pathlib import Path

from click.testing import CliRunner

from samcontact import results
from samcontact.commands.folder import is_own
from samcontact.commands.main import main


def invoke(*arguments):
    outcome = CliRunner().invoke(main, [str(argument) for argument in arguments])
    if outcome.exit_code == 0 and arguments[0] in ("run", "resume"):
        lines = [line for line in outcome.stdout.splitlines() if "/" in line]
        written = [Path(line) for line in lines if Path(line).is_file()]
        # otherwise a later run would leave it next to results that it does not belong to
        assert [file for file in written if not is_own(file)] == []
    return outcome


def check_failure(outcome, code, *messages):
    assert outcome.exit_code == code
    assert outcome.stdout == ""
    assert outcome.stderr.startswith("error: ")
    assert "Traceback" not in outcome.stderr
    for message in messages:
        assert message in outcome.stderr


def fields(folder):
    with results.open_results(folder / "results.nc") as data:
        del data.attrs["created"], data.attrs["history"]
        return data.load()


def pressed(*_, **__):
    raise KeyboardInterrupt

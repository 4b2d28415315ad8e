# SPDX-License-Identifier: GPL-3.0-or-later
"""Run of the commands of an application in an empty folder, with their processor time."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path
from typing import Any

from .application import Application, Work, as_record


def run(application: Application, folder: Path) -> tuple[Work, dict[str, Any]]:
    """Run the commands; return the folder with the results, and the record to be stored."""
    words = [["new", application.kind], *map(split, application.commands)]
    done = [command(one, folder) for one in words]
    work = Work(folder, application.kind, tuple(output for output, _ in done[1:]))
    record = {
        "answers": [as_record(answer) for answer in application.answers(work)],
        "tables": [
            table
            for output in work.outputs
            for title in application.shown
            if (table := printed_table(output, title))
        ],
        "seconds": [round(seconds, 1) for _, seconds in done[1:]],
        "case": (folder / f"{application.kind}.toml").read_text(encoding="utf-8"),
    }
    return work, record


def split(command: str) -> list[str]:
    """Split a command into words; text in double quotes is one word."""
    parts = command.split('"')
    return [
        word
        for number, part in enumerate(parts)
        for word in ([part] if number % 2 else part.split())
    ]


def command(words: list[str], folder: Path) -> tuple[str, float]:
    """Run `samcontact WORDS` with one thread; return what it prints, and its processor time [s]."""
    plain = {"OMP_NUM_THREADS": "1", "COLUMNS": "140", "FORCE_COLOR": "", "CLICOLOR_FORCE": ""}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [sys.executable, "-m", "samcontact", *words],
        cwd=folder,
        env={**os.environ, **plain},
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"samcontact {' '.join(words)}: {done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.stdout, used


def printed_table(output: str, title: str) -> str:
    """Return the table below a title in the output of a command; "" if there is none."""
    lines = output.splitlines()
    starts = [n for n, line in enumerate(lines[:-1]) if line.startswith(title)]
    starts = [n for n in starts if lines[n + 1].startswith("┏")]
    if not starts:
        return ""
    end = next(n for n in range(starts[-1], len(lines)) if lines[n].startswith("└"))
    return "\n".join(line.rstrip() for line in lines[starts[-1] : end + 1])

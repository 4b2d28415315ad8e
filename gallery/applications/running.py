# SPDX-License-Identifier: GPL-3.0-or-later
"""Run of the commands of an application in an empty folder, with their processor time."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path
from typing import Any

from .application import Answer, Application, Work, as_record, with_errors


def run(application: Application, folder: Path) -> tuple[Work, dict[str, Any]]:
    """Run the commands; return the folder with the results, and the record to be stored."""
    command(["new", application.kind], folder)
    done = [command(split(one), folder) for one in application.commands]
    work = Work(folder, application.kind, tuple(output for output, _ in done))
    answers = application.answers(work)
    if application.coarser:
        answers = with_errors(answers, coarse_answers(application, folder))
    record = {
        "answers": [as_record(answer) for answer in answers],
        "tables": [
            table
            for output in work.outputs
            for title in application.shown
            if (table := printed_table(output, title))
        ],
        "seconds": [round(seconds, 1) for _, seconds in done],
        "case": (folder / f"{application.kind}.toml").read_text(encoding="utf-8"),
    }
    return work, record


def coarse_answers(application: Application, folder: Path) -> list[Answer]:
    """Run the commands on coarser cells in a subfolder; return the answers."""
    case = f"{application.kind}.toml"
    text = (folder / case).read_text(encoding="utf-8")
    coarse = folder / "coarse"
    coarse.mkdir()
    (coarse / case).write_text(application.coarse_case(text), encoding="utf-8")
    outputs = tuple(command(split(one), coarse)[0] for one in application.commands)
    return application.answers(Work(coarse, application.kind, outputs))


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

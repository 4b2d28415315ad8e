# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands `new` and `cases`, which write example case files."""

from __future__ import annotations

from pathlib import Path

import click

from ..files.atomic import replacing
from .errors import short_errors
from .example_cases import FIRST_CASES, example_names, example_text, example_title


def _write_new(file: Path, text: str) -> bool:
    """Write a file unless it exists with the same text; return whether it was written.

    Raises
    ------
    ValueError
        The file exists with another text.
    """
    if file.exists() or file.is_symlink():
        if file.is_file() and file.read_bytes() == text.encode():
            return False
        raise ValueError(f"{file} exists already: choose another path, or remove the file")
    with replacing(file) as part:
        part.write_bytes(text.encode())
    return True


@click.command(epilog=f"Kinds: {', '.join(sorted(FIRST_CASES))}.")
@click.argument("kind", type=click.Choice(sorted(FIRST_CASES)), metavar="KIND")
@click.argument("path", required=False, type=click.Path(dir_okay=False, path_type=Path))
def new(kind: str, path: Path | None) -> None:
    """Write a commented case file for a kind of problem.

    PATH is KIND.toml if it is not given. An existing file is not replaced.
    """
    with short_errors():
        file = Path(f"{kind}.toml") if path is None else path
        written = _write_new(file, example_text(FIRST_CASES[kind], str(file)))
        exists = "" if written else " (exists already, unchanged)"
        click.echo(f"{file}{exists}\nsolve it with: samcontact run {file}")


@click.command()
@click.argument("folder", required=False, type=click.Path(file_okay=False, path_type=Path))
def cases(folder: Path | None) -> None:
    """List the example cases, or write all of them to FOLDER.

    The folder is created if it does not exist. Files that you have changed are not replaced.
    """
    with short_errors():
        names = example_names()
        if folder is None:
            width = max(map(len, names))
            for name in names:
                click.echo(f"{name:{width}}  {example_title(name)}")
            click.echo("\nsamcontact cases FOLDER writes these case files to a folder.")
            return
        files = {folder / f"{name}.toml": name for name in names}
        texts = {file: example_text(name, str(file)) for file, name in files.items()}
        folder.mkdir(parents=True, exist_ok=True)
        written = sum(_write_new(file, text) for file, text in texts.items())
        click.echo(f"{folder}: {written} case files written, {len(files) - written} unchanged")

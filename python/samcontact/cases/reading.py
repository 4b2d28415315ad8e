# SPDX-License-Identifier: GPL-3.0-or-later
"""Reader of case files."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util.checks import file_path
from .base import CaseError
from .kinds import kind_of
from .rolling_parts import short_places

if TYPE_CHECKING:
    from .kinds import AnyCase

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

MAX_CHARACTERS = 100_000_000
"""Maximum number of characters in a case file."""


def load_case(path: str | Path) -> AnyCase:
    """Read and validate a case file.

    Parameters
    ----------
    path : str or Path
        TOML file; the documentation and `cases/` show the layout.

    Returns
    -------
    Case, AsperityCase, FilmCase or SlidingCase
        An `AsperityCase` if the file has a section [asperities], a `FilmCase` if it has [film], a
        `SlidingCase` if it has [sliding], otherwise a `Case`.

    Raises
    ------
    CaseError
        The file cannot be read, is not TOML, or a field is missing, unknown or out of range.
    """
    try:
        source = file_path("path", path)
    except ValueError as error:
        raise CaseError(f"cannot read the case file: {error}") from None
    try:
        text = _text_of(source)
    except UnicodeDecodeError as error:
        reason = f"its byte {error.start} is not UTF-8: save it as UTF-8 text"
        raise CaseError(f"{source}: cannot read the case file: {reason}") from error
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise CaseError(f"{source}: cannot read the case file: {reason}") from error
    return parse_case(text, source)


def _text_of(source: Path) -> str:
    with source.open(encoding="utf-8") as file:
        text = file.read(MAX_CHARACTERS + 1)  # devices may be endless
    if len(text) > MAX_CHARACTERS:
        raise ValueError(f"more than {MAX_CHARACTERS} characters: check that it is a case file")
    return text


def parse_case(text: str, source: str | Path = "case.toml") -> AnyCase:
    """Validate the text of a case file, e.g. the text stored with results.

    Parameters
    ----------
    text : str
        Content of a case file, in TOML.
    source : str or Path, optional
        Path of the file with this text, for error messages. Relative paths in the text start from
        the folder of this file.

    Returns
    -------
    Case, AsperityCase, FilmCase or SlidingCase
        An `AsperityCase` if the text has a section [asperities], a `FilmCase` if it has [film], a
        `SlidingCase` if it has [sliding], otherwise a `Case`.

    Raises
    ------
    CaseError
        The text is not TOML, or a field is missing, unknown or out of range.
    """
    source = Path(source)
    try:
        # some editors begin a text with a byte order mark
        content = tomllib.loads(text.removeprefix("\N{ZERO WIDTH NO-BREAK SPACE}"))
        case = validated(content, source)
    except CaseError:
        raise
    except ValueError as error:  # ValueError: also for numbers of thousands of digits
        raise CaseError(f"{source}: not valid TOML: {error}") from error
    except RecursionError:
        raise CaseError(f"{source}: lists or tables are nested too deeply") from None
    return case.written_in(source, text)


def validated(content: Mapping[str, Any], source: Path) -> AnyCase:
    """Validate the fields of a case file; raises CaseError for invalid fields."""
    try:
        return kind_of(content).model_validate(content)
    except CaseError as error:
        lines = short_places(str(error), content).split("\n")
        raise CaseError("\n".join(f"{source}: {line}" for line in lines)) from None

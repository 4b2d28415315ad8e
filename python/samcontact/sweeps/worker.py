# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of one case of a sweep in any process; input and output are plain data."""

from __future__ import annotations

import hashlib
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util.errors import ResolutionWarning
from .._util.version import version
from ..restart.identity import digest, identity
from .tasks import film_scalars, search_results, solved

if TYPE_CHECKING:
    import xarray as xr

    from ..cases.base import CaseFile

Variables = dict[str, tuple[tuple[str, ...], Any, dict[str, str]]]
"""Variables of a case by name: dimensions, array and attributes of each."""
Outcome = dict[str, Any]
"""Outcome of a case: {"variables": Variables} or {"error": text}."""


def solve_case(
    content: Mapping[str, Any], source: str, search: Mapping[str, Any] | None = None
) -> Outcome:
    """Solve a case and return all quantities that have one value per increment, cycle or case.

    Parameters
    ----------
    content : mapping
        Fields of a case file.
    source : str
        Path of the case file. Paths of height files in the case are relative to its folder.
    search : mapping, optional
        Arguments of `samcontact.find_load`. If given, the case is not solved at its own load;
        instead, the load is found at which a quantity reaches its target value.

    Returns
    -------
    dict
        Entry "variables" with the results, or entry "error" with text if the case cannot be solved.
        Exceptions are returned as text, because not every exception can be passed between
        processes.
    """
    from ..cases import Case, FilmCase, kind_of

    try:
        case = kind_of(content).model_validate(content).written_in(Path(source))
        if isinstance(case, FilmCase):
            return {"variables": _plain(film_scalars(case))}
        if not isinstance(case, Case):
            return {"variables": _plain(case.solved())}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ResolutionWarning)  # the sweep warns once for all cases
            found = solved(case) if search is None else search_results(case, search)
        return {"variables": _plain(found)}
    except Exception as error:
        return failure(error)


def failure(error: BaseException) -> Outcome:
    """Return the outcome of a case that failed with an exception."""
    return {"error": f"{type(error).__name__}: {error}"}


def _plain(dataset: xr.Dataset) -> Variables:
    return {
        str(name): (tuple(map(str, field.dims)), field.values, dict(field.attrs))
        for name, field in dataset.data_vars.items()
    }


def case_key(
    case: CaseFile, digests: dict[Path, str], search: Mapping[str, Any] | None = None
) -> str:
    """Return a hash of all that affects the results: fields, height files and package version.

    Fields that do not affect the results, such as title and output folder, are omitted.

    Parameters
    ----------
    case : CaseFile
        Validated case.
    digests : dict
        Hashes of the files read so far, by path. The hashes of further files are added to it.
    search : mapping, optional
        As for `solve_case`.

    Raises
    ------
    CaseError
        A file of heights cannot be read.
    """
    unimportant: Any = {
        "title": True,
        "description": True,
        "estimate_error": True,
        "output": {"directory", "figures", "format", "column", "volume"},
    }
    fields = case.model_dump(exclude=unimportant)
    heights = [_digest(case, name, digests) for name in ("surface", "relief1", "relief2")]
    searched = {} if search is None else {"search": dict(search)}
    return digest(identity(version=version, heights=heights, **searched, **fields))


def _digest(case: CaseFile, name: str, digests: dict[Path, str]) -> str | None:
    """Return the hash of the files that a section names, or None if it names no file."""
    files = getattr(getattr(case, name, None), "files", {})
    found = [
        _hash(case, f"{name}.{field}", case.source.parent / path, digests)
        for field, path in files.items()
    ]
    return " ".join(found) or None


def _hash(case: CaseFile, field: str, file: Path, digests: dict[Path, str]) -> str:
    from ..cases.base import CaseError

    if file not in digests:
        try:
            digests[file] = hashlib.sha256(file.read_bytes()).hexdigest()
        except OSError as error:
            reason = error.strerror or error
            message = f"{field}: cannot read heights from {file}: {reason}"
            raise CaseError(f"{case.source}: {message}") from error
    return digests[file]

# SPDX-License-Identifier: GPL-3.0-or-later
"""One case of a sweep as a task for any process: plain data in, plain data out."""

from __future__ import annotations

import hashlib
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util.errors import ResolutionWarning
from .._util.version import version
from ..restart.identity import digest, identity

if TYPE_CHECKING:
    import xarray as xr

    from ..cases.base import CaseFile

Variables = dict[str, tuple[tuple[str, ...], Any, dict[str, str]]]
"""Of each name: dimensions, array and attributes."""
Outcome = dict[str, Any]
"""{"variables": Variables} or {"error": text}."""


def solve_case(content: Mapping[str, Any], source: str) -> Outcome:
    """Solve a case and return what has one value per increment.

    Parameters
    ----------
    content : mapping
        The fields of a case file.
    source : str
        The case file that they are of; files of heights are looked for beside it.

    Returns
    -------
    dict
        "variables", or "error" of a case that cannot be solved: exceptions are returned as text,
        since not every kind of exception can travel between processes.
    """
    from ..cases import Case, TuggingCase

    try:
        kind = TuggingCase if "tugging" in content else Case
        case = kind.model_validate(content).written_in(Path(source))
        if isinstance(case, TuggingCase):
            return {"variables": _plain(case.solve(progress=False).series)}
        return {"variables": _solve(case)}
    except Exception as error:
        return failure(error)


def failure(error: BaseException) -> Outcome:
    """The outcome of a case that ended with an exception."""
    return {"error": f"{type(error).__name__}: {error}"}


def _solve(case: Any) -> Variables:
    from .. import results
    from ..accuracy import to_accuracy

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResolutionWarning)  # the sweep tells it of all
        if case.accuracy is not None:
            dataset = to_accuracy(case, progress=False).to_dataset(volume="none")
        else:
            simulation, path = case.build()
            states = simulation.run(path, progress=False)
            dataset = results.to_dataset(simulation, states, case, volume="none")
    names = [name for name, field in dataset.data_vars.items() if field.dims == ("increment",)]
    return _plain(dataset[names])


def _plain(dataset: xr.Dataset) -> Variables:
    return {
        str(name): (tuple(map(str, field.dims)), field.values, dict(field.attrs))
        for name, field in dataset.data_vars.items()
    }


def case_key(case: CaseFile, digests: dict[Path, str]) -> str:
    """Hash of all that a case's numbers depend on: its fields, heights of files, and the version.

    Titles and where results go are no part of it.

    Parameters
    ----------
    case : CaseFile
        A validated case.
    digests : dict
        Hashes of files that were read before; more are added.

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
    return digest(identity(version=version, heights=heights, **fields))


def _digest(case: CaseFile, name: str, digests: dict[Path, str]) -> str | None:
    """Hash of the file that a section names; None without one."""
    from ..cases.base import CaseError

    path = getattr(getattr(case, name, None), "path", None)
    if path is None:
        return None
    file = case.source.parent / path
    if file not in digests:
        try:
            digests[file] = hashlib.sha256(file.read_bytes()).hexdigest()
        except OSError as error:
            reason = error.strerror or error
            message = f"{name}.path: cannot read heights from {file}: {reason}"
            raise CaseError(f"{case.source}: {message}") from error
    return digests[file]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoint files: HDF5 files in a common format, each with a digest at the end."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py

from .. import _core
from .._util.checks import file_path
from ..files.atomic import replacing_hdf5
from ..files.checksum import check_seal
from ..files.ownership import is_marked
from .identity import Identity, differences
from .tree import Tree, read_tree, write_tree

_FORMAT = "samcontact checkpoint"
_FORMAT_VERSION = 12
_SIGNATURE = b"\x89HDF\r\n\x1a\n"

READ_ERRORS = (
    OSError, KeyError, ValueError, TypeError, AttributeError, IndexError, OverflowError,
    RuntimeError, MemoryError,
)  # fmt: skip
"""Exceptions that h5py, NumPy and the compiled core raise for a file with invalid content."""


class CheckpointError(ValueError):
    """Error for a file that is not a checkpoint of this package, or is damaged."""


class DamagedCheckpointError(CheckpointError):
    """Error for a damaged checkpoint of this package; an earlier checkpoint may be usable."""


class ForeignCheckpointError(CheckpointError):
    """Error for a checkpoint of another run."""


def damaged(path: str | os.PathLike[str], error: BaseException) -> DamagedCheckpointError:
    """Return a DamagedCheckpointError for a checkpoint whose content caused `error`."""
    return DamagedCheckpointError(f"{os.fspath(path)!r} is damaged: {error}")


@contextmanager
def readable(path: str | os.PathLike[str]) -> Iterator[None]:
    """Context manager that converts errors due to invalid content to DamagedCheckpointError."""
    try:
        yield
    except CheckpointError:
        raise
    except READ_ERRORS as error:
        raise damaged(path, error) from error


def write(path: str | os.PathLike[str], kind: str, tree: Mapping[str, Any]) -> None:
    """Write a dictionary of data to a checkpoint file; if writing fails, an existing file is kept.

    kind: type of the content, e.g. "simulation"; `read` requires the same kind.
    """
    file_path("path", path)
    with replacing_hdf5(path) as opened, h5py.File(opened, "w") as file:
        file.attrs.update(
            format=_FORMAT,
            format_version=_FORMAT_VERSION,
            samcontact_version=_core.version,
            kind=kind,
        )
        write_tree(file, tree)


def read(path: str | os.PathLike[str], kind: str) -> Tree:
    """Read the dictionary of data that `write` has written to a file.

    Raises FileNotFoundError if there is no file, CheckpointError for a file of another program,
    format or kind, and DamagedCheckpointError if the file has changed since it was written.
    """
    if not file_path("path", path).is_file():
        raise FileNotFoundError(f"no checkpoint at {os.fspath(path)!r}")
    try:
        if not check_seal(path):  # HDF5 may not terminate on a damaged file
            raise _unsealed(path)
        with h5py.File(path, "r") as file:
            require_self_contained(file)
            _require_format(path, kind, dict(file.attrs))
            return read_tree(file)
    except CheckpointError:
        raise
    except READ_ERRORS as error:
        raise damaged(path, error) from error


def other_version(path: str | os.PathLike[str], tree: Tree) -> str:
    """Return a message if another version of this package wrote a checkpoint, otherwise ""."""
    version = tree.get("samcontact_version")
    if version == _core.version:
        return ""
    return f"{os.fspath(path)!r} was written by samcontact {version}, not {_core.version}"


def _unsealed(path: str | os.PathLike[str]) -> ValueError:
    """Return the error for a file without a digest: not written by this package, or damaged."""
    with open(path, "rb") as file:
        is_hdf5 = file.read(len(_SIGNATURE)) == _SIGNATURE
    if not is_hdf5:
        return ValueError("the file is not an HDF5 file")
    if not is_marked(Path(path)):
        return CheckpointError(f"{os.fspath(path)!r} is not a samcontact checkpoint")
    return ValueError("the checksum at the end is missing: the file is incomplete or was changed")


def require_self_contained(file: h5py.Group) -> None:
    """Raise ValueError if parts of an HDF5 file are stored in other files."""
    found: list[str] = []  # h5py drops exceptions raised within a visit

    def check_link(name: str, link: Any) -> None:
        if isinstance(link, h5py.ExternalLink):
            found.append(f"{name} is a link to another file, {link.filename!r:.80}")

    def check(name: str, part: h5py.Group | h5py.Dataset) -> None:
        if isinstance(part, h5py.Dataset) and (part.external or part.is_virtual):
            found.append(f"the values of {name} are in another file")

    file.visititems_links(check_link)
    file.visititems(check)
    if found:
        raise ValueError(f"{found[0]}, which is not supported: copy the values into the file")


def require_same(path: str | os.PathLike[str], now: Identity, tree: Tree) -> None:
    """Raise ForeignCheckpointError if a checkpoint was written by another run or version.

    now: identity of the current run. tree: content of the checkpoint.
    """
    before = tree.get("run")
    if text := other_version(path, tree):
        raise ForeignCheckpointError(
            f"{text}, so results may differ in the last digits: continue with the version that "
            "wrote the checkpoint, or start again with another path"
        )
    if now != before:
        text = differences(now, before) if isinstance(before, dict) else "a single simulation"
        raise ForeignCheckpointError(
            f"{os.fspath(path)!r} is a checkpoint of another run ({text}): remove this file, or "
            "use another path"
        )


def _require_format(path: str | os.PathLike[str], kind: str, found: Mapping[str, Any]) -> None:
    name = f"{os.fspath(path)!r}"
    if not isinstance(found.get("format"), str) or found["format"] != _FORMAT:
        raise CheckpointError(f"{name} is not a samcontact checkpoint")
    version = int(found["format_version"])
    if version != _FORMAT_VERSION:
        raise CheckpointError(
            f"{name} has checkpoint format {version}, but samcontact {_core.version} reads format "
            f"{_FORMAT_VERSION}: use samcontact {found.get('samcontact_version')}, or start again "
            "with another path"
        )
    if found.get("kind") != kind:
        raise CheckpointError(f"{name} is a checkpoint of {found.get('kind')!r}, not of {kind!r}")

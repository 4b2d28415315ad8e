# SPDX-License-Identifier: GPL-3.0-or-later
"""SHA-256 digest at the end of an HDF5 file, by which any later change of the file is detected.

The header of an HDF5 file contains the file length, and HDF5 ignores all bytes after it. The
digest is checked before the file is opened, because the HDF5 library may crash on damaged metadata.
"""

from __future__ import annotations

import hashlib
import os
from typing import BinaryIO

_MARK = b"\nsamcontact sha256 "
_DIGEST_CHARACTERS = 64
SEAL_BYTES = len(_MARK) + _DIGEST_CHARACTERS + 1
"""Total length of the mark and the digest that are appended to a file [bytes]."""
_BLOCK = 1 << 20


def seal(path: str | os.PathLike[str]) -> None:
    """Append the digest to a complete file. If HDF5 later changes the file, the digest is lost."""
    with open(path, "r+b") as file:
        digest = _digest(file, os.fstat(file.fileno()).st_size)
        file.write(_MARK + digest + b"\n")


def check_seal(path: str | os.PathLike[str]) -> bool:
    """Whether the file ends with a digest.

    Raises ValueError if the content of the file does not match the digest.
    """
    with open(path, "rb") as file:
        length = max(0, os.fstat(file.fileno()).st_size - SEAL_BYTES)
        file.seek(length)
        end = file.read(SEAL_BYTES)
        if not end.startswith(_MARK) or len(end) < SEAL_BYTES:
            if _MARK.strip() in end or any(end.endswith(_MARK[:n]) for n in range(4, len(_MARK))):
                raise ValueError("the file is incomplete, or data was appended to it")
            return False
        file.seek(0)
        if end != _MARK + _digest(file, length) + b"\n":
            raise ValueError("the file has changed since it was written")
    return True


def _digest(file: BinaryIO, length: int) -> bytes:
    """Return the SHA-256 digest of the next `length` bytes of a file."""
    digest = hashlib.sha256()
    while length > 0:
        block = file.read(min(_BLOCK, length))
        if not block:
            break
        digest.update(block)
        length -= len(block)
    return digest.hexdigest().encode()

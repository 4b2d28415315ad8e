# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command prints, on any terminal and into any pipe: it never costs results."""

from __future__ import annotations

import codecs
import errno
import os
import sys
import unicodedata
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

import click

_NEAREST = {"µ": "u", "μ": "u", "≤": "<=", "≥": ">=", "×": "x", "·": ".", "°": "deg", "–": "-",
            "—": "-", "…": "..."}  # fmt: skip


def _nearest(error: UnicodeError) -> tuple[str, int]:
    """Characters that a terminal has instead of those that it has not."""
    assert isinstance(error, UnicodeEncodeError)
    shown = []
    for character in error.object[error.start : error.end]:
        plain = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
        shown.append(_NEAREST.get(character) or plain or "?")
    return "".join(shown), error.end


codecs.register_error("samcontact.nearest", _nearest)


class _Guarded:
    """A text stream: what it cannot take is lost, and nothing else is."""

    def __init__(self, stream: Any) -> None:
        self._stream = stream
        self.error: OSError | None = None

    def write(self, text: str | bytes) -> int:
        if isinstance(text, bytes):  # of shell completion
            text = text.decode()
        if self.error is None:
            try:
                self._stream.write(text)
            except UnicodeEncodeError:
                encoding = self._stream.encoding
                self.write(text.encode(encoding, "samcontact.nearest").decode(encoding))
            except OSError as error:
                self._lose(error)
        return len(text)

    def flush(self) -> None:
        if self.error is None:
            try:
                self._stream.flush()
            except OSError as error:
                self._lose(error)

    def _lose(self, error: OSError) -> None:
        """Go on without it; what is still in its buffer must not fail when the process ends."""
        self.error = error
        with suppress(OSError, ValueError, AttributeError):
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, self._stream.fileno())
            os.close(nowhere)

    def __getattr__(self, name: str) -> Any:
        if name == "buffer":  # click would write to it, past this
            raise AttributeError(name)
        return getattr(self._stream, name)


@contextmanager
def guarded_output() -> Iterator[None]:
    """Standard output and error that cannot fail meanwhile; warnings are one line each.

    In the end, exit code 1 when output was lost.
    """
    streams, form = (sys.stdout, sys.stderr), warnings.formatwarning
    with open(os.devnull, "w", encoding="utf-8") as nowhere:
        # Python has None for those that are closed
        guards = [_Guarded(nowhere if stream is None else stream) for stream in streams]
        sys.stdout, sys.stderr = guards
        warnings.formatwarning = lambda message, *_, **__: f"warning: {message}\n"
        try:
            yield
        except SystemExit as end:
            if end.code:
                raise  # else success depends on what comes now
        finally:
            for guard in guards:
                guard.flush()
            warnings.formatwarning = form
            sys.stdout, sys.stderr = streams
    lost = guards[0].error
    if lost is not None:
        if lost.errno != errno.EPIPE:  # else its reader has left
            click.echo(f"error: cannot write to the standard output: {lost.strerror}", err=True)
        raise SystemExit(1)

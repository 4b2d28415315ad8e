# SPDX-License-Identifier: GPL-3.0-or-later
"""Output streams of the command, which do not stop a run if the terminal or pipe fails."""

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

_ASCII_SUBSTITUTES = {
    "µ": "u", "μ": "u", "≤": "<=", "≥": ">=", "×": "x", "·": ".", "°": "deg", "–": "-", "—": "-",
    "…": "...",
}  # fmt: skip


def _nearest(error: UnicodeError) -> tuple[str, int]:
    """Return ASCII text for characters that the terminal cannot show, and their end position."""
    assert isinstance(error, UnicodeEncodeError)
    shown = []
    for character in error.object[error.start : error.end]:
        plain = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
        shown.append(_ASCII_SUBSTITUTES.get(character) or plain or "?")
    return "".join(shown), error.end


codecs.register_error("samcontact.nearest", _nearest)


class _GuardedStream:
    """Text stream that discards output if writing fails, instead of raising an error."""

    def __init__(self, stream: Any) -> None:
        self._stream = stream
        self.error: OSError | None = None

    def write(self, text: str | bytes) -> int:
        if isinstance(text, bytes):  # bytes come from shell completion
            text = text.decode()
        if self.error is None:
            try:
                self._stream.write(text)
            except UnicodeEncodeError:
                encoding = self._stream.encoding
                self.write(text.encode(encoding, "samcontact.nearest").decode(encoding))
            except OSError as error:
                self._redirect(error)
        return len(text)

    def flush(self) -> None:
        if self.error is None:
            try:
                self._stream.flush()
            except OSError as error:
                self._redirect(error)

    def _redirect(self, error: OSError) -> None:
        """Redirect a failed stream to the null device, so that flushing at exit cannot fail."""
        self.error = error
        with suppress(OSError, ValueError, AttributeError):
            null_device = os.open(os.devnull, os.O_WRONLY)
            os.dup2(null_device, self._stream.fileno())
            os.close(null_device)

    def __getattr__(self, name: str) -> Any:
        if name == "buffer":  # click would write to the buffer directly
            raise AttributeError(name)
        return getattr(self._stream, name)


@contextmanager
def guarded_output() -> Iterator[None]:
    """Context manager in which output never raises errors and each warning is printed on one line.

    If text for the standard output was lost, SystemExit with code 1 is raised at the end.
    """
    streams, form = (sys.stdout, sys.stderr), warnings.formatwarning
    with open(os.devnull, "w", encoding="utf-8") as null_device:
        # closed streams are None
        guards = [_GuardedStream(null_device if stream is None else stream) for stream in streams]
        sys.stdout, sys.stderr = guards
        warnings.formatwarning = lambda message, *_, **__: f"warning: {message}\n"
        try:
            yield
        except SystemExit as end:
            if end.code:
                raise  # a nonzero exit code is kept, even if output was lost
        finally:
            for guard in guards:
                guard.flush()
            warnings.formatwarning = form
            sys.stdout, sys.stderr = streams
    lost = guards[0].error
    if lost is not None:
        if lost.errno != errno.EPIPE:  # EPIPE: the reader closed the pipe; no message
            click.echo(f"error: cannot write to the standard output: {lost.strerror}", err=True)
        raise SystemExit(1)

# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a long call is: a bar on a terminal or in a notebook, else a few lines."""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import Any, TextIO

LINES = 10
"""At most, of a call whose messages go into a file or a pipe."""


def progress_bar(
    total: int, unit: str, *, shown: bool, initial: int = 0, leave: bool = True
) -> Any:
    """A context with ``update()`` and ``set_postfix(**values)``; nothing is written if not `shown`.

    A bar is drawn again and again in its place, which a log does not have: there every tenth of
    the way is a line. Without `leave`, for parts of which `tell` has a line each, the bar goes when
    it is full, and a log has none.
    """
    stream = sys.stderr if shown else None
    if not _in_place(stream):
        return _Lines(total, unit, initial, stream if leave else None)
    from tqdm.auto import tqdm  # a widget in a notebook

    return tqdm(total=total, initial=initial, unit=unit, leave=leave)


def tell(text: str, *, shown: bool) -> None:
    """One line of progress."""
    with suppress(AttributeError, OSError, ValueError):  # no reason to end a run
        if shown and sys.stderr is not None:
            print(text, file=sys.stderr, flush=True)


def _in_place(stream: TextIO | None) -> bool:
    """On a terminal or in a notebook, what is written can be replaced."""
    if stream is None:
        return False
    try:
        return stream.isatty() or type(stream).__module__.startswith("ipykernel.")
    except (AttributeError, OSError, ValueError):  # closed, or hardly a stream
        return False


class _Lines:
    """Progress as lines, by counts: the same run writes the same lines."""

    def __init__(self, total: int, unit: str, initial: int, stream: TextIO | None) -> None:
        self.total, self.unit, self.count, self.stream = total, unit, initial, stream
        self.told = initial * LINES // max(total, 1)

    def __enter__(self) -> _Lines:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def update(self, count: int = 1) -> None:
        self.count += count
        part = self.count * LINES // max(self.total, 1)
        if part > self.told and self.told < LINES and self.stream is not None:
            self.told = part
            tell(f"{self.unit} {self.count} of {self.total}", shown=True)

    def set_postfix(self, **_: object) -> None:
        """What a bar shows of the present step is left out of the lines."""

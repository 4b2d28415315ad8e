# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress of long calls: a bar on a terminal or in a notebook, otherwise a few lines."""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import Any, TextIO

MAX_LINES = 10
"""Maximum number of progress lines per call if they are written to a file or a pipe."""


def progress_bar(
    total: int, unit: str, *, shown: bool, initial: int = 0, leave: bool = True
) -> Any:
    """Context manager with ``update()`` and ``set_postfix(**values)``; silent unless `shown`.

    A terminal shows a bar that is redrawn in place; a log receives one line per tenth of the total.
    Without `leave`, the bar is removed when complete and nothing is written to a log. Use
    leave=False for tasks that `report_progress` reports with one line each.
    """
    stream = sys.stderr if shown else None
    if not _can_overwrite(stream):
        return _LineProgress(total, unit, initial, stream if leave else None)
    from tqdm.auto import tqdm  # a widget in a notebook

    return tqdm(total=total, initial=initial, unit=unit, leave=leave)


def report_progress(text: str, *, shown: bool) -> None:
    """Print one line of progress to stderr if `shown`."""
    with suppress(AttributeError, OSError, ValueError):  # failed output must not end a run
        if shown and sys.stderr is not None:
            print(text, file=sys.stderr, flush=True)


def _can_overwrite(stream: TextIO | None) -> bool:
    """Whether output can be overwritten, as on a terminal or in a notebook."""
    if stream is None:
        return False
    try:
        return stream.isatty() or type(stream).__module__.startswith("ipykernel.")
    except (AttributeError, OSError, ValueError):  # closed, or not a stream
        return False


class _LineProgress:
    """Progress as a new line after fixed numbers of steps: repeated runs write equal lines."""

    def __init__(self, total: int, unit: str, initial: int, stream: TextIO | None) -> None:
        self.total, self.unit, self.count, self.stream = total, unit, initial, stream
        self.reported = initial * MAX_LINES // max(total, 1)

    def __enter__(self) -> _LineProgress:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def update(self, count: int = 1) -> None:
        self.count += count
        part = self.count * MAX_LINES // max(self.total, 1)
        if part > self.reported and self.reported < MAX_LINES and self.stream is not None:
            self.reported = part
            report_progress(f"{self.unit} {self.count} of {self.total}", shown=True)

    def set_postfix(self, **_: object) -> None:
        """Ignore the values of the current step, which are not shown in lines."""

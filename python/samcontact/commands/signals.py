# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that end the command, as exceptions, so that computed results are saved."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ..files.atomic import ENDING

INTERRUPTED = 130
_ONE_WISH = 1.0
"""Interval [s] within which repeated signals count as one, as `timeout` signals a process and its
group."""


class Stopped(KeyboardInterrupt):
    """Interruption by Ctrl-C or by another terminating signal."""

    def __init__(self, number: int) -> None:
        super().__init__(signal.Signals(number).name)
        self.exit_code = 128 + number


def exit_code(stop: BaseException) -> int:
    """Return the exit code of an interrupted command, by the convention of shells."""
    return getattr(stop, "exit_code", INTERRUPTED)


@contextmanager
def stoppable() -> Iterator[None]:
    """Raise `Stopped` on a terminating signal; ignored signals stay ignored (nohup)."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    last = -_ONE_WISH

    def stop(number: int, _: Any) -> None:
        nonlocal last
        before, last = last, time.monotonic()
        if last - before >= _ONE_WISH:
            raise Stopped(number)

    old = {number: signal.getsignal(number) for number in ENDING}
    taken = [number for number, handler in old.items() if handler not in (None, signal.SIG_IGN)]
    for number in taken:
        signal.signal(number, stop)
    try:
        yield
    finally:
        for number in taken:
            signal.signal(number, old[number])

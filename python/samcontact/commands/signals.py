# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that end the command, converted to exceptions so that computed results are saved."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ..files.atomic import TERMINATION_SIGNALS

EXIT_INTERRUPTED = 130
_REPEAT_INTERVAL = 1.0
"""Interval [s] within which repeated signals count as one. The program `timeout` sends its signal
twice: to the process and to its group."""


class StopRequested(KeyboardInterrupt):
    """Interruption by Ctrl-C or by another terminating signal."""

    def __init__(self, number: int) -> None:
        super().__init__(signal.Signals(number).name)
        self.exit_code = 128 + number


def exit_code(stop: BaseException) -> int:
    """Return the exit code of an interrupted command: 128 + signal number, as in shells."""
    return getattr(stop, "exit_code", EXIT_INTERRUPTED)


@contextmanager
def stoppable() -> Iterator[None]:
    """Context manager in which termination signals raise `StopRequested`.

    Signals that were ignored before are still ignored.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    last = -_REPEAT_INTERVAL

    def stop(number: int, _: Any) -> None:
        nonlocal last
        before, last = last, time.monotonic()
        if last - before >= _REPEAT_INTERVAL:
            raise StopRequested(number)

    old = {number: signal.getsignal(number) for number in TERMINATION_SIGNALS}
    taken = [number for number, handler in old.items() if handler not in (None, signal.SIG_IGN)]
    for number in taken:
        signal.signal(number, stop)
    try:
        yield
    finally:
        for number in taken:
            signal.signal(number, old[number])

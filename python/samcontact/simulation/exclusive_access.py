# SPDX-License-Identifier: GPL-3.0-or-later
"""One thread at a time in a simulation."""

from __future__ import annotations

import threading


class ExclusiveAccess:
    """Refuses a second thread, or a law of softening, that would change the same simulation."""

    def __init__(self) -> None:
        self._lock = threading.Lock()

    def __enter__(self) -> None:
        if not self._lock.acquire(blocking=False):
            raise RuntimeError(
                "this simulation is in the middle of an increment: one thread at a time, each "
                "with a simulation of its own (copy.deepcopy makes one)"
            )

    def __exit__(self, *error: object) -> None:
        self._lock.release()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Exclusive access of one thread to a simulation during an increment."""

from __future__ import annotations

import threading


class ExclusiveAccess:
    """Context manager that keeps other threads and softening laws from changing a simulation."""

    def __init__(self) -> None:
        self._lock = threading.Lock()

    def __enter__(self) -> None:
        if not self._lock.acquire(blocking=False):
            raise RuntimeError(
                "an increment is already in progress: use one Simulation per thread "
                "(copy.deepcopy returns a second one)"
            )

    def __exit__(self, *error: object) -> None:
        self._lock.release()

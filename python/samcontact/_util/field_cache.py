# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields that were computed last, so that files, tables and figures of a run share each of them.

They go with the state or track that they are of, or before: when all of them together are more than
`MOST` bytes or a quarter of the memory that is available, or when memory is short.
"""

from __future__ import annotations

import math
import os
import threading
from collections.abc import Callable, Hashable
from typing import Any
from weakref import WeakKeyDictionary

from . import memory
from .checks import FloatArray
from .frozen import read_only

MOST = 512e6
_PART = 0.25
_lock = threading.Lock()  # states can be used from several threads
if hasattr(os, "register_at_fork"):  # a child has none of the threads that could give it back
    os.register_at_fork(
        before=_lock.acquire, after_in_parent=_lock.release, after_in_child=_lock.release
    )
_fields: WeakKeyDictionary[Any, dict[Hashable, FloatArray]] = WeakKeyDictionary()
"""By owner, the one that was asked last at the end, and name."""


def kept(owner: Any, name: Hashable, compute: Callable[[], FloatArray]) -> FloatArray:
    """The field of this name, computed unless it is kept; read-only."""
    with _lock:
        mine = _fields[owner] = _fields.pop(owner, {})
        if name in mine:
            return mine[name]
    field = read_only(compute())
    with _lock:
        _fields.setdefault(owner, {})[name] = field
        _drop(min(MOST, _PART * (memory.available() or math.inf)))
    return field


def forget() -> bool:
    """Let go of all; whether there was something."""
    with _lock:
        there = any(_fields.values())
        _fields.clear()
    return there


memory.GIVING.append(forget)


def _drop(most: float) -> None:
    """Let the oldest go until those left have at most so many bytes."""
    total = sum(field.nbytes for mine in _fields.values() for field in mine.values())
    for mine in list(_fields.values()):
        for name in list(mine):
            if total <= most:
                return
            total -= mine.pop(name).nbytes

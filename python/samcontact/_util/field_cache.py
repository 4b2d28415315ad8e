# SPDX-License-Identifier: GPL-3.0-or-later
"""Cache of recently computed fields, shared by the files, tables and figures of a run.

A field is removed when its state or track is deleted. The least recently used fields are removed if
the cache exceeds `MAX_BYTES` bytes or a quarter of the available memory. All fields are removed if
memory is short.
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

MAX_BYTES = 512e6
_MAX_MEMORY_FRACTION = 0.25
_lock = threading.Lock()  # states can be used in several threads
if hasattr(os, "register_at_fork"):  # a forked child lacks the thread that holds the lock
    os.register_at_fork(
        before=_lock.acquire, after_in_parent=_lock.release, after_in_child=_lock.release
    )
_fields: WeakKeyDictionary[Any, dict[Hashable, FloatArray]] = WeakKeyDictionary()
"""Fields by owner and name; the most recently used owner comes last."""


def kept(owner: Any, name: Hashable, compute: Callable[[], FloatArray]) -> FloatArray:
    """Return a read-only field of `owner`, e.g. a state; compute and store it if not cached."""
    with _lock:
        mine = _fields[owner] = _fields.pop(owner, {})
        if name in mine:
            return mine[name]
    field = read_only(compute())
    with _lock:
        _fields.setdefault(owner, {})[name] = field
        _drop(min(MAX_BYTES, _MAX_MEMORY_FRACTION * (memory.available() or math.inf)))
    return field


def forget() -> bool:
    """Remove all fields from the cache; return whether the cache contained any field."""
    with _lock:
        there = any(_fields.values())
        _fields.clear()
    return there


memory.CACHE_RELEASERS.append(forget)


def _drop(limit: float) -> None:
    """Remove the least recently used fields until at most `limit` bytes remain in the cache."""
    total = sum(field.nbytes for mine in _fields.values() for field in mine.values())
    for mine in list(_fields.values()):
        for name in list(mine):
            if total <= limit:
                return
            total -= mine.pop(name).nbytes

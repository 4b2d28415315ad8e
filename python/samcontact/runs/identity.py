# SPDX-License-Identifier: GPL-3.0-or-later
"""Which computation it is: every argument that its numbers depend on, in one canonical text."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

Identity = dict[str, str]
"""The text of each part by name; a digest where that is long."""
_SHORT = 60


def identity(**parts: Any) -> Identity:
    """Of computations with equal parts: numbers, texts, arrays, dataclasses, and lists of them."""
    return {name: _shortened(canonical(part)) for name, part in parts.items()}


def digest(who: Identity) -> str:
    """One name for all."""
    return _hash(repr(sorted(who.items())).encode())


def differences(now: Identity, before: Identity) -> str:
    """What is not the same, in words."""

    def told(name: str) -> str:
        new, old = (str(who.get(name, "nothing")) for who in (now, before))
        digests = new.count("#") + old.count("#")
        return f"another {name}" if digests else f"{name} {new} instead of {old}"

    return ", ".join(told(n) for n in {**now, **before} if now.get(n) != before.get(n))


def canonical(value: Any) -> str:
    """The same text in every process; numbers are what they are worth: 1 is 1.0."""
    if isinstance(value, np.ndarray):
        array = np.ascontiguousarray(value, dtype=np.float64)
        return f"#{array.shape} {_hash(array.tobytes())}"
    if isinstance(value, (bool, np.bool_)) or value is None:
        return repr(value if value is None else bool(value))
    if isinstance(value, (int, float, np.integer, np.floating)):
        return repr(float(value))
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        parts = {item.name: getattr(value, item.name) for item in dataclasses.fields(value)}
        return f"{type(value).__name__}{canonical(parts)}"
    if isinstance(value, Mapping):
        inner = ", ".join(f"{name}={canonical(value[name])}" for name in sorted(value))
        return f"({inner})"
    if isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
        return f"[{', '.join(map(canonical, value))}]"
    code = getattr(value, "__code__", None)
    if code is not None:  # of a function, whose repr has an address
        plain = [one for one in code.co_consts if isinstance(one, (int, float, str))]
        return (
            f"{value.__qualname__} #{_hash(code.co_code + repr((code.co_names, plain)).encode())}"
        )
    return repr(value)


def _shortened(text: str) -> str:
    return text if len(text) <= _SHORT else f"#{_hash(text.encode())}"


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]

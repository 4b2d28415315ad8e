# SPDX-License-Identifier: GPL-3.0-or-later
"""Identity of a run: canonical text of each argument that affects the results."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np

from .dependencies import IDENTITY_ATTRIBUTE, UnidentifiedError, text_of_object

Identity = dict[str, str]
"""Canonical text of each argument of a run by name; a long text is replaced by its digest."""
_MAX_SHOWN_CHARACTERS = 60
_MAX_EXACT_INTEGER = 1 << 53
"""Magnitude up to which every integer is represented exactly by float64."""
_UNIDENTIFIED_PREFIX = "unidentified: "


def identity(**parts: Any) -> Identity:
    """Return the canonical text of each argument, e.g. of a number, array, function or list.

    For an argument that cannot be identified, the text states the reason, and `require_identified`
    raises an error with this reason.
    """
    return {name: _identified(part) for name, part in parts.items()}


def _identified(part: Any) -> str:
    try:
        return _shortened(canonical(part))
    except UnidentifiedError as error:
        return f"{_UNIDENTIFIED_PREFIX}{error}"


def require_identified(run_identity: Identity) -> None:
    """Raise UnidentifiedError if an argument of a run cannot be identified."""
    for name, text in run_identity.items():
        if text.startswith(_UNIDENTIFIED_PREFIX):
            raise UnidentifiedError(
                f"{name} cannot be identified, so checkpoints of different runs cannot be "
                f"distinguished: {text.removeprefix(_UNIDENTIFIED_PREFIX)}. Set the attribute "
                f"`{IDENTITY_ATTRIBUTE}` of {name} to everything on which {name} depends, e.g. "
                "law.identity = ('my law', 2e-4), or run without a checkpoint"
            )


def digest(run_identity: Identity) -> str:
    """Return a digest of the texts of all arguments in an identity."""
    return _hash(repr(sorted(run_identity.items())).encode())


def differences(now: Identity, before: Identity) -> str:
    """Describe the differences between two identities, e.g. "load 2.0 instead of 1.0"."""

    def change_of(name: str) -> str:
        new, old = (str(run_identity.get(name, "nothing")) for run_identity in (now, before))
        digests = new.count("#") + old.count("#")
        return f"different {name}" if digests else f"{name} {new} instead of {old}"

    return ", ".join(change_of(n) for n in {**now, **before} if now.get(n) != before.get(n))


def canonical(value: Any) -> str:
    """Return the canonical text of a value, which is the same in every process.

    Equal numbers such as 1 and 1.0 have the same text. Raises UnidentifiedError for a function or
    object with unknown dependencies.
    """
    try:
        return _IdentityTexts().text(value)
    except RecursionError:
        raise UnidentifiedError("the value is nested too deeply, or contains itself") from None


class _IdentityTexts:
    """Canonical texts of nested values, including objects that refer to themselves."""

    def __init__(self) -> None:
        self._open: dict[int, int] = {}
        """Nesting depth of the objects whose text is not finished yet, by id of the object."""
        self._done: dict[int, tuple[str, Any]] = {}
        """Finished text and object, by id of the object. Storing the object keeps its id in use."""

    def text(self, value: Any) -> str:
        plain = _plain(value)
        if plain is not None:
            return plain
        key = id(value)
        if key in self._open:
            return f"^{len(self._open) - self._open[key]}"
        if key not in self._done:
            self._open[key] = len(self._open)
            self._done[key] = self._nested(value), value
            del self._open[key]
        return self._done[key][0]

    def _nested(self, value: Any) -> str:
        kind = type(value)
        own = kind.__module__.partition(".")[0] == "samcontact"
        if isinstance(value, np.ndarray) and not isinstance(value, np.ma.MaskedArray):
            return _array(value) or f"#{value.shape} {self.text(value.ravel().tolist())}"
        if own and dataclasses.is_dataclass(value) and not isinstance(value, type):
            parts = {item.name: getattr(value, item.name) for item in dataclasses.fields(value)}
            return f"{kind.__name__}{self.text(parts)}"
        if isinstance(value, Mapping) and (own or kind in (dict, MappingProxyType)):
            inner = sorted(f"{self._key(name)}={self.text(part)}" for name, part in value.items())
            return f"({', '.join(inner)})"
        if isinstance(value, Sequence) and (own or kind in (list, tuple)):
            return f"[{', '.join(map(self.text, value))}]"
        if kind in (set, frozenset):
            return f"{{{', '.join(sorted(map(self.text, value)))}}}"
        return text_of_object(value, lambda part: _shortened(self.text(part)))

    def _key(self, name: Any) -> str:
        return name if type(name) is str else self.text(name)


def _plain(value: Any) -> str | None:
    """Return the text of a value without parts (number, text, ...), or None for other values."""
    if type(value) in (bool, np.bool_) or value is None:
        return repr(value if value is None else bool(value))
    if type(value) in (int, float) or isinstance(value, (np.integer, np.floating)):
        if isinstance(value, int) and abs(value) > _MAX_EXACT_INTEGER:
            return repr(value)
        return repr(float(value))
    if type(value) in (str, bytes, complex, range, slice, type(...), type(NotImplemented)):
        return repr(value)
    return repr(value) if isinstance(value, (np.generic, np.dtype)) else None


def _array(value: np.ndarray[Any, Any]) -> str | None:
    """Return shape and digest of an array as text, or None for an array of objects."""
    if value.dtype.hasobject:
        return None
    array = np.ascontiguousarray(value)
    if array.dtype.kind in "iufb":
        numbers = array.astype(np.float64)
        if array.dtype.kind == "f" or np.array_equal(numbers.astype(array.dtype), array):
            return f"#{array.shape} {_hash(numbers.tobytes())}"
    return f"#{array.shape} {array.dtype.str} {_hash(array.tobytes())}"


def _shortened(text: str) -> str:
    return text if len(text) <= _MAX_SHOWN_CHARACTERS else f"#{_hash(text.encode())}"


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]

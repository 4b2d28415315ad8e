# SPDX-License-Identifier: GPL-3.0-or-later
"""Read-only arrays, dictionaries and attributes: results and their input cannot be changed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, TypeVar

from .checks import FloatArray

Value = TypeVar("Value")


def read_only(array: FloatArray) -> FloatArray:
    """Make an array read-only, without a copy, and return it; for arrays not used elsewhere."""
    array.flags.writeable = False
    return array


class FrozenDict(Mapping[str, Value]):
    """Read-only dictionary that can be compared, hashed and pickled."""

    __slots__ = ("_items",)
    _items: dict[str, Value]

    def __init__(self, items: Mapping[str, Value]) -> None:
        object.__setattr__(self, "_items", dict(items))

    def __getitem__(self, name: str) -> Value:
        return self._items[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __hash__(self) -> int:
        return hash(frozenset(self._items.items()))

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name} is read-only: create a new object with the changed value")

    def __reduce__(self) -> tuple[Any, ...]:
        return FrozenDict, (self._items,)

    def __repr__(self) -> str:
        return repr(self._items)


class FixedAttributes:
    """Base class: public attributes are read-only once the attribute named by `_last` is set."""

    _last: ClassVar[str] = "_core"

    def __setattr__(self, name: str, value: Any) -> None:
        if self._last in self.__dict__ and not name.startswith("_"):
            known = getattr(type(self), name, None)
            if not (isinstance(known, property) and known.fset is not None):
                self._refuse(name)
        object.__setattr__(self, name, value)

    def __delattr__(self, name: str) -> None:
        self._refuse(name)

    def _refuse(self, name: str) -> None:
        if self._last in self.__dict__:
            kind = type(self).__name__
            raise AttributeError(f"{kind}.{name} is read-only: create a new {kind}")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of nested dictionaries of numbers, texts and arrays to HDF5 groups and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import h5py
import numpy as np

from .._util.checks import FloatArray

Tree = dict[str, Any]
_ARRAY_TYPES = (np.dtype(np.float64), np.dtype(np.int64), np.dtype(np.uint32))
"""Options of datasets for arrays."""


def write_tree(group: h5py.Group, tree: Mapping[str, Any]) -> None:
    """Write a tree to a group; numbers, texts and lists become attributes, None is omitted."""
    for name, value in tree.items():
        if isinstance(value, Mapping):
            same = [n for n, other in tree.items() if n in group and _equal(other, value)]
            if same:  # two identical bodies: one group under both names
                group[name] = group[same[0]]
            else:
                write_tree(group.create_group(name), value)
        elif isinstance(value, np.ndarray):
            _dataset(group, name, value)
        elif value is not None:
            group.attrs[name] = value


def _equal(first: Any, second: Mapping[str, Any]) -> bool:
    return (
        isinstance(first, Mapping)
        and bool(second)
        and first.keys() == second.keys()
        and all(np.array_equal(first[name], value) for name, value in second.items())
    )


def _dataset(group: h5py.Group, name: str, values: FloatArray) -> None:
    # fletcher32: a damaged block is refused on reading
    group.create_dataset(name, data=values, fletcher32=True, chunks=True)


def read_tree(group: h5py.Group) -> Tree:
    """Read a tree written by `write_tree`; raises ValueError for other content."""
    tree: Tree = {name: _plain(name, value) for name, value in group.attrs.items()}
    for name, part in group.items():
        tree[name] = _array(name, part) if isinstance(part, h5py.Dataset) else read_tree(part)
    return tree


def _plain(name: str, value: Any) -> Any:
    """Return an attribute as a number, text or list of numbers."""
    if isinstance(value, np.ndarray) and value.dtype.kind in "iuf":
        return value.tolist()
    if isinstance(value, (np.bool_, np.integer, np.floating)):
        return value.item()
    if isinstance(value, str):
        return value
    raise ValueError(f"{name} is neither a number nor a text")


def _array(name: str, values: h5py.Dataset) -> Any:
    if values.dtype not in _ARRAY_TYPES:
        raise ValueError(f"{name} must be of type float64, got {values.dtype}")
    return np.ascontiguousarray(values[...])


def array(
    tree: Tree, name: str, shape: tuple[int | None, ...], *, may_end: bool = False
) -> FloatArray:
    """Return an array of finite float64; ValueError for another array, KeyError if missing.

    shape: expected shape; None for any extent. may_end: whether +inf is allowed, as in a gap
    outside a body.
    """
    values: FloatArray = tree[name]
    if not isinstance(values, np.ndarray) or values.dtype != np.float64:
        raise ValueError(f"{name} is not an array of float64")
    fits = len(values.shape) == len(shape) and all(
        extent in (None, found) for extent, found in zip(shape, values.shape, strict=True)
    )
    if not fits:
        raise ValueError(f"{name} must have shape {shape}, got {values.shape}")
    finite = np.isfinite(values)
    if not finite.all() and not (may_end and np.all(finite | (values == np.inf))):
        raise ValueError(f"{name} must have finite values")
    return values

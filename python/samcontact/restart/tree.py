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
"""Data types that arrays in a file may have."""


def write_tree(group: h5py.Group, tree: Mapping[str, Any]) -> None:
    """Write a nested dictionary to a group.

    Arrays become datasets; numbers, texts and lists become attributes. Entries whose value is None
    are not written.
    """
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
    """Read the nested dictionary that `write_tree` has written to a group.

    Raises ValueError for invalid content.
    """
    tree: Tree = {name: _plain(name, value) for name, value in group.attrs.items()}
    for name, part in group.items():
        tree[name] = _array(name, part) if isinstance(part, h5py.Dataset) else read_tree(part)
    return tree


def _plain(name: str, value: Any) -> Any:
    """Convert an HDF5 attribute to a number, text or list of numbers."""
    if isinstance(value, np.ndarray) and value.dtype.kind in "iuf":
        return value.tolist()
    if isinstance(value, (np.bool_, np.integer, np.floating)):
        return value.item()
    if isinstance(value, str):
        return value
    raise ValueError(f"{name} must be a number or a text")


def _array(name: str, values: h5py.Dataset) -> Any:
    if values.dtype not in _ARRAY_TYPES:
        raise ValueError(f"{name} must be of type float64, got {values.dtype}")
    return np.ascontiguousarray(values[...])


def array(
    tree: Tree, name: str, shape: tuple[int | None, ...], *, may_end: bool = False
) -> FloatArray:
    """Return an array of finite float64 values from a dictionary.

    shape: expected shape; None for any extent. may_end: whether +inf is allowed, e.g. for the gap
    outside a body. Raises KeyError if there is no array of this name, and ValueError if the array
    is invalid.
    """
    values: FloatArray = tree[name]
    if not isinstance(values, np.ndarray) or values.dtype != np.float64:
        raise ValueError(f"{name} must be an array of type float64")
    fits = len(values.shape) == len(shape) and all(
        extent in (None, found) for extent, found in zip(shape, values.shape, strict=True)
    )
    if not fits:
        raise ValueError(f"{name} must have shape {shape}, got {values.shape}")
    finite = np.isfinite(values)
    if not finite.all() and not (may_end and np.all(finite | (values == np.inf))):
        raise ValueError(f"{name} must contain finite values only")
    return values

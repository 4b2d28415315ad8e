# SPDX-License-Identifier: GPL-3.0-or-later
"""Damage to files: flipped or lost bytes, and exchanged parts of HDF5 files."""

import h5py
import numpy as np
from hypothesis import strategies as st

from samcontact.files.checksum import seal


@st.composite
def damage(draw):
    """Draw a function that damages the bytes of a file at a fraction of its length."""
    kind = draw(st.sampled_from(["flip", "flip", "flip", "cut", "zero", "drop", "swap", "append"]))
    place = draw(st.floats(0, 1, exclude_max=True))
    bit, length = draw(st.integers(0, 7)), draw(st.sampled_from([1, 4, 64, 512, 4096]))

    def damaged(content):
        at = int(place * len(content))
        if kind == "flip":
            return content[:at] + bytes([content[at] ^ (1 << bit)]) + content[at + 1 :]
        if kind == "cut":
            return content[:at]
        if kind == "append":
            return content + bytes(length)
        end = min(at + length, len(content))
        if kind == "zero":
            return content[:at] + bytes(end - at) + content[end:]
        if kind == "drop":
            return content[:at] + content[end:]
        return content[:at] + content[at:end][::-1] + content[end:]

    return damaged


wild_values = st.one_of(
    st.integers(-(2**63), 2**63 - 1),
    st.integers(-3, 3),
    st.floats(),
    st.sampled_from([np.nan, np.inf, -np.inf, 1e308, -1.0, 0.0, 5e-324]),
    st.text(alphabet="swift elastic\u00e9", max_size=8),
    st.binary(min_size=1, max_size=5).map(np.void),
    st.booleans(),
    st.lists(st.floats(), max_size=6).map(np.array),
    st.integers(0, 3).map(lambda n: np.zeros((n, 2, 2))),
    st.sampled_from([h5py.Empty("f"), np.array(["a", "b"], dtype="S1"), np.zeros(5, np.int32)]),
)


@st.composite
def edit(draw):
    """Draw a function that changes one part of an open HDF5 file, chosen by a number."""
    what = draw(st.sampled_from(["attribute", "attribute", "array", "array", "array", "remove"]))
    number, value = draw(st.integers(0, 10_000)), draw(wild_values)
    how = draw(st.sampled_from(["value", "slice", "type", "transpose", "replace", "grow"]))

    def edited(file):
        parts = [file]
        file.visititems(lambda _, part: parts.append(part))
        owners = [part for part in parts if len(part.attrs)]
        arrays = [part for part in parts if isinstance(part, h5py.Dataset)]
        if what == "attribute":
            owner = owners[number % len(owners)]
            name = sorted(owner.attrs)[number // 7 % len(owner.attrs)]
            if number % 5 == 0:
                del owner.attrs[name]
            else:
                owner.attrs[name] = value
        elif what == "array":
            change_array(arrays[number % len(arrays)], how, number, value)
        else:
            part = parts[1:][number % (len(parts) - 1)]
            del file[part.name]

    return edited


@st.composite
def change_boxes(draw, name):
    """Draw a function that changes boxes, [box][i0, j0, nx, ny, nz, k0], of an open HDF5 file."""
    how = draw(st.sampled_from(["shift", "shift", "value", "repeat", "remove", "turn", "split"]))
    box, part = draw(st.integers(0, 100)), draw(st.integers(0, 5))
    far = st.sampled_from([-(2**31), 2**31 - 1, 2**32, -(2**63), 2**63 - 1, 10**6, -(10**6)])
    number = draw(st.one_of(st.integers(-40, 40), st.integers(-3, 3), far))

    def changed(file):
        boxes = file[name][...]
        at = box % len(boxes)
        if how == "shift":
            boxes[at] += np.where(np.arange(6) == part, number, 0)  # may overflow
        elif how == "value":
            boxes[at, part] = number
        elif how == "repeat":
            boxes = np.insert(boxes, 0, boxes[at], axis=0)
        elif how == "remove":
            boxes = np.delete(boxes, at, axis=0)
        elif how == "turn":
            boxes = np.roll(boxes, number % 7, axis=part % 2)
        else:
            half = boxes[at].copy()
            half[2] //= 2
            boxes[at, [0, 2]] += [half[2], -half[2]]
            boxes = np.insert(boxes, at, half, axis=0)
        del file[name]
        file[name] = boxes

    return changed


def change_array(array, how, number, value):
    values, owner, name = array[()], array.parent, array.name
    if how == "value":
        if not values.size or values.dtype.kind not in "fiu":
            return
        scalar = np.nan if not isinstance(value, float) else value
        try:
            np.ravel(values)[number % values.size] = scalar
        except (ValueError, OverflowError):  # an array of integers
            np.ravel(values)[number % values.size] = 7
        array[...] = values
        return
    other = {
        "slice": lambda: values[..., 1:] if values.ndim else values,
        "type": lambda: values.astype(np.float32) if values.dtype.kind in "fiu" else values,
        "transpose": lambda: values.T,
        "replace": lambda: value,
        "grow": lambda: np.concatenate([values, values]) if values.ndim else values,
    }[how]()
    attributes = dict(array.attrs)
    del owner[name]
    try:
        owner[name] = other
    except TypeError:  # h5py has no such type
        return
    for key, kept in attributes.items():
        if key not in ("DIMENSION_LIST", "REFERENCE_LIST"):
            owner[name].attrs[key] = kept


def write_edited(source, target, change, sealed=True):
    """Write a changed copy with a matching digest, so that only its content is wrong."""
    target.write_bytes(source)
    with h5py.File(target, "a") as file:
        change(file)
    if sealed:
        seal(target)

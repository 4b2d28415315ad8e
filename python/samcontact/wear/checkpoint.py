# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a wear computation stands between two cycles, in memory and in a file (HDF5)."""

from __future__ import annotations

import dataclasses
import hashlib
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from .._atomic import replacing
from .._checks import FloatArray
from .checks import Scene
from .results import Cycle

_FORMAT = "samcontact wear 1"


@dataclass
class Strain:
    """Plastic state of a body; its first row lies over the row `first` of the grid."""

    first: int
    strain: FloatArray
    equivalent: FloatArray
    backstress: FloatArray | None = None


@dataclass
class Standing:
    """All that the next cycle starts from, and the records of those before."""

    heights: dict[int, list[FloatArray]]
    """Of each worn body, at the start and after each cycle."""
    strains: dict[int, Strain] = field(default_factory=dict)
    cycles: list[Cycle] = field(default_factory=list)


def fingerprint(scene: Scene) -> str:
    """Digest of all arguments that results depend on."""
    digest = hashlib.sha256()
    _feed(digest, scene)
    return digest.hexdigest()


def _feed(digest: Any, value: Any) -> None:
    digest.update(f"<{type(value).__name__}>".encode())
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        for item in dataclasses.fields(value):
            _feed(digest, getattr(value, item.name))
    elif isinstance(value, Mapping):
        for name in sorted(value):
            digest.update(str(name).encode())
            _feed(digest, value[name])
    elif isinstance(value, (list, tuple)):
        digest.update(str(len(value)).encode())
        for item in value:
            _feed(digest, item)
    elif isinstance(value, np.ndarray):
        digest.update(str(value.shape).encode())
        digest.update(np.ascontiguousarray(value, dtype=np.float64).tobytes())
    else:
        digest.update(repr(value).encode())


def write(path: str | os.PathLike[str], scene: Scene, standing: Standing) -> None:
    """A failure leaves the old file."""
    with replacing(path) as part, h5py.File(part, "w") as file:
        _write(file, scene, standing)


def _write(file: h5py.File, scene: Scene, standing: Standing) -> None:
    file.attrs.update(format=_FORMAT, arguments=fingerprint(scene))
    for body, heights in standing.heights.items():
        _dataset(file, f"heights{body}", np.stack(heights))
    for body, state in standing.strains.items():
        group = file.create_group(f"strain{body}")
        group.attrs["first"] = state.first
        for name in ("strain", "equivalent", "backstress"):
            if getattr(state, name) is not None:
                _dataset(group, name, getattr(state, name))
    if standing.cycles:
        records = file.create_group("cycles")
        for item in dataclasses.fields(Cycle):
            records[item.name] = np.array([getattr(c, item.name) for c in standing.cycles])


def _dataset(group: h5py.Group, name: str, values: FloatArray) -> None:
    # fletcher32: a damaged block is refused when it is read instead of being computed with.
    group.create_dataset(name, data=values, fletcher32=True, chunks=True)


def read(path: str | os.PathLike[str], scene: Scene) -> Standing | None:
    """Where the file stands; None without a file.

    Raises ValueError for a file of other arguments, of another kind, or a damaged one.
    """
    if not Path(path).exists():
        return None
    name = os.fspath(path)
    try:
        with h5py.File(path, "r") as file:
            if file.attrs.get("format") != _FORMAT:
                raise ValueError(f"checkpoint {name!r} is no checkpoint of wear")
            if file.attrs["arguments"] != fingerprint(scene):
                raise ValueError(
                    f"checkpoint {name!r} was written with other arguments: give those again, or "
                    "another file"
                )
            return _read(file, scene)
    except (OSError, KeyError) as error:
        raise ValueError(f"checkpoint {name!r} is damaged: {error}") from error


def _read(file: h5py.File, scene: Scene) -> Standing:
    standing = Standing({body: list(file[f"heights{body}"][...]) for body in scene.worn})
    for body in (1, 2):
        if f"strain{body}" in file:
            group = file[f"strain{body}"]
            names = ("strain", "equivalent", "backstress")
            fields = {name: group[name][...] for name in names if name in group}
            standing.strains[body] = Strain(int(group.attrs["first"]), **fields)
    if "cycles" in file:
        records = {item.name: file["cycles"][item.name][...] for item in dataclasses.fields(Cycle)}
        for n in range(len(records["number"])):
            standing.cycles.append(Cycle(**{k: _plain(v[n]) for k, v in records.items()}))
    return standing


def _plain(value: Any) -> Any:
    return tuple(value.tolist()) if isinstance(value, np.ndarray) else value.item()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a wear computation stands between two cycles, in memory and in a file (HDF5)."""

from __future__ import annotations

import dataclasses
import hashlib
import os
import shutil
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from .._atomic import replacing, replacing_hdf5
from .._checks import FloatArray
from .._seal import check_seal
from ..checkpoint import (
    DAMAGED,
    CheckpointError,
    DamagedCheckpointError,
    ForeignCheckpointError,
)
from ..checkpoint import finite_dataset as _array
from .checks import Scene, met_rows
from .results import PER_BODY, Cycle

_FORMAT = "samcontact wear 3"


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


def _before(path: str | os.PathLike[str]) -> Path:
    """The checkpoint of the cycle before."""
    return Path(f"{os.fspath(path)}.before")


def write(path: str | os.PathLike[str], scene: Scene, standing: Standing) -> None:
    """A failure leaves the old file; a copy of it stays in any case."""
    if _is_whole(path):
        with replacing(_before(path)) as part:
            shutil.copyfile(path, part)
    with replacing_hdf5(path) as opened, h5py.File(opened, "w") as file:
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


def _is_whole(path: str | os.PathLike[str]) -> bool:
    try:
        return Path(path).exists() and check_seal(path)
    except ValueError:
        return False


def latest(path: str | os.PathLike[str], scene: Scene) -> Standing | None:
    """As `read`; of a damaged file that of the cycle before, with a warning, where there is one."""
    try:
        return read(path, scene)
    except DamagedCheckpointError as error:
        if not _before(path).exists():
            raise DamagedCheckpointError(f"{error}: delete it to start anew") from error
        warnings.warn(f"{error}: going on from the cycle before", stacklevel=3)
        return read(_before(path), scene)


def read(path: str | os.PathLike[str], scene: Scene) -> Standing | None:
    """Where the file stands; None without a file.

    Raises CheckpointError for a file of other arguments, of another kind, or a damaged one.
    """
    if not Path(path).exists():
        return None
    name = os.fspath(path)
    try:
        sealed = check_seal(path)
        with h5py.File(path, "r") as file:
            form = file.attrs.get("format")
            if not isinstance(form, str) or form != _FORMAT:
                raise CheckpointError(f"checkpoint {name!r} is no checkpoint of wear")
            if not sealed:
                raise ValueError("the digest at its end is missing: it was cut off or changed")
            if file.attrs["arguments"] != fingerprint(scene):
                raise ForeignCheckpointError(
                    f"checkpoint {name!r} was written with other arguments: give those again, or "
                    "another file"
                )
            return _read(file, scene)
    except CheckpointError:
        raise
    except DAMAGED as error:
        raise DamagedCheckpointError(f"checkpoint {name!r} is damaged: {error}") from error


def _read(file: h5py.File, scene: Scene) -> Standing:
    cycles = _read_cycles(file["cycles"], len(scene.worn)) if "cycles" in file else []
    standing = Standing({}, {}, cycles)
    for body in scene.worn:
        _, rows = met_rows(scene, body)
        shape = (len(cycles) + 1, rows, scene.grid.ny)
        standing.heights[body] = list(_array(file, f"heights{body}", shape))
    for body in (1, 2):
        if f"strain{body}" in file:
            group = file[f"strain{body}"]
            equivalent = _array(group, "equivalent")
            if equivalent.ndim != 3 or equivalent.shape[1:] != scene.grid.volume_shape[1:]:
                raise ValueError(f"equivalent has shape {equivalent.shape}")
            strain, back = _array(group, "strain", (6, *equivalent.shape)), None
            if "backstress" in group:
                terms = len(scene.bodies[body - 1].kinematic)
                back = _array(group, "backstress", (terms, *strain.shape))
            first = int(group.attrs["first"])
            standing.strains[body] = Strain(first, strain, equivalent, back)
    return standing


def _read_cycles(group: h5py.Group, worn: int) -> list[Cycle]:
    records = {item.name: group[item.name][...] for item in dataclasses.fields(Cycle)}
    count = len(records["number"])
    for name, values in records.items():
        shape: tuple[int, ...] = (count, worn) if name in PER_BODY else (count,)
        if values.dtype.kind not in "if" or values.shape != shape or not np.isfinite(values).all():
            raise ValueError(f"{name} of the cycles is not {shape} finite numbers")
    if list(records["number"]) != list(range(1, count + 1)):
        raise ValueError("the cycles are not numbered one after the other")
    return [Cycle(**{k: _plain(v[n]) for k, v in records.items()}) for n in range(count)]


def _plain(value: Any) -> Any:
    return tuple(value.tolist()) if isinstance(value, np.ndarray) else value.item()

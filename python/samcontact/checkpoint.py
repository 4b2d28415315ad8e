# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints of a simulation: one HDF5 file with scene, state and counters."""

from __future__ import annotations

import io
import math
import os
from collections.abc import Callable, Sequence
from dataclasses import asdict, astuple, dataclass, fields, replace
from typing import Any

import h5py
import numpy as np

from . import _core
from ._atomic import replacing_hdf5
from ._checks import FloatArray, file_path
from ._heating import heating
from ._seal import check_seal
from ._settings import Settings
from .grid import Grid
from .heat import Heat
from .material import Material
from .relief import Relief
from .softening import JohnsonCook

Softening = tuple[Callable[[FloatArray], Any] | None, Callable[[FloatArray], Any] | None]
_FORMAT = "samcontact checkpoint"
_FORMAT_VERSION = 6
_SURFACE = ("pressure", "shear_x", "shear_y", "contact_gap")
_REQUIRED = ("pressure",)
_FARTHEST = 1 << 30  # cells from the start of a body's way
_SCALARS = (
    "load",
    "approach",
    "iterations",
    "contact_iterations",
    "substeps",
    "plastic_residual",
    "yield_excess",
    "exact_residual_stress",
    "time",
    "duration",
)


DAMAGED = (
    OSError, KeyError, ValueError, TypeError, AttributeError, IndexError, OverflowError,
    RuntimeError, MemoryError,
)  # fmt: skip
"""What h5py, NumPy and the core raise for a file of which a part is not what it should be."""


class CheckpointError(ValueError):
    """The file is no checkpoint of this package, or it is damaged."""


class DamagedCheckpointError(CheckpointError):
    """It is one, or was, but cannot be used: an earlier one may serve."""


class ForeignCheckpointError(CheckpointError):
    """It belongs to another run."""


@dataclass(frozen=True)
class Snapshot:
    """What a checkpoint holds of a simulation."""

    arguments: dict[str, Any]
    """Of Simulation(...)."""
    state: _core.State
    counters: dict[str, int]


def write_checkpoint(path: str | os.PathLike[str], snapshot: Snapshot) -> None:
    """A failure leaves the old file."""
    file_path("path", path)
    with replacing_hdf5(path) as opened, h5py.File(opened, "w") as file:
        _write(file, snapshot)


def to_bytes(snapshot: Snapshot) -> bytes:
    """The content of such a file."""
    content = io.BytesIO()
    with h5py.File(content, "w") as file:
        _write(file, snapshot)
    return content.getvalue()


def _write(file: h5py.File, snapshot: Snapshot) -> None:
    file.attrs.update(
        format=_FORMAT, format_version=_FORMAT_VERSION, samcontact_version=_core.version
    )
    _write_scene(file, snapshot.arguments)
    _write_state(file.create_group("state"), snapshot.state)
    file.create_group("counters").attrs.update(snapshot.counters)


def _write_scene(file: h5py.File, arguments: dict[str, Any]) -> None:
    tables = {
        "grid": arguments["grid"].__getstate__(),
        "settings": {item.name: arguments[item.name] for item in fields(Settings)},
        "heat": asdict(arguments["heat"]),
    }
    for name, values in tables.items():
        file.create_group(name).attrs.update({k: v for k, v in values.items() if v is not None})
    for name in ("body1", "body2"):
        body = arguments[name]
        file.create_group(name).attrs.update(law=body.law, **body.parameters)
        if body.thermal is not None:
            file[name].attrs["thermal"] = np.array(body.thermal)
        if isinstance(body.softening, JohnsonCook):
            file[name].attrs["johnson_cook"] = np.array(astuple(body.softening))
        elif body.softening is not None:
            file[name].attrs["softening"] = repr(body.softening)
        if body.kinematic:
            file[name].attrs["kinematic"] = np.array(body.kinematic)
    file["initial_gap"] = arguments["gap"]
    for name in ("relief1", "relief2"):
        relief = arguments[name]
        if relief is not None:
            _dataset(file, name, relief.heights)
            file[name].attrs.update(first=relief.first, periodic=relief.periodic)


def _write_state(state: h5py.Group, core: _core.State) -> None:
    state.attrs.update({name: getattr(core, name) for name in _SCALARS})
    for name in _SURFACE:
        if getattr(core, name) is not None:
            _dataset(state, name, getattr(core, name))
    state.attrs["heat_factor"] = [entry.factor for entry in core.heating]
    state.attrs.update(past_symmetry=core.past_symmetry, travel=core.travel)
    for body in (0, 1):
        past = core.past(body)
        if past is not None:
            _dataset(state, f"past{body + 1}", past)
        factor = core.softening(body)
        if factor is not None:
            _dataset(state, f"softening{body + 1}", np.moveaxis(factor, 2, 0))
    histories = [core.history(body) for body in (0, 1)]
    for body, history in enumerate(histories):
        if body == 1 and _equal(histories[0], history):
            # Two identical bodies: one group under both names.
            state["history2"] = state["history1"]
        elif history is not None:
            kept = state.create_group(f"history{body + 1}")
            for attribute in ("box", "flow_box", "mirrored"):
                kept.attrs[attribute] = history[attribute]
            _dataset(kept, "strain", history["strain"])
            _dataset(kept, "equivalent", history["equivalent"])
            if history["backstress"].size:
                _dataset(kept, "backstress", history["backstress"])
    flow = core.last_flow()
    if flow is not None:
        kept = state.create_group("last_flow")
        for name, value in flow.items():
            if name in ("mirrored", "advance"):
                kept.attrs[name] = value
            elif len(value):
                _dataset(kept, name, value)


def _equal(first: dict[str, Any] | None, second: dict[str, Any] | None) -> bool:
    if first is None or second is None:
        return False
    return all(np.array_equal(first[name], second[name]) for name in first)


def _dataset(group: h5py.Group, name: str, values: Any) -> None:
    # fletcher32: a damaged block is refused when it is read instead of being computed with.
    group.create_dataset(name, data=values, fletcher32=True, chunks=True)


def read_checkpoint(
    path: str | os.PathLike[str], softening: Sequence[Any]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the arguments of Simulation(...) and the entries for the core's restore()."""
    try:
        law1, law2 = softening
    except (TypeError, ValueError) as error:
        raise TypeError(
            f"softening must be a pair, (law of body 1, law of body 2), got {softening!r}"
        ) from error
    if not file_path("path", path).is_file():
        raise FileNotFoundError(f"no checkpoint at {os.fspath(path)!r}")
    try:
        sealed = check_seal(path)
        with h5py.File(path, "r") as file:
            if _text(file.attrs.get("format")) != _FORMAT:
                raise CheckpointError(f"{os.fspath(path)!r} is not a samcontact checkpoint")
            version = int(file.attrs["format_version"])
            if version != _FORMAT_VERSION:
                raise CheckpointError(
                    f"{os.fspath(path)!r} has checkpoint format {version}; "
                    f"this version reads format {_FORMAT_VERSION}"
                )
            if not sealed:
                raise ValueError("the digest at its end is missing: it was cut off or changed")
            return _read(file, (law1, law2))
    except CheckpointError:
        raise
    except DAMAGED as error:
        raise damaged(path, error) from error


def from_bytes(content: bytes, softening: Softening) -> tuple[dict[str, Any], dict[str, Any]]:
    """The same as `read_checkpoint` from what `to_bytes` has made."""
    with h5py.File(io.BytesIO(content), "r") as file:
        return _read(file, softening)


def _read(file: h5py.File, softening: Softening) -> tuple[dict[str, Any], dict[str, Any]]:
    scene, state = _read_scene(file, softening), _read_state(file)
    heat = replace(scene["heat"], factor=_numbers(file["state"], "heat_factor", 2))
    state["heating"] = heating(heat, (scene["body1"], scene["body2"]), scene["grid"])
    return scene, state


def damaged(path: str | os.PathLike[str], error: BaseException) -> DamagedCheckpointError:
    """The error of a file whose content cannot be used."""
    return DamagedCheckpointError(f"{os.fspath(path)!r} is damaged: {error}")


def _text(value: Any) -> Any:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else value


def finite_dataset(
    group: h5py.Group, name: str, shape: tuple[int, ...] | None = None
) -> FloatArray:
    """A dataset of finite float64, of this shape where it is told."""
    if not isinstance(group[name], h5py.Dataset):
        raise ValueError(f"{name} is not an array")
    values = np.ascontiguousarray(group[name][...])
    if values.dtype != np.float64:
        raise ValueError(f"{name} has type {values.dtype}, not float64")
    if shape is not None and values.shape != shape:
        raise ValueError(f"{name} has shape {values.shape}, not {shape}")
    if not np.isfinite(values).all():
        raise ValueError(f"{name} has values that are not finite")
    return values


def _numbers(group: h5py.Group, name: str, count: int | None = None) -> list[float]:
    """An attribute of finite numbers."""
    values = np.asarray(group.attrs[name])
    if values.dtype.kind not in "iuf" or values.ndim != 1:
        raise ValueError(f"{name} is not a list of numbers")
    if count is not None and values.size != count:
        raise ValueError(f"{name} has {values.size} values, not {count}")
    if not np.isfinite(values).all():
        raise ValueError(f"{name} has values that are not finite")
    return [float(value) for value in values]


def _whole_numbers(group: h5py.Group, name: str, count: int) -> list[int]:
    numbers = _numbers(group, name, count)
    if any(number != round(number) or abs(number) >= 2**31 for number in numbers):
        raise ValueError(f"{name} has values that are not whole numbers of 32 bits")
    return [int(number) for number in numbers]


def _mirrored(group: h5py.Group, name: str) -> int:
    value = int(group.attrs[name])
    if value not in (0, 1, 2):
        raise ValueError(f"{name} must be 0, 1 or 2, got {value}")
    return value


def _read_flow(group: h5py.Group) -> dict[str, Any]:
    flow: dict[str, Any] = {
        "mirrored": _mirrored(group, "mirrored"),
        "advance": _numbers(group, "advance", 2),
    }
    for body in (1, 2):
        cells, strain = f"cells{body}", f"strain{body}"
        flow[cells] = group[cells][...] if cells in group else np.zeros(0, np.uint32)
        if flow[cells].dtype != np.uint32 or flow[cells].ndim != 1:
            raise ValueError(f"{cells} is not a list of cells")
        flow[strain] = finite_dataset(group, strain) if strain in group else np.zeros(0)
    return flow


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value


def _read_scene(file: h5py.File, softening: Softening) -> dict[str, Any]:
    arguments: dict[str, Any] = {k: _plain(v) for k, v in file["settings"].attrs.items()}
    required = {item.name for item in fields(Settings) if item.default is not None}
    if not required <= set(arguments) <= {item.name for item in fields(Settings)}:
        raise ValueError(f"its settings are {', '.join(arguments) or 'missing'}")
    arguments["heat"] = Heat(**{k: _plain(v) for k, v in file["heat"].attrs.items()})
    arguments["grid"] = Grid(**{k: _plain(v) for k, v in file["grid"].attrs.items()})
    for name, law in zip(("body1", "body2"), softening, strict=True):
        parameters = {k: _plain(v) for k, v in file[name].attrs.items()}
        kinematic = tuple(map(tuple, parameters.pop("kinematic", ())))
        thermal = parameters.pop("thermal", None)
        softened = law
        if "johnson_cook" in parameters:
            softened = JohnsonCook(*map(float, parameters.pop("johnson_cook")))
        elif "softening" in parameters and law is None:
            raise CheckpointError(
                f"{name} softens by {parameters['softening']}, which a checkpoint cannot hold: "
                "give it again, softening=(law of body 1, law of body 2), None for a body without"
            )
        parameters.pop("softening", None)
        arguments[name] = Material(
            parameters.pop("law"),
            parameters,
            kinematic,
            None if thermal is None else tuple(thermal),
            softened,
        )
    arguments["gap"] = finite_dataset(file, "initial_gap", arguments["grid"].surface_shape)
    for name in ("relief1", "relief2"):
        if name in file:
            place = {k: _plain(v) for k, v in file[name].attrs.items()}
            arguments[name] = Relief(finite_dataset(file, name), place["first"], place["periodic"])
    return arguments


def _read_state(file: h5py.File) -> dict[str, Any]:
    group = file["state"]
    shape = file["initial_gap"].shape
    saved: dict[str, Any] = {name: _plain(group.attrs[name]) for name in _SCALARS}
    for name in _SCALARS:
        if not math.isfinite(saved[name]) and name != "approach":  # none with given tractions
            raise ValueError(f"{name} must be finite, got {saved[name]}")
    for name in _SURFACE:
        present = name in group or name in _REQUIRED
        saved[name] = finite_dataset(group, name, shape) if present else None
    saved["travel"] = _numbers(group, "travel", 2)
    if max(map(abs, saved["travel"])) >= _FARTHEST:
        raise ValueError("travel is out of range")
    saved["past_symmetry"] = _mirrored(group, "past_symmetry")
    for body in (1, 2):
        for name in (f"softening{body}", f"past{body}"):
            saved[name] = finite_dataset(group, name) if name in group else None
        name = f"history{body}"
        saved[name] = _read_history(group[name]) if name in group else None
    saved["last_flow"] = _read_flow(group["last_flow"]) if "last_flow" in group else None
    saved["counters"] = {k: _plain(v) for k, v in file["counters"].attrs.items()}
    return saved


def _read_history(kept: h5py.Group) -> dict[str, Any]:
    box, flow_box = (_whole_numbers(kept, name, 5) for name in ("box", "flow_box"))
    if abs(box[0]) >= _FARTHEST or min(box[2:] + flow_box[2:]) < 0:
        raise ValueError("a box of a plastic history is out of range")
    _, _, nx, ny, nz = box
    strain = finite_dataset(kept, "strain")
    backstress: FloatArray = np.zeros(0)
    if strain.ndim != 4 or strain.shape[1:] != (nz, nx, ny):
        raise ValueError(f"strain has shape {strain.shape}, its box {(nz, nx, ny)}")
    if "backstress" in kept:
        backstress = finite_dataset(kept, "backstress")
        if backstress.ndim != 5 or backstress.shape[1:] != (5, nz, nx, ny):
            raise ValueError(f"backstress has shape {backstress.shape}, its box {(nz, nx, ny)}")
    return {
        "box": box,
        "flow_box": flow_box,
        "mirrored": _mirrored(kept, "mirrored"),
        "strain": strain,
        "equivalent": finite_dataset(kept, "equivalent", (nz, nx, ny)),
        "backstress": backstress,
    }

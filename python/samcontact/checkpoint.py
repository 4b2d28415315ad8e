# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints of a simulation: one HDF5 file with scene, state and counters."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import astuple
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np

from . import _core
from ._atomic import replacing
from ._checks import FloatArray
from .grid import Grid
from .material import Material
from .relief import Relief
from .softening import JohnsonCook

if TYPE_CHECKING:
    from .simulation import Simulation
    from .state import State

Softening = tuple[Callable[[FloatArray], Any] | None, Callable[[FloatArray], Any] | None]
_FORMAT = "samcontact checkpoint"
_FORMAT_VERSION = 4
_SURFACE = ("pressure", "shear_x", "shear_y", "contact_gap")
_REQUIRED = ("pressure",)
_SCALARS = (
    "load",
    "approach",
    "iterations",
    "contact_iterations",
    "substeps",
    "plastic_residual",
    "yield_excess",
    "exact_residual_stress",
)


class CheckpointError(ValueError):
    """The file is no checkpoint of this package, or it is damaged."""


def write_checkpoint(
    path: str | os.PathLike[str], simulation: Simulation, state: State | None = None
) -> None:
    """A failure leaves the old file.

    state: an earlier one of the simulation, instead of the present one.
    """
    with replacing(path) as part, h5py.File(part, "w") as file:
        _write(file, simulation, state)


def _write(file: h5py.File, simulation: Simulation, earlier: State | None = None) -> None:
    file.attrs.update(
        format=_FORMAT, format_version=_FORMAT_VERSION, samcontact_version=_core.version
    )
    grid = simulation.grid
    file.create_group("grid").attrs.update(
        {k: v for k, v in grid.__getstate__().items() if v is not None}
    )
    for name in ("body1", "body2"):
        body = getattr(simulation, name)
        file.create_group(name).attrs.update(law=body.law, **body.parameters)
        if body.thermal is not None:
            file[name].attrs["thermal"] = np.array(body.thermal)
        if isinstance(body.softening, JohnsonCook):
            file[name].attrs["johnson_cook"] = np.array(astuple(body.softening))
        elif body.softening is not None:
            file[name].attrs["softening"] = repr(body.softening)
        if body.kinematic:
            file[name].attrs["kinematic"] = np.array(body.kinematic)
    file.create_group("settings").attrs.update(
        friction=simulation.friction,
        tol=simulation.tol,
        on_border=simulation.on_border,
        max_iterations=simulation.max_iterations,
        residual_stress=simulation.residual_stress,
        image_tol=simulation.image_tol,
        heat_factor=np.array(simulation.heat_factor),
        velocity=np.array(simulation.velocity),
        reach=simulation.reach,
    )
    for name in ("increment_tol", "heating_time", "heat_reference", "heat_history"):
        if getattr(simulation, name) is not None:
            file["settings"].attrs[name] = getattr(simulation, name)
    file["initial_gap"] = simulation.initial_gap
    for name in ("relief1", "relief2"):
        relief = getattr(simulation, name)
        if relief is not None:
            _dataset(file, name, relief.heights)
            file[name].attrs.update(first=relief.first, periodic=relief.periodic)
    core = simulation._core.state if earlier is None else earlier._core
    state = file.create_group("state")
    state.attrs.update({name: getattr(core, name) for name in _SCALARS})
    for name in _SURFACE:
        if getattr(core, name) is not None:
            _dataset(state, name, getattr(core, name))
    state.attrs["heating"] = np.array([entry.values() for entry in core.heating])
    state.attrs.update(time=core.time, past_symmetry=core.past_symmetry, travel=core.travel)
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
    file.create_group("counters").attrs.update(simulation.counters)


def _equal(first: dict[str, Any] | None, second: dict[str, Any] | None) -> bool:
    if first is None or second is None:
        return False
    return all(np.array_equal(first[name], second[name]) for name in first)


def _dataset(group: h5py.Group, name: str, values: Any) -> None:
    # fletcher32: a damaged block is refused when it is read instead of being computed with.
    group.create_dataset(name, data=values, fletcher32=True, chunks=True)


def read_checkpoint(
    path: str | os.PathLike[str], softening: Softening
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the arguments of Simulation(...) and the entries for the core's restore()."""
    if not Path(path).exists():
        raise FileNotFoundError(f"no checkpoint at {os.fspath(path)!r}")
    try:
        with h5py.File(path, "r") as file:
            if file.attrs.get("format") != _FORMAT:
                raise CheckpointError(f"{os.fspath(path)!r} is not a samcontact checkpoint")
            version = int(file.attrs["format_version"])
            if version != _FORMAT_VERSION:
                raise CheckpointError(
                    f"{os.fspath(path)!r} has checkpoint format {version}; "
                    f"this version reads format {_FORMAT_VERSION}"
                )
            return _read_scene(file, softening), _read_state(file)
    except CheckpointError:
        raise
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise CheckpointError(f"{os.fspath(path)!r} is damaged: {error}") from error


def _read_flow(group: h5py.Group) -> dict[str, Any]:
    flow: dict[str, Any] = {
        "mirrored": int(group.attrs["mirrored"]),
        "advance": [float(cells) for cells in group.attrs["advance"]],
    }
    for body in (1, 2):
        for name, kind in ((f"cells{body}", np.uint32), (f"strain{body}", np.float64)):
            flow[name] = group[name][...] if name in group else np.zeros(0, kind)
    return flow


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value


def _read_scene(file: h5py.File, softening: Softening) -> dict[str, Any]:
    arguments: dict[str, Any] = {k: _plain(v) for k, v in file["settings"].attrs.items()}
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
    arguments["gap"] = file["initial_gap"][...]
    for name in ("relief1", "relief2"):
        if name in file:
            place = {k: _plain(v) for k, v in file[name].attrs.items()}
            arguments[name] = Relief(file[name][...], place["first"], place["periodic"])
    return arguments


def _read_state(file: h5py.File) -> dict[str, Any]:
    group = file["state"]
    shape = file["initial_gap"].shape
    saved: dict[str, Any] = {name: _plain(group.attrs[name]) for name in _SCALARS}
    for name in _SURFACE:
        saved[name] = None
        if name in group or name in _REQUIRED:
            saved[name] = np.ascontiguousarray(group[name][...])
            if saved[name].shape != shape:
                raise ValueError(f"{name} has shape {saved[name].shape}, not {shape}")
    saved["time"] = float(group.attrs["time"])
    saved["travel"] = [float(cells) for cells in group.attrs["travel"]]
    saved["past_symmetry"] = int(group.attrs["past_symmetry"])
    saved["heating"] = [_core.Heating(*map(float, row)) for row in group.attrs["heating"]]
    for body in (1, 2):
        for name in (f"softening{body}", f"past{body}"):
            saved[name] = np.ascontiguousarray(group[name][...]) if name in group else None
        name = f"history{body}"
        saved[name] = None
        if name in group:
            kept = group[name]
            saved[name] = {
                "box": [int(n) for n in kept.attrs["box"]],
                "flow_box": [int(n) for n in kept.attrs["flow_box"]],
                "mirrored": int(kept.attrs["mirrored"]),
                "strain": np.ascontiguousarray(kept["strain"][...]),
                "equivalent": np.ascontiguousarray(kept["equivalent"][...]),
                "backstress": np.ascontiguousarray(
                    kept["backstress"][...] if "backstress" in kept else np.zeros(0)
                ),
            }
    saved["last_flow"] = _read_flow(group["last_flow"]) if "last_flow" in group else None
    saved["counters"] = {k: _plain(v) for k, v in file["counters"].attrs.items()}
    return saved

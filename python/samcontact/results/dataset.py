# SPDX-License-Identifier: GPL-3.0-or-later
"""The dataset of a simulation, and its file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime, timezone
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5netcdf
import numpy as np
import xarray as xr

from .._atomic import replacing_hdf5
from .._checks import choice
from .._seal import check_seal
from ..checkpoint import DAMAGED
from .convergence import add_convergence
from .motion import COMPONENTS, add_motion
from .motion import variable as _variable
from .reading import parts_of_a_run

if TYPE_CHECKING:
    import pandas as pd

    from ..cases import Case
    from ..material import Material
    from ..simulation import Simulation
    from ..state import State

VOLUME_CHOICES = ("none", "last", "peak_and_last", "all")

_SURFACE = ("increment", "x", "y")
_VOLUME = ("volume_increment", "x", "y", "z")
_TENSOR = ("volume_increment", "component", "x", "y", "z")

# name: (dimensions, unit, description, only for inelastic bodies)
_VOLUME_FIELDS: dict[str, tuple[tuple[str, ...], str, str, bool]] = {
    "stress": (_TENSOR, "Pa", "stress, positive in tension", False),
    "von_mises": (_VOLUME, "Pa", "von Mises stress", False),
    "hydrostatic": (_VOLUME, "Pa", "mean normal stress", False),
    "equivalent_plastic_strain": (_VOLUME, "1", "equivalent plastic strain", True),
    "plastic_strain": (_TENSOR, "1", "plastic strain tensor", True),
    "residual_stress": (_TENSOR, "Pa", "stress due to plastic strain alone", True),
}


def to_dataset(
    simulation: Simulation,
    states: Sequence[State],
    case: Case | None = None,
    *,
    body: int | None = None,
    volume: str | None = None,
) -> xr.Dataset:
    """Collect the states of a simulation in one labelled dataset.

    Parameters
    ----------
    simulation : Simulation
        Gives the grid, the bodies and their materials.
    states : sequence of State
        One per increment.
    case : Case, optional
        Its title, text and [output] settings are used.
    body : {1, 2}, optional
        Body whose stresses are stored even when it is elastic; from the case, or 2.
        Inelastic bodies are always stored.
    volume : {"none", "last", "peak_and_last", "all"}, optional
        Increments whose volume fields are stored (peak: largest load); from the case, or
        "peak_and_last".

    Returns
    -------
    xarray.Dataset
        Dimensions increment, x, y and, with a volume, volume_increment, z, component; for an
        inelastic body that moved, track_x_body1 or track_x_body2: its whole track at the end.
        Every variable has ``units`` (SI) and ``long_name``.

    Raises
    ------
    ValueError
        No states, or an unknown `body` or `volume`.
    """
    if len(states) == 0:
        raise ValueError("states must hold at least one state, got none")
    if body is None:
        body = case.output.body if case is not None else 2
    if volume is None:
        volume = case.output.volume if case is not None else "peak_and_last"
    choice("body", body, (1, 2))
    choice("volume", volume, VOLUME_CHOICES)

    dataset = xr.Dataset(coords=_coordinates(simulation))
    _add_scalars(dataset, simulation, states)
    _add_surface(dataset, simulation, states)
    heated = _add_temperatures(dataset, simulation, states)
    if simulation.grid.nz > 0:
        bodies = _stored_bodies(simulation, body)
        _add_maxima(dataset, states, bodies)
        chosen = _chosen_increments(states, volume)
        if chosen:
            _add_volume(dataset, states, bodies, chosen)
            _add_volume_temperatures(dataset, states, heated, chosen)
    inelastic = _inelastic(simulation)
    add_convergence(dataset, states, inelastic)
    add_motion(dataset, states, inelastic, volume != "none")
    dataset.attrs = _attributes(simulation, case, body)
    return dataset


def _coordinates(simulation: Simulation) -> dict[str, xr.Variable]:
    grid = simulation.grid
    coordinates = {
        "x": _variable("x", np.asarray(grid.x), "m", "cell centres along x"),
        "y": _variable("y", np.asarray(grid.y), "m", "cell centres along y"),
    }
    if grid.nz > 0:
        text = "depths of the layer centres, into the body"
        coordinates["z"] = _variable("z", np.asarray(grid.z), "m", text)
    return coordinates


def _add_scalars(dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]) -> None:
    cell = simulation.grid.dx * simulation.grid.dy

    def contact_area(state: State) -> float:
        return float(cell * np.count_nonzero(state.pressure))

    def add(name: str, units: str, text: str, value: Callable[[State], float]) -> None:
        values = np.array([value(state) for state in states])
        dataset[name] = _variable("increment", values, units, text)

    dataset.coords["increment"] = _variable(
        "increment", np.arange(1, len(states) + 1), "1", "number of the load increment"
    )
    add("load", "N", "normal load", lambda s: float(s.load))
    add("approach", "m", "rigid-body approach", lambda s: float(s.approach))
    add("max_pressure", "Pa", "maximum pressure", lambda s: float(np.max(s.pressure)))
    add("contact_area", "m2", "area under pressure", contact_area)
    add("iterations", "1", "plastic iterations", lambda s: int(s.iterations))
    add("contact_iterations", "1", "contact iterations", lambda s: int(s.contact_iterations))
    add("substeps", "1", "steps the increment was split into", lambda s: int(s.substeps))


def _add_surface(dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]) -> None:
    def add(name: str, units: str, text: str, fields: list[Any]) -> None:
        dataset[name] = _variable(_SURFACE, np.stack(fields), units, text)

    add("pressure", "Pa", "contact pressure", [s.pressure for s in states])
    add("gap", "m", "gap under load", [s.gap for s in states])
    shear = np.stack([s.shear for s in states], axis=1)  # (2, increment, x, y)
    for direction, fields in zip("xy", shear, strict=True):
        if np.any(fields):
            add(f"shear_{direction}", "Pa", f"shear along +{direction} on body 2", list(fields))
    for body in _inelastic(simulation):
        add(
            f"residual_displacement_body{body}",
            "m",
            f"normal surface displacement by plastic strain, body {body}, into the body",
            [s.residual_displacement(body=body) for s in states],
        )
    initial = np.asarray(simulation.initial_gap)
    dataset["initial_gap"] = _variable(("x", "y"), initial, "m", "gap of the unloaded bodies")


def _add_temperatures(
    dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]
) -> list[int]:
    """Time and surface temperatures; returns the bodies that get warm."""
    if any(state.time for state in states):
        time = [state.time for state in states]
        dataset["time"] = _variable("increment", time, "s", "time since the start")
    heated = []
    for body in (1, 2):
        if _material(simulation, body).thermal is None:
            continue
        rise = np.stack([state.surface_temperature(body=body) for state in states])
        if not np.any(rise):
            continue
        heated.append(body)
        text = f"rise of temperature of the surface, body {body}"
        dataset[f"surface_temperature_body{body}"] = _variable(_SURFACE, rise, "K", text)
        largest = rise.max(axis=(1, 2))
        text = f"maximum rise of temperature, body {body}"
        dataset[f"max_temperature_body{body}"] = _variable("increment", largest, "K", text)
    return heated


def _add_volume_temperatures(
    dataset: xr.Dataset, states: Sequence[State], heated: list[int], chosen: list[int]
) -> None:
    for body in heated:
        rise = np.stack([states[i].temperature(body=body) for i in chosen])
        text = f"rise of temperature, body {body}"
        dataset[f"temperature_body{body}"] = _variable(_VOLUME, rise, "K", text)


def _material(simulation: Simulation, body: int) -> Material:
    return simulation.body1 if body == 1 else simulation.body2


def _inelastic(simulation: Simulation) -> list[int]:
    return [body for body in (1, 2) if _material(simulation, body).is_plastic]


def _stored_bodies(simulation: Simulation, body: int) -> dict[int, bool]:
    """Bodies with volume fields, and whether each is inelastic."""
    stored = {number: True for number in _inelastic(simulation)}
    if body not in stored and _material(simulation, body).law != "rigid":
        stored[body] = False
    return dict(sorted(stored.items()))


def _add_maxima(dataset: xr.Dataset, states: Sequence[State], bodies: dict[int, bool]) -> None:
    for body, inelastic in bodies.items():
        stress = [float(np.max(s.von_mises(body=body))) for s in states]
        text = f"maximum von Mises stress, body {body}"
        dataset[f"max_von_mises_body{body}"] = _variable("increment", stress, "Pa", text)
        if inelastic:
            strain = [float(np.max(s.equivalent_plastic_strain(body=body))) for s in states]
            text = f"maximum equivalent plastic strain, body {body}"
            name = f"max_equivalent_plastic_strain_body{body}"
            dataset[name] = _variable("increment", strain, "1", text)


def _chosen_increments(states: Sequence[State], volume: str) -> list[int]:
    last = len(states) - 1
    if volume == "none":
        return []
    if volume == "all":
        return list(range(last + 1))
    if volume == "last":
        return [last]
    peak = int(np.argmax([state.load for state in states]))
    return sorted({peak, last})


def _add_volume(
    dataset: xr.Dataset, states: Sequence[State], bodies: dict[int, bool], chosen: list[int]
) -> None:
    dataset.coords["component"] = ("component", list(COMPONENTS))
    dataset.coords["volume_increment"] = _variable(
        "volume_increment", np.array(chosen) + 1, "1", "increments with volume fields"
    )
    for body, inelastic in bodies.items():
        for name, (dims, units, text, needs_plasticity) in _VOLUME_FIELDS.items():
            if needs_plasticity and not inelastic:
                continue
            fields = np.stack([getattr(states[i], name)(body=body) for i in chosen])
            dataset[f"{name}_body{body}"] = _variable(dims, fields, units, f"{text}, body {body}")


def _attributes(simulation: Simulation, case: Case | None, body: int) -> dict[str, Any]:
    from .. import __version__

    attributes: dict[str, Any] = {
        "title": case.title if case is not None else "",
        "samcontact_version": __version__,
        "created": datetime.now(timezone.utc).isoformat(timespec="seconds"),
        "body": body,
        "dx": float(simulation.grid.dx),
        "dy": float(simulation.grid.dy),
        "friction": float(simulation.friction),
        "tol": float(simulation.tol),
        "reach": float(simulation.reach),
        "heat_factor": [float(factor) for factor in simulation.heat_factor],
    }
    if simulation.grid.dz is not None:
        attributes["dz"] = float(simulation.grid.dz)
    for body in (1, 2):
        material = _material(simulation, body)
        attributes[f"body{body}_law"] = material.law
        for name, value in material.parameters.items():
            attributes[f"body{body}_{name}"] = value
        if material.thermal is not None:
            names = ("conductivity", "expansion", "diffusivity")
            for name, value in zip(names, material.thermal, strict=True):
                attributes[f"body{body}_{name}"] = value
        if material.softening is not None:
            attributes[f"body{body}_softening"] = repr(material.softening)
        if material.kinematic:
            modulus, recovery = zip(*material.kinematic, strict=True)
            attributes[f"body{body}_kinematic_modulus"] = list(modulus)
            attributes[f"body{body}_kinematic_recovery"] = list(recovery)
    if case is not None:
        attributes["description"] = case.description
        attributes["case"] = case.text
    return attributes


def save(dataset: xr.Dataset, path: str | Path) -> Path:
    """Write a dataset as compressed netCDF4, atomically.

    The file appears under its name only when it is complete; an existing one is replaced.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `to_dataset`.
    path : str or Path
        The file, customarily ending in .nc; its directory must exist.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OSError
        The directory is missing or cannot be written.
    """
    target = Path(path)
    encoding = {
        name: {"zlib": True, "complevel": 1, "shuffle": True}
        for name, variable in dataset.data_vars.items()
        if variable.ndim > 1
    }
    with replacing_hdf5(target) as opened, h5netcdf.File(opened, "w") as file:
        # to_netcdf would let HDF5 write to the disk itself
        dataset.dump_to_store(xr.backends.H5NetCDFStore(file), encoding=encoding)
    return target


def open_results(path: str | Path) -> xr.Dataset:
    """Open a results file; fields are read when they are used.

    Parameters
    ----------
    path : str or Path
        A file written by `save`.

    Returns
    -------
    xarray.Dataset
        Close it, or use it in a ``with`` statement.

    Raises
    ------
    FileNotFoundError
        There is no such file.
    ValueError
        The file is not a results file of this package.
    """
    source = Path(path)
    if not source.is_file():
        raise FileNotFoundError(f"no results file at {source}")
    try:
        check_seal(source)  # files that other programs have written on purpose have none
        _try(source)
        dataset = xr.open_dataset(source, engine="h5netcdf")
    except PermissionError:
        raise
    except DAMAGED as error:
        raise ValueError(f"path must be a netCDF4 file, got {source}: {error}") from error
    if "samcontact_version" not in dataset.attrs:
        dataset.close()
        raise ValueError(f"path must be a results file written by samcontact, got {source}")
    return dataset


def _try(path: Path) -> None:
    """Read what is read at once; xarray would leave a file open that it cannot use."""
    with h5netcdf.File(path, "r") as file:
        xr.open_dataset(xr.backends.H5NetCDFStore(file))


def scalars(dataset: xr.Dataset) -> pd.DataFrame:
    """Table of the quantities that have one value per increment.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `to_dataset` or `open_results`.

    Returns
    -------
    pandas.DataFrame
        Indexed by increment, SI units.
    """
    names = [
        name for name, variable in dataset.data_vars.items() if variable.dims == ("increment",)
    ]
    with parts_of_a_run():
        return dataset[names].to_dataframe()

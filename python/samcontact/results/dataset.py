# SPDX-License-Identifier: GPL-3.0-or-later
"""The dataset of a simulation."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime, timezone
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from .._checks import choice
from .._peak import peak_of_dataset
from .convergence import add_convergence
from .motion import COMPONENTS, add_motion
from .motion import variable as _variable

if TYPE_CHECKING:
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
    stopped_by: str = "",
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
        Increments whose volume fields are stored; from the case, or "peak_and_last". The peak is
        the increment of largest von Mises stress; of several with the same, to 0.1 %, that of
        largest pressure, then of largest load.
    stopped_by : str, optional
        Of a run that did not reach the end of its path: why, e.g. the text of the error whose
        attribute `states` the states are. The attribute ``complete`` is then 0.

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
        chosen = _chosen_increments(dataset, volume)
        if chosen:
            _add_volume(dataset, states, bodies, chosen)
            _add_volume_temperatures(dataset, states, heated, chosen)
    inelastic = _inelastic(simulation)
    add_convergence(dataset, states, inelastic)
    add_motion(dataset, states, inelastic, volume != "none")
    dataset.attrs = _attributes(simulation, case, body) | completeness(stopped_by)
    return dataset


def completeness(stopped_by: str) -> dict[str, int | str]:
    """Attributes that tell whether a run reached its end, or else what stopped it."""
    return {"complete": 0, "stopped_by": stopped_by} if stopped_by else {"complete": 1}


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
        prints = [s.residual_displacement(body=body) for s in states]
        text = f"normal surface displacement by plastic strain, body {body}, into the body"
        add(f"residual_displacement_body{body}", "m", text, prints)
        depths = [float(np.max(field)) for field in prints]
        text = f"deepest point of the print within the grid, body {body}"
        dataset[f"print_depth_body{body}"] = _variable("increment", depths, "m", text)
    initial = np.asarray(simulation.initial_gap)
    dataset["initial_gap"] = _variable(("x", "y"), initial, "m", "gap of the unloaded bodies")


def _add_temperatures(
    dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]
) -> list[int]:
    """Time and surface temperatures; returns the bodies that get warm."""
    if any(state.time for state in states):
        time = [state.time for state in states]
        dataset["time"] = _variable("increment", time, "s", "time since the start")
    bodies = (simulation.body1, simulation.body2)
    if any(material.thermal is not None for material in bodies):
        factors = [state.heat_factor for state in states]
        text = "heat flux into body 1 and 2 over pressure"
        dataset["heat_factor"] = _variable(("increment", "body"), factors, "m/s", text)
        dataset.coords["body"] = _variable("body", [1, 2], "1", "number of the body")
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


def _chosen_increments(dataset: xr.Dataset, volume: str) -> list[int]:
    last = dataset.sizes["increment"] - 1
    if volume == "none":
        return []
    if volume == "all":
        return list(range(last + 1))
    if volume == "last":
        return [last]
    return sorted({peak_of_dataset(dataset), last})


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

# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of a simulation as one labelled dataset."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime, timezone
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from .._util.checks import choice, integer
from .._util.quantities import CONTACT
from .._util.tensors import COMPONENTS
from .._util.version import version
from ..bodies.depth_profiles import PROFILE_ARGUMENTS
from ..bodies.layered import Body, materials_of, matrix_of, names_of_materials
from ..bodies.layers import Layered
from ..problem.friction import attributes_of, friction_law
from ..solutions.interface_stress import SIDES
from ..solutions.peak import peak_of_dataset
from ..solutions.state import on_common_grid
from .adhesion import add_adhesion, adhesion_attributes
from .convergence import add_convergence
from .inclusions import add_inclusion_fields, add_inclusions
from .motion import add, add_motion
from .relaxing import add_relaxing, relaxation_attributes
from .slipping import add_slipping
from .zones import add_gathered, is_gathered, max_von_mises

if TYPE_CHECKING:
    from ..cases import Case
    from ..problem.domain import Domain
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

VOLUME_CHOICES = ("none", "last", "peak_and_last", "all")

_SURFACE = ("increment", "x", "y")
_VOLUME = ("output_increment", "x", "y", "z")
_TENSOR = ("output_increment", "component", "x", "y", "z")


_SCALARS: dict[str, Callable[[State], float]] = {
    "load": lambda state: float(state.load),
    "approach": lambda state: float(state.approach),
    "max_pressure": lambda state: float(np.max(state.pressure)),
    "contact_area": lambda state: state.contact_area,
    "iterations": lambda state: int(state.iterations),
    "contact_iterations": lambda state: int(state.contact_iterations),
    "substeps": lambda state: int(state.substeps),
}
# name: dimensions, and whether only elastic-plastic bodies have it
_VOLUME_FIELDS = {
    "stress": (_TENSOR, False),
    "von_mises": (_VOLUME, False),
    "hydrostatic": (_VOLUME, False),
    "equivalent_plastic_strain": (_VOLUME, True),
    "plastic_strain": (_TENSOR, True),
    "residual_stress": (_TENSOR, True),
}


def to_dataset(
    simulation: Simulation,
    states: Sequence[State],
    case: Case | None = None,
    *,
    body: int | None = None,
    volume: str | Sequence[int] | None = None,
    stopped_by: str = "",
) -> xr.Dataset:
    """Collect the states of a simulation in one labelled dataset.

    Parameters
    ----------
    simulation : Simulation
        Simulation with grid, bodies and materials.
    states : sequence of State
        One state per increment. If the grid was enlarged, all states are mapped to the largest
        grid.
    case : Case, optional
        Case whose title, text and [output] settings are used.
    body : {1, 2}, optional
        Body whose stresses are stored even if it is elastic. Default: the body of the case; without
        a case, body 2, or body 1 if body 2 is rigid. Those of elastic-plastic bodies are
        always stored.
    volume : {"none", "last", "peak_and_last", "all"} or sequence of int, optional
        Increments for which volume fields are stored, as a word or as increment numbers. Default:
        the setting of the case, or "peak_and_last". The peak is the increment with the maximum von
        Mises stress. If the stresses of several increments agree to 0.1 %, the peak is the one with
        the maximum pressure; if their pressures also agree, the one with the maximum load.
    stopped_by : str, optional
        Reason why a run did not reach the end of its path, e.g. the text of the error. (The error
        has the completed states in its attribute `states`.) The attribute ``complete`` of the
        dataset is then 0.

    Returns
    -------
    xarray.Dataset
        Dimensions increment, x, y and, for a grid with layers, output_increment, z, component. If
        the plastic strain of a body is computed in several subdomains (separate parts of the grid),
        its volume fields have the dimension cell_body1 or cell_body2 instead of x, y, z (see
        `on_grid`). With partial slip, the dataset has tangential forces and motions, slip, sticking
        cells and the energy balance. For an elastic-plastic body that moved, the dimension
        track_position_body1 or track_position_body2 spans its whole track at the end. Every
        variable has ``units`` (SI) and ``long_name``.

    Raises
    ------
    ValueError
        There are no states, or `body` or `volume` is unknown.
    """
    if len(states) == 0:
        raise ValueError("states must contain at least one state, got none")
    if body is None:
        body = case.output.body if case is not None else _body_with_stresses(simulation)
    if volume is None:
        volume = case.output.volume if case is not None else "peak_and_last"
    choice("body", body, (1, 2))
    listed = isinstance(volume, (Sequence, set, np.ndarray)) and not isinstance(volume, str)
    if not listed or getattr(volume, "ndim", 1) != 1:
        choice("volume", volume, VOLUME_CHOICES)

    states = on_common_grid(states)
    domain = states[0].domain
    dataset = xr.Dataset(coords=_coordinates(domain))
    _add_scalars(dataset, states)
    _add_surface(dataset, simulation, states)
    add_relaxing(dataset, simulation, states)
    add_slipping(dataset, simulation, states, volume != "none")
    add(dataset, "initial_gap", ("x", "y"), np.asarray(domain.initial_gap))
    heated = _add_temperatures(dataset, simulation, states)
    if simulation.grid.has_volume:
        bodies = _stored_bodies(simulation, body)
        _add_maxima(dataset, states, bodies)
        add_inclusions(dataset, simulation, states)
        chosen = _chosen(dataset, volume)
        states = _on_common_depths(states, [states[i] for i in chosen] or states[-1:])
        dataset.coords["z"] = CONTACT["z"].variable("z", np.asarray(states[-1].depths))
        if chosen:
            _add_volume(dataset, states, bodies, heated, chosen)
    inelastic = _inelastic(simulation)
    add_convergence(dataset, states, inelastic)
    add_motion(dataset, states, inelastic, volume != "none")
    dataset.attrs = _attributes(simulation, states, case, body) | completeness(stopped_by)
    return dataset


def completeness(stopped_by: str) -> dict[str, int | str]:
    """Return the dataset attribute `complete` and, for an incomplete run, `stopped_by`."""
    return {"complete": 0, "stopped_by": stopped_by} if stopped_by else {"complete": 1}


def _coordinates(domain: Domain) -> dict[str, xr.Variable]:
    return {n: CONTACT[n].variable(n, np.asarray(getattr(domain.grid, n))) for n in "xy"}


def _on_common_depths(states: Sequence[State], stored: Sequence[State]) -> list[State]:
    """Return all states with a common number of layers.

    The common number is the largest number of layers among the states in `stored` and the last
    state.
    """
    layers = max(len(state.depths) for state in (*stored, states[-1]))
    return [state.at_layers(layers) for state in states]


def _add_scalars(dataset: xr.Dataset, states: Sequence[State]) -> None:
    numbers = np.arange(1, len(states) + 1)
    dataset.coords["increment"] = CONTACT["increment"].variable("increment", numbers)
    for name, value in _SCALARS.items():
        add(dataset, name, "increment", np.array([value(state) for state in states]))
    if any(np.any(state.tilt) for state in states):
        for name in ("tilt", "moment"):
            for number, axis in enumerate("xy"):
                values = np.array([getattr(state, name)[number] for state in states])
                add(dataset, f"{name}_{axis}", "increment", values)


def _add_surface(dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]) -> None:
    add(dataset, "pressure", _SURFACE, np.stack([s.pressure for s in states]))
    add_adhesion(dataset, simulation, states)
    add(dataset, "gap", _SURFACE, np.stack([s.gap for s in states]))
    shear = np.stack([s.shear for s in states], axis=1)  # (2, increment, x, y)
    for direction, fields in zip("xy", shear, strict=True):
        if np.any(fields):
            add(dataset, f"shear_{direction}", _SURFACE, fields)
    for body in _inelastic(simulation):
        prints = np.stack([s.residual_displacement(body=body) for s in states])
        add(dataset, "residual_displacement", _SURFACE, prints, body)
        add(dataset, "imprint_depth", "increment", prints.max(axis=(1, 2)), body)


def _add_temperatures(
    dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]
) -> list[int]:
    """Add time, heat factors and surface temperatures; return the numbers of the heated bodies."""
    if any(state.time for state in states):
        add(dataset, "time", "increment", [state.time for state in states])
    bodies = (simulation.body1, simulation.body2)
    if any(material.thermal is not None for material in bodies):
        factors = [state.heat_factor for state in states]
        add(dataset, "heat_factor", ("increment", "body"), factors)
        dataset.coords["body"] = CONTACT["body"].variable("body", [1, 2])
    heated = []
    for body in (1, 2):
        if _material(simulation, body).thermal is None:
            continue
        rise = np.stack([state.surface_temperature(body=body) for state in states])
        if not np.any(rise):
            continue
        heated.append(body)
        add(dataset, "surface_temperature", _SURFACE, rise, body)
        add(dataset, "max_temperature", "increment", rise.max(axis=(1, 2)), body)
    return heated


def _body_with_stresses(simulation: Simulation) -> int:
    return 1 if simulation.body2.law == "rigid" else 2


def _material(simulation: Simulation, body: int) -> Body:
    return simulation.body1 if body == 1 else simulation.body2


def _inelastic(simulation: Simulation) -> list[int]:
    return [body for body in (1, 2) if _material(simulation, body).is_plastic]


def _stored_bodies(simulation: Simulation, body: int) -> dict[int, bool]:
    """Return the bodies with volume fields, as a dictionary.

    Keys are the numbers of the bodies; values state whether the body is elastic-plastic.
    """
    stored = {number: True for number in _inelastic(simulation)}
    if body not in stored and _material(simulation, body).law != "rigid":
        stored[body] = False
    return dict(sorted(stored.items()))


def _add_maxima(dataset: xr.Dataset, states: Sequence[State], bodies: dict[int, bool]) -> None:
    for body, inelastic in bodies.items():
        stress = [max_von_mises(state, body) for state in states]
        add(dataset, "max_von_mises", "increment", stress, body)
        if inelastic:
            strain = [s.max_equivalent_plastic_strain(body=body) for s in states]
            add(dataset, "max_equivalent_plastic_strain", "increment", strain, body)


def _chosen(dataset: xr.Dataset, volume: str | Sequence[int]) -> list[int]:
    """Return the indices (from 0) of the increments for which volume fields are stored."""
    count = dataset.sizes["increment"]
    if not isinstance(volume, str):
        return sorted({integer("volume", number, 1, count) - 1 for number in volume})
    if volume == "all":
        return list(range(count))
    if volume == "none":
        return []
    return sorted({peak_of_dataset(dataset), count - 1} if "peak" in volume else {count - 1})


def _add_volume(
    dataset: xr.Dataset,
    states: Sequence[State],
    bodies: dict[int, bool],
    heated: list[int],
    chosen: list[int],
) -> None:
    dataset.coords["component"] = CONTACT["component"].variable("component", list(COMPONENTS))
    dataset.coords["output_increment"] = CONTACT["output_increment"].variable(
        "output_increment", np.array(chosen) + 1
    )
    stored = [states[i] for i in chosen]
    gathered = [body for body in bodies if is_gathered(stored, body)]
    for body in gathered:
        add_gathered(dataset, stored, body)
    volume_fields = [
        (name, dims, body)
        for body, inelastic in bodies.items()
        for name, (dims, needs_plasticity) in _VOLUME_FIELDS.items()
        if body not in gathered and (inelastic or not needs_plasticity)
    ]
    for name, dims, body in [*volume_fields, *(("temperature", _VOLUME, body) for body in heated)]:
        fields = np.stack([getattr(state, name)(body=body) for state in stored])
        add(dataset, name, dims, fields, body)
    for body in bodies:
        if body not in gathered:
            _add_interfaces(dataset, stored, body)
            add_inclusion_fields(dataset, stored, body)


def _add_interfaces(dataset: xr.Dataset, stored: Sequence[State], body: int) -> None:
    """Add the interface stresses of a layered body.

    Nothing is added for other bodies, or if the fields of the body do not coincide with grid cells
    (`State.offset` is not 0).
    """
    layered = matrix_of(stored[0].setup.bodies[body - 1])
    if not isinstance(layered, Layered) or any(state.offset(body) for state in stored):
        return
    fields = np.stack([state.interface_stress(body=body) for state in stored])
    dim = f"interface_body{body}"
    dataset.coords["side"] = CONTACT["side"].variable("side", list(SIDES))
    dataset.coords[dim] = CONTACT["interface"].variable(dim, layered.interfaces, body)
    dims = ("output_increment", "side", "component", "x", "y", dim)
    add(dataset, "interface_stress", dims, fields, body)


def _material_attributes(prefix: str, body: Body) -> dict[str, Any]:
    """Return the material of a body as dataset attributes, whose names begin with `prefix`.

    For a heterogeneous body, this is the material of the matrix.
    """
    body = matrix_of(body)
    found: dict[str, Any] = {f"{prefix}law": body.law}
    if isinstance(body, Layered):
        found[f"{prefix}thickness"] = body.parameters["thickness"]
        for name, material in zip(
            names_of_materials(len(body.layers)), materials_of(body), strict=True
        ):
            found |= _material_attributes(f"{prefix}{name}_", material)
        return found
    found |= {f"{prefix}{name}": value for name, value in body.parameters.items()}
    if body.thermal is not None:
        names = ("conductivity", "expansion", "diffusivity")
        found |= {f"{prefix}{name}": v for name, v in zip(names, body.thermal, strict=True)}
    if body.softening is not None:
        found[f"{prefix}softening"] = repr(body.softening)
    if body.kinematic:
        modulus, recovery = zip(*body.kinematic, strict=True)
        found[f"{prefix}kinematic_modulus"] = list(modulus)
        found[f"{prefix}kinematic_recovery"] = list(recovery)
    if body.free_faces is not None:
        names = ("low", "high", "method")
        found |= {f"{prefix}free_faces_{n}": v for n, v in zip(names, body.free_faces, strict=True)}
    found |= relaxation_attributes(prefix, body.relaxation_terms)
    for kind, parts in PROFILE_ARGUMENTS.items():
        for part, values in zip(parts, getattr(body, kind) or (), strict=False):
            found[f"{prefix}{kind}_{part}"] = list(values)
    return found


def _attributes(
    simulation: Simulation, states: Sequence[State], case: Case | None, body: int
) -> dict[str, Any]:
    attributes: dict[str, Any] = {
        "title": case.title if case is not None else "",
        "samcontact_version": version,
        "created": datetime.now(timezone.utc).isoformat(timespec="seconds"),
        "body": body,
        "dx": float(simulation.grid.dx),
        "dy": float(simulation.grid.dy),
        **attributes_of(friction_law(simulation.friction)),
        "tol": float(simulation.tol),
        "reach": float(simulation.reach),
    }
    attributes |= adhesion_attributes(simulation, states)
    if simulation.grid.periodic:
        attributes["periodic"] = simulation.grid.periodic
    if simulation.grid.dz is not None:
        attributes["dz"] = float(simulation.grid.dz)
    for body in (1, 2):
        attributes |= _material_attributes(f"body{body}_", _material(simulation, body))
    if case is not None:
        attributes["description"] = case.description
        attributes["case"] = case.text
    return attributes

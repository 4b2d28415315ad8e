# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in which a load is looked for: cases under other loads, and what is asked of them."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .._util.quantities import described
from .._util.short_text import in_short
from .._util.tensors import von_mises
from ..bodies.layered import Layered
from ..bodies.material import Material
from ..simulation import error_controlled_quantities
from ..simulation.repeated import remade

if TYPE_CHECKING:
    from ..cases import Case
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

YIELD = "yield"
PERMANENT = "permanent_deformation"

Built = tuple["Simulation", Sequence[Mapping[str, Any]]]


@dataclass(frozen=True)
class Scaled:
    """A case under other loads."""

    case: Case
    largest: float

    def __call__(self, load: float) -> Built:
        factor = load / self.largest
        path = [segment.scaled(factor) for segment in self.case.path]
        return self.case.model_copy(update={"path": path}).build()


def of_case(case: Case) -> float:
    if case.wear is not None:
        raise ValueError("wear: a load is found of one contact, not of cycles of wear")
    loads = [segment.load for segment in case.path]
    given = [load for load in loads if load is not None]
    if len(given) < len(loads) or not max(given) > 0:
        raise ValueError("path: a load is found of a path of loads, one at least > 0")
    return max(given)


def require_known(name: object) -> None:
    """Raise ValueError for what is no quantity of any simulation, with the nearest that is one."""
    kinds = [*error_controlled_quantities.OF_CONTACT[1:], *error_controlled_quantities.OF_BODY]
    known = [*kinds, PERMANENT, YIELD]
    of_body = error_controlled_quantities.OF_BODY
    if name in known or name in [f"{kind}_body{n}" for kind in of_body for n in (1, 2)]:
        return
    word = name.lower() if isinstance(name, str) else ""
    near = difflib.get_close_matches(word, known, 1, cutoff=0.5)
    hint = f": did you mean {near[0]}?" if near else ""
    raise ValueError(f"quantity must be one of {', '.join(known)}, got {in_short(name)}{hint}")


def resolved(name: str, simulation: Simulation) -> str:
    """A name as `value_of` takes it; ValueError for one that the simulation has not."""
    require_known(name)
    bodies = simulation.body1, simulation.body2
    if name == YIELD:
        if not any(body.is_plastic for body in bodies):
            raise ValueError('quantity = "yield" needs a body that yields')
        if any(body.softening for body in bodies):
            raise ValueError('quantity = "yield" is not for bodies that soften by heat')
        for n, body in enumerate(bodies, 1):
            if isinstance(body, Layered) and body.is_plastic:
                raise ValueError(
                    f'quantity = "yield" is not for layers, which body{n} has: find '
                    "max_equivalent_plastic_strain of a small value, e.g. 1e-6"
                )
        if not simulation.grid.has_volume:
            raise ValueError('quantity = "yield" needs a grid with dz')
        return name
    if name == PERMANENT:
        if not any(body.is_plastic for body in bodies):
            raise ValueError(f'quantity = "{name}" needs a body that yields')
        if not simulation.grid.has_volume:
            raise ValueError(f'quantity = "{name}" needs a grid with dz')
        return name
    known = error_controlled_quantities.names(bodies, volume=simulation.grid.has_volume)
    found = [one for one in known if one in (name, f"{name}_body1", f"{name}_body2")]
    if not found:
        allowed = [one for one in known if one != "load"]
        raise ValueError(
            "quantity must be one that the bodies and the grid have, "
            f"{', '.join(allowed)}, got {in_short(name)}"
        )
    return name if name in found else ",".join(found)


def label_and_unit(name: str) -> tuple[str, str]:
    """Of a quantity by its resolved name, for those who read it."""
    if name == YIELD:
        return "von Mises stress over yield stress", ""
    if name == PERMANENT:
        return "permanent deformation, both bodies", "m"
    known, body = described(name.partition(",")[0])
    body = None if "," in name else body
    unit = {"m2": "m²", "1": ""}.get(known.unit, known.unit)
    return known.heading if body is None else f"{known.heading}, body {body}", unit


def elastic(simulation: Simulation) -> Simulation:
    """With bodies that do not yield."""
    bodies = {}
    for name in ("body1", "body2"):
        body = getattr(simulation, name)
        if body.is_plastic:
            made = Material.elastic(body.E, body.nu)
            made = made if body.thermal is None else made.with_thermal(*body.thermal)
            start = body.residual_stress
            bodies[name] = made if start is None else made.with_residual_stress(*start)
    return remade(simulation, **bodies)


def is_graded(body: Material) -> bool:
    """Whether its strength or its stress of the start changes with depth."""
    return body.yield_profile is not None or body.residual_stress is not None


def used_strength(state: State, n: int, body: Material) -> float:
    """Largest von Mises stress of an elastic state over the yield stress of its depth.

    Raises ValueError where the layers of the state may end above it.
    """
    least = float(body.yield_stress(0.0))
    if not is_graded(body):
        return error_controlled_quantities.value(state, f"max_von_mises_body{n}") / least
    used = von_mises(state.stress(n)) / (least * body.yield_factor(state.depths))
    over_depth = used.max(axis=(0, 1))
    if over_depth.argmax() == len(over_depth) - 1:
        raise ValueError(
            f"body{n} yields in the last layer of the grid, at {state.depths[-1]:.4g} m, or below: "
            "give a grid with more layers (nz)"
        )
    return max(error_controlled_quantities.below_and_at_surface(used))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of a load search: scaled loads, and checks of the quantity sought."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .._util.quantities import CONTACT, described
from .._util.short_text import in_short
from .._util.tensors import von_mises
from .._util.wear_quantities import WEAR
from ..bodies.layers import Layered
from ..bodies.material import Material
from ..simulation import error_controlled_quantities
from ..simulation.repeated import rebuilt

if TYPE_CHECKING:
    from ..cases import Case
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

YIELD = "yield"
PERMANENT_DEFORMATION = "permanent_deformation"

Built = tuple["Simulation", Sequence[Mapping[str, Any]]]


@dataclass(frozen=True)
class ScaledCase:
    """Case that is built for any maximum load [N] by scaling all forces."""

    case: Case
    largest: float

    def __call__(self, load: float) -> Built:
        factor = load / self.largest
        path = [segment.scaled(factor) for segment in self.case.path]
        return self.case.model_copy(update={"path": path}).build()


def max_load(case: Case) -> float:
    if case.wear is not None:
        raise ValueError(
            "a load search does not support wear: remove [wear], or solve the case for several "
            "loads"
        )
    loads = [segment.load for segment in case.path]
    given = [load for load in loads if load is not None]
    if len(given) < len(loads) or not max(given) > 0:
        raise ValueError(
            "path: a load search requires a prescribed load in each segment, "
            "and at least one load > 0"
        )
    return max(given)


def require_known(name: object) -> None:
    """Raise ValueError for an unknown quantity; the message suggests the most similar name."""
    kinds = [
        *error_controlled_quantities.CONTACT_QUANTITIES[1:],
        *error_controlled_quantities.BODY_QUANTITIES,
    ]
    known = [*kinds, PERMANENT_DEFORMATION, YIELD]
    of_body = error_controlled_quantities.BODY_QUANTITIES
    if name in known or name in [f"{kind}_body{n}" for kind in of_body for n in (1, 2)]:
        return
    kind = name.partition("_body")[0] if isinstance(name, str) else ""
    if kind in WEAR and kind not in CONTACT:
        raise ValueError(
            f"quantity must be a contact quantity, got {in_short(name)}: a load search does not "
            "support wear; solve the case for several loads, e.g. by samcontact sweep without "
            "--find"
        )
    word = name.lower() if isinstance(name, str) else ""
    near = difflib.get_close_matches(word, known, 1, cutoff=0.5)
    hint = f": did you mean {near[0]}?" if near else ""
    raise ValueError(f"quantity must be one of {', '.join(known)}, got {in_short(name)}{hint}")


def resolved(name: str, simulation: Simulation) -> str:
    """Return the name of a quantity with its body number.

    A name without body number gives the names for both bodies, separated by a comma, if both have
    the quantity. Raises ValueError if the simulation cannot compute the quantity.
    """
    require_known(name)
    bodies = simulation.body1, simulation.body2
    if name == YIELD:
        if not any(body.is_plastic for body in bodies):
            raise ValueError(
                'quantity = "yield" requires an elastic-plastic body: set a '
                "hardening law in [body1] or [body2]"
            )
        if any(body.softening for body in bodies):
            raise ValueError(
                'quantity = "yield" does not support thermal softening: '
                "remove softening from the bodies"
            )
        for n, body in enumerate(bodies, 1):
            if isinstance(body, Layered) and body.is_plastic:
                raise ValueError(
                    f'quantity = "yield" does not support layers, got layers in body{n}: search '
                    "for a small value of max_equivalent_plastic_strain instead, e.g. 1e-6"
                )
        if not simulation.grid.has_volume:
            raise ValueError('quantity = "yield" requires a grid with layers: set grid.dz')
        return name
    if name == PERMANENT_DEFORMATION:
        if not any(body.is_plastic for body in bodies):
            raise ValueError(
                f'quantity = "{name}" requires an elastic-plastic body: set a '
                "hardening law in [body1] or [body2]"
            )
        if not simulation.grid.has_volume:
            raise ValueError(f'quantity = "{name}" requires a grid with layers: set grid.dz')
        return name
    known = error_controlled_quantities.names(bodies, volume=simulation.grid.has_volume)
    found = [one for one in known if one in (name, f"{name}_body1", f"{name}_body2")]
    if not found:
        allowed = [one for one in known if one != "load"]
        raise ValueError(
            f"for these bodies and this grid, quantity must be one of {', '.join(allowed)}, got "
            f"{in_short(name)}"
        )
    return name if name in found else ",".join(found)


def label_and_unit(name: str) -> tuple[str, str]:
    """Return the label and the unit of the quantity with this name in results files."""
    if name == YIELD:
        return "von Mises stress / yield stress", ""
    if name == PERMANENT_DEFORMATION:
        return "permanent deformation, both bodies", "m"
    known, body = described(name.partition(",")[0])
    body = None if "," in name else body
    unit = {"m2": "m²", "1": ""}.get(known.unit, known.unit)
    return known.heading if body is None else f"{known.heading}, body {body}", unit


def elastic(simulation: Simulation) -> Simulation:
    """Return a copy of a simulation with elastic instead of elastic-plastic bodies.

    Raises ValueError for a simulation with dents, because dents are initial plastic strain.
    """
    if simulation.engine.preparation is not None:
        raise ValueError(
            'quantity = "yield" does not support dents, because body 2 has already yielded in '
            "them: use another quantity, e.g. max_pressure or max_equivalent_plastic_strain"
        )
    bodies = {}
    for name in ("body1", "body2"):
        body = getattr(simulation, name)
        if body.is_plastic:
            made = Material.elastic(body.E, body.nu)
            made = made if body.thermal is None else made.with_thermal(*body.thermal)
            start = body.residual_stress
            bodies[name] = made if start is None else made.with_residual_stress(*start)
    return rebuilt(simulation, **bodies)


def has_depth_profile(body: Material) -> bool:
    """Whether the yield stress or the initial stress of a body varies with depth."""
    return body.yield_profile is not None or body.residual_stress is not None


def used_strength(state: State, n: int, body: Material) -> float:
    """Return the maximum ratio of von Mises stress to yield stress in an elastic state.

    Raises ValueError if the maximum may lie below the deepest layer of the state.
    """
    strength = float(body.yield_stress(0.0))
    if not has_depth_profile(body):
        return error_controlled_quantities.value(state, f"max_von_mises_body{n}") / strength
    used = von_mises(state.stress(n)) / (strength * body.yield_factor(state.depths))
    over_depth = used.max(axis=(0, 1))
    if over_depth.argmax() == len(over_depth) - 1:
        raise ValueError(
            f"body{n} first yields in or below the deepest layer of the grid, which is at z = "
            f"{state.depths[-1]:.4g} m: increase nz"
        )
    return max(error_controlled_quantities.below_and_at_surface(used))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the arguments of fretting wear, and its lead-in steps."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .._util.cached_property import cached_property
from .._util.checks import (
    exactly_one,
    finite_array,
    number,
    require_type,
    step_list,
    value_per_body,
)
from .._util.short_text import in_short
from ..bodies.free_faces import require_endless
from ..bodies.layered import Body, require_bodies
from ..bodies.relaxation import long_time_share
from ..bodies.viscoelastic import longest_creep_time, relaxation_of, relaxes
from ..contact.tangential_drive import TangentialInput
from ..diagnostics.plausibility import warn_if_implausible, wear_coefficient
from ..problem.domain import SurfaceGeometry
from ..problem.friction import FrictionLaw, sticking_law
from ..problem.grid import Grid
from .problem import WearProblem
from .results import FrettingCycle
from .worn_inclusions import require_worn_inclusions

_ALLOWED_ARGUMENTS = (
    "load", "approach", "shift", "tangential_load", "twist", "torque", "duration",
)  # fmt: skip
_ROUNDING_ERROR = 1e-9
"""Difference below which loads or motions count as equal, divided by their maximum in a cycle."""


@dataclass(frozen=True)
class FrettingSetup(WearProblem):
    """Checked arguments of `samcontact.wear.fretting`, constant over all cycles."""

    friction: FrictionLaw
    law: str
    coefficients: tuple[float, float]
    repeats: int

    @property
    def relaxes(self) -> bool:
        """Whether at least one body is viscoelastic."""
        return relaxes(*self.bodies)

    @property
    def follows_time(self) -> bool:
        """Whether each loop continues the creep of the previous loop (see `fretting`, Notes)."""
        return self.relaxes and self.repeats == 1

    @cached_property
    def crept_share(self) -> float:
        """Fraction of the slowest creep process that one loop completes [-]; 1 without creep."""
        duration = sum(step.get("duration") or 0.0 for step in self.cycle[closing(self.cycle) :])
        slowest = max(map(longest_creep_time, self.bodies))
        return -math.expm1(-duration / slowest) if slowest > 0 and duration > 0 else 1.0

    @property
    def record(self) -> type[FrettingCycle]:
        return FrettingCycle

    def rows(self, body: int) -> tuple[int, int]:
        """Return the first row that can wear (0), and the number of such rows (all)."""
        return 0, self.grid.nx


def make_setup(
    grid: Grid,
    bodies: tuple[Body, Body],
    given: SurfaceGeometry,
    cycle: Iterable[Mapping[str, Any]],
    friction: FrictionLaw,
    energy: float | Sequence[float] | None,
    archard: float | Sequence[float] | None,
    repeats: int,
    settings: dict[str, Any],
) -> FrettingSetup:
    """Check all arguments that `Simulation` does not check, and return them."""
    require_type("grid", grid, Grid)
    require_bodies(*bodies, inclusions=True)
    require_worn_inclusions(*bodies)
    require_endless("wear does not support ends of bodies", *bodies)
    sticking_law(friction)
    if friction.is_frictionless or friction.prevents_slip:
        raise ValueError(f"friction must be > 0 and finite for fretting wear, got {friction!r}")
    law = exactly_one(energy=energy, archard=archard)
    coefficients = value_per_body(law, archard if energy is None else energy)
    if not any(coefficients):
        raise ValueError(f"{law} must be > 0 for at least one body, got {coefficients!r}")
    warn_if_implausible(wear_coefficient(law, max(coefficients)), stacklevel=4)
    surfaces = given.over(grid)
    finite_array("gap", surfaces.initial_gap)  # finite bodies are not supported
    path = step_list("cycle", cycle, _ALLOWED_ARGUMENTS)
    closing(path)
    if repeats > 1:
        _require_long_time_state(bodies)
    return FrettingSetup(
        surfaces=given,
        grid=grid,
        bodies=bodies,
        gap=surfaces.initial_gap,
        reliefs=surfaces.reliefs,
        cycle=path,
        friction=friction,
        worn=tuple(body for body in (1, 2) if coefficients[body - 1] > 0),
        settings=settings,
        law=law,
        coefficients=coefficients,
        repeats=repeats,
    )


def _require_long_time_state(bodies: tuple[Body, Body]) -> None:
    """Raise ValueError for a viscoelastic fluid, whose response never becomes periodic."""
    for n, body in enumerate(bodies, 1):
        terms = relaxation_of(body)
        if terms is not None and long_time_share(terms) == 0:
            raise ValueError(
                f"repeats must be 1 because body{n} is a viscoelastic fluid (its shares add up to "
                "1), whose response never becomes periodic"
            )


def closing(path: list[dict[str, Any]]) -> int:
    """Return the number of lead-in steps, which precede the repeated loop.

    Raises ValueError if the path has no steps, or if its last step does not return to the load and
    the tangential forces or motions of an earlier step.
    """
    places = _places(path)
    scales = [max(abs(place[k][1]) for place in places) for k in range(len(places[0]))]
    for n, place in enumerate(places[:-1]):
        if all(
            kind == last_kind and abs(value - last) <= _ROUNDING_ERROR * size
            for (kind, value), (last_kind, last), size in zip(
                place, places[-1], scales, strict=True
            )
        ):
            return n
    raise ValueError(
        "cycle must end with the load and the tangential forces or motions of an earlier step, "
        f"got {in_short(path)}: use paths.fretting_loop"
    )


def _places(path: list[dict[str, Any]]) -> list[list[tuple[str, float]]]:
    """Return the load or approach and the tangential forces or motions at each instant.

    The instants are the start of the path and the end of each step.

    Tangential forces and motions are ignored while the load is 0.
    """
    if not path:
        raise ValueError("cycle must contain at least one step, got none")
    free = [("load", 0.0), *[("motion", 0.0)] * 3]
    places, moved = [free], [0.0] * 3
    for step in path:
        name = exactly_one(load=step.get("load"), approach=step.get("approach"))
        along = TangentialInput.of(
            {"shift": step.get("shift"), "twist": step.get("twist")},
            {"tangential_load": step.get("tangential_load"), "torque": step.get("torque")},
        )
        place = [(name, number(name, step[name]))]
        for k, (is_force, value) in enumerate(zip(along.is_force, along.values, strict=True)):
            moved[k] += 0.0 if is_force else value
            place.append(("force", value) if is_force else ("motion", moved[k]))
        places.append(free if place[0] == ("load", 0.0) else place)
    return places

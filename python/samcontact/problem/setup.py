# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies, surfaces and settings of a simulation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .._util.cached_property import cached_property
from ..bodies.viscoelastic import relaxes
from .friction import has_history
from .settings import Settings

if TYPE_CHECKING:
    from ..bodies.layered import Body
    from ..heat import Heat
    from .contact_law import ContactLaw
    from .domain import Domain, SurfaceGeometry
    from .friction import FrictionLaw
    from .grid import Grid


@dataclass(frozen=True, eq=False)
class SimulationSetup:
    """Arguments of a simulation except grid and heat, which may change during a simulation."""

    body1: Body
    body2: Body
    surfaces: SurfaceGeometry
    settings: Settings

    @property
    def bodies(self) -> tuple[Body, Body]:
        """Body 1 (upper) and body 2 (lower)."""
        return self.body1, self.body2

    @cached_property
    def friction(self) -> FrictionLaw:
        """Friction law; if `friction` is a number, the contact slides fully."""
        return self.settings.law

    def steps_of_motion(self, grid: Grid) -> tuple[float, float | None]:
        """Return the steps along x and y [m] in which the bodies move through the grid.

        Along x, the step is a cell; any remainder of a displacement shifts the contact origin in
        the grid (see `State.origin`). Along y, the step is a cell if the bodies have a history (see
        `has_history`), and otherwise None, because any displacement is possible.
        """
        return grid.dx, grid.dy if has_history(self.friction, self.bodies) else None

    @property
    def adhesion(self) -> ContactLaw:
        """Contact law (hard contact or an attractive law)."""
        return self.settings.adhesion

    @property
    def needs_duration(self) -> bool:
        """Whether increments require a duration even if there is no heat."""
        return relaxes(self.body1, self.body2) or self.friction.needs_duration

    def resolved_adhesion(self, grid: Grid) -> ContactLaw:
        """Return the contact law as it is solved on a grid."""
        return self.adhesion.resolved(grid, self.body1, self.body2)

    def on_grid(self, grid: Grid, heat: Heat) -> dict[str, Any]:
        """Return the arguments of `Simulation`, with the surfaces as the user gave them."""
        surfaces = {name: getattr(self.surfaces, name) for name in ("gap", "relief1", "relief2")}
        return self._others(heat) | {"grid": grid} | surfaces

    def on_domain(self, domain: Domain, heat: Heat) -> dict[str, Any]:
        """Return the arguments of `Simulation`, with the surfaces as arrays on a domain."""
        given = vars(domain) | self._others(heat)
        return given | {"gap": given.pop("initial_gap")}

    def _others(self, heat: Heat) -> dict[str, Any]:
        bodies = {"body1": self.body1, "body2": self.body2}
        return bodies | self.settings.arguments() | {"heat": heat}

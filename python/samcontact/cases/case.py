# SPDX-License-Identifier: GPL-3.0-or-later
"""Case of one contact."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import BeforeValidator, Field, PrivateAttr, model_validator

from .. import hertz as _hertz
from .. import paths
from .._util import memory
from .._util.short_text import in_short
from .._util.travels import both_axes
from ..bodies.layered import softest
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.heating import NO_HEAT, heating
from ..simulation.given_strain import prepare
from .base import CaseError, CaseFile, Positive
from .bodies import BodySection
from .converted import Unit
from .cross_checks import (
    path_with_loads,
    reason_for_grid,
    require_all_used,
    require_durations,
)
from .dents import DentsSection
from .fatigue import FatigueSection
from .heat_checks import require_velocity_of_motion
from .motion import ReliefSection, Segment
from .part_grid import grid_of_part
from .rolling_parts import in_full
from .sections import (
    ContactSection,
    GridSection,
    HeatSection,
    OutputSection,
    SurfaceSection,
    contact_law_of,
    law_of_section,
    settings_of,
)
from .shakedown import ShakedownSection
from .slipping import EndState, require_held
from .wear import WearSection

if TYPE_CHECKING:
    from ..simulation.simulation import Simulation


def _accuracy(given: Any) -> Any:
    """Check `accuracy`: one relative error in (0, 1), or a table with one for each quantity."""
    values = list(given.values()) if isinstance(given, dict) else [given]
    for value in values or [given]:
        number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if given is not None and not (number and 0 < value < 1):
            raise ValueError(
                "must be a relative error in (0, 1), e.g. 0.01 for 1 %, or a table with one such "
                f"error for each quantity, got {in_short(value)}"
            )
    return given


class Case(CaseFile):
    """Validated case of one contact.

    Use `load_case` to read a case file. Validate a dictionary with the layout of a case file by
    ``Case.model_validate``. All quantities are in SI units.
    """

    title: Annotated[str, Field(min_length=1)]
    description: str = ""
    accuracy: Annotated[float | dict[str, float] | None, BeforeValidator(_accuracy)] = None
    quantities: Annotated[list[str], Field(min_length=1)] | None = None
    max_memory: Annotated[Positive, Unit("byte")] | None = None
    max_time: Annotated[Positive, Unit("s")] | None = None
    estimate_error: bool = True
    grid: GridSection | None = None
    body1: BodySection
    body2: BodySection
    surface: SurfaceSection
    relief1: ReliefSection | None = None
    relief2: ReliefSection | None = None
    dents: DentsSection | None = None
    contact: ContactSection = ContactSection()
    heat: HeatSection | None = None
    path: Annotated[list[Segment], Field(min_length=1)]
    wear: WearSection | None = None
    fatigue: FatigueSection | None = None
    shakedown: ShakedownSection | None = None
    output: OutputSection = OutputSection()

    _cells: Grid | None = PrivateAttr(default=None)

    def on_grid(self, grid: GridSection, **changes: Any) -> Case:
        """Return a copy with another grid; heights given for the cells of [grid] are interpolated.

        changes: new values of further fields.
        """
        case = self.model_copy(update={"grid": grid, **changes})
        if self._cells is None and self.grid is not None:
            case._cells = self.grid.build()
        return case

    @model_validator(mode="before")
    @classmethod
    def _in_full(cls, data: Any) -> Any:
        return in_full(data)

    @model_validator(mode="after")
    def _consistent(self) -> Case:
        self._resolve_loads()
        if self.grid is None and self.accuracy is None:
            object.__setattr__(self, "grid", grid_of_part(self))  # the case is frozen
        if self.grid is None and self.accuracy is None:
            raise ValueError(
                "grid: [grid] is missing: add [grid], or accuracy, e.g. accuracy = 0.01"
            )
        object.__setattr__(self, "path", path_with_loads(self))  # the case is frozen
        bodies = (self.body1, self.body2)
        if all(body.is_rigid for body in bodies):
            raise ValueError("body1 and body2 are both rigid: at least one must be deformable")
        self.surface.on_bodies(*(body.build() for body in bodies))
        for name, body in zip(("body1", "body2"), bodies, strict=True):
            if body.is_plastic and not self.has_volume:
                law = body.inelastic_laws[0]
                raise ValueError(
                    f"{name} is elastic-plastic (law {law}) and requires a grid with layers of "
                    "cells below the surface: set grid.dz"
                )
        require_durations(self)
        if self.has_volume and self.wear is None:
            self._show_a_body_with_stresses()
        require_all_used(self)
        self.steps()
        return self

    def _resolve_loads(self) -> None:
        """Replace each `load_factor` of the path by a load [N], factor times load of the part."""
        path = []
        for index, segment in enumerate(self.path):
            try:
                self.surface.require_path([segment.load])
                path.append(segment.with_load(self.surface.nominal_load(self._given_grid())))
            except ValueError as error:
                raise ValueError(f"path[{index}]: {error}") from error
        object.__setattr__(self, "path", path)  # the case is frozen

    def _given_grid(self) -> Grid | None:
        return None if self.grid is None else self.grid.build()

    def _show_a_body_with_stresses(self) -> None:
        selected = self.output.body
        if not (self.body1, self.body2)[selected - 1].is_rigid:
            return
        other = 3 - selected
        if "body" in self.output.model_fields_set:
            raise ValueError(
                f"output.body: body {selected} is rigid and has no stress field: use "
                f"output.body = {other}, or omit it"
            )
        output = self.output.model_copy(update={"body": other})
        object.__setattr__(self, "output", output)  # the case is frozen

    def steps(self) -> paths.Path:
        """Return the loading path as a list of dictionaries for `Simulation.run`."""
        return [step for steps in self.steps_of_segments() for step in steps]

    def steps_of_segments(self) -> list[paths.Path]:
        """Return, for each segment of the path, its steps as dictionaries for `Simulation.run`."""
        steps: list[paths.Path] = []
        reached = EndState()
        for index, segment in enumerate(self.path):
            try:
                made, reached = segment.steps(reached)
                self._check_motion(made)
            except ValueError as error:
                raise ValueError(f"path[{index}]: {error}") from error
            steps.append(made)
        return steps

    @property
    def study(self) -> str:
        return "" if self.wear is None else "wear"

    @property
    def has_volume(self) -> bool:
        """Whether the grid has layers of cells below the surface; True for an automatic grid."""
        return self.grid is None or self.grid.dz is not None

    @property
    def reason_for_grid(self) -> str:
        """Reason why the field `accuracy` requires [grid] in this case; "" if it does not."""
        return reason_for_grid(self)

    @property
    def sticks(self) -> bool:
        """Whether friction allows partial slip; if not, the contact slides fully."""
        return self.friction.sticks

    @property
    def friction(self) -> FrictionLaw:
        """Friction law of the contact."""
        return law_of_section(self.contact)

    @property
    def relaxes(self) -> bool:
        """Whether a body is viscoelastic."""
        return self.body1.relaxes or self.body2.relaxes

    @property
    def moves(self) -> bool:
        """Whether the surface of a body moves through the contact."""
        return any(both_axes(step["advance"]).any() for step in self.steps() if "advance" in step)

    def _check_motion(self, steps: paths.Path) -> None:
        """Check that the motion agrees with the direction of friction and with heat.velocity."""
        heat = NO_HEAT if self.heat is None else self.heat.build()
        friction = self.friction
        attracts = contact_law_of(self.contact).attracts  # adhesion adds to the friction limit
        for step in steps:
            if friction.sticks and not attracts:
                require_held(step, friction)
            if step.get("load") == 0.0 or "advance" not in step:
                continue
            (first, first_y), (second, second_y) = travels = both_axes(step["advance"]).tolist()
            if not friction.sticks and not friction.is_frictionless and first_y != second_y:
                raise ValueError(
                    "advance along y must be equal for both bodies, because friction acts along x, "
                    f"got {travels}: set friction = 0 to slide along y"
                )
            if friction.sliding_ratio > 0 and first < second:
                raise ValueError(
                    "advance[0] must be >= advance[1], because friction acts on body 2 towards "
                    f"+x, got {[first, second]}: reverse the sliding direction, or set friction = 0"
                )
            if "duration" in step and heat.track is None:
                require_velocity_of_motion(heat, travels, step["duration"])

    def hertz(self, load: float) -> _hertz.PointContact | _hertz.EllipticContact | None:
        """Return the Hertz contact at a load [N] > 0; None if Hertz theory does not apply.

        Hertz theory applies to smooth paraboloids and spheres with finite radii, if the bodies have
        no layers. For viscoelastic bodies, the instantaneous moduli are used.
        """
        radii = self.surface.radii()
        periodic = self.grid is not None and self.grid.periodic
        if self.body1.coating or self.body2.coating or contact_law_of(self.contact).attracts:
            return None
        if self.relief1 is not None or self.relief2 is not None or periodic:
            return None
        if self.dents is not None or self.body1.has_inclusions or self.body2.has_inclusions:
            return None
        if radii is None or self.surface.roughness is not None or not np.all(np.isfinite(radii)):
            return None
        E_star = _hertz.effective_modulus(*map(softest, (self.body1.build(), self.body2.build())))
        if radii[0] == radii[1]:
            return _hertz.point(radii[0], E_star, load=load)
        return _hertz.elliptic(radii[0], radii[1], E_star, load=load)

    def _surface_on(self, grid: Grid, section: Any) -> Any:
        """Return the gap or relief that a section describes, after checking it on the given grid.

        If the surface is defined on every grid, return a function of the grid instead.
        """
        build = partial(section.build, folder=self._source.parent, cells=self._cells)
        built = build(grid)
        return build if section.is_known else built

    def build(self) -> tuple[Simulation, paths.Path]:
        """Create the simulation and its loading path.

        Returns
        -------
        simulation : Simulation
        path : list of dict
            Argument of ``simulation.run(path)``.

        Raises
        ------
        CaseError
            A section does not describe a valid object, e.g. a surface file has the wrong shape.
        """
        from ..problem.moving_topography import relief_rows
        from ..simulation.simulation import Simulation

        section = "grid"
        try:
            if self.grid is None:
                raise ValueError(
                    "[grid] is missing: add [grid], or solve the case with samcontact.to_accuracy"
                )
            grid = self.grid.build()
            # before the surface, which also requires memory, is created
            needed = memory.surface(grid, memory.CONTACT_BYTES + memory.SIMULATION_BYTES)
            memory.require_for_grid("a simulation", grid, needed)
            section = "body1"
            body1 = self.body1.build()
            section = "body2"
            body2 = self.body2.build()
            section = "surface"
            lies_between = {"gap": self._surface_on(grid, self.surface)}
            for section in ("relief1", "relief2"):
                given = getattr(self, section)
                if given is not None:
                    relief = lies_between[section] = self._surface_on(grid, given)
                    relief_rows(section, relief(grid) if callable(relief) else relief, grid)
            section = "heat"
            heat = None if self.heat is None else self.heat.build()
            if heat is not None:
                heating(heat, (body1, body2), grid)
            section = "contact"
            settings = settings_of(self.contact)
            simulation = Simulation(grid, body1, body2, heat=heat, **settings, **lies_between)
            section = "dents"
            prepare(simulation, None if self.dents is None else self.dents.build(settings))
        except (ValueError, ImportError) as error:
            raise CaseError(f"{self._source}: [{section}] {error}") from error
        return simulation, self.steps()

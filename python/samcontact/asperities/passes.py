# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes of one sphere over another, increment by increment."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from .. import energy
from .._util.checks import FloatArray
from ..diagnostics import resolution
from ..simulation.journal import Journal
from ..simulation.simulation import Simulation
from .collision import Collision
from .series import IncrementRow

if TYPE_CHECKING:
    from ..bodies.material import Material

_ROUNDING_ERROR = 1e-9
"""Limit below which a value is attributed to rounding: the ratio approach/interference, or the
relative excess of a distance over a whole number of steps."""


def whole_steps(distance: float) -> int:
    """Round a distance, measured in steps, up to a whole number; rounding errors add no step."""
    return math.ceil(distance * (1.0 - _ROUNDING_ERROR))


class CollisionPasses:
    """Simulation of a collision: position of the spheres, states and plastic work so far."""

    def __init__(
        self,
        collision: Collision,
        simulation: Simulation,
        step: float,
        journal: Journal | None,
        bar: Any,
    ) -> None:
        self.collision, self.simulation, self.step = collision, simulation, step
        self.journal, self.bar = journal, bar
        self.state = self.peak = simulation.state
        self.position = 0  # number of steps from the aligned position
        self.plastic_work = 0.0

    def one_pass(self, direction: int) -> Iterator[IncrementRow]:
        """Iterate over the increments of a pass, from before first contact to final separation."""
        outside = self._outside()
        self._move(-direction * outside, unloaded=True)
        work, before = 0.0, None
        while before is None or before.normal_force > 0 or direction * self.position < outside:
            self._move(self.position + (direction if before is not None else 0))
            row = self._row()
            if before is not None:
                mean = 0.5 * (before.force_x + row.force_x)
                work += mean * (row.offset - before.offset)
            row.work = work
            before = row
            self.bar.update()
            yield row
        self._move(self.position, unloaded=True)
        before.residual_energy = sum(
            energy.residual_energy(self.state.track(body, margin=0)) for body in self._inelastic
        )
        before.residual_displacement = self._deepest(1), self._deepest(2)

    def _deepest(self, body: int) -> float:
        """Maximum residual imprint depth of a body [m]; 0 for an elastic body."""
        if body not in self._inelastic:
            return 0.0
        return float(self.state.track(body, margin=0).residual_displacement().max())

    def _outside(self) -> int:
        """Number of steps from the aligned position after which the rough spheres cannot touch."""
        highest = 0.0
        for body, relief in ((1, self.simulation.relief1), (2, self.simulation.relief2)):
            surface = np.zeros(1) if relief is None else relief.heights
            highest += max(float(surface.max()), 0.0)
            if body in self._inelastic:
                piled = -self.state.track(body, margin=0).residual_displacement()
                highest += max(float(piled.max()), 0.0)
        collision = self.collision
        part = (collision.interference + highest) / (collision.R1 + collision.R2 + highest)
        return whole_steps(2.0 * math.asin(math.sqrt(0.5 * part)) / self.step)

    def _approach(self) -> float:
        """Approach at the current position [m]; rounding errors are set to 0."""
        approach = self.collision.approach(self.position * self.step)
        return 0.0 if abs(approach) < _ROUNDING_ERROR * self.collision.interference else approach

    @property
    def _inelastic(self) -> list[int]:
        bodies = (self.simulation.body1, self.simulation.body2)
        return [number for number, body in enumerate(bodies, 1) if body.is_plastic]

    def _move(self, position: int, unloaded: bool = False) -> None:
        """Move to a position (in steps); solve the increment, or restore it from the checkpoint."""
        distance = (position - self.position) * self.step
        self.position = position
        before = self.state
        if self.journal is None or (kept := self.journal.next()) is None:
            advance = self.collision.advance(distance)
            target: dict[str, Any] = {"load": 0.0} if unloaded else {"approach": self._approach()}
            kept = self.simulation.step(**target, advance=advance)
            if self.journal is not None:
                self.journal.add()
        self.state = kept
        self.peak = max(self.peak, kept, key=lambda state: state.load)
        for body in self._inelastic:
            material = cast("Material", (self.simulation.body1, self.simulation.body2)[body - 1])
            tracks = (s.track(body, margin=0) for s in (self.state, before))
            self.plastic_work += energy.plastic_work(material, *tracks)

    def _row(self) -> IncrementRow:
        state, collision = self.state, self.collision
        layers = [math.nan, math.nan]
        for body in self._inelastic:
            strain = state.equivalent_plastic_strain(body)
            layers[body - 1] = resolution.layers_across(strain)
        angle = self.position * self.step
        tangential = self._tangential(collision.separation(angle))
        sine, cosine = math.sin(angle), math.cos(angle)
        return IncrementRow(
            offset=collision.offset(angle),
            angle=angle,
            approach=self._approach(),
            normal_force=state.load,
            force_x=-state.load * sine + tangential[0] * cosine,
            force_y=tangential[1],
            force_z=state.load * cosine + tangential[0] * sine,
            plastic_work=self.plastic_work,
            max_pressure=float(state.pressure.max()),
            contact_area=state.contact_area,
            max_equivalent_plastic_strain=(
                state.max_equivalent_plastic_strain(1),
                state.max_equivalent_plastic_strain(2),
            ),
            cells_across_contact=resolution.cells_across(state.repulsion),
            layers_across_plastic_zone=(layers[0], layers[1]),
        )

    def _tangential(self, separation: float) -> tuple[float, float]:
        """Force of sphere 1 on sphere 2 along the local x and y [N].

        The pressure acts along the surface normals, which gives tangential forces Q1 and Q2 on the
        spheres. The principle of virtual work gives the resultant (R1 Q1 - R2 Q2)/(distance of the
        centres). The slopes of the elastic displacement give no net force, and the contributions of
        the curvature cancel.
        """
        collision, grid, state = self.collision, self.simulation.grid, self.state
        if state.load == 0:
            return 0.0, 0.0
        total: FloatArray = np.zeros(2)
        for body, lever in ((1, collision.R1), (2, -collision.R2)):
            surface = -state.relief(body)
            if body in self._inelastic:
                surface = surface + state.residual_displacement(body)
            for axis, cell in enumerate((grid.dx, grid.dy)):
                slope = np.gradient(surface, cell, axis=axis)
                total[axis] += lever * float(np.sum(state.pressure * slope)) * grid.cell_area
        return float(total[0] / separation), float(total[1] / separation)

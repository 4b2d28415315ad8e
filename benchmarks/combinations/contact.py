# SPDX-License-Identifier: GPL-3.0-or-later
"""Description of a small contact of a ball, which each capability changes; checks of its states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import samcontact as sc

from ..stability.materials import slip_error
from .film import film_faults

CELLS, LAYERS, SIZE = 16, 10, 40e-6
RADIUS, LOAD, APPROACH = 5e-3, 260.0, 6e-6
SPEED = 0.2
TOL = 1e-5
METHODS = ("residual_stress", "increment_tol")
"""Settings of the indentation, taken from those of the contact."""
Body = sc.Material | sc.Layered | sc.Heterogeneous
Law = sc.Coulomb | sc.Anisotropic | sc.MappedCoulomb | sc.ThermalCoulomb | sc.FallingCoulomb
Law |= sc.ThirdBody
MU = 0.3
"""Largest coefficient of all laws with a finite one."""


@dataclass
class Contact:
    """Description of the contact of a ball and a half-space, with loads and motions."""

    body1: sc.Material = field(default_factory=lambda: sc.Material.elastic(210e9, 0.3))
    body2: sc.Material = field(default_factory=lambda: sc.Material.elastic(210e9, 0.3))
    has_thermal_properties: bool = False
    coating: sc.Material | None = None
    ends: bool = False
    """Whether the upper body ends at a free face inside the contact."""
    relaxes: bool = False
    """Whether the upper body is viscoelastic."""
    inclusion: sc.Material | None = None
    """Material of a spherical inclusion in the lower body."""
    periodic: str = ""
    heights: np.ndarray | None = None
    """Measured heights, which are added to the gap [m]."""
    is_dented: bool = False
    """Whether a hard particle has been pressed into the lower body before."""
    is_enlarged: bool = False
    """Whether the grid is enlarged when the contact reaches its edge."""
    is_lubricated: bool = False
    """Whether a film of oil carries the load."""
    law: float | Law = 0.0
    heat: dict[str, Any] = field(default_factory=dict)
    travels: Sequence[Any] | None = None
    """Distances by which the surfaces travel in each of three increments [m]: along x, or pairs."""
    drive: dict[str, Any] = field(default_factory=dict)
    """Tangential motions or forces in one increment at the full load."""
    pulls: float | None = None
    """Ratio of the tangential load along x to the load, unless `drive` prescribes a motion."""
    prescribes_approach: bool = False
    about: dict[str, tuple[float | None, float | None]] = field(default_factory=dict)
    """Moments or tilts about x and y at the full load or approach."""
    settings: dict[str, Any] = field(default_factory=dict)

    def slips_partially(self) -> None:
        """Use Coulomb friction with partial slip, unless a friction law is set."""
        if self.law == 0.0:
            self.law = sc.Coulomb(MU)

    def bodies(self) -> tuple[Body, Body]:
        """Return both bodies, with thermal properties and coating."""
        body1, body2, coating = self.body1, self.body2, self.coating
        inclusion = self.inclusion
        if self.has_thermal_properties:
            body1, body2 = (body.with_thermal(50.2, 11.7e-6, 1.39e-5) for body in (body1, body2))
            coating = None if coating is None else coating.with_thermal(5.0, 8e-6, 2e-6)
            inclusion = None if inclusion is None else inclusion.with_thermal(30.0, 8e-6, 1e-5)
        if self.relaxes:
            body1 = body1.with_relaxation(times=[1e-4, 1e-2], shares=[0.2, 0.1])
        if self.ends:
            body1 = body1.with_free_faces(high=4 * SIZE)
        if coating is not None:
            body2 = sc.Layered([(coating, SIZE)], body2)
        if inclusion is not None:
            sphere = sc.Inclusion.sphere((0.0, 0.0, 5 * SIZE), 4 * SIZE, inclusion)
            body2 = sc.Heterogeneous(body2, [sphere])
        return body1, body2

    def simulation(self) -> sc.Simulation:
        """Return the simulation before the first increment."""
        grid = sc.Grid(CELLS, CELLS, SIZE, SIZE, LAYERS, SIZE, periodic=self.periodic)
        settings = {"on_border": "error" if self.is_enlarged else "warn"} | self.settings
        if self.heat:
            settings["heat"] = self.heating()
        gap = self.gap if self.is_enlarged else self.gap(grid)
        simulation = sc.Simulation(grid, *self.bodies(), gap, self.law, **settings)
        if self.is_dented:
            self.press_particle(simulation)
        return simulation

    def press_particle(self, simulation: sc.Simulation) -> None:
        """Start the simulation from the dent of a hard particle in the lower body."""
        particle = sc.overrolling.Particle(radius=4e-4, approach=2e-6, x=SIZE)
        chosen = {name: self.settings[name] for name in METHODS if name in self.settings}
        dented = sc.overrolling.indent(
            simulation.grid, simulation.body2, [particle], increments=2, **chosen
        )
        if not dented.residual_displacement().max() > 0.0:
            raise ArithmeticError("the particle leaves no dent")
        sc.overrolling.start_from(simulation, dented)

    def heating(self) -> sc.Heat:
        """Return the heating, with a reference distance if the approach is prescribed."""
        heat = dict(self.heat)
        if self.relaxes and "partition" in heat:
            heat["partition"] = 1.0  # into the elastic body
        if self.prescribes_approach:
            heat["reference"] = 1e-2
        if self.lasts() and self.travels:
            pairs = [travel if np.ndim(travel) else (travel, 0.0) for travel in self.travels]
            heat["velocity"] = [(x / SIZE * SPEED, y / SIZE * SPEED) for x, y in pairs]
        return sc.Heat(**heat)

    def gap(self, grid: sc.Grid) -> np.ndarray:
        """Return the initial gap [m], shape (nx, ny)."""
        gap = sc.surfaces.paraboloid(grid, RADIUS)
        if self.heights is None:
            return gap
        measured = sc.measured.MeasuredSurface(self.heights, dx=SIZE)
        return sc.surfaces.from_heights(grid, measured.on(grid), gap)

    def path(self) -> list[dict[str, Any]]:
        """Return the increments: loading in two steps, tangential drive, motion, unloading."""
        lasting = {"duration": SIZE / SPEED} if self.lasts() or self.relaxes else {}

        def pressed(fraction: float) -> dict[str, Any]:
            name, most = ("approach", APPROACH) if self.prescribes_approach else ("load", LOAD)
            return {name: fraction * most} | lasting | self.turned(fraction)

        drive = dict(self.drive)
        if self.pulls and not self.travels and "shift" not in drive:
            drive.setdefault("tangential_load", (self.pulls * LOAD, 0.0))
        path = [pressed(0.5), pressed(1.0)]
        if drive:
            path.append(pressed(1.0) | drive)
        if self.travels:
            path += [pressed(1.0) | {"advance": self.travels}] * 3
        return [*path, pressed(-0.1 if self.prescribes_approach else 0.0)]

    def turned(self, fraction: float) -> dict[str, Any]:
        """Return moments and tilts at a fraction of the load."""
        return {
            name: tuple(None if value is None else fraction * value for value in pair)
            for name, pair in self.about.items()
        }

    def lasts(self) -> bool:
        """Whether increments have a duration."""
        needed = isinstance(self.law, sc.FallingCoulomb)
        return needed or "history" in self.heat or "partition" in self.heat


def faults(contact: Contact) -> list[str]:
    """Run a contact, and return the conditions that its states violate."""
    simulation = contact.simulation()
    if contact.is_lubricated:
        return film_faults(simulation, contact.path())
    found = set()
    for step in contact.path():
        found |= set(_faults_of(simulation.step(**step), step, contact))
    return sorted(found)


def _faults_of(state: sc.State, step: dict[str, Any], contact: Contact) -> list[str]:
    pressure, gap = state.repulsion, state.gap
    highest = pressure.max()
    conditions = {"finite pressure": bool(np.isfinite(pressure).all())}
    conditions["pressure >= 0"] = bool(pressure.min() >= 0)
    if "load" in step:
        load = state.pressure.sum() * state.grid.cell_area
        conditions["load"] = bool(abs(load - step["load"]) <= 1e-6 * LOAD)
    moment = step.get("moment", (None, None))[0]
    if moment is not None:
        conditions["moment"] = bool(abs(state.moment[0] - moment) <= 1e-6 * LOAD * SIZE)
    if highest > 0:
        closed = np.minimum(pressure / highest, gap / np.abs(gap[np.isfinite(gap)]).max())
        conditions["pressure or gap zero"] = bool(np.abs(closed).max() <= TOL)
    if not isinstance(contact.law, float):
        largest = contact.law.coefficient if isinstance(contact.law, sc.Coulomb) else MU
        excess = slip_error(state, largest)
        conditions["shear below the friction limit"] = excess <= 1e-6
    for body in (1, 2):
        conditions |= _conditions_in(state, body)
    return [name for name, holds in conditions.items() if not holds]


def _conditions_in(state: sc.State, body: int) -> dict[str, bool]:
    """Return the conditions on the plastic strain of a body; none for an elastic body."""
    if not state.equivalent_plastic_strain(body).any():
        return {}
    strain = state.plastic_strain(body)
    volume = np.abs(strain[:3].sum(axis=0)).max()
    return {
        "plastic flow without change of volume": bool(volume <= 1e-9 * np.abs(strain).max()),
        "finite stress": bool(np.isfinite(state.stress(body)).all()),
    }

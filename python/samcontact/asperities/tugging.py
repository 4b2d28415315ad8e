# SPDX-License-Identifier: GPL-3.0-or-later
"""Two spheres that slide past each other: their geometry, and the passes."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import energy, resolution, surfaces
from .._checks import FloatArray, finite, integer, positive
from .._journal import Journal, describe
from .._progress import progress_bar
from .._repr import Brief
from ..contact import require_type
from ..grid import Grid
from ..material import Material
from ..relief import Relief
from ..simulation import Simulation
from ..state import State
from .series import Row, to_dataset

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Collision:
    """Geometry of two spheres, one sliding over the other at a constant height.

    Parameters
    ----------
    R1, R2 : float
        Radii of the upper and the lower sphere [m], > 0.
    interference : float
        Of the undeformed spheres when aligned [m]; > 0 and below both radii.

    Raises
    ------
    ValueError
        A value outside its range.
    """

    R1: float
    R2: float
    interference: float

    def __post_init__(self) -> None:
        for name in ("R1", "R2", "interference"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        smallest = min(self.R1, self.R2)
        if self.interference >= smallest:
            raise ValueError(
                f"interference must be below both radii, < {smallest!r} m, "
                f"got {self.interference!r}"
            )

    @property
    def R(self) -> float:
        """Equivalent radius R1 R2/(R1 + R2) [m]."""
        return self.R1 * self.R2 / (self.R1 + self.R2)

    @property
    def height(self) -> float:
        """Of the centre of sphere 1 above that of sphere 2 [m]."""
        return self.R1 + self.R2 - self.interference

    @property
    def half_angle(self) -> float:
        """Angle of the line of centres from the vertical when the spheres touch [rad]."""
        return 2.0 * math.asin(math.sqrt(0.5 * self.interference / (self.R1 + self.R2)))

    @property
    def half_way(self) -> float:
        """Horizontal distance of the centres when the spheres touch [m]."""
        return self.offset(self.half_angle)

    def offset(self, angle: float) -> float:
        """Horizontal distance X of the centres [m] at an angle of their line from the vertical."""
        return self.height * math.tan(finite("angle", angle))

    def separation(self, angle: float) -> float:
        """Distance of the centres [m]."""
        return self.height / math.cos(finite("angle", angle))

    def approach(self, angle: float) -> float:
        """Approach of the spheres along the line of centres [m]; negative: apart."""
        finite("angle", angle)
        # R1 + R2 - separation without cancellation
        return self.interference - 2.0 * self.height * math.sin(0.5 * angle) ** 2 / math.cos(angle)

    def advance(self, angle: float) -> tuple[float, float]:
        """How far the surfaces move through the contact while the line turns by an angle [m].

        Along the local +x: the contact moves backwards over sphere 1 and forwards over sphere 2.
        """
        return self.R1 * finite("angle", angle), -self.R2 * angle

    def grid(
        self,
        increments: int = 24,
        cells_per_increment: int = 1,
        *,
        width: float = 1.8,
        depth: float = 1.9,
        dy: float = 1.0,
        dz: float = 1.0,
    ) -> Grid:
        """Grid for `tug` whose cells fit its increments.

        Parameters
        ----------
        increments : int
            From touching to parting, >= 4.
        cells_per_increment : int
            Cells that the contact moves over body 2 in each, >= 1.
        width : float
            Half the width of the grid over sqrt(2 R interference), the radius of the disc that the
            undeformed spheres share.
        depth : float
            Of the grid over the same.
        dy, dz : float
            Sizes of a cell over its size along x.
        """
        count = integer("increments", increments, 4)
        parts = integer("cells_per_increment", cells_per_increment, 1)
        dx = self.R2 * 2.0 * self.half_angle / count / parts
        reach = math.sqrt(2.0 * self.R * self.interference)
        half = positive("width", width) * reach
        across, down = positive("dy", dy) * dx, positive("dz", dz) * dx
        nx, ny = (2 * math.ceil(half / cell) + 1 for cell in (dx, across))
        layers = math.ceil(positive("depth", depth) * reach / down)
        return Grid(nx, ny, dx, across, layers, down)


@dataclass(repr=False)
class Tugging(Brief):
    """Result of `tug`."""

    collision: Collision
    simulation: Simulation
    """As it stands after the last pass, unloaded."""
    series: xr.Dataset
    """Of each pass and increment; see `tug`."""
    unloaded: list[State]
    """The bodies after each pass."""


def tug(
    collision: Collision,
    body1: Material,
    body2: Material,
    grid: Grid,
    *,
    passes: int = 1,
    cells_per_increment: int = 1,
    back_and_forth: bool = False,
    relief1: Relief | None = None,
    relief2: Relief | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = True,
    **settings: Any,
) -> Tugging:
    """Slide sphere 1 over sphere 2 once or more often, at the same height.

    Parameters
    ----------
    collision : Collision
        Radii and interference.
    body1, body2 : Material
        Of the upper and the lower sphere; any of them inelastic.
    grid : Grid
        Of the local frame, e.g. from `Collision.grid`; with layers when a body is inelastic.
    passes : int
        How often sphere 1 comes by, >= 1.
    cells_per_increment : int
        How far the contact moves over body 2 in each increment, in cells of dx, >= 1. The cells of
        body 1 are met exactly where R1/R2 times that is a whole number too.
    back_and_forth : bool
        Every second pass in the opposite direction; by default all towards +X.
    relief1, relief2 : Relief, optional
        Roughness of the spheres; its row positions are those of the grid when they are aligned.
    checkpoint : path, optional
        Folder in which to keep each increment. The same call goes on from it, with the same bits as
        without interruption. Remove it when it is no longer needed.
    progress : bool
        Show a progress bar; where there is no terminal, ten lines at most.
    **settings
        Of `Simulation`, e.g. increment_tol, tol (1e-8 by default for elastic spheres),
        residual_stress, reach.

    Returns
    -------
    Tugging
        Its `series` has, by pass and increment: offset, angle, approach, normal_force (along the
        line of centres), force_x, force_y, force_z (by sphere 1 on sphere 2: force_x > 0 resists a
        motion towards +X, force_z > 0 presses), load_ratio force_x/force_z (NaN without contact),
        work of force_x since the start of the pass, plastic_work of both bodies since the start of
        all, max_pressure, contact_area, contact_cells (across it; NaN without contact), and of each
        body max_equivalent_plastic_strain and plastic_layers (NaN without plastic strain). By pass:
        net_energy (the work of the pass), dissipation, residual_energy (after it),
        energy_imbalance (net energy less dissipation and increase of residual energy, the error of
        mesh and increments), and of each body residual_displacement (its maximum).

    Raises
    ------
    ValueError
        A friction or heat setting (the spheres are smooth and cold), a grid whose increment is
        longer than a quarter of the way, or a `checkpoint` of another call; and as `Simulation`.
        An error of a later increment has the result of those before in its attribute `result`; what
        belongs to a pass is NaN in one that has not come to its end.
    """
    require_type("collision", collision, Collision)
    require_type("body1", body1, Material)
    require_type("body2", body2, Material)
    require_type("grid", grid, Grid)
    for name in ("friction", "heat_factor", "heat_history"):
        if settings.get(name):
            raise ValueError(f"{name} must be 0 in tugging, got {settings[name]!r}")
    step = integer("cells_per_increment", cells_per_increment, 1) * grid.dx / collision.R2
    if step > 0.5 * collision.half_angle:
        raise ValueError(
            f"dx must be at most {0.5 * collision.half_angle * collision.R2:.6g} m over "
            f"cells_per_increment, a quarter of the way, got {grid.dx!r}"
        )
    count = integer("passes", passes, 1)
    gap = surfaces.paraboloid(grid, collision.R)
    if not (body1.is_plastic or body2.is_plastic):
        settings = {"tol": 1e-8, **settings}  # a net energy of nothing, at a fifth more work
    simulation = Simulation(grid, body1, body2, gap, relief1=relief1, relief2=relief2, **settings)
    simulation._looks_at_steps = False  # the first ones only touch
    journal = None
    if checkpoint is not None:
        what = describe(simulation, (collision, count, step, back_and_forth))
        journal = Journal(checkpoint, simulation, what)
    rows: list[list[Row]] = []
    unloaded: list[State] = []
    expected = 2 * _steps(collision.half_angle / step) + 1
    with progress_bar(count * expected, "increment", shown=progress) as bar:
        run = _Run(collision, simulation, step, journal, bar)
        try:
            for number in range(count):
                backwards = back_and_forth and number % 2 == 1
                rows.append([])
                for row in run.one_pass(-1 if backwards else 1):
                    rows[-1].append(row)
                unloaded.append(run.state)
        except Exception as error:
            if done := [one for one in rows if one]:
                found = Tugging(collision, simulation, to_dataset(collision, done), unloaded)
                error.result = found  # type: ignore[attr-defined]
            raise
    resolution.warn_of_run([run.peak, run.state], simulation._scene, stacklevel=2)
    return Tugging(collision, simulation, to_dataset(collision, rows), unloaded)


_ROUNDING = 1e-9
"""Relative: what is less does not count as a step, or as an approach."""


def _steps(ways: float) -> int:
    """Whole steps that go at least as far as so many of them; the same in every unit."""
    return math.ceil(ways * (1.0 - _ROUNDING))


class _Run:
    """The bodies, where they stand, and the energy spent so far."""

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
        self.position = 0  # in steps from where the spheres are aligned
        self.plastic_work = 0.0

    def one_pass(self, direction: int) -> Iterator[Row]:
        """From before the spheres touch, until they have parted for good."""
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
        """Largest depth of the print of a body [m]."""
        if body not in self._inelastic:
            return 0.0
        return float(self.state.track(body, margin=0).residual_displacement().max())

    def _outside(self) -> int:
        """Position from which the spheres cannot touch, with what rises above their surface."""
        highest = 0.0
        for body, relief in ((1, self.simulation.relief1), (2, self.simulation.relief2)):
            surface = np.zeros(1) if relief is None else relief.heights
            highest += max(float(surface.max()), 0.0)
            if body in self._inelastic:
                piled = -self.state.track(body, margin=0).residual_displacement()
                highest += max(float(piled.max()), 0.0)
        collision = self.collision
        part = (collision.interference + highest) / (collision.R1 + collision.R2 + highest)
        return _steps(2.0 * math.asin(math.sqrt(0.5 * part)) / self.step)

    def _approach(self) -> float:
        """At the present position; 0 where the spheres only just touch, but for rounding."""
        approach = self.collision.approach(self.position * self.step)
        return 0.0 if abs(approach) < _ROUNDING * self.collision.interference else approach

    @property
    def _inelastic(self) -> list[int]:
        bodies = (self.simulation.body1, self.simulation.body2)
        return [number for number, body in enumerate(bodies, 1) if body.is_plastic]

    def _move(self, position: int, unloaded: bool = False) -> None:
        """One increment, or what a journal kept of it."""
        turn = (position - self.position) * self.step
        self.position = position
        before = self.state
        if self.journal is None or (kept := self.journal.next()) is None:
            advance = self.collision.advance(turn)
            target = {"load": 0.0} if unloaded else {"approach": self._approach()}
            kept = self.simulation.step(**target, advance=advance)
            if self.journal is not None:
                self.journal.add()
        self.state = kept
        self.peak = max(self.peak, kept, key=lambda state: state.load)
        for body in self._inelastic:
            material = (self.simulation.body1, self.simulation.body2)[body - 1]
            tracks = (s.track(body, margin=0) for s in (self.state, before))
            self.plastic_work += energy.plastic_work(material, *tracks)

    def _row(self) -> Row:
        state, collision = self.state, self.collision
        layers = [math.nan, math.nan]
        for body in self._inelastic:
            strain = state.equivalent_plastic_strain(body)
            layers[body - 1] = resolution.layers_across(strain)
        angle = self.position * self.step
        tangential = self._tangential(collision.separation(angle))
        sine, cosine = math.sin(angle), math.cos(angle)
        return Row(
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
            contact_cells=resolution.cells_across(state.pressure),
            plastic_layers=(layers[0], layers[1]),
        )

    def _tangential(self, separation: float) -> tuple[float, float]:
        """Force by sphere 1 on sphere 2 along the local x and y [N].

        The pressure acts along the normals of both surfaces. Their slopes by elastic displacement
        exert no resultant, and those by curvature cancel in the sum that the principle of virtual
        work gives, (R1 Q1 - R2 Q2)/(distance of the centres).
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

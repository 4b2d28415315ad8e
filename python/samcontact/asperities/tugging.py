# SPDX-License-Identifier: GPL-3.0-or-later
"""One or more passes of a sphere over another."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .. import surfaces
from .._util.checks import boolean, integer, require_type
from .._util.display import Brief
from .._util.progress import progress_bar
from ..bodies.layered import require_homogeneous
from ..bodies.material import Material
from ..diagnostics import resolution
from ..scene.grid import Grid
from ..scene.moving_topography import Relief
from ..simulation.journal import journal_of
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .collision import Collision
from .passes import Passes, whole_steps
from .series import Row, to_dataset

if TYPE_CHECKING:
    import xarray as xr


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
    boolean("progress", progress)
    boolean("back_and_forth", back_and_forth)
    require_type("collision", collision, Collision)
    require_homogeneous("asperities that tug are homogeneous", body1, body2)
    require_type("grid", grid, Grid)
    for name in ("friction", "heat"):
        if settings.get(name):
            raise ValueError(f"{name} must be left out in tugging, got {settings[name]!r}")
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
    simulation.monitor.checks_steps = False  # the first ones only touch
    simulation.monitor.checks_increments = False
    way = {"passes": count, "step": step, "back_and_forth": back_and_forth}
    rows: list[list[Row]] = []
    unloaded: list[State] = []
    expected = 2 * whole_steps(collision.half_angle / step) + 1
    with (
        journal_of(checkpoint, simulation.engine, collision=collision, **way) as journal,
        progress_bar(count * expected, "increment", shown=progress) as bar,
    ):
        run = Passes(collision, simulation, step, journal, bar)
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
    resolution.warn_of_run([run.peak, run.state], simulation.engine.estimate, stacklevel=2)
    return Tugging(collision, simulation, to_dataset(collision, rows), unloaded)

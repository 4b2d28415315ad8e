# SPDX-License-Identifier: GPL-3.0-or-later
"""One or more passes of one sphere over another."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .. import surfaces
from .._util.checks import boolean, integer, require_type
from .._util.display import ShortRepr
from .._util.errors import attach
from .._util.progress import progress_bar
from ..bodies.layered import require_homogeneous
from ..bodies.material import Material
from ..bodies.viscoelastic import require_no_relaxation
from ..diagnostics import resolution
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..simulation.journal import journal_of
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .collision import Collision
from .passes import CollisionPasses, whole_steps
from .series import IncrementRow, to_dataset

if TYPE_CHECKING:
    import xarray as xr


@dataclass(repr=False)
class CollisionResult(ShortRepr):
    """Result of an asperity collision, returned by `collide`."""

    collision: Collision
    simulation: Simulation
    """Simulation after the last pass, with unloaded bodies."""
    series: xr.Dataset
    """Results of each pass and increment; see `collide`."""
    unloaded: list[State]
    """States of the unloaded bodies after each pass."""


def _require_possible_bodies(*bodies: Any) -> None:
    require_homogeneous("asperity collision does not support layered bodies", *bodies)
    require_no_relaxation("asperity collisions have no duration", *bodies)


def collide(
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
) -> CollisionResult:
    """Slide sphere 1 over sphere 2 at constant height, in one or more passes.

    Parameters
    ----------
    collision : Collision
        Radii and interference of the spheres.
    body1, body2 : Material
        Materials of the upper and the lower sphere; either may be elastic-plastic.
    grid : Grid
        Grid of the local frame, e.g. from `Collision.grid`; with layers if a body is
        elastic-plastic.
    passes : int
        Number of passes of sphere 1, >= 1.
    cells_per_increment : int
        Displacement of the contact over body 2 per increment, in cells of size dx, >= 1. The
        displacement over body 1 is also a whole number of cells if R1/R2 times this number is an
        integer.
    back_and_forth : bool
        Whether every second pass is in the opposite direction. By default, all passes are towards
        +X.
    relief1, relief2 : Relief, optional
        Roughness of the spheres. When one sphere is exactly above the other, the points of the
        roughness heights coincide with cell centres.
    checkpoint : path, optional
        Folder for a checkpoint of each increment. Repeating the call resumes from this folder, with
        bit-identical results. Delete the folder when it is no longer needed.
    progress : bool
        Show a progress bar, or at most ten lines if there is no terminal.
    **settings
        Further arguments of `Simulation`, e.g. increment_tol, tol (default for elastic spheres:
        1e-8), residual_stress, reach.

    Returns
    -------
    CollisionResult
        Results of all passes. `series` has, for each pass and increment: offset, angle, approach,
        normal_force (along the line of centres), force_x, force_y, force_z (of sphere 1 on sphere
        2: force_x > 0 resists motion towards +X, force_z > 0 is compressive), load_ratio
        force_x/force_z (NaN without contact), work of force_x since the start of the pass,
        plastic_work of both bodies since the start of the first pass, max_pressure, contact_area,
        cells_across_contact (NaN without contact), and for each body max_equivalent_plastic_strain
        and layers_across_plastic_zone (NaN without plastic strain). For each pass, it has:
        net_energy (work of the pass), dissipation, residual_energy (after the pass),
        energy_imbalance (net energy minus dissipation and increase of residual energy: the error
        due to grid and increments), and for each body residual_displacement (maximum of the field).

    Raises
    ------
    ValueError
        A setting for friction or heat is given (the spheres are frictionless and unheated),
        increments are longer than a quarter of the contact path, or a call with different arguments
        wrote `checkpoint`. The errors of `Simulation` are also raised. If an increment fails after
        others were completed, the attribute `result` of the error has the results of the completed
        increments; quantities per pass are NaN for an incomplete pass.
    """
    boolean("progress", progress)
    boolean("back_and_forth", back_and_forth)
    require_type("collision", collision, Collision)
    _require_possible_bodies(body1, body2)
    require_type("grid", grid, Grid)
    for name in ("friction", "heat"):
        if given := settings.get(name):
            raise ValueError(f"{name} is not supported in asperity collisions, got {given!r}")
    step = integer("cells_per_increment", cells_per_increment, 1) * grid.dx / collision.R2
    if step > 0.5 * collision.half_angle:
        raise ValueError(
            f"dx must be <= {0.5 * collision.half_angle * collision.R2:.6g} m (a quarter "
            f"of the contact path, divided by cells_per_increment), got {grid.dx!r} m: use "
            "smaller cells"
        )
    count = integer("passes", passes, 1)
    gap = surfaces.paraboloid(grid, collision.R)
    if not (body1.is_plastic or body2.is_plastic):
        settings = {"tol": 1e-8, **settings}  # net energy close to 0; 20 % more work
    simulation = Simulation(grid, body1, body2, gap, relief1=relief1, relief2=relief2, **settings)
    simulation.monitor.checks_steps = False  # no warning of few cells at first contact
    simulation.monitor.checks_increments = False
    arguments = {"passes": count, "step": step, "back_and_forth": back_and_forth}
    rows: list[list[IncrementRow]] = []
    unloaded: list[State] = []
    expected = 2 * whole_steps(collision.half_angle / step) + 1
    with (
        journal_of(checkpoint, simulation.engine, collision=collision, **arguments) as journal,
        progress_bar(count * expected, "increment", shown=progress) as bar,
    ):
        run = CollisionPasses(collision, simulation, step, journal, bar)
        try:
            for number in range(count):
                backwards = back_and_forth and number % 2 == 1
                rows.append([])
                for row in run.one_pass(-1 if backwards else 1):
                    rows[-1].append(row)
                unloaded.append(run.state)
        except Exception as error:
            if done := [one for one in rows if one]:
                part = CollisionResult(collision, simulation, to_dataset(collision, done), unloaded)
                attach(error, result=part)
            raise
    resolution.warn_of_run([run.peak, run.state], simulation.engine.estimate, stacklevel=2)
    return CollisionResult(collision, simulation, to_dataset(collision, rows), unloaded)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Main kinds of contact problem ("jobs"), each solved with increasing numbers of cells.

In two jobs, `rough` and `zones`, the number of cells increases with the area of a surface of equal
roughness, which then has more contact spots. In the other jobs the cells become finer. The size of
elastic jobs and of `zones` is the number of surface cells; for the other jobs, of volume cells.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

import samcontact as sc

from .. import elastic_rough, shared_cases, slip
from ..harness import Meter, work_of
from ..plastic_zones import HARDNESS, SLOPE
from ..rolling import CERAMIC, CONTACT_RADIUS, LOAD, RADIUS
from ..steel import ELASTIC, STEEL, balls
from ..steel import LOAD as OF_BALLS

CELL = 1e-6  # m; cell size of rough surfaces
ELASTIC_PRESSURE = 1.7e8  # Pa; mean pressure for a contact fraction of about 1/20
PLASTIC_PRESSURE = 0.05 * HARDNESS
STEPS = 8


MAX_EXPONENT = 1.15
"""Upper limit of the exponent of time over all sizes."""


class Job(NamedTuple):
    """Kind of contact problem, solved by the named function for each of its sizes.

    The sizes cover three decades of cells. `stated` is the limit of the memory per cell at the
    largest size [bytes]; `exponent` is the limit of the exponent of time over all sizes.
    """

    name: str
    function: str
    unit: str
    sizes: tuple[int, ...]
    stated: float
    exponent: float = MAX_EXPONENT


SURFACES = (64, 128, 256, 512, 1024, 2048)
RADII = (8, 12, 16, 24, 32, 48, 64, 80)
JOBS = (
    Job("elastic rough contact, finer cells", "finer", "surface", SURFACES, 120),
    Job("elastic rough contact, larger surface", "rough", "surface", SURFACES, 120),
    Job("partial slip to 1e-4", "slipping", "surface", SURFACES, 500),
    Job("partial slip to 1e-6", "slipping_fine", "surface", SURFACES, 500),
    Job(
        "elastic-plastic rough contact, subdomains", "zones", "surface", (32, *SURFACES[:-1]), 1700
    ),
    Job("elastic-plastic ball", "ball", "volume", RADII, 400),
    Job("rolling elastic-plastic ball", "rolling", "volume", (4, 6, 8, 12, 16, 24, 32, 40), 500),
    Job("elastic-plastic coated body", "coated", "volume", RADII, 300),
    Job("viscoelastic increments", "viscoelastic", "surface", SURFACES, 1000),
    Job("adhesive contact", "adhesive", "surface", SURFACES, 1000, 1.3),
    Job("film", "film", "surface", (24, 48, 96, 192, 384, 768), 8000, 1.4),
    Job("inclusion", "included", "volume", (3, 4, 6, 8, 12, 16, 24, 30), 10000),
)


def surface(n: int) -> tuple[sc.Grid, np.ndarray]:
    """Return grid and gap of a periodic rough flat, self-affine with waves of 8 to 32 cells."""
    grid = sc.Grid(n, n, CELL, CELL, dz=CELL, periodic="xy")
    rough = sc.surfaces.rough_self_affine(
        grid, 1e-6, 0.8, wavelength_min=8 * CELL, roll_off=32 * CELL, seed=7
    )
    slopes = np.gradient(rough, CELL)
    return grid, rough * SLOPE / np.sqrt(np.mean(slopes[0] ** 2 + slopes[1] ** 2))


def finer(meter: Meter, n: int) -> dict[str, Any]:
    """Solve elastic contact of a crowned rough surface with n x n cells, to a tolerance of 1e-8."""
    found = elastic_rough.contact(meter, n, "tol 1e-8")
    return {"cells": n * n, "contact": float(np.mean(found.pressure > 0)), "transforms": found.work}


def rough(meter: Meter, n: int) -> dict[str, Any]:
    """Solve elastic contact of a periodic rough surface, to the default tolerance."""
    grid, gap = surface(n)
    load = ELASTIC_PRESSURE * (n * CELL) ** 2
    found = meter(lambda: sc.ContactSolver(grid, ELASTIC, ELASTIC).solve(gap, load=load))
    share = float(np.mean(found.pressure > 0))
    return {"cells": n * n, "contact": share, "transforms": found.work}


def zones(meter: Meter, n: int) -> dict[str, Any]:
    """Press a rigid rough surface onto steel in two increments; spots yield in separate zones."""
    grid, gap = surface(n)
    load = PLASTIC_PRESSURE * (n * CELL) ** 2

    def press() -> tuple[sc.Simulation, sc.State]:
        made = sc.Simulation(grid, sc.Material.rigid(), STEEL, gap, tol=1e-3, zones="auto")
        return made, [made.step(load=part * load) for part in (0.5, 1.0)][-1]

    simulation, state = meter(press)
    share = float(np.mean(state.pressure > 0))
    more = {"contact": share, "plastic_cells": state.plastic_cells(), "layers": len(state.depths)}
    more["increments"] = 2
    return {"cells": n * n, **more, **work_of(simulation)}


def slipping(meter: Meter, n: int, method: str = "tol 1e-4") -> dict[str, Any]:
    """Press a ball, then load it tangentially by half of the friction limit."""
    found = slip.solve(meter, n, 0.5, method)
    return {"cells": n * n, "transforms": found["work"] + found["shear_work"]}


def slipping_fine(meter: Meter, n: int) -> dict[str, Any]:
    """Solve the contact of `slipping` to a smaller tolerance."""
    return slipping(meter, n, "tol 1e-6")


def ball(meter: Meter, n: int) -> dict[str, Any]:
    """Load two balls to 1500 N in three increments and unload, with `n` cells per Hertz radius."""

    def press() -> sc.Simulation:
        simulation = balls(n)
        for part in (1 / 3, 2 / 3, 1.0, 0.0):
            simulation.step(load=part * OF_BALLS)
        return simulation

    simulation = meter(press)
    grid = simulation.grid
    return {"cells": grid.nx * grid.ny * grid.nz, **work_of(simulation)}


def rolling(meter: Meter, n: int) -> dict[str, Any]:
    """Load a ball and roll it in steps of a quarter of the Hertz radius, which is `n` cells."""
    d = CONTACT_RADIUS / n
    grid = sc.Grid(5 * n + 1, 4 * n + 1, d, d, int(2.2 * n), d)
    step = {"load": LOAD, "advance": (-0.25 * CONTACT_RADIUS, -0.25 * CONTACT_RADIUS)}
    path = [{"load": LOAD * k / 4} for k in range(1, 5)] + [step] * STEPS

    def roll() -> sc.Simulation:
        gap = sc.surfaces.paraboloid(grid, RADIUS)
        simulation = sc.Simulation(grid, CERAMIC, STEEL, gap, residual_stress="fast")
        simulation.run(path, progress=False)
        return simulation

    simulation = meter(roll)
    return {"cells": grid.nx * grid.ny * grid.nz, **work_of(simulation)}


def coated(meter: Meter, n: int) -> dict[str, Any]:
    """Press a rigid ball, in two increments, on a hard elastic coating on elastic-plastic steel.

    The coating is a quarter as thick as the contact radius.
    """
    load, radius = 900.0, 10e-3
    modulus = sc.hertz.effective_modulus(sc.Material.rigid(), STEEL)
    d = sc.hertz.point(radius, modulus, load=load).a / n
    across = 2 * int(1.3 * n) + 1
    grid = sc.Grid(across, across, d, d, dz=d)
    body = sc.Layered(((sc.Material.elastic(300e9, 0.25), n // 4 * d),), STEEL)

    def press() -> tuple[sc.Simulation, sc.State]:
        gap = sc.surfaces.paraboloid(grid, radius)
        simulation = sc.Simulation(grid, sc.Material.rigid(), body, gap)
        return simulation, [simulation.step(load=part * load) for part in (0.5, 1.0)][-1]

    simulation, state = meter(press)
    return {"cells": across * across * len(state.depths), **work_of(simulation)}


def viscoelastic(meter: Meter, n: int) -> dict[str, Any]:
    """Press a rigid ball on a viscoelastic body with eight terms, in eleven increments."""
    states = meter(shared_cases.viscoelastic(n).follow)
    return {"cells": n * n, "contact_iterations": sum(one.contact_iterations for one in states)}


def adhesive(meter: Meter, n: int) -> dict[str, Any]:
    """Press a rigid ball on a soft body that attracts it, and retract it, in four steps."""
    found = shared_cases.adhesive(meter, n)
    return {"cells": n * n, "transforms": sum(one.work for one in found)}


def film(meter: Meter, n: int) -> dict[str, Any]:
    """Solve a steady film of a ball at 0.5 GPa."""
    last = shared_cases.film(meter, n).levels[-1]
    return {"cells": n * n, "newton_steps": last.iterations, "krylov_steps": last.krylov_steps}


def included(meter: Meter, n: int) -> dict[str, Any]:
    """Press a ball on steel with a stiff sphere of n cells radius below its centre.

    The cells are those of the box around the sphere.
    """
    states = meter(shared_cases.included(n).follow)
    return {"cells": (2 * n) ** 3, "volume_applications": sum(one.iterations for one in states)}


def measure(meter: Meter, job: str, n: int) -> dict[str, Any]:
    """Run the job with this function name, after a run at the smallest size to load libraries."""
    function = globals()[job]
    (smallest,) = (known.sizes[0] for known in JOBS if known.function == job)
    function(Meter(), smallest)
    found: dict[str, Any] = function(meter, n)
    return found

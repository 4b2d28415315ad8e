# SPDX-License-Identifier: GPL-3.0-or-later
"""Main jobs, each solved from the start, with what its iterations need."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

import samcontact as sc

from .. import elastic_rough, heat, shared_cases, slip
from ..harness import Meter
from ..plastic_zones import HARDNESS
from ..rolling import CERAMIC, CONTACT_RADIUS, LOAD, RADIUS
from ..scale import jobs as scale
from ..steel import ELASTIC, STEEL, balls, hertz
from ..steel import LOAD as OF_BALLS
from . import needs
from .needs import NOTHING, Need

MARGIN = 6
"""Cells around a subdomain."""
SPACINGS = (2, 8)
"""Spacings of the nodes of the middle and of the far band [cells]."""


class Found(NamedTuple):
    """Need and counts of a solution."""

    need: Need
    working_set: float
    """Size of the spectra that an iteration passes over [bytes]."""
    counts: str
    first: float = 1.0
    """Share of the processor time that the first increment took, with the set-up."""


class Steps(NamedTuple):
    """Increments of a simulation, with the share of the first one in the time."""

    simulation: sc.Simulation
    states: list[sc.State]
    first: float


class Job(NamedTuple):
    """Job, solved by `solve` for each of its sizes."""

    name: str
    solve: Callable[[Meter, int], Found]
    sizes: tuple[int, ...]


def stepped(
    meter: Meter, made: Callable[[], sc.Simulation], path: Sequence[dict[str, Any]]
) -> Steps:
    """Set up a simulation and run its path."""

    def run() -> Steps:
        start = time.process_time()
        simulation = made()
        states = [simulation.step(**path[0])]
        first = time.process_time() - start
        states += [simulation.step(**step) for step in path[1:]]
        return Steps(simulation, states, first / (time.process_time() - start))

    return meter(run)


def plane_bytes(nx: int, ny: int, *, padded: bool) -> float:
    """Return the size of the spectra of a plane and of its coefficients [bytes]."""
    return 24.0 * needs.spectrum(nx, ny, padded=padded)


def surface(found: sc.ContactSolution, tangential: float = 0.0) -> Found:
    """Return the need of an elastic solution; tangential: work of its shear."""
    grid = found.grid
    padded = not grid.periodic
    n = grid.nx, grid.ny
    one = needs.displacement(*n, padded=padded)
    need = needs.surface_setup(*n, padded=padded).plus(one.times(found.work + 2 * tangential))
    shown = f"{found.work:.1f} displacements"
    if tangential:
        need = need.plus(needs.surface_setup(*n, padded=padded).times(2))
        shown += f", {tangential:.1f} tangential"
    return Found(need, plane_bytes(*n, padded=padded), shown)


def smooth(meter: Meter, n: int) -> Found:
    """Press two balls; the contact covers four fifths of the grid."""
    d = 2 * hertz().a / (0.8 * n)
    grid = sc.Grid(n, n, d, d)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    return surface(
        meter(lambda: sc.ContactSolver(grid, ELASTIC, ELASTIC).solve(gap, load=OF_BALLS))
    )


def rough(meter: Meter, n: int) -> Found:
    return surface(elastic_rough.contact(meter, n, "tol 1e-8"))


def sliding(meter: Meter, n: int) -> Found:
    """Press a ball, then load it by half of the friction limit, to 1e-6."""
    grid, body, gap, load = slip.ball(n, n, slip.RADIUS)
    force = (0.5 * slip.MU * load, 0.0)
    found = meter(
        lambda: sc.ContactSolver(grid, body, body, sc.Coulomb(slip.MU), tol=1e-6).solve(
            gap, load=load, tangential_load=force
        )
    )
    return surface(found, found.tangential_work)


def heated(meter: Meter, n: int) -> Found:
    """Press a ball that slides at 0.1 m/s; the operators are built in the measured time."""
    d = 2.6 * hertz().a / n
    grid = sc.Grid(n, n, d, d)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    warm = ELASTIC.with_thermal(**heat.THERMAL)
    moving = heat.HEAT_CASES["moving, 0.1 m/s"]
    found = surface(
        meter(lambda: sc.ContactSolver(grid, ELASTIC, warm, heat=moving).solve(gap, load=OF_BALLS))
    )
    return found._replace(need=found.need.plus(needs.surface_setup(n, n, padded=True)))


def adhesive(meter: Meter, n: int) -> Found:
    """Press a rigid ball on a soft body that attracts it, and retract it."""
    work = sum(one.work for one in shared_cases.adhesive(meter, n))
    one = needs.displacement(n, n, padded=True)
    need = needs.surface_setup(n, n, padded=True).plus(one.times(work))
    return Found(need, plane_bytes(n, n, padded=True), f"{work:.1f} displacements")


def film(meter: Meter, n: int) -> Found:
    """Solve a steady film of a ball."""
    found = shared_cases.film(meter, n)
    need = needs.surface_setup(n, n, padded=True)
    for level in found.levels:
        cells = level.cells[0] * level.cells[1]
        need = need.plus(
            needs.displacement(*level.cells, padded=True).times(level.operator_applications),
            needs.dissection(cells).times(level.iterations),
            needs.substitution(cells).times(level.krylov_steps),
        )
    last = found.levels[-1]
    shown = (
        f"{last.iterations} decompositions, {last.krylov_steps} substitutions, "
        f"{last.operator_applications:.0f} displacements on the finest grid"
    )
    return Found(need, 8.0 * needs.factors(n * n), shown)


def box_around(cells: np.ndarray) -> tuple[int, ...]:
    """Return the numbers of cells of the box around the given cells; ones if there are none."""
    if not cells.any():
        return (1,) * cells.ndim
    return tuple(int(np.ptp(index)) + 1 for index in np.nonzero(cells))


def contacts(steps: Steps) -> Need:
    """Return the need of the contacts of increments.

    Each solution needs a displacement of the grid, and each iteration one and its preconditioner
    on the box around the contact.
    """
    grid = steps.simulation.grid
    padded = not grid.periodic
    need = needs.surface_setup(grid.nx, grid.ny, padded=padded).plus(
        needs.displacement(grid.nx, grid.ny, padded=padded).times(
            steps.simulation.counters["contact_solves"]
        )
    )
    for state in steps.states:
        near = needs.displacement(*box_around(state.pressure > 0), padded=False)
        need = need.plus(near.times(2 * state.contact_iterations))
    return need


def flow(steps: Steps, share: float) -> Found:
    """Return the need of increments with plastic flow of body 2.

    share: of the box that is solved, because of mirror planes.
    """
    need = contacts(steps)
    for state in steps.states:
        box = box_around(state.equivalent_plastic_strain(2) > 0)
        need = need.plus(needs.volume(box, padded=True).times(share * state.iterations))
    need = need.plus(needs.volume_setup(box))
    size = 16 * (2 * needs.STRAINS + needs.TENSOR) * box[2]
    return Found(
        need, share * size * needs.spectrum(*box[:2], padded=True), shown(steps, box), steps.first
    )


def shown(steps: Steps, box: Sequence[int]) -> str:
    count = sum(state.iterations for state in steps.states)
    return f"{count} evaluations of the volume, last box {' × '.join(map(str, box))}"


def ball(meter: Meter, n: int) -> Found:
    """Load two balls in three increments and unload, with n cells per Hertz radius."""
    path = [{"load": part * OF_BALLS} for part in (1 / 3, 2 / 3, 1.0, 0.0)]
    return flow(stepped(meter, lambda: balls(n), path), share=0.25)


def rolling(meter: Meter, n: int) -> Found:
    """Load a ball and roll it over two contact radii in eight steps."""
    d = CONTACT_RADIUS / n
    grid = sc.Grid(5 * n + 1, 4 * n + 1, d, d, int(2.2 * n), d)
    advance = {"load": LOAD, "advance": (-0.25 * CONTACT_RADIUS, -0.25 * CONTACT_RADIUS)}
    path: list[dict[str, Any]] = [{"load": LOAD * k / 4} for k in range(1, 5)]
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    made = stepped(meter, lambda: sc.Simulation(grid, CERAMIC, STEEL, gap), path + [advance] * 8)
    return flow(made, share=0.5)


def layered(meter: Meter, n: int) -> Found:
    """Press a rigid ball on a hard coating on steel that yields."""
    load, radius, rigid = 900.0, 10e-3, sc.Material.rigid()
    d = sc.hertz.point(radius, sc.hertz.effective_modulus(rigid, STEEL), load=load).a / n
    across = 2 * int(1.3 * n) + 1
    grid = sc.Grid(across, across, d, d, dz=d)
    body = sc.Layered(((sc.Material.elastic(300e9, 0.25), n // 4 * d),), STEEL)
    gap = sc.surfaces.paraboloid(grid, radius)
    path = [{"load": part * load} for part in (0.5, 1.0)]
    return flow(stepped(meter, lambda: sc.Simulation(grid, rigid, body, gap), path), share=0.25)


def included(meter: Meter, n: int) -> Found:
    """Press a ball on steel with a stiff sphere below its centre, of n cells radius."""
    steps = stepped(meter, *shared_cases.included(n))
    box = (2 * n, 2 * n, 2 * n)
    one = needs.volume(box, padded=True, components=needs.TENSOR)
    need = contacts(steps)
    for state in steps.states:
        source = box_around(state.pressure > 0)
        each = one.plus(needs.tractions(box, source)).times(0.25)
        need = need.plus(each.times(state.iterations))
    need = need.plus(needs.volume_setup(box), needs.tractions_setup(box, source))
    size = 16 * 3 * needs.TENSOR * box[2] * needs.spectrum(*box[:2], padded=True) / 4
    return Found(need, size, shown(steps, box), steps.first)


def zones(meter: Meter, n: int) -> Found:
    """Press a rigid, periodic rough surface on steel in two increments; 1 % is in contact."""
    grid, gap = scale.surface(n)
    load = 0.01 * HARDNESS * (n * scale.CELL) ** 2
    path = [{"load": part * load} for part in (0.5, 1.0)]

    def made() -> sc.Simulation:
        return sc.Simulation(grid, sc.Material.rigid(), STEEL, gap, tol=1e-3, zones="auto")

    steps = stepped(meter, made, path)
    need = contacts(steps)
    for state in steps.states:
        boxes = [zone.shape for zone in state.zones(2)]
        need = need.plus(of_zones(boxes, n).times(state.iterations))
    count = sum(state.iterations for state in steps.states)
    cells = sum(float(np.prod(box)) for box in boxes)
    text = f"{count} evaluations of the volume, {len(boxes)} subdomains of {cells:.0f} cells"
    return Found(need, 8.0 * (2 * needs.STRAINS + needs.TENSOR) * cells, text, steps.first)


def of_zones(boxes: Sequence[tuple[int, int, int]], n: int) -> Need:
    """Return the need of one evaluation: near bands with margins, middle and far band."""
    if len(boxes) == 1:
        return needs.volume(boxes[0], padded=False)
    once = NOTHING
    for nx, ny, nz in boxes:
        once = once.plus(needs.volume((nx + 2 * MARGIN, ny + 2 * MARGIN, nz), padded=False))
    deepest = max((box[2] for box in boxes), default=0)
    planes = [(n / spacing, n / spacing, deepest) for spacing in SPACINGS]
    return once.plus(*[needs.volume(plane, padded=False) for plane in planes])


def viscoelastic(meter: Meter, n: int) -> Found:
    """Press a rigid ball on a viscoelastic body."""
    steps = stepped(meter, *shared_cases.viscoelastic(n))
    need = contacts(steps)
    for state in steps.states:
        values = shared_cases.RELAXATION_TERMS * float(
            np.prod(box_around(state.pressure > 0))
        )  # of the memory
        need = need.plus(needs.displacement(n, n, padded=True), Need(4 * values, 16 * values))
    count = sum(state.contact_iterations for state in steps.states)
    text = f"{count} iterations of the contact in {len(steps.states)} increments"
    return Found(need, plane_bytes(n, n, padded=True), text, steps.first)


JOBS = (
    Job("elastic smooth contact", smooth, (64, 256, 1024)),
    Job("elastic rough contact", rough, (64, 256, 1024)),
    Job("partial slip to 1e-6", sliding, (64, 256, 512)),
    Job("ball that yields", ball, (8, 24, 40)),
    Job("rough contact that yields, subdomains", zones, (64, 256)),
    Job("rolling ball that yields", rolling, (6, 12)),
    Job("layered body that yields", layered, (8, 24, 40)),
    Job("heated contact", heated, (65, 257)),
    Job("viscoelastic increments", viscoelastic, (64, 256)),
    Job("adhesive contact", adhesive, (64, 256)),
    Job("film", film, (32, 128)),
    Job("inclusion", included, (4, 12)),
)
BY_NAME = {job.solve.__name__: job for job in JOBS}

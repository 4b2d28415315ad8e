# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations of a rigid sphere that flattens a half-space, for a range of interferences."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

import samcontact as sc

from ..bodies import RIGID, tolerance

E, NU, RADIUS = 210e9, 0.3, 10e-3
YIELD = 1e-4 * E
E_STAR = E / (1.0 - NU**2)
CRITICAL = sc.critical.kogut_etsion(RADIUS, E_STAR, NU, YIELD)
# steps of 10 to 15 %, including all interferences shown or compared
RATIOS = np.array(
    [1.2, 1.35, 1.5, 1.75, 2, 2.3, 2.6, 3, 3.5, 4, 4.5, 5, 5.5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18,
     20, 23, 26, 28, 30, 34, 40, 46, 52, 60, 70, 80, 95, 110]
)  # fmt: skip
RATIOS_QUICK = np.array([1.5, 2, 3, 4, 6, 8, 10, 14, 20, 28, 30, 40, 60, 80, 110])
RANGES = (1.0, 4.0, 14.0, 40.0, 110.0)
FRICTION = (0.0, 0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5)
FRICTION_QUICK = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)


@dataclass(frozen=True)
class Point:
    """Results at one interference, divided by the critical values; strain divided by Y/E."""

    ratio: float
    load: float
    area: float
    strain: float
    cells: float
    """Number of cells per contact radius."""
    substeps: int
    core: float
    """Elastic area between surface and plastic zone in the plane y = 0, x >= 0, over a_c^2."""
    top: tuple[float, float]
    """Depths over a_c of the upper and lower end of the plastic zone on the axis."""
    outline: tuple[np.ndarray, np.ndarray, np.ndarray]
    """Positions x and z divided by a_c, and plastic strain, in the plane y = 0, x >= 0."""


@dataclass(frozen=True)
class Surface:
    """Interference at which the plastic zone reaches the surface."""

    friction: float
    cells: int
    layers: tuple[float, float]
    """Interference ratios at which the first and the second layer of cells yield."""

    @property
    def ratio(self) -> float:
        """Interference ratio at which the surface begins to yield (linear extrapolation)."""
        return 1.5 * self.layers[0] - 0.5 * self.layers[1]


@dataclass(frozen=True)
class Results:
    points: list[Point]
    surface: list[Surface]
    """Results by friction coefficient."""
    study: list[Surface]
    """Results without friction on other meshes."""
    cells: int

    def at(self, ratio: float) -> Point:
        return min(self.points, key=lambda point: abs(point.ratio - ratio))


def compute(quick: bool) -> Results:
    """Solve all cases of the page, on coarse grids if quick."""
    cells, per_critical, study = (14, 6, ()) if quick else (28, 12, (6, 9, 16))

    def path(friction: float) -> tuple[int, float]:
        return (36, 4.0) if quick and friction > 0 else (80, 6.0)

    points = []
    for above, top in pairwise(RANGES):
        points += flatten(above, top, cells, 1 if quick else 3, tolerance(quick))
    return Results(
        points,
        [
            reach_surface(mu, per_critical, *path(mu))
            for mu in (FRICTION_QUICK if quick else FRICTION)
        ],
        [reach_surface(0.0, count, 80, 6.0) for count in study],
        cells,
    )


def simulation(
    spacing: float, half_width: float, depth: float, tol: float, friction: float = 0.0
) -> sc.Simulation:
    """Return a simulation on cubic cells; lengths are relative to the critical contact radius."""
    n, nz = 2 * round(half_width / spacing) + 1, round(depth / spacing)
    d = spacing * CRITICAL.a
    grid = sc.Grid(n, n, d, d, nz, d)
    body = sc.Material.perfect_plastic(E, NU, YIELD)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    return sc.Simulation(grid, RIGID, body, gap, friction, tol=tol)


def flatten(above: float, top: float, cells: int, parts: int, tol: float) -> list[Point]:
    """Solve one range of interferences, up to `top`; return the results above `above`.

    cells: number of cells per contact radius at the interference `top`. Each step between `RATIOS`
    is divided into `parts` increments.
    """
    model = sc.flattening.kogut_etsion(top * CRITICAL.interference, RADIUS, E_STAR, NU, YIELD)
    radius = float(np.sqrt(model.area_ratio))
    wide = np.interp(np.log(top), np.log([12, 110]), [1.35, 1.75])
    deep = np.interp(np.log(top), np.log([12, 110]), [1.9, 2.6])
    solver = simulation(radius / cells, wide * radius, deep * radius, tol)
    points, before = [], 1.0
    for ratio in RATIOS[top >= RATIOS] if parts > 1 else RATIOS_QUICK[top >= RATIOS_QUICK]:
        for part in np.geomspace(before, ratio, parts + 1)[1:]:
            state = solver.step(approach=part * CRITICAL.interference)
        before = ratio
        if ratio > above:
            points.append(point(float(ratio), state))
    return points


def point(ratio: float, state: sc.State) -> Point:
    grid = state.grid
    middle = grid.ny // 2
    g = state.equivalent_plastic_strain()[grid.nx // 2 :, middle, :] / (YIELD / E)
    flows = g > 0
    # depth of the first plastic cell in each column below the contact
    under = flows.any(axis=1) & (state.pressure[grid.nx // 2 :, middle] > 0)
    core = flows.argmax(axis=1)[under].sum() * (grid.dx / CRITICAL.a) ** 2
    axis = grid.z[flows[0]] / CRITICAL.a
    half = 0.5 * grid.dx / CRITICAL.a
    return Point(
        ratio=ratio,
        load=state.load / CRITICAL.load,
        area=state.contact_area / (np.pi * CRITICAL.a**2),
        strain=state.max_equivalent_plastic_strain() / (YIELD / E),
        cells=float(np.sqrt(state.contact_area / np.pi) / grid.dx),
        substeps=state.substeps,
        core=float(core),
        top=(float(axis.min() - half), float(axis.max() + half)),
        outline=(grid.x[grid.nx // 2 :] / CRITICAL.a, grid.z / CRITICAL.a, g),
    )


def reach_surface(friction: float, cells: int, increments: int, limit: float) -> Surface:
    """Return the interference ratios at which the first and the second layer of cells yield.

    cells: number of cells per critical contact radius. increments, limit: number of increments and
    largest interference ratio of the path.
    """
    half_width, depth = 1.15 * limit**0.5 + 0.4, 1.9 * limit**0.5
    solver = simulation(1.0 / cells, half_width, depth, 1e-6, friction)
    reached: dict[int, float] = {}
    before: list[tuple[float, np.ndarray]] = []
    for ratio in np.geomspace(0.3, limit, increments):
        state = solver.step(approach=ratio * CRITICAL.interference)
        # maximum of von Mises over yield stress in each layer; 1 is reached by extrapolation
        mises = state.von_mises()[:, :, :2].max(axis=(0, 1)) / YIELD
        for layer in range(2):
            if layer not in reached and mises[layer] >= 1 - 1e-5:
                (w1, m1), (w2, m2) = ((w, m[layer]) for w, m in before[-2:])
                guess = w2 + (1 - m2) * (w2 - w1) / (m2 - m1) if m2 > m1 else ratio
                reached[layer] = float(np.clip(guess, w2, ratio))
        if len(reached) == 2:
            return Surface(friction, cells, (reached[0], reached[1]))
        before.append((float(ratio), mises))
    raise RuntimeError(f"the zone does not reach the surface up to {limit}")


def models() -> dict[str, sc.flattening.Flattening]:
    """Evaluate both empirical models at closely spaced interferences."""
    w = np.geomspace(1.0, 110.0, 300) * CRITICAL.interference
    return {
        "Kogut-Etsion": sc.flattening.kogut_etsion(w, RADIUS, E_STAR, NU, YIELD),
        "Jackson-Green": sc.flattening.jackson_green(w, RADIUS, E_STAR, NU, YIELD),
    }

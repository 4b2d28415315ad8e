# SPDX-License-Identifier: GPL-3.0-or-later
"""Common parts of the rolling pages: bodies, ellipses, and loading, rolling and unloading."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.optimize import brentq

import samcontact as sc

from .bodies import CERAMIC, STEEL_52100
from .profiles import top

RADIUS = 4.7625e-3
BALL = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(CERAMIC, STEEL_52100), p0=5.7e9)
"""Hertz contact of the ball with a maximum pressure of 5.7 GPa, the reference for lengths."""


def ellipse(k: float, p0: float = BALL.p0, E_star: float = BALL.E_star) -> sc.hertz.EllipticContact:
    """Return the Hertz contact of ellipticity k with the contact radius of `BALL` along x."""
    across, reference = 1.0, sc.hertz.point(RADIUS, E_star, p0=p0)
    if k > 1:

        def excess(ratio: float) -> float:
            return sc.hertz.elliptic(1.0, ratio, E_star, p0=1.0).k - k

        across = float(brentq(excess, 1.0, k**2))
    unit = sc.hertz.elliptic(RADIUS, RADIUS * across, E_star, p0=p0)
    Rx = RADIUS * reference.a / unit.a_x
    return sc.hertz.elliptic(Rx, Rx * across, E_star, p0=p0)


def table_ellipse(k: float, load: float) -> sc.hertz.EllipticContact:
    """Return the Hertz contact for the radii and loads of tables 3.2 and 3.3 of Boucly (2008)."""
    return sc.hertz.elliptic(RADIUS, RADIUS * k ** (0.5 * np.pi), BALL.E_star, load=load)


@dataclass(frozen=True)
class Mesh:
    """Mesh of a rolling contact: cells, grid size in semi-axes, number of steps, tolerance."""

    cells: float
    layers: float
    """Number of layers of cells in a depth of one semi-axis along x."""
    length: float = 4.0
    width: float = 1.8
    """Half-width of the grid, along x in units of a_x and along y in units of a_y."""
    depth: float = 2.6
    loading: int = 10
    tol: float = 1e-6

    def grid(self, contact: sc.hertz.EllipticContact) -> sc.Grid:
        dx, dy, dz = contact.a_x / self.cells, contact.a_y / self.cells, contact.a_x / self.layers
        return sc.Grid(
            2 * int(self.length * self.cells) + 1,
            2 * int(self.width * self.cells) + 1,
            dx,
            dy,
            int(self.depth * self.layers),
            dz,
        )

    def __str__(self) -> str:
        along = f"a/{self.cells:.3g}"
        return along if self.layers == self.cells else f"{along}, layers a/{self.layers:.3g}"


@dataclass
class Cycle:
    """State of the lower body after a pass, along the track and across its steady part."""

    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    steady: float
    """Position of the section across the track [m]."""
    along: np.ndarray
    across: np.ndarray
    """Residual normal displacement [m], positive into the body."""
    gamma: np.ndarray
    von_mises: np.ndarray
    hydrostatic: np.ndarray
    """Field in the plane y = 0, shape (x, z)."""
    gamma_across: np.ndarray
    von_mises_across: np.ndarray
    hydrostatic_across: np.ndarray
    """Field in a section across the track, shape (y, z)."""
    largest_von_mises: float
    """Maximum over all cells of the section across the track."""

    @property
    def row(self) -> int:
        return int(np.abs(self.x - self.steady).argmin())

    @property
    def depth(self) -> float:
        """Depth of the steady imprint [m]."""
        return float(self.along[self.row])

    def profile(self, name: str) -> np.ndarray:
        """Return gamma, von_mises or hydrostatic below the middle of the steady track."""
        return np.asarray(getattr(self, name)[self.row])

    def peak(self, name: str) -> tuple[float, float]:
        """Return the maximum of a profile and its depth, by a parabola through three layers."""
        return top(self.z, self.profile(name))

    def shoulders(self) -> tuple[float, float, float]:
        """Return the heights of the shoulders [m]: at the start, the end and the sides."""
        middle = self.x < self.steady
        return (
            -float(self.along[middle].min()),
            -float(self.along[~middle].min()),
            -float(self.across.min()),
        )

    def width(self) -> float:
        """Width of the steady imprint between the points of zero displacement [m]."""
        y, u = self.y[self.y >= 0], self.across[self.y >= 0]
        if np.all(u > 0):
            return float("nan")
        j = int(np.flatnonzero(u <= 0)[0])
        return 2 * float(np.interp(0.0, [u[j], u[j - 1]], [y[j], y[j - 1]]))


@dataclass
class Run:
    """Results of loading, rolling and unloading in one or several passes."""

    contact: sc.hertz.EllipticContact
    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    distance: float
    vertical: Cycle
    """State of the lower body at full load, before rolling."""
    vertical_pressure: np.ndarray
    """Pressure in the plane y = 0 at full load, before rolling."""
    loading: np.ndarray
    """Load, maximum pressure and maximum plastic strain of each loading increment."""
    cycles: list[Cycle] = field(default_factory=list)
    pressure_along: list[np.ndarray] = field(default_factory=list)
    pressure_across: list[np.ndarray] = field(default_factory=list)
    """Pressure at the end of each pass: along the track, and across it through the maximum."""
    history: list[np.ndarray] = field(default_factory=list)
    """Distance, maximum pressure and maximum plastic strain of each pass."""
    loaded: np.ndarray = field(default_factory=lambda: np.zeros(0))
    """Von Mises stress under load at the end of the last pass, shape (y, z)."""
    loaded_axis: list[np.ndarray] = field(default_factory=list)
    counters: dict[str, int] = field(default_factory=dict)
    increments: int = 0

    @property
    def a(self) -> float:
        return self.contact.a_x

    @property
    def p0(self) -> float:
        return self.contact.p0

    def p_max(self, cycle: int = -1) -> float:
        """Return the maximum pressure at the end of a pass."""
        return float(self.pressure_along[cycle].max())

    @cached_property
    def steady(self) -> Cycle:
        return self.cycles[-1]


def section(state: sc.State, steady: float, body: int = 2) -> Cycle:
    track = state.track(body)
    middle = len(track.y) // 2
    row = int(np.abs(track.x - steady).argmin())
    imprint, gamma = track.residual_displacement(), track.equivalent_plastic_strain()
    stress, hydrostatic = track.residual_von_mises(), track.residual_hydrostatic()
    return Cycle(
        x=track.x.copy(),
        y=track.y.copy(),
        z=track.z.copy(),
        steady=float(track.x[row]),
        along=imprint[:, middle].copy(),
        across=imprint[row].copy(),
        gamma=gamma[:, middle].copy(),
        von_mises=stress[:, middle].copy(),
        hydrostatic=hydrostatic[:, middle].copy(),
        gamma_across=gamma[row].copy(),
        von_mises_across=stress[row].copy(),
        hydrostatic_across=hydrostatic[row].copy(),
        largest_von_mises=float(stress[row].max()),
    )


def roll(
    bodies: tuple[sc.Material, sc.Material],
    contact: sc.hertz.EllipticContact,
    mesh: Mesh,
    distance: float,
    cycles: int = 1,
    steady: float = 0.6,
) -> Run:
    """Load, roll by `distance` [m] towards +x over both bodies, and unload, `cycles` times.

    steady: position of the section across the track, as a fraction of `distance`.
    """
    grid = mesh.grid(contact)
    gap = sc.surfaces.paraboloid(grid, contact.Rx, contact.Ry)
    run = sc.Simulation(grid, *bodies, gap, tol=mesh.tol, residual_stress="fast")
    middle, centre = grid.ny // 2, grid.nx // 2
    steps = round(distance / grid.dx)
    loading = []
    for load in np.linspace(0.0, contact.load, mesh.loading + 1)[1:]:
        state = run.step(load=float(load))
        loading.append((load, state.pressure.max(), state.max_equivalent_plastic_strain()))
    vertical = section(state, 0.0)
    pressure = state.pressure[:, middle].copy()
    done = Run(contact, grid.x, grid.y, grid.z, steps * grid.dx, vertical, pressure,
               np.array(loading))  # fmt: skip
    done.increments = mesh.loading
    for cycle in range(cycles):
        if cycle:
            run.step(load=0.0, advance=(steps * grid.dx, steps * grid.dx))
            state = run.step(load=contact.load)
            done.increments += 2
        history = [(0.0, state.pressure.max(), state.max_equivalent_plastic_strain())]
        for n in range(1, steps + 1):
            state = run.step(load=contact.load, advance=(-grid.dx, -grid.dx))
            strain = state.max_equivalent_plastic_strain()
            history.append((n * grid.dx, state.pressure.max(), strain))
        done.history.append(np.array(history))
        done.pressure_along.append(state.pressure[:, middle].copy())
        done.pressure_across.append(state.pressure[int(state.pressure[:, middle].argmax())].copy())
        von_mises = state.von_mises()
        done.loaded_axis.append(von_mises[centre, middle].copy())
        done.loaded = von_mises[centre].copy()
        unloaded = run.step(load=0.0)
        done.cycles.append(section(unloaded, steady * steps * grid.dx))
        done.increments += steps + 1
    done.counters = run.counters
    return done


def both_cycles(
    ax: Axes,
    runs: Mapping[Any, Run],
    name: str,
    points: Callable[[Run, int], tuple[np.ndarray, np.ndarray]],
) -> None:
    """Draw a curve of each run after one (dashed) and two cycles; `name`: format of labels."""
    for n, (key, run) in enumerate(runs.items()):
        for cycle, style in zip(range(len(run.cycles)), ("--", "-"), strict=False):
            label = name.format(key) if cycle == len(run.cycles) - 1 else None
            ax.plot(*points(run, cycle), f"C{n}{style}", label=label)

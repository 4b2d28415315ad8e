# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations of elastic and elastic-plastic contacts heated by the flux Q_f p."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

import samcontact as sc

from ..bodies import ELASTIC, MICRO_STRAIN, STEEL_52100, square, tolerance
from ..profiles import largest, von_mises

RADIUS = 7.5e-3
LOAD = 1500.0
THERMAL = {"conductivity": 50.2, "expansion": 11.7e-6, "diffusivity": 1.367e-5}
STEEL = STEEL_52100.with_thermal(**THERMAL)
UNYIELDING = ELASTIC.with_thermal(**THERMAL)
YIELD = float(STEEL.yield_stress(MICRO_STRAIN))
E_STAR = sc.hertz.effective_modulus(ELASTIC, STEEL)
HERTZ = sc.hertz.point(R=RADIUS, E_star=E_STAR, load=LOAD)
FACTORS = (0.0, 0.05, 0.12, 0.20)
HEATED = FACTORS[1:]
SMALL_LOAD, LARGE_LOAD = 140.0, 7500.0
SMALL_LOAD_FACTORS = (0.0, 0.075, 0.15, 0.225, 0.3)


@dataclass
class Elastic:
    """Results of a thermo-elastic contact."""

    x: np.ndarray
    pressure: np.ndarray
    z: np.ndarray
    plane: np.ndarray
    """Von Mises stress in the plane y = 0, the surface included."""
    largest: tuple[float, float]
    """Maximum von Mises stress and its depth."""


@dataclass
class Plastic:
    """Results of a thermo-elastic-plastic contact, under load and after unloading."""

    x: np.ndarray
    z: np.ndarray
    pressure: np.ndarray
    area: float
    plane: np.ndarray
    largest: tuple[float, float]
    """Maximum von Mises stress under load and its depth."""
    distance: float
    """Distance of the largest von Mises stress from the axis."""
    gamma: float
    residual: np.ndarray
    """Residual von Mises stress on the axis."""
    residual_largest: tuple[float, float]
    """Maximum residual von Mises stress and its depth."""
    elastic_unloading: np.ndarray
    """Residual von Mises stress that would remain after elastic unloading."""


@dataclass
class Onset:
    """Hertz pressure at first yield and position of first yield, by heat flux per unit pressure."""

    factor: np.ndarray
    """Heat flux per unit pressure Q_f [m/s]."""
    p0: np.ndarray
    """Hertz pressure at first yield [Pa]."""
    radius: np.ndarray
    depth: np.ndarray
    """Depth of first yield; depth and `radius` are relative to the Hertz radius at first yield."""

    def load(self, factor: float) -> float:
        p0 = float(np.interp(factor, self.factor, self.p0))
        return sc.hertz.point(R=RADIUS, E_star=E_STAR, p0=p0).load

    def leaves_axis(self) -> float:
        return float(self.factor[np.flatnonzero(self.radius > 0)[0]])

    def reaches_surface(self) -> float:
        return float(self.factor[np.flatnonzero(self.depth > 0)[-1] + 1])


@dataclass
class Results:
    elastic: dict[float, Elastic]
    plastic: dict[float, list[Plastic]]
    """Results on increasingly thin layers, by Q_f [m/s]; the last result of each list is used."""
    onset: Onset
    curves: dict[str, tuple[float, list[tuple[str, np.ndarray, np.ndarray]]]]
    """Load [N] and curves of each panel of figure 2.21; a curve has a name, x and pressure."""
    strain: tuple[np.ndarray, np.ndarray]
    """Points of figure 2.22: Hertz pressure and maximum plastic strain."""
    small: dict[float, Plastic]
    """Results for figure 2.26, by Q_f [m/s]."""
    mesh: dict[str, str] = field(default_factory=dict)

    def last(self, factor: float) -> Plastic:
        return self.plastic[factor][-1]


def hertz(load: float) -> sc.hertz.PointContact:
    return sc.hertz.point(R=RADIUS, E_star=E_STAR, load=load)


def elastic_case(load: float, factor: float, cells: int, depths: np.ndarray) -> Elastic:
    contact = hertz(load)
    grid = square(contact.a, cells, 1.6)
    solver = sc.ContactSolver(grid, ELASTIC, UNYIELDING, heat=sc.Heat(factor))
    pressure = solver.solve(sc.surfaces.paraboloid(grid, RADIUS), load=load).pressure
    m = grid.nx // 2
    plane = von_mises(solver.stress(pressure, depths)[:, :, m])
    top, _, z = largest(plane, grid.x, depths)
    return Elastic(grid.x, pressure[:, m], depths, plane, (top, z))


def plastic_case(
    load: float,
    factor: float,
    cells: int,
    width: float,
    layer: float,
    depth: float,
    increments: int,
    tol: float,
) -> Plastic:
    """Solve the elastic-plastic contact.

    width, depth: half-width and depth of the grid, in contact radii.
    """
    grid = square(hertz(load).a, cells, width, depth, layer=layer)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, ELASTIC, STEEL, gap, tol=tol, heat=sc.Heat(factor))
    for value in load * np.arange(1, increments + 1) / increments:
        state = simulation.step(load=float(value))
    unloaded = simulation.step(load=0.0)
    m = grid.nx // 2
    stress, residual = state.von_mises(), unloaded.von_mises()
    i, j, k = np.unravel_index(int(stress.argmax()), stress.shape)
    return Plastic(
        x=grid.x,
        z=grid.z,
        pressure=state.pressure[:, m].copy(),
        area=state.contact_area,
        plane=stress[:, m].copy(),
        largest=(float(stress.max()), float(grid.z[k])),
        distance=float(np.hypot(grid.x[i], grid.y[j])),
        gamma=float(state.max_equivalent_plastic_strain()),
        residual=residual[m, m].copy(),
        residual_largest=(
            float(residual.max()),
            float(grid.z[int(residual.max(axis=(0, 1)).argmax())]),
        ),
        elastic_unloading=von_mises(state.residual_stress()[:, m, m]),
    )


def onset(cells: int, depths: int, factors: np.ndarray) -> Onset:
    """Return the onset of yield, derived by similarity from contacts at 1500 N.

    With lengths relative to a and stresses relative to p0, a thermo-elastic contact depends on
    Q_f a only, and a is proportional to p0. If the maximum von Mises stress of a contact with p0
    and Q_f is s, a contact with the Hertz pressure p0 Y/s and the heat factor Q_f s/Y is at the
    onset of yield, at an equal position relative to a.
    """
    grid = square(HERTZ.a, cells, 1.15)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    z = np.linspace(0.0, 0.6, depths) * HERTZ.a
    stress, place = [], []
    pressure = None
    for factor in factors:
        solver = sc.ContactSolver(grid, ELASTIC, UNYIELDING, heat=sc.Heat(float(factor)))
        pressure = solver.solve(gap, load=LOAD, initial_pressure=pressure).pressure
        found = von_mises(solver.stress(pressure, z))
        i, j, k = np.unravel_index(int(found.argmax()), found.shape)
        stress.append(float(found.max()))
        place.append((np.hypot(grid.x[i], grid.y[j]) / HERTZ.a, z[k] / HERTZ.a))
    s = np.array(stress)
    radius, depth = np.array(place).T
    return Onset(factors * s / YIELD, HERTZ.p0 * YIELD / s, radius, depth)


def pressure_curves(
    plastic: dict[float, list[Plastic]],
    cells: int,
    plastic_cells: int,
    increments: int,
    tol: float,
) -> dict[str, tuple[float, list[tuple[str, np.ndarray, np.ndarray]]]]:
    """Return the pressure curves of figure 2.21: the cases of 1500 N and additional cases."""
    depths = np.linspace(0.0, 1.6, 65) * HERTZ.a
    curves = {}
    for load, factor, width, depth in ((LOAD, 0.20, 4.0, 1.6), (LARGE_LOAD, 0.05, 3.0, 1.6)):
        a = hertz(load).a
        found = []
        for name, heat in (("", 0.0), ("thermo-", factor)):
            case = elastic_case(load, heat, cells, depths)
            found.append((f"{name}elastic", case.x, case.pressure))
            if load == LOAD and heat > 0:
                plastic_ = plastic[factor][0]
            else:
                deep = 2.6 if load > LOAD else depth
                plastic_ = plastic_case(
                    load, heat, plastic_cells, width, a / 20, deep, increments, tol
                )
            found.append((f"{name}elastic-plastic", plastic_.x, plastic_.pressure))
        curves[f"{load:.0f} N, Q_f = {factor:g} m/s"] = (load, found)
    return curves


def strain_curve(cells: int, count: int, tol: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the points of figure 2.22: `count` Hertz pressures, and maximum plastic strains."""
    p0, gamma = [], []
    largest = sc.hertz.point(R=RADIUS, E_star=E_STAR, p0=8.12e9)
    grid = square(largest.a, cells, 1.9, 2.6, layer=largest.a / 20)
    simulation = sc.Simulation(grid, ELASTIC, STEEL, sc.surfaces.paraboloid(grid, RADIUS), tol=tol)
    for value in np.linspace(1.6e9, 8.12e9, count):
        load = sc.hertz.point(R=RADIUS, E_star=E_STAR, p0=float(value)).load
        state = simulation.step(load=load)
        p0.append(float(value))
        gamma.append(float(state.max_equivalent_plastic_strain()))
    return np.array(p0), np.array(gamma)


def compute(quick: bool) -> Results:
    fine_depths = np.arange(0.0, 660e-6, 10e-6)
    cells = 16 if quick else 32
    elastic = {factor: elastic_case(LOAD, factor, cells, fine_depths) for factor in FACTORS}

    increments, tol = 5 if quick else 10, tolerance(quick)
    small_cells = 12 if quick else 24
    plastic = {
        factor: [plastic_case(LOAD, factor, small_cells, 1.6, 10e-6, 1.7, increments, tol)]
        for factor in (0.0, 0.05)
    }
    # heat alone causes plastic flow far outside the contact
    large_cells = 6 if quick else 12
    layers = (5e-6,) if quick else (20e-6, 10e-6, 5e-6, 2.5e-6)
    for factor, width, depth in ((0.12, 2.6, 1.25), (0.20, 4.0, 1.6)):
        plastic[factor] = [
            plastic_case(LOAD, factor, large_cells, width, layer, depth, increments, tol)
            for layer in layers
        ]

    steps, step = np.linspace(0.0, 0.14, 29 if quick else 57), 0.001 if quick else 0.0005
    near = [np.arange(0.057, 0.061, step), np.arange(0.0915, 0.0965, step)]
    fine_cells, depths = (24, 49) if quick else (48, 97)
    curve = onset(fine_cells, depths, np.unique(np.concatenate([steps, *near]).round(6)))

    small_layer = hertz(SMALL_LOAD).a / 20
    small = {
        factor: plastic_case(
            SMALL_LOAD, factor, 8 if quick else 16, 3.0, small_layer, 1.7, increments, tol
        )
        for factor in SMALL_LOAD_FACTORS
    }
    return Results(
        elastic,
        plastic,
        curve,
        pressure_curves(plastic, cells, large_cells, increments, tol),
        strain_curve(small_cells, 9 if quick else 25, tol),
        small,
        {
            "elastic": f"a/{cells}",
            "onset": f"a/{fine_cells}",
            "plastic": f"a/{small_cells}, layers of 10 µm",
            "heated": f"a/{large_cells}, layers of {layers[-1] * 1e6:g} µm",
            "small": f"a/{8 if quick else 16}, layers a/20",
        },
    )


def at_surface(profile: np.ndarray) -> float:
    """Extrapolate a profile over the depth to z = 0 from the first two layers."""
    return float(1.5 * profile[0] - 0.5 * profile[1])

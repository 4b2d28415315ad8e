# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that slides over a half-space of steel M50: section 2.3.3."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc
from reference import fem

from .page import Number, Picture, Statement
from .profiles import finish, succession, von_mises

TITLE = "Normal load and friction"
INTRODUCTION = """
Section 2.3.3 of the thesis: a ball of 10 mm radius on a half-space of steel M50, in gross sliding
with the friction coefficient µ; the shear µp acts on the half-space along +x. First a rigid ball
and 800 N, then an elastic ball and up to 5000 N. For the second the text says 20 mm, but its Hertz
pressure of 5.05 GPa needs 10 mm, which is what the start of the section says. a is the Hertz
contact radius at the largest load.
"""

RADIUS = 10e-3
RIGID = sc.Material.rigid()
ELASTIC = sc.Material.elastic(210e9, 0.3)
M50 = sc.Material.swift(210e9, 0.3, B=1280e6, C=4, n=0.095)
MICRO_STRAIN = 20e-6
MICRO_YIELD = float(M50.yield_stress(MICRO_STRAIN))
F1_LOAD, F2_LOAD = 800.0, 5000.0
F1_FRICTION = (0.0, 0.2, 0.4)
SHOWN = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
MORE = (0.15, 0.25, 0.31, 0.32, 0.33, 0.35, 0.45)
LAYERS = 1.85  # depth of the volume over a
HERTZ_DEPTH = 0.48


@dataclass
class Elastic:
    x: np.ndarray
    pressure: np.ndarray
    z: np.ndarray
    von_mises: np.ndarray
    """On x = y = 0."""
    largest_at: tuple[float, float]
    """x, z of the largest von Mises stress in the plane y = 0."""


@dataclass
class Plastic:
    """One friction coefficient: the largest load, after unloading, and each load before."""

    x: np.ndarray
    z: np.ndarray
    pressure: np.ndarray
    von_mises: np.ndarray
    gamma: np.ndarray
    residual: np.ndarray
    hydrostatic: np.ndarray
    """Profiles on x = y = 0; residual and hydrostatic after unloading."""
    loads: np.ndarray
    gamma_max: np.ndarray
    """Largest plastic strain at each load."""
    gamma_at: tuple[float, float]
    """x, z of the largest plastic strain."""
    von_mises_at: tuple[float, float, float]
    """Largest von Mises stress under load, and its x and z."""
    largest_by_depth: np.ndarray
    """Largest von Mises stress in each layer."""
    surface_plane: np.ndarray
    """Residual von Mises stress in the plane y = 0."""


@dataclass
class Results:
    rigid: sc.hertz.PointContact
    elastic: dict[float, Elastic]
    plastic: dict[float, Plastic]
    ball: sc.hertz.PointContact
    sliding: dict[float, Plastic]
    by_load: dict[float, np.ndarray]
    """Residual hydrostatic stress on the axis for µ = 0, per load."""
    layers: list[tuple[float, float]]
    """First depth over a and largest plastic strain, µ = 0.5."""
    mesh: dict[str, str]


def hertz(body1: sc.Material, load: float) -> sc.hertz.PointContact:
    return sc.hertz.point(R=RADIUS, E_star=sc.hertz.effective_modulus(body1, M50), load=load)


def make_grid(a: float, cells: float, per_cell: int, width: float, depth: float) -> sc.Grid:
    """`cells` per radius a, `per_cell` layers in the height of a cell."""
    n, d = 2 * int(width * cells) + 1, a / cells
    return sc.Grid(n, n, d, d, int(depth * cells * per_cell), d / per_cell)


def elastic_case(contact: sc.hertz.PointContact, friction: float, cells: int) -> Elastic:
    n, d = 2 * int(1.4 * cells) + 1, contact.a / cells
    grid = sc.Grid(n, n, d, d)
    solver = sc.ContactSolver(grid, RIGID, ELASTIC, friction)
    pressure = solver.solve(sc.surfaces.paraboloid(grid, RADIUS), load=contact.load).pressure
    z = np.linspace(0.0, 2.0, 41) * contact.a
    middle = n // 2
    stress = von_mises(solver.stress(pressure, z)[:, :, middle])
    i, k = np.unravel_index(int(stress.argmax()), stress.shape)
    largest_at = (float(grid.x[i]), float(z[k]))
    return Elastic(grid.x, pressure[:, middle], z, stress[middle], largest_at)


def plastic_case(
    body1: sc.Material, grid: sc.Grid, friction: float, load: float, increments: int
) -> Plastic:
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, body1, M50, gap, friction)
    loads, gamma_max = load * np.arange(1, increments + 1) / increments, []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of strains above 5 %: they are the subject here
        for value in loads:
            state = simulation.step(load=float(value))
            gamma_max.append(float(state.equivalent_plastic_strain().max()))
        unloaded = simulation.step(load=0.0)
    i = j = grid.nx // 2
    gamma, stress, residual = (
        state.equivalent_plastic_strain(),
        state.von_mises(),
        unloaded.von_mises(),
    )
    at = np.unravel_index(int(gamma.argmax()), gamma.shape)
    top = np.unravel_index(int(stress.argmax()), stress.shape)
    return Plastic(
        x=grid.x,
        z=grid.z,
        pressure=state.pressure[:, j].copy(),
        von_mises=stress[i, j].copy(),
        gamma=gamma[i, j].copy(),
        residual=residual[i, j].copy(),
        hydrostatic=unloaded.hydrostatic()[i, j].copy(),
        loads=loads,
        gamma_max=np.array(gamma_max),
        gamma_at=(float(grid.x[at[0]]), float(grid.z[at[2]])),
        von_mises_at=(float(stress.max()), float(grid.x[top[0]]), float(grid.z[top[2]])),
        largest_by_depth=stress.max(axis=(0, 1)),
        surface_plane=residual[:, j].copy(),
    )


def residual_by_load(grid: sc.Grid, increments: int) -> dict[float, np.ndarray]:
    """Residual hydrostatic stress on the axis after 1000, 2000, ... 5000 N, µ = 0."""
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, ELASTIC, M50, gap)
    middle, found = grid.nx // 2, {}
    for k in range(1, increments + 1):
        load = F2_LOAD * k / increments
        simulation.step(load=load)
        if load % 1000.0 == 0.0:  # unloading is elastic: loading goes on where it ended
            found[load] = simulation.step(load=0.0).hydrostatic()[middle, middle].copy()
    return found


def compute(quick: bool) -> Results:
    rigid, ball = hertz(RIGID, F1_LOAD), hertz(ELASTIC, F2_LOAD)
    cells, per_cell, increments = (12, 2, 10) if quick else (16, 4, 20)
    small_cells, small_layers = (16, 1) if quick else (24, 2)
    small = make_grid(rigid.a, small_cells, small_layers, 1.4, 1.6)
    elastic = {mu: elastic_case(rigid, mu, small_cells) for mu in F1_FRICTION}
    plastic = {mu: plastic_case(RIGID, small, mu, F1_LOAD, increments) for mu in F1_FRICTION}
    grid = make_grid(ball.a, cells, per_cell, 2.0, LAYERS)
    sliding = {
        mu: plastic_case(ELASTIC, grid, mu, F2_LOAD, increments) for mu in sorted(SHOWN + MORE)
    }
    by_load = residual_by_load(grid, increments)
    layers = []
    for count in (1, 2, 4) if quick else (1, 2, 4, 8):
        thin = make_grid(ball.a, 12, count, 2.0, LAYERS)
        found = plastic_case(ELASTIC, thin, 0.5, F2_LOAD, 10)
        layers.append((float(thin.z[0]) / ball.a, float(found.gamma_max[-1])))
    return Results(
        rigid,
        elastic,
        plastic,
        ball,
        sliding,
        by_load,
        layers,
        {
            "elastic": f"a/{small_cells}",
            "rigid ball": f"a/{small_cells}, layers a/{small_cells * small_layers}",
            "elastic ball": f"a/{cells}, layers a/{cells * per_cell}",
        },
    )


def peak_position(x: np.ndarray, pressure: np.ndarray) -> float:
    """Where a profile has its maximum, by a parabola through five cells."""
    k = int(pressure.argmax())
    c = np.polyfit(x[k - 2 : k + 3], pressure[k - 2 : k + 3], 2)
    return float(-c[1] / (2 * c[0]))


def contact_radius(x: np.ndarray, pressure: np.ndarray) -> float:
    """Where the pressure ends: its square falls linearly with the square of the distance."""
    rim = (x > 0.75) & (x < 0.95)
    slope, at_centre = np.polyfit(x[rim] ** 2, pressure[rim] ** 2, 1)
    return float(np.sqrt(-at_centre / slope))


def crossing(mu: list[float], difference: list[float]) -> float:
    """First µ at which a difference turns from negative to positive (linear between values)."""
    for k in range(1, len(mu)):
        if difference[k - 1] < 0 <= difference[k]:
            share = difference[k - 1] / (difference[k - 1] - difference[k])
            return mu[k - 1] + share * (mu[k] - mu[k - 1])
    return math.nan


def surface_jump() -> float:
    """Friction above which a sliding Hertz contact yields first at its surface, ν = 0.3."""
    low, high = 0.2, 0.4
    while high - low > 1e-6:
        mu = 0.5 * (low + high)
        below = sc.critical.onset_sliding(1.0, 1.0, 0.3, 1.0, mu).z > 0
        low, high = (mu, high) if below else (low, mu)
    return low


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_rigid(results), *stated_elastic_ball(results), *stated_residual(results)]


def stated_rigid(results: Results) -> list[Number | Statement]:
    a = results.rigid.a
    mesh = results.mesh["rigid ball"]
    entries: list[Number | Statement] = [
        Number("800 N, rigid ball: Hertz pressure", 4.35, results.rigid.p0 * 1e-9, "GPa",
               "closed form"),
        Number("its contact radius", 296.0, a * 1e6, "µm", "closed form"),
    ]  # fmt: skip
    for name, cases, mesh_name in (
        ("elastic", results.elastic, "elastic"),
        ("elastic-plastic", results.plastic, "rigid ball"),
    ):
        shift = [peak_position(cases[mu].x, cases[mu].pressure) / a for mu in F1_FRICTION]
        entries.append(
            Statement(
                f"pressure with µ = 0, 0.2, 0.4, {name}",
                "asymmetric with µ, maximum shifted in the direction of the traction",
                "maximum at x/a = " + ", ".join(f"{round(s, 3) + 0.0:.3f}" for s in shift),
                abs(shift[0]) < 1e-3 and shift[2] < shift[1] < -0.02,
                results.mesh[mesh_name],
                remark="That is the direction of the traction on the ball, -x; the text does not "
                "say on which body. The surface of the half-space sinks ahead of a shear along +x "
                "and rises behind it (Cerruti), so a rigid ball presses more behind its centre."
                if name == "elastic"
                else "",
            )
        )
    depth = {mu: results.elastic[mu].largest_at[1] / a for mu in F1_FRICTION}
    entries += [
        Statement(
            "elastic: largest von Mises stress",
            "at the surface for µ > 0.3",
            ", ".join(f"z/a = {depth[mu]:.2f} (µ = {mu:g})" for mu in F1_FRICTION),
            depth[0.0] > 0.3 and depth[0.2] > 0.3 and depth[0.4] == 0.0,
            results.mesh["elastic"],
        ),
        Number(
            "friction above which the largest elastic von Mises stress is at the surface",
            0.3, surface_jump(), "", "closed form",
            remark="Hertz pressure with the shear µp, `samcontact.critical.onset_sliding`.",
        ),
    ]  # fmt: skip
    both: tuple[Elastic, Plastic] = (results.elastic[0.0], results.plastic[0.0])
    top = [float(case.pressure.max()) * 1e-9 for case in both]
    edge = [contact_radius(case.x / a, case.pressure) for case in both]
    curves = fem.load("2a")
    fem_pressure, fem_axis = curves.pressure_r, curves.axis_loaded
    ours = results.plastic[0.0]
    inside = (ours.x > 0) & (ours.x < 0.9 * a)
    expected = np.interp(ours.x[inside], fem_pressure["r_m"], fem_pressure["p_Pa"])
    differences = {
        "pressure": (ours.pressure[inside] - expected, fem_pressure["p_Pa"].max()),
        "von Mises stress": (
            ours.von_mises - np.interp(ours.z, fem_axis["z_m"], fem_axis["vonMises_Pa"]),
            fem_axis["vonMises_Pa"].max(),
        ),
        "plastic strain": (
            ours.gamma - np.interp(ours.z, fem_axis["z_m"], fem_axis["gamma_p"]),
            fem_axis["gamma_p"].max(),
        ),
    }
    rms = {
        name: float(np.sqrt(np.mean(error**2)) / largest)
        for name, (error, largest) in differences.items()
    }
    entries += [
        Statement(
            "plasticity, µ = 0: largest pressure, and contact radius",
            "lower; area tends to increase",
            f"{top[1]:.3f} instead of {top[0]:.3f} GPa; {edge[1]:.3f} a instead of {edge[0]:.3f} a",
            top[1] < 0.98 * top[0] and edge[1] > edge[0],
            mesh,
        ),
        Statement(
            "profiles for µ = 0 against finite elements",
            "fairly good agreement",
            "rms of the difference over the maximum: "
            + ", ".join(f"{name} {100 * value:.2f} %" for name, value in rms.items()),
            all(value < 0.02 for value in rms.values()),
            mesh,
            remark="Finite elements of `reference/fem/README.md`, case 2a.",
        ),
    ]
    return entries


def bound(mu: float, pressure: float) -> float:
    """Least plastic strain at a surface point with this pressure and the shear µp.

    The von Mises stress is at least sqrt(3) µp there, and must not exceed the yield stress.
    """
    B, C, n = (M50.parameters[name] for name in "BCn")
    return max(0.0, float((math.sqrt(3) * mu * pressure / B) ** (1 / n)) - C) * 1e-6


def stated_elastic_ball(results: Results) -> list[Number | Statement]:
    a, ball, mesh = results.ball.a, results.ball, results.mesh["elastic ball"]
    at_rest = sc.critical.onset(RADIUS, ball.E_star, 0.3, MICRO_YIELD)
    sliding = results.sliding
    last = sc.critical.onset_sliding(RADIUS, ball.E_star, 0.3, MICRO_YIELD, 0.5)
    entries: list[Number | Statement] = [
        Number("5000 N, elastic ball: Hertz pressure", 5.05, ball.p0 * 1e-9, "GPa", "closed form"),
        Number("micro-yield stress, γ = 20e-6", 1731.0, MICRO_YIELD * 1e-6, "MPa", "closed form"),
        Number("yield stress at γ = 0.2 %", 2636.0, float(M50.yield_stress(2e-3)) * 1e-6, "MPa",
               "closed form"),
        Number("ω/ω_c0", 3.2, ball.approach / at_rest.interference, "", "closed form",
               remark="ω_c0 where the elastic von Mises stress reaches the micro-yield stress."),
        Statement(
            "critical load and interference",
            "very important effect of friction",
            f"W_c/W_c0 = {last.load / at_rest.load:.3f}, "
            f"ω_c/ω_c0 = {last.interference / at_rest.interference:.3f} for µ = 0.5",
            last.load < 0.5 * at_rest.load,
            "closed form",
        ),
        Number("largest plastic strain, µ = 0", 0.34, 100 * sliding[0.0].gamma_max[-1], "%", mesh),
    ]  # fmt: skip
    least = bound(0.5, float(sliding[0.5].pressure.max()))
    depth, gamma = np.array(results.layers).T
    there = float(np.interp(0.0534, gamma, depth))
    entries.append(
        Statement(
            "largest plastic strain, µ = 0.5",
            "5.34 %, on a mesh that is not stated",
            ", ".join(f"{100 * g:.1f} % (first layer at {z:.4f} a)" for z, g in results.layers)
            + f"; 5.34 % at {there:.3f} a",
            gamma.min() < 0.0534 < gamma.max() and 0.03 < there < 0.05,
            "a/12, layers a/12 and thinner",
            remark="The maximum is at the surface, where the strain has a steep gradient: what a "
            "mesh shows is the strain of its first layer. The thesis's value is that of layers of "
            f"about {2 * there * a * 1e6:.0f} µm, and not converged. At z = 0 more is needed: "
            "under the largest pressure the von Mises stress is at least √3 µ p, which the yield "
            f"stress of M50 reaches at γ = {100 * least:.1f} %. That is beyond the 5 % up to "
            "which the thesis takes small strains as acceptable.",
        )
    )
    depths = {mu: sliding[mu].gamma_at[1] for mu in SHOWN}
    first = float(sliding[0.0].z[0])
    entries += [
        Statement(
            "depth z/a of the largest plastic strain",
            "at the surface for µ = 0.4 and 0.5, at the Hertz depth for µ = 0",
            ", ".join(f"{depths[mu] / a:.2f} (µ = {mu:g})" for mu in SHOWN)
            + f"; first layer at {first / a:.3f}",
            depths[0.4] == depths[0.5] == first and abs(depths[0.0] / a - HERTZ_DEPTH) < 0.05,
            mesh,
        ),
    ]
    frictionless = sliding[0.0]
    outside = (frictionless.gamma == 0) & (frictionless.z > HERTZ_DEPTH * a)
    z = frictionless.z[outside]
    radial, axial = ball.axis_stress(z, 0.3)
    error = float(np.abs(frictionless.von_mises[outside] / np.abs(axial - radial) - 1).max())
    entries.append(
        Statement(
            "von Mises stress below the plastic zone, µ = 0",
            "follows the elastic solution",
            f"within {100 * error:.1f} % of it",
            error < 0.05,
            mesh,
        )
    )
    return [*entries, *stated_maximum(results)]


def rivals(case: Plastic, a: float) -> tuple[float, float]:
    """Largest von Mises stress close to the surface (z < 0.2 a), and below."""
    near = case.z < 0.2 * a
    return float(case.largest_by_depth[near].max()), float(case.largest_by_depth[~near].max())


def stated_maximum(results: Results) -> list[Number | Statement]:
    a, mesh, sliding = results.ball.a, results.mesh["elastic ball"], results.sliding
    range_ = [mu for mu in sorted(sliding) if 0.25 <= mu <= 0.4]
    pairs = [rivals(sliding[mu], a) for mu in range_]
    jump = crossing(range_, [near - below for near, below in pairs])
    ahead = {mu: sliding[mu].von_mises_at[1] / a for mu in sorted(sliding)}
    shown = ", ".join(f"{ahead[mu]:.2f} (µ = {mu:g})" for mu in SHOWN)
    return [
        Number(
            "friction above which the largest von Mises stress under load is at the surface",
            0.32,
            jump,
            "",
            mesh,
            remark="It depends on how close to the surface the stress is taken: with first layers "
            "at z/a = 0.042, 0.021, 0.010 and 0.005 (cells of a/12) it is 0.340, 0.321, 0.314 and "
            "0.312. The thesis's value is in this range.",
        ),
        Statement(
            "x/a of the largest von Mises stress under load",
            "ahead of the centre, more so with µ; then jumps behind; then back to the centre",
            shown,
            ahead[0.0] == 0 < ahead[0.1] < ahead[0.2] < ahead[0.3]
            and ahead[0.35] < 0
            and ahead[0.35] < ahead[0.5] <= 0,
            mesh,
        ),
    ]


def stated_residual(results: Results) -> list[Number | Statement]:
    a, mesh, sliding = results.ball.a, results.mesh["elastic ball"], results.sliding
    both = sorted(mu for mu in sliding if mu >= 0.2)
    near = {mu: float(sliding[mu].residual[sliding[mu].z < 0.2 * a].max()) for mu in both}
    deep = {mu: at_hertz_depth(sliding[mu], a) for mu in both}
    exceeds = crossing(both, [near[mu] - deep[mu] for mu in both])
    quiet = {mu: quiescent(sliding[mu], a) for mu in both}
    turns = crossing(both, [-quiet[mu] for mu in both])
    reach = {mu: float(sliding[mu].gamma[0]) for mu in sorted(sliding)}
    mus = [mu for mu in reach if reach[mu] > 0 and mu <= 0.3]
    reaches = crossing(mus, [math.log(reach[mu] / MICRO_STRAIN) for mu in mus])
    by_load = results.by_load
    amplitude = [float(np.ptp(by_load[load])) * 1e-6 for load in sorted(by_load)]
    signs = {
        load: succession(by_load[load], 0.02 * float(np.abs(by_load[load]).max()))
        for load in sorted(by_load)
    }
    wanted = ["compressive", "tensile", "compressive", "tensile"]
    rest, z = sliding[0.0].residual * 1e-6, sliding[0.0].z
    zones = rest[0], rest[z < HERTZ_DEPTH * a].min(), rest[z > 0.3 * a].max()
    entries: list[Number | Statement] = [
        Statement(
            "residual von Mises stress on the axis, µ = 0",
            "two zones, at the Hertz depth and at the surface",
            f"{zones[0]:.0f} MPa in the first layer, {zones[1]:.0f} MPa below it, "
            f"{zones[2]:.0f} MPa at the Hertz depth",
            zones[1] < 0.2 * min(zones[0], zones[2]),
            mesh,
        ),
        Statement(
            "residual von Mises stress on the axis: largest near the surface / at Hertz depth",
            "higher at the surface for µ > 0.3",
            ", ".join(f"{near[m] * 1e-6:.0f}/{deep[m] * 1e-6:.0f} MPa (µ = {m:g})"
                      for m in (0.2, 0.3, 0.4, 0.5)) + f"; equal at µ = {exceeds:.2f}",
            near[0.3] < deep[0.3] and near[0.4] > deep[0.4],
            mesh,
        ),
        Statement(
            "residual von Mises stress at the Hertz depth (0.48 a)",
            "pronounced decrease for µ > 0.4",
            ", ".join(f"{deep[m] * 1e-6:.0f} MPa (µ = {m:g})" for m in (0.2, 0.3, 0.4, 0.5)),
            deep[0.5] < 0.85 * deep[0.4] and deep[0.4] > 0.9 * deep[0.2],
            mesh,
        ),
        Statement(
            "friction at which the plastic zone reaches the surface, x = y = 0",
            "approximately 0.2",
            f"γ of the first layer passes 20e-6 at µ = {reaches:.2f}",
            0.15 < reaches < 0.25,
            mesh,
        ),
        Statement(
            "residual hydrostatic stress on the axis, µ = 0, from the surface down",
            ", ".join(wanted),
            "; ".join(f"{load:.0f} N: {', '.join(found)}" for load, found in signs.items()
                      if load >= 4000.0),
            all(signs[load] == wanted for load in (4000.0, 5000.0)),
            mesh,
        ),
        Statement(
            "its amplitude at 1000, 2000, ... 5000 N",
            "increases with the load",
            ", ".join(f"{value:.3g}" for value in amplitude) + " MPa",
            amplitude == sorted(amplitude),
            mesh,
        ),
        Statement(
            "largest hydrostatic residual stress between surface and Hertz depth",
            "turns compressive for µ between 0.2 and 0.3",
            ", ".join(f"{quiet[mu] * 1e-6:.0f} MPa (µ = {mu:g})" for mu in (0.2, 0.25, 0.3))
            + f"; zero at µ = {turns:.2f}",
            0.2 < turns < 0.3,
            mesh,
        ),
    ]  # fmt: skip
    return entries


def at_hertz_depth(case: Plastic, a: float) -> float:
    return float(np.interp(HERTZ_DEPTH * a, case.z, case.residual))


def quiescent(case: Plastic, a: float) -> float:
    """Largest hydrostatic residual stress between the surface and the Hertz depth."""
    between = (case.z > 0.04 * a) & (case.z < 0.4 * a)
    return float(case.hydrostatic[between].max())


def figures(results: Results) -> list[Picture]:
    return [
        rigid_elastic(results),
        rigid_plastic(results),
        onset_and_strain(results),
        pressure_and_strain(results),
        stress_profiles(results),
        maximum(results),
        residual_map(results),
        hydrostatic(results),
        first_layer(results),
    ]


def rigid_elastic(results: Results) -> Picture:
    contact = results.rigid
    a, p0 = contact.a, contact.p0
    figure = Figure(figsize=(10.0, 5.4), layout="constrained")
    rows = figure.subplots(2, 3, sharey="row")
    fine = np.linspace(-1.4, 1.4, 281)
    for mu, upper, lower in zip(F1_FRICTION, *rows, strict=True):
        case = results.elastic[mu]
        upper.plot(fine, contact.pressure(fine * a) * 1e-9, "k--", linewidth=1, label="Hertz")
        upper.plot(case.x / a, case.pressure * 1e-9, color="C0", label="samcontact")
        upper.set_xlim(-1.4, 1.4)
        upper.set_title(f"µ = {mu:g}", fontsize="medium")
        exact = von_mises(contact.stress(0.0, 0.0, case.z, 0.3, mu))
        lower.plot(case.z / a, exact * 1e-9, "k--", linewidth=1, label="Hertz with shear µp")
        lower.plot(case.z / a, case.von_mises * 1e-9, color="C0", label="samcontact")
        finish(upper, "x/a", "pressure [GPa]" if mu == 0 else "", legend=mu == 0)
        finish(lower, "depth z/a", "von Mises stress [GPa]" if mu == 0 else "", legend=mu == 0)
    rows[0, 0].plot(0, 4.35, "ko", markerfacecolor="none", label="stated: 4.35 GPa")
    rows[0, 0].legend(frameon=False, fontsize="small")
    rows[0, 0].set_ylim(0, 1.12 * p0 * 1e-9)
    return Picture(
        "friction_rigid_elastic",
        "Figures 2.35 to 2.40: rigid ball on an elastic half-space, 800 N. Pressure in the plane "
        "y = 0 and von Mises stress on x = y = 0; the shear acts on the half-space along +x.",
        figure,
    )


def rigid_plastic(results: Results) -> Picture:
    contact = results.rigid
    a = contact.a
    curves = fem.load("2a")
    pressure, axis = curves.pressure_r, curves.axis_loaded
    figure = Figure(figsize=(8.6, 6.4), layout="constrained")
    rows = figure.subplots(3, 3, sharey="row")
    fine = np.linspace(-1.4, 1.4, 281)
    for column, mu in enumerate(F1_FRICTION):
        case = results.plastic[mu]
        first, second, third = rows[:, column]
        first.plot(fine, contact.pressure(fine * a) * 1e-9, "k--", linewidth=1, label="Hertz")
        first.plot(case.x / a, case.pressure * 1e-9, color="C0", label="samcontact")
        second.plot(case.z / a, case.von_mises * 1e-9, color="C0", label="samcontact")
        third.plot(case.z / a, 100 * case.gamma, color="C0", label="samcontact")
        if mu == 0:
            dots = {"color": "C3", "marker": ".", "linestyle": "none", "label": "finite elements"}
            inside, shown = pressure["r_m"] < 0.95 * a, (axis["z_m"] < 1.6 * a) & (axis["z_m"] > 0)
            first.plot(pressure["r_m"][inside] / a, pressure["p_Pa"][inside] * 1e-9, **dots)
            z = axis["z_m"][shown][::3] / a
            second.plot(z, axis["vonMises_Pa"][shown][::3] * 1e-9, **dots)
            third.plot(z, 100 * axis["gamma_p"][shown][::3], **dots)
        first.set_xlim(-1.4, 1.4)
        first.set_title(f"µ = {mu:g}", fontsize="medium")
        finish(first, "x/a", "pressure [GPa]" if mu == 0 else "", legend=mu == 0)
        finish(second, "depth z/a", "von Mises stress [GPa]" if mu == 0 else "", legend=mu == 0)
        finish(third, "depth z/a", "plastic strain [%]" if mu == 0 else "", legend=mu == 0)
        for ax in (second, third):
            ax.set_xlim(0, 1.6)
    return Picture(
        "friction_rigid_plastic",
        "Figures 2.41 to 2.49: rigid ball on M50, 800 N. Pressure in the plane y = 0, von Mises "
        "stress and equivalent plastic strain on x = y = 0.",
        figure,
    )


def onset_and_strain(results: Results) -> Picture:
    ball = results.ball
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    left, right = figure.subplots(1, 2)
    mu = np.linspace(0.0, 0.5, 51)
    found = [sc.critical.onset_sliding(RADIUS, ball.E_star, 0.3, MICRO_YIELD, m) for m in mu]
    left.plot(mu, [f.load / found[0].load for f in found], "C0", label="critical load")
    left.plot(mu, [f.interference / found[0].interference for f in found], "C3",
              label="critical interference")  # fmt: skip
    left.axvline(0.3, color="k", linestyle="--", linewidth=1, label="stated: surface above 0.3")
    left.set_ylim(0, 1.1)
    finish(left, "µ", "over that for µ = 0")
    for k, friction in enumerate(SHOWN):
        case = results.sliding[friction]
        pressure = ball.p0 * (case.loads / F2_LOAD) ** (1 / 3) / MICRO_YIELD
        positive = case.gamma_max > 0
        right.semilogy(
            pressure[positive], 100 * case.gamma_max[positive], color=f"C{k}",
            label=f"µ = {friction:g}",
        )  # fmt: skip
    end = ball.p0 / MICRO_YIELD
    for value, label in ((0.34, "stated: 0.34 and 5.34 %"), (5.34, None)):
        right.plot(end, value, "ko", markerfacecolor="none", label=label)
    right.set_ylim(1e-3, 20)
    finish(right, "Hertz pressure / micro-yield stress", "largest plastic strain [%]")
    return Picture(
        "friction_onset",
        "Figures 2.50 and 2.51: critical load and interference at the onset of yield (closed "
        "form), and the largest plastic strain against the Hertz pressure.",
        figure,
    )


def pressure_and_strain(results: Results) -> Picture:
    ball = results.ball
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    left, right = figure.subplots(1, 2)
    fine = np.linspace(-1.5, 1.5, 301)
    left.plot(fine, ball.pressure(fine * ball.a) * 1e-9, "k--", linewidth=1, label="Hertz")
    for k, mu in enumerate(SHOWN):
        case = results.sliding[mu]
        left.plot(case.x / ball.a, case.pressure * 1e-9, color=f"C{k}", label=f"µ = {mu:g}")
        right.plot(case.z / ball.a, 100 * case.gamma, color=f"C{k}", label=f"µ = {mu:g}")
    left.set_xlim(-1.5, 1.5)
    right.set_xlim(0, 1.6)
    right.set_ylim(-0.05, 1.5)
    right.axvline(HERTZ_DEPTH, color="k", linestyle=":", linewidth=1, label="Hertz depth")
    finish(left, "x/a", "pressure [GPa]")
    finish(right, "depth z/a", "plastic strain [%]")
    return Picture(
        "friction_pressure",
        "Figures 2.52 and 2.57: pressure in the plane y = 0, and equivalent plastic strain on "
        "x = y = 0 (for µ = 0.5 it goes on rising towards the surface), at 5000 N.",
        figure,
    )


def stress_profiles(results: Results) -> Picture:
    ball = results.ball
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    left, right = figure.subplots(1, 2)
    z = np.linspace(0.0, 1.8, 181) * ball.a
    radial, axial = ball.axis_stress(z, 0.3)
    left.plot(z / ball.a, np.abs(axial - radial) * 1e-9, "k--", linewidth=1, label="elastic, µ = 0")
    for k, mu in enumerate(SHOWN):
        case = results.sliding[mu]
        left.plot(case.z / ball.a, case.von_mises * 1e-9, color=f"C{k}", label=f"µ = {mu:g}")
        right.plot(case.z / ball.a, case.residual * 1e-6, color=f"C{k}", label=f"µ = {mu:g}")
    right.axvline(HERTZ_DEPTH, color="k", linestyle=":", linewidth=1, label="Hertz depth")
    for ax in (left, right):
        ax.set_xlim(0, 1.8)
    finish(left, "depth z/a", "von Mises stress [GPa]")
    finish(right, "depth z/a", "residual von Mises stress [MPa]")
    return Picture(
        "friction_von_mises",
        "Figures 2.53 and 2.54: von Mises stress on x = y = 0 at 5000 N and after unloading.",
        figure,
    )


def maximum(results: Results) -> Picture:
    a = results.ball.a
    mus = sorted(results.sliding)
    found = np.array([results.sliding[mu].von_mises_at for mu in mus])
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    left, right = figure.subplots(1, 2)
    left.plot(mus, found[:, 0] * 1e-9, "o-", markersize=3, color="C0", label="largest")
    near, below = np.array([rivals(results.sliding[mu], a) for mu in mus]).T
    left.plot(mus, below * 1e-9, ":", color="C2", label="below z = 0.2 a")
    left.plot(mus, near * 1e-9, ":", color="C3", label="above z = 0.2 a")
    right.plot(mus, found[:, 1] / a, "o-", markersize=3, color="C0", label="x/a")
    right.plot(mus, found[:, 2] / a, "s-", markersize=3, color="C3", label="z/a")
    for ax in (left, right):
        ax.axvline(0.32, color="k", linestyle="--", linewidth=1, label="stated: surface above 0.32")
    finish(left, "µ", "largest von Mises stress [GPa]")
    finish(right, "µ", "its position")
    return Picture(
        "friction_maximum",
        "Figure 2.55: value and position of the largest von Mises stress at 5000 N. Positions are "
        "those of cells.",
        figure,
    )


def residual_map(results: Results) -> Picture:
    case, a = results.sliding[0.0], results.ball.a
    figure = Figure(figsize=(6.0, 3.0))
    figure.subplots_adjust(left=0.12, right=0.98, bottom=0.16, top=0.96)
    ax = figure.subplots()
    levels = np.arange(0.0, 261.0, 20.0)
    filled = ax.contourf(
        case.x / a, case.z / a, case.surface_plane.T * 1e-6, levels, cmap="viridis"
    )
    figure.colorbar(filled, ax=ax, label="residual von Mises stress [MPa]")
    ax.axhline(HERTZ_DEPTH, color="w", linestyle=":", linewidth=1)
    ax.set(xlim=(-1.5, 1.5), ylim=(1.5, 0), aspect="equal", xlabel="x/a", ylabel="depth z/a")
    return Picture(
        "friction_residual_map",
        "Figure 2.56: residual von Mises stress in the plane y = 0 after 5000 N, µ = 0. Dotted: "
        "the Hertz depth.",
        figure,
    )


def hydrostatic(results: Results) -> Picture:
    a = results.ball.a
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    left, right = figure.subplots(1, 2, sharey=True)
    z = results.sliding[0.0].z / a
    for k, load in enumerate(sorted(results.by_load)):
        left.plot(z, results.by_load[load] * 1e-6, color=f"C{k}", label=f"{load:.0f} N")
    for k, mu in enumerate(SHOWN):
        case = results.sliding[mu]
        right.plot(case.z / a, case.hydrostatic * 1e-6, color=f"C{k}", label=f"µ = {mu:g}")
    for ax in (left, right):
        ax.axhline(0, color="k", linewidth=0.6)
        ax.axvline(HERTZ_DEPTH, color="k", linestyle=":", linewidth=1, label="Hertz depth")
        ax.set_xlim(0, 1.8)
        ax.set_ylim(-250, 80)
    finish(left, "depth z/a", "residual hydrostatic stress [MPa]")
    finish(right, "depth z/a")
    return Picture(
        "friction_hydrostatic",
        "Figures 2.58 and 2.59: residual hydrostatic stress on x = y = 0, for µ = 0 and loads up "
        "to 5000 N, and for 5000 N and µ up to 0.5. a is that of 5000 N.",
        figure,
    )


def first_layer(results: Results) -> Picture:
    figure = Figure(figsize=(5.0, 3.6), layout="constrained")
    ax = figure.subplots()
    depth, gamma = np.array(results.layers).T
    ax.plot(depth, 100 * gamma, "o-", color="C0", label="largest plastic strain")
    least = bound(0.5, float(results.sliding[0.5].pressure.max()))
    ax.axhline(100 * least, color="C3", linestyle=":", label="needed to bear the shear at z = 0")
    ax.axhline(5.34, color="k", linestyle="--", linewidth=1, label="stated: 5.34 %")
    ax.set(xlim=(0, 1.1 * depth.max()), ylim=(0, 14))
    finish(ax, "depth of the first layer z/a", "plastic strain [%]")
    return Picture(
        "friction_first_layer",
        "Not in the thesis: the largest plastic strain for µ = 0.5 and 5000 N against the depth "
        "at which it is taken.",
        figure,
    )

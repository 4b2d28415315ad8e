# SPDX-License-Identifier: GPL-3.0-or-later
"""A tool that heats a flat of steel 52100, at rest or moving over it: section 3.2.3."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

import samcontact as sc

from .bodies import ELASTIC, square
from .drawing import axes, finish
from .heat.scenes import E_STAR, STEEL, at_surface
from .page import Number, Picture, Statement
from .profiles import largest, von_mises

TITLE = "Transient frictional heat"
INTRODUCTION = """
Section 3.2.3 of the thesis: an elastic, adiabatic tool on a flat of steel AISI 52100, 1500 N, heat
factor 0.12 m/s. The tool (i) stays where it is and has heated the flat for 23 ms; (ii) the same in
the steady state; (iii) moves along +x at 0.95 m/s, and has done so for 23 ms. In (iii) the
flat moves through the contact with `velocity=(-0.95, 0)`. The thesis shows maps of these cases, its
text has few numbers. Radius: its 15 mm of diameter give 418 µm and 4.10 GPa; its 332 µm and 6.5 GPa
need half of that, which is taken here. It has no diffusivity: 1.367e-5 m²/s is taken (ρc = 3.67
MJ/(m³K)). All constants are independent of the temperature, which rises far beyond melting in (i)
and (ii).

In each increment the heat is that of a contact that has been as it is now for 23 ms. The
elastic-plastic flat is loaded once; in (iii) its plastic strain stays below the tool, where the
real one would be left behind.
"""

RADIUS, LOAD, FACTOR = 3.75e-3, 1500.0, 0.12
SPEED, TIME = 0.95, 23e-3
HERTZ = sc.hertz.point(R=RADIUS, E_star=E_STAR, load=LOAD)
assert STEEL.thermal is not None
CONDUCTIVITY, _, DIFFUSIVITY = STEEL.thermal
KINDS = {
    "no heat": sc.Heat(0.0),
    "(i)": sc.Heat(FACTOR, time=TIME),
    "(ii)": sc.Heat(FACTOR),
    "(iii)": sc.Heat(FACTOR, velocity=(-SPEED, 0.0), time=TIME),
}
NAMES = {
    "(i)": "(i) at rest, 23 ms",
    "(ii)": "(ii) at rest, steady",
    "(iii)": "(iii) moving, 23 ms",
}
EXTENT = {"no heat": (2.2, 2.4), "(i)": (3.1, 1.8), "(ii)": (3.1, 1.8), "(iii)": (2.4, 2.5)}
"""Half-width and depth over a of the grid of the elastic-plastic flat."""


@dataclass
class Elastic:
    x: np.ndarray
    z: np.ndarray
    pressure: np.ndarray
    """In the plane y = 0, as the other fields."""
    flash: np.ndarray
    temperature: np.ndarray
    von_mises: np.ndarray
    largest: tuple[float, float, float]
    """Von Mises stress, its x and z."""

    @property
    def hottest(self) -> tuple[float, float]:
        """Rise of temperature and x."""
        k = int(self.flash.argmax())
        return float(self.flash[k]), float(self.x[k])


@dataclass
class Plastic:
    x: np.ndarray
    z: np.ndarray
    von_mises: np.ndarray
    largest: tuple[float, float, float]
    gamma: float
    pressure: float
    residual: float
    """Largest, at the middle of a layer or, on the axis, at the surface."""


@dataclass
class Results:
    elastic: dict[str, Elastic]
    plastic: dict[str, Plastic]
    steady: Elastic
    """(iii) in its steady state."""
    times: np.ndarray
    rises: np.ndarray
    """Largest rise of temperature of a source at rest at these times."""
    pressures: np.ndarray
    """Largest pressure at these times."""
    mesh: dict[str, str]


def solver(cells: int, heat: sc.Heat) -> tuple[sc.ContactSolver, np.ndarray]:
    """Of an elastic flat, and its pressure."""
    grid = square(HERTZ.a, cells, 1.8)
    found = sc.ContactSolver(grid, ELASTIC, STEEL, heat=heat)
    return found, found.solve(sc.surfaces.paraboloid(grid, RADIUS), load=LOAD).pressure


def elastic_case(cells: int, depths: int, heat: sc.Heat) -> Elastic:
    contact, pressure = solver(cells, heat)
    x, m = contact.grid.x, contact.grid.ny // 2
    z = np.linspace(0.0, 1.2, depths) * HERTZ.a
    stress = von_mises(contact.stress(pressure, z)[:, :, m])
    rise = contact.temperature(pressure, z)[:, m]
    return Elastic(x, z, pressure[:, m], rise[:, 0], rise, stress, largest(stress, x, z))


def plastic_case(kind: str, cells: int, per_cell: int) -> Plastic:
    width, depth = EXTENT[kind]
    grid = square(HERTZ.a, cells, width, depth, per_cell)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, ELASTIC, STEEL, gap, heat=KINDS[kind])
    for load in np.linspace(0.0, LOAD, 11)[1:]:
        state = simulation.step(load=float(load))
    unloaded = simulation.step(load=0.0)
    m = grid.nx // 2
    stress, residual = state.von_mises()[:, m], unloaded.von_mises()
    return Plastic(
        grid.x, grid.z, stress, largest(stress, grid.x, grid.z),
        float(state.max_equivalent_plastic_strain()), float(state.pressure.max()),
        max(float(residual.max()), at_surface(residual[m, m])),
    )  # fmt: skip


def compute(quick: bool) -> Results:
    cells, depths = (12, 21) if quick else (32, 61)
    elastic = {kind: elastic_case(cells, depths, heat) for kind, heat in KINDS.items()}
    steady = elastic_case(cells, 2, sc.Heat(FACTOR, velocity=(-SPEED, 0.0)))
    plastic_cells, per_cell = (6, 2) if quick else (10, 2)
    plastic = {kind: plastic_case(kind, plastic_cells, per_cell) for kind in KINDS}
    times = np.geomspace(1e-4, 1e4, 9 if quick else 25)
    rises, pressures = [], []
    for time in times:
        contact, pressure = solver(cells, sc.Heat(FACTOR, time=float(time)))
        rises.append(float(contact.temperature(pressure).max()))
        pressures.append(float(pressure.max()))
    return Results(
        elastic, plastic, steady, times, np.array(rises), np.array(pressures),
        {
            "elastic": f"a/{cells}",
            "plastic": f"a/{plastic_cells}, layers a/{plastic_cells * per_cell}",
        },
    )  # fmt: skip


def still_missing(time: float) -> float:
    """What a source at rest lacks of its steady temperature after a long time [K].

    A point source has Q/(2 pi k r) erfc(r/sqrt(4 kappa t)): Carslaw & Jaeger (1959), section 10.4.
    """
    heat = FACTOR * LOAD
    return heat / (2 * math.pi * CONDUCTIVITY * math.sqrt(math.pi * DIFFUSIVITY * time))


def moving_source() -> float:
    """Largest rise below a parabolic source that moves [K], Tian & Kennedy (1994)."""
    flux = FACTOR * LOAD / (math.pi * HERTZ.a**2)
    peclet = SPEED * HERTZ.a / (2 * DIFFUSIVITY)
    return 2.32 * flux * HERTZ.a / (CONDUCTIVITY * math.sqrt(math.pi * (1.273 + peclet)))


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_steady(results), *stated_rise(results), *stated_stress(results)]


def tops(results: Results) -> dict[str, float]:
    """Largest elastic pressures [GPa]."""
    return {kind: float(case.pressure.max()) * 1e-9 for kind, case in results.elastic.items()}


def stated_steady(results: Results) -> list[Number | Statement]:
    mesh, top = results.mesh["elastic"], tops(results)
    rise = {kind: results.elastic[kind].hottest for kind in NAMES}
    steady, time = rise["(ii)"][0], float(results.times[-1])
    missing = (steady - results.rises[-1], still_missing(time))
    pressure_error = results.pressures[-1] * 1e-9 / top["(ii)"] - 1
    return [
        Number("Hertz pressure", 6.5, HERTZ.p0 * 1e-9, "GPa", "closed form"),
        Number("its contact radius", 332.0, HERTZ.a * 1e6, "µm", "closed form"),
        Number("largest pressure without heat", 6.5, top["no heat"], "GPa", mesh, tolerance=0.01),
        Statement(
            "time of observation set to infinity",
            "the steady state is reached",
            f"at {time:.0f} s the largest rise is {missing[0]:.2f} K ({missing[0] / steady:.1e}) "
            f"below the steady one, the largest pressure {abs(pressure_error):.0e}; a point source "
            f"lacks {missing[1]:.2f} K",
            missing[0] < 1e-3 * steady
            and abs(pressure_error) < 1e-3
            and abs(missing[0] / missing[1] - 1) < 0.02,
            mesh,
            remark="With the square root of time: after 23 ms "
            f"{100 * (1 - rise['(i)'][0] / steady):.0f} % of the rise is missing.",
        ),
    ]


def stated_rise(results: Results) -> list[Number | Statement]:
    a, mesh, case = HERTZ.a, results.mesh["elastic"], results.elastic
    rise = {kind: case[kind].hottest for kind in NAMES}
    estimate = moving_source()
    settled = float(np.abs(results.steady.flash / case["(iii)"].flash - 1).max())
    return [
        Statement(
            "largest rise of temperature in (i), (ii), (iii)",
            "maps, no numbers",
            ", ".join(f"{value:.0f} K" for value, _ in rise.values()),
            rise["(iii)"][0] < rise["(i)"][0] < rise["(ii)"][0],
            mesh,
        ),
        Statement(
            "(iii): largest rise",
            "not stated",
            f"{rise['(iii)'][0]:.0f} K; {estimate:.0f} K by the formula of Tian and Kennedy for a "
            "parabolic source with the radius a",
            abs(rise["(iii)"][0] / estimate - 1) < 0.08,
            mesh,
            remark="That formula is a fit, 1.5 % below the exact value of a semi-ellipsoidal "
            "source without motion.",
        ),
        Statement(
            "(iii): place of the largest rise",
            "not stated",
            f"behind the centre, at x/a = {rise['(iii)'][1] / a:.2f}; ahead of the contact "
            f"(x/a = 1.5) {ahead(case['(iii)']):.1f} K",
            -1.0 < rise["(iii)"][1] / a < -0.4 and ahead(case["(iii)"]) < 0.01 * rise["(iii)"][0],
            mesh,
        ),
        Statement(
            "(iii) at 23 ms against its steady state",
            "not stated",
            f"flash temperature {settled:.0e} apart: the tool has moved {SPEED * TIME / a:.0f} a",
            settled < 1e-3,
            mesh,
        ),
    ]


def stated_stress(results: Results) -> list[Number | Statement]:
    a, mesh, top = HERTZ.a, results.mesh["elastic"], tops(results)
    case, plastic = results.elastic, results.plastic
    return [
        Statement(
            "largest pressure in (i), (ii), (iii)",
            "not stated",
            ", ".join(f"{top[kind]:.2f} GPa" for kind in NAMES)
            + f", without heat {top['no heat']:.2f}",
            top["no heat"] < top["(iii)"] < 1.1 * top["no heat"] < top["(i)"] < top["(ii)"],
            mesh,
            remark="The flux is the same, but the flat carries the heat away, and bulges behind "
            "the tool: that widens the contact there.",
        ),
        Statement(
            "thermo-elastic: largest von Mises stress in (i), (ii), (iii)",
            "maps, no numbers",
            "; ".join(where(case[kind].largest) for kind in NAMES)
            + f"; without heat {where(case['no heat'].largest)}",
            case["(i)"].largest[2] == case["(ii)"].largest[2] == 0 < case["(iii)"].largest[2],
            mesh,
        ),
        Statement(
            "elastic-plastic: the same",
            "maps, no numbers",
            "; ".join(where(plastic[kind].largest) for kind in NAMES)
            + f"; without heat {where(plastic['no heat'].largest)}",
            plastic["(i)"].largest[2] < 0.25 * a and plastic["(iii)"].largest[2] > 0.35 * a,
            results.mesh["plastic"],
        ),
        Statement(
            "largest plastic strain; largest residual von Mises stress",
            "not stated",
            "; ".join(
                f"{100 * plastic[kind].gamma:.2f} %, {plastic[kind].residual * 1e-6:.0f} MPa "
                f"({kind.strip('()')})"
                for kind in KINDS
            ),
            plastic["(i)"].gamma < plastic["(ii)"].gamma < 0.05,
            results.mesh["plastic"],
            remark="The residual stress at the surface depends on the thickness of the layers: see "
            "[frictional heat](heat.md).",
        ),
    ]


def ahead(case: Elastic) -> float:
    return float(np.interp(1.5 * HERTZ.a, case.x, case.flash))


def where(found: tuple[float, float, float]) -> str:
    stress, x, z = found
    a = HERTZ.a
    return f"{stress * 1e-6:.0f} MPa at |x|/a = {abs(x) / a:.2f}, z/a = {z / a:.2f}"


def figures(results: Results) -> list[Picture]:
    return [flash(results), temperatures(results), stresses(results), approach(results)]


def flash(results: Results) -> Picture:
    figure, (left, right) = axes()
    for k, kind in enumerate(KINDS):
        case = results.elastic[kind]
        colour = "k" if kind == "no heat" else f"C{k - 1}"
        label = NAMES.get(kind, kind)
        if kind != "no heat":
            left.plot(case.x / HERTZ.a, case.flash, color=colour, label=label)
        right.plot(case.x / HERTZ.a, case.pressure * 1e-9, color=colour, label=label,
                   linestyle="--" if kind == "no heat" else "-")  # fmt: skip
    right.plot(0, 6.5, "ko", markerfacecolor="none", label="stated: 6.5 GPa")
    right.plot([-332 / HERTZ.a / 1e6, 332 / HERTZ.a / 1e6], [0, 0], "k|", markersize=12,
               label="stated: ±332 µm")  # fmt: skip
    left.set_ylim(-200, 6500)
    left.annotate("tool moves", xy=(1.7, 4200), xytext=(0.75, 4200), fontsize="small",
                  va="center", arrowprops={"arrowstyle": "->"})  # fmt: skip
    for ax in (left, right):
        ax.set_xlim(-1.8, 1.8)
    right.set_ylim(-0.2, 13)
    finish(left, "x/a", "rise of temperature of the surface [K]")
    finish(right, "x/a", "pressure [GPa]")
    return Picture(
        "transient_heat_flash",
        "Flash temperature along the direction of motion, and pressure; elastic flat.",
        figure,
    )


def temperatures(results: Results) -> Picture:
    figure = Figure(figsize=(10.0, 2.9), layout="compressed")
    for ax, kind in zip(figure.subplots(1, 3, sharey=True), NAMES, strict=True):
        case = results.elastic[kind]
        value, x = case.hottest
        shown = panel(ax, case.x, case.z, case.temperature, "inferno", NAMES[kind])
        figure.colorbar(shown, ax=ax, label="rise of temperature [K]", shrink=0.85,
                        location="bottom", ticks=MaxNLocator(5))  # fmt: skip
        ax.plot(x / HERTZ.a, 0, "wx", clip_on=False, zorder=4)
        ax.text(0.02, 0.05, f"largest: {value:.0f} K", transform=ax.transAxes, color="w",
                fontsize="small")  # fmt: skip
    figure.axes[0].set_ylabel("depth z/a")
    return Picture(
        "transient_heat_temperature",
        "Figures 3.34 to 3.36: rise of temperature in the plane y = 0, elastic flat. In (iii) the "
        "tool moves to the right. Cross: the largest.",
        figure,
    )


def stresses(results: Results) -> Picture:
    figure, rows = axes(2, 3, (10.0, 5.4), layout="compressed", sharex=True, sharey=True)
    both: tuple[dict[str, Any], ...] = (results.elastic, results.plastic)
    for row, cases, name in zip(rows, both, ("elastic", "elastic-plastic"), strict=True):
        for ax, kind in zip(row, NAMES, strict=True):
            case = cases[kind]
            stress, x, z = case.largest
            shown = panel(
                ax,
                case.x,
                case.z,
                case.von_mises * 1e-6,
                "viridis",
                NAMES[kind] if name == "elastic" else "",
            )
            figure.colorbar(shown, ax=ax, label="von Mises stress [MPa]", shrink=0.85,
                            location="bottom", ticks=MaxNLocator(6))  # fmt: skip
            ax.plot(x / HERTZ.a, z / HERTZ.a, "wx", clip_on=False, zorder=4)
            ax.text(0.02, 0.05, f"largest: {stress * 1e-6:.0f} MPa", transform=ax.transAxes,
                    color="w", fontsize="small")  # fmt: skip
        row[0].set_ylabel(f"{name}\ndepth z/a")
    return Picture(
        "transient_heat_von_mises",
        "Figures 3.34 to 3.36: von Mises stress in the plane y = 0; above an elastic flat, below "
        "an elastic-plastic one. Cross: the largest.",
        figure,
    )


def panel(
    ax: Axes, x: np.ndarray, z: np.ndarray, field: np.ndarray, colours: str, title: str
) -> Any:
    shown = ax.contourf(x / HERTZ.a, z / HERTZ.a, field.T, levels=12, cmap=colours)
    ax.set(xlim=(-1.7, 1.7), ylim=(1.15, 0), aspect="equal", xlabel="x/a")
    ax.set_title(title, fontsize="medium")
    return shown


def approach(results: Results) -> Picture:
    figure, ax = axes(1, 1, (5.6, 3.8))
    steady = results.elastic["(ii)"].hottest[0]
    top = float(results.elastic["(ii)"].pressure.max())
    ax.loglog(results.times, 1 - results.rises / steady, "o-", markersize=3, label="temperature")
    ax.loglog(results.times, 1 - results.pressures / top, "s-", markersize=3, label="pressure")
    ax.loglog(results.times, [still_missing(t) / steady for t in results.times], "k--",
              linewidth=1, label="point source, long times")  # fmt: skip
    ax.axvline(TIME, color="k", linestyle=":", linewidth=1, label="23 ms")
    ax.set_ylim(1e-9, 3)
    finish(ax, "time of heating [s]", "missing of the steady largest value")
    return Picture(
        "transient_heat_steady",
        "Not in the thesis: how (i) becomes (ii). What the largest temperature and pressure lack "
        "of their steady values.",
        figure,
    )

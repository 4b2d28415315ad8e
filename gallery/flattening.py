# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid sphere on an elastic, perfectly plastic half-space: figures 2.10 to 2.13 of the thesis."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import samcontact as sc
from reference import fem

from .page import Number, Picture, Statement

TITLE = "Flattening, perfect plasticity"
INTRODUCTION = """
A rigid sphere is pressed without friction on an elastic, perfectly plastic half-space, to 110
critical interferences: 2.3.1.2 of the thesis, which compares with the finite elements of Kogut and
Etsion (2002, [doi:10.1115/1.1490373](https://doi.org/10.1115/1.1490373)). Here the model of Jackson
and Green (2005, [doi:10.1115/1.1866166](https://doi.org/10.1115/1.1866166)) is drawn beside theirs;
both are in `samcontact.flattening`.

The thesis does not state the material. ν is 0.3 here, as in Kogut and Etsion. In the half-space
theory nothing else matters: load over critical load, area over critical area, the shape of the
plastic zone over the critical contact radius a_c, and plastic strain over Y/E (yield stress over
Young's modulus) are functions of ω/ω_c alone. Y/E is 10⁻⁴, for which the empirical models are at
their limit of small a/R.

Four grids cover the range, each for a part of it, so that the contact radius is never a few cells
only. A zone has reached a depth when the first cell there yields; the first layer of cells has its
centre half a layer below the surface, and the value at the surface is extrapolated from the first
two layers.
"""

E, NU, RADIUS = 210e9, 0.3, 10e-3
YIELD = 1e-4 * E
E_STAR = E / (1.0 - NU**2)
CRITICAL = sc.critical.kogut_etsion(RADIUS, E_STAR, NU, YIELD)
# steps of 10 to 15 %, through all interferences that are shown or compared
RATIOS = np.array(
    [1.2, 1.35, 1.5, 1.75, 2, 2.3, 2.6, 3, 3.5, 4, 4.5, 5, 5.5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18,
     20, 23, 26, 28, 30, 34, 40, 46, 52, 60, 70, 80, 95, 110]
)  # fmt: skip
RANGES = (1.0, 4.0, 14.0, 40.0, 110.0)
SMALL, LARGE = (2.0, 4.0, 6.0, 8.0, 11.0), (12.0, 20.0, 40.0, 70.0, 110.0)
COMPARED = (2.0, 4.0, 6.0, 10.0, 20.0, 30.0)
FRICTION = (0.0, 0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5)
REACHED = 5.0
"""Mesh study of the interference at which the zone reaches the surface, see `stated`."""


@dataclass(frozen=True)
class Point:
    """One interference: everything over its critical value, strain over Y/E."""

    ratio: float
    load: float
    area: float
    strain: float
    cells: float
    """Of the contact radius."""
    substeps: int
    core: float
    """Area in the plane y = 0, x >= 0, over a_c^2, that is elastic between surface and zone."""
    top: tuple[float, float]
    """Depths over a_c between which the axis has yielded."""
    outline: tuple[np.ndarray, np.ndarray, np.ndarray]
    """x, z over a_c, strain in the plane y = 0, x >= 0."""


@dataclass(frozen=True)
class Surface:
    """When the zone reaches the surface."""

    friction: float
    cells: int
    layers: tuple[float, float]
    """Interference ratio at which the first and the second layer yield."""

    @property
    def ratio(self) -> float:
        """At the surface, extrapolated linearly."""
        return 1.5 * self.layers[0] - 0.5 * self.layers[1]


@dataclass(frozen=True)
class Results:
    points: list[Point]
    surface: list[Surface]
    """One for each coefficient of friction."""
    study: list[Surface]
    """Without friction, on other meshes."""
    cells: int

    def at(self, ratio: float) -> Point:
        return min(self.points, key=lambda point: abs(point.ratio - ratio))


def compute(quick: bool) -> Results:
    """Coarse grids when quick."""
    cells, per_critical, study = (14, 6, ()) if quick else (28, 12, (6, 9, 16))
    points = []
    for above, top in pairwise(RANGES):
        points += flatten(above, top, cells, parts=1 if quick else 3)
    return Results(
        points,
        [reach_surface(friction, per_critical) for friction in FRICTION],
        [reach_surface(0.0, count) for count in study],
        cells,
    )


def simulation(
    spacing: float, half_width: float, depth: float, friction: float = 0.0
) -> sc.Simulation:
    """Cubic cells; all lengths over the critical contact radius."""
    n, nz = 2 * round(half_width / spacing) + 1, round(depth / spacing)
    d = spacing * CRITICAL.a
    grid = sc.Grid(n, n, d, d, nz, d)
    body = sc.Material.perfect_plastic(E, NU, YIELD)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    return sc.Simulation(grid, sc.Material.rigid(), body, gap, friction)


def flatten(above: float, top: float, cells: int, parts: int) -> list[Point]:
    """Points of one range: a contact radius of `cells` at its top, each step in `parts`."""
    model = sc.flattening.kogut_etsion(top * CRITICAL.interference, RADIUS, E_STAR, NU, YIELD)
    radius = float(np.sqrt(model.area_ratio))
    wide = np.interp(np.log(top), np.log([12, 110]), [1.35, 1.75])
    deep = np.interp(np.log(top), np.log([12, 110]), [1.9, 2.6])
    solver = simulation(radius / cells, wide * radius, deep * radius)
    points, before = [], 1.0
    for ratio in RATIOS[top >= RATIOS]:
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
    # depth of the first cell that flows, in each column under the contact
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


def reach_surface(friction: float, cells: int, limit: float = 6.0) -> Surface:
    """Interference at which the first layers yield, with `cells` per critical contact radius."""
    solver = simulation(1.0 / cells, 1.15 * limit**0.5 + 0.4, 1.9 * limit**0.5, friction)
    reached: dict[int, float] = {}
    before: list[tuple[float, np.ndarray]] = []
    for ratio in np.geomspace(0.3, limit, 80):
        state = solver.step(approach=ratio * CRITICAL.interference)
        # von Mises over yield stress, largest of a layer: extrapolated where it would pass 1
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
    """Both empirical models on a fine range of interference."""
    w = np.geomspace(1.0, 110.0, 300) * CRITICAL.interference
    return {
        "Kogut-Etsion": sc.flattening.kogut_etsion(w, RADIUS, E_STAR, NU, YIELD),
        "Jackson-Green": sc.flattening.jackson_green(w, RADIUS, E_STAR, NU, YIELD),
    }


def stated(results: Results) -> list[Number | Statement]:
    """What the thesis states beside what was computed."""
    mesh = f"{results.cells // 2} to {results.cells} cells per contact radius"
    reached = results.surface[0]
    entries: list[Number | Statement] = [
        core_at_two(results, mesh),
        Number(
            "ω/ω_c at which the plastic zone reaches the surface",
            6.0,
            reached.ratio,
            "",
            f"{reached.cells} cells per a_c",
            converged=REACHED,
            remark=surface_remark(results),
        ),
        core_shrinks(results, mesh),
        strain_limit(results, mesh),
    ]
    entries += [against(name, results, mesh) for name in models()]
    return [*entries, *friction(results)]


def core_at_two(results: Results, mesh: str) -> Statement:
    at = results.at(2.0)
    return Statement(
        "elastic core at the surface, ω/ω_c = 2",
        "found",
        f"on the axis the zone goes from {at.top[0]:.2f} to {at.top[1]:.2f} a_c; nothing yields "
        "at the surface",
        at.top[0] > 0.1 and not at.outline[2][:, 0].any(),
        mesh,
    )


def core_shrinks(results: Results, mesh: str) -> Statement:
    ratios = (6.0, 20.0, 40.0, 110.0)
    areas = [results.at(ratio).core for ratio in ratios]
    radii = [results.at(ratio).area ** 0.5 for ratio in ratios]
    parts = [area / radius**2 for area, radius in zip(areas, radii, strict=True)]
    listed = ", ".join(f"{100 * part:.1f}" for part in parts)
    return Statement(
        "elastic core at the surface, ω/ω_c > 6",
        "gradually shrinks",
        f"its cross-section (y = 0, x ≥ 0) is {listed} % of the squared contact radius at 6, 20, "
        "40 and 110",
        bool(np.all(np.diff(parts) <= 0) and areas[-1] < 0.1 * areas[0]),
        mesh,
        "The core is what has never flowed under the contact, between the surface and the zone. On "
        "the finest mesh that was tried (48 cells per contact radius) its area is 0.50 a_c² at 6, "
        "0.47 at 14, 0.50 at 20, 0.36 at 28, 0.34 at 40, and it is gone at 60: at first it shrinks "
        "only against the contact that grows. With few cells per a_c it is gone sooner.",
    )


def strain_limit(results: Results, mesh: str) -> Statement:
    strain = results.at(28.0).strain
    needed = 0.05 / strain
    return Statement(
        "largest plastic strain exceeds 5 %",
        "at ω/ω_c = 28",
        f"{strain:.2f} Y/E at 28: 5 % for Y/E = {100 * needed:.2f} %",
        # the law is self-similar: the statement is one about the material
        0.0065 < needed < 0.0095 and bool(np.all(np.diff([p.strain for p in results.points]) > 0)),
        mesh,
        "The thesis does not say for which material. The largest strain is near the surface in a "
        "ring under the edge of the contact, and scatters with mesh and increments: at 28, 6.8, "
        "6.7, 6.4, 6.0 Y/E with 11, 20, 28, 40 cells per contact radius, increments of 3 to 5 %; "
        "6.6 with 28 cells and increments of 2 to 3 %; on the axis 5.6. 5 % then needs Y/E of 0.74 "
        "to 0.83 %, i.e. 1.55 to 1.74 GPa for E = 210 GPa; the nitrided steel of the thesis starts "
        "to yield at 1.66 GPa.",
    )


def against(name: str, results: Results, mesh: str) -> Statement:
    """Load against a model: at most 7 % up to 30 critical interferences."""
    model = getattr(sc.flattening, name.lower().replace("-", "_"))
    differences: dict[str, list[float]] = {"load": [], "area": [], "pressure": []}
    for ratio in COMPARED:
        at = results.at(ratio)
        there = model(ratio * CRITICAL.interference, RADIUS, E_STAR, NU, YIELD)
        load = at.load * CRITICAL.load / there.load
        area = at.area * np.pi * CRITICAL.a**2 / there.area
        for key, value in (("load", load), ("area", area), ("pressure", load / area)):
            differences[key].append(value - 1)
    loads = ", ".join(f"{100 * value:+.1f}" for value in differences["load"])
    ranges = {
        key: f"{100 * min(v):+.0f} to {100 * max(v):+.0f} %" for key, v in differences.items()
    }
    return Statement(
        f"load, {name}, ω/ω_c from 2 to 30",
        "fairly good agreement" if name == "Kogut-Etsion" else "not compared",
        f"{loads} %",
        max(np.abs(differences["load"])) < 0.07,
        mesh,
        f"At {', '.join(f'{ratio:g}' for ratio in COMPARED)} critical interferences; asserted to "
        f"7 %. Contact area {ranges['area']}, mean pressure {ranges['pressure']}; the area is "
        "counted in cells.",
    )


def friction(results: Results) -> list[Statement]:
    ratios = [surface.ratio for surface in results.surface]
    mesh = f"{results.surface[0].cells} cells per a_c"
    listed = ", ".join(f"{s.ratio:.2f} (μ = {s.friction:g})" for s in results.surface)
    return [
        Statement(
            "friction and the ω/ω_c at which the zone reaches the surface",
            "decreases it",
            listed,
            bool(np.all(np.diff(ratios) < 0)),
            mesh,
            "Sliding in the whole contact, with the effect of the shear on the pressure; a rigid "
            "sphere. From about μ = 0.3 the surface yields first. Quadrature of the point-load "
            "solutions for Hertz's pressure and its shear gives 0.71 (μ = 0.4) and 0.47 (μ = 0.5).",
        ),
        Statement(
            "the same for high friction",
            "below 1",
            f"{ratios[-2]:.2f} (μ = {FRICTION[-2]:g}), {ratios[-1]:.2f} (μ = {FRICTION[-1]:g})",
            max(ratios[-2:]) < 1.0,
            mesh,
        ),
    ]


def surface_remark(results: Results) -> str:
    text = (
        "First yield is at 0.5 a_c under the axis. The zone grows outward and up, and comes to the "
        "surface in a ring just inside the edge of the contact, while the core within it stays "
        f"elastic. Converged: {REACHED:.1f} (to 0.1), 17 % below the 6 of the thesis, which takes "
        "that number from Kogut and Etsion. "
    )
    if results.study:
        rows = "; ".join(
            f"{s.cells} cells: {s.layers[0]:.2f}, {s.ratio:.2f}"
            for s in sorted([*results.study, results.surface[0]], key=lambda s: s.cells)
        )
        text += f"Cells per a_c, first layer and extrapolated to the surface: {rows}. "
    return text + "The two bracket the limit: the first layer yields too early, at half its depth."


def figures(results: Results) -> list[Picture]:
    """Figures 2.10 to 2.13, and load, area and mean pressure against both models."""
    return [
        Picture(
            "flattening_zone_small",
            "Figure 2.10: outlines of the plastic zone in the plane y = 0, for 2 to 11 critical "
            "interferences. Stated: elastic core at the surface at 2, zone at the surface at 6.",
            zones(results, SMALL, zoom=True),
        ),
        Picture(
            "flattening_zone_large",
            "Figure 2.11: the same for 12 to 110 critical interferences.",
            zones(results, LARGE, zoom=False),
        ),
        Picture(
            "flattening_strain",
            "Figure 2.12: largest equivalent plastic strain, as a multiple of Y/E, and in percent "
            "for the material that has the stated 5 % at 28.",
            strain_figure(results),
        ),
        Picture(
            "flattening_friction",
            "Figure 2.13: interference at which the plastic zone reaches the surface. Stated: 6 "
            "without friction, less with friction, below 1 for high friction.",
            friction_figure(results),
        ),
        Picture(
            "flattening_models",
            "Load, contact area and mean pressure with the models of Kogut and Etsion and of "
            "Jackson and Green, and finite elements for ν = 0.32. Dashed: 2 and 30, between which "
            "the load agrees with both models to 7 %.",
            model_figure(results),
        ),
    ]


def new_axes(width: float = 6.0, height: float = 4.2) -> tuple[Figure, Axes]:
    figure = Figure(figsize=(width, height), layout="constrained")
    ax = figure.subplots()
    ax.grid(True, linewidth=0.4, alpha=0.5)
    return figure, ax


def zones(results: Results, ratios: tuple[float, ...], zoom: bool) -> Figure:
    figure = Figure(figsize=(8.5, 4.6) if zoom else (6.0, 4.6), layout="constrained")
    panels = figure.subplots(1, 2, width_ratios=(1, 1.15)) if zoom else [figure.subplots()]
    colours = colormaps["viridis"](np.linspace(0.0, 0.9, len(ratios)))
    for ax in panels:
        ax.grid(True, linewidth=0.4, alpha=0.5)
        for ratio, colour in zip(ratios, colours, strict=True):
            outline(ax, results.at(ratio), colour)
        ax.plot([], [], "kv", label="edge of the contact")
        ax.set_xlabel("$x / a_c$")
    x, z, g = results.at(ratios[-1]).outline
    panels[0].set_xlim(0, 1.12 * x[(g > 0).any(axis=1)].max())
    panels[0].set_ylim(1.08 * z[(g > 0).any(axis=0)].max(), 0)
    panels[0].set_aspect("equal")
    panels[0].set_ylabel("$z / a_c$")
    if zoom:
        surface(panels[1], results.surface[0].ratio)
    panels[-1].legend(frameon=False, fontsize=9, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def outline(ax: Axes, at: Point, colour: np.ndarray) -> None:
    x, z, g = at.outline
    # up to the surface, with the strain of the first layer
    z, g = np.append(0.0, z), np.column_stack([g[:, :1], g])
    ax.contour(x, z, g.T, levels=[1e-2], colors=[colour], linewidths=1.4)
    ax.plot([], [], color=colour, label=rf"$\omega/\omega_c$ = {at.ratio:g}")
    ax.plot(at.area**0.5, 0.0, "v", color=colour, clip_on=False, zorder=3)


def surface(ax: Axes, reached: float) -> None:
    """The part of the first figure near the surface, with what the thesis states about it."""
    ax.set_title("near the surface", fontsize=10)
    ax.set_xlim(0, 4.4)
    ax.set_ylim(1.0, 0)
    box = {"facecolor": "white", "edgecolor": "none", "alpha": 0.9, "pad": 1.5}
    text = "elastic core above the lines\nthesis: found at 2, shrinks above 6"
    ax.text(0.1, 0.46, text, fontsize=9, bbox=box)
    edge = reached**0.5 * 1.04
    ax.axvline(edge, color="k", linestyle="--", linewidth=0.8)
    text = f"zone reaches the surface\nthesis: at 6, here: at {reached:.1f}"
    ax.text(edge - 0.05, 0.97, text, fontsize=9, ha="right", va="bottom", bbox=box)


def strain_figure(results: Results) -> Figure:
    figure, ax = new_axes()
    ratio = [p.ratio for p in results.points]
    strain = np.array([p.strain for p in results.points])
    ax.plot(ratio, strain, "o-", ms=3)
    at = results.at(28.0).strain
    ax.axvline(28, color="k", linestyle="--", linewidth=0.8)
    ax.axhline(at, color="k", linestyle="--", linewidth=0.8)
    ax.text(29, 0.2, "thesis: 28", rotation=90, va="bottom")
    ax.text(109, at - 0.15, "thesis: 5 %", ha="right", va="top")
    right = ax.secondary_yaxis(
        "right", functions=(lambda g: np.multiply(g, 5 / at), lambda p: np.multiply(p, at / 5))
    )
    right.set_ylabel(f"for Y/E = {5 / at:.2f} % [%]")
    ax.set_xlim(0, 112)
    ax.set_ylim(0, None)
    ax.set_xlabel(r"$\omega/\omega_c$")
    ax.set_ylabel("largest equivalent plastic strain / (Y/E)")
    return figure


def friction_figure(results: Results) -> Figure:
    figure, ax = new_axes()
    ax.plot(
        [s.friction for s in results.surface],
        [s.ratio for s in results.surface],
        "o-",
        ms=4,
        label="computed",
    )
    for value, label in ((6, "thesis, no friction: 6"), (1, "thesis: below 1, high friction")):
        ax.axhline(value, color="k", linestyle="--", linewidth=0.8)
        ax.text(0.5, value + 0.25 * (value < 2) + 0.06, label, ha="right", va="bottom")
    ax.set_xlim(-0.01, 0.51)
    ax.set_ylim(0, 6.6)
    ax.set_xlabel("coefficient of friction μ")
    ax.set_ylabel(r"$\omega/\omega_c$, zone at the surface")
    ax.legend(frameon=False, loc="center right")
    return figure


def model_figure(results: Results) -> Figure:
    figure = Figure(figsize=(9.0, 3.4), layout="constrained")
    panels = figure.subplots(1, 3)
    ratio = np.array([p.ratio for p in results.points])
    load, area = (np.array([getattr(p, k) for p in results.points]) for k in ("load", "area"))
    w = np.geomspace(1.0, 110.0, 300)
    unit = CRITICAL.load / (np.pi * CRITICAL.a**2) / YIELD
    curve = fem.load("2d").load_displacement
    rising = curve[1 : int(np.argmax(curve["approach_m"])) + 1]
    rising = rising[rising["approach_over_wc"] >= 1][::4]
    for ax in panels:
        ax.grid(True, linewidth=0.4, alpha=0.5)
        ax.set_xscale("log")
        ax.set_xlabel(r"$\omega/\omega_c$")
        for value in (2, 30):
            ax.axvline(value, color="k", linestyle="--", linewidth=0.8)
    for (name, model), style in zip(models().items(), ("C1-", "C2-"), strict=True):
        # loads over w^(5/4), or three decades would hide the differences
        relative = np.asarray(model.load) / CRITICAL.load
        area_ratio = np.asarray(model.area) / (np.pi * CRITICAL.a**2)
        panels[0].plot(w, relative / w**1.25, style, label=name)
        panels[1].plot(w, area_ratio / w, style)
        panels[2].plot(w, relative / area_ratio * unit, style)
    panels[0].plot(ratio, load / ratio**1.25, "C0o", ms=3, label="computed")
    panels[0].plot(
        rising["approach_over_wc"], rising["load_over_Wc"] / rising["approach_over_wc"] ** 1.25,
        "k+", ms=5, label="finite elements",
    )  # fmt: skip
    panels[1].plot(ratio, area / ratio, "C0o", ms=3)
    panels[2].plot(ratio, load / area * unit, "C0o", ms=3)
    for ax, label in zip(
        panels,
        (
            r"load / $P_c$ / $(\omega/\omega_c)^{1.25}$",
            r"area / $A_c$ / $(\omega/\omega_c)$",
            "mean pressure / Y",
        ),
        strict=True,
    ):  # fmt: skip
        ax.set_ylabel(label)
    panels[0].legend(frameon=False, fontsize=8)
    return figure

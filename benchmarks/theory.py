# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.theory --docs: recompute the tables of numbers in docs/theory.

Each table lies between markers that name its function in this module.
"""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Callable, Sequence

import click
import numpy as np

import samcontact as sc
from samcontact import shakedown

from . import adhesive_craters, adhesive_spheres, increment_errors, roller_ends
from .steel import LOAD, balls
from .study import ROOT, table

PAGES = sorted((ROOT / "docs" / "theory").glob("*.md"))
MARKED = re.compile(r"(<!-- table: (\w+) -->\n).*?(<!-- end of table -->)", re.DOTALL)
RIGID, STEEL = sc.Material.rigid(), sc.Material.elastic(210e9, 0.3)
FRICTIONS = (0.0, 0.1, 0.2, 0.3, 0.35, 0.4, 0.5)
ROUGH = ((256, 0.8), (256, 0.3), (1024, 0.8), (1024, 0.3))  # cells across, Hurst exponent


def press(gap: np.ndarray, grid: sc.Grid, load: float) -> list[sc.ContactSolution]:
    """Solve under load control, then under approach control at the approach found; return both."""
    solver = sc.ContactSolver(grid, RIGID, STEEL, on_border="warn")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.GridTooSmallWarning)
        warnings.simplefilter("ignore", sc.ResolutionWarning)
        by_load = solver.solve(gap, load=load)
        return [by_load, solver.solve(gap, approach=by_load.approach)]


def contact_counts(rough: Sequence[tuple[int, float]] = ROUGH) -> str:
    """Return the table of iterations and work of elastic contacts, by load and approach control."""
    grid = sc.Grid(256, 256, 1e-6, 1e-6)
    modulus = sc.hertz.effective_modulus(RIGID, STEEL)
    hertz = sc.hertz.point(10e-3, modulus, approach=(64e-6) ** 2 / 10e-3)
    gap = sc.surfaces.paraboloid(grid, 10e-3)
    cases = {"ball, 256 × 256 cells, 64 per contact radius": press(gap, grid, hertz.load)}
    for n, hurst in rough:
        grid = sc.Grid(n, n, 1e-6, 1e-6)
        heights = sc.surfaces.rough_self_affine(
            grid, 1e-7, hurst, wavelength_min=4e-6, roll_off=n / 8 * 1e-6, seed=1
        )
        slope = math.sqrt(2) * np.diff(heights, axis=0).std() / grid.dx
        found = press(heights - heights.min(), grid, 0.05 * modulus * slope * (n * 1e-6) ** 2)
        share = 100 * np.mean(found[0].pressure > 0)
        cases[f"rough, Hurst {hurst:g}, {n} × {n}, contact on {share:.0f} %"] = found
    rows = [
        [
            name,
            ", ".join(str(one.iterations) for one in found),
            ", ".join(str(one.operator_applications) for one in found),
            ", ".join(f"{one.work:.0f}" for one in found),
        ]
        for name, found in cases.items()
    ]
    return table(["contact", "steps", "exact displacements", "work"], rows)


def shakedown_limits(frictions: Sequence[float] = FRICTIONS) -> str:
    """Return the table of shakedown limits p₀/k in rolling with friction; k: shear yield stress."""
    limits: dict[str, Callable[[float], shakedown.ShakedownLimit]] = {
        "line, Tresca": lambda mu: shakedown.line(mu, criterion="tresca"),
        "line, von Mises": lambda mu: shakedown.line(mu, criterion="von_mises"),
        "line, kinematic": shakedown.line_kinematic,
        "circle, upper bound": shakedown.point,
        "circle, lower bound": shakedown.point_lower_bound,
    }
    rows = [
        [name, *(f"{limit(mu).ratio:.3f}" for mu in frictions)] for name, limit in limits.items()
    ]
    return table(["μ", *(f"{mu:g}" for mu in frictions)], rows)


def rolling_reach(steps: int = 100) -> str:
    """Return the table of relative pressure errors if the track beyond `reach` is neglected."""
    body = sc.Material.elastic(310e9, 0.29)
    steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
    d, radius, load = 80e-6, 4.7625e-3, 1150.0
    a = sc.hertz.point(radius, sc.hertz.effective_modulus(body, steel), load=load).a
    path = [{"load": load * k / 4} for k in range(1, 5)]
    path += [{"load": load, "advance": (-d, -d)}] * steps

    def pressure(n: int, reach: float | None) -> np.ndarray:
        grid = sc.Grid(n, 15, d, d, 12, 0.75 * d)
        gap = sc.surfaces.paraboloid(grid, radius)
        simulation = sc.Simulation(grid, body, steel, gap, residual_stress="fast", reach=reach)
        return np.asarray(simulation.run(path, progress=False)[-1].pressure)

    rows = []
    for n in (21, 31):
        exact = pressure(n, 1.0)
        errors = [np.abs(pressure(n, reach) - exact).max() / exact.max()
                  for reach in (0.0, 0.5 * n * d, None)]  # fmt: skip
        rows.append([f"{n * d / a:.1f} contact radii", *(f"{error:.0e}" for error in errors)])
    heading = ["length of the grid", "reach 0", "half the grid", "the grid (default)"]
    return table(heading, [[cell.replace("e-0", "e-") for cell in row] for row in rows])


def rollers(ratio: float, friction: float, hardening: float) -> tuple[sc.Simulation, list]:
    """Return a simulation of rollers at distances of 6 half-widths, and the steps of one pass."""
    shear_limit, width = 50e6, 1e-4
    body = sc.Material.perfect_plastic(210e9, 0.3, math.sqrt(3) * shear_limit)
    if hardening:
        body = body.with_kinematic_hardening(hardening * body.E)
    grid = sc.Grid(60, 1, 0.1 * width, 1e-3, nz=30, dz=0.1 * width, periodic="xy")
    modulus = sc.hertz.effective_modulus(STEEL, body)
    p0 = ratio * shear_limit
    contact = sc.hertz.line(0.5 * width * modulus / p0, modulus, p0=p0)
    flat = np.zeros(grid.surface_shape)
    made = sc.Simulation(grid, STEEL, body, flat, friction, residual_stress="fast")
    return made, list(shakedown.passes(grid, contact.pressure(grid.x)[:, None], cells=2))


CYCLES = ((3.9, 0.0, 0.0), (4.1, 0.0, 0.0), (3.4, 0.2, 0.0), (4.1, 0.0, 0.05), (4.1, 0.2, 0.1))


def shakedown_cycles(cases: Sequence[tuple[float, float, float]] = CYCLES) -> str:
    """Return the table of shakedown results, with and without jumps over cycles."""
    rows = []
    for ratio, friction, hardening in cases:
        name = f"{ratio:g}, " + (f"μ = {friction:g}" if friction else "no friction")
        name += f", kinematic, E/{1 / hardening:.0f}" if hardening else ""
        found = [
            shakedown.run(*rollers(ratio, friction, hardening), progress=False, accelerate=jumps)
            for jumps in (True, False)
        ]
        strains = [f"{1e3 * one.rate / one.yield_strain:.3g}" for one in found]
        cycles = [f"{one.solved} of {one.cycles[-1].number}" for one in found]
        rows.append([name, *dict.fromkeys(one.response for one in found), *cycles, *strains])
    modes = ("with jumps", "without jumps")
    heading = ["load, friction", "result"]
    heading += [f"cycles solved of cycles covered, {mode}" for mode in modes]
    heading += [f"strain of the last cycle, {mode} [10⁻³ σ_y/E]" for mode in modes]
    return table(heading, rows)


ERRORS = {
    "approach": "approach",
    "max_pressure": "maximum pressure",
    "contact_area": "contact area",
    "max_von_mises_body2": "maximum von Mises stress",
    "max_equivalent_plastic_strain_body2": "maximum plastic strain",
    "max_residual_von_mises_body2": "residual von Mises stress",
    "imprint_depth_body2": "imprint depth",
}
CIRCLES = (4, 5, 6, 7, 8, 9, 10, 12, 14, 17, 20, 23, 26)  # cells per radius
ELLIPSES = (5.3, 40.0)  # ratios of the radii of curvature, for semi-axes of 1:3 and 1:11
T1 = (8, 9, 11, 13, 15, 18, 21)
FINER = 3


def pressed(lower: sc.Material, cell: float, reach: tuple[float, float], Ry: float, load: float,
            parts: Sequence[float]) -> sc.GridErrors:  # fmt: skip
    """Press a ball by fractions of a load; return the estimated errors. reach: grid half-widths."""
    nx, ny = (2 * math.ceil(half / cell) + 1 for half in reach)
    grid = sc.Grid(nx, ny, cell, cell, dz=cell, nz=math.ceil(1.2 * min(reach) / cell))
    path = [{"load": part * load} for part in parts]
    simulation = sc.Simulation(
        grid, STEEL, lower, lambda grid: sc.surfaces.paraboloid(grid, 7.5e-3, Ry)
    )
    states = simulation.run(path, progress=False)
    return sc.estimate_errors(simulation, path, states)


def compared(found: sc.GridErrors, truth: dict[str, float]) -> dict[str, float]:
    """Return the ratio of estimated to true error at the maximum of each quantity."""
    ratios = {}
    for name, true in truth.items():
        at = int(np.nanargmax(np.abs(found.values[name])))
        ratios[name] = found.errors[name][at] / abs(found.values[name][at] - true)
    return ratios


def hertz_ratios(cells: int, ratio: float) -> dict[str, float]:
    """Return ratios of estimated to true errors (`compared`) for an elastic Hertz contact."""
    modulus = sc.hertz.effective_modulus(STEEL, STEEL)
    exact = sc.hertz.elliptic(7.5e-3, ratio * 7.5e-3, modulus, load=1500.0)
    truth = {"approach": exact.approach, "max_pressure": exact.p0,
             "contact_area": math.pi * exact.a_x * exact.a_y}  # fmt: skip
    if ratio == 1:
        round_ = sc.hertz.point(7.5e-3, modulus, load=1500.0)
        truth["max_von_mises_body2"] = round_.max_von_mises(0.3)[0]
    cell = min(exact.a_x, exact.a_y) / cells
    reach = (1.25 * exact.a_x, 1.25 * exact.a_y)
    return compared(pressed(STEEL, cell, reach, ratio * 7.5e-3, 1500.0, (1.0,)), truth)


def grid_errors(
    circles: Sequence[int] = CIRCLES, ellipses: Sequence[float] = ELLIPSES, t1: Sequence[int] = T1
) -> str:
    """Return the table of ratios of errors estimated by `sc.estimate_errors` to true errors."""
    found = [hertz_ratios(n, 1.0) for n in circles]
    found += [hertz_ratios(n, ratio) for ratio in ellipses for n in circles[:7:2]]
    a = sc.hertz.point(7.5e-3, sc.hertz.effective_modulus(STEEL, STEEL), load=1500.0).a
    swift = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)

    def ball(n: int) -> sc.GridErrors:
        return pressed(swift, a / n, (1.25 * a, 1.25 * a), 7.5e-3, 1500.0, (0.5, 1.0, 0.0))

    if t1:
        fine = ball(FINER * max(t1)).values
        truth = {name: float(np.nanmax(np.abs(fine[name]))) for name in ERRORS}
        found += [compared(ball(n), truth) for n in t1]
    rows = []
    for name, label in (*ERRORS.items(), ("", "all")):
        ratios = [v for one in found for key, v in one.items() if name in ("", key)]
        if ratios:
            enough = sum(ratio >= 1 for ratio in ratios)
            rows.append([label, f"{np.median(ratios):.1f}", f"{min(ratios):.1f}",
                         f"{enough} of {len(ratios)}"])  # fmt: skip
    return table(
        ["quantity", "estimated error / true error, median",
         "estimated error / true error, minimum",
         "cases in which the estimated error is at least the true error"],
        rows,
    )  # fmt: skip


def increments(few: Sequence[int] = (1, 4, 16), many: int = 64, across: int = 16) -> str:
    """Return the table of errors of two balls, loaded in different numbers of increments."""

    def values(count: int) -> np.ndarray:
        simulation = balls(across)
        for k in range(count):
            loaded = simulation.step(load=LOAD * (k + 1) / count)
        strain = loaded.max_equivalent_plastic_strain()
        unloaded = simulation.step(load=0.0)
        stress = unloaded.von_mises()[simulation.grid.nx // 2, simulation.grid.ny // 2].max()
        depth = unloaded.residual_displacement().max()
        return np.array([strain, loaded.pressure.max(), stress, depth])

    truth = values(many)
    rows = [
        [str(count), *(f"{100 * change:.1g}" for change in np.abs(values(count) / truth - 1))]
        for count in few
    ]
    heading = ["increments", "plastic strain [%]", "maximum pressure [%]"]
    return table([*heading, "residual von Mises stress on the axis [%]", "imprint depth [%]"], rows)


TABLES: dict[str, Callable[[], str]] = {
    "contact_counts": contact_counts,
    "rolling_reach": rolling_reach,
    "increments": increments,
    "grid_errors": grid_errors,
    "increment_errors": increment_errors.stated_errors,
    "shakedown_limits": shakedown_limits,
    "shakedown_cycles": shakedown_cycles,
    "roller_end": roller_ends.stated_pressures,
    "maugis": adhesive_spheres.maugis,
    "craters": adhesive_craters.craters,
    "adhesion_cost": adhesive_craters.adhesion_cost,
}


def page(text: str, made: dict[str, str]) -> str:
    """Return the text of a page with new tables between the markers."""

    def replaced(match: re.Match[str]) -> str:
        head, name, tail = match.groups()
        return f"{head}\n{made[name]}\n\n{tail}" if name in made else match[0]

    return MARKED.sub(replaced, text)


@click.command(help=__doc__)
@click.argument("names", nargs=-1, metavar="[TABLE]...", type=click.Choice(list(TABLES)))
@click.option("--docs", is_flag=True, help="Write the tables into docs/theory.")
def main(names: tuple[str, ...], docs: bool) -> None:
    made = {name: TABLES[name]() for name in names or TABLES}
    click.echo("\n\n".join(made.values()))
    if docs:
        for file in PAGES:
            text = file.read_text(encoding="utf-8")
            if (new := page(text, made)) != text:
                file.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main(prog_name="python -m benchmarks.theory")

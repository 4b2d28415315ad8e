# SPDX-License-Identifier: GPL-3.0-or-later
"""Examples of the program CONTACT: its printed digits and those of samcontact."""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from . import study
from .study import Record

TEXT = Path(__file__).with_name("contact_examples.md")
Rows = Iterator[tuple[str, str, float]]
"""Quantity, the number as CONTACT prints it, and that of samcontact in the same unit."""


def of_shear_modulus(G: float, nu: float) -> sc.Material:
    return sc.Material.elastic(2 * G * (1 + nu), nu)


def counts(found: Any, touching: int, sticking: int) -> Rows:
    """Compare numbers of cells."""
    yield "cells in contact", str(touching), np.count_nonzero(found.pressure)
    yield "cells that stick", str(sticking), np.count_nonzero(found.sticking)


def cattaneo() -> Rows:
    """Two balls, normal load, then a tangential force of 0.875 of the friction limit."""
    grid, body = sc.Grid(19, 19, 0.13333, 0.13333), of_shear_modulus(200.0, 0.42)
    solver, load = sc.ContactSolver(grid, body, body, sc.Coulomb(0.4)), 9.1954
    gap = sc.surfaces.paraboloid(grid, 50.0)
    found = solver.solve(gap, load=load, tangential_load=(0.875 * 0.4 * load, 0.0))
    yield from counts(found, 177, 45)
    yield "approach [mm]", "1.998E-02", found.approach
    yield "shift [mm]", "8.155E-03", found.shift[0]
    yield "maximum pressure [N/mm²]", "4.393", found.pressure.max()
    yield "frictional work [N mm]", "2.750E-03", found.friction_work
    shown = ("0.575", "1.06", "1.31", "1.49", "1.09", "0.948", "0.895", "0.879")
    sizes = np.hypot(*found.shear)[2:10, 9]
    for row, (printed, size) in enumerate(zip(shown, sizes, strict=True), 1):
        yield f"shear traction in cell {row} from the edge [N/mm²]", printed, size


def carter2d() -> Rows:
    """Rolling cylinders of 200 mm length with a creepage of 2.4e-4."""
    grid, steel = sc.Grid(55, 1, 0.04, 200.0), of_shear_modulus(82000.0, 0.28)
    gap = 0.001 * (-1.05 + 0.04 * np.arange(55.0)[:, None]) ** 2
    found = sc.rolling.steady(grid, steel, steel, gap, load=35780.0, friction=sc.Coulomb(0.3),
                              creepage=(2.4e-4, 0.0), on_border="warn")  # fmt: skip
    yield from counts(found, 50, 30)
    yield "tangential force [N]", "6955", found.tangential_load[0]
    yield "maximum pressure [N/mm²]", "113.9", found.pressure.max()
    yield "approach [mm]", "6.492E-03", found.approach


def bentall() -> Rows:
    """Rollers of different materials: creepage for four pairs of friction coefficient and force."""
    grid = sc.Grid(216, 1, 1e-6, 1.0)
    gap, load = sc.surfaces.paraboloid(grid, 25e-3, math.inf), 16201.9
    bodies = of_shear_modulus(23e9, 0.31), of_shear_modulus(82e9, 0.28)
    cases = ((2, 1e-4, 0.0, "5.260E-04"), (4, 0.05, 0.0, "4.294E-04"),
             (5, 0.05, 0.75, "2.108E-04"), (6, 0.05, -0.75, "5.392E-04"))  # fmt: skip
    for case, mu, share, printed in cases:
        found = sc.rolling.steady(
            grid, *bodies, gap, load=load, friction=sc.Coulomb(mu),
            tangential_load=(share * mu * load, None), on_border="warn",
        )  # fmt: skip
        yield f"creepage, case {case} [-]", printed, -found.creepage[0]


def catt_to_cart() -> Rows:
    """A ball that is loaded tangentially and then rolls in steps of one cell."""
    grid, body = sc.Grid(33, 33, 0.25, 0.25), of_shear_modulus(1.0, 0.28)
    gap, load, mu = sc.surfaces.paraboloid(grid, 1 / (2 * 0.002963)), 0.4705, 0.4013
    solver = sc.ContactSolver(grid, body, body, sc.Coulomb(mu))
    force: dict[str, Any] = {"load": load, "tangential_load": (-0.657 * mu * load, 0.0)}
    now: Any = solver.solve(gap, **force)
    yield "shift without rolling [mm]", "-1.774E-02", now.shift[0]
    yield "cells that stick without rolling", "305", np.count_nonzero(now.sticking)
    printed = {1: ("1.824E-03", 422), 2: ("1.882E-03", 420), 3: ("1.955E-03", 416),
               4: ("2.050E-03", 406), 5: ("2.140E-03", 405), 6: ("2.221E-03", 395),
               7: ("2.334E-03", 390), 13: ("3.184E-03", 323), 14: ("3.403E-03", 319),
               15: ("3.402E-03", 330)}  # fmt: skip
    for step in range(1, 16):
        before = now
        now = solver.solve(gap, **force, previous=before, advance=(-0.25, -0.25))
        if step in printed:
            creepage, sticking = printed[step]
            yield f"creepage, step {step} [-]", creepage, -(now.shift - before.shift)[0] / 0.25
            yield f"cells that stick, step {step}", str(sticking), np.count_nonzero(now.sticking)


def spence35() -> Rows:
    """A ball pressed onto a body of another material in 35 steps."""
    grid = sc.Grid(37, 37, 0.2, 0.2)
    soft, hard = sc.Material.elastic(1.0, 0.0), sc.Material.elastic(2e5, 0.0)
    solver = sc.ContactSolver(grid, soft, hard, sc.Coulomb(0.2986))
    gap, found = sc.surfaces.paraboloid(grid, 0.5 / 0.004116), None
    printed = {6: (29, 5, "2.901E-03", "3.941E-03"), 18: (241, 61, "2.610E-02", "1.220E-02"),
               35: (921, 225, "9.874E-02", "2.392E-02")}  # fmt: skip
    for k in range(1, 36):
        found = solver.solve(gap, load=(k / 45) ** 3, previous=found)
        if k in printed:
            touching, sticking, approach, peak = printed[k]
            for quantity, text, value in counts(found, touching, sticking):
                yield f"{quantity}, step {k}", text, value
            yield f"approach, step {k} [mm]", approach, found.approach
            yield f"maximum pressure, step {k} [N/mm²]", peak, found.pressure.max()


def visc_cylindr() -> Rows:
    """Rolling viscoelastic cylinders at 0.6 of the friction limit; the axes are at x = -0.08 mm."""
    grid, load, mu = sc.Grid(99, 1, 0.16e-3, 1.0), 6e5, 0.3
    gap = (grid.x + 0.08e-3)[:, None] ** 2 / 0.1
    glass = of_shear_modulus(1143e6, 0.4)
    cases = ((0.009, 0.0, "60.32", "2.50845", 80, 51, "1.378E-02"),
             (0.009, 1.0, "78.74", "2.36736", 62, 37, "1.365E-02"),
             (0.045, 1.0, "84.72", "2.06321", 57, 36, "1.152E-02"),
             (2.0, 1.0, "85.31", "1.45462", 56, 35, "9.932E-03"))  # fmt: skip
    for time, speed, peak, approach, touching, sticking, creepage in cases:
        body = glass.with_relaxation(times=[time / 2], shares=[0.5])
        found = sc.rolling.steady(grid, body, body, gap, load=load, friction=sc.Coulomb(mu),
                                  speed=speed, tangential_load=(-0.6 * mu * load, 0.0),
                                  on_border="warn")  # fmt: skip
        name = f"creep time {1000 * time:g} ms" + (", slow" if speed == 0 else "")
        for quantity, text, value in counts(found, touching, sticking):
            yield f"{quantity}, {name}", text, value
        yield f"maximum pressure, {name} [N/mm²]", peak, found.pressure.max() / 1e6
        yield f"approach, {name} [mm]", approach, found.approach * 1e3
        yield f"creepage, {name} [-]", creepage, -found.creepage[0]


def veldep_fric() -> Rows:
    """A rolling cylinder with friction that falls with the slip rate."""
    speed, load = 45.0, 622216.0
    grid, steel = sc.Grid(93, 1, 1e-4, 0.2), of_shear_modulus(82e9, 0.28)
    gap, law = grid.x[:, None] ** 2 / 0.92, sc.FallingCoulomb(0.18, 0.12, 0.1)
    steady = sc.rolling.steady(grid, steel, steel, gap, load=load, friction=law, speed=speed,
                               creepage=(0.9999e-3, 0.0), on_border="warn")  # fmt: skip
    solver = sc.ContactSolver(grid, steel, steel, law, on_border="warn")
    step: dict[str, Any] = {"previous": steady, "advance": (-grid.dx, -grid.dx)}
    step |= {"shift": (1e-3 * grid.dx, 0.0), "duration": grid.dx / speed}
    below, above = (solver.solve(gap, load=load, slip_rate=rate, **step) for rate in (0.0, speed))
    printed = (("steady", steady, "0.5941", 45), ("step from stick", below, "0.5977", 77),
               ("step from slip", above, "0.5702", 34))  # fmt: skip
    for name, found, force, sticking in printed:
        yield f"force / (0.3 load), {name} [-]", force, found.tangential_load[0] / (0.3 * load)
        yield f"cells that stick, {name}", str(sticking), np.count_nonzero(found.sticking)


def plastic_3bl() -> Rows:
    """One cell in motion to and fro, with a third-body layer that hardens or softens."""
    cell, steel = sc.Grid(1, 1, 1e-3, 1e-3), of_shear_modulus(82e9, 0.28)
    layers = {
        "clay": (sc.ThirdBody(0.7, 200e6, 106.25e6, 20e-6, hardening=435e9),
                 (40, 40, 40, 40, 36, 0, -36, 0, 46, 44),
                 "200.0 216.0 232.0 248.0 262.4 262.4 82.43 82.43 266.4 284.0"),
        "sand": (sc.ThirdBody(0.7, 400e6, 176.63e6, 20e-6, hardening=-195e9),
                 (25, 25, 50, 50, 50), "200.0 400.0 390.0 380.0 370.0"),
        "MoS₂": (sc.ThirdBody(0.7, 20e6, 20.238e6, 20e-6, hardening=20.4e9),
                 (20, 40, 40, 50, 50, 50), "20.00 20.80 21.60 22.60 23.60 24.60"),
    }  # fmt: skip
    for name, (law, shifts, printed) in layers.items():
        solver, last = sc.ContactSolver(cell, steel, steel, law, on_border="warn"), None
        for step, (shift, text) in enumerate(zip(shifts, printed.split(), strict=True), 1):
            drive: dict[str, Any] = {"load": 900.0, "shift": (1e-6 * shift, 0.0)}
            last = solver.solve(np.zeros((1, 1)), previous=last, **drive)
            yield f"force, {name}, step {step} [N]", text, last.tangential_load[0]


EXAMPLES: dict[str, Callable[[], Rows]] = {
    made.__name__: made
    for made in (cattaneo, carter2d, bentall, catt_to_cart, spence35, visc_cylindr, veldep_fric,
                 plastic_3bl)
}  # fmt: skip
QUICK_EXAMPLES = ("carter2d", "plastic_3bl")


def points(quick: bool) -> list[Record]:
    return [{"of": name} for name in EXAMPLES if not quick or name in QUICK_EXAMPLES]


def run(of: str) -> Record:
    """Solve an example; return its quantities, printed numbers and numbers of samcontact."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rows = [[name, text, float(value)] for name, text, value in EXAMPLES[of]()]
    return {"rows": rows}


def last_digit(printed: str) -> float:
    """Return the value of a unit of the last digit of a printed number; 1 for a whole number."""
    mantissa, _, exponent = printed.partition("E")
    return float(10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2])))


def units_off(printed: str, value: float) -> float:
    """Return the difference in units of the last printed digit, after rounding to this digit."""
    unit = last_digit(printed)
    return float(abs(round(value / unit) - round(float(printed) / unit)))


def as_printed(printed: str, value: float) -> str:
    """Return a number with the digits and the notation of a printed one."""
    mantissa, mark, exponent = printed.partition("E")
    decimals = len(mantissa.partition(".")[2])
    text = f"{value / 10.0 ** int(exponent or 0):.{decimals}f}"
    return f"{text}E{exponent}" if mark else text


def differences(records: Sequence[Record]) -> dict[str, float]:
    """Return the differences of all numbers [units of the last digit], by example and quantity."""
    return {
        f"{record['of']}, {name}": units_off(text, value)
        for record in records
        for name, text, value in record["rows"]
    }


def page(records: list[Record]) -> str:
    """Return the page: a table for each example, and the examples that cannot be posed."""
    off = differences(records)
    equal = sum(units == 0 for units in off.values())
    sections = []
    for record in records:
        rows = [
            [name, text, as_printed(text, value), f"{units_off(text, value):.0f}"]
            for name, text, value in record["rows"]
        ]
        head = ["quantity", "CONTACT", "samcontact", "units of the last digit"]
        about = (EXAMPLES[record["of"]].__doc__ or "").strip()
        sections.append(f"### {record['of']}\n\n{about}\n\n{study.table(head, rows)}")
    return re.sub(
        r"\{(\w+)\}",
        lambda found: {"examples": "\n\n".join(sections), "equal": str(equal),
                       "count": str(len(off)), "posed": str(len(records)),
                       "worst": f"{max(off.values()):.0f}"}[found[1]],
        TEXT.read_text(encoding="utf-8"),
    )  # fmt: skip


STUDY = study.Study(
    "contact_examples",
    "Examples of the program CONTACT: its printed digits and those of samcontact.",
    points,
    run,
    page,
)

if __name__ == "__main__":
    STUDY.main()

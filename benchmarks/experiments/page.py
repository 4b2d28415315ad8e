# SPDX-License-Identifier: GPL-3.0-or-later
"""Indentation from first yield to the fully plastic range: points, page and figure."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from ..study import Record, Study, table_of
from .indentation import (
    E_STAR,
    INCREMENTS,
    Indentation,
    cavity,
    first_yield,
    hardening,
    hertz,
    perfect,
)

STIFFNESSES = (2.0, 2.5, 3.0, 4.0, 6.0, 9.0, 13.0, 20.0, 30.0, 45.0, 65.0, 100.0)
CELLS = (10, 14, 20)
MAX_FINE_STIFFNESS = 60.0  # stiffness from which the finest grid is omitted
EXPONENTS = (0.1, 0.2, 0.3)
RADII = (0.02, 0.04)

TABOR = (2.6, 3.0)
"""Tabor's constraint factor, 2.8 +- 0.2."""
METALS = {  # Y [Pa], with the order of magnitude of E*/Y
    "bearing steel": 2.0e9,
    "steel, worked": 0.65e9,
    "mild steel, as delivered": 0.25e9,
    "copper, annealed (E* of 140 GPa)": 0.07e9 * E_STAR / 140e9,
}
HARDNESS = 800  # Vickers, of 64 HRC
PROJECTED = math.sin(math.radians(68.0))
"""Ratio of the projected area of a Vickers imprint to the area of its faces."""
VICKERS_STRAIN = 0.08

TEXT = Path(__file__).with_name("template.md")


Prints = list[tuple[float, Indentation]]
"""Imprints, each with a nominal stiffness E* a/(Y R) or a hardening exponent."""


def points(quick: bool) -> list[Record]:
    found: list[Record] = [
        {"of": "perfect", "stiffness": stiffness, "cells": cells}
        for stiffness in STIFFNESSES
        for cells in (CELLS if stiffness < MAX_FINE_STIFFNESS else CELLS[:2])
    ]
    found += [{"of": "hardening", "exponent": exponent, "cells": CELLS[0], "to_radius": radius}
              for exponent in EXPONENTS for radius in RADII]  # fmt: skip
    return [found[0], found[-1]] if quick else found


def run(of: str, **point: Any) -> Record:
    found = perfect(**point) if of == "perfect" else hardening(**point)
    return found._asdict()


def prints(records: list[Record]) -> dict[str, Prints]:
    """Return the imprints of the groups "perfect" and "hardening"."""
    return {
        name: [(record[first], Indentation(*(record[field] for field in Indentation._fields)))
               for record in records if record["of"] == name]
        for name, first in (("perfect", "stiffness"), ("hardening", "exponent"))
    }  # fmt: skip


def finest(rows: Prints) -> list[Indentation]:
    """Return the imprint on the finest grid for each load."""
    return list(dict(rows).values())


def page(records: list[Record]) -> str:
    found = prints(records)
    curve = finest(found["perfect"])
    x, values = (np.array([getattr(one, k) for one in curve]) for k in ("stiffness", "constraint"))
    yielded = x > 3.5
    deviation = np.abs(values / cavity(x) - 1)
    until = x[yielded & (deviation < 0.08)].max()
    powers = meyer(found["hardening"])
    steel = sc.Material.swift(210e9, 0.3, B=945e6, C=20.0, n=0.121)
    vickers = HARDNESS * 9.80665e6 / PROJECTED
    swift = float(steel.yield_stress(VICKERS_STRAIN))
    hardens = [one.stiffness for _, one in found["hardening"]]
    factors = np.array([one.constraint for _, one in found["hardening"]])
    return TEXT.read_text(encoding="utf-8").format(
        first=first_yield(),
        perfect=table_of(curve_table(found["perfect"])),
        finest=max(one.stiffness for _, one in found["perfect"] if one.cells == 20),
        cells=f"{', '.join(map(str, CELLS[:-1]))} and {CELLS[-1]}",
        increments=INCREMENTS,
        spread=math.ceil(100 * spread(found["perfect"])),
        small=min(hardens),
        large=max(hardens),
        edge=edge(curve),
        deviation=math.ceil(100 * deviation[yielded & (x <= until)].max()),
        until=until,
        enters=float(np.interp(TABOR[0], values, x)),
        highest=values[-1],
        peak=max(one.max_pressure / one.yield_stress for one in curve),
        last=x[-1],
        hardening=table_of(hardening_table(found["hardening"])),
        off=math.ceil(100 * max(0.0, factors.max() / TABOR[1] - 1, 1 - factors.min() / TABOR[0])),
        meyer=max(abs(power - 2 - n) for n, power in powers.items()),
        honest=table_of(honest_table(curve)),
        swift=1e-9 * swift,
        harder=100 * (swift * 2.8 / vickers - 1),
        hardness=HARDNESS,
        vickers=1e-9 * vickers,
        stress=1e-9 * vickers / 2.8,
    )


def curve_table(rows: Prints) -> list[dict[str, Any]]:
    lines = []
    for prescribed in dict(rows):
        grids = [one for first, one in rows if first == prescribed]
        last = grids[-1]
        x = last.stiffness
        grows = x > 3.5  # below this value the model has no core
        lines.append(
            {
                "$E^* a/(Y R)$": f"{x:.2f}",
                "mean pressure / Y": f"{last.constraint:.3f}",
                "on coarser grids": ", ".join(f"{one.constraint:.3f}" for one in grids[:-1]),
                "Hertz": f"{hertz(x):.3f}" if x < 5 else "",
                "cavity": f"{float(cavity(x)):.3f}" if grows else "",
                "maximum plastic strain × R/a": f"{last.max_strain / last.radius:.2f}",
            }
        )
    return lines


def hardening_table(rows: Prints) -> list[dict[str, Any]]:
    powers = meyer(rows)
    return [
        {
            "n": f"{n:g}",
            "a/R": f"{one.radius:.4f}",
            "$E^* a/(Y R)$": f"{one.stiffness:.0f}",
            "mean pressure / Y": f"{one.constraint:.3f}",
            "maximum plastic strain": f"{100 * one.max_strain:.1f} %",
            "exponent of the load": "" if number % len(RADII) else f"{powers[n]:.2f}",
        }
        for number, (n, one) in enumerate(rows)
    ]


def meyer(rows: Prints) -> dict[float, float]:
    """Return Meyer's exponent, of load versus imprint radius, for each hardening exponent."""
    found = {}
    for n in EXPONENTS:
        first, last = (one for exponent, one in rows if exponent == n)
        loads = [one.mean_pressure * one.radius**2 for one in (first, last)]
        found[n] = math.log(loads[1] / loads[0]) / math.log(last.radius / first.radius)
    return found


def spread(rows: Prints) -> float:
    """Return the maximum relative difference of mean pressures from results on the finest grid."""
    last = dict(rows)
    return max(abs(one.constraint / last[prescribed].constraint - 1) for prescribed, one in rows)


def edge(curve: list[Indentation]) -> float:
    """Return the maximum plastic strain over a/R at the beginning of the fully plastic range."""
    at = min(curve, key=lambda one: abs(one.stiffness - 30))
    return at.max_strain / at.radius


def honest_table(curve: list[Indentation]) -> list[dict[str, Any]]:
    lines = []
    for metal, stress in METALS.items():
        radius = 30 * stress / E_STAR
        lines.append(
            {
                "metal": metal,
                "Y/E\\*": f"{stress / E_STAR:.4f}",
                "a/R at $E^* a/(Y R) = 30$": f"{radius:.3f}",
                "maximum plastic strain at this radius": f"{100 * radius * edge(curve):.1f} %",
            }
        )
    return lines


def draw(records: list[Record]) -> dict[str, Any]:
    from matplotlib.figure import Figure

    found = prints(records)
    figure = Figure(figsize=(6.4, 4.4), layout="constrained")
    ax = figure.subplots()
    ax.axhspan(*TABOR, color="0.9", label="Tabor, 2.8 ± 0.2")
    ax.plot([1, 27], [first_yield()] * 2, color="0.6", linewidth=1)
    ax.text(9, first_yield() + 0.04, f"first yield, {first_yield():.2f}", color="0.4", fontsize=9)
    x = np.geomspace(1.0, 8.0, 50)
    ax.plot(x[hertz(x) < 2.6], hertz(x[hertz(x) < 2.6]), "k:", label="Hertz")
    x = np.geomspace(3.5, 120.0, 100)
    ax.plot(x, cavity(x), "k--", label="expanding cavity")
    for cells, marker, colour in ((10, "x", "C0"), (14, "+", "C0"), (20, "o", "C3")):
        rows = [one for _, one in found["perfect"] if one.cells == cells]
        ax.plot(
            [one.stiffness for one in rows], [one.constraint for one in rows], marker,
            color=colour, label=f"{cells} cells on the radius", markerfacecolor="none",
        )  # fmt: skip
    hard = [one for _, one in found["hardening"]]
    ax.plot(
        [one.stiffness for one in hard], [one.constraint for one in hard], "s", color="C2",
        label="hardening, n = 0.1 to 0.3", markerfacecolor="none",
    )  # fmt: skip
    ax.set(xscale="log", xlim=(1, 220), ylim=(0, 3.8))
    ax.set(xlabel="E* a/(Y R) [-]", ylabel="mean pressure / Y (at a strain of 0.2 a/R) [-]")
    ax.set_xticks([1, 2, 5, 10, 20, 50, 100, 200], ["1", "2", "5", "10", "20", "50", "100", "200"])
    ax.grid(alpha=0.3)
    ax.legend(frameon=False, fontsize=8, loc="lower right")
    return {"experiments.png": figure}


STUDY = Study("experiments", "Comparison of indentation with experiments.", points, run, page, draw)

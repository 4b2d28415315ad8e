# SPDX-License-Identifier: GPL-3.0-or-later
"""Load for a permanent deformation of 1e-4 of the ball diameter: points, page and figure."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from samcontact import bearings, critical, hertz

from ..study import Record, Study, table_of
from .setups import (
    ALLOWED,
    BALL,
    BALLS,
    CONTACTS,
    E_STAR,
    FLAT,
    PITCH,
    PRESSURES,
    STEEL,
    STEELS,
    Pressed,
    press,
    reaches,
)

FINE_CELLS = 20  # cells per semi-axis on the finer grid
GROOVE = "deep groove, inner race"

TEXT = Path(__file__).with_name("template.md")


Rows = dict[str, list[Pressed]]


def points(quick: bool) -> list[Record]:
    found = [
        {"of": "contacts", "name": name, "pressure": pressure}
        for name, contact in CONTACTS.items()
        for pressure in sorted({*PRESSURES, contact.pressure})
    ]
    found += [{"of": "steels", "name": name, "pressure": p} for name in STEELS for p in PRESSURES]
    found += [{"of": "fine", "name": name, "pressure": contact.pressure}
              for name, contact in CONTACTS.items()]  # fmt: skip
    return found[:1] if quick else found


def run(of: str, name: str, pressure: float) -> Record:
    contact = CONTACTS[GROOVE if of == "steels" else name]
    steel = STEELS[name if of == "steels" else STEEL]
    cells = {"cells": FINE_CELLS} if of == "fine" else {}
    return press(contact, steel, pressure, **cells)._asdict()


def pressed(records: list[Record]) -> tuple[Rows, Rows, Rows]:
    """Return three dictionaries of results by name: for contacts, for steels, on finer grids."""
    found: dict[str, Rows] = {"contacts": {}, "steels": {}, "fine": {}}
    for record in records:
        rows = found[record["of"]].setdefault(record["name"], [])
        rows.append(Pressed(*(record[field] for field in Pressed._fields)))
    return found["contacts"], found["steels"], found["fine"]


def at(rows: list[Pressed], pressure: float) -> Pressed:
    return next(row for row in rows if math.isclose(row.pressure, pressure))


def by_model(rows: list[Pressed]) -> float:
    """Return the Hertz pressure at the permissible deformation [Pa], interpolated from results."""
    return reaches(rows, [row.deformation for row in rows])


def power(rows: list[Pressed], low: float, high: float) -> float:
    """Return the exponent n of deformation ~ pressure^n, from results at two pressures [Pa]."""
    first, last = at(rows, low), at(rows, high)
    return math.log(last.deformation / first.deformation) / math.log(high / low)


def page(records: list[Record]) -> str:
    contacts, steels, finer = pressed(records)
    groove, flat = contacts[GROOVE], contacts[FLAT]
    iso = {name: at(rows, CONTACTS[name].pressure) for name, rows in contacts.items()}
    rated = [name for name in contacts if name != FLAT]
    allowed = {name: by_model(contacts[name]) for name in rated}
    margins = [100 * (allowed[name] / CONTACTS[name].pressure - 1) for name in rated]
    fine = [abs(finer[n][0].deformation / iso[n].deformation - 1) for n in contacts]
    grows = power(groove, 4.2e9, 5.0e9)
    race = CONTACTS[GROOVE].race
    rating = {
        p0: bearings.static_load_rating([race], BALLS, pressure=p0, E_star=modulus)
        for p0, modulus in (
            (4.2e9, bearings.rating.STEEL_CONTACT_MODULUS),
            (allowed[GROOVE], E_STAR),
        )
    }
    ratios = [at(groove, p).deformation / at(flat, p).deformation for p in (4.2e9, 6e9)]
    return TEXT.read_text(encoding="utf-8").format(
        ball=1e3 * BALL, pitch=1e3 * PITCH, balls=BALLS, fine=FINE_CELLS,
        contacts=table_of([contact_row(name, contacts[name], iso[name]) for name in contacts]),
        steels=table_of([steel_row(name, rows) for name, rows in steels.items()]),
        grids=100 * max(fine),
        smallest=min(iso[name].deformation for name in rated) / ALLOWED,
        largest=max(iso[name].deformation for name in rated) / ALLOWED,
        low=1e-9 * min(allowed.values()), high=1e-9 * max(allowed.values()),
        margin_low=min(margins), margin_high=max(margins),
        power=grows, two=2 ** (1 / grows), power_high=power(groove, 5.5e9, 6.0e9),
        rating=1e-3 * rating[4.2e9], capacity=1e-3 * rating[allowed[GROOVE]],
        ratio_low=ratios[0], ratio_high=ratios[1],
        ratio_palmgren=at(groove, 4.2e9).palmgren / at(flat, 4.2e9).palmgren,
        palmgren=1e4 * at(groove, 4.2e9).palmgren,
        flat_palmgren=1e4 * at(flat, 4.2e9).palmgren,
        flat_model=1e4 * at(flat, 4.2e9).deformation,
        softer=at(steels["52100, all stresses 10 % lower"], 4.2e9).deformation
        / at(steels[STEEL], 4.2e9).deformation,
        strain=100 * at(groove, 4.2e9).strain,
        across=2e3 * race_ellipse().a_y, longer=race_ellipse().a_y / race_ellipse().a_x,
        circle=critical.onset(1.0, 1.0, 0.3, 1.0).p0,
        line=critical.onset_cylinder(1.0, 1.0, 0.3, 1.0).p0,
    )  # fmt: skip


def race_ellipse() -> hertz.EllipticContact:
    """Return the Hertz contact of ball and groove at a pressure of 4.2 GPa."""
    race = CONTACTS[GROOVE].race
    return hertz.elliptic(race.Rx, race.Ry, E_STAR, p0=4.2e9)


def contact_row(name: str, rows: list[Pressed], iso: Pressed) -> dict[str, str]:
    line = math.isnan(iso.palmgren)
    formula = reaches(rows, [row.palmgren for row in rows]) if not line else math.nan
    load = f"{iso.load:.0f} N/mm" if line else f"{1e-3 * iso.load:.2f} kN"
    return {
        "contact": name,
        "p₀ of ISO 76 [GPa]": f"{1e-9 * iso.pressure:.1f}" + (" (as in a groove)" * (name == FLAT)),
        "load": load,
        "deformation by the model [1e-4 D]": f"{1e4 * iso.deformation:.2f}",
        "deformation by Palmgren [1e-4 D]": "" if line else f"{1e4 * iso.palmgren:.2f}",
        "maximum plastic strain": f"{100 * iso.strain:.2f} %",
        "p₀ for 1e-4 D, model [GPa]": f"{1e-9 * by_model(rows):.2f}",
        "p₀ for 1e-4 D, Palmgren [GPa]": "" if line else f"{1e-9 * formula:.2f}",
    }


def steel_row(name: str, rows: list[Pressed]) -> dict[str, str]:
    deformation = at(rows, 4.2e9).deformation
    reached = by_model(rows)
    return {
        "steel": name,
        "deformation at 4.2 GPa [1e-4 D]": f"{1e4 * deformation:.2f}",
        "p₀ for 1e-4 D [GPa]": f"{1e-9 * reached:.2f}" if reached > 0 else "above these pressures",
        "maximum plastic strain at 4.2 GPa": f"{100 * at(rows, 4.2e9).strain:.2f} %",
    }


def draw(records: list[Record]) -> dict[str, Any]:
    from matplotlib.figure import Figure

    contacts, steels, _ = pressed(records)
    figure = Figure(figsize=(9.6, 4.0), layout="constrained")
    left, right = figure.subplots(1, 2, sharex=True, sharey=True)
    for number, name in enumerate((GROOVE, FLAT)):
        rows = contacts[name]
        pressures = [1e-9 * row.pressure for row in rows]
        colour = f"C{number}"
        left.plot(pressures, [row.deformation for row in rows], "o-", color=colour, label=name)
        left.plot(
            pressures, [row.palmgren for row in rows], "--", color=colour, label=f"{name}, Palmgren"
        )
    for name, rows in steels.items():
        style = "--" if name.startswith("perf") else ":" if "%" in name else "-"
        known = [row for row in rows if row.deformation > 0]
        right.plot(
            [1e-9 * row.pressure for row in known], [row.deformation for row in known], style,
            label=name, marker=".",
        )  # fmt: skip
    for ax in (left, right):
        ax.axhline(ALLOWED, color="k", linewidth=0.8)
        ax.axvline(4.2, color="k", linewidth=0.8)
        ax.set(yscale="log", xlabel="maximum Hertz pressure [GPa]", ylim=(1e-6, 1e-3))
        ax.grid(alpha=0.3)
        ax.legend(frameon=False, fontsize=7.5, loc="lower right")
    left.set(ylabel="permanent deformation / ball diameter [-]", title=f"{STEEL}, both bodies")
    right.set_title(GROOVE)
    return {"static_capacity.png": figure}


STUDY = Study(
    "static_capacity",
    "Load at a permanent deformation of 1e-4 of the ball diameter.",
    points,
    run,
    page,
    draw,
)

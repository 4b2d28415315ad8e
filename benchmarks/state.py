# SPDX-License-Identifier: GPL-3.0-or-later
"""State of the project: the worst number of each table of measurements, on one page."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import click

from . import busy, contact_examples, scaling, small_contacts, study, tables, threads, viscous
from .adhesion_peers.page import STUDY as ADHESION
from .peers import page as peers
from .roofline import page as roofline
from .scale import page as scale
from .scale.jobs import JOBS
from .stability.page import TABLES
from .study import ROOT

PAGE = ROOT / "docs" / "state.md"
TEXT = Path(__file__).with_name("state_template.md")
MEASURED = ROOT / "docs" / "benchmarks.md"
Rows = list[dict[str, Any]]


class Worst(NamedTuple):
    """Worst number of a table; `goal` is a limit in words, `met` whether the number is within."""

    page: str
    quantity: str
    value: float
    place: str
    goal: str = ""
    met: bool | None = None


def at_most(page: str, quantity: str, found: dict[str, float], limit: float | None = None) -> Worst:
    """Return the largest of some numbers, by place."""
    place = max(found, key=lambda name: found[name])
    if limit is None:
        return Worst(page, quantity, found[place], place)
    return Worst(page, quantity, found[place], place, f"≤ {limit:g}", found[place] <= limit)


def at_least(page: str, quantity: str, found: dict[str, float], limit: float) -> Worst:
    """Return the smallest of some numbers, by place."""
    place = min(found, key=lambda name: found[name])
    return Worst(page, quantity, found[place], place, f"≥ {limit:g}", found[place] >= limit)


def accuracy() -> Iterator[Worst]:
    """Validation, reliability of stated errors, and their cost."""
    checks = json.loads((ROOT / "docs" / "validation.json").read_text(encoding="utf-8"))
    share = {}
    for row in checks:
        if row["allowed"]:
            scale_of = abs(row["reference"]) if row["relative"] else 1.0
            off = abs(row["ours"] - row["reference"]) / scale_of / row["allowed"]
            share[f"{row['table']}, {row['quantity']}"] = off
    yield at_most("validation", "deviation / allowed deviation", share, 1.0)
    printed = contact_examples.differences(contact_examples.STUDY.records())
    yield at_most("contact_examples", "difference from CONTACT [units of the last printed digit]",
                  printed)  # fmt: skip
    stated = study.find("accuracy").records()
    beyond = {
        f"{row['of']}, {name}, to {100 * row['accuracy']:g} %": true / row["stated"][name]
        for row in stated
        for name, true in row["true"].items()
        if row["stated"][name] > 0
    }
    yield at_most("accuracy", "true error / stated error", beyond)
    covered = sum(value <= 1 for value in beyond.values()) / len(beyond)
    yield at_least("accuracy", "share of values covered by their stated error [%]",
                   {"all values": 100 * covered}, 95.0)  # fmt: skip
    cost = {
        f"{row['of']}, to {100 * row['accuracy']:g} %": row["mine"]["seconds"]
        / row["best"]["seconds"]
        for row in study.find("accuracy_cost").records()
        if row["as_exact"]
    }
    yield at_most("accuracy_cost", "time to an accuracy / time of the best manual grid", cost)


def stability() -> Iterator[Worst]:
    """Extreme cases: numbers over their limits, units, pairs of capabilities."""
    rows = study.by_group(study.find("stability").records())
    share = {}
    for known in TABLES:
        for row in rows[known.name]:
            for column in known.columns:
                if column.at_most:
                    place = f"{known.name}, {row['row']}, {column.key}"
                    share[place] = (row.get(column.key) or 0.0) / column.at_most
    yield at_most("stability", "number / limit of its table", share, 1.0)
    units = {
        row["row"]: max(value for name, value in row.items() if name.startswith("system"))
        for row in rows["units"]
    }
    yield at_most("stability", "difference between systems of units", units, 1e-12)
    pairs = study.find("combinations").records()
    works = sum(not row["refusal"] for row in pairs)
    yield at_least("combinations", "pairs of capabilities that work [%]",
                   {f"{works} of {len(pairs)} pairs": 100 * works / len(pairs)}, 90.0)  # fmt: skip


def cost() -> Iterator[Worst]:
    """Physical limits, growth with size, small contacts, threads."""
    found = roofline.largest(roofline.STUDY.records())
    yield at_most("roofline", "time / limit of the machine at the rate of transforms",
                  {name: roofline.transform_ratio(row) for name, row in found.items()},
                  roofline.STATED)  # fmt: skip
    rows = scale.STUDY.records()
    exponents = {job.name: scale.overall(scale.of(rows, job)) / job.exponent for job in JOBS}
    yield at_most("scale", "exponent of time over size / its limit", exponents, 1.0)
    memory = {job.name: scale.bytes_a_cell(scale.of(rows, job)[-1]) / job.stated for job in JOBS}
    yield at_most("scale", "bytes per cell / their limit", memory, 1.0)
    yield from of_parts(MEASURED.read_text(encoding="utf-8"))


def of_parts(text: str) -> Iterator[Worst]:
    """Return the worst numbers of some tables on the page of benchmarks."""
    small = rows_of(text, small_contacts)
    shares = {
        f"{row['case']}, {row['across']:.0f} cells across": row["outside the core [%]"]
        for row in small
        if row.get("across", 0) >= 64
    }
    yield at_most("benchmarks", "time outside the core [%]", shares, 10.0)
    processes = {row["case"]: row["processor time [s]"] for row in small if "across" not in row}
    for case, limit in (("import samcontact", 0.25), ("samcontact run --no-figures", 1.0)):
        yield at_most("benchmarks", "processor time [s]", {case: processes[case]}, limit)
    over = {
        f"{row['case']}, {row['method']}, {row['across']:.0f} cells across": row[
            "increment over elastic"
        ]
        for row in rows_of(text, viscous)
    }
    yield at_most("benchmarks", "viscoelastic / elastic increment", over)
    two = {
        f"{row['case']}, {row['cells']:.0f} cells": row["time_ratio"]
        for row in rows_of(text, threads)
        if row["method"] == "2 threads"
    }
    yield at_most("benchmarks", "time on two threads / on one", two, 1.0)
    crowded = {
        f"{row['case']}, {row['method']}": row["processor time 2 / 1"]
        for row in rows_of(text, busy)
        if row["method"] != "0 busy processes"
    }
    yield at_most("benchmarks", "processor time of two threads / of one", crowded, busy.GOAL)
    exact = {
        f"{row['across']:.0f} cells per radius": row["time_ratio"]
        for row in rows_of(text, scaling)
        if row["method"] == "fast" and "time_ratio" in row
    }
    yield at_most("benchmarks", "fast / exact residual stress, time of an increment", exact, 1.0)


def rows_of(text: str, part: Any) -> Rows:
    """Return the rows of the table of a part of the benchmarks."""
    return tables.rows_of(tables.section_of(text, part))


def other_codes() -> Iterator[Worst]:
    """Times of other codes over those of samcontact, at equal errors."""
    stored = json.loads((ROOT / "benchmarks" / "peers" / "results.json").read_text("utf-8"))
    for kind, ratio in peers.minimum_ratios(stored).items():
        yield at_least("peers", "time of the fastest other code / samcontact", {kind: ratio}, 1.0)
    adhesive = [row for row in ADHESION.records() if row["code"] != "samcontact"]
    for kind, rows in study.by_group(adhesive).items():
        ratios = {
            f"adhesion, {kind}, {row['code']}, {row['n']} × {row['n']} cells": row["ratio"]
            for row in rows
        }
        yield at_least("adhesion_peers", "time of the fastest other code / samcontact", ratios, 1.0)


SECTIONS = {"accuracy": accuracy, "stability": stability, "cost": cost, "peers": other_codes}


def shown(rows: list[Worst]) -> str:
    """Return the Markdown table of the worst numbers."""
    lines = [
        [f"[{row.page.replace('_', ' ')}]({row.page}.md)", row.quantity, f"{row.value:.3g}",
         row.place, row.goal, {None: "", True: "yes", False: "**no**"}[row.met]]
        for row in rows
    ]  # fmt: skip
    return study.table(["page", "quantity", "worst", "where", "goal", "met"], lines)


def page() -> str:
    """Return the text of the page, from the stored results of all benchmarks."""
    found = {name: list(make()) for name, make in SECTIONS.items()}
    rows = [row for every in found.values() for row in every]
    goals = [row.met for row in rows if row.met is not None]
    missed = [f"{row.quantity} ({row.place})" for row in rows if row.met is False]
    listed = f"Missed: {'; '.join(missed)}." if missed else ""
    return TEXT.read_text(encoding="utf-8").format(
        **{name: shown(every) for name, every in found.items()},
        goals=len(goals), met=sum(goals), missed=listed,
    )  # fmt: skip


@click.command(help=__doc__)
@click.option("--docs", is_flag=True, help="Write docs/state.md.")
def main(docs: bool) -> None:
    """Print or write the page."""
    text = page()
    if docs:
        PAGE.write_text(text, encoding="utf-8")
    else:
        click.echo(text)


if __name__ == "__main__":
    main(prog_name="python -m benchmarks.state")

# SPDX-License-Identifier: GPL-3.0-or-later
"""The page: growth of time and memory, and what a surface too large for a machine would need."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ..finite_elements.tables import table
from ..scaling import exponent
from . import cluster
from .jobs import JOBS, Job

KEPT = Path(__file__).with_name("results.json")
TEXT = Path(__file__).with_name("template.md")
DECADE = 10.0
Rows = list[dict[str, Any]]


def kept() -> Rows:
    found: Rows = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else []
    return found


def of(rows: Rows, job: Job) -> Rows:
    """Those of a job, smallest first."""
    return sorted((row for row in rows if row["case"] == job.function), key=lambda row: row["n"])


def growth(rows: Rows) -> float:
    """Exponent of the processor's time over the last decade of cells, or all where they are few."""
    last = [row for row in rows if row["cells"] >= rows[-1]["cells"] / (1.1 * DECADE)]
    chosen = last if len(last) > 2 else rows[-3:]
    return exponent([row["cells"] for row in chosen], [row["cpu_s"] for row in chosen])


def overall(rows: Rows) -> float:
    """The same over all sizes."""
    return exponent([row["cells"] for row in rows], [row["cpu_s"] for row in rows])


def bytes_a_cell(row: dict[str, Any]) -> float:
    return float(1e6 * row["memory_MB"] / row["cells"])


def summary(rows: Rows) -> str:
    """A line for each job."""
    lines = []
    for job in JOBS:
        found = of(rows, job)
        ends = [f"{row['cells']:.1e}" for row in (found[0], found[-1])]
        exponents = [f"{overall(found):.2f}", f"{job.exponent:g}", f"{growth(found):.2f}"]
        memory = [f"{bytes_a_cell(found[-1]):.0f}", f"{job.stated:.0f}"]
        lines.append([job.name, job.unit, " to ".join(ends), *exponents, *memory])
    return table(
        ["job", "cells of the", "cells", "exponent, all", "at most", "exponent, last decade",
         "bytes a cell, largest", "at most"], lines,
    )  # fmt: skip


def sizes(rows: Rows) -> str:
    """A line for each size of each job."""
    lines = [
        [job.name, str(row["n"]), str(row["cells"]), f"{row['cpu_s']:.3g}",
         f"{1e6 * row['cpu_s'] / row['cells']:.3g}", f"{row['memory_MB']:.0f}"]
        for job in JOBS
        for row in of(rows, job)
    ]  # fmt: skip
    return table(["job", "n", "cells", "time [s]", "µs a cell", "memory [MB]"], lines)


# The others are no surfaces, or above their size what they take is not known.
LARGE = [job for job in JOBS if job.unit == "surface" and job.exponent < 1.2]


def needs(rows: Rows) -> str:
    """Time and memory of the large surface, from the largest that was solved."""
    lines = []
    for job in LARGE:
        found = of(rows, job)
        times = (cluster.SIDE**2 / found[-1]["cells"]) ** growth(found)
        hours = times * found[-1]["cpu_s"] / 3600
        memory = bytes_a_cell(found[-1]) * cluster.SIDE**2
        lines.append([job.name, f"{memory / 1e12:.2g}", f"{hours:.2g}"])
    return table(["job", "memory [TB]", "one core [h]"], lines)


def communication(rows: Rows) -> str:
    """What travels between processes, of each job and number of them."""
    by_name = {job.function: of(rows, job)[-1] for job in LARGE}
    lines = []
    for job in LARGE:
        count = cluster.planes(job.function, by_name)
        for ranks in cluster.RANKS:
            each = cluster.bytes_of_a_rank(cluster.SIDE, ranks, count.padded)
            lines.append([job.name, str(ranks), f"{each / 1e9:.2g}",
                          f"{cluster.message(cluster.SIDE, ranks, count.padded) / 1e6:.2g}",
                          f"{2 * count.number:.0f}", f"{count.number * each / 1e9:.3g}",
                          f"{count.number * each / cluster.RATE / 60:.2g}"])  # fmt: skip
    return table(
        ["job", "processes", "a displacement, of one process [GB]", "a message [MB]",
         "transposes of a solution", "all of a process [GB]", "at the rate below [min]"], lines,
    )  # fmt: skip


def page(rows: Rows) -> str:
    """All of it."""
    by_name = {job.function: of(rows, job) for job in JOBS}
    few, many = (by_name["rough"][at]["transforms"] for at in (0, -1))
    return TEXT.read_text(encoding="utf-8").format(
        summary=summary(rows),
        sizes=sizes(rows),
        needs=needs(rows),
        communication=communication(rows),
        side=f"{cluster.SIDE:,}".replace(",", " "),
        few=f"{few:.0f}",
        many=f"{many:.0f}",
        rate=f"{cluster.RATE / 1e9:g}",
        bands=f"{cluster.BANDS:.2g}",
        tensors=cluster.STRAINS + cluster.STRESSES,
        layers=by_name["zones"][-1]["layers"],
    )

# SPDX-License-Identifier: GPL-3.0-or-later
"""Page on the growth of time and memory with size, with estimates for a very large surface."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from ..harness import Meter
from ..scaling import exponent
from ..study import Study, table
from . import cluster
from .jobs import JOBS, MAX_EXPONENT, Job, measure

TEXT = Path(__file__).with_name("template.md")
DECADE = 10.0
MACHINE = 1e12
"""Memory of one large machine [bytes]."""
Rows = list[dict[str, Any]]


def points(quick: bool) -> Rows:
    return [{"of": job.function, "n": n} for job in JOBS
            for n in (job.sizes[:1] if quick else job.sizes)]  # fmt: skip


def run(of: str, n: int) -> dict[str, Any]:
    meter = Meter()
    found = measure(meter, of, n)
    return found | {"cpu_s": meter.cpu, "memory_MB": meter.memory / 1e6}


def of(rows: Rows, job: Job) -> Rows:
    """Return the results of a job at all measured sizes, smallest size first."""
    return sorted((row for row in rows if row["of"] == job.function), key=lambda row: row["n"])


def growth(rows: Rows) -> float:
    """Return the exponent of time versus cells over the last decade, or the last three sizes."""
    last = [row for row in rows if row["cells"] >= rows[-1]["cells"] / (1.1 * DECADE)]
    chosen = last if len(last) > 2 else rows[-3:]
    return exponent([row["cells"] for row in chosen], [row["cpu_s"] for row in chosen])


def overall(rows: Rows) -> float:
    """Return the exponent of processor time versus number of cells, fitted to all sizes."""
    return exponent([row["cells"] for row in rows], [row["cpu_s"] for row in rows])


def bytes_a_cell(row: dict[str, Any]) -> float:
    return float(1e6 * row["memory_MB"] / row["cells"])


def summary(rows: Rows) -> str:
    """Return the table of exponents and memory per cell, with a row for each job."""
    lines = []
    for job in JOBS:
        found = of(rows, job)
        ends = [f"{row['cells']:.1e}" for row in (found[0], found[-1])]
        exponents = [f"{overall(found):.2f}", f"{job.exponent:g}", f"{growth(found):.2f}"]
        memory = [f"{bytes_a_cell(found[-1]):.0f}", f"{job.stated:.0f}"]
        lines.append([job.name, job.unit, " to ".join(ends), *exponents, *memory])
    return table(
        ["job", "type of cells", "number of cells", "exponent, all sizes",
         "limit of this exponent", "exponent, last decade", "bytes per cell, largest size",
         "limit of the bytes per cell"],
        lines,
    )  # fmt: skip


def sizes(rows: Rows) -> str:
    """Return the table of times and memory, with a row for each size of each job."""
    lines = [
        [job.name, str(row["n"]), str(row["cells"]), f"{row['cpu_s']:.3g}",
         f"{1e6 * row['cpu_s'] / row['cells']:.3g}", f"{row['memory_MB']:.0f}"]
        for job in JOBS
        for row in of(rows, job)
    ]  # fmt: skip
    return table(["job", "n", "cells", "time [s]", "µs per cell", "memory [MB]"], lines)


# The numbers of transforms of other jobs are not counted.
LARGE_SURFACE_JOBS = [job for job in JOBS if job.function in cluster.JOBS]


def memory(rows: Rows, job: Job) -> float:
    """Return the memory of a job on the large surface [bytes], from its largest solved size."""
    return bytes_a_cell(of(rows, job)[-1]) * cluster.SIDE**2


def needs(rows: Rows) -> str:
    """Return the table of extrapolated time and memory of each job on the large surface."""
    lines = []
    for job in LARGE_SURFACE_JOBS:
        found = of(rows, job)
        times = (cluster.SIDE**2 / found[-1]["cells"]) ** growth(found)
        hours = times * found[-1]["cpu_s"] / 3600
        lines.append([job.name, f"{memory(rows, job) / 1e12:.2g}", f"{hours:.2g}"])
    return table(["job", "memory [TB]", "time on one core [h]"], lines)


def communication(rows: Rows) -> str:
    """Return the table of data sent between processes, by job and number of processes."""
    by_name = {job.function: of(rows, job)[-1] for job in LARGE_SURFACE_JOBS}
    lines = []
    for job in LARGE_SURFACE_JOBS:
        count = cluster.planes(job.function, by_name)
        for ranks in cluster.RANKS:
            each = cluster.bytes_of_a_rank(cluster.SIDE, ranks, count.padded)
            lines.append([job.name, str(ranks), f"{each / 1e9:.2g}",
                          f"{cluster.message(cluster.SIDE, ranks, count.padded) / 1e6:.2g}",
                          f"{2 * count.number:.0f}", f"{count.number * each / 1e9:.3g}",
                          f"{count.number * each / cluster.RATE / 60:.2g}"])  # fmt: skip
    return table(
        ["job", "processes", "sent per evaluation and process [GB]", "size of a message [MB]",
         "transposes of a solution", "sent per solution and process [GB]",
         f"time at {cluster.RATE / 1e9:g} GB/s [min]"], lines,
    )  # fmt: skip


def slowest(rows: Rows, job: Job) -> tuple[float, int, int]:
    """Return the maximum ratio of transform times per cell at successive sizes, and the sizes."""
    found = of(rows, job)
    each = [row["cpu_s"] / row["cells"] / row["transforms"] for row in found]
    return max(
        (more / less, row["n"], larger["n"])
        for less, more, row, larger in zip(each, each[1:], found, found[1:], strict=False)
    )


def counted(rows: Rows) -> list[Job]:
    """Return the jobs for which the number of transforms is counted."""
    return [job for job in JOBS if "transforms" in of(rows, job)[-1]]


def caches(rows: Rows) -> str:
    """Return a sentence on the largest increase of transform time per cell in elastic contact."""
    elastic = [job for job in counted(rows) if job.name.startswith("elastic")]
    ratio, small, large = max(slowest(rows, job) for job in elastic)
    return (
        f"from {small} × {small} to {large} × {large} cells a transform takes\n"
        f"{ratio:.1f} times as long per cell."
    )


def transforms(rows: Rows) -> str:
    """Return a list of jobs with their numbers of transforms at the smallest and largest size."""
    ends = [(job, of(rows, job)) for job in counted(rows)]
    return "\n".join(
        f"- {job.name}: {found[0]['transforms']:.0f} to {found[-1]['transforms']:.0f}"
        for job, found in ends
    )


def above(rows: Rows) -> str:
    """Return a sentence on jobs whose exponent of time exceeds `MAX_EXPONENT`."""
    found = [(job, overall(of(rows, job))) for job in JOBS]
    beyond = [f"{job.name} (exponent {value:.2f})" for job, value in found if value > MAX_EXPONENT]
    text = f"above {MAX_EXPONENT:g} over all sizes"
    if beyond:
        return f"{text[0].upper()}{text[1:]}: {'; '.join(beyond)}."
    return f"No exponent is {text}."


def fits(memories: dict[str, float]) -> str:
    """Return a sentence on the jobs that fit into one machine; memories: by job name [bytes]."""
    inside = [name for name, size in memories.items() if size <= MACHINE]
    if not inside:
        return f"None fits into {MACHINE / 1e12:g} TB, the memory of one large machine."
    others = " The others do not." if len(inside) < len(memories) else ""
    return (
        f"Jobs that fit into {MACHINE / 1e12:g} TB, the memory of one large machine: "
        f"{'; '.join(inside)}.{others}"
    )


def page(rows: Rows) -> str:
    """Return the text of the page."""
    return TEXT.read_text(encoding="utf-8").format(
        summary=summary(rows),
        sizes=sizes(rows),
        needs=needs(rows),
        communication=communication(rows),
        side=f"{cluster.SIDE:,}".replace(",", " "),
        memory=math.ceil(1e-3 * max(row["memory_MB"] for row in rows)),
        caches=caches(rows),
        transforms=transforms(rows),
        above=above(rows),
        fits=fits({job.name: memory(rows, job) for job in LARGE_SURFACE_JOBS}),
        rate=f"{cluster.RATE / 1e9:g}",
        bands=f"{cluster.BANDS:.2g}",
        tensors=cluster.STRAINS + cluster.STRESSES,
        layers=max(row.get("layers", 0) for row in rows),
    )


STUDY = Study(
    "scale", "Time and memory of the main jobs against their size.", points, run, page, fresh=True
)

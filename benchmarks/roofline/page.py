# SPDX-License-Identifier: GPL-3.0-or-later
"""Page on the time of the main jobs over their physical limit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ..harness import Meter
from ..study import Record, Study, table
from .jobs import BY_NAME, JOBS
from .machine import MEMORY, Machine, measured

TEXT = Path(__file__).with_name("template.md")
STATED = 4.0
"""Ratio above which a job is listed."""


def points(quick: bool) -> list[Record]:
    return [{"of": job.solve.__name__, "n": n} for job in JOBS
            for n in (job.sizes[:1] if quick else job.sizes)]  # fmt: skip


def run(of: str, n: int) -> Record:
    """Solve a job, after one at its smallest size; measure the machine before and after."""
    job = BY_NAME[of]
    job.solve(Meter(), job.sizes[0])
    before = measured(MEMORY)
    meter = Meter()
    need, working_set, counts, first = job.solve(meter, n)
    after = measured(working_set)
    rates = after.best(before._replace(copy=0.0))
    return {
        "seconds": meter.cpu, "flops": need.flops, "bytes": need.bytes, "counts": counts,
        "first": first, "memory": before.copy, **rates._asdict(),
    }  # fmt: skip


def rates(row: Record) -> Machine:
    return Machine(row["product"], row["transform"], row["copy"])


def limit(row: Record) -> float:
    """Return the physical limit: the longer of moving the bytes and of the operations [s]."""
    return float(max(row["bytes"] / row["copy"], row["flops"] / row["product"]))


def ratio(row: Record) -> float:
    """Return the time over the physical limit."""
    return float(row["seconds"] / limit(row))


def transform_ratio(row: Record) -> float:
    """Return the time over the limit if all operations have the rate of transforms."""
    return float(row["seconds"] / max(row["bytes"] / row["copy"], row["flops"] / row["transform"]))


def largest(records: list[Record]) -> dict[str, Record]:
    """Return the record of the largest size of each job, by the name of the job."""
    return {BY_NAME[row["of"]].name: row for row in records}


def rows(records: list[Record]) -> str:
    """Return the table of all jobs and sizes."""
    lines = [
        [BY_NAME[row["of"]].name, str(row["n"]), f"{row['seconds']:.3g}",
         f"{row['bytes'] / 1e9:.3g}", f"{row['flops'] / 1e9:.3g}", f"{limit(row):.2g}",
         f"{ratio(row):.1f}", f"{transform_ratio(row):.1f}",
         f"{100 * row['first']:.0f}", row["counts"]]
        for row in records
    ]  # fmt: skip
    return table(
        ["job", "n", "time [s]", "bytes [GB]", "operations [10⁹]", "physical limit [s]",
         "time / limit", "time / limit at the rate of transforms",
         "share of the first increment [%]", "counts"],
        lines,
    )  # fmt: skip


def spread(records: list[Record], name: str) -> str:
    """Return the smallest and the largest rate of all processes, in 10⁹ per second."""
    values = [row[name] / 1e9 for row in records]
    return f"{min(values):.3g} to {max(values):.3g}"


def machine(records: list[Record]) -> str:
    """Return the table of measured rates."""
    names = {
        "product": "product of two matrices of 256 × 256 numbers [10⁹ operations/s]",
        "transform": "real transforms of 32 rows of 512 numbers [10⁹ operations/s]",
        "memory": "copy in main memory [GB/s]",
        "copy": "copy of the size of the job [GB/s]",
    }
    lines = [[text, spread(records, name)] for name, text in names.items()]
    return table(["rate of one core", "all processes"], lines)


def above(records: list[Record]) -> str:
    """Return a sentence on the jobs whose ratio at the largest size is above `STATED`."""
    found = {
        name: transform_ratio(row) for name, row in largest(records).items()
        if transform_ratio(row) > STATED
    }  # fmt: skip
    limit = f"more than {STATED:g} times the limit at the rate of transforms"
    if not found:
        return f"At the largest sizes, no job takes {limit}."
    worst = sorted(found.items(), key=lambda one: -one[1])
    listed = "; ".join(f"{name} ({value:.1f})" for name, value in worst)
    return f"At the largest sizes, these jobs take {limit}: {listed}."


def page(records: list[Record]) -> str:
    """Return the text of the page."""
    return TEXT.read_text(encoding="utf-8").format(
        rows=rows(records), machine=machine(records), above=above(records)
    )


def headline(records: list[Record]) -> dict[str, Any]:
    """Return the largest ratio of all jobs at their largest size, and the job."""
    name, row = max(largest(records).items(), key=lambda one: transform_ratio(one[1]))
    return {"job": name, "ratio": transform_ratio(row)}


STUDY = Study(
    "roofline", "Time of the main jobs over their physical limit.", points, run, page, fresh=True
)

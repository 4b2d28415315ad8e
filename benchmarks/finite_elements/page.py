# SPDX-License-Identifier: GPL-3.0-or-later
"""Page that compares finite elements and samcontact on two contacts, with runs and figures."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from ..study import Record, Study
from . import balls, wave
from .tables import Points, Runs, points

PROBLEMS = {"balls": balls, "wave": wave}
REPEATS = 3  # runs of samcontact; the minimum time counts, because disturbances only add time
LABELS = {"a grid": "samcontact", "an accuracy": "samcontact, prescribed accuracy"}
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: OMP_NUM_THREADS=1 python -m benchmarks.finite_elements --docs -->
# Comparison with finite elements

This page compares the errors and computing times of samcontact with those of the finite element
code [CalculiX](https://www.calculix.de) 2.20 (Debian's `calculix-ccx`). Two elastic-plastic
contacts are solved, one axisymmetric and one not. Both codes use one thread and their own meshes.

```console
$ apt install calculix-ccx
$ OMP_NUM_THREADS=1 python -m benchmarks.finite_elements --docs
```

The tables give the maximum error of five quantities and the processor time. The error of a code is
the relative difference from the limit of the same code on fine meshes. This limit is extrapolated
with order two from the two finest meshes of the code. The time for writing the input deck is not
included. The lines below each table of errors compare the times at equal errors: the time that
samcontact needs to reach the error of a mesh of CalculiX is interpolated between the runs of
samcontact in the table. Meshes of CalculiX with an error larger than that of every run of
samcontact are left out.

{sections}"""


def cases(quick: bool) -> list[Record]:
    """Return all runs, by contact, code and mesh size, with the additional runs for the balls."""
    sizes = {
        name: {
            "samcontact": problem.CELLS[:2] if quick else problem.CELLS,
            "CalculiX": problem.ELEMENTS[:1] if quick else problem.ELEMENTS,
        }
        for name, problem in PROBLEMS.items()
    }
    more = {"slopes": balls.FLATTER, "an accuracy": balls.ACCURACIES, "truth": (0,)}
    sizes["balls"] |= {} if quick else more
    return [{"of": name, "by": by, "size": size} for name, codes in sizes.items()
            for by, some in codes.items() for size in some]  # fmt: skip


def run(of: str, by: str, size: float) -> Record:
    """Return the results [SI units] and the processor time of one run."""
    problem = PROBLEMS[of]
    if by == "samcontact":
        runs = (problem.solve(int(size)) for _ in range(REPEATS))
        return min(runs, key=lambda run: float(run["seconds"]))
    if by == "CalculiX":
        with tempfile.TemporaryDirectory() as folder:
            found: Record = problem.finite_elements(Path(folder), int(size))
            return found
    if by == "slopes":
        return balls.measure_slopes(size)
    return balls.measure_accuracy(size) if by == "an accuracy" else balls.limit()


def runs_of(records: list[Record], name: str) -> dict[str, Runs]:
    """Return the records of a contact by code and mesh size."""
    found: dict[str, Runs] = {"CalculiX": {}, "samcontact": {}}
    for record in records:
        if record["of"] == name:
            found.setdefault(record["by"], {})[f"{record['size']:g}"] = record
    return found


def page(records: list[Record]) -> str:
    """Return the text of the page."""
    sections = (problem.section(runs_of(records, name)) for name, problem in PROBLEMS.items())
    return TEXT.format(sections="\n".join(sections))


def draw(records: list[Record]) -> dict[str, Any]:
    """Return a figure for each contact: maximum error of all quantities versus processor time."""
    from matplotlib.figure import Figure

    figures = {}
    for name, problem in PROBLEMS.items():
        runs = runs_of(records, name)
        lines: dict[str, Points] = {"CalculiX": points(runs["CalculiX"], problem.QUANTITIES)}
        lines |= {LABELS[than]: known for than, known in problem.ours(runs).items()}
        figure = figures[problem.FIGURE] = Figure(figsize=(5.2, 3.6), layout="constrained")
        ax = figure.subplots()
        for (label, known), marker in zip(lines.items(), "sod", strict=False):
            errors, seconds = zip(*known, strict=True)
            ax.loglog(seconds, [100 * e for e in errors], marker=marker, label=label)
        ax.set(xlabel="processor time [s]", ylabel="maximum error [%]")
        ax.grid(which="major", alpha=0.3)
        figure.legend(loc="outside upper center", ncols=3, fontsize="small")
    return figures


STUDY = Study(
    "finite_elements", "Comparison of two contacts with finite elements.", cases, run, page, draw
)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Random cases of the newer families, counted for docs/testing.md.

`python tests/fuzz/random_families.py FIRST LAST [FAMILY ...]` solves the cases FIRST to LAST - 1 of
each family, or of the named families, and prints their outcomes. With `--docs LOG ...` it counts
the outcomes in such logs and writes the table of the page. If a case occurs in several lines, the
last counts. Families that are not in the logs keep their counts.
"""

import json
import re
import sys
import traceback
import warnings
from collections import Counter
from pathlib import Path

import drawn_adhesion
import drawn_faces
import drawn_films
import drawn_friction
import drawn_heat
import drawn_histories
import drawn_microstructures

import samcontact as sc

COUNTS = Path(__file__).with_suffix(".json")
PAGE = Path(__file__).parents[2] / "docs" / "testing.md"
PLACE = re.compile(r"(<!-- table: random_families -->\n).*?(<!-- end of table -->)", re.DOTALL)
OUTCOMES = ("solved", "border", "convergence", "refused", "FAILED")
"""Outcomes named in the logs."""
FAMILIES = {
    "adhesive rough surfaces": drawn_adhesion.follow,
    "adhesive simulations": drawn_adhesion.follow_simulated,
    "viscoelastic histories": drawn_histories.followed,
    "microstructures": drawn_microstructures.solved,
    "films": drawn_films.solved,
    "friction laws": drawn_friction.run,
    "free faces": drawn_faces.followed,
    "heated layers": drawn_heat.followed,
}
"""Functions that solve the case of a seed; they return its result, or an error, or False."""


def outcome(result):
    """Return the outcome of a case in a word."""
    if isinstance(result, sc.GridTooSmallError):
        return "border"
    if isinstance(result, sc.ConvergenceError):
        return "convergence"
    return "refused" if result is False or isinstance(result, Exception) else "solved"


def solve(first, last, families):
    """Print the outcome of each case: family, number, outcome, place of a failure."""
    warnings.simplefilter("ignore")
    for number in range(first, last):
        for family in families:
            try:
                print(f"{family}: {number} {outcome(FAMILIES[family](number))}", flush=True)
            except Exception as failure:  # wrong results, and errors that are not documented
                line = traceback.extract_tb(failure.__traceback__)[-1]
                place = f"{line.filename.rpartition('/')[2]}:{line.lineno} {line.line}"
                cause = f"{type(failure).__name__} {str(failure)[:200]!r}"
                print(f"{family}: {number} FAILED {cause} {place}", flush=True)


def counted(lines, stored=None):
    """Return the numbers of outcomes by family; families not in the lines keep the stored ones."""
    found = {}
    for line in lines:
        family, _, rest = line.strip().partition(": ")
        number, _, ended = rest.partition(" ")
        if family in FAMILIES and number.isdecimal():
            found[family, int(number)] = next(name for name in OUTCOMES if ended.startswith(name))
    new = {family for family, _ in found}
    counts = {name: Counter({} if name in new else (stored or {}).get(name)) for name in FAMILIES}
    for (family, _), ended in found.items():
        counts[family][ended] += 1
    counts = {"all": sum(counts.values(), Counter()), **counts}
    return {family: {name: count[name] for name in OUTCOMES} for family, count in counts.items()}


def table(counts):
    """Return the table in Markdown."""
    lines = [
        "| cases | tried | " + " | ".join((*OUTCOMES[:-1], "failed")) + " |",
        "|---|---|" + "---|" * len(OUTCOMES),
    ]
    for family, count in counts.items():
        cells = [family, sum(count.values()), *(count[name] for name in OUTCOMES)]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def main(words):
    """Run the command."""
    if words[0] != "--docs":
        solve(int(words[0]), int(words[1]), words[2:] or FAMILIES)
        return
    read = [line for log in words[1:] for line in Path(log).read_text("utf-8").splitlines()]
    counts = counted(read, json.loads(COUNTS.read_text("utf-8")))
    COUNTS.write_text(json.dumps(counts, indent=1) + "\n", encoding="utf-8")
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(PLACE.sub(rf"\1\n{table(counts)}\n\n\2", text), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])

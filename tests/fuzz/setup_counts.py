# SPDX-License-Identifier: GPL-3.0-or-later
"""Outcomes of randomly drawn cases, counted for docs/testing.md.

`python tests/fuzz/setup_counts.py LOG ...` writes the counts and the table of that page. A log is
the output of `python tests/fuzz/test_fuzz_setups.py FIRST LAST`. If a case occurs in several lines,
the last line counts.
"""

import json
import math
import re
import sys
from collections import Counter
from pathlib import Path

from drawn_paths import drawn_case

COUNTS = Path(__file__).with_suffix(".json")
PAGE = Path(__file__).parents[2] / "docs" / "testing.md"
PLACE = re.compile(r"(<!-- table: drawn_setups -->\n).*?(<!-- end of table -->)", re.DOTALL)
OUTCOMES = ("solved", "border", "convergence", "unbounded flow", "parts", "heat steps", "FAILED")
"""Outcomes named in the logs; all but the first and the last are refusals."""


def laws(case):
    """Return the material laws of both bodies and their layers."""
    bodies = [case["body1"], case["body2"]]
    return {part["law"] for body in bodies for part in (body, *body.get("layers", []))}


def coulomb(case):
    friction = case["contact"].get("friction")
    return friction["coulomb"] if isinstance(friction, dict) else None


KINDS = {
    "all": lambda case: True,
    "elastic": lambda case: laws(case) <= {"elastic", "rigid"},
    "elastic-plastic": lambda case: not laws(case) <= {"elastic", "rigid"},
    "perfectly plastic": lambda case: "perfect_plastic" in laws(case),
    "layers": lambda case: "layers" in case["body1"] or "layers" in case["body2"],
    "heat": lambda case: "heat" in case,
    "periodic": lambda case: "periodic" in case["grid"],
    "roughness or reliefs": lambda case: (
        "roughness" in case["surface"] or not case.keys().isdisjoint(("relief1", "relief2"))
    ),
    "partial slip": lambda case: coulomb(case) is not None,
    "infinite friction": lambda case: coulomb(case) == math.inf,
    "rolling or sliding": lambda case: any(
        {"roll", "slide"} & step.keys() for step in case["path"]
    ),
    "`increment_tol`": lambda case: "increment_tol" in case["contact"],
}


def outcomes(lines):
    """Read the outcome of each problem, by its number, from the lines of logs."""
    found = {}
    for line in lines:
        number, _, outcome = line.strip().partition(" ")
        if number.isdecimal():
            found[int(number)] = next(name for name in OUTCOMES if outcome.startswith(name))
    return found


def counted(found):
    """Number of problems by kind and outcome."""
    counts = {kind: Counter() for kind in KINDS}
    for number, outcome in found.items():
        case = drawn_case(number)
        for kind, holds in KINDS.items():
            if holds(case):
                counts[kind][outcome] += 1
    return {kind: {name: counts[kind][name] for name in OUTCOMES} for kind in KINDS}


def table(counts):
    """Table in Markdown."""
    lines = [
        "| cases | tried | " + " | ".join((*OUTCOMES[:-1], "failed")) + " |",
        "|---|---|" + "---|" * len(counts["all"]),
    ]
    for kind, count in counts.items():
        cells = [kind, sum(count.values()), *(count[name] for name in OUTCOMES)]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


if __name__ == "__main__":
    read = [line for log in sys.argv[1:] for line in Path(log).read_text().splitlines()]
    counts = counted(outcomes(read))
    COUNTS.write_text(json.dumps(counts, indent=1) + "\n")
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(PLACE.sub(rf"\1\n{table(counts)}\n\n\2", text), encoding="utf-8")

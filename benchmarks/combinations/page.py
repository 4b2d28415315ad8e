# SPDX-License-Identifier: GPL-3.0-or-later
"""Page on pairs of capabilities: which work together, and why others are refused."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from ..study import Record, Study, table
from .capabilities import CAPABILITIES, PAIRS, contact_with
from .contact import faults

TEXT = Path(__file__).with_name("template.md")
RETESTED = (
    ("plastic body", "heat history"),
    ("no slip", "prescribed rotation"),
    ("periodic along x", "sliding"),
    ("full sliding", "prescribed shift"),
    ("steady heat", "periodic along y"),
    ("elastic coating", "heat history"),
    ("no slip", "steady heat"),
    ("elastic coating", "adhesion"),
    ("rolling", "dent of a pressed particle"),
    ("inclusion", "rolling"),
    ("viscoelastic body", "friction that falls with the slip rate"),
    ("viscoelastic body", "friction that depends on the temperature"),
    ("plastic body", "friction that depends on the temperature"),
    ("layer of wear particles", "rolling"),
    ("plastic body", "lubricant film"),
    ("full sliding", "lubricant film"),
)
"""Pairs that the tests run again."""


@dataclass(frozen=True)
class Reason:
    """Reason why pairs are refused, recognised by the error message."""

    message: str
    """Regular expression of the error message."""
    text: str
    is_limit: bool = False
    """Whether physics or mathematics excludes the pairs; otherwise the method is missing."""


REASONS = (
    Reason(
        "must not have friction under a film",
        "The shear of a film follows from its lubricant, so that no friction law of the contact "
        "applies.",
        is_limit=True,
    ),
    Reason(
        "lubricant enters and leaves at the ends",
        "Along x, lubricant enters and leaves a film, whose flow therefore does not repeat.",
        is_limit=True,
    ),
    Reason(
        r"press\(\) got an unexpected|under a film|only Simulation supports|"
        "got inf at index",
        "Under a lubricant film: prescribed approach, duration, moments, motion through the grid "
        "of plastic strain and of reliefs (`sc.lubrication.transient` moves reliefs of elastic "
        "bodies), heat, adhesion, inclusions, bodies that end inside the contact.",
    ),
    Reason(
        "is not supported in full sliding",
        "In full sliding, the shear traction is given: it acts in a prescribed direction and "
        "equals the friction coefficient times the pressure. A tangential motion or force would "
        "therefore be prescribed twice.",
        is_limit=True,
    ),
    Reason(
        "in full sliding the heat flux is proportional",
        "In full sliding, the heat flux follows from the pressure (`Heat(factor)`), and there is "
        "no slip to be computed.",
        is_limit=True,
    ),
    Reason(
        "uniformly heated half-space has no steady state",
        "The mean temperature of a half-space that is heated everywhere rises without limit.",
        is_limit=True,
    ),
    Reason(
        "requires closed-form kernels|exact kernels cannot be summed",
        'No closed form exists for the kernels of the method "exact". The default method, "fast", '
        "has no such limit.",
        is_limit=True,
    ),
    Reason(
        "free faces|free_faces",
        "The displacement due to shear and heat near a free face, and plastic flow of the body "
        "with this face; also periodic surfaces of a body with a free face.",
    ),
    Reason(
        "on a grid that is periodic along",
        "A tilted surface does not repeat: a surface that is periodic along y cannot rotate about "
        "x. Rotation about y is possible if the surface is not periodic along x.",
        is_limit=True,
    ),
    Reason("moment cannot be combined with approach", "Moment at a prescribed approach."),
    Reason(
        "advance along y is not supported|heat.velocity of body . along y must be 0",
        "Motion along y of viscoelastic bodies, inclusions and reliefs; also of plastic strain and "
        "heat along a period.",
    ),
    Reason(
        "relaxation cannot be combined with a yield stress",
        "A body that both relaxes and yields; the other body may yield.",
    ),
    Reason(
        "adhesion|attraction",
        "Adhesion with heat, free faces, or motion through the grid under partial slip.",
    ),
    Reason(
        "inclusions",
        "Inclusions in a body that is dented by a particle. Inclusions with the method "
        '"exact": it evaluates the stress at cell centres, which makes soft inclusions unstable.',
    ),
)


def points(quick: bool) -> list[Record]:
    return [{"of": "pairs", "first": first, "second": second}
            for first, second in (RETESTED if quick else PAIRS)]  # fmt: skip


def run(of: str, first: str, second: str) -> Record:
    """Return the error message of a refused pair; empty: the pair works."""
    try:
        violated = faults(contact_with(first, second))
    except ValueError as error:
        return {"refusal": str(error)}
    if violated:
        raise ArithmeticError(f"{first} with {second}: violated: {', '.join(violated)}")
    return {"refusal": ""}


def reason(record: Record) -> Reason:
    """Return the reason of a refused pair."""
    for known in REASONS:
        if re.search(known.message, record["refusal"]):
            return known
    pair = f"{record['first']} with {record['second']}"
    raise LookupError(f"no reason is known for {pair}: {record['refusal']}")


def _refused(records: list[Record], limits: bool) -> str:
    """Return the table of reasons with the refused pairs."""
    found: dict[Reason, dict[str, list[str]]] = {}
    for record in records:
        if record["refusal"] and (known := reason(record)).is_limit == limits:
            found.setdefault(known, {}).setdefault(record["first"], []).append(record["second"])
    rows = []
    for known, pairs in found.items():
        listed = "; ".join(f"{first} with {' or '.join(others)}" for first, others in pairs.items())
        rows.append([known.text, listed])
    return table(["reason" if limits else "missing method", "pairs"], rows)


def page(records: list[Record]) -> str:
    refused = [record for record in records if record["refusal"]]
    limits = sum(reason(record).is_limit for record in refused)
    values = {
        "capabilities": len(CAPABILITIES),
        "pairs": len(records),
        "works": len(records) - len(refused),
        "limits": limits,
        "missing": len(refused) - limits,
        "listed": ", ".join(CAPABILITIES),
        "excluded": _refused(records, True),
        "not_available": _refused(records, False),
    }
    return TEXT.read_text(encoding="utf-8").format(**values)


STUDY = Study("combinations", "Pairs of capabilities: which work together.", points, run, page)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of adhesive rough contacts at equal error, in samcontact and other codes."""

from __future__ import annotations

import contextlib
import importlib
import io
import time
from pathlib import Path as File
from typing import Any

from ..study import Record, Study, table
from .problems import Path, State, errors

TEXT = File(__file__).with_name("template.md")
MODULES = {"samcontact": "samcontact", "tamaas": "tamaas", "Adhesion": "adhesion"}
CODES = {"periodic": ("samcontact", "tamaas", "Adhesion"), "free": ("samcontact", "Adhesion")}
DISTANCES = {"periodic": (2.0, 1.5, 1.2, 1.0, 0.8), "free": (1.0, 0.3, -0.5, -1.0, -1.5)}
SIZES = (64, 128, 256)
KAPPA = 0.3
ALLOWED = 1e-6
"""Error of the pressure at which times are compared."""
REFERENCE = 1e-11
ROUNDS = 2


def points(quick: bool) -> list[Record]:
    return [{"of": of, "n": n} for of in CODES for n in (SIZES[:1] if quick else SIZES)]


def path_of(of: str, n: int) -> Path:
    """Return an approach and the retraction to its start."""
    there = DISTANCES[of]
    return Path(n, "xy" if of == "periodic" else "", KAPPA, there + there[-2::-1])


def timed(contact: Any) -> tuple[float, list[State]]:
    """Return processor time and states of a path; messages of the codes are dropped."""
    start = time.process_time()
    with contextlib.redirect_stdout(io.StringIO()):
        states = contact.solve()
    return time.process_time() - start, states


def run(of: str, n: int) -> list[Record]:
    """Return a record for each installed code, at its loosest tolerance of a sufficient error."""
    path = path_of(of, n)
    codes: dict[str, Any] = {}
    for name in CODES[of]:
        with contextlib.suppress(ImportError):
            codes[name] = importlib.import_module(f"{__package__}.code_{MODULES[name]}").Contact
    exact = timed(codes["samcontact"](path, REFERENCE))[1]
    rows: dict[str, Record] = {}
    chosen = {}
    for name, code in codes.items():
        for tol in code.tolerances:
            contact = code(path, tol)
            seconds, states = timed(contact)
            pressure, energy, same = errors(path, states, exact)
            if pressure <= ALLOWED:
                break
        chosen[name] = contact
        rows[name] = {
            "code": name, "tol": tol, "cpu_s": seconds, "pressure": pressure, "energy": energy,
            "same": same, "states": len(states),
            "iterations": sum(state.iterations for state in states) / len(states),
            "contact": max(float((state.gap <= 0).mean()) for state in exact),
        }  # fmt: skip
    for _ in range(ROUNDS - 1):
        for name, contact in chosen.items():
            rows[name]["cpu_s"] = min(rows[name]["cpu_s"], timed(contact)[0])
    for row in rows.values():
        row["ratio"] = row["cpu_s"] / rows["samcontact"]["cpu_s"]
    return list(rows.values())


def times(records: list[Record], of: str) -> str:
    """Return the table of a kind of surface."""
    lines = [
        [f"{row['n']} × {row['n']}", row["code"], f"{row['cpu_s']:.3g}", f"{row['ratio']:.2f}",
         f"{row['iterations']:.1f}", f"{row['pressure']:.1e}", f"{row['energy']:.1e}",
         f"{row['same']} of {row['states']}"]
        for row in records if row["of"] == of
    ]  # fmt: skip
    return table(
        ["cells", "code", "time [s]", "time / samcontact", "iterations per state",
         "error of the pressure", "difference of the energy", "states in the same minimum"], lines,
    )  # fmt: skip


def contacts(records: list[Record], of: str) -> str:
    """Return the largest fraction of cells in contact on the finest grid, in per cent."""
    last = [row for row in records if row["of"] == of][-1]
    return f"{100 * last['contact']:.0f}"


def least(records: list[Record], of: str) -> str:
    """Return the smallest ratio of times of another code on the finest grid."""
    last = [row for row in records if row["of"] == of and row["n"] == SIZES[-1]]
    return f"{min(row['ratio'] for row in last if row['code'] != 'samcontact'):.1f}"


def page(records: list[Record]) -> str:
    found = {f"{of}_{what.__name__}": what(records, of)
             for of in CODES for what in (times, contacts, least)}  # fmt: skip
    return TEXT.read_text(encoding="utf-8").format(
        **found, kappa=KAPPA, allowed=f"{ALLOWED:g}", finest=SIZES[-1]
    )


STUDY = Study(
    "adhesion_peers", "Adhesive rough contact, compared with other codes.", points, run, page
)

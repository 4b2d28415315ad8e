# SPDX-License-Identifier: GPL-3.0-or-later
"""Common parts of the CalculiX decks: sets, both materials, contact, steps.

Units are millimetres, newtons and megapascals.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import samcontact as sc

RESIDUAL = 5e-4  # relative residual at which an increment is accepted

FloatArray = NDArray[np.float64]


def steel(elastic_only: bool) -> list[str]:
    """Return the deck lines of both materials: elastic UPPER, and LOWER of AISI 52100."""
    law = sc.Material.swift(210e9, 0.3, B=945e6, C=20, n=0.121)
    strains = np.r_[0.0, np.geomspace(1e-6, 0.2, 150)]
    curve = [f"{law.yield_stress(g) / 1e6:.10g}, {g:.10g}" for g in strains]
    if elastic_only:
        curve = ["1e6, 0."]
    elastic = ["*ELASTIC", "210000., 0.3"]
    return [
        "*MATERIAL, NAME=ELASTIC", *elastic, "*SOLID SECTION, ELSET=UPPER, MATERIAL=ELASTIC",
        "*MATERIAL, NAME=STEEL", *elastic, "*PLASTIC", *curve,
        "*SOLID SECTION, ELSET=LOWER, MATERIAL=STEEL",
    ]  # fmt: skip


def named(kind: str, name: str, numbers: list[int]) -> list[str]:
    """Return the deck lines of a named set of nodes or elements."""
    return [f"*{kind}, {kind}={name}", *(f"{n}," for n in numbers)]


def surface(name: str, elements: list[int], side: str) -> list[str]:
    """Return the deck lines of a surface that consists of one side of several elements."""
    return [f"*SURFACE, NAME={name}, TYPE=ELEMENT", *(f"{n}, {side}" for n in elements)]


def contact(stiffness: float) -> list[str]:
    """Return the deck lines of the contact of BELOW and ABOVE, face to face; stiffness [N/mm^3]."""
    return [
        "*SURFACE INTERACTION, NAME=TOUCH",
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness:g}, 1e-3",
        "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "BELOW, ABOVE",
    ]  # fmt: skip


def step(drive: list[str], increments: int, printed: list[str]) -> list[str]:
    """Return the deck lines of a step, with the lines of its load (`drive`) and output."""
    return [
        "*STEP, INC=10000", "*STATIC, DIRECT", f"{1.0 / increments:.10g}, 1.",
        "*CONTROLS, PARAMETERS=FIELD", f"{RESIDUAL:g}, {100 * RESIDUAL:g}",
        *drive, *printed, "*END STEP",
    ]  # fmt: skip

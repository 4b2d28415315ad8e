# SPDX-License-Identifier: GPL-3.0-or-later
"""Field that is probably meant by a wrong name, which is a synonym or a misspelling."""

from __future__ import annotations

import difflib
import re
from collections.abc import Sequence

LIKELY = 0.75
"""Similarity (0 to 1) above which one of two names is probably a misspelling of the other."""

# Names of fields by synonym; synonyms are in lower case and without separators.
SYNONYMS = {
    "radius": ("R", "Rx", "R1"),
    "radiusx": ("Rx",),
    "radiusy": ("Ry",),
    "r": ("Rx",),
    "young": ("E",),
    "youngsmodulus": ("E",),
    "youngmodulus": ("E",),
    "elasticmodulus": ("E",),
    "modulus": ("E",),
    "poisson": ("nu",),
    "poissonratio": ("nu",),
    "poissonsratio": ("nu",),
    "sigmay": ("yield_stress",),
    "yieldstrength": ("yield_stress",),
    "mu": ("friction", "coulomb"),
    "cof": ("friction", "coulomb"),
    "coefficient": ("coulomb", "friction"),
    "force": ("load", "radial_load", "tangential_load_x"),
    "load": ("radial_load",),
    "width": ("length", "face_width"),
    "balls": ("elements",),
    "rollers": ("elements",),
    "hv": ("surface",),
    "vickers": ("surface",),
    "tolerances": ("tol",),
    "forcex": ("tangential_load_x",),
    "forcey": ("tangential_load_y",),
    "moment": ("moment_x", "torque"),
    "tilt": ("tilt_x",),
    "misalignment": ("tilt_x",),
    "rotation": ("twist",),
    "creepage": ("slide_to_roll", "advance"),
    "fretting": ("fret",),
    "indentation": ("approach",),
    "displacement": ("approach",),
    "steps": ("increments",),
    "tolerance": ("tol",),
    "material": ("law",),
    "type": ("law", "kind", "shape"),
    "name": ("title",),
    "file": ("path",),
    "filename": ("path",),
    "speed": ("velocity",),
    "folder": ("directory",),
}


def nearest(name: str, fields: Sequence[str], cutoff: float = 0.5) -> str | None:
    """Return the field probably meant by a wrong name (a synonym or misspelling), or None.

    cutoff: minimum similarity of a misspelling, 1 for equal names. Names less similar than
    `LIKELY` must also have a word or their first three letters in common.
    """
    lower = {field.lower(): field for field in reversed(fields)}
    word = re.sub(r"[^a-z]", "", name.lower())
    for suggestion in SYNONYMS.get(word, ()):
        if suggestion in fields:
            return suggestion
    for found in difflib.get_close_matches(name.lower(), lower, len(lower) or 1, cutoff=cutoff):
        similar = difflib.SequenceMatcher(None, name.lower(), found).ratio()
        words = set(name.lower().split("_")) & set(found.split("_"))
        if similar >= LIKELY or words or found[:3] == name[:3].lower():
            return lower[found]
    return None

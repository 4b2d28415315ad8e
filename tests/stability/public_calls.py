# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of everything public, and the names by which errors may call its arguments."""

import re

from calls_of_contact import CALLS as ON_GRIDS
from calls_of_formulas import CALLS as FORMULAS
from calls_of_laws import CALLS as OF_LAWS
from calls_of_shakedown import CALLS as OF_SHAKEDOWN
from calls_of_wear import CALLS as OF_WEAR

CALLS = FORMULAS + ON_GRIDS + OF_LAWS + OF_SHAKEDOWN + OF_WEAR
PARTS = {
    "kinematic": {"modulus", "recovery"},
    "thermal": {"conductivity", "expansion", "diffusivity"},
}
"""Names of the numbers of an argument that has several."""


def names_in(name, value):
    """What an error about an argument may call it: its name, or that of a part with a name."""
    found = {name} | PARTS.get(name, set())
    for item in value if isinstance(value, (list, tuple)) else [value]:
        found |= set(item) if isinstance(item, dict) else set()
    return found


def is_named(name, text):
    """A single letter may be a word of the sentence anywhere but at its beginning."""
    where = "^" if len(name) == 1 else r"(?<!\w)"
    return re.search(rf"{where}{re.escape(name)}(?!\w)", text) is not None

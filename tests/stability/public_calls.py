# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of all public functions, and permitted names of their arguments in errors."""

import re

from calls_of_adhesion import CALLS as OF_ADHESION
from calls_of_bearings import CALLS as BEARINGS
from calls_of_contact import CALLS as ON_GRIDS
from calls_of_formulas import CALLS as FORMULAS
from calls_of_inclusions import CALLS as OF_INCLUSIONS
from calls_of_laws import CALLS as OF_LAWS
from calls_of_lubrication import CALLS as OF_LUBRICATION
from calls_of_materials import CALLS as OF_MATERIALS
from calls_of_motion import CALLS as OF_MOTION
from calls_of_parts import CALLS as OF_PARTS
from calls_of_paths import CALLS as OF_PATHS
from calls_of_shakedown import CALLS as OF_SHAKEDOWN
from calls_of_viscoelasticity import CALLS as OF_VISCOELASTICITY
from calls_of_wear import CALLS as OF_WEAR

CALLS = [
    *FORMULAS, *BEARINGS, *ON_GRIDS, *OF_LAWS, *OF_LUBRICATION, *OF_MATERIALS, *OF_MOTION,
    *OF_PARTS, *OF_INCLUSIONS, *OF_ADHESION, *OF_PATHS, *OF_SHAKEDOWN, *OF_VISCOELASTICITY,
    *OF_WEAR,
]  # fmt: skip
PARTS = {
    "kinematic": {"modulus", "recovery"},
    "thermal": {"conductivity", "expansion", "diffusivity"},
    "relaxation_terms": {"times", "shares"},
}
"""Names of the numbers of an argument that has several."""


def names_in(name, value):
    """Return the permitted names of an argument in errors: its own name or that of a part."""
    found = {name} | PARTS.get(name, set())
    for item in value if isinstance(value, (list, tuple)) else [value]:
        found |= set(item) if isinstance(item, dict) else set()
    return found


def is_named(name, text):
    """Return whether a message names an argument; single letters count only at its start."""
    where = "^" if len(name) == 1 else r"(?<!\w)"
    return re.search(rf"{where}{re.escape(name)}(?!\w)", text) is not None

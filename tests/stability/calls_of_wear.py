# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every public function of wear, with all arguments."""

from calls_of_contact import BODIES, GAP, LOAD, NOTHING, STRAIN
from calls_of_formulas import STEEL

import samcontact as sc

RUBBED = {**BODIES, "body2": STEEL}


def last_wear():
    """Compute one cycle of wear that removes nothing."""
    return sc.wear.run(
        **BODIES, gap=GAP, cycle=[{"load": LOAD}, {"load": 0.0}], threshold=0.04, cycles=1,
        window=1, order=0, progress=False, tol=1e-4,
    )  # fmt: skip


def last_scar():
    """Compute one cycle of fretting with negligible wear."""
    return sc.wear.fretting(
        **RUBBED, gap=GAP, cycle=SCAR, friction=sc.Coulomb(0.3), energy=1e-20, cycles=1,
        progress=False, tol=1e-4,
    )  # fmt: skip


SCAR = [{"load": LOAD, "tangential_load": (q * LOAD, 0.0)} for q in (0.0, 0.1, -0.1, 0.1)]
WORN, FRETTED = last_wear(), last_scar()

CALLS = [
    ("wear.depth", sc.wear.depth, {"equivalent": STRAIN[0], "dz": 5e-5, "threshold": 0.04}),
    (
        "wear.run",
        sc.wear.run,
        {
            **BODIES, "gap": GAP, "cycle": [{"load": LOAD}, {"load": 0.0}], "threshold": 0.04,
            "cycles": 1, "worn": (2,), "window": 1, "order": 0, "strain_depth": "exact",
            "keep_heat": False, "friction": 0.0, "relief1": None, "relief2": None,
            "checkpoint": None, "progress": False, "tol": 1e-4,
        },
    ),
    (
        "wear.run",
        sc.wear.run,
        {
            **BODIES, "gap": GAP, "cycle": [{"load": LOAD}, {"load": 0.0}], "threshold": 0.04,
            "cycles": 1, "smoothing_length": 5e-5, "progress": False, "tol": 1e-4,
        },
    ),
    (
        "wear.fretting",
        sc.wear.fretting,
        {
            **RUBBED, "gap": GAP, "cycle": SCAR, "friction": sc.Coulomb(0.3), "energy": 1e-20,
            "cycles": 1, "repeats": 1, "relief1": None, "relief2": None, "checkpoint": None,
            "progress": False, "tol": 1e-4,
        },
    ),
    (
        "wear.fretting",
        sc.wear.fretting,
        {
            **RUBBED, "gap": GAP, "cycle": SCAR, "friction": sc.Coulomb(0.3), "archard": 1e-20,
            "cycles": 1, "progress": False, "tol": 1e-4,
        },
    ),
    (
        "wear.below_worn_surface",
        sc.wear.below_worn_surface,
        {"field": STRAIN, "depth": NOTHING, "dz": 5e-5},
    ),
    ("wear.smooth", sc.wear.smooth, {"depth": NOTHING, "window": (3, 3), "order": 2}),
    ("wear.WearResult.x", WORN.x, {"body": 2}),
    ("wear.WearResult.profile", WORN.profile, {"cycle": 1, "body": 2}),
    ("wear.WearResult.to_dataset", WORN.to_dataset, {}),
    ("wear.FrettingResult.x", FRETTED.x, {"body": 2}),
    ("wear.FrettingResult.profile", FRETTED.profile, {"cycle": 1, "body": 2}),
    ("wear.FrettingResult.to_dataset", FRETTED.to_dataset, {}),
]  # fmt: skip

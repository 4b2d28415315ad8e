# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every public function that writes a path, with all arguments."""

from calls_of_contact import DRIVERS, PATCH

import samcontact as sc

PASSES = {
    "distance": 1e-4, "step": 5e-5, "passes": 1, "increments": 2, "unload_increments": 2,
    "back_and_forth": False, "speed": 1.0, "heat_factor": (0.0, 0.01), "return_time": 0.1,
}  # fmt: skip
RAMP = {"increments": 3, "spacing": "power", "exponent": 2.0}
PARTS = {"advance": (1e-5, 2e-5), "duration": 0.1, "heat_factor": 0.01}

CALLS = [
    *(
        (f"paths.{name}", getattr(sc.paths, name), {**driver, **PASSES, **rest})
        for name, rest in (
            ("rolling", {"slide_to_roll": -0.1, "lateral_creepage": 1e-3, "spin": 1.0}),
            ("rolling", {"tangential_load_x": 1.0}),
            ("sliding", {"slider": 1}),
        )
        for driver in DRIVERS
    ),
    *(
        (f"paths.{name}", getattr(sc.paths, name), {**DRIVERS[0], **drive, **rest, "increments": 2})
        for name, rest in (("tangential", {}), ("fretting_loop", {"cycles": 1}))
        for drive in ({"force": (1.0, 0.0)}, {"shift": (1e-7, 0.0)})
    ),
    *(
        ("paths.traverse", sc.paths.traverse,
         {"points": [(0.0, 0.0), (1e-5, 0.0), (1e-5, 2e-5)], "step": 5e-6, "slider": 1,
          "speed": 0.1, **driver})
        for driver in (*DRIVERS, {"pressure": PATCH})
    ),
    ("paths.tangential", sc.paths.tangential,
     {"load": 10.0, "force": (1.0, 0.0), "start": (0.5, 0.0)}),
    ("paths.tangential", sc.paths.tangential, {"approach": 1e-7, "force": (1.0, 0.0)}),
    ("paths.fretting_loop", sc.paths.fretting_loop, {"approach": 1e-7, "force": (1.0, 0.0)}),
    *(
        ("paths.hold", sc.paths.hold, {**driver, "increments": 2, **PARTS, "first_duration": 0.01})
        for driver in DRIVERS
    ),
    *(
        ("paths.ramp", sc.paths.ramp, {**driver, "start": 1e-7, **RAMP, **PARTS})
        for driver in DRIVERS
    ),
    *(
        (
            "paths.load_unload",
            sc.paths.load_unload,
            {**driver, **RAMP, "unload_increments": 2, "end": 0.0},
        )
        for driver in DRIVERS
    ),
]  # fmt: skip

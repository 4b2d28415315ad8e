# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of each public function of bearings and rollers, with all arguments."""

import samcontact as sc

GRID = sc.Grid(7, 5, 1e-4, 1e-4)
BALLS = sc.bearings.standard("6208")
SIZES = {"element_diameter": 8e-3, "pitch_diameter": 4e-2, "elements": 8, "rows": 2, "source": "s"}
LOADS = {"radial_load": 500.0, "axial_load": 200.0, "moment": 1.0, "E_star": 1.1e11}
ROLLER = {
    "grid": GRID, "radius": 5e-3, "length": 4e-4, "race_radius": 2e-2, "tilt": 1e-3, "skew": 1e-2,
}  # fmt: skip
CALLS = [
    (
        "bearings.Bearing",
        sc.bearings.Bearing,
        {
            "kind": "deep_groove",
            **SIZES,
            "contact_angle": 0.0,
            "inner_conformity": 0.52,
            "outer_conformity": 0.53,
            "clearance": 1e-5,
        },
    ),
    (
        "bearings.Bearing",
        sc.bearings.Bearing,
        {"kind": "cylindrical_roller", **SIZES, "length": 1e-2, "profile": "straight"},
    ),
    ("bearings.Bearing.element_loads", BALLS.element_loads, LOADS),
    ("bearings.Bearing.max_element_load", BALLS.max_element_load, LOADS),
    (
        "bearings.Bearing.load_factor",
        BALLS.load_factor,
        {"element_load": 1e3, "radial_load": 500.0, "axial_load": 200.0, "moment": 1.0},
    ),
    ("bearings.Bearing.gap", BALLS.gap, {"race": "inner", "tilt": 0.0}),
    ("bearings.Bearing.hertz", BALLS.hertz, {"race": "outer", "load": 1e3, "E_star": 1.1e11}),
    ("bearings.Bearing.race", BALLS.race, {"race": "outer"}),
    (
        "bearings.Bearing.static_equivalent_load",
        BALLS.static_equivalent_load,
        {"radial_load": 1e3, "axial_load": 2e3},
    ),
    (
        "bearings.Bearing.static_safety",
        BALLS.static_safety,
        {"radial_load": 1e3, "axial_load": 2e3},
    ),
    ("bearings.standard", sc.bearings.standard, {"designation": "6208", "clearance": 1e-5}),
    (
        "bearings.from_boundary",
        sc.bearings.from_boundary,
        {"bore": 4e-2, "outside_diameter": 8e-2, "clearance": 1e-5},
    ),
    *(
        ("surfaces.roller", sc.surfaces.roller, {**ROLLER, **profile})
        for profile in (
            {"profile": "crowned", "crown_radius": 1.0, "straight_length": 1e-4},
            {"profile": "logarithmic", "diameter": 1e-2},
            {"profile": "lundberg", "design_load": 100.0, "E_star": 1.1e11},
        )
    ),
]

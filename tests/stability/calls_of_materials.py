# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of the library of materials, hardness profiles, exposures and lives."""

import samcontact as sc

FLANK = sc.hertz.line(1e-2, 1e11, p0=1e9)
STEEL = sc.Material.linear_hardening(2e11, 0.3, 1e9, 1e10)
CASE = sc.hardness.HardnessProfile((0.0, 1e-3), (390.0, 300.0))
CYCLE = sc.fatigue.hertz_cycle(FLANK, STEEL, z=[1e-5, 2e-5])
SHEAR = sc.fatigue.orthogonal_shear(CYCLE)
LIFE = sc.fatigue.life(SHEAR, depth_exponent=0.0)
EXPOSURE = sc.fatigue.exposure(CYCLE, CASE)

CALLS = [
    (
        "Material.from_test",
        sc.Material.from_test,
        {
            "strain": [0.0, 1e-3, 2e-3, 3e-3, 4e-3, 2e-2, 5e-2],
            "stress": [0.0, 2e8, 4e8, 6e8, 7e8, 8e8, 9e8],
            "engineering": False,
            "E": 2e11,
            "nu": 0.3,
            "offset": 1e-3,
        },
    ),
    ("materials.names", sc.materials.names, {}),
    ("materials.get", sc.materials.get, {"name": "100Cr6"}),
    *(
        (f"materials.MaterialData.{method}", getattr(sc.materials.get("M50"), method), {name: text})
        for method, name, text in (
            ("constants", "law", "swift"),
            ("material", "law", "swift"),
            ("source", "constant", "E"),
            ("value", "constant", "E"),
        )
    ),
    ("hardness.HardnessProfile", sc.hardness.HardnessProfile, {"z": [0.0], "HV": [300.0]}),
    ("hardness.HardnessProfile.at", CASE.at, {"z": [0.0, 1e-4]}),
    ("hardness.HardnessProfile.depth_of", CASE.depth_of, {"HV": 350.0}),
    ("hardness.HardnessProfile.applied_to", CASE.applied_to, {"material": STEEL}),
    (
        "hardness.hardened_case",
        sc.hardness.hardened_case,
        {"surface": 600.0, "core": 300.0, "depth": 1e-3, "limit": 500.0},
    ),
    (
        "hardness.bending_limit_from_vickers",
        sc.hardness.bending_limit_from_vickers,
        {"HV": [300.0], "defect": 2e-5, "location": "surface"},
    ),
    (
        "fatigue.hertz_cycle",
        sc.fatigue.hertz_cycle,
        {"contact": FLANK, "body": STEEL, "z": [1e-5], "friction": 0.1},
    ),
    (
        "fatigue.hertz_cycle",
        sc.fatigue.hertz_cycle,
        {"contact": sc.hertz.point(1e-2, 1e11, p0=1e9), "body": STEEL, "z": [1e-5], "y": [0.0]},
    ),
    ("fatigue.max_von_mises", sc.fatigue.max_von_mises, {"states": CYCLE}),
    (
        "fatigue.exposure",
        sc.fatigue.exposure,
        {"states": CYCLE, "hardness": CASE, "slope": 0.3, "axis": "y", "defect": 2e-5},
    ),
    ("fatigue.Exposure.to_dataset", EXPOSURE.to_dataset, {}),
    ("fatigue.Exposure.max_value", EXPOSURE.max_value, {"criterion": "yield"}),
    ("fatigue.Exposure.depth", EXPOSURE.depth, {"criterion": "yield"}),
    (
        "fatigue.life",
        sc.fatigue.life,
        {
            "field": SHEAR,
            "model": "ioannides_harris",
            "limit": 1e7,
            "exponent": 9.0,
            "depth_exponent": 1.0,
            "weibull": 1.1,
            "length": 0.1,
            "stress_depth": 1e-5,
        },
    ),
    ("fatigue.Life.relative_to", LIFE.relative_to, {"reference": LIFE}),
    ("fatigue.Life.constant_for", LIFE.constant_for, {"cycles": 1e6, "reliability": 0.9}),
    ("fatigue.Life.cycles", LIFE.cycles, {"log_constant": -200.0, "reliability": 0.9}),
]

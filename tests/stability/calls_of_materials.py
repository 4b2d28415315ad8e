# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of the library of materials and of hardening laws from tests."""

import samcontact as sc

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
]

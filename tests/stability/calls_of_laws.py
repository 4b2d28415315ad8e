# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every friction law and contact law, with all arguments."""

from dataclasses import asdict

import numpy as np

import samcontact as sc

CALLS = [
    *(
        (f"{type(law).__name__}{call}", function, arguments)
        for law in (
            sc.Coulomb(0.3),
            sc.Tresca(1e8),
            sc.CappedCoulomb(0.3, 1e8),
            sc.Anisotropic(0.3, 0.2, 0.5),
            sc.FallingCoulomb(0.2, 0.1, 1.0, 1e-6),
            sc.ThirdBody(0.3, 1e8, 1e9, 1e-6),
            sc.ThermalCoulomb([0.0, 100.0], [0.3, 0.2], 20.0),
            sc.MappedCoulomb([0.3, 0.2], y=[0.0, 1e-3]),
        )
        for call, function, arguments in (
            ("", type(law), asdict(law)),
            (".bound", law.bound, {"pressure": np.full((3, 3), 1e8)}),
            (".ratio", law.ratio, {"pressure": 1e8}),
            (".to_core", law.to_core, {}),
            (".to_tree", law.to_tree, {}),
        )
    ),
    *(
        (f"{type(law).__name__}{call}", function, arguments)
        for law in (
            sc.HardContact(),
            sc.TensileLimit(1e6),
            sc.Adhesion.exponential(0.1, 1e-9),
            type(sc.Adhesion.dugdale(0.1, 1e7))(0.1, 1e7, 1e-8),
            sc.Adhesion.lennard_jones(0.1, 1e-9),
            sc.Adhesion.tabulated([0.0, 1e-9], [1e7, 0.0]),
        )
        for call, function, arguments in (
            ("", type(law), asdict(law)),
            (
                ".require_possible",
                law.require_possible,
                {"heat": sc.Heat(), "given": {}, "sticks": False},
            ),
            (".may_move", law.may_move, {"sticks": False}),
            (".to_core", law.to_core, {}),
            (".to_tree", law.to_tree, {}),
        )
    ),
]

# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every public function of viscoelastic bodies."""

from calls_of_contact import GAP, GRID, LOAD, STEEL

import samcontact as sc

SLS = STEEL.with_relaxation([1.0], [0.5])
CREEPING = sc.Simulation(GRID, STEEL, SLS, GAP)
STATE = CREEPING.step(load=LOAD, duration=1.0)
SHARES = [0.1, 0.2]
OMEGA = [0.1, 1.0, 10.0]

CALLS = [
    ("Material.with_relaxation", STEEL.with_relaxation, {"times": [1.0, 2.0], "shares": SHARES}),
    (
        "Material.from_dynamic",
        sc.Material.from_dynamic,
        {
            "omega": OMEGA, "storage": SLS.storage(OMEGA), "loss": SLS.loss(OMEGA), "terms": 3,
            "nu": 0.4,
        },
    ),
    ("Material.relaxation", SLS.relaxation, {"t": [0.0, 1.0]}),
    ("Material.creep", SLS.creep, {"t": [0.0, 1.0]}),
    ("Material.storage", SLS.storage, {"omega": OMEGA}),
    ("Material.loss", SLS.loss, {"omega": OMEGA}),
    ("Simulation.relax", CREEPING.relax, {"hold": "load"}),
    ("State.equivalent_pressure", STATE.equivalent_pressure, {"body": 2}),
    ("State.viscous_work", STATE.viscous_work, {"body": 2}),
    ("State.stored_energy", STATE.stored_energy, {"body": 2}),
    ("paths.creep", sc.paths.creep, {"load": 1.0, "until": 1.0, "per_decade": 2, "first": 0.01}),
    (
        "paths.stress_relaxation",
        sc.paths.stress_relaxation,
        {"approach": 1e-6, "until": 1.0, "per_decade": 2, "first": 0.01},
    ),
    (
        "paths.oscillation",
        sc.paths.oscillation,
        {
            "mean": 1.0, "amplitude": 0.5, "frequency": 2.0, "periods": 2, "increments": 4,
            "quantity": "load",
        },
    ),
]  # fmt: skip

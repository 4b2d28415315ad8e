# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every public function that computes on a grid, with all arguments."""

import atexit
import shutil
import tempfile
from pathlib import Path

import numpy as np
from calls_of_formulas import COLLISION, HOT, NU, STEEL, E

import samcontact as sc
from samcontact import results

GRID = sc.Grid(9, 9, 5e-5, 5e-5, 6, 5e-5)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
LOAD = 60.0
SOFT = sc.Material.perfect_plastic(E, NU, 6e8)
COATED = sc.Layered([(STEEL, 1e-6)], SOFT)
KINEMATIC = SOFT.with_kinematic_hardening(1e10)
NOTHING = np.zeros(GRID.surface_shape)
PATCH = NOTHING.copy()
PATCH[4, 4] = 1e8
STRAIN = np.zeros((6, *GRID.volume_shape))
FLAT = sc.Relief(np.zeros((3, 9)))

HEATED = {
    "friction": 0.1,
    "heat": sc.Heat((0.01, 0.02), ((0.1, 0.0), (0.2, 0.1)), time=1.0, reference=1.0),
}
BODIES = {"grid": GRID, "body1": STEEL, "body2": SOFT}
SOLVER = sc.ContactSolver(GRID, HOT, HOT, heat=sc.Heat((0.0, 0.01), time=1.0, reference=1.0))
FRETTING = sc.Simulation(GRID, STEEL, STEEL, GAP, sc.Coulomb(0.3))
PULLED = sc.Simulation(GRID, STEEL, STEEL, GAP, sc.Coulomb(0.3))
STICKING = sc.ContactSolver(GRID, STEEL, STEEL, sc.Coulomb(0.3))
FALLING = sc.ContactSolver(GRID, STEEL, STEEL, sc.FallingCoulomb(0.2, 0.1, 1.0))
STUCK = STICKING.solve(GAP, load=LOAD)
SIMULATION = sc.Simulation(**BODIES, gap=GAP, tol=1e-4)
STATE = SIMULATION.step(load=LOAD)
COATED_STATE = sc.Simulation(
    sc.Grid(9, 9, 5e-5, 5e-5), STEEL, sc.Layered([(STEEL, 1e-6)], STEEL), GAP
).step(load=LOAD)
PRESSED = {"run": sc.Simulation(**BODIES, gap=GAP), "path": [{"load": LOAD}], "states": [STATE]}
FIND = {
    "case": lambda load: (sc.Simulation(**BODIES, gap=GAP), [{"load": load}]),
    "quantity": "approach", "value": 1e-6, "tolerance": 1e-2, "largest_load": 2 * LOAD,
    "progress": False, "checkpoint": None,
}  # fmt: skip
ERRORS = sc.estimate_errors(**PRESSED)
TRACK = STATE.track(2, margin=0)
FATIGUE = sc.fatigue.dang_van([STATE, STATE], 2, slope=0.3)
ZONE = STATE.zones(2)[0]
MARCHED = {"heat": sc.Heat((0.0, 0.01), history=(1e-4, 1e-2)), "friction": 0.1}
MARCHING = sc.Simulation(GRID, HOT, HOT, GAP, **MARCHED)
SETTABLE = sc.Simulation(GRID, STEEL, KINEMATIC, GAP, tol=1e-4)

FOLDER = Path(tempfile.mkdtemp(prefix="samcontact-"))
atexit.register(shutil.rmtree, FOLDER)
CHECKPOINT = FOLDER / "state.h5"
SIMULATION.save(CHECKPOINT)
HEIGHTS = FOLDER / "heights.npy"
np.save(HEIGHTS, np.zeros((4, 3)))
CASE = FOLDER / "case.toml"
CASE.write_text(
    """title = "one ball"
[grid]
nx = 9
ny = 9
dx = 5e-5
dy = 5e-5
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[[path]]
load = 100.0
increments = 1
""",
    encoding="utf-8",
)
ACCURATE = sc.to_accuracy(CASE, 0.5, progress=False)

SETTINGS = {
    "tol": 1e-4, "on_border": "error", "on_stall": "error", "max_iterations": 60,
}  # fmt: skip
DRIVERS = ({"load": 10.0}, {"approach": 1e-6})
STEP = {"heat_factor": (0.0, 0.0), "advance": (0.0, 0.0)}
BODY_FIELDS = (
    "offset", "stress", "residual_stress", "initial_stress", "von_mises", "hydrostatic",
    "plastic_strain", "equivalent_plastic_strain", "backstress", "max_equivalent_plastic_strain",
    "max_plastic_strain_magnitude", "relief", "surface_displacement", "temperature",
    "surface_temperature", "softening", "zones", "eigenstrain", "eigenstress", "has_eigenstrain",
)  # fmt: skip
TRACK_FIELDS = (
    "residual_stress", "initial_stress", "yield_factor", "residual_von_mises",
    "residual_hydrostatic", "plastic_strain", "equivalent_plastic_strain", "backstress",
    "eigenstrain", "eigenstress",
)  # fmt: skip
ZONE_FIELDS = ("stress", "residual_stress", "plastic_strain", "equivalent_plastic_strain")


CALLS = [
    ("Grid.depths", GRID.depths, {"layers": 3}),
    (
        "ContactSolver",
        sc.ContactSolver,
        {
            "grid": GRID, "body1": HOT, "body2": HOT, **HEATED, "tol": 1e-6,
            "on_border": "error", "on_stall": "error", "max_iterations": 50,
            "adhesion": sc.HardContact(), "stiffness": None,
        },
    ),
    *(
        ("ContactSolver.solve", SOLVER.solve, {"gap": GAP, "initial_pressure": PATCH, **driver})
        for driver in DRIVERS
    ),
    *(
        (
            "ContactSolver.solve",
            STICKING.solve,
            {"gap": GAP, "previous": STUCK, "load": LOAD, **drive},
        )
        for drive in (
            {"shift": (1e-8, 0.0), "twist": 1e-6, "tilt": (1e-6, 0.0)},
            {"tangential_load": (1.0, 2.0), "torque": 1e-6, "moment": (1e-6, 0.0)},
            {"advance": (GRID.dx, GRID.dx), "shift": (0.0, 1e-8)},
        )
    ),
    ("ContactSolver.solve", FALLING.solve,
     {"gap": GAP, "load": LOAD, "shift": (1e-8, 0.0), "duration": 1.0, "slip_rate": 1e-3}),
    (
        "rolling.steady",
        sc.rolling.steady,
        {"grid": GRID, "body1": STEEL, "body2": STEEL, "gap": GAP, "load": LOAD, "speed": 1.0,
         "friction": sc.FallingCoulomb(0.2, 0.1, 1.0), "creepage": (1e-3, 0.0)},
    ),
    *(
        (
            "rolling.steady",
            sc.rolling.steady,
            {
                "grid": GRID, "body1": STEEL, "body2": STEEL, "gap": GAP, "load": LOAD,
                "friction": sc.Coulomb(0.3), "tol": 1e-6, "on_border": "error", "on_stall": "error",
                "max_iterations": 50, **drive,
            },
        )
        for drive in (
            {"creepage": (1e-3, 1e-3), "spin": 1.0},
            {"tangential_load": (1.0, 2.0), "torque": 1e-6},
            {"approach": 1e-7, "load": None, "start": None},
        )
    ),
    (
        "ContactSolver.stress",
        SOLVER.stress,
        {"pressure": PATCH, "z": [0.0, 1e-5], "body": 2, "shear": PATCH},
    ),
    (
        "ContactSolver.stress_at",
        STICKING.stress_at,
        {"solution": STUCK, "x": [0.0, 1e-5], "y": 1e-5, "z": 2e-5, "body": 2},
    ),
    (
        "ContactSolver.displacement",
        SOLVER.displacement,
        {"pressure": PATCH, "shear": PATCH, "body": 2},
    ),
    ("ContactSolver.temperature", SOLVER.temperature, {"pressure": PATCH, "z": 1e-5, "body": 2}),
    (
        "Simulation",
        sc.Simulation,
        {
            **BODIES, "body1": HOT, "body2": HOT, "gap": GAP, **HEATED, **SETTINGS,
            "increment_tol": 1e-2, "residual_stress": "exact", "image_tol": 1e-3, "zones": "auto",
            "relief1": FLAT, "relief2": FLAT, "reach": 1e-4, "adhesion": sc.HardContact(),
            "stiffness": None,
        },
    ),
    (
        "Simulation",
        sc.Simulation,
        {"grid": GRID, "body1": HOT, "body2": HOT, "gap": GAP, **MARCHED},
    ),
    *(("Simulation.step", SIMULATION.step, {**driver, **STEP}) for driver in DRIVERS),
    (
        "Simulation.step",
        SIMULATION.step,
        {"pressure": PATCH, "shear": PATCH, "advance": (0.0, 0.0)},
    ),
    ("Simulation.step", MARCHING.step, {"load": 10.0, "duration": 1e-3}),
    *(
        ("Simulation.step", FRETTING.step, {"load": LOAD, **drive})
        for drive in (
            {"shift": (1e-8, 0.0), "twist": 1e-6, "tilt": (1e-6, 0.0)},
            {"tangential_load": (1.0, 2.0), "torque": 1e-6, "moment": (1e-6, 0.0)},
        )
    ),
    (
        "Simulation.run",
        SIMULATION.run,
        {"path": [{"load": 10.0}], "progress": False, "checkpoint": None},
    ),
    (
        "Simulation.set_plastic_strain",
        SETTABLE.set_plastic_strain,
        {
            "body": 2, "strain": STRAIN, "equivalent": STRAIN[0], "backstress": STRAIN[None],
            "first": 0,
        },
    ),
    (
        "Simulation.add_eigenstrain",
        SETTABLE.add_eigenstrain,
        {"body": 2, "strain": [1e-6] * 6, "first": (0, 0, 0), "cells": (1, 1, 1)},
    ),
    ("estimate_errors", sc.estimate_errors, PRESSED),
    ("find_load", sc.find_load, FIND),
    ("GridErrors.add_to", ERRORS.add_to, {"dataset": results.to_dataset(SIMULATION, [STATE])}),
    ("Simulation.save", SIMULATION.save, {"path": FOLDER / "other.h5"}),
    (
        "Simulation.load",
        sc.Simulation.load,
        {"path": CHECKPOINT, "softening": (None, None), "gap": lambda grid: GAP},
    ),
    *(
        (f"fatigue.{name}", getattr(sc.fatigue, name), {"states": 2 * [STATE], "body": 2, **more})
        for name, more in {
            "dang_van": {"slope": 0.3},
            "crossland": {"slope": 0.3},
            "findley": {"k": 0.3},
            "max_von_mises": {},
            "exposure": {"hardness": sc.hardness.HardnessProfile((0.0,), (390.0,))},
            "fatemi_socie": {"k": 0.3},
            "orthogonal_shear": {},
            "cycle": {},
        }.items()
    ),
    ("fatigue.steady_cycle", sc.fatigue.steady_cycle, {"state": STATE, "body": 2}),
    ("fatigue.FatigueField.over_depth", FATIGUE.over_depth, {}),
    ("fatigue.FatigueField.to_dataset", FATIGUE.to_dataset, {}),
    ("State.at_layers", STATE.at_layers, {"layers": 3}),
    ("State.track", STATE.track, {"body": 2, "margin": 1}),
    ("State.plastic_cells", STATE.plastic_cells, {}),
    *((f"State.{name}", getattr(STATE, name), {"body": 2}) for name in BODY_FIELDS),
    ("State.stress_at", STATE.stress_at, {"x": 0.0, "y": 1e-5, "z": [1e-5, 2e-5], "body": 2}),
    ("State.interface_stress", COATED_STATE.interface_stress, {"body": 2}),
    ("State.residual_displacement", STATE.residual_displacement, {"body": 2, "axis": "x"}),
    *((f"Zone.{name}", getattr(ZONE, name), {}) for name in ZONE_FIELDS),
    *((f"Track.{name}", getattr(TRACK, name), {}) for name in TRACK_FIELDS),
    ("Track.residual_displacement", TRACK.residual_displacement, {"axis": "x"}),
    ("Track.to_dataset", TRACK.to_dataset, {"volume": True}),
    (
        "Heat",
        sc.Heat,
        {
            "factor": (0.0, 0.0), "velocity": ((0.1, 0.0), (0.2, 0.1)), "time": 1.0,
            "history": None, "reference": 1.0, "partition": 0.5, "track": None,
        },
    ),
    (
        "Layered",
        sc.Layered,
        {"layers": [(STEEL, 1e-6), (SOFT, 2e-5)], "substrate": sc.Material.rigid()},
    ),
    (
        "Layered.wave_compliance",
        COATED.wave_compliance,
        {"wavenumber": [1.0, 1e5]},
    ),
    ("Layered.material_at", COATED.material_at, {"z": 1e-6}),
    ("Layered.yield_stress_at", COATED.yield_stress_at, {"z": [0.0, 1e-6]}),
    ("Layered.residual_stress_at", COATED.residual_stress_at, {"z": [0.0, 1e-6]}),
    (
        "asperities.collide",
        sc.asperities.collide,
        {
            "collision": COLLISION, "body1": sc.Material.rigid(), "body2": STEEL,
            "grid": COLLISION.grid(4), "passes": 1, "cells_per_increment": 1,
            "back_and_forth": False, "relief1": None, "relief2": None, "checkpoint": None,
            "progress": False, "tol": 1e-6, "reach": 1e-4,
        },
    ),
    (
        "energy.plastic_work",
        sc.energy.plastic_work,
        {"material": SOFT, "after": TRACK, "before": TRACK},
    ),
    ("energy.residual_energy", sc.energy.residual_energy, {"track": TRACK}),
    ("energy.eigenstrain_energy", sc.energy.eigenstrain_energy, {"track": TRACK}),
    (
        "energy.balance",
        sc.energy.balance,
        {"simulation": PULLED, "states": [PULLED.step(load=LOAD, shift=(1e-7, 0.0))]},
    ),
    (
        "measured.read",
        sc.measured.read,
        {
            "path": HEIGHTS, "format": None, "channel": None, "detrend": None, "undefined": "fill",
            "dx": 1e-5, "dy": 1e-5, "unit": None,
        },
    ),
    ("operators.shear_components", sc.operators.shear_components, {"grid": GRID, "shear": PATCH}),
    ("operators.depths_of", sc.operators.depths_of, {"z": [0.0, 1e-5]}),
    (
        "operators.depth_major",
        sc.operators.depth_major,
        {"grid": GRID, "name": "tensor", "tensor": STRAIN},
    ),
    (
        "operators.surface_displacement",
        sc.operators.surface_displacement,
        {"grid": GRID, "pressure": PATCH, "E": E, "nu": NU, "shear": PATCH, "axis": "x"},
    ),
    (
        "operators.surface_stress",
        sc.operators.surface_stress,
        {
            "grid": GRID, "pressure": PATCH, "z": [0.0, 1e-5], "nu": NU,
            "shear": np.stack([PATCH] * 2),
        },
    ),
    *(
        (
            "operators.residual_stress",
            sc.operators.residual_stress,
            {
                "grid": GRID, "strain": STRAIN, "E": E, "nu": NU, "method": method,
                "image_tol": 1e-3,
            },
        )
        for method in ("exact", "fast")
    ),
    (
        "operators.residual_displacement",
        sc.operators.residual_displacement,
        {"grid": GRID, "strain": STRAIN, "nu": NU, "axis": "y"},
    ),
    (
        "sweep",
        sc.sweep,
        {
            "case": CASE, "parameters": {"path[0].load": [10.0, 20.0]}, "executor": None,
            "output": None, "progress": False, "mode": "product",
            "find": None,
        },
    ),
    (
        "to_accuracy",
        sc.to_accuracy,
        {
            "case": CASE, "accuracy": 0.5, "quantities": ["max_pressure"], "max_memory": 1e9,
            "max_time": 1e3, "progress": False, "checkpoint": None,
        },
    ),
    ("AccuracyResult.to_dataset", ACCURATE.to_dataset, {"volume": "none"}),
]  # fmt: skip

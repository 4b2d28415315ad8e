# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of all that concerns lubricants and films, with all arguments."""

import math
import warnings

import numpy as np

import samcontact as sc

OIL = sc.Lubricant.roelands(0.04, 22e-9).with_thermal(0.14, 1.7e6, 0.04)
CONSTANTS = {"viscosity": 0.04, "pressure_viscosity": 22e-9}
PRESSURES = [0.0, 1e8, 2e8]
TAIT = {"bulk_modulus": 1.2e9, "modulus_slope": 11.7}
BALL = sc.hertz.point(0.01, 1.1e11, load=20.0)
ROLLER = sc.hertz.line(0.01, 1.1e11, load_per_length=1e5)
CASE = {"contact": BALL, "speed": (1.0, 0.8), "lubricant": OIL}
FILM = sc.lubrication.estimate(**CASE)
SQUARE = sc.Grid(16, 16, 2.5e-5, 2.5e-5)
STEEL = sc.Material.elastic(210e9, 0.3)
SOLVED = sc.lubrication.FilmSolution(
    SQUARE, OIL, np.array([[1.1, 0.0], [0.9, 0.0]]), np.zeros((16, 16)), np.full((16, 16), 1e7),
    np.zeros((16, 16)), np.full((16, 16), 1e-6), np.ones((16, 16)), 0.0, 1.6, 0.0, (),
)  # fmt: skip

BOUNDARY = sc.lubrication.Boundary(2e-9)
INLET_GRID = sc.Grid(30, 30, 4e-5, 4e-5)
DEEP_GRID = sc.Grid(30, 30, 4e-5, 4e-5, dz=4e-5)
GAP = sc.surfaces.paraboloid(INLET_GRID, 0.01)
with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # of the small grid
    FLOWING = sc.lubrication.steady(
        INLET_GRID, STEEL, STEEL, GAP, load=40.0, speed=(1.0, 1.0), lubricant=OIL
    )
    RUBBING = sc.lubrication.steady(
        INLET_GRID, STEEL, STEEL, GAP, load=40.0, speed=(1e-3, 0.0), lubricant=OIL, order=1,
        boundary=BOUNDARY,
    )  # fmt: skip
    IN_TIME = sc.lubrication.transient(FLOWING, duration=1e-5, steps=2)
ON_GRID = {"grid": INLET_GRID, "body1": STEEL, "body2": STEEL, "gap": GAP, "lubricant": OIL}
HOW = {"order": 1, "tol": 1e-4, "max_iterations": 30}
WARM_STEEL = STEEL.with_thermal(46.0, 12e-6, 12.5e-6)
HEATED = {
    "grid": sc.Grid(40, 1, 1e-5, 1e-3, periodic="y"), "body1": WARM_STEEL, "body2": WARM_STEEL,
    "gap": lambda on: sc.surfaces.paraboloid(on, 0.01, math.inf), "load": 40.0,
    "speed": (1.0, 0.8), "lubricant": OIL.with_eyring(5e6), "shear_thinning": True,
    "thermal": True, "accuracy": {"central_film": 0.1}, "tol": 1e-4,
}  # fmt: skip

CALLS = [
    ("Lubricant", sc.Lubricant,
     {"eta0": 0.04, "law": OIL.law, "density_law": OIL.density_law, "thinning": OIL.thinning,
      "limiting_coefficient": 0.05, "heat": OIL.heat}),
    ("Lubricant.roelands", sc.Lubricant.roelands, {**CONSTANTS, "z": 0.6, "density": None}),
    ("Lubricant.barus", sc.Lubricant.barus, {**CONSTANTS, "density": "dowson-higginson"}),
    ("Lubricant.doolittle", sc.Lubricant.doolittle,
     {"viscosity": 0.016, "B": 4.7, "R0": 0.65, **TAIT}),
    ("Lubricant.tabulated", sc.Lubricant.tabulated,
     {"p": PRESSURES, "eta": [0.04, 0.3, 2.0], "rho": [900.0, 940.0, 970.0]}),
    ("Lubricant.with_eyring", OIL.with_eyring, {"stress": 5e6}),
    ("Lubricant.with_carreau", OIL.with_carreau, {"stress": 5e6, "n": 0.4}),
    ("Lubricant.with_limiting_shear", OIL.with_limiting_shear, {"coefficient": 0.05}),
    ("Lubricant.with_thermal", OIL.with_thermal,
     {"conductivity": 0.14, "capacity": 1.7e6, "beta": 0.04, "temperature": 320.0}),
    ("Lubricant.viscosity", OIL.viscosity, {"p": PRESSURES, "T": [300.0, 310.0, 320.0]}),
    ("Lubricant.density", OIL.density, {"p": PRESSURES}),
    ("Lubricant.shear_stress", OIL.shear_stress,
     {"rate": [1e5, -1e6, 0.0], "p": PRESSURES, "T": [300.0, 310.0, 320.0]}),
    ("Lubricant.tables", OIL.tables, {"max_pressure": 1e9}),
    ("lubricants.LubricantHeat", sc.lubricants.LubricantHeat,
     {"conductivity": 0.14, "capacity": 1.7e6, "beta": 0.04, "temperature": 320.0}),
    ("lubricants.DowsonHigginson", sc.lubricants.DowsonHigginson, {"a": 6e-10, "b": 1.7e-9}),
    ("lubricants.Tait", sc.lubricants.Tait, TAIT),
    *(
        (f"lubricants.{type(law).__name__}.{method}", getattr(law, method), {"p": PRESSURES})
        for law in (
            sc.lubricants.DowsonHigginson(), sc.lubricants.Incompressible(),
            sc.lubricants.Tait(**TAIT),
        )
        for method in ("ratio", "slope")
    ),
    ("lubricants.iso_vg", sc.lubricants.iso_vg, {"grade": "ISO VG 68"}),
    ("lubricants.oil", sc.lubricants.oil, {"nu40": 68e-6, "nu100": 8.5e-6, "density": 880.0}),
    ("lubricants.Oil", sc.lubricants.Oil,
     {"name": "a", "nu40": 68e-6, "nu100": 8.5e-6, "density": 880.0, "source": "b"}),
    *(
        (f"lubricants.Oil.{name}", getattr(sc.lubricants.iso_vg(68), name), {"T": 320.0})
        for name in ("beta", "kinematic_viscosity", "lubricant", "pressure_viscosity", "viscosity")
    ),
    *(
        (f"lubrication.{name}", getattr(sc.lubrication, name), CASE)
        for name in ("estimate", "moes", "nijenbanning", "regime", "rigid_isoviscous")
    ),
    ("lubrication.hamrock_dowson", sc.lubrication.hamrock_dowson,
     {**CASE, "contact": sc.hertz.point(0.01, 5e6, load=1.0), "material": "soft"}),
    ("lubrication.dowson_higginson", sc.lubrication.dowson_higginson, {**CASE, "contact": ROLLER}),
    ("lubrication.inlet_heating_factor", sc.lubrication.inlet_heating_factor,
     {"speed": (1.0, 0.8), "lubricant": OIL}),
    ("lubrication.lambda_ratio", sc.lubrication.lambda_ratio,
     {"film": 1e-6, "roughness1": 1e-7, "roughness2": 2e-7}),
    ("lubrication.FilmEstimate.lambda_ratio", FILM.lambda_ratio,
     {"roughness1": 1e-7, "roughness2": 2e-7}),
    ("lubrication.friction", sc.lubrication.friction, {"film": SOLVED}),
    ("lubrication.traction_curve", sc.lubrication.traction_curve,
     {"film": SOLVED, "slide_to_roll": [0.0, 0.1], "tol": 1e-4, "max_iterations": 20}),
    ("lubricants.DensityLaw", sc.lubricants.Incompressible, {}),
    ("lubricants.DensityLaw.ratio", sc.lubricants.Tait(**TAIT).ratio, {"p": PRESSURES}),
    ("lubricants.DensityLaw.slope", sc.lubricants.Tait(**TAIT).slope, {"p": PRESSURES}),
    ("lubricants.Incompressible", sc.lubricants.Incompressible, {}),
    ("lubrication.Boundary", sc.lubrication.Boundary,
     {"thickness": 2e-9, "friction": 0.1, "pressure": 1e9}),
    ("lubrication.steady", sc.lubrication.steady,
     {**ON_GRID, **HOW, "load": 40.0, "speed": (1.0, 1.0), "spin": 100.0, "supply": 1e-6,
      "boundary": BOUNDARY}),
    ("lubrication.steady", sc.lubrication.steady,
     {**ON_GRID, **HOW, "approach": FLOWING.approach, "speed": (1.0, 1.0)}),
    ("lubrication.steady", sc.lubrication.steady, HEATED),
    ("lubrication.stribeck", sc.lubrication.stribeck,
     {**ON_GRID, **HOW, "load": 40.0, "speeds": [1e-3, 3e-3], "slide_to_roll": 0.1,
      "boundary": BOUNDARY, "lubricant": OIL.with_eyring(5e6), "shear_thinning": True,
      "thermal": True, "body1": WARM_STEEL, "body2": WARM_STEEL}),
    ("lubrication.transient", sc.lubrication.transient,
     {**HOW, "start": FLOWING, "duration": 1e-5, "steps": 1, "relief1": lambda x, y: 1e-8 + 0 * x,
      "relief2": lambda x, y: 0 * y, "load": lambda t: 40.0, "speed": lambda t: (1.0, 1.0),
      "checkpoint": None, "progress": False}),
    ("lubrication.press", sc.lubrication.press,
     {**HOW, "simulation": sc.Simulation(INLET_GRID, STEEL, STEEL, GAP), "load": 40.0,
      "speed": (1.0, 1.0), "lubricant": OIL, "boundary": BOUNDARY, "shear_thinning": False,
      "thermal": False}),
    ("lubrication.pass_stress", sc.lubrication.pass_stress,
     {"films": IN_TIME.solutions, "z": [1e-5, 2e-5], "body": 2}),
    ("lubrication.running_in", sc.lubrication.running_in,
     {"film": RUBBING, "archard": 1e-15, "duration": 0.1, "steps": 1, "worn": 2, "tol": 1e-4,
      "max_iterations": 30, "progress": False}),
    ("lubrication.press_loads", sc.lubrication.press_loads,
     {**HOW, "simulation": sc.Simulation(DEEP_GRID, STEEL, STEEL, GAP), "loads": [30.0, 40.0],
      "speed": (1.0, 1.0), "lubricant": OIL, "boundary": BOUNDARY, "checkpoint": None,
      "progress": False, "shear_thinning": False, "thermal": False}),
    ("lubrication.bearing_speeds", sc.lubrication.bearing_speeds,
     {"bearing": sc.bearings.standard("6208"), "inner": 314.0, "outer": 10.0}),
]  # fmt: skip
CALLS += [
    (f"lubricants.{name}", call, arguments) for name, call, arguments in CALLS
    if name.startswith("Lubricant")
]  # fmt: skip

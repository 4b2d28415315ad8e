# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every public function of parts and of passes over dents."""

import math

import numpy as np
from calls_of_formulas import E_STAR

import samcontact as sc

GRID = sc.Grid(7, 5, 1e-5, 2e-5)
GEAR = {
    "module": 4.5e-3, "teeth": [16, 24], "face_width": 14e-3, "pressure_angle": 0.349,
    "profile_shift": [0.18, 0.17], "centre_distance": 91.5e-3, "tip_diameter": [82.5e-3, 118.4e-3],
    "crowning": 1e-5, "tip_relief": [2e-5, 3e-5], "relief_length": [5e-3, 6e-3],
    "relief_exponent": 1.5,
}  # fmt: skip
FLANK = sc.parts.GearPair(**GEAR).at("D")
ANGLES = np.linspace(-1.0, 1.0, 21)
LIFTS = 2e-3 * (1.0 + np.cos(math.pi * ANGLES))
CAM = sc.parts.Cam.harmonic(3e-2, 4e-3, 2.5)
TAPPET = CAM.at(0.3)
Y = np.linspace(-0.03, 0.03, 31)
PROFILES = {
    "rail": np.column_stack([Y, Y**2 / 0.6]), "wheel": np.column_stack([Y, -(Y**2)]),
    "wheel_radius": 0.46, "shift": 1e-3, "yaw": 1e-2, "roll": 1e-3, "smoothing": 1e-6,
}  # fmt: skip
PYRAMID = {"grid": GRID, "tip_radius": 1e-6, "angle": 0.1, "half_angle": 1.2}

STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
CELLS = sc.Grid(12, 10, 1e-6, 1e-6, dz=1e-6)
PARTICLE = sc.overrolling.Particle(1e-4, approach=1.2e-7)
INDENT = {
    "grid": CELLS, "body2": STEEL, "particles": [PARTICLE], "increments": 1,
    "body1": sc.Material.elastic(210e9, 0.3), "progress": False,
}  # fmt: skip
ROLL = {
    "grid": CELLS, "body1": sc.Material.elastic(210e9, 0.3), "body2": STEEL,
    "gap": sc.surfaces.paraboloid(CELLS, 1e-4), "load": 5e-4, "distance": 2e-6, "step": 2e-6,
    "middle": 1e-6, "slide_to_roll": 0.0, "increments": 1, "progress": False,
}  # fmt: skip
ROLL["dented"] = sc.overrolling.indent(**INDENT)
PASS = sc.overrolling.roll_over(**ROLL)

CALLS = [
    ("parts.flat_punch", sc.parts.flat_punch, {"grid": GRID, "radius": 3e-5, "edge_radius": 1e-5}),
    ("parts.cone", sc.parts.cone, {"grid": GRID, "half_angle": 1.2, "tip_radius": 1e-6}),
    ("parts.berkovich", sc.parts.berkovich, PYRAMID),
    ("parts.vickers", sc.parts.vickers, PYRAMID),
    ("parts.GearPair", sc.parts.GearPair, GEAR),
    ("parts.GearPair.at", FLANK.pair.at, {"position": -1e-3}),
    ("parts.GearPair.surface", FLANK.pair.surface, {"grid": GRID, "position": "B"}),
    ("parts.FlankContact.speeds", FLANK.speeds, {"speed": 100.0}),
    ("parts.FlankContact.load_share", FLANK.load_share, {"sharing": "linear"}),
    ("parts.FlankContact.load", FLANK.load, {"torque": 10.0, "sharing": "linear"}),
    (
        "parts.FlankContact.hertz",
        FLANK.hertz,
        {"torque": 10.0, "E_star": E_STAR, "sharing": "equal"},
    ),
    ("parts.FlankContact.surface", FLANK.surface, {"grid": GRID}),
    ("parts.Cam.eccentric", sc.parts.Cam.eccentric, {"radius": 2e-2, "eccentricity": 5e-3}),
    (
        "parts.Cam.harmonic",
        sc.parts.Cam.harmonic,
        {"base_radius": 3e-2, "max_lift": 4e-3, "duration": 2.5},
    ),
    (
        "parts.Cam.table",
        sc.parts.Cam.table,
        {"base_radius": 6e-2, "angle": ANGLES, "lift": LIFTS},
    ),
    ("parts.Cam.at", CAM.at, {"angle": 0.3}),
    ("parts.TappetContact.speeds", TAPPET.speeds, {"speed": 100.0}),
    ("parts.TappetContact.entraining_speed", TAPPET.entraining_speed, {"speed": 100.0}),
    ("parts.TappetContact.hertz", TAPPET.hertz, {"load": 10.0, "width": 1e-2, "E_star": E_STAR}),
    ("parts.TappetContact.surface", TAPPET.surface, {"grid": GRID, "crown_radius": 1.0}),
    ("parts.WheelRail", sc.parts.WheelRail, PROFILES),
    ("parts.WheelRail.surface", sc.parts.WheelRail(**PROFILES).surface, {"grid": GRID}),
    (
        "overrolling.Particle",
        sc.overrolling.Particle,
        {"radius": 1e-4, "load": 1.0, "approach": None, "x": 1e-5, "y": 2e-5},
    ),
    ("overrolling.Particle", sc.overrolling.Particle, {"radius": 1e-4, "approach": 1e-6}),
    ("overrolling.Particle.gap", PARTICLE.gap, {"grid": GRID}),
    ("overrolling.Particle.path", PARTICLE.path, {"increments": 3}),
    (
        "overrolling.particles",
        sc.overrolling.particles,
        {
            "length": 1e-3, "width": 1e-3, "density": 1e7, "radius": 1e-5, "spread": 0.2,
            "depth_ratio": 0.1, "seed": 1,
        },
    ),
    ("overrolling.indent", sc.overrolling.indent, INDENT),
    ("overrolling.roll_over", sc.overrolling.roll_over, ROLL),
    ("overrolling.Overrolling.dang_van", PASS.dang_van, {"slope": 0.3}),
]  # fmt: skip

# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of all that concerns adhesion, with all arguments."""

import numpy as np

import samcontact as sc

GRID = sc.Grid(12, 12, 5e-8, 5e-8)
TIP, SOFT = sc.Material.rigid(), sc.Material.elastic(1e9, 0.3)
LAW = sc.Adhesion.jkr(0.1)
ON = {"friction_on": "repulsion"}
TABLE = {"gap": [0.0, 1e-9], "stress": [1e7, 0.0], **ON}
JKR = sc.adhesion.jkr(1e-6, 0.1, 1e9)
MAUGIS = sc.adhesion.maugis(1e-6, 0.1, 1e9, 1e7)
WAVE = sc.adhesion.wave(1e-6, 1e-8, 0.1, 1e9)
SPHERE = {"R": 1e-6, "w": 0.1, "E_star": 1e9}
RADII = np.array([5e-8, 1e-7])


def slope(r):
    return r / 1e-6


def touching():
    """Return the simulation of a small tip that adheres to a viscoelastic body."""
    gap = sc.surfaces.paraboloid(GRID, 1e-6)
    rubber = SOFT.with_relaxation([1.0], [0.4])
    simulation = sc.Simulation(GRID, TIP, rubber, gap, adhesion=LAW)
    simulation.step(approach=0.0, duration=0.0)
    return simulation


TIP_IN_CONTACT = touching()


def retracted(simulation, step, until, max_steps, speed):
    """Retract a tip, whose simulation is new in each call."""
    one = touching() if simulation is TIP_IN_CONTACT else simulation
    return sc.paths.pull_off(one, step=step, until=until, max_steps=max_steps, speed=speed)


CALLS = [
    ("Adhesion.exponential", sc.Adhesion.exponential, {"w": 0.1, "range": 1e-9, **ON}),
    ("Adhesion.jkr", sc.Adhesion.jkr, {"w": 0.1, **ON}),
    ("Adhesion.dugdale", sc.Adhesion.dugdale, {"w": 0.1, "stress": 1e7, **ON}),
    ("Adhesion.lennard_jones", sc.Adhesion.lennard_jones, {"w": 0.1, "z0": 1e-9, **ON}),
    ("Adhesion.tabulated", sc.Adhesion.tabulated, TABLE),
    ("Adhesion.on", LAW.on, {"grid": GRID, "body1": TIP, "body2": SOFT}),
    ("Adhesion.resolved", LAW.resolved, {"grid": GRID, "body1": TIP, "body2": SOFT}),
    ("Adhesion.require_possible", LAW.require_possible,
     {"heat": sc.Heat(), "given": {}, "sticks": False}),
    ("Adhesion.may_move", LAW.may_move, {"sticks": False}),
    ("Adhesion.to_core", sc.Adhesion.exponential(0.1, 1e-9).to_core, {}),
    ("Adhesion.to_tree", LAW.to_tree, {}),
    *(
        (f"{name}.resolved", law.resolved, {"grid": GRID, "body1": TIP, "body2": SOFT})
        for name, law in (("HardContact", sc.HardContact()), ("TensileLimit", sc.TensileLimit(1e6)))
    ),
    ("adhesion.tabor", sc.adhesion.tabor, {**SPHERE, "range": 1e-9}),
    ("adhesion.dmt", sc.adhesion.dmt, {"R": 1e-6, "w": 0.1}),
    ("adhesion.jkr", sc.adhesion.jkr, SPHERE),
    ("adhesion.Jkr.load", JKR.load, {"radius": RADII}),
    ("adhesion.Jkr.approach", JKR.approach, {"radius": RADII}),
    ("adhesion.Jkr.radius", JKR.radius, {"load": np.array([0.0, 1e-6])}),
    ("adhesion.maugis", sc.adhesion.maugis, {**SPHERE, "stress": 1e7}),
    ("adhesion.Maugis.load", MAUGIS.load, {"radius": RADII}),
    ("adhesion.Maugis.approach", MAUGIS.approach, {"radius": RADII}),
    ("adhesion.Maugis.outer_radius", MAUGIS.outer_radius, {"radius": RADII}),
    ("adhesion.jkr_profile", sc.adhesion.jkr_profile,
     {"slope": slope, "radius": RADII, "w": 0.1, "E_star": 1e9}),
    ("adhesion.wave", sc.adhesion.wave,
     {"length": 1e-6, "amplitude": 1e-8, "w": 0.1, "E_star": 1e9}),
    ("adhesion.WaveContact.mean_pressure", WAVE.mean_pressure, {"half_width": RADII}),
    ("paths.pull_off", retracted,
     {"simulation": TIP_IN_CONTACT, "step": 2e-8, "until": "apart", "max_steps": 60,
      "speed": 1e-8}),
    ("paths.Retraction", sc.paths.Retraction,
     {"step": 2e-8, "until": "apart", "max_steps": 60, "speed": 1e-8}),
]  # fmt: skip

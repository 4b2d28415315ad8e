# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of adhesion, creep and inclusions, in any system of units."""

import samcontact as sc

from .scaled_setups import TIGHT_SETTINGS


def adhering(unit):
    """Press a viscoelastic body that is attracted, with partial slip and a soft machine."""
    grid = sc.Grid(14, 14, 1e-8 * unit.m, 1e-8 * unit.m, dz=1e-8 * unit.m)
    body = unit.elastic(1e9).with_relaxation([1.0 * unit.s], [0.4])
    law = sc.Adhesion.exponential(0.05 * unit.J / unit.m**2, range=3e-9 * unit.m)
    gap = sc.surfaces.paraboloid(grid, 2e-7 * unit.m)
    sim = sc.Simulation(
        grid, sc.Material.rigid(), body, gap, sc.Coulomb(0.3), adhesion=law,
        stiffness=10.0 * unit.N / unit.m, **TIGHT_SETTINGS,
    )  # fmt: skip
    for approach in (0.0, 2e-9, 1e-9):
        at = approach * unit.m
        state = sim.step(approach=at, shift=(0.2 * at, 0.0), duration=0.3 * unit.s)
    found = unit.stated(state) | {"shift": state.shift / unit.m, "load": state.load / unit.N}
    return found | {"attraction": state.adhesion_stress / unit.Pa}


def creeping(unit):
    """Load, hold and unload two viscoelastic bodies with partial slip."""
    grid = unit.grid(dz=45e-6 * unit.m)
    rubber = unit.elastic(10e6, 0.45).with_relaxation([0.1 * unit.s, 2.0 * unit.s], [0.3, 0.4])
    sim = sc.Simulation(
        grid, rubber, unit.elastic(30e6, 0.4), unit.ball(grid), sc.Coulomb(0.3), **TIGHT_SETTINGS
    )
    for load, pull in ((0.01, 0.0), (0.02, 0.2), (0.01, 0.1)):
        force = (0.3 * pull * load * unit.N, 0.0)
        state = sim.step(load=load * unit.N, tangential_load=force, duration=0.2 * unit.s)
    found = unit.stated(state, (1, 2)) | unit.slipped(state)
    del found["torque"]  # zero by symmetry
    return found | {"viscous work": state.viscous_work(1) / unit.J}


def included(unit):
    """Load and unload steel with a stiff inclusion that has a misfit, and a pore."""
    grid = unit.grid(16, dz=45e-6 * unit.m)
    radius, depth = 100e-6 * unit.m, 200e-6 * unit.m
    hard = unit.elastic(400e9, 0.25)
    oxide = sc.Inclusion.sphere((-100e-6 * unit.m, 0.0, depth), radius, hard, misfit=1e-3)
    pore = sc.Inclusion.void.sphere((150e-6 * unit.m, 0.0, depth), radius)
    body = sc.Heterogeneous(unit.soft(), [oxide, pore])
    sim = sc.Simulation(grid, unit.elastic(), body, unit.ball(grid), tol=1e-4, on_border="warn")
    sim.step(load=500 * unit.N)
    return unit.stated(sim.step(load=100 * unit.N))


CASES = {"adhesion with creep and slip": adhering, "creep": creeping}

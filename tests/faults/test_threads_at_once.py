# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations, contacts and files in parallel threads give the digits of separate runs."""

import hashlib
from concurrent.futures import ThreadPoolExecutor

from faulting import tried

import samcontact as sc

ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
GRID = sc.Grid(15, 15, 80e-6, 80e-6, 10, 80e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)


def solve(folder, number):
    """Solve one problem in three kinds of runs, whose files are read and written meanwhile."""
    load = 700.0 + 50.0 * number
    sim = sc.Simulation(GRID, ELASTIC, STEEL, GAP, residual_stress=("fast", "exact")[number % 2])
    sim.step(load=load)
    sim.save(folder / f"{number}.h5")
    state = sc.Simulation.load(folder / f"{number}.h5").step(load=1.2 * load)
    flat = sc.ContactSolver(GRID, ELASTIC, STEEL, 0.1).solve(GAP, load=load)
    parts = (state.pressure, state.stress(), state.plastic_strain(), flat.pressure)
    return hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest()


@tried("threads")
def test_same_digits(tmp_path, count):
    alone = [solve(tmp_path, number) for number in range(2 * count)]
    with ThreadPoolExecutor(2) as pool:
        together = list(pool.map(lambda number: solve(tmp_path, number), range(2 * count)))
    assert together == alone
    assert len(set(alone)) == 2 * count

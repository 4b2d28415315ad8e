# SPDX-License-Identifier: GPL-3.0-or-later
"""Results are independent of the number of OpenMP threads and of other Python threads."""

import threading

import numpy as np
import pytest

import samcontact as sc
from openmp import outputs_with

CONTACT = """
import hashlib, samcontact as sc
steel, ceramic = sc.Material.elastic(210e9, 0.3), sc.Material.elastic(310e9, 0.29)
grid = sc.Grid(120, 90, 1e-6, 1.2e-6)
gap = sc.surfaces.paraboloid(grid, 5e-3) + sc.surfaces.sinusoidal(grid, 2e-8, 9e-6, 8e-6)
solution = sc.ContactSolver(grid, ceramic, steel, 0.3, tol=1e-10).solve(gap, load=1.0)
print(solution.iterations, hashlib.sha256(solution.pressure.tobytes()).hexdigest())
"""
ROUGH = """
import hashlib, warnings, samcontact as sc
warnings.simplefilter("ignore", sc.GridTooSmallWarning)
grid = sc.Grid(160, 145, 1e-6, 1e-6)
gap = sc.surfaces.rough_self_affine(grid, 1e-8, 0.8, wavelength_min=4e-6, roll_off=4e-5, seed=1)
rigid, steel = sc.Material.rigid(), sc.Material.elastic(210e9, 0.3)
solution = sc.ContactSolver(grid, rigid, steel, on_border="warn").solve(gap, load=0.5)
print(solution.iterations, hashlib.sha256(solution.pressure.tobytes()).hexdigest())
"""
SIMULATION = """
import hashlib, samcontact as sc
soft = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9)
grid = sc.Grid(33, 31, 1.5e-5, 1.6e-5, 20, 1.5e-5)
gap = sc.surfaces.paraboloid(grid, 7.5e-3) + 1e-4 * grid.x[:, None]
sim = sc.Simulation(grid, sc.Material.elastic(300e9, 0.2), soft, gap, friction=0.1)
state = sim.run([{"load": 100.0}, {"load": 200.0}], progress=False)[-1]
digest = hashlib.sha256(state.pressure.tobytes() + state.stress().tobytes())
print(state.iterations, digest.hexdigest())
"""

FAST = """
import hashlib, samcontact as sc
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
perfect = sc.Material.perfect_plastic(210e9, 0.3, 1.3e9)
grid = sc.Grid(31, 31, 4.3e-5, 4.3e-5, 18, 4.3e-5)
gap = sc.surfaces.paraboloid(grid, 7.5e-3) + {tilt} * grid.x[:, None] * grid.y
sim = sc.Simulation(grid, steel, perfect, gap, residual_stress="fast")
state = sim.run([{{"load": 1000.0}}], progress=False)[0]
parts = (state.pressure, state.stress(1), state.stress(2), state.plastic_strain(2))
digest = hashlib.sha256(b"".join(part.tobytes() for part in parts))
print(state.iterations, digest.hexdigest())
"""
DISPLACEMENT = """
import hashlib, numpy as np, samcontact as sc
steel = sc.Material.elastic(210e9, 0.3)
solver = sc.ContactSolver(sc.Grid(40, 60, 1e-6, 1e-6), steel, steel)
pressure = np.random.default_rng(0).random((40, 60))
print(hashlib.sha256(np.asarray(solver.displacement(pressure)).tobytes()).hexdigest())
"""
SCRIPTS = {
    "contact": CONTACT,
    "rough": ROUGH,
    "simulation": SIMULATION,
    "mirrored": FAST.format(tilt="0.0"),
    "whole": FAST.format(tilt="0.1"),
}


@pytest.fixture(scope="module")
def answers():
    """Return the answers to each script of one process per number of threads."""
    outputs = outputs_with("".join(SCRIPTS.values()), 1, 2)
    lines = (text.splitlines() for text in outputs)
    return dict(zip(SCRIPTS, zip(*lines, strict=True), strict=True))


def test_two_simulations_at_once_give_the_digits_of_each_alone():
    grid = sc.Grid(21, 21, 60e-6, 60e-6, 14, 60e-6)
    elastic = sc.Material.elastic(210e9, 0.3)
    steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)

    def solve(load, into):
        simulation = sc.Simulation(grid, elastic, steel, gap)
        for k in range(1, 4):
            state = simulation.step(load=load * k / 3)
        into[load] = (state.pressure.copy(), state.equivalent_plastic_strain())

    loads = (900.0, 1400.0)
    alone, together = {}, {}
    for load in loads:
        solve(load, alone)
    threads = [threading.Thread(target=solve, args=(load, together)) for load in loads]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for load in loads:
        for one, other in zip(alone[load], together[load], strict=True):
            assert np.array_equal(one, other)


@pytest.mark.parametrize("name", SCRIPTS)
def test_same_digits_for_any_number_of_openmp_threads(name, answers):
    one, two = answers[name]
    assert one == two
    iterations, digest = one.split()
    assert int(iterations) > 0
    assert len(digest) == 64


def test_a_thread_for_the_last_column_of_coefficients_changes_no_digit():
    """The last of the 41 columns of the spectrum has a thread of its own if there are four."""
    one, four = outputs_with(DISPLACEMENT, 1, 4)
    assert len(one.strip()) == 64
    assert four == one

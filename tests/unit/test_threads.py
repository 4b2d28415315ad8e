# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations in several Python threads do not disturb each other."""

import threading

import numpy as np

import samcontact as sc


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

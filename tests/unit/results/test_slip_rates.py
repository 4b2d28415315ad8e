# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip rate and falling number in results and report."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact import results
from samcontact.report.tables import convergence_table

STEEL = sc.Material.elastic(210e9, 0.3)
GRID = sc.Grid(20, 18, 50e-6, 50e-6)
BALL = sc.surfaces.paraboloid(GRID, 7.5e-3)
DURATION = 1e-4


def dataset(law):
    simulation = sc.Simulation(GRID, STEEL, STEEL, BALL, law)
    timed = {"duration": DURATION} if law.needs_duration else {}
    states = [
        simulation.step(load=300.0, shift=(shift, 0.0), **timed) for shift in (1e-6, 4e-6, 2e-6)
    ]
    return results.to_dataset(simulation, states)


def test_slip_rate_and_falling_number_are_those_of_their_definition():
    law = sc.FallingCoulomb(kinetic=0.1, drop=0.2, half_speed=0.05)
    data = dataset(law)
    slip = np.hypot(data["slip_x"].values, data["slip_y"].values)
    rate = data["slip_rate"].values
    np.testing.assert_allclose(rate, slip / DURATION, atol=2e-3 * rate.max())
    one_cell = np.zeros((2, *GRID.surface_shape))
    one_cell[0, 10, 9] = 1.0
    solver = sc.ContactSolver(GRID, STEEL, STEEL)
    pressure = np.zeros(GRID.surface_shape)
    both = [solver.displacement(pressure, one_cell, body)[0, 10, 9] for body in (1, 2)]
    own = abs(both[1] - both[0])
    slope = 0.2 * math.log(2) / 0.05 * 2 ** (-rate / 0.05)
    expected = (slope * data["pressure"].values).max(axis=(1, 2)) * own / DURATION
    assert (expected > 0.01).all()
    np.testing.assert_allclose(data["falling_number"], expected, rtol=1e-2)
    assert "falling number" in str(convergence_table(data))


@pytest.mark.parametrize("name", ["slip_rate", "falling_number"])
def test_other_laws_have_no_slip_rate(name):
    assert name not in dataset(sc.Coulomb(0.3))

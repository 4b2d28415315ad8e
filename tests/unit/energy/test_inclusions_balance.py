# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy balance of bodies with inclusions."""

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
GRID = sc.Grid(25, 25, 25e-6, 25e-6, dz=25e-6)
PLACE = (0.0, 5e-5, 2e-4), 1e-4


@pytest.mark.parametrize(
    "inclusion",
    [
        sc.Inclusion.sphere(*PLACE, sc.Material.elastic(600e9, 0.2)),
        sc.Inclusion.sphere(*PLACE, sc.Material.elastic(70e9, 0.33), misfit=1e-3),
        sc.Inclusion.void(*PLACE),
    ],
)
def test_the_work_of_the_load_is_elastic_energy(inclusion):
    """Both the mismatch and the misfit count: without them the error is ten times as large."""
    body = sc.Heterogeneous(STEEL, [inclusion])
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    sim = sc.Simulation(GRID, sc.Material.rigid(), body, gap, on_border="warn", tol=1e-4)
    states = [sim.step(load=load) for load in np.linspace(2.0, 60.0, 10)]
    balance = sc.energy.balance(sim, states)
    assert abs(balance.imbalance) < 1.5e-3


def test_refused():
    yielding = sc.Material.perfect_plastic(210e9, 0.3, 1e9)
    body = sc.Heterogeneous(yielding, [sc.Inclusion.void(*PLACE)])
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    sim = sc.Simulation(GRID, sc.Material.rigid(), body, gap, on_border="warn", tol=1e-3)
    states = [sim.step(load=1.0), sim.step(load=2.0)]
    with pytest.raises(ValueError, match="body2 must be elastic if it has inclusions"):
        sc.energy.balance(sim, states)

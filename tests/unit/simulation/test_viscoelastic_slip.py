# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip of viscoelastic bodies."""

import numpy as np
import pytest
from viscoelastic_setups import LOAD, SLS, SOFT, E, scaled, simulation

import samcontact as sc

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.ResolutionWarning", "ignore::samcontact.IncrementWarning",
    "ignore::samcontact.UnitWarning", "ignore::samcontact.ElasticStrainWarning",
)  # fmt: skip


def test_slow_partial_slip_is_elastic_with_long_time_moduli():
    """Dissimilar bodies of different relaxation, which couple pressure and shear."""
    bodies = SLS, sc.Material.elastic(2 * E, 0.2).with_relaxation([5.0], [0.5])
    others = scaled(SOFT, 0.1), sc.Material.elastic(E, 0.2)
    path = [{"load": 0.05 * LOAD}, {"load": 0.05 * LOAD, "shift": (2e-7, 0.0)}]
    path += [{"load": 0.06 * LOAD, "shift": (-1e-7, 1e-7)}]
    found, elastic = (simulation(b, a, friction=sc.Coulomb(0.3)) for a, b in (bodies, others))
    for step in path:
        one, two = found.step(**step, duration=1e12), elastic.step(**step)
    peak = two.pressure.max()
    np.testing.assert_allclose(one.pressure, two.pressure, atol=1e-6 * peak)
    np.testing.assert_allclose(one.shear, two.shear, atol=1e-6 * peak)
    assert one.friction_work == pytest.approx(two.friction_work, rel=1e-5)


def test_a_sticking_contact_creeps_tangentially():
    """Relaxed under the normal load, the shift grows as the creep function."""
    body = SOFT.with_relaxation([1.0], [0.7])
    sim = simulation(body, body, friction=sc.Coulomb(0.3))
    sim.step(load=0.1 * LOAD, duration=0.0)
    sim.relax()
    drive = {"load": 0.1 * LOAD, "tangential_load": (1e-3 * LOAD, 0.0)}
    shifts = [sim.step(**drive, duration=0.0).shift[0]]
    shifts += [sim.step(**drive, duration=0.25).shift[0] for _ in range(16)]
    expected = body.creep(0.25 * np.arange(17))
    np.testing.assert_allclose(np.array(shifts) / shifts[0], expected, rtol=6e-4)


def test_the_energy_balance_of_partial_slip():
    other = sc.Material.elastic(2 * E, 0.2).with_relaxation([5.0], [0.5])
    sim = simulation(SLS, other, friction=sc.Coulomb(0.3))
    parts = np.arange(1, 13) / 12
    path = [{"load": 0.1 * LOAD * x, "tangential_load": (0.02 * LOAD * x, 0.0)} for x in parts]
    path += [
        {"load": 0.1 * LOAD, "tangential_load": (0.02 * LOAD * (1 - 2 * x), 0.0)} for x in parts
    ]
    states = sim.run([step | {"duration": 0.2} for step in path], progress=False)
    balance = sc.energy.balance(sim, states)
    assert balance.friction_work > 0
    assert balance.viscous_work > 0.1 * balance.work_input
    assert abs(balance.imbalance) < 1e-3

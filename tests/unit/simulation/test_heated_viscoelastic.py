# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictional heat of contacts with viscoelastic bodies: limits, expansion, energy, refusals."""

import numpy as np
import pytest
from viscoelastic_setups import GRID, LOAD, SOFT, E, scaled, simulation

import samcontact as sc

METAL = sc.Material.elastic(3 * E, 0.3).with_thermal(0.3, 3e-3, 2e-7)
RUBBER = SOFT.with_thermal(0.2, 5e-3, 1e-7)
TERMS = {"times": [1.0, 10.0], "shares": [0.3, 0.4]}
CREEPS = RUBBER.with_relaxation(**TERMS)
RELAXED = scaled(SOFT, 0.3).with_thermal(*RUBBER.thermal)
pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.ResolutionWarning", "ignore::samcontact.IncrementWarning",
    "ignore::samcontact.UnitWarning", "ignore::samcontact.ElasticStrainWarning",
)  # fmt: skip


def equal(one, other, rel=1e-6):
    for name in ("pressure", "shear", "gap"):
        found, expected = getattr(one, name), getattr(other, name)
        np.testing.assert_allclose(found, expected, atol=rel * max(1e-30, np.abs(expected).max()))
    np.testing.assert_allclose(one.surface_temperature(1), other.surface_temperature(1), rtol=rel)


@pytest.mark.parametrize("terms", [TERMS, {"times": [1e12], "shares": [0.5]}])
def test_slow_and_fast_contacts_with_a_history_of_heat_are_elastic(terms):
    """The heat enters the elastic body, whose history goes on in the same increments."""
    heat = sc.Heat((2e-6, 0.0), history=(0.5, 1e6))
    long, duration = (RELAXED, 1e4) if terms is TERMS else (RUBBER, 2.0)
    body = RUBBER.with_relaxation(**terms)
    path = [{"load": part * LOAD, "duration": duration} for part in (0.1, 0.2, 0.15)]
    one, two = (simulation(b, METAL, heat=heat) for b in (body, long))
    for step in path:
        # the mean of a ramp over 1e4 s lags by tau/1e4
        equal(one.step(**step), two.step(**step), 2e-3 if duration > 10 else 1e-9)
    assert one.state.surface_temperature(1).max() > 0


def test_expansion_moves_the_surface_and_closes_the_energy_balance():
    heat = sc.Heat((2e-3, 0.0), history=(0.05, 1e6))
    hot, cold = simulation(CREEPS, METAL, heat=heat, tol=1e-8), simulation(CREEPS, METAL)
    path = [{"load": 0.2 * LOAD * min(1, n / 20), "duration": 0.1} for n in range(1, 41)]
    states = hot.run(path, progress=False)
    free = cold.run(path, progress=False)
    balance = sc.energy.balance(hot, states)
    assert balance.expansion_work > 0.02 * balance.work_input
    assert balance.viscous_work > 0.02 * balance.work_input
    assert abs(balance.imbalance) < 2e-3
    assert states[-1].pressure.max() > 1.01 * free[-1].pressure.max()


def test_heat_of_slip_is_the_friction_work():
    """The heat flux times the duration is the share of the friction work, at any relaxation."""
    heat = sc.Heat(partition=0.0, time=1.0)  # into body 1
    path = [{"load": 0.1 * LOAD, "duration": 0.5}]
    path += [{"load": 0.1 * LOAD, "duration": 0.5, "shift": (s * 2e-6, 0.0)} for s in (1, 1, 1, -1)]
    rises = []
    for body in (CREEPS, RUBBER, RUBBER.with_relaxation([1e12], [0.5])):
        sim = simulation(body, METAL, heat=heat, friction=sc.Coulomb(0.3), tol=1e-8)
        states = sim.run(path, progress=False)
        rises.append(np.array([s.surface_temperature(1).sum() for s in states]))
        work = np.diff([s.friction_work for s in states])
        assert work.min() > 0
        # the mean temperature is proportional to the power
        np.testing.assert_allclose(rises[-1][1:] / work, (rises[-1][1:] / work)[0], rtol=0.1)
    np.testing.assert_allclose(rises[2], rises[1], rtol=1e-5)
    assert np.abs(rises[0] / rises[1] - 1)[1:].max() > 0.01
    assert sim.relax().surface_temperature(1).max() == 0.0  # no power over an infinite time


def test_the_expansion_of_a_viscoelastic_body_does_not_depend_on_its_modulus():
    """A free surface expands as that of an elastic body with any modulus; no stress is stated."""
    pressure = 1e4 * np.exp(-((GRID.x[:, None] / 1e-3) ** 2) - (GRID.y / 1e-3) ** 2)
    heat = sc.Heat((0.0, 1e-4), time=3.0)

    def expansion(body, **timed):
        states = [
            simulation(b, heat=h).step(pressure=pressure, **timed)
            for b, h in ((body, heat), (body, None))
        ]
        hot, cold = (state.surface_displacement(2) for state in states)
        return hot - cold

    soft = expansion(RELAXED)
    for body, timed in ((RUBBER, {}), (CREEPS, {"duration": 0.7}), (CREEPS, {"duration": 1e5})):
        np.testing.assert_allclose(expansion(body, **timed), soft, atol=1e-9 * np.abs(soft).max())


def test_refusals():
    layers = sc.Grid(GRID.nx, GRID.ny, GRID.dx, GRID.dy, dz=GRID.dx)
    with pytest.raises(ValueError, match=r"heat.factor must be 0 for viscoelastic body2 on a grid"):
        simulation(CREEPS, METAL, layers, heat=sc.Heat((0.0, 1e-6), time=1.0))
    slip = {"heat": sc.Heat(partition=0.5, time=1.0), "friction": sc.Coulomb(0.3)}
    with pytest.raises(ValueError, match=r"heat.partition .fraction of the heat. must be 0 for"):
        simulation(CREEPS, METAL, layers, **slip)
    sim = simulation(CREEPS, METAL, heat=sc.Heat((1e-6, 0.0), history=(0.1, 1e3)))
    with pytest.raises(ValueError, match=r"duration must be >= the shortest step of heat.history"):
        sim.step(load=LOAD, duration=1e-3)
    metal = sc.Material.perfect_plastic(E, 0.3, E).with_thermal(*METAL.thermal)
    with pytest.raises(ValueError, match=r"increment_tol and heat.history together are not"):
        simulation(
            CREEPS, metal, layers, increment_tol=0.1,
            heat=sc.Heat((1e-6, 0.0), history=(0.1, 1e3)),
        )  # fmt: skip

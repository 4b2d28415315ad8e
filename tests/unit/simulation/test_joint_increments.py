# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments whose pressure and shear are solved together, in combination with other features."""

import math

import numpy as np
import pytest

import samcontact as sc
from benchmarks.stability import random_contacts
from checkpoint_setups import assert_same
from samcontact import surfaces

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning",
    "ignore::samcontact.ResolutionWarning",
    "ignore::samcontact.ElasticStrainWarning",
)
CELL, RADIUS = random_contacts.CELL, random_contacts.RADIUS
RIGID, COMPRESSIBLE = sc.Material.rigid(), sc.Material.elastic(20e9, 0.05)
NO_SLIP = sc.Coulomb(math.inf)


def assert_close(field, expected, tol=1e-5):
    np.testing.assert_allclose(field, expected, rtol=0, atol=tol * np.abs(expected).max())


def pressed_and_pulled(load, ratio=(0.4, 0.1)):
    return [{"load": load}, {"load": load, "tangential_load": tuple(load * r for r in ratio)}]


def test_restart_gives_identical_digits(tmp_path):
    contact = random_contacts.random_contact("none", 4)
    press, pull, unload = contact.steps
    simulation = contact.simulation()
    states = [simulation.step(**press), simulation.step(**pull)]
    assert states[1].joint_steps > 0
    simulation.save(tmp_path / "pulled.h5")
    expected = simulation.step(**unload)
    resumed = sc.Simulation.load(tmp_path / "pulled.h5")
    assert resumed.state.joint_steps == states[1].joint_steps
    found = resumed.step(**unload)
    assert found.joint_steps == expected.joint_steps
    assert_same(found, expected)
    assert found.shear.tobytes() == expected.shear.tobytes()
    assert resumed.counters == simulation.counters


def test_enlarged_grid_gives_the_results_of_a_larger_one():
    contact = random_contacts.random_contact("none", 6)
    steps = [*contact.steps, {"load": 2 * contact.steps[0]["load"]}]

    def states(cells):
        grid = sc.Grid(cells, cells, CELL, CELL)
        simulation = sc.Simulation(
            grid, *contact.bodies, lambda grid: surfaces.paraboloid(grid, RADIUS), NO_SLIP
        )
        return [simulation.step(**step) for step in steps]

    for found, expected in zip(states(13), states(25), strict=True):
        assert found.joint_steps > 0 or expected.joint_steps == 0
        rim = (25 - found.grid.nx) // 2
        assert rim > 0
        inner = slice(rim, 25 - rim)
        assert_close(found.pressure, expected.pressure[inner, inner])
        assert_close(found.shear, expected.shear[:, inner, inner])
    assert found.grid.nx > 17


def test_layers_of_the_same_material_have_no_effect():
    grid = sc.Grid(11, 12, CELL, CELL)
    substrate = sc.Material.elastic(70e9, 0.05)
    load = 4 / 3 * substrate.E * (0.3 * grid.nx * CELL) ** 3 / RADIUS

    def pulled(body):
        gap = surfaces.paraboloid(grid, RADIUS)
        simulation = sc.Simulation(grid, RIGID, body, gap, NO_SLIP, on_border="warn")
        return [simulation.step(**step) for step in pressed_and_pulled(load)][1]

    found = pulled(sc.Layered([(substrate, 3 * CELL)], substrate))
    expected = pulled(substrate)
    assert found.joint_steps > 0
    assert_close(found.pressure, expected.pressure)
    assert_close(found.shear, expected.shear)
    coated = pulled(sc.Layered([(sc.Material.elastic(400e9, 0.2), 3 * CELL)], substrate))
    assert coated.joint_steps > 0
    assert coated.tangential_load == pytest.approx((0.4 * load, 0.1 * load), rel=1e-5)
    assert (
        np.abs(np.minimum(coated.pressure / coated.pressure.max(), coated.gap / CELL)).max() < 1e-5
    )


@pytest.mark.parametrize(("periodic", "seed"), [("x", 1), ("y", 2)])
def test_two_periods_repeat_the_solution_of_one(periodic, seed):
    """A rough strip of nominal pressure 300 MPa that is periodic along its length."""
    grid = sc.Grid(12, 10, 10e-6, 10e-6, periodic=periodic)
    across = grid.y[None, :] if periodic == "x" else grid.x[:, None]
    rough = 2e-6 * np.random.default_rng(seed).random((12, 10))
    gap = rough + 3e-6 * (across / 50e-6) ** 2

    def pulled(periods):
        times = (periods, 1) if periodic == "x" else (1, periods)
        simulation = sc.Simulation(
            sc.Grid(12 * times[0], 10 * times[1], 10e-6, 10e-6, periodic=periodic),
            RIGID, COMPRESSIBLE, np.tile(gap, times), NO_SLIP, on_border="warn",
        )  # fmt: skip
        load = 300e6 * simulation.grid.cell_area * simulation.grid.nx * simulation.grid.ny
        return [simulation.step(**step) for step in pressed_and_pulled(load, (0.3, 0.1))][1], times

    (one, _), (two, times) = pulled(1), pulled(2)
    assert one.joint_steps > 0
    assert_close(two.pressure, np.tile(one.pressure, times))
    assert_close(two.shear, np.tile(one.shear, (1, *times)))


@pytest.mark.parametrize("periodic", ["x", "y", "xy"])
def test_flat_dissimilar_periodic_bodies_are_pressed_and_pulled_with_friction(periodic):
    """Bodies in contact everywhere, pulled by half the friction limit."""
    grid = sc.Grid(12, 10, CELL, CELL, periodic=periodic)
    steel, polymer = sc.Material.elastic(210e9, 0.3), sc.Material.elastic(3e9, 0.4)
    load = 50e6 * grid.cell_area * grid.nx * grid.ny
    simulation = sc.Simulation(
        grid, steel, polymer, np.zeros(grid.surface_shape), sc.Coulomb(0.3), on_border="warn"
    )
    for step in pressed_and_pulled(load, (0.15, 0.0)):
        state = simulation.step(**step)
        assert state.converged
        assert np.all(np.hypot(*state.shear) <= 0.3 * state.pressure * (1 + 1e-6))
    assert state.tangential_load == pytest.approx((0.15 * load, 0.0), rel=1e-5, abs=1e-8 * load)


def test_elastic_plastic_body_without_slip():
    """An unreachable yield stress gives the elastic solution, a small one plastic strain."""
    contact = random_contacts.random_contact("none", 44)
    grid = sc.Grid(contact.grid.nx, contact.grid.ny, CELL, CELL, 6, CELL)
    press, pull = contact.steps[:2]
    simulation = contact.simulation()
    elastic = [simulation.step(**step) for step in (press, pull)][1]

    def pulled(yield_stress):
        body = sc.Material.linear_hardening(70e9, 0.33, yield_stress, 7e9)
        simulation = sc.Simulation(
            grid, contact.bodies[0], body, contact.gap, contact.friction, on_border="warn"
        )
        simulation.step(**press)
        return simulation.step(**pull)

    same, yielded = pulled(1e13), pulled(0.3e9)
    assert same.joint_steps > 0
    assert_close(same.pressure, elastic.pressure)
    assert_close(same.shear, elastic.shear)
    assert yielded.converged
    assert yielded.tangential_load == pytest.approx(pull["tangential_load"], rel=1e-5)
    assert yielded.equivalent_plastic_strain().max() > 0


@pytest.mark.parametrize("cells", [(8, 4), (8, 1)])
def test_full_periodic_contact_without_slip_cannot_be_shifted(cells):
    grid = sc.Grid(*cells, 10e-6, 10e-6, periodic="xy")
    bodies = sc.Material.elastic(210e9, 0.3), sc.Material.elastic(70e9, 0.2)
    load = 100e6 * grid.nx * grid.ny * grid.dx * grid.dy
    simulation = sc.Simulation(grid, *bodies, np.zeros(cells), NO_SLIP)
    simulation.step(load=load)
    for shift in ((1e-7, 0.0), (0.0, -1e-7)):
        with pytest.raises(ValueError, match="shift must be 0 in full contact without slip"):
            simulation.step(load=load, shift=shift)
    state = simulation.step(load=load, tangential_load=(0.2 * load, 0.0))
    np.testing.assert_allclose(state.shear[0], 20e6)
    np.testing.assert_allclose(state.shear[1], 0.0, atol=1.0)

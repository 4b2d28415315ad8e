# SPDX-License-Identifier: GPL-3.0-or-later
"""Two elastic-plastic bodies: identical ones (one is computed), and different ones."""

import h5py
import numpy as np
import pytest

import samcontact as sc

E, NU = 210e9, 0.3
STEEL = sc.Material.swift(E, NU, 945e6, 20.0, 0.121)
# The same to the last digit but one: too different for one body to stand for both.
STEEL_AGAIN = sc.Material.swift(E, NU, 945e6, 20.0, np.nextafter(0.121, 1))
KINEMATIC = sc.Material.perfect_plastic(E, NU, 1.4e9).with_kinematic_hardening(30e9, 40.0)
KINEMATIC_AGAIN = sc.Material.perfect_plastic(
    E, NU, np.nextafter(1.4e9, 2e9)
).with_kinematic_hardening(30e9, 40.0)
CYCLE = [{"load": w} for w in (800.0, 1600.0, 0.0, 1800.0, 0.0)]


def balls(body1, body2, n=19, **settings):
    d = 60e-6
    grid = sc.Grid(n, n, d, d, 13, d)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    return sc.Simulation(grid, body1, body2, gap, **settings)


FIELDS = (
    ("stress", 1e9),
    ("plastic_strain", 1e-3),
    ("equivalent_plastic_strain", 1e-3),
    ("residual_displacement", 1e-6),
    ("backstress", 1e9),
)


# Every pair of values of two parameters occurs.
@pytest.mark.parametrize(
    ("method", "material", "again", "control"),
    [
        ("exact", KINEMATIC, KINEMATIC_AGAIN, {}),
        ("fast", STEEL, STEEL_AGAIN, {}),
        ("exact", STEEL, STEEL_AGAIN, {"increment_tol": 2e-3}),
        pytest.param(
            *("fast", KINEMATIC, KINEMATIC_AGAIN, {"increment_tol": 2e-3}), marks=pytest.mark.slow
        ),
    ],
    ids=["given-kin-exact", "given-52100-fast", "automatic-52100-exact", "automatic-kin-fast"],
)
def test_one_body_represents_two_identical_ones(method, material, again, control):
    settings = {"residual_stress": method, "tol": 1e-9, **control}
    short = balls(material, material, **settings).run(CYCLE, progress=False)
    general = balls(material, again, **settings).run(CYCLE, progress=False)
    for one, two in zip(short, general, strict=True):
        assert one.iterations == two.iterations
        np.testing.assert_allclose(one.pressure, two.pressure, rtol=0, atol=1e-8 * 4e9)
        assert one.approach == pytest.approx(two.approach, rel=1e-8)
        for name, scale in FIELDS:
            for body in (1, 2):
                a, b = getattr(one, name)(body), getattr(two, name)(body)
                np.testing.assert_allclose(a, b, rtol=0, atol=1e-8 * scale, err_msg=name)
    assert short[-1].equivalent_plastic_strain().max() > 1e-3


def test_states_of_identical_bodies_are_equal_and_stored_once():
    simulation = balls(STEEL, STEEL)
    general = balls(STEEL, STEEL_AGAIN)
    for both in (simulation, general):
        both.run(CYCLE[:2], progress=False)
    assert simulation.counters["volume_bytes"] < general.counters["volume_bytes"]
    state = simulation.state
    for name, _ in FIELDS:
        assert np.array_equal(getattr(state, name)(1), getattr(state, name)(2))


def test_prescribed_pressure():
    simulation = balls(STEEL, STEEL)
    pressure = balls(STEEL, STEEL).step(load=1500.0).pressure
    state = simulation.step(pressure=pressure)
    other = balls(STEEL, STEEL_AGAIN).step(pressure=pressure)
    for body in (1, 2):
        np.testing.assert_allclose(
            state.plastic_strain(body), other.plastic_strain(body), rtol=0, atol=1e-11
        )


def test_shear_acts_on_them_in_opposite_directions():
    pressure = balls(STEEL, STEEL).step(load=1500.0).pressure
    state = balls(STEEL, STEEL).step(pressure=pressure, shear=0.3 * pressure)
    for body in (1, 2):
        assert state.equivalent_plastic_strain(body).max() > 1e-3
    for c in range(6):
        np.testing.assert_allclose(
            state.plastic_strain(1)[c],
            (-1 if c in (4, 5) else 1) * state.plastic_strain(2)[c, ::-1],
            rtol=0,
            atol=1e-9,
        )


def test_changes_of_one_body_make_the_bodies_different():
    simulation = balls(STEEL, STEEL)
    state = simulation.step(load=1000.0)
    strain = 2 * state.plastic_strain(1)
    simulation.set_plastic_strain(1, strain, state.equivalent_plastic_strain(1))
    after = simulation.step(load=1500.0)
    assert not np.array_equal(after.plastic_strain(1), after.plastic_strain(2))
    # and the other way: equal again
    for body in (1, 2):
        simulation.set_plastic_strain(body, strain, state.equivalent_plastic_strain(1))
    after = simulation.step(load=1800.0)
    assert np.array_equal(after.plastic_strain(1), after.plastic_strain(2))


def test_a_checkpoint_stores_one_of_two_identical_bodies(tmp_path):
    simulation = balls(STEEL, STEEL)
    simulation.run(CYCLE[:2], progress=False)
    simulation.save(tmp_path / "saved.h5")
    with h5py.File(tmp_path / "saved.h5") as file:
        assert file["state/history1"] == file["state/history2"]
    resumed = sc.Simulation.load(tmp_path / "saved.h5")
    for target in CYCLE[2:]:
        a, b = simulation.step(**target), resumed.step(**target)
    for name, _ in FIELDS:
        for body in (1, 2):
            assert np.array_equal(getattr(a, name)(body), getattr(b, name)(body))
    work = [{**s.counters, "volume_bytes": 0} for s in (simulation, resumed)]
    assert work[0] == work[1]


def test_the_harder_of_two_yields_less():
    hard = sc.Material.swift(E, NU, 1280e6, 4.0, 0.095)
    state = balls(hard, STEEL).step(load=1800.0)
    g = [state.equivalent_plastic_strain(body).max() for body in (1, 2)]
    assert 0 < g[0] < 0.6 * g[1]
    swapped = balls(STEEL, hard).step(load=1800.0)
    np.testing.assert_allclose(swapped.pressure, state.pressure, rtol=0, atol=1e-5 * 4e9)
    assert swapped.equivalent_plastic_strain(1).max() == pytest.approx(g[1], rel=1e-5)

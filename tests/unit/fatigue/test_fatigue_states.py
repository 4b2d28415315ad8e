# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue of simulated contacts: cells, moments and stress used; invalid input."""

from functools import partial

import numpy as np
import pytest

import samcontact as sc
from samcontact.fatigue import (
    crossland,
    cycle,
    dang_van,
    fatemi_socie,
    findley,
    orthogonal_shear,
    steady_cycle,
)

STEEL = sc.Material.elastic(210e9, 0.3)
GRID = sc.Grid(48, 16, 20e-6, 20e-6, nz=6, dz=20e-6)
BALL = {"load": 60.0}


def ball_on(grid=GRID, body=STEEL, **settings):
    return sc.Simulation(grid, STEEL, body, sc.surfaces.paraboloid(grid, 5e-3), **settings)


def test_a_pass_gives_the_stress_path_of_the_material():
    """States of a pass over the body agree with a line through one state."""
    soft = sc.Material.linear_hardening(
        210e9, 0.3, 50e9, 21e9
    )  # it follows body 2, and never flows
    steps = sc.paths.rolling(load=60.0, distance=32 * 20e-6, step=20e-6, increments=1)
    simulation = ball_on(body=soft)
    states = simulation.run(steps, progress=False)  # unloaded at the end, as far from the contact
    seen = cycle(states, 2)
    assert seen.points_shape[0] == 48 - 32
    steady = steady_cycle(states[10], 2)
    for criterion in (dang_van, crossland):
        whole = criterion(seen, slope=0.3)
        assert whole.values.shape == (16, 16, 6)
        middle = whole.values[7:9].mean(axis=0)
        line = criterion(steady, slope=0.3)
        np.testing.assert_allclose(middle, line.values, atol=0.01 * line.max_value)
        # cells lie on the body: the contact went over them
        assert set(whole.position) == {"x", "y", "z"}
        assert 0.0 < whole.coordinates["x"].mean() < 32 * 20e-6
        assert abs(whole.position["y"]) < 2 * 20e-6
    tau = orthogonal_shear(seen).values[7:9].mean(axis=0)
    np.testing.assert_allclose(tau, orthogonal_shear(steady).values, rtol=0.02, atol=1e6)


def test_rolling_along_y_is_rolling_along_x_rotated():
    grids = (
        sc.Grid(24, 16, 20e-6, 20e-6, nz=4, dz=20e-6),
        sc.Grid(16, 24, 20e-6, 20e-6, nz=4, dz=20e-6),
    )
    one, other = (ball_on(grid).step(**BALL) for grid in grids)
    for criterion in (dang_van, crossland):
        along_x, along_y = (
            criterion(steady_cycle(one), slope=0.2),
            criterion(steady_cycle(other, axis="y"), slope=0.2),
        )
        assert (set(along_x.coordinates), set(along_y.coordinates)) == ({"y", "z"}, {"x", "z"})
        np.testing.assert_allclose(along_x.values, along_y.values, rtol=1e-8)
    y = orthogonal_shear(steady_cycle(other, axis="y"), axis="y")
    np.testing.assert_allclose(orthogonal_shear(steady_cycle(one)).values, y.values, rtol=1e-8)


def test_residual_stress_is_in_the_cycle():
    """Initial compression changes Dang Van's criterion only by its hydrostatic mean."""
    hard = sc.Material.linear_hardening(210e9, 0.3, 50e9, 21e9)
    treated = hard.with_residual_stress([0.0, 1e-3], [-300e6, -300e6])
    plain, peened = (
        dang_van([s.step(load=0.0), s.step(load=60.0)], slope=0.3)
        for s in (ball_on(body=hard), ball_on(body=treated))
    )
    np.testing.assert_allclose(peened.values, plain.values - 0.3 * 200e6, rtol=1e-6)


def test_plastic_strain_is_included_in_strain_criteria():
    soft = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9)
    simulation = ball_on(body=soft)
    states = [simulation.state, simulation.step(load=70.0)]
    found = fatemi_socie(states, k=0.5)
    assert found.parameters["yield_stress"] == 1e9
    stress, strain = (
        np.stack([getattr(s.at_layers(6), name)(2) for s in states])
        for name in ("stress", "plastic_strain")
    )
    given = cycle(stress, plastic_strain=strain)
    again = fatemi_socie(given, k=0.5, yield_stress=1e9, material=STEEL)
    np.testing.assert_array_equal(again.values, found.values)
    elastic = fatemi_socie(stress, k=0.5, yield_stress=1e9, material=STEEL)
    flowed = states[1].equivalent_plastic_strain(2) > 1e-3
    assert flowed.any()
    assert (found.values[flowed] > 1.2 * elastic.values[flowed]).all()


def test_a_coating_has_its_own_stiffness():
    coated = sc.Layered([(sc.Material.elastic(420e9, 0.2), 40e-6)], STEEL)
    states = [(s := ball_on(body=coated)).state, s.step(load=60.0)]
    found = fatemi_socie(states, k=0.0, yield_stress=1e9)
    stress = np.stack([state.stress(2) for state in states])
    for layers, material in ((slice(0, 2), sc.Material.elastic(420e9, 0.2)), (slice(2, 6), STEEL)):
        own = fatemi_socie(stress[..., layers], k=0.0, yield_stress=1e9, material=material)
        np.testing.assert_allclose(found.values[..., layers], own.values, rtol=1e-9)
    with pytest.raises(ValueError, match="yield_stress is required"):
        fatemi_socie(states, k=0.0)


def test_digits_depend_neither_on_blocks_nor_on_the_memory(monkeypatch):
    from samcontact._util import memory

    states = [(s := ball_on()).state, s.step(load=30.0), s.step(load=60.0)]
    criteria = (partial(dang_van, slope=0.3), partial(findley, k=0.3))
    criteria += (partial(fatemi_socie, k=0.5, yield_stress=1e9),)
    seen = cycle(states)
    whole = [criterion(seen) for criterion in criteria]
    minimum = 2.5 * 48 * 3 * 48 * 16
    monkeypatch.setattr(memory, "available", lambda: 2.2 * minimum / 0.4)  # two layers at once
    for given in (states, seen):  # the second has its stress already
        parts = [criterion(given) for criterion in criteria]
        for one, other in zip(whole, parts, strict=True):
            np.testing.assert_array_equal(one.values, other.values)
        np.testing.assert_array_equal(whole[1].normals, parts[1].normals)


def test_margin_and_place():
    stress = np.zeros((2, 6, 3, 4, 5))
    stress[1, 4, 1, 2, 3] = 200e6
    found = dang_van(stress, slope=0.3)
    assert found.index == (1, 2, 3)
    assert found.position == {}
    assert found.max_value == pytest.approx(100e6)
    assert found.margin(250e6) == pytest.approx(1.5)
    assert found.margin(80e6) == pytest.approx(-0.2)
    np.testing.assert_allclose(found.over_depth(), [0, 0, 0, 100e6, 0])
    assert dang_van(np.zeros((2, 6, 3)), slope=0.3).margin(1.0) == np.inf
    with pytest.raises(ValueError, match="requires coordinates"):
        found.to_dataset()


def test_the_dataset_is_labelled():
    found = findley(steady_cycle(ball_on().step(**BALL)), k=0.3)
    dataset = found.to_dataset()
    assert dict(dataset.sizes) == {"y": 16, "z": 6, "axis": 3}
    assert dataset["findley"].attrs["units"] == "Pa"
    assert dataset["findley"].attrs["k"] == 0.3
    np.testing.assert_array_equal(dataset["findley_normal"].sel(found.position), found.normal)
    maximum = dataset["findley"].sel(found.position)
    assert float(maximum) == found.max_value


@pytest.mark.parametrize(
    ("call", "error", "text"),
    [
        (lambda s: dang_van(s), TypeError, "slope is required"),
        (lambda s: dang_van(s, 2, 300e6), ValueError, "slope .* dimensionless"),
        (lambda s: crossland(s, slope=-0.1), ValueError, "slope"),
        (lambda s: findley(s, 3, 0.3), ValueError, "body must be one of 1, 2"),
        (lambda s: dang_van(s[0], slope=0.3), ValueError, "steady_cycle"),
        (lambda s: dang_van(s[:1], slope=0.3), ValueError, "steady_cycle"),
        (lambda s: dang_van([s[0], 3.0], slope=0.3), TypeError, "samcontact.State"),
        (lambda s: dang_van([], slope=0.3), ValueError, "states"),
        (lambda s: dang_van(np.zeros((4, 5, 2)), slope=0.3), ValueError, "shape"),
        (lambda s: dang_van(np.zeros((1, 6, 2)), slope=0.3), ValueError, "at least 2 instants"),
        (lambda s: dang_van(np.full((2, 6, 2), np.nan), slope=0.3), ValueError, "finite"),
        (lambda s: dang_van(np.zeros((2, 6, 2)), 2, 0.3), ValueError, "body must be omitted"),
        (lambda s: dang_van(cycle(s), 2, 0.3), ValueError, "body must be omitted with a Cycle"),
        (lambda s: orthogonal_shear(s, axis="z"), ValueError, "axis"),
        (lambda s: fatemi_socie(np.zeros((2, 6, 2)), k=0.3), TypeError, "material is required"),
        (lambda s: fatemi_socie(s, k=0.3), ValueError, "yield_stress is required"),
        (lambda s: steady_cycle(np.zeros((6, 1, 2, 2))), ValueError, "at least 2 cells along x"),
        (lambda s: steady_cycle(np.zeros((6, 4, 4))), ValueError, "shape"),
    ],
)  # fmt: skip
def test_invalid_arguments_are_named(call, error, text):
    states = [(s := ball_on()).state, s.step(load=10.0)]
    with pytest.raises(error, match=text):
        call(states)


def test_states_of_several_simulations_are_refused():
    other = ball_on(sc.Grid(48, 16, 21e-6, 20e-6, nz=6, dz=20e-6)).step(load=10.0)
    with pytest.raises(ValueError, match="different grids"):
        dang_van([ball_on().step(load=10.0), other], slope=0.3)
    other = ball_on(body=sc.Material.elastic(200e9, 0.3)).step(load=10.0)
    with pytest.raises(ValueError, match="same body 2"):
        dang_van([ball_on().step(load=10.0), other], slope=0.3)

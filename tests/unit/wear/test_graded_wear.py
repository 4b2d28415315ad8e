# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear exposes deeper material: depth profiles move with the material."""

import numpy as np
import pytest

import samcontact as sc
from samcontact.simulation.repeated import coarsened

E, NU, Y = 210e9, 0.3, 1e9
ELASTIC = sc.Material.elastic(E, NU)
SOFT = sc.Material.linear_hardening(E, NU, Y, 0.1 * E)
CASE = np.array([0.0, 80e-6, 160e-6]), np.array([2.0, 2.0, 1.0])
PULL = np.array([0.0, 150e-6]), np.array([-5e8, 0.0])
BODY = SOFT.with_yield_profile(*CASE).with_residual_stress(*PULL)
GRID = sc.Grid(25, 25, 30e-6, 30e-6, 20, 15e-6)
BALL = sc.surfaces.paraboloid(GRID, 7.5e-3)


def flat(worn, rows=25):
    return sc.Relief(np.zeros((rows, 25)), worn=np.broadcast_to(worn, (rows, 25)))


def test_uniform_wear_shifts_the_profile():
    worn = 50e-6
    shifted = SOFT.with_yield_profile([0.0, 30e-6, 110e-6], CASE[1])
    shifted = shifted.with_residual_stress([0.0, 100e-6], [-5e8 * (1 - 50 / 150), 0.0])
    sims = [
        sc.Simulation(GRID, ELASTIC, BODY, BALL, relief2=flat(worn)),
        sc.Simulation(GRID, ELASTIC, shifted, BALL),
        sc.Simulation(GRID, ELASTIC, BODY, BALL),
    ]
    for load in (150.0, 250.0, 0.0):
        one, other, unworn = (sim.step(load=load) for sim in sims)
        np.testing.assert_allclose(one.pressure, other.pressure, atol=1e3)
        np.testing.assert_allclose(one.stress(), other.stress(), atol=1e-5 * Y)
        np.testing.assert_allclose(one.initial_stress(), other.initial_stress(), atol=1.0)
    strains = [s.max_equivalent_plastic_strain() for s in (one, unworn)]
    assert strains[0] > 1.2 * strains[1]


@pytest.mark.parametrize("advance", [0.0, 60e-6, 75e-6])
def test_wear_depth_moves_with_the_body(advance):
    """Rows with different wear depths move with the body."""
    rows = 40
    worn = 4e-6 * np.arange(rows)[:, None] * np.ones(25)
    relief = sc.Relief(np.zeros((rows, 25)), first=-10, worn=worn)
    sim = sc.Simulation(GRID, ELASTIC, BODY, BALL, relief2=relief, friction=0.1)
    sim.step(load=200.0)
    state = sim.step(load=200.0, advance=(0.0, advance))
    track = state.track(margin=0)
    depth = np.interp(track.first + np.arange(track.grid.nx), np.arange(-10, 30), worn[:, 0], 0, 0)
    z = track.z + depth[:, None, None]
    expected = np.broadcast_to(np.interp(z, *CASE), track.grid.volume_shape)
    np.testing.assert_allclose(track.yield_factor(), expected, rtol=1e-12)
    expected = np.broadcast_to(np.interp(z, *PULL), track.grid.volume_shape)
    np.testing.assert_allclose(track.initial_stress()[0], expected, atol=1.0)
    # The stress is that of yield in the cells that have just flown.
    strain = track.equivalent_plastic_strain()
    limit = SOFT.yield_stress(strain) * track.yield_factor()
    assert strain.max() > 1e-4
    assert (track.residual_von_mises() <= limit * (1 + 1e-3)).all()


def test_identical_bodies_with_different_wear_are_not_identical():
    sim = sc.Simulation(GRID, BODY, BODY, BALL, relief1=flat(0.0), relief2=flat(100e-6))
    state = sim.step(load=250.0)
    weak, strong = (state.max_equivalent_plastic_strain(body) for body in (2, 1))
    assert weak > 1.2 * strong


def test_a_worn_case_becomes_thinner():
    """The hard layer becomes thinner from cycle to cycle."""
    steel = sc.Material.swift(E, NU, 1735e6, 16.0, 0.067)
    grid = sc.Grid(29, 27, 5e-6, 5e-6, 28, 1.6e-6)
    z, factor = [0.0, 0.4e-6, 4e-6], [1.06, 1.04, 1.0]
    result = sc.wear.run(
        grid, ELASTIC, steel.with_yield_profile(z, factor), sc.surfaces.paraboloid(grid, 4e-4),
        cycle=[{"load": 5.0}, {"load": 0.0}], threshold=2e-3, cycles=3, window=7, friction=0.4,
        progress=False,
    )  # fmt: skip
    assert result.cycles[0].volume[0] > 0
    worn = result.profile(0) - result.profile()
    assert worn.max() > 0.1e-6
    np.testing.assert_allclose(result.relief2.worn, np.maximum(worn, 0.0), atol=1e-18)
    before = result.last[1].track(margin=0)  # that of the surface that the last cycle began with
    first = result.first_row[2]
    at_start = (result.profile(0) - result.profile(-2))[before.first - first :][: before.grid.nx]
    expected = np.interp(before.z + at_start[..., None], z, factor)
    np.testing.assert_allclose(before.yield_factor(), expected, rtol=1e-6)


def test_a_coarser_grid_keeps_the_wear_depth():
    worn = 40e-6 + 1e-6 * np.arange(26)[:, None] * np.ones(26)
    grid = sc.Grid(26, 26, 30e-6, 30e-6, 10, 30e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    relief = sc.Relief(np.zeros((26, 26)), worn=worn)
    sim = sc.Simulation(grid, ELASTIC, BODY, gap, relief2=relief)
    coarse = coarsened(sim, sc.Heat(0.0))
    found = coarse.step(load=100.0).track(margin=0).yield_factor()
    z = coarse.grid.z + worn.mean()
    middle = tuple(n // 2 for n in found.shape[:2])
    np.testing.assert_allclose(found[middle], np.interp(z, *CASE), atol=0.02)


def test_checkpoints_keep_the_wear_depth(tmp_path):
    worn = 40e-6 + 1e-6 * np.arange(25)[:, None] * np.ones(25)
    sim = sc.Simulation(GRID, ELASTIC, BODY, BALL, relief2=flat(worn))
    sim.step(load=150.0)
    sim.save(tmp_path / "state.h5")
    again = sc.Simulation.load(tmp_path / "state.h5")
    np.testing.assert_array_equal(*(s.step(load=250.0).stress() for s in (sim, again)))


@pytest.mark.parametrize(
    ("worn", "text"), [(-1e-6, "worn must be >= 0 everywhere, got -1e-06"), (np.nan, "worn must")]
)
def test_bodies_that_cannot_wear_are_refused(worn, text):
    with pytest.raises(ValueError, match=text):
        flat(worn)

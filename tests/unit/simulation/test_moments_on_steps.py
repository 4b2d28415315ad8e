# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments under load and moments: equilibrium, history, energy, checkpoints and case files."""

import numpy as np
import pytest

import samcontact as sc
from samcontact.cases import parse_case
from samcontact.report import checks
from samcontact.results import to_dataset

STEEL = sc.Material.elastic(E=210e9, nu=0.3)
SOFT = sc.Material.linear_hardening(E=210e9, nu=0.3, yield_stress=8e8, tangent_modulus=10e9)
GRID = sc.Grid(28, 24, 25e-6, 25e-6, dz=25e-6)
GAP = sc.surfaces.paraboloid(GRID, 8e-3, 5e-3)
LOAD = 120.0
ECCENTRIC = {"load": LOAD, "moment": (LOAD * 75e-6, -LOAD * 50e-6)}


def simulation(body2=SOFT, friction=0.0, gap=GAP, **options):
    return sc.Simulation(GRID, STEEL, body2, gap, friction, tol=1e-9, **options)


def test_plastic_flow_under_a_moment_is_that_under_the_tilt():
    driven = simulation()
    reached = driven.step(**ECCENTRIC)
    assert reached.max_equivalent_plastic_strain() > 1e-3
    assert reached.moment == pytest.approx(ECCENTRIC["moment"], rel=1e-10)
    held = simulation().step(load=LOAD, tilt=reached.tilt)
    assert held.moment == pytest.approx(reached.moment, rel=1e-7)
    peak = held.pressure.max()
    np.testing.assert_allclose(reached.pressure, held.pressure, atol=1e-6 * peak)
    # The ball rolls to the line of action of the load.
    assert reached.tilt == pytest.approx([75e-6 / 5e-3, -50e-6 / 8e-3], rel=1e-3)
    # Without moment the bodies keep the tilt; unloaded ones transmit none.
    more = driven.step(load=1.1 * LOAD)
    assert np.array_equal(more.tilt, reached.tilt)
    apart = driven.step(load=0.0, moment=(0.0, 0.0))
    assert np.array_equal(apart.tilt, reached.tilt)
    assert not apart.moment.any()


def test_mirrored_moments_mirror_the_plastic_strain():
    one = simulation().step(**ECCENTRIC)
    about_x, about_y = ECCENTRIC["moment"]
    other = simulation().step(load=LOAD, moment=(-about_x, about_y))
    assert other.tilt == pytest.approx(one.tilt * [-1, 1], rel=1e-8)
    strain, mirrored = (s.equivalent_plastic_strain() for s in (one, other))
    np.testing.assert_allclose(mirrored[:, ::-1], strain, atol=1e-6 * strain.max())


def test_an_increment_in_two_parts_reaches_the_same_elastic_state():
    once = simulation(STEEL).step(**ECCENTRIC)
    parts = simulation(STEEL)
    parts.step(load=0.5 * LOAD, tilt=(1e-3, -2e-3))
    twice = parts.step(**ECCENTRIC)
    assert twice.tilt == pytest.approx(once.tilt, rel=1e-7)


def test_the_work_of_a_moment_is_part_of_the_energy_balance():
    # A paraboloid that rolls at constant load keeps its energy: the moment does the work that the
    # load gives back.
    sim = simulation(STEEL, sc.Coulomb(0.3))
    states = [sim.step(load=LOAD), sim.step(**ECCENTRIC)]
    balance = sc.energy.balance(sim, states)
    given_back = LOAD * (states[0].approach - states[1].approach)
    assert given_back > 0.02 * balance.work_input
    assert abs(balance.imbalance) < 1e-6
    # Dissimilar bodies in partial slip, pressed eccentrically and turned further.
    gap = GAP + 0.4e-6 * np.cos(GRID.x[:, None] * 1.5e4) * np.sin(GRID.y * 1.7e4 + 1.0)
    rubber = sc.Material.elastic(E=70e9, nu=0.2)
    sim = simulation(rubber, sc.Coulomb(0.3), gap)
    parts = np.linspace(0.2, 1.0, 5)
    path = [{"load": LOAD * f, "moment": tuple(f * m for m in ECCENTRIC["moment"])} for f in parts]
    path += [{"load": LOAD, "moment": (f * ECCENTRIC["moment"][0], 0.0)} for f in (0.5, 0.0, -0.5)]
    balance = sc.energy.balance(sim, sim.run(path, progress=False))
    assert abs(balance.imbalance) < 0.01


def test_a_checkpoint_keeps_the_tilt(tmp_path):
    sim = simulation()
    sim.step(**ECCENTRIC)
    sim.save(tmp_path / "tilted.h5")
    again = sc.Simulation.load(tmp_path / "tilted.h5")
    assert np.array_equal(again.state.tilt, sim.state.tilt)
    one, other = (s.step(load=1.2 * LOAD) for s in (sim, again))
    assert np.array_equal(one.pressure, other.pressure)
    assert np.array_equal(one.gap, other.gap)


CASE = """
title = "tilted"
[grid]
nx = 28
ny = 24
dx = 25e-6
dy = 25e-6
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 8e-3
[[path]]
load = 60.0
moment_x = 3e-3
increments = 2
[[path]]
load = 60.0
moment_x = 1e-3
tilt_y = "1 mrad"
increments = 2
[[path]]
load = 0.0
increments = 1
"""


def test_a_case_file_prescribes_moments_and_tilts():
    case = parse_case(CASE)
    steps = case.steps()
    assert steps == [
        {"load": 30.0, "moment": (1.5e-3, None)},
        {"load": 60.0, "moment": (3e-3, None)},
        {"load": 60.0, "moment": (2e-3, None), "tilt": (None, 5e-4)},
        {"load": 60.0, "moment": (1e-3, None), "tilt": (None, 1e-3)},
        {"load": 0.0},
    ]
    sim, steps = case.build()
    dataset = to_dataset(sim, sim.run(steps, progress=False), case)
    assert dataset["moment_x"].values == pytest.approx([1.5e-3, 3e-3, 2e-3, 1e-3, 0.0], rel=1e-9)
    assert dataset["tilt_y"].values[-2:] == pytest.approx([1e-3, 1e-3], rel=1e-12)
    assert all(check.passed for check in checks(dataset))
    wrong = CASE.replace("load = 60.0\nmoment_x = 3e-3", "approach = 1e-6\nmoment_x = 3e-3")
    with pytest.raises(ValueError, match="moment_x and moment_y cannot be combined with approach"):
        parse_case(wrong)
    unknown = CASE.replace("load = 60.0\nmoment_x = 1e-3", "load = 60.0\ntilt_x = 1e-3", 1)
    with pytest.raises(ValueError, match="tilt_x must not change in several increments"):
        parse_case(unknown)

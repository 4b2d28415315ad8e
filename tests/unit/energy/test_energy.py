# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic work and residual energy against sums over the path and over the surrounding stress."""

import itertools

import numpy as np
import pytest
import scipy.integrate

import samcontact as sc
from samcontact import energy

SWIFT = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
HARDENING = sc.Material.linear_hardening(210e9, 0.3, 1e9, 20e9)
PERFECT = sc.Material.perfect_plastic(210e9, 0.3, 1.2e9)
KINEMATIC = PERFECT.with_kinematic_hardening(30e9, 20.0)
ELASTIC = sc.Material.elastic(210e9, 0.3)


@pytest.mark.parametrize("material", [SWIFT, HARDENING, PERFECT, KINEMATIC])
def test_plastic_work_is_the_integral_of_the_yield_stress(material):
    g = np.array([0.0, 1e-5, 0.004, 0.03])
    expected = [scipy.integrate.quad(material.yield_stress, 0, end)[0] for end in g]
    np.testing.assert_allclose(material.plastic_work(g), expected, rtol=1e-9, atol=1e-12)
    assert material.plastic_work(0.004) == pytest.approx(expected[2], rel=1e-9)


def test_nothing_is_dissipated_without_yielding():
    assert ELASTIC.plastic_work(0.01) == 0
    assert not sc.Material.rigid().plastic_work(np.ones(3)).any()
    with pytest.raises(ValueError, match="g must be finite and >= 0, got -1"):
        SWIFT.plastic_work([-1.0])


def problem(material, increments, **settings):
    grid = sc.Grid(15, 15, 84e-6, 84e-6, 12, 90e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    simulation = sc.Simulation(grid, ELASTIC, material, gap, **settings)
    path = sc.paths.load_unload(load=1500.0, increments=increments)
    return simulation, [simulation.state, *simulation.run(path, progress=False)]


def work_of_the_stress(states):
    """Return the trapezoidal sum of stress : plastic strain increment over cells and increments."""
    grid, total = states[0].grid, 0.0
    for before, after in itertools.pairwise(states):
        stress = 0.5 * (before.stress() + after.stress())
        strain = after.plastic_strain() - before.plastic_strain()
        product = stress * strain
        total += product[:3].sum() + 2 * product[3:].sum()
    return total * grid.dx * grid.dy * grid.dz


@pytest.mark.parametrize("material", [SWIFT, KINEMATIC], ids=["swift", "kinematic"])
def test_plastic_work_of_a_body_is_that_of_its_stress(material):
    errors = []
    for increments in (10, 20, 40):
        _, states = problem(material, increments)
        tracks = [state.track(margin=0) for state in states]
        work = sum(
            energy.plastic_work(material, after, before)
            for before, after in itertools.pairwise(tracks)
        )
        assert work > 0
        errors.append(abs(work / work_of_the_stress(states) - 1))
    # yield starts within an increment, which the sum over the path does not resolve
    assert errors[2] < 2e-3
    assert errors[2] < 0.6 * errors[0]


def test_plastic_work_depends_on_the_state_alone_without_kinematic_hardening():
    _, states = problem(SWIFT, 5)
    tracks = [state.track(margin=0) for state in states]
    steps = [
        energy.plastic_work(SWIFT, after, before) for before, after in itertools.pairwise(tracks)
    ]
    assert min(steps) >= 0
    assert sum(steps) == pytest.approx(energy.plastic_work(SWIFT, tracks[-1]), rel=1e-12)


def test_residual_energy_is_that_of_the_stress_around():
    """Residual energy is half of residual stress times elastic strain over a large volume."""
    grid = sc.Grid(35, 35, 1e-5, 1e-5, 22, 1e-5)
    middle, depth = slice(14, 21), slice(2, 9)
    x = (np.arange(7) - 3) / 3.5
    bump = np.cos(0.5 * np.pi * x) ** 2
    shape = np.einsum("i,j,k->ijk", bump, bump, bump)
    strain = np.zeros((6, *grid.volume_shape))
    for component, factor in ((0, 0.5), (1, 0.5), (2, -1.0), (4, 0.3)):
        strain[component, middle, middle, depth] = 1e-3 * factor * shape
    gap = sc.surfaces.paraboloid(grid, 1.0)
    simulation = sc.Simulation(grid, ELASTIC, SWIFT, gap, residual_stress="exact")
    simulation.set_plastic_strain(2, strain)
    track = simulation.state.track(margin=14)
    stress = track.residual_stress()
    trace = stress[:3].sum(axis=0)
    norm = (stress[:3] ** 2).sum() + 2 * (stress[3:] ** 2).sum()
    E, nu = 210e9, 0.3
    around = 0.5 * ((1 + nu) / E * norm - nu / E * (trace**2).sum()) * 1e-15
    # cells of a seventh of the strained block, and what is outside
    assert energy.residual_energy(track) == pytest.approx(around, rel=0.06)
    assert energy.residual_energy(track) > around


def test_thermal_softening_is_refused():
    soft = SWIFT.with_softening(sc.softening.JohnsonCook(melting=1800.0, m=1.0))
    simulation, _ = problem(SWIFT, 1)
    with pytest.raises(ValueError, match="material must have no thermal softening"):
        energy.plastic_work(soft, simulation.state.track())

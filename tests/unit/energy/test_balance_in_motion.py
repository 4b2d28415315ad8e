# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy balance of bodies that slide, roll and soften: conservation and closing increments."""

import numpy as np
import pytest

import samcontact as sc

BALL = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.linear_hardening(210e9, 0.3, 0.5e9, 20e9)
LOAD, D = 60.0, 20e-6


def moved(body2=STEEL, advance=(0.0, -1.0), friction=0.2, parts=2, **settings):
    """Return the balance of a ball that is pressed, moves by three cells, and is unloaded."""
    grid = sc.Grid(26, 16, D, D, 9, 1.2 * D)
    gap = sc.surfaces.paraboloid(grid, 5e-3)
    simulation = sc.Simulation(grid, BALL, body2, gap, friction, **settings)
    loads = np.linspace(LOAD / (3 * parts), LOAD, 3 * parts)
    travel = tuple(D * cells / parts for cells in advance)
    path = [{"load": load} for load in loads]
    path += 3 * parts * [{"load": LOAD, "advance": travel}]
    path += [{"load": load} for load in [*loads[-2::-1], 0.0]]
    return sc.energy.balance(simulation, simulation.run(path, progress=False))


def test_a_wavy_surface_slides_without_friction_and_without_loss():
    """The work that moves the waves is stored in the bodies, and recovered over each period."""
    lost = []
    for n in (12, 24):
        grid = sc.Grid(n, n, 320e-6 / n, 320e-6 / n, periodic="xy")
        along, across = (np.cos(2 * np.pi * x / 320e-6) for x in (grid.x, grid.y))
        wave = sc.Relief(1e-6 * np.outer(along, across))
        gap = np.outer(1e-6 * (1 - along), np.ones(n))
        simulation = sc.Simulation(grid, BALL, BALL, gap, 0.0, relief2=wave)
        states = [simulation.step(load=load) for load in (10.0, 20.0, 30.0)]
        states += [simulation.step(load=30.0, advance=(0.0, -grid.dx)) for _ in range(n // 4)]
        found = sc.energy.balance(simulation, states[2:])
        assert abs(found.elastic_energy / found.work_input - 1) > 0.02
        assert found.net_external_work > 0
        lost.append(abs(found.imbalance))
    assert lost[1] < 0.5 * lost[0] < 0.02


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.parametrize(
    ("advance", "friction"), [((-1.0, -1.0), 0.0), ((0.0, -1.0), 0.2)], ids=["rolls", "slides"]
)
def test_work_of_travel_is_plastic_work(advance, friction):
    """Rolling and sliding do work on the plastic flow and on the residual stress."""
    found = moved(advance=advance, friction=friction)
    inelastic = found.plastic_work + found.residual_energy
    assert found.elastic_energy == 0
    assert found.plastic_work > 1e-6
    assert (friction == 0) == (found.friction_work == 0)
    remaining = found.net_external_work - found.friction_work
    assert remaining == pytest.approx(inelastic, rel=0.03)


def test_friction_work_of_full_sliding_is_that_of_partial_slip():
    """The friction work is that of the slip of each cell, if all cells slide."""
    works = []
    for friction in (0.2, sc.Coulomb(0.2)):
        grid = sc.Grid(20, 18, D, D)
        gap = sc.surfaces.paraboloid(grid, 5e-3)
        simulation = sc.Simulation(grid, BALL, BALL, gap, friction)
        states = [simulation.step(load=60.0, advance=(0.0, -3 * D)) for _ in range(4)]
        found = sc.energy.balance(simulation, states)
        done = states[0].friction_work if isinstance(friction, sc.Coulomb) else 0.0
        works.append(found.friction_work - done)
        assert abs(found.imbalance) < 2e-3
    assert works[0] == pytest.approx(works[1], rel=2e-3)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_the_balance_of_softening_bodies_closes_with_the_increments():
    """The yield stress that does the plastic work decreases with the temperature."""
    law = sc.softening.JohnsonCook(melting=500.0, m=1.0)
    hard = STEEL.with_kinematic_hardening(5e9).with_thermal(50.0, 12e-6, 14e-6)
    heat = sc.Heat(factor=0.1, velocity=(-1.0, 0.0))
    grid = sc.Grid(18, 16, D, D, 18, 0.6 * D)
    lost = []
    for increments in (2, 4):
        gap = sc.surfaces.paraboloid(grid, 5e-3)
        simulation = sc.Simulation(grid, BALL, hard.with_softening(law), gap, 0.0, heat=heat)
        path = sc.paths.load_unload(load=LOAD, increments=increments)
        states = simulation.run(path, progress=False)
        found = sc.energy.balance(simulation, states)
        cold = sc.energy.plastic_work(hard, states[-1].track(margin=0))
        assert found.plastic_work < 0.95 * cold
        lost.append(abs(found.imbalance))
    assert lost[1] < 0.5 * lost[0] < 0.01


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_softening_bodies_that_slide_through_their_heat():
    law = sc.softening.JohnsonCook(melting=700.0, m=1.0)
    soft = STEEL.with_thermal(50.0, 12e-6, 14e-6).with_softening(law)
    found = moved(soft, heat=sc.Heat(factor=0.1, velocity=(-1.0, 0.0)))
    inelastic = found.plastic_work + found.residual_energy
    remaining = found.net_external_work + found.expansion_work - found.friction_work
    assert found.expansion_work > 0.04 * inelastic
    assert remaining == pytest.approx(inelastic, rel=0.03)


def test_friction_that_drives_the_sliding_is_refused():
    grid = sc.Grid(8, 8, D, D)
    simulation = sc.Simulation(grid, BALL, BALL, sc.surfaces.paraboloid(grid, 5e-3), 0.2)
    states = [simulation.step(load=5.0), simulation.step(load=5.0, advance=(0.0, D))]
    with pytest.raises(ValueError, match="friction must oppose the sliding"):
        sc.energy.balance(simulation, states)


def reversed_slip(parts, body=BALL, last=LOAD):
    """Return the balance of a contact that slides forwards, backwards and forwards again."""
    grid = sc.Grid(24, 24, D, D)
    gap = sc.surfaces.paraboloid(grid, 5e-3)
    simulation = sc.Simulation(grid, BALL, body, gap, friction=sc.Coulomb(0.2))
    states = [simulation.step(load=LOAD), simulation.step(load=LOAD, shift=(3e-6, 0.0))]
    for way, load in ((-6e-6, last), (6e-6, LOAD)):
        for now in np.linspace(states[-1].load, load, parts + 1)[1:]:
            states.append(simulation.step(load=now, shift=(way / parts, 0.0)))
    return sc.energy.balance(simulation, states)


@pytest.mark.parametrize("body", [BALL, sc.Material.elastic(70e9, 0.2)], ids=["alike", "unlike"])
def test_slip_reverses_in_few_increments(body):
    """The work is that of fine increments, and the balance of stored and lost energy closes."""
    fine = reversed_slip(40, body)
    assert abs(fine.imbalance) < 1.5e-3
    for parts, tol in ((1, 3e-3), (2, 3e-3), (10, 5e-3)):
        found = reversed_slip(parts, body)
        assert abs(found.imbalance) < tol
        assert found.net_external_work == pytest.approx(fine.net_external_work, rel=tol)
        assert found.friction_work == pytest.approx(fine.friction_work, rel=3e-3)


def test_slip_reverses_while_the_load_changes():
    """The friction limit follows the load, and the balance closes with the increments."""
    missed = [abs(reversed_slip(parts, last=2 * LOAD).imbalance) for parts in (1, 2, 4, 8, 16)]
    assert max(missed) < 0.015
    assert missed[4] < 0.35 * missed[3] < 0.35**2 * missed[2]

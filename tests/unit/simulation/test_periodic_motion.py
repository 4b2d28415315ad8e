# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that move through the contact along a periodic direction."""

import numpy as np
import pytest

import samcontact as sc
from samcontact.cases import CaseError, load_case

CELL, ROWS, RADIUS = 1e-6, 16, 1e-4
CERAMIC = sc.Material.elastic(300e9, 0.2)
STEEL = sc.Material.linear_hardening(210e9, 0.3, 1e9, 20e9).with_kinematic_hardening(10e9)
SOFT = sc.Material.linear_hardening(180e9, 0.3, 0.8e9, 20e9)
LOAD = 8e-3
"""Load on a row of cells: maximum Hertz pressure 1.7 GPa, contact of 6 cells [N]."""
PERIOD = ROWS * CELL


def waves(rows=ROWS):
    """Roughness that repeats after 16 rows [m]."""
    angle = 2 * np.pi * np.arange(rows)[:, None] / ROWS
    return 1e-8 * (np.cos(angle + 0.3) + 0.5 * np.sin(3 * angle))


def roller(body1, body2, friction=0.0, shift=0, relief=None, **settings):
    """Smooth cylinder above a rough half-space in plane strain, moved by some cells."""
    grid = sc.Grid(ROWS, 1, CELL, CELL, dz=CELL, periodic="xy")
    gap = np.roll(sc.surfaces.cylinder(grid, RADIUS), shift, 0)
    relief = relief or sc.Relief(waves(), first=shift, periodic=True)
    settings = {"on_border": "warn", "tol": 1e-11} | settings
    return sc.Simulation(grid, body1, body2, gap, friction, relief2=relief, **settings)


def roll(simulation, first, second, steps):
    """Press, and move both bodies by some cells per increment; return all states."""
    simulation.step(load=LOAD)
    advance = (first * CELL, second * CELL)
    return [simulation.step(load=LOAD, advance=advance) for _ in range(steps)]


def assert_equal(found, expected, tol):
    np.testing.assert_allclose(found, expected, rtol=0, atol=tol * np.abs(expected).max())


@pytest.mark.parametrize("friction", [0.2, sc.Coulomb(0.3)])
def test_a_period_of_travel_changes_nothing_on_elastic_bodies(friction):
    states = roll(roller(CERAMIC, CERAMIC, friction), -4, -4, 8)
    assert np.abs(states[3].pressure - states[2].pressure).max() > 0.1 * states[3].pressure.max()
    for one, other in zip(states[:4], states[4:], strict=True):
        for name in ("pressure", "gap", "shear"):
            assert_equal(getattr(other, name), getattr(one, name), 1e-12)
    assert states[-1].travel == pytest.approx((-2 * PERIOD, -2 * PERIOD))


@pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")
def test_laps_approach_shakedown():
    states = roll(roller(CERAMIC, STEEL), -4, -4, 32)
    changes = []
    for lap in (1, 3, 7):
        now, before = (states[4 * n + 3].plastic_strain(2) for n in (lap, lap - 1))
        changes.append(np.abs(now - before).max() / np.abs(now).max())
    assert changes[0] > 1e-2
    assert changes[1] < 1e-2 * changes[0]
    assert changes[2] < 1e-10


@pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")
@pytest.mark.parametrize(
    ("bodies", "friction", "cells"),
    [
        ((SOFT, STEEL), 0.2, (-2.4, -1.7)),  # offset between the cells of two plastic bodies
        ((SOFT, STEEL), sc.Coulomb(0.3), (-2.3, -2.2)),
        ((CERAMIC, CERAMIC), sc.Coulomb(0.3), (1.6, 2.3)),
    ],
)
def test_a_contact_may_start_at_any_cell(bodies, friction, cells):
    shift = 9  # the contact lies across the ends of the grid
    one, other = (roll(roller(*bodies, friction, n), *cells, 3)[-1] for n in (0, shift))
    fields = [[s.pressure, s.gap, s.shear[0]] for s in (one, other)]
    for body, material in enumerate(bodies, 1):
        if not material.is_plastic:
            continue
        assert one.equivalent_plastic_strain(body).max() > 1e-4
        for state, of in zip((one, other), fields, strict=True):
            of.append(state.residual_displacement(body))
            of.append(state.equivalent_plastic_strain(body))
            of.extend(state.residual_stress(body)[[0, 1, 2, 4]])
    for before, after in zip(*fields, strict=True):
        assert_equal(after, np.roll(before, shift, 0), 1e-10)


def test_a_relief_repeats_with_the_grid():
    """Rows that repeat, a part of the period that is flat elsewhere, and the whole period."""
    dent = np.zeros((ROWS, 1))
    dent[[15, 0, 1]] = -1e-8
    for given, whole in (
        (sc.Relief(waves(1), periodic=True), np.broadcast_to(waves(1), (ROWS, 1))),
        (sc.Relief(dent[[15, 0, 1]], first=-1), dent),
    ):
        found, expected = (
            roll(roller(CERAMIC, CERAMIC, relief=r), 0, 5, 2)[-1].pressure
            for r in (given, sc.Relief(whole, periodic=True))
        )
        np.testing.assert_array_equal(found, expected)
    with pytest.raises(ValueError, match=r"relief2 repeats every 7 rows, which must divide grid"):
        roller(CERAMIC, CERAMIC, relief=sc.Relief(waves(7), periodic=True))
    with pytest.raises(ValueError, match=r"relief2 must have at most grid\.nx = 16 rows"):
        roller(CERAMIC, CERAMIC, relief=sc.Relief(waves(17)))


def test_a_checkpoint_and_a_track_of_a_periodic_body(tmp_path):
    simulation = roller(CERAMIC, STEEL, shift=7)
    roll(simulation, -3, -3, 4)
    simulation.save(tmp_path / "c.h5")
    again = sc.Simulation.load(tmp_path / "c.h5")
    move = {"load": LOAD, "advance": (-5 * CELL, -5 * CELL)}
    state, restored = simulation.step(**move), again.step(**move)
    for name in ("pressure", "gap"):
        assert_equal(getattr(restored, name), getattr(state, name), 1e-14)
    track = state.track(2)
    assert track.grid.surface_shape == state.grid.surface_shape
    # The body has moved by 17 cells, one period and one cell.
    np.testing.assert_array_equal(track.x, state.grid.x)
    assert track.contact == pytest.approx(CELL)
    for name, axis in (("plastic_strain", 1), ("residual_stress", 1), ("residual_displacement", 0)):
        expected = np.roll(getattr(state, name)(2), 1, axis)
        assert_equal(getattr(track, name)(), expected, 1e-12)


def test_an_eigenstrain_moves_through_the_ends_of_the_period():
    def pressed(first):
        simulation = roller(CERAMIC, STEEL, relief=sc.Relief(np.zeros((1, 1)), periodic=True))
        strain = np.zeros((6, 4, 1, 2))
        strain[2] = 2e-3
        simulation.add_eigenstrain(2, strain, first=(first, 0, 0))
        return simulation

    moved = pressed(11).step(load=LOAD, advance=(0.0, 9 * CELL))
    at_once = pressed(4).step(load=LOAD)
    assert_equal(moved.pressure, at_once.pressure, 1e-10)
    assert_equal(moved.eigenstress(2), at_once.eigenstress(2), 1e-12)


@pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")
def test_a_body_below_a_fixed_pressure_is_as_a_pressure_that_passes():
    """Two laps, in which either the body or the pressure moves."""
    grid = sc.Grid(24, 1, CELL, CELL, dz=CELL, periodic="xy")
    pressure = sc.hertz.line(RADIUS, 1.2e11, p0=2e9).pressure(grid.x)[:, None]
    passing, moving = (
        sc.Simulation(grid, CERAMIC, STEEL, np.zeros((24, 1)), 0.2, tol=1e-9) for _ in range(2)
    )
    for number, step in enumerate(2 * sc.shakedown.passes(grid, pressure, cells=6)):
        passing.step(**step)
        moving.step(pressure=pressure, advance=(0.0, -6 * CELL if number else 0.0))
    for name in ("plastic_strain", "residual_stress", "residual_displacement"):
        found, expected = (getattr(s.state.track(2), name)() for s in (moving, passing))
        assert np.abs(expected).max() > 0
        assert_equal(found, expected, 1e-7)


def test_a_lap_is_a_closed_cycle_of_shakedown():
    lap = [{"load": LOAD, "advance": (-4 * CELL, -4 * CELL)}] * 4
    result = sc.shakedown.run(roller(CERAMIC, STEEL, tol=1e-8), lap, progress=False)
    assert result.response == "elastic shakedown"
    assert result.state.travel[1] == pytest.approx(-len(result.cycles) * PERIOD)
    with pytest.raises(ValueError, match="cycle must move both bodies back"):
        sc.shakedown.run(roller(CERAMIC, STEEL), lap[1:], progress=False)


CASE = """
title = "A rough roller in plane strain"
grid = {nx = 16, ny = 1, dx = 1e-6, dy = 1e-6, dz = 1e-6, periodic = "xy"}
body1 = {law = "elastic", E = 300e9, nu = 0.2}
body2 = {law = "linear_hardening", E = 18e10, nu = 0.3, yield_stress = 8e8, tangent_modulus = 2e10}
surface = {shape = "cylinder", R = 1e-4}
relief2 = {kind = "self_affine", rms_height = 2e-9, hurst = 0.8, seed = 3}
contact = {on_border = "warn"}
path = [{load = 8e-3, increments = 2, advance = [-16e-6, -16e-6]}]
shakedown = {cycles = 20}
"""


@pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")
def test_a_case_file_with_a_lap(tmp_path):
    file = tmp_path / "lap.toml"
    file.write_text(CASE, encoding="utf-8")
    simulation, path = load_case(file).build()
    states = simulation.run(path, progress=False)
    heights = sc.surfaces.rough_self_affine(simulation.grid, 2e-9, 0.8, seed=3)
    relief = sc.Relief(heights, periodic=True)
    same = roller(CERAMIC, SOFT, relief=relief, tol=simulation.tol)
    for state, step in zip(states, path, strict=True):
        np.testing.assert_array_equal(state.pressure, same.step(**step).pressure)
    file.write_text(CASE.replace("-16e-6]", "-15e-6]"), encoding="utf-8")
    with pytest.raises(CaseError, match="shakedown requires a closed path"):
        load_case(file)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_a_lap_is_a_closed_cycle_of_wear():
    grid = sc.Grid(ROWS, 1, CELL, CELL, dz=CELL, periodic="xy")
    step = {"load": 1.2 * LOAD, "advance": (0.0, -8 * CELL)}
    worn = []
    for shift in (0, 9):
        result = sc.wear.run(
            grid,
            CERAMIC,
            STEEL,
            np.roll(sc.surfaces.cylinder(grid, RADIUS), shift, 0),
            cycle=[step, step, {"load": 0.0}],
            threshold=3e-4,
            cycles=1,
            window=(5, 1),
            friction=0.3,
            relief2=sc.Relief(waves(), first=shift, periodic=True),
            on_border="warn",
            progress=False,
        )
        worn.append(result.heights[2])
    assert worn[0].shape == (2, ROWS, 1)
    assert np.ptp(worn[0][-1] - worn[0][0]) > 1e-6
    np.testing.assert_allclose(worn[1], np.roll(worn[0], 9, 1), rtol=0, atol=1e-14)


@pytest.mark.slow
def test_far_apart_periods_are_as_one_contact():
    """The other balls of a row act with the square of their inverse distance."""
    radius, load = 1e-4, 0.25  # contact radius 5.4e-6 m
    states = []
    for rows, periodic in ((24, ""), (24, "x"), (48, "x"), (96, "x")):
        grid = sc.Grid(rows, 12, 2e-6, 2e-6, 6, 2e-6, periodic=periodic)
        ball = sc.Simulation(grid, CERAMIC, STEEL, sc.surfaces.paraboloid(grid, radius))
        ball.step(load=load)
        for _ in range(4):
            state = ball.step(load=load, advance=(-2e-6, -2e-6))
        middle = slice((rows - 24) // 2, (rows + 24) // 2)
        states.append([state.pressure[middle], state.equivalent_plastic_strain(2)[middle]])
    for alone, *repeated in zip(*states, strict=True):
        off = [np.abs(field - alone).max() / alone.max() for field in repeated]
        assert off[0] < 0.02
        assert off[1] < 0.4 * off[0]
        assert off[2] < 0.3 * off[1]

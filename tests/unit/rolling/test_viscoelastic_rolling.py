# SPDX-License-Identifier: GPL-3.0-or-later
"""Rolling of viscoelastic bodies against digits of CONTACT and a dense solution."""

import numpy as np
import pytest

import samcontact as sc
from moving_bodies import RUBBER, displaced_by_creep

G, NU, RADIUS, LOAD = 1143e6, 0.4, 0.05, 6e5
GLASS = sc.Material.elastic(2 * G * (1 + NU), NU)
GRID = sc.Grid(99, 1, 0.16e-3, 1.0)
MIDDLE = -0.08e-3
"""Centre of the rollers: the first cell of CONTACT is at -7.92 mm."""
GAP = (GRID.x - MIDDLE)[:, None] ** 2 / (2 * RADIUS)


def polymer(creep_time):
    """Return the material of CONTACT, whose creep share FG is 1."""
    return GLASS.with_relaxation(times=[creep_time / 2], shares=[0.5])


def rolled(body, speed, **more):
    return sc.rolling.steady(
        GRID, body, body, GAP, load=LOAD, friction=0.0, speed=speed, on_border="warn", **more
    )


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.parametrize(
    ("creep_time", "speed", "pressure", "cells", "approach", "ahead"),
    [
        (0.009, 0.0, 60.315, 80, 2.50845, 0.0),
        (0.009, 1.0, 78.740, 62, 2.36736, 1.222),
        (0.045, 1.0, 84.716, 57, 2.06321, 0.595),
        (2.0, 1.0, 85.299, 56, 1.45462, 0.02825),
        (2.0, 1e9, 85.289, 56, 1.32370, 0.0),
    ],
)
def test_rollers_of_contact(creep_time, speed, pressure, cells, approach, ahead):
    """visc_cylindr of CONTACT, in MPa and mm: cells and approaches are those that CONTACT prints.

    CONTACT prints pressures with two digits (85.31 in the fourth case); those with three digits,
    and `ahead`, are from a dense solution with the track on the grid.
    """
    found = rolled(polymer(creep_time), speed)
    assert found.pressure.max() / 1e6 == pytest.approx(pressure, abs=6e-4)
    assert np.count_nonzero(found.pressure) == cells
    assert found.approach * 1e3 == pytest.approx(approach, abs=1e-4)
    resistance = found.rolling_resistance - MIDDLE * LOAD
    assert resistance / LOAD * 1e3 == pytest.approx(ahead, abs=1e-3)


def test_two_bodies_on_a_grid_with_the_track():
    """One body is stiff and elastic; the other moves its creep through a contact in 3-D."""
    grid = sc.Grid(20, 12, 1e-3, 1e-3)
    gap = sc.surfaces.paraboloid(grid, 0.1)
    glass = sc.Material.elastic(3e7, 0.3)
    found = sc.rolling.steady(grid, glass, RUBBER, gap, load=0.3, friction=0.0, speed=0.05)
    zero = sc.ContactSolver(grid, sc.Material.rigid(), glass)
    u = displaced_by_creep(found, RUBBER, 0.05) + zero.displacement(found.pressure)[2]
    assert np.ptp(found.gap - gap - u) < 1e-6 * np.abs(u).max()
    assert found.rolling_resistance > 0


def test_equal_bodies_share_the_displacement():
    """Two equal rollers are one of half the modulus on a rigid plane."""
    grid = sc.Grid(24, 16, 1e-3, 1e-3)
    gap = sc.surfaces.paraboloid(grid, 0.1)
    half = sc.Material.elastic(RUBBER.E / 2, RUBBER.nu).with_relaxation(*RUBBER.relaxation_terms)
    given = {"gap": gap, "load": 0.5, "friction": 0.0, "speed": 0.05}
    both = sc.rolling.steady(grid, RUBBER, RUBBER, **given)
    one = sc.rolling.steady(grid, sc.Material.rigid(), half, **given)
    assert np.abs(both.pressure - one.pressure).max() < 1e-6 * one.pressure.max()
    again = sc.rolling.steady(grid, RUBBER, RUBBER, **given, start=both)
    assert again.iterations < both.iterations


@pytest.mark.parametrize(
    ("change", "error", "text"),
    [
        ({"speed": None}, ValueError, "speed must be given"),
        ({"speed": -1.0}, ValueError, "speed must be >= 0"),
        ({"creepage": (1e-3, 0.0)}, ValueError, "creepage must be None"),
        (
            {"body2": GLASS, "body1": GLASS, "friction": sc.Coulomb(0.3)},
            ValueError,
            "speed has no effect",
        ),
        ({"body2": RUBBER.with_relaxation([1.0], [1.0])}, ValueError, "body2 must be a solid"),
        ({"body1": GLASS.with_free_faces(-1.0, 1.0)}, ValueError, "ends of bodies"),
    ],
)
def test_bad_input(change, error, text):
    grid = sc.Grid(8, 8, 1e-3, 1e-3)
    arguments = {
        "grid": grid, "body1": RUBBER, "body2": RUBBER, "load": 0.5, "friction": 0.0, "speed": 0.05,
        "gap": sc.surfaces.paraboloid(grid, 0.1),
    } | change  # fmt: skip
    with pytest.raises(error, match=text):
        sc.rolling.steady(**arguments)

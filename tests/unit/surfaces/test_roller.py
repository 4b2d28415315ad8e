# SPDX-License-Identifier: GPL-3.0-or-later
"""Rollers of finite length: profiles at known points, ends, tilt, skew, and their pressure."""

import math
import warnings

import numpy as np
import pytest

import samcontact as sc
from core_fakes import make_grid
from samcontact import surfaces

R, L = 5e-3, 10e-3
STEEL = sc.Material.elastic(210e9, 0.3)


@pytest.fixture
def grid():
    return make_grid(nx=9, ny=25, dx=50e-6, dy=0.5e-3)  # y from -6 to 6 mm


def drop(grid, *args, **named):
    return surfaces.roller(grid, R, L, *args, **named)[grid.nx // 2]


def test_straight_roller_is_a_cylinder_with_ends(grid):
    gap = surfaces.roller(grid, R, L)
    inside = np.abs(grid.y) <= L / 2 + 1e-12
    assert np.isinf(gap[:, ~inside]).all()
    assert np.array_equal(gap[:, inside], surfaces.paraboloid(grid, R, math.inf)[:, inside])


def test_logarithmic_profile_of_the_standard(grid):
    at = drop(grid, "logarithmic")
    y = np.argmin(abs(grid.y - 4e-3))
    assert at[y] == pytest.approx(0.00035 * 10e-3 * math.log(1 / (1 - 0.8**2)), rel=1e-12)
    assert np.isinf(at[np.argmin(abs(grid.y - 5e-3))])  # at the end face
    assert drop(grid, "logarithmic", diameter=20e-3)[y] == pytest.approx(2 * at[y])
    # longer than 2.5 D: straight in the middle, 0.0005 D at the ends
    thin = drop(grid, "logarithmic", diameter=2e-3)
    assert (thin[np.abs(grid.y) <= 2.5e-3] == 0.0).all()
    assert thin[y] == pytest.approx(1e-6 * math.log(1 / (1 - 0.6**2)), rel=1e-12)


def test_other_profiles(grid):
    y = np.argmin(abs(grid.y - 4e-3))
    assert drop(grid, "crowned", crown_radius=2.0)[y] == pytest.approx(4e-6)
    partly = drop(grid, "crowned", crown_radius=2.0, straight_length=6e-3)
    assert partly[y] == pytest.approx(0.25e-6)
    lundberg = drop(grid, "lundberg", design_load=12e3, E_star=115e9)
    assert lundberg[y] == pytest.approx(
        12e3 / (math.pi * 115e9 * L) * math.log(1 / (1 - 0.8**2)), rel=1e-12
    )
    # a table that samples the crown, symmetric or not
    points = np.linspace(0.0, L / 2, 41)
    half = drop(grid, (points, points**2 / 4.0))
    both = np.concatenate([-points[:0:-1], points])
    np.testing.assert_allclose(half, drop(grid, (both, both**2 / 4.0)), rtol=1e-12)
    assert half[y] == pytest.approx(4e-6, rel=1e-3)
    # monotone between points, without overshoot
    step = drop(grid, ([0.0, 3e-3, 4e-3, 5e-3], [0.0, 0.0, 1e-6, 1e-6]))
    assert step[np.isfinite(step)].min() == 0.0
    assert step[np.isfinite(step)].max() == 1e-6


def test_tilt_and_skew_are_rotations(grid):
    tilted = surfaces.roller(grid, R, L, "logarithmic", tilt=1e-3)
    assert np.array_equal(tilted[:, ::-1], surfaces.roller(grid, R, L, "logarithmic", tilt=-1e-3))
    y = np.argmin(abs(grid.y - 4e-3))
    assert tilted[4, y] == pytest.approx(drop(grid, "logarithmic")[y] - 4e-6, rel=1e-12)
    # two equal cylinders crossed at the angle s: curvatures (1 +- cos s)/R (Johnson 1985, 4.1)
    square = make_grid(nx=21, ny=21, dx=50e-6, dy=50e-6)
    s = 0.08
    gap = surfaces.roller(square, R, L, race_radius=R, skew=s)
    xx = (gap[11, 10] + gap[9, 10] - 2 * gap[10, 10]) / square.dx**2
    yy = (gap[10, 11] + gap[10, 9] - 2 * gap[10, 10]) / square.dy**2
    xy = (gap[11, 11] + gap[9, 9] - gap[11, 9] - gap[9, 11]) / (4 * square.dx * square.dy)
    found = np.linalg.eigvalsh([[xx, xy], [xy, yy]])
    np.testing.assert_allclose(found, [(1 - math.cos(s)) / R, (1 + math.cos(s)) / R], rtol=1e-9)


def pressed(cells, tilt=0.0, **profile):
    """Pressure of a roller of 10 mm x 10 mm under 15 kN on an inner race, and its grid."""
    E_star = sc.hertz.effective_modulus(STEEL, STEEL)
    b = sc.hertz.line(4e-3, E_star, 15e3 / L).b
    grid = sc.Grid(17, cells, b / 5, L / cells)
    gap = surfaces.roller(grid, R, L, race_radius=20e-3, tilt=tilt, **profile)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solution = sc.ContactSolver(grid, STEEL, STEEL).solve(gap - gap.min(), load=15e3)
    return solution.pressure, grid


@pytest.mark.parametrize(
    ("profile", "largest"),
    [
        ({"profile": "logarithmic"}, (4.75e9, 5.98e9)),
        (
            {"profile": "lundberg", "design_load": 12e3, "E_star": 115.385e9},
            (4.97e9, 6.29e9),
        ),
    ],
)
def test_end_pressure_does_not_depend_on_the_cells(profile, largest):
    for tilt, known in zip((0.0, 1e-3), largest, strict=True):
        found = [pressed(cells, tilt, **profile)[0].max() for cells in (801, 1201)]
        np.testing.assert_allclose(found, known, rtol=0.02)
    pressure, grid = pressed(801, 1e-3, **profile)
    assert pressure[8, 400] == pytest.approx(3.7e9, rel=0.01)  # Hertz: 3.71 GPa
    # the tilt moves the pressure towards y > 0; the mirrored tilt mirrors it
    assert (pressure * grid.y).sum() > 0
    mirrored = pressed(801, -1e-3, **profile)[0]
    np.testing.assert_allclose(mirrored[:, ::-1], pressure, atol=1e-4 * pressure.max())


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"profile": "round"}, "profile must be one of 'straight', 'crowned', 'logarithmic', 'lun"),
        ({"profile": "crowned"}, "crown_radius is required"),
        ({"crown_radius": 1.0}, 'crown_radius belongs to profile = "crowned"'),
        ({"profile": "lundberg", "design_load": 1.0}, "E_star is required"),
        ({"tilt": 0.5}, "tilt must be between -0.1 and 0.1 rad, got 0.5"),
        ({"race_radius": -4e-3}, "race_radius must be > 0 .*concave"),
        ({"profile": ([0.0, 4e-3], [0.0, 1e-6])}, "profile must cover y from 0.0 to 0.005 m"),
        ({"profile": ([0.0, 0.0], [0.0, 1e-6])}, "positions y that increase"),
        ({"profile": ([0.0],)}, "or a table .y, drop."),
        ({"profile": "crowned", "crown_radius": 1.0, "straight_length": 1.0}, "straight_length"),
    ],
)
def test_bad_input_is_named(grid, given, message):
    with pytest.raises(ValueError, match=message):
        surfaces.roller(grid, R, L, **given)


def test_a_roller_between_cell_centres_is_refused():
    with pytest.raises(ValueError, match="length must be larger than a cell"):
        surfaces.roller(make_grid(nx=4, ny=4, dx=1e-3, dy=1e-3), R, 0.1e-3)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts under a load and moments about x and y."""

import numpy as np
import pytest
from scipy import optimize

import samcontact as sc

STEEL = sc.Material.elastic(E=210e9, nu=0.3)
SOFT = sc.Material.elastic(E=70e9, nu=0.2)
RIGID = sc.Material.rigid()
E_STAR = 210e9 / (1 - 0.3**2) / 2
GRID = sc.Grid(48, 40, 20e-6, 20e-6)
WAVES = 0.2e-6 * np.cos(GRID.x[:, None] * 2e4) * np.sin(GRID.y * 1.7e4 + 1.0)
WAVY_GAP = sc.surfaces.paraboloid(GRID, 20e-3, 10e-3) + WAVES
LOAD = 40.0
MOMENT = LOAD * 60e-6, -LOAD * 40e-6


def solver(grid=GRID, body1=STEEL, body2=STEEL, friction=0.0, **options):
    return sc.ContactSolver(grid, body1, body2, friction, tol=1e-11, **options)


def moments(solution, grid=GRID):
    about_x = float((solution.pressure * grid.y).sum()) * grid.cell_area
    about_y = -float((solution.pressure * grid.x[:, None]).sum()) * grid.cell_area
    return np.array([about_x, about_y])


def test_a_moment_on_a_paraboloid_moves_the_contact():
    # A paraboloid is its own image under a tilt that moves its lowest point: here by whole cells.
    radii, cells = (12e-3, 8e-3), (5, -3)
    gap = sc.surfaces.paraboloid(GRID, *radii)
    centred = solver().solve(gap, load=LOAD)
    x, y = cells[0] * GRID.dx, cells[1] * GRID.dy
    moved = solver().solve(gap, load=LOAD, moment=(LOAD * y, -LOAD * x))
    assert moved.tilt == pytest.approx([y / radii[1], -x / radii[0]], rel=1e-9)
    lower = x**2 / (2 * radii[0]) + y**2 / (2 * radii[1])
    assert moved.approach == pytest.approx(centred.approach - lower, rel=1e-9)
    expected = np.roll(centred.pressure, cells, (0, 1))
    np.testing.assert_allclose(moved.pressure, expected, atol=1e-8 * expected.max())
    assert moments(moved) == pytest.approx([LOAD * y, -LOAD * x], rel=1e-12)
    assert moved.iterations <= 1.2 * centred.iterations


@pytest.mark.parametrize(
    "given",
    [
        {},
        {"friction": 0.4, "body2": SOFT},
        {"friction": sc.Coulomb(0.3), "body2": SOFT},
        {"adhesion": sc.TensileLimit(5e6)},
        {"body2": sc.Layered([(SOFT, 40e-6)], STEEL)},
    ],
    ids=["elastic", "sliding", "partial slip", "tensile limit", "layered"],
)
def test_a_moment_gives_the_tilt_that_has_this_moment(given):
    contact = solver(**given)
    driven = contact.solve(WAVY_GAP, load=LOAD, moment=MOMENT)
    assert driven.moment == pytest.approx(MOMENT, rel=1e-12)
    assert moments(driven) == pytest.approx(MOMENT, rel=1e-10)
    held = contact.solve(WAVY_GAP, load=LOAD, tilt=driven.tilt)
    assert held.moment == pytest.approx(MOMENT, rel=1e-8)
    assert held.approach == pytest.approx(driven.approach, rel=1e-9)
    largest = held.pressure.max()
    np.testing.assert_allclose(driven.pressure, held.pressure, atol=1e-7 * largest)
    # One axis by its moment, the other by its tilt.
    mixed = contact.solve(WAVY_GAP, load=LOAD, moment=(MOMENT[0], None), tilt=(None, held.tilt[1]))
    assert mixed.tilt == pytest.approx(held.tilt, rel=1e-8)
    assert mixed.moment == pytest.approx(MOMENT, rel=1e-7)


def test_the_tilt_agrees_with_newton_on_held_tilts():
    def missing(tilt):
        found = solver().solve(WAVY_GAP, load=LOAD, tilt=tilt * 1e-3).moment
        return (found - MOMENT) / np.abs(MOMENT)

    root = optimize.root(missing, [0.0, 0.0], tol=1e-12)
    driven = solver().solve(WAVY_GAP, load=LOAD, moment=MOMENT)
    assert driven.tilt == pytest.approx(root.x * 1e-3, rel=1e-8)


def test_swapped_axes_mirror_the_solution():
    swapped = sc.Grid(GRID.ny, GRID.nx, GRID.dy, GRID.dx)
    one = solver().solve(WAVY_GAP, load=LOAD, moment=MOMENT)
    other = solver(swapped).solve(WAVY_GAP.T, load=LOAD, moment=(-MOMENT[1], -MOMENT[0]))
    assert other.tilt == pytest.approx(-one.tilt[::-1], rel=1e-9)
    largest = one.pressure.max()
    np.testing.assert_allclose(other.pressure.T, one.pressure, atol=1e-9 * largest)


def punch(grid, radius):
    gap = np.where(np.hypot(grid.x[:, None], grid.y) < radius, 0.0, np.inf)
    return gap, np.sqrt(np.isfinite(gap).sum() * grid.cell_area / np.pi)


@pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")
def test_a_round_punch_tilts_until_it_lifts_and_falls_over_at_its_edge():
    grid = sc.Grid(72, 72, 1e-6, 1e-6)
    gap, radius = punch(grid, 32e-6)
    contact = solver(grid, RIGID, STEEL)
    # In full contact, tilt = 3 M/(4 E* a^3) (Johnson 1985, section 5.2, for a rigid punch).
    stiff, load = 210e9 / (1 - 0.3**2), 1e-3
    moment = 0.2 * load * radius
    full = contact.solve(gap, load=load, moment=(moment, 0.0))
    # the cells at the edge make the punch about half a cell larger
    assert full.tilt[0] == pytest.approx(3 * moment / (4 * stiff * radius**3), rel=0.03)
    assert abs(full.tilt[1]) < 1e-9 * full.tilt[0]
    most = load * radius
    lifted = contact.solve(gap, load=load, moment=(0.0, -0.8 * most))
    assert moments(lifted, grid) == pytest.approx([0, -0.8 * most], abs=1e-10 * most)
    assert lifted.gap[:8][np.isfinite(gap[:8])].min() > 0
    with pytest.raises(ValueError, match="moment is too large for the load"):
        contact.solve(gap, load=load, moment=(0.75 * most, 0.75 * most))


def test_moments_that_are_not_possible_are_refused():
    gap = sc.surfaces.paraboloid(GRID, 10e-3)
    for given, text in [
        ({"approach": 1e-6, "moment": (1e-3, 0.0)}, "moment cannot be combined with approach"),
        ({"load": 1.0, "moment": (1e-3, None), "tilt": (1e-3, 0.0)}, "cannot both be given"),
        ({"load": 0.0, "moment": (1e-3, 0.0)}, "moment must be 0 N m without load"),
        ({"load": 1.0, "moment": (np.nan, 0.0)}, "moment about x"),
        ({"load": 1.0, "tilt": 1e-3}, "two numbers, about x and y"),
    ]:
        with pytest.raises((ValueError, TypeError), match=text):
            solver().solve(gap, **given)
    unloaded = solver().solve(gap, load=0.0, moment=(0.0, 0.0))
    assert (unloaded.load, *unloaded.tilt) == (0.0, 0.0, 0.0)


def test_a_periodic_surface_tilts_only_along_its_free_direction():
    grid = sc.Grid(64, 2, 10e-6, 10e-6, periodic="y")
    gap = sc.surfaces.paraboloid(grid, 10e-3, np.inf)
    load, x = 1e5 * 20e-6, 50e-6
    found = solver(grid).solve(gap, load=load, moment=(None, -load * x))
    assert found.tilt == pytest.approx([0, -x / 10e-3], rel=1e-9)
    with pytest.raises(ValueError, match="periodic along y"):
        solver(grid).solve(gap, load=load, moment=(0.0, -load * x))
    with pytest.raises(ValueError, match="periodic along y"):
        solver(grid).solve(gap, load=load, tilt=(1e-4, 0.0))


@pytest.mark.slow
@pytest.mark.parametrize("roughness", [0.0, 0.3e-6])
def test_load_and_moments_need_few_more_iterations(roughness):
    grid = sc.Grid(256, 256, 6e-6, 6e-6)
    gap = sc.surfaces.paraboloid(grid, 20e-3, 30e-3)
    gap = gap + roughness * np.random.default_rng(1).standard_normal(gap.shape)
    contact = sc.ContactSolver(grid, STEEL, STEEL, tol=1e-8)
    alone = contact.solve(gap, load=150.0)
    both = contact.solve(gap, load=150.0, moment=(150.0 * 80e-6, -150.0 * 120e-6))
    assert both.iterations <= 1.2 * alone.iterations


def test_a_tilt_in_degrees_is_refused():
    gap = sc.surfaces.paraboloid(GRID, 12e-3)
    with pytest.raises(ValueError, match=r"tilt about x must be .* got 1\.0: convert degrees"):
        solver().solve(gap, load=LOAD, tilt=(1.0, 0.0))


@pytest.mark.parametrize("profile", ["straight", "logarithmic"])
@pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")
def test_a_moment_on_a_roller_costs_what_its_tilt_costs(profile):
    """Cells beyond the ends do not determine the first tilt, also where an end lifts off."""
    load, length, radius = 5e3, 10e-3, 5e-3
    b = sc.hertz.line(radius, E_STAR, load / length).b
    grid = sc.Grid(40, 81, 6 * b / 40, 1.04 * length / 81)
    contact = sc.ContactSolver(grid, STEEL, STEEL, tol=1e-8)
    gap = sc.surfaces.roller(grid, radius, length, profile)
    for arm in (0.1 * length, 0.2 * length, 0.3 * length):
        driven = contact.solve(gap, load=load, moment=(load * arm, 0.0))
        held = contact.solve(gap, load=load, tilt=driven.tilt)
        assert held.moment[0] == pytest.approx(load * arm, rel=1e-6)
        assert driven.iterations <= 1.25 * held.iterations
    assert driven.pressure[:, :8].max() == 0.0  # lifted
    # Both moments: most further steps are due to the shape of the contact.
    both = contact.solve(gap, load=load, moment=(load * 0.3 * length, load * 0.2 * b))
    held = contact.solve(gap, load=load, tilt=both.tilt)
    assert both.iterations <= 1.25 * held.iterations
    assert both.iterations <= 1.6 * contact.solve(gap, load=load).iterations

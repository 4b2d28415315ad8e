# SPDX-License-Identifier: GPL-3.0-or-later
"""Wheel and rail against circular sections, a search by distances, and published positions."""

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import minimize
from standard_profiles import rail_60e1, wheel_s1002

import samcontact as sc
from samcontact.parts import WheelRail

RAIL, WHEEL, RADIUS = 0.30, 0.50, 0.46
STEEL = sc.Material.elastic(210e9, 0.3)


def arc(radius, half_width=0.03, points=301):
    y = np.linspace(-half_width, half_width, points)
    return np.column_stack(
        [y, math.copysign(1.0, radius) * (abs(radius) - np.sqrt(radius**2 - y**2))]
    )


def test_circular_sections_give_the_pressure_of_the_paraboloid():
    """A convex rail in a hollow wheel, shifted: the tangents are parallel at the contact."""
    contact = WheelRail(arc(RAIL), arc(WHEEL), RADIUS, shift=2e-3)
    # both centres on the normal: (y - shift)/WHEEL = y/RAIL
    assert contact.y == pytest.approx(-2e-3 * RAIL / (WHEEL - RAIL), rel=1e-5)
    assert math.sin(contact.angle) == pytest.approx(contact.y / RAIL, rel=1e-9)
    across = 1.0 / (1.0 / RAIL - 1.0 / WHEEL)
    along = contact.rolling_radius / math.cos(contact.angle)
    assert contact.radii == pytest.approx((along, across), rel=1e-5)
    ellipse = sc.hertz.elliptic(along, across, sc.hertz.effective_modulus(STEEL, STEEL), load=2e4)
    grid = sc.Grid(31, 31, ellipse.a_x / 12, ellipse.a_y / 12)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    found = solver.solve(contact.surface(grid), load=2e4).pressure
    expected = solver.solve(sc.surfaces.paraboloid(grid, along, across), load=2e4).pressure
    assert np.abs(found - expected).max() < 1e-3 * expected.max()


def test_a_yawed_wheel_is_a_turned_paraboloid():
    contact = WheelRail(arc(RAIL), arc(-WHEEL), RADIUS, yaw=0.05)
    assert (contact.x, contact.y, contact.angle) == pytest.approx((0.0, 0.0, 0.0), abs=1e-7)
    grid = sc.Grid(9, 9, 5e-4, 5e-4)
    x, y = grid.x[:, None], grid.y[None, :]
    along, across = x * math.cos(0.05) + y * math.sin(0.05), y * math.cos(0.05) - x * math.sin(0.05)
    expected = along**2 / (2 * RADIUS) + across**2 / (2 * WHEEL) + y**2 / (2 * RAIL)
    assert contact.surface(grid) == pytest.approx(expected, rel=1e-4, abs=1e-12)


def test_the_gap_is_the_distance_along_the_normal():
    """A point of the wheel above each cell, found by minimisation, lies at the gap from the rail.

    The rail is steep, curved with a varying radius, and the wheel is yawed.
    """
    rail = rail_60e1() * 1e-3 + np.array([10.54e-3, 0.0])
    contact = WheelRail(rail, wheel_s1002() * 1e-3, RADIUS, shift=4e-3, yaw=0.03, roll=0.002)
    grid = sc.Grid(3, 3, 2e-3, 1e-3)
    gap = contact.surface(grid)
    assert gap[1, 1] == pytest.approx(0.0, abs=1e-15)
    assert np.delete(gap, 4).min() > 0.0
    normal = np.array([0.0, -math.sin(contact.angle), math.cos(contact.angle)])
    side = np.array([0.0, math.cos(contact.angle), math.sin(contact.angle)])
    head = CubicSpline(*rail.T, bc_type="natural")
    z = float(head(contact.y))
    spline = CubicSpline(*(1e-3 * wheel_s1002()).T, bc_type="natural")

    def wheel_at(s, turn):
        r = RADIUS + float(spline(s))
        x, y, down = r * math.sin(turn), s, r * math.cos(turn) - RADIUS
        y, down = (
            y * math.cos(0.002) - down * math.sin(0.002),
            (y * math.sin(0.002) + down * math.cos(0.002)),
        )
        x, y = x * math.cos(0.03) - y * math.sin(0.03), x * math.sin(0.03) + y * math.cos(0.03)
        return np.array([x, y + 4e-3, down + contact.separation])

    for i, j in ((0, 0), (2, 1), (2, 2)):
        cell = np.array([contact.x + grid.x[i], contact.y, z]) + grid.y[j] * side

        def off_normal(at, cell=cell):
            away = 1e3 * (wheel_at(*(1e-3 * np.array(at))) - cell)
            return float(away @ away - (away @ normal) ** 2)

        start = [1e3 * (contact.y_wheel + grid.y[j]), 1e3 * grid.x[i] / RADIUS]
        found = minimize(off_normal, start, method="Nelder-Mead", options={"fatol": 1e-16})
        above = (wheel_at(*(1e-3 * found.x)) - cell) @ normal
        y = contact.y + grid.y[j] * math.cos(contact.angle)
        for _ in range(9):  # the rail on the same normal
            below = (float(head(y)) - cell[2]) / math.cos(contact.angle)
            y = cell[1] - below * math.sin(contact.angle)
        assert gap[i, j] == pytest.approx(below - above, abs=1e-11)


@pytest.mark.parametrize(("shift", "y", "angle"), [(0.0, 751.873, 0.029), (-5.0, 757.896, 0.0085)])
def test_positions_of_the_manchester_benchmark(shift, y, angle):
    """Right wheel, positions by CONTACT, which weights the whole patch: 1.5 mm where it is wide."""
    rail, wheel = rail_60e1(), wheel_s1002()
    # gauge 1435 mm, 14 mm below the top of the rail; backs of the wheels 1360 mm apart, at -70 mm
    half_gauge = np.interp(14.0, rail[:200, 1][::-1], rail[:200, 0][::-1])
    rail[:, 0] += 717.5 - min(half_gauge, rail[:, 0].min()) - 750.0
    contact = WheelRail(rail * 1e-3, wheel * 1e-3, RADIUS, shift=shift * 1e-3)
    assert 750.0 + 1e3 * contact.y == pytest.approx(y, abs=0.1 if shift else 1.5)
    assert -contact.angle == pytest.approx(angle, abs=5e-3)


def test_unusable_profiles_are_refused():
    with pytest.raises(ValueError, match="rail must have points ordered by y"):
        WheelRail(np.vstack([arc(RAIL), [[0.0, 0.1]]]), arc(WHEEL), RADIUS)
    with pytest.raises(ValueError, match=r"wheel must have \|y\| < wheel_radius.*mm"):
        WheelRail(arc(RAIL), 1e3 * arc(WHEEL), RADIUS)
    with pytest.raises(ValueError, match="must extend beyond the contact"):
        WheelRail(arc(RAIL), arc(WHEEL), RADIUS, shift=0.025)

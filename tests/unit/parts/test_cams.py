# SPDX-License-Identifier: GPL-3.0-or-later
"""Cams against an eccentric circle, the kinematics of its contact, and the lift itself."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact.parts import Cam

R, E = 20e-3, 5e-3


@pytest.mark.parametrize("angle", [0.0, 0.7, 2.5, 4.0])
def test_an_eccentric_circle(angle):
    """The contact lies next to the centre; the circle rolls by its radius times the angle."""
    contact = Cam.eccentric(R, E).at(angle)
    assert contact.lift == pytest.approx(E * (1.0 - math.cos(angle)), rel=1e-12, abs=1e-18)
    assert contact.radius == pytest.approx(R, rel=1e-14)
    assert contact.position == pytest.approx(E * math.sin(angle), rel=1e-12, abs=1e-18)
    cam, tappet = contact.speeds(100.0)
    assert cam == pytest.approx(100.0 * R, rel=1e-14)
    step = 1e-4
    moved = Cam.eccentric(R, E).at(angle + step).position - contact.position
    assert tappet == pytest.approx(100.0 * moved / step, abs=2e-4)
    grid = sc.Grid(9, 3, 1e-4, 1e-4)
    gap = contact.surface(grid, crown_radius=1.0)
    expected = sc.surfaces.cylinder(grid, R) + sc.surfaces.paraboloid(grid, math.inf, 1.0)
    assert gap == pytest.approx(expected, rel=1e-9, abs=1e-17)


def test_a_table_of_the_lift_gives_the_same_cam():
    angle = np.linspace(-1.2, 1.2, 121)
    given = Cam.harmonic(22e-3, 8e-3, 2.4)
    table = Cam.table(22e-3, angle, given.lift(angle, 0))
    for at in (-1.0, 0.0, 0.4, 3.0):
        one, other = given.at(at), table.at(at + 2.0 * math.pi)
        assert other.lift == pytest.approx(one.lift, abs=1e-9)
        assert other.radius == pytest.approx(one.radius, abs=2e-5)
        assert other.entraining_speed(50.0) == pytest.approx(one.entraining_speed(50.0), abs=1e-3)


def test_no_point_of_the_cam_lies_above_the_tappet_at_any_angle():
    """The gap, turned with the cam, touches the tappet at the lift of each angle."""
    cam = Cam.harmonic(25e-3, 5e-3, 2.6)
    contact = cam.at(0.6)
    grid = sc.Grid(401, 1, 5e-5, 1e-3)
    gap = contact.surface(grid)[:, 0]
    x = grid.x + contact.position
    height = cam.base_radius + contact.lift - gap
    for turn in (-0.2, -0.05, 0.0, 0.1, 0.2):
        reached = np.max(x * math.sin(turn) + height * math.cos(turn))
        expected = cam.base_radius + cam.at(0.6 + turn).lift
        assert reached == pytest.approx(expected, abs=3e-8)
    assert gap.argmin() == 200


def test_a_flat_tappet_cannot_follow_a_concave_cam():
    with pytest.raises(ValueError, match=r"radius of curvature .* concave"):
        Cam.harmonic(10e-3, 9e-3, 2.0)
    with pytest.raises(ValueError, match=r"angle must lie within one turn.*degrees"):
        Cam.table(20e-3, [0.0, 60.0, 90.0, 120.0, 180.0], [0.0, 1e-3, 2e-3, 1e-3, 0.0])
    with pytest.raises(ValueError, match="lift must be >= 0, and 0 at the first"):
        Cam.table(20e-3, [0.0, 0.6, 0.9, 1.2, 1.8], [1e-3, 1e-3, 2e-3, 1e-3, 0.0])

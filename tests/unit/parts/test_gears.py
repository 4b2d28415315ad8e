# SPDX-License-Identifier: GPL-3.0-or-later
"""Gear flanks against ISO 6336, the equations of the involute, and the balance of speeds."""

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import samcontact as sc
from samcontact.parts import GearPair

STEEL = sc.Material.elastic(206e9, 0.3)
FZG = {"module": 4.5e-3, "teeth": (16, 24), "face_width": 14e-3, "profile_shift": (0.1817, 0.1715)}


def test_data_of_the_test_gears_of_fzg():
    """Type C: centre distance 91.5 mm, working pressure angle 22.44 degrees, contact ratio 1.44."""
    pair = GearPair(**FZG, tip_diameter=(82.5e-3, 118.4e-3))
    assert pair.centre_distance == pytest.approx(91.5e-3, rel=1e-5)
    assert math.degrees(pair.working_pressure_angle) == pytest.approx(22.44, abs=0.01)
    assert pair.contact_ratio == pytest.approx(1.44, abs=0.01)
    given = GearPair(**FZG, centre_distance=pair.centre_distance)
    assert given.working_pressure_angle == pair.working_pressure_angle


def test_pressure_at_the_pitch_point_is_that_of_iso_6336():
    # sigma = Z_H Z_E sqrt(F_t/(d b) (u + 1)/u), Z_H = sqrt(2/(cos^2 alpha tan alpha_w))
    pair = GearPair(**FZG)
    torque, diameter = 300.0, pair.module * pair.teeth[0]
    zone = math.sqrt(
        2.0 / (math.cos(pair.pressure_angle) ** 2 * math.tan(pair.working_pressure_angle))
    )
    elastic = 189.8e3  # sqrt(Pa), steel on steel in the standard
    tangential = 2.0 * torque / diameter
    stress = tangential / (diameter * pair.face_width) * (pair.ratio + 1.0) / pair.ratio
    found = pair.at("C").hertz(torque, sc.hertz.effective_modulus(STEEL, STEEL)).p0
    assert found == pytest.approx(zone * elastic * math.sqrt(stress), rel=1e-4)


def test_without_shift_the_pitch_point_lies_on_the_reference_circles():
    pair = GearPair(3e-3, (20, 31), 10e-3)
    first, second = pair.at("C").radii
    sine = math.sin(pair.pressure_angle)
    assert first == pytest.approx(0.5 * 3e-3 * 20 * sine, rel=1e-14)
    assert second == pytest.approx(0.5 * 3e-3 * 31 * sine, rel=1e-14)
    # MAAG: contact ratio from the tip circles
    tips = (
        math.sqrt(tip**2 - base**2)
        for tip, base in zip(pair.tip_radii, pair.base_radii, strict=True)
    )
    length = sum(tips) - pair.centre_distance * sine
    assert pair.contact_ratio == pytest.approx(length / pair.base_pitch, rel=1e-13)


def test_speeds_are_equal_at_the_pitch_point_only():
    pair = GearPair(**FZG)
    first, second = pair.at("C").speeds(100.0)
    assert first == pytest.approx(second, rel=1e-14)
    v1, v2 = pair.at(2e-3).speeds(100.0)
    # sliding: distance from the pitch point times the sum of the angular speeds
    assert v1 - v2 == pytest.approx(2e-3 * 100.0 * (1.0 + 1.0 / pair.ratio), rel=1e-12)
    assert pair.at("A").slide_to_roll < 0.0 < pair.at("E").slide_to_roll


@pytest.mark.parametrize("sharing", ["equal", "linear"])
def test_two_pairs_carry_the_whole_load(sharing):
    pair = GearPair(**FZG)
    p = pair.points
    for part in (0.1, 0.5, 0.9):
        at = p["A"] + part * (p["B"] - p["A"])
        both = (at, at + pair.base_pitch)
        assert sum(pair.at(x).load_share(sharing) for x in both) == pytest.approx(1.0, rel=1e-12)
    assert pair.at("D").load(100.0, sharing) == 100.0 / pair.base_radii[0]


def depth_of_involute(base, radius, x):
    """Depths of an involute below its tangent, interpolated between points of its definition."""
    turn = np.linspace(-0.03, 0.03, 2001)
    # the base circle turns, and the string is unwound by as much
    point = (base + 1j * (radius + base * turn)) * np.exp(-1j * turn) - complex(base, radius)
    return CubicSpline(point.real, -point.imag)(x)


@pytest.mark.parametrize("position", ["B", "C", "D"])
def test_the_gap_is_that_of_two_involutes(position):
    pair = GearPair(**FZG)
    radii = pair.at(position).radii
    grid = sc.Grid(9, 1, 5e-5, 1e-3)
    first, second = (
        depth_of_involute(base, radius, side * grid.x)
        for base, radius, side in zip(pair.base_radii, radii, (1.0, -1.0), strict=True)
    )
    gap = pair.surface(grid, position)[:, 0]
    assert gap == pytest.approx(first + second, rel=1e-8, abs=1e-17)
    assert abs(gap[0] / gap[-1] - 1.0) > 1e-3  # the curvature varies


def test_the_equivalent_radius_is_the_curvature_of_the_gap():
    contact = GearPair(**FZG).at("B")
    grid = sc.Grid(3, 1, 1e-6, 1e-3)
    before, middle, after = contact.surface(grid)[:, 0]
    assert middle == 0.0
    assert 2.0 * grid.dx**2 / (before + after) == pytest.approx(2.0 * contact.radius, rel=1e-5)


def test_tip_relief_begins_at_the_end_of_single_contact():
    """A part of the relief per length, times d(radius)/dx = base radius/radius of curvature."""
    pair = GearPair(**FZG, tip_relief=(20e-6, 30e-6))
    grid = sc.Grid(3, 1, 1e-6, 1e-3)
    relief = (pair.surface(grid, "D") - GearPair(**FZG).surface(grid, "D"))[:, 0]
    double = pair.points["E"] - pair.points["D"]
    slope = 20e-6 / double * pair.base_radii[0] / pair.at("D").radii[0]
    assert relief == pytest.approx([0.0, 0.0, slope * grid.dx], rel=1e-3, abs=1e-16)


def test_flanks_end_at_the_tip_and_at_the_ends_of_the_face():
    pair = GearPair(**FZG, crowning=10e-6)
    at_tip = np.isfinite(pair.surface(sc.Grid(5, 1, 1e-5, 1e-3), "E")[:, 0])
    assert at_tip.tolist() == [True, True, True, False, False]
    gap = pair.surface(sc.Grid(1, 9, 1e-3, 2e-3))[0]
    assert np.isinf(gap[[0, -1]]).all()
    assert gap[1:-1] == pytest.approx(10e-6 * (np.arange(-3, 4) * 2 / 7) ** 2, rel=1e-9)


def test_unusable_pairs_are_refused():
    with pytest.raises(ValueError, match="teeth of gear 1 must not extend below the base"):
        GearPair(2e-3, (10, 60), 10e-3)
    with pytest.raises(ValueError, match=r"pressure_angle must be .* degrees"):
        GearPair(2e-3, (20, 60), 10e-3, pressure_angle=20.0)
    with pytest.raises(ValueError, match="position must be between A"):
        GearPair(2e-3, (20, 60), 10e-3).at(0.1)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"module": 4.5}, "module must be at most 0.5 m, got 4.5 m: millimetres"),
        ({"crowning": 20.0}, "crowning must be at most"),
        ({"tip_relief": (20.0, 20.0)}, "tip_relief must be at most"),
        ({"tip_diameter": (82.5, 118.4)}, "tip_diameter must be at most"),
    ],
)
def test_lengths_in_millimetres_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        GearPair(**{"module": 4.5e-3, "teeth": (16, 24), "face_width": 14e-3} | change)

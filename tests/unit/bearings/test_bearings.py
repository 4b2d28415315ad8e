# SPDX-License-Identifier: GPL-3.0-or-later
"""Bearing contacts against the geometry of tori, textbook values, and sums over the balls."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import samcontact as sc
from samcontact import bearings, hertz

D, PITCH, F = 12.7e-3, 65e-3, 0.52  # the 209 deep groove bearing of Harris


@pytest.mark.parametrize(
    ("race", "total", "difference"), [("inner", 201.8, 0.93996), ("outer", 137.8, 0.91209)]
)
def test_textbook_example(race, total, difference):
    # Harris: 1/D (4 - 1/f + 2 g/(1 - g)) inside, 1/D (4 - 1/f - 2 g/(1 + g)) outside, g = D/d_m
    contact = bearings.ball_on_race(D, PITCH, conformity=F, race=race)
    assert contact.curvature_sum == pytest.approx(total, rel=2e-4)
    assert contact.curvature_difference == pytest.approx(difference, abs=1e-5)


def torus(point, groove, radius):
    """Return zero on the torus about z with tube radius `groove` and this centre line."""
    return math.hypot(math.hypot(point[0], point[1]) - radius, point[2]) - groove


def gap_of_sphere_and_torus(race, alpha, groove, along, across):
    """Return the distance between ball and race along the normal, from their equations."""
    side = 1.0 if race == "outer" else -1.0
    ball = np.array([PITCH / 2, 0.0, 0.0])
    normal = np.array([side * math.cos(alpha), 0.0, math.sin(alpha)])  # towards the race
    rolling, transverse = np.array([0.0, 1.0, 0.0]), np.cross(normal, [0.0, 1.0, 0.0])
    centre = ball - (groove - D / 2) * normal  # of the cross-section of the groove
    shift = np.array([0.0, 0.0, centre[2]])
    start = ball + along * rolling + across * transverse

    def race_at(t):
        return torus(start + t * normal - shift, groove, centre[0])

    on_ball = math.sqrt(D**2 / 4 - along**2 - across**2)
    return brentq(race_at, 0.45 * D, 0.55 * D, xtol=1e-17, rtol=1e-15) - on_ball


@pytest.mark.parametrize("race", ["inner", "outer"])
@pytest.mark.parametrize("degrees", [0.0, 15.0, 40.0])
def test_radii_are_those_of_the_gap(race, degrees):
    alpha, groove, h = math.radians(degrees), 6.6e-3, 2e-4
    contact = bearings.ball_on_race(D, PITCH, groove, contact_angle=alpha, race=race)
    at = [gap_of_sphere_and_torus(race, alpha, groove, *p) for p in ((0, 0), (h, 0), (0, h))]
    back = [gap_of_sphere_and_torus(race, alpha, groove, *p) for p in ((-h, 0), (0, -h))]
    assert at[0] == pytest.approx(0.0, abs=1e-15)
    # second differences; the fourth order leaves h^2/D^2, rounding 1e-17/h^2 times the radius
    assert (at[1] + back[0]) / h**2 == pytest.approx(1.0 / contact.Rx, rel=1e-3)
    assert (at[2] + back[1]) / h**2 == pytest.approx(1.0 / contact.Ry, rel=1e-3)


def test_groove_radius_and_conformity_agree():
    first = bearings.ball_on_race(D, PITCH, F * D, contact_angle=0.3)
    second = bearings.ball_on_race(D, PITCH, conformity=F, contact_angle=0.3)
    assert first.Rx == second.Rx
    assert first.Ry == pytest.approx(second.Ry, rel=1e-13)
    # a very wide groove tends to a plane
    assert bearings.ball_on_race(D, PITCH, 1e6).Ry == pytest.approx(D / 2, rel=1e-8)
    # a thrust bearing rolls on a flat in the rolling direction
    thrust = bearings.ball_on_race(D, PITCH, conformity=F, contact_angle=math.pi / 2)
    assert thrust.Rx == pytest.approx(D / 2, rel=1e-13)


def test_radii_go_into_hertz():
    contact = bearings.ball_on_race(D, PITCH, conformity=F)
    ellipse = hertz.elliptic(contact.Rx, contact.Ry, 115.4e9, load=1000.0)
    assert ellipse.a_y > 5.0 * ellipse.a_x  # long across the rolling direction


def test_roller_radii_are_those_of_two_cylinders():
    inner = bearings.roller_on_race(0.01, 0.06)
    # 1/R = 2/D + 2/d_race, the race being d_m - D or, concave, d_m + D
    assert 1.0 / inner.Rx == pytest.approx(2 / 0.01 + 2 / 0.05, rel=1e-13)
    outer = bearings.roller_on_race(0.01, 0.06, race="outer", crown_radius=2.0)
    assert 1.0 / outer.Rx == pytest.approx(2 / 0.01 - 2 / 0.07, rel=1e-13)
    assert (inner.Ry, outer.Ry) == (math.inf, 2.0)
    assert (inner.curvature_difference, inner.curvature_sum) == (1.0, 1.0 / inner.Rx)


@pytest.mark.parametrize("n", [1.0, 10 / 9, 1.5])
@pytest.mark.parametrize("epsilon", [0.01, 0.5, 0.999, 1.0, 1.001, 5.0])
def test_sjovall_integrals_by_quadrature(n, epsilon):
    edge = math.acos(max(-1.0, 1.0 - 2.0 * epsilon))

    def load(psi):
        return max(1.0 - (1.0 - math.cos(psi)) / (2.0 * epsilon), 0.0) ** n

    J_r, J_a = bearings.sjovall(epsilon, n)
    assert J_a == pytest.approx(quad(load, 0, edge)[0] / math.pi, rel=1e-8)
    radial = quad(lambda psi: load(psi) * math.cos(psi), 0, edge)[0] / math.pi
    assert J_r == pytest.approx(radial, rel=1e-8)


def test_known_factors():
    assert bearings.ball_load(1.0, 1) == pytest.approx(4.37, abs=5e-4)
    assert bearings.ball_load(1.0, 1, exponent=10 / 9) == pytest.approx(4.08, abs=6e-3)
    assert bearings.stribeck_load(900.0, 9, math.pi / 3) == pytest.approx(1000.0, rel=1e-13)
    assert bearings.ball_load(900.0, 9) < bearings.stribeck_load(900.0, 9)


def test_radial_load_is_in_equilibrium_with_many_balls():
    count, angle = 10001, 0.4
    # the inner ring moves by 1 along the load, balls in front are compressed by cos(psi)
    psi = 2.0 * math.pi * np.arange(count) / count
    loads = np.maximum(np.cos(psi), 0.0) ** 1.5
    force = math.cos(angle) * np.sum(loads * np.cos(psi))
    assert bearings.ball_load(force, count, angle) == pytest.approx(1.0, rel=1e-6)


@pytest.mark.parametrize("radial", [0.2, 0.9, 3.0])
def test_load_zone_is_in_equilibrium_with_many_balls(radial):
    count, angle = 10001, math.radians(40.0)
    psi = 2.0 * math.pi * np.arange(count) / count
    approach = math.sin(angle) + radial * math.cos(angle) * np.cos(psi)
    loads = np.maximum(approach, 0.0) ** 1.5
    F_a = math.sin(angle) * loads.sum()
    F_r = math.cos(angle) * np.sum(loads * np.cos(psi))
    zone = bearings.load_zone(F_r, F_a, count, angle)
    assert zone.max_load == pytest.approx(loads.max(), rel=1e-6)
    np.testing.assert_allclose([zone.load(p) for p in psi[:6000:500]], loads[:6000:500], atol=1e-5)
    edge = (
        math.pi
        if radial * math.cos(angle) <= math.sin(angle)
        else math.acos(-math.tan(angle) / radial)
    )
    assert zone.half_angle == pytest.approx(edge, rel=1e-4)


def test_pure_thrust_loads_all_balls_equally():
    zone = bearings.load_zone(0.0, 800.0, 16, math.pi / 6)
    assert (zone.max_load, zone.epsilon) == (pytest.approx(100.0, rel=1e-13), math.inf)
    assert zone.load(2.0) == zone.max_load
    almost = bearings.load_zone(1e-6, 800.0, 16, math.pi / 6)
    assert almost.max_load == pytest.approx(100.0, rel=1e-7)


# ISO 76: f_0 of radial ball bearings by D cos(alpha)/d_m, with conformities of 0.52 and 0.53
FACTORS = {0.01: 14.9, 0.05: 15.7, 0.08: 16.3, 0.09: 16.5, 0.1: 16.4, 0.15: 15.2, 0.2: 14.0}


def both_races(diameter, pitch):
    return [
        bearings.ball_on_race(diameter, pitch, conformity=f, race=race)
        for race, f in (("inner", 0.52), ("outer", 0.53))
    ]


@pytest.mark.parametrize(("gamma", "factor"), FACTORS.items())
def test_static_rating_has_the_factors_of_the_standard(gamma, factor):
    D, balls, angle = 9e-3, 11, 0.3
    races = both_races(D, D / gamma)
    rating = bearings.static_load_rating(races, balls, angle)
    f_0 = rating / (balls * (1e3 * D) ** 2 * math.cos(angle))
    assert f_0 == pytest.approx(factor, abs=0.06)
    assert bearings.static_load_rating(races, balls, angle, rows=2) == 2 * rating


def test_static_rating_of_rollers_has_the_factor_of_the_standard():
    D, length, rollers, gamma = 10e-3, 12e-3, 14, 0.15
    races = [bearings.roller_on_race(D, D / gamma, race=race) for race in ("inner", "outer")]
    rating = bearings.static_load_rating(races, rollers, pressure=4e9, length=length)
    assert rating == pytest.approx(44 * (1 - gamma) * rollers * 12 * 10, rel=5e-3)


def test_palmgren_and_the_rating_agree_in_the_deformation():
    # 12.3 was the factor for 1e-4 of the diameter before the standard stated pressures
    race = bearings.ball_on_race(D, PITCH, conformity=F)
    before = bearings.palmgren_deformation(race, 5 * 12.3 * (1e3 * D) ** 2, D)
    assert before == pytest.approx(1e-4 * D, rel=0.07)
    now = 5 * bearings.static_load_rating([race], 1)
    assert bearings.palmgren_deformation(race, now, D) == pytest.approx(1.2e-4 * D, rel=0.03)
    # with N and mm
    flat = bearings.RaceContact(D / 2, D / 2)
    in_mm = 1.3e-7 * 500.0**2 / 12.7 * (2 / 12.7) ** 2
    assert bearings.palmgren_deformation(flat, 500.0, D) == pytest.approx(1e-3 * in_mm)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: bearings.static_load_rating([], 8), "races must contain at least one contact"),
        (
            lambda: bearings.static_load_rating(both_races(D, PITCH), 8, length=1e-2),
            "length must be None for balls and crowned rollers, got 0.01",
        ),
        (
            lambda: bearings.static_load_rating([bearings.roller_on_race(D, PITCH)], 8),
            "length must be a number > 0 .m. for rollers without crowning",
        ),
        (lambda: bearings.ball_on_race(D, PITCH), "exactly one of groove_radius and conformity"),
        (lambda: bearings.ball_on_race(D, PITCH, 6.3e-3), "must be > 0.5, got 0.49"),
        (lambda: bearings.ball_on_race(D, 0.01, conformity=F), "pitch_diameter must be greater"),
        (lambda: bearings.ball_on_race(D, PITCH, conformity=F, race="cage"), "race must be one of"),
        (
            lambda: bearings.ball_on_race(D, PITCH, conformity=F, contact_angle=40.0),
            r"contact_angle must be in \[0, pi/2\] rad, got 40.0",
        ),
        (lambda: bearings.ball_load(1.0, 0), "balls must be an integer >= 1"),
        (lambda: bearings.ball_load(1.0, 8, math.pi / 2), "contact_angle must be < pi/2"),
        (lambda: bearings.sjovall(0.0), "epsilon must be a finite number > 0"),
        (
            lambda: bearings.load_zone(100.0, 50.0, 8, math.pi / 4),
            "axial_load must be greater than radial",
        ),
        (lambda: bearings.load_zone(100.0, 50.0, 8, 0.0), "contact_angle must be between"),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_millimetres_cause_a_warning():
    for call in (
        lambda: bearings.ball_on_race(12.0, 60.0, conformity=0.52),
        lambda: bearings.roller_on_race(12.0, 60.0),
    ):
        with pytest.warns(sc.UnitWarning, match=r"diameter is 12\.0 m .* Use m: 12 mm is 12e-3"):
            call()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Bearings: dimensions, load distribution against closed forms, static rating, gaps."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact import bearings
from samcontact.bearings import Bearing

D, PITCH = 12.7e-3, 65e-3
FINE_ROW = {"element_diameter": 1e-3, "pitch_diameter": 65e-3, "elements": 101}


def resultants(found):
    """Radial and axial force of the loads."""
    radial = found.loads * np.cos(found.contact_angles) * np.cos(found.angles)
    return radial.sum(), (found.loads * np.sin(found.contact_angles)).sum()


def test_the_standard_bearing_6208():
    bearing = bearings.standard("6208")
    assert bearing.static_load_rating == pytest.approx(18.1e3, rel=2e-3)
    assert bearing.governing_race == "inner"
    # Stribeck's rule, because the clearance is unknown
    assert bearing.max_element_load(24e3) == pytest.approx(5 / 9 * 24e3)
    assert bearing.max_element_load(24e3, 1.0) == pytest.approx(5 / 9 * 24e3)
    assert bearing.static_safety(12e3) == pytest.approx(bearing.static_load_rating / 12e3)
    assert bearing.static_equivalent_load(10e3, 20e3) == pytest.approx(16e3)
    assert "estimated" in bearing.source
    # catalogues: 4.75, 7.8 and 20.4 kN for 6203, 6205 and 6209
    for name, rating in (("6203", 4.75e3), ("6205", 7.8e3), ("6209", 20.4e3)):
        assert bearings.standard(name).static_load_rating == pytest.approx(rating, rel=0.03)
    # the estimate from bore and outside diameter has the balls of the tables
    estimate = bearings.from_boundary(40e-3, 80e-3)
    assert estimate.element_diameter == pytest.approx(12e-3)
    assert (estimate.elements, estimate.pitch_diameter) == (9, pytest.approx(60e-3))
    for size, rating in (((17e-3, 40e-3), 4.75e3), ((25e-3, 52e-3), 7.8e3)):
        assert bearings.from_boundary(*size).static_load_rating == pytest.approx(rating, rel=0.1)


@pytest.mark.parametrize(("rollers", "factor"), [(False, 4.37), (True, 4.08)])
def test_stribeck_factor_without_clearance(rollers, factor):
    more = {"length": 2e-3, "profile": "straight"} if rollers else {}
    kind = "cylindrical_roller" if rollers else "deep_groove"
    found = Bearing(kind, **FINE_ROW, **more, clearance=0.0).element_loads(50.0)
    assert found.max_load * 101 / 50.0 == pytest.approx(factor, rel=2e-3)
    assert found.loaded == 51
    assert resultants(found)[0] == pytest.approx(50.0, rel=1e-8)


@pytest.mark.parametrize("rollers", [False, True])
def test_clearance_reduces_the_load_zone_as_sjovall(rollers):
    kind, n = ("cylindrical_roller", 10 / 9) if rollers else ("deep_groove", 1.5)
    more = {"length": 2e-3, "profile": "straight"} if rollers else {}
    found = Bearing(kind, **FINE_ROW, **more, clearance=1e-6).element_loads(50.0)
    # Harris: epsilon = (1 - P_d/(2 delta_r))/2
    epsilon = 0.5 * (1.0 - 1e-6 / (2.0 * found.displacement[0]))
    known = bearings.ball_load(50.0, 101, epsilon=epsilon, exponent=n)
    assert found.max_load == pytest.approx(known, rel=5e-3)
    assert epsilon < 0.45


def test_combined_load_of_parallel_rings_is_that_of_sjovall():
    angle = math.radians(40.0)
    bearing = Bearing("angular_contact", **FINE_ROW, contact_angle=angle)
    found = bearing.element_loads(4.0, 8.0)  # so small that the contact angles hardly change
    zone = bearings.load_zone(4.0, 8.0, 101, angle)
    assert found.max_load == pytest.approx(zone.max_load, rel=5e-3)
    assert resultants(found) == pytest.approx((4.0, 8.0), rel=1e-7)
    with pytest.raises(ValueError, match=r"axial_load must exceed about radial_load tan"):
        bearing.element_loads(8.0, 2.0)


def test_thrust_raises_the_contact_angle():
    """Harris: F_a/(Z K A^1.5) = sin(a) (cos(a0)/cos(a) - 1)^1.5, a the angle of all balls."""
    bearing = bearings.standard("6209", clearance=20e-6)
    found = bearing.element_loads(axial_load=5e3)
    A = 0.05 * D
    start = math.acos(1.0 - 20e-6 / (2.0 * A))
    angle = found.contact_angles[0]
    np.testing.assert_allclose(found.contact_angles, angle, rtol=1e-9)
    ellipses = [bearing.hertz(race, 1e3) for race in ("inner", "outer")]
    K = 1e3 / sum(e.approach for e in ellipses) ** 1.5
    share = math.sin(angle) * (math.cos(start) / math.cos(angle) - 1.0) ** 1.5
    assert 9 * K * A**1.5 * share == pytest.approx(5e3, rel=1e-6)


def test_load_factor_is_the_inverse_of_the_distribution():
    bearing = bearings.standard("6208", clearance=10e-6)
    factor = bearing.load_factor(6e3, 5e3, 1e3)
    assert bearing.max_element_load(5e3 * factor, 1e3 * factor) == pytest.approx(6e3, rel=1e-8)
    assert bearings.standard("6208").load_factor(5e3, 9e3) == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("kind", ["deep_groove", "cylindrical_roller"])
def test_moment_balances_the_load_beside_the_centre(kind):
    more = {"length": 10e-3} if kind == "cylindrical_roller" else {}
    bearing = Bearing(kind, 10e-3, 50e-3, 12, clearance=5e-6, **more)
    free, given = bearing.element_loads(5e3, moment=0.0), bearing.element_loads(5e3, moment=8.0)
    assert free.displacement[2] == pytest.approx(0.0, abs=1e-12)
    assert given.tilt > 1e-5
    other = bearing.element_loads(5e3, moment=-8.0)
    np.testing.assert_allclose(other.loads, given.loads, rtol=1e-6)
    assert other.tilt == pytest.approx(-given.tilt, rel=1e-6)
    # the work of the moment: d(energy) = F d(delta) + M d(theta) (reciprocity)
    step = 1e-3
    more_moment = bearing.element_loads(5e3, moment=8.0 + step)
    more_load = bearing.element_loads(5e3 + step, moment=8.0)
    by_moment = (more_moment.displacement[0] - given.displacement[0]) / step
    by_load = (more_load.displacement[2] - given.displacement[2]) / step
    assert by_moment == pytest.approx(by_load, rel=1e-3, abs=1e-12)


def test_gaps_are_those_of_the_races():
    grid = sc.Grid(9, 9, 50e-6, 100e-6)
    ball = bearings.standard("6209")
    inner = bearings.ball_on_race(D, PITCH, conformity=0.52)
    assert np.array_equal(ball.gap("inner")(grid), sc.surfaces.paraboloid(grid, inner.Rx, inner.Ry))
    rollers = Bearing("cylindrical_roller", 10e-3, 50e-3, 13, length=0.5e-3)
    known = sc.surfaces.roller(grid, 6e-3, 0.5e-3, "logarithmic", diameter=10e-3, tilt=1e-3)
    np.testing.assert_allclose(rollers.gap("outer", tilt=1e-3)(grid), known, rtol=1e-12)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: bearings.standard("6280"), "designation must be one of 6203, .*got '6280'"),
        (lambda: bearings.standard("6208ETN9"), "got '6208ETN9': the suffix is unknown"),
        (lambda: Bearing("ball", D, PITCH, 9), "kind must be one of 'deep_groove'"),
        (
            lambda: Bearing("deep_groove", D, PITCH, 17),
            "17 elements of diameter 0.0127 m do not fit",
        ),
        (lambda: Bearing("deep_groove", D, PITCH, 9, contact_angle=0.3), "contact_angle must be"),
        (lambda: Bearing("angular_contact", D, PITCH, 9), "contact_angle must be > 0"),
        (lambda: Bearing("deep_groove", D, PITCH, 9, length=0.01), "length does not apply"),
        (lambda: Bearing("cylindrical_roller", D, PITCH, 9), "length is required for rollers"),
        (lambda: Bearing("deep_groove", D, PITCH, 9, clearance=10.0), "clearance must be < 0.1"),
        (lambda: bearings.standard("6208").element_loads(), "radial_load, axial_load or moment"),
        (lambda: bearings.standard("6208").gap("inner", tilt=1e-3), "tilt must be 0 for balls"),
        (
            lambda: Bearing("cylindrical_roller", D, PITCH, 9, length=0.01).element_loads(1, 2),
            "axial_load must be 0 for cylindrical rollers",
        ),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_sizes_in_millimetres_are_refused():
    with pytest.raises(ValueError, match=r"element_diameter must be at most 1 m, got 12\.0 m"):
        sc.bearings.Bearing("deep_groove", 12.0, 60.0, 9)


def test_suffixes_of_seals_and_clearance_leave_the_dimensions():
    plain = bearings.standard("6208")
    for given in (6208, " 6208 ", "6208-2RS", "6208-2RS1/C3", "6208 ZZ", "6208-2Z/P6", "6208NR"):
        assert bearings.standard(given) == plain
    with pytest.raises(TypeError, match=r'designation must be text, e\.g\. "6208", got 6208\.0'):
        bearings.standard(6208.0)

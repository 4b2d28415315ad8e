# SPDX-License-Identifier: GPL-3.0-or-later
"""Static capacity: the case of a ball in a groove, and the page on static capacity."""

from pathlib import Path

import pytest

import samcontact as sc
from benchmarks.static_capacity import setups
from benchmarks.static_capacity.page import GROOVE, STUDY, by_model, pressed
from samcontact.cases import load_case

CASE = Path(__file__).parents[3] / "cases" / "b1_ball_in_groove.toml"


def test_the_case_has_the_geometry_of_the_bearing():
    contact, case = setups.CONTACTS[GROOVE], load_case(CASE)
    simulation, _ = case.build()
    assert case.surface.Rx == pytest.approx(contact.race.Rx, rel=1e-4)
    assert case.surface.Ry == pytest.approx(contact.race.Ry, rel=1e-4)
    load = max(segment.load for segment in case.path)
    hertz = sc.hertz.elliptic(case.surface.Rx, case.surface.Ry, setups.E_STAR, load=load)
    assert hertz.p0 == pytest.approx(4.2e9, rel=2e-3)
    for body in (simulation.body1, simulation.body2):
        assert body.yield_stress(1e-3) == setups.STEELS[setups.STEEL].yield_stress(1e-3)


def test_the_found_load_agrees_with_the_pressure_on_the_page():
    # of the load 2 %, which is 0.6 % of the pressure
    found = sc.find_load(
        load_case(CASE), "permanent_deformation", 1e-4 * setups.BALL, tolerance=0.03, progress=False
    )
    race = setups.CONTACTS[GROOVE].race
    pressure = sc.hertz.elliptic(race.Rx, race.Ry, setups.E_STAR, load=found.load).p0
    # of other cells, and between the pressures that the page has solved
    assert pressure == pytest.approx(by_model(pressed(STUDY.records())[0][GROOVE]), rel=0.01)


def test_imprints_scale_with_the_ball():
    """Doubling all lengths at equal pressure doubles the imprint depth."""
    small = setups.CONTACTS[setups.FLAT]
    race = setups.bearings.RaceContact(2 * small.race.Rx, 2 * small.race.Ry)
    large = setups.Contact(race, 2 * small.diameter, small.pressure)
    one, two = (setups.press(c, setups.STEELS["M50"], 5e9, 8) for c in (small, large))
    assert two.load == pytest.approx(4 * one.load)
    assert two.deformation == pytest.approx(one.deformation, rel=1e-4)
    assert two.palmgren == pytest.approx(one.palmgren)

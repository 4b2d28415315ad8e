# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `find` for bearings: both races, the loads on the bearing, ISO 76."""

import re
from pathlib import Path

import pytest

from command import check_failure, invoke
from samcontact import bearings
from samcontact.cases import load_case
from samcontact.commands.bearing_loads import in_metres, largest_contact_load

CASES = Path(__file__).parents[3] / "cases"
STEEL = '[body{}]\nlaw = "elastic"\nE = 207e9\nnu = 0.3\n'
ELASTIC = STEEL.format(1) + STEEL.format(2)
BEARING = 'title = "t"\n[bearing]\ndesignation = "6208"\nradial_load = {}\n' + ELASTIC


def row(text, label):
    """Numbers in the row of a table."""
    (line,) = (line for line in text.splitlines() if label in line)
    return [float(number) for number in re.findall(r"[\d.]+(?= k?N)|[\d.]+(?= *│)", line)]


def test_the_pressure_of_the_standard_is_found_at_the_rated_load(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(BEARING.format("18e3"))
    outcome = invoke("find", file, "max_pressure=4.2e9")
    assert outcome.exit_code == 0, outcome.output
    rated = bearings.standard("6208").static_load_rating / 1e3
    inner, outer = row(outcome.stdout, "radial load on the bearing")
    assert inner == pytest.approx(rated, rel=5e-3)
    assert row(outcome.stdout, "contact load")[0] == pytest.approx(5 / 9 * inner, rel=1e-3)
    assert outer > 1.2 * inner
    assert row(outcome.stdout, "static load rating") == pytest.approx([rated, rated], rel=1e-3)
    assert row(outcome.stdout, "s0 at this load")[0] == pytest.approx(1.0, abs=0.011)
    assert "governing: inner race" in outcome.stdout


def test_a_named_race_is_solved_alone(tmp_path):
    file = tmp_path / "case.toml"
    text = BEARING.format('18e3\nrace = "outer"\nclearance = 20e-6')
    file.write_text(text)
    outcome = invoke("find", file, "max_pressure=3e9", "--quiet")
    assert outcome.exit_code == 0, outcome.output
    bearing = bearings.standard("6208", clearance=20e-6)
    load = bearing.max_element_load(float(outcome.stdout))
    assert bearing.hertz("outer", load).p0 == pytest.approx(3e9, rel=5e-3)


def test_targets_in_diameters_need_a_rolling_element(tmp_path):
    case = load_case(CASES / "b5_bearing_6208.toml")
    name, value = in_metres("permanent_deformation=1e-4 D", case).split("=")
    assert name == "permanent_deformation"
    assert float(value) == pytest.approx(1.2e-6)
    assert in_metres("max_pressure=4 GPa", case) == "max_pressure=4 GPa"
    refused = invoke("find", CASES / "b5_bearing_6208.toml", "max_pressure=4 D")
    check_failure(refused, 2, "D (diameter of the rolling element) applies to lengths only")
    refused = invoke("find", CASES / "b1_ball_in_groove.toml", "permanent_deformation=1e-4 D")
    check_failure(refused, 2, "requires [bearing] or [roller]")


def test_the_largest_load_is_that_on_the_bearing(tmp_path):
    """By Stribeck's rule, one of nine elements carries 5/9 of the radial load."""
    file = tmp_path / "case.toml"
    file.write_text(BEARING.format("18e3"))
    case = load_case(file)
    assert largest_contact_load(case, 9e3) == pytest.approx(5e3)
    assert largest_contact_load(case, None) is None
    outcome = invoke("find", file, "max_pressure=9e9", "--largest-load", "9 kN", "--quiet")
    check_failure(outcome, 2, "cannot be reached")
    ball = load_case(CASES / "b1_ball_in_groove.toml")
    assert largest_contact_load(ball, 9e3) == 9e3


@pytest.mark.slow
def test_overload_of_the_bearing_6208():
    """Loads that leave 1e-4 D; the radial load follows from Stribeck's rule."""
    found = invoke("find", CASES / "b5_bearing_6208.toml", "permanent_deformation=1e-4 D")
    assert row(found.stdout, "contact load") == pytest.approx([13.3, 14.9], rel=0.01)
    assert row(found.stdout, "radial load on the bearing")[0] == pytest.approx(24.0, rel=0.01)
    assert row(found.stdout, "static load rating")[0] == pytest.approx(18.1, rel=5e-3)

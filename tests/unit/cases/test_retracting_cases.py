# SPDX-License-Identifier: GPL-3.0-or-later
"""Segments of a path that retract the bodies until they separate."""

import pytest
from rich.console import Console

import samcontact as sc
from samcontact.cases import CaseError, parse_case
from samcontact.commands.errors import StoppedEarlyError
from samcontact.commands.solve_contact import solve_contact
from samcontact.results import open_results

HEAD = """
title = "t"
estimate_error = false
grid = {nx = 20, ny = 20, dx = "9 nm", dy = "9 nm"}
body1 = {law = "rigid"}
body2 = {law = "elastic", E = 1e9, nu = 0.3}
surface = {shape = "paraboloid", Rx = 0.5e-6}
"""
LAW = '[contact]\nadhesion = {kind = "exponential", work = 0.05, range = "1.6 nm"}\n'
TOUCH = '[[path]]\nload = "20 nN"\nincrements = 1\n'
PULL = "[[path]]\npull_off = {text}\n"

pytestmark = pytest.mark.filterwarnings("ignore:the attraction at the edge")


def case(*segments, law=LAW, head=HEAD):
    return parse_case("".join((head, law, *segments)))


def pulled(text="true", more=""):
    return PULL.format(text=text) + more


def test_a_case_retracts_until_the_surfaces_separate(tmp_path):
    """The increments are those of `paths.pull_off`; the path goes on from them."""
    after = '[[path]]\napproach = "0 nm"\nstart = "-9 nm"\nincrements = 1\n'
    solve_contact(
        case(TOUCH, pulled(), after), tmp_path, Console(quiet=True), figures=False, animate=False,
        resume=False,
    )  # fmt: skip
    simulation, path = case(TOUCH).build()
    simulation.run(path, progress=False)
    expected = sc.paths.pull_off(simulation, step=0.4e-9)
    with open_results(tmp_path / "results.nc") as found:
        loads = found["load"].values
        assert found.attrs["pull_off"] == pytest.approx(expected.pull_off, rel=1e-9)
        assert found.attrs["pull_off_increment"] == 1 + loads.argmin()
    assert len(loads) == len(expected.states) + 1
    assert loads[:-1] == pytest.approx([s.load for s in expected.states], rel=1e-6, abs=1e-15)
    assert expected.is_apart
    assert loads[-1] < 0.5 * loads[-2] < 0


def test_a_retraction_that_does_not_end_keeps_its_results(tmp_path):
    few = case(TOUCH, pulled("{step = 1e-11, until = 'maximum'}", "increments = 3\n"))
    with pytest.raises(StoppedEarlyError, match="4 of at most 4 increments"):
        solve_contact(
            few, tmp_path, Console(quiet=True), figures=False, animate=False, resume=False
        )
    with open_results(tmp_path / "results.nc") as found:
        assert "max_steps = 3 increments of 1e-11 m do not separate" in found.attrs["stopped_by"]
        assert found.sizes["increment"] == 4


@pytest.mark.parametrize(
    ("segments", "law", "message"),
    [
        ((pulled(),), LAW, "pull_off requires a previous segment"),
        ((TOUCH, pulled(more="load = 0.0\n")), LAW, "pull_off cannot be combined with load"),
        ((TOUCH, pulled()), "", r"path\[1\]\.pull_off requires a law of adhesion"),
        ((TOUCH, pulled("false")), LAW, "exactly one of load, approach and"),
        ((TOUCH, pulled("{speed = 1.0}")), LAW, "speed has no effect without heat"),
        ((TOUCH, pulled(), '[[path]]\napproach = "0 nm"\n'), LAW, "start is required where"),
    ],
)
def test_retractions_are_checked(segments, law, message):
    with pytest.raises(CaseError, match=message):
        case(*segments, law=law)


def test_adhering_bodies_do_not_return_unloaded():
    """Passes end at zero load, at which adhering bodies remain in contact."""
    rolled = '[[path]]\nload = "20 nN"\nroll = {distance = "36 nm", step = "9 nm"}\n'
    with pytest.raises(CaseError, match=r"roll cannot be combined with contact\.adhesion"):
        case(rolled)
    moved = '[[path]]\nload = "20 nN"\nincrements = 2\nadvance = ["18 nm", "18 nm"]\n'
    assert case(TOUCH, moved).moves


def test_a_retraction_has_no_fixed_number_of_increments():
    plain = TOUCH.replace("increments = 1\n", "")
    with pytest.raises(CaseError, match=r"pull_off cannot be combined with accuracy"):
        case(plain, pulled(), head=f"accuracy = 0.1\n{HEAD.replace('estimate_error = false', '')}")

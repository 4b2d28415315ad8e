# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files with a contact law: built law, conditions of tension, and refused fields."""

import pytest
from rich.console import Console

import samcontact as sc
from case_texts import BODIES, GRID
from samcontact.cases import CaseError, parse_case
from samcontact.commands.solve_contact import solve_contact
from samcontact.results import open_results

LAW = 'adhesion = {kind = "tensile_limit", limit = "0.5 MPa"}'


def case(*segments, contact=LAW, more=""):
    path = "".join(f"[[path]]\n{segment}\n" for segment in segments)
    return parse_case(f'title = "t"\n{GRID}\n{BODIES}\n[contact]\n{contact}\n{path}{more}')


def test_contact_laws_reach_the_simulation():
    loads = "load = 600.0\nincrements = 1", "load = -0.01\nincrements = 1"
    simulation, _ = case(*loads).build()
    assert simulation.adhesion == sc.TensileLimit(5e5)
    hard = case(loads[0], contact='adhesion = {kind = "hard"}').build()[0]
    assert hard.adhesion == case(loads[0], contact="").build()[0].adhesion
    assert hard.adhesion == sc.HardContact()


@pytest.mark.parametrize(
    ("contact", "message"),
    [
        ('adhesion = {kind = "soft"}', "kind"),
        ('adhesion = {kind = "tensile_limit"}', "limit"),
        ('adhesion = {kind = "tensile_limit", limit = "-1 MPa"}', "limit"),
        ('adhesion = {kind = "tensile_limit", limit = "1 N"}', "limit"),
    ],
)
def test_laws_are_checked(contact, message):
    with pytest.raises(CaseError, match=message):
        case("load = 600.0", contact=contact)


def test_tension_needs_an_attraction():
    with pytest.raises(
        CaseError, match=r"path\[1\]\.load: must be a number >= 0 \[N\], got -0\.01"
    ):
        case("load = 600.0", "load = -0.01", contact="")


def test_options_unsupported_with_attraction_are_refused():
    with pytest.raises(CaseError, match="path: bodies must not roll or slide"):
        case("load = 600.0", "load = 600.0\nadvance = [1e-4, 1e-4]")


def test_a_run_stores_law_and_repulsion(tmp_path):
    loads = "load = 600.0\nincrements = 1", "load = -0.01\nincrements = 1"
    console = Console(width=200)
    solve_contact(case(*loads), tmp_path, console, figures=False, animate=False, resume=False)
    with open_results(tmp_path / "results.nc") as found:
        assert found.attrs["adhesion"] == "tensile_limit"
        assert found.attrs["adhesion_limit"] == 5e5
        assert float(found["load"][-1]) == pytest.approx(-0.01)
        pulled = found["pressure"].values + 5e5
        assert abs(found["repulsion"].values - pulled).max() < 1e-9 * pulled.max()

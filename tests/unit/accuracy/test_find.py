# SPDX-License-Identifier: GPL-3.0-or-later
"""Found loads agree with closed forms, and a run at a found load reaches the target value."""

import re
import sys

import pytest

import samcontact as sc
from case_texts import MINIMAL
from command import check_failure, invoke
from samcontact.cases import parse_case
from samcontact.simulation import error_controlled_quantities

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

STEEL = sc.Material.elastic(210e9, 0.3)
SOFT = sc.Material.perfect_plastic(210e9, 0.3, 1.5e9)
R, E_STAR = 7.5e-3, sc.hertz.effective_modulus(STEEL, SOFT)


def ball(load):
    size = 20e-6
    grid = sc.Grid(31, 31, size, size, dz=size)

    def gap(grid):
        return sc.surfaces.paraboloid(grid, R)

    return sc.Simulation(grid, STEEL, SOFT, gap), [{"load": load}]


@pytest.mark.parametrize(
    ("quantity", "value", "load"),
    [
        ("yield", 1.0, sc.critical.onset(R, E_STAR, 0.3, 1.5e9).load),
        ("max_pressure", 2e9, sc.hertz.point(R, E_STAR, p0=2e9).load),
        ("approach", 5e-6, sc.hertz.point(R, E_STAR, approach=5e-6).load),
    ],
)
def test_a_found_load_agrees_with_its_closed_form(quantity, value, load):
    found = sc.find_load(ball, quantity, value, largest_load=1000.0)
    assert found.value == pytest.approx(value, rel=1e-3)
    assert abs(found.load - load) < found.load_error < 0.04 * load


def test_a_run_with_the_load_reaches_the_strain():
    case = parse_case(MINIMAL)
    found = sc.find_load(case, "max_equivalent_plastic_strain", 1e-3, tolerance=1e-4)
    text = MINIMAL.replace("load = 600.0", f"load = {found.load!r}")
    simulation, path = parse_case(text).build()
    *_, peak, _ = simulation.run(path, progress=False)
    strain = error_controlled_quantities.value(peak, "max_equivalent_plastic_strain_body2")
    assert strain == pytest.approx(1e-3, rel=1e-4)
    assert found.quantity == "max_equivalent_plastic_strain_body2"


def test_permanent_deformation_is_the_sum_for_both_bodies():
    """The sum of both imprint depths, as in ISO 76: twice one depth for identical materials."""

    def identical(load):
        size = 24e-6
        grid = sc.Grid(31, 31, size, size, dz=size)
        simulation = sc.Simulation(grid, SOFT, SOFT, sc.surfaces.paraboloid(grid, R))
        return simulation, sc.paths.load_unload(load=load, increments=4, unload_increments=1)

    both = sc.find_load(identical, "permanent_deformation", 0.2e-6, largest_load=1000.0)
    one = sc.find_load(identical, "imprint_depth_body1", 0.1e-6, largest_load=1000.0)
    assert both.load == pytest.approx(one.load, rel=1e-3)
    prints = [both.states[-1].residual_displacement(body).max() for body in (1, 2)]
    assert sum(prints) == pytest.approx(0.2e-6, rel=5e-3)
    assert 0 < both.error < 0.1 * both.value  # 10 cells across a contact that has just yielded
    assert "permanent deformation, both bodies" in both._repr_html_()


def test_permanent_deformation_needs_a_body_that_yields():
    def elastic(load):
        made, path = ball(load)
        return sc.Simulation(made.grid, STEEL, STEEL, made.initial_gap), path

    with pytest.raises(
        ValueError, match='"permanent_deformation" requires an elastic-plastic body'
    ):
        sc.find_load(elastic, "permanent_deformation", 1e-6, largest_load=300.0)


def test_an_unreached_target_is_refused_with_the_largest_value():
    hertz = sc.hertz.point(R, E_STAR, load=300.0)
    with pytest.raises(ValueError, match=r"the maximum is (\S+).* at 300 N") as error:
        sc.find_load(ball, "max_pressure", 1.5 * hertz.p0, largest_load=300.0)
    assert float(str(error.value).split("the maximum is ")[1].split()[0]) == pytest.approx(
        hertz.p0, rel=0.02
    )


def test_loads_without_a_solution_limit_the_search():
    def within(load):
        made, path = ball(load)
        return sc.Simulation(made.grid, STEEL, SOFT, made.initial_gap), path

    load = sc.hertz.point(R, E_STAR, approach=5e-6).load
    found = sc.find_load(within, "approach", 5e-6, largest_load=1e6)
    assert found.load == pytest.approx(load, rel=5e-3)
    with pytest.raises(ValueError, match=r"cannot be reached: .*reaches the edge of the grid"):
        sc.find_load(within, "approach", 1e-4, largest_load=1e6)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"quantity": "max_presure", "value": 1e9}, r"got 'max_presure': did you mean max_press"),
        ({"quantity": "x" * 1000, "value": 1e9}, r"one of approach.{9,300}got '.{9,90}$"),
        ({"quantity": "imprint_depth_body1", "value": 1e9}, "for these bodies and this grid"),
        ({"quantity": "max_pressure", "value": -1.0}, "value must be"),
        ({"quantity": "approach", "value": 1e-6, "tolerance": 0.5}, "tolerance must be in"),
        ({"quantity": "approach", "value": 1e-6, "largest_load": None}, "load must be given"),
    ],
)
def test_bad_targets_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        sc.find_load(ball, **{"largest_load": 300.0} | arguments)


@pytest.mark.parametrize(
    ("quantity", "value", "message"),
    [
        ("permanent_deformation", 1.2, "1.2 µm is 1.2e-06 m"),
        ("approach", 5.0, "5 µm is 5e-06 m"),
        ("max_pressure", 2.0, "less than one cell; values are in SI units: 2 GPa is 2e.09 Pa"),
        ("max_pressure", 2e12, "cannot be reached: at loads up to 1000 N the value is below"),
        ("contact_area", 0.1, "0.1 mm² is 1e-07 m²"),
        ("contact_area", 1e-12, "one cell has an area of 400 µm²"),
        ("max_von_mises", 1e12, "cannot be reached"),
        ("max_equivalent_plastic_strain", 2.0, "values are in SI units: 2 % is 0.02"),
        ("yield", 1e3, "cannot be reached"),
    ],
)
def test_an_impossible_target_is_refused_before_a_solve(quantity, value, message, monkeypatch):
    monkeypatch.setattr(sc.Simulation, "run", None)
    with pytest.raises(ValueError, match=message):
        sc.find_load(ball, quantity, value, largest_load=1000.0)


def test_the_yield_stress_bounds_the_stress_of_a_yielding_body():
    assert sc.find_load(ball, "max_von_mises", 1.4e9, largest_load=1000.0).load > 100
    with pytest.raises(ValueError, match="yield stress at a plastic strain of 1"):
        sc.find_load(ball, "max_von_mises", 1.6e9, largest_load=1000.0)


def test_a_case_is_given_in_any_form(tmp_path):
    """All forms of a case give the same load."""
    file = tmp_path / "case.toml"
    file.write_text(MINIMAL, encoding="utf-8")
    given = (parse_case(MINIMAL), file, str(file), tomllib.loads(MINIMAL))
    loads = {sc.find_load(g, "max_pressure", 2e9, progress=False).load for g in given}
    assert len(loads) == 1
    with pytest.raises(ValueError, match=r"case must be a case of one contact.*got a float"):
        sc.find_load(1.0, "max_pressure", 2e9)


def test_each_load_is_reported_once(capsys):
    sc.find_load(ball, "yield", 1.0, largest_load=1000.0)
    lines = [line for line in capsys.readouterr().err.splitlines() if " grid, load " in line]
    assert len(lines) == len(set(lines)) > 2
    assert all(
        re.fullmatch(r"(coarse|fine) grid, load \S+ k?N: .* \S+ \(target 1\)", o) for o in lines
    )


def test_the_command_finds_and_refuses(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(MINIMAL, encoding="utf-8")
    outcome = invoke("find", file, "max_pressure=2 GPa")
    assert outcome.exit_code == 0
    assert "N ±" in outcome.stdout
    outcome = invoke("find", file, "permanent_deformation=50 nm")
    assert outcome.exit_code == 0
    assert "permanent deformation" in outcome.stdout
    check_failure(invoke("find", file, "max_pressure"), 2, "must have a value")
    check_failure(invoke("find", file, "max_presure=abc"), 2, "did you mean max_pressure")
    check_failure(invoke("find", file, "=4 GPa"), 2, "must name a quantity")
    check_failure(invoke("find", file, "yield=abc"), 2, "value of yield", "a number without a unit")
    refused = invoke("find", file, "max_pressure=5e9", "--largest-load", "700", "--quiet")
    check_failure(refused, 2, "cannot be reached: the maximum is")

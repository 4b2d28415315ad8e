# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities in units other than SI cause a warning before the solve."""

import re
import warnings

import numpy as np
import pytest

import samcontact as sc
from command import invoke
from samcontact import report, results
from samcontact.cases import parse_case
from samcontact.diagnostics.plausibility import plausibility_checks
from samcontact.problem.heating import NO_HEAT

ELASTIC = sc.Material.elastic(210e9, 0.3)

CASE = """
title = "Two balls"
[grid]
nx = 31
ny = 31
dx = 20e-6
dy = 20e-6
dz = 20e-6
[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
law = "perfect_plastic"
E = 210e9
nu = 0.3
yield_stress = 2e9
[body2.thermal]
conductivity = 50.2
expansion = 11.7e-6
diffusivity = 1.367e-5
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[heat]
factor = 0.01
[[path]]
load = 300.0
increments = 2
"""
FITS = "The contact would be plausible with"
HERTZ = "Hertz: radius 244.5 µm, p0 = 2.395 GPa"
CELLS_ACROSS, GRID_WIDTHS = "width of the Hertz contact in cells", "relative to the grid"
RADIUS_RATIO, YIELD = (
    "half-width of the Hertz contact / radius of curvature",
    "yield stress / E of body 2",
)
CAPACITY = "volumetric heat capacity (conductivity over diffusivity) of body 2"
# changed value, failing check, and names in the text
UNIT_ERRORS = {
    "cells in µm": ({"20e-6": "20.0"}, CELLS_ACROSS, f"{HERTZ}. {FITS} cells of 20 µm:"),
    "cells in mm": ({"20e-6": "0.02"}, CELLS_ACROSS, f"{HERTZ}. {FITS} cells of 20 µm:"),
    "E in GPa": ({"210e9": "210.0"}, RADIUS_RATIO, f"{FITS} E* = 115.4 GPa:"),
    "E in MPa": ({"210e9": "210e3"}, RADIUS_RATIO, f"{FITS} E* = 115.4 GPa:"),
    "E in kPa": ({"210e9": "210e6"}, GRID_WIDTHS, "E* = 115.4 GPa"),
    "radius in mm": ({"7.5e-3": "7.5"}, GRID_WIDTHS, f"{FITS} radii of 7.5 mm:"),
    "radius in µm": ({"7.5e-3": "7500.0"}, GRID_WIDTHS, f"{FITS} radii of 7.5 mm:"),
    "load": ({"300.0": "1e9"}, RADIUS_RATIO, f"p0 = 357.8 GPa. {FITS} a load of"),
    "small ball": ({"7.5e-3": "0.05e-3"}, RADIUS_RATIO, "The theory assumes half-spaces"),
    "small cells": ({"20e-6": "20e-9"}, GRID_WIDTHS, HERTZ),
    "layers": ({"dz = 20e-6": "dz = 20e-9"}, "contact in layers", "dz = 20 nm"),
    "yield in MPa": ({"2e9": "2000.0"}, YIELD, "Use Pa for both"),
    "W/(mm K)": ({"50.2": "0.0502"}, CAPACITY, "use W/(m K) for conductivity"),
    "mm²/s": ({"1.367e-5": "13.67"}, CAPACITY, "m^2/s for diffusivity"),
    "1e-6/K": ({"11.7e-6": "11.7"}, "expansion of body 2", "Steel has 1.2e-5"),
    "mm/s": ({"factor = 0.01": "factor = 1e4"}, "temperature rise", "Use m/s for heat.factor"),
}


def changed(slip):
    text = CASE
    for right, wrong in UNIT_ERRORS[slip][0].items():
        assert right in text
        text = text.replace(right, wrong)
    return text


@pytest.fixture(scope="module")
def solved():
    """Solve without a warning; the setup is correct."""
    case = parse_case(CASE)
    simulation, path = case.build()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        states = simulation.run(path, progress=False)
    return results.to_dataset(simulation, states, case)


def test_correct_units_pass(solved):
    assert all(check.passed for check in report.checks(solved))


@pytest.mark.parametrize("slip", UNIT_ERRORS)
def test_a_unit_error_causes_a_warning_before_the_solve_and_fails_a_check(slip, solved):
    _, name, message = UNIT_ERRORS[slip]
    case = parse_case(changed(slip))
    simulation, path = case.build()
    solver = sc.ContactSolver(
        simulation.grid, simulation.body1, simulation.body2, heat=simulation.heat
    )
    solves = [lambda: simulation.step(**path[-1]), lambda: simulation.run(path, progress=False)]
    if slip != "layers":  # which a contact of surfaces has not
        solves.append(lambda: solver.solve(simulation.initial_gap, **path[-1]))
    for solve in solves:
        with warnings.catch_warnings():
            warnings.simplefilter("error", sc.UnitWarning)  # so that nothing is solved
            far_below_a_cell = slip == "cells in µm"
            with pytest.raises(ValueError if far_below_a_cell else sc.UnitWarning) as caught:
                solve()
        assert name in str(caught.value)
        assert message in str(caught.value)
    loads = "increment", [step["load"] for step in path]
    checks = report.checks(solved.assign(load=loads).assign_attrs(case=case.text))
    assert [name in check.name for check in checks if not check.passed].count(True) == 1


@pytest.mark.filterwarnings("default::samcontact.UnitWarning")
def test_a_contact_far_below_a_cell_is_refused_unless_it_was_loaded():
    grid = sc.Grid(15, 15, 30e-6, 30e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    simulation = sc.Simulation(grid, ELASTIC, ELASTIC, gap)
    refused = r"in cells must be at least 0.001, got .*: Hertz: radius"
    with pytest.raises(ValueError, match=refused):
        simulation.step(load=1e-12)
    with pytest.raises(ValueError, match=refused):
        sc.ContactSolver(grid, ELASTIC, ELASTIC).solve(gap, load=1e-12)
    assert not simulation.state.pressure.any()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.UnitWarning)
        assert sc.ContactSolver(grid, ELASTIC, ELASTIC).solve(gap, load=1e-12).load > 0
    simulation.step(load=100.0)
    with pytest.warns(sc.UnitWarning, match="in cells is"):
        simulation.step(load=1e-12)
    assert simulation.state.load == pytest.approx(1e-12)


STEEL = sc.Material.perfect_plastic(210e9, 0.3, 2e9)
UNIT_ERRORS_OF_MATERIALS = {
    "hardness numbers": (STEEL.with_yield_profile([0, 1e-3], [720, 350]), "maximum yield factor"),
    "case depth in mm": (STEEL.with_yield_profile([0, 0.8, 1], [2, 1, 1]), "depth of the yield"),
    "depths in mm": (STEEL.with_residual_stress([0, 0.3], [-8e8, 0]), "depth of the residual"),
    "MPa": (STEEL.with_residual_stress([0, 3e-4], [-800, 0]), "maximum residual stress / E"),
    "E in GPa": (sc.Material.tabulated(210.0, 0.3, [0, 1e-3], [1e9, 2e9]), "maximum yield stress"),
    "E in MPa": (sc.Material.voce(2.1e5, 0.3, 1e4, 2e5, 10.0), "maximum yield stress / E"),
    "backstress in MPa": (STEEL.with_kinematic_hardening(2e4), "modulus of kinematic hardening"),
    "layer in µm": (sc.Layered([(STEEL, 5.0)], STEEL), "thickness of layers[0] of body 2"),
    "residual stress below a layer": (
        sc.Layered([(sc.Material.elastic(3e11, 0.2), 5e-6)], sc.Material.elastic(2e11, 0.3)
                   .with_residual_stress([0, 3e-4], [-800, 0])),
        "of the substrate of body 2",
    ),
    "speed in mm/s": (STEEL.with_thermal(50.2, 11.7e-6, 1.367e-5), "heat.velocity of body 2"),
}  # fmt: skip


@pytest.mark.parametrize("slip", UNIT_ERRORS_OF_MATERIALS)
def test_a_unit_error_in_a_material_causes_a_warning(slip):
    body, message = UNIT_ERRORS_OF_MATERIALS[slip]
    heat = sc.Heat(1e-3, velocity=(2e3, 0.0)) if "speed" in slip else None
    found = list(
        plausibility_checks(None, sc.Grid(8, 8, 1e-5, 1e-5), (ELASTIC, body), heat or NO_HEAT)
    )
    failed = [finding for finding in found if not finding.check.passed]
    assert any(message in finding.check.name for finding in failed)
    assert all(finding.remedy() for finding in failed)


def test_real_materials_and_layers_cause_no_warning():
    """A nitrided and a case-hardened steel, a work roll, a coating, gold and a polymer."""
    case = ([0, 0.4e-3, 0.8e-3, 1.6e-3, 1.0], [2.2, 2.1, 1.6, 1.0, 1.0])
    roll = ([0, 0.04, 0.08], [3.0, 2.8, 1.0])
    gold = sc.Material.perfect_plastic(78e9, 0.44, 5e6).with_kinematic_hardening(1e9, 50.0)
    polymer = sc.Material.tabulated(3e9, 0.4, [0, 0.1], [60e6, 120e6])
    coating = sc.Layered([(sc.Material.elastic(1e12, 0.1), 50e-9)], gold)
    bodies = [STEEL.with_yield_profile(*case).with_residual_stress([0, 5e-4], [-1e9, 0])]
    bodies += [STEEL.with_yield_profile(*roll), gold, polymer, coating]
    for body in bodies:
        found = plausibility_checks(None, sc.Grid(8, 8, 1e-5, 1e-5), (ELASTIC, body), NO_HEAT)
        assert [finding.check.name for finding in found if not finding.check.passed] == []


def test_a_solver_reports_the_first_unit_error():
    grid = sc.Grid(8, 8, 1e-5, 1e-5, dz=1e-5)
    body, message = UNIT_ERRORS_OF_MATERIALS["hardness numbers"]
    simulation = sc.Simulation(grid, ELASTIC, body, np.zeros((8, 8)), on_border="warn")
    with warnings.catch_warnings():
        warnings.simplefilter("error", sc.UnitWarning)
        with pytest.raises(sc.UnitWarning, match=message):
            simulation.step(load=1.0)


def test_limits_and_coefficients_of_wear():
    stress = 1e8 * np.sin(np.arange(3 * 6 * 2.0)).reshape(3, 6, 2)
    with pytest.warns(sc.UnitWarning, match=r"limit is 300 Pa \(≥ 1e\+04 Pa expected\)"):
        sc.fatigue.dang_van(stress, slope=0.3).margin(300.0)
    with pytest.warns(sc.UnitWarning, match="yield_stress is 900 Pa"):
        sc.fatigue.fatemi_socie(stress, k=0.3, yield_stress=900.0, material=ELASTIC)
    given = {"cycle": [{"load": 1.0}, {"load": 1.0}], "friction": sc.Coulomb(0.3), "cycles": 1}
    grid = sc.Grid(8, 8, 1e-5, 1e-5)
    with warnings.catch_warnings():
        warnings.simplefilter("error", sc.UnitWarning)
        with pytest.raises(sc.UnitWarning, match=r"archard is 1e-06 1/Pa.*1e-6 mm³/\(N m\)"):
            sc.wear.fretting(grid, ELASTIC, ELASTIC, np.zeros((8, 8)), archard=1e-6, **given)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--R", "7.5", "--E-star", "115e9", "--load", "300"], '--R is 7.5 m (≤ 1 m expected)'),
        (["--R", "7.5e-3", "--E-star", "115000", "--load", "3"], "--E-star is 1.15e+05 Pa"),
        (["--R", "7.5e-3", "--E-star", "115e9", "--p0", "1500"], "--p0 is 1.5e+03 Pa"),
        (["--R", "10 um", "--E-star", "115 GPa", "--load", "300"], "radius of curvature is 2.69"),
    ],
)  # fmt: skip
def test_the_command_reports_unit_errors(arguments, message):
    with pytest.warns(sc.UnitWarning, match=re.escape(message)):
        assert invoke("hertz", *arguments).exit_code == 0


def test_numbers_with_units_cause_no_warning():
    outcome = invoke("hertz", "--R", "4 m", "--E-star", "500 kPa", "--load", "300")
    assert (outcome.exit_code, outcome.stderr) == (0, "")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities in other units than those of the SI are told before anything is solved."""

import warnings

import pytest

import samcontact as sc
from samcontact import report, results
from samcontact.cases import parse_case

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
HERTZ = "Hertz: radius 244.5 µm, largest pressure 2.395 GPa"
CELLS, WINDOW = "width of the Hertz contact in cells", "over that of the grid"
PART, YIELD = "half width of the Hertz contact over its radius", "yield stress over E of body 2"
CAPACITY = "conductivity over diffusivity of body 2"
# what is changed, the check that fails, and what the text names
SLIPS = {
    "cells in µm": ({"20e-6": "20.0"}, CELLS, f"{HERTZ}. It would fit with cells of 20 µm:"),
    "cells in mm": ({"20e-6": "0.02"}, CELLS, f"{HERTZ}. It would fit with cells of 20 µm:"),
    "E in GPa": ({"210e9": "210.0"}, PART, "It would fit with moduli of E* = 115.4 GPa:"),
    "E in MPa": ({"210e9": "210e3"}, PART, "It would fit with moduli of E* = 115.4 GPa:"),
    "E in kPa": ({"210e9": "210e6"}, WINDOW, "moduli of E* = 115.4 GPa"),
    "radius in mm": ({"7.5e-3": "7.5"}, WINDOW, "It would fit with radii of 7.5 mm:"),
    "radius in µm": ({"7.5e-3": "7500.0"}, WINDOW, "It would fit with radii of 7.5 mm:"),
    "load": ({"300.0": "1e9"}, PART, "largest pressure 357.8 GPa. It would fit with a load of"),
    "small ball": ({"7.5e-3": "0.05e-3"}, PART, "Bodies are taken as half-spaces"),
    "small cells": ({"20e-6": "20e-9"}, WINDOW, HERTZ),
    "layers": ({"dz = 20e-6": "dz = 20e-9"}, "contact in layers", "dz = 20 nm"),
    "yield in MPa": ({"2e9": "2000.0"}, YIELD, "Both are in pascals"),
    "W/(mm K)": ({"50.2": "0.0502"}, CAPACITY, "conductivity is in W/(m K)"),
    "mm²/s": ({"1.367e-5": "13.67"}, CAPACITY, "diffusivity in m^2/s"),
    "1e-6/K": ({"11.7e-6": "11.7"}, "expansion of body 2", "Steel has 1.2e-5"),
    "mm/s": ({"factor = 0.01": "factor = 1e4"}, "rise of the temperature", "factor of heat is"),
}


def changed(slip):
    text = CASE
    for right, wrong in SLIPS[slip][0].items():
        assert right in text
        text = text.replace(right, wrong)
    return text


@pytest.fixture(scope="module")
def solved():
    """The scene as it is meant, without a warning."""
    case = parse_case(CASE)
    simulation, path = case.build()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        states = simulation.run(path, progress=False)
    return results.to_dataset(simulation, states, case)


def test_the_right_scene_passes(solved):
    assert all(check.passed for check in report.checks(solved))


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_told_before_the_solve_and_fails_a_check(slip, solved):
    _, name, told = SLIPS[slip]
    case = parse_case(changed(slip))
    simulation, path = case.build()
    solver = sc.ContactSolver(
        simulation.grid, simulation.body1, simulation.body2, heat=simulation.heat
    )
    ways = [lambda: simulation.step(**path[-1]), lambda: simulation.run(path, progress=False)]
    if slip != "layers":  # which a contact of surfaces has not
        ways.append(lambda: solver.solve(simulation.initial_gap, **path[-1]))
    for way in ways:
        with warnings.catch_warnings():
            warnings.simplefilter("error", sc.UnitWarning)  # so that nothing is solved
            with pytest.raises(sc.UnitWarning) as caught:
                way()
        assert name in str(caught.value)
        assert told in str(caught.value)
    loads = "increment", [step["load"] for step in path]
    checks = report.checks(solved.assign(load=loads).assign_attrs(case=case.text))
    assert [name in check.name for check in checks if not check.passed].count(True) == 1

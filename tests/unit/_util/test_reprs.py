# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of notebooks: parsed as HTML, they show the numbers of the object with units."""

import dataclasses
import importlib
import inspect
import math
import pkgutil
import typing
from xml.etree import ElementTree

import numpy as np
import pytest
from long_cases import long_cases
from objects_of_films import lubricants_and_films
from objects_of_inclusions import inclusions_and_lives
from objects_of_motion import viscoelastic_motion

import samcontact as sc
from samcontact import results
from samcontact._util.display import (
    MAX_REPR_CHARACTERS,
    UNIT_OF_FIELD,
    html_table,
    in_short,
    quantity,
)
from samcontact.accuracy.refinable_case import RefinableCase

E_STAR = 115384615384.6154
BALL = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)


def parsed(thing):
    """Return caption and rows; parsed as XML, so that a missing escape or end tag is an error."""
    root = ElementTree.fromstring(thing._repr_html_())
    assert root.tag == "table"
    rows = {row.findtext("th"): row.findtext("td") for row in root.iter("tr")}
    assert None not in rows
    assert None not in rows.values()
    return root.findtext("caption"), rows


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (25e-6, "m", "25 µm"),
        (1.48e9, "Pa", "1.48 GPa"),
        (999.96, "N", "1 kN"),  # rounded before the prefix is chosen
        (0.0, "N", "0 N"),
        (-3.2e-7, "m", "-320 nm"),
        (1.234567e-6, "m", "1.235 µm"),
        (2.5e-7, "m²", "0.25 mm²"),
        (3e-10, "m²", "300 µm²"),
        (0.0, "m²", "0 µm²"),
        (0.5, "m²", "0.5 m²"),
        (1234.5, "K", "1234 K"),
        (0.3, "", "0.3"),
        (math.inf, "m", "∞"),
        (math.nan, "m", "none"),
    ],
)
def test_quantities(value, unit, text):
    assert quantity(value, unit) == text


def test_grid():
    assert parsed(sc.Grid(31, 21, 25e-6, 30e-6, 10, 5e-6)) == (
        "Grid",
        {
            "cells": "31 × 21 × 10",
            "cell size": "25 µm × 30 µm × 5 µm",
            "extent": "775 µm × 630 µm × 50 µm",
        },
    )
    _, rows = parsed(sc.Grid(4, 5, 1e-3, 2e-3))
    assert rows["cells"] == "4 × 5"
    assert rows["extent"] == "4 mm × 10 mm"


def test_material():
    material = STEEL.with_kinematic_hardening(2e9, 30.0).with_thermal(50.2, 11.7e-6, 1.37e-5)
    material = material.with_softening(sc.softening.JohnsonCook(1800.0, 1.0))
    name, rows = parsed(material)
    assert name == "Material"
    assert rows.pop("softening").startswith("JohnsonCook(")
    assert rows == {
        "law": "swift",
        "E": "210 GPa",
        "nu": "0.3",
        "B": "945 MPa",
        "C": "20 microstrain",
        "n": "0.121",
        "backstress 1": "modulus 2 GPa, recovery 30",
        "conductivity": "50.2 W/(m K)",
        "thermal expansion": "11.7 µm/(m K)",
        "diffusivity": "13.7 mm²/s",
    }
    assert parsed(sc.Material.rigid()) == ("Material", {"law": "rigid"})


def test_names_are_escaped():
    class Law:
        def __call__(self, rise):
            return rise

        def __repr__(self):
            return "<script>alert('x' & 1)</script>"

    material = STEEL.with_softening(Law())
    assert "<script" not in material._repr_html_()
    assert parsed(material)[1]["softening"] == repr(Law())
    assert "<b>" not in html_table("<b>", [("<b>", "<b>")])


def test_simulation_and_state():
    grid = sc.Grid(13, 13, 60e-6, 60e-6, 12, 60e-6)
    simulation = sc.Simulation(grid, BALL, STEEL, sc.surfaces.paraboloid(grid, 7.5e-3))
    state = simulation.step(load=600.0)
    name, rows = parsed(simulation)
    assert name == "Simulation"
    assert rows["grid"] == "13 × 13 × 12 cells of 60 µm × 60 µm × 60 µm"
    assert rows["body 1"] == "elastic (E = 210 GPa, nu = 0.3)"
    assert rows["load"] == "600 N"
    pressure = f"{state.pressure.max() * 1e-9:.4g} GPa"
    assert rows["maximum pressure"] == pressure
    name, rows = parsed(state)
    assert name == "State"
    assert rows["maximum pressure"] == pressure
    assert rows["approach"] == f"{state.approach * 1e6:.4g} µm"
    assert rows["contact area"] == f"{state.contact_area * 1e6:.4g} mm²"
    strain = 100 * state.max_equivalent_plastic_strain(body=2)
    assert rows["maximum equivalent plastic strain, body 2"] == f"{strain:.4g} %"
    assert "maximum equivalent plastic strain, body 1" not in rows
    assert rows["converged"] == "yes"
    moved = simulation.step(load=600.0, advance=(-60e-6, -60e-6))
    assert parsed(moved)[1]["travel, body 2"] == "-60 µm"


def test_state_without_approach():
    grid = sc.Grid(8, 8, 60e-6, 60e-6)
    simulation = sc.Simulation(grid, BALL, BALL, sc.surfaces.paraboloid(grid, 7.5e-3))
    _, rows = parsed(simulation.step(pressure=1e9 * (sc.surfaces.paraboloid(grid, 1.0) > -1)))
    assert rows["approach"] == "none"
    assert rows["maximum pressure"] == "1 GPa"


def test_contact_solution():
    grid = sc.Grid(16, 16, 40e-6, 40e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    solution = sc.ContactSolver(grid, BALL, BALL).solve(gap, load=300.0)
    name, rows = parsed(solution)
    assert name == "ContactSolution"
    assert rows["load"] == "300 N"
    assert rows["cells in contact"] == f"{(solution.pressure > 0).sum()} of 256"
    assert float(rows["error"]) == pytest.approx(solution.error, rel=1e-3)


def test_state_with_partial_slip():
    grid = sc.Grid(16, 16, 40e-6, 40e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    simulation = sc.Simulation(grid, BALL, BALL, gap, sc.Coulomb(0.3))
    state = simulation.step(load=300.0, tangential_load=(45.0, 0.0))
    _, rows = parsed(state)
    assert rows["tangential load"] == "45 N, 0 N"
    assert rows["shift"] == f"{state.shift[0] * 1e6:.4g} µm, 0 m"
    stated = f"{state.sticking.sum()} of {np.count_nonzero(state.pressure)} in contact"
    assert rows["sticking cells"] == stated
    assert "twist" not in rows
    _, rows = parsed(simulation.step(load=300.0, twist=1e-4))
    assert rows["twist"] == "100 µrad"


def test_partial_slip_solution():
    grid = sc.Grid(16, 16, 40e-6, 40e-6)
    solver = sc.ContactSolver(grid, BALL, BALL, sc.Coulomb(0.3))
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    solution = solver.solve(gap, load=300.0, tangential_load=(45.0, 0.0))
    name, rows = parsed(solution)
    assert name == "PartialSlipSolution"
    assert rows["tangential load"] == "45 N, 0 N"
    assert rows["sticking cells"] == str(solution.sticking.sum())
    assert "friction=Coulomb(coefficient=0.3)" in repr(solver)


CLOSED_FORMS = [
    sc.hertz.point(7.5e-3, E_STAR, load=1500.0),
    sc.hertz.elliptic(7.5e-3, 20e-3, E_STAR, load=1500.0),
    sc.hertz.line(7.5e-3, E_STAR, p0=1e9),
    sc.critical.green(7.5e-3, E_STAR, 0.3, 1e9),
    sc.critical.green_cylinder(7.5e-3, E_STAR, 0.3, 1e9),
    sc.critical.onset_sliding(7.5e-3, E_STAR, 0.3, 1e9, 0.2),
    sc.critical.onset_over_depth(7.5e-3, E_STAR, sc.Material.perfect_plastic(210e9, 0.3, 1e9)),
    sc.critical.onset_cylinder_over_depth(
        7.5e-3, E_STAR, sc.Material.perfect_plastic(210e9, 0.3, 1e9)
    ),
]


@pytest.mark.parametrize("thing", CLOSED_FORMS, ids=lambda thing: type(thing).__name__)
def test_closed_forms(thing):
    name, rows = parsed(thing)
    assert name == type(thing).__name__
    assert list(rows) == [field.name for field in dataclasses.fields(thing)]
    for field, text in rows.items():
        number, _, unit = text.partition(" ")
        factors = {"n": 1e-9, "µ": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6, "G": 1e9}
        prefix = unit.removesuffix(UNIT_OF_FIELD[field])
        value = float(number) * factors[prefix] if prefix else float(number)
        assert value == pytest.approx(getattr(thing, field), rel=6e-4), field


def test_plain_text_reprs_are_unchanged():
    grid = sc.Grid(4, 4, 1e-6, 1e-6)
    assert repr(grid) == "Grid(nx=4, ny=4, dx=1e-06, dy=1e-06, nz=0, dz=None, periodic='')"
    assert repr(CLOSED_FORMS[0]).startswith("PointContact(R=0.0075, E_star=")


GEARS = sc.parts.GearPair(0.013 / 3, (16, 24), 0.043 / 3, 1 / 3, (0.1, 0.1), crowning=1e-5 / 3)
CAM = sc.parts.Cam.harmonic(0.1 / 3, 0.01 / 3, 2.5)
LINE = np.column_stack([np.linspace(-0.03, 0.03, 31), np.linspace(-0.03, 0.03, 31) ** 2])
PARTS = [
    GEARS, GEARS.at("B"), CAM, CAM.at(1 / 3), sc.parts.WheelRail(LINE, LINE * [1, -1], 0.46),
    sc.overrolling.Particle(1e-3 / 3, approach=1e-6 / 3),
]  # fmt: skip


FRICTION_LAWS = (
    sc.Coulomb(0.3),
    sc.Tresca(1e9 / 3),
    sc.CappedCoulomb(1 / 3, 1e9 / 3),
    sc.Anisotropic(1 / 3, 1 / 7),
    sc.ThermalCoulomb([0.0, 100 / 3], [1 / 3, 1 / 7]),
    sc.ThirdBody(1 / 3, 1e9 / 3, 1e9 / 7, 1e-6 / 3),
    sc.FallingCoulomb(1 / 3, 1 / 7, 1 / 9),
    sc.MappedCoulomb([1 / 3] * 100, y=[n / 3 for n in range(100)]),
)


def public_objects():
    """Return one object of each public class."""
    grid = sc.Grid(40, 30, 60e-6, 60e-6, 3, 60e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    heights = np.array(gap)
    heights[3, 4] = np.nan
    steel = STEEL.with_kinematic_hardening([1e9] * 4, [30.0] * 4).with_thermal(50.2, 12e-6, 1e-5)
    steel = steel.with_softening(sc.softening.JohnsonCook(1800.0, 1.0))
    relief, heat = sc.Relief(1e-9 * heights[:2], -3), sc.Heat(1 / 3, (1 / 3, 1 / 7))
    simulation = sc.Simulation(grid, steel, steel, gap, relief1=relief, heat=heat)
    state = simulation.step(load=10.0)
    solver = sc.ContactSolver(grid, steel, steel, 0.1, heat=heat)
    collision = sc.asperities.Collision(1e-3, 1e-3, 1e-6)
    values = ((0.1,),) * 5, (1.0, 1.0, 1.0, 9.0), ((9.0,), (0.0,))
    cycle = sc.wear.Cycle(1, *values[0], *values[1], *values[2])
    scar = sc.wear.FrettingCycle(
        1, 2, 0.1, (0.1,), (0.1,), (0.1,), 0.1, 1.0, 1.0, 1.0, 9.0, (0.0,), 0.0, (0.0,)
    )
    worn = {2: np.stack([gap] * 5)}
    pass_ = sc.shakedown.Cycle(1, 1e-3 / 3, 1e-3 / 7)
    bent = sc.Simulation(grid, steel, steel, gap)
    bent.set_plastic_strain(2, np.full((6, 40, 30, 3), 1e-3))
    load = sc.flattening.kogut_etsion(np.linspace(1e-9, 1e-7, 500), 1e-3, 1e11, 0.3, 1e9)
    series = results.to_dataset(simulation, [state])
    balls = {
        "body1": {"law": "rigid"},
        "body2": {"law": "elastic", "E": 210e9, "nu": 0.3},
        "surface": {"shape": "paraboloid", "Rx": 7.5e-3},
        "path": [{"load": 10.0}],
    }
    return [
        sc.to_accuracy(balls, 0.5),
        RefinableCase(sc.to_accuracy(balls, 0.5).case),
        sc.Layered([(BALL, 1e-6 / 3)] * 3, BALL),
        grid, steel, relief, heat, simulation, state, state.track(), solver,
        sc.overrolling.Overrolling(state.track(), [state] * 50), collision, cycle, load,
        sc.IncrementErrors({"pressure": 0.1}, {}, "half as many"),
        *bent.state.zones(2), sc.estimate_errors(simulation, [{"load": 10.0}], [state]),
        sc.FoundLoad("max_pressure", 1.0 / 3, 1e-3, 1e9 / 3, 1e6 / 3, [state] * 100),
        sc.ContactSolver(grid, BALL, BALL).solve(gap, load=10.0),
        *FRICTION_LAWS,
        sc.HardContact(), sc.TensileLimit(1e6 / 3), *adhesive_contacts(),
        sc.ContactSolver(grid, BALL, BALL, sc.Coulomb(0.3)).solve(gap, load=10.0),
        sc.rolling.steady(grid, BALL, BALL, gap, load=10.0, friction=sc.Coulomb(0.3)),
        sc.energy.EnergyBalance(1 / 3, 1 / 7, 1 / 9, 1 / 11, 1 / 13, 1 / 17),
        sc.measured.MeasuredSurface(heights, 1e-6, attrs={"source": "s" * 3000}),
        sc.asperities.CollisionResult(collision, simulation, series, [state]),
        sc.wear.WearResult(grid, (2,), [cycle] * 50, 1, None, relief, worn, {2: 0}, [state], None),
        scar, sc.wear.FrettingResult(grid, (2,), [scar] * 50, True, None, relief, worn, {2: 0},
                                     (state,) * 4, None),
        sc.fatigue.steady_cycle(state), sc.fatigue.findley(sc.fatigue.steady_cycle(state), k=1 / 3),
        *hardened_flank(), sc.materials.get("52100"), sc.materials.get("52100").values["E"],
        sc.shakedown.line(0.3), pass_, sc.shakedown.ShakedownResult(
            "ratcheting", 1e-3 / 3, 1e-3 / 7, (pass_,) * 50, 60, 1e-4 / 3, 1, 1e-3 / 9, state, {}),
        *PARTS, steel.softening, *CLOSED_FORMS, sc.bearings.load_zone(1e3, 500.0, 9, 0.4),
        sc.bearings.standard("6208"), sc.bearings.standard("6208").element_loads(1e3),
        sc.bearings.ball_on_race(0.01, 0.05, conformity=0.52),
        *long_cases(),
        *viscoelastic_motion(), *inclusions_and_lives(), *lubricants_and_films(),
    ]  # fmt: skip


def adhesive_contacts():
    """Return laws of adhesion, closed forms, and a pull-off."""
    laws = [
        sc.Adhesion.exponential(0.1 / 3, 1e-9), sc.Adhesion.dugdale(0.1 / 3, 1e7 / 3),
        sc.Adhesion.lennard_jones(0.1 / 3, 1e-9 / 3),
        sc.Adhesion.tabulated(np.linspace(0.0, 1e-9, 40), np.linspace(1e8, 0.0, 40) / 3),
    ]  # fmt: skip
    forms = [
        sc.adhesion.jkr(1e-6, 0.1 / 3, 1e9), sc.adhesion.maugis(1e-6, 0.1 / 3, 1e9, 1e7),
        sc.adhesion.wave(1e-6, 1e-8, 0.1 / 3, 1e9),
        sc.adhesion.jkr_profile(lambda r: r, np.linspace(1e-9, 1e-8, 99), 0.1 / 3, 1e9),
    ]  # fmt: skip
    on = laws[0].on(sc.Grid(9, 9, 1e-9, 1e-9), BALL, BALL)
    pulled = sc.paths.PullOff([1.0] * 200, 1e-6 / 3, 1e-9 / 3, 1e-15 / 3, True)
    return [*laws, on, *forms, pulled, sc.paths.Retraction(1e-9 / 3, speed=1e-6 / 3)]


def hardened_flank():
    case = sc.hardness.hardened_case(390.0, 300.0, 1e-3 / 3, limit=350.0)
    body = sc.Material.elastic(206e9, 0.3)
    cycle = sc.fatigue.hertz_cycle(sc.hertz.line(1e-2, 1e11, p0=1e9 / 3), body)
    life = sc.fatigue.life(sc.fatigue.orthogonal_shear(cycle))
    return case, sc.fatigue.exposure(cycle, case), life


def public_classes():
    """All but errors and warnings, which show their message."""
    names = [module.name for module in pkgutil.iter_modules(sc.__path__)]
    shown = [name for name in names if not name.startswith("_") and name != "commands"]
    modules = [sc, *(importlib.import_module(f"samcontact.{name}") for name in shown)]
    named = [getattr(m, name) for m in modules for name in getattr(m, "__all__", ())]
    classes = [c for c in named if inspect.isclass(c) and typing.get_origin(c) is None]  # 3.10
    return {c for c in classes if not issubclass(c, BaseException)}


def test_no_repr_is_long():
    things = public_objects()
    assert {c for c in public_classes() if not any(isinstance(t, c) for t in things)} == set()
    for thing in things:
        text = repr(thing)
        assert text.startswith(f"{type(thing).__name__}("), text
        assert len(text) <= 1000, text
        assert " at 0x" not in text
        assert "\n" not in text


def test_arrays_are_shown_by_shape_and_range():
    heights = np.array([[1.0, np.nan, -2.0], [0.5, 0.25, 3.0]])
    surface = sc.measured.MeasuredSurface(heights, 1e-6)
    assert repr(surface) == (
        "MeasuredSurface(heights=<array 2 x 3, -2 to 3, 1 NaN>, dx=1e-06, dy=1e-06, attrs={})"
    )
    relief = sc.Relief(np.zeros((2, 3)), 5)
    shown = "Relief(heights=<array 2 x 3, 0 to 0>, first=5, periodic=False, worn=None)"
    assert repr(relief) == shown
    assert in_short(np.zeros(0)) == "<array 0>"
    assert in_short(np.full(2, np.nan)) == "<array 2, 2 NaN>"
    assert in_short(["a" * 200]) == "<list>"
    assert in_short(list(range(1000))) == "<list of 1000>"
    assert len(in_short("a" * 1000)) < MAX_REPR_CHARACTERS
    grid = sc.Grid(4, 4, 1e-6, 1e-6)
    assert repr(sc.ContactSolver(grid, sc.Material.rigid(), BALL, tol=1e-6)).endswith(
        "friction=0.0, tol=1e-06, on_border='error', on_stall='error', "
        "max_iterations=5000, adhesion=HardContact(), heat=Heat(factor=(0.0, 0.0)))"
    )

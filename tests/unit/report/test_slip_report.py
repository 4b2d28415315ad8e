# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy balance in partial slip, and its section in a report."""

import itertools
import math
import re

import numpy as np
import pytest

import samcontact as sc
from case_texts import BODIES, GRID
from samcontact import energy, report, results
from samcontact.cases import parse_case
from samcontact.results.slipping import balance_of

CASE = f"""title = "Fretting"
{GRID}
{BODIES}
[contact]
friction = {{coulomb = 0.3}}
[[path]]
load = 600.0
increments = 3
[[path]]
load = 600.0
increments = 3
fret = {{tangential_load_x = 120.0}}
"""
pytestmark = pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")


def test_cells_that_touch_without_pressure_may_carry_shear_up_to_a_constant_limit():
    """The check of the friction law fails for the same shear in a cell with a gap."""
    grid, body = sc.Grid(9, 9, 90e-6, 90e-6), sc.Material.elastic(210e9, 0.3)
    law = sc.Tresca(200e6)
    simulation = sc.Simulation(grid, body, body, sc.surfaces.paraboloid(grid, 7.5e-3), law)
    step = {"load": 600.0, "tangential_load": (30.0, 0.0)}
    data = results.to_dataset(simulation, [simulation.step(**step)])
    data["shear_x"][0, 0, 0] = law.limit

    def excess():
        (check,) = [one for one in report.checks(data) if "friction law" in one.name]
        return check

    assert not excess().passed
    data["gap"][0, 0, 0] = 0.0
    assert excess().passed


@pytest.fixture(scope="module")
def data():
    case = parse_case(CASE)
    simulation, path = case.build()
    return results.to_dataset(simulation, simulation.run(path, progress=False), case)


def balances(body2, friction, counts, force):
    """Return energy balances of a ball in fretting, for increasing numbers of increments."""
    grid = sc.Grid(21, 21, 34e-6, 34e-6, dz=34e-6)
    body1 = sc.Material.elastic(210e9, 0.3)
    for count in counts:
        simulation = sc.Simulation(
            grid, body1, body2, sc.surfaces.paraboloid(grid, 7.5e-3), sc.Coulomb(friction)
        )
        path = sc.paths.ramp(load=300.0, increments=count)
        path += sc.paths.fretting_loop(load=300.0, force=(force, 0.0), increments=count)
        path += [
            {"load": part * 300.0, "tangential_load": (part * force, 0.0)}
            for part in 1 - np.arange(1, count + 1) / count
        ]
        yield energy.balance(simulation, simulation.run(path, progress=False))


HARDENING = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 20e9)
KINEMATIC = sc.Material.perfect_plastic(210e9, 0.3, 1.2e9).with_kinematic_hardening(20e9, 10.0)


@pytest.mark.parametrize(
    ("body2", "friction"),
    [(sc.Material.elastic(100e9, 0.2), 0.3), (HARDENING, 0.3), (KINEMATIC, 0.3)],
    ids=["dissimilar", "yields", "kinematic"],
)
def test_the_energy_imbalance_decreases_with_the_increments(body2, friction):
    few, many = balances(body2, friction, (2, 6), 60.0)
    assert abs(many.imbalance) < 0.5 * abs(few.imbalance) < 0.01
    assert many.elastic_energy == pytest.approx(0, abs=1e-9 * many.work_input)  # released
    assert many.friction_work > 0.01 * many.work_input
    assert (many.plastic_work > 0) == (many.residual_energy > 0) == body2.is_plastic
    assert 0 < many.net_external_work < many.work_input


def test_pressing_elastic_balls_has_no_error():
    """One increment has the exact work 2/5 load times approach, as load ~ approach^(3/2)."""
    grid = sc.Grid(61, 61, 10e-6, 10e-6)
    body = sc.Material.elastic(210e9, 0.3)
    simulation = sc.Simulation(
        grid, body, body, sc.surfaces.paraboloid(grid, 7.5e-3), sc.Coulomb(0.3)
    )
    states = [simulation.state, *simulation.run([{"load": 300.0}], progress=False)]
    found = energy.balance(simulation, states)
    hertz = sc.hertz.point(7.5e-3, 210e9 / 1.82, load=300.0)
    assert found.work_input == pytest.approx(0.4 * 300.0 * hertz.approach, rel=2e-3)
    assert abs(found.imbalance) < 2e-3
    assert (found.friction_work, found.plastic_work, found.residual_energy) == (0.0, 0.0, 0.0)


def test_initial_energy_is_not_counted_as_imbalance():
    """The run is a continuation, and the body has initial strain."""
    grid = sc.Grid(21, 21, 34e-6, 34e-6, dz=34e-6, nz=12)
    simulation = sc.Simulation(
        grid, sc.Material.elastic(210e9, 0.3), KINEMATIC, sc.surfaces.paraboloid(grid, 7.5e-3),
        sc.Coulomb(0.3),
    )  # fmt: skip
    strain = np.zeros((6, *grid.volume_shape))
    strain[:3, 8:13, 8:13, 2:5] = np.array([1e-3, 1e-3, -2e-3])[:, None, None, None]
    simulation.set_plastic_strain(2, strain)
    pulled = {"load": 300.0, "tangential_load": (60.0, 0.0)}
    simulation.run([{"load": 300.0}, pulled], progress=False)
    path = [{"load": 300.0, "tangential_load": (60.0 - 12.0 * n, 0.0)} for n in range(6)]
    found = energy.balance(simulation, simulation.run(path, progress=False))
    assert abs(found.imbalance) < 0.002
    assert (
        min(found.residual_energy, found.friction_work, found.plastic_work)
        > 5e-4 * found.work_input
    )


def test_unknown_balances_are_refused():
    grid = sc.Grid(15, 15, 50e-6, 50e-6)
    body = sc.Material.elastic(210e9, 0.3)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    given = sc.Simulation(grid, body, body, gap, 0.3)
    with pytest.raises(ValueError, match="got prescribed tractions"):
        energy.balance(given, [given.step(pressure=np.zeros(grid.surface_shape))])
    rolls = sc.Simulation(grid, body, body, gap, sc.Coulomb(0.3))
    with pytest.raises(ValueError, match="at least one state, got none"):
        energy.balance(rolls, [])
    path = [{"load": 300.0}, {"load": 300.0, "advance": (50e-6, 50e-6)}]
    states = rolls.run(path, progress=False)
    assert "work_input" not in results.to_dataset(rolls, states)


@pytest.mark.parametrize("cells", [11, pytest.param(19, marks=pytest.mark.slow)])
def test_the_energy_balance_of_hot_bodies_includes_the_work_of_expansion(cells):
    size = 714e-6 / cells
    grid = sc.Grid(cells, cells, size, size, dz=size)
    thermal = 50.0, 12e-6, 1.4e-5
    bodies = (
        sc.Material.elastic(210e9, 0.3).with_thermal(*thermal),
        HARDENING.with_thermal(*thermal),
    )
    found = []
    for count in (1, 3):
        simulation = sc.Simulation(
            grid, *bodies, sc.surfaces.paraboloid(grid, 7.5e-3), sc.Coulomb(0.3), tol=1e-4,
            heat=sc.Heat(partition=0.4),
        )  # fmt: skip
        path = sc.paths.ramp(load=300.0, increments=count)
        path += sc.paths.fretting_loop(load=300.0, force=(80.0, 0.0), increments=count)
        timed = [step | {"duration": 1e-5 / count} for step in path]
        states = simulation.run(timed, progress=False)
        found.append(energy.balance(simulation, states))
    few, many = found
    assert many.expansion_work > 0.02 * many.work_input
    assert abs(many.imbalance) < 0.1 * many.expansion_work / many.work_input
    assert abs(many.imbalance) < 0.5 * abs(few.imbalance)
    data = results.to_dataset(simulation, states)
    assert balance_of(data).imbalance == pytest.approx(many.imbalance)


def test_the_work_of_gross_slip_is_dissipated():
    """In a closed cycle of reversed sliding, friction dissipates the work of the force."""
    grid, body = sc.Grid(13, 13, 55e-6, 55e-6), sc.Material.elastic(210e9, 0.3)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    simulation = sc.Simulation(grid, body, body, gap, sc.Coulomb(0.3))
    distance = 40e-6
    signs = [*[1] * 8, *[-1] * 16, *[1] * 16]
    path = [{"load": 300.0, "shift": (sign * distance / 16, 0.0)} for sign in signs]
    states = simulation.run([{"load": 300.0}, *path], progress=False)
    start, end = states[8], states[-1]
    for state in (start, end):
        assert not state.sticking.any()
    done = np.diff([s.shift[0] for s in states[8:]]) * [
        0.5 * (a.tangential_load[0] + b.tangential_load[0])
        for a, b in itertools.pairwise(states[8:])
    ]
    work = end.friction_work - start.friction_work
    assert 0.8 < work / (2 * 0.3 * 300.0 * distance) < 1
    assert done.sum() == pytest.approx(work, rel=0.01)
    assert abs(energy.balance(simulation, states).imbalance) < 0.01


def named(checks_found, start):
    (found,) = [check for check in checks_found if check.name.startswith(start)]
    return found


@pytest.mark.parametrize(
    ("start", "name", "change"),
    [
        ("friction law", "shear_x", lambda s: 1.001 * s),
        ("friction law", "shear_x", lambda s: s + 1e3),  # where the bodies are apart
        ("tangential force balance", "shear_x", lambda s: 0.999 * s),
        ("minimum frictional work", "friction_work", lambda w: w - 1e-12 * w["increment"]),
        ("energy balance", "friction_work", lambda w: 5 * w),
        ("energy balance", "elastic_energy", lambda e: math.nan * e),
    ],
)
def test_every_check_can_fail(data, start, name, change):
    assert named(report.checks(data), start).passed
    spoilt = data.copy(deep=True)
    spoilt[name] = change(spoilt[name])
    assert not named(report.checks(spoilt), start).passed


def test_the_page_has_a_section_on_partial_slip(data, tmp_path):
    text = report.write(data, tmp_path / "report.html").read_text(encoding="utf-8")
    for heading in ("Partial slip", "Energy balance", "Stick and slip zones, increment 18"):
        assert heading in text
    assert "Tangential force versus displacement" in text
    table = text.split('id="slipping-table"')[1].split("</table>")[0]
    assert re.findall(r'scope="col" class="number">(.*?)</th>', table) == [
        "tangential force, x [N]", "tangential displacement, x [µm]", "frictional work [µJ]",
        "stick fraction [%]",
    ]  # fmt: skip
    last = re.findall(r'<data value="(.*?)">', table)[-4:]
    names = ("tangential_load_x", "shift_x", "friction_work", "stick_fraction")
    assert [float(value) for value in last] == [float(data[name][-1]) for name in names]
    parts = text.split('id="energy-table"')[1].split("</table>")[0]
    values = [float(v) for v in re.findall(r'<data value="(.*?)">', parts)[::2]]
    net, *found = values
    assert net == pytest.approx(sum(found), rel=1e-12)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files with partial slip: paths and error messages."""

import math
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

import samcontact as sc
from case_texts import BODIES, GRID
from samcontact import paths
from samcontact.cases import CaseError, load_case, parse_case
from samcontact.commands.folder import is_own
from samcontact.commands.solve_contact import solve_contact
from samcontact.results import open_results
from samcontact.results.slipping import moved_along, without_rounding
from samcontact.simulation import coarsening

CASES = Path(__file__).parents[3] / "cases"
LAW = "friction = {coulomb = 0.3}"
PRESSED = "[[path]]\nload = 600.0\nincrements = 2\n"


def case(*segments, friction=LAW, more=""):
    path = "".join(f"[[path]]\n{segment}\n" for segment in segments)
    return parse_case(
        f'title = "t"\n{GRID}\n{BODIES}\n[contact]\n{friction}\n{PRESSED}{path}{more}'
    )


@pytest.mark.parametrize("mu", ["0.3", "0", "inf"])
def test_a_friction_law_reaches_the_simulation(mu):
    simulation, _ = case(friction=f"friction = {{coulomb = {mu}}}").build()
    assert simulation.friction == sc.Coulomb(float(mu))
    assert case(friction="friction = 0.3").build()[0].friction == 0.3


LAWS = {
    "{tresca = 2e8}": sc.Tresca(2e8),
    "{tresca = '200 MPa'}": sc.Tresca(2e8),
    "{tresca = inf}": sc.Tresca(math.inf),
    "{capped_coulomb = {coefficient = 0.3, limit = '200 MPa'}}": sc.CappedCoulomb(0.3, 2e8),
    "{capped_coulomb = {coefficient = 0.3, limit = inf}}": sc.CappedCoulomb(0.3, math.inf),
    "{anisotropic = {mu_x = 0.4, mu_y = 0.2, angle = '500 mrad'}}": sc.Anisotropic(0.4, 0.2, 0.5),
    "{mapped_coulomb = {coefficient = [0.2, 0.4], y = ['-1 mm', 0.001]}}": sc.MappedCoulomb(
        (0.2, 0.4), (), (-1e-3, 1e-3)
    ),
}


@pytest.mark.parametrize("text", LAWS)
def test_laws_with_a_limit(text):
    simulation, path = case("load = 600.0\nshift_x = 2e-6", friction=f"friction = {text}").build()
    assert simulation.friction == LAWS[text]
    state = simulation.run(path, progress=False)[-1]
    bound = LAWS[text].bound(state.pressure)
    assert 0 < state.tangential_load[0] <= bound.sum() * simulation.grid.cell_area
    assert (np.hypot(*state.shear) <= bound * (1 + 1e-12)).all()


def test_ramps_go_along_the_surface():
    steps = case(
        "load = 600.0\nincrements = 2\ntangential_load_x = 100.0\nshift_y = 4e-6\ntwist = 1e-4",
        "load = 900.0\nincrements = 1\ntangential_load_x = -20.0\ntangential_load_y = 0.0\n"
        "torque = 0.02",
        "load = 300.0\nincrements = 2\ntangential_load_x = '0.02 kN'\ntangential_load_y = 40.0\n"
        "torque = 0.0",
        "load = 0.0\nincrements = 1",
        "load = 300.0\nincrements = 2\nspacing = 'power'\ntangential_load_x = 40.0\nshift_y = 1e-6",
    ).steps()
    parts = {"shift": (None, 2e-6), "tangential_load": (50.0, None), "twist": 5e-5}
    assert steps[2:4] == [
        {"load": 600.0} | parts,
        {"load": 600.0} | parts | {"tangential_load": (100.0, None)},
    ]
    assert steps[4] == {"load": 900.0, "tangential_load": (-20.0, 0.0), "torque": 0.02}
    assert steps[5] == {"load": 600.0, "tangential_load": (0.0, 20.0), "torque": 0.01}
    assert steps[7] == {"load": 0.0}
    # the same shares as the load, from nothing, since the bodies have been apart
    assert steps[8] == {"load": 75.0, "tangential_load": (10.0, None), "shift": (None, 2.5e-7)}


def test_fretting_is_that_of_paths():
    force = {"force": (120.0, 0.0), "cycles": 2, "increments": 3}
    shift = {"shift": (0.0, -2e-6), "increments": 1}
    steps = case(
        "load = 600.0\nincrements = 3\nfret = {tangential_load_x = 120, cycles = 2}",
        "load = 600.0\nincrements = 1\nfret = {shift_y = '-2 um'}",
    ).steps()
    assert steps[2:] == paths.fretting_loop(load=600.0, **force) + paths.fretting_loop(
        load=600.0, **shift
    )


def test_a_case_reaches_its_forces():
    read = case(
        "load = 600.0\nincrements = 1\nfret = {tangential_load_x = 120.0}",
        "load = 600.0\nincrements = 1\nadvance = [-60e-6, -60e-6]\ntangential_load_x = 100.0",
    )
    simulation, path = read.build()
    states = simulation.run(path, progress=False)
    found = [float(state.tangential_load[0]) for state in states]
    np.testing.assert_allclose(found, [0, 0, 120, 0, -120, 0, 120, 100], atol=1e-3)
    assert read.moves


def test_rolling_may_creep_either_way():
    for ratio in (-0.002, 0.002):
        roll = f"roll = {{distance = 180e-6, step = 60e-6, slide_to_roll = {ratio}}}"
        text = f"load = 0.0\nincrements = 1\n[[path]]\nload = 600.0\n{roll}"
        steps = case(text).steps()
        assert steps[-11]["advance"] == pytest.approx(
            (-60e-6 * (1 + ratio / 2), -60e-6 * (1 - ratio / 2))
        )


def test_rolling_comes_to_the_steady_state_of_its_creepages():
    """Signs and units agree, with all three creepages and with a force."""
    grid = sc.Grid(31, 31, 22e-6, 22e-6)
    body, gap = sc.Material.elastic(210e9, 0.3), sc.surfaces.paraboloid(grid, 7.5e-3)
    law, rolls = sc.Coulomb(0.4), {"load": 300.0, "distance": 100 * 22e-6, "step": 22e-6}
    for drive, steady in (
        (
            {"slide_to_roll": -1e-3, "lateral_creepage": 5e-4, "spin": 4.0},
            {"creepage": (1e-3, 5e-4), "spin": 4.0},
        ),
        (
            {"tangential_load_x": -40.0, "lateral_creepage": -1e-3},
            {"tangential_load": (-40.0, None), "creepage": (None, -1e-3)},
        ),
    ):
        path = paths.rolling(**rolls, increments=1, unload_increments=1, **drive)
        states = sc.Simulation(grid, body, body, gap, law).run(path, progress=False)
        expected = sc.rolling.steady(grid, body, body, gap, load=300.0, friction=law, **steady)
        found = states[-2].tangential_load
        np.testing.assert_allclose(found, expected.tangential_load, atol=0.5)
        assert states[-2].torque == pytest.approx(expected.torque, rel=0.03)
        slip = (states[-2].shift - states[-3].shift) / grid.dx
        np.testing.assert_allclose(slip, expected.creepage, atol=2e-5)
    with pytest.raises(ValueError, match="slide_to_roll must be 0 with tangential_load_x"):
        paths.rolling(**rolls, slide_to_roll=0.1, tangential_load_x=1.0)


def test_cells_twice_as_large_take_twice_the_motion():
    step = {"load": 1.0, "advance": (1.001e-5, 1e-5), "shift": (None, 2e-8), "twist": 1e-6}
    step["tangential_load"] = (0.1, None)
    halved, which = coarsening.coarser_path([step] * 4, (1e-5, 1e-5))
    assert which == [0, 0, 1, 1]
    assert halved[0] == step | {
        "advance": (2.002e-5, 2e-5), "shift": (None, 4e-8), "twist": 2e-6
    }  # fmt: skip


def test_forces_scale_with_other_loads():
    read = case(
        "load = 600.0\nincrements = 1\ntangential_load_y = 0.0\nshift_x = 0.0",
        "load = 600.0\nfret = {tangential_load_y = 50.0}",
        "load = 700.0\ntangential_load_x = 20.0\ntorque = 1.0\nincrements = 1",
    )
    fretted, pulled = (segment.scaled(2.0) for segment in read.path[-2:])
    assert (fretted.load, fretted.fret.tangential_load_y) == (1200.0, 100.0)
    assert (pulled.load, pulled.tangential_load_x, pulled.torque) == (1400.0, 40.0, 2.0)


@pytest.mark.parametrize(
    ("segment", "message"),
    [
        ("load = 700.0\nforce_x = 1.0", r"path\[1\]\.force_x: .*did you mean tangential_load_x\?"),
        ("load = 700.0\nmoment = 1.0", r"path\[1\]\.moment: .*did you mean moment_x\?"),
        ("load = 700.0\nshift_x = '1 N'", r"path\[1\]\.shift_x: must be .* converts to m, got"),
        (
            "load = 700.0\nshift_x = 1.0\ntangential_load_x = 1.0",
            r"path\[1\]: shift_x cannot be combined with tangential_load_x",
        ),
        (
            "load = 600.0\ntangential_load_x = 200.0",
            r"path\[1\]: tangential load must be below the friction limit \("
            r"180\.0 N at load 600\.0 N\), got 180\.0 N: prescribe shift_x",
        ),
        (
            "load = 600.0\nshift_x = 1e-6\n[[path]]\nload = 600.0\ntangential_load_x = 1.0",
            r"path\[2\]: tangential_load_x must not change in several increments",
        ),
        (
            "load = 300.0\nfret = {shift_x = 1e-6}",
            r"path\[1\]: fret requires .* ends at load = 300\.0, got load = 600",
        ),
        (
            "load = 600.0\ntangential_load_y = 9.0\n[[path]]\nload = 600.0\n"
            "fret = {tangential_load_x = 1.0}",
            r"path\[2\]: fret with a force must start at zero .* at \[0\.0, 9\.0\] N",
        ),
        ("load = 600.0\nfret = {cycles = 2}", r"path\[1\]\.fret: fret requires either a motion"),
        ("load = 600.0\nfret = {shift_x = 0.0}", r"path\[1\]\.fret: the amplitude of the motion"),
        (
            "load = 600.0\nshift_x = 1.0\nfret = {shift_x = 1.0}",
            r"path\[1\]: fret cannot be combined with shift_x: omit shift_x$",
        ),
        (
            "load = 600.0\nadvance = [1e-6, 1e-6]\ntorque = 1.0",
            r"path\[1\]: torque cannot be combined with advance: prescribe twist",
        ),
        (
            "load = 600.0\nroll = {distance = 1.0, step = 1.0}\nfret = {shift_x = 1.0}",
            r"path\[1\]: roll and fret cannot be combined",
        ),
    ],
)
def test_errors_name_field_and_remedy(segment, message):
    with pytest.raises(CaseError, match=message):
        case(segment)


@pytest.mark.parametrize(
    ("friction", "message"),
    [
        ("-0.1", r"contact\.friction: must be a finite number >= 0, got -0\.1"),
        ("{coulomb = -0.1}", r"contact\.friction\.coulomb: must be a number >= 0"),
        ("{coulomb = nan}", r"contact\.friction\.coulomb: must be a number >= 0"),
        ("{coulom = 0.1}", r"contact\.friction\.coulom: unknown field; .*did you mean coulomb\?"),
        ("{mu = 0.1}", r"contact\.friction\.mu: unknown field; .*did you mean coulomb\?"),
        ("inf", r"contact\.friction: must be a finite number >= 0, got inf"),
        ("{coulomb = 0.1, tresca = 1e8}", r"exactly one of .*tresca.*, got coulomb, tresca"),
        ("{}", r"contact\.friction: exactly one of coulomb, tresca.*, got none"),
        ("{tresca = -1.0}", r"contact\.friction\.tresca: must be a number >= 0"),
        ("{capped_coulomb = 0.3}", r"contact\.friction\.capped_coulomb: must be a"),
        ("{capped_coulomb = {coefficient = 0.3}}", r"friction\.capped_coulomb\.limit: .*missing"),
        (
            "{capped_coulomb = {coefficient = inf, limit = 1e8}}",
            r"friction\.capped_coulomb\.coefficient: must be a finite number >= 0, got inf",
        ),
    ],
)
def test_errors_of_laws_name_the_field(friction, message):
    with pytest.raises(CaseError, match=message):
        case(friction=f"friction = {friction}")


def test_fields_unused_in_full_sliding_are_refused():
    with pytest.raises(CaseError, match=r"path\[1\]: shift_x, twist requires Coulomb friction"):
        case("load = 700.0\nshift_x = 1e-6\ntwist = 0.0", friction="friction = 0.3")
    with pytest.raises(CaseError, match=r"path\[2\]: roll\.spin requires Coulomb friction"):
        case(
            "load = 0.0", "load = 9.0\nroll = {distance = 1e-4, step = 1e-5, spin = 1.0}",
            friction="friction = 0.3",
        )  # fmt: skip
    with pytest.raises(CaseError, match=r"path\[1\]: fret requires Coulomb friction"):
        case("load = 600.0\nfret = {shift_x = 1e-6}", friction="friction = 0.3")


@pytest.mark.parametrize("name", sorted(path.name for path in CASES.glob("s*.toml")))
def test_cases_that_come_with_the_package(name):
    simulation, path = load_case(CASES / name).build()
    assert 0 < simulation.friction.ratio(1e9) < math.inf
    assert any({"tangential_load", "shift", "advance"} & step.keys() for step in path)
    travels = [0.5 * sum(step["advance"]) for step in path if "advance" in step]
    cells = np.array(travels) / simulation.grid.dx
    np.testing.assert_allclose(cells, np.round(cells), atol=1e-6)


def test_results_contain_forces_motions_and_stick_zones(capsys, tmp_path):
    read = case(
        "load = 600.0\nincrements = 2\ntangential_load_x = 120.0",
        "load = 0.0\nincrements = 1",
        more="[output]\nfigures = false\n",
    )
    console = Console(width=200)
    files = solve_contact(read, tmp_path, console, figures=False, animate=True, resume=False)
    assert [file.name for file in files] == ["results.nc", "partial_slip.gif"]
    assert all(is_own(file) for file in files)
    with open_results(files[0]) as dataset:
        names = ["tangential_load_x", "shift_x", "friction_work", "stick_fraction"]
        assert moved_along(dataset) == names
        share = dataset["stick_fraction"].values
        cells = (dataset["pressure"].values > 0).sum(axis=(1, 2))
        stick = dataset["sticking"].values.sum(axis=(1, 2))
        np.testing.assert_allclose(share[:-1], (stick[:-1] / cells[:-1]))
        assert share[0] == 1 > share[2] > share[3] > 0
        assert np.isnan(share[-1])
    np.testing.assert_array_equal(without_rounding(np.array([4e-9, -270.0])), [0.0, -270.0])
    stated = capsys.readouterr().out
    for heading in ("force", "displacement", "frictional", "stick"):
        assert heading in stated
    assert "torque" not in stated


HEAT = "[heat]\npartition = 0.4\ntime = 1e-3\n"
THERMAL = """[body2.thermal]
conductivity = 50.2
expansion = 1.1e-5
diffusivity = 1.4e-5
[body1.thermal]
conductivity = 50.2
expansion = 1.1e-5
diffusivity = 1.4e-5
"""


def test_slip_heats_for_the_duration_of_the_increment():
    timed = PRESSED + "duration = 2e-3\n[[path]]\nload = 600.0\nincrements = 2\nduration = 1e-2\n"
    text = f'title = "t"\n{GRID}\n{BODIES}\n{THERMAL}[contact]\n{LAW}\n{HEAT}{timed}'
    simulation, steps = parse_case(text + "fret = {shift_x = 2e-6}\n").build()
    assert simulation.heat.partition == 0.4
    assert [step["duration"] for step in steps] == [1e-3] * 2 + [1e-3] * 10
    state = simulation.run(steps, progress=False)[-1]
    # the bodies are identical except for their share of the heat
    warm = [state.surface_temperature(body).max() for body in (1, 2)]
    assert warm[0] > 0
    assert warm[1] / warm[0] == pytest.approx(0.4 / 0.6, rel=1e-9)
    stated = {"duration = 1e-2\n": "duration is required", "partition = 0.4\n": "exactly one of"}
    for old, message in stated.items():
        with pytest.raises(CaseError, match=message):
            parse_case(text.replace(old, "") + "fret = {shift_x = 2e-6}\n")

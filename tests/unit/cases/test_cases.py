# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files: accepted and refused fields, messages, and a built simulation."""

import re
from pathlib import Path

import numpy as np
import pytest

import samcontact
import samcontact.plotting
import samcontact.results
from case_texts import MINIMAL, SWIFT
from core_fakes import make_grid
from samcontact import surfaces
from samcontact.cases import CaseError, load_case
from samcontact.plotting.summary import increments_shown

CASES = Path(__file__).parents[3] / "cases"


@pytest.fixture
def write(tmp_path):
    def writer(text):
        path = tmp_path / "case.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return writer


def replaced(old, new):
    assert old in MINIMAL
    return MINIMAL.replace(old, new, 1)


def test_defaults_and_steps(write):
    case = load_case(write(MINIMAL))
    assert case.steps() == [{"load": 300.0}, {"load": 600.0}, {"load": 0.0}]
    assert case.contact.model_dump() == {
        "friction": 0.0,
        "tol": 1e-6,
        "on_border": "error",
        "on_stall": "error",
        "max_iterations": 60,
        "adhesion": None,
        "stiffness": None,
        "increment_tol": None,
        "residual_stress": "fast",
        "image_tol": 1e-3,
        "zones": "auto",
        "reach": None,
    }
    assert (case.output.body, case.output.volume, case.output.figures) == (2, "peak_and_last", True)
    assert case.output_directory == Path("results/case")
    assert case.text == MINIMAL


def test_every_law_and_shape_is_accepted(write):
    for body in (
        'law = "rigid"',
        'law = "perfect_plastic"\nE = 1e9\nnu = 0.3\nyield_stress = 1e9',
        'law = "linear_hardening"\nE = 1e9\nnu = 0.3\nyield_stress = 1e9\ntangent_modulus = 0.0',
    ):
        text = replaced(SWIFT, body) + "[output]\nbody = 1\n"
        assert load_case(write(text)).body2.law in body
    shape = 'shape = "paraboloid"\nRx = 7.5e-3'
    for surface in (
        'shape = "paraboloid"\nRx = 1e-3\nRy = inf',
        'shape = "sphere"\nR = 1e-3',
        'shape = "cylinder"\nR = 1e-3\naxis = "x"',
        'shape = "file"\npath = "a.npy"\nRx = 1e-3',
    ):
        assert load_case(write(replaced(shape, surface))).surface.shape in surface


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("nx = 15", "nx = 0", r"grid\.nx: must be a whole number >= 1, got 0"),
        ("nx = 15", "nx = 1.5", r"grid\.nx: must be a whole number >= 1, got 1\.5"),
        ("dx = 60e-6", "dx = inf", r"grid\.dx: must be a finite number > 0 \[m\], got inf"),
        ("dx = 60e-6", 'dx = "60"', r"grid\.dx: must be a number and a unit .* m, got '60'"),
        ("dx = 60e-6\n", "", r"grid\.dx: required field is missing"),
        ("dz = 60e-6\n", "", r"grid: nz requires dz: specify both, or only dz"),
        (
            "nz = 12\ndz = 60e-6",
            "",
            r"body2 is elastic-plastic \(law swift\) and requires a grid with layers",
        ),
        (
            "C = 20",
            "C = 20\nK = 1",
            r"body2\.K: unknown field; allowed here: layers, inclusions, random_inclusions, mater",
        ),
        (
            '"swift"',
            '"ludwik"',
            r"body2\.law: must be one of 'elastic', 'rigid', .*'swift', .*, got 'ludwik'",
        ),
        ('law = "swift"\n', "", r"body2\.law: required field is missing"),
        ("n = 0.121", "n = -1.0", r"body2\.n: must be a number in \[0, 1\], got -1\.0"),
        (
            'law = "elastic"\nE = 210e9\nnu = 0.3',
            'law = "elastic"\nE = 210e9\nnu = 0.5',
            r"body1\.nu: must be a number in \[0, 0\.5\), got 0\.5",
        ),
        (
            'law = "elastic"\nE = 210e9',
            'law = "linear_hardening"\nyield_stress = 1e9\ntangent_modulus = 3e9\nE = 2e9',
            r"body1: tangent_modulus must be in \[0, E\) with E = 2e\+09 Pa, got 3e\+09",
        ),
        ("[surface]", "[surfaces]", r"surface: required field is missing"),
        (
            "[surface]",
            "[surfaces]",
            r"surfaces: unknown field; allowed here: title, .*output; did you mean surface\?",
        ),
        (
            "Rx = 7.5e-3",
            'Rx = 7.5e-3\n[surface.roughness]\nkind = "sinusoidal"\namplitude = 1e-6\nlx = 1.0',
            r"surface\.roughness\.lx: unknown field; allowed here: kind, amplitude, wavelength_x",
        ),
        (
            'shape = "paraboloid"',
            'shape = "file"\npath = ""',
            r"surface\.path: must be text \(not empty\), got ''",
        ),
        ("increments = 2", "increments = 0", r"path\[0\]\.increments: .* >= 1, got 0"),
        ("load = 600.0", "load = -1.0", r"path\[0\]\.load: .*number >= 0 \[N\]"),
        ("load = 600.0", "load = 1.0\napproach = 1.0", r"path\[0\]: exactly one of load, app"),
        ("load = 0.0", "approach = 0.0", r"path\[1\]: start is required where the path changes"),
        ("load = 0.0", "load = 600.0", r"path\[1\]: start must differ from load"),
        (
            "[grid]",
            "[output]\nvolume = 'some'\n[grid]",
            r'output\.volume: must be one of "none", "last"',
        ),
        (
            "[grid]",
            "[contact]\ntol = 2\n[grid]",
            r"contact\.tol: must be a number in \[1e-11, 1\), got 2",
        ),
        ("nx = 15", "nx = ", r"not valid TOML: .*line 4"),
    ],
)
def test_errors_name_file_field_and_remedy(write, old, new, message):
    path = write(replaced(old, new))
    with pytest.raises(CaseError, match=rf"{re.escape(str(path))}: (.*\n.*)?{message}"):
        load_case(path)


def test_all_errors_are_reported_at_once(write):
    with pytest.raises(CaseError) as caught:
        load_case(write(replaced("nx = 15\nny = 13", "nx = 0\nny = 0")))
    assert str(caught.value).count("must be a whole number >= 1, got 0") == 2


def test_rigid_bodies(write):
    elastic = 'law = "elastic"\nE = 210e9\nnu = 0.3'
    text = replaced(SWIFT, 'law = "rigid"')
    case = load_case(write(text))
    assert case.output.body == 1  # the one that has stresses
    assert case.build()[0].body2.law == "rigid"
    with pytest.raises(CaseError, match=r"output\.body: body 2 is rigid .* use output\.body = 1"):
        load_case(write(text + "[output]\nbody = 2\n"))
    with_rigid = replaced(elastic, 'law = "rigid"')
    assert load_case(write(with_rigid)).output.body == 2
    with pytest.raises(CaseError, match=r"output\.body: body 1 is rigid .* use output\.body = 2"):
        load_case(write(with_rigid + "[output]\nbody = 1\n"))
    with pytest.raises(CaseError, match="both rigid"):
        load_case(write(text.replace(elastic, 'law = "rigid"')))


def test_unreadable_files(tmp_path):
    with pytest.raises(CaseError, match="cannot read the case file: No such file"):
        load_case(tmp_path / "missing.toml")
    with pytest.raises(CaseError, match="cannot read the case file"):
        load_case(tmp_path)
    (tmp_path / "latin.toml").write_bytes(b'title = "\xe9"')
    with pytest.raises(CaseError, match=r"cannot read the case file: its byte 9 is not UTF-8"):
        load_case(tmp_path / "latin.toml")


def test_segment_may_change_quantity_with_a_start(write):
    text = replaced("load = 0.0\nincrements = 1", "approach = 2e-6\nstart = 4e-6\nincrements = 2")
    steps = load_case(write(text)).steps()
    assert [list(step) for step in steps] == [["load"], ["load"], ["approach"], ["approach"]]
    assert [step["approach"] for step in steps[2:]] == pytest.approx([3e-6, 2e-6])


def test_surface_from_file(write, tmp_path):
    heights = np.random.default_rng(0).standard_normal((15, 13)) * 1e-7
    grid = make_grid(nx=15, ny=13, dx=60e-6, dy=60e-6)
    expected = surfaces.from_heights(grid, heights, surfaces.paraboloid(grid, 7.5e-3))
    np.save(tmp_path / "h.npy", heights)
    np.savetxt(tmp_path / "h.txt", heights)
    np.savetxt(tmp_path / "h.csv", heights, delimiter=",")
    for name in ("h.npy", "h.txt", "h.csv"):
        case = load_case(
            write(replaced('shape = "paraboloid"', f'shape = "file"\npath = "{name}"'))
        )
        np.testing.assert_allclose(case.surface.build(grid, tmp_path), expected, atol=1e-22)
        assert case.hertz(1.0) is None


@pytest.mark.parametrize(
    ("section", "expected"),
    [
        ('shape = "paraboloid"\nRx = 1.0\nRy = 3', lambda g: surfaces.paraboloid(g, 1.0, 3.0)),
        ('shape = "sphere"\nR = 0.1', lambda g: surfaces.sphere(g, 0.1)),
        ('shape = "cylinder"\nR = 0.1', lambda g: surfaces.cylinder(g, 0.1)),
        ('shape = "cylinder"\nR = 0.1\naxis = "x"', lambda g: surfaces.cylinder(g, 0.1, "x")),
    ],
)
def test_surface_sections(write, section, expected):
    grid = make_grid(nx=15, ny=13)
    case = load_case(write(replaced('shape = "paraboloid"\nRx = 7.5e-3', section)))
    np.testing.assert_array_equal(case.surface.build(grid, Path()), expected(grid))


def test_roughness_is_added(write):
    rough = "Rx = 7.5e-3\n[surface.roughness]\n"
    grid = make_grid(nx=15, ny=13, dx=60e-6, dy=60e-6)
    ball = surfaces.paraboloid(grid, 7.5e-3)
    text = rough + 'kind = "sinusoidal"\namplitude = 1e-6\nwavelength_x = 3e-4\nwavelength_y = 4e-4'
    case = load_case(write(replaced("Rx = 7.5e-3", text)))
    wave = surfaces.sinusoidal(grid, 1e-6, 3e-4, 4e-4)
    np.testing.assert_array_equal(case.surface.build(grid, Path()), ball + wave)
    text = rough + 'kind = "self_affine"\nrms_height = 1e-6\nhurst = 0.8\nseed = 7'
    case = load_case(write(replaced("Rx = 7.5e-3", text)))
    wave = surfaces.rough_self_affine(grid, 1e-6, 0.8, seed=7)
    np.testing.assert_array_equal(case.surface.build(grid, Path()), ball + wave)


def test_build_makes_the_real_simulation(write):
    simulation, path = load_case(write(MINIMAL)).build()
    assert isinstance(simulation, samcontact.Simulation)
    assert (simulation.grid.nx, simulation.grid.ny, simulation.grid.nz) == (15, 13, 12)
    assert simulation.body2.law == "swift"
    assert simulation.body2.parameters == {"E": 210e9, "nu": 0.3, "B": 945e6, "C": 20, "n": 0.121}
    np.testing.assert_allclose(
        simulation.initial_gap, surfaces.paraboloid(simulation.grid, 7.5e-3), rtol=1e-15
    )
    assert path == [{"load": 300.0}, {"load": 600.0}, {"load": 0.0}]


def test_build_errors_name_file_and_section(write, tmp_path):
    text = replaced('shape = "paraboloid"\nRx = 7.5e-3', 'shape = "file"\npath = "h.npy"')
    path = write(text)
    with pytest.raises(CaseError, match=r"case\.toml: \[surface\] path: cannot read heights"):
        load_case(path).build()
    np.save(tmp_path / "h.npy", np.zeros((3, 3)))
    with pytest.raises(CaseError, match=r"\[surface\] heights_lower must have shape \(15, 13\)"):
        load_case(path).build()
    path = write(replaced('shape = "paraboloid"\nRx = 7.5e-3', 'shape = "sphere"\nR = 1e-4'))
    with pytest.raises(CaseError, match=r"\[surface\] R must be >="):
        load_case(path).build()


def test_hertz_of_a_case(write):
    contact = load_case(write(MINIMAL)).hertz(1500.0)
    assert contact.p0 == pytest.approx(4095642673.4, rel=1e-10)
    text = replaced("Rx = 7.5e-3", "Rx = 7.5e-3\nRy = 37.5e-3")
    assert load_case(write(text)).hertz(1.0).k == pytest.approx(2.890181, abs=1e-6)
    text = replaced("Rx = 7.5e-3", "Rx = 7.5e-3\nRy = inf")
    assert load_case(write(text)).hertz(1.0) is None


@pytest.mark.parametrize(
    "name", ["heated_balls", "t1_two_balls", "v1_nano_indentation", "v2_two_balls"]
)
def test_shipped_cases(name):
    case = load_case(CASES / f"{name}.toml")
    assert case.output_directory == Path("results") / name
    simulation, path = case.build()
    assert path[-1]["load"] == 0.0
    peak = max(step["load"] for step in path)
    contact = case.hertz(peak)
    grid = simulation.grid
    # the grid reaches beyond the contact and twice as deep as the largest stress
    assert min(grid.x[-1], grid.y[-1]) > 1.25 * contact.a
    assert grid.z[-1] > 2.0 * contact.max_von_mises(0.3)[1]


HEATED = """
title = "heat"
[grid]
nx = 17
ny = 17
dx = 80e-6
dy = 80e-6
nz = 10
dz = 80e-6
[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
law = "swift"
E = 210e9
nu = 0.3
B = 945e6
C = 20
n = 0.121
[body2.thermal]
conductivity = 50.2
expansion = 11.7e-6
diffusivity = 1.367e-5
[body2.softening]
kind = "johnson_cook"
melting = 1800.0
m = 1.0
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[heat]
factor = 0.02
velocity = [0.1, 0.0]
history = [1e-3, 1.0]
[[path]]
load = 1200.0
increments = 2
duration = 4e-3
[[path]]
load = 1200.0
increments = 1
duration = 2e-3
heat_factor = 0.0
"""


def test_heat(write, tmp_path, undrawn):
    case = load_case(write(HEATED))
    body = case.body2.build()
    assert body.thermal == (50.2, 11.7e-6, 1.367e-5)
    assert body.softening == samcontact.softening.JohnsonCook(1800.0, 1.0)
    assert case.steps() == [
        {"load": 600.0, "duration": 2e-3},
        {"load": 1200.0, "duration": 2e-3},
        {"load": 1200.0, "duration": 2e-3, "heat_factor": 0.0},
    ]
    simulation, path = case.build()
    states = simulation.run(path, progress=False)
    data = samcontact.results.to_dataset(simulation, states, case)
    np.testing.assert_allclose(data["time"], [2e-3, 4e-3, 6e-3])
    rise = data["max_temperature_body2"].values
    assert 0 < rise[0] < rise[1] > rise[2] > 0
    np.testing.assert_allclose(data["surface_temperature_body2"].max(["x", "y"]), rise)
    assert data["temperature_body2"].dims == ("output_increment", "x", "y", "z")
    np.testing.assert_array_equal(data["heat_factor"], [[0.0, 0.02], [0.0, 0.02], [0.0, 0.0]])
    assert data.attrs["body2_conductivity"] == 50.2
    assert "JohnsonCook" in data.attrs["body2_softening"]
    shown = sorted(increments_shown(data, 2))
    data = samcontact.results.to_dataset(simulation, states, case, volume=shown)
    written = samcontact.plotting.summary_figures(data, tmp_path / "figures")
    assert {"flash_temperature.png", "temperature.png"} <= {path.name for path in written}


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("duration = 4e-3\n", "", r"path\[0\]: duration is required with heat\.history, .* add"),
        (
            "history = [1e-3, 1.0]",
            "",
            r"path\[0\]: duration has no effect without heat\.history, .* omit dur",
        ),
        ("history = [1e-3, 1.0]", "history = [1e-3]", "heat.history"),
        (
            "factor = 0.02",
            "factor = -0.02",
            r"heat\.factor",
        ),
        ("factor = 0.02", "", "heat: exactly one of factor and partition"),
        ("factor = 0.02", "factor = 0.02\npartition = 0.5", "exactly one of factor and part"),
        ("factor = 0.02", "partition = 1.5", "heat.partition"),
        ("velocity = [0.1, 0.0]", "velocity = [0.1]", "heat.velocity"),
        ("velocity", "time = 1.0\nvelocity", "heat: history and time cannot be combined"),
        (
            "[heat]",
            "[contact]\nheat_factor = 0.02\n[heat]",
            "contact.heat_factor: unknown .*; did you mean heat.factor",
        ),
        ("conductivity = 50.2", "conductivity = 0.0", "body2.thermal.conductivity"),
        ("melting = 1800.0", "melting = 20.0", "melting must be greater than reference"),
        ("factor = 0.02", "factor = [0.1, 0.1]", r"heat.factor of body1 must be 0 without"),
    ],
)
def test_errors_of_heat(write, old, new, message):
    with pytest.raises(CaseError, match=message):
        load_case(write(HEATED.replace(old, new, 1))).build()

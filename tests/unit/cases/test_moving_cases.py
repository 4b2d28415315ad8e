# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files with motion: segments, reliefs, and messages."""

import re
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc
from case_texts import MOVING
from samcontact import paths
from samcontact.cases import Case, CaseError, load_case

CASES = Path(__file__).parents[3] / "cases"

ROLL = "roll = {distance = 180e-6, step = 60e-6, passes = 2, unload_increments = 1}"


@pytest.fixture
def write(tmp_path):
    def writer(*replacements):
        text = MOVING
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new, 1)
        path = tmp_path / "case.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return writer


def test_roll_and_slide_are_those_of_paths(write):
    options = {"load": 600.0, "distance": 180e-6, "step": 60e-6, "increments": 2}
    case = load_case(write())
    assert case.steps() == paths.rolling(**options, passes=2, unload_increments=1)
    assert case.moves
    text = "roll = {distance = 180e-6, step = 60e-6, slide_to_roll = -0.1"
    twice = f"{text}, passes = 2, back_and_forth = true}}"
    assert load_case(write((ROLL, twice))).steps() == paths.rolling(
        **options, slide_to_roll=-0.1, passes=2, back_and_forth=True
    )
    with pytest.raises(CaseError, match="back_and_forth has no effect on one pass"):
        load_case(write((ROLL, f"{text}, back_and_forth = true}}")))
    text = "slide = {distance = 180e-6, step = 60e-6, slider = 2}"
    assert load_case(write((ROLL, text))).steps() == paths.sliding(**options, slider=2)


def test_ramps_with_motion(write):
    text = """advance = [-60e-6, -120e-6]
[[path]]
load = 600.0
increments = 3
advance = [0.0, 90e-6]
[[path]]
load = 0.0
increments = 1
[[path]]
load = 0.0
increments = 1
advance = [60e-6, 30e-6]
"""
    steps = load_case(write((ROLL, text))).steps()
    expected = paths.ramp(load=600.0, increments=2, advance=(-60e-6, -120e-6))
    expected += paths.hold(load=600.0, increments=3, advance=(0.0, 90e-6))
    expected += [{"load": 0.0}, {"load": 0.0, "advance": (60e-6, 30e-6)}]
    assert steps == expected
    assert not load_case(write((ROLL, ""))).moves


def test_passes_may_follow_passes(write):
    text = ROLL + "\n[[path]]\nload = 300.0\nslide = {distance = 60e-6, step = 60e-6}"
    steps = load_case(write((ROLL, text))).steps()
    assert steps[-22:] == [{"load": 0.0}, *paths.sliding(load=300.0, distance=60e-6, step=60e-6)]


def test_a_moving_case_runs_and_tracks_the_bodies(write):
    simulation, path = load_case(write(("friction = 0.0", "reach = 120e-6"))).build()
    assert simulation.reach == 120e-6
    states = simulation.run(path, progress=False)
    np.testing.assert_allclose(states[-1].travel, [-180e-6, -180e-6], rtol=1e-12)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("distance = 180e-6", "distance = 0.0", r"path\[0\]\.roll: distance must not be 0"),
        (
            "step = 60e-6",
            "step = -1.0",
            r"path\[0\]\.roll\.step: must be a finite number > 0 \[m\]",
        ),
        ("step = 60e-6", "step = 1.0", r"path\[0\]: step must be <= the distance, 0\.00018"),
        ("step = 60e-6, ", "", r"path\[0\]\.roll\.step: required field is missing"),
        ("passes = 2", "passes = 0", r"path\[0\]\.roll\.passes: must be a whole number >= 1"),
        ("passes = 2", "slider = 2", r"path\[0\]\.roll\.slider: unknown field; allowed here: dist"),
        ("passes = 2", "slide_to_roll = 3", r"roll\.slide_to_roll: must be a number in \[-2, 2\]"),
        ("passes = 2", "speed = 1.0", r"path\[0\]: speed has no effect without heat\.history"),
        ("load = 600.0", "load = 0.0", r"path\[0\]: load must be > 0, got 0\.0"),
        (ROLL, ROLL + "\nstart = 1.0", r"path\[0\]: roll cannot be combined with start"),
        (
            ROLL,
            ROLL + "\nduration = 1.0\nspacing = 'power'",
            r"path\[0\]: roll cannot be combined with duration, spacing: .*, and set roll.speed",
        ),
        (
            ROLL,
            ROLL + "\nslide = {distance = 1.0, step = 1.0}",
            r"path\[0\]: roll and slide cannot be combined",
        ),
        (
            "[[path]]",
            "[[path]]\nload = 1.0\n[[path]]",
            r"path\[1\]: roll must start unloaded, but the previous segment ends at load = 1\.0",
        ),
        (ROLL, "advance = [1.0]", r"path\[0\]\.advance: must be a list of 2 finite numbers"),
        (
            ROLL,
            "advance = [1.0, inf]",
            r"path\[0\]\.advance: must be a list of 2 finite numbers or",
        ),
        ("friction = 0.0", "reach = -1.0", r"contact\.reach: must be a finite number >= 0 \[m\]"),
    ],
)
def test_errors_name_field_and_remedy(write, old, new, message):
    with pytest.raises(CaseError, match=message):
        load_case(write((old, new)))


@pytest.mark.parametrize(
    ("motion", "allowed"),
    [
        ("roll = {distance = 6e-5, step = 6e-5}", True),
        ("roll = {distance = 6e-5, step = 6e-5, slide_to_roll = -0.1}", True),
        ("roll = {distance = -6e-5, step = 6e-5, slide_to_roll = 0.1}", True),
        ("roll = {distance = 6e-5, step = 6e-5, slide_to_roll = 0.1}", False),
        ("slide = {distance = 6e-5, step = 6e-5, passes = 2}", True),
        ("slide = {distance = -6e-5, step = 6e-5, slider = 2}", True),
        ("slide = {distance = -6e-5, step = 6e-5}", False),
        ("slide = {distance = 6e-5, step = 6e-5, passes = 2, back_and_forth = true}", False),
        ("advance = [0.0, 1e-6]", False),
    ],
)
def test_friction_and_sliding_agree_in_direction(write, motion, allowed):
    load_case(write((ROLL, motion)))  # without friction any direction will do
    path = write((ROLL, motion), ("friction = 0.0", "friction = 0.1"))
    if allowed:
        load_case(path)
    else:
        with pytest.raises(CaseError, match=r"path\[0\]: advance\[0\] must be >= advance\[1\]"):
            load_case(path)


THERMAL = """n = 0.121
[body2.thermal]
conductivity = 50.2
expansion = 11.7e-6
diffusivity = 1.367e-5
[heat]
factor = 0.02
velocity = [-0.5, 0.0]
history = [1e-6, 1e-2]
"""


def test_heat_moves_with_the_body(write):
    heated = [("n = 0.121\n", THERMAL)]
    roll = ("unload_increments = 1", "unload_increments = 1, speed = 0.5")
    follows = ("velocity = [-0.5, 0.0]", "track = 200e-6")
    case = load_case(write(*heated, roll, follows))
    steps = case.steps()
    assert all(step["duration"] == pytest.approx(120e-6) for step in steps[:5])
    assert steps[6]["duration"] == pytest.approx(360e-6)  # the way back
    simulation, _ = case.build()
    assert simulation.heat.march == (1e-6, 1e-2, 200e-6, 0.0)
    at_once = load_case(write(*heated, (roll[0], f"{roll[1]}, return_time = 0.0"), follows))
    assert at_once.steps()[6]["duration"] == 0.0
    with pytest.raises(CaseError, match=r"heat\.track is required because the path moves"):
        load_case(write(*heated, roll))
    with pytest.raises(CaseError, match=r"heat\.track must be at least the length of the path"):
        load_case(write(*heated, roll, (follows[0], "track = 100e-6")))
    partly = r"path\[0\]\.roll\.step: advance of body 1 must be a multiple of the cell size"
    with pytest.raises(CaseError, match=partly):
        load_case(write(*heated, roll, follows, ("step = 60e-6", "step = 45e-6")))
    with pytest.raises(CaseError, match=r"path\[0\]: speed is required with heat\.history"):
        load_case(write(*heated))
    slip = THERMAL.replace("factor = 0.02", "partition = 1.0").replace("history", "# history")
    by_slip = [("n = 0.121\n", slip), ("friction = 0.0", "friction = {coulomb = 0.1}")]
    with pytest.raises(CaseError, match=r"path\[0\]: return_time requires heat\.history"):
        load_case(write(*by_slip, (roll[0], f"{roll[1]}, return_time = 0.0")))
    with pytest.raises(
        CaseError, match=r"motion of heated body 2, -0\.5 m/s along x, got 0\.5 m/s"
    ):
        load_case(write(*heated, roll, ("velocity = [-0.5", "velocity = [0.5")))


def relief(write, text):
    case = load_case(write(("[contact]", f"[relief2]\n{text}\n[contact]")))
    assert case.hertz(100.0) is None
    simulation, _ = case.build()
    assert simulation.relief1 is None
    return simulation.grid, simulation.relief2


def test_dents_and_furrows(write):
    grid, made = relief(write, 'kind = "dent"\ndepth = 1e-6\nradius = 2e-4\nx = 6e-4\ny = 6e-5')
    expected = sc.dents.spherical(grid, 1e-6, 2e-4, 6e-4, 6e-5)
    np.testing.assert_array_equal(made.heights, expected.heights)
    assert (made.first, made.periodic) == (expected.first, False)
    grid, made = relief(
        write, 'kind = "furrow"\ndepth = 1e-6\nhalf_width = 2e-4\nalong = "x"\nposition = 6e-5'
    )
    expected = sc.dents.furrow(grid, 1e-6, 2e-4, "x", 6e-5)
    np.testing.assert_array_equal(made.heights, expected.heights)
    assert made.periodic


def test_relief_from_a_file(write, tmp_path):
    heights = np.random.default_rng(1).standard_normal((5, 13)) * 1e-7
    np.save(tmp_path / "h.npy", heights)
    _, made = relief(write, 'kind = "file"\npath = "h.npy"\nx = 130e-6\nperiodic = true')
    np.testing.assert_array_equal(made.heights, heights)
    # 15 rows of 60 um: the middle of 5 rows stands over row 7 at x = 0, 120 um are two more
    assert (made.first, made.periodic) == (5 + 2, True)
    np.save(tmp_path / "h.npy", heights[:, :4])
    with pytest.raises(CaseError, match=r"\[relief2\] relief2 must have heights of shape \(rows, "):
        relief(write, 'kind = "file"\npath = "h.npy"')
    with pytest.raises(CaseError, match=r"\[relief2\] path: cannot read heights from"):
        relief(write, 'kind = "file"\npath = "none.npy"')


def test_a_rough_relief_is_periodic_over_the_grid(write):
    text = 'kind = "self_affine"\nrms_height = 1e-7\nhurst = 0.8\nseed = 7'
    grid, made = relief(write, text)
    expected = sc.surfaces.rough_self_affine(grid, 1e-7, 0.8, seed=7)
    np.testing.assert_array_equal(made.heights, expected)
    assert (made.first, made.periodic) == (0, True)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('kind = "hole"', r"relief2\.kind: must be one of 'file', 'dent', 'furrow', 'self_affine'"),
        ('kind = "dent"\ndepth = 1e-6', r"relief2\.radius: required field is missing"),
        ('kind = "dent"\ndepth = 1.0\nradius = 1e-4', r"\[relief2\] depth must be nonzero, of"),
        ('kind = "file"\npath = "h.xlsx"', r"\[relief2\] path: cannot read heights from .*h\.xlsx"),
        (
            'kind = "furrow"\ndepth = 1.0\nlong = 1',
            r"relief2\.long: unknown field; allowed here: k",
        ),
    ],
)
def test_errors_of_reliefs(write, text, message):
    with pytest.raises(CaseError, match=message):
        relief(write, text)


@pytest.mark.parametrize("name", sorted(path.name for path in CASES.glob("r*.toml")))
def test_cases_that_come_with_the_package(name):
    case = load_case(CASES / name)
    assert case.moves
    simulation, path = case.build()
    assert simulation.body2.is_plastic
    # whole cells, so that the contact keeps its place in the grid
    travels = np.array([step["advance"] for step in path if "advance" in step])
    cells = travels / simulation.grid.dx
    np.testing.assert_allclose(cells, np.round(cells), atol=1e-6)


def test_the_path_in_the_documentation(write):
    page = (CASES.parent / "docs" / "case_files.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"^```toml\n(\[\[path\]\]\n.*?)^```$", page, re.MULTILINE | re.DOTALL)
    case = load_case(write(("[[path]]\nload = 600.0\nincrements = 2\n" + ROLL, block)))
    assert case.steps() == paths.rolling(
        load=1000.0, distance=1e-3, step=25e-6, passes=3, increments=10
    )


def test_dictionaries_are_cases_too():
    case = Case.model_validate(
        {
            "title": "elastic",
            "grid": {"nx": 9, "ny": 9, "dx": 1e-5, "dy": 1e-5},
            "body1": {"law": "rigid"},
            "body2": {"law": "elastic", "E": 210e9, "nu": 0.3},
            "surface": {"shape": "paraboloid", "Rx": 1e-2},
            "relief2": {"kind": "dent", "depth": 1e-8, "radius": 2e-5, "x": 3e-5},
            "path": [{"load": 0.1, "increments": 1, "roll": {"distance": 4e-5, "step": 1e-5}}],
        }
    )
    simulation, path = case.build()
    states = simulation.run(path, progress=False)
    # three steps later, over the dent, the bodies are closer by a fraction of its depth
    assert 0 < states[3].approach - states[0].approach < 1e-8

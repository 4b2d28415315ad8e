# SPDX-License-Identifier: GPL-3.0-or-later
"""Applications: commands without Python give the answers of closed forms and of Python."""

import math

import pytest
from PIL import Image

from command import invoke
from gallery.applications.__main__ import DOCS, NAMES, find, records, texts
from gallery.applications.application import Answer, Work, with_errors
from gallery.applications.page import shown
from gallery.applications.running import run, split
from samcontact.commands.example_cases import FIRST_CASES, example_text

STORED = records()
# Relative tolerance of the answers with a check, by application and answer. The first two checks
# of the bearing are estimates by a formula that was fitted to tests of other steels.
TOLERANCES = {
    "bearing_overload": {"inner": 0.5, "outer": 0.65, "radial": 1e-3, "rated": 1e-3},
    "dented_raceway": {"away": 0.01},
    "misaligned_roller": {"tilted": 0.01, "middle": 0.01, "aligned": 0.02},
    "case_depth": {"p0": 1e-3, "dang_van": 3e-3, **{f"chd{n}": 0.01 for n in range(5)}},
    "coated_gear": {"p0": 0.02, "tension": 0.01, "shear": 1e-3},
    "running_in": {"volume": 1e-3},
    "blade_root": {"p0": 1e-3, "stick": 0.03, "work": 0.08, "tension": 0.15},
    "rail_traction": {"force": 0.06, "stick": 0.06, "p0": 0.12},
    "coated_indentation": {"elastic": 0.02},
}
# The accepted values: the 6208, the roller, and a flank of 1.5 GPa.
ACCEPTED = {
    ("bearing_overload", "inner"): 13.3e3,
    ("bearing_overload", "outer"): 14.9e3,
    ("bearing_overload", "radial"): 24.0e3,
    ("bearing_overload", "rated"): 18.1e3,
    ("misaligned_roller", "aligned"): 4.75e9,
    ("misaligned_roller", "tilted"): 5.98e9,
    ("misaligned_roller", "middle"): 3.69e9,
    ("case_depth", "dang_van"): 0.1707 * 1.5e9,
}
# Places, which are known to about one cell.
PLACES = {("dented_raceway", "place"), ("dented_raceway", "below"), ("blade_root", "place")}
# Changes of the case files and of the commands for runs of a few seconds, and looser tolerances.
SMALL_VERSIONS = {
    "case_depth": (
        [("nx = 96", "nx = 48"), ("dx = 20e-6", "dx = 40e-6")],
        [("0.3e-3,0.5e-3,0.7e-3,0.9e-3,1.1e-3", "0.3e-3,1.1e-3")],
        {"p0": 0.01, "dang_van": 0.01},
    ),
    "coated_gear": (
        [("nx = 41", "nx = 23"), ("ny = 41", "ny = 23"), ("dx = 24e-6", "dx = 44e-6"),
         ("dy = 0.36e-3", "dy = 0.66e-3")],
        [],
        {"p0": 0.04},
    ),
    "blade_root": (
        [("nx = 108", "nx = 54"), ("dx = 24e-6", "dx = 48e-6"), ("nz = 24", "nz = 2"),
         ("increments = 6", "increments = 3")],
        [],
        {"stick": 0.06, "work": 0.4, "tension": 0.4, "p0": 0.01},
    ),
    "misaligned_roller": (
        [("accuracy = 0.02", "accuracy = 0.1")],
        [("0.0,0.0005,0.001", "0.0,0.001")],
        {"tilted": 0.05, "aligned": 0.05, "middle": 0.02},
    ),
    "running_in": (
        [("nx = 135", "nx = 67"), ("ny = 135", "ny = 67"), ("2.5e-6", "5e-6"), ("1e-6", "2e-6"),
         ("nz = 20", "nz = 8"), ("threshold = 0.002", "threshold = 0.002\ncycles = 1")],
        [("67,135", "67,89"), ("5e-6,2.5e-6", "5e-6,3.75e-6"),
         ("2e-6,1e-6", "2e-6,2e-6")],
        {},
    ),
    "rail_traction": (
        [("nx = 27", "nx = 15"), ("ny = 21", "ny = 13"), ("0.65e-3", "1.3e-3"),
         ("nz = 12", "nz = 6")],
        [],
        {"force": 0.2, "stick": 0.2, "p0": 0.15},
    ),
    "coated_indentation": (
        [("nx = 33", "nx = 17"), ("ny = 33", "ny = 17"), ("dx = 0.4e-6", "dx = 0.8e-6"),
         ("dy = 0.4e-6", "dy = 0.8e-6"), ("dz = 0.4e-6", "dz = 0.5e-6")],
        [],
        {"elastic": 0.06},
    ),
}  # fmt: skip


def require_checks(answers, tolerances):
    """Each answer with a check agrees with it, and each tolerance belongs to an answer."""
    checked = {a["key"]: a for a in answers if a["expected"] is not None}
    assert checked.keys() <= tolerances.keys()
    for key, one in checked.items():
        assert one["value"] == pytest.approx(one["expected"], rel=tolerances[key]), key


@pytest.mark.parametrize("name", NAMES)
def test_stored_answers_agree_with_their_checks(name):
    answers = STORED[name]["answers"]
    require_checks(answers, TOLERANCES[name])
    assert len({a["key"] for a in answers}) == len(answers)
    assert all(math.isfinite(a["error"]) for a in answers)
    assert max(a["error"] for a in answers if (name, a["key"]) not in PLACES) < 0.25
    for one in answers:
        accepted = ACCEPTED.get((name, one["key"]))
        if accepted is not None:
            assert one["value"] == pytest.approx(accepted, rel=0.01)


def test_pages_follow_from_the_records():
    assert list(STORED) == list(NAMES)
    written = {file.name: file.read_text(encoding="utf-8") for file in DOCS.glob("*.md")}
    assert texts(STORED) == written


@pytest.mark.parametrize("name", NAMES)
def test_cases_and_pictures_belong_to_the_pages(name):
    kind = find(name).kind
    assert STORED[name]["case"] == example_text(FIRST_CASES[kind], f"{kind}.toml")
    with Image.open(DOCS / f"{name}.png") as picture:
        assert 5.0 < picture.width / picture.info["dpi"][0] < 8.2  # wider pictures scroll


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")
@pytest.mark.parametrize("name", SMALL_VERSIONS)
def test_a_small_version_agrees_with_its_checks(name, tmp_path, undrawn):
    application = find(name)
    of_case, of_commands, tolerances = SMALL_VERSIONS[name]
    text = example_text(FIRST_CASES[application.kind])
    for old, new in of_case:
        assert old in text
        text = text.replace(old, new)
    (tmp_path / f"{application.kind}.toml").write_text(text, encoding="utf-8")
    outputs = []
    for command in application.commands:
        for old, new in of_commands:
            command = command.replace(old, new)
        words = split(command) + ["--no-figures"] * command.startswith("run")
        with pytest.MonkeyPatch.context() as patch:
            patch.chdir(tmp_path)
            outcome = invoke(*words)
        assert outcome.exit_code == 0, outcome.output
        outputs.append(outcome.stdout)
    work = Work(tmp_path, application.kind, tuple(outputs))
    for answer in application.answers(work):
        if not math.isnan(answer.expected):
            tolerance = tolerances.get(answer.key, TOLERANCES[name][answer.key])
            assert answer.value == pytest.approx(answer.expected, rel=tolerance), answer.key


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_commands_give_the_stored_answers(name, tmp_path):
    _, record = run(find(name), tmp_path)
    require_checks(record["answers"], TOLERANCES[name])
    for now, before in zip(record["answers"], STORED[name]["answers"], strict=True):
        assert now["value"] == pytest.approx(before["value"], rel=1e-3, abs=1e-30), now["key"]


def test_missing_errors_are_differences_from_coarser_cells():
    fine = [Answer("a", "", 2.0, "", 0.1), Answer("b", "", 4.0, ""), Answer("c", "", -5.0, "")]
    coarse = [Answer("a", "", 3.0, ""), Answer("b", "", 3.0, ""), Answer("c", "", -6.0, "")]
    errors = [one.error for one in with_errors(fine, coarse)]
    assert errors == pytest.approx([0.1, 0.25, 0.2])
    for name in NAMES:
        application = find(name)
        text = application.coarse_case(example_text(FIRST_CASES[application.kind]))
        assert all(f"\n{new}\n" in text for _, new in application.coarser)


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [(13.34e3, "N", "13.34 kN"), (2.5e-7, "m", "250 nm"), (0.632, "%", "63.2 %"), (0.9, "", "0.9"),
     (5.98e9, "Pa", "5.98 GPa")],
)  # fmt: skip
def test_values_are_shown_with_prefixes(value, unit, text):
    assert shown(value, unit) == text


def test_words_in_quotes_are_one_word():
    assert split('find a.toml "p=1 nm" --quiet') == ["find", "a.toml", "p=1 nm", "--quiet"]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of solver and simulation: one default and one range each."""

import re
from dataclasses import FrozenInstanceError, asdict, fields
from inspect import signature
from pathlib import Path

import pytest

import samcontact as sc
from samcontact.cases import AsperityCase, Case
from samcontact.problem.adhesion_laws import LAWS
from samcontact.problem.settings import (
    ChoiceSetting,
    ContactLawSetting,
    ContactSettings,
    RangeSetting,
    Settings,
    allowed,
)

DOCS = Path(__file__).parents[3] / "docs"
NUMBERS = [
    (kind, name, limits)
    for kind in (ContactSettings, Settings)
    for name, limits in allowed(kind).items()
    if isinstance(limits, RangeSetting)
]


def beyond(limits):
    """Return numbers just outside a range, and NaN and infinity."""
    found = [float("nan"), float("inf"), -float("inf")]
    found += [one for one in (limits.gt, limits.lt) if one is not None]
    if limits.ge is not None:
        found.append(limits.ge * (1 - 1e-9) or -1e-300)
    if limits.le is not None:
        found.append(limits.le * (1 + 1e-9))
    return found


def inside(limits):
    return [one for one in (limits.ge, limits.le) if one is not None]


@pytest.mark.parametrize(("kind", "name", "limits"), NUMBERS)
def test_numbers_within_their_range(kind, name, limits):
    for value in beyond(limits):
        text = f"{name} must be {limits}, got {value!r}"
        with pytest.raises(ValueError, match=re.escape(text)):
            kind(**{name: value})
    for value in inside(limits):
        assert getattr(kind(**{name: value}), name) == value
    with pytest.raises(TypeError, match=f"{name} must be a number, got 'much'"):
        kind(**{name: "much"})


def test_ranges_in_words():
    assert str(RangeSetting(ge=0.0)) == "a finite number >= 0"
    assert str(RangeSetting(gt=0.0, lt=1.0)) == "in (0, 1)"
    assert str(RangeSetting(ge=1e-6, le=0.1)) == "in [1e-6, 0.1]"


def test_texts_counts_and_combinations_of_settings():
    with pytest.raises(ValueError, match="on_border must be one of 'error', 'warn', got 'no'"):
        ContactSettings(on_border="no")
    with pytest.raises(ValueError, match="max_iterations must be an integer >= 1, got 0"):
        Settings(max_iterations=0)
    text = r"increment_tol must be in \[10 tol, 1\) with tol = 0.001, got 0.009"
    with pytest.raises(ValueError, match=text):
        Settings(tol=1e-3, increment_tol=9e-3)
    assert Settings(tol=1e-3, increment_tol=1e-2).increment_tol == 1e-2
    for name in ("increment_tol", "reach"):
        assert getattr(Settings(**{name: None}), name) is None
    with pytest.raises(TypeError, match="tol must be a number, got None"):
        Settings(tol=None)
    with pytest.raises(FrozenInstanceError):
        Settings().tol = 1e-3


@pytest.mark.parametrize(
    ("kind", "made"), [(ContactSettings, sc.ContactSolver), (Settings, sc.Simulation)]
)
def test_arguments_have_these_names_and_defaults(kind, made):
    arguments = signature(made).parameters
    for item in fields(kind):
        assert arguments[item.name].default == item.default


@pytest.mark.parametrize(
    ("case", "others"), [(Case, {}), (AsperityCase, {"friction": None, "tol": None})]
)
def test_case_files_have_these_names_defaults_and_ranges(case, others):
    section = type(case.model_fields["contact"].default)
    expected = asdict(Settings()) | {"adhesion": None} | others
    if "friction" in others:
        del expected["friction"], expected["adhesion"], expected["stiffness"]
    assert section().model_dump() == expected
    for name in expected.keys() - {"adhesion"}:
        limits = allowed(Settings)[name]
        given = beyond(limits) if isinstance(limits, RangeSetting) else ["no", 0]
        for value in given:
            with pytest.raises(ValueError, match=name):
                section.model_validate({name: value})
        good = (
            inside(limits) if isinstance(limits, RangeSetting) else getattr(limits, "allowed", [1])
        )
        for value in good:
            assert getattr(section.model_validate({name: value}), name) == value


def test_the_pages_state_these_ranges():
    page = (DOCS / "case_files.md").read_text(encoding="utf-8")
    page = page.split("### [contact]")[1].split("\n### ")[0]
    rows = dict(re.findall(r"^\| (\w+) \| (.*?) \|", page, re.MULTILINE))
    for name, limits in allowed(Settings).items():
        default = getattr(Settings, name)
        if isinstance(limits, ContactLawSetting):
            assert all(f'kind = "{law.kind}"' in rows[name] for law in LAWS)
            continue
        if isinstance(limits, ChoiceSetting):
            assert all(f'"{word}"' in rows[name] for word in limits.allowed)
            assert f'"{default}" (default)' in rows[name]
            continue
        numbers = {float(n) for n in re.findall(r"\d[\d.e-]*", rows[name])}
        ends = (
            {limits.gt, limits.ge, limits.lt, limits.le}
            if isinstance(limits, RangeSetting)
            else {1}
        )
        assert {end for end in ends if end is not None} <= numbers
        assert default is None or float(default) in numbers
    for made, kind in ((sc.ContactSolver, ContactSettings), (sc.Simulation, Settings)):
        tol, images = allowed(kind)["tol"], allowed(Settings)["image_tol"]
        assert f"in [{tol.ge:g}, {tol.lt:g})" in made.__doc__
    assert f"in [{images.ge:g}, {images.le:g}]".replace("e-0", "e-") in sc.Simulation.__doc__


def test_given_settings_are_shown_and_stored(tmp_path):
    grid = sc.Grid(5, 5, 1e-5, 1e-5)
    given = {
        "friction": 0.1, "tol": 1e-5, "on_border": "warn", "on_stall": "warn", "max_iterations": 9,
        "increment_tol": 1e-3, "residual_stress": "exact", "image_tol": 1e-2, "zones": "one",
            "reach": 2e-5, "adhesion": sc.Adhesion.exponential(1e-3, 1e-6), "stiffness": 7.0,
    }  # fmt: skip
    assert set(given) == {item.name for item in fields(Settings)}
    body = sc.Material.elastic(1e11, 0.3)
    made = sc.Simulation(grid, body, body, sc.surfaces.paraboloid(grid, 1e-2), **given)
    made.save(tmp_path / "kept.h5")
    for one in (made, sc.Simulation.load(tmp_path / "kept.h5")):
        for name, value in given.items():
            assert getattr(one, name) == value
            assert f"{name}={value!r}" in repr(one)

# SPDX-License-Identifier: GPL-3.0-or-later
"""What pages of measurements say in words follows from their tables."""

import importlib
import re

import pytest

from benchmarks import (
    images,
    increment_errors,
    operators,
    plastic_zones,
    resolution,
    scaling,
    sensitivity,
    slip,
    tables,
    theory,
    wear_convergence,
)
from benchmarks.__main__ import PARTS, main
from benchmarks.harness import ROOT

PAGE = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
EVERY = [importlib.import_module(f"benchmarks.{name}") for name in PARTS]


def rows_on_the_page(part):
    return tables.rows_of(tables.section_of(PAGE, part))


def test_rows_are_read_from_a_table():
    table = tables.markdown(tables.frame([{"case": "a", "cells": 4, "time_s": 0.25}]))
    assert tables.rows_of(f"### A\n\n{table}\n\na note") == [
        {"case": "a", "cells": 4.0, "time_s": 0.25}
    ]


def test_sentences_below_tables_are_made_of_them():
    assert tables.noted(PAGE, EVERY) == PAGE
    section = tables.section_of(PAGE, operators)
    assert section.splitlines()[-1] == operators.notes(rows_on_the_page(operators))[0]
    changed = PAGE.replace(section, section[: section.rindex("|") + 1] + "\n\nno note")
    assert tables.noted(changed, EVERY) == PAGE


@pytest.mark.parametrize("part", [slip, scaling], ids=lambda part: part.NAME)
def test_sentences_that_need_times_agree_in_the_rest(part):
    lines = tables.section_of(PAGE, part).splitlines()
    made = "\n".join(part.notes(rows_on_the_page(part))).splitlines()
    assert len(made) > 0
    assert set(made) <= set(lines)
    others = {line for line in lines[1:] if line and not line.startswith("|")} - set(made)
    assert all(re.search(r": [\d.]+ s; CONTACT|time per application", line) for line in others)


def test_the_command_makes_sentences_only(tmp_path, monkeypatch):
    monkeypatch.setattr("benchmarks.__main__.ROOT", tmp_path)
    (tmp_path / "docs").mkdir()
    section = tables.section_of(PAGE, images)
    page = tmp_path / "docs" / "benchmarks.md"
    page.write_text(PAGE.replace(section, section + "\n\ntyped"), encoding="utf-8")
    assert main(["--notes"]) == 0
    assert page.read_text(encoding="utf-8") == PAGE


class TestWhatItSays:
    """Claims of docs/benchmarks.md in words."""

    def test_the_fast_stress_is_better_and_cheaper(self):
        rows = rows_on_the_page(operators)
        for exact, fast in zip(rows[::2], rows[1::2], strict=True):
            assert (exact["method"], fast["method"]) == ("exact", "fast")
            assert fast["error: stress, rms"] < exact["error: stress, rms"]
            assert fast["time_ratio"] < 0.5
            assert fast["memory_MB"] < exact["memory_MB"]

    def test_zones_save_the_more_the_larger_the_surface(self):
        rows = [row for row in rows_on_the_page(plastic_zones) if row["method"] == "zones"]
        for case in {row["case"] for row in rows}:
            times = [row["time_ratio"] for row in rows if row["case"] == case]
            assert times == sorted(times, reverse=True)
            assert max(times) < 1

    def test_what_images_leave_is_below_its_bound(self):
        for row in rows_on_the_page(images):
            bound = float(row["method"].removeprefix("image_tol "))
            assert row["error: stress, largest"] < bound


class TestTablesOfTheTheory:
    """Small forms of what makes them, beside what they say."""

    @staticmethod
    def rows(name):
        text = theory.PAGE.read_text(encoding="utf-8")
        table = re.search(rf"<!-- table: {name} -->\n(.*?)<!-- end", text, re.DOTALL)[1]
        return tables.rows_of(table)

    def test_contact_counts(self):
        (found,), stored = (
            tables.rows_of(theory.contact_counts(rough=())),
            self.rows("contact_counts"),
        )
        assert found["contact"] == stored[0]["contact"]
        for name in found.keys() - {"contact"}:
            new, old = ([int(n) for n in row[name].split(", ")] for row in (found, stored[0]))
            assert new == pytest.approx(old, rel=0.2, abs=1)

    def test_increments(self):
        """On half as many cells they change about as much."""
        (found,), stored = tables.rows_of(theory.increments((1,), 16, 8)), self.rows("increments")
        for name in found.keys() - {"increments"}:
            assert 0.4 < found[name] / stored[0][name] < 2.5

    def test_grid_errors(self):
        (*found, last), stored = (
            tables.rows_of(theory.grid_errors((8, 9), (), ())),
            self.rows("grid_errors"),
        )
        known = {row["quantity"]: row for row in stored}
        assert last["quantity"] == "all"
        for row in found:
            assert row["least"] >= known[row["quantity"]]["least"]

    def test_increment_errors(self):
        """Of one scene, with one increment and many."""
        (name, *_) = increment_errors.SCENES
        found = tables.rows_of(increment_errors.stated_errors([name], runs=1))
        stored = self.rows("increment_errors")[: len(found)]
        assert len(found) == 2
        for new, old in zip(found, stored, strict=True):
            assert [new[key] for key in ("scene", "field")] == [old["scene"], old["field"]]
            for key in ("true error [%]", "true over stated error"):
                first = float(str(old[key]).split(", ")[0])
                assert new[key] == pytest.approx(first, rel=0.05)

    def test_rolling_reach(self):
        (found, _), (stored, _) = (
            tables.rows_of(theory.rolling_reach(20)),
            self.rows("rolling_reach"),
        )
        length = "length of the grid"
        assert found[length] == stored[length]
        for name in found.keys() - {length}:
            assert found[name] <= 2 * stored[name]

    def test_shakedown_cycles(self):
        (found,) = tables.rows_of(theory.shakedown_cycles(theory.CYCLES[:1]))
        stored = self.rows("shakedown_cycles")[0]
        for name, value in found.items():
            near = isinstance(value, float)
            assert value == (pytest.approx(stored[name], rel=0.05) if near else stored[name])


def test_what_wear_depends_on_is_as_stored():
    rows = wear_convergence.kept()
    assert wear_convergence.page(rows) == wear_convergence.PAGE.read_text(encoding="utf-8")
    meshes = [(name, wear_convergence._mesh(scene)) for name, _, scene in wear_convergence.scenes()]
    stored = [(name, row) for name, lines in rows.items() for row in lines]
    assert [(name, row | mesh) for (name, row), (_, mesh) in zip(stored, meshes, strict=True)] == (
        stored
    )
    coarsest = next(scene for name, _, scene in wear_convergence.scenes() if name == "lens")
    found = wear_convergence.lens(coarsest)
    for name, text in found.items():
        new, old = ([float(n) for n in one.split(", ")] for one in (text, rows["lens"][0][name]))
        assert new == pytest.approx(old, rel=0.01), name


def test_what_the_gallery_depends_on_is_as_stored():
    stored = sensitivity.PAGE.read_text(encoding="utf-8")
    assert sensitivity.page(sensitivity.moves.TABLE) == stored


def test_sentences_on_rough_contact_follow_from_its_tables():
    text = resolution.PAGE.read_text(encoding="utf-8")
    sections = re.split(r"^## Load ", text, flags=re.MULTILINE)[1:]
    assert len(sections) > 1
    shares = []
    for section in sections:
        block = next(one for one in section.split("\n\n") if one.startswith("|"))
        rows = tables.rows_of(block)
        area = [row["contact area [%]"] for row in rows]
        order = re.search(r"three finest grids: ([\d.]+)\.", section)[1]
        assert resolution.order(area) == pytest.approx(float(order), abs=0.2)
        limit = 2 * area[-1] - area[-2]
        shares += [100 * (one / limit - 1) / row["uncertain [%]"]
                   for one, row in zip(area[:3], rows[:3], strict=True)]  # fmt: skip
    low, high = map(float, re.search(r"errors found are ([\d.]+) to ([\d.]+)", text).groups())
    assert low - 0.03 < min(shares) < max(shares) < high + 0.03

# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of measurements are generated only from the stored records."""

import importlib
import math
import random
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from benchmarks import (
    images,
    increment_errors,
    operators,
    plastic_zones,
    resolution,
    scaling,
    slip,
    tables,
    theory,
)
from benchmarks import study as studies
from benchmarks.__main__ import PARTS, main
from benchmarks.harness import ROOT

PAGE = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
EVERY = [importlib.import_module(f"benchmarks.{name}") for name in PARTS]
WITHOUT_RECORDS = {"resolution"}  # of runs before there were any
STUDIES = {
    file.parent.name if file.stem == "page" else file.stem
    for file in Path(studies.__file__).parent.rglob("*.py")
    if "\nSTUDY = Study(" in file.read_text(encoding="utf-8")
}
STORED_RECORDS = {name: studies.find(name) for name in sorted(STUDIES - WITHOUT_RECORDS)}
by_study = pytest.mark.parametrize("study", STORED_RECORDS.values(), ids=STORED_RECORDS)
# Columns that are not measured, besides the first columns, which name rows.
GIVEN = {
    "accuracy": {"values", "quantity", "finite elements", "reference", "difference [%]",
                 "accuracy of finite elements [%]", "accuracy [%]"},
    "accuracy_cost": {"prescribed [%]"},
    "experiments": {"Y/E\\*", "a/R at $E^* a/(Y R) = 30$"},
    "finite_elements": {"elements or cells on the contact radius",
                        "elements on half a period (CalculiX), cells on a period (samcontact)"},
    "roofline": {"n", "operations", "bytes"},
    "scale": {"limit of this exponent", "limit of the bytes per cell", "n", "processes",
              "sent per evaluation and process [GB]",
              "size of a message [MB]"},
    "static_capacity": {"p₀ of ISO 76 [GPa]"},
    "viscous_peers": {"allowed error"},
    "wear_convergence": {"dz [µm]", "increments"},
}  # fmt: skip
NUMBER = re.compile(r"\d+\.?\d*(?:e[-+]\d+)?")
TIMES = {"on", "seconds", "cpu_s", "memory_MB"}
AGAIN = [
    ("experiments", {"of": "perfect", "stiffness": 6.0, "cells": 10}, 1e-4),
    ("static_capacity", {"of": "steels", "name": "AISI 52100", "pressure": 4.2e9}, 1e-4),
    ("finite_elements", {"of": "balls", "by": "samcontact", "size": 8}, 1e-5),
    ("finite_elements", {"of": "wave", "by": "samcontact", "size": 16}, 1e-5),
    ("accuracy", {"of": "semi-axes 1:4", "accuracy": 0.01}, 0.02),
    ("wear_convergence", {"of": "lens", "dx": 60 * 1e-6, "dz": 24 * 1e-6, "increments": 1}, 0.01),
]  # fmt: skip


@by_study
def test_a_page_is_generated_from_the_records(study):
    records = study.records()
    assert records
    for record in records:  # of some point
        points = [*study.points(False), *study.points(study.keeps_quick)]
        assert any(point.items() <= record.items() for point in points), record
    if study.name != "sensitivity":  # it lacks some changes of some meshes
        for point in study.points(False):
            assert any(point.items() <= record.items() for record in records), point
    if study.name != "truth":
        assert study.page(records) == study.document_file.read_text(encoding="utf-8")


def other(value, chance):
    """Return a record with larger numbers."""
    if isinstance(value, bool):
        return chance.random() < 0.5
    if isinstance(value, float):
        return value * chance.uniform(1.3, 2.5)
    if isinstance(value, int):
        return round(value * chance.uniform(1.3, 2.5)) + 1
    if isinstance(value, str):
        return NUMBER.sub(lambda found: f"{other(float(found[0]), chance) + 1:.3g}", value)
    if isinstance(value, dict):
        return {key: other(one, chance) for key, one in value.items()}
    return [other(one, chance) for one in value] if isinstance(value, list) else value


def cells_of(page):
    """Return cells with numbers, by table, column, heading and name of the row."""
    found = {}
    for block, text in enumerate(re.findall(r"(?:^\|.*\n?)+", page, re.MULTILINE)):
        lines = [re.split(r" *\| *", line)[1:-1] for line in text.splitlines()]
        for number, row in enumerate(lines[2:]):
            same = [one[0] for one in lines[2 : number + 2]].count(row[0])
            for column, cell in enumerate(row):
                if re.search(r"[1-9]", cell) and row[0] != "**limit**":
                    found[block, column, lines[0][column], row[0], same] = cell
    return found


@by_study
def test_numbers_of_a_page_come_from_records(study):
    """Each column either changes with the measurements, or contains given values."""
    records, given = study.records(), {name for point in study.points(False) for name in point}
    before, changed = cells_of(study.page(records)), set()
    for seed in range(3):
        chance = random.Random(seed)
        moved = [
            one | {key: other(one[key], chance) for key in sorted(one.keys() - given)}
            for one in records
        ]
        after = cells_of(study.page(moved))
        changed |= {key for key, cell in before.items() if after.get(key) != cell}
    columns = {key[:3] for key in changed}
    typed = {key for key in before.keys() - changed if key[1] > 0}
    assert {key for key in typed if key[:3] in columns} == set()
    assert {key[2] for key in typed} == GIVEN.get(study.name, set())


def close(found, stored, rel, name=""):
    if isinstance(stored, dict):
        assert found.keys() - TIMES == stored.keys() - TIMES
        for key in stored.keys() - TIMES:
            close(found[key], stored[key], rel, key)
    elif isinstance(stored, str):
        found, stored = ([float(n) for n in NUMBER.findall(text)] for text in (found, stored))
        assert found == pytest.approx(stored, rel=rel), name
    else:
        assert found == pytest.approx(stored, rel=rel), name


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize(
    ("name", "point", "rel"), AGAIN, ids=[f"{n}, {p['of']}" for n, p, _ in AGAIN]
)
def test_a_point_is_found_as_stored(name, point, rel):
    (stored,) = (one for one in STORED_RECORDS[name].records() if point.items() <= one.items())
    close(point | STORED_RECORDS[name].run(**point), stored, rel)


class TestStudy:
    @pytest.fixture
    def made(self, tmp_path, monkeypatch):
        monkeypatch.setattr(studies.Study, "file", tmp_path / "kept.json")
        points = [{"of": "a", "n": 1}, {"of": "a", "n": 2}, {"of": "b", "m": 1}]
        return studies.Study("made", "", lambda quick: points, lambda **given: given)

    def test_new_records_replace_those_of_the_same_point(self, made):
        last, first = {"of": "b", "m": 1, "x": 3}, {"of": "a", "n": 1, "x": 1}
        made.keep([last, {"of": "a", "n": 2, "x": 2}])
        made.keep([first])
        assert [record["x"] for record in made.records()] == [1, 2, 3]
        made.keep([last | {"x": 4}, last | {"x": 5}, {"of": "c"}])
        assert [record["x"] for record in made.records()] == [1, 2, 4, 5]

    def test_points_are_chosen_by_group_text_and_place(self, made):
        points = made.points(False)
        assert studies.chosen(points, ()) == points
        assert studies.chosen(points, ("b",)) == points[2:]
        assert studies.chosen(points, (), "2") == points[1:2]
        assert studies.chosen(points, (), largest=1) == points[1:]

    def test_the_command_solves_in_a_process_and_writes_on_request(self, tmp_path, monkeypatch):
        study = STORED_RECORDS["static_capacity"]
        kept = study.file.read_bytes()
        page = tmp_path / "page.md"
        monkeypatch.setattr(studies, "ROOT", tmp_path)
        (tmp_path / "docs").mkdir()
        done = CliRunner().invoke(studies.command(study), ["contacts", "--quick"])
        assert done.exit_code == 0, done.output
        assert done.output.startswith(
            "of contacts, name deep groove, inner race, pressure 3000000000"
        )
        page = tmp_path / "docs" / "static_capacity.md"
        assert not page.exists()
        assert study.file.read_bytes() == kept
        assert CliRunner().invoke(studies.command(study), ["--page"]).exit_code == 0
        assert page.read_text(encoding="utf-8") == study.page(study.records())
        drawn = [file.name for file in (tmp_path / "build" / "figures").iterdir()]
        assert drawn == ["static_capacity.png"]
        done = CliRunner().invoke(studies.command(study), ["nothing"])
        assert done.exit_code == 2
        assert "is not one of 'contacts', 'steels', 'fine'" in done.output


def rows_on_the_page(part):
    return tables.rows_of(tables.section_of(PAGE, part))


def test_rows_are_read_from_a_table():
    table = tables.markdown(tables.frame([{"case": "a", "cells": 4, "time_s": 0.25}]))
    assert tables.rows_of(f"### A\n\n{table}\n\na note") == [
        {"case": "a", "cells": 4.0, "time_s": 0.25}
    ]


def test_sentences_below_tables_follow_from_the_tables():
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


def test_the_command_can_rewrite_only_the_sentences(tmp_path, monkeypatch):
    page = tmp_path / "benchmarks.md"
    monkeypatch.setattr("benchmarks.__main__.PAGE", page)
    section = tables.section_of(PAGE, images)
    page.write_text(PAGE.replace(section, section + "\n\ntyped"), encoding="utf-8")
    assert CliRunner().invoke(main, ["--notes"]).exit_code == 0
    assert page.read_text(encoding="utf-8") == PAGE


def test_claims_of_the_page_in_words():
    """Claims on accuracy and cost of fast stress, subdomains and periodic images hold."""
    rows = rows_on_the_page(operators)
    for exact, fast in zip(rows[::2], rows[1::2], strict=True):
        assert (exact["method"], fast["method"]) == ("exact", "fast")
        for name in ("error: stress, rms", "memory_MB"):
            assert fast[name] < exact[name]
        assert fast["time_ratio"] < 0.5
    zones = [row for row in rows_on_the_page(plastic_zones) if row["method"] == "subdomains"]
    for case in {row["case"] for row in zones}:
        times = [row["time_ratio"] for row in zones if row["case"] == case]
        assert max(times) < 1
        assert times == sorted(times, reverse=True)
    for row in rows_on_the_page(images):
        assert row["error: stress, largest"] < float(row["method"].removeprefix("image_tol "))


# Small versions of the tables of the theory, with the range of their ratio to the page.
SMALL_RUNS = {
    "contact_counts": (lambda: theory.contact_counts(rough=()), 0.8, 1.2, ["contact"]),
    "increments": (lambda: theory.increments((1,), 16, 8), 0.4, 2.5, ["increments"]),
    "grid_errors": (lambda: theory.grid_errors((8, 9), (), ()), 1.0, math.inf, ["quantity"]),
    "increment_errors": (
        lambda: increment_errors.stated_errors([*increment_errors.SETUPS][:1], runs=1),
        0.95, 1.05, ["case", "field"],
    ),
    "rolling_reach": (lambda: theory.rolling_reach(20), 0.0, 2.0, ["length of the grid"]),
    "shakedown_cycles": (
        lambda: theory.shakedown_cycles(theory.CYCLES[:1]), 0.95, 1.05, ["load, friction", "result"]
    ),
}  # fmt: skip
# Columns that are independent of the number of rows.
ALONE = {"grid_errors": {"estimated error / true error, minimum"}}


@pytest.mark.parametrize("name", SMALL_RUNS)
def test_a_small_form_of_a_table_of_the_theory(name):
    make, low, high, same = SMALL_RUNS[name]
    page = "\n".join(file.read_text(encoding="utf-8") for file in theory.PAGES)
    made = re.search(rf"<!-- table: {name} -->\n(.*?)<!-- end", page, re.DOTALL)[1]
    rows = {tuple(row[key] for key in same): row for row in tables.rows_of(made)}
    found = {tuple(row[key] for key in same): row for row in tables.rows_of(make())}
    shared = found.keys() & rows.keys()
    assert shared
    for key in shared - {("all",)}:
        for column in ALONE.get(name, found[key].keys() - {*same}):
            new, old = (
                float(NUMBER.search(str(row[column]))[0]) for row in (found[key], rows[key])
            )
            assert low * old <= new <= high * old or abs(new - old) <= (name == "contact_counts")


def test_sentences_on_rough_contact_follow_from_its_tables():
    text = resolution.STUDY.document_file.read_text(encoding="utf-8")
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
        shares += [100 * (one / limit - 1) / row["area uncertainty [%]"]
                   for one, row in zip(area[:3], rows[:3], strict=True)]  # fmt: skip
    low, high = map(float, re.search(r"errors found are\s+([\d.]+) to ([\d.]+)", text).groups())
    assert low - 0.03 < min(shares) < max(shares) < high + 0.03

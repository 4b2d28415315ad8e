# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers on pages are made by what is named beside them, not typed."""

import importlib
import json
import re
from pathlib import Path

import pytest

from benchmarks import theory

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
TEXTS = {str(page.relative_to(ROOT)): page.read_text(encoding="utf-8") for page in PAGES}
ENDS = r"<!-- (?:measured: begin|table: \w+) -->", r"<!-- (?:measured: end|end of table) -->"
MADE = re.compile(".*?".join(ENDS), re.DOTALL)
BY = re.compile(r"<!-- Written by: (.*?) -->", re.DOTALL)
POWER = r"(?:10)?[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+"
NUMBER = rf"[-+−]?(?:\d+\.\d+(?:e-?\d+)?|\d+e-?\d+|{POWER}|\d+ · {POWER}|\d+ %)"
CELL = re.compile(rf"{NUMBER}(?:, {NUMBER})*(?: (?:[GMk]?Pa|[GMk]?B|N|[mµn]?[ms]|%))?")
# Tables that another test holds, or that state what something is.
OTHERS = {
    ("README.md", "quantity"): "tests/structure/test_validation_page.py",  # the stored numbers
    ("docs/gallery.md", "page"): None,  # numbers of figures
}


def typed(text):
    """First words of the tables with measured numbers that nothing makes."""
    if BY.search(text):
        return []
    lines, found = MADE.sub("", text).splitlines(), []
    for number, line in enumerate(lines):
        if line.startswith("|") and not (number and lines[number - 1].startswith("|")):
            rows = [line]
            while number + len(rows) < len(lines) and lines[number + len(rows)].startswith("|"):
                rows.append(lines[number + len(rows)])
            cells = [cell.strip() for row in rows[2:] for cell in row.strip("|").split("|")[1:]]
            if any(CELL.fullmatch(cell) for cell in cells):
                found.append(line.strip("| ").split("|")[0].strip())
    return found


@pytest.mark.parametrize(
    ("cell", "number"),
    [("3.982 GPa", True), ("5e-3", True), ("0.8 %", True), ("27 %", True), ("3 · 10⁻⁴", True),
     ("1", False), ("≤ 0.05", False), ("2 x 2", False), ("> 0", False), ("10⁵ to 10⁷", False)],
)  # fmt: skip
def test_what_is_a_measured_number(cell, number):
    table = f"| name | value |\n|---|---|\n| a | {cell} |\n"
    assert typed(table) == (["name"] if number else [])
    assert typed(f"<!-- table: made -->\n\n{table}\n<!-- end of table -->") == []
    assert typed(f"<!-- Written by: a command -->\n{table}") == []


def test_every_table_of_numbers_is_made():
    found = {(page, head) for page, text in TEXTS.items() for head in typed(text)}
    assert found == set(OTHERS)
    for (page, head), test in OTHERS.items():
        assert test is None or page in (ROOT / test).read_text(encoding="utf-8"), head


def test_what_makes_a_page_exists():
    commands = {command for text in TEXTS.values() for command in BY.findall(text)}
    assert len(commands) > 10
    for command in commands:
        module = re.search(r"python -m ([\w.]+)", command)
        files = [Path(module[1].replace(".", "/"))] if module else [Path("test")]
        assert any((ROOT / f).exists() or (ROOT / f.with_suffix(".py")).exists() for f in files)


def kept(text, name):
    return re.search(rf"<!-- table: {name} -->\n\n(.*?)\n\n<!-- end", text, re.DOTALL)[1]


def test_tables_of_the_theory_are_made():
    text = TEXTS["docs/theory.md"]
    assert set(re.findall(r"<!-- table: (\w+) -->", text)) == set(theory.TABLES)
    page = theory.page(text, {"contact_counts": "other"})
    assert "\n\nother\n\n<!-- end of table -->" in page
    assert theory.page(page, {"contact_counts": kept(text, "contact_counts")}) == text


def test_limits_of_shakedown_are_those_of_the_theory():
    made, stated = theory.shakedown_limits(), kept(TEXTS["docs/theory.md"], "shakedown_limits")
    found, told = (re.findall(r"\d\.\d{3}", table) for table in (made, stated))
    assert len(found) == 5 * len(theory.FRICTIONS)
    assert [*map(float, found)] == pytest.approx([*map(float, told)], abs=1.01e-3)  # a digit


def test_counts_of_drawn_scenes_are_those_of_a_run(monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "tests" / "fuzz")
    counter = importlib.import_module("scene_counts")
    counts = json.loads(counter.COUNTS.read_text(encoding="utf-8"))
    assert list(counts) == list(counter.KINDS)
    assert kept(TEXTS["docs/testing.md"], "drawn_scenes") == counter.table(counts)
    assert counts["all"]["FAILED"] == 0
    once = counter.counted(counter.outcomes(["0 solved", "3 convergence", "0 parts", "x 1"]))
    assert once["all"]["convergence"] == once["all"]["parts"] == 1
    assert sum(once["all"].values()) == 2

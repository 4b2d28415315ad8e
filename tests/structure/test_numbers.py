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
    ("docs/features.md", "quantity"): "tests/structure/test_validation_page.py",  # stored numbers
    ("docs/gallery.md", "page"): None,  # numbers of figures
}

CODE = re.compile(r"^```.*?^```$|\$\$.*?\$\$|`[^`\n]+`", re.DOTALL | re.MULTILINE)
WORDS = "a|an|one|two|three|four|five|six|seven|eight|nine|ten|twelve"
FRACTION_WORDS = (
    "half|halves|thirds?|quarters?|fifths?|sixths?|sevenths?|eighths?|tenths?|twelfths?"
)
FIGURE = r"\d+(?:\.\d+)?"
AMOUNT = rf"(?:{FIGURE}|\b(?:(?:{WORDS})(?:[ -](?:{FRACTION_WORDS}))?|half|twice))"
# What something takes: a duration, a size in memory, or such a thing as a multiple of another.
COST = re.compile(
    rf"\b{FIGURE}(?: |-)(?:[mµ]?s|min|h|[kMGT]?B|(?:second|minute|hour)s?)\b(?! *[/·^])"
    rf"|{AMOUNT} (?:(?:%|times)(?: of the| the| as| less| more)?|of the|of its|the|as) "
    r"(?:time|memory|work|cost|long|fast|slow|quick|faster|slower|cheaper|dearer)\b"
)
# Those that nobody has measured: set, where the code has them so; or of what is described.
SET = {
    ("docs/developer/data_layout.md", "64 kB"): ("cpp/src/base/aligned.cpp", "1} << 16"),
    ("docs/developer/threads.md", "1 MB"): (
        "python/samcontact/_util/load_core.py", "MIN_STACK_BYTES = 2**20"),
    ("docs/developer/data_layout.md", "16 MB"): ("cpp/src/base/aligned.cpp", "1} << 24"),
    ("docs/developer/states.md", "512 MB"): ("python/samcontact/_util/field_cache.py", "512e6"),
    ("docs/peers.md", "3 s"): ("benchmarks/peers/schedule.py", "MAX_REPEATED_SECONDS = 3.0"),
    ("docs/theory/zones.md", "0.7 of the work"): (
        "cpp/src/simulation/increment/split_choice.cpp", "max_work_ratio = 0.7"),
    ("docs/theory/zones.md", "0.45 of its work"): (
        "cpp/src/simulation/increment/split_choice.cpp", "max_work_ratio_periodic = 0.45"),
    ("docs/theory/zones.md", "a quarter of the work"): None,  # of the cells there are
    ("docs/theory/half_space.md", "a quarter of the memory"): None,  # planes counted there
    ("docs/theory/periodic.md", "19 times as long"): None,  # a period
}  # fmt: skip
TEMPLATES = {
    str(page.relative_to(ROOT)): page.read_text(encoding="utf-8")
    for page in [*(ROOT / "benchmarks").rglob("*.md"), ROOT / "docs" / "validation.md.jinja"]
}
WRITTEN = re.compile(r'^(?:TEXT|HEAD) = """(.*?)"""$', re.DOTALL | re.MULTILINE)
TEMPLATES |= {
    str(file.relative_to(ROOT)): "\n".join(WRITTEN.findall(file.read_text(encoding="utf-8")))
    for file in (ROOT / "benchmarks").rglob("*.py")
}


def costs(text):
    """What a page says that something takes, where nothing makes it: in prose, as a number."""
    prose = CODE.sub("", MADE.sub("", text))
    lines = " ".join(line for line in prose.splitlines() if not line.startswith("|"))
    return [match[0].strip() for match in COST.finditer(lines)]


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


@pytest.mark.parametrize(
    ("words", "found"),
    [("It takes 3.2 s.", ["3.2 s"]), ("of 0.6 kB a cell", ["0.6 kB"]),
     ("a third of the\ntime of one box", ["a third of the time"]),
     ("1.7 times as long", ["1.7 times as long"]), ("is 10 % slower", ["10 % slower"]),
     ("5 to 6 times faster", ["6 times faster"]), ("{ratio} times as long", []),
     ("at 3 m/s, 0.12 m/s", []), ("for a long time", []), ("`sleep 3 s` in\n```\n3 s\n```", [])],
)  # fmt: skip
def test_what_is_a_cost(words, found):
    assert costs(words) == found
    assert costs(f"<!-- table: made -->\n{words}\n<!-- end of table -->") == []


def test_no_cost_is_typed():
    """Times, memory and their ratios, in pages and in what pages are made of."""
    pages = {name: text for name, text in TEXTS.items() if not BY.search(text)} | TEMPLATES
    found = {(name, cost) for name, text in pages.items() for cost in costs(text)}
    assert found == set(SET)
    for place in filter(None, SET.values()):
        assert place[1] in (ROOT / place[0]).read_text(encoding="utf-8")


def test_every_table_of_numbers_is_made():
    found = {(page, head) for page, text in TEXTS.items() for head in typed(text)}
    assert found == set(OTHERS)
    for (page, head), test in OTHERS.items():
        assert test is None or Path(page).name in (ROOT / test).read_text(encoding="utf-8"), head


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
    text = "\n".join(TEXTS[name] for name in sorted(TEXTS) if name.startswith("docs/theory/"))
    assert set(re.findall(r"<!-- table: (\w+) -->", text)) == set(theory.TABLES)
    page = theory.page(text, {"contact_counts": "other"})
    assert "\n\nother\n\n<!-- end of table -->" in page
    assert theory.page(page, {"contact_counts": kept(text, "contact_counts")}) == text


def test_limits_of_shakedown_are_those_of_the_theory():
    made = theory.shakedown_limits()
    stated = kept(TEXTS["docs/theory/shakedown.md"], "shakedown_limits")
    found, told = (re.findall(r"\d\.\d{3}", table) for table in (made, stated))
    assert len(found) == 5 * len(theory.FRICTIONS)
    assert [*map(float, found)] == pytest.approx([*map(float, told)], abs=1.01e-3)  # a digit


def test_counts_of_drawn_scenes_are_those_of_a_run(monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "tests" / "fuzz")
    counter = importlib.import_module("setup_counts")
    counts = json.loads(counter.COUNTS.read_text(encoding="utf-8"))
    assert list(counts) == list(counter.KINDS)
    assert kept(TEXTS["docs/testing.md"], "drawn_setups") == counter.table(counts)
    assert counts["all"]["FAILED"] == 0
    once = counter.counted(counter.outcomes(["0 solved", "3 convergence", "0 parts", "x 1"]))
    assert once["all"]["convergence"] == once["all"]["parts"] == 1
    assert sum(once["all"].values()) == 2

# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation: its examples run, what it names exists, its links lead somewhere."""

import importlib
import re
from pathlib import Path

import pytest

import samcontact as sc
from samcontact import results
from samcontact.cases import Case
from samcontact.cases.base import Section

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / name for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md")]
PAGES += sorted((ROOT / "docs").rglob("*.md"))
TEXTS = {str(page.relative_to(ROOT)): page.read_text(encoding="utf-8") for page in PAGES}
pages = pytest.mark.parametrize("page", TEXTS)

BLOCKS = re.compile(r"^```(\{\w+\})\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
EXAMPLES = [
    pytest.param(block, id=f"{page}-{number}")
    for page, text in TEXTS.items()
    for number, (language, block) in enumerate(FENCE.findall(text))
    if language == "python"
]


INDEXES = [f"docs/{folder}/index.md" for folder in ("theory", "developer", "decisions")]
PARTS = tuple(index.removesuffix("index.md") for index in INDEXES)


def prose(page):
    """The page without its fenced blocks."""
    return FENCE.sub("", TEXTS[page])


@pytest.mark.parametrize("block", EXAMPLES)
def test_example_runs(block, tmp_path, monkeypatch, capsys):
    """And prints what it says beside a `print`, to the digits given."""
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {"__name__": "example"})
    printed = capsys.readouterr().out.split()
    beside = r"^print\(.*\)  # (\d[\d.]*)(e-?\d+)?\b"
    for digits, power in re.findall(beside, block, re.MULTILINE):
        last = 0.5001 * float(f"1{power or 'e0'}") * 10.0 ** -len(digits.partition(".")[2])
        numbers = [float(word) for word in printed if re.fullmatch(r"[\d.]+(?:e-?\d+)?", word)]
        assert any(abs(number - float(digits + power)) <= last for number in numbers), digits


@pages
def test_paths_exist(page):
    folders = "cpp|python|tests|cases|docs|cmake|benchmarks|gallery|reference"
    named = re.compile(rf"(?<![\w./])(?:(?:{folders})/[\w./-]+|\./\w+)")
    # the targets of links are relative to the page, and checked below
    text = re.sub(r"\]\([^)]*\)", "]", TEXTS[page])
    paths = {path.rstrip("./-") for path in named.findall(text)}
    missing = sorted(path for path in paths if not (ROOT / path).exists())
    assert not missing


def resolve(name):
    """The object a dotted name in the package stands for."""
    first, *rest = name.split(".")
    # modules such as `results` are not attributes of the package before they are imported
    target = getattr(sc, first, None) or importlib.import_module(f"samcontact.{first}")
    for part in rest:
        target = getattr(target, part)
    return target


@pages
def test_names_exist(page):
    code = " ".join(re.findall(r"`([^`\n]+)`", prose(page)))
    for name in re.findall(r"\b(?:sc|samcontact)\.([A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*)", code):
        resolve(name)


TESTS = "\n".join(file.read_text(encoding="utf-8") for file in (ROOT / "tests").rglob("*.py"))


@pages
def test_named_tests_exist(page):
    code = " ".join(re.findall(r"`([^`\n]+)`", prose(page)))
    named = set(re.findall(r"(?<![\w/])(?:test_\w+|Test[A-Z]\w*)(?!\.py)\b", code))
    missing = sorted(n for n in named if not re.search(rf"^ *(?:def|class) {n}\b", TESTS, re.M))
    assert not missing


def anchors(page):
    headings = re.findall(r"^#+ (.+)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pages
def test_links_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
        if target.startswith(("https://", "http://", "../build/")):  # the last are the site's
            continue
        path, _, anchor = target.partition("#")
        file = (ROOT / page).parent / path if path else ROOT / page
        assert file.exists(), target
        if anchor:
            assert anchor in anchors(str(file.resolve().relative_to(ROOT))), target


def test_every_page_is_linked_from_the_readme():
    links = set(re.findall(r"\]\(([^)\s]+)\)", TEXTS["README.md"]))
    parts = {page for page in TEXTS if page.startswith(PARTS)} - set(INDEXES)
    parts |= {page for page in TEXTS if page.startswith(("docs/gallery/", "docs/api/"))}
    # made from others, or there for the site only
    site = {
        f"docs/{name}.md"
        for name in ("index", "case_reference", "notebooks", "contributing", "changes")
    }
    assert links >= set(TEXTS) - parts - site - {"README.md"}


@pytest.mark.parametrize("index", INDEXES)
def test_every_page_of_a_folder_is_linked_from_its_first_page(index):
    links = re.findall(r"\]\(([^)\s]+)\)", TEXTS[index])
    folder = {page for page in TEXTS if page.startswith(index.removesuffix("index.md"))} - {index}
    assert {index.replace("index.md", link) for link in links} >= folder
    assert set(pages_below(index)) == folder


def test_every_page_of_the_gallery_is_linked_from_its_first_page():
    links = re.findall(r"\]\(([^)\s]+)\)", TEXTS["docs/gallery.md"])
    gallery = {page for page in TEXTS if page.startswith("docs/gallery/")}
    assert {f"docs/{link}" for link in links} >= gallery


def test_newest_change_is_this_version():
    version, date = re.findall(r"^## \[(.+?)\] - (.+)$", TEXTS["CHANGELOG.md"], re.MULTILINE)[0]
    assert version == sc.__version__
    assert re.fullmatch(r"\d{4}-\d\d-\d\d", date)


def test_every_version_tells_whether_numbers_changed():
    for release in re.split(r"^## \[", TEXTS["CHANGELOG.md"], flags=re.MULTILINE)[1:]:
        assert "### Numerical results changed" in release


def pages_below(index):
    """Pages in the order of the table of contents of an index page."""
    toctree = dict(BLOCKS.findall(TEXTS[index]))["{toctree}"]
    return [index.replace("index", name) for name in toctree.split() if not name.startswith(":")]


def test_equations_are_numbered_in_order():
    index = "docs/theory/index.md"
    tags = {
        page: re.findall(r"\\tag\{(\d+)([a-z]?)\}", TEXTS[page])
        for page in [index, *pages_below(index)]
    }
    numbers = [int(number) for found in tags.values() for number, letter in found if not letter]
    assert numbers == list(range(1, len(numbers) + 1))
    row = re.compile(r"^\| \[.*\]\((\w+)\.md\) \| (.*?) ?\|", re.MULTILINE)
    for name, said in row.findall(TEXTS[index]):
        found = [f"({number}{letter})" for number, letter in tags[f"docs/theory/{name}.md"]]
        ends = dict.fromkeys([found[0], found[-1]]) if found else []
        assert said == " to ".join(ends), name


def sections(model=Section):
    for section in model.__subclasses__():
        yield section
        yield from sections(section)


def test_every_field_of_a_case_file_is_documented():
    text = TEXTS["docs/case_files.md"]
    fields = {name for section in sections() for name in section.model_fields}
    assert fields > {"title", "nx", "yield_stress", "hurst", "on_border", "spacing", "volume"}
    assert sorted(name for name in fields if not re.search(rf"\b{name}\b", text)) == []


# Bodies that move differently, and by parts of a cell, have the most to tell.
PASS = {"distance": 4e-4, "step": 2e-4, "slide_to_roll": -0.3}


def test_every_variable_of_a_results_file_is_documented():
    swift = {"law": "swift", "E": 210e9, "nu": 0.3, "B": 945e6, "C": 20.0, "n": 0.121}
    case = Case.model_validate(
        {
            "title": "small",
            "grid": {"nx": 8, "ny": 8, "dx": 1e-4, "dy": 1e-4, "nz": 8, "dz": 1e-4},
            "body1": swift,
            "body2": swift,
            "surface": {"shape": "paraboloid", "Rx": 7.5e-3},
            "contact": {"friction": 0.1},
            "path": [{"load": 50.0, "increments": 1, "roll": PASS}],
        }
    )
    simulation, path = case.build()
    dataset = results.to_dataset(simulation, simulation.run(path, progress=False), case)
    names = {re.sub(r"body[12]$", "bodyN", str(name)) for name in dataset.variables}
    assert {"travel_bodyN", "offset_bodyN", "track_residual_stress_bodyN"} <= names
    text = TEXTS["docs/case_files.md"]
    assert sorted(name for name in names if not re.search(rf"\b{name}\b", text)) == []


def test_the_tutorial_states_what_its_examples_compute(capsys):
    """Numbers in its sentences are those that its first examples make, rounded."""
    page = "docs/tutorial.md"
    first, second = (block for language, block in FENCE.findall(TEXTS[page])[:2])
    made: dict[str, object] = {}
    exec(compile(first, "example", "exec"), made)
    hertz, steel = made["hertz"], made["steel"]
    text = " ".join(prose(page).split())
    assert f"{hertz.p0 / 1e9:.1f} GPa, and a von Mises stress of" in text
    assert f"von Mises stress of {hertz.max_von_mises(0.3)[0] / 1e9:.1f} GPa below" in text
    assert f"begins to yield at {float(steel.yield_stress(0.0)) / 1e9:.2f} GPa" in text
    exec(compile(second, "example", "exec"), made)
    grid, law = made["grid"], made["simulation"].body2
    assert f"{grid.nx * grid.dx / (2 * hertz.a):.1f} times as wide as the contact" in text
    assert f"has {hertz.a / grid.dx:.0f} cells to a contact radius" in text
    assert law.yield_stress(0.0) == steel.yield_stress(0.0)  # the same steel
    # every number with a unit in these sentences is one of those above, or what is given
    stated = set(re.findall(r"[\d.]+ (?:GPa|MPa|N|mm)\b", text))
    assert stated == {"15 mm", "1500 N", "4.1 GPa", "2.5 GPa", "1.36 GPa"}

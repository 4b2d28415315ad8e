# SPDX-License-Identifier: GPL-3.0-or-later
"""Documentation: examples run, named objects and link targets exist."""

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


INDEXES = [
    f"docs/{folder}/index.md"
    for folder in ("applications", "guides", "theory", "developer", "decisions")
]


def prose(page):
    """Return the page without its fenced blocks."""
    return FENCE.sub("", TEXTS[page])


@pytest.mark.parametrize("block", EXAMPLES)
def test_example_runs(block, tmp_path, monkeypatch, capsys):
    """An example runs and prints the numbers in the comments after its `print`, to their digits."""
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {"__name__": "example"})
    printed = capsys.readouterr().out.split()
    commented = r"^print\(.*\)  # (\d[\d.]*)(e-?\d+)?\b"
    for digits, power in re.findall(commented, block, re.MULTILINE):
        last = 0.5001 * float(f"1{power or 'e0'}") * 10.0 ** -len(digits.partition(".")[2])
        numbers = [float(word) for word in printed if re.fullmatch(r"[\d.]+(?:e-?\d+)?", word)]
        assert any(abs(number - float(digits + power)) <= last for number in numbers), digits


@pages
def test_no_line_of_text_is_a_comment(page):
    """MyST omits the rest of a paragraph after a line that begins with a per cent sign."""
    assert re.findall(r"^ *%.*", prose(page), re.MULTILINE) == []


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
    """Return the object of a dotted name in the package."""
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
def test_link_targets_exist(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
        if target.startswith(("https://", "http://", "../build/")):  # the last are the site's
            continue
        path, _, anchor = target.partition("#")
        file = (ROOT / page).parent / path if path else ROOT / page
        assert file.exists(), target
        if anchor:
            assert anchor in anchors(str(file.resolve().relative_to(ROOT))), target


def toctrees(page):
    """Return the pages in the tables of contents of a page, in order."""
    folder = page.rpartition("/")[0]
    for kind, block in BLOCKS.findall(TEXTS[page]):
        for name in block.split("\n") if kind == "{toctree}" else ():
            if name and not name.startswith(":"):
                found = sorted((ROOT / folder).glob(f"{name}.md"))
                yield from (str(file.relative_to(ROOT)) for file in found)


def test_every_page_is_in_the_navigation():
    found, waiting = set(), ["docs/index.md"]
    while waiting:
        page = waiting.pop()
        found.add(page)
        waiting += set(toctrees(page)) - found
    assert found == {page for page in TEXTS if page.startswith("docs/")}


def test_the_readme_is_short_and_leads_to_each_part():
    assert len(TEXTS["README.md"].splitlines()) <= 110
    links = set(re.findall(r"\]\(([^)#\s]+)", TEXTS["README.md"]))
    using, trusting, theory, extending = re.findall(
        r":caption: .*?\n(.*?)```", TEXTS["docs/index.md"], re.DOTALL
    )
    for part in (using, trusting, theory, extending):
        assert links & {f"docs/{name}.md" for name in part.split()}, part
    guides = set(toctrees("docs/guides/index.md"))
    assert links & guides >= guides - {"docs/guides/heat.md"}


def test_every_notebook_is_linked_from_a_guide():
    text = "".join(TEXTS[page] for page in pages_below("docs/guides/index.md"))
    linked = set(re.findall(r"/notebooks/(\w+\.ipynb)\)", text))
    assert linked == {file.name for file in (ROOT / "notebooks").glob("*.ipynb")}


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


def test_every_version_states_whether_numbers_changed():
    for release in re.split(r"^## \[", TEXTS["CHANGELOG.md"], flags=re.MULTILINE)[1:]:
        assert "### Numerical results changed" in release


def pages_below(index):
    """Return the pages in the order of the table of contents of an index page."""
    return list(toctrees(index))


def test_equations_are_numbered_in_order():
    index = "docs/theory/index.md"
    tags = {
        page: re.findall(r"\\tag\{(\d+)([a-z]?)\}", TEXTS[page])
        for page in [index, *pages_below(index)]
    }
    numbers = [int(number) for found in tags.values() for number, letter in found if not letter]
    assert numbers == list(range(1, len(numbers) + 1))
    row = re.compile(r"^\| \[.*\]\((\w+)\.md\) \| (.*?) ?\|", re.MULTILINE)
    for name, label in row.findall(TEXTS[index]):
        found = [f"({number}{letter})" for number, letter in tags[f"docs/theory/{name}.md"]]
        ends = dict.fromkeys([found[0], found[-1]]) if found else []
        assert label == " to ".join(ends), name


def sections(model=Section):
    for section in model.__subclasses__():
        yield section
        yield from sections(section)


def test_every_field_of_a_case_file_is_documented():
    text = TEXTS["docs/case_files.md"]
    fields = {name for section in sections() for name in section.model_fields}
    assert fields > {"title", "nx", "yield_stress", "hurst", "on_border", "spacing", "volume"}
    assert sorted(name for name in fields if not re.search(rf"\b{name}\b", text)) == []


def test_every_field_of_a_case_file_has_a_meaning_and_no_other(monkeypatch):
    """The table of the case reference, one short line for each field."""
    monkeypatch.syspath_prepend(ROOT / "docs" / "_ext")
    schema = importlib.import_module("case_schema")
    tables = schema.tomllib.loads(schema.MEANINGS.read_text(encoding="utf-8"))
    unused = {(place, name) for place, fields in tables.items() for name in fields}
    for model, meaning in schema.meanings().items():
        place = schema.place_of(model)
        for name, line in meaning.items():
            assert 8 < len(line) <= 100, (place, name)
            assert line[-1] != ".", (place, name)
            above = re.sub(r"\.(layers|inclusions|random_inclusions)$", "", place)
            places = [p for p in (place, above, "any") if p in tables]
            unused.discard((next(p for p in places if name in tables[p]), name))
    assert unused == set()


def test_every_error_and_warning_is_on_the_troubleshooting_page():
    classes = {name for name in sc.__all__ if name.endswith(("Error", "Warning", "Interrupted"))}
    assert len(classes) > 8
    text = TEXTS["docs/troubles.md"]
    assert {name for name in classes if f"`sc.{name}`" not in text} == set()


@pytest.mark.parametrize(
    ("word", "page"),
    [("brinelling", "bearing"), ("misalignment", "bearing"), ("indentation", "indentation"),
     ("coating", "coating"), ("fretting", "fretting"), ("creepage", "rail")],
)  # fmt: skip
def test_words_that_users_search_for_lead_to_a_guide(word, page):
    assert re.search(rf"\b{word}", TEXTS[f"docs/guides/{page}.md"], re.IGNORECASE)


# Bodies with different motions by fractions of a cell have the most variables.
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
    """Numbers in the text of the tutorial are the rounded results of its first examples."""
    page = "docs/tutorial.md"
    first, second = (block for language, block in FENCE.findall(TEXTS[page])[:2])
    made: dict[str, object] = {}
    exec(compile(first, "example", "exec"), made)
    hertz, steel = made["hertz"], made["steel"]
    text = " ".join(prose(page).split())
    stress, depth = hertz.max_von_mises(0.3)
    assert f"maximum pressure is {hertz.p0 / 1e9:.2f} GPa" in text
    assert f"von Mises stress, {stress / 1e9:.2f} GPa at a depth of {depth * 1e3:.2f} mm" in text
    assert f"initial yield stress of {float(steel.yield_stress(0.0)) / 1e9:.2f} GPa" in text
    exec(compile(second, "example", "exec"), made)
    grid, law = made["grid"], made["simulation"].body2
    assert f"{grid.nx * grid.dx / (2 * hertz.a):.1f} times as wide as the contact" in text
    assert f"has {hertz.a / grid.dx:.0f} cells per contact radius" in text
    assert f"limits the pressure to {made['loaded'].pressure.max() / 1e9:.2f} GPa" in text
    imprint = made["unloaded"].residual_displacement(body=2).max()
    assert f"an imprint {imprint * 1e6:.2f} µm deep" in text
    assert law.yield_stress(0.0) == steel.yield_stress(0.0)  # the same steel
    # every number with a unit in these sentences is one of those above, or is given
    stated = set(re.findall(r"[\d.]+ (?:GPa|MPa|N|mm|µm)\b", text))
    given, pressures = {"15 mm", "1500 N"}, {"4.10 GPa", "2.54 GPa", "1.36 GPa", "3.98 GPa"}
    assert stated == given | pressures | {"0.20 mm", "0.29 µm"}

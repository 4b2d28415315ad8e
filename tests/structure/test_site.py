# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation site builds without warnings and is complete without a network."""

import re
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

import samcontact as sc
from browser import chromium, served

DOCS = Path(__file__).parents[2] / "docs"


VARIANTS = tomllib.loads((Path(__file__).parents[1] / "slow_variants.toml").read_text("utf-8"))
LONG_NOTEBOOKS = VARIANTS["notebooks/test_notebooks.py"]["test_runs_and_shows_figures"]


@pytest.fixture(scope="module", params=[False, pytest.param(True, marks=pytest.mark.slow)])
def with_long_notebooks(request):
    return request.param


@pytest.fixture(scope="module")
def site(tmp_path_factory, with_long_notebooks):
    """Return the folder of the built site.

    By default, it is the brief site of docs/conf.py, without outputs of long notebooks.
    """
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html"]
    if not with_long_notebooks:
        command += ["-D", f"unexecuted_notebooks={','.join(LONG_NOTEBOOKS)}"]
        command += ["-t", "brief"]
    built = subprocess.run(
        [*command, "-d", str(folder / "doctrees"), str(DOCS), str(folder / "html")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert built.returncode == 0, built.stderr
    return folder / "html"


def test_every_source_is_a_page(site):
    for source in DOCS.rglob("*.md"):
        assert (site / source.relative_to(DOCS).with_suffix(".html")).exists(), source


def test_navigation_leads_to_every_page(site):
    tree = (site / "index.html").read_text().partition('class="sidebar-tree"')[2]
    linked = set(re.findall(r'href="([\w/.]+)\.html"', tree.partition("</aside>")[0]))
    sources = {str(file.relative_to(DOCS).with_suffix("")) for file in DOCS.rglob("*.md")}
    assert len(sources - linked) == 1  # the home page itself
    assert {f"notebooks/{file.stem}" for file in (DOCS / "notebooks").glob("*.ipynb")} <= linked


def test_the_reference_has_all_public_names(site):
    text = "".join(page.read_text() for page in (site / "api").glob("*.html"))
    missing = []
    for name in sc.__all__:
        thing = getattr(sc, name)
        if name.startswith("__"):
            continue
        full = thing.__name__ if hasattr(thing, "__file__") else f"samcontact.{name}"
        if f'id="{full}' not in text and f'id="module-{full}' not in text:
            missing.append(name)
    assert not missing


def test_the_fields_of_case_files_come_from_the_models(site):
    text = (site / "case_reference.html").read_text()
    for expected in ("image_tol", "&gt; 0.0", "back_and_forth", "list of lists of numbers"):
        assert expected in text
    meaning = r"<td><p>cell size along x</p></td>"
    assert re.search(rf">dx</span></code></p></td>\s*{meaning}\s*<td><p>m</p></td>", text)


def test_functions_on_the_questions_page_are_links(site):
    text = (site / "questions.html").read_text().partition("<h1>")[2]
    named = re.findall(r'(<a [^>]*>)?<code [^>]*><span class="pre">sc\.[\w.]+</span></code>', text)
    assert len(named) > 60
    assert all(named)
    assert 'href="api/references.html#samcontact.hertz.point"' in text


def test_the_first_page_has_a_picture_for_each_kind_of_user(site):
    text = (site / "index.html").read_text()
    card = (
        r'href="(?:applications|guides|theory)/(\w+)\.html"><img alt="([^"]+)" src="data:image/png'
    )
    assert len(dict(re.findall(card, text))) == 9


def headings(page):
    """Return the plain texts of the headings of a page."""
    found = re.findall(r"<h[123]>(.*?)<a class=\"headerlink\"", page.read_text(), re.DOTALL)
    return [re.sub(r"<[^>]*>", "", text).replace("&quot;", '"') for text in found]


def test_sections_of_case_files_are_titled_as_there(site):
    titles = headings(site / "case_reference.html")
    assert len(set(titles)) == len(titles)
    for expected in ("[grid]", '[body1], [body2] with law = "swift"', "[[path]]", "[path.roll]"):
        assert expected in titles
    # class names are of no use to authors of case files
    assert [title for title in titles if re.search(r"[a-z][A-Z]|^[A-Z]\w+[A-Z]", title)] == []


def test_signatures_have_short_type_names(site):
    text = "".join(page.read_text() for page in (site / "api").glob("*.html"))
    plain = re.sub(r"<[^>]*>", "", text)
    assert "gap: ArrayLike" in plain
    assert "ArrayLike | None" in plain
    for spelled_out in ("TypeAliasForwardRef", "_SupportsArray", "_NestedSequence", "dtype[Any]"):
        assert spelled_out not in plain


def test_long_signatures_have_a_line_for_each_parameter(site):
    text = (site / "api" / "contact.html").read_text()
    signature = text.partition('id="samcontact.ContactSolver"')[2].partition("</dt>")[0]
    assert signature.count("<dd>") > 5
    assert not re.search(r"Bases: <code[^>]*><span[^>]*>object<", text)


def test_words_between_parameters_are_not_parameters(site):
    """Words of a sentence between parameters must not be taken for parameter names."""
    text = "".join(page.read_text() for page in (site / "api").glob("*.html"))
    types = re.findall(r"<strong>[^<]*</strong> \(<em>([^<]*)</em>", text)
    assert types
    assert [found for found in types if re.search(r"\b(are|is|those|this)\b", found)] == []
    assert "model_config" not in text


def test_the_docstring_of_a_property_is_not_parsed_as_its_type(site):
    """Text before a colon in the first line of a property must not be taken for its type."""
    text = "".join(page.read_text() for page in (site / "api").glob("*.html"))
    types = re.findall(r'Type<span class="colon">:</span></dt>\s*<dd[^>]*><p>(.*?)</p>', text)
    assert types
    assert [found for found in types if re.match(r"[A-Z][a-z]+ [a-z]", found)] == []


def test_notebooks_and_tutorial_show_their_output_and_figures(site, with_long_notebooks):
    for source in (DOCS.parent / "notebooks").glob("*.ipynb"):
        if source.stem in LONG_NOTEBOOKS and not with_long_notebooks:
            continue
        page = (site / "notebooks" / f"{source.stem}.html").read_text()
        described = re.findall(r'<img alt="([^"]+)"[^>]* src="\.\./_images/', page)
        assert len(described) >= 3, source
        assert not [alt for alt in described if alt.endswith(".png")], source
        assert "output stream" in page, source
    tutorial = (site / "tutorial.html").read_text()
    assert re.search(r"maximum pressure \d\.\d\d GPa", tutorial)
    assert "results/ball/results.nc" in tutorial  # from the command below the case file
    assert "[1m" not in tutorial  # nor codes for a terminal
    assert tutorial.count("data:image/png;base64,") == 2
    assert '<img alt="Figure drawn by the code"' in (site / "index.html").read_text()


def test_every_notebook_has_its_picture(site):
    text = (site / "notebooks.html").read_text()
    linked = re.findall(r'href="notebooks/(\w+)\.html"><img alt="[^"]+" src="data:image/png', text)
    assert linked == sorted(path.stem for path in (DOCS.parent / "notebooks").glob("*.ipynb"))


def test_words_in_types_are_not_links(site):
    text = "".join(page.read_text() for page in (site / "api").glob("*.html"))
    assert "(array_like, shape (nx, ny)" in re.sub(r"<[^>]*>", "", text)
    assert not re.search(r"<a [^>]*><em>[a-z_]+</em></a>", text)


def test_every_part_of_the_gallery_has_its_picture(site):
    text = (site / "gallery.html").read_text()
    parts = {path.stem for path in (DOCS / "gallery").glob("*.md")}
    picture = r'href="gallery/(\w+)\.html">(?:<span[^>]*>)?<img alt="[^"]+"[^>]* src="_images/'
    linked = re.findall(picture, text)
    assert sorted(linked) == sorted(parts)


def test_figures_of_benchmarks_are_drawn(site):
    drawn = {}
    for page in DOCS.glob("*.md"):
        drawn[page.stem] = re.findall(r"\.\./build/figures/(\w+)\.png", page.read_text())
        text = (site / f"{page.stem}.html").read_text()
        for name in drawn[page.stem]:
            assert f'src="_images/{name}.png"' in text
            with Image.open(site / "_images" / f"{name}.png") as picture:
                assert picture.width > 700
    assert {page for page in drawn if drawn[page]} == {
        "experiments", "finite_elements", "peers", "static_capacity"
    }  # fmt: skip


def test_every_module_is_listed_with_its_first_line(site):
    text = (site / "developer" / "modules.html").read_text()
    row = r'<span class="pre">(\w+)</span></code></p></td>\s*<td>(.*?)</td>'
    rows = dict(re.findall(row, text, re.DOTALL))
    for top, pattern in (("python/samcontact", "*.py"), ("cpp/include", "*.hpp")):
        stems = {file.stem for file in (DOCS.parent / top).rglob(pattern)}
        assert {stem for stem in stems if not stem.startswith("__")} <= set(rows)
    assert [name for name, text in rows.items() if len(text) < 20] == []
    rooms = (site / "architecture.html").read_text()
    for folder in (DOCS.parent / "python" / "samcontact").glob("*/__init__.py"):
        assert f'<span class="pre">{folder.parent.name}</span>' in rooms


CUT = """
const page = document.documentElement;
return {
  formulas: document.querySelectorAll(".math mjx-container").length,
  raw: document.querySelectorAll("div.math, span.math").length,
  errors: [...document.querySelectorAll("[data-mml-node=merror]")].map(e => e.textContent),
  missing: [...document.images].filter(i => !i.complete || !i.naturalWidth).map(i => i.src),
  wider: page.scrollWidth - page.clientWidth,
  squeezed: [...document.querySelectorAll("article p > img")].filter(
    i => i.naturalWidth >= 700 && i.width < 600 && i.src.endsWith(".png")).map(i => i.src),
  beyond: [...document.querySelectorAll("article a")].filter(
    a => a.getBoundingClientRect().right > page.clientWidth && !a.closest("pre, .table-wrapper")
  ).map(a => a.textContent),
};
"""


PAGES = ["index", "tutorial", "features", "case_reference", "api/contact", "gallery/friction"]
PAGES += ["notebooks/02_yield_and_hardening", "developer/modules", "theory/friction"]
MORE_PAGES = [
    "questions",
    "troubles",
    "guides/bearing",
    "guides/index",
    "gallery",
    "genindex",
    "architecture",
]
MORE_PAGES += ["developer/recipes", "developer/data_layout", "applications/blade_root"]


def test_pages_in_a_browser_without_a_network(site, with_long_notebooks):
    """Pictures and formulas are displayed, at full width on a phone, with legible labels.

    By default, nine pages of different kinds are tested; the slow test includes all theory.
    """
    pages = PAGES
    if with_long_notebooks:
        pages = (
            PAGES + MORE_PAGES + [f"theory/{file.stem}" for file in (DOCS / "theory").glob("*.md")]
        )
    offline = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"
    with chromium(offline) as driver, served(site) as (address, _):
        for page in pages:
            size = {"width": 390, "height": 900, "deviceScaleFactor": 1, "mobile": True}
            driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
            driver.get(f"{address}/{page}.html")
            failed = driver.execute_async_script(
                "const done = arguments[0];"
                "const begun = window.MathJax?.startup?.promise ?? Promise.resolve();"
                "begun.then(() => done(null), error => done(String(error)))"
            )
            assert failed is None, (page, failed)  # e.g. an extension that is not in the site
            found = driver.execute_script(CUT)
            assert found.pop("formulas") == found.pop("raw"), page
            assert found.pop("wider") == 0, page
            assert not any(found.values()), (page, found)

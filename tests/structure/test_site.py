# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation site builds without warnings, and shows what it should."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

import samcontact as sc

DOCS = Path(__file__).parents[2] / "docs"


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html"]
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
    for expected in ("TuggingSection", "image_tol", "self_affine", "&gt; 0.0", "back_and_forth"):
        assert expected in text
    assert re.search(r"<p>dx</p></td>\s*<td><p>m</p></td>", text)  # with its unit

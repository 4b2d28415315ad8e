# SPDX-License-Identifier: GPL-3.0-or-later
"""Recipes of docs/developer/recipes.md: their examples occur in exactly the files they list."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "developer" / "recipes.md").read_text(encoding="utf-8")
FOLDERS = ("python/samcontact", "cpp/include", "cpp/src", "cpp/bindings")
SOURCES = {
    str(file.relative_to(ROOT)): file.read_text(encoding="utf-8")
    for folder in FOLDERS
    for file in (ROOT / folder).rglob("*")
    if file.suffix in {".py", ".pyi", ".hpp", ".cpp"}
}


def recipes():
    """Return title, names of the example and listed files of each recipe with an example."""
    for section in re.split(r"^## ", PAGE, flags=re.MULTILINE)[1:]:
        if example := re.search(r"^Example: (.*)\.$", section, re.MULTILINE):
            names = re.findall(r"`(\w+)`", example[1])
            files = re.findall(r"^\| `([\w./]+)` \|", section, re.MULTILINE)
            yield pytest.param(names, files, id=section.splitlines()[0])


def python_words(text):
    """Return names and whole strings of a module, without comments and docstrings."""
    for node in ast.walk(ast.parse(text)):
        for field in ("id", "attr", "name", "arg", "asname"):
            if isinstance(word := getattr(node, field, None), str):
                yield word
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value


def words(name):
    """Return all words of a source file except comments."""
    text = SOURCES[name]
    if name.endswith((".py", ".pyi")):
        return set(python_words(text))
    return set(re.findall(r"\w+", re.sub(r"//.*", "", text)))


WORDS = {name: words(name) for name in SOURCES}


RECIPES = list(recipes())


@pytest.mark.parametrize(("names", "files"), RECIPES)
def test_the_example_of_a_recipe_occurs_in_its_files(names, files):
    found = {source for source, there in WORDS.items() if there & set(names)}
    stems = {source for source in SOURCES if Path(source).stem in names}
    assert found | stems == set(files)
    assert len(files) == len(set(files))
    for name in names:
        assert any(name in there for there in WORDS.values()), name


def test_words_are_those_of_code():
    module = 'from .a import B as b\n"""Tresca, told."""\nx = {"mu": b.C}  # D\ndef f(g): ...\n'
    assert {"B", "b", "mu", "C", "f", "g", "x"} <= set(python_words(module))
    assert not {"Tresca", "D", "told"} & set(python_words(module))


def test_every_table_of_files_has_an_example():
    assert len(RECIPES) == PAGE.count("| file | what to write |") >= 3

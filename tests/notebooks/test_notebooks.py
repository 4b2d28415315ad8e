# SPDX-License-Identifier: GPL-3.0-or-later
"""Notebooks run without a warning, show figures, and are stored without outputs.

slow_variants.toml lists the long ones, which only slow tests run.
"""

import inspect
import re
from pathlib import Path

import pytest

nbformat = pytest.importorskip("nbformat")
executed = pytest.importorskip("docs._ext.executed").executed

ROOT = Path(__file__).parents[2]
PATHS = sorted((ROOT / "notebooks").glob("*.ipynb"))
notebooks = pytest.mark.parametrize("path", PATHS, ids=lambda path: path.stem)


def read(path):
    return nbformat.read(path, as_version=4)


def text(notebook, kind):
    return "\n".join(cell.source for cell in notebook.cells if cell.cell_type == kind)


def test_there_are_notebooks():
    assert len(PATHS) >= 10


@notebooks
def test_form(path):
    notebook = read(path)
    nbformat.validate(notebook)
    first = notebook.cells[0]
    assert first.cell_type == "markdown"
    lines = first.source.splitlines()
    assert lines[0] == "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->"
    assert re.fullmatch(rf"# {int(path.stem[:2])}\. .+", lines[1])
    prose = text(notebook, "markdown")
    assert "**After this notebook you can**" in prose
    assert "\n## Try\n" in prose


@notebooks
def test_stored_without_outputs(path):
    for cell in read(path).cells:
        if cell.cell_type == "code":
            assert not cell.outputs
            assert cell.execution_count is None


@notebooks
def test_cells_have_named_ids(path):
    """Cell ids are names, not random, so that a change affects only the changed cell in git."""
    names = [cell.id for cell in read(path).cells]
    assert len(set(names)) == len(names)
    assert [name for name in names if not re.fullmatch(r"[a-z]+(-[a-z]+)*", name)] == []


@notebooks
def test_uses_the_public_interface_only(path):
    code = text(read(path), "code")
    imported = re.findall(r"^\s*(?:from|import) +(samcontact\S*)(.*)$", code, re.MULTILINE)
    assert imported
    used = [" ".join(names) for names in imported] + re.findall(r"[\w)\]]\.(_\w+)", code)
    assert [name for name in used if re.search(r"(?<!\w)_\w", name)] == []


@notebooks
def test_names_of_the_package_exist(path):
    """A quick check of notebooks that only slow tests run."""
    code = text(read(path), "code")
    space = {}
    for line in re.findall(r"^(?:import samcontact.*|from samcontact.*)$", code, re.MULTILINE):
        exec(line, space)
    modules = {name for name, value in space.items() if getattr(value, "__spec__", None)}
    used = set(re.findall(rf"(?<![\w.])(?:{'|'.join(modules)})(?:\.\w+)+", code))
    assert len(used) > 4
    for chain in used:
        first, *parts = chain.split(".")
        thing = space[first]
        for part in parts:
            thing = getattr(thing, part)
            if not inspect.ismodule(thing):
                break


@notebooks
def test_link_targets_exist(path):
    for target in re.findall(r"\]\(([^)\s]+)\)", text(read(path), "markdown")):
        assert target.startswith("https://") or (path.parent / target).exists(), target


@notebooks
def test_runs_and_shows_figures(path):
    """Warnings are errors. The site shows the outputs of this run."""
    run = executed(read(path))
    outputs = [o for cell in run.cells for o in cell.get("outputs", ())]
    assert sum("image/png" in o.get("data", {}) for o in outputs) >= 3
    assert [o.text for o in outputs if o.output_type == "stream" and o.name == "stderr"] == []
    assert run.metadata.files == []

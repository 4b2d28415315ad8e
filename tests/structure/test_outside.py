# SPDX-License-Identifier: GPL-3.0-or-later
"""Gallery and benchmarks are outside the package: public names only, no duplicated files."""

import ast
import graphlib
import hashlib
import importlib
import subprocess
import sys
from pathlib import Path

import pytest

import samcontact as sc

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
SCRIPTS = sorted(file for name in ("gallery", "benchmarks") for file in (ROOT / name).rglob("*.py"))


def private(text):
    """Return the private names of the package used in these lines."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            taken = [(alias.name, None) for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            taken = [(node.module, alias.name) for alias in node.names]
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            offered = node.value.id != "sc" or node.attr in sc.__all__
            taken = [("", node.attr)] if not offered else []
        else:
            continue
        for module, name in taken:
            if module.split(".")[0] not in ("samcontact", ""):
                continue
            known = getattr(importlib.import_module(module), "__all__", ()) if module else ()
            if "._" in module or (name is not None and name not in known):
                yield f"{module}.{name}"


@pytest.mark.parametrize(
    "line",
    ["from samcontact._util.tensors import von_mises", "import samcontact._core", "sc._core.grid()",
     "from samcontact import _checks", "from samcontact.plotting.wear import _panel"],
)  # fmt: skip
def test_private_names_are_found(line):
    assert len(list(private(line))) == 1


def test_scripts_use_public_names():
    assert len(SCRIPTS) > 30
    found = {file: list(private(file.read_text(encoding="utf-8"))) for file in SCRIPTS}
    assert {file: names for file, names in found.items() if names} == {}


def taken(file):
    """Return the neighbouring modules that a script imports anywhere in the file."""
    package = [*file.relative_to(ROOT).parts[:-1]]
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            module = [*above, *(node.module or "").split(".")]
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.Import):
            module, names = [], [alias.name for alias in node.names]
        else:
            continue
        for name in names:
            path = ROOT.joinpath(*filter(None, module), *name.split("."))
            for found in (
                path.with_suffix(".py"),
                path.parent.with_suffix(".py"),
                path / "__init__.py",
            ):
                if found in SCRIPTS:
                    yield found
                    break


def test_scripts_have_no_import_cycle():
    graph = {file: set(taken(file)) for file in SCRIPTS}
    order = [*graphlib.TopologicalSorter(graph).static_order()]
    assert order.index(ROOT / "benchmarks" / "study.py") < order.index(
        ROOT / "benchmarks" / "experiments" / "page.py"
    )
    page, start = (ROOT / "benchmarks" / "scale" / f"{name}.py" for name in ("page", "__main__"))
    with pytest.raises(graphlib.CycleError):
        graphlib.TopologicalSorter(graph | {page: graph[page] | {start}}).prepare()


def test_the_wheel_contains_the_package_alone():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert project["tool"]["scikit-build"]["wheel"]["packages"] == ["python/samcontact"]
    assert [f for f in (ROOT / "python").rglob("*") if f.suffix in (".csv", ".json", ".npz")] == []


def test_no_file_is_duplicated():
    command = ["git", "-C", str(ROOT), "ls-files"]
    names = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\n")
    found = {}
    for file in (ROOT / name for name in names if name):
        if file.is_file() and file.stat().st_size > 0:
            found.setdefault(hashlib.sha256(file.read_bytes()).digest(), []).append(file)
    assert len(found) > 500
    assert [files for files in found.values() if len(files) > 1] == []

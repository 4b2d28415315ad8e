# SPDX-License-Identifier: GPL-3.0-or-later
"""What reproduces and measures stands outside the package: public names, data that exist once."""

import ast
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
    """Names that these lines take from the package, and that it does not offer."""
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


def test_the_wheel_holds_the_package_alone():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert project["tool"]["scikit-build"]["wheel"]["packages"] == ["python/samcontact"]
    assert [f for f in (ROOT / "python").rglob("*") if f.suffix in (".csv", ".json", ".npz")] == []


def test_no_file_is_there_twice():
    command = ["git", "-C", str(ROOT), "ls-files"]
    names = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\n")
    found = {}
    for file in (ROOT / name for name in names if name):
        if file.is_file() and file.stat().st_size > 0:
            found.setdefault(hashlib.sha256(file.read_bytes()).digest(), []).append(file)
    assert len(found) > 500
    assert [files for files in found.values() if len(files) > 1] == []

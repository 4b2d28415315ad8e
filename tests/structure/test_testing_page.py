# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/testing.md names all kinds of tested runs and their folders."""

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "testing.md").read_text(encoding="utf-8")


def constants(path):
    spec = importlib.util.spec_from_file_location(Path(path).stem, ROOT / path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("folder", ["fuzz", "faults"])
def test_every_kind_of_run_is_tested_and_on_the_page(folder):
    path = {"fuzz": "tests/fuzz/fuzzing.py", "faults": "tests/faults/faulting.py"}[folder]
    module = constants(path)
    counted = getattr(module, "INPUTS" if folder == "fuzz" else "TRIALS")
    tests = "\n".join(file.read_text() for file in (ROOT / "tests" / folder).glob("test_*.py"))
    assert [name for name in counted if f'"{name}"' not in tests] == []
    section = PAGE.partition(f"## {folder.capitalize()}\n")[2].partition("\n## ")[0]
    assert re.findall(r"^\| ([^|]+) \| ", section, re.MULTILINE)[1:] == list(counted)


def test_memory_bounds_on_the_page_are_those_of_the_tests():
    tried = (ROOT / "tests" / "faults" / "test_out_of_memory.py").read_text()
    low, high = re.search(r"between ([\d.]+) and ([\d.]+) times the peak", PAGE).groups()
    assert f"{low} < r < {high}" in tried


def test_every_family_has_its_folder():
    folders = set(re.findall(r"`(tests/\w+)`", PAGE))
    there = {f"tests/{path.name}" for path in (ROOT / "tests").iterdir() if path.is_dir()}
    assert folders <= there
    assert {"tests/fuzz", "tests/faults", "tests/unit", "tests/property"} <= folders

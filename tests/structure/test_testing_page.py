# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/testing.md: its counts are those of the tests, all of them."""

import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "testing.md").read_text(encoding="utf-8")


def constants(path):
    spec = importlib.util.spec_from_file_location(Path(path).stem, ROOT / path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("heading", "path", "name"),
    [("Fuzz", "tests/fuzz/fuzzing.py", "INPUTS"), ("Faults", "tests/faults/faulting.py", "TRIALS")],
)
def test_counts(heading, path, name):
    section = PAGE.partition(f"## {heading}\n")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| ([^|]+) \| (\d+) \| (\d+) \|", section, re.MULTILINE)
    told = {what: (int(few), int(many)) for what, few, many in rows}
    assert told == getattr(constants(path), name)


@pytest.mark.parametrize("folder", ["fuzz", "faults"])
def test_every_count_is_used(folder):
    path = {"fuzz": "tests/fuzz/fuzzing.py", "faults": "tests/faults/faulting.py"}[folder]
    module = constants(path)
    counted = getattr(module, "INPUTS" if folder == "fuzz" else "TRIALS")
    tests = "\n".join(file.read_text() for file in (ROOT / "tests" / folder).glob("test_*.py"))
    assert [name for name in counted if f'"{name}"' not in tests] == []


def test_numbers_of_tests():
    """As pytest and doctest count them."""
    rows = re.findall(r"^\| \w+ \| `([\w/]+)` \| (\d+) \|", PAGE, re.MULTILINE)
    told = {folder: int(count) for folder, count in rows}
    cases = sum(
        len(re.findall(r"^TEST_CASE", file.read_text(), re.MULTILINE))
        for file in (ROOT / "cpp" / "tests").glob("*.cpp")
    )
    assert told.pop("cpp/tests") == cases
    command = [sys.executable, "-m", "pytest", "-q", "--collect-only", "-m", "", *told]
    found = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    counted = {
        folder: len(re.findall(rf"^{folder}/.+::", found.stdout, re.MULTILINE)) for folder in told
    }
    assert told == counted


def test_every_family_has_its_folder():
    folders = set(re.findall(r"`(tests/\w+)`", PAGE))
    there = {f"tests/{path.name}" for path in (ROOT / "tests").iterdir() if path.is_dir()}
    assert folders <= there
    assert {"tests/fuzz", "tests/faults", "tests/unit", "tests/property"} <= folders

# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders of unit tests have the names of the tested rooms."""

from pathlib import Path

ROOT = Path(__file__).parents[2]
UNIT = ROOT / "tests" / "unit"
OUTSIDE = {"benchmarks", "gallery", "reference"}
"""Folders next to the package."""


def rooms():
    package = (ROOT / "python" / "samcontact").iterdir()
    core = (ROOT / "cpp" / "src").iterdir()
    return {path.stem for path in (*package, *core)} | OUTSIDE


def test_each_folder_of_unit_tests_is_named_after_a_room():
    folders = [path for path in UNIT.iterdir() if path.name != "__pycache__"]
    assert [path.name for path in folders if not path.is_dir()] == []
    assert {path.name for path in folders} - rooms() == set()
    assert [path.name for path in folders if not list(path.glob("test_*.py"))] == []

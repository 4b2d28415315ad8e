# SPDX-License-Identifier: GPL-3.0-or-later
"""Stubs of the compiled module agree with its signatures."""

import importlib.util
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_the_stubs_are_generated_from_the_module():
    spec = importlib.util.spec_from_file_location("stubs", ROOT / "scripts" / "stubs.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    kept = {file.name: file.read_text(encoding="utf-8") for file in script.FOLDER.iterdir()}
    assert script.generated() == kept, "build the module, then run: python scripts/stubs.py"
    assert "def pressure(self)" in kept["__init__.pyi"]

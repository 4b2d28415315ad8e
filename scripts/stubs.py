#!/usr/bin/env python
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the stubs of the compiled module, python/samcontact/_core, from its signatures.

    python scripts/stubs.py

Run this after a change of the bindings and a build of the module.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "python" / "samcontact" / "_core"
HEAD = "# SPDX-License-Identifier: GPL-3.0-or-later\n# Written by: python scripts/stubs.py\n"


def plain(text: str) -> str:
    """Return stubs with plain types instead of all convertible types, and no attribute values.

    Each version of pybind11 has its own union of what it converts to a number. mypy refuses a
    class whose __hash__ is None.
    """
    supported = r"typing\.Supports(Float|Int)( \| typing\.SupportsIndex)?"
    text = re.sub(supported, lambda found: found[1].lower(), text)
    array = r"typing\.Annotated\[numpy\.typing\.ArrayLike, (numpy\.\w+)\]"
    text = re.sub(array, r"numpy.typing.NDArray[\1]", text)
    text = re.sub(r"^ *__hash__: .*\n", "", text, flags=re.MULTILINE)
    attribute = r"^( *\w+): (?:typing\.ClassVar\[)?(\w+)\]? = .*"
    return re.sub(attribute, r"\1: \2", text, flags=re.MULTILINE)


def generated() -> dict[str, str]:
    """Return names and texts of the stubs, one for each module of the core."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["pybind11_stubgen", "samcontact._core", "--exit-code", "-o", folder]
        subprocess.run([sys.executable, "-m", *command], check=True)
        place = Path(folder, "samcontact", "_core")
        for file in place.iterdir():
            text = plain(file.read_text(encoding="utf-8"))
            file.write_text(HEAD + text, encoding="utf-8")
        ruff = [sys.executable, "-m", "ruff", "--config", str(ROOT / "pyproject.toml")]
        subprocess.run([*ruff, "check", "--quiet", "--fix-only", place], check=True)
        subprocess.run([*ruff, "format", "--quiet", place], check=True)
        return {file.name: file.read_text(encoding="utf-8") for file in place.iterdir()}


def main() -> None:
    for name, text in generated().items():
        (FOLDER / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

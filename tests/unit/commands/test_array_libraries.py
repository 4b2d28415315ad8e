# SPDX-License-Identifier: GPL-3.0-or-later
"""Libraries that commands do not load."""

import subprocess
import sys
from importlib.util import find_spec

from benchmarks.small_contacts import CASE
from samcontact.commands import array_libraries


def test_libraries_are_absent_until_they_are_needed(monkeypatch):
    for name in ("dask", "sparse"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    monkeypatch.setitem(sys.modules, "pint", sys)  # loaded already
    monkeypatch.delitem(sys.modules, "cupy", raising=False)
    array_libraries.hide()
    assert find_spec("dask") is None
    assert sys.modules["pint"] is sys
    array_libraries.show()
    assert find_spec("dask") is not None
    assert sys.modules["pint"] is sys


def test_units_are_converted_in_a_process_of_a_command():
    code = (
        "from samcontact.commands import array_libraries; array_libraries.hide()\n"
        "import samcontact; print(samcontact.units.si('7.5 mm', 'm'))"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "0.0075"


def test_a_run_loads_only_what_it_uses(tmp_path):
    """Loading takes most of the time of a small case."""
    code = """if True:
        import sys
        sys.argv = ["samcontact", "run", "small.toml", "--no-figures", "--quiet"]
        from samcontact.__main__ import start
        try:
            start()
        except SystemExit as end:
            assert not end.code
        unused = {"scipy", "dask", "pint", "matplotlib", "samcontact.lubrication",
                  "samcontact.cases.films", "samcontact.cases.sliding", "samcontact.plotting",
                  "samcontact.cases.asperities", "rich.spinner"}
        print(sorted(name for name in unused if sys.modules.get(name)))"""
    (tmp_path / "small.toml").write_text(CASE, encoding="utf-8")
    found = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert found.stdout.splitlines()[-1] == "[]"

# SPDX-License-Identifier: GPL-3.0-or-later
"""Wheels of `scripts/wheels.py`, made from the installed package without compilation."""

import importlib.util
import os
import re
import subprocess
import sys
import zipfile
from importlib import metadata
from pathlib import Path

import pytest

import samcontact

ROOT = Path(__file__).parents[2]
PLACE = Path(samcontact.__file__).parents[1]
DISTRIBUTION = next(metadata.distributions(name="samcontact", path=[str(PLACE)]), None)
if DISTRIBUTION is None:
    pytest.skip(f"samcontact is imported from {PLACE}, not installed", allow_module_level=True)


@pytest.fixture(scope="module")
def wheels():
    """Return the script as a module."""
    spec = importlib.util.spec_from_file_location("wheels", ROOT / "scripts" / "wheels.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def wheel(wheels, tmp_path_factory):
    """Pack the installed files into a wheel that includes their libraries."""
    wheels.require_tools([sys.executable])
    folder = tmp_path_factory.mktemp("wheel")
    tag = re.search(r"^Tag: (\S+)$", DISTRIBUTION.read_text("WHEEL"), re.MULTILINE)[1]
    raw = folder / f"samcontact-{DISTRIBUTION.version}-{tag}.whl"
    with zipfile.ZipFile(raw, "w") as file:
        for path in DISTRIBUTION.files:
            if path.parts[0].startswith("samcontact") and path.name != "RECORD":  # no commands
                file.write(path.locate(), str(path))
        lines = DISTRIBUTION.read_text("RECORD").splitlines(keepends=True)
        record = "".join(line for line in lines if line.startswith("samcontact"))
        file.writestr(f"samcontact-{DISTRIBUTION.version}.dist-info/RECORD", record)
    return wheels.repaired(raw, folder / "repaired")


def test_the_wheel_contains_its_libraries_and_has_the_right_tag(wheel):
    names = zipfile.ZipFile(wheel).namelist()
    held = [name.removeprefix("samcontact.libs/") for name in names if "samcontact.libs/" in name]
    assert {name.partition("-")[0] for name in held} >= {"libfftw3", "libgomp"}
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    assert re.search(rf"-{python}-{python}-manylinux_\d+_\d+_\w+\.whl$", wheel.name)


def test_the_wheel_computes_with_its_own_libraries(wheels, wheel, tmp_path):
    with zipfile.ZipFile(wheel) as file:
        file.extractall(tmp_path)
    folder = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    settings = {
        "cwd": tmp_path,
        "env": {**os.environ, "PYTHONPATH": str(tmp_path), "PATH": folder},
    }
    found = wheels.call(sys.executable, "-c", wheels.MAPPED, **settings).split()
    assert len(found) >= 2
    assert all(Path(name).is_relative_to(tmp_path / "samcontact.libs") for name in found)
    command = wheels.PROJECT["tool"]["cibuildwheel"]["test-command"]
    assert samcontact.__version__ in wheels.call("/bin/sh", "-c", command, **settings)


def test_quick_tests_of_wheels_are_those_of_test_quick(wheels):
    chosen = wheels.quick_tests()
    left_out = [word.partition("=")[2] for word in chosen if word.startswith("--ignore-glob=")]
    assert len(left_out) > 10
    for pattern in left_out:
        assert list(ROOT.glob(f"{pattern}.py") if not pattern.endswith("*") else ROOT.glob(pattern))
    script = (ROOT / "test").read_text()
    assert 'quick) lint && python_tests -q tests/unit "${LONG[@]' in script


def test_missing_tools_are_named_before_compilation(wheels):
    with pytest.raises(SystemExit, match="missing: no-such-python"):
        wheels.require_tools(["no-such-python"])
    command = [sys.executable, str(ROOT / "scripts" / "wheels.py"), "no-such-python"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1
    assert "no-such-python" in done.stderr

# SPDX-License-Identifier: GPL-3.0-or-later
"""Contents of the tested installation, and its requirements."""

import re
import subprocess
import sys
import sysconfig
from importlib import metadata
from pathlib import Path

import pytest

import samcontact

ROOT = Path(__file__).parents[2]
# Another package may be installed while this one is imported from a source folder.
PLACE = Path(samcontact.__file__).parents[1]
DISTRIBUTION = next(metadata.distributions(name="samcontact", path=[str(PLACE)]), None)
if DISTRIBUTION is None:
    pytest.skip(f"samcontact is imported from {PLACE}, not installed", allow_module_level=True)
FILES = {str(path) for path in DISTRIBUTION.files or ()}
(CORE,) = (path for path in DISTRIBUTION.files or () if path.match("samcontact/_core*.so"))
# Distributed wheels include FFTW and OpenMP (scripts/wheels.py); other libraries are the system's.
LIBRARIES = {"fftw3", "gomp", "omp", "stdc++", "gcc_s", "m", "c", "pthread"}


def test_the_installation_contains_only_the_package():
    listing = ["--cached", "--others", "--exclude-standard", "python/samcontact"]
    command = ["git", "-C", str(ROOT), "ls-files", *listing]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    wanted = {name.removeprefix("python/") for name in listed} | {str(CORE)}
    packaged = {name for name in FILES if not re.search(r"\.dist-info/|\.pyc$|bin/", name)}
    assert packaged == wanted
    assert {"samcontact/py.typed", "samcontact/_core/__init__.pyi"} < packaged
    assert any(name.endswith("dist-info/licenses/LICENSE") for name in FILES)


def test_the_wheel_tag_matches_python_and_platform():
    tag = re.search(r"^Tag: (\S+)$", DISTRIBUTION.read_text("WHEEL"), re.MULTILINE)[1]
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"\W", "_", sysconfig.get_platform())
    assert tag == f"{version}-{version}-{platform}"


def test_the_core_links_known_libraries_without_local_paths():
    core = Path(CORE.locate())
    head = subprocess.run(["readelf", "-d", core], capture_output=True, text=True, check=True)
    needed = set(re.findall(r"\(NEEDED\).*\[lib([\w+]+)\.so", head.stdout))
    assert {"fftw3", "c"} < needed <= LIBRARIES
    assert re.findall(r"\((?:RPATH|RUNPATH)\).*", head.stdout) == []
    assert re.findall(rb"/(?:home|root|tmp|work|build)/[\w./-]*", core.read_bytes()) == []
    assert str(ROOT).encode() not in core.read_bytes()

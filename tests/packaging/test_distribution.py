# SPDX-License-Identifier: GPL-3.0-or-later
"""Distribution: the source distribution builds, and recipes agree with pyproject.toml."""

import re
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())


def test_the_conda_recipe_has_the_version_and_dependencies_of_the_project():
    recipe = (ROOT / "packaging" / "conda" / "meta.yaml").read_text()
    assert f'version = "{PROJECT["project"]["version"]}"' in recipe
    run = recipe.partition("  run:\n")[2].partition("\ntest:")[0]
    found = dict(re.findall(r"- ([\w-]+) >=([\d.]+)", run))
    found["matplotlib"] = found.pop("matplotlib-base")
    assert found.pop("python") == PROJECT["project"]["requires-python"].removeprefix(">=")
    expected = {}
    for requirement in PROJECT["project"]["dependencies"]:
        name, version = re.match(r"([\w-]+)>=([\d.]+)", requirement).groups()
        expected[name] = version
    assert found == expected


def test_the_conda_recipe_builds_with_the_tools_of_the_project():
    recipe = (ROOT / "packaging" / "conda" / "meta.yaml").read_text()
    parts = dict(re.findall(r"^  (\w+):\n((?:    .*\n)+)", recipe, re.MULTILINE))
    requires = PROJECT["build-system"]["requires"]
    host = re.findall(r"- (.+)", parts["host"])
    assert {name.replace(">=", " >=") for name in requires} < set(host)
    assert {"python", "pip", "eigen", "fftw"} < set(host)
    cmake = re.search(
        r"cmake_minimum_required\(VERSION (.+)\)", (ROOT / "CMakeLists.txt").read_text()
    )
    assert f"cmake >={cmake[1]}" in re.findall(r"- (.+)", parts["build"])
    assert "samcontact doctor" in re.findall(r"- (.+)", parts["commands"])


def test_wheels_are_for_the_supported_versions():
    builds = PROJECT["tool"]["cibuildwheel"]["build"].split()
    lowest = PROJECT["project"]["requires-python"].removeprefix(">=").replace(".", "")
    assert builds[0] == f"cp{lowest}-*"
    named = [name.rpartition(" :: ")[2] for name in PROJECT["project"]["classifiers"]]
    versions = [name for name in named if re.fullmatch(r"3\.\d+", name)]
    assert builds == [f"cp{version.replace('.', '')}-*" for version in versions]
    page = " ".join((ROOT / "docs" / "install.md").read_text().split())
    assert f"Python {versions[0]} to {versions[-1]}" in page


@pytest.mark.slow
def test_the_source_distribution_builds_and_works(tmp_path):
    def call(*command):
        subprocess.run([str(part) for part in command], check=True, cwd=tmp_path)

    call(sys.executable, "-m", "build", "--sdist", "--outdir", tmp_path, ROOT)
    (archive,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(archive) as files:
        names = files.getnames()
    assert any(name.endswith("cpp/src/simulation/simulation.cpp") for name in names)
    assert not any(name.endswith((".so", ".pyc")) for name in names)
    call(sys.executable, "-m", "venv", tmp_path / "venv")
    python = tmp_path / "venv" / "bin" / "python"
    call(python, "-m", "pip", "install", "--quiet", archive)
    call(python, "-m", "samcontact", "--version")
    call(python, "-c", "import samcontact as sc; sc.critical.green(0.5, 1e11, 0.3, 1e9)")

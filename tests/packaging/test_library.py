# SPDX-License-Identifier: GPL-3.0-or-later
"""The C++ library installed without Python, and a separate program that uses it."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
EXAMPLE = ROOT / "cpp" / "examples" / "hertz"
# Kept between runs; compiled as by `cmake --preset core`, so that ccache finds the objects.
BUILD = ROOT / "build" / "library"
CORE = {
    "SAMCONTACT_PYTHON": "OFF",
    "SAMCONTACT_WERROR": "ON",
    "CMAKE_DISABLE_PRECOMPILE_HEADERS": "ON",
}


def call(*command):
    """Return the output of a command; if it fails, the test fails with its output."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def configure(source, build, **cache):
    settings = [f"-D{name}={value}" for name, value in cache.items()]
    call("cmake", "-S", source, "-B", build, "-G", "Ninja", *settings)


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    """Install the library; return its folder."""
    folder = tmp_path_factory.mktemp("prefix")
    configure(ROOT, BUILD, CMAKE_INSTALL_LIBDIR="lib", **CORE)
    call("cmake", "--build", BUILD, "--target", "samcontact")
    call("cmake", "--install", BUILD, "--prefix", folder)
    return folder


def test_library_headers_and_cmake_package_are_installed(prefix):
    found = {str(file.relative_to(prefix)) for file in prefix.rglob("*") if file.is_file()}
    headers = {
        str(file.relative_to(ROOT / "cpp")) for file in (ROOT / "cpp" / "include").rglob("*.hpp")
    }
    package = {
        "FindFFTW3.cmake",
        "samcontactConfig.cmake",
        "samcontactConfigVersion.cmake",
        "samcontactTargets.cmake",
        "samcontactTargets-release.cmake",
    }
    assert found == headers | {"lib/libsamcontact.a"} | {
        f"lib/cmake/samcontact/{n}" for n in package
    }


def test_the_cmake_package_contains_no_build_path(prefix):
    for file in (prefix / "lib" / "cmake").rglob("*.cmake"):
        assert str(ROOT) not in file.read_text(), file


def test_the_example_program_finds_the_library_and_agrees_with_hertz(prefix, tmp_path):
    configure(EXAMPLE, tmp_path, CMAKE_PREFIX_PATH=prefix)
    call("cmake", "--build", tmp_path)
    assert f"samcontact_DIR:PATH={prefix}" in (tmp_path / "CMakeCache.txt").read_text()
    rows = re.findall(r"(\S+) (?:m|Pa), Hertz (\S+)", call(tmp_path / "hertz"))
    errors = [abs(float(found) / float(exact) - 1) for found, exact in rows]
    assert len(errors) == 3
    assert max(errors) < 0.01


def test_the_library_version_is_the_project_version(prefix, tmp_path):
    wanted = {VERSION: "1", "0.99": "0", "1.0": "0"}
    lines = ["cmake_minimum_required(VERSION 3.22)", "project(user LANGUAGES CXX)"]
    for version in wanted:
        lines += [
            "unset(samcontact_DIR CACHE)",
            f"find_package(samcontact {version} QUIET)",
            f"message(STATUS {version}=${{samcontact_FOUND}})",
        ]
    (tmp_path / "CMakeLists.txt").write_text("\n".join(lines))
    said = call("cmake", "-S", tmp_path, "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}")
    assert dict(re.findall(r"^-- ([\d.]+)=(\d)$", said, re.MULTILINE)) == wanted

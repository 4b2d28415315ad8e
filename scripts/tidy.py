#!/usr/bin/env python
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run clang-tidy on core, bindings and C++ tests; unchanged files that have passed are skipped.

    python scripts/tidy.py [--paths] [--since REVISION] [PATTERN ...]      e.g. src/contact

All files by default.

--paths: run only the path-sensitive checks of clang-analyzer; this takes two to three times longer.
--since: check only files that differ from this revision, and files that include one; check all if
the checks or the build differ, or if the revision does not exist.

A file counts as passed while its included sources, the checks and clang-tidy are unchanged, in any
checkout; ~/.cache/samcontact-tidy contains a mark for each file that has passed.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build" / "tidy"
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
PASSED = CACHE / "samcontact-tidy"
# Quadrature loops count by floating-point widths, because their panels grow.
PATHS = "-*,clang-analyzer-*,-clang-analyzer-security.FloatLoopCounter"


def output(*command: str) -> str:
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout


@cache
def digest(file: str) -> bytes:
    return hashlib.sha256(Path(file).read_bytes()).digest()


def fingerprint(entry: dict[str, str], checker: str) -> str:
    """Digest of everything that determines the findings of clang-tidy in a file."""
    words = shlex.split(entry["command"])
    del words[words.index("-o") : words.index("-o") + 2]
    words.remove("-c")
    rule = output(*words, "-M").replace("\\\n", " ")
    files = shlex.split(rule.partition(":")[2])
    above = Path(entry["file"]).relative_to(ROOT).parents
    files += [str(ROOT / folder / ".clang-tidy") for folder in above]
    anywhere = entry["command"].replace(str(ROOT), "")
    found = hashlib.sha256(f"{checker} {anywhere}".encode())
    for file in files:
        if (path := BUILD / file).exists():
            found.update(path.name.encode() + digest(str(path)))
    return found.hexdigest()


def check(entry: dict[str, str], checker: str, options: list[str]) -> tuple[str, str] | None:
    """Run clang-tidy on a file; return its name and findings, or None if nothing has changed."""
    mark = PASSED / fingerprint(entry, " ".join([checker, *options]))
    if mark.exists():
        return None
    command = ["clang-tidy", "-quiet", f"-p={BUILD}", *options, entry["file"]]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if done.returncode == 0:
        mark.touch()
        return entry["file"], ""
    return entry["file"], done.stdout + done.stderr


def with_includes(file: Path) -> set[Path]:
    """Return the file and all files of the project that it includes, directly or indirectly."""
    found, left = set(), [file]
    while left:
        file = left.pop()
        if file not in found:
            found.add(file)
            left += included(file)
    return found


@cache
def included(file: Path) -> list[Path]:
    names = re.findall(r'^#include "(.+)"', file.read_text(encoding="utf-8"), re.MULTILINE)
    places = (folder / name for name in names for folder in (file.parent, ROOT / "cpp" / "include"))
    return [place.resolve() for place in places if place.exists()]


def differing(revision: str) -> set[Path] | None:
    """Return the files that differ from a revision, or None if all files must be checked."""
    try:
        names = output("git", "diff", "--name-only", revision, "--").splitlines()
        names += output("git", "ls-files", "--others", "--exclude-standard").splitlines()
    except (FileNotFoundError, subprocess.CalledProcessError):
        return None
    build = re.compile(r"(.*/)?\.clang-tidy|CMake\w+\.\w+|cmake/.*|scripts/tidy\.py")
    return None if any(build.fullmatch(name) for name in names) else {ROOT / n for n in names}


def main(patterns: list[str], paths: bool, since: str | None) -> int:
    bindings = output(sys.executable, "-m", "pybind11", "--cmakedir").strip()
    output("cmake", "--preset", "tidy", f"-DPython_EXECUTABLE={sys.executable}",
           f"-Dpybind11_DIR={bindings}")  # fmt: skip
    PASSED.mkdir(parents=True, exist_ok=True)
    # The package clang-tidy lacks the headers of OpenMP, which belong to clang++;
    # their folder is searched last, so that it provides nothing else.
    headers = f"{output('clang++', '-print-resource-dir').strip()}/include"
    # The standard library uses features that it has itself deprecated.
    options = [f"-extra-arg=-idirafter{headers}", "-extra-arg=-Wno-deprecated-declarations"]
    if paths:
        options.append(f"-checks={PATHS}")
    checker = output("clang-tidy", "--version")
    entries = [
        entry
        for entry in json.loads((BUILD / "compile_commands.json").read_text())
        if not patterns or any(re.search(pattern, entry["file"]) for pattern in patterns)
    ]
    if since and (changed := differing(since)) is not None:
        entries = [entry for entry in entries if with_includes(Path(entry["file"])) & changed]
    # the longest files first, so that none of them runs alone at the end
    entries.sort(key=lambda entry: (
        "/bindings/" not in entry["file"], -Path(entry["file"]).stat().st_size))  # fmt: skip
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda entry: check(entry, checker, options), entries))
    said = [result for result in results if result is not None]
    failed = [text for _, text in said if text]
    print(*failed, sep="\n", end="")
    print(f"clang-tidy: {len(said)} of {len(entries)} files are new or changed, {len(failed)} fail")
    return 1 if failed else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--paths", action="store_true", help="paths of clang-analyzer alone")
    parser.add_argument("--since", metavar="REVISION", help="what differs from it")
    parser.add_argument("patterns", nargs="*", metavar="PATTERN", help="part of a file's path")
    asked = parser.parse_args()
    sys.exit(main(asked.patterns, asked.paths, asked.since))

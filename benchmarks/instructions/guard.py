# SPDX-License-Identifier: GPL-3.0-or-later
"""Check that no hot kernel needs more instructions than in the previous commit.

    python benchmarks/instructions/guard.py [--base REVISION]

The script builds driver.cpp for the working tree and for the base (HEAD~1), each with the sources
of that version, and counts the instructions of each kernel under valgrind, on one thread. Unlike
times, the counts are the same on a busy machine. An intended change is announced in the commit
message, one line each:

    Instructions: layer_sweep +12 % because ...
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DRIVER = "benchmarks/instructions/driver.cpp"
WHAT_COUNTS = ("cpp/include", "cpp/src", "cmake", "CMakeLists.txt", "benchmarks/instructions")
VALGRIND = ("valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null")
TOLERANCE = 0.05  # relative growth that passes unannounced
ALLOWANCE = re.compile(
    r"^Instructions:\s+(\w+)\s+\+(\d+(?:\.\d+)?)\s*%\s+because\s+\S.*$", re.MULTILINE
)


class Skip(Exception):
    """Exception if no comparison is possible."""


def allowances(messages: str) -> dict[str, float]:
    """Return the relative growth announced in commit messages, by kernel."""
    found: dict[str, float] = {}
    for kernel, percent in ALLOWANCE.findall(messages):
        found[kernel] = max(found.get(kernel, 0.0), float(percent) / 100)
    return found


def compare(
    before: dict[str, int], after: dict[str, int], allowed: dict[str, float]
) -> tuple[list[tuple[str, str, str, str, str]], list[str]]:
    """Return rows (kernel, before, after, change, result) and the kernels above their allowance."""
    rows, failed = [], []
    for kernel in sorted(before.keys() | after.keys()):
        old, new = before.get(kernel), after.get(kernel)
        change, status = "", "new" if old is None else "gone"
        if old is not None and new is not None:
            growth = (new - old) / old
            limit = max(TOLERANCE, allowed.get(kernel, 0.0))
            change = f"{100 * growth:+.2f} %"
            status = "ok" if growth <= TOLERANCE else "announced"
            if growth > limit:
                status = f"more than +{100 * limit:g} %"
                failed.append(kernel)
        rows.append((kernel, *("" if n is None else f"{n:,}" for n in (old, new)), change, status))
    return rows, failed


def table(rows: list[tuple[str, str, str, str, str]]) -> str:
    """Return the rows as text with right-aligned numbers."""
    lines = [("kernel", "before", "after", "change", ""), *rows]
    widths = [max(len(line[c]) for line in lines) for c in range(5)]
    return "\n".join(
        "  ".join(
            cell.rjust(width) if 0 < c < 4 else cell.ljust(width)
            for c, (cell, width) in enumerate(zip(line, widths, strict=True))
        ).rstrip()
        for line in lines
    )


def git(*arguments: str) -> str:
    """Return the output of git; raise Skip if it fails."""
    try:
        done = subprocess.run(
            ["git", "-C", str(ROOT), *arguments], capture_output=True, text=True, check=True
        )
    except FileNotFoundError:
        raise Skip("git is not installed") from None
    except subprocess.CalledProcessError as error:
        raise Skip(f"git {' '.join(arguments)}: {error.stderr.strip()}") from error
    return done.stdout.strip()


def find_base(revision: str) -> str:
    """Return the commit to compare with; raise Skip if there is none or no source has changed."""
    if Path(git("rev-parse", "--show-toplevel")).resolve() != ROOT:
        raise Skip("this folder is not a git repository of its own")
    try:
        base = git("rev-parse", "--verify", "--quiet", f"{revision}^{{commit}}")
    except Skip:
        shallow = git("rev-parse", "--is-shallow-repository") == "true"
        reason = "the history is shallow" if shallow else "there is no such commit"
        raise Skip(f"{revision} cannot be read: {reason}") from None
    if not git("ls-tree", base, DRIVER):
        raise Skip(f"{revision} has no {DRIVER}")
    changed = git("diff", "--name-only", base, "--", *WHAT_COUNTS)
    new = git("ls-files", "--others", "--exclude-standard", "--", *WHAT_COUNTS)
    if not changed and not new:
        raise Skip(f"nothing that is counted differs from {revision}")
    return base


class BuildError(Exception):
    """Error for a failed build; the message is the output of the build."""


def build(source: Path) -> Path:
    """Build the driver of a source tree; returns the program.

    Flags and folder depth are as in the package build, so that ccache finds the objects.
    """
    folder = source / "build" / "instructions"
    options = [
        "-DCMAKE_BUILD_TYPE=Release",
        "-DSAMCONTACT_PYTHON=OFF",
        "-DSAMCONTACT_WERROR=ON",
        "-DSAMCONTACT_BENCHMARKS=ON",
    ]
    environment = {**os.environ, "CCACHE_BASEDIR": str(source)}
    if shutil.which("ninja"):
        options += ["-G", "Ninja"]
    target = "samcontact_instructions"
    jobs = str(os.cpu_count() or 1)
    for command in (
        ["cmake", "-S", str(source), "-B", str(folder), *options],
        ["cmake", "--build", str(folder), "--target", target, "--parallel", jobs],
    ):
        done = subprocess.run(command, capture_output=True, text=True, env=environment)
        if done.returncode:
            raise BuildError(f"{done.stdout}{done.stderr}{' '.join(command)} failed")
    return folder / target


def run_once(program: Path, kernel: str, runs: int) -> int:
    """Return the number of instructions of one run of the driver."""
    done = subprocess.run(
        [*VALGRIND, str(program), kernel, str(runs)],
        capture_output=True,
        text=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )
    found = re.search(r"I\s+refs:\s+([\d,]+)", done.stderr)
    if done.returncode or not found:
        sys.exit(f"{done.stderr}valgrind failed with {kernel}")
    return int(found[1].replace(",", ""))


def count(program: Path) -> dict[str, int]:
    """Return the instructions of one run of each kernel, without the preparation of its data."""
    listed = subprocess.run([str(program)], capture_output=True, text=True, check=True)
    return {
        kernel: run_once(program, kernel, 1) - run_once(program, kernel, 0)
        for kernel in listed.stdout.split()
    }


def compare_with(revision: str) -> int:
    """Count instructions, print the table and return the exit code."""
    base = find_base(revision)
    if not shutil.which("valgrind"):
        raise Skip("valgrind is not installed")
    messages = git("log", "--format=%B", f"{base}..HEAD")
    program = build(ROOT)
    with tempfile.TemporaryDirectory(prefix="samcontact-") as name:
        folder = Path(name)
        git("worktree", "add", "--quiet", "--detach", str(folder / "base"), base)
        try:
            before = count(build(folder / "base"))
        except BuildError as error:
            reason = [line for line in str(error).splitlines() if "error" in line]
            raise Skip("\n".join([f"{revision} does not build", *reason])) from None
        finally:
            git("worktree", "remove", "--force", str(folder / "base"))
        after = count(program)
    rows, failed = compare(before, after, allowances(messages))
    print(table(rows))
    if failed:
        print(
            f"More instructions than in {revision}: {', '.join(failed)}. If that is intended, say "
            f"so in the commit message, e.g.\nInstructions: {failed[0]} +10 % because ..."
        )
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--base", default="HEAD~1", help="commit to compare with (HEAD~1)")
    try:
        return compare_with(parser.parse_args().base)
    except Skip as reason:
        print(f"Instruction counts skipped: {reason}.")
        return 0
    except BuildError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    sys.exit(main())

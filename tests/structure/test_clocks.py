# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests use no clock, so that none fails on a busy machine."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("tests", "cpp/tests", "cpp/fuzz", "benchmarks/instructions", "notebooks", "docs/_ext")
FILES = [
    ROOT / "CMakeLists.txt",
    ROOT / "CMakePresets.json",
    ROOT / "test",
    *(
        path
        for folder in FOLDERS
        for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in (".py", ".cpp", ".hpp", ".cmake", ".sh", ".ipynb")
    ),
]

# Functions of clocks, and limits given in seconds.
CLOCK = re.compile(
    r"\b(?:time\.(?:time|perf_counter|monotonic|process_time|thread_time|sleep)(?:_ns)?"
    r"|perf_counter|timeit|steady_clock|system_clock|high_resolution_clock|clock_gettime"
    r"|sleep_for|sleep_until|wait_for\w*|setitimer|signal\.alarm|ITIMER_\w+|faulthandler"
    r"|WebDriverWait|implicitly_wait|deadline|\w*timeouts?|max_total_time|TIMEOUT)\b"
)
# Permitted lines: the wait ends by its condition, not by the time.
NO_LIMIT = re.compile(
    r"timeout=(?:None|NEVER|0\b)|deadline=None|TIMEOUT 0\b|client_config\.timeout = None"
    r"|options\.timeouts = .*NEVER.*NEVER|wait_for_workers\(\d\)"
)
# Lines that read a clock without an effect on the result of a test.
EXCEPTIONS = {
    "tests/faults/faulting.py": "times of a kill; one too late is repeated earlier",
    "tests/faults/killed_runs.py": "a clock that is set back",
    "tests/faults/test_interrupted.py": "times of Ctrl-C; one too late is repeated earlier",
    "tests/unit/simulation/test_interrupt.py": "polls until the step has begun",
    "tests/unit/fatigue/test_fatigue_threads.py": "the signal arrives during the call",
    "tests/unit/heat_kernels/test_heat_kernels_limits.py": "the call takes hours",
    "tests/packaging/test_workflows.py": "key of a workflow; nothing waits",
    "tests/unit/sweeps/test_sweep_cli.py": "polls until a case is done",
}


def clock_uses(path):
    """Return the lines of a file that use a clock."""
    found = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if CLOCK.search(NO_LIMIT.sub("", line)):
            found.append(f"{path.relative_to(ROOT)}:{number}: {line.strip()}")
    return found


@pytest.mark.parametrize(
    "line",
    ["-timeout=20", "assert time.perf_counter() - start < 2", "process.communicate(timeout=60)",
     "signal.alarm(20)", "client.wait_for_workers(2, timeout=30)", "@settings(deadline=200)",
     "std::chrono::steady_clock::now()", "set_tests_properties(fuzz PROPERTIES TIMEOUT 100)"],
)  # fmt: skip
def test_clocks_are_found(line, tmp_path, monkeypatch):
    monkeypatch.setattr(f"{__name__}.ROOT", tmp_path)
    (tmp_path / "file.py").write_text(line)
    assert len(clock_uses(tmp_path / "file.py")) == 1


def test_no_test_uses_a_clock():
    others = [f for f in FILES if f != Path(__file__)]
    assert len(others) > 100
    found = {str(path.relative_to(ROOT)): clock_uses(path) for path in others}
    wrong = [line for name, lines in found.items() if name not in EXCEPTIONS for line in lines]
    assert wrong == []
    assert [name for name in EXCEPTIONS if not found[name]] == []  # no obsolete exceptions

# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixtures and settings for all tests."""

import gc
import signal
import sys
from pathlib import Path

import hypothesis
import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

# A shell starts background jobs with SIGINT ignored, and children inherit this; tests that send
# SIGINT would never end.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Collection makes many objects and no garbage; a search for garbage takes a quarter of its time.
gc.disable()

# Each test sets its number of examples; no clock does.
hypothesis.settings.register_profile("project", deadline=None, derandomize=True, database=None)
hypothesis.settings.load_profile("project")

# The longest files start first, so that none of them runs alone at the end.
LONG_TESTS = (
    "validation/test_gallery.py",
    "structure/test_site.py",
    "notebooks/test_notebooks.py",
    "unit/plotting/test_default_images.py",
    "unit/simulation/",
    "validation/",
    "faults/",
    "stability/",
    "structure/",
    "fuzz/",
)


@pytest.fixture
def undrawn(monkeypatch):
    """Create figures and files without drawing, which is slow and has its own tests."""
    from matplotlib.figure import Figure

    def savefig(self, target, **options):
        if isinstance(target, Path):
            target.touch()

    monkeypatch.setattr(Figure, "savefig", savefig)


@pytest.fixture
def undrawn_files(monkeypatch):
    """Create files of figures without drawing, but draw figures of reports and animations."""
    from matplotlib.figure import Figure

    draw = Figure.savefig

    def savefig(self, target, **options):
        return target.touch() if isinstance(target, Path) else draw(self, target, **options)

    monkeypatch.setattr(Figure, "savefig", savefig)


@pytest.fixture
def steps_alone(monkeypatch):
    """Switch off the estimate of increment errors, which would add steps to those of the path."""
    from samcontact.simulation import increment_errors

    monkeypatch.setattr(increment_errors, "estimated", lambda *_, **__: None)


def mark_slow_variants(items, whole_files):
    """Mark the tests of slow_variants.toml; raise UsageError for a name that no test has."""
    listed = tomllib.loads(Path(__file__).with_name("slow_variants.toml").read_text("utf-8"))
    found = {}
    for item in items:
        found.setdefault(item.nodeid, []).append(item)
        if "[" in item.nodeid:
            found.setdefault(item.nodeid.partition("[")[0], []).append(item)
    files = {nodeid.partition("::")[0] for nodeid in found}
    for file, tests in listed.items():
        for test, names in tests.items():
            suffixes = [""] if names is True else [f"[{name}]" for name in names]
            for nodeid in (f"tests/{file}::{test}{suffix}" for suffix in suffixes):
                for item in found.get(nodeid, ()):
                    item.add_marker(pytest.mark.slow)
                if whole_files and f"tests/{file}" in files and nodeid not in found:
                    raise pytest.UsageError(f"slow_variants.toml: there is no test {nodeid}")


def pytest_collection_finish():
    gc.enable()


@pytest.hookimpl(tryfirst=True)  # before tests are selected by their marks
def pytest_collection_modifyitems(config, items):
    mark_slow_variants(items, whole_files=not any("::" in part for part in config.args))

    def place(item):
        return next(
            (n for n, name in enumerate(LONG_TESTS) if f"tests/{name}" in item.nodeid),
            len(LONG_TESTS),
        )

    items.sort(key=place)  # stable: files stay together

# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared tools of the fuzz tests: number of inputs, and calls with them."""

import pytest
from hypothesis import HealthCheck, given, settings

# Inputs tried: in every run of the tests, and with the marker `slow`.
INPUTS = {
    "texts of case files": (75, 6000),
    "cases with extreme values": (100, 8000),
    "construction of simulations from cases": (15, 1200),
    "flipped or cut bytes of checkpoints": (75, 6000),
    "flipped or cut bytes of wear checkpoints": (40, 3000),
    "flipped or cut bytes of a journal": (10, 1200),
    "flipped or cut bytes of results": (10, 1200),
    "edited parts of checkpoints": (40, 5000),
    "boxes of subdomains in checkpoints": (20, 1200),
    "edited parts of wear checkpoints": (25, 2000),
    "edited parts of results": (6, 1200),
    "files of heights": (50, 4000),
    "arguments of the grid, materials and surfaces": (500, 20000),
    "arguments of operators": (300, 12000),
    "arguments of contacts": (100, 8000),
    "arguments of steps": (75, 6000),
    "drawn cases": (16, 10_000),
    "studies": (5, 500),
}


def with_trials(name):
    """Parametrise a test with `count` inputs, and with more inputs if slow."""
    few, many = INPUTS[name]
    slow = pytest.param(many, marks=pytest.mark.slow, id="many")
    return pytest.mark.parametrize("count", [pytest.param(few, id="few"), slow])


def try_all(check, count, **strategies):
    """Call a check with `count` random inputs, equal in every run."""

    def run_check(**drawn):
        check(**drawn)  # what it returns is for other callers

    steady = settings(
        max_examples=count,
        deadline=None,
        derandomize=True,
        database=None,
        suppress_health_check=list(HealthCheck),
    )
    steady(given(**strategies)(run_check))()


def unless_refused(call, kind, text=""):
    """Result of a call; None if it raises an error of this kind with this text."""
    try:
        return call()
    except kind as error:
        message = str(error)
    assert message
    assert text in message
    return None

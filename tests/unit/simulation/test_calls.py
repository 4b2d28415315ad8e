# SPDX-License-Identifier: GPL-3.0-or-later
"""Number of Python calls per increment: properties of the setup are computed once."""

import sys
import warnings
from pathlib import Path

import pytest

import samcontact as sc

PACKAGE = str(Path(sc.__file__).parent)
STEEL = sc.Material.elastic(210e9, 0.3)
YIELDING = sc.Material.perfect_plastic(210e9, 0.3, 0.6e9)
MAX_CALLS = {"elastic": 61, "plastic": 69}
"""Calls of functions of the package in a step: a few more than there are."""


def calls_of(function):
    """Return the number of calls of functions of the package."""
    count = 0

    def look(frame, event, _):
        nonlocal count
        count += event == "call" and frame.f_code.co_filename.startswith(PACKAGE)

    sys.setprofile(look)
    try:
        function()
    finally:
        sys.setprofile(None)
    return count


@pytest.mark.parametrize("kind", MAX_CALLS)
def test_a_step_calls_few_functions(kind):
    dz = {"elastic": None, "plastic": 10e-6}[kind]
    grid = sc.Grid(25, 25, 20e-6, 20e-6, dz=dz)
    body = {"elastic": STEEL, "plastic": YIELDING}[kind]
    simulation = sc.Simulation(grid, STEEL, body, sc.surfaces.paraboloid(grid, 10e-3))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.IncrementWarning)  # whose estimate is another run
        counts = [calls_of(lambda load=load: simulation.step(load=load)) for load in (40.0, 44.0)]
    assert (simulation.state.max_equivalent_plastic_strain(2) > 0) == (kind == "plastic")
    assert max(counts) <= MAX_CALLS[kind]
    assert min(counts) >= 20  # they are counted

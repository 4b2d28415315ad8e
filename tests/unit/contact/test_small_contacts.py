# SPDX-License-Identifier: GPL-3.0-or-later
"""Small contacts: little work in Python, and laws that keep their object of the core."""

import copy
import pickle
import sys

import numpy as np

import samcontact as sc

MAX_CALLS = 480
"""Maximum number of calls of Python functions in a solver and its solution; measured: 426."""


def test_a_small_contact_needs_few_calls_of_python():
    """Checks and estimates must not exceed the time of the core on 64 x 64 cells."""
    grid = sc.Grid(64, 64, 20e-6, 20e-6)
    steel = sc.Material.elastic(210e9, 0.3)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)

    def solve():
        return sc.ContactSolver(grid, steel, steel).solve(gap, load=500.0)

    calls, first = 0, solve()

    def count(frame, event, argument):
        nonlocal calls
        calls += event == "call"

    sys.setprofile(count)
    try:
        again = solve()
    finally:
        sys.setprofile(None)
    assert calls <= MAX_CALLS
    np.testing.assert_array_equal(first.pressure, again.pressure)


def test_copies_of_a_law_make_their_own_object():
    law = sc.CappedCoulomb(0.3, 2e8)
    assert law.to_core() is law.to_core()
    for other in (copy.deepcopy(law), pickle.loads(pickle.dumps(law))):
        assert other == law
        assert other.to_core() is not law.to_core()
        assert other.bound(1e9) == law.bound(1e9) == 2e8

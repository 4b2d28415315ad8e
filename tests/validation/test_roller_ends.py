# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure at the end of a roller against finite elements (reference/roller_end)."""

import numpy as np
import pytest

from benchmarks import roller_ends

HALF_SPACE, FACTOR, EXACT = "", "factor", "exact"


def test_both_bodies_end():
    """Two faces with their reflections agree to 0.01 of the Hertz pressure from 0.05 mm on.

    Without the reflections they deviate by 0.016. The blocks are clamped at 8 mm of depth.
    """
    expected = roller_ends.elements()["flush"]
    exact = roller_ends.ratios("flush", EXACT)
    np.testing.assert_allclose(exact, expected, rtol=0, atol=0.01)
    meshed = roller_ends.meshed_roller()  # the middle plane is at 8 mm of depth
    np.testing.assert_allclose(exact[1:], meshed[1:], rtol=0, atol=0.01)


@pytest.mark.slow
def test_a_roller_as_long_as_its_radius():
    """Reflections are larger; finite elements of each wave and iteration of the gap gave these."""
    expected = [0.7807, 0.8668, 0.9265, 0.9657, 0.9952]
    found = roller_ends.ratios("flush", EXACT, cell_y=40e-6, length=8e-3)
    np.testing.assert_allclose(found, expected, rtol=0, atol=0.01)


@pytest.mark.slow
def test_one_body_ends():
    """The pressure rises to the end, less than between half-spaces."""
    expected = roller_ends.elements()["overhang"]
    exact = roller_ends.ratios("overhang", EXACT)
    np.testing.assert_allclose(exact, expected, rtol=0, atol=0.01)
    half = roller_ends.ratios("overhang", HALF_SPACE)
    assert half[1] > 1.2 * expected[1]


@pytest.mark.slow
@pytest.mark.parametrize(("end", "error"), [("flush", 0.045), ("overhang", 0.06)])
def test_the_factor(end, error):
    expected = roller_ends.elements()[end]
    np.testing.assert_allclose(roller_ends.ratios(end, FACTOR), expected, rtol=0, atol=error)


@pytest.mark.slow
def test_cells_half_as_long():
    """The pressure from 0.05 mm on does not depend on the cells."""
    coarse, fine = (roller_ends.ratios("flush", EXACT, cell) for cell in (20e-6, 10e-6))
    np.testing.assert_allclose(fine, coarse, rtol=0, atol=0.008)

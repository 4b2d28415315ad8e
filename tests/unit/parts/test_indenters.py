# SPDX-License-Identifier: GPL-3.0-or-later
"""Indenters against Sneddon's solutions, area functions and properties of their rounded tips."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact import parts

BODY = sc.Material.elastic(1.0, 0.3)
E_STAR = 1.0 / 0.91
ANGLE = math.radians(88.0)


def test_a_cone_follows_sneddon():
    # Sneddon 1965: load 2 E* tan(angle) d^2/pi, contact radius 2 d tan(angle)/pi
    approach = 0.5 * math.pi / math.tan(ANGLE)
    grid = sc.Grid(41, 41, 0.06, 0.06)
    found = sc.ContactSolver(grid, sc.Material.rigid(), BODY).solve(
        lambda grid: parts.cone(grid, ANGLE), approach=approach
    )
    load = 2.0 * E_STAR * math.tan(ANGLE) * approach**2 / math.pi
    assert found.load == pytest.approx(load, rel=2e-3)
    radius = math.sqrt(np.count_nonzero(found.pressure) * grid.cell_area / math.pi)
    assert radius == pytest.approx(1.0, rel=2e-2)


def test_a_sharp_punch_follows_boussinesq():
    # load 2 a E* d; the cells approximate the circle, with an error of the order of one cell
    grid = sc.Grid(41, 41, 0.06, 0.06)
    gap = parts.flat_punch(grid, 1.0)
    radius = math.sqrt(np.count_nonzero(gap == 0.0) * grid.cell_area / math.pi)
    with pytest.warns(sc.SingularPressureWarning):
        found = sc.ContactSolver(grid, sc.Material.rigid(), BODY).solve(gap, approach=1e-3)
    assert found.load == pytest.approx(2.0 * radius * E_STAR * 1e-3, rel=1e-2)


@pytest.mark.parametrize(
    ("pyramid", "area"), [(parts.berkovich, 24.5), (parts.vickers, 4.0 * math.tan(1.18682) ** 2)]
)
def test_cross_sections_of_pyramids(pyramid, area):
    grid = sc.Grid(601, 601, 0.01, 0.01)
    depth = 0.4
    # the count of cells is exact to a part of the cells on the border
    inside = np.count_nonzero(pyramid(grid, angle=0.1) < depth) * grid.cell_area
    assert inside == pytest.approx(area * depth**2, rel=2e-3)


@pytest.mark.parametrize("pyramid", [parts.berkovich, parts.vickers])
def test_a_rounded_pyramid_is_convex_without_kink(pyramid):
    """No curvature is negative or above that of the ball, corrected for its slope."""
    grid, R = sc.Grid(161, 161, 0.02, 0.02), 1.0
    gap = pyramid(grid, tip_radius=R, angle=0.3)
    steepest = 1.0 / math.tan(math.radians(65.0))
    for axis in (0, 1):
        curvature = np.diff(gap, 2, axis=axis) / grid.dx**2
        assert curvature.min() > -1e-9
        assert curvature.max() < math.hypot(1.0, steepest) ** 3 / R
    assert gap[80, 80] == 0.0
    assert curvature[80, 79] == pytest.approx(1.0 / R, rel=1e-3)


def test_far_from_the_tip_a_rounded_indenter_is_a_shifted_sharp_one():
    grid = sc.Grid(9, 1, 1.0, 1.0)
    for shape in (lambda R: parts.cone(grid, 1.2, R), lambda R: parts.vickers(grid, R)):
        angle = 1.2 if shape(0.0)[0, 0] == pytest.approx(4.0 / math.tan(1.2)) else 1.18682389
        shift = shape(0.0) - shape(0.5)
        assert shift[[0, -1], 0] == pytest.approx(0.5 * (1.0 / math.sin(angle) - 1.0), rel=1e-6)


def test_the_rounded_edge_of_a_punch():
    grid = sc.Grid(11, 1, 0.2, 0.2)
    gap = parts.flat_punch(grid, 0.9, edge_radius=0.5)[5:, 0]
    expected = [0.0, 0.0, 0.0, *(0.5 - math.sqrt(0.25 - (r - 0.4) ** 2) for r in (0.6, 0.8))]
    assert gap[:5] == pytest.approx(expected, abs=1e-12)
    assert gap[5] == math.inf


def test_degrees_are_named():
    with pytest.raises(ValueError, match=r"half_angle must be in \(0, pi/2\).*degrees"):
        parts.cone(sc.Grid(3, 3, 1.0, 1.0), 70.3)

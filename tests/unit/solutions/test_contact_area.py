# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact areas against smooth outlines; exact if the edge lies between two cells."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact import results
from samcontact.solutions.contact_area import contact_area

STEEL, RIGID = sc.Material.elastic(210e9, 0.3), sc.Material.rigid()
PERIOD, AMPLITUDE = 1e-3, 1e-6
FULL = math.sqrt(2) * math.pi * sc.hertz.effective_modulus(STEEL, RIGID) * AMPLITUDE / PERIOD
WAVY = {0.05: 0.1130, 0.2: 0.3453, 0.5: 0.7043, 0.8: 0.8977, 0.9: 0.9507}
"""Contact over nominal area at a share of full contact: 1024 x 1024 cells, as of Johnson,
Greenwood & Higginson (1985) and Yastrebov, Anciaux & Molinari (2014)."""


def wavy(cells, shift=0.0):
    """Return a grid of one period, and the gap function of a wave in both directions."""

    def gap(grid):
        x, y = (2 * np.pi * (s + shift * PERIOD / cells) / PERIOD for s in (grid.x, grid.y))
        return AMPLITUDE * (1 - np.outer(np.cos(x), np.cos(y)))

    return sc.Grid(cells, cells, PERIOD / cells, PERIOD / cells, periodic="xy"), gap


def ball(cells, shift, aspect=1.0):
    """Return relative errors of the contact area of a ball, corrected and by counting cells."""
    load, radius = 100.0, 5e-3
    hertz = sc.hertz.point(radius, sc.hertz.effective_modulus(STEEL, STEEL), load=load)
    dx, dy = 2 * hertz.a / cells, 2 * hertz.a / cells * aspect
    grid = sc.Grid(math.ceil(1.3 * cells) + 3, math.ceil(1.3 * cells / aspect) + 3, dx, dy)
    gap = (grid.x[:, None] - shift * dx) ** 2 + (grid.y - 0.6 * shift * dy) ** 2
    found = sc.ContactSolver(grid, STEEL, STEEL).solve(gap / (2 * radius), load=load)
    counted = np.count_nonzero(found.pressure) * grid.cell_area
    exact = math.pi * hertz.a**2
    return found.contact_area / exact - 1, counted / exact - 1


@pytest.mark.parametrize("aspect", [1.0, 0.5])
def test_area_of_a_ball_is_of_higher_order_than_counted_cells(aspect):
    worst = {}
    for cells in (12, 24, 48):
        found = np.array([ball(cells, shift, aspect) for shift in (0.0, 0.2, 0.4, 0.5)])
        worst[cells] = np.abs(found).max(axis=0)
    assert worst[12][0] < 0.015
    assert worst[48][0] < 0.25 * worst[12][0]
    for located, counted in worst.values():
        assert located < 0.5 * counted


def test_straight_edges_are_located_within_their_cells():
    radius, line_load = 5e-3, 1e5
    b = sc.hertz.line(radius, sc.hertz.effective_modulus(STEEL, STEEL), line_load).b
    for cells in (8, 17, 32):
        for shift in (0.0, 0.25, 0.5):
            grid = sc.Grid(math.ceil(1.3 * cells) + 3, 2, 2 * b / cells, b, periodic="y")
            gap = (grid.x[:, None] - shift * grid.dx) ** 2 / (2 * radius) + np.zeros(2)
            found = sc.ContactSolver(grid, STEEL, STEEL).solve(gap, load=line_load * 2 * b)
            assert found.contact_area == pytest.approx(4 * b * b, rel=0.13 / cells)


@pytest.mark.parametrize("share", WAVY)
def test_true_error_of_a_wavy_surface_is_below_the_stated_one(share):
    for cells in (16, 32, 48, 96):
        for shift in (0.0, 0.3):
            grid, gap = wavy(cells, shift)
            run = sc.Simulation(grid, RIGID, STEEL, gap)
            path = [{"load": share * FULL * PERIOD**2}]
            states = run.run(path, progress=False)
            found = sc.estimate_errors(run, path, states)
            value, error = (float(v["contact_area"][0]) for v in (found.values, found.errors))
            assert value == states[0].contact_area
            assert abs(value - WAVY[share] * PERIOD**2) <= error + 1e-4 * PERIOD**2
            assert error < 0.5 * value
            dataset = results.to_dataset(run, states)
            found.add_to(dataset)
            assert float(dataset["contact_area"][0]) == value
            assert float(dataset["contact_area_error"][0]) == error


def test_rough_surfaces_of_few_cells_a_wave_come_close_to_fine_ones():
    cells, size = 256, 1e-6
    fine = sc.Grid(cells, cells, size, size, periodic="xy")
    heights = sc.surfaces.rough_self_affine(
        fine, 1e-6, 0.8, wavelength_min=16 * size, roll_off=cells * size / 4, seed=1
    )
    gap = heights - heights.min()
    slope = np.hypot(*np.gradient(gap, size)).std()
    load = 0.05 * sc.hertz.effective_modulus(STEEL, RIGID) * slope * (cells * size) ** 2
    areas = {}
    for step in (1, 4, 8):
        grid = sc.Grid(cells // step, cells // step, step * size, step * size, periodic="xy")
        sampled = gap[step // 2 :: step, step // 2 :: step]
        found = sc.ContactSolver(grid, RIGID, STEEL).solve(sampled, load=load)
        areas[step] = found.contact_area, np.count_nonzero(found.pressure) * grid.cell_area
    assert areas[8][1] > 1.2 * areas[1][0]
    for step in (4, 8):
        assert areas[step][0] == pytest.approx(areas[1][0], rel=0.08)


def test_exact_areas_are_not_corrected():
    # full contact has no outline, and a punch has its edge between two cells
    assert contact_area(np.ones((6, 4)), 2.0, "xy") == 48.0
    assert contact_area(np.zeros((6, 4)), 2.0) == 0.0
    one = np.zeros((5, 5))
    one[2, 2] = 1.0
    assert 0.5 <= contact_area(one, 1.0) < 0.6
    for ny, periodic in ((1, "y"), (4, "y"), (32, "")):
        grid = sc.Grid(32, ny, 1e-5, 1e-5, periodic=periodic)
        inside = np.abs(grid.x[:, None]) < 1e-4
        if not periodic:
            inside = inside & (np.hypot(grid.x[:, None], grid.y) < 1.04e-4)
        inside = inside & np.ones(ny, dtype=bool)
        with pytest.warns(sc.SingularPressureWarning):
            found = sc.ContactSolver(grid, RIGID, STEEL).solve(
                np.where(inside, 0.0, 1e-4), load=1.0
            )
        assert found.contact_area == pytest.approx(inside.sum() * grid.cell_area, rel=1e-12)

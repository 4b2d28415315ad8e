# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of plastic solutions distorted by the cells: above the limit load, alternating in
depth."""

import math
import re
import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact.diagnostics.plastic_patterns import alternation

RIGID = sc.Material.rigid()


def warned(sim, start, **steps):
    """Return the warnings of some steps that begin with this text."""
    ((driver, values),) = steps.items()
    sim.monitor.checks_increments = False
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        for value in values:
            sim.step(**{driver: value})
    texts = [str(w.message) for w in caught if w.category is sc.ResolutionWarning]
    return [text for text in texts if text.startswith(start)]


class TestLimitLoad:
    """A ball in a perfectly plastic body, at E* a/(Y R) of about 10 and 100."""

    YIELD, R = 50e6, 0.5

    def pressed(self, cells, depth):
        """Return the warnings, and the mean pressure over the yield stress."""
        soft = sc.Material.perfect_plastic(210e9, 0.3, self.YIELD)
        half_width = math.sqrt(2 * self.R * depth)
        size = half_width / cells
        n = int(2.4 * cells) | 1
        gap = lambda grid: sc.surfaces.paraboloid(grid, self.R)  # noqa: E731
        sim = sc.Simulation(sc.Grid(n, n, size, size, dz=size), RIGID, soft, gap)
        texts = warned(sim, "mean pressure exceeds", approach=[depth])
        return texts, sim.state.mean_pressure / self.YIELD

    def test_the_limit_load_exceeded_on_few_cells_causes_a_warning(self):
        (text,), mean = self.pressed(5, 0.25e-3)
        assert mean > 3.15
        shown = re.search(r"is ([\d.]+) times the yield stress of body 2", text)
        assert float(shown[1]) == pytest.approx(mean, rel=5e-3)
        over = re.search(r"about (\d+) % too high", text)
        assert float(over[1]) == pytest.approx(100 * (mean / 3 - 1), abs=1)

    def test_the_limit_load_is_not_reached_at_smaller_depth(self):
        texts, mean = self.pressed(5, 5e-6)
        assert 1.1 < mean < 3.0
        assert texts == []


class TestAlternation:
    def pressed(self, residual_stress, depth, yields=1e9):
        """Press a rigid ball to ten times the interference at first yield."""
        soft = sc.Material.linear_hardening(210e9, 0.3, yields, 10e9)
        R, E_star = 1e-2, 210e9 / 0.91
        interference = 10 * (math.pi * 1.6 * yields / (2 * E_star)) ** 2 * R
        n = 15
        size = 2.6 * math.sqrt(R * interference) / n
        sim = sc.Simulation(
            sc.Grid(n, n, size, size, dz=depth * size), RIGID, soft,
            lambda grid: sc.surfaces.paraboloid(grid, R), residual_stress=residual_stress,
        )  # fmt: skip
        start = "plastic strain of body 2 alternates between layers"
        texts = warned(sim, start, approach=[0.5 * interference, interference])
        return texts, sim.state.max_equivalent_plastic_strain()

    def test_alternation_in_cubes_with_little_hardening_causes_a_warning(self):
        (text,), exact = self.pressed("exact", 1.0)
        texts, fast = self.pressed("fast", 1.0)
        assert texts == []
        assert exact > 1.1 * fast
        assert 'residual_stress="fast"' in text

    def test_flatter_cells_do_not_alternate(self):
        """Flatter cells are the second remedy in the warning."""
        texts, exact = self.pressed("exact", 0.5)
        assert texts == []
        assert exact == pytest.approx(self.pressed("fast", 0.5)[1], rel=0.02)

    @pytest.mark.parametrize("layers", [5, 8])
    def test_smooth_strain_hardly_alternates(self, layers):
        z = np.arange(20)[None, None, None, :]
        bump = np.maximum(0.0, 1 - ((z - 9.5) / (layers / 2)) ** 2) * np.ones((6, 3, 3, 1))
        pattern = bump * (1 + 0.4 * (-1.0) ** z)
        assert alternation(bump) < 0.15 < alternation(pattern)
        assert alternation(0 * bump) == alternation(bump[..., :4]) == 0

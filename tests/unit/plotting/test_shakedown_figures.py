# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of shakedown show the computed data."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import plotting, shakedown


@pytest.mark.parametrize(("contact", "curves"), [("line", 4), ("point", 3)])
def test_map_of_limits(contact, curves, monkeypatch):
    monkeypatch.setattr("samcontact.plotting.shakedown._FRICTION", np.array([0.0, 0.3, 0.5]))
    ax = plotting.shakedown_map(contact=contact)
    drawn = {line.get_label(): line for line in ax.lines if line.get_label()[0] != "_"}
    assert len(drawn) == curves
    name = next(label for label in drawn if label.startswith("shakedown, perfectly plastic"))
    function = {"line": lambda mu: shakedown.line(mu, 0.3, "von_mises"), "point": shakedown.point}
    expected = [function[contact](mu).ratio for mu in (0.0, 0.3, 0.5)]
    np.testing.assert_allclose(drawn[name].get_ydata(), expected)
    texts = [text.get_text() for text in ax.get_legend().get_texts()]
    assert texts == list(drawn)
    with pytest.raises(ValueError, match="contact must be"):
        plotting.shakedown_map(contact="ellipse")


def test_strain_of_each_cycle():
    grid = sc.Grid(19, 19, 20e-6, 20e-6, dz=20e-6)
    body = sc.Material.perfect_plastic(210e9, 0.3, 8.66e7)
    gap = sc.surfaces.paraboloid(grid, 50e-3)
    simulation = sc.Simulation(grid, sc.Material.elastic(210e9, 0.3), body, gap)
    cycle = [{"load": 8.0}, {"load": 0.0}]
    result = shakedown.run(simulation, cycle, progress=False)
    ax = plotting.strain_per_cycle(result, label="a ball")
    left, flow = ax.lines
    assert left.get_label() == "a ball"
    np.testing.assert_array_equal(left.get_xdata(), [c.number for c in result.cycles])
    shown = np.array(flow.get_ydata()) * result.yield_strain
    np.testing.assert_allclose(shown, [c.flow for c in result.cycles])
    assert ax.get_yscale() == "log"

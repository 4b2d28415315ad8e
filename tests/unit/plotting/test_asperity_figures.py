# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of asperity collisions show the given series."""

import numpy as np
import pytest

import samcontact as sc
from samcontact.asperities import Collision, collide
from samcontact.plotting import asperities as asperity_figures

ELASTIC = sc.Material.elastic(200e9, 0.32)
STEEL = sc.Material.perfect_plastic(200e9, 0.32, 0.9115e9)
CRITICAL = sc.critical.green(0.5, sc.hertz.effective_modulus(STEEL, STEEL), 0.32, 0.9115e9)


@pytest.fixture(scope="module")
def results():
    found = []
    for relative in (2.0, 4.0):
        which = Collision(1.0, 1.0, relative * CRITICAL.interference)
        found.append(collide(which, ELASTIC, STEEL, which.grid(8), passes=2, progress=False).series)
    return found


def lines(ax):
    """Return the curves without the zero lines of the axes."""
    return [line for line in ax.lines if not line.get_label().startswith("_")]


@pytest.mark.parametrize(
    ("component", "number", "scale", "unit"), [("x", 1, 1e3, "kN"), ("z", 2, 1e6, "MN")]
)
def test_force(results, component, number, scale, unit):
    ax = asperity_figures.force(results, component=component, number=number)
    assert len(lines(ax)) == 2
    for line, result in zip(lines(ax), results, strict=True):
        series = result.sel({"pass": number})
        np.testing.assert_allclose(line.get_xdata(), series["offset"].values / 0.5)
        np.testing.assert_allclose(line.get_ydata() * scale, series[f"force_{component}"].values)
    assert f"[{unit}]" in ax.get_ylabel()
    assert ax.get_legend().get_title().get_text() == "interference"
    over = asperity_figures.force(results, component=component, number=number, critical=CRITICAL)
    scaled = lines(over)[0]
    force = results[0][f"force_{component}"].sel({"pass": number}).values
    np.testing.assert_allclose(scaled.get_ydata() * CRITICAL.load, force)
    assert scaled.get_label() == "ω/ωc = 2"
    assert lines(ax)[0].get_label() == f"{2e6 * CRITICAL.interference:.4g} µm"


def test_load_ratio(results):
    ax = asperity_figures.load_ratio(results)
    shown = lines(ax)[1].get_ydata()
    np.testing.assert_array_equal(shown, results[1].load_ratio.values[0])
    assert np.isnan(shown[0])


def test_energy_and_imprint_against_the_interference(results):
    ax = asperity_figures.net_energy(results, critical=CRITICAL)
    assert [line.get_label() for line in lines(ax)] == [
        "net energy", "pass 2", "energy of residual stress"
    ]  # fmt: skip
    first = lines(ax)[0]
    np.testing.assert_allclose(first.get_xdata(), [2, 4])
    expected = [float(r.net_energy[0]) / CRITICAL.energy for r in results]
    np.testing.assert_allclose(first.get_ydata(), expected)

    ax = asperity_figures.residual_displacement(results)
    depths = {line.get_label(): line.get_ydata() for line in lines(ax)}
    assert not np.any(depths["body 1, pass 1"])  # elastic
    expected = [float(r.residual_displacement[1, 1]) for r in results]
    np.testing.assert_array_equal(depths["body 2, pass 2"], expected)


def test_bad_arguments(results):
    with pytest.raises(ValueError, match="component must be one of 'x', 'z', got 'y'"):
        asperity_figures.force(results, component="y")
    with pytest.raises(ValueError, match="number must be that of a pass, from 1 to 2, got 3"):
        asperity_figures.load_ratio(results, number=3)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of fatigue: the data shown by artists, and the accepted fields."""

import numpy as np
import pytest
from matplotlib.figure import Figure

import samcontact as sc
from samcontact import plotting

D = 20e-6
GRID = sc.Grid(24, 18, D, D, nz=6, dz=D)
STEEL = sc.Material.elastic(210e9, 0.3)


@pytest.fixture(scope="module")
def states():
    simulation = sc.Simulation(GRID, STEEL, STEEL, sc.surfaces.paraboloid(GRID, 5e-3))
    return [simulation.state, simulation.step(load=30.0), simulation.step(load=60.0)]


@pytest.fixture(scope="module")
def fields(states):
    cycle = sc.fatigue.cycle(states)
    return [sc.fatigue.dang_van(cycle, slope=0.3), sc.fatigue.findley(cycle, k=0.2)]


@pytest.fixture
def ax():
    return Figure().subplots()


def cross(ax):
    (line,) = (line for line in ax.lines if line.get_marker() == "x")
    return float(line.get_xdata()[0]), float(line.get_ydata()[0])


def test_depth(fields, ax):
    assert plotting.fatigue_depth(fields, ax, limit=300e6) is ax
    curves = [line for line in ax.lines if len(line.get_xdata()) == 6]
    for curve, field in zip(curves, fields, strict=True):
        np.testing.assert_allclose(curve.get_xdata(), field.over_depth() * 1e-6)
        np.testing.assert_allclose(curve.get_ydata(), GRID.z * 1e6)
    assert [t.get_text() for t in ax.get_legend().get_texts()] == [
        "Dang Van (slope = 0.3)", "Findley (k = 0.2)", "limit",
    ]  # fmt: skip
    assert ax.yaxis_inverted()
    (limit,) = (line for line in ax.lines if set(line.get_xdata()) == {300.0})
    assert limit.get_linestyle() == "--"
    alone = plotting.fatigue_depth(fields[0])
    assert alone.get_xlabel() == "Dang Van (slope = 0.3) [MPa]"


@pytest.mark.parametrize(("plane", "across"), [("y", "x"), ("x", "y")])
def test_section_goes_through_the_largest(fields, ax, plane, across):
    field = fields[0]
    plotting.fatigue_section(field, ax, plane=plane)
    expected = field.position[across] * 1e6, field.position["z"] * 1e6
    np.testing.assert_allclose(cross(ax), expected, atol=1e-9)
    assert ax.yaxis_inverted()
    assert ax.get_xlabel().startswith(across)
    assert "Dang Van" in ax.get_title()


def test_section_elsewhere(fields, ax):
    plotting.fatigue_section(fields[0], ax, plane="y", position=5 * D)
    row = np.abs(GRID.y - 5 * D).argmin()
    i, k = np.unravel_index(fields[0].values[:, row].argmax(), (24, 6))
    np.testing.assert_allclose(cross(ax), (GRID.x[i] * 1e6, GRID.z[k] * 1e6), atol=1e-9)


def test_section_across_the_rolling_direction(states, ax):
    field = sc.fatigue.fatemi_socie(sc.fatigue.steady_cycle(states[-1]), k=0.3, yield_stress=1e9)
    plotting.fatigue_section(field, ax)
    assert ax.get_xlabel() == "y [µm]"
    assert ax.get_title() == "Fatemi-Socie (k = 0.3) [%]"
    with pytest.raises(ValueError, match="plane must be 'x'"):
        plotting.fatigue_section(field, plane="y")
    with pytest.raises(ValueError, match="field must have the coordinates x, y, z, got y, z"):
        plotting.fatigue_map(field)


def test_map_has_the_largest_of_each_column(fields, ax):
    plotting.fatigue_map(fields[1], ax)
    place = fields[1].position
    np.testing.assert_allclose(cross(ax), (place["x"] * 1e6, place["y"] * 1e6), atol=1e-9)


def test_fields_without_a_figure_are_refused(fields, states):
    strain = sc.fatigue.fatemi_socie(states, k=0.3, yield_stress=1e9)
    with pytest.raises(ValueError, match="the same unit"):
        plotting.fatigue_depth([fields[0], strain])
    with pytest.raises(ValueError, match="at least one"):
        plotting.fatigue_depth([])
    given = sc.fatigue.dang_van(np.zeros((2, 6, 3, 3, 3)), slope=0.3)
    for figure in (plotting.fatigue_depth, plotting.fatigue_section, plotting.fatigue_map):
        with pytest.raises(ValueError, match="from states, not from arrays"):
            figure(given)
    with pytest.raises(ValueError, match="limit"):
        plotting.fatigue_depth(fields, limit=-1.0)


def test_exposure_marks_what_governs(ax):
    flank = sc.hertz.line(10e-3, 113e9, p0=1.5e9)
    seen = sc.fatigue.hertz_cycle(flank, sc.Material.elastic(206e9, 0.3))
    found = sc.fatigue.exposure(seen, sc.hardness.HardnessProfile([0.0], [400.0]))
    plotting.exposure_depth(found, ax)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [
        "yield (von Mises)", "Dang Van", "orthogonal shear", "governs", "limit",
    ]  # fmt: skip
    assert ax.get_title() == f"maximum {found.max_value():.3g} at {found.depth() * 1e6:.3g} µm"

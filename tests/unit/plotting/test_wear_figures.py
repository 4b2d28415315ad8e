# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of wear: the data shown by artists."""

import numpy as np
import pytest
from drawn_fields import shows
from matplotlib.figure import Figure

import samcontact as sc
from samcontact.plotting import wear as wear_figures

GRID = sc.Grid(29, 27, 5e-6, 5e-6, 28, 1.6e-6)


@pytest.fixture(scope="module")
def result():
    return sc.wear.run(
        GRID,
        sc.Material.elastic(210e9, 0.3),
        sc.Material.swift(210e9, 0.3, 1735e6, 16.0, 0.067),
        sc.surfaces.paraboloid(GRID, 4e-4),
        cycle=[{"load": 5.0}, {"load": 0.0}],
        threshold=2e-3,
        cycles=2,
        window=5,
        friction=0.4,
        progress=False,
    )


@pytest.fixture
def ax():
    return Figure().subplots()


def test_tresca():
    """Values for uniaxial, hydrostatic and pure shear stress."""
    stress = np.zeros((6, 3))
    stress[0, 0] = -5.0
    stress[:3, 1] = 7.0
    stress[5, 2] = 2.0
    np.testing.assert_allclose(wear_figures.tresca(stress), [5.0, 0.0, 4.0], atol=1e-14)


def test_tresca_is_independent_of_the_axes():
    rng = np.random.default_rng(3)
    full = rng.normal(size=(3, 3))
    full += full.T
    rotation, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    pairs = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
    both = [np.array([m[p] for p in pairs]) for m in (full, rotation @ full @ rotation.T)]
    first, second = (wear_figures.tresca(s) for s in both)
    assert first == pytest.approx(second, rel=1e-12)


def test_worn_profile(result, ax):
    wear_figures.worn_profile(result.to_dataset(), ax, cycles=(0, 2))
    first, last = ax.get_lines()
    np.testing.assert_allclose(first.get_ydata(), 0.0)
    np.testing.assert_allclose(last.get_ydata(), result.profile(2)[:, 13] * 1e6)
    assert last.get_xdata()[np.argmin(np.abs(result.x()))] == pytest.approx(0.0, abs=1e-9)
    ax.figure.draw_without_rendering()
    assert ax.get_legend().get_window_extent().x0 >= ax.get_window_extent().x1  # next to the axes
    alone = wear_figures.worn_profile(result.to_dataset(), cycles=(0,))
    assert alone.get_legend() is None


def test_worn_profile_across(result, ax):
    wear_figures.worn_profile(result.to_dataset(), ax, axis="y", position=5e-6)
    row = np.argmin(np.abs(result.x() - 5e-6))
    assert len(ax.get_lines()) == 3
    np.testing.assert_allclose(ax.get_lines()[1].get_ydata(), result.profile(1)[row] * 1e6)


def test_surface_map(result, ax):
    wear_figures.surface_map(result.to_dataset(), ax, cycle=1, cells=True)
    shown = ax.collections[0].get_array().reshape(27, -1)
    np.testing.assert_allclose(shown, result.profile(1).T * 1e6)


def test_wear_rate(result, ax):
    wear_figures.wear_rate(result.to_dataset(), ax)
    np.testing.assert_allclose(ax.get_lines()[0].get_ydata(), result.rate * 1e18)


def test_panels(result):
    figure = wear_figures.cycle_panels(result.last, position=5e-6, width=6e-5, depth=3e-5)
    pressure, tresca, *_ = figure.axes
    loaded = result.last[0]
    np.testing.assert_allclose(pressure.get_lines()[0].get_ydata(), loaded.pressure[:, 14] * 1e-9)
    expected = wear_figures.tresca(loaded.stress()[:, :, 14]) * 1e-6
    inside = np.abs(loaded.grid.x) < 5.5e-5
    layers = loaded.grid.z < 2.9e-5
    shown = expected[inside][:, layers]
    assert shows(tresca, loaded.grid.x[inside], loaded.grid.z[layers], shown, within=0.1)
    assert tresca.get_ylim() == pytest.approx((30.0, 0.0))
    assert pressure.get_xlim() == pytest.approx((-60.0, 60.0))


def test_bad_input_is_named(result):
    with pytest.raises(ValueError, match=r"stress must have shape \(6, ...\), got \(3, 2\)"):
        wear_figures.tresca(np.zeros((3, 2)))
    with pytest.raises(ValueError, match="axis must be one of 'x', 'y', got 'z'"):
        wear_figures.worn_profile(result.to_dataset(), axis="z")
    with pytest.raises(ValueError, match="cycle must be from 0"):
        wear_figures.surface_map(result.to_dataset(), cycle=3)
    with pytest.raises(ValueError, match="body must be one of 2, got 1"):
        wear_figures.surface_map(result.to_dataset(), body=1)


def test_fretting_panels_show_pressure_and_slip():
    grid, steel = sc.Grid(16, 16, 1e-5, 1e-5), sc.Material.elastic(210e9, 0.3)
    scar = sc.wear.fretting(
        grid, steel, steel, sc.surfaces.paraboloid(grid, 5e-3), cycles=2, repeats=20000,
        cycle=[{"load": 5.0, "tangential_load": (q, 0.0)} for q in (0.0, 1.5, -1.5, 1.5)],
        friction=sc.Coulomb(0.5), energy=1e-14, progress=False,
    )  # fmt: skip
    above, below = wear_figures.fretting_panels(scar.first, scar.last, position=0.0).axes
    for line, states in zip(above.get_lines(), (scar.first, scar.last), strict=True):
        np.testing.assert_allclose(line.get_ydata(), states[-1].pressure[:, 7] * 1e-9)
    slip_distance = sum(np.hypot(*state.slip) for state in scar.last)[:, 7]
    np.testing.assert_allclose(below.get_lines()[1].get_ydata(), slip_distance * 1e6)
    assert slip_distance[7] == 0.0 < slip_distance.max()

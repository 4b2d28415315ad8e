# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions far from a rolling contact take one step in each increment, not an iteration."""

import numpy as np
import pytest

import samcontact as sc

YIELDING = sc.Material.linear_hardening(210e9, 0.3, 1.5e9, 9.5e9)
STIFF = sc.Material.elastic(390e9, 0.25)
SOFT = sc.Material.elastic(80e9, 0.3)
H = 40e-6
GRID = sc.Grid(52, 44, H, H, dz=H)
A, P0 = 8 * H, 4e9  # contact radius and maximum pressure of the elastic body
RADIUS = 2 * A * 210e9 / 0.91 / (np.pi * P0)
LOAD = 2 / 3 * np.pi * A**2 * P0
PLACES = [(0.0, 0.2, 5.0), (-6.0, 4.4, 7.0), (9.0, -5.2, 6.0), (-15.0, 3.0, 9.0), (4.0, 15.0, 5.0),
          (12.0, -14.0, 12.0), (-19.0, -8.0, 5.0), (1.0, -3.0, 17.0), (-20.0, 17.0, 5.0),
          (20.0, 12.0, 20.0)]  # cells  # fmt: skip
BODY = sc.Heterogeneous(
    YIELDING,
    [
        sc.Inclusion.sphere(tuple(H * np.array(place)), 2.6 * H, (STIFF, SOFT)[n % 2])
        for n, place in enumerate(PLACES)
    ],
)
pytestmark = pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")


def rolling(zones):
    gap = sc.surfaces.paraboloid(GRID, RADIUS)
    simulation = sc.Simulation(
        GRID, sc.Material.rigid(), BODY, gap, tol=1e-3, on_border="warn", zones=zones
    )
    simulation.step(load=LOAD)
    return simulation


def roll(simulation, positions):
    return [simulation.step(load=LOAD, advance=(0.0, H)) for _ in range(positions)]


@pytest.fixture(scope="module")
def whole():
    """All inclusions are iterated together with the contact."""
    return roll(rolling("one"), 5)


@pytest.fixture(scope="module")
def near():
    return roll(rolling("auto"), 5)


@pytest.mark.parametrize(("position", "of_far", "of_all"), [(4, 0.03, 2e-5), (3, 0.06, 1e-4)])
def test_one_step_for_far_inclusions_is_close_to_the_iteration(
    whole, near, position, of_far, of_all
):
    """Far inclusions are renewed at every second position only."""
    exact, found = whole[position], near[position]
    assert found.pressure.max() == pytest.approx(exact.pressure.max(), rel=2e-4)
    np.testing.assert_allclose(found.pressure, exact.pressure, atol=1e-3 * P0)
    largest = exact.max_equivalent_plastic_strain(2)
    assert found.max_equivalent_plastic_strain(2) == pytest.approx(largest, rel=1e-3)
    error = np.abs(found.stress(2) - exact.stress(2))
    assert 0 < error.max() < 0.01 * P0
    assert np.sqrt(np.mean(error**2)) < of_all * P0
    # the farthest inclusions, relative to their own strain
    strain, expected = found.eigenstrain(2), exact.eigenstrain(2)
    x, y = np.abs(GRID.x), np.abs(GRID.y)
    far = (x > 1.6 * A)[:, None] | (y > 1.6 * A)
    assert np.abs(strain - expected)[:, far].max() < of_far * np.abs(expected[:, far]).max()


def test_unloaded_after_rolling():
    """The residual stress is solved for all inclusions together again."""
    states = []
    for zones in ("one", "auto"):
        simulation = rolling(zones)
        roll(simulation, 2)
        states.append(simulation.step(load=0.0))
    exact, found = (state.residual_stress(2) for state in states)
    assert np.abs(found - exact).max() < 0.01 * np.abs(exact).max()


def test_restart_among_far_inclusions(tmp_path, near):
    simulation = rolling("auto")
    roll(simulation, 3)
    simulation.save(tmp_path / "state.h5")
    after = roll(sc.Simulation.load(tmp_path / "state.h5"), 2)
    for found, expected in zip(after, near[3:], strict=True):
        np.testing.assert_array_equal(found.pressure, expected.pressure)
        np.testing.assert_array_equal(found.stress(2), expected.stress(2))

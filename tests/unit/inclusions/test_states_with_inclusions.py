# SPDX-License-Identifier: GPL-3.0-or-later
"""Interfaces, statistics and butterflies of simulated contacts."""

from dataclasses import replace

import numpy as np
import pytest

import samcontact as sc
from samcontact._util.tensors import von_mises
from samcontact.fatigue import FatigueField

STEEL = sc.Material.elastic(210e9, 0.3)
A, P0 = 1e-3, 4e9
RIGID = sc.Material.rigid()
LOAD = 2 / 3 * np.pi * A**2 * P0
BALL_RADIUS = 4 * 210e9 / 0.91 * A**3 / (3 * LOAD)


def contact(inclusion, cells=6):
    h = 0.25 * A / cells
    n = int(2.5 * A / h) // 2 * 2 + 1
    grid = sc.Grid(n, n, h, h, dz=h)
    body = sc.Heterogeneous(STEEL, [inclusion])
    gap = sc.surfaces.paraboloid(grid, BALL_RADIUS)
    return sc.Simulation(grid, RIGID, body, gap, tol=1e-4).step(load=LOAD)


PLACE = (0.0, 0.0, 0.5 * A)


@pytest.mark.parametrize(
    ("inclusion", "reference", "tolerance"),
    [
        (sc.Inclusion.sphere(PLACE, 0.25 * A, sc.Material.elastic(420e9, 0.25)), 3.026e9, 0.08),
        (sc.Inclusion.sphere(PLACE, 0.25 * A, sc.Material.elastic(63e9, 0.3)), 3.714e9, 0.04),
        (sc.Inclusion.void(PLACE, 0.25 * A), 5.096e9, 0.05),
    ],
)
def test_the_stress_at_the_interface_agrees_with_finite_elements(inclusion, reference, tolerance):
    """Maximum of the integration points of the matrix within 1.03 radii (reference/inclusions).

    Cells of the matrix are further away from the interface, and their maximum is smaller.
    """
    state = contact(inclusion)
    (found,) = sc.inclusions.interfaces(state)
    assert found.max_von_mises == pytest.approx(reference, rel=tolerance)
    cells = sc.inclusions.statistics(state).near["von_mises"]
    assert 0.7 * reference < cells.value < reference
    assert cells.number == 0
    assert 1.0 < cells.distance < 1.5
    # the maximum of the stiff sphere is in front of it, that of the others at its equator
    assert found.max_tension <= 0.0
    if inclusion.is_void:
        assert (found.max_tension, found.max_shear) == (0.0, 0.0)


def test_an_interface_within_the_matrix_has_its_stress():
    """Inclusion with the constants of the matrix: tractions of the stress at its place."""
    state = contact(sc.Inclusion.sphere((0.0, 0.0, 2.0 * A), 0.25 * A, STEEL))
    (found,) = sc.inclusions.interfaces(state, numbers=[0])
    middle = state.grid.nx // 2
    deep = state.at_layers(60).stress(2)
    stress = deep[:, middle, middle, int(2.0 * A / state.grid.dz)]
    principal = np.linalg.eigvalsh(np.diag(stress[:3]))
    assert found.max_tension == pytest.approx(principal[-1], rel=0.1, abs=0.01 * P0)
    assert found.max_shear == pytest.approx((principal[-1] - principal[0]) / 2, rel=0.05)
    assert found.max_von_mises == pytest.approx(von_mises(stress), rel=0.05)


def rolled():
    """States of an elastic ball that rolls over a stiff inclusion."""
    h = 6e-6
    grid = sc.Grid(40, 32, h, h, dz=h)
    oxide = sc.Inclusion.sphere((0.0, 0.0, 50e-6), 24e-6, sc.Material.elastic(390e9, 0.25))
    gap = sc.surfaces.paraboloid(grid, 3e-3)
    sim = sc.Simulation(grid, RIGID, sc.Heterogeneous(STEEL, [oxide]), gap, tol=1e-3)
    sim.step(load=30.0, advance=(0.0, 36e-6))
    return [sim.step(load=30.0, advance=(0.0, -2 * h)) for _ in range(6)]


def test_statistics_and_butterflies_follow_the_moving_body():
    states = rolled()
    body = states[0].setup.bodies[1]
    found = sc.inclusions.statistics(states, slope=0.3)
    of = sc.fatigue.cycle(states, 2)
    criterion = sc.fatigue.dang_van(of, slope=0.3)
    (peak,) = sc.inclusions.peaks(criterion, body)
    assert found.near["dang_van"] == peak
    assert found.anywhere["von_mises"].value >= found.near["von_mises"].value
    assert set(found.percentiles) == {"50", "90", "99", "99.9"}
    assert found.percentiles["99.9"] <= found.near["von_mises"].value
    assert np.hypot(*(np.array(peak.position) - [0.0, 0.0, 50e-6])[[0, 2]]) < 1.6 * 24e-6
    wings = sc.inclusions.butterflies(criterion, body, sectors=12)
    assert wings.numbers == (0,)
    assert wings.count.sum() == 1
    # the cells of the body, with the share of the moved body in each state
    first = states[-1]
    share = first.share(2)
    matrix = sc.inclusions.matrix_field(criterion, body)
    assert (matrix.values == 0).sum() == (share > 0).sum()
    lives = [
        sc.fatigue.life(replace(one, values=one.values), "zaretsky") for one in (matrix, criterion)
    ]
    assert lives[0].relative_to(lives[1]) >= 1.0
    assert isinstance(matrix, FatigueField)


def test_one_state_gives_statistics_too():
    state = contact(sc.Inclusion.void(PLACE, 0.25 * A), cells=4)
    found = sc.inclusions.statistics(state)
    assert found == sc.inclusions.statistics([state]) == sc.inclusions.statistics([state, state])
    assert "plastic_strain" not in found.near
    assert "cells near inclusions" in found._repr_html_()


def bodies_to_keep():
    hard = sc.Material.linear_hardening(210e9, 0.3, 8e8, 1e10)
    oxide = sc.Material.elastic(390e9, 0.25)
    labels = np.zeros((10, 10, 8), dtype=int)
    labels[3:7, 3:7, 2:6], labels[8:, 8:, 2:] = 1, 2
    turned = [[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]]
    ellipsoid = sc.Inclusion.ellipsoid(
        (0, 0, 5e-5), (24e-6, 25e-6, 28e-6), oxide, [1e-3, 0, 0, 0, 0, 0], turned
    )
    yield sc.Heterogeneous(hard, [ellipsoid])
    yield sc.Heterogeneous.voxels(hard, [oxide, None], labels, 6e-6, (-30e-6, -30e-6, 12e-6))


@pytest.mark.parametrize("body", list(bodies_to_keep()), ids=["ellipsoid", "voxels"])
def test_a_restart_continues_with_identical_bits(body, tmp_path):
    """A case in which only the matrix yields: the inclusions have no plastic strain."""
    grid = sc.Grid(20, 20, 6e-6, 6e-6, dz=6e-6)
    simulation = sc.Simulation(grid, RIGID, body, sc.surfaces.paraboloid(grid, 3e-3))
    assert simulation.step(load=4.0).max_plastic_strain_magnitude(2) > 0
    simulation.save(tmp_path / "kept")
    again = sc.Simulation.load(tmp_path / "kept")
    assert again.body2 == body
    first, second = (one.step(load=5.0) for one in (simulation, again))
    np.testing.assert_array_equal(first.pressure, second.pressure)
    np.testing.assert_array_equal(first.stress(2), second.stress(2))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Fine boxes around small inclusions, against closed forms and one fine grid."""

import warnings
from types import SimpleNamespace

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
STIFF = sc.Material.elastic(390e9, 0.25)
RIGID = sc.Material.rigid()


def uniform(stress, cells=12, h=50e-6):
    """A state in a uniform initial stress along x, without contact."""
    body = STEEL.with_residual_stress([0.0, 1.0], [stress, stress], [0.0, 0.0])
    grid = sc.Grid(cells, cells, h, h, dz=h)
    gap = sc.surfaces.paraboloid(grid, 5e-3)
    return sc.Simulation(grid, RIGID, body, gap, on_border="warn").state


@pytest.mark.parametrize(("ratio", "bound", "within"), [(0.0, 0.06, 0.02), (2.0, 0.036, 0.035)])
def test_sphere_in_uniform_stress(ratio, bound, within):
    """Eshelby's sphere and Goodier's void, smaller than a cell of the state."""
    radius, depth = 10e-6, 120e-6
    at = (130e-6, -20e-6, depth)
    material = sc.Material.elastic(ratio * 210e9, 0.3) if ratio > 0 else None
    one = (
        sc.Inclusion.sphere(at, radius, material)
        if material is not None
        else sc.Inclusion.void(at, radius)
    )
    (box,) = sc.inclusions.fine_boxes(uniform(1e8), [one], within=1.6)
    exact = sc.inclusions.eshelby_sphere(STEEL, material, [1e8, 0, 0, 0, 0, 0], radius=radius)
    points = np.meshgrid(box.x - at[0], box.y - at[1], box.z - at[2], indexing="ij")
    around = box.is_matrix & (np.linalg.norm(points, axis=0) < 1.5 * radius)
    expected = exact.stress(*points)[:, around]
    disturbance = np.linalg.norm(expected - exact.remote_stress[:, None])
    assert np.linalg.norm(box.stress[:, around] - expected) < bound * disturbance
    inner = box.stress[:, box.share >= 1.0].mean(axis=1)
    deviation = np.linalg.norm(exact.interior_stress - exact.remote_stress)
    assert np.linalg.norm(inner - exact.interior_stress) < within * deviation
    assert box.interpolation_error < 1e-9
    (interface,) = box.interfaces()
    if ratio == 0.0:
        assert interface.max_von_mises == pytest.approx(2.045e8, rel=0.05)


H = 12.5e-6  # cell of the fine grid
CELLS = 61
A, P0 = 20 * H, 2e9
BALL = 2 * A * 210e9 / 0.91 / (np.pi * P0)
LOAD = 2 / 3 * np.pi * A**2 * P0
OXIDE = sc.Inclusion.sphere((5 * H, 0.0, 16 * H), 4 * H, STIFF)


def pressed(body, factor):
    """A contact on cells `factor` times as large as those of the fine grid, and its simulation."""
    count, h = CELLS // factor + (CELLS // factor + 1) % 2, factor * H
    grid = sc.Grid(count, count, h, h, dz=h)
    gap = sc.surfaces.paraboloid(grid, BALL)
    simulation = sc.Simulation(grid, RIGID, body, gap, on_border="warn", tol=1e-4)
    return simulation, simulation.step(load=LOAD)


@pytest.fixture(scope="module")
def under_contact():
    clean = pressed(STEEL, 1)[1]
    whole = pressed(sc.Heterogeneous(STEEL, [OXIDE]), 1)[1]
    simulation, coarse = pressed(STEEL, 3)
    (box,) = sc.inclusions.fine_boxes(coarse, [OXIDE], cells_per_radius=4.0)
    return SimpleNamespace(clean=clean, whole=whole, simulation=simulation, coarse=coarse, box=box)


def test_box_equals_one_fine_grid(under_contact):
    """The inclusion lies on equal cells below the contact on one fine grid."""
    whole, box = under_contact.whole, under_contact.box
    stress, share = whole.stress(2), whole.share(2)
    i, j = (np.searchsorted(whole.grid.x, of[0] - H / 4) for of in (box.x, box.y))
    k = round(box.z[0] / H - 0.5)
    nx, ny, nz = box.share.shape
    at = np.ix_(np.arange(i, i + nx), np.arange(j, j + ny), np.arange(k, k + nz))
    np.testing.assert_allclose(
        [box.x[0], box.y[0], box.z[0]],
        [whole.grid.x[i], whole.grid.y[j], whole.depths[k]],
        atol=0.51 * H,
    )
    assert box.share.sum() == pytest.approx(share.sum(), rel=2e-2)
    largest = [
        np.sort(field[where])[-20:].mean()
        for field, where in (
            (box.von_mises, box.is_matrix),
            (whole.von_mises(2)[at], share[at] == 0),
        )
    ]
    assert largest[0] == pytest.approx(largest[1], rel=0.02)
    inner = box.stress[:, box.share >= 1].mean(axis=1)
    expected = stress[:, share >= 1].mean(axis=1)
    np.testing.assert_allclose(inner, expected, rtol=0, atol=0.02 * P0)
    assert 0 < box.interpolation_error < 0.05


def test_pressure_change_and_its_return_to_the_contact(under_contact):
    clean, whole, box = under_contact.clean, under_contact.whole, under_contact.box
    change = np.abs(whole.pressure - clean.pressure).max()
    assert 0.3 * change < box.pressure_change < 3 * change
    simulation, coarse = under_contact.simulation, under_contact.coarse
    simulation.add_eigenstrain(2, box.eigenstrain_on(coarse.grid))
    returned = simulation.step(load=LOAD)
    near = np.hypot(coarse.grid.x[:, None], coarse.grid.y) < 0.6 * A
    fine = (whole.pressure - clean.pressure)[::3, ::3]  # the same places
    found = (returned.pressure - coarse.pressure)[near]
    assert np.abs(found - fine[near]).max() < 0.25 * change


def test_close_inclusions_are_solved_together():
    state = uniform(1e8)
    places = [(-100e-6, 0.0), (-90e-6, 5e-6), (100e-6, 0.0)]
    spheres = [sc.Inclusion.sphere((x, y, 60e-6), 4e-6, STIFF) for x, y in places]
    boxes = sc.inclusions.fine_boxes(state, spheres, cells_per_radius=4.0)
    assert [box.numbers for box in boxes] == [(0, 1), (2,)]
    assert [one.number for box in boxes for one in box.interfaces()] == [0, 1, 2]
    assert "fine_boxes" not in repr(boxes[0])


def test_inclusions_move_with_the_body():
    """The box of a state that has moved equals that of the same inclusion placed there."""
    simulation, _ = pressed(STEEL, 3)
    shift = 3 * simulation.grid.dx
    state = simulation.step(load=LOAD, advance=(0.0, shift))
    x, y, z = OXIDE.center
    start = sc.Inclusion.sphere((x - shift, y, z), 4 * H, STIFF)
    (moved,) = sc.inclusions.fine_boxes(state, [start], cells_per_radius=4.0)
    np.testing.assert_allclose(moved.x.mean(), x, atol=1e-12)
    field = sc.inclusions.fine_field([moved, moved], sc.fatigue.max_von_mises)
    (peak,) = sc.inclusions.peaks(field, moved.body)
    assert peak.value == pytest.approx(moved.von_mises[moved.is_matrix].max(), rel=0.05)


def test_refusals():
    state = uniform(1e8)
    fine = sc.inclusions.fine_boxes
    sphere = sc.Inclusion.sphere((0.0, 0.0, 6e-5), 4e-6, STIFF)
    hard = sc.Material.linear_hardening(210e9, 0.3, 1e9, 1e9)
    with pytest.raises(ValueError, match=r"inclusions\[0\] must be elastic or a void"):
        fine(state, [sc.Inclusion.sphere((0.0, 0.0, 6e-5), 4e-6, hard)])
    with pytest.raises(
        ValueError, match=r"around inclusions \[0\] must lie inside the grid, within x"
    ):
        fine(state, [sc.Inclusion.sphere((4e-4, 0.0, 6e-5), 4e-6, STIFF)])
    with pytest.raises(ValueError, match="cells_per_radius must be in"):
        fine(state, [sphere], cells_per_radius=1.0)
    with pytest.raises(ValueError, match="within must be above 1"):
        fine(state, [sphere], within=1.0)
    with pytest.warns(sc.ResolutionWarning, match="fewer than 4 cells per radius"):
        (box,) = fine(state, [sphere], cells_per_radius=3.0)
    with pytest.raises(ValueError, match="grid must contain the box along x"):
        box.eigenstrain_on(sc.Grid(1, 9, 1e-6, 5e-5, dz=5e-5))
    with pytest.raises(ValueError, match="body1 must not be rigid"):
        fine(state, [sphere], body=1)
    grid = state.grid
    coarse = sc.Heterogeneous(STEEL, [sc.Inclusion.sphere((0.0, 0.0, 3e-4), 2e-4, STIFF)])
    other = sc.Simulation(grid, RIGID, coarse, sc.surfaces.paraboloid(grid, 5e-3)).state
    with pytest.raises(ValueError, match="must not contain inclusions of the body"):
        fine(other, [sc.Inclusion.sphere((0.0, 0.0, 2e-4), 4e-6, STIFF)])


def test_yield_is_reported():
    stiff = sc.Inclusion.sphere((0.0, 0.0, 1e-4), 5e-6, STIFF)
    grid = sc.Grid(12, 12, 5e-5, 5e-5, dz=5e-5)
    body = sc.Material.linear_hardening(210e9, 0.3, 1e8, 1e9).with_residual_stress(
        [0.0, 1.0], [9e7, 9e7], [0.0, 0.0]
    )
    state = sc.Simulation(grid, RIGID, body, sc.surfaces.paraboloid(grid, 5e-3)).state
    with pytest.warns(sc.ElasticStrainWarning, match="the matrix would yield near 1 of 1"):
        sc.inclusions.fine_boxes(state, [stiff], cells_per_radius=4.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        sc.inclusions.fine_boxes(uniform(1e8), [stiff], cells_per_radius=4.0)

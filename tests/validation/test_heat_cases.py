# SPDX-License-Identifier: GPL-3.0-or-later
"""Two balls at 1500 N with steady heat into one (Boucly 2008, tables 2.1 to 2.3).

References are converged values of an independent solution; those of the thesis are from a coarse
mesh.
"""

import numpy as np
import pytest

import samcontact as sc

COLD = sc.Material.elastic(210e9, 0.3)
THERMAL = (50.2, 11.7e-6, 1.367e-5)
WARM = COLD.with_thermal(*THERMAL)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121).with_thermal(*THERMAL)
RADIUS, LOAD = 7.5e-3, 1500.0
HERTZ = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(COLD, COLD), load=LOAD)
TABLE = "Frictional heat"


def grid_of(cells, width=1.3, **volume):
    d = 2 * width * HERTZ.a / cells
    return sc.Grid(cells, cells, d, d, **volume)


def von_mises(grid, factor, load, z):
    """Von Mises stress [Pa] of the elastic contact at the depths z [m]."""
    solver = sc.ContactSolver(grid, COLD, WARM, heat=sc.Heat(factor))
    pressure = solver.solve(sc.surfaces.paraboloid(grid, RADIUS), load=load).pressure
    s = solver.stress(pressure, z)
    normal = (s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2
    return np.sqrt(0.5 * normal + 3 * (s[3:] ** 2).sum(axis=0))


@pytest.mark.parametrize(
    ("Q", "largest", "thesis", "depth"),
    [
        (0.0, 2539.4, 2537.9, (180e-6, 220e-6)),
        (0.05, 1961.9, 1971.4, (205e-6, 245e-6)),
        (0.12, 3530.4, 3501.6, (0.0, 0.0)),
        (0.20, 7391.6, 7343.3, (0.0, 0.0)),
    ],
)
def test_largest_von_mises_stress(Q, largest, thesis, depth, measured):
    z = np.arange(0, 400e-6, 10e-6)
    mises = von_mises(grid_of(65), Q, LOAD, z)
    for source, expected, rel in (("fine grid", largest, 1e-3), ("thesis", thesis, 2e-2)):
        measured.close(TABLE, f"Q_f = {Q:g}: elastic, maximum von Mises stress",
                       1e-6 * mises.max(), expected, unit="MPa", rel=rel, source=source,
                       mesh="a/25, layers of 10 µm")  # fmt: skip
    assert depth[0] <= z[np.unravel_index(mises.argmax(), mises.shape)[2]] <= depth[1]


@pytest.mark.parametrize(
    ("Q", "onset", "thesis"), [(0.0, 296, 298), (0.05, 497, 491), (0.12, 472, 468), (0.2, 209, 212)]
)
def test_onset_of_yield(Q, onset, thesis, measured):
    """Load at which the maximum von Mises stress reaches 1476.7 MPa."""
    grid, z = grid_of(97, 1.0), np.arange(0, 300e-6, 5e-6)
    loads = np.array([0.97, 1.03]) * onset
    largest = [von_mises(grid, Q, load, z).max() for load in loads]
    found = np.interp(1476.7e6, largest, loads)
    mesh = f"a/{HERTZ.a / grid.dx:.0f}, layers of 5 µm"
    for source, expected, rel in (("fine grid", onset, 1e-2), ("thesis", thesis, 2e-2)):
        measured.close(TABLE, f"Q_f = {Q:g}: load at first yield", found, expected, unit="N",
                       rel=rel, source=source, mesh=mesh)  # fmt: skip


@pytest.mark.parametrize(("Q", "loaded", "residual"), [(0.0, 2351.0, 133.7), (0.05, 1926.0, 24.4)])
def test_elastic_plastic(Q, loaded, residual, measured):
    grid = grid_of(35, 1.5, nz=34, dz=20e-6)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    heated = sc.Simulation(grid, COLD, STEEL, gap, heat=sc.Heat(Q))
    hot = heated.run(sc.paths.ramp(load=LOAD, increments=12), progress=False)[-1]
    name, mesh = f"Q_f = {Q:g}: elastic-plastic, ", "a/12, layers of 20 µm, 12 increments"
    measured.close(TABLE, name + "maximum von Mises stress", 1e-6 * hot.von_mises().max(), loaded,
                   unit="MPa", rel=3e-3, source="fine grid", mesh=mesh)  # fmt: skip
    left = 1e-6 * heated.step(load=0.0).von_mises().max()
    measured.close(TABLE, name + "residual von Mises stress", left, residual, unit="MPa", rel=0.03,
                   source="fine grid", mesh=mesh)  # fmt: skip

# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact of a coated body against solutions of its integral equation (reference/layers).

At 32 cells per contact radius; the errors are those of the homogeneous contact, first in the list.
"""

import json
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc

CASES = json.loads((Path(__file__).parents[2] / "reference" / "layers" / "coated.json").read_text())
CELLS = 32


# In the units of the reference numbers E is 1.
@pytest.mark.filterwarnings("ignore::samcontact.ElasticStrainWarning")
@pytest.mark.parametrize("name", CASES)
def test_pressure_approach_and_stresses_on_the_axis(name):
    case = CASES[name]
    *layers, (E, nu, _) = case["layers"]
    body = sc.Layered(
        [(sc.Material.elastic(E_1, nu_1), h) for E_1, nu_1, h in layers],
        sc.Material.elastic(E, nu),
    )
    E_star, dx = E / (1 - nu**2), case["a"] / CELLS
    n = 2 * int(1.15 * CELLS) + 1
    grid = sc.Grid(n, n, dx, dx)
    solver = sc.ContactSolver(grid, sc.Material.rigid(), body)
    gap = sc.surfaces.paraboloid(grid, 2 * E_star / np.pi)
    found = solver.solve(gap, load=2 / 3 * np.pi)
    assert found.pressure.max() == pytest.approx(case["p_max"], rel=1e-3)
    assert found.approach == pytest.approx(case["approach"] * np.pi / (2 * E_star), rel=5e-4)
    # Cells that the edge cuts count in full: a sixth of a cell, with or without a coating.
    radius = np.sqrt(np.count_nonzero(found.pressure) / np.pi) * dx
    assert radius == pytest.approx(case["a"], rel=5.5e-3)

    expected = [(0.0, case["axis_surface_srr"], case["axis_surface_szz"])]
    expected += [(z, s_rr, s_zz) for z, s_rr, s_zz in case["axis"]]
    for interface in case["interfaces"]:
        above, below = np.nextafter(interface["z"], 0.0), interface["z"]
        expected.append((above, interface["srr_above"], interface["szz"]))
        expected.append((below, interface["srr_below"], interface["szz"]))
    depths, s_rr, s_zz = np.array(expected).T
    stress = solver.stress(found.pressure, depths)[:, n // 2, n // 2]
    assert stress[2] == pytest.approx(s_zz, abs=5e-4)
    assert stress[0] == pytest.approx(s_rr, abs=5e-4)

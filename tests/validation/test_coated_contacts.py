# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact of a coated body against solutions of its integral equation (reference/layers).

The grids have 32 cells per contact radius. The homogeneous contact, first in the list, has equal
errors.
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
    assert radius == pytest.approx(case["a"], rel=5e-3)

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


WAVE, AMPLITUDE = 1e-3, 1e-7
STEEL = sc.Material.elastic(210e9, 0.3)
COATINGS = [
    [(sc.Material.elastic(210e9 * ratio, nu), thickness * WAVE)]
    for ratio, nu, thickness in [
        (4, 0.25, 0.003), (4, 0.25, 0.05), (4, 0.25, 0.3), (50, 0.2, 0.02), (50, 0.2, 2.0),
        (0.25, 0.3, 0.003), (0.25, 0.3, 0.1), (0.02, 0.45, 0.05), (0.02, 0.49, 1.0),
    ]
]  # fmt: skip
COATINGS.append(COATINGS[1] + COATINGS[7])


@pytest.mark.parametrize("layers", COATINGS)
def test_full_contact_pressure_of_a_wave_on_a_coating(layers):
    """Full contact of a wave: p = p_m + p* cos(q x), p* is amplitude over wave compliance."""
    n = 128
    grid = sc.Grid(n, 1, WAVE / n, WAVE / n, periodic="xy")
    body, q = sc.Layered(layers, STEEL), 2 * np.pi / WAVE
    gap = AMPLITUDE * (1 - np.cos(q * grid.x))[:, None]
    full = AMPLITUDE / body.wave_compliance(q)
    solver = sc.ContactSolver(grid, sc.Material.rigid(), body)
    found = solver.solve(gap, load=1.2 * full * WAVE * grid.dy)
    exact = full * (1.2 + np.cos(q * grid.x))
    assert found.pressure[:, 0] == pytest.approx(exact, abs=1e-3 * full)
    touching = solver.solve(gap, load=0.98 * full * WAVE * grid.dy).pressure
    assert touching.min() == 0


def test_substrate_that_yields_below_a_coating():
    """Finite elements, reference/layers/yielding; 12 cells per Hertz radius, 3 in the coating."""
    folder = Path(__file__).parents[2] / "reference" / "layers" / "yielding"
    case = json.loads((folder / "case.json").read_text())
    summary, h, load = case["summary"], case["coating"]["thickness_m"], case["W_N"]
    dx = summary["hertz_substrate"]["a_m"] / 12
    grid = sc.Grid(33, 33, dx, dx, dz=h / 3)
    steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
    body = sc.Layered([(sc.Material.elastic(400e9, 0.25), h)], steel)
    gap = sc.surfaces.paraboloid(grid, case["R_m"])
    run = sc.Simulation(grid, sc.Material.rigid(), body, gap)
    for part in range(1, 17):
        loaded = run.step(load=load * part / 16)
    unloaded = run.step(load=0.0)
    assert loaded.pressure[16, 16] == pytest.approx(summary["p_center_Pa"], rel=5e-3)
    assert loaded.approach == pytest.approx(summary["approach_max_m"], rel=2e-3)
    largest = summary["gamma_p_max_anywhere"]
    assert loaded.max_equivalent_plastic_strain() == pytest.approx(largest, rel=1e-2)
    left = unloaded.residual_displacement()[16, 16]
    assert left == pytest.approx(summary["uz_center_residual_m"], rel=1e-2)
    axis = np.genfromtxt(folder / "axis_unloaded.csv", delimiter=",", names=True)
    z, stress = unloaded.depths, unloaded.residual_stress()[0, 16, 16]
    for own, exact in ((z < h, axis["z_m"] < h), ((z > h) & (z < 8 * h), axis["z_m"] > h)):
        s_rr = np.interp(z[own], axis["z_m"][exact], axis["srr_Pa"][exact])
        rms = np.sqrt(np.mean((stress[own] - s_rr) ** 2))
        assert rms < 0.02 * np.abs(axis["srr_Pa"][exact]).max()


def hertz_pressure(grid, a, p0, parts=10):
    """Return cell means of the Hertz pressure [Pa], scaled to the exact force."""
    offsets = (np.arange(parts) + 0.5) / parts - 0.5
    x, y = ((c[:, None] + offsets * d).ravel() for c, d in ((grid.x, grid.dx), (grid.y, grid.dy)))
    p = p0 * np.sqrt(np.maximum(0.0, 1 - (x[:, None] ** 2 + y**2) / a**2))
    p = p.reshape(grid.nx, parts, grid.ny, parts).mean(axis=(1, 3))
    return p * (2 / 3 * np.pi * a**2 * p0) / (p.sum() * grid.cell_area)


def test_coating_and_substrate_that_both_yield():
    """Finite elements, reference/layers/both_yield.json; 12 cells per radius, 6 in the coating."""
    file = Path(__file__).parents[2] / "reference" / "layers" / "both_yield.json"
    case = json.loads(file.read_text())
    a, h = case["a"], case["thickness"]
    coating, substrate = (
        sc.Material.linear_hardening(E, nu, Y, E * H / (E + H))
        for E, nu, Y, H in (m.values() for m in case["materials"])
    )
    body = sc.Layered(
        [(coating.with_residual_stress([0.0], [case["growth_stress"]]), h)], substrate
    )
    grid = sc.Grid(41, 41, a / 12, a / 12, nz=62, dz=h / 6)
    pressure = hertz_pressure(grid, a, case["p0"])
    run = sc.Simulation(grid, sc.Material.rigid(), body, np.zeros(grid.surface_shape))
    up, down = case["increments"]
    for part in range(1, up + 1):
        loaded = run.step(pressure=part / up * pressure)
    for part in range(1, down + 1):
        unloaded = run.step(pressure=(1 - part / down) * pressure)
    strain = unloaded.equivalent_plastic_strain()[20, 20]
    fields = {
        "loaded": loaded.stress()[0, 20, 20],
        "unloaded": unloaded.residual_stress()[0, 20, 20],
    }
    z = grid.z
    # The strain of the coating is that of its few cells through the thickness.
    below = (z > h) & (z < 1.7 * a)
    for inside, allowed in ((z < h, (0.05, 0.004, 0.015)), (below, (0.01, 0.004, 0.01))):
        for name, stress in fields.items():
            depth, g, s_rr = np.array(case[name]).T
            own = (depth < h) == (z[inside][0] < h)
            for found, exact, tol in (
                (strain, g, allowed[0]),
                (stress, s_rr, allowed[1 if name == "loaded" else 2]),
            ):
                expected = np.interp(z[inside], depth[own], exact[own])
                rms = np.sqrt(np.mean((found[inside] - expected) ** 2))
                assert rms < tol * np.abs(exact[own]).max()
    left = unloaded.residual_displacement()[20, 20]
    assert left == pytest.approx(case["residual_uz"], rel=0.02)

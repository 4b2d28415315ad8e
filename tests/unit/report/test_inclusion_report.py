# SPDX-License-Identifier: GPL-3.0-or-later
"""Tolerance of bodies with inclusions in the checks of a report, which its figure shows."""

import samcontact as sc
from samcontact import results
from samcontact.report.quality_checks import all_checks, flow_tol

H = 25e-6


def test_tolerance_of_the_checks():
    """The strain of inclusions, and the yield condition with it, has a tolerance of its own."""
    grid = sc.Grid(25, 25, H, H, dz=H)
    steel = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 9.5e9)
    oxide = sc.Inclusion.sphere((0.0, 0.0, 8 * H), 4 * H, sc.Material.elastic(400e9, 0.25))
    simulation = sc.Simulation(
        grid, sc.Material.rigid(), sc.Heterogeneous(steel, [oxide]),
        sc.surfaces.paraboloid(grid, 5e-3), on_border="warn",
    )  # fmt: skip
    states = [simulation.step(load=load) for load in (40.0, 60.0)]
    dataset = results.to_dataset(simulation, states)
    names = ("yield condition", "plastic strain increment")
    checks = [check for check in all_checks(dataset, None) if any(n in check.name for n in names)]
    assert len(checks) == 2
    assert {check.limit for check in checks} == {flow_tol(dataset)} == {1e-3}
    assert dataset.attrs["tol"] < dataset["yield_violation"].max() < 1e-3

# SPDX-License-Identifier: GPL-3.0-or-later
"""Prescribed accuracy of contacts with adhesion."""

import pytest

import samcontact as sc
from samcontact.accuracy.prescribed import to_accuracy

CASE = {
    "title": "tip",
    "grid": {"nx": 40, "ny": 40, "dx": 12e-9, "dy": 12e-9},
    "body1": {"law": "rigid"},
    "body2": {"law": "elastic", "E": 100e6, "nu": 0.4},
    "surface": {"shape": "paraboloid", "Rx": 1e-6},
    "contact": {"adhesion": {"kind": "exponential", "work": 50e-3, "range": 4e-9}},
    "path": [{"approach": 3e-9}],
}


@pytest.mark.filterwarnings("ignore:the attraction at the edge")
def test_errors_of_adhesion_contain_the_difference_to_a_fine_grid():
    found = to_accuracy({**CASE, "accuracy": 0.02}, progress=False)
    grid = sc.Grid(240, 240, 2e-9, 2e-9)
    fine = sc.ContactSolver(
        grid, sc.Material.rigid(), sc.Material.elastic(100e6, 0.4),
        adhesion=sc.Adhesion.exponential(50e-3, 4e-9),
    ).solve(sc.surfaces.paraboloid(grid, 1e-6), approach=3e-9)  # fmt: skip
    for name, expected in (("load", fine.load), ("max_pressure", fine.pressure.max())):
        value, error = found.series[name][-1], found.series_errors[name][-1]
        assert abs(value - expected) < error < 0.02 * abs(value), name


def test_accuracy_of_adhesion_requires_its_range_and_a_grid():
    contact = {"adhesion": {"kind": "exponential", "work": 50e-3}}
    with pytest.raises(ValueError, match=r"with accuracy, .*range must be given"):
        to_accuracy({**CASE, "contact": contact, "accuracy": 0.02})
    without = {name: part for name, part in CASE.items() if name != "grid"}
    with pytest.raises(ValueError, match="attraction extends beyond the contact"):
        to_accuracy({**without, "accuracy": 0.02})

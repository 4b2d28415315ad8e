# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic subdomains of rough periodic surfaces, also across the ends of the period."""

import numpy as np
import pytest

import samcontact as sc
from rough_setups import (
    ELASTIC,
    KINEMATIC,
    RIGID,
    SIZE,
    SOFT,
    STEEL,
    assert_few_errors,
    rough_gap,
    same,
    simulation,
    zone_counts,
    zones_of,
)

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.ResolutionWarning", "ignore::samcontact.PlasticStrainWarning"
)
CELLS = 128
GRID = sc.Grid(CELLS, CELLS, SIZE, SIZE, 10, SIZE, "xy")
GAP = rough_gap(0.0, sc.Grid(CELLS, CELLS, SIZE, SIZE))
GAP = np.roll(GAP, -np.array(np.unravel_index(GAP.argmin(), GAP.shape)), (0, 1))
"""The highest asperity is at a corner."""
LOAD = 0.005 * 4.2e9 * (CELLS * SIZE) ** 2


def pressed(*bodies, loads=(0.5, 1.0, 0.2), grid=GRID, gap=GAP, **options):
    sim = simulation(*bodies, grid=grid, gap=gap, **options)
    return sim, [sim.step(load=part * LOAD) for part in loads]


@pytest.mark.parametrize(
    ("bodies", "options"),
    [((ELASTIC, KINEMATIC), {"friction": 0.3}), ((SOFT, STEEL), {})],
    ids=["sliding", "dissimilar"],
)
def test_subdomains_give_the_fields_of_one_box(bodies, options):
    split, zones = pressed(*bodies, **options)
    whole, one = pressed(*bodies, zones="one", **options)
    yielding = [body for body, law in enumerate(bodies, 1) if law.is_plastic]
    for ours, expected in zip(zones, one, strict=True):
        assert_few_errors(ours, expected, yielding, 2e-3)
        assert ours.contact_area == pytest.approx(expected.contact_area, rel=2e-3)
    assert max(zone_counts(split)) > 3
    assert max(zone_counts(whole)) == 1
    # the asperity at the corner has strain at all four of them
    corners = {
        (bool(i0 == 0), bool(j0 == 0))
        for i0, j0, nx, ny, *_ in zones_of(split, 2)
        if (i0 == 0 or i0 + nx == CELLS) and (j0 == 0 or j0 + ny == CELLS)
    }
    assert len(corners) == 4


def test_results_are_independent_of_the_period_origin():
    _, (*_, here) = pressed()
    _, (*_, there) = pressed(gap=np.roll(GAP, (37, 90), (0, 1)))
    for name in ("pressure", "residual_displacement"):
        ours, other = (
            getattr(state, name) if name == "pressure" else getattr(state, name)()
            for state in (here, there)
        )
        moved = np.roll(ours, (37, 90), (0, 1))
        assert np.sqrt(np.mean((other - moved) ** 2)) < 2e-3 * np.sqrt(np.mean(moved**2))


@pytest.mark.parametrize(
    "grid",
    [
        sc.Grid(CELLS, CELLS, SIZE, SIZE, 10, SIZE, "x"),
        sc.Grid(CELLS, 120, SIZE, SIZE, 10, SIZE, "xy"),
    ],
    ids=["one end", "no whole nodes"],
)
def test_what_cannot_be_split_stays_in_one_box(grid):
    gap = np.roll(GAP, (CELLS // 2, CELLS // 2), (0, 1))[:, : grid.ny]
    sims = [
        pressed(RIGID, STEEL, loads=[0.5], grid=grid, gap=gap, zones=zones)
        for zones in ("auto", "one")
    ]
    assert zone_counts(sims[0][0]) == zone_counts(sims[1][0]) == [0, 1]
    assert same(sims[0][1][0], sims[1][1][0])

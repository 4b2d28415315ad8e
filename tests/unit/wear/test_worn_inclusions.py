# SPDX-License-Identifier: GPL-3.0-or-later
"""Fretting wear of elastic bodies with inclusions."""

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
STIFF = sc.Material.elastic(400e9, 0.25)
CELL = 8e-6
PLACE = 6 * CELL  # below the slip annulus
GRID = sc.Grid(18, 18, CELL, CELL, dz=CELL)
LOOP = [{"load": 8.0, "tangential_load": (q * 2.4, 0.0)} for q in (0, 1, -1, 1)]
pytestmark = pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")


def frets(*inclusions, repeats=100_000, **more):
    body = sc.Heterogeneous(STEEL, inclusions) if inclusions else STEEL
    return sc.wear.fretting(
        GRID, STEEL, body, lambda grid: sc.surfaces.paraboloid(grid, 5e-3), cycle=LOOP,
        friction=sc.Coulomb(0.5), energy=1e-14, repeats=repeats, progress=False,
        **({"cycles": 1} | more),
    )  # fmt: skip


def sphere(z, material=STIFF):
    return sc.Inclusion.sphere((PLACE, 0.0, z), 2.2 * CELL, material)


def test_inclusion_comes_closer_to_the_surface(tmp_path):
    """The second cycle begins with the raised inclusion and the worn surface."""
    start = sphere(2.6 * CELL)
    path = tmp_path / "wear.h5"
    before = frets(start, checkpoint=path, repeats=100_000)
    worn = frets(start, checkpoint=path, repeats=100_000, cycles=2)
    for cycle in worn.cycles:
        assert cycle.volume[0] == pytest.approx(1e-14 * cycle.friction_work, rel=1e-9)
        assert cycle.lost_volume[0] == pytest.approx(cycle.volume[0], rel=1e-9)
    heights = before.relief2.heights
    r2 = ((GRID.x - PLACE)[:, None] ** 2 + GRID.y**2) / (2.2 * CELL) ** 2
    weight = np.sqrt(np.maximum(1 - r2, 0))
    raised, unmoved = (
        max_pressure(sphere(2.6 * CELL + part * (weight * heights).sum() / weight.sum()), before)
        for part in (1, 0)
    )
    assert worn.cycles[1].max_pressure == pytest.approx(raised, rel=1e-9)
    assert abs(unmoved / raised - 1) > 1e-7


def max_pressure(inclusion, worn):
    simulation = sc.Simulation(
        GRID, STEEL, sc.Heterogeneous(STEEL, [inclusion]),
        sc.surfaces.paraboloid(GRID, 5e-3), sc.Coulomb(0.5), relief2=worn.relief2,
    )  # fmt: skip
    states = [simulation.step(**step) for step in LOOP + LOOP[2:]]
    return max(state.pressure.max() for state in states[4:])


def test_inclusions_worn_away():
    """A body whose inclusion has been worn away is its matrix."""
    left = 1e-9  # of the inclusion, below the surface
    cap = sc.Inclusion.sphere((PLACE, 0.0, left - 2.2 * CELL), 2.2 * CELL, STIFF)
    found, clean = (frets(*given, cycles=2, repeats=100_000) for given in ([cap], []))
    for one, other in zip(found.cycles, clean.cycles, strict=True):
        assert one.max_pressure == pytest.approx(other.max_pressure, rel=1e-3)


def test_void_reached_by_wear():
    void = sc.Inclusion.void((PLACE, 0.0, 2.2 * CELL + 1e-9), 2.2 * CELL)
    message = r"body2.inclusions\[0\] must stay below the worn surface, but wear has reached"
    with pytest.raises(ValueError, match=message):
        frets(void, cycles=2, tol=1e-3)


def test_refusals():
    hard = sc.Material.linear_hardening(210e9, 0.3, 1e9, 1e9)
    with pytest.raises(ValueError, match="for wear, body2 must be elastic"):
        frets(sphere(4 * CELL, hard))
    layered = sc.Layered([(STIFF, CELL)], STEEL)
    with pytest.raises(ValueError, match="body2 must not have both layers and inclusions"):
        sc.wear.fretting(
            GRID, STEEL, sc.Heterogeneous(layered, [sphere(4 * CELL)]),
            sc.surfaces.paraboloid(GRID, 5e-3), cycle=LOOP, friction=sc.Coulomb(0.5),
            energy=1e-14, progress=False,
        )  # fmt: skip
    voxels = sc.Heterogeneous.voxels(STEEL, STIFF, np.ones((4, 4, 4), int), CELL, (0, 0, CELL))
    with pytest.raises(ValueError, match="for wear, body2 must not have voxels"):
        sc.wear.fretting(
            GRID, STEEL, voxels, sc.surfaces.paraboloid(GRID, 5e-3), cycle=LOOP,
            friction=sc.Coulomb(0.5), energy=1e-14, progress=False,
        )  # fmt: skip
